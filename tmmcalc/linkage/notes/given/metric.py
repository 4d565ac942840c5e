"""The metric of a linkage for the task: points of the frame, distances of pins, guides and points by what is seen."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import combinations

from tmmcalc.core.plane import cross
from tmmcalc.linkage.model import FRAME, Joint, Mechanism, Output
from tmmcalc.linkage.notes.given.bases import NEAR, Base, Seen, line_on
from tmmcalc.linkage.notes.group import guide_name, plain_name
from tmmcalc.linkage.pins import Pin
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Datum

SIDES = 3  # pins of a link up to which all distances are given


def metric(seen: Seen, *, centres: bool) -> Iterator[Datum]:
    """The frame, then every link: its pins, its guides, its further points, centres of mass among them or not."""
    yield from _frame(seen)
    for link, base in seen.bases.items():
        for first, second in _distances(base.pins):
            apart = abs(second.at[link] - first.at[link])
            yield distance(plain_name(first.name), plain_name(second.name), apart)
        if not base.line:
            for pin in base.pins:
                if plain_name(pin.name) != base.name:
                    yield from _turned(link, base, plain_name(pin.name), pin.at[link])
        for joint in seen.rails(link):
            yield from _guide(seen, link, joint)
        for point in seen.points:
            if [*point.at] == [link] and not point.joints and (centres or not point.centre):
                yield from place(seen, link, plain_name(point.name), point.at[link])


def _frame(seen: Seen) -> Iterator[Datum]:
    """Points of the frame, and the guides on it."""
    for point in seen.points:
        if point.fixed:
            name = plain_name(point.name)
            yield coordinates(tr("coordinates of point {point}", point=name), name, point.at[FRAME])
    for joint in seen.mechanism.joints:
        if joint.kind == "prismatic" and FRAME in joint.links:
            link, (at, direction) = joint.other(FRAME), line_on(joint, FRAME)
            said = tr("coordinates of a point of the guide of link {link}", link=link)
            yield coordinates(said, guide_name(seen.points, joint), at)
            angle = degrees(direction)
            yield Datum(tr("angle of the guide of link {link}", link=link), (f"gamma_{link}",), (angle,), "deg")


def coordinates(said: str, name: str, at: complex) -> Datum:
    """A point of the fixed plane [m]."""
    return Datum(said, (f"x_{{{name}}}", f"y_{{{name}}}"), (at.real, at.imag), "m")


def distance(first: str, second: str, apart: float) -> Datum:
    """The distance of two points [m]."""
    said = tr("distance between points {first} and {second}", first=first, second=second)
    return Datum(said, (f"l_{{{first}{second}}}",), (apart,), "m")


def coordinate_said(mechanism: Mechanism, output: Output) -> str:
    """The coordinate of an output in words, with its own name where it has one."""
    if output.point is not None:
        said = tr("coordinate of point {point}", point=output.point)
    elif output.link is not None:
        said = tr("angle of link {link}", link=output.link)
    else:
        slider = mechanism.joint(output.joint or "").links[0]
        said = tr("coordinate of link {link} along its guide", link=slider)
    return said if output.label is None else f"{said} {tr('“{name}”', name=output.label)}"


def degrees(direction: complex) -> float:
    """The angle [deg] of a vector from axis x."""
    return math.degrees(math.atan2(direction.imag, direction.real))


def _distances(pins: Sequence[Pin]) -> Iterator[tuple[Pin, Pin]]:
    """The pins between which distances are given: all of a triangle, those to the first two of more."""
    for first, second in combinations(pins, 2):
        if len(pins) <= SIDES or first in pins[:2]:
            yield first, second


def place(seen: Seen, link: int, name: str, at: complex) -> Iterator[Datum]:
    """A point of a link, in its axes [m]: its distance from the point of the link, and the angle there."""
    base = seen.bases[link]
    vector = at - base.place
    if abs(vector) < NEAR:
        if name != base.name:
            said = tr("point {point} of link {link}", point=name, link=link)
            yield Datum(said, text=tr("in point {point}", point=base.name))
    elif base.line and base.angle(vector) == 0.0:
        said = tr("distance between points {first} and {second}, along line {line}",
                  first=base.name, second=name, line=base.line)  # fmt: skip
        yield Datum(said, (f"l_{{{base.name}{name}}}",), (abs(vector),), "m")
    else:
        yield distance(base.name, name, abs(vector))
        yield from _turned(link, base, name, at)


def _turned(link: int, base: Base, name: str, at: complex) -> Iterator[Datum]:
    """The angle of a point of a link [m] about the point of the link."""
    said = tr("angle of point {point} on link {link} about {pivot}, {origin}",
              point=name, link=link, pivot=base.name, origin=base.origin)  # fmt: skip
    yield Datum(said, (f"alpha_{{{name}}}",), (base.angle(at - base.place),), "deg")


def _guide(seen: Seen, link: int, joint: Joint) -> Iterator[Datum]:
    """The line of a prismatic joint on a link: its angle and its offset from the point of the link, or in words."""
    base, (at, direction) = seen.bases[link], line_on(joint, link)
    said, carries = _line_said(joint, link), joint.links[1] == link
    if (same := _coincident(seen, link, joint)) is not None:
        slider, guide = same.links
        along = tr("along the guide of link {link} on link {other}", link=slider, other=guide)
        yield Datum(said, text=tr("along the guide of link {link}", link=slider) if guide == FRAME else along)
        return
    left = float(cross(direction, base.place - at))
    turn = base.angle(direction)
    straight, through = turn == 0.0, abs(left) < NEAR
    if not straight:
        said_angle = tr("{line}: angle {origin}", line=said, origin=base.origin)
        yield Datum(said_angle, (_key(seen, "delta", link, joint),), (turn,), "deg")
    elif base.line:
        along = tr("along line {line}", line=base.line)
        yield Datum(said, text=along if through else tr("parallel to line {line}", line=base.line))
    if not through:
        behind = seen.slotted.get(link) == joint.name
        said_offset = (
            tr("{line}: its distance from point {point}, positive to the left", line=said, point=base.name)
            if behind
            else tr("{line}: distance of point {point} from it, positive to the left", line=said, point=base.name)
        )
        yield Datum(said_offset, (_key(seen, "h", link, joint),), (-left if behind else left,), "m")
    elif not (straight and base.line) and (carries or not straight or not base.pins):
        yield Datum(said, text=tr("through point {point}", point=base.name))


def _line_said(joint: Joint, link: int) -> str:
    """The line of a prismatic joint as it lies on one of its links."""
    slider, guide = joint.links
    if guide == link:
        return tr("guide of link {link} on link {other}", link=slider, other=guide)
    if FRAME in joint.links:
        return tr("line of link {link} along its guide", link=link)
    return tr("line of link {link} along its guide on link {other}", link=slider, other=guide)


def _coincident(seen: Seen, link: int, joint: Joint) -> Joint | None:
    """The first prismatic joint of a link that has the same line on it, if it is not this one."""
    at, direction = line_on(joint, link)
    for other in seen.rails(link):
        if other is joint:
            return None
        q, d = line_on(other, link)
        if abs(direction - d) < NEAR and abs(cross(d, at - q)) < NEAR:
            return other
    return None


def _key(seen: Seen, letter: str, link: int, joint: Joint) -> str:
    """A letter with the number of the link; with both numbers of the pair where the link has several lines so told."""
    lines = [rail for rail in seen.rails(link) if _coincident(seen, link, rail) is None]
    return f"{letter}_{link}" if len(lines) <= 2 else f"{letter}_{{{''.join(map(str, joint.links))}}}"


def counted(seen: Seen, joint: Joint) -> Iterator[Datum]:
    """From where to where the coordinate of a prismatic joint is counted, along its guide."""
    slider = joint.links[0]
    (second, further), (first, more) = _end(seen, joint, 0), _end(seen, joint, 1)
    said = tr("coordinate of link {link} along its guide", link=slider)
    text = tr("from point {first} to point {second}", first=first, second=second)
    yield Datum(said, (f"s_{slider}",), text=text)
    yield from (*more, *further)


def _end(seen: Seen, joint: Joint, side: int) -> tuple[str, Sequence[Datum]]:
    """The point of the line of a joint on one of its links; where it lies if no other point is there."""
    link, at = joint.links[side], joint.points[side]
    name = guide_name(seen.points, joint)
    if link == FRAME:
        return name, ()
    known = seen.point_at(link, at)
    if known is not None:
        return plain_name(known.name), ()
    if abs(seen.bases[link].place - at) < NEAR:
        return seen.bases[link].name, ()
    return f"{name}{link}", (*place(seen, link, f"{name}{link}", at),)
