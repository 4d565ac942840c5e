"""Pictures to scale take the height of what is on them, and no other scale for it."""

from __future__ import annotations

import numpy as np
import pytest

from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.diagram import Axis, Diagram
from tmmcalc.report.drawing.field import Board
from tmmcalc.report.drawing.scales import length_scale
from tmmcalc.report.drawing.shapes import Drawing
from tmmcalc.report.drawing.snug import snug

SIZE = 160.0, 130.0


def flat(drawing: Drawing, box: Box) -> float:
    """A line of 0.3 m by 0.05 m on a board; its scale."""
    ends = np.array([0.0, 0.3 + 0.05j])
    board = Board(drawing, box, ends, 9.0, scale=length_scale)
    board.line(ends)
    return board.mu


def test_a_flat_picture_is_low_and_keeps_its_scale() -> None:
    size = snug(flat, SIZE)
    mu = flat(Drawing(*SIZE, ""), Box(0.0, 0.0, *SIZE))
    assert size == pytest.approx((160.0, 0.05 / mu + 20.0))
    assert flat(Drawing(*size, ""), Box(0.0, 0.0, *size)) == mu


def test_a_diagram_has_its_whole_size() -> None:
    def draw(drawing: Drawing, box: Box) -> None:
        Diagram(drawing, box.inset(20, 20, 5, 5), Axis("x", 0.0, 1.0), Axis("y", 0.0, 1.0))

    assert snug(draw, SIZE) == SIZE
