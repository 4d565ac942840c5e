"""Friction at its limits: steep rods, the brink of self-locking, further solutions, sliders that tip, pairs at rest."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from properties import examples
from sparing import sparing

from linkage.forces.checking import check
from linkage.forces.newton_euler import placements
from linkage.forces.worked import CASES, press, press_loading
from linkage.scenes import bar, crank_slider, four_bar, full_turn, part, pin, slide, slotted, with_input, yoke
from tmmcalc import NoSolutionError, solve_kinematics
from tmmcalc.linkage.forces.drive import crank, mesh_force
from tmmcalc.linkage.forces.friction import Rubbing, Solution, one_pair, size_of, solve
from tmmcalc.linkage.forces.iteration import Iteration, textbook_iteration
from tmmcalc.linkage.forces.kinetostatics import compile_statics
from tmmcalc.linkage.forces.results import Forces
from tmmcalc.linkage.forces.solve import solve_forces
from tmmcalc.linkage.forces.wrench import Pivot, Slideway, Wrench
from tmmcalc.linkage.loading import Body, GearDrive, Load, Loading, Pair
from tmmcalc.linkage.loadlaws.constant import Constant
from tmmcalc.linkage.loads.scene import compile_scene
from tmmcalc.linkage.model import Assembly, Grid, Input, Link, Mechanism

EXTREME = {case["id"]: case for case in CASES["dyn-friction-extreme"]["inputs"]["cases"]}
EXAMPLES = examples(25, derandomize=True, database=None)


def steep(tan: float, sense: float = 1.0) -> Mechanism:
    """A massless crank-slider whose rod has this inclination at the middle one of its three positions.

    There the crank stands upright, so the slider has the speed of the crank pin and the rod does not turn.
    """
    l1 = np.sin(np.arctan(abs(tan)))
    middle = -np.pi / 2 if tan > 0 else np.pi / 2
    mechanism = part(crank_slider(l1, 1.0), middle - 0.01, middle + 0.01, 2)
    speed = sense * (1.0 if tan > 0 else -1.0)
    return with_input(mechanism, speed=speed, start=middle - np.sign(speed) * 0.01)


def steep_loading(friction: float, force: float, length: float | None = None) -> Loading:
    load = Load("Q", 3, "force", Constant(force))
    return Loading(loads=(load,), pairs=(Pair("B0", friction, length=length),))


def pushed(tan: float, friction: float, force: float, sense: float = 1.0) -> Forces:
    mechanism = steep(tan, sense)
    return solve_forces(mechanism, steep_loading(friction, force), solve_kinematics(mechanism))


def history(tan: float, friction: float, force: float, **options: Any) -> Iteration:
    mechanism = steep(tan)
    scene = compile_scene(mechanism, steep_loading(friction, force), solve_kinematics(mechanism))
    return textbook_iteration(compile_statics(scene), "RRP(2,3)", 0.01, **options)


class TestSteepRod:
    """dyn-friction-extreme: closed form R = tan Q / (1 + f tan sgn v s)."""

    expected = CASES["dyn-friction-extreme"]["expected"]

    @pytest.mark.parametrize("name", ["a", "c", "d", "e"])
    def test_the_admissible_solution(self, name: str) -> None:
        case = EXTREME[name]
        result = pushed(case["tan_phi2"], case["f"], case["Q"], case["sign_v"])
        # printed with six digits
        assert result.normal[3, 1] == pytest.approx(self.expected[name]["R30"], rel=1e-5 if name in "ad" else 1e-6)
        s = np.sign(case["tan_phi2"] * case["Q"])
        exact = case["tan_phi2"] * case["Q"] / (1 + case["f"] * case["tan_phi2"] * case["sign_v"] * s)
        assert result.normal[3, 1] == pytest.approx(exact, rel=1e-12)
        assert result.friction[3, 1] == pytest.approx(-case["f"] * abs(exact) * case["sign_v"], rel=1e-12)

    def test_self_locking(self) -> None:
        case = EXTREME["b"]
        with pytest.raises(NoSolutionError, match=r"self-locking at position [012]") as raised:
            pushed(case["tan_phi2"], case["f"], case["Q"])
        error = raised.value
        assert error.exit_code == 3
        assert "RRP(2,3)" in error.where
        assert "B0" in error.message
        assert error.limit == pytest.approx(1 / (0.5 * 3), rel=1e-3)  # it moves up to f tan = 1
        assert f"{error.limit:.4g}" in str(error)

    def test_only_the_places_that_lock_are_named(self) -> None:
        """f tan = 1 near 65 degrees of the rod: the outer of these positions are free."""
        mechanism = part(crank_slider(0.95, 1.0), -np.pi / 2 - 1.0, -np.pi / 2 + 1.0, 10)
        with pytest.raises(NoSolutionError) as raised:
            solve_forces(mechanism, steep_loading(0.5, -1000.0), solve_kinematics(mechanism))
        angles = np.arcsin(0.95 * np.cos(np.linspace(-1, 1, 11)))
        locked = [str(i) for i in np.flatnonzero(0.5 * np.tan(angles) >= 1)]
        assert 0 < len(locked) < 11
        assert f"at {', '.join(f'position {i}' for i in locked[:6])}" in raised.value.message

    def test_places_between_the_positions_are_named_by_their_angle(self) -> None:
        """Only the steepest rod locks, and no position stands there."""
        mechanism = part(crank_slider(0.95, 1.0), -np.pi / 2 - 0.5, -np.pi / 2 + 0.5, 1)
        ends, middle = 0.95 * np.cos(0.5), 0.95
        friction = 0.9 / np.tan(np.arcsin(ends))
        assert friction * np.tan(np.arcsin(middle)) > 1
        with pytest.raises(NoSolutionError, match=r"self-locking at \d+(\.\d+)? deg"):
            solve_forces(mechanism, steep_loading(friction, -1000.0), solve_kinematics(mechanism))

    def test_a_further_solution_is_told(self) -> None:
        case = EXTREME["c"]
        result = pushed(case["tan_phi2"], case["f"], case["Q"])
        (grade,) = result.grades
        assert grade.severity == "warning"
        assert grade.where == "group RRP(2,3)"
        assert "further solution at 0, 1, 2" in grade.message
        for name in "ade":
            case = EXTREME[name]
            assert pushed(case["tan_phi2"], case["f"], case["Q"]).grades == ()

    def test_a_further_solution_between_the_positions_is_told(self) -> None:
        """Where f tan(beta) > 1, sin(beta) = 0.95 cos(theta - 0.5): about the steepest rod, beside all positions."""
        mechanism = part(crank_slider(0.95, 1.0), -np.pi / 2 - 0.5, -np.pi / 2 + 0.5, 1)
        steepest = 0.95 / np.sqrt(1 - 0.95**2)
        loading = steep_loading(1.02 / steepest, 1000.0)
        (grade,) = solve_forces(mechanism, loading, solve_kinematics(mechanism)).grades
        (found,) = re.findall(r"a further solution at ([\d.]+) deg to ([\d.]+) deg; the one", grade.message)
        low, high = np.radians([float(angle) for angle in found])
        half = np.arccos(np.sin(np.arctan(steepest / 1.02)) / 0.95)
        assert 0.5 - half < low < 0.5 - half / 2
        assert 0.5 + half / 2 < high < 0.5 + half
        less = steep_loading(0.98 / steepest, 1000.0)
        assert not any(
            "further" in g.message for g in solve_forces(mechanism, less, solve_kinematics(mechanism)).grades
        )

    @pytest.mark.parametrize("gap", [1e-2, 1e-4, 1e-6, -1e-6, -1e-4])
    def test_the_brink(self, gap: float) -> None:
        """Denominator 1 - f tan = gap at the steepest place."""
        friction = (1 - gap) / 3
        if gap < 0:
            with pytest.raises(NoSolutionError) as raised:
                pushed(3.0, friction, -1000.0)
            assert raised.value.limit == pytest.approx(1 / (1 - gap), rel=1e-7)
            return
        result = pushed(3.0, friction, -1000.0)
        exact = -3.0 * 1000.0 / (1 - 3.0 * friction)
        assert abs(result.normal[3, 1] / exact - 1) < result.error < 1e-12 / gap
        assert np.all(np.isfinite(result.reaction))

    @pytest.mark.parametrize("sense", [1.0, -1.0])
    @pytest.mark.parametrize("force", [1000.0, -1000.0])
    @pytest.mark.parametrize("tan", [0.3, -0.8, 1.4, -2.5])
    def test_the_closed_form_on_all_sides(self, tan: float, force: float, sense: float) -> None:
        """Either the closed form holds or the group is locked, whichever way slider, load and rod point."""
        for friction in (0.05, 0.35, 0.9):
            denominator = 1 + friction * tan * sense * np.sign(tan * force)
            if denominator <= 0.005:  # the other positions are less steep
                continue
            result = pushed(tan, friction, force, sense)
            assert result.normal[3, 1] == pytest.approx(tan * force / denominator, rel=1e-11)
            assert (result.grades != ()) == (friction * abs(tan) > 1)


class TestPlainIteration:
    """What the textbook's fixed point does in the same cases."""

    @pytest.mark.parametrize(("name", "gain"), [("a", 0.025), ("d", 0.9)])
    def test_it_converges_with_the_loop_gain(self, name: str, gain: float) -> None:
        case = EXTREME[name]
        found = history(case["tan_phi2"], case["f"], case["Q"], stop=1e-9, most=400)
        steps = np.abs(np.diff(found.friction[:, 0]))
        assert found.stopped
        np.testing.assert_allclose(steps[3] / steps[2], gain, rtol=1e-6)

    def test_near_self_locking_it_creeps(self) -> None:
        case = EXTREME["e"]
        found = history(case["tan_phi2"], case["f"], case["Q"], stop=1e-9, most=30)
        steps = np.abs(np.diff(found.friction[:, 0]))
        np.testing.assert_allclose(steps[10:] / steps[9:-1], 0.95, rtol=1e-6)
        assert not found.stopped
        assert found.passes == 30

    def test_a_component_that_is_next_to_nothing_holds_up_no_reaction(self) -> None:
        """A turn of a reaction by 2 degrees changes it by 3.5 %, whatever it does to its smaller component."""
        mechanism, kinematics = press()
        statics = compile_statics(compile_scene(mechanism, press_loading(0.1), kinematics))
        found = textbook_iteration(statics, "RRP(2,3)", np.pi / 2, stop=1e-3, judged="reactions")
        a = found.unknowns[:, :2] @ [1, 1j]
        seen = np.abs(np.diff(a)) / np.abs(a[1:])
        assert found.stopped
        assert found.shift[-1] <= 1e-3 < found.shift[-2]
        assert np.all(found.shift[1:] >= seen)
        assert np.all(found.shift[1:] <= found.change[1:])

    def test_beyond_a_gain_of_one_it_never_settles(self) -> None:
        """N goes to 3 (1000 - 0.5 |N|), which stretches every distance by half; `solve_forces` has the solution."""
        case = EXTREME["c"]
        found = history(case["tan_phi2"], case["f"], case["Q"], most=40)
        force = found.unknowns[:, found.names.index("B0.N")]
        np.testing.assert_allclose(force[1:], 3 * (1000 - 0.5 * np.abs(force[:-1])), rtol=1e-9)
        assert not found.stopped
        assert np.min(found.change[1:]) > 0.03

    def test_no_friction_is_settled_at_once(self) -> None:
        mechanism, kinematics = press()
        statics = compile_statics(compile_scene(mechanism, press_loading(0.0), kinematics))
        found = textbook_iteration(statics, "RRP(2,3)", 1.0)
        assert (found.passes, found.stopped, found.joints) == (2, True, ())

    def test_an_unknown_group(self) -> None:
        mechanism, kinematics = press()
        statics = compile_statics(compile_scene(mechanism, press_loading(), kinematics))
        with pytest.raises(Exception, match=r"no group 'RRR\(2,3\)'") as raised:
            textbook_iteration(statics, "RRR(2,3)", 1.0)
        assert "RRP(2,3)" in raised.value.remedy

    def test_it_ends_where_the_stage_ends(self) -> None:
        mechanism, kinematics = press()
        result = solve_forces(mechanism, press_loading(), kinematics)
        statics = compile_statics(compile_scene(mechanism, press_loading(), kinematics))
        found = textbook_iteration(statics, "RRP(2,3)", float(result.theta[4]), stop=1e-14, most=100)
        a, b, d = (j for j, pair in enumerate(result.pairs) if pair.friction)
        np.testing.assert_allclose(
            found.friction[-1], [result.friction[a, 4], -result.friction[b, 4], result.friction[d, 4]], rtol=1e-13
        )


def system(rng: np.random.Generator, k: int, n: int, size: float) -> list[Rubbing]:
    """k random pairs, of pins and slides with and without length, with friction of about this loop gain."""

    def wrench() -> Wrench:
        return Wrench(rng.normal(size=n) + 1j * rng.normal(size=n), rng.normal(size=n))

    pairs = []
    for _ in range(k):
        slideway = Slideway(np.zeros(n, complex), np.exp(1j * rng.uniform(-3, 3, n)))
        prismatic = rng.random() < 0.5
        half = float(rng.uniform(0.3, 2)) if prismatic and rng.random() < 0.5 else None
        c = size * rng.uniform(0.1, 1) * rng.choice([-1.0, 1.0], n)
        pairs.append(
            Rubbing(slideway if prismatic else Pivot(slideway.r), c, wrench(), tuple(wrench() for _ in range(k)), half)
        )
    return pairs


def miss(pairs: list[Rubbing], solution: Solution) -> Any:
    """Largest misfit (n,) of the friction law."""
    worst = np.zeros(solution.values.shape[1])
    for j, pair in enumerate(pairs):
        force = pair.base.force + sum(r.force * q for r, q in zip(pair.responses, solution.values, strict=True))
        moment = pair.base.moment + sum(r.moment * q for r, q in zip(pair.responses, solution.values, strict=True))
        law = -pair.c * size_of(pair.seat, Wrench(force, moment), pair.half)
        worst = np.maximum(worst, np.abs(solution.values[j] - law))
    return worst


@given(st.integers(0, 2**32 - 1), st.integers(1, 3), st.sampled_from([0.02, 0.1, 0.3, 1.0]))
@EXAMPLES
def test_the_law_holds_wherever_there_is_a_solution(seed: int, k: int, size: float) -> None:
    rng = np.random.default_rng(seed)
    pairs = system(rng, k, 30, size)
    solution = solve(pairs, (30,))
    free = ~solution.locked
    scale = 1 + np.max(np.abs(solution.values), axis=0)
    assert np.all(miss(pairs, solution)[free] <= 1e-12 * scale[free])
    assert np.all(solution.values[:, solution.locked] == 0)
    assert np.all((solution.limit < 1) == solution.locked)
    if size <= 0.02:
        assert free.all()


@pytest.mark.parametrize("k", [1, 2, 3])
@sparing("seed", range(4), every=4)
def test_the_solution_grows_out_of_no_friction(seed: int, k: int) -> None:
    """From a little friction to the full one in small steps, by the plain fixed point where that converges."""
    rng = np.random.default_rng(seed)
    pairs = system(rng, k, 8, 0.12)
    full = solve(pairs, (8,))
    q = np.zeros((k, 8))
    for part_of in np.linspace(0, 1, 11)[1:]:
        scaled = [pair._replace(c=pair.c * part_of) for pair in pairs]
        for _ in range(150):
            forces = [
                Wrench(
                    pair.base.force + sum(r.force * v for r, v in zip(pair.responses, q, strict=True)),
                    pair.base.moment + sum(r.moment * v for r, v in zip(pair.responses, q, strict=True)),
                )
                for pair in scaled
            ]
            law = [-pair.c * size_of(pair.seat, wrench, pair.half) for pair, wrench in zip(scaled, forces, strict=True)]
            q = 0.5 * q + 0.5 * np.array(law)
    settled = np.max(np.abs(np.array(law) - q), axis=0) < 1e-10
    both = settled & ~full.locked
    assert both.sum() >= 4
    np.testing.assert_allclose(full.values[:, both], q[:, both], rtol=1e-9, atol=1e-9)


@pytest.mark.parametrize("tips", [False, True])
def test_one_pair_in_closed_form(tips: bool) -> None:
    """R = R0 + S q: locked exactly where c S turns the force against itself, or the couple of a slider on its edges."""
    rng = np.random.default_rng(1)
    n = 400
    base, response = rng.normal(size=n), rng.normal(size=n)
    c = rng.uniform(-2, 2, n)
    seat = Slideway(np.zeros(n, complex), np.ones(n, complex))

    def wrench(size: Any) -> Wrench:
        return Wrench(1e-3j * size, 0.7 * size) if tips else Wrench(1j * size, np.zeros(n))

    solution = solve([Rubbing(seat, c, wrench(base), (wrench(response),), 0.7 if tips else None)], (n,))
    denominator = 1 + c * response * np.sign(base)  # of |N| = |N0| - c S sgn(N0) |N|
    np.testing.assert_array_equal(solution.locked, denominator <= 0)
    free = denominator > 0
    np.testing.assert_allclose(solution.values[0, free], -(c * np.abs(base) / denominator)[free], rtol=1e-12)
    np.testing.assert_allclose(solution.limit[~free], (1 / (1 - denominator))[~free], rtol=1e-6)
    other = 1 - c * response * np.sign(base) < 0  # the force turned round is a solution too
    np.testing.assert_array_equal(solution.ambiguous, other & free)


@pytest.mark.parametrize("flat", [False, True], ids=["pin", "guide"])
def test_one_pair_against_the_roots_of_its_equation(flat: bool) -> None:
    """The smallest positive root of m = |b - c m S|; none beyond the part of the friction at which it locks."""
    rng = np.random.default_rng(11)
    base, response = rng.normal(size=(2, 2, 400)) * (np.array([[1.0], [0.0]]) if flat else 1.0)
    c = rng.normal(size=400) * 1.5
    q, limit, further = one_pair(base, response, c)
    for b, s, f, value, reach, more in zip(base.T, response.T, c, q[0], limit, further, strict=True):

        def roots(p: float, b: Any = b, s: Any = s, f: Any = f) -> Any:
            found = np.roots([1 - (p * f) ** 2 * (s @ s), 2 * p * f * (b @ s), -(b @ b)])
            return np.sort(found[(abs(found.imag) < 1e-9) & (found.real > 0)].real)

        if reach == 1:
            assert -value / f == pytest.approx(roots(1.0)[0], rel=1e-9)
            assert len(roots(1.0)) == 1 + more
        else:
            assert value == 0
            assert not roots(reach * (1 + 1e-9)).size
            assert roots(reach * (1 - 1e-9)).size
    assert 50 < np.count_nonzero(limit < 1) < 350
    assert np.count_nonzero(further) > 20


@pytest.mark.slow
def test_strong_friction_against_a_path_of_small_steps() -> None:
    """From no friction on in two thousand steps; the path ends where the determinant vanishes or Newton is lost."""
    rng = np.random.default_rng(12)
    n, steps = 60, 2000
    pairs = system(rng, 2, n, 1.2)
    solution = solve(pairs, (n,))
    q, alive, end = np.zeros((2, n)), np.ones(n, bool), np.ones(n)
    for part_of in np.linspace(0, 1, steps + 1)[1:]:
        tried = q.copy()
        for _ in range(3):
            left, jacobian = equations(pairs, tried, part_of)
            tried = tried - np.linalg.solve(jacobian, left.T[..., None])[..., 0].T
        left, jacobian = equations(pairs, tried, part_of)
        leap = np.max(np.abs(tried - q), axis=0) > 0.01 + 0.3 * np.max(np.abs(q), axis=0)
        good = alive & (np.linalg.det(jacobian) > 0) & ~leap & (np.max(np.abs(left), axis=0) < 1e-6)
        end[alive & ~good] = part_of
        q[:, good], alive = tried[:, good], good
    assert 10 < alive.sum() < n - 10
    calm = np.max(np.abs(solution.values), axis=0) < 10  # on the brink the values leap from step to step
    assert calm.sum() > n - 6
    np.testing.assert_array_equal(solution.locked[calm], ~alive[calm])
    np.testing.assert_allclose(solution.limit[calm], end[calm], atol=2e-3)
    np.testing.assert_allclose(solution.values[:, alive], q[:, alive], rtol=1e-6, atol=1e-6)


def equations(pairs: list[Rubbing], q: Any, part_of: float) -> tuple[Any, Any]:
    """Left sides (k, n) and Jacobians (n, k, k), these by differences of a tiny step."""

    def left(values: Any) -> Any:
        rows = []
        for j, pair in enumerate(pairs):
            force = pair.base.force + sum(r.force * v for r, v in zip(pair.responses, values, strict=True))
            moment = pair.base.moment + sum(r.moment * v for r, v in zip(pair.responses, values, strict=True))
            rows.append(values[j] + part_of * pair.c * size_of(pair.seat, Wrench(force, moment), pair.half))
        return np.array(rows)

    base, columns = left(q), []
    for i in range(len(pairs)):
        moved = q.copy()
        moved[i] += 1e-7
        columns.append((left(moved) - base) / 1e-7)
    return base, np.moveaxis(np.array(columns), (0, 1, 2), (2, 1, 0))


class TestRest:
    """Pairs at rest, for a moment or for good, and coefficients of zero."""

    def test_zero_coefficients_change_nothing(self) -> None:
        mechanism, kinematics = press()
        loading = press_loading()
        nothing = replace(loading, pairs=tuple(replace(pair, friction=0.0) for pair in loading.pairs))
        result, bare = (solve_forces(mechanism, x, kinematics) for x in (nothing, press_loading(0.0)))
        assert result.labels == bare.labels
        assert np.array_equal(result.reaction, bare.reaction)
        assert np.array_equal(result.drive, bare.drive)
        assert not result.friction.any()

    def test_pins_without_radius_do_not_rub(self) -> None:
        mechanism, kinematics = press()
        loading = replace(press_loading(), pairs=(Pair("A", 0.1), Pair("B", 0.1)))
        assert np.array_equal(
            solve_forces(mechanism, loading, kinematics).drive,
            solve_forces(mechanism, press_loading(0.0), kinematics).drive,
        )

    def test_a_pair_that_never_slides(self) -> None:
        """The coupler of a parallelogram does not turn against the frame, nor does the block of a straight yoke."""
        mechanism = full_turn(four_bar(0.1, 0.4, 0.1, 0.4 + 0j), 0.3, 8)
        mechanism = part(mechanism, 0.3, 2.8, 8)
        joints = (*mechanism.joints[:3], mechanism.joints[3])
        loading = Loading(bodies=(Body(2, 3.0, 0.1, 0.2 + 0j),), gravity=-9.81j, pairs=(Pair("O", 0.2, 0.02),))
        # rod 4 on the coupler, its end in a guide that moves with a second parallelogram: both only translate
        links = (*mechanism.links, bar(4, A=0, E=0.2j), bar(5, E=0))
        more = replace(
            mechanism,
            links=links,
            joints=(*joints, pin("E", 2, 4, 0.2 + 0.1j), slide("F", 4, 5, 0, 0.3), slide("G", 5, 0, 0.1j, 1.4)),
        )
        rubbing = replace(loading, pairs=(*(Pair(name, 0.2, 0.02) for name in "OABE"), Pair("F", 0.3), Pair("G", 0.3)))
        kinematics = solve_kinematics(more)
        result = solve_forces(more, rubbing, kinematics)
        check(more, placements(more, kinematics), rubbing, result)
        at = {pair.joint: j for j, pair in enumerate(result.pairs)}
        assert np.max(np.abs(kinematics.trace.dangle[kinematics.trace.link_ids.index(2)])) < 1e-12
        assert not result.friction[at["E"]].any()  # links 2 and 4 keep their angle
        assert result.friction[at["A"]].all()  # the crank turns against the coupler all the time

    def test_rounding_is_no_motion(self) -> None:
        """Two couplers move alike; two sliders between them rest in their guides but for rounding."""
        mechanism = four_bar(0.1, 0.4, 0.1, 0.4 + 0j)
        span = 0.31 + 0.13j
        links = (*mechanism.links, bar(4, A=0, B2=span), bar(5, C2=0, B2=0.1), bar(6, E=0), bar(7, E=0))
        joints = (
            pin("A2", 1, 4, 0.1),
            pin("B2", 4, 5, span, 0.1),
            pin("C2", 0, 5, span),
            slide("F", 6, 2, 0.2 + 0.1j, 0.7),
            pin("E", 6, 7),
            slide("G", 7, 4, 0.1 + 0.2j, 1.9),
        )
        mechanism = replace(mechanism, links=links, joints=(*mechanism.joints, *joints))
        mechanism = part(replace(mechanism, assembly=Assembly(variants={(2, 3): 1, (4, 5): 1})), 0.6, 2.8, 8)
        kinematics = solve_kinematics(mechanism)
        noise = kinematics.trace.ds[[kinematics.trace.joint_names.index(name) for name in "FG"]]
        assert 0 < np.max(np.abs(noise)) < 1e-14
        loading = Loading(
            bodies=tuple(Body(k, 1.0, 0.1, 0.1 + 0j) for k in range(1, 8)),
            gravity=-9.81j,
            pairs=(Pair("F", 0.3, length=0.1), Pair("G", 0.3), Pair("A", 0.2, 0.02)),
        )
        result = solve_forces(mechanism, loading, kinematics)
        check(mechanism, placements(mechanism, kinematics), loading, result)
        at = {pair.joint: j for j, pair in enumerate(result.pairs)}
        assert not result.friction[[at["F"], at["G"]]].any()
        assert result.friction[at["A"]].all()
        # panels are cut at no reversal: only the friction of the pin and resolution count
        assert result.counters["dense"] <= 9 * 16

    @pytest.mark.parametrize("speed", [5.0, -5.0])
    def test_both_sides_of_a_dead_point(self, speed: float) -> None:
        """The two rows are the limits of the reactions before and after the position."""
        mechanism, kinematics = press(speed=speed)
        result = solve_forces(mechanism, press_loading(), kinematics)
        statics = compile_statics(compile_scene(mechanism, press_loading(), kinematics))
        doubled = [i for i, label in enumerate(result.labels) if label.endswith("-")]
        assert len(doubled) == 3
        for i in doubled:
            for row, away in ((i, -1e-8), (i + 1, 1e-8)):
                state = statics.solve(statics.scene.place(result.theta[row : row + 1] + away))
                for j, pair in enumerate(result.pairs):
                    found = state.reactions[pair.joint]
                    np.testing.assert_allclose(found.wrench.force, result.reaction[j, row], rtol=2e-6, atol=1e-4)
                    np.testing.assert_allclose(found.friction, result.friction[j, row], rtol=2e-6, atol=1e-6)

    def test_ends_of_the_cycle_are_taken_from_inside(self) -> None:
        """Position 0 is a dead centre of the slider: its friction is that of just after, at the end of just before."""
        result = solve_forces(press()[0], press_loading(), press()[1])
        assert result.friction[3, 0] > 0  # the slider is about to move inwards
        assert result.friction[3, -1] < 0
        assert result.labels[0] == "0"
        assert result.labels[-1] == "12"


class TestTipping:
    """Sliders of given length bear on two edges when the resultant passes outside."""

    def scene(self, lever: float, length: float | None) -> tuple[Mechanism, Loading]:
        mechanism = full_turn(crank_slider(0.1, 0.35), 0.2, 16)
        load = Load("Q", 3, "force", Constant(-500.0), complex(0, lever))
        return mechanism, Loading(loads=(load,), pairs=(Pair("B0", 0.15, length=length),))

    @sparing("lever", [0.0, 0.01, 0.05, 0.2], every=4, first=2)
    def test_the_law_with_edges(self, lever: float) -> None:
        mechanism, loading = self.scene(lever, 0.08)
        kinematics = solve_kinematics(mechanism)
        result = solve_forces(mechanism, loading, kinematics)
        check(mechanism, placements(mechanism, kinematics), loading, result)
        normal, couple, length = result.normal[3], result.couple[3], 0.08
        ahead, behind = normal / 2 + couple / length, normal / 2 - couple / length
        np.testing.assert_allclose(np.abs(result.friction[3]), 0.15 * (np.abs(ahead) + np.abs(behind)), rtol=1e-10)
        tips = tuple(np.array(result.labels)[np.sign(ahead) * np.sign(behind) < 0].tolist())
        assert result.pairs[3].tips == tips
        assert (tips != ()) == (lever > 0)

    def test_edges_raise_the_friction_and_the_pressure(self) -> None:
        narrow, wide = (
            solve_forces(*s, solve_kinematics(s[0])) for s in (self.scene(0.05, 0.05), self.scene(0.05, 5.0))
        )
        assert wide.pairs[3].tips == ()
        assert np.all(np.abs(narrow.friction[3]) >= np.abs(wide.friction[3]) - 1e-9)
        assert narrow.pairs[3].pressure.value > 2 * wide.pairs[3].pressure.value

    def test_without_a_length_there_are_no_edges(self) -> None:
        mechanism, loading = self.scene(0.2, None)
        result = solve_forces(mechanism, loading, solve_kinematics(mechanism))
        assert result.pairs[3].pressure is None
        assert result.pairs[3].tips == ()
        np.testing.assert_allclose(np.abs(result.friction[3]), 0.15 * np.abs(result.normal[3]), rtol=1e-12)


class TestMainBearing:
    def test_coupling(self) -> None:
        mechanism, kinematics = press()
        loading = press_loading(0.0)
        bare = solve_forces(mechanism, loading, kinematics)
        rubbing = solve_forces(mechanism, replace(loading, pairs=(Pair("O", 0.1, 0.03),)), kinematics)
        np.testing.assert_allclose(rubbing.reaction, bare.reaction, rtol=1e-13)
        np.testing.assert_allclose(rubbing.drive - bare.drive, 0.1 * 0.03 * np.abs(bare.reaction[0]), rtol=1e-10)
        np.testing.assert_allclose(rubbing.friction[0], -0.1 * 0.03 * np.abs(bare.reaction[0]), rtol=1e-10)

    def test_against_the_motion_of_a_crank_that_goes_back(self) -> None:
        mechanism, kinematics = press(speed=-5.0)
        loading = press_loading(0.0)
        bare = solve_forces(mechanism, loading, kinematics)
        rubbing = solve_forces(mechanism, replace(loading, pairs=(Pair("O", 0.1, 0.03),)), kinematics)
        assert np.all(rubbing.drive < bare.drive)
        assert np.all(rubbing.power > bare.power)

    @sparing("speed", [5.0, -5.0], every=2)
    @sparing("internal", [False, True], every=2, first=1)
    def test_gear(self, speed: float, internal: bool) -> None:
        """The mesh force loads the bearing whose friction it must overcome: one equation, against bisection."""
        mechanism, kinematics = press(speed=speed)
        gear = GearDrive(0.09, np.radians(20), 0.7, internal)
        loading = replace(press_loading(), drive=gear)
        bare = solve_forces(mechanism, loading, kinematics)
        c = 0.3 * 0.05 * np.sign(speed)
        rubbing = solve_forces(mechanism, replace(loading, pairs=(*loading.pairs, Pair("O", 0.3, 0.05))), kinematics)
        on_pivot = -(bare.reaction[0] + bare.mesh)

        def left(moment: Any) -> Any:
            away = 1.0 if internal else -1.0
            mesh = (1j * moment + away * np.abs(moment) * np.tan(gear.mesh_angle)) * np.exp(0.7j) / gear.radius
            return moment - bare.drive - c * np.abs(on_pivot + mesh)

        low, high = np.full(len(bare.drive), -1e4), np.full(len(bare.drive), 1e4)
        for _ in range(100):
            middle = (low + high) / 2
            below = left(middle) < 0
            low, high = np.where(below, middle, low), np.where(below, high, middle)
        np.testing.assert_allclose(rubbing.drive, low, rtol=1e-11, atol=1e-11)
        check(
            mechanism,
            placements(mechanism, kinematics),
            replace(loading, pairs=(*loading.pairs, Pair("O", 0.3, 0.05))),
            rubbing,
            values={"Q": press_force},
        )

    def test_a_bearing_as_wide_as_the_gear_locks(self) -> None:
        """The friction circle against the arm r cos alpha of the line of action."""
        mechanism, kinematics = press()
        loading = replace(press_loading(0.0), drive=GearDrive(0.05, 0.3, 0.0), pairs=(Pair("O", 0.9, 0.06),))
        with pytest.raises(NoSolutionError, match="self-locking") as raised:
            solve_forces(mechanism, loading, kinematics)
        assert raised.value.where == "forces, group O"
        assert raised.value.limit == pytest.approx(0.05 * np.cos(0.3) / (0.9 * 0.06), rel=1e-12)

    @pytest.mark.parametrize("internal", [False, True])
    def test_the_moment_of_a_gear_under_any_load(self, internal: bool) -> None:
        """M = M_0 + c |R(M)| on the path that grows out of no friction, up to where that path ends."""
        rng = np.random.default_rng(5)
        n = 2000
        load = Wrench(rng.normal(size=n) + 1j * rng.normal(size=n), rng.normal(size=n))
        c = rng.uniform(-1.5, 1.5, n)
        gear = GearDrive(0.8, 0.4, 1.1, internal)
        full = crank(load, gear, c).solution
        assert 300 < full.locked.sum() < n - 300
        np.testing.assert_array_equal(full.locked, full.limit < 1)
        before = -load.moment
        for t in np.linspace(0, 1, 101)[1:]:
            part_of = t * np.minimum(full.limit, 1.0) * np.where(full.locked, 0.99, 1.0)
            driven = crank(load, gear, part_of * c)
            assert not driven.solution.locked.any()
            left = driven.drive + load.moment - part_of * c * np.abs(load.force + mesh_force(gear, driven.drive))
            assert np.max(np.abs(left) / (1 + np.abs(driven.drive))) < 1e-12
            grown = (driven.drive - before) * np.sign(c)
            assert np.all(grown >= -1e-12 * (1 + np.abs(before)))
            flank = np.where(driven.drive >= 0, 1.0, -1.0)
            force = load.force + mesh_force(gear, driven.drive)
            slope = (np.conj(force) * flank * mesh_force(gear, flank)).real / np.abs(force)
            assert np.all(part_of * c * slope < 1)  # the root that rises, of which each flank has one
            before = driven.drive
        beyond = crank(load, gear, c * np.where(full.locked, full.limit * (1 + 1e-9), 1.0))
        np.testing.assert_array_equal(beyond.solution.locked, full.locked)


def press_force(theta: Any) -> Any:
    d = np.degrees(theta) - 210
    return np.where((d > 0) & (theta > 0), -0.133 * d**2, 0.0)


@sparing("kind", ["driven slider", "slotted", "yoke"], every=3)
def test_rubbing_sliders_of_other_kinds(kind: str) -> None:
    """Friction in the guide of a driven slider and in the slides of RPR and RPP dyads."""
    if kind == "driven slider":
        mechanism = Mechanism(
            Link(0),
            (bar(1, A=0.1j), bar(2, A=0, B=0.5), bar(3, B=0)),
            (slide("D", 0, 1, 0, 0.4), pin("A", 1, 2, 0.1j), pin("B", 2, 3, 0.5), slide("B0", 3, 0, 0.6, np.pi / 2)),
            Input("D", -0.7, 0.4, start=-0.1),
            grid=Grid(positions=8, span=0.3),
        )
        pairs = (Pair("D", 0.2, length=0.05), Pair("A", 0.1, 0.02), Pair("B0", 0.1, length=0.2))
    elif kind == "slotted":
        mechanism = with_input(full_turn(slotted(0.3, 0.12, 0.02), 0.4, 12), speed=-3.0)
        pairs = (Pair("A3", 0.15, length=0.03), Pair("B", 0.2, 0.03), Pair("A", 0.1, 0.01), Pair("O", 0.1, 0.02))
    else:
        mechanism = with_input(full_turn(yoke(0.12, 1.3), 0.4, 12), speed=3.0)
        pairs = (Pair("A3", 0.15, length=0.03), Pair("D0", 0.2, length=0.5), Pair("A", 0.1, 0.01))
    bodies = tuple(Body(link.id, 1.0 + link.id, 0.02, 0.03 + 0.02j) for link in mechanism.links)
    loading = Loading(bodies, -9.81j, (Load("Q", 3, "force", Constant(40.0), 0.05 + 0j, 1j),), pairs=pairs)
    kinematics = solve_kinematics(mechanism)
    check(mechanism, placements(mechanism, kinematics), loading, solve_forces(mechanism, loading, kinematics))
