"""Names keep clear of curves, however far these leave the picture, and say where they found no room."""

from __future__ import annotations

import numpy as np
from paper import of_words

from tmmcalc.core.plane import Plane
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.field import Board, Field
from tmmcalc.report.drawing.labels import STEP
from tmmcalc.report.drawing.pens import THICK
from tmmcalc.report.drawing.shapes import Drawing, Stroke
from tmmcalc.report.drawing.wording import corners

PAGE = Box(0.0, 0.0, 100.0, 100.0)


def field() -> Field:
    """A unit of data is 1 mm."""
    return Field(Drawing(100.0, 100.0), PAGE, 0j, (1.0, 1.0))


def drawn_in(one: Field) -> Plane:
    """The points on paper that names of a field keep clear of."""
    x, y, _ = one.labels._around(np.array([-50 - 50j, 150 + 150j]), 1e3, 1e3)
    return np.asarray(x + 1j * y)


def test_a_curve_of_kilometres_takes_points_in_the_frame_alone() -> None:
    one = field()
    one.curve(np.array([-1e9 - 1e9j, 1e9 + 1e9j]), THICK)
    one.curve(np.array([1e9 + 1j, 1e9 + 2j]), THICK)
    points = drawn_in(one)
    assert len(points) < 3 * 100 / STEP
    assert points.real.min() > -1e-6
    assert points.real.max() < 100 + 1e-6
    np.testing.assert_allclose(points.real, points.imag, atol=1e-5)


def test_a_curve_within_the_frame_is_taken_whole() -> None:
    one = field()
    one.curve(np.array([10 + 10j, 90 + 10j, 90 + 20j]), THICK)
    points = drawn_in(one)
    np.testing.assert_allclose(points.real.max(), 90, rtol=1e-9)
    assert len(points) == 1 + int(80 / STEP) + int(10 / STEP)
    assert one.labels.crowded([10 + 10j, 150 + 10j], 1.0) > 60


def test_names_stand_apart_and_what_has_no_room_is_told() -> None:
    drawing = Drawing(100.0, 100.0)
    board = Board(drawing, PAGE, np.array([0j, 1 + 1j]), 10.0)
    for _ in range(60):
        board.labels.put("name", [50 + 50j])
    boxes = [corners(words) for words in of_words(drawing)]
    free = len(boxes) - len(board.labels.faults)
    assert 3 < free < 60
    assert board.labels.count == 60

    def apart(one: np.ndarray, other: np.ndarray) -> bool:
        gap = np.maximum(one.real.min() - other.real.max(), other.real.min() - one.real.max())
        return bool(gap > 0 or one.imag.min() > other.imag.max() or other.imag.min() > one.imag.max())

    assert all(apart(boxes[k], boxes[j]) for k in range(free) for j in range(k))


def test_no_leader_is_a_minus_sign_before_its_name() -> None:
    one = field()
    for height in (10.0, 30.0, 50.0, 70.0, 90.0):
        one.labels.avoid([complex(0, height + 2), complex(100, height + 2)], 10.0)
        one.labels.avoid([complex(0, height - 2), complex(100, height - 2)], 10.0)
        one.labels.put("A", [20 + 1j * height], height=2.0, gaps=(3.5, 7.0))
    leaders = [shape.points for shape in one.drawing.shapes if isinstance(shape, Stroke)]
    assert len(leaders) == 5
    for start, end in leaders:
        assert abs((end - start).imag) > 0.1 * abs((end - start).real)
