"""Factors between the unit that is asked for and the one that is taken for it; NaN where there is no such slip."""

from __future__ import annotations

import re
from math import nan, pi

LENGTH = re.compile(r"(?<![A-Za-z])(m|mm)(?:\^([234]))?(?![A-Za-z])")
PREFIXED = {  # what the unit is taken for with or without its kilo or mega
    "N": 1e-3,
    "kN": 1e3,
    "W": 1e-3,
    "kW": 1e3,
    "J": 1e-3,
    "kJ": 1e3,
    "Pa": 1e-6,
    "MPa": 1e6,
    "N*m": 1e-3,
    "kN*m": 1e3,
}
ANGLE = {"deg": pi / 180, "rad": 180 / pi}
SPEED = {"rpm": pi / 30, "rad/s": 30 / pi}
FORCES = ("N", "kN", "N*m", "kN*m")
G = 9.81  # [m/s^2]


def lengths_swapped(unit: str) -> float:
    """Factor of a value in this unit if metres are taken for millimetres in it, or millimetres for metres.

    >>> lengths_swapped("m/s"), lengths_swapped("mm"), lengths_swapped("kg*m^2"), lengths_swapped("m/m")
    (1000.0, 0.001, 1000000.0, nan)
    """
    found = [*LENGTH.finditer(unit)]
    if len(found) != 1:
        return nan
    length, power = found[0].groups("1")
    over = -1 if "/" in unit[: found[0].start()] else 1
    return float(1000.0 ** ((1 if length == "m" else -1) * int(power) * over))


def prefixes_swapped(unit: str) -> float:
    """Factor of a value whose kilo or mega is forgotten, or too much."""
    return PREFIXED.get(unit, nan)


def angles_swapped(unit: str) -> float:
    """Factor of an angle, or of a speed in radians, that is told in the other unit of angles."""
    return ANGLE.get(unit.partition("/")[0], nan)


def speeds_swapped(unit: str) -> float:
    """Factor of a speed in rpm that is told in radians a second, or the other way."""
    return SPEED.get(unit, nan)


def forces_in_kilograms(unit: str) -> float:
    """Factor of a force or a moment that is told in kilograms-force."""
    return 1 / G if unit in FORCES else nan
