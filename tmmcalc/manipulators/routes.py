"""Routes of the gripper as pieces: straight lines and circular arcs that the way s [m] runs along.

    line    p = p_1 + s u
    arc     p = c + R (cos θ e_1 + sin θ e_2),  θ = θ_1 + q s/R                        (2.96)

In the plane e_1 and e_2 are the axes, so that θ is the polar angle. Pieces that follow each other smoothly make a leg;
between two legs the gripper stands still.
"""

from __future__ import annotations

import math
from fractions import Fraction
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.numerics.extended import as_number
from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.records import record
from tmmcalc.manipulators.task import ArcRoute, ArcThrough, Place, PolyRoute, Route

WHERE = "manipulator, path"
SAME = 1e-12  # of the route's size: nearer points are one, and turns by a smaller angle are none
HALF = 2e-15  # of R^2: a smaller difference of the radius from half the distance is that of their decimals
REVERSAL = 1e-9  # a turn so near to half a turn has no arc that rounds it [rad]


@record
class Piece:
    """A straight line, or an arc where ``radius`` is given; vectors are (D,)."""

    start: Values  # p_1 [m]
    end: Values
    length: float  # [m]
    e1: Values  # of a line its direction
    e2: Values
    centre: Values | None = None  # [m]
    radius: float | None = None  # [m]
    theta: float = 0.0  # θ_1 [rad]
    sense: int = 0  # q

    @property
    def theta_end(self) -> float:
        """θ_2 [rad], continuous from θ_1."""
        return self.theta + (self.sense * self.length / self.radius if self.radius else 0.0)

    def at(self, s: Values) -> Values:
        """Place, unit tangent and curvature vector, (3, D, n), at the ways s (n,) ((2.96) to (2.99))."""
        if self.radius is None or self.centre is None:
            place = self.start[:, None] + self.e1[:, None] * s
            return np.stack((place, np.broadcast_to(self.e1[:, None], place.shape), np.zeros_like(place)))
        theta = self.theta + self.sense * s / self.radius
        out = np.cos(theta) * self.e1[:, None] + np.sin(theta) * self.e2[:, None]
        along = self.sense * (np.cos(theta) * self.e2[:, None] - np.sin(theta) * self.e1[:, None])
        return np.stack((self.centre[:, None] + self.radius * out, along, -out / self.radius))


Leg = tuple[Piece, ...]


def legs_of(route: Route) -> tuple[Leg, ...]:
    """The legs of a route; raises `NoSolutionError` for an arc or a corner that cannot be."""
    if isinstance(route, ArcRoute):
        return ((_arc_of_radius(route),),)
    if isinstance(route, ArcThrough):
        return ((_arc_through(route),),)
    return _polyline(route)


def chord(route: Route) -> Piece:
    """The straight line from the start of a route to its end."""
    points = route.points if isinstance(route, PolyRoute) else (route.start, route.end)
    return line(_vector(points[0]), _vector(points[-1]))


def line(start: Values, end: Values) -> Piece:
    """The straight line between two points."""
    length = np.linalg.norm(end - start).item()
    direction = (end - start) / length if length else np.eye(len(start))[0]
    return Piece(start, end, length, direction, np.zeros_like(start))


def _vector(place: Place) -> Values:
    return np.array(place) * 1.0


def _axes(direction: Values, left: Values) -> tuple[Values, Values]:
    """The axes from which θ is counted: those of the plane, or the direction and its left side in space."""
    return (np.array([1.0, 0.0]), np.array([0.0, 1.0])) if len(direction) == 2 else (direction, left)


def _arc(start: Values, end: Values, centre: Values, axes: tuple[Values, Values], turn: float) -> Piece:
    """The arc about a centre by the signed angle ``turn`` [rad]."""
    e1, e2 = axes
    out = start - centre
    radius = np.linalg.norm(out).item()
    theta = np.arctan2(out @ e2, out @ e1).item()
    sense = 1 if turn >= 0 else -1
    return Piece(start, end, radius * abs(turn), e1, e2, centre, radius, theta, sense)


class Bow(NamedTuple):
    """What an arc is laid out by: its chord and where its centre is beside the middle of it."""

    chord: float  # d [m]
    along: Values  # unit vector from start to end
    left: Values  # unit vector across it, in the plane of the arc
    height: float  # h [m] of the centre to the left of the chord, below zero to the right
    via: tuple[float, float] = (0.0, 0.0)  # a, b [m] of a point that it goes through, along the chord and to its left


def bow_of(route: ArcRoute | ArcThrough) -> Bow:
    """The layout of an arc; raises `NoSolutionError` for one that cannot be."""
    return _bow_of_radius(route) if isinstance(route, ArcRoute) else _bow_through(route)


def _arc_of_radius(route: ArcRoute) -> Piece:
    """The shorter arc with its centre on the side K ((2.90) to (2.95))."""
    bow = bow_of(route)
    start, end = _vector(route.start), _vector(route.end)
    centre = (start + end) / 2 + bow.height * bow.left
    turn = 2 * np.arctan2(bow.chord / 2, abs(bow.height)).item() * route.side
    return _arc(start, end, centre, _axes(bow.along, bow.left), turn)


def _bow_of_radius(route: ArcRoute) -> Bow:
    start, end = _vector(route.start), _vector(route.end)
    between = end - start
    d = np.linalg.norm(between).item()
    if d == 0:
        remedy = "write two points"
        raise NoSolutionError("the arc begins where it ends", where=WHERE, value=d, remedy=remedy)
    if route.radius < d / 2 * (1 - SAME):
        raise NoSolutionError(
            f"the radius {route.radius:.9g} m is less than half the distance of the ends, {d / 2:.9g} m",
            where=WHERE,
            value=route.radius,
            limit=d / 2,
            remedy="write a larger radius",
        )
    direction = between / d
    return Bow(d, direction, _left(direction, route.normal), route.side * np.sqrt(_beyond_half(route)).item())


def _beyond_half(route: ArcRoute) -> float:
    """R^2 - (d/2)^2 without rounding; 0 where the radius is half the distance but for the rounding of decimals."""
    start, end, radius = (
        [Fraction(*number.as_integer_ratio()) for number in each] for each in (route.start, route.end, (route.radius,))
    )
    square = radius[0] ** 2 - sum(((b - a) ** 2 for a, b in zip(start, end, strict=True)), Fraction()) / 4
    found: float = as_number(square, type(route.radius))
    return found if found > HALF * route.radius**2 else 0.0


def _left(direction: Values, normal: Place) -> Values:
    """The unit vector to the left of a direction, seen against the normal."""
    if len(direction) == 2:
        return np.array([-direction[1], direction[0]])
    left = np.cross(_vector(normal), direction)
    size = np.linalg.norm(left).item()
    if size <= 1e-9 * float(np.linalg.norm(normal)):
        raise NoSolutionError(
            "the normal of the arc's plane is parallel to the line from start to end",
            where=WHERE,
            value=size,
            remedy="give another normal, across that line",
        )
    return np.asarray(left / size)


def _arc_through(route: ArcThrough) -> Piece:
    """The circle through three points, from the first by the second to the third."""
    bow = bow_of(route)
    start, end = _vector(route.start), _vector(route.end)
    centre = (start + end) / 2 + bow.height * bow.left
    turn = -2 * np.arctan2(bow.chord / 2, -bow.height).item()  # clockwise, seen with via above the chord
    if len(start) == 2 and bow.along[0] * bow.left[1] - bow.along[1] * bow.left[0] < 0:
        turn = -turn
    return _arc(start, end, centre, _axes(bow.along, bow.left), turn)


def _bow_through(route: ArcThrough) -> Bow:
    start, via, end = (_vector(point) for point in (route.start, route.via, route.end))
    d = np.linalg.norm(end - start).item()
    along = (end - start) / d if d else np.zeros_like(start)
    a = ((via - start) @ along).item()
    off = via - start - a * along
    b = np.linalg.norm(off).item()
    if not d or b <= 1e-9 * d:
        raise NoSolutionError(
            "the three points of the arc lie on one line",
            where=WHERE,
            value=b,
            limit=0.0,
            remedy='move via off that line, or write kind = "line"',
        )
    return Bow(d, along, off / b, (a * a - a * d + b * b) / (2 * b), (a, b))


def _polyline(route: PolyRoute) -> tuple[Leg, ...]:
    """Lines between the points, rounded or with a stop at every corner."""
    corners, size = corners_of(route)
    (_, begin), (_, end) = corners[0], corners[-1]
    if len(corners) < 2:
        return ((line(begin, end),),)
    sides = [line(a, b) for (_, a), (_, b) in pairwise(corners)]
    legs: list[list[Piece]] = [[]]
    used = 0.0
    for (number, corner), (side, after) in zip(corners[1:-1], pairwise(sides), strict=True):
        turn = _turn(side.e1, after.e1)
        rounded = turn < math.pi - REVERSAL and route.corner > 0
        cut = (route.corner * np.tan(turn / 2)).item() if rounded else 0.0
        _check_corner(number, cut, side.length - used, after.length)
        legs[-1].append(line(begin, corner - cut * side.e1))
        if rounded:
            legs[-1].append(_fillet(corner, side.e1, after.e1, cut, turn))
        else:
            legs.append([])
        begin, used = corner + cut * after.e1, cut
    legs[-1].append(line(begin, end))
    kept = [tuple(piece for piece in leg if piece.length > SAME * size) for leg in legs]
    return tuple(leg for leg in kept if leg)


def corners_of(route: PolyRoute) -> tuple[list[tuple[int, Values]], float]:
    """The points at which a polyline turns, with both ends, each with its number from 1; and the route's size [m]."""
    points = [_vector(point) for point in route.points]
    size = max(float(np.linalg.norm(point - points[0])) for point in points)
    kept = [(1, points[0])]
    for number, point in enumerate(points[1:], 2):
        if np.linalg.norm(point - kept[-1][1]) <= SAME * size:
            continue
        if len(kept) > 1 and _turn(*(line(a, b).e1 for a, b in pairwise((kept[-2][1], kept[-1][1], point)))) <= SAME:
            kept.pop()
        kept.append((number, point))
    return kept, size


def _turn(before: Values, after: Values) -> float:
    """Angle [rad] between two unit vectors."""
    half: float = np.arctan2(np.linalg.norm(after - before), np.linalg.norm(after + before)).item()
    return 2 * half


def _check_corner(number: int, cut: float, before: float, after: float) -> None:
    if cut > min(before, after) * (1 + SAME):
        left = min(before, after)
        raise NoSolutionError(
            f"the rounding of corner {number} takes {cut:.9g} m of its sides, which have {left:.9g} m left",
            where=WHERE,
            value=cut,
            limit=left,
            remedy="write a smaller corner_radius, or points farther apart",
        )


def _fillet(corner: Values, before: Values, after: Values, cut: float, turn: float) -> Piece:
    """The arc that touches both sides of a corner."""
    radius = cut / np.tan(turn / 2)
    inward = after - (after @ before) * before
    inward = inward / np.linalg.norm(inward)
    start, end = corner - cut * before, corner + cut * after
    plane = len(corner) == 2
    sense = 1.0 if not plane or before[0] * inward[1] - before[1] * inward[0] > 0 else -1.0
    return _arc(start, end, start + radius * inward, _axes(before, inward), sense * turn)
