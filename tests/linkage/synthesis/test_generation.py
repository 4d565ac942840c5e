"""Function, path and motion generation: linkages are found again from what they do; defects are told; seeds hold."""

from __future__ import annotations

import math

import numpy as np
import pytest

import tmmcalc
from tmmcalc.core.plane import Plane, Real
from tmmcalc.linkage.synthesis.burmester import Poses, centres, circle_points, curve_points, line_points
from tmmcalc.linkage.synthesis.function import chebyshev
from tmmcalc.linkage.synthesis.kinds import solve_synthesis
from tmmcalc.linkage.synthesis.path import cognates
from tmmcalc.linkage.synthesis.planar import bars_of
from tmmcalc.linkage.synthesis.rating import crank_angles
from tmmcalc.linkage.synthesis.results import Synthesis
from tmmcalc.linkage.synthesis.task import FunctionTask, PoseTask, SynthesisTask

pytestmark = pytest.mark.slow

ANGLES = np.radians([20, 50, 80, 120, 160, 200, 240, 290, 330])


def traced(phi: Real, a: float = 0.1, b: float = 0.3, c: float = 0.25, d: float = 0.32) -> tuple[Plane, Real]:
    """Coupler point and coupler angle of a crank-rocker, by intersecting circles."""
    pin = a * np.exp(1j * phi)
    reach = d - pin
    along = (b**2 - c**2 + np.abs(reach) ** 2) / (2 * np.abs(reach))
    joint = pin + reach / np.abs(reach) * (along + 1j * np.sqrt(b**2 - along**2))
    turn = (joint - pin) / b
    return pin + turn * (0.1 + 0.1j), np.unwrap(np.angle(turn))


def solved(kind: str, asked: object, solutions: int = 5) -> Synthesis:
    return solve_synthesis(SynthesisTask(kind, asked, solutions=solutions))


def function_task(mechanism: str, count: int, **given: float) -> FunctionTask:
    """y = x^2 over [1, 2] in 90 degrees of the crank and 90 degrees of the rocker, or 100 mm."""
    span = math.pi / 2 if mechanism == "four_bar" else 0.1
    x, fine = chebyshev(count, 1.0, 2.0), np.linspace(1, 2, 181)
    parts = [((at - 1) * math.pi / 2, (at**2 - 1) / 3 * span) for at in (x, fine)]
    return FunctionTask(mechanism, *parts[0], *parts[1], (0.0, math.pi / 2), **given)


@pytest.mark.parametrize("mechanism", ["four_bar", "slider_crank"])
@pytest.mark.parametrize("count", [3, 4, 5])
def test_precision_points_of_a_function_are_met_exactly(mechanism: str, count: int) -> None:
    found = solved("function", function_task(mechanism, count))
    assert found.residual < 1e-12
    best = found.best
    assert not best.defects
    assert best.precision is not None
    motion = tmmcalc.solve_kinematics(tmmcalc.parse_spec(best.spec))
    rows = [int(np.argmin(np.abs(motion.x - x))) for x in best.precision.crank]
    assert np.max(np.abs(motion.x[rows] - best.precision.crank)) < 1e-9
    steps = np.diff(motion.s[0, rows])
    assert steps == pytest.approx(np.diff(function_task(mechanism, count).outputs), abs=1e-11)


def test_three_points_with_both_starts_given_are_the_textbook_system() -> None:
    """Freudenstein's three linear equations, solved by numpy."""
    given = {"input_start": math.radians(167), "output_start": math.radians(-132)}
    task = function_task("four_bar", 3, **given)
    phi, psi = task.inputs + given["input_start"], task.outputs + given["output_start"]
    matrix = np.column_stack((np.cos(psi), -np.cos(phi), np.ones(3)))
    k1, k2, k3 = np.linalg.solve(matrix, np.cos(phi - psi))
    a, c = 1 / k1, 1 / k2
    b = math.sqrt(a**2 + c**2 + 1 - 2 * a * c * k3)
    (design,) = solved("function", task).designs
    assert [design.size(s) for s in "abcd"] == pytest.approx([abs(a), b, abs(c), 1.0], rel=1e-12)


@pytest.mark.parametrize("mechanism", ["four_bar", "slider_crank"])
def test_more_points_of_a_function_in_the_least_squares(mechanism: str) -> None:
    found = solved("function", function_task(mechanism, 9))
    exact = solved("function", function_task(mechanism, 5))
    name = "structural_error_max[deg]" if mechanism == "four_bar" else "structural_error_max[m]"
    assert found.best.merits[name] < 1.5 * exact.best.merits[name]
    assert any("least squares" in note for note in found.notes)


def test_chebyshev_spacing() -> None:
    """Roots of the Chebyshev polynomial, by numpy."""
    roots = np.polynomial.chebyshev.Chebyshev.basis(6).roots()
    assert chebyshev(6, 2.0, 8.0) == pytest.approx(np.sort(5 + 3 * roots), abs=1e-13)


def test_burmester_points_are_even_in_number_and_stay_on_circles() -> None:
    rng = np.random.default_rng(0)
    counts = set()
    for _ in range(30):
        poses = Poses(rng.normal(size=5) + 1j * rng.normal(size=5), np.append(0, rng.uniform(-1.5, 1.5, 4)))
        z, c = circle_points(poses)
        counts.add(len(z))
        radius = np.abs(poses.places(z) - c[:, None])
        assert np.all(np.ptp(radius, axis=1) < 1e-6 * radius.max(axis=1)) if len(z) else True
    assert counts == {0, 2, 4}


def test_burmester_points_are_all_that_random_starts_find() -> None:
    """scipy's Newton from many starts finds no fifth point."""
    from scipy.optimize import fsolve

    points, angles = traced(ANGLES[:5])
    poses = Poses(points, angles - angles[0])
    z, _ = circle_points(poses)

    def gaps(x: Real) -> Real:
        places = poses.places(np.array([x[0] + 1j * x[1]]))[0] - (x[2] + 1j * x[3])
        return np.diff(np.abs(places) ** 2)

    rng = np.random.default_rng(1)
    for start in rng.normal(0, 0.4, size=(150, 4)):
        x, _, code, _ = fsolve(gaps, start, full_output=True, xtol=1e-13)
        size = np.max(np.abs(gaps(x)))
        if code == 1 and size < 1e-15 and np.max(np.abs(x)) < 3:
            assert np.min(np.abs(z - (x[0] + 1j * x[1]))) < 1e-5


def test_points_of_four_poses_on_circles_and_lines() -> None:
    points, angles = traced(ANGLES[:4])
    poses = Poses(points, angles - angles[0])
    z = curve_points(poses, 1.0, 24)
    c = centres(poses, z)
    near = np.abs(c) < 10
    assert near.sum() > 50
    assert np.max(np.ptp(np.abs(poses.places(z[near]) - c[near, None]), axis=1)) < 1e-9
    (ball,) = line_points(poses, 8)
    steps = np.diff(poses.places(np.array([ball]))[0])
    assert np.max(np.abs((np.conj(steps[1:]) * steps[0]).imag)) < 1e-13
    assert np.min(np.abs(steps)) > 1e-4


@pytest.mark.parametrize("count", [2, 3, 4, 5])
@pytest.mark.parametrize("mechanism", ["four_bar", "slider_crank"])
def test_poses_are_met(mechanism: str, count: int) -> None:
    points, angles = traced(ANGLES[:count])
    found = solved("motion", PoseTask(mechanism, points, angles), solutions=2)
    best = found.best
    assert best.precision is not None
    if mechanism == "slider_crank" and count == 5:
        assert any("least squares" in note for note in found.notes)
        assert best.merits["error_max[m]"] < 1e-3
        return
    assert found.residual < 1e-9
    assert not best.defects
    assert np.max(np.abs(best.precision.reached - points)) < 1e-9
    assert np.max(np.abs(best.precision.angle_errors)) < 1e-9


def test_a_known_four_bar_is_found_from_seven_poses() -> None:
    points, angles = traced(ANGLES[:7])
    best = solved("motion", PoseTask("four_bar", points, angles), solutions=1).best
    assert [best.size(s) for s in "abc"] == pytest.approx([0.1, 0.3, 0.25], rel=1e-6)
    assert best.size("body") == pytest.approx(0, abs=1e-6)


@pytest.mark.parametrize(("mechanism", "count"), [("four_bar", 5), ("slider_crank", 4)])
def test_points_of_a_path_are_met(mechanism: str, count: int) -> None:
    points, _ = traced(ANGLES[:count])
    found = solved("path", PoseTask(mechanism, points), solutions=1)
    best = found.best
    assert not best.defects
    assert found.residual < 1e-9
    motion = tmmcalc.solve_kinematics(tmmcalc.parse_spec(best.spec))
    curve = motion.trace.r[motion.trace.point_names.index("P")]
    assert np.max(np.min(np.abs(curve[:, None] - points), axis=0)) < 1e-9  # the points are positions of the ready spec


def test_a_timed_path_keeps_its_timing() -> None:
    phi = ANGLES[:4]
    points, _ = traced(phi)
    found = solved("path", PoseTask("four_bar", points, timing=phi - phi[0]), solutions=1)
    assert found.residual < 1e-9
    precision = found.best.precision
    assert precision is not None
    turned = precision.crank - precision.crank[0]
    off = turned - (phi - phi[0])
    assert np.max(np.abs(off - 2 * np.pi * np.round(off / (2 * np.pi)))) < 1e-9


def test_equal_seeds_give_equal_designs() -> None:
    points, _ = traced(ANGLES[:3])
    task = PoseTask("slider_crank", points, timing=ANGLES[:3] - ANGLES[0])
    one, two = (solved("path", task, solutions=2) for _ in range(2))
    assert [design.spec for design in one.designs] == [design.spec for design in two.designs]


def test_cognates_trace_the_same_points() -> None:
    points, angles = traced(ANGLES[:6])
    turn = np.exp(1j * (angles - angles[0]))[None, :]
    first = np.exp(1j * angles[0])
    z1, z2 = np.array([-(0.1 + 0.1j) * first]), np.array([(0.2 - 0.1j) * first])
    for turned, one, c1, two, c2 in cognates(points, turn, z1, np.array([0j]), z2, np.array([0.32 + 0j])):
        assert c2 is not None
        for z, c in ((one, c1), (two, c2)):
            assert np.ptp(np.abs(points + turned * z[:, None] - c[:, None])) < 1e-14
        assert np.max(np.abs(np.abs(turned) - 1)) < 1e-14


def test_order_of_positions() -> None:
    angles = np.array([[0.0, 1.0, 2.0, 4.0], [0.0, 2.0, 1.0, 4.0], [4.0, 2.0, 1.0, 0.0], [6.0, 7.0, 8.0, 12.0]])
    phi, sense, order = crank_angles(np.exp(1j * angles))
    assert order.tolist() == [True, False, True, True]
    assert sense[[0, 2, 3]].tolist() == [1, -1, 1]
    assert np.diff(phi[[0, 2, 3]], axis=1) == pytest.approx(np.diff(angles[[0, 2, 3]], axis=1))


def test_vectorised_places_agree_with_the_kinematics() -> None:
    points, angles = traced(ANGLES)
    parts = [[[v]] for v in (0j, 0.1, 0.3, 0.32 + 0j, 0.25, 1 + 0j, 0.1 + 0.1j, 1.0)]
    placed = bars_of(parts, False).at(ANGLES[None, :])
    assert np.max(np.abs(placed.point[0] - points)) < 1e-15
    assert np.max(np.abs(np.angle(placed.turn[0] * np.exp(-1j * angles)))) < 1e-15


def test_in_a_region_without_exact_pivots_the_nearest_are_told() -> None:
    points, angles = traced(ANGLES[:5])
    low, high = 0.1 + 0.1j, 0.2 + 0.2j
    found = solved("motion", PoseTask("four_bar", points, angles, region=(low, high)))
    assert any(note.startswith("warning: no four-bar was found that meets") for note in found.notes)
    for design in found.designs:
        for x, y in (("x_A", "y_A"), ("x_D", "y_D")):
            assert low.real - 1e-12 <= design.size(x) <= high.real + 1e-12
            assert low.imag - 1e-12 <= design.size(y) <= high.imag + 1e-12


@pytest.mark.parametrize("sense", [1, -1])
def test_the_sense_of_the_crank_is_told_and_is_that_of_the_ready_spec(sense: int) -> None:
    inputs, outputs = sense * np.radians([0, 30, 70]), np.radians([0, 15, 40])
    none = np.zeros(0)
    span = (min(0.0, float(inputs[-1])), max(0.0, float(inputs[-1])))
    task = FunctionTask("four_bar", inputs, outputs, none, none, span)
    design = solved("function", task, solutions=1).best
    assert design.precision is not None
    assert design.precision.sense == sense
    assert math.copysign(1, tmmcalc.solve_kinematics(tmmcalc.parse_spec(design.spec)).speed) == sense
    points, angles = traced(ANGLES[:4][::sense])
    guided = solved("motion", PoseTask("four_bar", points, angles), solutions=3).best
    assert guided.precision is not None
    assert np.all(guided.precision.sense * np.diff(guided.precision.crank) > 0)


def test_fixed_pivots_stand_in_the_region() -> None:
    points, angles = traced(ANGLES[:3])
    low, high = -0.1 - 0.1j, 0.3 + 0.3j
    for design in solved("motion", PoseTask("four_bar", points, angles, region=(low, high))).designs:
        for x, y in (("x_A", "y_A"), ("x_D", "y_D")):
            assert low.real <= design.size(x) <= high.real
            assert low.imag <= design.size(y) <= high.imag


def test_poses_that_no_linkage_meets_are_met_nearly_or_told() -> None:
    """Three poses without a turn have no circle of finite radius."""
    found = solved("motion", PoseTask("four_bar", np.array([0, 0.1, 0.2 + 0j]), np.zeros(3)), solutions=1)
    assert any(note.startswith("warning") for note in found.notes)
    assert found.best.merits["error_max[m]"] < 1e-6


def test_the_least_transmission_angle_is_that_of_the_lines_of_centres() -> None:
    """Of a crank that turns fully it stands where the crank is in line with the frame."""
    points, angles = traced(ANGLES[:5])
    found = solved("motion", PoseTask("four_bar", points, angles), solutions=20)
    crank_rockers = [design for design in found.designs if design.name.endswith("crank-rocker")]
    assert crank_rockers
    for design in crank_rockers:
        a, b, c = (design.size(symbol) for symbol in "abc")
        d = math.hypot(design.size("x_D") - design.size("x_A"), design.size("y_D") - design.size("y_A"))
        cosines = [(b**2 + c**2 - (d + sign * a) ** 2) / (2 * b * c) for sign in (1, -1)]
        least = math.degrees(math.acos(max(map(abs, cosines))))
        assert design.merits["transmission_min[deg]"] == pytest.approx(least, abs=1e-6)
    merits = [(len(design.defects), -design.merits["transmission_min[deg]"]) for design in found.designs]
    assert merits == sorted(merits)
