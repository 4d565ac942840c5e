"""ISO 2768-1: general tolerances of lengths and angles, classes f, m, c and v."""

from __future__ import annotations

import math

from tmmcalc.spec.units import UnitError

CLASSES = ("f", "m", "c", "v")
LEAST = 0.5  # [mm]
STEPS = (3, 6, 30, 120, 400, 1000, 2000, 4000)  # [mm] of lengths
LENGTHS: dict[str, tuple[float | None, ...]] = {  # [mm]
    "f": (0.05, 0.05, 0.1, 0.15, 0.2, 0.3, 0.5, None),
    "m": (0.1, 0.1, 0.2, 0.3, 0.5, 0.8, 1.2, 2.0),
    "c": (0.2, 0.3, 0.5, 0.8, 1.2, 2.0, 3.0, 4.0),
    "v": (None, 0.5, 1.0, 1.5, 2.5, 4.0, 6.0, 8.0),
}
SIDES = (10, 50, 120, 400, math.inf)  # [mm] of the shorter side of an angle
ANGLES = {  # [minutes]
    "f": (60, 30, 20, 10, 5),
    "m": (60, 30, 20, 10, 5),
    "c": (90, 60, 30, 15, 10),
    "v": (180, 120, 60, 30, 20),
}


def class_of(text: str) -> str:
    """The letter of a general tolerance, ``"m"`` or ``"ISO 2768-m"``; empty for anything else.

    >>> class_of("ISO 2768-c"), class_of("m"), class_of("h7")
    ('c', 'm', '')
    """
    letter = text.strip().removeprefix("ISO").strip().removeprefix("2768").strip().removeprefix("-").strip()
    return letter if letter in CLASSES else ""


def of_length(letter: str, size: float) -> float:
    """The deviation [m], to both sides, of a length [m]; raises UnitError beyond the table.

    >>> of_length("m", 0.2)
    0.0005
    """
    millimetres = round(abs(size) * 1e3, 9)
    row = next((row for row, step in enumerate(STEPS) if LEAST <= millimetres <= step), None)
    found = None if row is None else LENGTHS[letter][row]
    if found is None:
        rule = f"ISO 2768-{letter} gives no tolerance of {millimetres:g} mm"
        raise UnitError(rule, 'write the tolerance itself: "0.1 mm"')
    return round(found * 1e-3, 12)


def of_angle(letter: str, side: float) -> float:
    """The deviation [rad], to both sides, of an angle whose shorter side is ``side`` [m]."""
    row = next(row for row, step in enumerate(SIDES) if round(side * 1e3, 9) <= step)
    return math.radians(ANGLES[letter][row] / 60)
