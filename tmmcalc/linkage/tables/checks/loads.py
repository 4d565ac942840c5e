"""Checks of ``[[loads]]``: names, links and points."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.linkage.tables.checks import places
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline, Raw, tables
from tmmcalc.spec.phrases import Path


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


def loads(outline: Outline) -> list[tuple[Path, Raw]]:
    """Return the loads that are tables, each with its place."""
    return [(("loads", index), load) for index, load in tables(outline.document, "loads")]


CHECKS = (check_names, check_links)
