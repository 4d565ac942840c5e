"""Checks of ``[[loads]]``: names, links, points, and the one law of each load."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.linkage.loadlaws import laws
from tmmcalc.linkage.tables.checks import places
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline, Raw, tables
from tmmcalc.spec.phrases import Path, either

_OF_A_FORCE = ("point", "direction", "axes")


def check_names(outline: Outline) -> Iterator[Finding]:
    """Every load has a name of its own."""
    yield from places.check_names(outline, tables(outline.document, "loads"), "loads", "load")


def check_links(outline: Outline) -> Iterator[Finding]:
    """A load acts on a link that exists, against another one, at a point that the link has."""
    for path, load in loads(outline):
        for key in ("link", "axes", "against"):
            yield from places.check_link(outline, load.get(key), (*path, key))
        yield from places.check_point(outline, load.get("link"), load.get("point"), (*path, "point"))
        if "against" in load and load["against"] == load.get("link"):
            yield Finding(
                (*path, "against"),
                f"a load on link {load['link']} against the same link does nothing",
                "name the other link, or remove against: then the frame takes the opposite load",
            )


def check_laws(outline: Outline) -> Iterator[Finding]:
    """A load has exactly one law, and a force has a point."""
    for path, load in loads(outline):
        given = [key for key in laws() if key in load]
        if not given:
            text = f"missing key: a load has one law: {either(tuple(laws()))}"
            yield Finding(path, text, 'add force = "1500 N", for example')
        for key in given[1:]:
            yield Finding(
                (*path, key), f"{' and '.join(given)} together: a load has one law", "write one [[loads]] for each"
            )
        if len(given) == 1:
            yield from _check_kind(load, given[0], path)


def _check_kind(load: Raw, key: str, path: Path) -> Iterator[Finding]:
    law = laws()[key]
    faults = list(law.check_kind(load, key, path))
    yield from faults
    if faults:
        return
    kind = law.kind_of(load, key)
    if kind == "force" and "point" not in load:
        yield Finding(path, "missing key: a force acts at a point of its link", 'add point = "D"')
    for name in _OF_A_FORCE if kind == "moment" else ():
        if name in load:
            yield Finding((*path, name), f"a moment has no {name}", "remove it, or give a force")


def check_by_law(outline: Outline) -> Iterator[Finding]:
    """What the law of a load asks for, law by law."""
    for key, law in laws().items():
        for path, load in loads(outline):
            if key in load:
                yield from law.check(outline, load, path)


def loads(outline: Outline) -> list[tuple[Path, Raw]]:
    """Return the loads that are tables, each with its place."""
    return [(("loads", index), load) for index, load in tables(outline.document, "loads")]


CHECKS = (check_names, check_links, check_laws)
