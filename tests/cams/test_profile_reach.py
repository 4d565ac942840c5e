"""Largest roller, cusps and crossings against dense pairs of points, other formulas, and the curves themselves."""

from dataclasses import replace
from math import degrees, radians

import numpy as np
import pytest
from sparing import sparing

from cams.turns import task_of, turn
from tmmcalc.cams.follower import Follower
from tmmcalc.cams.profile import solve_profile
from tmmcalc.cams.profile.offsets import Rim
from tmmcalc.cams.synthesis.solve import solve_synthesis
from tmmcalc.cams.task import AngleLimits
from tmmcalc.core.errors import NoSolutionError, UsageError

ROCKER = {"kind": "oscillating", "centres": 0.1, "rocker": 0.09}
SCENES = {
    "cusp": (turn("sine", "shun"), Follower("translating", 0.040, 0.005)),
    "jumps": (turn("const", "linear"), Follower("translating", 0.035, -0.005)),
    "rocker": (turn("sine", stroke=radians(25)), Follower(start=radians(30), **ROCKER)),
    "rocker against": (turn("poly5", stroke=radians(25)), Follower(start=radians(30), assembly=-1, **ROCKER)),
    "lobe": (turn("modified_trapezoid", "sine", rise=42, high=0, back=52, stroke=0.1), Follower("translating", 0.02)),
    "thin lobe": (turn("sine", "shun", rise=54, high=0, back=44, stroke=0.12), Follower("translating", 0.02)),
}


def bounds(rim, side, count=900):
    """Least |q - p|^2/(2 n (q - p)) over pairs of points that are not neighbours."""
    phi = np.linspace(0, 2 * np.pi, count, endpoint=False) + 1e-7
    here = rim.at(phi)
    chord = here.points - here.points[:, None]
    depth = (np.conj(side * 1j * here.tangent)[:, None] * chord).real
    step = 4 * np.max(here.speed) * (phi[1] - phi[0])
    far = (np.abs(chord) > step) & (depth > 0)
    return float(np.min(np.where(far, np.abs(chord) ** 2 / np.where(far, 2 * depth, 1.0), np.inf)))


@sparing("name", SCENES, every=4)
@pytest.mark.parametrize("side", [1, -1])
def test_the_reach_is_what_dense_pairs_of_points_allow(name, side):
    program, follower = SCENES[name]
    found = solve_profile(task_of(program), follower)
    reach = found.inner_reach if side > 0 else found.outer_reach
    least = bounds(Rim(follower, program), side)
    if reach is None:
        assert least > 1e3
        return
    assert reach.distance <= least * (1 + 1e-9)
    if reach.cause == "neck":
        assert reach.distance == pytest.approx(least, rel=1e-3)
        return
    edges = np.concatenate((program.edges[:-1] + 1e-9, program.edges[1:] - 1e-9))
    bend = side * Rim(follower, program).at(np.concatenate((np.linspace(0, 6.28, 20_000), edges))).bend
    assert 1 / reach.distance == pytest.approx(np.max(bend), rel=1e-3)


def test_some_scenes_have_necks_and_some_cusps():
    causes = {solve_profile(task_of(program), follower).inner_reach.cause for program, follower in SCENES.values()}
    assert causes == {"cusp", "neck"}


def necked():
    for name, (program, follower) in SCENES.items():
        reach = solve_profile(task_of(program), follower).inner_reach
        if reach.cause == "neck":
            yield name, program, follower, reach


def test_a_neck_stands_square_to_both_sides():
    for _, program, follower, reach in necked():
        ends = Rim(follower, program).at(np.array(reach.at))
        chord = ends.points[1] - ends.points[0]
        assert abs(chord) == pytest.approx(2 * reach.distance, rel=1e-13)
        assert np.max(np.abs((np.conj(ends.tangent) * chord).real)) < 1e-9 * abs(chord)


@pytest.mark.slow
def test_beyond_a_neck_the_profile_crosses_itself_without_a_cusp():
    for _, program, follower, reach in necked():
        roller = reach.distance * (1 + 1e-4)
        big = Follower(follower.kind, follower.start, follower.offset, roller)
        found = solve_profile(task_of(program, report_faults=True), big)
        assert not found.working.loops
        assert len(found.working.crossings) >= 1
        for crossing in found.working.crossings:
            ends = Rim(big, program).at(np.array([crossing.first, crossing.second])).offset(roller)
            assert abs(ends[0] - ends[1]) < 1e-12
            assert abs(ends[0] - crossing.point) < 1e-12
        below = Follower(follower.kind, follower.start, follower.offset, reach.distance * (1 - 1e-6))
        assert solve_profile(task_of(program), below).working.sound
        with pytest.raises(NoSolutionError, match="crosses itself") as error:
            solve_profile(task_of(program), big)
        assert "a neck between" in error.value.remedy


@pytest.mark.parametrize("roller", [0.0342, 0.036, 0.045])
def test_loops_end_where_the_curvature_is_that_of_the_roller(roller):
    program, follower = turn("cosine"), Follower("translating", 0.055, roller=roller)
    found = solve_profile(task_of(program, report_faults=True), follower)
    rim = Rim(follower, program)
    first = found.working.loops[0]
    assert rim.at(np.array([first[0]])).bend[0] * roller == pytest.approx(1, rel=1e-12)
    for crossing in found.working.crossings:
        ends = rim.at(np.array([crossing.first, crossing.second])).offset(roller)
        assert abs(ends[0] - ends[1]) < 1e-10
    # the crossing of a loop encloses it
    assert any(c.first < first[0] and c.second > first[1] - 1e-12 for c in found.working.crossings)


def test_the_roller_at_its_limit_is_told_and_beyond_refused():
    program = turn("cosine")
    limit = solve_profile(task_of(program), Follower("translating", 0.055)).inner_reach.distance
    found = solve_profile(task_of(program), Follower("translating", 0.055, roller=limit))
    assert found.working.sound
    assert any("the largest that works" in remark for remark in found.remarks)
    assert np.isfinite(found.curvature).all()
    with pytest.raises(NoSolutionError):
        solve_profile(task_of(program), Follower("translating", 0.055, roller=limit * (1 + 1e-9)))


def test_the_second_wall_of_a_groove():
    program = turn("sine")
    reach = solve_profile(task_of(program, closure="groove"), Follower("translating", 0.045)).outer_reach
    assert reach.cause == "cusp"
    # the inner wall fails first here, so it is reported
    big = Follower("translating", 0.045, roller=reach.distance * 1.001)
    found = solve_profile(task_of(program, closure="groove", report_faults=True), big)
    assert found.outer.loops
    assert found.outer.crossings
    rim = Rim(big, program)
    for bound in found.outer.loops[0]:
        assert -rim.at(np.array([bound])).bend[0] * big.roller == pytest.approx(1, rel=1e-9)


def test_both_walls_of_a_groove_are_held_against_the_least_radius():
    """The second wall bulges where the pitch curve is concave: its radius there is rho1 - r2."""
    task = task_of(turn("poly4567", stroke=0.06), closure="groove")
    follower = Follower("translating", 0.06)
    rho = solve_profile(task, follower).outer_reach.distance
    for left, warned in ((1.001, 0), (0.999, 1)):
        found = solve_profile(task, replace(follower, roller=rho - left * task.limits.convex))
        said = [each for each in found.remarks if "the second wall has a radius" in each]
        assert len(said) == warned
        assert all(f"the roller may have {1e3 * (rho - task.limits.convex):.6g} mm" in each for each in said)
    # a tool no larger than the roller mills both walls, so r_i does not count
    assert found.least_concave < task.limits.concave
    assert not any("r_i" in each for each in found.remarks)
    open_side = solve_profile(replace(task, asked=replace(task.asked, closure="force")), found.follower)
    assert any("r_i" in each for each in open_side.remarks)


def test_a_tool_that_cuts_into_concave_parts():
    program, follower = turn("cosine"), Follower("translating", 0.055, roller=0.010)
    found = solve_profile(task_of(program, tool=0.05), follower)
    # the concave part has rho1 = 86.43 mm in the pitch curve
    assert found.largest_tool == pytest.approx(0.0864285714 + 0.010, rel=1e-9)
    assert found.tool.sound
    assert not any("cuts into" in remark for remark in found.remarks)
    found = solve_profile(task_of(program, tool=0.120), follower)
    assert found.tool.loops
    assert any("cuts into the profile" in remark for remark in found.remarks)
    assert np.abs(found.tool.points - found.working.points) == pytest.approx(0.120, rel=1e-12)


def test_a_tool_in_a_groove_is_not_larger_than_the_roller():
    task = task_of(turn("sine"), closure="groove", tool=0.012)
    with pytest.raises(UsageError, match="does not fit"):
        solve_profile(task, Follower("translating", 0.045, roller=0.010))


def test_the_tool_of_the_rollers_radius_runs_on_the_pitch_curve():
    task = task_of(turn("sine"), closure="groove", tool=0.010)
    found = solve_profile(task, Follower("translating", 0.045, roller=0.010))
    np.testing.assert_array_equal(found.tool.points, found.pitch)
    np.testing.assert_array_equal(found.outer_tool.points, found.pitch)


@pytest.mark.parametrize("name", SCENES)
def test_curvature_by_differences(name):
    program, follower = SCENES[name]
    rim = Rim(follower, program)
    phi = np.array([0.3, 0.61, 1.3, 1.9, 4.0])
    h = 1e-4
    before, here, after = (rim.at(phi + k * h).points for k in (-1, 0, 1))
    first, second = (after - before) / (2 * h), (after - 2 * here + before) / h**2
    kappa = (np.conj(first) * second).imag / np.abs(first) ** 3
    np.testing.assert_allclose(rim.at(phi).bend, kappa, rtol=2e-5, atol=1e-4)


@pytest.mark.parametrize("distance", [0.01, -0.02])
def test_the_rate_of_an_offset_by_differences(distance):
    for program, follower in SCENES.values():
        rim = Rim(follower, program)
        phi, h = np.array([0.31, 1.7, 3.0]), 1e-5
        rate = (rim.at(phi + h).offset(distance) - rim.at(phi - h).offset(distance)) / (2 * h)
        np.testing.assert_allclose(rim.at(phi).rate(distance, False), rate, rtol=1e-6, atol=1e-8)


def test_the_usual_rule_is_a_note_and_limits_are_warnings():
    found = solve_profile(task_of(turn("sine")), Follower("translating", 0.045, roller=0.020))
    notes = [remark for remark in found.remarks if remark.startswith("note")]
    warnings = [remark for remark in found.remarks if remark.startswith("warning")]
    assert any("0.4 R0 = 18 mm" in note for note in notes)
    assert any("r_i = 75 mm" in warning and f"{degrees(found.hollowest.phi):.6g}" in warning for warning in warnings)


@pytest.mark.parametrize(("shaft", "warned"), [(0.04, 0), (0.04 * (1 + 1e-6), 1)])
def test_a_cam_that_the_shaft_has_sized_clears_it(shaft, warned):
    """The synthesis sets R0 = r1 + r2 there, so that R0 - r2 is the shaft but for its last digit."""
    task = task_of(turn("sine", rise=90, back=90, stroke=0.01), limits=AngleLimits(radians(30), None, shaft=0.04))
    task = replace(task, asked=replace(task.asked, roller=0.005))
    follower = solve_synthesis(task).follower
    task = replace(task, limits=replace(task.limits, shaft=shaft))
    assert sum("the shaft has" in each for each in solve_profile(task, follower).remarks) == warned
