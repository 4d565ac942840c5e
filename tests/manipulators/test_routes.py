"""Routes: arcs, roundings, limits of accelerations, stops."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest

from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.manipulators.routes import legs_of
from tmmcalc.manipulators.solve import solve_manipulator
from tmmcalc.manipulators.task import ArcRoute, ArcThrough, PolyRoute
from tmmcalc.manipulators.timedroute import timed

from .scenes import task


def piece_of(route: ArcRoute | ArcThrough):
    ((piece,),) = legs_of(route)
    return piece


@pytest.mark.parametrize("side", [1, -1])
def test_the_arc_of_the_textbook(side: int) -> None:
    """(2.90) to (2.95) as they are printed, with the difference of the angles wrapped."""
    (x1, y1), (x2, y2), radius = (1.2, 0.3), (0.5, 1.1), 0.8
    piece = piece_of(ArcRoute((x1, y1), (x2, y2), radius, side))
    d, phi = math.dist((x1, y1), (x2, y2)), math.atan2(y2 - y1, x2 - x1)
    beta = math.acos(d / (2 * radius))
    centre = (x1 + radius * math.cos(phi + side * beta), y1 + radius * math.sin(phi + side * beta))
    assert piece.centre == pytest.approx(centre, rel=1e-14)
    first, last = (math.atan2(y - centre[1], x - centre[0]) for x, y in ((x1, y1), (x2, y2)))
    turn = (last - first + math.pi) % (2 * math.pi) - math.pi
    assert piece.theta == pytest.approx(first, abs=1e-14)
    assert piece.theta_end - piece.theta == pytest.approx(turn, abs=1e-13)
    assert piece.sense == side
    assert piece.length == pytest.approx(radius * abs(turn), rel=1e-13)


@pytest.mark.parametrize("side", [1, -1])
def test_an_arc_across_the_negative_axis(side: int) -> None:
    """Where the printed difference of the angles fails."""
    piece = piece_of(ArcRoute((-1.0, 0.5), (-1.0, -0.5), 0.6, side))
    assert piece.length < math.pi * 0.6
    ends = piece.at(np.array([0.0, piece.length]))[0].T
    corners = np.array([[-1.0, 0.5], [-1.0, -0.5]])
    assert ends == pytest.approx(corners, abs=1e-14)


@pytest.mark.parametrize("side", [1, -1])
def test_half_a_circle(side: int) -> None:
    piece = piece_of(ArcRoute((0.0, 0.0), (2.0, 0.0), 1.0, side))
    assert piece.length == pytest.approx(math.pi, rel=1e-14)
    assert piece.at(np.array([math.pi / 2]))[0][:, 0] == pytest.approx([1.0, -side], abs=1e-14)


@pytest.mark.parametrize("via", [(1.1, 0.9), (0.7, 0.3), (1.3, 0.25), (0.4, 1.15), (2.0, 3.0)])
def test_an_arc_through_a_point(via: tuple[float, float]) -> None:
    piece = piece_of(ArcThrough((1.2, 0.3), via, (0.5, 1.1)))
    s = np.linspace(0, piece.length, 4001)
    place = piece.at(s)[0]
    corners = np.array([[1.2, 0.3], [0.5, 1.1]])
    assert pytest.approx(corners, abs=1e-13) == place[:, [0, -1]].T
    nearest = np.min(np.hypot(*(place - np.array(via)[:, None])))
    assert nearest < piece.length / 4000
    assert np.hypot(*(place - piece.centre[:, None])) == pytest.approx(piece.radius, rel=1e-13)


def test_an_arc_in_space_lies_in_its_plane_on_the_asked_side() -> None:
    normal = np.array([0.2, -0.3, 1.0])
    route = ArcRoute((1.1, -0.4, 0.2), (0.6, 0.7, 0.6), 0.9, 1, tuple(normal))
    piece = piece_of(route)
    place = piece.at(np.linspace(0, piece.length, 50))[0]
    between = place[:, -1] - place[:, 0]
    across = np.cross(normal, between)
    assert (piece.centre - place[:, 0]) @ across > 0
    plane = np.cross(across, between)
    assert np.max(np.abs(plane @ (place - place[:, :1]))) < 1e-13
    assert np.linalg.norm(place - piece.centre[:, None], axis=0) == pytest.approx(0.9, rel=1e-14)


@pytest.mark.parametrize("dimensions", [2, 3])
def test_rounded_corners_touch_both_sides(dimensions: int) -> None:
    points = ((1.2, 0.3, 0.1), (0.7, 0.5, 0.4), (0.5, 1.1, 0.2), (0.9, 1.2, 0.6))
    (leg,) = legs_of(PolyRoute(tuple(point[:dimensions] for point in points), 0.1))
    assert [piece.radius for piece in leg] == [None, pytest.approx(0.1), None, pytest.approx(0.1), None]
    for before, after in pairwise(leg):
        last, first = before.at(np.array([before.length])), after.at(np.zeros(1))
        assert last[:2] == pytest.approx(first[:2], abs=1e-13)


def test_points_on_one_line_are_no_corner() -> None:
    legs = legs_of(PolyRoute(((0.0, 1.0), (0.3, 1.0), (0.3, 1.0), (1.0, 1.0))))
    assert len(legs) == 1
    assert sum(piece.length for piece in legs[0]) == pytest.approx(1.0, rel=1e-15)


def test_a_reversal_is_a_stop_even_where_corners_are_rounded() -> None:
    assert len(legs_of(PolyRoute(((0.0, 1.0), (1.0, 1.0), (0.2, 1.0)), 0.1))) == 2


def test_stops_at_the_corners() -> None:
    result = solve_manipulator(task("spherical", "stops", steps=40))
    assert len(result.legs) == 2
    corner = result.legs[1].begin
    at = np.flatnonzero(np.abs(result.t - corner) < 1e-12)
    assert len(at) == 2
    assert result.gripper[1][:, at] == pytest.approx(0, abs=1e-14)
    assert result.gripper[0][:, at[0]] == pytest.approx([0.7, 0.5], abs=1e-14)
    assert np.linalg.norm(result.gripper[2][:, at], axis=0) == pytest.approx(2.0, rel=1e-13)


def test_the_normal_acceleration_limits_the_speed() -> None:
    result = solve_manipulator(task("spherical", "arc", speed=3.0, acceleration=10.0, normal=0.9))
    reached = next(each for each in result.extremes if each.name == "a_normal")
    assert reached.largest == pytest.approx(0.9, rel=1e-12)
    assert result.legs[0].law.speed == pytest.approx(math.sqrt(0.9 * 0.8), rel=1e-13)


def test_the_total_acceleration_is_kept() -> None:
    result = solve_manipulator(task("spherical", "arc", speed=3.0, acceleration=2.0, total=2.5))
    reached = next(each for each in result.extremes if each.name == "acceleration")
    assert reached.largest == pytest.approx(2.5, rel=1e-12)


def test_a_duration_settles_the_speed() -> None:
    result = solve_manipulator(task("spherical", "arc", speed=None, duration=4.0))
    assert result.duration == pytest.approx(4.0, rel=1e-14)
    assert result.gripper[0, :, -1] == pytest.approx([0.5, 1.1], abs=1e-13)


def test_the_way_is_the_integral_of_the_speed() -> None:
    asked = task("spherical", "rounded")
    found = timed(legs_of(asked.motion.route), asked.motion.drive)
    t = np.linspace(0, found.duration, 20_001)
    speed = np.linalg.norm(found.gripper(t, 0)[1], axis=0)
    assert np.trapezoid(speed, t) == pytest.approx(found.length, rel=1e-7)
    for k, leg in enumerate(found.legs):
        for s in np.linspace(0, sum(piece.length for piece in leg), 9):
            at = found.time(k, float(s))
            assert found.way(np.array([at]), 0)[0, 0] == pytest.approx(s, abs=1e-12)


@pytest.mark.parametrize(
    ("route", "said"),
    [
        (ArcRoute((0.0, 1.0), (1.0, 1.0), 0.4, 1), "less than half the distance"),
        (ArcRoute((0.0, 1.0), (0.0, 1.0), 0.4, 1), "begins where it ends"),
        (ArcThrough((0.0, 1.0), (0.5, 1.0), (1.0, 1.0)), "lie on one line"),
        (PolyRoute(((0.0, 1.0), (0.1, 1.0), (0.1, 1.1)), 0.2), "rounding of corner 2"),
        (ArcRoute((0.0, 0.0, 0.5), (0.0, 0.0, 1.0), 0.4, 1), "normal of the arc's plane"),
    ],
)
def test_routes_that_cannot_be(route: object, said: str) -> None:
    with pytest.raises(NoSolutionError, match=said):
        legs_of(route)


def test_limits_that_cannot_be_kept() -> None:
    with pytest.raises(NoSolutionError, match="alone takes up"):
        solve_manipulator(task("spherical", "arc", total=1.5))
    with pytest.raises(UsageError, match="does not divide itself"):
        solve_manipulator(task("spherical", "stops", duration=4.0))
    with pytest.raises(UsageError, match="neither a speed nor a duration"):
        solve_manipulator(task("spherical", "arc", speed=None))
