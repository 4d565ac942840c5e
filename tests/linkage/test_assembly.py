"""Assembly intervals against closed forms and dense scans; what the messages say; ranges inside and across limits."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from properties import examples
from random_mechanisms import build
from sparing import sparing
from transforms import moved, scaled

from linkage.scenes import (
    bar,
    crank_slider,
    driven_rod,
    four_bar,
    full_turn,
    part,
    pin,
    slide,
    slotted,
    trammel,
    with_grid,
    with_input,
)
from tmmcalc import AssemblyError, SingularityError, solve_kinematics
from tmmcalc.linkage.assembly import find_domain
from tmmcalc.linkage.chain import Chain, compile_chain
from tmmcalc.linkage.model import Mechanism, Output
from tmmcalc.linkage.placing import SEAM
from tmmcalc.linkage.results import Domain
from tmmcalc.linkage.structure import solve_structure
from tmmcalc.linkage.variants import given_variants

TURN = 2 * math.pi
STABLE = examples(150, derandomize=True, database=None)


def chain_of(mechanism: Mechanism) -> Chain:
    structure = solve_structure(mechanism)
    return compile_chain(mechanism, structure, given_variants(mechanism, structure))


def domain_of(mechanism: Mechanism) -> Domain:
    return find_domain(chain_of(mechanism), SEAM - math.pi, SEAM + math.pi)


def limits_of(domain: Domain) -> list[float]:
    """All limit positions, ascending in [0, 2 pi)."""
    return sorted(limit.x % TURN for interval in domain.intervals for limit in interval.limits)


def inside(domain: Domain, x: np.ndarray) -> np.ndarray:
    held = [np.mod(x - i.low, TURN) <= i.high - i.low for i in domain.intervals]
    return np.ones(x.shape, bool) if domain.full else np.any(held, axis=0)


def same_angles(found: list[float], expected: list[float], tolerance: float) -> None:
    """As many of one as of the other, and each near one of the other, round the circle."""
    assert len(found) == len(expected), (np.degrees(found), np.degrees(expected))
    if not found:
        return
    apart = np.abs([[math.remainder(a - b, TURN) for a in found] for b in expected])
    assert np.max(apart.min(axis=0)) < tolerance
    assert np.max(apart.min(axis=1)) < tolerance


def arcs(cosine: float) -> list[float]:
    """Both angles with this cosine, none if it is beyond 1."""
    return [math.acos(cosine), -math.acos(cosine)] if abs(cosine) < 1 else []


length = st.floats(0.2, 5.0)


@given(length, length, length, length, st.floats(-3, 3))
@STABLE
def test_four_bars_of_all_classes(l1: float, l2: float, l3: float, c: float, turn: float) -> None:
    """The distance of the outer pins A and C must lie between |l2 - l3| and l2 + l3."""
    cosines = [(l1**2 + c**2 - reach**2) / (2 * l1 * c) for reach in (abs(l2 - l3), l2 + l3)]
    if min(abs(abs(cosine) - 1) for cosine in cosines) < 1e-6:
        return
    expected = [angle + turn for cosine in cosines for angle in arcs(cosine)]
    mechanism = moved(four_bar(l1, l2, l3, c), turn, 1 - 2j)
    if not expected and not abs(l2 - l3) < abs(l1 - c) < l2 + l3:
        with pytest.raises(AssemblyError, match="cannot be assembled at any crank angle"):
            domain_of(mechanism)
        return
    domain = domain_of(mechanism)
    same_angles(limits_of(domain), expected, 1e-9)
    assert domain.full is (not expected)
    x = np.linspace(-math.pi, math.pi, 1001)
    q = np.abs(l1 * np.exp(1j * (x - turn)) - c)
    clear = np.min([np.abs(q - abs(l2 - l3)), np.abs(q - l2 - l3)], axis=0) > 1e-9
    assert np.array_equal(inside(domain, x)[clear], ((q > abs(l2 - l3)) & (q < l2 + l3))[clear])


@given(length, length, st.floats(-5, 5))
@STABLE
def test_offset_crank_sliders(l1: float, l2: float, e: float) -> None:
    """The pin A must not be farther than l2 from the line of the slider."""
    sines = [(e - l2) / l1, (e + l2) / l1]
    if min(abs(abs(s) - 1) for s in sines) < 1e-6:
        return
    expected = [angle + math.pi / 2 for s in sines for angle in arcs(s)]
    if abs(e) > l1 + l2:
        with pytest.raises(AssemblyError, match="off its line"):
            domain_of(crank_slider(l1, l2, e))
        return
    same_angles(limits_of(domain_of(crank_slider(l1, l2, e))), expected, 1e-9)


@given(length, length, st.floats(-4, 4))
@STABLE
def test_slotted_links_with_an_offset(l0: float, l1: float, h: float) -> None:
    """The pivots must not be nearer than the offset of the slot."""
    sine = (h**2 - l0**2 - l1**2) / (2 * l0 * l1)
    if abs(abs(sine) - 1) < 1e-6 or abs(h) < 1e-3 or abs(l0 - l1) < 1e-3:
        return
    expected = [angle + math.pi / 2 for angle in arcs(sine)]
    if sine > 1:
        with pytest.raises(AssemblyError, match="always nearer to each other than the offset"):
            domain_of(slotted(l0, l1, h))
        return
    same_angles(limits_of(domain_of(slotted(l0, l1, h))), expected, 1e-9)


@sparing("seed", range(60), every=6)
def test_chains_against_a_dense_scan(seed: int) -> None:
    """Chains of up to four dyads: the runs of a scan of 200 000 positions are the intervals."""
    scene = build(np.random.default_rng(seed), prismatic_input=False)
    result = solve_kinematics(scene.mechanism)
    chain = compile_chain(scene.mechanism, result.structure, result.variants)
    x = np.linspace(-math.pi, math.pi, 200_001)
    last = chain.evaluate(x, order=0).motions
    reached = np.all([np.isfinite(np.broadcast_to(m.u, x.shape)) for m in last.values()], axis=0)
    held = inside(result.domain, x)
    off = np.flatnonzero(reached != held)
    limits = np.array(limits_of(result.domain))
    for i in off:
        assert np.min(np.abs(np.exp(1j * x[i]) - np.exp(1j * limits))) < 1e-9
    runs = np.count_nonzero(np.diff(reached[:-1].astype(int), append=int(reached[0]))) // 2
    assert runs in (0, len(result.domain.intervals))


def with_second_slider(l3: float) -> Mechanism:
    """A crank-slider whose slider carries a rod of length l3 to a second guide at right angles, x = 0.35."""
    base = crank_slider(0.1, 0.15, 0.08)
    return replace(
        base,
        links=(*base.links, bar(4, B=0, D=l3), bar(5, D=0)),
        joints=(*base.joints, pin("B4", 3, 4), pin("D", 4, 5, l3), slide("D0", 5, 0, 0.35, math.pi / 2)),
        outputs=(Output(point="D", direction=math.pi / 2),),
    )


def test_limits_of_a_second_group_within_those_of_the_first() -> None:
    """x_B >= 0.35 - l3 cuts the interval that |y_A - 0.08| <= 0.15 leaves."""
    l3 = 0.2
    chain = chain_of(with_second_slider(l3))
    domain = find_domain(chain, SEAM - math.pi, SEAM + math.pi)
    groups = {limit.group for interval in domain.intervals for limit in interval.limits}
    assert groups == {"RRP(4,5)"} or groups == {"RRP(2,3)", "RRP(4,5)"}
    for interval in domain.intervals:
        for limit in interval.limits:
            y = 0.1 * math.sin(limit.x)
            if limit.group == "RRP(2,3)":
                assert abs(abs(0.08 - y) - 0.15) < 1e-12
            else:
                x_b = 0.1 * math.cos(limit.x) + math.sqrt(0.15**2 - (0.08 - y) ** 2)
                assert abs(abs(0.35 - x_b) - l3) < 1e-12
    x = np.linspace(-math.pi, math.pi, 1_000_001)
    y = 0.1 * np.sin(x)
    with np.errstate(invalid="ignore"):
        x_b = 0.1 * np.cos(x) + np.sqrt(0.15**2 - (0.08 - y) ** 2)
    assert np.count_nonzero((np.abs(0.35 - x_b) <= l3) != inside(domain, x)) <= 4


EDGE = SEAM - math.pi  # where the search of the turn begins
PLACES = [0.0, 0.003, 1.234567, EDGE, EDGE + 1e-3, EDGE - 2e-3, math.pi, -2.0, 5e-4 - math.pi]


@pytest.mark.parametrize("nearness", [1e-3, 1e-5, 1e-7, 1e-9])
@pytest.mark.parametrize("place", PLACES)
def test_a_short_gap_is_found_wherever_it_stands(nearness: float, place: float) -> None:
    """l1 + |e| is a little more than l2: the crank cannot pass the angle where it stands across the guide."""
    mechanism = moved(crank_slider(0.1, 0.15, 0.05 * (1 + nearness)), place + math.pi / 2, 0j)
    domain = domain_of(mechanism)
    half = math.acos((0.15 - 0.05 * (1 + nearness)) / 0.1)
    assert not domain.full
    same_angles(limits_of(domain), [place + half, place - half], 1e-3 * half)


@pytest.mark.parametrize("nearness", [1e-3, 1e-5, 1e-7, 1e-9])
@pytest.mark.parametrize("place", PLACES)
def test_a_short_interval_is_found_wherever_it_stands(nearness: float, place: float) -> None:
    """|e| is a little less than l1 + l2: the links reach the line only about one crank angle."""
    mechanism = moved(crank_slider(0.1, 0.15, 0.25 - 0.1 * nearness), place - math.pi / 2, 0j)
    domain = domain_of(mechanism)
    half = math.acos(1 - nearness)
    assert len(domain.intervals) == 1
    same_angles(limits_of(domain), [place + half, place - half], 1e-3 * half)


@sparing("nearness", [-1e-3, -1e-5, -1e-7, -1e-9], every=2)
@sparing("place", PLACES, every=3)
def test_a_crank_that_just_passes_turns_fully(nearness: float, place: float) -> None:
    """The regularity at the narrow place is the cosine of the rod's angle there, exactly, wherever it stands."""
    mechanism = moved(crank_slider(0.1, 0.15, 0.05 * (1 + nearness)), place + math.pi / 2, 0j)
    for start in (0.0, place, place + math.radians(0.5), place + 0.002, place - 0.003):
        result = solve_kinematics(with_input(mechanism, start=start))
        assert result.domain.full
        (quality,) = result.qualities
        sine = (0.1 + 0.05 * (1 + nearness)) / 0.15
        assert quality.regularity == pytest.approx(math.sqrt(1 - sine**2), rel=1e-6)
        assert abs(math.remainder(quality.regularity_at - place, TURN)) < 1e-6
        assert any("nearly singular" in str(grade) for grade in result.grades)


@pytest.mark.parametrize(
    "mechanism",
    [
        four_bar(1, 3, 1, 3),  # parallelogram
        four_bar(1, 3, 1, 3, variant=-1),
        four_bar(1, 2, 2, 1),  # kite: A passes over C
        crank_slider(0.1, 0.15, 0.05),  # l1 + |e| = l2
        crank_slider(0.1, 0.1, 0.0),  # l1 = l2
        slotted(0.1, 0.1),  # l1 = l0
        slotted(0.1, 0.3, 0.2),  # l1 - l0 = h
    ],
)
@sparing("start", [0.0, 0.3, 1.7, math.radians(0.5), math.radians(270.5)], every=5, first=1)
def test_change_points_are_dead_points(mechanism: Mechanism, start: float) -> None:
    for place in (0.0, 0.77):
        with pytest.raises(SingularityError, match="dead point at angle_1 = ") as refused:
            solve_kinematics(with_input(moved(mechanism, place, 0j), start=start))
        assert "group R" in str(refused.value)


@pytest.mark.parametrize("nearness", [1e-3, 1e-6, 1e-9, 1e-12, 1e-13, -1e-12, -1e-13])
def test_nearly_a_change_point_is_never_answered_with_numbers_beyond_it(nearness: float) -> None:
    for place in np.linspace(-3, 3, 7):
        mechanism = moved(crank_slider(0.1, 0.15, 0.05 * (1 + nearness)), float(place), 0j)
        with pytest.raises((AssemblyError, SingularityError)):
            solve_kinematics(mechanism)


def test_the_message_names_group_lengths_and_angles() -> None:
    with pytest.raises(AssemblyError) as refused:
        solve_kinematics(full_turn(four_bar(3, 2, 2.5, 4)))
    text = str(refused.value)
    for part_of_it in ("group RRR(2,3)", "cannot make a full turn", "links 2 and 3 are stretched"):
        assert part_of_it in text
    assert "2000 mm + 2500 mm = 4500 mm" in text
    limit = math.degrees(math.acos((9 + 16 - 4.5**2) / 24))
    assert f"{limit:.6f}"[:8] in text
    assert "input.start and grid.span" in text
    assert refused.value.exit_code == 3
    with pytest.raises(AssemblyError, match=r"folded.*falls to") as refused:
        solve_kinematics(full_turn(four_bar(1.5, 3, 1, 2.5)))
    assert "|l_2 - l_3| = |3000 mm - 1000 mm| = 2000 mm" in str(refused.value)
    with pytest.raises(AssemblyError, match="link 2 stands perpendicular to the guide of link 3"):
        solve_kinematics(full_turn(crank_slider(0.1, 0.15, 0.08)))
    with pytest.raises(AssemblyError, match="as near as the offset of the guide, 150 mm"):
        solve_kinematics(full_turn(slotted(0.1, 0.2, 0.15)))


def test_inside_the_interval_it_works_and_across_a_limit_it_is_refused() -> None:
    mechanism = crank_slider(0.1, 0.15, 0.08)
    limit = math.asin(-0.7)
    result = solve_kinematics(part(mechanism, limit + 1e-3, math.pi - limit - 1e-3, positions=50))
    (interval,) = result.domain.intervals
    assert interval.low == pytest.approx(limit, abs=1e-12)
    assert interval.high == pytest.approx(math.pi - limit, abs=1e-12)
    assert np.all(np.isfinite(result.trace.ddr))
    for low, high in ((limit - 1e-6, 1.0), (1.0, math.pi - limit + 1e-6), (limit - 0.5, limit - 0.1), (-3.0, 3.0)):
        with pytest.raises(AssemblyError, match="does not assemble throughout"):
            solve_kinematics(part(mechanism, low, high))
    with pytest.raises(AssemblyError, match="cannot make a full turn"):
        solve_kinematics(full_turn(mechanism))
    with pytest.raises(AssemblyError, match=r"group RRP\(4,5\)"):  # the limit that is crossed, not the first one
        solve_kinematics(part(with_second_slider(0.2), 1.0, 2.0))
    with pytest.raises(SingularityError):
        solve_kinematics(part(mechanism, limit, 1.0))


def test_the_range_may_be_given_in_another_turn() -> None:
    mechanism = crank_slider(0.1, 0.15, 0.08)
    one = solve_kinematics(part(mechanism, 0.0, 1.0))
    two = solve_kinematics(part(mechanism, -2 * TURN, 1.0 - 2 * TURN))
    np.testing.assert_allclose(two.trace.r, one.trace.r, atol=1e-15)


def test_extra_positions_must_assemble_too() -> None:
    mechanism = part(crank_slider(0.1, 0.15, 0.08), 0.0, 1.0)
    result = solve_kinematics(with_grid(mechanism, extra=(-0.3, 1.5)))
    assert result.phi[0] == pytest.approx(-0.3)
    assert result.phi[-1] == pytest.approx(1.5)
    with pytest.raises(AssemblyError):
        solve_kinematics(with_grid(mechanism, extra=(-1.0,)))


@pytest.mark.parametrize("size", [1e-6, 1.0, 1e3])
def test_a_driven_slider_up_to_its_limit(size: float) -> None:
    """The rod l = 1 reaches the line x = 0.2 while |0.2 - s| < 1; ranges in the length of the scene."""
    mechanism = scaled(driven_rod(1.0, 0.2, 0.7), size)
    (interval,) = solve_kinematics(mechanism).domain.intervals
    np.testing.assert_allclose((interval.low, interval.high), (-0.8 * size, 1.2 * size), rtol=1e-14)
    assert [limit.x for limit in interval.limits] == [interval.low, interval.high]
    beyond = with_grid(mechanism, span=1.2 * size * (1 + 1e-7))
    with pytest.raises(AssemblyError, match="does not assemble throughout"):
        solve_kinematics(beyond)
    backwards = solve_kinematics(with_grid(mechanism, span=-0.7 * size))
    assert backwards.phi[-1] == pytest.approx(-0.7 * size)
    np.testing.assert_allclose(np.abs(backwards.trace.r[1] - backwards.trace.r[0]), size, rtol=1e-12)


def test_guides_that_become_parallel() -> None:
    with pytest.raises(SingularityError, match="dead point at angle_1 = 90 deg"):
        solve_kinematics(part(trammel(0.1, math.pi / 2), 0.1, 2.0))
    assert solve_kinematics(part(trammel(0.1, math.pi / 2), 0.1, 1.5)).domain.full


@pytest.mark.parametrize("far", [0.0, 10.0, 1e4])
def test_the_limits_of_a_driven_slider_do_not_depend_on_where_the_axes_stand(far: float) -> None:
    """The line of the guide is given by the joint alone, far from any named point."""
    near = driven_rod(1.0, 0.2, 0.7)
    joints = tuple(
        replace(joint, points=(joint.points[0], joint.points[1] + 1j * far)) if 0 in joint.links else joint
        for joint in near.joints
    )
    (interval,) = solve_kinematics(replace(near, joints=joints)).domain.intervals
    (expected,) = solve_kinematics(near).domain.intervals
    np.testing.assert_allclose((interval.low, interval.high), (expected.low, expected.high), atol=1e-14 * (1 + far))
