"""Checks of ``[[loads]]``: names, links, points, and the one law of each load."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Literal

from tmmcalc.linkage.tables.checks import places
from tmmcalc.spec.dimensions import DIMENSIONS
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline, Raw, subtable, tables
from tmmcalc.spec.phrases import Path, either, show
from tmmcalc.spec.units import dimension_of

LAWS = ("force", "moment", "polynomial", "viscous", "quadratic", "table", "indicator")
_OF_A_FORCE = ("point", "direction", "axes")
_TORSIONAL = {"viscous": "torsional damping", "quadratic": "torsional quadratic damping"}
_AGAINST_MOTION = {"viscous": "damping", "quadratic": "quadratic damping"}


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
        laws = [law for law in LAWS if law in load]
        if not laws:
            yield Finding(path, f"missing key: a load has one law: {either(LAWS)}", 'add force = "1500 N", for example')
        for law in laws[1:]:
            yield Finding(
                (*path, law), f"{' and '.join(laws)} together: a load has one law", "write one [[loads]] for each"
            )
        if len(laws) == 1:
            yield from _check_kind(load, laws[0], path)


def _check_kind(load: Raw, law: str, path: Path) -> Iterator[Finding]:
    if law == "polynomial" and isinstance(load[law], dict) and len({"force", "moment"} & {*load[law]}) != 1:
        both = "force" in load[law]
        yield Finding(
            (*path, law),
            "force and moment together: a load is one of them" if both else "missing key: force or moment",
            "write one [[loads]] for each" if both else "write polynomial = { force = [0, 250, -12.5] }",
        )
    kind = kind_of(load, law)
    if kind == "force" and "point" not in load:
        yield Finding(path, "missing key: a force acts at a point of its link", 'add point = "D"')
    if kind != "moment":
        return
    if law in _TORSIONAL and "point" in load:
        needed = DIMENSIONS[_AGAINST_MOTION[law]]
        yield Finding(
            (*path, law),
            f"{show(load[law])} is {DIMENSIONS[_TORSIONAL[law]].noun}, but the load has a point, so it is a force",
            f'write {needed.noun}, such as "{needed.example}", or remove point',
        )
        return
    for key in _OF_A_FORCE:
        if key in load:
            yield Finding((*path, key), f"a moment has no {key}", "remove it, or give a force")


def kind_of(load: Raw, law: str) -> Literal["force", "moment"] | None:
    """Return whether the law of a raw load is a force or a moment; None if that cannot be read."""
    if law in ("force", "indicator"):
        return "force"
    if law == "moment":
        return "moment"
    if law in _TORSIONAL:
        dimension = dimension_of(load[law])
        if dimension in (None, _AGAINST_MOTION[law]):
            return "force" if "point" in load or dimension else "moment"
        return "moment" if dimension == _TORSIONAL[law] else None
    values = {"force", "moment"} & {*subtable(load, law)}
    return None if len(values) != 1 else "force" if "force" in values else "moment"


def loads(outline: Outline) -> list[tuple[Path, Raw]]:
    """Return the loads that are tables, each with its place."""
    return [(("loads", index), load) for index, load in tables(outline.document, "loads")]


CHECKS = (check_names, check_links, check_laws)
