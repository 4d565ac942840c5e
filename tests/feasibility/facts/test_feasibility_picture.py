"""The picture of the constraints: bars, colours and words against the verdicts."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from drawing import drawn
from paper import of_words, on_sheet, written
from sparing import sparing

from tmmcalc.core.errors import UsageError
from tmmcalc.feasibility.judge import Constraint, Feasibility, FeasibilityTask, judge
from tmmcalc.feasibility.pictures.feasibility import FAILS, HOLDS, IDLE, feasibility_drawing
from tmmcalc.report.drawing.diagram import Diagram
from tmmcalc.report.drawing.shapes import Area, Hatching
from tmmcalc.report.drawing.wording import corners

VALUES = {"a": (1.2, "m", 1.0, None), "b": (3.0, "N", None, 2.0), "c": (50.0, "W", None, 10.0)}
TASK = FeasibilityTask(
    (
        Constraint("a", "s", value="v", at_least=1.0),
        Constraint("b", "s", column="w", of="min", at_most=2.0),
        Constraint("c", "s", value="u", at_most=10.0),
    ),
    "a and b and (a or c)",
)


def found(rows: int = 1) -> Feasibility:
    names = [f"{name}{k}" for k in range(rows) for name in "abc"]
    constraints = tuple(Constraint(name, "kinematics", value="stroke_D", at_most=1.0) for name in names)
    return judge(FeasibilityTask(constraints), {name: VALUES[name[0]] for name in names})


def test_bars_are_margins() -> None:
    result = judge(TASK, VALUES)
    drawing = feasibility_drawing(result)
    (field,) = drawing.fields
    assert isinstance(field, Diagram)
    bars = [shape for shape in drawing.shapes if isinstance(shape, Area) and shape.fill in (HOLDS, FAILS, IDLE)]
    reached = [field.data(complex(bar.points[1])).real for bar in bars]
    assert reached == pytest.approx([20.0, -50.0, -100.0])
    assert [bar.fill for bar in bars] == [HOLDS, FAILS, IDLE]
    hatched = [shape.loops[0] for shape in drawing.shapes if isinstance(shape, Hatching)]
    assert len(hatched) == 2
    assert np.array_equal(hatched[0], bars[1].points)
    said = written(drawing)
    assert [text for text in said if text.endswith(" %")] == ["+20 %", "−50 %", "−400 %"]
    assert [text for text in said if text in "abc"] == ["a", "b", "c"]
    assert "s min w = 3 N\nat most 2 N" in said
    assert "Constraints: not feasible: b\nrule: a and b and (a or c)" in said


@sparing("rows", [1, 4, 10], every=3)
def test_words_do_not_run_into_one_another(rows: int) -> None:
    drawing = feasibility_drawing(found(rows))
    assert not on_sheet(drawing)
    for side in (1, -1):
        boxes = [corners(words) for words in of_words(drawing) if words.align == side and not words.clear]
        boxes.sort(key=lambda box: float(box.imag.min()))
        for below, above in pairwise(boxes):
            assert above.imag.min() > below.imag.max()


def test_a_file_of_another_kind(tmp_path: Path) -> None:
    with pytest.raises(UsageError):
        drawn("feasibility", "feasibility", tmp_path / "x.gif", found())
    drawn("feasibility", "feasibility", tmp_path / "x.svg", found())
    assert (tmp_path / "x.svg").read_bytes().startswith(b"<?xml")
