"""How far shapes reach, and drawings without the blank over and under them."""

from __future__ import annotations

import math

import numpy as np
import pytest

from tmmcalc.report.drawing.pens import MIDDLE, THIN
from tmmcalc.report.drawing.reach import BLANK, around, moved, reach, trimmed
from tmmcalc.report.drawing.shapes import Arc, Area, Dimension, Drawing, Hatching, Shape, Stroke, Words

SQUARE = np.array([20 + 40j, 30 + 40j, 30 + 50j, 20 + 50j])
SHAPES: tuple[Shape, ...] = (
    Stroke(SQUARE, MIDDLE, closed=True),
    Arc(25 + 45j, 4.0, MIDDLE, 0.0, math.pi),
    Area(SQUARE, "#fff"),
    Hatching((SQUARE,)),
    Words(25 + 60j, "A", 3.5),
    Dimension(20 + 40j, 30 + 40j, 25 + 34j, "10"),
)


@pytest.mark.parametrize("shape", SHAPES, ids=lambda shape: type(shape).__name__)
def test_a_moved_shape_is_the_same_elsewhere(shape: Shape) -> None:
    before, after = reach(shape), reach(moved(shape, 3.0 - 12.5j))
    assert np.allclose([after.left, after.right], [before.left + 3.0, before.right + 3.0])
    assert np.allclose([after.bottom, after.top], [before.bottom - 12.5, before.top - 12.5])


def test_a_trimmed_drawing_has_all_its_shapes_and_no_blank_over_and_under_them() -> None:
    drawing = Drawing(60.0, 100.0, "title")
    drawing.add(*SHAPES)
    found = trimmed(drawing, 2.0)
    box = around(map(reach, found.shapes))
    assert (found.width, found.title, len(found.shapes)) == (60.0, "title", len(SHAPES))
    assert box.bottom == pytest.approx(2.0)
    assert found.height - box.top == pytest.approx(2.0, abs=0.1)


def test_what_reaches_over_a_side_is_not_cut() -> None:
    drawing = Drawing(60.0, 100.0)
    drawing.add(Words(-2 + 1j, "A", 3.5), Words(61 + 99.5j, "B", 3.5))
    found = trimmed(drawing)
    box = around(map(reach, found.shapes))
    assert box.left == pytest.approx(0.0)
    assert 63.0 < box.right <= found.width < box.right + 0.1
    assert box.bottom == pytest.approx(0.0)
    assert 100.0 < box.top <= found.height < box.top + 0.1


def test_a_drawing_without_shapes_stays() -> None:
    drawing = Drawing(60.0, 100.0)
    assert trimmed(drawing) is drawing


def test_words_above_and_below_come_near_to_what_is_drawn_which_stays_to_scale() -> None:
    """A strip without anything between two strokes is part of the picture."""
    drawing = Drawing(60.0, 100.0)
    strokes = [Stroke(np.array([10 + y * 1j, 40 + y * 1j]), THIN) for y in (30.0, 60.0)]
    drawing.add(Words(25 + 95j, "heading", 2.5), Words(25 + 5j, "note", 2.5), *strokes)
    found = trimmed(drawing)
    heading, note, *lines = [reach(shape) for shape in found.shapes]
    assert lines[1].bottom - lines[0].top == pytest.approx(30.0)
    assert heading.bottom - lines[1].top == pytest.approx(BLANK)
    assert lines[0].bottom - note.top == pytest.approx(BLANK)
