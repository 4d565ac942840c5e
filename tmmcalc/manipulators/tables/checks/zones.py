"""Checks of ``[[manipulator.obstacles]]``: outlines with an area, heights where the base turns."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.manipulators.tables.checks.written import ROOT, turns_base, written_manipulator
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline, Raw, tables
from tmmcalc.spec.phrases import Path, show
from tmmcalc.spec.values import amount, amounts

_NEAR = 1e-12  # of the square of the size: a smaller area is none


def check_obstacles(outline: Outline) -> Iterator[Finding]:
    """An obstacle has an outline with an area, and heights where the base turns."""
    table = written_manipulator(outline)
    spatial = turns_base(table)
    for k, obstacle in tables(table, "obstacles"):
        at = (ROOT, "obstacles", k)
        if ("corners" in obstacle) == ("box" in obstacle):
            rule = "corners together with box" if "box" in obstacle else "missing key: an obstacle has corners or a box"
            yield Finding(at, rule, "write corners = [[x, y], ...], or box with two opposite corners")
        yield from _check_heights(obstacle, at, spatial)
        corners = obstacle.get("box", obstacle.get("corners"))
        points = [amounts(point, "length") for point in corners] if isinstance(corners, list) else []
        flat = [complex(*point) for point in points if point is not None and len(point) == 2]
        if len(flat) == len(points) and _empty(flat, "box" in obstacle):
            key = "box" if "box" in obstacle else "corners"
            yield Finding((*at, key), "the obstacle has no area", "write corners that are not on one line")


def _check_heights(obstacle: Raw, at: Path, spatial: bool) -> Iterator[Finding]:
    for key in ("low", "high"):
        if spatial and key not in obstacle:
            yield Finding(at, f"missing key: with a turning base an obstacle has {key}", f'add {key} = "0.5 m"')
        if not spatial and key in obstacle:
            yield Finding(
                (*at, key), f"{key} has no effect: without a turning base the polygon is upright", "remove it"
            )
    low, high = (amount(obstacle.get(key), "length") for key in ("low", "high"))
    if spatial and low is not None and high is not None and not low < high:
        yield Finding((*at, "high"), f"{show(obstacle['high'])} is not above low", "write a greater height")


def _empty(corners: list[complex], box: bool) -> bool:
    if box:
        return len(corners) == 2 and ((corners[1] - corners[0]).real == 0 or (corners[1] - corners[0]).imag == 0)
    if len(corners) < 3:
        return False
    around = [*corners[1:], corners[0]]
    area = sum((a.conjugate() * b).imag for a, b in zip(corners, around, strict=True))
    size = max(abs(corner - corners[0]) for corner in corners)
    return abs(area) <= _NEAR * size * size


CHECKS = (check_obstacles,)
