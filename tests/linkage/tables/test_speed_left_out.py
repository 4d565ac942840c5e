"""A mechanism that nothing loads needs no speed: its rates are transfer functions; everything else asks for it."""

from __future__ import annotations

import numpy as np
import pytest

import tmmcalc
from tmmcalc.project import templates

PLAIN = {"crank-slider": "1 rad/s", "crane-luffing": "1 m/s"}  # ready specs without masses, with their unit speed


def text_of(name: str) -> str:
    return (templates.folder() / f"{name}.toml").read_text(encoding="utf-8")


def without_speed(text: str) -> str:
    """The text without the speed of [mechanism.input], and that speed."""
    head, _, rest = text.partition("[mechanism.input]")
    before, _, after = rest.partition("\nspeed = ")
    return f"{head}[mechanism.input]{before}\n{after.partition(chr(10))[2]}"


@pytest.mark.parametrize("name", PLAIN)
def test_rates_are_those_at_a_unit_speed(name: str) -> None:
    unit = PLAIN[name].partition(" ")[2]
    bare = without_speed(text_of(name))
    given = bare.replace("[mechanism.input]\n", f'[mechanism.input]\nspeed = "3 {unit}"\n')
    one, other = (tmmcalc.run(tmmcalc.parse_spec(text)).results for text in (given, bare))
    assert [*one] == [*other]
    fast, slow = one["kinematics"], other["kinematics"]
    assert (fast.speed, slow.speed) == (3.0, 1.0)
    rates = zip(fast.in_time(fast.ds, fast.dds), slow.in_time(slow.ds, slow.dds), (3, 9), strict=True)
    for quick, unhurried, factor in rates:
        np.testing.assert_allclose(quick, factor * unhurried, rtol=1e-12, atol=1e-12)
    assert f"those at {PLAIN[name]}" in str(slow.grades[0])
    assert not any("speed is not given" in str(grade) for grade in fast.grades)
    if "unsteady" in one:
        np.testing.assert_array_equal(one["unsteady"].drive, other["unsteady"].drive)


MASS = ("id = 2\n", 'id = 2\nmass = "2 kg"\n')
FURTHER = {
    "masses": lambda text: text.replace(*MASS),
    "loads": lambda text: text + '\n[[loads]]\nlink = 3\npoint = "B"\nforce = ["100 N", "0 N"]\n',
    "a motor": lambda text: text + '\n[motor]\nname = "4A80B4"\n',
    "constraints": lambda text: (
        text + '\n[[constraints]]\nname = "v"\nstage = "kinematics"\ncolumn = "vS_B"\nat_most = "1 m/s"\n'
    ),
    "an acceleration": lambda text: text.replace("[mechanism.input]\n", "[mechanism.input]\nacceleration = 1.0\n"),
}


def test_constraints_on_paths_ask_for_none() -> None:
    limit = '\n[[constraints]]\nname = "near"\nstage = "paths"\nvalue = "deviation_max_P"\nat_most = "0.2 mm"\n'
    result = tmmcalc.run(tmmcalc.parse_spec(text_of("wanted-path") + limit)).results["feasibility"]
    assert result.feasible


@pytest.mark.parametrize("what", FURTHER)
def test_it_is_asked_for_where_something_depends_on_it(what: str) -> None:
    bare = without_speed(text_of("crank-slider"))
    changed = FURTHER[what](bare)
    assert changed != bare
    with pytest.raises(tmmcalc.SpecError) as refused:
        tmmcalc.parse_spec(changed)
    line = changed.splitlines().index("[mechanism.input]") + 1
    assert f":{line}:1: mechanism.input.speed: missing key: the input needs its mean speed" in str(refused.value)
    assert 'add speed = "55 rpm"' in str(refused.value)
