"""Every extreme scene gives its known answer, and every short proof of an answer holds in mpmath."""

from __future__ import annotations

import re
from typing import Any

import mpmath
import pytest
from sparing import sparing

from tmmcalc.core.errors import TmmError
from tmmcalc.pipeline.outcome import RunResult
from tmmcalc.project.loader import Variants
from tmmcalc.stress.compare import not_finite
from tmmcalc.stress.expected import Value, disagreements, expected
from tmmcalc.stress.shipped import end_of

from .scenes import FOLDER, MARKED, NAMES

KNOWN: dict[str, Any] = {name: getattr(mpmath, name) for name in dir(mpmath) if not name.startswith("_")}


def text(name: str) -> str:
    return (FOLDER / f"{name}.toml").read_text(encoding="utf-8")


PROVED = {f"{name}: {value.name}": value for name in NAMES for value in expected(text(name)).values if value.formula}


def test_there_are_many_and_each_has_an_answer() -> None:
    assert len(NAMES) >= 50
    assert not [name for name in NAMES if "#= " not in text(name)]
    assert len(PROVED) >= 40
    bare = re.compile(r"-?(?:mpf\()?'?[-\d.e+]*'?\)?")
    assert not [name for name, value in PROVED.items() if bare.fullmatch(value.formula)]


@sparing("name", MARKED, every=6)
def test_scene_gives_its_known_answer(name: str) -> None:
    file = FOLDER / f"{name}.toml"
    wanted = expected(text(name))
    end = end_of(Variants(text(name), str(file), FOLDER), wanted)
    assert not list(disagreements(end, wanted))
    if isinstance(end, RunResult):
        assert not [fault for stage in end.outcomes for fault in not_finite(end, stage)]


@pytest.mark.parametrize("value", PROVED.values(), ids=PROVED)
def test_the_answer_is_that_of_its_formula(value: Value) -> None:
    """With thirty digits; numbers such as 0.2 that the spec rounds to binary are written mpf(0.2)."""
    with mpmath.workdps(30):
        proved = eval(value.formula, dict(KNOWN))
        assert abs(proved - mpmath.mpf(value.value)) <= 2e-16 * abs(proved)


def test_a_wrong_answer_is_told() -> None:
    name = "positions-few"
    whole = text(name).replace("#= value | kinematics.vS_B_max[m/s] | 0.2", "#= value | kinematics.vS_B_max[m/s] | 0.3")
    wanted = expected(whole)
    end = end_of(Variants(whole, name, FOLDER), wanted)
    (gap,) = disagreements(end, wanted)
    assert gap.startswith("kinematics.vS_B_max[m/s] = ")
    (gap,) = disagreements(end, expected("#= exit | 3 | no such thing"))
    assert gap == "exit code 0 in place of 3"
    (gap,) = disagreements(end, expected("#= value | kinematics.nothing[m] | 1 | 1e-3 | none"))
    assert "tells no such quantity" in gap
    error = TmmError("another", where="there")
    error.exit_code = 3
    assert len(list(disagreements(error, expected("#= exit | 3 | this")))) == 1
