"""The mechanism of a document with something else in it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from copy import deepcopy
from typing import Any

from tmmcalc.spec.altered import bare, changed

Change = Callable[[float], float]


def mechanism_with(document: Mapping[str, Any], change: Callable[[dict[str, Any]], bool]) -> dict[str, Any]:
    """The tables of a document whose mechanism is changed in place; {} where ``change`` finds nothing to change."""
    if "mechanism" not in document:
        return {}
    mechanism = deepcopy(document["mechanism"])
    return {"mechanism": mechanism} if change(mechanism) else {}


def with_each(document: Mapping[str, Any], several: str, key: str, change: Change) -> dict[str, Any]:
    """The same with this key changed in all its ``several`` (links, joints) that have it."""

    def every(mechanism: dict[str, Any]) -> bool:
        having = [each for each in mechanism.get(several, ()) if each.get(key)]
        for each in having:
            each[key] = changed(each[key], change)
        return bool(having)

    return mechanism_with(document, every)


def with_gravity(document: Mapping[str, Any], gravity: float) -> dict[str, Any]:
    """The same with another gravity [m/s^2]; {} where nothing has a weight."""

    def other(mechanism: dict[str, Any]) -> bool:
        if not bare(mechanism.get("gravity", 9.81)) or not any(link.get("mass") for link in mechanism["links"]):
            return False
        mechanism["gravity"] = gravity
        return True

    return mechanism_with(document, other)


def with_steiner(document: Mapping[str, Any], sign: int) -> dict[str, Any]:
    """The same with moments of inertia I + m s^2, or I - m s^2 by the ``sign``; {} where one would be below 0."""

    def shifted(mechanism: dict[str, Any]) -> bool:
        found = False
        for link in mechanism["links"]:
            mass, inertia, center = bare(link.get("mass")), bare(link.get("inertia")), link.get("center")
            if mass and inertia and isinstance(center, list):
                x, y = (bare(each) or 0.0 for each in center)
                link["inertia"] = inertia + sign * mass * (x * x + y * y)
                if link["inertia"] < 0:  # whoever finds that sees that it is wrong
                    return False
                found = True
        return found

    return mechanism_with(document, shifted)
