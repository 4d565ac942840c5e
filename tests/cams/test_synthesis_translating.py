"""Translating followers: worked cases, the exact optimum against a linear programme, what is given is kept."""

import json
from dataclasses import replace
from math import hypot, radians, tan
from pathlib import Path

import numpy as np
import pytest
from sparing import sparing

from cams.turns import task_of, turn
from tmmcalc.cams.follower import Follower, contact_path, curvature
from tmmcalc.cams.laws.catalogue import LAWS
from tmmcalc.cams.pressure.angle import reached
from tmmcalc.cams.profile import solve_profile
from tmmcalc.cams.synthesis.results import Synthesis, region_columns
from tmmcalc.cams.synthesis.solve import solve_synthesis
from tmmcalc.cams.synthesis.translatingsizes import least_start, lines_of, lowest, nearest
from tmmcalc.cams.task import AngleLimits
from tmmcalc.core.conversion import from_record, to_record
from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.core.numerics.panels import Panels

CASES = {case["id"]: case for case in json.loads((Path(__file__).parents[1] / "cases" / "cams.json").read_text())}
BOTH = AngleLimits(radians(30), radians(30))
UNEQUAL = turn("shun", "sine", rise=60, high=20, back=100, stroke=0.025)


def case_task(name):
    case = CASES[name]
    given, expected = case["inputs"], case["expected"]
    angles = {"rise": given["phi_rise_deg"], "high": given["phi_high_dwell_deg"], "back": given["phi_return_deg"]}
    program = turn(given["law_rise"], given["law_return"], stroke=given["h_mm"] / 1e3, **angles)
    limit = radians(given["theta_allow_deg"])
    return task_of(program, limits=AngleLimits(limit, limit), offset=None), expected


@pytest.mark.parametrize("name", ["cams-s11a", "cams-s11b"])
def test_worked_cases(name):
    task, expected = case_task(name)
    found = solve_synthesis(task)
    near = {"rel": 1e-5, "abs": 1e-7}
    assert found.follower.start == pytest.approx(expected["exact_S0_mm"] / 1e3, **near)
    assert found.follower.offset == pytest.approx(expected["exact_e_mm"] / 1e3, **near)
    assert found.follower.base == pytest.approx(expected["exact_R0_mm"] / 1e3, **near)
    book = next(each for each in found.designs if each.name == "textbook (5.44)")
    assert book.start == pytest.approx(expected["approx_S0_mm"] / 1e3, **near)
    assert book.offset == pytest.approx(expected["approx_e_mm"] / 1e3, **near)
    angles = expected["approx_theta_extremes_deg_rise_min_rise_max_return_min_return_max"]
    assert np.degrees([*book.rise, *book.back]) == pytest.approx(angles, abs=1e-4)
    central = solve_synthesis(replace(task, asked=replace(task.asked, offset=0.0)))
    assert central.follower.start == pytest.approx(expected["exact_S0_for_e0_mm"] / 1e3, **near)


def test_the_lines_of_a_phase_take_one_pass_over_it(monkeypatch):
    """The search for extremes is what the least base circle costs: two for the four lines keep it in its time."""
    passes, seek = [], Panels._turnings
    monkeypatch.setattr(Panels, "_turnings", lambda *given: passes.append(1) or seek(*given))
    assert len(lines_of(task_of(UNEQUAL, limits=BOTH))) == 4
    assert len(passes) == 2


def dense_half_planes(task, count=4001):
    """Rows a e + b S0 <= c of many angles, in units of the stroke."""
    program, rows, right = task.program, [], []
    for k, limit in ((0, task.limits.rise), (2, task.limits.back)):
        if limit is None:
            continue
        phi = np.linspace(program.starts[k], program.starts[k + 1], count)
        y, y1 = program.at(phi)[:2] / program.stroke
        for side in (1, -1):
            rows.append(np.stack((np.full_like(y, side), np.full_like(y, -tan(limit))), axis=1))
            right.append(tan(limit) * y - side * y1)
    return np.concatenate(rows), np.concatenate(right)


@sparing("seed", range(8), every=4)
def test_optimum_against_other_methods(seed):
    from scipy.optimize import linprog, minimize

    random = np.random.default_rng(seed)
    laws = random.choice(list(LAWS), 2)
    rise, high, back = random.uniform(20, 140), random.uniform(5, 40), random.uniform(20, 140)
    program = turn(*laws, rise=rise, high=high, back=back, stroke=10 ** random.uniform(-3, -1))
    limits = AngleLimits(radians(random.uniform(15, 50)), None if seed % 4 == 0 else radians(random.uniform(15, 50)))
    task = task_of(program, limits=limits, offset=None)
    a, b = dense_half_planes(task)
    h, lines = program.stroke, lines_of(task)
    e, start = lowest(lines)
    programme = linprog([0, 1], A_ub=a, b_ub=b, bounds=[(None, None), (0, None)])
    assert start / h == pytest.approx(programme.x[1], rel=1e-6)
    assert start / h >= programme.x[1] - 1e-12  # the dense family is part of the exact one
    e, start = nearest(lines)
    guess = np.array(lowest(lines)) * 1.1 / h
    bound = {"type": "ineq", "fun": lambda x: b - a @ x, "jac": lambda x: -a}
    other = minimize(lambda x: x @ x, guess, jac=lambda x: 2 * x, constraints=bound, method="SLSQP", tol=1e-15)
    assert hypot(e, start) / h == pytest.approx(np.sqrt(other.fun), rel=1e-5)
    for offset in random.uniform(-1, 1, 3) * h:
        alone = np.max((a[:, 0] * offset / h - b) / -a[:, 1])
        assert least_start(lines, offset) / h == pytest.approx(alone, rel=1e-5)


@sparing("offset", [None, 0.0, 0.008, -0.012], every=4)
@pytest.mark.parametrize("sense", [1, -1])
@pytest.mark.parametrize("back", [None, 40, 25])
def test_limits_are_reached_and_kept(offset, sense, back):
    limits = AngleLimits(radians(32), None if back is None else radians(back))
    found = solve_synthesis(task_of(UNEQUAL, limits=limits, offset=offset, sense=sense))
    assert found.governs == "pressure angle"
    assert found.residual < 1e-12
    assert not found.rise.exceeded
    assert not found.back.exceeded
    if offset is not None:
        assert found.follower.offset == sense * offset
        assert {size.symbol: size.value for size in found.sizes}["e"] == offset
    assert found.rounded is not None
    assert found.rounded.excess <= 0
    assert found.rounded.start * 1e3 == pytest.approx(round(found.rounded.start * 1e3), abs=1e-9)


def test_senses_mirror_the_offset():
    one, other = (solve_synthesis(task_of(UNEQUAL, limits=BOTH, offset=None, sense=s)) for s in (1, -1))
    values = [{size.symbol: size.value for size in found.sizes} for found in (one, other)]
    assert values[0]["e"] == -values[1]["e"] != 0
    assert values[0]["S0"] == values[1]["S0"]


@pytest.mark.parametrize("rise", [5.0, 60.0])
@pytest.mark.parametrize("stroke", [1e-6, 1.0])
@sparing("law", ["const", "sine", "modified_trapezoid"], every=4)
def test_extreme_sizes(rise, stroke, law):
    program = turn(law, rise=rise, high=20, back=90, stroke=stroke)
    limits = AngleLimits(radians(30), radians(30), convex=0.0)
    found = solve_synthesis(task_of(program, limits=limits, offset=None, roller=0.0))
    assert found.residual < 1e-10
    scaled = solve_synthesis(
        task_of(turn(law, rise=rise, high=20, back=90), limits=limits, offset=None, roller=0.0)
    ).follower
    assert found.follower.start / stroke == pytest.approx(scaled.start / 0.02, rel=1e-12)
    assert found.follower.offset / stroke == pytest.approx(scaled.offset / 0.02, rel=1e-9, abs=1e-12)


def test_given_sizes_are_kept():
    free = solve_synthesis(task_of(UNEQUAL, limits=BOTH, offset=None)).follower
    start = 1.05 * free.start
    found = solve_synthesis(task_of(UNEQUAL, limits=BOTH, offset=None, start=start))
    assert found.follower.start == start
    assert found.rise.excess <= 1e-12
    assert found.back.excess <= 1e-12
    smaller = replace(found.follower, offset=0.98 * found.follower.offset)
    assert max(on.excess for on in reached(task_of(UNEQUAL, limits=BOTH), smaller)) > 0
    base = 1.05 * free.base
    found = solve_synthesis(task_of(UNEQUAL, limits=BOTH, offset=None, base=base))
    assert found.follower.base == pytest.approx(base, rel=1e-15)
    assert max(found.rise.excess, found.back.excess) == pytest.approx(0, abs=1e-12)
    found = solve_synthesis(task_of(UNEQUAL, limits=BOTH, offset=0.004, base=base))
    assert found.follower.base == pytest.approx(base, rel=1e-15)
    found = solve_synthesis(task_of(UNEQUAL, limits=BOTH, offset=None, base=base, start=0.99 * base))
    assert found.follower.start == 0.99 * base
    assert found.follower.base == pytest.approx(base, rel=1e-14)


def test_given_sizes_beyond_the_limits_are_warned_of():
    found = solve_synthesis(task_of(UNEQUAL, limits=BOTH, offset=0.0, start=0.02))
    assert found.rise.exceeded
    assert any(note.startswith("warning: on the rise") for note in found.notes)


@pytest.mark.parametrize(
    ("asked", "fault"),
    [
        ({"start": 0.02, "offset": None}, NoSolutionError),
        ({"base": 0.02, "offset": None}, NoSolutionError),
        ({"base": 0.02, "offset": 0.03}, NoSolutionError),
        ({"base": 0.06, "start": 0.07, "offset": None}, NoSolutionError),
        ({"base": 0.06, "start": 0.05, "offset": 0.01}, UsageError),
    ],
)
def test_what_cannot_be(asked, fault):
    with pytest.raises(fault):
        solve_synthesis(task_of(UNEQUAL, limits=BOTH, **asked))


@pytest.mark.parametrize("limit", [0.0, radians(90), -0.1])
def test_limits_that_no_angle_has(limit):
    with pytest.raises(UsageError):
        solve_synthesis(task_of(UNEQUAL, limits=AngleLimits(limit, None)))


def test_region_is_where_the_limits_hold():
    task = task_of(UNEQUAL, limits=BOTH, offset=None)
    region = solve_synthesis(task).region
    corners = region.x + 1j * region.y
    assert (np.conj(corners) * np.roll(corners, -1)).imag.sum() > 0  # counter-clockwise
    random = np.random.default_rng(3)
    low, high = region.x.min(), region.x.max()
    top = region.y.max()
    edges = np.roll(corners, -1) - corners
    for point in random.uniform(low, high, 40) + 1j * random.uniform(0.01, 0.999 * top, 40):
        inside = bool(np.all((np.conj(edges) * (point - corners)).imag > 0))
        angles = reached(task, Follower("translating", point.imag, point.real))
        assert inside == (max(on.excess for on in angles) <= 0)
    at_cut = region.side == 0
    for z, on_cut in zip(corners + edges / 2, at_cut, strict=True):
        worst = max(on.excess for on in reached(task, Follower("translating", z.imag, z.real)))
        assert on_cut or worst == pytest.approx(0, abs=1e-12)


def test_room_for_roller_and_shaft():
    limits = AngleLimits(radians(30), None, shaft=0.06)
    found = solve_synthesis(task_of(UNEQUAL, limits=limits, offset=None))
    assert found.governs == "shaft"
    assert found.follower.base == pytest.approx(0.1, rel=1e-14)
    assert found.follower.base - found.follower.roller >= 0.06 * (1 - 1e-12)
    found = solve_synthesis(task_of(UNEQUAL, limits=BOTH, offset=None, roller=0.045))
    assert found.governs == "curvature"
    assert found.follower.roller == 0.045
    phi = np.linspace(0, UNEQUAL.starts[-1], 40001)
    kappa = curvature(contact_path(found.follower, phi, UNEQUAL.at(phi)))
    assert 1 / kappa.max() == pytest.approx(0.045 + 0.0025, rel=1e-6)
    limits = AngleLimits(radians(30), None, allow_concave=False)
    found = solve_synthesis(task_of(UNEQUAL, limits=limits, offset=None))
    assert found.roller.concave is None
    kappa = curvature(contact_path(found.follower, phi, UNEQUAL.at(phi)))
    assert kappa.min() * found.follower.base == pytest.approx(0, abs=1e-6)


def test_roller_by_the_rules():
    found = solve_synthesis(task_of(UNEQUAL, limits=BOTH, offset=None))
    phi = np.linspace(0, UNEQUAL.starts[-1], 40001)
    kappa = curvature(contact_path(found.follower, phi, UNEQUAL.at(phi)))
    most = min(0.4 * found.follower.base, 0.7 / kappa.max(), 1 / kappa.max() - 0.0025)
    assert found.follower.roller == pytest.approx(np.floor(most * 1e3) / 1e3, abs=1e-15)
    assert found.roller.convex.value == pytest.approx(1 / kappa.max(), rel=1e-6)
    assert found.roller.concave.value == pytest.approx(-1 / kappa.min(), rel=1e-6)
    large = solve_synthesis(task_of(UNEQUAL, limits=BOTH, start=0.06, roller=0.05))
    assert any("undercuts" in note for note in large.notes)
    with pytest.raises(NoSolutionError):
        solve_synthesis(task_of(UNEQUAL, limits=replace(BOTH, convex=0.05), start=0.06))


def test_record_and_columns():
    found = solve_synthesis(task_of(UNEQUAL, limits=BOTH, offset=None, sense=-1))
    again = from_record(Synthesis, to_record(found))
    for name in ("follower", "sizes", "designs", "rounded", "rise", "back", "roller", "notes", "residual", "governs"):
        assert getattr(again, name) == getattr(found, name)
    assert np.array_equal(again.region.x, found.region.x)
    columns = region_columns(found)
    assert columns["e[m]"] == pytest.approx(-found.region.x)
    assert list(columns) == ["e[m]", "S0[m]", "phi[deg]", "side"]


GROOVE = turn("cosine", "poly4567", rise=30, high=0, back=140, stroke=0.03)


@pytest.mark.parametrize("convex", [0.0025, 0.001])
def test_the_second_wall_of_a_groove_keeps_its_radius(convex):
    """The pitch curve is hollow with rho1 = r2 + r_m where that decides, found here by samples of its curvature."""
    limits = AngleLimits(radians(54), radians(45), convex=convex)
    task = task_of(GROOVE, limits=limits, closure="groove", roller=0.02)
    found = solve_synthesis(task)
    assert found.governs == "second wall"
    phi = np.linspace(0, 2 * np.pi, 40_001)
    hollowest = -1 / np.min(curvature(contact_path(found.follower, phi, GROOVE.at(phi))))
    assert hollowest == pytest.approx(0.02 + convex, rel=1e-6)
    assert not any("second wall" in note for note in found.notes)
    profile = solve_profile(task, found.follower)
    assert profile.outer.sound
    assert (
        solve_synthesis(replace(task, asked=replace(task.asked, closure="force"))).follower.base < found.follower.base
    )


@pytest.mark.parametrize(("less", "what"), [(-0.001, "undercuts the"), (0.001, "leaves the"), (0.003, None)])
def test_a_given_groove_is_warned_of_its_second_wall(less, what):
    limits, start = AngleLimits(radians(54), radians(45)), 0.08
    phi = np.linspace(0, 2 * np.pi, 40_001)
    pitch = contact_path(Follower("translating", start), phi, GROOVE.at(phi))
    roller = float(-1 / np.min(curvature(pitch))) - less
    task = task_of(GROOVE, limits=limits, closure="groove", roller=roller, start=start, offset=0.0)
    said = [note for note in solve_synthesis(task).notes if "second wall" in note]
    assert len(said) == (what is not None)
    assert all(f"{what} second wall" in note for note in said)
    held = replace(task, asked=replace(task.asked, closure="force"))
    assert not any("second wall" in note for note in solve_synthesis(held).notes)


def test_an_offset_that_is_rounding_is_nothing():
    """Rise and return alike on both sides of the axis: every design has e = 0, and so has the region's corner."""
    found = solve_synthesis(task_of(turn("sine"), limits=BOTH, offset=None))
    assert {design.offset for design in found.designs} == {0.0}
    assert found.follower.offset == 0.0
    assert 0.0 in found.region.x
    assert np.all((found.region.x == 0) | (np.abs(found.region.x) > 1e-6))


@pytest.mark.parametrize(
    ("theta", "shaft", "roller"), [(33, 0.0382, 0.0085), (40, 0.0, 0.0397), (33, 0.02, 0.0085), (50, 0.0482, 0.0085)]
)
def test_whole_millimetres_keep_shaft_and_radius(theta, shaft, roller):
    limits = AngleLimits(radians(theta), None, shaft=shaft)
    task = task_of(turn("sine", stroke=0.03), limits=limits, offset=None, roller=roller)
    whole = solve_synthesis(task).rounded
    assert 1e3 * whole.start == pytest.approx(round(1e3 * whole.start), abs=1e-9)
    assert whole.excess <= 0
    assert whole.base >= shaft + roller if shaft else True
    phi = np.linspace(0, 2 * np.pi, 40_001)
    follower = Follower("translating", whole.start, whole.offset)
    assert 1 / np.max(curvature(contact_path(follower, phi, task.program.at(phi)))) >= roller + limits.convex
