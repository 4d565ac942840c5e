"""Two profiles rolled through a mesh: they keep the ratio, touch with both flanks, and never overlap."""

from __future__ import annotations

from math import acos, cos, pi, radians

import numpy as np
import pytest
from sparing import sparing

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.plane import cross
from tmmcalc.gears.involute.pair import Pair, pair_of_shifts
from tmmcalc.gears.involute.profile.flank import Flank, flank_of
from tmmcalc.gears.involute.profile.mesh import Placing, placings, ring_placings
from tmmcalc.gears.involute.profile.outline import arcs, outline, tooth
from tmmcalc.gears.involute.profile.ring import RingFlank, ring_flank
from tmmcalc.gears.involute.rack import RACKS
from tmmcalc.gears.involute.wheel import Wheel

PAIRS = {
    "spur": pair_of_shifts(Wheel(13, 0.25), Wheel(30, 0.15)),
    "helical": pair_of_shifts(Wheel(14, 0.6, radians(15)), Wheel(17, 0.5, radians(15))),
    "undercut": pair_of_shifts(Wheel(11, 0.1), Wheel(40, 0.0)),
    "smallest": pair_of_shifts(Wheel(5, 0.5, radians(45)), Wheel(1000, -0.5, radians(45))),
    "steep": pair_of_shifts(Wheel(9, 0.45, radians(30)), Wheel(1000, 0.0, radians(30))),
    "flat": pair_of_shifts(Wheel(30, -0.2, 0.0, RACKS["AGMA 14.5"]), Wheel(31, 0.4, 0.0, RACKS["AGMA 14.5"])),
    "large": pair_of_shifts(Wheel(17, 0.0), Wheel(400, 0.0)),
}
PHASES = (-0.21, -0.05, 0.0, 0.08, 0.3)


def flanks(pair: Pair) -> tuple[Flank, Flank]:
    first, second = (flank_of(wheel, float(tip)) for wheel, tip in zip(pair.wheels, pair.tips, strict=True))
    return first, second


def nearest(pair: Pair, phase: float, side: int, part: tuple[float, float], teeth: range, samples: int) -> np.ndarray:
    """Distance (k, n) along the arc from wheel 1 of the involutes of teeth of wheel 2, one side of theirs."""
    first, second = flanks(pair)
    one, two = placings(pair, phase)
    xi = np.linspace(*part, samples)
    turns = np.exp(2j * pi * np.array(teeth) / pair.second.teeth)[:, None]
    points = second.on_involute(xi)
    points = two(turns * (points if side > 0 else -np.conj(points)))
    own = (points - one.centre) * np.exp(-1j * one.turn)
    radius, pitch = np.abs(own), 2 * pi / pair.first.teeth
    angle = np.mod(np.angle(own) - pi / 2 + pitch / 2, pitch) - pitch / 2
    away = np.full(radius.shape, np.inf)
    at = radius < first.tip
    away[at] = (np.abs(angle[at]) - first.half_angle_at(radius[at])) * radius[at]
    return away


@sparing("name", PAIRS, every=4)
@pytest.mark.parametrize("side", [1, -1])
def test_ratio_is_constant(name: str, side: int) -> None:
    pair = PAIRS[name]
    second = flanks(pair)[1]
    # with a contact ratio below 1 the flanks touch about P only: the left ones at 0, the right ones a tooth later
    about = 0.0 if side > 0 else 2 * placings(pair)[0].turn
    for phase in PHASES if pair.contact_ratio > 1 else (about - 0.02, about, about + 0.02):
        low, high, samples = second.lowest, second.highest, 801
        centre = round(-phase * pair.first.teeth / (2 * pi))
        teeth = range(centre - 3, centre + 4)
        for _ in range(5):
            away = nearest(pair, phase, side, (low, high), teeth, samples)
            tooth_at, best = np.unravel_index(int(np.argmin(away)), away.shape)
            teeth, step = range(teeth[tooth_at], teeth[tooth_at] + 1), (high - low) / (samples - 1)
            middle = low + step * float(best)
            low, high, samples = max(middle - 2 * step, second.lowest), min(middle + 2 * step, second.highest), 41
        assert abs(away.min()) < 1e-10


@sparing("name", ["spur", "helical", "undercut"], every=3)
def test_outlines_do_not_overlap(name: str) -> None:
    pair, tolerance = PAIRS[name], 1e-4
    polygons = [outline(tooth(flank), tolerance=tolerance) for flank in flanks(pair)]
    pitch_point = 1j * float(pair.operating[0])
    for phase in PHASES[:3]:
        one, two = (placing(polygon) for placing, polygon in zip(placings(pair, phase), polygons, strict=True))
        close = one[np.abs(one - pitch_point) < 4]
        depth = np.where(inside(close, two), separation(close, two), 0.0)
        assert depth.max() < 2 * tolerance
        assert separation(close, two).min() < 2 * tolerance


def inside(points: np.ndarray, polygon: np.ndarray) -> np.ndarray:
    """Whether points lie inside a polygon, by the crossings of a ray."""
    a, b = polygon[None, :], np.roll(polygon, -1)[None, :]
    p = points[:, None]
    spans = (a.imag > p.imag) != (b.imag > p.imag)
    right = (cross(b - a, p - a) > 0) == (b.imag > a.imag)
    return np.asarray(np.sum(spans & right, axis=1) % 2 == 1)


def separation(points: np.ndarray, polygon: np.ndarray) -> np.ndarray:
    """Distance of points from the sides of a polygon that lie near them."""
    a, b = polygon, np.roll(polygon, -1)
    near = np.abs(a - points.mean()) < 6
    a, chord = a[near][None, :], (b - a)[near][None, :]
    part = np.clip(((points[:, None] - a) / chord).real, 0, 1)
    return np.abs(points[:, None] - a - part * chord).min(axis=1)


def test_pitch_point_lies_on_both_flanks() -> None:
    pair = PAIRS["helical"]
    one, two = placings(pair)
    for flank, placing, sign in zip(flanks(pair), (one, two), (1, -1), strict=True):
        radius = float(pair.operating[0]) if sign > 0 else float(pair.operating[1])
        angle = float(flank.half_angle_at(radius)[0])
        point = placing(np.array([radius * 1j * np.exp(1j * angle)]))[0]
        assert point == pytest.approx(1j * float(pair.operating[0]), abs=1e-12)


def ring_mesh(z1: int, z2: int, x1: float, x2: float, helix: float) -> tuple[Wheel, Wheel, float, float]:
    from tmmcalc.gears.involute.function import inverse_involute, involute

    pinion, like = Wheel(z1, x1, helix), Wheel(z2, x2, helix)
    start = pinion.section.angle
    target = float(involute(start)) + 2 * (x2 - x1) * np.tan(pinion.rack.angle) / (z2 - z1)
    angle = float(inverse_involute(target))
    return pinion, like, angle, (like.reference - pinion.reference) * cos(start) / cos(angle)


@pytest.mark.parametrize(("z1", "z2", "x1", "x2", "helix"), [(20, 70, 0.0, 0.0, 0.0), (23, 80, 0.3, 0.5, 0.3)])
def test_pinion_rolls_in_its_ring(z1: int, z2: int, x1: float, x2: float, helix: float) -> None:
    pinion, like, angle, distance = ring_mesh(z1, z2, x1, x2, helix)
    flank, ring = flank_of(pinion), ring_flank(like, like.reference + x2 - 0.9, like.reference + x2 + 1.25)
    xi = np.linspace(flank.lowest, flank.highest, 4001)
    for phase in (0.0, 0.07, -0.11):
        one, two = ring_placings(pinion, like, angle, distance, phase)
        for side in (1, -1):
            gap = in_ring(flank, ring, one, two, xi, side)
            assert -1e-12 < gap.min() < 1e-7


def in_ring(flank: Flank, ring: RingFlank, one: Placing, two: Placing, xi: np.ndarray, side: int) -> np.ndarray:
    """Distance along the arc of the pinion's involutes inside the spaces of the ring, where these are involutes."""
    points = flank.on_involute(xi) if side > 0 else -np.conj(flank.on_involute(xi))
    turns = np.exp(2j * pi * np.arange(-3, 4) / flank.wheel.teeth)[:, None]
    own = (one(turns * points) - two.centre) * np.exp(-1j * two.turn)
    radius, pitch = np.abs(own), 2 * pi / ring.teeth
    at = (radius > ring.tip) & (radius < ring.form)
    turn = np.mod(np.angle(own[at]) - pi / 2 + pitch / 2, pitch) - pitch / 2
    pressure = np.arccos(ring.base / radius[at])
    half = ring.base_half_angle - (np.tan(pressure) - pressure)
    return np.asarray((half - np.abs(turn)) * radius[at])


def test_ring_is_smooth_and_closed() -> None:
    like = Wheel(70, 0.2, 0.2)
    ring = ring_flank(like, like.reference - 0.7, like.reference + 1.45)
    corner, flank = ring.element.curves
    meet = corner.point(np.array([corner.end]))[0], flank.point(np.array([flank.start]))[0]
    assert meet[0] == pytest.approx(meet[1], abs=1e-12)
    down, on = corner.rate(np.array([corner.end]))[0], flank.rate(np.array([flank.start]))[0]
    down, on = down * np.sign(corner.end - corner.start), on * np.sign(flank.end - flank.start)
    assert down / abs(down) == pytest.approx(on / abs(on), abs=1e-12)
    assert abs(corner.point(np.array([corner.start]))[0]) == pytest.approx(ring.root, rel=1e-14)
    crest, gap = arcs(ring.element)
    points = outline(ring.element, tolerance=1e-4)
    assert np.abs(points).max() == pytest.approx(ring.root, abs=1e-4)
    assert np.abs(points).min() == pytest.approx(ring.tip, abs=1e-4)
    # teeth and spaces share the pitch circle of the reference
    assert crest.sweep > 0
    assert 2 * pi / 70 > gap.sweep > 0


def test_largest_corner_rounds_the_whole_bottom() -> None:
    like = Wheel(60, 0.0)
    tip, root = 29.3, 31.25
    with pytest.raises(NoSolutionError, match="does not fit") as caught:
        ring_flank(like, tip, root, 0.9)
    largest = caught.value.limit
    assert largest is not None
    full = ring_flank(like, tip, root, largest)
    assert abs(full.centre.real) < 1e-12
    assert arcs(full.element)[0].sweep == 0


@pytest.mark.parametrize(
    ("tip", "root", "corner", "words"),
    [
        (27.0, 31.25, None, "between base and root"),
        (31.5, 31.25, None, "between base and root"),
        (29.3, 31.25, -0.1, "does not fit"),
        (31.2, 31.25, 0.38, "beyond the tip circle"),
        (29.3, 36.0, None, "pointed below the root circle"),
    ],
)
def test_rings_that_do_not_exist(tip: float, root: float, corner: float | None, words: str) -> None:
    assert Wheel(60).base == pytest.approx(30 * cos(acos(cos(radians(20)))))
    with pytest.raises(NoSolutionError, match=words):
        ring_flank(Wheel(60), tip, root, corner)
