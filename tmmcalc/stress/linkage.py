"""Ladders of a linkage: toward a dead point, number of positions, first position, direction of turning."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from typing import Any

from tmmcalc.spec.units import UnitError, parse
from tmmcalc.stress.compare import Alignment
from tmmcalc.stress.mirror import mirrored
from tmmcalc.stress.scene import Climb, Document, Scene, Step, always, by_regularity, changed, lacking, moves

FACTORS = (1.05, 1.15, 1.3, 1.5, 1.75, 2.0, 2.5, 3.0, 4.0, 6.0, 10.0)  # of a length, outward; and their inverses
HALVINGS = 44
DISTANCES = (1.0, 1e-1, 1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 0.0)  # parts of the way that are left
POSITIONS = (12, 24, 72, 360, 3600, 36_000, 360_000, 1_000_000)
FEWEST = 4
ANGLES = 12  # first positions over a turn

Change = tuple[str | int, ...]  # the path of a length in the document
OWN_TWIN = "the same scene in units of a third of a metre, 1/7 kg, 1/1.7 s: what the arithmetic loses"


def dead_point(scene: Scene) -> Climb:
    """One length is varied until the transmission fails; the one that is nearest to it."""
    if not scene.has("kinematics"):
        raise lacking("the scene has no linkage")
    path, points, ordinary, limit = _nearest(scene)
    name = _name(scene.document, path)

    def steps() -> Iterator[Step]:
        for left in DISTANCES:
            factor = limit + (ordinary - limit) * left
            told = f"{name} x {factor:.13g}, {left:g} of the way left"
            yield Step(told, left, changed(scene.document, *path, to=_longer(points, factor)), by_regularity)

    return Climb(f"toward a dead point: {name} to {limit:.9g} times its length", "1/regularity", OWN_TWIN, steps())


def _nearest(scene: Scene) -> tuple[Change, Any, float, float]:
    """Path, value, last factor that moves and the limit of the length whose change ends the motion first."""
    found: list[tuple[float, Change, Any, float, float]] = []
    for path, value in _lengths(scene.document):
        for outward in (True, False):
            bracket = _bracket(scene, path, value, outward, min((each[0] for each in found), default=math.inf))
            if bracket is not None:
                found.append((abs(math.log(bracket[1])), path, value, *bracket))
    if not found:
        raise lacking(f"no length leads to a dead point within a factor of {FACTORS[-1]:g}")
    _, path, value, good, bad = min(found, key=lambda each: each[0])
    return path, value, 1.0, _bisected(scene, path, value, good, bad)


def _bracket(scene: Scene, path: Change, value: Any, outward: bool, within: float) -> tuple[float, float] | None:
    """The last factor that moves and the first that does not, if it is nearer than what is known."""
    good = 1.0
    for size in FACTORS:
        factor = size if outward else 1 / size
        if abs(math.log(factor)) >= within:
            return None
        if moves(scene, changed(scene.document, *path, to=_longer(value, factor))) is None:
            return good, factor
        good = factor
    return None


def _bisected(scene: Scene, path: Change, value: Any, good: float, bad: float) -> float:
    for _ in range(HALVINGS):
        middle = (good + bad) / 2
        if moves(scene, changed(scene.document, *path, to=_longer(value, middle))) is None:
            bad = middle
        else:
            good = middle
    return bad


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


def _longer(place: Any, factor: float) -> Any:
    if isinstance(place, dict):
        return {**place, "length": f"{parse(place['length'], 'length') * factor!r} m"}
    return [parse(part, "length") * factor for part in place]


def _name(document: Mapping[str, Any], path: Change) -> str:
    link = document["mechanism"]["links"][path[2]]
    return f"length to {path[-1]} of link {link['id']}"


def positions(scene: Scene) -> Climb:
    """The same quarters of the turn on ever finer grids."""
    document = _even(scene)
    fewest = scene.run(changed(document, "mechanism", "grid", "positions", to=FEWEST))

    def steps() -> Iterator[Step]:
        for count in POSITIONS:
            part = count // FEWEST
            yield Step(
                f"{count} positions",
                count,
                changed(document, "mechanism", "grid", "positions", to=count),
                always(float(count)),
                Alignment(label=_finer(part)),
                fewest,
            )

    return Climb("positions over the cycle", "positions", f"the same places on {FEWEST} positions", steps())


def start_angle(scene: Scene) -> Climb:
    """Position 0 anywhere: the same positions under other numbers."""
    document = _even(scene)
    if _counted(document):
        raise lacking("loads are counted from position 0, and change with it")
    result = scene.base.results["kinematics"]
    if not result.turns:
        raise lacking("the input is a driven slider")
    first = float(result.x[0])
    count = len(result.labels) - 1
    fixed = changed(document, "mechanism", "grid", "positions", to=count)

    def steps() -> Iterator[Step]:
        for k in range(0, count, max(count // ANGLES, 1)):
            angle = first + math.copysign(2 * math.pi * k / count, result.speed)
            told = _kept(changed(fixed, "mechanism", "input", "start", to=f"{angle!r} rad"), first)
            yield Step(
                f"start {math.degrees(angle):.6g} deg",
                math.degrees(angle),
                told,
                by_regularity,
                Alignment(label=_later(k), shifted=True),
            )

    return Climb("first position over the turn", "1/regularity", "the same positions of the scene as it is", steps())


def _finer(parts: int) -> Callable[[int, int], int]:
    """Where a position stands on a grid whose steps are parts of those of the first."""
    return lambda at, _: at * parts


def _later(k: int) -> Callable[[int, int], int]:
    """Where a position stands if position 0 is the one that was ``k``."""
    return lambda at, count: (at - k) % count


def _kept(document: Document, first: float) -> Document:
    """The sketch stays that of the place where it was read."""
    return changed(document, "mechanism", "assembly", "at", to=f"{first!r} rad") if _sketched(document) else document


def _sketched(document: Document) -> bool:
    assembly = document["mechanism"].get("assembly", {})
    return bool(assembly) and "at" not in assembly


def direction(scene: Scene) -> Climb:
    """The scene in a mirror: all turns the other way round."""
    if "mechanism" not in scene.document:
        raise lacking("the scene has no linkage")
    document = mirrored(scene.document)
    step = Step("mirrored", -1.0, document, by_regularity, Alignment(mirrored=True))
    return Climb(
        "direction of turning", "1/regularity", "the scene as it is, every quantity but for its sign", iter([step])
    )


def _even(scene: Scene) -> Document:
    """The document with a plain grid over a full turn."""
    if not scene.has("kinematics"):
        raise lacking("the scene has no linkage")
    grid = scene.document["mechanism"].get("grid", {})
    if any(key in grid for key in ("working", "span", "extra", "extremes")):
        raise lacking("its positions are no equal steps over a turn")
    if any(
        "positions" in load or load.get("table", {}).get("of") == "position" for load in scene.document.get("loads", ())
    ):
        raise lacking("its loads are given by numbers of positions")
    return scene.document


def _counted(document: Document) -> bool:
    loads = document.get("loads", ())
    named = ("between", "polynomial", "table", "indicator")
    return any(key in load for load in loads for key in named) or "cam" in document
