"""The feasibility stage on a ready spec: quantities of facts and columns, limits in any unit, rules, faults."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import tmmcalc
from tmmcalc.feasibility.judge import Feasibility
from tmmcalc.project import templates
from tmmcalc.rooms import STAGES

SHAPER = (templates.folder() / "shaper.toml").read_text()
CONSTRAINTS = """
[[constraints]]
name = "stroke"
stage = "kinematics"
value = "stroke_D"
at_least = "600 mm"
at_most = 0.7

[[constraints]]
name = "swift"
stage = "kinematics"
column = "vS_D"
of = "size"
at_most = "100 m/min"

[feasibility]
rule = "stroke and not swift"
form = "R0"
"""


def solved(tmp_path: Path, text: str) -> Feasibility:
    file = tmp_path / "spec.toml"
    file.write_text(SHAPER + text)
    run = tmmcalc.run(tmmcalc.load_spec(file), target="feasibility")
    result: Feasibility = run.results["feasibility"]
    assert set(run.results) == {"structure", "kinematics", "feasibility"}
    return result


def test_quantities_and_their_limits(tmp_path: Path) -> None:
    result = solved(tmp_path, CONSTRAINTS)
    kinematics = tmmcalc.solve_kinematics(tmmcalc.load_spec(templates.folder() / "shaper.toml"))
    stroke, swift = result.verdicts
    assert stroke.value == pytest.approx(kinematics.summaries[0].stroke, rel=1e-15)
    assert (stroke.at_least, stroke.at_most, stroke.unit) == (0.6, 0.7, "m")
    speeds, _ = kinematics.in_time(kinematics.ds, kinematics.dds)
    assert swift.value == pytest.approx(np.abs(speeds[0]).max(), rel=1e-15)
    assert swift.at_most == pytest.approx(100 / 60, rel=1e-15)
    assert stroke.holds
    assert not swift.holds
    assert result.feasible
    assert result.failing == ()
    low, high = (stroke.value - 0.6) / 0.6, (0.7 - stroke.value) / 0.7
    assert stroke.margin == pytest.approx(min(low, high), rel=1e-15)
    a, b = low + high - np.hypot(low, high), -swift.margin  # both limits of one constraint are joined smoothly
    assert result.function == pytest.approx(a + b - np.hypot(a, b), rel=1e-12)
    assert STAGES["feasibility"].load(STAGES["feasibility"].dump(result)) == result


def test_what_fails_is_named(tmp_path: Path) -> None:
    result = solved(tmp_path, CONSTRAINTS.replace("stroke and not swift", "stroke and swift"))
    assert not result.feasible
    assert result.failing == ("swift",)


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ('value = "stroke_D"', 'value = "stroke_E"', "tells no 'stroke_E'"),
        ('column = "vS_D"', 'column = "v_D"', "tells no 'v_D'"),
        ('at_most = "100 m/min"', 'at_most = "100 mm"', "cannot be compared: the quantity is in m/s"),
        ('stage = "kinematics"\ncolumn', 'stage = "cam_law"\ncolumn', "this scene has no cam_law"),
    ],
)
def test_quantities_that_are_not_told(tmp_path: Path, old: str, new: str, words: str) -> None:
    assert old in CONSTRAINTS
    with pytest.raises(tmmcalc.UsageError, match=words):
        solved(tmp_path, CONSTRAINTS.replace(old, new))


@pytest.mark.parametrize(
    ("old", "new", "path"),
    [
        ('name = "swift"', 'name = "stroke"', "constraints[1].name"),
        ('stage = "kinematics"\nvalue', 'stage = "kinematic"\nvalue', "constraints[0].stage"),
        ('value = "stroke_D"', "", "constraints[0]"),
        ('column = "vS_D"', 'column = "vS_D"\nvalue = "x"', "constraints[1].column"),
        ('at_most = "100 m/min"', 'at_most = "fast"', "constraints[1].at_most"),
        ('at_most = "100 m/min"', "", "constraints[1]"),
        ("not swift", "not quick", "feasibility.rule"),
        ('form = "R0"', 'form = "R0"\nsmoothness = 2', "feasibility.smoothness"),
        ('form = "R0"', 'form = "R1"', "feasibility.form"),
        ('of = "size"', 'of = "biggest"', "constraints[1].of"),
    ],
)
def test_faults(tmp_path: Path, old: str, new: str, path: str) -> None:
    assert old in CONSTRAINTS
    file = tmp_path / "spec.toml"
    file.write_text(SHAPER + CONSTRAINTS.replace(old, new))
    with pytest.raises(tmmcalc.SpecError) as refused:
        tmmcalc.load_spec(file)
    assert path in [fault.path for fault in refused.value.faults]
