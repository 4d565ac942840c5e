"""The closed table of units, and the conversion of a quantity to SI.

A bare number is in SI. A string is a number and a unit: ``"200 mm"``, ``"55 rpm"``, ``"-18.819 deg"``.
The space may be left out. ``·`` stands for ``*``, ``²`` and ``³`` for ``^2`` and ``^3``. As is usual in the
field, ``1/min`` counts revolutions (it is rpm) and ``1/s`` counts radians (it is rad/s).

Each factor is an exact ratio of integers, times pi where the unit needs it. The number is read as a ratio
of integers too, and the one division at the end rounds once: ``"290 mm"`` is the float 0.29, and
``"90 deg"`` is ``math.pi / 2``.
"""

from __future__ import annotations

import cmath
import math
import re
from typing import NamedTuple

from .phrases import either, nearest, show

_QUARTERS = (1 + 0j, 1j, -1 + 0j, -1j)
FULL_TURN = 2 * math.pi * (1 + 1e-12)  # a bare angle above it is degrees in disguise
LARGEST = 1e250  # larger and smaller (1/LARGEST) magnitudes are slips, and their squares overflow

_PI_NUM = 3141592653589793238462643383279502884197169399375105820974944
_PI_DEN = 10**60


class UnitError(ValueError):
    """A quantity that cannot be read; ``remedy`` says what to write instead."""

    def __init__(self, message: str, remedy: str = "") -> None:
        self.message = message
        self.remedy = remedy
        super().__init__(message)


class Dimension(NamedTuple):
    """A kind of quantity: its name with the article, its SI unit, and an example of a string."""

    noun: str
    si: str
    example: str


class Factor(NamedTuple):
    """SI value of one unit: ``num / den``, times pi if ``pi``."""

    num: int = 1
    den: int = 1
    pi: bool = False


DIMENSIONS = {
    "length": Dimension("a length", "m", "200 mm"),
    "mass": Dimension("a mass", "kg", "55 kg"),
    "time": Dimension("a time", "s", "0.5 s"),
    "angle": Dimension("an angle", "rad", "30 deg"),
    "angular speed": Dimension("an angular speed", "rad/s", "55 rpm"),
    "angular acceleration": Dimension("an angular acceleration", "rad/s^2", "2 rad/s^2"),
    "speed": Dimension("a speed", "m/s", "0.2 m/s"),
    "acceleration": Dimension("an acceleration", "m/s^2", "9.81 m/s^2"),
    "force": Dimension("a force", "N", "1.5 kN"),
    "moment": Dimension("a moment", "N*m", "40 N*m"),
    "inertia": Dimension("a moment of inertia", "kg*m^2", "4.5 kg*m^2"),
    "static moment": Dimension("a static moment", "kg*m", "12 g*mm"),
    "power": Dimension("a power", "W", "1.1 kW"),
    "energy": Dimension("an energy", "J", "250 J"),
    "area": Dimension("an area", "m^2", "50 cm^2"),
    "pressure": Dimension("a pressure", "Pa", "600 MPa"),
    "stiffness": Dimension("a stiffness", "N/m", "30 N/mm"),
    "torsional stiffness": Dimension("a torsional stiffness", "N*m/rad", "5000 N*m/rad"),
    "damping": Dimension("a damping coefficient", "N*s/m", "20 N*s/m"),
    "torsional damping": Dimension("a torsional damping coefficient", "N*m*s/rad", "0.5 N*m*s/rad"),
    "quadratic damping": Dimension("a coefficient of quadratic resistance", "N*s^2/m^2", "3.5 N*s^2/m^2"),
    "torsional quadratic damping": Dimension(
        "a torsional coefficient of quadratic resistance", "N*m*s^2/rad^2", "0.02 N*m*s^2/rad^2"
    ),
    # GD^2 of the catalogues: its unit is the technical one by custom, and a quarter of the number is kg*m^2
    "flywheel moment": Dimension("a flywheel moment GD^2", "kgf*m^2", "0.11 kgf*m^2"),
    "voltage": Dimension("a voltage", "V", "220 V"),
    "resistance": Dimension("an electrical resistance", "ohm", "0.5 ohm"),
    "motor constant": Dimension("a motor constant", "V*s/rad", "1.4 V*s/rad"),
    "frequency": Dimension("a frequency", "Hz", "50 Hz"),
    "density": Dimension("a density", "kg/m^3", "7850 kg/m^3"),
}

_RPM = Factor(1, 30, pi=True)

UNITS: dict[str, dict[str, Factor]] = {
    "length": {
        "m": Factor(),
        "mm": Factor(1, 1000),
        "cm": Factor(1, 100),
        "um": Factor(1, 10**6),
        "km": Factor(1000),
    },
    "mass": {"kg": Factor(), "g": Factor(1, 1000), "t": Factor(1000)},
    "time": {"s": Factor(), "ms": Factor(1, 1000), "min": Factor(60), "h": Factor(3600)},
    "angle": {
        "rad": Factor(),
        "deg": Factor(1, 180, pi=True),
        "°": Factor(1, 180, pi=True),
        "arcmin": Factor(1, 10800, pi=True),
        "rev": Factor(2, pi=True),
    },
    "angular speed": {
        "rad/s": Factor(),
        "1/s": Factor(),
        "s^-1": Factor(),
        "rpm": _RPM,
        "1/min": _RPM,
        "min^-1": _RPM,
        "rev/min": _RPM,
        "rev/s": Factor(2, pi=True),
        "deg/s": Factor(1, 180, pi=True),
    },
    "angular acceleration": {
        "rad/s^2": Factor(),
        "1/s^2": Factor(),
        "s^-2": Factor(),
        "deg/s^2": Factor(1, 180, pi=True),
    },
    "speed": {"m/s": Factor(), "mm/s": Factor(1, 1000), "m/min": Factor(1, 60), "km/h": Factor(5, 18)},
    "acceleration": {"m/s^2": Factor(), "mm/s^2": Factor(1, 1000)},
    "force": {"N": Factor(), "kN": Factor(1000), "MN": Factor(10**6)},
    "moment": {"N*m": Factor(), "kN*m": Factor(1000), "N*mm": Factor(1, 1000)},
    "inertia": {
        "kg*m^2": Factor(),
        "kg*cm^2": Factor(1, 10**4),
        "kg*mm^2": Factor(1, 10**6),
        "g*cm^2": Factor(1, 10**7),
    },
    "static moment": {
        "kg*m": Factor(),
        "kg*cm": Factor(1, 100),
        "kg*mm": Factor(1, 1000),
        "g*m": Factor(1, 1000),
        "g*cm": Factor(1, 10**5),
        "g*mm": Factor(1, 10**6),
    },
    "power": {"W": Factor(), "kW": Factor(1000), "MW": Factor(10**6)},
    "energy": {"J": Factor(), "kJ": Factor(1000)},
    "area": {"m^2": Factor(), "cm^2": Factor(1, 10**4), "mm^2": Factor(1, 10**6)},
    "pressure": {
        "Pa": Factor(),
        "kPa": Factor(1000),
        "MPa": Factor(10**6),
        "N/mm^2": Factor(10**6),
        "bar": Factor(10**5),
    },
    "stiffness": {"N/m": Factor(), "N/mm": Factor(1000), "kN/m": Factor(1000)},
    "torsional stiffness": {"N*m/rad": Factor(), "kN*m/rad": Factor(1000)},
    "damping": {"N*s/m": Factor(), "kN*s/m": Factor(1000), "kg/s": Factor()},
    "torsional damping": {"N*m*s/rad": Factor(), "N*m*s": Factor()},
    "quadratic damping": {"N*s^2/m^2": Factor(), "kg/m": Factor()},
    "torsional quadratic damping": {"N*m*s^2/rad^2": Factor(), "N*m*s^2": Factor()},
    "flywheel moment": {"kgf*m^2": Factor(), "N*m^2": Factor(10**5, 980665)},
    "voltage": {"V": Factor(), "kV": Factor(1000)},
    "resistance": {"ohm": Factor(), "Ω": Factor()},
    "motor constant": {"V*s/rad": Factor(), "V*s": Factor()},
    "frequency": {"Hz": Factor()},
    "density": {"kg/m^3": Factor()},
}

_DIMENSION_OF = {unit: dimension for dimension, units in UNITS.items() for unit in units}

_SPELLINGS = str.maketrans(
    {"·": "*", "⋅": "*", "×": "*", "²": "^2", "³": "^3", "¹": "^1", "⁻": "^-", "µ": "u", "μ": "u", "º": "°"}
)
_QUANTITY = re.compile(r"\s*([+-]?)(\d+\.?\d*|\.\d+)(?:[eE]([+-]?\d+))?\s*(.*?)\s*", re.ASCII | re.DOTALL)


class _Reading(NamedTuple):
    """A quantity string taken apart: the number as text, and its unit as the table spells it."""

    sign: str
    digits: str
    exponent: str
    unit: str


def parse(value: object, *dimensions: str) -> float:
    """Return ``value`` in SI.

    ``value`` is a bare number (SI) or a string of a number and a unit; ``dimensions`` are the kinds of
    quantity allowed, keys of ``DIMENSIONS``. The result is the correctly rounded float.

    Raises UnitError: no number, no unit, an unknown unit, a unit of another dimension, not finite.

    >>> parse("290 mm", "length")
    0.29
    """
    if isinstance(value, str):
        return _parse_text(value, dimensions)
    if isinstance(value, int | float) and not isinstance(value, bool):
        return _bare(value, dimensions)
    raise UnitError(f"{show(value)} is not {_wanted(dimensions)}", _advice(dimensions))


def dimension_of(value: object) -> str | None:
    """Return the dimension that the unit of a quantity string has, None for anything else."""
    if not isinstance(value, str) or (reading := _take_apart(value)) is None:
        return None
    return _DIMENSION_OF.get(reading.unit)


def unit_direction(angle: float) -> complex:
    """Return e^(i angle), exact (1, i, -1, -i) where the angle [rad] is a whole number of right angles."""
    quarters = round(angle / (math.pi / 2))
    if abs(angle - quarters * (math.pi / 2)) <= 2 * math.ulp(angle):
        return _QUARTERS[quarters % 4]
    return cmath.rect(1.0, angle)


def _bare(value: float, dimensions: tuple[str, ...]) -> float:
    magnitude = abs(value)
    if magnitude == 0:
        return 0.0
    if not 1 / LARGEST <= magnitude <= LARGEST:  # false for nan as well
        raise UnitError(f"{show(value)} is not a finite number of ordinary size", _advice(dimensions))
    if dimensions == ("angle",) and magnitude > FULL_TURN:
        raise UnitError(
            f"{show(value)} without a unit is in radians, more than a full turn",
            f'write "{value:g} deg" or "{value:g} rad"',
        )
    return float(value)


def _parse_text(text: str, dimensions: tuple[str, ...]) -> float:
    reading = _take_apart(text)
    if reading is None:
        raise UnitError(f"{show(text)} is not {_wanted(dimensions)}", _advice(dimensions))
    dimension = _DIMENSION_OF.get(reading.unit)
    if dimension is None:
        raise _unit_fault(text, reading, dimensions)
    if dimension not in dimensions:
        raise UnitError(
            f"{show(text)} is {DIMENSIONS[dimension].noun}, {_wanted(dimensions)} is needed",
            _advice(dimensions),
        )
    return _convert(text, reading, UNITS[dimension][reading.unit], dimensions)


def _take_apart(text: str) -> _Reading | None:
    # A minus copied from a printed page is U+2212.
    match = _QUANTITY.fullmatch(text.replace("−", "-"))
    if match is None:
        return None
    sign, digits, exponent, unit = match.groups()
    unit = re.sub(r"\s*([*/^])\s*", r"\1", unit.translate(_SPELLINGS)).replace("^-^", "^-").replace("**", "^")
    return _Reading(sign, digits, exponent or "0", unit)


def _convert(text: str, reading: _Reading, factor: Factor, dimensions: tuple[str, ...]) -> float:
    """Return number times factor, rounded once: Python divides integers with correct rounding."""
    approximate = float(f"{reading.digits}e{reading.exponent}")
    if approximate == 0 and not reading.digits.strip("0."):
        return 0.0
    if len(reading.digits) > 400 or not 1 / LARGEST <= approximate <= LARGEST:
        raise UnitError(f"{show(text)} is not a finite number of ordinary size", _advice(dimensions))
    whole, _, fraction = reading.digits.partition(".")
    num, den = int(whole + fraction) * factor.num, factor.den
    shift = int(reading.exponent) - len(fraction)
    num, den = (num * 10**shift, den) if shift >= 0 else (num, den * 10**-shift)
    if factor.pi:
        num, den = num * _PI_NUM, den * _PI_DEN
    return math.copysign(num / den, -1.0 if reading.sign == "-" else 1.0)


def _unit_fault(text: str, reading: _Reading, dimensions: tuple[str, ...]) -> UnitError:
    if not reading.unit:
        si = either(DIMENSIONS[dimension].si for dimension in dimensions)
        advice = _advice(dimensions)
        if not reading.digits.strip("0."):
            return UnitError(f"{show(text)} has no unit", f"write 0 without quotes, or {advice.removeprefix('write ')}")
        return UnitError(f"{show(text)} has no unit", f"{advice}; a number without quotes is in {si}")
    if re.match(r",\d", reading.unit):
        return UnitError(f"{show(text)} has a decimal comma", f'write a point: "{text.replace(",", ".", 1)}"')
    if re.match(r"[\d.,/]", reading.unit):
        return UnitError(f"{show(text)} does not start with one plain number", _advice(dimensions))
    own = [unit for dimension in dimensions for unit in UNITS[dimension]]
    guess = nearest(reading.unit, own) or nearest(reading.unit, list(_DIMENSION_OF))
    remedy = f'did you mean "{guess}"? ' if guess else ""
    return UnitError(f"{show(text)}: unknown unit {show(reading.unit)}", f"{remedy}known here: {', '.join(own)}")


def _wanted(dimensions: tuple[str, ...]) -> str:
    return either(DIMENSIONS[dimension].noun for dimension in dimensions)


def _advice(dimensions: tuple[str, ...]) -> str:
    examples = either(f'"{DIMENSIONS[dimension].example}"' for dimension in dimensions)
    return f"write a number and its unit in quotes, such as {examples}"
