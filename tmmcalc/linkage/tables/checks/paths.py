"""Checks of ``[[paths]]``: names, points that move, and a timing that suits points and input."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.linkage.tables.checks import places
from tmmcalc.linkage.tables.checks.input import check_coordinate
from tmmcalc.linkage.tables.checks.outputs import check_moving
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline, tables


def check_names(outline: Outline) -> Iterator[Finding]:
    """Every path has a name of its own."""
    yield from places.check_names(outline, tables(outline.document, "paths"), "paths", "path")


def check_points(outline: Outline) -> Iterator[Finding]:
    """The point is one of a moving link."""
    for index, path in tables(outline.document, "paths"):
        if isinstance(path.get("point"), str):
            yield from check_moving(outline, path["point"], ("paths", index, "point"))


def check_timing(outline: Outline) -> Iterator[Finding]:
    """Every point has its input coordinate, an angle of a crank or a length of a slider."""
    for index, path in tables(outline.document, "paths"):
        through, at = path.get("through"), path.get("at")
        if not isinstance(at, list):
            continue
        if isinstance(through, list) and len(through) != len(at):
            yield Finding(
                ("paths", index, "at"),
                f"{len(at)} input coordinate{'s' if len(at) != 1 else ''}, points: {len(through)}",
                "write one for each point of through, or remove at",
            )
        for place, value in enumerate(at):
            yield from check_coordinate(outline, value, ("paths", index, "at", place))


CHECKS = (check_names, check_points, check_timing)
