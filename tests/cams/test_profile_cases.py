"""Profiles against the worked cases: curvature, walls, cusps, senses, flat face."""

import json
from math import degrees, radians
from pathlib import Path

import numpy as np
import pytest

from cams.turns import task_of, turn
from tmmcalc.cams.follower import Follower
from tmmcalc.cams.profile import solve_profile
from tmmcalc.cams.profile.offsets import Rim
from tmmcalc.cams.task import AngleLimits
from tmmcalc.core.errors import NoSolutionError

CASES = {c["id"]: c for c in json.loads((Path(__file__).parents[1] / "cases/cams.json").read_text())}
WIDE = 1e-5


def close(found, expected, rel, absolute=0.0):
    np.testing.assert_allclose(found, expected, rtol=rel, atol=absolute)


def of_rise(profile, steps):
    """Rows of the rise, the limit before a jump at its end."""
    labels = profile.positions.labels
    ends = [f"{k}-" if f"{k}-" in labels else str(k) for k in range(1, steps)] + [
        f"{steps}-" if f"{steps}-" in labels else str(steps)
    ]
    return [0, *(labels.index(k) for k in ends)]


def test_curvature_of_the_pitch_curve_s05():
    case = CASES["cams-s05"]
    profile = solve_profile(task_of(turn("cosine"), steps=12), Follower("translating", 0.055))
    rows = of_rise(profile, 12)
    close(1 / profile.pitch_curvature[rows], np.array(case["expected"]["rho_mm"]) / 1e3, 1e-6)
    assert 1 / profile.sharpest.value == pytest.approx(0.03409090909, rel=1e-9)
    assert -1 / profile.hollowest.value == pytest.approx(0.08642857143, rel=1e-9)
    assert (profile.sharpest.side, profile.hollowest.side) == (-1, 1)


def test_cusp_and_undercut_s17():
    expected = CASES["cams-s17"]["expected"]
    program, follower = turn("cosine", high=30), Follower("translating", 0.055, roller=0.040)
    found = solve_profile(task_of(program, report_faults=True), follower)
    assert found.sharpest.value == pytest.approx(expected["kappa_max_per_mm"] * 1e3, rel=1e-6)
    assert degrees(found.sharpest.phi) == pytest.approx(60 * expected["k_at_rho2"])
    assert found.inner_reach.distance == pytest.approx(expected["r2_max_no_undercut_mm"] / 1e3, rel=1e-6)
    (begin, end), _ = found.working.loops
    assert degrees(begin) / 60 == pytest.approx(expected["undercut_k_from"], rel=1e-6)
    assert degrees(end) / 60 == pytest.approx(expected["undercut_k_to"], rel=1e-6)
    with pytest.raises(NoSolutionError, match=r"is undercut.*44.6137 to 60 deg") as error:
        solve_profile(task_of(program), follower)
    assert error.value.limit == pytest.approx(0.0340909, rel=1e-5)
    assert "roller_radius below 34.0909 mm" in error.value.remedy


@pytest.mark.parametrize("name", ["cams-s17"])
def test_the_margin_of_technology(name):
    limits = AngleLimits(radians(30), None, convex=0.003)
    found = solve_profile(task_of(turn("cosine"), limits=limits), Follower("translating", 0.055, roller=0.0320))
    said = f"the roller may have {CASES[name]['expected']['r2_max_with_r_m_mm']:.6g} mm"
    assert any(said in remark for remark in found.remarks)


def test_walls_of_a_groove_s19():
    expected = CASES["cams-s19"]["expected"]
    task = task_of(turn("sine"), steps=4, closure="groove")
    found = solve_profile(task, Follower("translating", 0.045, roller=0.010))
    rows = of_rise(found, 4)
    for wall, name in ((found.working, "inner"), (found.outer, "outer")):
        close(1e3 * wall.points[rows].real, expected[f"x_{name}"], 1e-5, 1e-5)
        close(1e3 * wall.points[rows].imag, expected[f"y_{name}"], 1e-5, 1e-5)
    close(1e3 / found.pitch_curvature[rows], expected["rho"], 1e-5)
    close(found.sharpest.value / 1e3, expected["kappa_max_per_mm"], 1e-6)
    close(found.hollowest.value / 1e3, expected["kappa_min_per_mm"], 1e-6)
    close(1e3 * found.inner_reach.distance, expected["r2_max_inner_wall_mm"], 1e-6)
    close(1e3 * found.outer_reach.distance, expected["r2_max_outer_wall_mm"], 1e-6)


@pytest.mark.parametrize("name", ["cams-s08", "cams-s09"])
def test_rocker(name):
    inputs, table = CASES[name]["inputs"], CASES[name]["expected"]["table"]
    program = turn(inputs["law"], stroke=radians(30))
    follower = Follower("oscillating", radians(30), roller=0.010, centres=0.1, rocker=0.1, assembly=inputs["assembly"])
    found = solve_profile(task_of(program, "oscillating", steps=10), follower)
    rows = of_rise(found, 10)
    close(1e3 * found.pitch[rows].real, table["xc_mm"], 1e-5, WIDE)
    close(1e3 * found.pitch[rows].imag, table["yc_mm"], 1e-5, WIDE)
    close(1e3 * found.working.points[rows].real, table["xw_mm"], 1e-5, WIDE)
    close(1e3 * found.working.points[rows].imag, table["yw_mm"], 1e-5, WIDE)
    close(1e3 / found.pitch_curvature[rows], table["rho_mm"], 1e-5)


@pytest.mark.parametrize("combination", ["cw,right", "cw,left", "ccw,right", "ccw,left"])
def test_offset_and_sense_s10(combination):
    case = CASES["cams-s10"]
    expected = case["expected"][combination]
    rotation, side = combination.split(",")
    sense, offset = {"cw": 1, "ccw": -1}[rotation], {"right": 0.008, "left": -0.008}[side]
    follower = Follower("translating", 0.055, sense * offset, 0.008, sense=sense)
    program = turn("sine", "shun", rise=80, high=30, back=100)
    found = solve_profile(task_of(program), follower)
    phi = np.degrees(found.positions.phi).round(9)
    rows = [int(np.flatnonzero(phi == wanted)[0]) for wanted in case["inputs"]["phi_deg"]]
    for points, name in ((found.pitch, "c"), (found.working.points, "w")):
        close(1e3 * points[rows].real, expected[f"x{name}_mm"], 1e-6, 1e-5)
        close(1e3 * points[rows].imag, expected[f"y{name}_mm"], 1e-6, 1e-5)
    close(1e3 / found.pitch_curvature[rows], expected["rho_mm"], 1e-6)


def test_flat_face_s13():
    case = CASES["cams-s13"]
    expected = case["expected"]
    program = turn("sine", rise=70, high=20, back=70, stroke=0.012)
    found = solve_profile(task_of(program, "flat"), Follower("flat", expected["S0_min_mm"] / 1e3))
    phi = np.degrees(found.positions.phi).round(9)
    rows = [int(np.flatnonzero(phi == wanted)[0]) for wanted in expected["phi_deg"]]
    close(1e3 * found.working.points[rows].real, expected["x_mm"], 1e-6, 1e-5)
    close(1e3 * found.working.points[rows].imag, expected["y_mm"], 1e-6, 1e-5)
    close(1e3 / found.curvature[rows], expected["rho_mm"], 1e-6)
    assert 1e3 * found.sharpest.value == pytest.approx(3.0, abs=1e-5)
    assert degrees(found.sharpest.phi) / 70 == pytest.approx(expected["k_at_F_min"], rel=1e-6)
    assert 1e3 * found.face.left == pytest.approx(expected["plate_reach_left_mm"], rel=1e-6)
    assert 1e3 * found.face.right == pytest.approx(expected["plate_reach_right_mm"], rel=1e-6)


def test_flat_face_that_would_be_undercut():
    program, s0 = turn("sine", rise=70, high=20, back=70, stroke=0.012), 0.0380
    with pytest.raises(NoSolutionError, match="undercut") as error:
        solve_profile(task_of(program, "flat"), Follower("flat", s0))
    assert "start_distance above 39.6415 mm" in error.value.remedy
    found = solve_profile(task_of(program, "flat", report_faults=True), Follower("flat", s0))
    rim = Rim(found.follower, program)
    assert len(found.working.loops) == 2
    for bound in found.working.loops[0]:
        assert abs(rim.at(np.array([bound])).speed[0]) < 1e-13
    for crossing in found.working.crossings:
        ends = rim.at(np.array([crossing.first, crossing.second])).offset(0.0)
        assert abs(ends[0] - ends[1]) < 1e-10


def test_the_least_start_distance_of_a_flat_face_works():
    program = turn("sine", rise=70, high=20, back=70, stroke=0.012)
    found = solve_profile(task_of(program, "flat"), Follower("flat", 0.0396415 + 1e-6))
    assert found.working.sound
    assert 0 < found.sharpest.value < 2e-6
