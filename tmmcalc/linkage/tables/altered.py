"""The mechanism of a document with something else in it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from copy import deepcopy
from typing import Any

from tmmcalc.spec.altered import changed

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
