"""What is given of a scene: written numbers whole, nothing that is found, one letter for one thing."""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Sequence
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory

import pytest

from note import test_extras, test_manipulators, test_vibration
from note.scenes import CONFIGS
from tmmcalc.note.task import row_of
from tmmcalc.pipeline.chapters import chapters_of, given_in, task_of
from tmmcalc.pipeline.outcome import RunResult
from tmmcalc.pipeline.picturing import NONE
from tmmcalc.pipeline.runner import run
from tmmcalc.project import load_spec
from tmmcalc.report.language import speaking
from tmmcalc.report.manuscript import Datum, Table
from tmmcalc.report.telling import CELL

HEAD = '[project]\ntitle = "t"\n\n'
POINTS = (
    '[motor]\nname = "by points"\npower = "5 W"\nspeed = "1400 rpm"\ncharacteristic = "table"\n[motor.table]\n'
    'speed = ["0 rpm", "700 rpm", "1500 rpm"]\nmoment = [0.4, 0.5, 0]\ninterpolation = "{}"\n'
)
SEVERAL = re.compile(r"^(motion|pair|open pair|wind)[^:]*: |: .*$|“.*?”|, of unbalances .*$")
COMPOSED = {  # parts of ready specs that make one
    "engine with motor": ("electric-braking", "in-line-engine"),
    "engine and rotor beside a linkage": ("press", "in-line-engine", "rotor"),
    "engine, rotor and linkage with motor": ("shaper", "in-line-engine", "rotor"),
    "cam with its own speed beside a linkage": ("crank-slider", "cam-groove"),
    "cam and engine beside an induction motor": ("elastic-drive", "cam-translating", "in-line-engine"),
    "pump with open pair, engine, rotor, cam": ("geared-pump", "in-line-engine", "rotor", "cam-flat"),
}
SHORT = {"press", "rotor", "in-line-engine"}  # whose composed scene is quick


def body(name: str) -> str:
    """A ready spec without its project."""
    text = (CONFIGS / f"{name}.toml").read_text(encoding="utf-8")
    return re.sub(r"^\[project\]\n(?:[^\[\n].*\n|\n)*", "", text, flags=re.MULTILINE)


@cache
def solved(text: str, changed: tuple[str, ...] = ()) -> RunResult:
    """What is found of a spec that is written out."""
    with TemporaryDirectory() as folder:
        spec = Path(folder) / "spec.toml"
        spec.write_text(text, encoding="utf-8")
        return run(load_spec(spec, changed))


@cache
def ready(name: str, *changed: str) -> RunResult:
    return run(load_spec(CONFIGS / f"{name}.toml", changed))


def data(done: RunResult) -> list[Datum]:
    """What is given, in the task or in chapters."""
    blocks = [*task_of(done.spec, done.results), *given_in(done.spec, done.results)]
    return [*dict.fromkeys(block for block in blocks if isinstance(block, Datum))]


def told(done: RunResult) -> dict[str, tuple[str, str]]:
    """Designation and value of what is given, by what it is."""
    rows = [row_of(each) for each in data(done)]
    assert len(rows) == len({what for what, _, _ in rows})
    return {what: (keys.replace("$", ""), value.replace("$", "").replace("-", "−")) for what, keys, value in rows}


def meanings(found: Sequence[Datum]) -> dict[str, set[str]]:
    """Letters that are of several things."""
    known = defaultdict[str, set[str]](set)
    for each in found:
        for key in each.keys:
            known[key].add(SEVERAL.sub("", each.what.partition(", points ")[0]))
    return {key: whats for key, whats in known.items() if len(whats) > 1}


@pytest.mark.parametrize(
    "parts",
    [pytest.param(each, marks=[pytest.mark.slow] * (not {*each} <= SHORT), id=k) for k, each in COMPOSED.items()],
)
def test_a_composed_scene_has_one_letter_for_one_thing(parts: tuple[str, ...]) -> None:
    done = solved(HEAD + "\n".join(map(body, parts)))
    assert "balance" in done.results or "cam_forces" in done.results
    assert meanings(data(done)) == {}


def test_a_transloader_has_one_letter_for_one_thing() -> None:
    """Of the area and the shape, which a wind and a part had in common."""
    said = defaultdict[str, set[str]](set)
    for each in data(ready("extra-transloader")):
        for key in each.keys:
            said[key].add(each.what.rpartition(": ")[2])
    assert said["A"] == {"section of the part"}
    assert said["A_w"] == {"area that the wind acts on"}
    assert said["c_w"] == {"coefficient of the shape"}
    assert not any("wind" in what and "load" not in what for what in said["c"] if "$" not in what)


@pytest.mark.parametrize("kind", ["driven", "started"])
def test_a_vibratory_device_has_one_letter_for_one_thing(kind: str) -> None:
    assert meanings(data(solved(HEAD + test_vibration.KINDS[kind]))) == {}


def test_intervals_of_a_motor_are_numbered() -> None:
    found = told(ready("elastic-drive", "transients[0].motor_on=[[0, 0.1], [0.2, 0.3]]"))
    on = {what: value for what, (_, value) in found.items() if "motor is on" in what}
    assert [*on.values()] == ["0; 0.1 s", "0.2; 0.3 s"]


def test_a_motor_by_points_is_told_with_what_is_between_them() -> None:
    kind = test_vibration.KINDS["driven"].replace(test_vibration.MOTOR, "")
    lines, smooth = (told(solved(HEAD + kind + POINTS.format(way))) for way in ("linear", "pchip"))
    said = "characteristic between its points"
    assert (lines[said][1], smooth[said][1]) == ("straight lines", "smooth monotone curve")
    assert lines["speeds of the motor at the points of its characteristic"][1] == "0; 700; 1500 rpm"


def test_the_chapter_of_a_vibratory_device_has_all_that_is_given() -> None:
    done = solved(HEAD + test_vibration.KINDS["driven"])
    chapters = chapters_of({"vibration": "Vibration"}, done.spec, done.results, NONE)
    table = next(
        block
        for chapter in chapters
        for block in chapter.blocks
        if isinstance(block, Table) and block.key == "vibrator_data"
    )
    assert [row[0] for row in table.rows] == [each.what for each in data(done)]


def test_written_numbers_of_words_are_whole() -> None:
    contacts = 'cam.optimum.contacts={ hardened = "912.3456 MPa" }'
    found = told(ready("cam-rocker-optimum", contacts))
    assert found["permissible contact stresses that are tried too"][1].endswith("912.3456 MPa")
    gap = HEAD + test_extras.KINDS["gap by a table"]
    assert "at $y$ = −1.001234 mm" in str([*told(solved(gap, ("contact.table.y[0]=-0.001001234",)))])


def test_the_speed_of_a_cam_is_told_as_it_is_written() -> None:
    assert told(ready("cam-flat", "cam.speed='301.2345 rpm'"))["rotational speed of the cam"] == ("n_k", "301.2345 rpm")


def test_a_static_unbalance_is_told_by_its_moment() -> None:
    changed = ('rotor.unbalances=[{ moment = "4650 g*mm", angle = "205 deg", position = "320 mm" }]',)
    found = told(ready("rotor", *changed))
    assert found["static moments of unbalanced masses"] == ("m_i*r_i", "4650 g·mm")
    assert not {"unbalanced masses", "their distances from the axis"} & {*found}


def test_unbalances_by_mass_and_by_moment_are_told_apart() -> None:
    first = '{ mass = "24 g", radius = "170 mm", position = "160 mm" }'
    second = '{ moment = "4650 g*mm", angle = "205 deg", position = "320 mm" }'
    found = told(ready("rotor", f"rotor.unbalances=[{first}, {second}]"))
    assert found["unbalanced masses, of unbalances 1"][1] == "0.024 kg"
    assert found["static moments of unbalanced masses, of unbalances 2"][1] == "4650 g·mm"


def test_the_radius_of_balancing_weights_is_told_as_the_spec_has_it() -> None:
    said = "radius of the balancing weights"
    assert told(ready("press"))[said][1] == "the length of the crank"
    assert told(ready("press", "balance.radius='90 mm'"))[said][1] == "0.09 m"


def test_the_rim_is_told_whether_one_is_needed_or_not() -> None:
    """A machine that keeps the unevenness without a flywheel is told as one that needs it."""
    needed, idle = ready("press"), ready("press", "motion.inertia=1e5")
    assert needed.results["flywheel"].addition > 0 == idle.results["flywheel"].addition
    first, second = told(needed), told(idle)
    assert {*second} - {*first} == {"further constant moment of inertia of the input link"}
    assert {*first} <= {*second}
    assert second["highest allowed speed of the rim"] == ("v_a", "30 m/s")


@pytest.mark.parametrize("name", ["cam-own-law", pytest.param("reduced-machine", marks=pytest.mark.slow)])
def test_long_lists_stand_in_rows(name: str) -> None:
    found = data(ready(name))
    assert max(len(each.values) for each in found) <= CELL
    assert any(", points 1 to " in each.what for each in found)


def test_a_long_table_of_a_manipulator_stands_in_rows() -> None:
    rows = range(26)
    motion = (
        f"t = {[k / 4 for k in rows]}\nphi_2 = {[0.1 + k / 50 for k in rows]}\nl_3 = {[0.6 + k / 99 for k in rows]}\n"
    )
    done = solved(test_manipulators.HEAD + test_manipulators.SPHERICAL + "[manipulator.motion]\n" + motion)
    found = [each for each in data(done) if ", points " in each.what]
    assert [each.what.partition(", points ")[2] for each in found[::3]] == ["1 to 8", "9 to 17", "18 to 26"]
    assert [len(each.values) for each in found] == [8, 8, 8, 9, 9, 9, 9, 9, 9]


@pytest.mark.slow
def test_equal_steps_are_counted_in_words_that_fit_every_number() -> None:
    done = ready("reduced-machine")
    with speaking("uk"):
        said = [each.text for each in data(done) if "від нуля" in each.text]
    assert said
    assert all(each.startswith("кількість рівних кроків періоду: ") for each in said)


def test_the_table_of_a_chapter_has_written_numbers_whole() -> None:
    done = solved(HEAD + test_vibration.KINDS["stiffnesses"], ("vibrator.ring.mass=1.234567",))
    chapters = chapters_of({"vibration": "Vibration"}, done.spec, done.results, NONE)
    rows = [row for chapter in chapters for block in chapter.blocks if isinstance(block, Table) for row in block.rows]
    assert next(row[-1] for row in rows if row[0] == "mass of the ring") == "1.234567"
