"""From [indexing] to what is asked of an indexing drive: every key, laws, defaults, faults with their lines."""

from __future__ import annotations

import math
import re
import tomllib
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from project.scenes import CONFIGS
from project.test_schema import accepts

from tmmcalc.cams.indexing.task import IndexingTask
from tmmcalc.cams.tables.indexing import IndexingTable
from tmmcalc.cams.tables.indexing_law import StepLawTable
from tmmcalc.cams.tables.tasks.indexing import to_indexing
from tmmcalc.core.errors import SpecError, UsageError
from tmmcalc.project import load_spec, parse_spec
from tmmcalc.project.files import named_files

DEGREE = math.pi / 180
DOCS = CONFIGS.parent / "docs" / "spec.md"
NEEDED = {"rollers": "8", "step_angle": '"100 deg"', "law": '"sine"', "wheel_radius": '"60 mm"'}


def spec_text(lines: str = "", **given: str) -> str:
    kept = "".join(f"{key} = {value}\n" for key, value in {**NEEDED, **given}.items())
    return f"[indexing]\n{kept}{lines}\n"


def asked(lines: str = "", **given: str) -> IndexingTask:
    return to_indexing(parse_spec(spec_text(lines, **given)))


# key: lines with it, what is read from the task, and the value
KEYS: dict[str, tuple[str, Callable[[IndexingTask], Any], Any]] = {
    "rollers": ("", lambda task: task.rollers, 8),
    "step_angle": ("", lambda task: task.step, 100 * DEGREE),
    "law": ("", lambda task: task.law.name, "sine"),
    "wheel_radius": ("", lambda task: task.wheel, 0.06),
    "centre_distance": ('centre_distance = "120 mm"', lambda task: task.ratio, 2.0),
    "ratio": ("ratio = 2.4", lambda task: task.ratio, 2.4),
    "roller_radius": ('roller_radius = "9 mm"', lambda task: task.roller, 0.009),
    "roller_radii": (
        'roller_radii = ["9 mm", "7 mm"]',
        lambda task: (task.roller, task.second_roller),
        (0.009, 0.007),
    ),
    "dwells": ('dwells = ["100 deg", "60 deg"]', lambda task: task.dwells, (100 * DEGREE, 60 * DEGREE)),
    "pressure_angle": ('pressure_angle = "45 deg"', lambda task: task.limit, 45 * DEGREE),
    "friction": ("friction = 0.1", lambda task: (task.friction, task.pin_friction), (0.1, 0.127)),
    "pin_friction": ("pin_friction = 0.3", lambda task: (task.friction, task.pin_friction), (0.18, 0.3)),
    "shaft_radius": ('shaft_radius = "15 mm"', lambda task: task.shaft, 0.015),
    "steps": ("steps = 50", lambda task: task.rows, 50),
    "tolerance": ('tolerance = "10 um"', lambda task: task.tolerance, 1e-5),
}


@pytest.mark.parametrize("key", KEYS)
def test_every_key_reaches_the_task(key: str) -> None:
    lines, read, value = KEYS[key]
    assert read(asked(lines)) == pytest.approx(value) if not isinstance(value, str) else read(asked(lines)) == value


def test_every_key_has_its_test_and_its_line_in_the_docs() -> None:
    assert KEYS.keys() == IndexingTable.model_fields.keys()
    section = DOCS.read_text().split("## `[indexing]`")[1].split("## Values")[0]
    named = set(re.findall(r"`(\w+)`", section))
    assert named >= IndexingTable.model_fields.keys() | StepLawTable.model_fields.keys()


def test_defaults() -> None:
    task = asked()
    assert (task.ratio, task.roller, task.shaft, task.rows, task.tolerance) == (None, None, 0.0, 20, 1e-6)
    assert task.limit == pytest.approx(50 * DEGREE)
    assert task.pin_friction == pytest.approx(1.27 * 0.18)


@pytest.mark.parametrize(
    ("law", "peak"),
    [
        ('"0010"', 1.525423728813559),
        ('"0000"', 1.5),
        ("{ constant_ends = 0.1 }", 1.525423728813559),
        ("{ polynomial = [0, 0, 3, -2] }", 1.5),
        ("{ acceleration = [[0, 1], [1, -1]] }", 1.5),
        ("{ peak_velocity = 1.625 }", 1.625),
        ('{ points = [[0, 0], ["45 deg", 0.5], ["90 deg", 1]] }', None),
    ],
)
def test_laws(law: str, peak: float | None) -> None:
    task = asked(law=law)
    if peak is not None:
        assert task.law.peak == pytest.approx(peak)
    assert (task.law.law is None) == ("peak" in law)


def test_a_law_from_a_file_beside_the_spec(tmp_path: Path) -> None:
    k = np.linspace(0, 1, 21)
    rows = "\n".join(f"{x},{3 * x**2 - 2 * x**3}" for x in k)
    (tmp_path / "law.csv").write_text(f"k,s\n{rows}\n")
    file = tmp_path / "spec.toml"
    file.write_text(spec_text(law='{ file = "law.csv" }'))
    spec = load_spec(file)
    assert to_indexing(spec).law.peak == pytest.approx(1.5, abs=2e-3)
    assert named_files(spec, tmp_path) == [tmp_path / "law.csv"]


# what is written: the line of the fault, its place, the rule, the remedy
FAULTS = {
    "odd": ({"rollers": "7"}, "", 2, "rollers", "7 rollers do not fill two rows", "8"),
    "few": ({"rollers": "2"}, "", 2, "rollers", "2 is out of range", "between 4"),
    "half a turn": ({"step_angle": '"180 deg"'}, "", 3, "step_angle", "is out of range", "between"),
    "no law": ({"law": '"shum"'}, "", 4, "law", "is no law of motion", 'did you mean "shun"'),
    "no code": ({"law": '"0060"'}, "", 4, "law", "is no law of motion", "0000 to 0050"),
    "empty": ({"law": "{}"}, "", 4, "law", "missing key", "constant_ends"),
    "two ways": ({"law": "{ constant_ends = 0.1, peak_velocity = 2 }"}, "", 4, "law", "together", "keep one"),
    "skew": ({"law": "{ polynomial = [0, 0, 6, -8, 3] }"}, "", 4, "law.polynomial", "not symmetric", "s(1 - k)"),
    "struck": ({"law": "{ polynomial = [0, 1, 0] }"}, "", 4, "law.polynomial", "cannot move", "would be struck"),
    "twice": ({}, 'ratio = 2.5\ncentre_distance = "150 mm"', 6, "ratio", "together with centre_distance", "remove"),
    "inside": ({}, 'centre_distance = "50 mm"', 6, "centre_distance", "is not above wheel_radius", "larger"),
    "ratio": ({}, "ratio = 0.9", 6, "ratio", "out of range", "2.6"),
    "roller": ({}, 'roller_radius = "60 mm"', 6, "roller_radius", "on a wheel of 60 mm", "smaller"),
    "unit": ({}, "roller_radius = 12", 6, "roller_radius", "without a unit", "12 mm"),
    "wheel": ({"wheel_radius": "60"}, 'centre_distance = "0.2 m"', 5, "wheel_radius", "without a unit", "60 mm"),
    "unknown": ({}, 'centre = "150 mm"', 6, "centre", "unknown key", "centre_distance"),
}


@pytest.mark.parametrize("name", FAULTS)
def test_one_slip_is_one_fault_at_its_line(name: str) -> None:
    given, lines, line, place, rule, remedy = FAULTS[name]
    with pytest.raises(SpecError) as caught:
        parse_spec(spec_text(lines, **given))
    assert len(caught.value.faults) == 1, caught.value
    (fault,) = caught.value.faults
    assert fault.line == line
    assert fault.path.startswith(f"indexing.{place}")
    assert rule in fault.message
    assert remedy in fault.remedy


def test_all_faults_at_once() -> None:
    with pytest.raises(SpecError) as caught:
        parse_spec(spec_text("ratio = 0.5\nsteps = 1", rollers="9"))
    assert len(caught.value.faults) == 3


def test_a_missing_key_is_told_with_an_example() -> None:
    for key in NEEDED:
        kept = "".join(f"{name} = {value}\n" for name, value in NEEDED.items() if name != key)
        with pytest.raises(SpecError, match="missing key") as caught:
            parse_spec(f"[indexing]\n{kept}")
        assert f"add {key} = " in caught.value.faults[0].remedy


def test_a_spec_without_one() -> None:
    with pytest.raises(UsageError, match=r"no \[indexing\]"):
        to_indexing(load_spec(CONFIGS / "cam.toml"))


def test_the_schema_takes_what_the_reader_takes(schema: dict[str, Any]) -> None:
    for law in ('"0010"', '"sine"', "{ constant_ends = 0.1 }", "{ peak_velocity = 1.7 }"):
        assert accepts(schema, tomllib.loads(spec_text(law=law)), schema)
    for law in ('"0060"', "{ constant_ends = 0.6 }"):
        assert not accepts(schema, tomllib.loads(spec_text(law=law)), schema)
    assert accepts(schema, tomllib.loads((CONFIGS / "cam-lantern.toml").read_text()), schema)
