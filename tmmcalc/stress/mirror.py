"""A linkage in a mirror: y becomes -y, and all angles, moments and senses of turning change their sign."""

from __future__ import annotations

import operator
from collections.abc import Callable, Mapping, Sequence
from typing import Any

from tmmcalc.stress.quantities import rewritten
from tmmcalc.stress.scene import Document, lacking

UNKNOWN = (
    "torque",
    "engine",
    "rotor",
    "unsteady",
    "synthesis",
    "manipulator",
    "indexing",
    "vibrator",
    "pendulum",
)


def mirrored(document: Mapping[str, Any]) -> Document:
    """The document of the mirrored scene; raises UsageError for what is not told how it looks in a mirror."""
    for table in UNKNOWN:
        if table in document:
            raise lacking(f"[{table}] is not mirrored")
    found = dict(document)
    if "mechanism" in document:
        found["mechanism"] = _mechanism(document["mechanism"])
    if "cam" in document:
        found["cam"] = _cam(document["cam"])
    if "loads" in document:
        found["loads"] = [_load(load) for load in document["loads"]]
    if "springs" in document:
        found["springs"] = [_spring(spring) for spring in document["springs"]]
    if "paths" in document:
        found["paths"] = [_path(path, _turns(document["mechanism"])) for path in document["paths"]]
    if "drive" in document and "pinion" in document["drive"]:
        found["drive"] = {**document["drive"], "pinion": _negative(document["drive"]["pinion"])}
    return found


def _cam(cam: Mapping[str, Any]) -> Document:
    """Sizes and laws are told by the sense in which the cam turns, the offset by left and right."""
    turned = "counter-clockwise" if cam.get("rotation", "clockwise") == "clockwise" else "clockwise"
    return {**_with(cam, offset=_negative), "rotation": turned}


def _turns(mechanism: Mapping[str, Any]) -> bool:
    """Whether the input is a crank."""
    driven = mechanism["input"]["joint"]
    return any(j["name"] == driven and j["kind"] == "revolute" for j in mechanism["joints"])


def _mechanism(mechanism: Mapping[str, Any]) -> Document:
    turns, found = _turns(mechanism), dict(mechanism)
    found["gravity_direction"] = _negative(mechanism.get("gravity_direction", "-90 deg"))
    found["fixed"] = _points(mechanism.get("fixed", {}))
    found["links"] = [_with(link, points=_points, center=_point) for link in mechanism["links"]]
    found["joints"] = [_with(joint, guide=_line, slider=_line) for joint in mechanism["joints"]]
    found["outputs"] = [_with(output, direction=_negative) for output in mechanism.get("outputs", ())]
    if turns:
        if "speed" not in mechanism["input"]:
            raise lacking("a crank without a speed turns counter-clockwise, not clockwise")
        found["input"] = _with(mechanism["input"], speed=_negative, acceleration=_negative, start=_start)
    if "assembly" in mechanism:
        at = {"at": _negative} if turns else {}
        found["assembly"] = _with(mechanism["assembly"], sketch=_points, variants=_Variants(mechanism["joints"]), **at)
    return found


def _with(table: Mapping[str, Any], **changes: Callable[[Any], Any]) -> Document:
    return {key: changes[key](value) if key in changes else value for key, value in table.items()}


def _points(points: Mapping[str, Any]) -> Document:
    return {name: _point(place) for name, place in points.items()}


def _point(place: Any) -> Any:
    if isinstance(place, str):
        return place
    if isinstance(place, dict):
        return {**place, "angle": _negative(place["angle"])}
    return [place[0], _negative(place[1])]


def _line(line: Mapping[str, Any]) -> Document:
    return _with(line, through=_point, angle=_negative)


def _load(load: Mapping[str, Any]) -> Document:
    found = _with(load, point=_point, direction=_negative, moment=_negative)
    for law in ("polynomial", "table"):
        if "moment" in load.get(law, {}):
            found[law] = {**load[law], "moment": [_negative(value) for value in load[law]["moment"]]}
    return found


def _spring(spring: Mapping[str, Any]) -> Document:
    return _with(spring, points=_each(_point), free_angle=_negative)


def _path(path: Mapping[str, Any], turns: bool) -> Document:
    at = {"at": _each(_negative)} if turns else {}
    return _with(path, through=_each(_point), turn=_negative, shift=_point, **at)


def _each(change: Callable[[Any], Any]) -> Callable[[Sequence[Any]], list[Any]]:
    return lambda values: [change(value) for value in values]


class _Variants:
    """Signs of dyads in a mirror: left of a line becomes right of it, ahead along a guide stays ahead."""

    def __init__(self, joints: Sequence[Mapping[str, Any]]) -> None:
        self.sliding = {str(link) for joint in joints if joint["kind"] == "prismatic" for link in joint["links"]}

    def __call__(self, variants: Mapping[str, Any]) -> Document:
        """Those of higher groups are numbered, and their order in a mirror is not known: raises UsageError."""
        if any(name.count("-") > 1 for name in variants):
            raise lacking("the assembly of a higher group is given by its number")
        return {name: sign if self.sliding.intersection(name.split("-")) else -sign for name, sign in variants.items()}


def _start(value: Any) -> Any:
    return value if value == "extreme" else _negative(value)


def _negative(value: Any) -> Any:
    """The value with the other sign, whether it has a unit or not."""
    return rewritten(value, operator.neg)
