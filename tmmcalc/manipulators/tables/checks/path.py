"""Checks of ``[manipulator.path]``: the keys of its kind, an arc that can be, points of as many coordinates."""

from __future__ import annotations

import math
from collections.abc import Iterator

from tmmcalc.manipulators.tables.checks.written import ROOT, written_manipulator
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline, Raw, subtable, word
from tmmcalc.spec.phrases import Path, either, show
from tmmcalc.spec.values import amount, amounts

_KEYS = {
    "arc": ("start", "end", "radius", "side", "via", "normal"),
    "line": ("start", "end"),
    "polyline": ("points", "corner_radius"),
}
_NEAR = 1e-12  # of a length: smaller differences are rounding


def check_path(outline: Outline) -> Iterator[Finding]:
    """A path has the keys of its kind, and points of as many coordinates."""
    path = subtable(written_manipulator(outline), "path")
    kind = word(path, "kind")
    if kind not in _KEYS:
        return
    at = (ROOT, "path")
    for key in path:
        owners = [other for other in _KEYS if key in _KEYS[other]]
        if owners and kind not in owners:
            yield Finding((*at, key), f"{key} belongs to {either(owners)}, this path is {kind}", "remove it")
    needed = {"arc": ("start", "end"), "line": ("start", "end"), "polyline": ("points",)}[kind]
    for key in needed:
        if key not in path:
            yield Finding(
                at,
                f"missing key: {kind} has {key}",
                f"add {key} = {'[[0, 0], [1, 1]]' if key == 'points' else '[1.2, 0.3]'}",
            )
    if kind == "arc":
        yield from _check_arc(path, at)
    yield from _check_coordinates(path, at)


def _check_arc(path: Raw, at: Path) -> Iterator[Finding]:
    """An arc is given once, and its radius spans the distance of its ends."""
    sized = [key for key in ("radius", "side") if key in path]
    if "via" in path:
        for key in (*sized, *(["normal"] if "normal" in path else [])):
            yield Finding((*at, key), f"{key} together with via: three points settle the arc", "remove one of them")
        return
    for key, example in (("radius", '"0.8 m"'), ("side", '"left"')):
        if key not in path:
            yield Finding(at, "missing key: an arc has radius and side, or via", f"add {key} = {example}")
            return
    radius, start, end = (
        amount(path["radius"], "length"),
        amounts(path.get("start"), "length"),
        amounts(path.get("end"), "length"),
    )
    if radius is None or start is None or end is None or len(start) != len(end):
        return
    half = math.dist(start, end) / 2
    if half == 0:
        yield Finding((*at, "end"), "the arc ends where it begins", "write another point")
    elif radius < half * (1 - _NEAR):
        rule = f"{show(path['radius'])} does not span the ends of the arc, which are {2 * half:.9g} m apart"
        yield Finding((*at, "radius"), rule, f'write at least "{math.ceil(half * 1e6) / 1e6:.9g} m"')


def _check_coordinates(path: Raw, at: Path) -> Iterator[Finding]:
    """All points have two coordinates, or all have three."""
    points = [((*at, key), path[key]) for key in ("start", "via", "end") if key in path]
    listed = path.get("points")
    points += [((*at, "points", k), point) for k, point in enumerate(listed if isinstance(listed, list) else ())]
    counts = [(where, len(point)) for where, point in points if isinstance(point, list)]
    for where, count in counts[1:]:
        if count != counts[0][1]:
            rule = f"{count} coordinates, and the first point has {counts[0][1]}"
            yield Finding(where, rule, "write [x, y] everywhere, or [x, y, z] for an arm with a turning base")
    if counts and counts[0][1] == 2 and "normal" in path:
        yield Finding((*at, "normal"), "normal has no effect: the path lies in the arm's plane", "remove it")


CHECKS = (check_path,)
