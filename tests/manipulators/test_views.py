"""What a page moves of arms: links keep their lengths, the gripper is where the stage says, aslant where it is seen."""

from __future__ import annotations

import itertools
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tmmcalc.manipulators.solve import solve_manipulator
from tmmcalc.manipulators.tables.tasks.manipulator import to_manipulator, with_steps
from tmmcalc.manipulators.task import JointLimit, ManipulatorTask, Obstacle
from tmmcalc.manipulators.views.manipulator import _PlaneArm, _stops, views
from tmmcalc.manipulators.views.space import AslantArm
from tmmcalc.pipeline.picturing import order_of
from tmmcalc.project import load_spec
from tmmcalc.report.moving import Body, View

from .scenes import ARMS, PLANE, SPACE, task

BOX = Obstacle("press", (0.85 + 0.65j, 1.05 + 0.65j, 1.05 + 0.85j, 0.85 + 0.85j), 0.0, 0.4)
FLAT = [name for name in ARMS if not ARMS[name].spatial]
TURNING = [name for name in ARMS if ARMS[name].spatial]


def place(bodies: dict[str, Body], body: str, at: complex) -> Any:
    """Where a point of a body goes."""
    if not body:
        return at
    x, y, angle = (track.values for track in bodies[body][1:4])
    return x + 1j * y + at * np.exp(1j * angle)


def rates(bodies: dict[str, Body], body: str, at: complex) -> Any:
    """How fast."""
    x, y, angle = bodies[body][1:4]
    return x.rates + 1j * y.rates + 1j * angle.rates * at * np.exp(1j * angle.values)


@pytest.mark.parametrize(("arm", "route"), [*itertools.product(FLAT, PLANE)])
def test_the_gripper_of_a_plane_arm(arm: str, route: str) -> None:
    result = solve_manipulator(task(arm, route, (BOX,)))
    view = _PlaneArm(task(arm, route, (BOX,)), result)
    bodies = {body.name: body for body in view.bodies()}
    gripper = next(spot for spot in view.spots() if spot.name == "P")
    at, speed = place(bodies, gripper.body, gripper.at), rates(bodies, gripper.body, gripper.at)
    np.testing.assert_allclose(at, result.gripper[0, 0] + 1j * result.gripper[0, 1], atol=1e-12)
    np.testing.assert_allclose(speed, result.gripper[1, 0] + 1j * result.gripper[1, 1], atol=1e-9)
    low, high = view.box
    assert ((at.real >= low.real) & (at.real <= high.real) & (at.imag >= low.imag) & (at.imag <= high.imag)).all()


@pytest.mark.parametrize("arm", FLAT)
def test_links_of_a_plane_arm_stay_joined(arm: str) -> None:
    result = solve_manipulator(task(arm, "rounded"))
    view = _PlaneArm(task(arm, "rounded"), result)
    bodies = {body.name: body for body in view.bodies()}
    own = result.arm
    if own.kind == "angular":
        ends = place(bodies, "2", own.upper + 0j), place(bodies, "3", 0j)
        np.testing.assert_allclose(*ends, atol=1e-12)
        assert result.elbow is not None
        np.testing.assert_allclose(ends[0], result.elbow[0] + 1j * result.elbow[1], atol=1e-12)
        np.testing.assert_allclose(place(bodies, "2", 0j), 1j * own.height, atol=1e-12)
        return
    (bar,) = [mark for mark in bodies["3"].marks if mark.kind == "bar" and len(mark.points) == 2]
    block = [mark for mark in bodies["2"].marks if mark.kind == "block"][-1]
    back, front = (place(bodies, "3", end) for end in bar.points)
    guide = place(bodies, "2", block.points[0])
    along = (guide - back) / (front - back)
    np.testing.assert_allclose(along.imag, 0.0, atol=1e-9)  # the block is on the rod
    assert (along.real > 0).all()
    assert (along.real < 1).all()


def test_what_the_joints_reach() -> None:
    limits = (JointLimit("phi_2", 0.0, np.pi / 2), JointLimit("l_3", 0.8, 1.3))
    asked = ManipulatorTask(ARMS["spherical"], task("spherical", "arc").motion, limits)
    view = _PlaneArm(asked, solve_manipulator(asked))
    (border,) = [np.array(mark.points) for mark in view.frame() if mark.kind == "range"]
    far = np.abs(border - 0.3j)
    np.testing.assert_allclose(np.sort(np.unique(far.round(9))), [0.8, 1.3])
    assert abs(np.angle(border - 0.3j)).max() == pytest.approx(np.pi / 2)
    half = ManipulatorTask(ARMS["spherical"], asked.motion, (JointLimit("phi_2", None, 1.0),))
    assert not [m for m in _PlaneArm(half, solve_manipulator(half)).frame() if m.kind == "range"]


@pytest.mark.parametrize(("arm", "route"), [*itertools.product(TURNING, SPACE)])
def test_an_arm_in_space_is_seen_aslant(arm: str, route: str) -> None:
    result = solve_manipulator(task(arm, route, (BOX,)))
    view = AslantArm(task(arm, route, (BOX,)), result)
    bodies = {body.name: body for body in view.bodies()}
    np.testing.assert_allclose(place(bodies, "hand", 0j), view.seen(result.gripper[0]), atol=1e-12)
    np.testing.assert_allclose(rates(bodies, "hand", 0j), view.seen(result.gripper[1]), atol=1e-12)
    below = np.stack((*result.gripper[0, :2], 0 * result.t))
    np.testing.assert_allclose(place(bodies, "ground", 0j), view.seen(below), atol=1e-12)
    if result.elbow is not None:
        np.testing.assert_allclose(place(bodies, "middle", 0j), view.seen(result.elbow), atol=1e-12)
    for span in view.spans():
        assert all(not body or body in bodies for body, _ in span.points)
    assert {spot.name for spot in view.spots()} >= {"P", "x", "y", "z", "press"}


def test_seen_aslant_is_a_projection() -> None:
    """Both directions of the picture are unit vectors at right angles: lengths are shortened, never drawn out."""
    asked = task("spherical, base", "line")
    view = AslantArm(asked, solve_manipulator(asked))
    axes = view.seen(np.eye(3))
    assert np.sum(axes.real**2) == pytest.approx(1)
    assert np.sum(axes.imag**2) == pytest.approx(1)
    assert np.sum(axes.real * axes.imag) == pytest.approx(0, abs=1e-12)


def view_of(name: str) -> View:
    """The view of a ready spec over many steps."""
    spec = load_spec(Path(__file__).parents[2] / "configs" / f"{name}.toml")
    found = solve_manipulator(to_manipulator(with_steps(spec, 360)))
    (view,) = views(order_of(spec, {"manipulator": found}))
    return view


@pytest.mark.parametrize("name", ["manipulator", "manipulator-angular", "manipulator-direct"])
def test_views_of_ready_specs(name: str) -> None:
    view = view_of(name)
    assert len(view.values) > 360
    assert (np.diff(view.values) >= 0).all()
    assert view.column == "t[s]"
    assert view.stages == ("manipulator",)
    assert all(column.startswith("manipulator.") for column in view.shown)


def test_where_a_limit_is_passed_is_marked() -> None:
    asked = ManipulatorTask(ARMS["spherical"], task("spherical", "arc").motion, (JointLimit("phi_2", None, 0.5),))
    result = solve_manipulator(asked)
    (stop,) = _stops(result)
    assert stop.title == "joint phi_2"
    row = np.argmin(np.abs(result.t - stop.at))
    assert abs(result.q[0, 0, row] - 0.5) < 0.05
