"""Checks of ``[[springs]]``: links, ends, and the keys of the kind."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.linkage.tables.checks import places
from tmmcalc.linkage.tables.checks.joints import known_links
from tmmcalc.spec.dimensions import DIMENSIONS
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline, Raw, tables, word
from tmmcalc.spec.phrases import Path, show
from tmmcalc.spec.units import dimension_of

# Keys that only the other kind of spring has.
_FOREIGN = {"linear": ("free_angle",), "torsion": ("points", "free_length")}
_FREE = {"linear": ("free_length", "200 mm"), "torsion": ("free_angle", "30 deg")}
_DIMENSIONS = {
    "linear": {"stiffness": "stiffness", "damping": "damping"},
    "torsion": {"stiffness": "torsional stiffness", "damping": "torsional damping"},
}


def check_names(outline: Outline) -> Iterator[Finding]:
    """Every spring has a name of its own."""
    yield from places.check_names(outline, tables(outline.document, "springs"), "springs", "spring")


def check_ends(outline: Outline) -> Iterator[Finding]:
    """A spring joins two different links that exist, at points that they have."""
    for index, spring in tables(outline.document, "springs"):
        path: Path = ("springs", index)
        links, points = spring.get("links"), spring.get("points")
        if not isinstance(links, list) or len(links) != 2:
            continue
        if links[0] == links[1]:
            yield Finding(
                (*path, "links"),
                f"{show(links)} is one link twice; a spring joins two different links",
                f"the links are: {known_links(outline)}",
            )
            continue
        for place, link in enumerate(links):
            yield from places.check_link(outline, link, (*path, "links", place))
            if isinstance(points, list) and len(points) == 2:
                yield from places.check_point(outline, link, points[place], (*path, "points", place))


def check_kinds(outline: Outline) -> Iterator[Finding]:
    """A spring has the keys of its kind, in their dimensions, and does something."""
    for index, spring in tables(outline.document, "springs"):
        kind = word(spring, "kind", "linear")
        if kind in _FOREIGN:
            yield from _check_keys(spring, kind, ("springs", index))


def _check_keys(spring: Raw, kind: str, path: Path) -> Iterator[Finding]:
    for key in _FOREIGN[kind]:
        if key in spring:
            other = "torsion" if kind == "linear" else "linear"
            yield Finding((*path, key), f"a {kind} spring has no {key}", f'remove it, or write kind = "{other}"')
    if kind == "linear" and "points" not in spring:
        yield Finding(path, "missing key: a linear spring has an end on each link", 'add points = ["B", [0.1, 0.2]]')
    if not {"stiffness", "damping"} & {*spring}:
        example = DIMENSIONS[_DIMENSIONS[kind]["stiffness"]].example
        yield Finding(path, "missing key: stiffness or damping", f'add stiffness = "{example}"')
    free, example = _FREE[kind]
    if spring.get("stiffness") and free not in spring:
        what = "length" if kind == "linear" else "angle"
        yield Finding(path, f"missing key: a spring needs its {what} without load", f'add {free} = "{example}"')
    for key, needed in _DIMENSIONS[kind].items():
        written = dimension_of(spring.get(key))
        if written in [dimensions[key] for dimensions in _DIMENSIONS.values()] and written != needed:
            yield Finding(
                (*path, key),
                f"{show(spring[key])} is {DIMENSIONS[written].noun}; a {kind} spring has {DIMENSIONS[needed].noun}",
                f'write {DIMENSIONS[needed].noun}, such as "{DIMENSIONS[needed].example}"',
            )


CHECKS = (check_names, check_ends, check_kinds)
