"""Lines, polygons and arcs cut at areas, against dense samples of them."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tmmcalc.core.plane import Plane
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.field import Board
from tmmcalc.report.drawing.lettering import width, wrapped
from tmmcalc.report.drawing.pens import THIN
from tmmcalc.report.drawing.regions import arcs_in, contains, cut_to, parted
from tmmcalc.report.drawing.shapes import Drawing, Hatching, hatch_lines

BOX = Box(10.0, 20.0, 70.0, 55.0)
SEEDS = st.integers(0, 10_000)


def star(rng: np.random.Generator, centre: complex, size: float) -> Plane:
    """A polygon that sees its centre from all corners."""
    turns = (
        (np.arange(9) + rng.uniform(0, 0.9, 9)) * 2 * np.pi / 9
    )  # no gap of half a turn, behind which it would cross itself
    return np.asarray(centre + size * rng.uniform(0.2, 1.0, 9) * np.exp(1j * turns))


def length(parts: list[Plane]) -> float:
    return float(sum(np.abs(np.diff(part)).sum() for part in parts))


def winding(polygon: Plane, z: Plane) -> np.ndarray:
    """Whether points see the sides of a polygon under a whole turn."""
    seen = np.angle((np.roll(polygon, -1) - z[:, None]) * np.conj(polygon - z[:, None])).sum(axis=1)
    return np.asarray(np.abs(seen) > np.pi)


def shoelace(z: Plane) -> float:
    after = np.roll(z, -1)
    return float(np.sum(z.real * after.imag - after.real * z.imag)) / 2


@given(SEEDS)
@settings(max_examples=60, deadline=None)
def test_parts_of_a_line_are_inside_and_outside(seed: int) -> None:
    rng = np.random.default_rng(seed)
    loops = [star(rng, complex(*rng.uniform(-1, 1, 2)), 2.0) for _ in range(2)]
    line = rng.uniform(-3, 3, 7) + 1j * rng.uniform(-3, 3, 7)
    inside, outside = parted(line, loops)
    assert length(inside) + length(outside) == pytest.approx(length([line]))
    for parts, expected in ((inside, True), (outside, False)):
        for part in parts:
            steps = np.linspace(0.01, 0.99, 40)
            fine = np.concatenate([a + (b - a) * steps for a, b in pairwise(part)])
            within = winding(loops[0], fine) | winding(loops[1], fine)
            assert np.mean(within == expected) == 1
            assert np.array_equal(contains(loops, fine), within)


def test_without_areas_all_is_outside() -> None:
    line = np.array([0, 1, 1 + 1j])
    inside, (outside,) = parted(line, [])
    assert not inside
    assert np.array_equal(outside, line)


@given(SEEDS)
@settings(max_examples=60, deadline=None)
def test_a_polygon_cut_to_a_rectangle(seed: int) -> None:
    """Its area is that of what both have, counted on a grid."""
    rng = np.random.default_rng(seed)
    polygon = star(rng, complex(rng.uniform(0, 80), rng.uniform(10, 60)), 30.0)
    cut = cut_to(polygon, BOX)
    columns, rows = np.arange(BOX.left, BOX.right, 0.25), np.arange(BOX.bottom, BOX.top, 0.25)
    x, y = np.meshgrid(columns + 0.125, rows + 0.125)
    counted = winding(polygon, (x + 1j * y).ravel()).sum() * 0.0625
    assert abs(shoelace(cut) if len(cut) else 0.0) == pytest.approx(counted, abs=12)
    assert len(cut) == 0 or (cut.real.min() >= BOX.left - 1e-9 and cut.imag.max() <= BOX.top + 1e-9)


@given(SEEDS)
@settings(max_examples=60, deadline=None)
def test_arcs_in_a_rectangle(seed: int) -> None:
    rng = np.random.default_rng(seed)
    centre, radius = complex(rng.uniform(-40, 120), rng.uniform(-40, 120)), 10 ** rng.uniform(0.5, 2.5)
    start = rng.uniform(-7, 7)
    end = start + rng.choice([rng.uniform(0.1, 6), 2 * math.pi])
    found = arcs_in(centre, radius, BOX, start, end)
    angles = np.linspace(start, end, 4001)
    z = centre + radius * np.exp(1j * angles)
    seen = (z.real > BOX.left) & (z.real < BOX.right) & (z.imag > BOX.bottom) & (z.imag < BOX.top)
    assert sum(b - a for a, b in found) == pytest.approx(seen.mean() * (end - start), abs=0.02)
    for a, b in found:
        middle = centre + radius * np.exp(1j * np.linspace(a, b, 23)[1:-1])
        assert np.all((middle.real > BOX.left - 1e-6) & (middle.real < BOX.right + 1e-6))
        assert np.all((middle.imag > BOX.bottom - 1e-6) & (middle.imag < BOX.top + 1e-6))


def test_a_circle_inside_stays_whole() -> None:
    (only,) = arcs_in(BOX.middle, 5.0, BOX, 0.0, 2 * math.pi)
    assert only == (0.0, 2 * math.pi)


def test_an_arc_that_goes_on_through_its_beginning_is_one() -> None:
    centre = complex(BOX.left + 3.0, BOX.middle.imag)
    (only,) = arcs_in(centre, 8.0, BOX, 0.0, 2 * math.pi)
    assert only[1] - only[0] == pytest.approx(2 * math.pi - 2 * math.acos(3 / 8))


def test_circles_of_a_board_keep_to_its_frame_and_to_scale() -> None:
    drawing = Drawing(100, 100)
    board = Board(drawing, BOX, np.array([0, 6 + 3j]), 2.0)
    for arc in board.arc(1 + 1j, 3.0, THIN):
        assert arc.radius == pytest.approx(3.0 / board.mu)
        assert arc.centre == pytest.approx(board.place(1 + 1j))
        z = arc.centre + arc.radius * np.exp(1j * np.linspace(arc.start, arc.end, 50))
        assert np.all((z.real > BOX.left - 1e-9) & (z.imag > BOX.bottom - 1e-9))


def test_hatching_leaves_holes_and_specks_out() -> None:
    outer, inner = 20 * np.array([0, 1, 1 + 1j, 1j]), 10 * np.array([0, 1, 1 + 1j, 1j])
    lines = hatch_lines(Hatching((outer, inner)))
    middles = np.array([line.mean() for line in lines])
    assert not np.any((middles.real < 10) & (middles.imag < 10))
    assert length(lines) * 2.0 == pytest.approx(300, rel=0.1)  # area: length by pitch
    assert not hatch_lines(Hatching((outer, outer)))


def test_words_in_lines() -> None:
    text = "the contour has no admissible shifts: $x_1 + x_2$ is too small, 5 \\$ a piece"
    lines = wrapped(text, 40.0, 2.5)
    assert " ".join(lines) == text
    assert all(width(line, 2.5) <= 40 for line in lines)
    assert any("$x_1 + x_2$" in line for line in lines)
    assert wrapped("", 40.0, 2.5) == [""]
