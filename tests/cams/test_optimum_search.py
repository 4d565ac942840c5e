"""Margins, step search, continuous optimum: against case s16, brute force, differential evolution."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from sparing import sparing

from cams.optimum_scene import CASES, flat_task, roller_task
from tmmcalc.cams.facts.cam_optimum import document as optimum_document
from tmmcalc.cams.follower import Follower
from tmmcalc.cams.optimum.leastheight import least_height
from tmmcalc.cams.optimum.margins import NUMBERS, judge, margins
from tmmcalc.cams.optimum.options import MOST, with_law
from tmmcalc.cams.optimum.peaks import ended, largest
from tmmcalc.cams.optimum.results import Level, merged
from tmmcalc.cams.optimum.scene import scene_of
from tmmcalc.cams.optimum.slipbounds import may_roll
from tmmcalc.cams.optimum.solve import solve_optimum
from tmmcalc.cams.optimum.wholesteps import search
from tmmcalc.cams.strength.solve import solve_strength
from tmmcalc.cams.tables.checks.cam_search import MOST_OPTIONS
from tmmcalc.cams.task import CamTask, Optimum, Spring
from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.core.progress import listening

ROLLER = Follower("translating", 0.06)
S16 = CASES["cams-s16"]


def test_margins_of_the_case() -> None:
    scene = scene_of(roller_task(), ROLLER, "rise")
    at = 1e-3 * np.array(S16["inputs"]["points"])
    found = judge(scene, at[:, 0], at[:, 1], np.full(len(at), 0.12))
    for k, expected in enumerate(S16["expected"]["points"]):
        values = {
            "D": found.slip[k],
            "rho2": 1e3 / found.curvature[1, k],
            "rho1": -1e3 / found.curvature[0, k],
            "R_max": found.contact[k],
            "r2_star": 1e3 * found.roller[k],
            "r1_strength": 1e3 * found.shaft[0, k],
            "r1_stiffness": 1e3 * found.shaft[1, k],
            "sigma_stem": 1e-6 * found.stem[k],
            "p_guide": 1e-6 * found.pressure[k],
            "sigma_H": 1e-6 * found.stress[k],
        }
        assert values == pytest.approx({key: expected[key] for key in values}, rel=1e-6)
        violated = [n for n, margin in zip(NUMBERS, found.margin[:, k], strict=True) if margin < 0]
        assert violated == expected["violated"]


def test_margins_agree_with_the_strength_stage() -> None:
    """Both take every largest value over the whole turn, by different quadratures; sine leaves an inner maximum."""
    task = with_law(roller_task(spring=Spring("safety", safety=1.5), guide=0.24), "sine")
    follower = replace(ROLLER, start=0.14, roller=0.014, offset=0.004)
    scene = scene_of(task, follower)
    found = judge(scene, np.array([0.14]), np.array([0.014]), np.array([0.24]))
    strength = {each.name: each for each in solve_strength(task, follower).margins}
    names = {2: "no slip", 3: "no undercut", 5: "roller unit", 6: "clearance of the shaft", 9: "contact stress"}
    for number, name in names.items():
        assert found.margin[NUMBERS.index(number), 0] == pytest.approx(strength[name].margin, abs=1e-9)


@pytest.mark.parametrize("place", [0.999, 1.001])
def test_a_largest_value_beside_the_common_edge_of_two_panels(place: float) -> None:
    """The edge, a node of both, is the largest node; the function rises beyond it, or before it."""
    t = ended().points
    values = -((np.stack((t, 1 + t))[None] - place) ** 2)
    assert float(largest(values)[0]) == pytest.approx(0, abs=1e-15)


def test_a_largest_value_between_nodes_that_are_lower_than_those_of_a_dwell() -> None:
    """The crest is 0 between two nodes; the dwell lies between it and the nodes."""
    t = ended().points
    middle = (t[8] + t[9]) / 2
    values = np.stack((-((t - middle) ** 2), np.full_like(t, -((t[8] - middle) ** 2) / 2)))
    for both in (values, values[::-1]):
        assert float(largest(both[None])[0]) == pytest.approx(0, abs=1e-15)


@pytest.mark.parametrize(("friction", "key"), [(0.1, ""), (0.0, "_f0")])
def test_least_step_height_of_the_case(friction: float, key: str) -> None:
    found, _ = search(scene_of(roller_task(friction), ROLLER, "rise"), Optimum())
    assert found is not None
    height = S16["expected"]["H2_min_integer_mm" if not key else "H2_min_integer_f0_mm"]
    points = S16["expected"]["feasible_integer_points_at_H2_min" if not key else "feasible_integer_points_f0"]
    assert round(1e3 * found.height, 9) == height
    assert np.round(1e3 * np.stack((found.start, found.roller), axis=1), 9).tolist() == points


@sparing(("law", "spring"), [("cosine", None), ("shun", Spring("safety", safety=1.4))], every=2, first=1)
def test_no_lower_step_height_by_brute_force(law: str, spring: Spring | None) -> None:
    """Every step point at the least height and at all below it, with steps of 2 mm."""
    scene = scene_of(with_law(roller_task(spring=spring), law), ROLLER)
    found, _ = search(scene, Optimum(step=0.002, height_step=0.002))
    assert found is not None
    top = found.height - scene.stroke
    start, roller = (v.ravel() for v in np.meshgrid(*2 * [0.002 * np.arange(1, round(top / 0.002))], indexing="ij"))
    inside = (roller < start) & (start + roller < top)
    start, roller = start[inside], roller[inside]
    good = np.all(margins(scene, start, roller, np.full(len(start), found.height)) >= -1e-12, axis=0)
    assert {*zip(start[good].tolist(), roller[good].tolist(), strict=True)} == {
        *zip(found.start.tolist(), found.roller.tolist(), strict=True)
    }
    for lower in found.height - 0.002 * np.arange(1, 8):
        assert not np.any(np.all(margins(scene, start, roller, np.full(len(start), lower)) >= -1e-12, axis=0))
    *before, last = found.course
    assert (last.height, last.kept) == (found.height, len(found.start))
    assert last.margin == pytest.approx(np.max(np.min(found.margin, axis=0)))
    assert not any(each.kept for each in before)


def test_levels_of_stretches_make_one_course() -> None:
    """A height that was tried with near points and with those farther out stands once; those above the least do not."""
    near = [Level(0.10, 2, 2, 0, -0.2, 9), Level(0.11, 3, 3, 0, -0.1, 8)]
    far = [Level(0.11, 4, 4, 1, 0.02, 2), Level(0.13, 9, 9, 9, 0.5, 5)]
    assert merged(near + far, 0.11) == (near[0], Level(0.11, 7, 7, 1, 0.02, 2))


@pytest.mark.slow
@sparing("friction", [0.1, 0.0], every=2)
@sparing("phases", ["turn", "rise"], every=2, first=1)
def test_continuous_optimum_against_differential_evolution(friction: float, phases: Any) -> None:
    from scipy.optimize import differential_evolution

    scene = scene_of(roller_task(friction), ROLLER, phases)
    found, _ = search(scene, Optimum())
    assert found is not None
    least = least_height(scene, float(found.start[0]), float(found.roller[0]), found.height)
    assert np.min(least.margin) > -1e-12

    def cost(x: Any) -> Any:
        held = margins(scene, x[0], x[1], x[2])
        return x[2] + 10 * np.maximum(-np.min(held, axis=0), 0.0)

    other = differential_evolution(
        cost, [(0.03, 0.08), (0.004, 0.02), (0.08, 0.13)], vectorized=True, updating="deferred", popsize=24,
        maxiter=160, tol=1e-13, rng=1, polish=False,
    )  # fmt: skip
    assert least.height <= other.fun + 1e-10
    assert least.height == pytest.approx(other.fun, rel=2e-4)


def test_where_two_constraints_bind_the_height_is_stationary() -> None:
    """The slope of H2 is a sum of those of both, with factors that are positive; found in a few steps."""
    scene = scene_of(roller_task(), ROLLER)
    least = least_height(scene, 0.056, 0.007, 0.107)
    binding = np.flatnonzero(np.abs(least.margin) < 1e-13)
    assert [NUMBERS[row] for row in binding] == [8, 9]
    at, near = np.array([[least.start], [least.roller], [least.height]]), 1e-6
    shift = near * np.concatenate((np.eye(3), -np.eye(3)), axis=1)
    held = margins(scene, *(at + shift))[binding]
    slope = (held[:, :3] - held[:, 3:]) / (2 * near)
    factors, rest, *_ = np.linalg.lstsq(slope.T, np.array([0.0, 0.0, 1.0]), rcond=None)
    assert np.all(factors > 0)
    assert rest[0] < 1e-14
    assert least.steps < 12


@pytest.mark.slow
def test_an_active_limit_relaxed_lowers_the_mechanism() -> None:
    result = solve_optimum(roller_task(), ROLLER)
    assert result.least.active == (8, 9)
    assert {each.number for each in result.relaxations} == {8, 9}
    one = next(each for each in result.relaxations if each.key == "guide_pressure" and not each.preferred)
    task = roller_task()
    eased = replace(task, requirements=replace(task.requirements, guide_pressure=5.05e6))
    assert one.height == pytest.approx(solve_optimum(eased, ROLLER).least.height, abs=1e-8)
    assert all(each.gain > 0 for each in result.relaxations)


def test_offset_is_taken() -> None:
    """An offset that lowers the pressure angle of the rise lowers the mechanism when the rise alone counts."""
    heights = [solve_optimum(roller_task(), replace(ROLLER, offset=e), "rise").least.height for e in (0.0, -0.008)]
    assert heights[1] < heights[0] - 1e-3


def test_what_is_taken_out_for_slip_slips_at_every_height() -> None:
    """Bounds over heights of half the least length more, against heights tried one by one."""
    task = roller_task()
    wide = replace(task.requirements, width=0.02, roller_friction=0.02, pin_friction=0.02)
    taken = 0
    for scene in (scene_of(task, ROLLER), scene_of(replace(task, requirements=wide), ROLLER)):
        known = search(scene, Optimum(step=0.002, heights=(0.05, 0.11)))[1]
        rows = slice(0, None, 7)
        start, roller, low = known.start[rows], known.roller[rows], known.least[rows]
        high = np.minimum(known.most[rows], 1.3 * low)
        gone = ~may_roll(scene, start, roller, low, high)
        grown = [judge(scene, start, roller, low + part * (high - low)).slip for part in np.linspace(0, 1, 12)]
        assert np.min(grown, axis=0)[gone] == pytest.approx(np.maximum(np.min(grown, axis=0)[gone], 1.0))
        taken += np.count_nonzero(gone)
    assert taken > 50


@pytest.mark.slow
def test_options_are_compared_each_with_its_spring() -> None:
    task = roller_task(spring=Spring("safety", safety=1.5), laws=("cosine", "const"), safeties=(1.3,))
    base, const, softer = solve_optimum(task, ROLLER).options  # the cam's own law is no option
    assert (base.changes, const.changes, softer.changes) == ((), ("law const",), ("safety 1.3",))
    alone = solve_optimum(with_law(task, "const"), ROLLER)
    assert (const.height, const.stiffness) == (alone.chosen.height, alone.stiffness)
    assert const.least == pytest.approx(alone.least.height, abs=1e-7)
    assert softer.least < base.least < const.least  # by the stiffness of the spring, which is most of the load
    assert softer.stiffness == pytest.approx(base.stiffness)  # the lift at P_M is half the stroke: c = P_M/(h/2)
    assert softer.preload == pytest.approx(0.6 * base.preload)  # (K1 - 1) P_M


@pytest.mark.slow
def test_materials_and_rollers_are_compared() -> None:
    """Each option is what the whole task gives with that requirement."""
    task = roller_task(contacts=(("steel", 6e8), ("", 4e8)), roller_ratios=(("needle", 1.15),), phases="rise")
    options = {each.name: each for each in solve_optimum(task, ROLLER).options}
    assert list(options) == ["as asked", "contact steel (600 MPa)", "roller needle (1.15)"]
    changes: dict[str, dict[str, float]] = {"contact steel (600 MPa)": {"contact": 6e8}}
    changes["roller needle (1.15)"] = {"roller_ratio": 1.15}
    for name, change in changes.items():
        other = replace(roller_task(), requirements=replace(task.requirements, **change))
        least = solve_optimum(other, ROLLER, "rise").least
        assert options[name].least == pytest.approx(least.height, abs=1e-7)
        assert options[name].active == least.active


@pytest.mark.slow
def test_combined_options() -> None:
    asked: dict[str, Any] = {"contacts": (("", 5e8), ("", 6e8)), "roller_ratios": (("needle", 1.15),)}
    told: list[str] = []
    with listening(lambda _, words: told.append(words)):
        options = solve_optimum(roller_task(**asked, combine=True), ROLLER).options
    assert len({each.changes for each in options}) == 6
    assert len(told) == 5
    assert told[-1] == "design game, 5 of 5: contact 600 MPa, roller needle (1.15)"
    both = next(each for each in options if each.name == "contact 600 MPa, roller needle (1.15)")
    assert both.least < min(each.least for each in options if each is not both and "600" not in each.name)
    many = roller_task(**asked, laws=("sine", "shun", "const"), safeties=(1.2, 1.3, 1.4), combine=True)
    with pytest.raises(UsageError, match="96 mechanisms"):  # 3 * 2 * 4 * 4
        solve_optimum(many, ROLLER)


@pytest.mark.slow
def test_an_option_without_solution_says_why() -> None:
    task = roller_task(contacts=(("wood", 1e7),))
    base, wood = solve_optimum(task, ROLLER).options
    assert (base.refused, wood.refused) == ("", "no sizes keep all constraints")
    document = optimum_document(solve_optimum(task, ROLLER), "cam")
    assert any(fact.label == "contact wood (10 MPa)" for fact in document.parts[-1].facts)


def test_no_more_options_than_the_spec_says() -> None:
    assert MOST == MOST_OPTIONS


@pytest.mark.slow
def test_refusals_name_the_constraints() -> None:
    with pytest.raises(NoSolutionError, match=r"5 \(roller on its pin\) and 8 \(pressure in the guide\)"):
        solve_optimum(roller_task(heights=(0.09, 0.1)), ROLLER)
    task = roller_task()
    with pytest.raises(NoSolutionError, match="contact stress: sigma_H"):
        solve_optimum(replace(task, requirements=replace(task.requirements, contact=1e7)), ROLLER)
    with pytest.raises(NoSolutionError, match="leaves the cam"):
        solve_optimum(roller_task(spring=Spring("given", stiffness=100.0)), ROLLER)
    with pytest.raises(UsageError, match="force closure"):
        solve_optimum(replace(task, asked=replace(task.asked, closure="groove")), ROLLER)
    with pytest.raises(UsageError):
        solve_optimum(replace(task, loads=None), ROLLER)


@pytest.mark.parametrize("phases", ["rise", "turn"])
def test_flat_chart_of_the_case(phases: Any) -> None:
    result = solve_optimum(flat_task(), Follower("flat", 0.05), phases)
    expected = CASES["cams-s13b"]["expected"]
    chart, checks = result.flat, {each.number: each for each in result.least.checks}
    assert chart is not None
    assert 1e3 * chart.least_length == pytest.approx(expected["l_min_mm"], rel=1e-6)
    assert 1e3 * chart.least_height == pytest.approx(expected["H2_min_mm"], rel=1e-6)
    assert 1e3 * chart.least_start == pytest.approx(CASES["cams-s13"]["expected"]["S0_min_mm"], rel=1e-6)
    assert result.least.height == pytest.approx(chart.least_height, rel=1e-9)
    assert 1e-6 * (checks[9].value or 0) == pytest.approx(expected["sigma_H_max_MPa"], rel=1e-6)
    moment = (checks[7].value or 0) * np.pi * 4**3 / 4 * 1e-6
    assert moment == pytest.approx(expected["stem_M_max_Nmm"], rel=1e-6)
    assert result.least.active == (3, 8)
    assert result.chosen.height == pytest.approx(0.073)


def test_flat_contact_stress_asks_for_more_height() -> None:
    task: CamTask = flat_task()
    tight = replace(task, requirements=replace(task.requirements, contact=190e6))
    least = solve_optimum(tight, Follower("flat", 0.05)).least
    assert 9 in least.active
    for start in least.start + np.array([-1e-3, -1e-4, 1e-4, 1e-3]):  # no S0 beside it is lower
        from tmmcalc.cams.optimum import flatface

        scene = scene_of(tight, Follower("flat", 0.05))
        found = flatface.lengths(scene)(np.array([start]))
        assert start + scene.stroke + found.least[0] > least.height - 1e-7


@pytest.mark.slow
def test_a_tiny_stroke_and_a_profile_without_concave_parts() -> None:
    task = roller_task(spring=Spring("safety", safety=1.5))
    convex = replace(task, limits=replace(task.limits, allow_concave=False))
    least = solve_optimum(convex, ROLLER).least
    assert 4 in least.active
    assert least.start == pytest.approx(0.09)  # S0^2 - S0 S'' = 0 with S'' = h pi^2/(2 phi^2) = 90 mm at the start
    phases = tuple(replace(p, start=p.start * 5e-5, end=p.end * 5e-5) for p in task.program.phases)
    small = solve_optimum(replace(task, program=replace(task.program, phases=phases)), ROLLER)
    assert small.chosen.start + small.chosen.roller < small.chosen.height < 0.02
    assert small.chosen.worst.margin >= 0


@pytest.mark.slow
def test_no_scipy_in_an_ordinary_run() -> None:
    import subprocess
    import sys

    code = (
        "import sys; from cams.optimum_scene import roller_task; from tmmcalc.cams.follower import Follower; "
        "from tmmcalc.cams.optimum.solve import solve_optimum; "
        "solve_optimum(roller_task(), Follower('translating', 0.06)); assert 'scipy' not in sys.modules"
    )
    subprocess.run([sys.executable, "-c", code], check=True, cwd=Path(__file__).parents[1])
