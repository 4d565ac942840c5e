"""Ladders of a machine: stiffness of a shaft, lag and slip of the motor, inertia."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from math import sqrt

from tmmcalc.spec.units import parse
from tmmcalc.stress.scene import OWN_TWIN, Climb, Scene, Step, always, changed, decades, lacking

STIFFNESSES = decades(2, 10)  # [N*m/rad]
LAGS = decades(0, -9, -1)  # [s]
SLIPS = decades(-1, -6, -1)
RATIOS = (1.0, *decades(-1, -9, -2), *decades(1, 9, 2))  # of inertia to that of the scene


def stiffness(scene: Scene) -> Climb:
    """The first elastic shaft, from soft to all but rigid."""
    shafts = scene.document.get("shafts", ())
    soft = [k for k, shaft in enumerate(shafts) if "stiffness" in shaft]
    if not soft or not scene.has("transient"):
        raise lacking("the scene has no elastic shaft in a motion in time")
    steps = _row(scene, ("shafts", soft[0], "stiffness"), STIFFNESSES, "N*m/rad", lambda c: sqrt(c / STIFFNESSES[0]))
    name = shafts[soft[0]].get("name", f"shaft {soft[0] + 1}")
    return Climb(f"stiffness of {name}", "frequency over that of the softest", OWN_TWIN, steps)


def lag(scene: Scene) -> Climb:
    """The electromagnetic time constant of the motor."""
    if not (scene.has("motion") or scene.has("transient")) or "time_constant" not in scene.document.get("motor", {}):
        raise lacking("the motor of the scene has no time constant")
    cycle = scene.fact("power", "cycle_time") or 1.0
    steps = _row(scene, ("motor", "time_constant"), LAGS, "s", lambda lag: cycle / lag)
    return Climb("time constant of the motor", "cycle over time constant", OWN_TWIN, steps)


def slip(scene: Scene) -> Climb:
    """The rated slip of an induction motor: how steep its characteristic is."""
    motor = scene.document.get("motor", {})
    if not {"synchronous_speed", "speed"} <= set(motor) or not scene.has("motion"):
        raise lacking("the scene has no motor whose slip is given, or no motion with it")
    synchronous = parse(motor["synchronous_speed"], "angular speed")

    def steps() -> Iterator[Step]:
        for part in SLIPS:
            document = changed(scene.document, "motor", "speed", to=f"{synchronous * (1 - part)!r} rad/s")
            yield Step(f"slip {part:g}", part, document, always(1 / part))

    return Climb("rated slip of the motor", "1/slip", OWN_TWIN, steps())


def inertia(scene: Scene) -> Climb:
    """The constant moment of inertia, or else the mass of the heaviest link, by factors."""
    document = scene.document
    if not scene.has("motion") and not scene.has("forces"):
        raise lacking("the scene has neither forces nor a motion with inertia")
    if scene.has("motion") and document.get("motion", {}).get("inertia"):
        size = parse(document["motion"]["inertia"], "inertia")
        return _inertia(scene, ("motion", "inertia"), size, "constant inertia", "kg*m^2")
    masses = [
        (parse(link["mass"], "mass"), k)
        for k, link in enumerate(document.get("mechanism", {}).get("links", ()))
        if link.get("mass")
    ]
    if not masses:
        raise lacking("the scene has neither a constant inertia nor masses")
    mass, k = max(masses)
    name = f"mass of link {document['mechanism']['links'][k]['id']}"
    return _inertia(scene, ("mechanism", "links", k, "mass"), mass, name, "kg")


def _inertia(scene: Scene, path: Sequence[str | int], size: float, name: str, unit: str) -> Climb:
    def steps() -> Iterator[Step]:
        for ratio in RATIOS:
            document = changed(scene.document, *path, to=f"{size * ratio!r} {unit}")
            yield Step(f"x {ratio:g}", ratio, document, always(max(ratio, 1 / ratio)))

    return Climb(f"inertia ratio: {name}", "ratio or its inverse", OWN_TWIN, steps())


def _row(
    scene: Scene, path: Sequence[str | int], sizes: Sequence[float], unit: str, condition: Callable[[float], float]
) -> Iterator[Step]:
    for size in sizes:
        document = changed(scene.document, *path, to=f"{size!r} {unit}")
        yield Step(f"{size:g} {unit}", size, document, always(condition(size)))
