"""Ladder of units: the scene from micrometres to kilometres, with densities kept."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from typing import Any

from tmmcalc.stress.compare import Alignment
from tmmcalc.stress.quantities import rewritten
from tmmcalc.stress.scene import Climb, Document, Scene, Step, always
from tmmcalc.stress.similarity import in_units
from tmmcalc.stress.units import Factors

NUDGED = ("x1", "x2", "helix_angle", "pressure_angle", "time_ratio")
SIZES = (1.0, 0.1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 10.0, 100.0, 1e3, 1e4)
TWIN = Factors(1 / 3, 1 / 7, 1 / 1.7)


def scale(scene: Scene) -> Climb:
    """All lengths by s, masses by s^3, times kept: forces by s^4, moments by s^5, stresses by s^2."""
    document = with_sizes(scene, scene.document)
    in_units(document, TWIN)  # a scene that has no twin says so before anything runs
    beside = scene.run(document) if document is not scene.document else None

    def steps() -> Iterator[Step]:
        for size in SIZES:
            factors = Factors(size, size**3)
            yield Step(
                f"x {size:g}",
                size,
                in_units(document, factors),
                always(max(size, 1 / size)),
                Alignment(factors),
                beside,
            )

    return Climb(
        "unit scale: lengths by s, masses by s^3", "s or 1/s", "the scene as it is, every quantity by its unit", steps()
    )


def with_sizes(scene: Scene, document: Mapping[str, Any]) -> Document:
    """The document with the sizes of a cam that the program chose, which it does in whole millimetres."""
    found: Document = dict(document)
    cam = found.get("cam")
    if cam is None or cam.get("follower") == "oscillating" or not scene.has("cam_synthesis"):
        return found
    given = {"start_distance", "base_radius"} & set(cam)
    sizes = {"r2": "roller_radius", "e": "offset", **({} if given else {"S0": "start_distance"})}
    told = {key: scene.fact("cam_synthesis", name) for name, key in sizes.items()}
    missing = {key: f"{value!r} m" for key, value in told.items() if value is not None and key not in cam}
    return {**found, "cam": {**cam, **missing}} if missing else found


def twin(document: Mapping[str, Any]) -> Document:
    """The document in units that share no digits with those of the spec; what has no unit a rounding away."""
    found = in_units(document, TWIN)
    return {key: _nudged(value) if key in ("pair", "synthesis") else value for key, value in found.items()}


def _nudged(table: Mapping[str, Any]) -> Document:
    """A table with its pure numbers and angles the next to what they are."""
    return {
        key: rewritten(value, _next) if key in NUDGED else _nudged(value) if isinstance(value, dict) else value
        for key, value in table.items()
    }


def _next(value: float) -> float:
    """The next number away from zero; zero stays what it is."""
    return math.nextafter(value, math.copysign(math.inf, value)) if value else value
