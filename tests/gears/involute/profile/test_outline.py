"""Whole outlines: simple, periodic, on the curves, within the tolerance that is stated."""

from __future__ import annotations

from math import pi, radians
from time import perf_counter
from typing import Any

import numpy as np
import pytest
from sparing import sparing

from gears.involute.profile.extremes import EXTREMES
from tmmcalc.core.errors import AccuracyError, NoSolutionError, UsageError
from tmmcalc.core.numerics.curves import Curve, chords, cubics
from tmmcalc.core.plane import cross
from tmmcalc.gears.involute.profile.flank import Flank, flank_of
from tmmcalc.gears.involute.profile.generation import in_wheel, path_of_centre, rack_outline
from tmmcalc.gears.involute.profile.outline import Element, arcs, element_outline, half, outline, pieces, tooth
from tmmcalc.gears.involute.rack import Rack
from tmmcalc.gears.involute.wheel import Wheel

WHEELS = [Wheel(10, 0.0), Wheel(14, 0.6, radians(15)), Wheel(8, 0.7), Wheel(5, 0.3), Wheel(120, -0.8, radians(40))]


def area(polygon: np.ndarray) -> float:
    return float(np.sum(cross(polygon, np.roll(polygon, -1)))) / 2


@pytest.mark.parametrize("wheel", WHEELS)
def test_outline_is_a_simple_polygon_of_equal_teeth(wheel: Wheel) -> None:
    flank = flank_of(wheel)
    points = outline(tooth(flank), points=40)
    one = points.reshape(wheel.teeth, -1)
    assert one == pytest.approx(one[0] * np.exp(2j * pi * np.arange(wheel.teeth) / wheel.teeth)[:, None], abs=1e-11)
    radii = np.abs(points)
    assert radii.min() >= float(wheel.root) - 1e-12
    assert radii.max() <= flank.tip + 1e-12
    assert pi * float(wheel.root) ** 2 < area(points) < pi * flank.tip**2
    # no two sides of two neighbouring teeth cross, no point twice
    side = np.append(one[:2].ravel(), one[2, 0])
    assert np.abs(np.diff(side)).min() > 1e-9
    assert not crossing(side)


def test_extreme_outlines_do_not_cross_themselves() -> None:
    drawn = 0
    for wheel, shape in EXTREMES[::7]:
        try:
            one = element_outline(tooth(flank_of(wheel, shape=shape)), points=40)
        except NoSolutionError:
            continue
        next_one = one * np.exp(2j * pi / wheel.teeth)
        assert not crossing(np.append(one, next_one[:20]))
        drawn += 1
    assert drawn > 80


def crossing(line: np.ndarray) -> bool:
    a, b = line[:-1, None], line[1:, None]
    c, d = line[None, :-1], line[None, 1:]
    left = cross(b - a, c - a) * cross(b - a, d - a)
    right = cross(d - c, a - c) * cross(d - c, b - c)
    apart = np.abs(np.subtract.outer(np.arange(len(line) - 1), np.arange(len(line) - 1))) > 1
    return bool(np.any((left < 0) & (right < 0) & apart))


def test_symmetry_of_a_tooth() -> None:
    one = element_outline(tooth(flank_of(Wheel(17, 0.1))), points=50)
    left = one[one.real < -1e-9]
    mirrored = -np.conj(one[one.real > 1e-9])
    distance = np.abs(left[:, None] - mirrored[None, :]).min(axis=0)
    assert np.median(distance) < 1e-14


@pytest.mark.parametrize("tolerance", [1e-2, 1e-4, 1e-7])
@pytest.mark.parametrize("wheel", WHEELS[:4])
def test_polyline_keeps_the_chord_tolerance(wheel: Wheel, tolerance: float) -> None:
    element = tooth(flank_of(wheel))
    for curve in element.curves:
        points = chords(curve, tolerance)
        fine = curve.point(np.linspace(curve.start, curve.end, 20001))
        assert distance(fine, points) <= tolerance
        # economy: a quarter of the points would not do
        assert distance(fine, np.append(points[::4], points[-1])) > tolerance or len(points) < 8


def distance(points: np.ndarray, line: np.ndarray) -> float:
    """Largest distance of points from a polyline."""
    start, chord = line[:-1], np.diff(line)
    keep = np.abs(chord) > 0
    start, chord, best = start[keep], chord[keep], np.full(len(points), np.inf)
    # the points lie in the order of the line: the nearest side is that of the nearest start or one beside it
    nearest = np.searchsorted(np.cumsum(np.abs(chord)), np.append(0, np.cumsum(np.abs(np.diff(points)))))
    for step in range(-2, 3):
        k = np.clip(nearest + step, 0, len(start) - 1)
        part = np.clip(((points - start[k]) / chord[k]).real, 0, 1)
        best = np.minimum(best, np.abs(points - start[k] - part * chord[k]))
    return float(best.max())


@sparing("tolerance", [1e-3, 1e-6, 1e-9], every=3)
def test_cubics_keep_the_tolerance_and_join_smoothly(tolerance: float) -> None:
    for wheel in WHEELS[:4]:
        for curve in tooth(flank_of(wheel)).curves:
            control = cubics(curve, tolerance)
            part = np.linspace(0, 1, 400)[:, None]
            weights = ((1 - part) ** 3, 3 * part * (1 - part) ** 2, 3 * part**2 * (1 - part), part**3)
            fitted = np.sum([w * control[:, i] for i, w in enumerate(weights)], axis=0).T.ravel()
            exact = curve.point(np.linspace(curve.start, curve.end, 200001))
            # rounding of the far side: the polyline of the exact curve strays 1e-11 itself
            assert distance(fitted, exact) <= tolerance + 1e-11
            assert control[1:, 0] == pytest.approx(control[:-1, 3], abs=1e-14)
    assert len(cubics(Curve(np.exp, np.exp, 0.0, 0.0), tolerance)) == 0


def test_pieces_close_the_element() -> None:
    element = tooth(flank_of(Wheel(14, 0.6, radians(15))))
    one = pieces(element, 1e-6)
    for arc, before, after in ((one.crest, one.right[-1, 3], one.left[0, 0]),):
        assert arc.radius * np.exp(1j * arc.start) == pytest.approx(before, abs=1e-13)
        assert arc.radius * np.exp(1j * (arc.start + arc.sweep)) == pytest.approx(after, abs=1e-13)
    gap_end = one.gap.radius * np.exp(1j * (one.gap.start + one.gap.sweep))
    assert one.gap.radius * np.exp(1j * one.gap.start) == pytest.approx(one.left[-1, 3], abs=1e-13)
    assert gap_end == pytest.approx(one.right[0, 0] * np.exp(2j * pi / 14), abs=1e-13)


def test_root_arc_is_the_flat_of_the_tool() -> None:
    wheel = Wheel(20, 0.2, 0.3)
    flank = flank_of(wheel)
    gap = arcs(tooth(flank))[1]
    assert gap.sweep * wheel.reference == pytest.approx(2 * flank.rounding.flat, rel=1e-12)
    # a tool rounded all over leaves no arc
    alpha = radians(20)
    radius = (pi / 4 - 1.25 * np.tan(alpha)) / (np.cos(alpha) - (1 - np.sin(alpha)) * np.tan(alpha))
    round_tool = Wheel(20, 0.2, 0.0, Rack(alpha, 1.0, 0.25, float(radius)))
    assert arcs(tooth(flank_of(round_tool)))[1].sweep == 0
    assert not crossing(outline(tooth(flank_of(round_tool)), points=30)[:200])


def test_points_lie_on_the_tooth() -> None:
    flank = flank_of(Wheel(9, -0.1, 0.2))
    points = half(tooth(flank), points=61)
    assert len(points) == 61
    angles = flank.half_angle_at(np.abs(points))
    # at the root circle the angle is the root of a radius
    assert np.angle(points[:-1]) - pi / 2 == pytest.approx(angles[:-1], abs=1e-9)


def test_bad_requests() -> None:
    element = tooth(flank_of(Wheel(20)))
    bad: tuple[dict[str, Any], ...]
    bad = {}, {"points": 50, "tolerance": 1e-3}, {"points": 3}, {"tolerance": 0.0}, {"tolerance": -1.0}
    for arguments in bad:
        with pytest.raises(UsageError):
            half(element, **arguments)
    with pytest.raises(UsageError):
        half(element, tolerance=float("nan"))
    with pytest.raises(AccuracyError):
        chords(element.curves[0], 1e-18)
    curves = element.curves
    with pytest.raises(NoSolutionError, match="overlap"):
        tooth_of(curves, 21)


def tooth_of(curves: tuple[Curve, ...], teeth: int) -> Element:
    from tmmcalc.gears.involute.profile.outline import checked

    return checked(Element(teeth, curves, 11.0, 8.75))


def test_racks_touch_the_flank_and_never_enter_it() -> None:
    flank = flank_of(Wheel(12, 0.1, 0.3))
    rolls = np.linspace(flank.rolls.limit, flank.rolls.tip, 41)
    for rack in in_wheel(flank, rack_outline(flank), rolls):
        gap = clearance(flank, rack)
        assert gap.min() > -1e-3  # the straight side is given by its ends, the rounding by chords
    # each contact of rounding and straight flank lies on the flank
    theta = np.linspace(flank.slope, pi / 2, 7)
    cut = np.diag(in_wheel(flank, flank.rounding.on_rack(theta), flank.rounding.roll(theta)))
    assert cut == pytest.approx(flank.on_fillet(theta), abs=1e-13)
    assert len(rack_outline(flank, 3)) == 3 * len(rack_outline(flank))
    path = path_of_centre(flank, flank.rounding.roll(theta))
    assert np.abs(path - cut)[-1] == pytest.approx(flank.rounding.height, rel=1e-12)


def clearance(flank: Flank, points: np.ndarray) -> np.ndarray:
    """Distance along the arc of points of the rack from the tooth that lies on the axis."""
    radius = np.abs(points)
    at = (radius > float(flank.wheel.root)) & (radius < flank.tip)
    away = np.abs(np.angle(points[at]) - pi / 2) - flank.half_angle_at(radius[at])
    return np.append(away * radius[at], 1.0)


@pytest.mark.bench
def test_speed() -> None:
    best = np.inf
    for _ in range(5):
        start = perf_counter()
        outline(tooth(flank_of(Wheel(100, 0.2))), points=200)
        best = min(best, perf_counter() - start)
    assert best < 0.02
