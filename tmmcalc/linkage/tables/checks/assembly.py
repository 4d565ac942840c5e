"""Checks of ``[mechanism.assembly]``: the sketch and the variants name what exists."""

from __future__ import annotations

import re
from collections.abc import Iterator

from tmmcalc.linkage.tables.checks.written_linkage import FRAME, written_linkage
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline, is_integer, subtable
from tmmcalc.spec.phrases import Path, did_you_mean, listing, show

_LINKS = re.compile(r"[0-9]{1,9}(-[0-9]{1,9})+")


def check_sketch(outline: Outline) -> Iterator[Finding]:
    """A sketch places points that exist."""
    linkage = written_linkage(outline)
    sketch = subtable(subtable(linkage.table, "assembly"), "sketch")
    if None in linkage.points.values() or not linkage.ids_complete:
        return
    for name in sketch:
        if name not in linkage.names:
            guess = did_you_mean(name, linkage.names)
            yield Finding(
                ("mechanism", "assembly", "sketch", name),
                f"there is no point {show(name)}",
                f"{guess} the points are: {listing(linkage.names)}".strip(),
            )


def check_variants(outline: Outline) -> Iterator[Finding]:
    """A variant names the links of a group, once; it is 1 or -1 of a dyad, 1 or more of a higher group."""
    seen: dict[frozenset[int], str] = {}
    for key, value in subtable(subtable(written_linkage(outline).table, "assembly"), "variants").items():
        path: Path = ("mechanism", "assembly", "variants", key)
        if _LINKS.fullmatch(key) is None:
            yield Finding(
                path, f"{show(key)} names no group", 'write the links of the group: "2-3" = 1, or "2-3-4-5" = 2'
            )
            continue
        links = tuple(int(link) for link in key.split("-"))
        yield from _check_value(path, value, len(links))
        if frozenset(links) in seen:
            yield Finding(path, f"{show(key)} is the group of '{seen[frozenset(links)]}' again", "remove one of them")
        seen.setdefault(frozenset(links), key)
        yield from _check_links(outline, links, path)


def _check_value(path: Path, value: object, links: int) -> Iterator[Finding]:
    if not is_integer(value):
        return
    if links == 2 and value not in (1, -1):
        yield Finding(path, f"{show(value)} is not a variant", "a variant of two links is 1 or -1")
    if links > 2 and value < 1:
        yield Finding(
            path,
            f"{show(value)} is not the number of an assembly",
            "assemblies count from 1; tmmcalc structure --assemblies lists them",
        )


def _check_links(outline: Outline, links: tuple[int, ...], path: Path) -> Iterator[Finding]:
    linkage = written_linkage(outline)
    if not linkage.ids_complete:
        return
    moving = [id_ for id_ in linkage.ids if id_ != FRAME]
    absent = [link for link in dict.fromkeys(links) if link not in moving]
    for link in absent:
        what = "the frame, link 0, belongs to no group" if link == FRAME else f"there is no link {link}"
        yield Finding(path, what, f"the moving links are: {listing(moving)}")
    if absent or not linkage.joints_complete:
        return
    remedy = "name the links of one group, which are joined to each other"
    twice = next((link for link in links if links.count(link) > 1), None)
    if twice is not None:
        yield Finding(path, f"link {twice} is named twice", remedy)
    elif not _joined(outline, links):
        yield Finding(path, f"links {listing(links)} are not joined to each other", remedy)


def _joined(outline: Outline, links: tuple[int, ...]) -> bool:
    """Whether joints among these links connect them all."""
    reached = {links[0]}
    while (
        more := {
            k
            for joint in written_linkage(outline).joints
            if joint.links and {*joint.links} <= {*links} and reached & {*joint.links}
            for k in joint.links
        }
        - reached
    ):
        reached |= more
    return reached == {*links}
