"""Checks of ``[rotor]``: two bearings and two planes apart, and unbalances that are measured once."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline, subtable, tables
from tmmcalc.spec.phrases import Path
from tmmcalc.spec.values import amounts, check_bare_speed

_PAIRS = {"bearings": "a rotor runs in two bearings", "planes": "a couple is balanced by weights at a distance"}


def check_places(outline: Outline) -> Iterator[Finding]:
    """Two bearings, and two correction planes, are apart."""
    rotor = subtable(outline.document, "rotor")
    for key, rule in _PAIRS.items():
        pair = amounts(rotor.get(key), "length")
        if pair is not None and len(pair) == 2 and pair[0] == pair[1]:
            yield Finding(("rotor", key), f"both {key} are at one place; {rule}", "write two different places")
    yield from check_bare_speed(rotor.get("speed"), ("rotor", "speed"))


def check_unbalances(outline: Outline) -> Iterator[Finding]:
    """An unbalance is a mass at a radius, or a static moment."""
    for index, unbalance in tables(subtable(outline.document, "rotor"), "unbalances"):
        path: Path = ("rotor", "unbalances", index)
        given = [key for key in ("mass", "radius") if key in unbalance]
        if "moment" in unbalance and given:
            rule = f"moment together with {' and '.join(given)}: the moment is mass times radius"
            yield Finding((*path, "moment"), rule, f"remove it, or remove {' and '.join(given)}")
        elif "moment" not in unbalance and len(given) < 2:
            rule = "missing key: an unbalance is a mass at a radius, or a static moment"
            yield Finding(path, rule, 'add mass = "5 g" and radius = "80 mm", or moment = "400 g*mm"')


CHECKS = (check_places, check_unbalances)
