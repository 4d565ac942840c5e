"""The picture of the constraints: bars, colours and words against the verdicts."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from drawing import drawn
from sparing import sparing

pytest.importorskip("matplotlib")

from matplotlib.colors import to_hex
from matplotlib.patches import Rectangle

from tmmcalc.core.errors import UsageError
from tmmcalc.feasibility.judge import Constraint, Feasibility, FeasibilityTask, judge
from tmmcalc.feasibility.pictures.feasibility import FAILS, HOLDS, IDLE, feasibility_figure

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
    axes = feasibility_figure(result).axes[0]
    bars = [bar for bar in axes.patches if isinstance(bar, Rectangle) and bar.get_height() == pytest.approx(0.42)]
    assert [bar.get_width() for bar in bars] == pytest.approx([20.0, -50.0, -100.0])
    assert [to_hex(bar.get_facecolor()) for bar in bars] == [HOLDS, FAILS, IDLE]
    assert [bool(bar.get_hatch()) for bar in bars] == [False, True, True]
    assert [text.get_text() for text in axes.texts[:3]] == ["+20 %", "-50 %", "-400 %"]
    assert [label.get_text() for label in axes.get_yticklabels()] == ["a", "b", "c"]
    right = [label.get_text() for label in axes.figure.axes[1].get_yticklabels()]
    assert right[1] == "s min w is 3 N\nat most 2 N"
    title = axes.figure.get_suptitle()
    assert title == "Constraints: not feasible: b\nrule: a and b and (a or c)"


@sparing("rows", [1, 4, 10], every=3)
def test_words_do_not_run_into_one_another(rows: int) -> None:
    figure = feasibility_figure(found(rows))
    figure.draw_without_rendering()
    for axes in figure.axes:
        boxes = [label.get_window_extent() for label in axes.get_yticklabels()]
        centres = np.array([(box.y0 + box.y1) / 2 for box in boxes])
        assert all(np.diff(np.sort(centres)) > 0.85 * max(box.height for box in boxes))
        assert all(box.x0 >= 0 and box.x1 <= figure.bbox.width for box in boxes)


def test_a_file_of_another_kind(tmp_path: Path) -> None:
    with pytest.raises(UsageError):
        drawn("feasibility", "feasibility", tmp_path / "x.gif", found())
    drawn("feasibility", "feasibility", tmp_path / "x.svg", found())
    assert (tmp_path / "x.svg").read_bytes().startswith(b"<?xml")
