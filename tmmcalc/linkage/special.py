"""The special (Assur) points of groups of class III and IV: where the lines of two legs of a basic link meet.

A leg is a link that joins the basic one, which has three pairs or more, to one other link. Whatever the basic link
does, the leg hands the velocity of its other end on along its own line alone: of the point S of the basic link where
the lines of two legs meet both components are known, so that the plan of velocities begins with it,

    v_S . e_k = v_F . e_k        e_k along leg k, F its pin on the other link

Between two basic links (class IV) S is a point of each, and both have one velocity there. The line of a leg with a
slider is normal to its guide, through its pin. Where the lines are parallel there is no such point.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property, partial
from itertools import combinations
from typing import Any, NamedTuple

import numpy as np

from tmmcalc.core.columns import Column, column
from tmmcalc.core.plane import Plane, Point, Real, cross
from tmmcalc.core.quantity import Quantity
from tmmcalc.linkage.chain import Configuration, chain_of
from tmmcalc.linkage.columns import units_of
from tmmcalc.linkage.loads.sources import same_place
from tmmcalc.linkage.model import Joint, Mechanism
from tmmcalc.linkage.results import Kinematics
from tmmcalc.linkage.structure import Group, Structure

PARALLEL = 1e-9  # sine of the angle between two lines that do not meet
NOISE = 1e-12  # of what a velocity is the sum of: it is none

PLACE = Quantity(
    "{axis}_W{link}_{first}_{second}[{length}]",
    "{axis} of special point W{link}_{first}_{second}, where the lines of two legs meet on a basic link",
)
VELOCITY = Quantity(
    "v{axis}_W{link}_{first}_{second}[{velocity}]",
    "velocity of special point W{link}_{first}_{second} of its basic link along {axis}",
)
ACCELERATION = Quantity(
    "a{axis}_W{link}_{first}_{second}[{acceleration}]",
    "acceleration of special point W{link}_{first}_{second} of its basic link along {axis}",
)


class Leg(NamedTuple):
    """A link that joins the basic one to another: its pair with the basic link, and its pair with the other."""

    link: int
    near: Joint
    far: Joint


class Special(NamedTuple):
    """The point of a basic link where the lines of two legs meet."""

    link: int
    legs: tuple[Leg, Leg]

    @property
    def name(self) -> str:
        """``W3_2_4``: of basic link 3, on the lines of links 2 and 4."""
        return "W{link}_{first}_{second}".format(link=self.link, **self.lines)

    @property
    def lines(self) -> dict[str, int]:
        """The links on whose lines it lies, by their places in names."""
        return {"first": self.legs[0].link, "second": self.legs[1].link}


def special_points(mechanism: Mechanism, structure: Structure) -> tuple[Special, ...]:
    """The special points of all groups of class III and higher; a group with the drive inside it has none."""
    found: list[Special] = []
    for group in structure.groups:
        if not (group.kind or group.drive):
            found += _of_group(mechanism, group)
    return tuple(found)


def _of_group(mechanism: Mechanism, group: Group) -> Iterator[Special]:
    """By basic link, each pair of its legs."""
    joints = [mechanism.joint(name) for name in (*group.inner, *group.outer)]
    own = {link: [joint for joint in joints if link in joint.links] for link in group.links}
    for link in group.links:
        if len(own[link]) < 3:
            continue
        legs = [
            _leg(own[joint.other(link)], joint, joint.other(link)) for joint in own[link] if _is_leg(own, joint, link)
        ]
        for first, second in combinations(sorted(filter(_has_line, legs)), 2):
            yield Special(link, (first, second))


def _is_leg(own: dict[int, list[Joint]], joint: Joint, link: int) -> bool:
    return len(own.get(joint.other(link), ())) == 2


def _leg(both: list[Joint], near: Joint, link: int) -> Leg:
    return Leg(link, near, next(joint for joint in both if joint is not near))


def _has_line(leg: Leg) -> bool:
    return "revolute" in (leg.near.kind, leg.far.kind)


def meeting(configuration: Configuration, special: Special) -> Point:
    """Place (n,) of a special point and the transfer functions of the basic link there; NaN without such a point."""
    (p, e), (q, f) = (_line(configuration, leg) for leg in special.legs)
    sine = cross(e, f)
    t = cross(q - p, f) / np.where(np.abs(sine) > PARALLEL, sine, np.nan)
    place = np.asarray(p + t * e)
    return same_place(configuration.motions[special.link], Point(place, place, place))


def _line(configuration: Configuration, leg: Leg) -> tuple[Plane, Plane]:
    """A point of the line of a leg and its direction, (n,) each."""
    pins = [_pin(configuration, joint, leg.link) for joint in (leg.near, leg.far) if joint.kind == "revolute"]
    if len(pins) == 2:
        along = pins[1] - pins[0]
        return pins[0], np.asarray(along / np.abs(along))
    slide = leg.near if leg.near.kind == "prismatic" else leg.far
    guide = configuration.motions[slide.links[1]].u * slide.directions[1]
    return pins[0], np.asarray(1j * guide)


def _pin(configuration: Configuration, joint: Joint, link: int) -> Plane:
    return configuration.motions[link].point(joint.points[joint.links.index(link)]).r


def special_columns(mechanism: Mechanism, result: Kinematics, *, dimensionless: bool = False) -> Iterator[Column]:
    """Place, velocity and acceleration of every special point; NaN where its lines are parallel.

    Raises `UsageError` for dimensionless driven sliders.
    """
    units, found = units_of(result, dimensionless), SpecialPoints(mechanism, result)
    for special in found.points:
        for k, (told, (_, factor)) in enumerate(
            ((PLACE, units.length), (VELOCITY, units.velocity), (ACCELERATION, units.acceleration))
        ):
            for axis in "xy":
                own = told.of(axis=axis, link=special.link, **special.lines, **units.names)
                yield column(own, partial(found.component, special, k, axis, factor))


class SpecialPoints:
    """The special points over the positions of a result; the mechanism is evaluated there when one is asked for."""

    def __init__(self, mechanism: Mechanism, result: Kinematics) -> None:
        self.mechanism, self.result = mechanism, result
        self.points = special_points(mechanism, result.structure)

    @cached_property
    def _configuration(self) -> Configuration:
        return chain_of(self.mechanism, self.result).evaluate(self.result.x)

    def state(self, special: Special) -> tuple[Plane, Plane, Plane]:
        """Place, velocity and acceleration (n,) of a special point in time."""
        at, basic = meeting(self._configuration, special), self._configuration.motions[special.link]
        parts = np.abs(basic.v) + np.abs(basic.omega) * np.abs(at.r - basic.r)
        still = np.abs(at.v) < NOISE * parts  # as where both legs turn about the frame: a pole of the basic link
        velocity, acceleration = self.result.in_time(np.where(still, 0.0, at.v), at.a)
        return at.r, velocity, acceleration

    def component(self, special: Special, order: int, axis: str, factor: float) -> Real:
        """A component (n,) of the place (order 0), velocity or acceleration."""
        value: Any = self.state(special)[order]
        return np.asarray(value.real if axis == "x" else value.imag) * factor
