"""The flank against the swept rack, the worked cases, and closed forms."""

from __future__ import annotations

from dataclasses import replace
from math import cos, pi, radians, sin, tan
from typing import Any

import numpy as np
import pytest

from gears.involute.profile.envelope import CASES, half_angles
from gears.involute.profile.extremes import EXTREMES, TOOLS
from tmmcalc.core.errors import NoSolutionError
from tmmcalc.gears.involute.profile.flank import flank_of
from tmmcalc.gears.involute.profile.form import form_radius, junction
from tmmcalc.gears.involute.profile.outline import tooth
from tmmcalc.gears.involute.profile.rounding import Shape, rounding
from tmmcalc.gears.involute.rack import Rack
from tmmcalc.gears.involute.wheel import Wheel


@pytest.mark.slow
def test_flank_is_what_the_rack_leaves() -> None:
    checked = 0
    for wheel, shape in EXTREMES[::5]:
        try:
            flank = flank_of(wheel, shape=shape)
        except NoSolutionError:
            continue
        root, form, tip = float(wheel.root), flank.form, flank.tip
        radii = np.array([root + 1e-3, 0.8 * root + 0.2 * form, 0.3 * root + 0.7 * form, form - 1e-5, form + 1e-5, tip])
        error = np.abs(flank.half_angle_at(radii) - half_angles(wheel, radii, shape)) * radii
        assert error.max() < 1e-10, (wheel, shape)
        checked += 1
    assert checked > 120


@pytest.mark.slow
def test_fillet_runs_from_the_root_circle_into_the_involute() -> None:
    for wheel, shape in EXTREMES:
        try:
            flank = flank_of(wheel, shape=shape)
        except NoSolutionError:
            continue
        tooth(flank)
        assert abs(flank.on_fillet(flank.slope) - flank.on_involute(flank.lowest)) < 1e-11 * max(1, wheel.base)
        assert abs(flank.on_fillet(pi / 2)) == pytest.approx(float(wheel.root), rel=1e-14)
        if wheel.limit > 0.01:  # both tangents, down along the flank
            down, up = flank.on_fillet_rate(flank.slope), flank.on_involute_rate(flank.lowest)
            assert abs(down / abs(down) + up / abs(up)) < 1e-9


@pytest.mark.parametrize("shape", ["circle", "ellipse"])
@pytest.mark.parametrize("helix", [0, 30])
def test_form_radius_near_the_limit_of_undercut(shape: Shape, helix: int) -> None:
    start = Wheel(10, 0.0, radians(helix))
    depths = np.array([0.3, 1e-1, 1e-2, 1e-3, 1e-4, 3e-5, 1.5e-5, 1e-5, 1e-6, 1e-8, 1e-12, 0.0, -1e-12, -1e-3])
    wheel = replace(start, shift=start.least_shift - depths)
    rho = np.asarray(junction(wheel, shape).curvature_radius)
    under, limit = depths > 1e-13, np.asarray(wheel.limit)
    # the tangent of the second branch crosses the first one at half its own radius of curvature
    assert np.all(np.abs(rho[under] / -limit[under] - 0.5) < np.abs(0.11 * limit[under]) + 1e-5)
    assert rho[~under] == pytest.approx(np.maximum(limit[~under], 0.0), abs=1e-14)
    # in turn with the shifts, without a jump where the method changes
    assert np.all(np.diff(rho[under]) < 0)


def test_form_radius_of_arrays_is_that_of_each() -> None:
    shifts = np.linspace(-0.9, 0.6, 16).reshape(4, 4)
    found = np.asarray(form_radius(Wheel(11, shifts, 0.3)))
    assert found.shape == shifts.shape
    for shift, value in zip(shifts.ravel(), found.ravel(), strict=True):
        assert value == pytest.approx(float(form_radius(Wheel(11, float(shift), 0.3))), rel=1e-14)


@pytest.mark.parametrize("name", ["IG-S08", "IG-S11"])
def test_worked_flanks(name: str) -> None:
    case = CASES[name]
    data, expected = case["inputs"], case["expected"]
    flank = flank_of(Wheel(data["z"], data["x"]), data["r_a"] / 5)
    assert 5 * flank.form == pytest.approx(expected["r_F"], abs=1e-6)
    rolls = flank.rolls
    assert (rolls.limit, rolls.root, rolls.tip) == pytest.approx(
        [expected[k] for k in ("phi_L", "phi_D", "phi_A")], abs=6e-9
    )
    assert 5 * float(flank.rounding.x) == pytest.approx(expected["x1S"], abs=6e-7)
    assert 5 * float(flank.rounding.y) == pytest.approx(expected["y1S"], abs=6e-7)
    radii = np.array([row["radius"] for row in expected["flank"]]) / 5
    angles = [row["half_tooth_angle_rad"] for row in expected["flank"]]
    assert flank.half_angle_at(radii) == pytest.approx(angles, abs=1e-6)


def test_worked_ellipse_and_circle() -> None:
    data, expected = CASES["IG-S10"]["inputs"], CASES["IG-S10"]["expected"]
    wheel = Wheel(data["z"], data["x"], radians(15))
    shapes: dict[Any, str] = {"ellipse": "exact_ellipse", "circle": "circle"}
    for shape, key in shapes.items():
        flank = flank_of(wheel, data["r_a"] / 5, shape)
        radii = np.array([row["radius"] for row in expected[key]]) / 5
        angles = [row["half_tooth_angle_rad"] for row in expected[key]]
        assert flank.half_angle_at(radii) == pytest.approx(
            angles, abs=CASES["IG-S10"]["tolerance"]["half_tooth_angle_rad"]
        )
    circle = flank_of(wheel, data["r_a"] / 5, "circle")
    assert circle.rolls.root == pytest.approx(expected["phi_D"], abs=1e-8)
    assert 5 * circle.rounding.height == pytest.approx(expected["rho_t"], abs=1e-6)


@pytest.mark.parametrize(
    ("x", "helix", "shape"), [(0.3, 0.5, "ellipse"), (0.95, 0.0, "ellipse"), (-0.2, 0.3, "circle")]
)
def test_curvature_of_the_fillet(x: float, helix: float, shape: Shape) -> None:
    tool = rounding(Wheel(20, x, helix), shape)
    theta, h = np.linspace(tool.angle, pi / 2 - 0.01, 9), 1e-5
    rate = tool.cut_rate(theta)
    assert (tool.cut(theta + h) - tool.cut(theta - h)) / (2 * h) == pytest.approx(rate, abs=1e-8)
    second = (tool.cut_rate(theta + h) - tool.cut_rate(theta - h)) / (2 * h)
    # theta runs down the flank, so a hollow bends it clockwise
    assert -(np.conj(rate) * second).imag / np.abs(rate) ** 3 == pytest.approx(tool.curvature(theta), rel=1e-7)


def test_small_tip_radius_lets_the_straight_flank_run_on() -> None:
    rack = Rack(radians(20), 1.0, 0.25, 0.25)
    tool = rounding(Wheel(40, 0.1, 0.0, rack))
    end = 1.25 - 0.25 * (1 - sin(rack.angle))
    assert tool.limit == pytest.approx(20 * sin(rack.angle) - (end - 0.1) / sin(rack.angle), rel=1e-14)
    assert tool.flat == pytest.approx(pi / 4 - end * tan(rack.angle) - 0.25 * cos(rack.angle), rel=1e-14)


def test_sharp_tool_leaves_the_trochoid_of_its_corner() -> None:
    wheel = Wheel(30, 0.2, 0.0, Rack(radians(20), 1.0, 0.25, 0.0))
    flank = flank_of(wheel)
    radii = np.linspace(float(wheel.root) + 0.01, flank.form - 0.01, 5)
    corner = complex((0.2 - 1.25) * tan(radians(20)), 0.2 - 1.25)
    roll = flank.rolls.root - np.arccos(1.0)  # phi_D: the corner stands below Q
    assert flank.on_fillet(pi / 2) == pytest.approx(
        (corner - 15 * roll + 15j) * np.exp(1j * (float(wheel.half_angle) - roll)), abs=1e-10
    )
    assert np.all(np.diff(flank.half_angle_at(radii)) < 0)


def test_pointed_tooth_ends_at_its_point() -> None:
    flank = flank_of(Wheel(8, 0.7))
    assert flank.pointed
    assert flank.tip < 8 / 2 + 1.7
    assert abs(flank.on_involute(flank.highest).real) < 1e-14
    assert not flank_of(Wheel(8, 0.5), 4.6).pointed


@pytest.mark.parametrize(
    ("wheel", "tip", "words"),
    [
        (Wheel(5, -1.4), None, "shrinks to the centre"),
        (Wheel(12, -1.0, 0.0, TOOLS[14.5]), None, "below the beginning of the involute"),
        (Wheel(5, 2.3), None, "pointed below"),
        (Wheel(20, 0.0), 9.0, "below the beginning"),
        (Wheel(20, 0.0, 0.0, Rack(radians(25), tip_radius=0.4)), None, "wider than the tooth of the rack"),
        (Wheel(5, -0.7), None, "cuts the tooth off at its foot"),
    ],
)
def test_teeth_that_do_not_exist(wheel: Wheel, tip: float | None, words: str) -> None:
    with pytest.raises(NoSolutionError, match=words) as caught:
        flank_of(wheel, tip)
    assert caught.value.remedy
    assert caught.value.value is not None


@pytest.mark.parametrize(("teeth", "shift"), [(5, 2.3), (6, 2.5), (30, 4.0)])
def test_largest_shift_that_is_offered_is_the_largest(teeth: int, shift: float) -> None:
    with pytest.raises(NoSolutionError) as caught:
        flank_of(Wheel(teeth, shift))
    offered = float(caught.value.remedy.split()[-1])
    assert flank_of(Wheel(teeth, offered - 1e-4)).pointed
    with pytest.raises(NoSolutionError):
        flank_of(Wheel(teeth, offered + 1e-4))
