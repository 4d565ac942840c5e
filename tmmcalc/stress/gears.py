"""Ladders of gears: numbers of teeth, shifts toward the border of the contour, closing meshes, torques of all sizes.

A pair is computed in modules, so that other units find nothing; shifts a rounding away do.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

from tmmcalc.gears.involute.function import involute
from tmmcalc.spec.units import parse
from tmmcalc.stress.compare import Alignment
from tmmcalc.stress.scene import (
    DISTANCES,
    NUDGED_TWIN,
    OWN_TWIN,
    Climb,
    Document,
    Scene,
    Step,
    always,
    changed,
    decades,
    lacking,
)

FEW = (3, 4, 6, 8, 10, 12, 14, 17)  # teeth of the pinion
MANY = (1, 2, 5, 10, 50, 200, 1000)  # times as many teeth
MOST = 10_000  # teeth
MOST_WRITTEN = 100_000  # of a train that is written out
LEFT = (*DISTANCES[:-1], -1e-3)  # parts of the way to the limit; the last is beyond it
TORQUES = decades(-3, 9, 2)  # [N*m]
CHOICE = ("strategy", "split", "desired_contact_ratio", "x1", "x2", "centre_distance")  # what settles the shifts
MEASURES = ("span_teeth", "ball_diameters", "tip_diameters")  # that fit the teeth they are given for


def teeth(scene: Scene) -> Climb:
    """The pinion from three teeth on, then both wheels with ever more; of a written train all wheels at once."""
    if scene.has("gearing"):
        return _written_teeth(scene)
    pair = _pair(scene)
    numbers: list[int] = pair["teeth"]
    plain = {key: value for key, value in _without_shifts(pair).items() if key not in MEASURES}
    fewer = [[few, *numbers[1:]] for few in FEW if few < numbers[0]]
    more = [[k * z for z in numbers] for k in MANY if k * max(numbers) <= MOST]

    def steps() -> Iterator[Step]:
        for each in (*fewer, *more):
            told = {**scene.document, "pair": {**plain, "teeth": each}}
            largest = float(max(each))
            yield Step(f"z = {'/'.join(map(str, each))}", float(each[0]), told, always(largest))

    return Climb("numbers of teeth, with the shifts of the program", "teeth of the wheel", OWN_TWIN, steps())


def _written_teeth(scene: Scene) -> Climb:
    """All wheels with so many times the teeth: speeds and torques stay what they are."""
    gearing = scene.document["gearing"]
    numbers = _numbers(gearing)

    def steps() -> Iterator[Step]:
        for k in MANY:
            if k * max(numbers) <= MOST_WRITTEN:
                told = {**scene.document, "gearing": _times(gearing, k)}
                yield Step(f"{k} times the teeth", float(k), told, always(float(k * max(numbers))), Alignment())

    return Climb("numbers of teeth of all wheels", "teeth of the largest", "the scene as it is", steps())


def _numbers(gearing: Document) -> list[int]:
    meshes = [mesh[key] for mesh in gearing.get("meshes", ()) for key in ("first_teeth", "second_teeth")]
    return meshes + list(gearing.get("teeth", ()))


def _times(gearing: Document, k: int) -> Document:
    found = dict(gearing)
    if "teeth" in gearing:
        found["teeth"] = [k * z for z in gearing["teeth"]]
    if "meshes" in gearing:
        found["meshes"] = [
            {**mesh, **{key: k * mesh[key] for key in ("first_teeth", "second_teeth")}} for mesh in gearing["meshes"]
        ]
    return found


def shift(scene: Scene) -> Climb:
    """The shifts go, with their sum kept, to the nearer border of the blocking contour, and beyond it."""
    pair = _pair(scene)
    contour = next(iter(scene.base.results["blocking"].pairs), None) if scene.has("blocking") else None
    if contour is None or contour.low is None:
        raise lacking("the pair has no blocking contour about its shifts")
    x1, x2 = scene.base.results["pair"].pairs[0].shifts
    border = min((contour.low, contour.high), key=lambda each: abs(each - x1))
    plain = _without_shifts(pair)

    def steps() -> Iterator[Step]:
        for left in LEFT:
            first = border + (x1 - border) * left
            told = {**scene.document, "pair": {**plain, "x1": first, "x2": x1 + x2 - first}}
            yield Step(f"{left:g} left, x1 = {first:.12g}", left, told, always(1 / abs(left)))

    title = f"toward the border of the blocking contour: x1 to {border:.9g}, with the sum of the shifts kept"
    return Climb(title, "1/part of the way left", NUDGED_TWIN, steps())


def mesh_angle(scene: Scene) -> Climb:
    """The sum of the shifts falls until the pitch circles are the base circles: the angle of mesh is zero there."""
    pair = _pair(scene)
    found = scene.base.results["pair"].pairs[0]
    if found.task.kind != "external":
        raise lacking("the pair is no external one, whose wheels can come so near that they have no angle of mesh")
    alpha, total = found.angle_t, sum(found.shifts)
    least = -sum(pair["teeth"]) * involute(alpha) / (2 * math.tan(found.task.rack.angle))
    plain = _without_shifts(pair) | {"refuse": False}

    def steps() -> Iterator[Step]:
        for left in LEFT:
            half = (least + (total - least) * left) / 2
            told = {**scene.document, "pair": {**plain, "x1": half, "x2": half}}
            yield Step(f"{left:g} left, x1 + x2 = {2 * half:.12g}", left, told, always(1 / abs(left)))

    title = f"toward an angle of mesh of 0: sum of the shifts to {least:.9g}"
    return Climb(title, "1/part of the way left", NUDGED_TWIN, steps())


def _without_shifts(pair: Document) -> Document:
    return {key: value for key, value in pair.items() if key not in CHOICE}


def torque(scene: Scene) -> Climb:
    """The torque on the first wheel over twelve orders: modules from the least of the series to beyond its end."""
    if not scene.has("strength") or "torque" not in scene.document.get("strength", {}):
        raise lacking("the scene has no train that is sized for a torque")
    own = parse(scene.document["strength"]["torque"], "moment")

    def steps() -> Iterator[Step]:
        for size in TORQUES:
            told = changed(scene.document, "strength", "torque", to=f"{size:g} N*m")
            yield Step(f"{size:g} N*m", size, told, always(max(size / own, own / size)))

    return Climb("torque on the first wheel", "ratio or its inverse", "nothing: modules are standard", steps())


def _pair(scene: Scene) -> dict[str, Any]:
    """The table of the one pair that the scene has."""
    pair: dict[str, Any] = scene.document.get("pair", {})
    if not scene.has("pair") or "teeth" not in pair or pair.get("meshes"):
        raise lacking("the scene has no single pair of gears")
    return pair
