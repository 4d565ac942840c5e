"""Every kind of fault in [unsteady]; and what its keys become."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest
from faults import HOSTILE, Faults, check_lines, check_only_fault
from project.scenes import CONFIGS

from tmmcalc.core.errors import UsageError
from tmmcalc.linkage.tables.tasks.unsteady import to_unsteady
from tmmcalc.linkage.tables.unsteady import UnsteadyTable
from tmmcalc.linkage.unsteady.task import UnsteadyTask
from tmmcalc.project import parse_spec

CRANE = (CONFIGS / "crane-luffing.toml").read_text(encoding="utf-8").partition("[unsteady]")[0]
CRANK = (CONFIGS / "crank-slider.toml").read_text(encoding="utf-8")
LIMITS = 'speed = "0.2 m/s"\nacceleration = "0.05 m/s^2"\n'
TURNING = 'speed = "1 rad/s"\nacceleration = "2 rad/s^2"\n'

# the mechanism, the lines of [unsteady]; the path, the message and the remedy of the one fault
FAULTS = [
    (
        CRANE,
        LIMITS,
        "unsteady",
        "missing key: neither an end, a travel nor a duration is given",
        'add to, travel, or duration = "12 s"',
    ),
    (
        CRANE,
        'acceleration = "0.05 m/s^2"\nduration = "12 s"\n',
        "unsteady.speed",
        "missing key: the largest speed of the input is needed",
        "add speed, or give both the duration and the end",
    ),
    (
        CRANE,
        LIMITS + 'to = "6 m"\ntravel = "1 m"\n',
        "unsteady.travel",
        "travel together with to: they say the same",
        "remove one of them",
    ),
    (
        CRANE,
        LIMITS + 'travel = "1 m"\nsense = "positive"\n',
        "unsteady.sense",
        "sense together with travel: the travel has its sign",
        "remove sense",
    ),
    (
        CRANE,
        LIMITS + 'output = "c"\nto = "6 m"\n',
        "unsteady.output",
        "there is no output 'c'",
        'did you mean "C"? outputs: C, 1; add [[mechanism.outputs]] for another',
    ),
    (
        CRANE,
        LIMITS + 'output = "C"\ntravel = "1 m"\n',
        "unsteady.output",
        "output = 'C' has no effect: neither from nor to is given",
        "add to, or remove output",
    ),
    (
        CRANE,
        'speed = "1 rad/s"\nacceleration = "0.05 m/s^2"\ntravel = "1 m"\n',
        "unsteady.speed",
        "'1 rad/s' is an angular speed; the input joint \"D\" is prismatic, so a speed is needed",
        'write a speed, such as "0.2 m/s"',
    ),
    (
        CRANK,
        'speed = "1 rad/s"\nacceleration = "2 m/s^2"\ntravel = "1 rad"\n',
        "unsteady.acceleration",
        "'2 m/s^2' is an acceleration; the input joint \"O\" is revolute, so an angular acceleration is needed",
        'write an angular acceleration, such as "2 rad/s^2"',
    ),
    (
        CRANE,
        LIMITS + 'output = "1"\nto = "6 m"\n',
        "unsteady.to",
        "'6 m' is a length; output 1 is an angle, so an angle is needed",
        'write an angle, such as "30 deg"',
    ),
    (
        CRANE,
        LIMITS + 'from = "30 deg"\nto = "6 m"\n',
        "unsteady.from",
        "'30 deg' is an angle; the input joint \"D\" is prismatic, so a length is needed",
        'write a length, such as "200 mm"',
    ),
    (
        CRANK,
        'speed = 955\nacceleration = "2 rad/s^2"\ntravel = "1 rad"\n',
        "unsteady.speed",
        "955 without a unit is in rad/s, which is 9120 rpm",
        'write "955 rpm" or "955 rad/s"',
    ),
    (
        CRANE,
        'speed = 0\nacceleration = "0.05 m/s^2"\ntravel = "1 m"\n',
        "unsteady.speed",
        "0 is zero; a speed or an angular speed other than 0 is needed here",
        'write "0.2 m/s" or "55 rpm", for example',
    ),
    (
        CRANE,
        LIMITS + 'travel = "1 m"\nsense = "up"\n'.replace('travel = "1 m"', 'to = "6 m"'),
        "unsteady.sense",
        "'up' is no sense of the motion",
        "there are: positive, negative",
    ),
]


@pytest.mark.parametrize(("mechanism", "lines", "path", "message", "remedy"), FAULTS)
def test_one_fault(faults_of: Faults, mechanism: str, lines: str, path: str, message: str, remedy: str) -> None:
    text = f"{mechanism}\n[unsteady]\n{lines}"
    check_only_fault(text, faults_of(text), path, message, remedy)


def test_without_a_mechanism(faults_of: Faults) -> None:
    text = "[rotor]\nmass = 40\ncenter = 0.2\nbearings = [0, 0.4]\nspeed = 300\nplanes = [0.1, 0.3]\n"
    text += f"[[rotor.unbalances]]\nmoment = 0.001\nposition = 0\n[unsteady]\n{LIMITS}travel = 1\n"
    (fault,) = faults_of(text)
    assert fault.message == "[unsteady] without [mechanism]: it is the motion of a mechanism"


@pytest.mark.parametrize("value", HOSTILE)
@pytest.mark.parametrize("key", [field.alias or name for name, field in UnsteadyTable.model_fields.items()])
def test_hostile_values_never_break_a_check(key: str, value: str) -> None:
    check_lines(f"{CRANE}\n[unsteady]\n{key} = {value}\n")


KEYS: dict[str, tuple[str, Callable[[UnsteadyTask], Any], Any]] = {
    "speed": ('speed = "300 mm/s"', lambda task: task.speed, 0.3),
    "acceleration": ('acceleration = "70 mm/s^2"', lambda task: task.acceleration, 0.07),
    "start": ('from = "5300 mm"', lambda task: task.start, 5.3),
    "end": ('to = "5900 mm"', lambda task: task.end, 5.9),
    "travel": ('travel = "-20 mm"', lambda task: task.travel, -0.02),
    "duration": ('duration = "0.5 min"', lambda task: task.duration, 30.0),
    "output": ('output = "C"\nfrom = "3.3 m"', lambda task: task.output, "C"),
    "sense": ('sense = "negative"', lambda task: task.sense, -1),
    "steps": ("steps = 7", lambda task: task.steps, 7),
}


def test_every_key_is_here() -> None:
    assert KEYS.keys() == UnsteadyTable.model_fields.keys()


@pytest.mark.parametrize("key", KEYS)
def test_what_a_key_becomes(key: str) -> None:
    line, read, value = KEYS[key]
    table = {"speed": 'speed = "0.2 m/s"', "acceleration": "acceleration = 0.05", "duration": "duration = 12"}
    if key in ("end", "travel"):
        table.pop("duration")
    lines = "\n".join([*(text for own, text in table.items() if own != key), line])
    assert read(to_unsteady(parse_spec(f"{CRANE}\n[unsteady]\n{lines}\n"))) == pytest.approx(value)


def test_a_spec_without_the_table() -> None:
    with pytest.raises(UsageError, match=r"no \[unsteady\]"):
        to_unsteady(parse_spec(CRANK))
