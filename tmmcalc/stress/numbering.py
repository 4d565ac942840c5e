"""Ladders that change only how positions are counted: how many, where the first one is, in which direction.

The mechanics stays what it is, so whatever differs is lost by the arithmetic, or by a rule that knows of the grid.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator

from tmmcalc.stress.compare import Alignment
from tmmcalc.stress.mirror import mirrored
from tmmcalc.stress.scene import Climb, Document, Scene, Step, always, by_regularity, changed, lacking

POSITIONS = (12, 24, 72, 360, 3600, 36_000, 360_000, 1_000_000)
FEWEST = 4
CAM_STEPS = (2, 4, 12, 36, 360, 3600, 36_000, 100_000)  # of each moving phase
ANGLES = 12  # first positions over a turn


def positions(scene: Scene) -> Climb:
    """The same quarters of the turn on ever finer grids; of a cam alone rows of its phases."""
    if not scene.has("kinematics") and scene.has("cam_law"):
        return _cam_positions(scene)
    document = _even(scene)
    fewest = changed(document, "mechanism", "grid", "positions", to=FEWEST)
    known = scene.run(fewest)

    def steps() -> Iterator[Step]:
        yield Step(f"{FEWEST} positions", FEWEST, fewest, always(float(FEWEST)), Alignment())
        for count in POSITIONS:
            yield Step(
                f"{count} positions",
                count,
                changed(document, "mechanism", "grid", "positions", to=count),
                always(float(count)),
                Alignment(label=_finer(count // FEWEST)),
                known,
            )

    return Climb("positions over the cycle", "positions", f"the same places on {FEWEST} positions", steps())


def _cam_positions(scene: Scene) -> Climb:
    """What a cam's stages tell apart from their rows does not know of these."""
    cam = {key: value for key, value in scene.document["cam"].items() if key != "step"}

    def steps() -> Iterator[Step]:
        for count in CAM_STEPS:
            document = {**scene.document, "cam": {**cam, "steps": count}}
            yield Step(f"{count} steps of each phase", count, document, always(float(count)), Alignment())

    return Climb("rows of the cam's phases", "steps", "the scene as it is: what is told beside its rows", steps())


def start_angle(scene: Scene) -> Climb:
    """Position 0 anywhere: the same positions under other numbers."""
    document = _even(scene)
    if _counted(document):
        raise lacking("loads, or paths, are counted from position 0, and change with it")
    result = scene.base.results["kinematics"]
    if not result.turns:
        raise lacking("the input is a driven slider")
    first = float(result.x[0])
    count = len(result.labels) - 1
    fixed = changed(document, "mechanism", "grid", "positions", to=count)

    def steps() -> Iterator[Step]:
        for k in range(0, count, max(count // ANGLES, 1)):
            angle = first + math.copysign(2 * math.pi * k / count, result.speed)
            told = _sketch_kept(changed(fixed, "mechanism", "input", "start", to=f"{angle!r} rad"), first)
            yield Step(
                f"start {math.degrees(angle):.6g} deg",
                math.degrees(angle),
                told,
                by_regularity,
                Alignment(label=_counted_from(k), shifted=True),
            )

    return Climb("first position over the turn", "1/regularity", "the same positions of the scene as it is", steps())


def _finer(parts: int) -> Callable[[int, int], int]:
    """Where a position stands on a grid whose steps are parts of those of the first."""
    return lambda at, _: at * parts


def _counted_from(k: int) -> Callable[[int, int], int]:
    """Where a position stands if position 0 is the one that was ``k``."""
    return lambda at, count: (at - k) % count


def _sketch_kept(document: Document, first: float) -> Document:
    """The sketch stays that of the place where it was read."""
    return changed(document, "mechanism", "assembly", "at", to=f"{first!r} rad") if _sketched(document) else document


def _sketched(document: Document) -> bool:
    assembly = document["mechanism"].get("assembly", {})
    return bool(assembly) and "at" not in assembly


def direction(scene: Scene) -> Climb:
    """The scene in a mirror: all turns the other way round."""
    if not scene.has("kinematics") and not scene.has("cam_law"):
        raise lacking("the scene has neither a linkage nor a cam")
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
    timed = any("at" in path for path in document.get("paths", ()))
    return timed or any(key in load for load in loads for key in named) or "cam" in document
