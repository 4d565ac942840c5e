"""What is seen of a link beside the scheme, where its axes are not: a point of it and a line that turns with it.

The point is its first pin, the line the guide along which it slides or that slides along it, else that of its first
two pins; of the crank the line that has its angle. Without a pin the point is where two lines of the link meet.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import NamedTuple

from tmmcalc.core.plane import cross
from tmmcalc.linkage.model import FRAME, Joint, Mechanism
from tmmcalc.linkage.notes.group import plain_name
from tmmcalc.linkage.pins import Pin, find_pins
from tmmcalc.linkage.structure import Structure
from tmmcalc.report.language import tr

NEAR = 1e-9  # [m] within which points are one; sine of an angle that is none


class Base(NamedTuple):
    """The point and the line of a link, in its axes."""

    name: str  # of the point
    place: complex  # [m]
    direction: complex  # unit vector of the line
    line: str  # the first two pins, in its sense, where they lie on it; else empty
    origin: str  # from what an angle is counted: "from line AB", "from the guide of link 5"
    pins: tuple[Pin, ...]  # of the joints of the link

    def angle(self, vector: complex) -> float:
        """The angle of a vector of the link from its line [deg]."""
        turned = vector / self.direction
        if abs(turned.imag) < NEAR * abs(turned):
            return 0.0 if turned.real > 0 else 180.0
        return math.degrees(math.atan2(turned.imag, turned.real))


class Seen(NamedTuple):
    """A linkage with what is seen of its links."""

    mechanism: Mechanism
    points: tuple[Pin, ...]
    bases: Mapping[int, Base]
    slotted: Mapping[int, str]  # links b of RPR groups, whose offset is that of the line from the pivot; their joints

    def rails(self, link: int) -> list[Joint]:
        """The prismatic joints of a link, that with the frame first."""
        return _rails(self.mechanism, link)

    def point_at(self, link: int, at: complex) -> Pin | None:
        """The point that lies at a place of a link, in its axes [m]."""
        return next((point for point in self.points if link in point.at and abs(point.at[link] - at) < NEAR), None)


def seen_of(mechanism: Mechanism, structure: Structure) -> Seen:
    """What is seen of a linkage."""
    points = find_pins(mechanism)
    bases = {link.id: _base(mechanism, points, link.id) for link in mechanism.links}
    slotted = {group.links[1]: group.inner[0] for group in structure.groups if group.kind == "RPR"}
    return Seen(mechanism, points, bases, slotted)


def line_on(joint: Joint, link: int) -> tuple[complex, complex]:
    """A point of the line of a prismatic joint in the axes of one of its links [m], and its unit vector."""
    side = joint.links.index(link)
    return joint.points[side], joint.directions[side]


def _rails(mechanism: Mechanism, link: int) -> list[Joint]:
    own = (joint for joint in mechanism.joints if joint.kind == "prismatic" and link in joint.links)
    return sorted(own, key=lambda joint: FRAME not in joint.links)


def _base(mechanism: Mechanism, points: Sequence[Pin], link: int) -> Base:
    pins = tuple(point for point in points if link in point.at and point.joints)
    own = _in_sense(link, pins)
    rails = _rails(mechanism, link)
    drive = mechanism.joint(mechanism.input.joint)
    if drive.kind == "revolute" and set(drive.links) == {FRAME, link}:
        direction, origin = 1 + 0j, tr("from the line that has the angle of the crank")
    elif rails:
        direction, origin = line_on(rails[0], link)[1], _from_guide(rails[0])
    elif len(own) > 1:
        vector = own[1].at[link] - own[0].at[link]
        direction, origin = vector / abs(vector), ""
    else:
        direction, origin = 1 + 0j, tr("from axis $x$ of link {link}", link=link)
    line = _pins_along(link, own[:2], direction)
    if line:
        origin = tr("from line {line}", line=line)
    return Base(*_point(points, link, own, rails), direction, line, origin, pins)


def _in_sense(link: int, pins: tuple[Pin, ...]) -> tuple[Pin, ...]:
    """The pins of a link, the second before the first where its own axis x leads from that one to this one."""
    if len(pins) > 1:
        vector = pins[1].at[link] - pins[0].at[link]
        if vector.real < 0 and abs(vector.imag) < NEAR:
            return (pins[1], pins[0], *pins[2:])
    return pins


def _from_guide(joint: Joint) -> str:
    slider, guide = joint.links
    if FRAME in joint.links:
        return tr("from the guide of link {link}", link=joint.other(FRAME))
    return tr("from the guide of link {link} on link {other}", link=slider, other=guide)


def _pins_along(link: int, own: Sequence[Pin], direction: complex) -> str:
    """Two pins of a link in the order in which a line through both leads; empty where it does not."""
    if len(own) < 2:
        return ""
    first, second = own
    vector = (second.at[link] - first.at[link]) / direction
    if abs(vector.imag) > NEAR:
        return ""
    names = [plain_name(first.name), plain_name(second.name)]
    return "".join(names if vector.real > 0 else reversed(names))


def _point(points: Sequence[Pin], link: int, own: Sequence[Pin], rails: Sequence[Joint]) -> tuple[str, complex]:
    """The first pin; without one the point where two lines of the link meet, or one of its only line."""
    if own:
        return plain_name(own[0].name), own[0].at[link]
    if not rails:
        return f"O{link}", 0j
    place, e = line_on(rails[0], link)
    for other in rails[1:]:
        q, d = line_on(other, link)
        if abs(cross(e, d)) > NEAR:
            place += e * float(cross(q - place, d) / cross(e, d))
            break
    there = (point.name for point in points if link in point.at and abs(point.at[link] - place) < NEAR)
    return plain_name(next(there, f"O{link}")), place
