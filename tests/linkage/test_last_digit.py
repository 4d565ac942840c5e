"""Near dead points: the error estimate against formulas by hand in 40 digits, and what the last digit of data does."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from functools import cache
from typing import Any

import mpmath as mp
import numpy as np
import pytest
from bounding import assert_bounds

from linkage.forces.loadings import random_loading
from linkage.scenes import crank_slider, four_bar, full_turn, shaper, slotted, with_input
from tmmcalc import Kinematics, TmmError, solve_kinematics
from tmmcalc.core.numerics.extended import EPS, WIDER
from tmmcalc.core.records import names_of
from tmmcalc.linkage.errors import last_digit
from tmmcalc.linkage.forces.solve import solve_forces
from tmmcalc.linkage.kinematics import chain_of
from tmmcalc.linkage.lastdigit import LOST, SENSITIVE, against
from tmmcalc.linkage.loading import Loading
from tmmcalc.linkage.model import Joint, Mechanism
from tmmcalc.linkage.results import LastDigit
from tmmcalc.machine.reduction.solve import solve_reduction

pytestmark = pytest.mark.skipif(not WIDER, reason="no wider float here: the estimate has no reference")
KINDS = ("position", "velocity", "acceleration")
NEAREST, FARTHEST = -12, -2  # powers of ten of the part of a length that is left to the dead point
SOLVED = 1e-3  # of scenes near enough: a change of data by some units is linear there

Scene = tuple[str, tuple[float, ...], Mechanism]


def near_dead_point(rng: np.random.Generator) -> Scene:
    """A linkage whose crank just turns fully, its kind and its lengths."""
    left = 10 ** rng.uniform(NEAREST, FARTHEST)
    short, middle, long = np.sort(rng.uniform(0.1, 1, 3)).tolist()
    crank = float(short * rng.uniform(0.3, 0.9))
    start, positions = float(rng.uniform(0, 6)), int(rng.choice([6, 24, 100]))
    kind = str(rng.choice(["stretched", "folded", "slider", "slotted"]))
    if kind == "stretched":
        lengths = crank, middle, long, middle + long - crank * (1 + left)
        scene = four_bar(*lengths)
    elif kind == "folded":
        lengths = crank, middle, long, long - middle + crank * (1 + left)
        scene = four_bar(*lengths)
    elif kind == "slider":
        lengths = crank, (crank + short) * (1 + left), short
        scene = crank_slider(*lengths)
    else:
        lengths = crank, crank * (1 + max(left, 2e-6))
        scene = slotted(lengths[1], lengths[0])
    return kind, lengths, full_turn(scene, start, positions)


def by_hand(kind: str, lengths: tuple[float, ...], x: float) -> tuple[list[Any], list[Any]]:
    """States (value, first, second derivative) of pin A and, but for the slotted link, pin B; and of the last link."""
    l1, *rest = map(mp.mpf, lengths)
    u = mp.expj(mp.mpf(x))
    a = [l1 * u, 1j * l1 * u, -l1 * u]
    if kind == "slotted":
        a[0] += 1j * rest[0]
        q = a[1] / a[0]
        return [a], [mp.arg(a[0]), q.imag, (a[2] / a[0] - q * q).imag]
    if kind == "slider":
        l2, e = rest
        across = e - a[0].imag
        along = mp.sqrt((l2 - across) * (l2 + across))
        rod = mp.mpc(along, across)
        w = -a[1].imag / along
        b1 = a[1] + 1j * w * rod
        eps = (-a[2].imag + w * w * across) / along
        return [a, [a[0] + rod, b1.real, (a[2] + 1j * eps * rod - w * w * rod).real]], [mp.arg(rod), w, eps]
    l2, l3, l4 = rest
    d = l4 - a[0]
    size = abs(d)
    part = (l2 * l2 - l3 * l3 + size * size) / (2 * size)
    rod = (part + 1j * mp.sqrt(l2 * l2 - part * part)) * d / size
    rocker = a[0] + rod - l4

    def cross(p: Any, q: Any) -> Any:
        return p.real * q.imag - p.imag * q.real

    def rates(w: Any) -> tuple[Any, Any]:  # i x rod - i y rocker = w
        det = cross(1j * rod, -1j * rocker)
        return cross(w, -1j * rocker) / det, cross(1j * rod, w) / det

    p, q = rates(-a[1])
    _, eps = rates(-a[2] + p * p * rod - q * q * rocker)
    return [a, [a[0] + rod, 1j * q * rocker, (1j * eps - q * q) * rocker]], [mp.arg(rocker), q, eps]


def true_errors(scene: Scene, found: Kinematics) -> list[float]:
    """Largest error of the named points, and of the last link, over all positions, by kind.

    Angular accelerations are made from the squares of the rates, and told against these where they are larger.
    """
    kind, lengths, _ = scene
    t, link = found.trace, 2 if kind == "slider" else 3
    rate = float(np.max(np.abs(t.dangle)))
    names = [t.point_names.index(name) for name in ("A", *("B",) * (kind != "slotted"))]
    with mp.workdps(40):
        rows = [by_hand(kind, lengths, x) for x in found.x.tolist()]
        errors = []
        for order, (points, angles) in enumerate(zip((t.r, t.dr, t.ddr), (t.angle, t.dangle, t.ddangle), strict=True)):
            exact = [[points_[k][order] for points_, _ in rows] for k in range(len(names))]
            turned = [link_[order] for _, link_ in rows]
            off = max(
                abs(mp.mpmathify(complex(points[row, i])) - each)
                for row, track in zip(names, exact, strict=True)
                for i, each in enumerate(track)
            )
            size = max(abs(each) for track in exact for each in track)
            told = angles[t.link_ids.index(link)].tolist()
            gaps = [mp.mpf(a) - b for a, b in zip(told, turned, strict=True)]
            swing = max(abs(mp.expj(gap) - 1) if order == 0 else abs(gap) for gap in gaps)
            around = (1.0, rate, max(rate**2, float(np.max(np.abs(t.ddangle)))))[order]
            errors.append(float(max(off / size, swing / around)))
    return errors


@cache
def solved(scenes: int) -> tuple[tuple[Scene, Kinematics], ...]:
    rng = np.random.default_rng(20)
    found = []
    while len(found) < scenes:
        scene = near_dead_point(rng)
        try:
            found.append((scene, solve_kinematics(scene[2])))
        except TmmError:
            continue  # nearer than a regularity of 1e-6
    return tuple(found)


@pytest.mark.parametrize("scenes", [40, pytest.param(300, marks=pytest.mark.slow)])
def test_the_estimate_bounds_the_error_of_exactly_these_data(scenes: int) -> None:
    pairs: dict[str, list[tuple[float, float]]] = {kind: [] for kind in KINDS}
    for scene, found in solved(scenes):
        for kind, error in zip(KINDS, true_errors(scene, found), strict=True):
            pairs[kind].append((getattr(found.error, kind), error))
    for kind, values in pairs.items():
        assert_bounds(values, kind, scenes=scenes)


def nudged(mechanism: Mechanism, rng: np.random.Generator) -> Mechanism:
    """The mechanism with every coordinate of its joints up or down by a unit in its last place."""

    def number(value: float) -> float:
        return float(np.nextafter(value, value * (1 + rng.choice([-1, 1])))) if value else value

    def joint(each: Joint) -> Joint:
        one, two = (complex(number(p.real), number(p.imag)) for p in each.points)
        return replace(each, points=(one, two))

    return replace(mechanism, joints=tuple(map(joint, mechanism.joints)))


def twins(count: int) -> Iterator[tuple[Kinematics, list[float]]]:
    """Scenes, and by how much the motion of nudged ones differs at most, by kind."""
    rng = np.random.default_rng(4)
    for (_, _, mechanism), found in solved(count):
        far = [0.0] * 3
        for _ in range(4):
            try:
                other = solve_kinematics(nudged(mechanism, rng))
            except TmmError:
                continue
            t, o = found.trace, other.trace
            for k, (a, b) in enumerate(((t.r, o.r), (t.dr, o.dr), (t.ddr, o.ddr))):
                far[k] = max(far[k], float(np.max(np.abs(a - b)) / np.max(np.abs(a))))
        yield found, far


@pytest.mark.slow
def test_other_last_digits_differ_by_no_more_than_is_told() -> None:
    ratios = []
    for found, far in twins(40):
        digit = found.error.last_digit
        if digit is None:
            assert min(q.regularity for q in found.qualities) >= SENSITIVE
            continue
        for kind, size in zip(KINDS, far, strict=True):
            told = getattr(digit, kind)
            assert size <= getattr(found.error, kind) + told
            ratios.append(told / max(size, EPS))
    assert len(ratios) > 90
    assert np.median(ratios) < 30


@pytest.mark.slow
def test_a_position_0_at_a_dead_centre_goes_along() -> None:
    """It hangs on the metric, and so do all positions, which are counted from it."""
    rng, compared, moved = np.random.default_rng(33), 0, 0
    for (_, _, given), _ in solved(40):
        mechanism = with_input(given, start=None)
        try:
            found, other = solve_kinematics(mechanism), solve_kinematics(nudged(mechanism, rng))
        except TmmError:
            continue
        digit, t, o = found.error.last_digit, found.trace, other.trace
        if digit is None:
            continue
        compared += 1
        moved += abs(found.x[0] - other.x[0]) > 100 * EPS
        for kind, a, b in zip(KINDS, (t.r, t.dr, t.ddr), (o.r, o.dr, o.ddr), strict=True):
            told = getattr(found.error, kind) + getattr(digit, kind)
            assert np.max(np.abs(a - b)) <= told * np.max(np.abs(a))
    assert compared > 30
    assert moved > 3


def test_a_slotted_link_without_a_point_tells_of_its_angle() -> None:
    mechanism = full_turn(slotted(0.1 * (1 + 2e-6), 0.1), 0.1, 60)
    mechanism = replace(mechanism, links=tuple(replace(link, points={}) for link in mechanism.links))
    found = solve_kinematics(mechanism)
    digit = found.error.last_digit
    assert digit is not None
    assert digit.acceleration > 1e-12
    assert found.error.acceleration > 1e-12  # its pin A is right to rounding


def test_far_from_dead_points_nothing_is_told() -> None:
    assert solve_kinematics(shaper()).error.last_digit is None


def test_by_a_formula() -> None:
    """Of a slider near l = r + e the coordinate is x = sqrt(l^2 - (r + e)^2): dx = (l dl + (r + e) (dr + de))/x."""
    r, e, left = 0.1, 0.05, 1e-6
    l = (r + e) * (1 + left)
    mechanism = full_turn(crank_slider(r, l, e), 1.5 * math.pi, 4)
    found = solve_kinematics(mechanism)
    chain, x = chain_of(mechanism, found), found.x[:1]
    along = math.sqrt(l * l - (r + e) ** 2)
    one = last_digit(chain, x)
    size = float(np.max(np.abs(found.trace.r[:, 0])))
    turn = abs(float(x[0])) * r * abs(math.cos(float(x[0]))) * (r + e) / along
    assert one.position >= EPS * ((l * l + (r + e) ** 2) / along - turn) / size / 1.01
    assert one.position <= EPS * (2 * (l * l + (r + e) ** 2) / along + turn) / min(size, 1.0) + 10 * EPS / along


def test_no_digit_is_left_where_the_links_do_not_meet() -> None:
    assert against(np.array([0.1, np.nan]), 1.0) == LOST
    assert against(np.array([5.0]), 1.0) == LOST
    assert against(np.array([1e-9]), 0.0) == 1e-9


def loaded_scenes(count: int) -> Iterator[tuple[Mechanism, Loading, Kinematics]]:
    rng = np.random.default_rng(9)
    for (_, _, mechanism), found in solved(count):
        if found.error.last_digit is not None and found.error.last_digit.acceleration < SOLVED:
            yield mechanism, replace(random_loading(rng, mechanism), springs=()), found


@pytest.mark.slow
def test_forces_and_reduction_tell_it() -> None:
    rng, met = np.random.default_rng(5), 0
    for mechanism, loading, found in loaded_scenes(14):
        forces, reduction = (solve(mechanism, loading, found) for solve in (solve_forces, solve_reduction))
        digit = reduction.error.last_digit
        assert forces.last_digit is not None
        assert digit is not None
        try:
            other = nudged(mechanism, rng)
            kinematics = solve_kinematics(other)
            apart, reduced = (solve(other, loading, kinematics) for solve in (solve_forces, solve_reduction))
        except TmmError:
            continue
        met += 1
        for a, b in ((forces.reaction, apart.reaction), (forces.drive, apart.drive)):
            assert np.max(np.abs(a - b)) <= (forces.error + forces.last_digit) * np.max(np.abs(a))
        inertia = np.max(np.abs(reduction.inertia - reduced.inertia)) / np.max(reduction.inertia)
        assert inertia <= reduction.error.inertia + digit.inertia
        moments = np.max(np.abs(reduction.moment - reduced.moment)) / np.max(np.abs(reduction.parts))
        assert moments <= 4 * (reduction.error.moment + digit.moment)
    assert met > 5


def test_its_parts_are_those_of_the_estimate() -> None:
    assert names_of(LastDigit) == KINDS
