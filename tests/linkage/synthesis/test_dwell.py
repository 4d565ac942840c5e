"""Six-bars with a dwell against independent truths: geometry, the paper's formulas, differences, swarms."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import cache
from typing import Any

import numpy as np
import pytest

import tmmcalc
from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.core.plane import Plane, cross
from tmmcalc.linkage.kinematics import solve_kinematics
from tmmcalc.linkage.synthesis.dwell.criteria import rated
from tmmcalc.linkage.synthesis.dwell.exact import figures
from tmmcalc.linkage.synthesis.dwell.linkages import (
    Linkages,
    Parameters,
    circumcentre,
    from_lengths,
    from_positions,
    rocking,
    sliding,
)
from tmmcalc.linkage.synthesis.dwell.motion import pose
from tmmcalc.linkage.synthesis.dwell.optimum import Costs, search
from tmmcalc.linkage.synthesis.dwell.parameters import by_rule
from tmmcalc.linkage.synthesis.dwell.relative import accuracy, arc_of, gamma, places, reach
from tmmcalc.linkage.synthesis.dwell.results import Dwell
from tmmcalc.linkage.synthesis.dwell.task import DwellTask, Lengths, Optimum, ThreePositions
from tmmcalc.linkage.synthesis.dwell.turn import TURN, Turn, along, place, whole_turn
from tmmcalc.linkage.synthesis.dwell.unitforces import unit_forces
from tmmcalc.linkage.synthesis.kinds import solve_synthesis
from tmmcalc.linkage.synthesis.results import Synthesis
from tmmcalc.linkage.synthesis.task import SynthesisTask

pytestmark = pytest.mark.slow

DEGREE = math.pi / 180
QUARTER = 90 * DEGREE
GIVEN = ThreePositions(45 * DEGREE, 125 * DEGREE, -43.5 * DEGREE, -91.5 * DEGREE, 0.3, 0.8, -11 * DEGREE)
SLIDER = DwellTask(QUARTER, positions=GIVEN, n=0.5)
ROCKER = DwellTask(QUARTER, "rocker", GIVEN, pivot=0.8824 * np.exp(225j * DEGREE))
ANGLES = np.linspace(0.0, TURN, 37)


def linkage(asked: DwellTask) -> Linkages:
    p = asked.positions
    one = [np.array([v]) for v in (p.phi12, asked.dwell, p.psi0, p.psi12, p.psi13, p.bar, p.side, p.alpha)]
    found = from_positions(Parameters(*one)).linkages
    if asked.pivot is not None:
        return rocking(found, np.asarray(asked.pivot))
    return sliding(found, np.array([asked.n]), asked.dwell, asked.reverse)


@pytest.fixture(scope="module", params=[SLIDER, ROCKER], ids=["slider", "rocker"])
def turn(request: pytest.FixtureRequest) -> Turn:
    return whole_turn(linkage(request.param), 360)


@cache
def solved(asked: DwellTask, **more: Any) -> Synthesis:
    return solve_synthesis(SynthesisTask("dwell", asked, **more))


def dwell_of(result: Synthesis) -> Dwell:
    assert result.best.dwell is not None
    return result.best.dwell


def swarm(dwell: float, count: int) -> tuple[Parameters, np.ndarray]:
    """Random parameters of the usual ranges, and n."""
    rng = np.random.default_rng(7)
    psi13 = rng.uniform(-0.9 * np.pi, -0.1 * np.pi, count)
    given = Parameters(
        rng.uniform(0.4, 0.6, count) * dwell,
        np.full(count, dwell),
        rng.uniform(0.1 * np.pi, 0.9 * np.pi, count),
        rng.uniform(0.4, 0.6, count) * psi13,
        psi13,
        rng.uniform(0.1, 1.5, count),
        rng.uniform(0.1, 1.5, count),
        rng.uniform(0.1 * np.pi, 2 * np.pi - 0.1, count),
    )
    return given, rng.uniform(0.2, 0.8, count)


def test_three_positions_of_many_candidates_close() -> None:
    given, _ = swarm(QUARTER, 200)
    found = from_positions(given)
    lengths = [np.abs(found.a), np.abs(found.c - found.a), np.abs(found.c - 1), np.abs(found.dd - found.linkages.e)]
    for length in lengths:
        size = np.maximum(length.max(axis=0), 1.0)
        assert np.ptp(length, axis=0) / size == pytest.approx(0, abs=1e-9)
    turned = np.angle(found.a[1:] / found.a[0])
    assert turned == pytest.approx(np.array([given.phi12, given.phi13]))
    opening = np.angle((found.dd - found.c) / (found.a - found.c) / np.exp(1j * given.alpha))
    assert opening == pytest.approx(0, abs=1e-9)


def test_about_a_third_of_the_usual_ranges_works() -> None:
    given, n = swarm(QUARTER, 400)
    found = from_positions(given)
    refused = np.any(list(found.faults.values()), axis=0)
    turn = whole_turn(sliding(found.linkages.rows(~refused), n[~refused], QUARTER, False), 120)
    assert 0.2 < len(turn.which) / 400 < 0.4  # the share that the criteria of assembly and turn leave: about 30 %
    assert sum(flags.sum() for flags in found.faults.values()) == refused.sum()
    assert sum(flags.sum() for flags in turn.faults.values()) + len(turn.which) == (~refused).sum()
    one = whole_turn(turn.linkages.rows(np.array([3])), 120)
    assert one.state.s[:, 0] == pytest.approx(turn.state.s[:, 3], abs=1e-13)


def test_the_sign_of_an_assembly_is_checked() -> None:
    """A linkage whose C changes the side of A -> B between the positions is refused before it moves."""
    found = from_positions(swarm(QUARTER, 200)[0])
    wrong = found.faults["positions on different assemblies of O-A-C-B"]
    sides = np.sign(cross(found.c - found.a, 1 - found.a))
    assert wrong.any()
    assert np.array_equal(wrong, np.abs(sides.sum(axis=0)) < 3)


def test_collinear_points_have_no_circle() -> None:
    line = np.array([[0j], [1 + 1j], [3 + 3j]])
    assert not circumcentre(line)[1][0]
    centre, circular = circumcentre(line + np.array([[0], [1e-6j], [0]]))
    assert circular[0]
    assert np.abs(centre - line) == pytest.approx(np.abs(centre - line)[0, 0] * np.ones((3, 1)), rel=1e-5)


def test_lengths_of_the_links_over_the_turn(turn: Turn) -> None:
    found = along(turn, ANGLES)
    at, one = pose(turn.linkages, turn.linkages.phi0 + ANGLES, found.theta, found.s), turn.linkages
    for length, wanted in (
        (at.c - at.b, one.bar),
        (at.d - at.e, one.rod),
        (at.c - at.a, one.coupler),
        (at.a, one.crank),
    ):
        assert np.abs(length) == pytest.approx(np.broadcast_to(wanted, ANGLES.shape), rel=1e-14)
    assert np.abs(at.b - at.e) == pytest.approx(np.broadcast_to(np.abs(one.e - 1), ANGLES.shape), rel=1e-14)


def test_derivatives_by_differences(turn: Turn) -> None:
    h = 1e-4
    low, mid, high = (along(turn, ANGLES + step) for step in (-h, 0.0, h))
    assert mid.ds == pytest.approx((high.s - low.s) / (2 * h), abs=1e-7)
    assert mid.dtheta == pytest.approx(np.sin(high.theta - low.theta) / (2 * h), abs=1e-7)
    assert mid.dds == pytest.approx((high.ds - low.ds) / (2 * h), abs=1e-7)
    assert mid.ddtheta == pytest.approx((high.dtheta - low.dtheta) / (2 * h), abs=1e-7)


def test_the_output_stands_in_three_positions(turn: Turn) -> None:
    for at in turn.linkages.turns:
        assert place(turn, at).s == pytest.approx(0, abs=1e-14)


def test_the_formulas_of_the_paper_give_the_forces(turn: Turn) -> None:
    """By the intersection P of CB and DE, with the two expressions of the bars exchanged as they must be."""
    linkages, found = turn.linkages, along(turn, ANGLES)
    phi = linkages.phi0 + ANGLES
    at = pose(linkages, phi, found.theta, found.s)
    axis = linkages.output / np.abs(linkages.output)
    a, b, c, d, e, f = (np.asarray(p) * np.conj(axis) for p in (at.a, at.b, at.c, at.d, at.e, linkages.output))
    t35, t45 = np.tan(np.angle(c - b)), np.tan(np.angle(d - e))
    x = (e.imag - e.real * t45 - b.imag + b.real * t35) / (t35 - t45)
    p = x + 1j * (b.imag + (x - b.real) * t35)
    forces = unit_forces(linkages, phi, found.theta, found.s)
    if linkages.rocks:
        gamma_ = np.angle(p - a)
        arm = np.abs(a.imag * np.cos(gamma_) + (f.real - a.real) * np.sin(gamma_))
        r21 = 1 / arm
        f35, f45 = np.arctan(t35), np.angle(d - e)
        r45 = r21 * (np.sin(gamma_) - np.cos(gamma_) * t35) / (np.sin(f45) - t35 * np.cos(f45))
        assert np.abs(forces.f4) == pytest.approx(np.abs(r45), rel=1e-9)
        assert np.abs(forces.f3) == pytest.approx(
            np.abs((r21 * np.cos(gamma_) - r45 * np.cos(f45)) / np.cos(f35)), rel=1e-9
        )
    else:
        delta = np.arctan((p - a).imag / (p - a).real)
        f35, f45 = np.angle(c - b), np.angle(d - e)
        r21 = 1 / np.abs(np.cos(delta))
        both = np.cos(delta) * np.sin(f35 - f45)
        assert -forces.f3 == pytest.approx(np.sin(delta - f45) / both, rel=1e-9)
        assert -forces.f4 == pytest.approx(np.sin(f35 - delta) / both, rel=1e-9)
        assert forces.normal == pytest.approx(-np.tan(delta), rel=1e-9)
        assert forces.delta == pytest.approx(delta, abs=1e-9)
        h = (-(e - b).real * -forces.f4 * np.sin(f45) + (e - b).imag * -forces.f4 * np.cos(f45)) / forces.normal
        assert forces.couple == pytest.approx(forces.normal * h, rel=1e-9)
    assert forces.r21 == pytest.approx(r21, rel=1e-9)


def test_virtual_work(turn: Turn) -> None:
    found = along(turn, ANGLES)
    forces = unit_forces(turn.linkages, turn.linkages.phi0 + ANGLES, found.theta, found.s)
    assert forces.moment == pytest.approx(found.ds, abs=1e-14)


@pytest.mark.parametrize("asked", [SLIDER, ROCKER, replace(SLIDER, clockwise=True), replace(ROCKER, reverse=True)])
def test_the_rooms_of_kinematics_and_forces_agree(asked: DwellTask) -> None:
    found = dwell_of(solved(asked)).agreement
    assert max(found.motion, found.forces, found.virtual_work, found.positions) < 1e-13


def test_the_places_of_the_relative_trajectory_are_on_the_motion(turn: Turn) -> None:
    """Gamma is another closed form of the positions: every point of it gives two, exactly."""
    phi, s = places(turn.linkages, arc_of(turn.linkages), 40, True)
    assert len(phi) == 80
    assert along(turn, phi).s == pytest.approx(s, abs=1e-12)


def test_the_relative_trajectory_converges(turn: Turn) -> None:
    few, many = accuracy(turn, 24), accuracy(turn, 48)
    assert many.cosine < few.cosine / 8 < few.uniform / 8  # a cubic spline: an order of four in smooth coordinates
    assert many.uniform < 3e-4


def test_an_arc_over_both_branches_of_gamma() -> None:
    """Where bar BC turns back in the course of the turn, the pin changes to the other branch; the places stay exact."""
    given, n = swarm(QUARTER, 400)
    found = from_positions(given)
    kept = ~np.any(list(found.faults.values()), axis=0)
    every = whole_turn(sliding(found.linkages.rows(kept), n[kept], QUARTER, False), 120)
    turned = []
    for k in range(len(every.which)):
        one = every.linkages.rows(np.array([k]))
        try:
            arc = arc_of(one)
        except NoSolutionError:
            continue
        if arc.course.half:
            phi, s = places(one, arc, 12, False)
            turned.append(np.max(np.abs(along(whole_turn(one, 360), phi).s - s)))
    assert len(turned) > 2
    assert max(turned) < 1e-9


def test_both_branches_of_the_slot_meet_at_its_ends(turn: Turn) -> None:
    ends = np.array(reach(turn.linkages, 125 * DEGREE))
    own, other = (gamma(turn.linkages, ends, branch) for branch in (1.0, -1.0))
    assert own == pytest.approx(other, abs=1e-6)
    inside = gamma(turn.linkages, np.mean(ends, keepdims=True), 1.0)
    assert np.isfinite(inside).all()


def test_extremes_by_brute_force(turn: Turn) -> None:
    asked = ROCKER if turn.linkages.rocks else SLIDER
    found = figures(turn, asked)
    dense = along(turn, np.linspace(0, TURN, 20001))
    assert found.stroke == pytest.approx(np.ptp(dense.s), abs=1e-8)
    assert found.dwell[0] == pytest.approx(np.max(np.abs(dense.s[:5001])), abs=1e-8)
    assert found.largest["ds"][0] == pytest.approx(np.max(np.abs(dense.ds)), abs=1e-7)
    assert found.largest["dds"][0] == pytest.approx(np.max(np.abs(dense.dds)), abs=1e-7)
    phi = np.linspace(0, TURN, 20001)
    forces = unit_forces(turn.linkages, turn.linkages.phi0 + phi, dense.theta, dense.s)
    working = phi >= found.far
    f4 = np.max(forces.f3[working] ** 2) + np.max(forces.f4[working] ** 2)
    idle = (phi >= QUARTER) & ~working
    f5 = np.max(forces.f3[idle] ** 2) + np.max(forces.f4[idle] ** 2)
    assert [float(part[0]) for part in found.criteria[2:]] == pytest.approx(
        [np.max(np.abs(np.tan(forces.delta))), f4, f5], rel=2e-4
    )
    for exact, coarse in zip(found.criteria, rated(turn, asked).criteria, strict=True):
        assert coarse == pytest.approx(exact, rel=2e-3)


@pytest.mark.parametrize("clockwise", [False, True])
def test_a_prescribed_cyclogram(clockwise: bool) -> None:
    asked = DwellTask(QUARTER, positions=GIVEN, working_angle=140 * DEGREE, clockwise=clockwise)
    n = by_rule(asked)
    assert n == pytest.approx(5 / 9 if clockwise else 4 / 9)
    result = solved(asked)
    assert result.best.check("stroke towards the dwell").achieved == pytest.approx(140 * DEGREE, abs=1e-11)
    assert result.best.size("n") == pytest.approx(n, abs=0.02)
    by_rules = solved(replace(asked, exact=False)).best
    assert by_rules.size("n") == n
    assert by_rules.check("stroke towards the dwell").achieved == pytest.approx(140 * DEGREE, abs=1.5 * DEGREE)


def test_swing_and_sides_of_a_rocker() -> None:
    asked = DwellTask(QUARTER, "rocker", GIVEN, swing=37 * DEGREE)
    result = solved(asked)
    ratios = [design.merits["dwell_error[%]"] for design in result.designs]
    assert len(result.designs) == 2
    assert ratios == sorted(ratios)
    assert [design.check("swing").achieved for design in result.designs] == pytest.approx([37 * DEGREE] * 2, abs=1e-11)
    rule = solved(replace(asked, exact=False, pivot_left=False)).best
    assert rule.size("l_OF") == pytest.approx(rule.size("l_OA") / math.sin(18.5 * DEGREE), rel=1e-14)
    assert rule.check("swing").achieved == pytest.approx(37 * DEGREE, rel=0.02)


def test_scale_and_resistance() -> None:
    one, two = solved(SLIDER), solved(replace(SLIDER, stroke=0.2, resistance=500.0))
    small, large = dwell_of(one), dwell_of(two)
    assert large.stroke == pytest.approx(0.2, rel=1e-14)
    factor = 0.2 / small.stroke
    assert large.motion.s == pytest.approx(factor * small.motion.s, abs=1e-14)
    assert large.motion.f4 == pytest.approx(500 * small.motion.f4)
    assert large.motion.moment == pytest.approx(500 * factor * small.motion.moment, abs=1e-12)
    assert large.criteria == pytest.approx(small.criteria)
    pair = [dwell_of(solved(replace(ROCKER, frame=frame, resistance=10.0))) for frame in (1.0, 0.25)]
    assert pair[1].motion.f3 == pytest.approx(4 * pair[0].motion.f3)
    assert pair[1].motion.moment == pytest.approx(pair[0].motion.moment)


def test_clockwise_is_the_same_motion_backwards() -> None:
    there, back = (dwell_of(solved(replace(SLIDER, clockwise=flag), positions=36)).fine for flag in (False, True))
    assert back.s == pytest.approx(there.s[::-1], abs=1e-14)
    assert back.ds == pytest.approx(there.ds[::-1], abs=1e-13)
    negative = dwell_of(solved(SLIDER, crank_speed=-2.0, positions=36)).fine
    assert negative.s == pytest.approx(back.s, abs=1e-14)


def test_k_turns_the_sense_of_s_about() -> None:
    plus, minus = (dwell_of(solved(replace(SLIDER, reverse=flag))) for flag in (False, True))
    assert minus.motion.s == pytest.approx(-plus.motion.s, abs=1e-14)
    assert minus.motion.f3 == pytest.approx(-plus.motion.f3, rel=1e-12)
    assert minus.criteria == pytest.approx(plus.criteria)


def test_lengths_and_positions_give_one_linkage() -> None:
    one = linkage(SLIDER)
    lengths = Lengths(one.crank[0], one.coupler[0], 0.3, 0.8, -11 * DEGREE, one.phi0[0], 45 * DEGREE, left=True)
    two = from_lengths(lengths, QUARTER).linkages
    if abs(two.theta0[0] - one.theta0[0]) > 1e-9:
        two = from_lengths(replace(lengths, left=False), QUARTER).linkages
    assert two.e == pytest.approx(one.e)
    assert two.rod == pytest.approx(one.rod)


def refused_by(reason: str) -> DwellTask:
    """A task whose linkage is refused for this reason."""
    given, n = swarm(QUARTER, 200)
    found = from_positions(given)
    faults = found.faults
    if reason not in faults:
        kept = np.flatnonzero(~np.any(list(faults.values()), axis=0))
        turn = whole_turn(sliding(found.linkages.rows(kept), n[kept], QUARTER, False), 1440)
        faults = {reason: np.isin(np.arange(200), kept[turn.faults[reason]])}
    k = int(np.flatnonzero(faults[reason])[0])
    p = {name: float(part[k]) for name, part in given._asdict().items() if name != "phi13"}
    return DwellTask(QUARTER, positions=ThreePositions(**p), n=float(n[k]))


REASONS = (
    "positions on different assemblies of O-A-C-B",
    "positions on different assemblies of C-D-E",
    "crank does not turn fully",
)


@pytest.mark.parametrize("reason", REASONS)
def test_a_linkage_that_does_not_work_is_refused_with_its_reason(reason: str) -> None:
    with pytest.raises(NoSolutionError, match=f"the linkage does not work: {reason}"):
        solved(refused_by(reason))


def test_a_linkage_that_passes_close_to_a_singular_position() -> None:
    """Coarse steps lose it, finer ones do not, and the rooms of kinematics and forces agree with them."""
    given, n = swarm(QUARTER, 200)
    found = from_positions(given)
    kept = np.flatnonzero(~np.any(list(found.faults.values()), axis=0))
    linkages = sliding(found.linkages.rows(kept), n[kept], QUARTER, False)
    coarse, fine = (set(whole_turn(linkages, steps).which.tolist()) for steps in (60, 1440))
    assert coarse < fine
    k = kept[min(fine - coarse)]
    p = {name: float(part[k]) for name, part in given._asdict().items() if name != "phi13"}
    dwell = dwell_of(solved(DwellTask(QUARTER, positions=ThreePositions(**p), n=float(n[k]))))
    assert max(dwell.agreement.motion, dwell.agreement.forces) < 1e-11


def test_lengths_that_do_not_close() -> None:
    long = Lengths(2.0, 0.985, 0.3, 0.8, 0.2, 0.0, 45 * DEGREE, left=True)
    with pytest.raises(NoSolutionError, match="the linkage does not work"):
        solved(DwellTask(QUARTER, lengths=long))


def test_missing_parameters() -> None:
    with pytest.raises(UsageError, match="nothing gives psi0, alpha"):
        solved(replace(SLIDER, positions=replace(GIVEN, psi0=None, alpha=None)))


def test_the_ready_spec_moves_as_the_synthesis_says() -> None:
    from tmmcalc.linkage.tables.tasks.mechanism import to_linkage

    for asked in (replace(SLIDER, stroke=0.2), ROCKER):
        result = solved(asked, crank_speed=3.0)
        spec = tmmcalc.parse_spec(result.best.spec)
        found = solve_kinematics(to_linkage(spec.linkage))
        motion = dwell_of(result).motion
        assert found.speed == 3.0
        assert found.s[0] == pytest.approx(motion.s, abs=1e-14)
        forces = tmmcalc.solve_forces(spec)
        names = [pair.joint for pair in forces.pairs]
        for name, wanted in (("C", motion.f3), ("D", motion.f4), ("A", motion.r21)):
            size: Plane = np.abs(forces.reaction[names.index(name)][: len(wanted)])
            assert size == pytest.approx(np.abs(wanted), rel=1e-11)


SHORT = Optimum(population=20, generations=2, polish=6)
SOUGHT = DwellTask(QUARTER, positions=ThreePositions(bar=0.3, side=0.8), optimum=SHORT)


def test_the_search_is_repeatable_and_keeps_count() -> None:
    one, two = (search(SOUGHT, SHORT, 3, 2) for _ in range(2))
    assert np.array_equal(one.rows, two.rows)
    assert one.refused == two.refused
    assert one.tried == one.worked + sum(one.refused.values())
    assert one.rows[:, 4:6] == pytest.approx(np.broadcast_to([0.3, 0.8], (len(one.rows), 2)))


def test_the_search_beats_chance() -> None:
    """Against as many random linkages of the same ranges as it has tried."""
    found = search(SOUGHT, SHORT, 3, 1)
    costs = Costs(SOUGHT, SHORT)
    low, high = costs.bounds.T
    rng = np.random.default_rng(11)
    chance = costs(rng.uniform(low, high, (found.tried, len(low))).T)
    assert found.costs[0] < np.min(chance)


def test_an_optimum_is_analysed() -> None:
    asked = replace(SOUGHT, stroke=0.2, optimum=replace(SHORT, weights=(100.0, 0.0, 1.0, 0.0, 0.0)))
    result = solve_synthesis(SynthesisTask("dwell", asked, solutions=2, seed=5))
    dwell = dwell_of(result)
    assert dwell.cost == pytest.approx(100 * dwell.criteria[0] + dwell.criteria[2])
    assert dwell.cost == min(design.merits["cost"] for design in result.designs)
    assert result.counters["linkages tried"] >= result.counters["worked"]
    assert dwell.stroke == pytest.approx(0.2)


def test_a_search_in_vain() -> None:
    asked = replace(refused_by(REASONS[0]), n=None, optimum=SHORT)
    with pytest.raises(NoSolutionError, match=f"0 of 600 random linkages work; most often: {REASONS[0]}"):
        search(asked, SHORT, 1, 1)
