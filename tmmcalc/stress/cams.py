"""Ladders of a cam: toward the cusp, where the profile gets a point and then crosses itself; toward 90 deg of pressure.

The limit of the cusp has a closed form. The working profile of a roller is the pitch curve's parallel, so the roller is
at most as large as the least radius of that curve; under a flat face the radius is S + S'' and grows with the start
distance. The pressure angle tends to 90 deg as the start distance of a stem through the cam's axis goes to zero.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

from tmmcalc.core.facts import facts
from tmmcalc.pipeline.outcome import RunResult
from tmmcalc.stress.scales import with_sizes
from tmmcalc.stress.scene import DISTANCES, OWN_TWIN, Climb, Scene, Step, always, changed, lacking

LEFT = (*DISTANCES[:-1], -1e-3)  # parts of the way to the cusp; the last is beyond it
PARTS = (1.0, 0.5, 0.2, 0.1, 1e-2, 1e-3, 1e-4)  # of the start distance
ANGLES = ("theta_rise_max", "theta_return_max")


def cusp(scene: Scene) -> Climb:
    """The radius of the roller grows to the least radius of the pitch curve; a flat face comes nearer to the axis."""
    if not scene.has("cam_profile"):
        raise lacking("the scene has no cam with a profile")
    document = with_sizes(scene, scene.document)
    flat = document["cam"].get("follower") == "flat"
    key, name = ("start_distance", "distance of the face") if flat else ("roller_radius", "radius of the roller")
    found, limit = _flat(scene) if flat else _roller(scene)

    def steps() -> Iterator[Step]:
        for left in LEFT:
            size = limit + (found - limit) * left
            told = changed(document, "cam", key, to=f"{size!r} m")
            yield Step(f"{left:g} left, {size * 1e3:.12g} mm", left, told, always(1 / abs(left)))

    return Climb(f"toward a cusp: {name} to {limit * 1e3:.9g} mm", "1/part of the way left", OWN_TWIN, steps())


def _roller(scene: Scene) -> tuple[float, float]:
    """Radius of the roller as it is, and the one that gives a cusp."""
    found, limit = scene.fact("cam_synthesis", "r2"), scene.fact("cam_profile", "roller_max")
    base = scene.fact("cam_synthesis", "R0")
    if found is None or limit is None or (base is not None and limit >= base):
        raise lacking("no roller is too large for the pitch curve before it covers the cam's axis")
    return found, limit


def _flat(scene: Scene) -> tuple[float, float]:
    """Start distance as it is, and the one that gives a cusp."""
    found, radius = scene.fact("cam_synthesis", "S0"), scene.fact("cam_profile", "rho_min")
    if found is None or radius is None or radius >= found:
        raise lacking("the face reaches the cam's axis before any cusp")
    return found, found - radius


def pressure(scene: Scene) -> Climb:
    """The sizes of a cam with a stem shrink; a profile that is undercut on the way is told and not refused."""
    if not scene.has("cam_pressure"):
        raise lacking("the scene has no cam with a pressure angle")
    start, roller, offset = (scene.fact("cam_synthesis", name) for name in ("S0", "r2", "e"))
    if start is None or roller is None or scene.document["cam"].get("follower") == "flat":
        raise lacking("the cam has no stem with a roller, whose pressure angle grows as it comes nearer")
    document = changed(with_sizes(scene, scene.document), "cam", "refuse", to=False)
    cam = {key: value for key, value in document["cam"].items() if key not in ("base_radius", "optimum")}

    def steps() -> Iterator[Step]:
        for part in PARTS:
            sizes = {"start_distance": start, "roller_radius": roller, "offset": offset or 0.0}
            written = {key: f"{size * part!r} m" for key, size in sizes.items()}
            told = {**document, "cam": {**cam, **written}}
            yield Step(f"sizes x {part:g}", part, told, by_pressure)

    return Climb(
        "toward a pressure angle of 90 deg: start distance, offset and roller to 0", "1/cos(theta)", OWN_TWIN, steps()
    )


def by_pressure(result: RunResult) -> float | None:
    """By how much the force of the cam exceeds what lifts the follower, at the largest pressure angle."""
    if "cam_pressure" not in result.outcomes:
        return None
    told = dict(facts("cam_pressure", result.results["cam_pressure"]))
    largest = max((told[name][0] for name in ANGLES if name in told), default=0.0)
    return 1 / max(math.cos(math.radians(largest)), 1e-300)
