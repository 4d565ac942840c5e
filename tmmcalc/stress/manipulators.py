"""Ladder of a manipulator: its path is led toward a place where the joints lose a degree of freedom.

Two links lose it where they are in line, so the forearm gets shorter until they just reach; every other arm with its
gripper over the shoulder, so the path is moved there.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from tmmcalc.pipeline.outcome import RunResult
from tmmcalc.spec.units import parse
from tmmcalc.stress.limits import limit_of
from tmmcalc.stress.scene import DISTANCES, OWN_TWIN, Climb, Document, Scene, Step, changed, lacking

SHORTEST = 1e-3  # of the forearm
ENDS = ("start", "end", "via")


def singular(scene: Scene) -> Climb:
    """The way leads ever nearer to a singular place; obstacles and ranges of the joints are left out."""
    if not scene.has("manipulator"):
        raise lacking("the scene has no manipulator")
    if not scene.base.results["manipulator"].inverse:
        raise lacking("the joints of the manipulator are led, which they can be everywhere")
    kept = {key: value for key, value in scene.document["manipulator"].items() if key not in ("limits", "obstacles")}
    document = {**scene.document, "manipulator": kept}
    return _stretched(scene, document) if kept["arm"] == "angular" else _moved(scene, document)


def _stretched(scene: Scene, document: Document) -> Climb:
    length = parse(document["manipulator"]["forearm"], "length")

    def of(factor: float) -> Document:
        return changed(document, "manipulator", "forearm", to=f"{length * factor!r} m")

    def regular(factor: float) -> float | None:
        return _regularity(scene.run(of(factor), "manipulator"))

    limit = limit_of(regular, 1.0, SHORTEST)

    def steps() -> Iterator[Step]:
        for left in DISTANCES:
            factor = limit + (1.0 - limit) * left
            yield Step(f"{left:g} left, x {factor:.13g}", left, of(factor), by_arm)

    title = f"toward arms in line: forearm to {limit:.9g} times its length"
    return Climb(title, "1/sine of the elbow", OWN_TWIN, steps())


def _moved(scene: Scene, document: Document) -> Climb:
    found = scene.base.results["manipulator"]
    places = found.gripper[0]
    away = places.copy()
    if found.arm.spatial:
        away[2] = 0.0
    else:
        away[1] -= found.arm.height
    nearest = away[:, (away**2).sum(axis=0).argmin()]

    def steps() -> Iterator[Step]:
        for left in DISTANCES:
            by = [-(1.0 - left) * part for part in nearest.tolist()]
            path = _shifted(document["manipulator"]["path"], by)
            told = changed(document, "manipulator", "path", to=path)
            yield Step(f"{left:g} left", left, told, by_arm)

    return Climb("toward the shoulder: the path moved there", "size of the path/distance", OWN_TWIN, steps())


def _shifted(path: Mapping[str, Any], by: list[float]) -> Document:
    """The path with all its points moved."""

    def point(place: list[Any]) -> list[float]:
        return [parse(part, "length") + move for part, move in zip(place, by, strict=True)]

    found = {key: point(value) if key in ENDS else value for key, value in path.items()}
    return {**found, "points": [point(place) for place in path["points"]]} if "points" in path else found


def _regularity(result: RunResult) -> float | None:
    """The least relative distance from a singular place, 1 far from all; None where the way cannot be gone."""
    if "manipulator" not in result.outcomes:
        return None
    return min((place.relative for place in result.results["manipulator"].singular), default=1.0)


def by_arm(result: RunResult) -> float | None:
    """Amplification of the gripper's rates in the joints; of a singular place that which the program refuses."""
    least = _regularity(result)
    if least is None:
        error = result.failures.get("manipulator")
        least = abs(error.value) if error is not None and error.value else None
    return 1 / least if least else None
