"""Ladder of a cam: toward the cusp, where the profile gets a point and then crosses itself.

The limit has a closed form. The working profile of a roller is the pitch curve's parallel, so the roller is at most as
large as the least radius of that curve; under a flat face the radius is S + S'' and grows with the start distance.
"""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.stress.linkage import DISTANCES, OWN_TWIN
from tmmcalc.stress.scales import with_sizes
from tmmcalc.stress.scene import Climb, Scene, Step, always, changed, lacking

LEFT = (*DISTANCES[:-1], -1e-3)  # parts of the way to the cusp; the last is beyond it


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
            yield Step(f"{size * 1e3:.12g} mm, {left:g} of the way left", left, told, always(1 / abs(left)))

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
