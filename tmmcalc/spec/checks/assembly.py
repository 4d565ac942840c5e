"""Checks of ``[mechanism.assembly]``: the sketch and the variants name what exists."""

from __future__ import annotations

import re
from collections.abc import Iterator

from tmmcalc.spec.findings import Finding
from tmmcalc.spec.phrases import Path, did_you_mean, listing, show

from .outline import FRAME, Outline, is_integer, subtable

_PAIR = re.compile(r"([0-9]{1,9})-([0-9]{1,9})")


def check_sketch(outline: Outline) -> Iterator[Finding]:
    """A sketch places points that exist."""
    sketch = subtable(subtable(outline.table, "assembly"), "sketch")
    if None in outline.points.values() or not outline.ids_complete:
        return
    for name in sketch:
        if name not in outline.names:
            guess = did_you_mean(name, outline.names)
            yield Finding(
                ("mechanism", "assembly", "sketch", name),
                f"no link has a point {show(name)}",
                f"{guess} the points are: {listing(outline.names)}".strip(),
            )


def check_variants(outline: Outline) -> Iterator[Finding]:
    """A variant names the two joined links of a group, once, and is 1 or -1."""
    seen: dict[frozenset[int], str] = {}
    for key, value in subtable(subtable(outline.table, "assembly"), "variants").items():
        path: Path = ("mechanism", "assembly", "variants", key)
        if is_integer(value) and value not in (1, -1):
            yield Finding(path, f"{show(value)} is not a variant", "a variant is 1 or -1")
        match = _PAIR.fullmatch(key)
        if match is None:
            yield Finding(path, f"{show(key)} is not a pair of links", 'write the two links of the group: "2-3" = 1')
            continue
        links = (int(match[1]), int(match[2]))
        pair = frozenset(links)
        if pair in seen:
            yield Finding(path, f"{show(key)} is the group of '{seen[pair]}' again", "remove one of them")
        seen.setdefault(pair, key)
        yield from _check_pair(outline, links, path)


def _check_pair(outline: Outline, links: tuple[int, int], path: Path) -> Iterator[Finding]:
    if not outline.ids_complete:
        return
    moving = [id_ for id_ in outline.ids if id_ != FRAME]
    absent = [link for link in dict.fromkeys(links) if link not in moving]
    for link in absent:
        what = "the frame, link 0, belongs to no group" if link == FRAME else f"there is no link {link}"
        yield Finding(path, what, f"the moving links are: {listing(moving)}")
    if absent or not outline.joints_complete:
        return
    joined = any(joint.links and {*joint.links} == {*links} for joint in outline.joints)
    if links[0] == links[1] or not joined:
        what = "is one link twice" if links[0] == links[1] else "are not joined"
        yield Finding(
            path,
            f"links {links[0]} and {links[1]} {what}",
            "name the two links of one group, which share a joint",
        )
