"""The smallest cam with a rocker: constraints coded anew, grids over all sizes, a global optimiser, refusals."""

from __future__ import annotations

import json
from dataclasses import replace
from itertools import pairwise
from math import radians
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.interpolate import CubicSpline
from scipy.optimize import differential_evolution
from sparing import sparing

from tmmcalc.cams.follower import Follower
from tmmcalc.cams.optimum.results import CamOptimum
from tmmcalc.cams.optimum.rockershapes import bounds, thinned
from tmmcalc.cams.optimum.rockersizes import NUMBERS, Sizes, judge_rocker, rocker_scene
from tmmcalc.cams.optimum.solve import solve_optimum
from tmmcalc.cams.tables.tasks.cam import to_cam
from tmmcalc.cams.task import CamTask, Optimum, Spring
from tmmcalc.core.errors import NoSolutionError
from tmmcalc.project import load_spec

CASES = Path(__file__).parents[1] / "cases" / "cams.json"
SPEC = Path(__file__).parents[2] / "configs" / "cam-rocker-optimum.toml"
ROCKER = Follower("oscillating", 0.5, centres=0.1, rocker=0.1)
FINE = 721


def task_of(*overrides: str, **asked: Any) -> CamTask:
    """The ready spec without its options."""
    made = to_cam(load_spec(SPEC, overrides))
    return replace(made, optimum=Optimum(**asked))


def independent(task: CamTask, l2: float, base: float, r2: float, l0: float) -> dict[int, float]:
    """Margins by other means: the roller centre in the frame of the cam as points, all derivatives by splines.

    The force is from the balance of moments about the pivot, the pressure angle from tangent and rocker.
    """
    loads, need, limits = task.loads, task.requirements, task.limits
    assert loads is not None
    cosine = (l0**2 + l2**2 - base**2) / (2 * l0 * l2)
    if abs(cosine) >= 1:
        return dict.fromkeys(NUMBERS, -1.0)
    psi0, peak = np.arccos(cosine), 0.0
    least: dict[str, float] = {}
    scene = rocker_scene(task, ROCKER).scene
    edges = np.unique(task.program.edges)
    for low, high in pairwise(edges):
        phi = np.linspace(low, high, FINE)
        middle = task.program.piece(np.full(FINE, (low + high) / 2))
        y = task.program.at(phi, middle)[0]
        lift = CubicSpline(phi, y)
        slope, bend = (task.program.at(phi, middle)[k] for k in (1, 2))
        assert lift(phi, 1)[5:-5] == pytest.approx(slope[5:-5], abs=1e-6)
        psi = psi0 + y
        z = l0 * np.exp(1j * phi) - l2 * np.exp(1j * (phi - psi))
        x, w = CubicSpline(phi, z.real), CubicSpline(phi, z.imag)
        tangent = x(phi, 1) + 1j * w(phi, 1)
        second = x(phi, 2) + 1j * w(phi, 2)
        speed = np.abs(tangent)
        kappa = (np.conj(tangent) * second).imag / speed**3
        push = 1j * np.exp(1j * (phi - psi))
        useful = np.abs((tangent / speed / 1j * np.conj(push)).real)
        moving = float(np.ptp(y) > 0) * (1.0 if y[-1] > y[0] else -1.0)
        given = loads.force.rise if low < task.program.starts[2] - 1e-9 else loads.force.back
        spring = scene.spring.preload + scene.spring.stiffness * y
        moment = spring + loads.mass * loads.speed**2 * bend - given
        force = moment / (l2 * useful - moving * loads.pivot_friction * loads.pivot_radius)
        torque = moment * slope
        gap = r2 * (1 - kappa * r2)
        reduced = np.sqrt((force * (need.span or 0.0) / 4) ** 2 + need.torsion * torque**2)
        for name, value in (
            ("kappa", kappa),
            ("hollow", -kappa),
            ("force", force),
            ("reduced", reduced),
            ("contact", np.where(gap > 0, force / np.where(gap > 0, gap, 1.0), np.inf)),
        ):
            least[name] = max(least.get(name, -np.inf), float(value.max()))
        if moving:
            limit = limits.rise if moving > 0 else limits.back
            assert limit is not None
            least["theta"] = max(least.get("theta", 0.0), float(np.arccos(useful).max()) / limit)
        peak = max(peak, float(np.abs(z).max()))
        run = (np.conj(tangent) * second).real / speed / force
        least["run"], least["slow"] = max(least.get("run", 0), run.max()), max(least.get("slow", 0), -run.min())
    pin = np.sqrt(least["force"] / (4 * need.pin_ratio * (need.pin_pressure or 1.0)))
    inertia = np.pi / 2 * (need.width or 0.0) * need.roller_density * (r2**4 - pin**4)
    friction = need.roller_friction or 1.0
    resisting = ((need.rolling_arm or 0.0) + (need.pin_friction or 0.0) * pin) / (friction * r2)
    grown = inertia * loads.speed**2 / (friction * r2**2)
    strong = np.cbrt(4 * least["reduced"] / (np.pi * (need.bending or 1.0)))
    stiff = (least["force"] * (need.span or 0) ** 3 / (12 * np.pi * need.young * (need.deflection or 1.0))) ** 0.25
    shaft = max(np.ceil(1e3 * max(strong, stiff) - 1e-9) / 1e3, limits.shaft)
    stress = 0.418 * np.sqrt(need.modulus / (need.width or 1.0) * least["contact"])
    return {
        2: 1 - max(resisting + grown * least["run"], grown * least["slow"] - resisting),
        3: 1 - (r2 + limits.convex) * least["kappa"],
        4: 1 + (limits.concave - r2) * min(-least["hollow"], 0.0),
        5: 1 - need.roller_ratio * pin / r2,
        6: 1 - (r2 + shaft) / base,
        9: 1 - stress / (need.contact or 1.0),
        10: 1 - least["theta"],
        11: 1 - (peak - r2) / (l0 - loads.pivot_radius),
    }


SIZES = [(0.038, 0.042, 0.018, 0.044), (0.06, 0.05, 0.02, 0.07), (0.1, 0.08, 0.03, 0.105)]


@pytest.mark.parametrize("sizes", SIZES)
def test_margins_are_those_of_formulas_coded_anew(sizes: tuple[float, float, float, float]) -> None:
    task = task_of()
    own = judge_rocker(rocker_scene(task, ROCKER), Sizes(*(np.array([size]) for size in sizes))).margin[:, 0]
    other = independent(task, *sizes)
    for number, margin in zip(NUMBERS, own.tolist(), strict=True):
        assert margin == pytest.approx(other[number], abs=2e-5), number


@pytest.fixture(scope="module")
def found() -> CamOptimum:
    return solve_optimum(task_of(), ROCKER)


def test_the_worked_case(found: CamOptimum) -> None:
    """Case s21, whose numbers were found apart from the program."""
    case = next(each for each in json.loads(CASES.read_text()) if each["id"] == "cams-s21")
    expected, near = case["expected"], case["tolerance"]
    assert (found.stiffness, found.preload) == pytest.approx((expected["c_N_m_per_rad"], expected["M0_N_m"]))
    sizes = Sizes(*(np.array([1e-3 * case["inputs"]["point_mm"][name]]) for name in ("l2", "R0", "r2", "l0")))
    margin = judge_rocker(rocker_scene(task_of(), ROCKER), sizes).margin[:, 0]
    assert dict(zip(map(str, NUMBERS), margin.tolist(), strict=True)) == pytest.approx(
        expected["margins"], abs=near["margins_abs"]
    )
    least, own = expected["least_mm"], found.least
    assert 1e3 * own.height == pytest.approx(least["l0"], rel=near["least_rel"])
    other = [least[name] for name in ("l2", "R0", "r2")]
    assert [1e3 * own.length, 1e3 * own.start, 1e3 * own.roller] == pytest.approx(other, rel=near["least_sizes_rel"])
    assert own.active == tuple(expected["active"])
    whole = expected["whole_mm"]
    assert (1e3 * found.chosen.height, len(found.start)) == pytest.approx((whole["l0"], whole["points"]))
    assert found.length is not None
    points = 1e3 * np.stack((found.length, found.start, found.roller), axis=1)[:3]
    assert points == pytest.approx(np.array(whole["best"]))
    assert 100 * found.margin[:3] == pytest.approx(np.array(whole["margins_percent"]), abs=1e-4)


def test_a_grid_of_all_sizes_has_nothing_smaller(found: CamOptimum) -> None:
    """Every l2, R0, r2 in whole mm at the least l0 and below it, by the margins alone."""
    task = task_of()
    of = rocker_scene(task, ROCKER)
    for centres, good in ((found.chosen.height - 1e-3, 0), (found.chosen.height, len(found.start))):
        l2, base = (1e-3 * values.ravel() for values in np.mgrid[10:65, 10:75])
        r2 = 1e-3 * np.arange(1, 46)
        one = np.full(len(l2), centres)
        close = bounds(thinned(of), Sizes(l2, base, one, one))  # its interval is an outer bound, judged below
        count = 0
        for radius in r2.tolist():
            rows = np.flatnonzero((close.least <= radius + 1e-9) & (close.most >= radius - 1e-9))
            if rows.size:
                sizes = Sizes(l2[rows], base[rows], np.full(rows.size, radius), one[rows])
                count += int(np.count_nonzero(np.all(judge_rocker(of, sizes).margin >= -1e-12, axis=0)))
        assert count == good
    margin = judge_rocker(of, Sizes(*(np.array([s]) for s in (0.038, 0.042, 0.018, 0.044)))).margin
    assert found.margin[0] == pytest.approx(margin.min())


def test_the_interval_of_r2_is_that_of_the_margins() -> None:
    """Just inside both ends all constraints but slip are kept, just outside one is broken."""
    of = rocker_scene(task_of(), ROCKER)
    l2, base = (1e-3 * values.ravel() for values in np.mgrid[34:42, 36:48])
    one = np.ones(len(l2))
    free = bounds(of, Sizes(l2, base, one, 0.045 * one))
    rows = np.flatnonzero(free.most > free.least + 1e-4)
    assert rows.size > 5
    for radius, kept in (
        (free.least + 1e-6, True),
        (free.most - 1e-6, True),
        (free.least - 1e-6, False),
        (free.most + 1e-6, False),
    ):
        margin = judge_rocker(of, Sizes(l2[rows], base[rows], radius[rows], 0.045 * one[rows])).margin[1:]
        # nodes miss the very crest by some 1e-6
        assert np.all((margin.min(axis=0) > -2e-5) == kept) or np.all(margin.min(axis=0) < 2e-5)


@pytest.mark.slow
def test_a_global_optimiser_finds_nothing_smaller(found: CamOptimum) -> None:
    of = rocker_scene(task_of(), ROCKER)

    def height(x: np.ndarray) -> np.ndarray:
        ratio, angle, part, centres = x
        base = centres * np.sqrt(1 + ratio**2 - 2 * ratio * np.cos(angle))
        margin = judge_rocker(of, Sizes(ratio * centres, base, part * base, centres)).margin
        return np.asarray(1e3 * centres + 1e3 * np.maximum(-np.maximum(margin.min(axis=0), -1), 0))

    ends = [(0.3, 1.3), (0.3, 1.5), (0.1, 0.7), (0.02, 0.2)]
    best = differential_evolution(
        height, ends, seed=3, vectorized=True, updating="deferred", maxiter=250, popsize=24, tol=1e-12, polish=False
    )
    assert 1e3 * found.least.height == pytest.approx(best.fun, rel=2e-4)
    assert 1e3 * found.least.height <= best.fun * (1 + 1e-7)


def test_the_least_meets_its_constraints_and_scales(found: CamOptimum) -> None:
    """At the least of any sizes the active margins are 0; all grown alike every constraint but slip is kept."""
    least = found.least
    assert found.kind == "oscillating"
    assert least.active == (9, 11)
    sizes = np.array([least.length, least.start, least.roller, least.height])
    other = independent(task_of(), *sizes)
    assert [number for number, margin in other.items() if abs(margin) < 2e-5] == [9, 11]
    of = rocker_scene(task_of(), ROCKER)
    before = judge_rocker(of, Sizes(*sizes[:, None])).margin[:, 0]
    for scale in (1.1, 1.7, 4.0):
        after = judge_rocker(of, Sizes(*(scale * sizes[:, None]))).margin[:, 0]
        assert np.all(after[1:] >= np.minimum(before[1:], 1) - 1e-9)
    assert found.error["height"] < 1e-10
    (region,) = found.contours[0].outlines
    assert {number for corner in region.corners for number in corner.numbers} == {9, 11}
    for corner in region.corners:
        margin = independent(task_of(), found.chosen.length, corner.start, corner.roller, found.chosen.height)
        assert [margin[number] for number in corner.numbers] == pytest.approx([0, 0], abs=2e-5)


@pytest.mark.slow
def test_looser_limits_buy_what_solving_again_gives(found: CamOptimum) -> None:
    for each in found.relaxations:
        if not each.preferred:
            key = (
                f"cam.requirements.contact={each.after}" if each.number == 9 else f"cam.loads.pivot_radius={each.after}"
            )
            again = solve_optimum(task_of(key), ROCKER)
            if each.number == 9:
                assert again.least.height == pytest.approx(each.height, rel=1e-9)
            assert each.gain > 0


@sparing(
    ("asked", "wanted"),
    [
        ({"rocker_lengths": (0.08, 0.08)}, "length"),
        ({"rocker_lengths": (0.045, 0.06)}, "length"),
        ({"centre_distances": (0.06, 0.09)}, "height"),
    ],
    every=3,
    first=1,
)
def test_ranges_hold_the_sizes(asked: dict[str, tuple[float, float]], wanted: str) -> None:
    found = solve_optimum(task_of(**asked), ROCKER)
    ((low, high),) = asked.values()
    for choice in (found.chosen, found.least):
        assert low - 1e-9 <= getattr(choice, wanted) <= high + 1e-9
        assert choice.least_margin >= -1e-7
    assert any("end of its range" in note for note in found.notes)
    assert found.least.height <= found.chosen.height + 1e-9


@pytest.mark.slow
def test_refusals_say_why() -> None:
    with pytest.raises(NoSolutionError, match="ranges of"):
        solve_optimum(task_of(centre_distances=(0.01, 0.03)), ROCKER)
    task = task_of()
    steep = replace(task, limits=replace(task.limits, rise=radians(2), back=radians(2)))
    with pytest.raises(NoSolutionError, match="pressure angle of 2 deg"):
        solve_optimum(steep, ROCKER)
    loads = task.loads
    assert loads is not None
    loose = replace(loads, spring=Spring("given", stiffness=1.0), force=replace(loads.force, rise=0.0, back=0.0))
    with pytest.raises(NoSolutionError, match="moments about the pivot"):
        solve_optimum(replace(task, loads=loose), ROCKER)
    worn = replace(task.requirements, rolling_arm=1.0)
    with pytest.raises(NoSolutionError, match=r"2 \(roller without slip\)"):
        solve_optimum(replace(task, requirements=worn), ROCKER)


@pytest.mark.slow
def test_a_finer_step_comes_nearer_to_the_least(found: CamOptimum) -> None:
    heights = [solve_optimum(task_of(step=step), ROCKER).chosen.height for step in (2e-3, 5e-4)]
    assert found.least.height <= heights[1] <= found.chosen.height <= heights[0]
    assert heights[1] - found.least.height < 1e-3


@sparing("law", ["cosine", "const", "modified_trapezoid"], every=3, first=1)
def test_other_laws_and_the_other_sense(law: str) -> None:
    """Laws with jumps, and a rocker that turns against the cam: every constraint is kept by the formulas coded anew."""
    task = task_of(f'cam.law="{law}"', 'cam.rocker_turn="against"')
    found = solve_optimum(task, replace(ROCKER, assembly=-1))
    own = found.least
    margin = judge_rocker(
        rocker_scene(task, replace(ROCKER, assembly=-1)),
        Sizes(*(np.array([s]) for s in (own.length, own.start, own.roller, own.height))),
    ).margin
    assert margin.min() > -1e-7
    assert len(own.active) >= 1
