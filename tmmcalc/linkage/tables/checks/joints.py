"""Checks of ``[[mechanism.joints]]``: their names, their links, and the points on these links."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.linkage.tables.checks.written_linkage import FRAME, WrittenJoint, link_words, written_linkage
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline, subtable
from tmmcalc.spec.phrases import Path, listing, nearest, show


def check_names(outline: Outline) -> Iterator[Finding]:
    """Every joint has a name of its own."""
    first: dict[str, WrittenJoint] = {}
    for joint in written_linkage(outline).joints:
        if joint.name is None:
            continue
        if joint.name in first:
            line = outline.at_line((*first[joint.name].path, "name"))
            yield Finding(
                (*joint.path, "name"),
                f"{show(joint.name)} is already the name of another joint{line}",
                f'give each joint a name of its own; several joints at one pin name it with point = "{joint.name}"',
            )
        first.setdefault(joint.name, joint)


def check_links(outline: Outline) -> Iterator[Finding]:
    """A joint connects two different links that exist."""
    linkage = written_linkage(outline)
    for joint in linkage.joints:
        if joint.links is None:
            continue
        if joint.links[0] == joint.links[1]:
            yield Finding(
                (*joint.path, "links"),
                f"{list(joint.links)} is one link twice; a joint connects two different links",
                f"the links are: {known_links(outline)}",
            )
        elif linkage.ids_complete:
            yield from _absent(outline, joint, joint.links)


def _absent(outline: Outline, joint: WrittenJoint, links: tuple[int, int]) -> Iterator[Finding]:
    for place, link in enumerate(links):
        if link >= FRAME and link not in written_linkage(outline).ids:  # a negative number is a fault of its own
            yield Finding(
                (*joint.path, "links", place),
                f"there is no link {link}",
                f"the links are: {known_links(outline)}",
            )


def known_links(outline: Outline) -> str:
    """Return the numbers of all links for a remedy."""
    return listing("0 (the frame)" if id_ == FRAME else id_ for id_ in written_linkage(outline).ids)


def check_pins(outline: Outline) -> Iterator[Finding]:
    """The pin of a revolute joint is a point of both links."""
    linkage = written_linkage(outline)
    for joint in linkage.joints:
        if "point" in joint.table and "points" in joint.table and joint.kind == "revolute":
            yield Finding(
                (*joint.path, "points"),
                "point and points together: the pin is named once",
                "keep point if both links call the pin the same, points if they differ",
            )
        elif linkage.connects(joint):
            yield from _missing_pins(outline, joint)


def _missing_pins(outline: Outline, joint: WrittenJoint) -> Iterator[Finding]:
    absent = [
        (place, link, pin)
        for place, (link, pin) in enumerate(zip(joint.links or (), joint.pins or (), strict=False))
        if not written_linkage(outline).has_point(link, pin)
    ]
    if len(absent) == 2 and "points" not in joint.table:
        yield _pin_of_neither(outline, joint, absent[0][2], (absent[0][1], absent[1][1]))
        return
    for place, link, pin in absent:
        path: Path = (*joint.path, "points", place) if "points" in joint.table else _pin_path(joint)
        message = f"{link_words(link)} has no point {show(pin)}, the pin of this joint{_default(joint)}"
        yield Finding(path, message, point_remedy(outline, link, pin))


def _pin_of_neither(outline: Outline, joint: WrittenJoint, pin: str, links: tuple[int, int]) -> Finding:
    linkage = written_linkage(outline)
    a, b = links
    shared = [name for name in linkage.points.get(a) or () if name in (linkage.points.get(b) or ())]
    meant = f'did you mean point = "{shared[0]}", which both have? or ' if shared else ""
    return Finding(
        _pin_path(joint),
        f"neither {link_words(a)} nor {link_words(b)} has a point {show(pin)}, the pin of this joint{_default(joint)}",
        f"{meant}add {pin} = [x, y] to the points of both",
    )


def _pin_path(joint: WrittenJoint) -> Path:
    return (*joint.path, "point" if "point" in joint.table else "name")


def _default(joint: WrittenJoint) -> str:
    return "" if {"point", "points"} & {*joint.table} else "; without point = ... the pin has the joint's name"


def point_remedy(outline: Outline, link: int, point: str) -> str:
    """Return what to do about a point that a link has not: the nearest name, or where to add it."""
    known = list(written_linkage(outline).points.get(link) or ())
    guess = nearest(point, known)
    meant = f'did you mean "{guess}"? ' if guess else ""
    home = "[mechanism.fixed]" if link == FRAME else f"the points of link {link}"
    return f"{meant}the points of {link_words(link)} are: {listing(known)}; or add {point} = [x, y] to {home}"


def check_lines(outline: Outline) -> Iterator[Finding]:
    """The line of a prismatic joint runs through a point of its own link."""
    linkage = written_linkage(outline)
    for joint in linkage.joints:
        if joint.kind != "prismatic" or joint.links is None or not linkage.connects(joint):
            continue
        slider, guide = joint.links
        yield from _through(outline, joint, "slider", slider, guide)
        yield from _through(outline, joint, "guide", guide, slider)


def _through(outline: Outline, joint: WrittenJoint, role: str, link: int, other: int) -> Iterator[Finding]:
    linkage = written_linkage(outline)
    point = subtable(joint.table, role).get("through")
    if not isinstance(point, str) or linkage.has_point(link, point):
        return
    remedy = point_remedy(outline, link, point)
    if role == "guide" and linkage.has_point(other, point):
        remedy = f"if {link_words(other)} carries the guide, write links = [{link}, {other}], slider first"
    yield Finding(
        (*joint.path, role, "through"),
        f"{link_words(link)}, the {role} of this joint, has no point {show(point)}",
        remedy,
    )


def check_friction(outline: Outline) -> Iterator[Finding]:
    """The friction of a pin acts on its radius."""
    for joint in written_linkage(outline).joints:
        if joint.kind == "revolute" and joint.table.get("friction") and "radius" not in joint.table:
            yield Finding(
                (*joint.path, "friction"),
                "friction without radius: the moment of friction in a pin is f R r",
                'add radius = "20 mm", the radius of the pin',
            )
