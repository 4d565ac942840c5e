"""Checks of ``[[mechanism.links]]`` and of the names of points."""

from __future__ import annotations

import re
from collections.abc import Iterator

from tmmcalc.linkage.tables.checks.written_linkage import FRAME, WrittenLink, written_linkage
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline
from tmmcalc.spec.phrases import Path, show
from tmmcalc.spec.units import UnitError, parse

_CENTRE = re.compile(r"S[0-9]+")


def check_ids(outline: Outline) -> Iterator[Finding]:
    """Every link has a number of its own."""
    linkage = written_linkage(outline)
    first: dict[int, WrittenLink] = {}
    for link in linkage.links:
        if link.id is None:
            continue
        if link.id in first:
            line = outline.at_line((*first[link.id].path, "id"))
            free = max(linkage.ids) + 1
            yield Finding(
                (*link.path, "id"),
                f"id {link.id} is already the number of another link{line}",
                f"write id = {free}",
            )
        first.setdefault(link.id, link)


def check_reserved_names(outline: Outline) -> Iterator[Finding]:
    """S1, S2, ... are the centres of mass; nothing else is called so."""
    linkage = written_linkage(outline)
    yield from _reserved(linkage.table.get("fixed"), ("mechanism", "fixed"))
    for link in linkage.links:
        yield from _reserved(link.table.get("points"), (*link.path, "points"))


def _reserved(points: object, path: Path) -> Iterator[Finding]:
    for name in points if isinstance(points, dict) else ():
        if _CENTRE.fullmatch(name):
            yield Finding(
                (*path, name),
                f"{show(name)} is a reserved name: S and a number is the centre of mass of that link",
                'give the centre of mass as center = [x, y], or call the point otherwise, such as "P"',
            )


def check_masses(outline: Outline) -> Iterator[Finding]:
    """A moment of inertia belongs to a mass."""
    for link in written_linkage(outline).links:
        if "inertia" in link.table and "mass" not in link.table:
            yield Finding(
                (*link.path, "inertia"),
                "inertia without mass: a link has a mass, or a mass and a moment of inertia, or neither",
                'add mass = "... kg", or leave inertia out',
            )


def check_connected(outline: Outline) -> Iterator[Finding]:
    """Every link, and the frame, is named by some joint."""
    linkage = written_linkage(outline)
    if not (linkage.ids_complete and linkage.joints_complete):
        return
    used = {id_ for joint in linkage.joints for id_ in joint.links or ()}
    for link in linkage.links:
        if link.id not in used:
            yield Finding(
                link.path,
                f"no joint names link {link.id}",
                "add its [[mechanism.joints]], or remove the link",
            )
    if FRAME not in used:
        yield Finding(
            ("mechanism", "joints"),
            "no joint names the frame, link 0",
            "one joint at least connects a moving link with the frame: links = [0, 1]",
        )


def check_lengths(outline: Outline) -> Iterator[Finding]:
    """A link that is held by pins alone has them at two places or more."""
    linkage = written_linkage(outline)
    for link in linkage.links:
        if link.id is None:
            continue
        joints = [joint for joint in linkage.joints if joint.links and link.id in joint.links]
        pins = [pin for joint in joints if linkage.is_pinned(joint) and (pin := joint.pin_on(link.id))]
        if len(joints) < 2 or len(pins) < len(joints):
            continue
        places = [_place((link.points or {}).get(pin)) for pin in pins]
        if None not in places and len(set(places)) == 1:
            names = " and ".join(dict.fromkeys(pins))
            yield Finding(
                (*link.path, "points"),
                f"the pins {names} of link {link.id} are at one place: the link has no length",
                'give its points their distance, such as A = ["200 mm", 0]',
            )


def check_ambiguous(outline: Outline) -> Iterator[Finding]:
    """A name that stands on two moving links is one point: the pin that joins them."""
    linkage = written_linkage(outline)
    if not (linkage.ids_complete and linkage.joints_complete):
        return  # the joint that is at fault may be the one that joins them
    groups = _Groups(outline)
    jointed = {id_ for joint in linkage.joints for id_ in joint.links or ()}
    first: dict[str, int] = {}
    for link in linkage.links:
        if link.id is None or link.id not in jointed:
            continue
        for name in link.points or ():
            if _CENTRE.fullmatch(name):
                continue  # a point of this name has that fault alone
            if name in first and not groups.same((first[name], name), (link.id, name)):
                yield _ambiguous((*link.path, "points", name), name, first[name], link.id)
            first.setdefault(name, link.id)


def _ambiguous(path: Path, name: str, first: int, second: int) -> Finding:
    return Finding(
        path,
        f"{show(name)} is a point of link {first} and of link {second}, but no revolute joint makes them one",
        f"rename one of them, or add the revolute joint with links = [{first}, {second}]",
    )


class _Groups:
    """Points of links that revolute joints make one: a union-find over (link, name)."""

    def __init__(self, outline: Outline) -> None:
        linkage = written_linkage(outline)
        self.parent: dict[tuple[int, str], tuple[int, str]] = {}
        for joint in linkage.joints:
            if joint.links is None or joint.kind == "prismatic":
                continue
            a, b = joint.links
            if joint.pins and linkage.is_pinned(joint):
                self._join((a, joint.pins[0]), (b, joint.pins[1]))
                continue
            # The joint has a fault of its own; whichever pin was meant, do not report its name again.
            for name in {*(linkage.points.get(a) or ())} & {*(linkage.points.get(b) or ())}:
                self._join((a, name), (b, name))

    def same(self, a: tuple[int, str], b: tuple[int, str]) -> bool:
        return self._root(a) == self._root(b)

    def _join(self, a: tuple[int, str], b: tuple[int, str]) -> None:
        self.parent[self._root(a)] = self._root(b)

    def _root(self, node: tuple[int, str]) -> tuple[int, str]:
        while (above := self.parent.get(node, node)) != node:
            node = above
        return node


def _place(point: object) -> tuple[float, float] | None:
    if not isinstance(point, list) or len(point) != 2:
        return None
    try:
        return parse(point[0], "length"), parse(point[1], "length")
    except UnitError:
        return None
