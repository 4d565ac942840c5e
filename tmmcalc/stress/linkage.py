"""Ladder of a linkage: one length is changed until the transmission fails."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from typing import Any

from tmmcalc.spec.units import UnitError, parse
from tmmcalc.stress.limits import limit_of
from tmmcalc.stress.scene import (
    DISTANCES,
    OWN_TWIN,
    Climb,
    Document,
    Scene,
    Step,
    by_regularity,
    changed,
    lacking,
    regularity_with,
)

FACTORS = (1.05, 1.15, 1.3, 1.5, 1.75, 2.0, 2.5, 3.0, 4.0, 6.0, 10.0)  # of a length, outward; and their inverses

Change = tuple[str | int, ...]  # the path of a length in the document


def dead_point(scene: Scene) -> Climb:
    """One length is varied until the transmission fails; the one that is nearest to it."""
    if not scene.has("kinematics"):
        raise lacking("the scene has no linkage")
    path, place, limit = _nearest(scene)

    def steps() -> Iterator[Step]:
        for left in DISTANCES:
            factor = limit + (1.0 - limit) * left
            told = f"{left:g} left, x {factor:.13g}"
            yield Step(told, left, _with(scene.document, path, place, factor), by_regularity)

    title = f"toward a dead point: {_name(scene.document, path)} to {limit:.9g} times its length"
    return Climb(title, "1/regularity", OWN_TWIN, steps())


def _nearest(scene: Scene) -> tuple[Change, Any, float]:
    """Path and value of the length whose change ends the motion first, and the factor that does."""
    found: list[tuple[float, Change, Any, float, float]] = []
    for path, value in _lengths(scene.document):
        for outward in (True, False):
            bracket = _bracket(scene, path, value, outward, min((each[0] for each in found), default=math.inf))
            if bracket is not None:
                found.append((abs(math.log(bracket[1])), path, value, *bracket))
    if not found:
        raise lacking(f"no length leads to a dead point within a factor of {FACTORS[-1]:g}")
    _, path, value, good, bad = min(found, key=lambda each: each[0])
    limit = limit_of(lambda factor: regularity_with(scene, _with(scene.document, path, value, factor)), good, bad)
    return path, value, limit


def _bracket(scene: Scene, path: Change, value: Any, outward: bool, within: float) -> tuple[float, float] | None:
    """The last factor that moves and the first that does not, if it is nearer than what is known."""
    good = 1.0
    for size in FACTORS:
        factor = size if outward else 1 / size
        if abs(math.log(factor)) >= within:
            return None
        if regularity_with(scene, _with(scene.document, path, value, factor)) is None:
            return good, factor
        good = factor
    return None


def _lengths(document: Mapping[str, Any]) -> Iterator[tuple[Change, Any]]:
    """Second points of links that have their first in the origin: the lengths of the links."""
    for k, link in enumerate(document["mechanism"].get("links", ())):
        points = link.get("points", {})
        for name, place in list(points.items())[1:]:
            if isinstance(place, list | dict) and _size(place) > 0:
                yield ("mechanism", "links", k, "points", name), place


def _size(place: Any) -> float:
    parts = [place["length"]] if isinstance(place, dict) else place
    try:
        return math.hypot(*(parse(part, "length") for part in parts))
    except UnitError:
        return 0.0


def _with(document: Mapping[str, Any], path: Change, place: Any, factor: float) -> Document:
    """The document with a point that many times as far from the link's origin."""
    if isinstance(place, dict):
        longer: Any = {**place, "length": f"{parse(place['length'], 'length') * factor!r} m"}
    else:
        longer = [parse(part, "length") * factor for part in place]
    return changed(document, *path, to=longer)


def _name(document: Mapping[str, Any], path: Change) -> str:
    link = document["mechanism"]["links"][path[2]]
    return f"length to {path[-1]} of link {link['id']}"
