"""Checks that loads and springs share: the link exists, and its point."""

from __future__ import annotations

import re
from collections.abc import Iterator

from tmmcalc.linkage.tables.checks.joints import known_links, point_remedy
from tmmcalc.linkage.tables.checks.written_linkage import FRAME, link_words, written_linkage
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.identifiers import NAME
from tmmcalc.spec.outline import Outline, Raw
from tmmcalc.spec.phrases import Path, listing, show

_CENTRE = re.compile(r"S[0-9]+")


def check_link(outline: Outline, link: object, path: Path) -> Iterator[Finding]:
    """A link of this number exists."""
    linkage = written_linkage(outline)
    known = linkage.ids_complete and isinstance(link, int) and not isinstance(link, bool)
    if known and isinstance(link, int) and link >= FRAME and link not in linkage.ids:
        yield Finding(path, f"there is no link {link}", f"the links are: {known_links(outline)}")


def check_point(outline: Outline, link: object, point: object, path: Path) -> Iterator[Finding]:
    """A named point is one of this link."""
    linkage = written_linkage(outline)
    if not isinstance(point, str) or not isinstance(link, int) or link not in linkage.ids:
        return
    if not NAME.fullmatch(point) or linkage.has_point(link, point):
        return
    remedy = point_remedy(outline, link, point)
    if _CENTRE.fullmatch(point):
        remedy = f"the points are: {listing(linkage.points[link] or ())}; a centre of mass needs the center of its link"
    yield Finding(path, f"{link_words(link)} has no point {show(point)}", remedy)


def check_names(outline: Outline, elements: list[tuple[int, Raw]], table: str, noun: str) -> Iterator[Finding]:
    """Every element of a list of tables has a name of its own, if it has one."""
    first: dict[str, int] = {}
    for index, element in elements:
        name = element.get("name")
        if not isinstance(name, str):
            continue
        if name in first:
            line = outline.at_line((table, first[name], "name"))
            yield Finding(
                (table, index, "name"),
                f"{show(name)} is already the name of another {noun}{line}",
                f"give each {noun} a name of its own",
            )
        first.setdefault(name, index)
