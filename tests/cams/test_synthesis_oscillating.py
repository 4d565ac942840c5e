"""Rockers: worked case, the exact optimum against a dense search, one size more, what cannot be."""

import json
from dataclasses import replace
from math import radians, sqrt
from pathlib import Path

import numpy as np
import pytest
from sparing import sparing

from cams.turns import task_of, turn
from tmmcalc.cams.follower import Follower
from tmmcalc.cams.laws.catalogue import LAWS
from tmmcalc.cams.pressure.angle import pressure_angle, reached
from tmmcalc.cams.synthesis.bestplace import best
from tmmcalc.cams.synthesis.halfplanes import families, outside
from tmmcalc.cams.synthesis.objectives import Distance
from tmmcalc.cams.synthesis.oscillatingsizes import least_triangle
from tmmcalc.cams.synthesis.results import Synthesis, region_columns
from tmmcalc.cams.synthesis.solve import solve_synthesis
from tmmcalc.cams.task import AngleLimits
from tmmcalc.core.conversion import from_record, to_record
from tmmcalc.core.errors import NoSolutionError, UsageError

CASES = {case["id"]: case for case in json.loads((Path(__file__).parents[1] / "cases" / "cams.json").read_text())}
FORTY = AngleLimits(radians(40), radians(40))
UNEQUAL = turn("shun", "sine", rise=60, high=20, back=80, stroke=radians(20))
L2 = 0.1


def rocker_task(limits=FORTY, program=UNEQUAL, **asked):
    return task_of(program, "oscillating", limits=limits, **asked)


@pytest.mark.parametrize("assembly", [1, -1])
def test_worked_case(assembly):
    case = CASES["cams-s12"]
    expected, limit = case["expected"], radians(36)
    program = turn("linear", rise=45, high=70, back=45, stroke=radians(20))
    task = rocker_task(AngleLimits(limit, limit), program, rocker=0.15, assembly=assembly)
    found = solve_synthesis(task)
    assert found.follower.centres == pytest.approx(expected["exact_l0_mm"] / 1e3, rel=1e-6)
    assert np.degrees(found.follower.start) == pytest.approx(expected["exact_psi0_deg"], rel=1e-6)
    assert found.follower.base == pytest.approx(expected["exact_R0_mm"] / 1e3, rel=1e-6)
    ends = [found.rise.least, found.rise.largest, found.back.least, found.back.largest]
    angles = expected["exact_theta_extremes_deg_rise_min_rise_max_return_min_return_max"]
    if assembly > 0:
        assert np.degrees([end.value for end in ends]) == pytest.approx(angles, abs=1e-4)
    book = next(each for each in found.designs if each.name.startswith("textbook"))
    assert np.degrees(book.start) == pytest.approx(expected["approx_psi0_deg"], rel=1e-6)
    assert book.centres == pytest.approx(expected["approx_l0_mm"] / 1e3, rel=1e-6)
    assert book.base == pytest.approx(expected["approx_R0_mm"] / 1e3, rel=1e-6)
    assert np.degrees(book.excess) == pytest.approx(2.76608, abs=1e-4)


def worst(task, psi0, l0, l2):
    """By how much |theta| is beyond its limit for arrays of sizes (m,), at many angles; a pressure angle by itself."""
    over = np.full(np.shape(psi0), -np.inf)
    for k, limit in ((0, task.limits.rise), (2, task.limits.back)):
        if limit is None:
            continue
        phi = np.linspace(task.program.starts[k], task.program.starts[k + 1], 301)
        y, y1 = task.program.at(phi)[:2]
        psi = psi0[:, None] + y
        lean = l2 * (1 - task.asked.assembly * y1) - l0[:, None] * np.cos(psi)
        theta = np.arctan2(lean, l0[:, None] * np.sin(psi))
        over = np.maximum(over, np.max(np.abs(theta), axis=1) - limit)
    return over


def searched(task, aim, centre, spread):
    """The least aim on grids of psi0 and l0 (l2 = 1) that close in on the best place."""
    psi0, l0 = centre
    for _ in range(9):
        a, b = np.meshgrid(np.linspace(-1, 1, 41) * spread + psi0, np.linspace(-1, 1, 41) * spread + l0)
        a, b = a.ravel(), b.ravel()
        value = np.where((worst(task, a, b, 1.0) <= 1e-9) & (a > 0) & (b > 0), aim(a, b), np.inf)
        k = int(np.argmin(value))
        psi0, l0, spread = a[k], b[k], spread / 3
    return float(value[k])


@sparing("seed", range(6), every=6)
@pytest.mark.parametrize("which", ["rocker", "centres"])
def test_optimum_against_a_search(seed, which):
    random = np.random.default_rng(seed)
    laws = random.choice(list(LAWS), 2)
    angles = {"rise": random.uniform(40, 130), "high": 20, "back": random.uniform(40, 130)}
    program = turn(*laws, **angles, stroke=radians(random.uniform(5, 40)))
    limits = AngleLimits(radians(random.uniform(30, 55)), None if seed % 3 == 0 else radians(random.uniform(30, 55)))
    task = rocker_task(limits, program, assembly=1 if seed % 2 else -1, roller=0.0, **{which: L2})
    task = replace(task, limits=replace(limits, convex=0.0))
    follower = least_triangle(task)  # of the pressure angle alone, whatever room the pivot has

    def aim(psi0, l0):
        base = np.sqrt(1 + l0 * l0 - 2 * l0 * np.cos(psi0))
        return base if which == "rocker" else base / l0

    mine = float(aim(follower.start, follower.centres / follower.rocker))
    at = (follower.start, follower.centres / follower.rocker)
    least = searched(task, aim, at, 0.5)
    assert mine <= least * (1 + 1e-4)  # the search sees 301 angles of a phase
    assert least <= mine * (1 + 1e-2)  # the search, which stays inside, comes near it


@sparing("back", [None, 40, 30], every=3, first=1)
@pytest.mark.parametrize("assembly", [1, -1])
@pytest.mark.parametrize("sense", [1, -1])
def test_limits_are_reached_and_kept(back, assembly, sense):
    limits = AngleLimits(radians(36), None if back is None else radians(back))
    found = solve_synthesis(rocker_task(limits, rocker=L2, assembly=assembly, sense=sense))
    assert found.residual < 1e-12
    assert not found.rise.exceeded
    assert not found.back.exceeded
    assert found.follower.rocker == L2
    assert found.rounded is not None
    assert found.rounded.excess <= 1e-9
    assert found.rounded.centres * 1e3 == pytest.approx(round(found.rounded.centres * 1e3), abs=1e-9)


def test_exchange_ends_on_the_corner():
    task = rocker_task(rocker=L2)
    every = families(task)
    for centre in (0.0, 1.0, 0.5 + 0.2j):
        found = best(every, Distance(centre))
        assert abs(outside(every, found.point)[0]) < 1e-13
        assert len(found.lines.phi) in (1, 2)


@pytest.mark.slow
def test_one_size_more():
    free = solve_synthesis(rocker_task(rocker=L2)).follower
    psi0, l0, base = free.start, free.centres, free.base
    for asked in (
        {"rocker": L2, "start": psi0 + 0.1},
        {"centres": l0, "start": psi0 + 0.1},
        {"base": base, "start": psi0 + 0.1},
        {"rocker": L2, "centres": 1.05 * l0},
        {"rocker": L2, "base": 1.05 * base},
        {"centres": l0, "base": 1.3 * base},
    ):
        found = solve_synthesis(rocker_task(**asked))
        follower = found.follower
        for name, value in asked.items():
            assert getattr(follower, name) == pytest.approx(value, rel=1e-14)
        assert max(found.rise.excess, found.back.excess) == pytest.approx(0, abs=1e-12)


@sparing("names", [("rocker", "centres"), ("rocker", "start"), ("rocker", "base")], every=3)
def test_the_optimum_itself_may_be_given(names):
    free = solve_synthesis(rocker_task(rocker=L2)).follower
    again = solve_synthesis(rocker_task(**{name: getattr(free, name) for name in names})).follower
    for name in ("centres", "rocker", "start"):
        assert getattr(again, name) == pytest.approx(getattr(free, name), rel=1e-7)


def test_base_alone_scales():
    by_rocker = solve_synthesis(rocker_task(rocker=L2)).follower
    by_base = solve_synthesis(rocker_task(base=by_rocker.base)).follower
    assert by_base.rocker == pytest.approx(L2, rel=1e-12)
    by_centres = solve_synthesis(rocker_task(centres=by_rocker.centres)).follower
    assert by_centres.base <= by_rocker.base * (1 + 1e-12)


def test_three_sizes_are_a_triangle():
    for asked in (
        {"rocker": 0.1, "centres": 0.12, "start": 0.5},
        {"rocker": 0.1, "base": 0.06, "start": 0.5},
        {"centres": 0.12, "base": 0.06, "start": 0.45},
        {"rocker": 0.1, "centres": 0.12, "base": 0.06},
    ):
        follower = solve_synthesis(rocker_task(**asked)).follower
        for name, value in asked.items():
            assert getattr(follower, name) == pytest.approx(value, rel=1e-14)
        square = follower.centres**2 + follower.rocker**2
        square -= 2 * follower.centres * follower.rocker * np.cos(follower.start)
        assert follower.base == pytest.approx(sqrt(square), rel=1e-13)


@pytest.mark.parametrize(
    ("asked", "fault"),
    [
        ({}, UsageError),
        ({"rocker": 0.1, "centres": 0.12, "start": 0.5, "base": 0.02}, UsageError),
        ({"rocker": 0.1, "centres": 0.12, "base": 0.3}, UsageError),
        ({"rocker": 0.1, "base": 0.01, "start": 0.5}, UsageError),
        ({"rocker": 0.1, "start": 0.2}, NoSolutionError),
        ({"rocker": 0.1, "centres": 0.09}, NoSolutionError),
        ({"rocker": 0.1, "base": 0.02}, NoSolutionError),
    ],
)
def test_what_cannot_be(asked, fault):
    with pytest.raises(fault):
        solve_synthesis(rocker_task(**asked))


def test_a_swing_beyond_the_limits_says_what_would_do():
    program = turn("sine", rise=120, high=20, back=120, stroke=radians(70))
    with pytest.raises(NoSolutionError, match=r"exclude each other") as fault:
        solve_synthesis(rocker_task(AngleLimits(radians(30), radians(30)), program, rocker=L2))
    assert "pressure_angle of 35.0" in fault.value.remedy
    wider = AngleLimits(radians(35.02), radians(35.02))
    assert solve_synthesis(rocker_task(wider, program, rocker=L2)).residual < 1e-9


def test_region_is_where_the_limits_hold():
    task = rocker_task(rocker=L2)
    found = solve_synthesis(task)
    region = found.region
    corners = region.x + 1j * region.y
    edges = np.roll(corners, -1) - corners
    assert (np.conj(corners) * np.roll(corners, -1)).imag.sum() > 0
    axis = found.follower.centres * np.exp(-1j * found.follower.start)
    assert np.min(np.abs(corners - axis)) < 1e-12
    random = np.random.default_rng(4)
    middle = corners.mean()
    spread = np.max(np.abs(corners - middle))
    low = -1j * np.exp(0.5j * task.program.stroke)
    for point in middle + spread * (random.uniform(-1, 1, 60) + 1j * random.uniform(-1, 1, 60)):
        psi0 = -np.angle(point)
        gap = np.min((np.conj(edges) * (point - corners)).imag / np.abs(edges))
        beyond = (point * np.conj(low)).real > (corners * np.conj(low)).real.max()
        if not 0 < psi0 < np.pi - task.program.stroke or abs(gap) < 1e-3 * spread or beyond:
            continue
        follower = Follower("oscillating", psi0, centres=abs(point), rocker=L2)
        assert (gap > 0) == (max(on.excess for on in reached(task, follower)) <= 0)
    for k in np.flatnonzero(region.side):  # a side belongs to its angle of the cam
        z, at = corners[k] + edges[k] / 2, region.phi[[k]]
        follower = Follower("oscillating", float(-np.angle(z)), centres=abs(z), rocker=L2)
        theta = pressure_angle(follower, at, task.program.at(at))[0]
        assert region.side[k] * theta == pytest.approx(radians(40), abs=1e-9)


def test_room_for_roller_and_shaft():
    found = solve_synthesis(rocker_task(replace(FORTY, shaft=0.07), rocker=L2))
    assert found.governs == "shaft"
    assert found.follower.base == pytest.approx(0.07 / 0.6, rel=1e-12)
    assert not found.rise.exceeded
    assert not found.back.exceeded
    found = solve_synthesis(rocker_task(rocker=L2, roller=0.03))
    assert found.governs == "curvature"
    assert found.roller.convex.value == pytest.approx(0.0325, rel=1e-10)


def test_record_and_columns():
    found = solve_synthesis(rocker_task(rocker=L2, assembly=-1))
    again = from_record(Synthesis, to_record(found))
    for name in ("follower", "sizes", "designs", "rounded", "rise", "back", "roller", "notes", "residual", "governs"):
        assert getattr(again, name) == getattr(found, name)
    assert np.array_equal(again.region.phi, found.region.phi)
    assert list(region_columns(found)) == ["x_O[m]", "y_O[m]", "phi[deg]", "side"]
