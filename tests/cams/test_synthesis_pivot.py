"""Rockers whose cam has to pass the pivot: on the border, the best there against dense searches, what forbids it."""

from dataclasses import replace
from math import pi, radians

import numpy as np
import pytest

from cams.turns import overshooting, task_of, turn
from tmmcalc.cams.follower import Follower
from tmmcalc.cams.pressure.angle import reached
from tmmcalc.cams.profile import solve_profile
from tmmcalc.cams.profile.offsets import Rim
from tmmcalc.cams.synthesis.solve import solve_synthesis
from tmmcalc.cams.task import AngleLimits, Loads
from tmmcalc.core.errors import NoSolutionError

pytestmark = pytest.mark.slow

PROGRAM = turn("sine", stroke=radians(30))
LIMITS = AngleLimits(radians(45), None)
ALONE = replace(LIMITS, convex=0.0)


def rocker_task(limits=LIMITS, program=PROGRAM, pivot=0.0, **asked):
    loads = Loads(10.0, pivot_radius=pivot) if pivot else None
    return task_of(program, "oscillating", limits=limits, loads=loads, **asked)


def over(task, psi0, l0, l2, r2, pivot):
    """By how much [rad or lengths] sizes (m,) miss the pressure angle or the pivot, at many angles, from scratch."""
    missed = np.full(np.shape(psi0), -np.inf)
    top = np.zeros(np.shape(psi0))
    for k, limit in ((0, task.limits.rise), (2, task.limits.back)):
        phi = np.linspace(task.program.starts[k], task.program.starts[k + 1], 301)
        y, y1 = task.program.at(phi)[:2]
        psi = psi0[..., None] + y
        centre = l0[..., None] - l2[..., None] * np.exp(1j * psi)
        top = np.maximum(top, np.max(np.abs(centre), axis=-1))
        if limit is not None:
            lean = l2[..., None] * (1 - task.asked.assembly * y1) - l0[..., None] * np.cos(psi)
            theta = np.arctan2(lean, l0[..., None] * np.sin(psi))
            missed = np.maximum(missed, np.max(np.abs(theta), axis=-1) - limit)
    return np.maximum(missed, (top - r2 - l0 + pivot) / l2)


def searched(task, which, aim, at, r2, pivot):
    """The least aim on grids of psi0 and l0/l2 that close in on the best place; one length is given."""
    (psi0, q), spread = at, 0.6
    for _ in range(13):
        a, b = np.meshgrid(np.linspace(-1, 1, 41) * spread + psi0, np.linspace(-1, 1, 41) * spread + q)
        a, b = a.ravel(), np.maximum(b.ravel(), 1e-3)
        l2 = np.full(a.shape, which["rocker"]) if "rocker" in which else which["centres"] / b
        value = np.where((over(task, a, b * l2, l2, r2, pivot) <= 1e-9) & (a > 0), aim(a, b), np.inf)
        k = int(np.argmin(value))
        psi0, q, spread = a[k], b[k], spread / 2
    return float(value[k])


def base_part(psi0, q):
    return np.sqrt(1 + q * q - 2 * q * np.cos(psi0))


@pytest.mark.parametrize(
    ("given", "roller", "pivot"),
    [
        ({"rocker": 0.1}, 0.002, 0.0),
        ({"rocker": 0.1}, 0.010, 0.010),
        ({"rocker": 0.1}, 0.010, 0.004),
        ({"centres": 0.1}, 0.002, 0.010),
        ({"base": 0.1}, 0.010, 0.006),
        ({"base": 0.1}, 0.002, 0.002),
    ],
)
def test_the_best_place_is_on_the_border(given, roller, pivot):
    task = rocker_task(ALONE, roller=roller, pivot=pivot, **given)
    found = solve_synthesis(task)
    follower = found.follower
    assert found.governs == "room at the pivot"
    assert abs(found.pivot.clearance) < 1e-15
    assert found.rise.excess < 1e-12
    drawn = np.abs(Rim(follower, PROGRAM).at(np.linspace(0, 2 * pi, 7200)).offset(roller)).max()
    assert drawn == pytest.approx(follower.centres - pivot, rel=1e-9)
    assert solve_profile(task, follower).pivot == found.pivot  # the profile is not refused
    given = {"rocker": follower.rocker} if "base" in given else given  # the longest rocker: its least base circle

    def aim(psi0, q):
        return base_part(psi0, q) if "rocker" in given else base_part(psi0, q) / q

    at = (follower.start, follower.centres / follower.rocker)
    least, mine = searched(task, given, aim, at, roller, pivot), float(aim(*at))
    assert mine <= least * (1 + 1e-4)  # the search sees 301 angles of a phase
    assert least <= mine * (1 + 1e-3)  # it stays inside


@pytest.mark.parametrize(
    ("rise", "swing", "limit", "back", "pivot", "assembly"),
    [
        (55, 25, 45, None, 0.01, 1),
        (65, 30, 60, 60, 0.035, 1),
        (80, 35, 50, 50, 0.02, 1),
        (65, 30, 60, 60, 0.045, -1),
        (80, 35, 50, 50, 0.022, -1),
    ],
)
def test_other_motions(rise, swing, limit, back, pivot, assembly):
    program = turn("shun", "cosine", rise=rise, back=80, stroke=radians(swing))
    limits = AngleLimits(radians(limit), None if back is None else radians(back), convex=0.0)
    task = rocker_task(limits, program, pivot=pivot, roller=0.001, rocker=0.1, assembly=assembly)
    found = solve_synthesis(task)
    follower = found.follower
    assert abs(found.pivot.clearance) < 1e-15
    at = (follower.start, follower.centres / follower.rocker)
    least = searched(task, {"rocker": 0.1}, base_part, at, 0.001, pivot)
    assert float(base_part(*at)) == pytest.approx(least, rel=1e-3)


@pytest.mark.parametrize("fixed", ["start", "base"])
def test_one_size_more(fixed):
    """Along the curve of a second size the first place that passes, by a dense scan of the distance of the centres."""
    size = {"start": radians(50), "base": 0.1}[fixed]
    task = rocker_task(rocker=0.1, roller=0.002, **{fixed: size})
    found = solve_synthesis(task)
    assert abs(found.pivot.clearance) < 1e-15
    l0 = np.linspace(0.05, 0.199, 150001) if fixed == "base" else np.linspace(0.05, 0.4, 350001)
    psi0 = np.full(l0.shape, size)
    if fixed == "base":
        psi0 = np.arccos((l0**2 + 0.1**2 - size**2) / (2 * l0 * 0.1))
    top = np.abs(l0 - 0.1 * np.exp(1j * (psi0 + radians(30))))
    passing = top - 0.002 <= l0
    rough = np.flatnonzero(passing)[0]
    bare = Follower("oscillating", float(psi0[rough]), centres=float(l0[rough]), rocker=0.1)
    assert reached(task, bare)[0].excess < 0  # the pressure angle does not bind there
    assert found.follower.centres == pytest.approx(l0[rough], abs=2e-6)


def test_a_found_roller_is_the_largest_that_its_cam_is_left():
    found = solve_synthesis(rocker_task(rocker=0.1))
    r2 = found.follower.roller
    assert r2 == pytest.approx(round(1e3 * r2) / 1e3, rel=1e-15)
    assert abs(found.pivot.clearance) < 1e-15
    larger = solve_synthesis(rocker_task(rocker=0.1, roller=r2 + 1e-3))  # given: its cam is too small for the rules
    assert min(rule.value for rule in larger.roller.rules) < r2 + 1e-3


@pytest.mark.parametrize("limits", [replace(LIMITS, shaft=0.07), replace(LIMITS, allow_concave=False)])
def test_shaft_and_curvature_beside_the_pivot(limits):
    found = solve_synthesis(rocker_task(limits, rocker=0.1, roller=0.002))
    assert abs(found.pivot.clearance) < 1e-15
    assert not found.rise.exceeded
    if limits.shaft:
        assert found.follower.base == pytest.approx(0.072, rel=1e-12)
    else:
        assert found.roller.concave is None
    assert ", where the cam just passes the pivot" in found.sizes[0].how


def test_the_highest_place_of_an_overshooting_law_counts():
    program = overshooting(radians(20))
    task = rocker_task(AngleLimits(radians(50), None), program, rocker=0.1, roller=0.001, pivot=0.03)
    follower = solve_synthesis(task).follower
    psi = follower.start + program.at(np.linspace(0, 2 * pi, 36001))[0]
    top = np.abs(follower.centres - follower.rocker * np.exp(1j * psi)).max()
    assert top - 0.001 == pytest.approx(follower.centres - 0.03, abs=1e-9)


def test_no_place_is_an_error_with_a_roller_that_would_do():
    task = rocker_task(AngleLimits(radians(25), None), rocker=0.1, roller=0.002)
    message = r"sweeps over the rocker's pivot: it reaches 184\.747 mm .* keeps the pressure angle and passes it"
    with pytest.raises(NoSolutionError, match=message) as fault:
        solve_synthesis(task)
    assert fault.value.value > fault.value.limit
    assert "a roller_radius of 16.19 mm" in fault.value.remedy
    wider = replace(task, asked=replace(task.asked, roller=0.01619))
    assert 0 <= solve_synthesis(wider).pivot.clearance < 1e-5
    told = solve_synthesis(replace(task, asked=replace(task.asked, report_faults=True)))
    assert told.pivot.swept
    assert any("sweeps over" in note for note in told.notes)


def test_the_size_that_forbids_it_is_named():
    with pytest.raises(NoSolutionError, match="with the given rocker_length and centre_distance") as fault:
        solve_synthesis(rocker_task(rocker=0.1, centres=0.092, roller=0.002))
    assert fault.value.remedy.startswith("leave centre_distance out")


def test_an_unknown_pivot_is_told():
    found = solve_synthesis(rocker_task(rocker=0.1, roller=0.002))
    assert any("pivot_radius in [cam.loads]" in note for note in found.notes)
    known = solve_synthesis(rocker_task(rocker=0.1, roller=0.002, pivot=0.01))
    assert not any("pivot_radius" in note for note in known.notes)
