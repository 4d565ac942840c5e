"""The conversion of a quantity to SI.

A bare number is in SI. A string is a number and a unit: ``"200 mm"``, ``"55 rpm"``, ``"-18.819 deg"``.
The space may be left out. ``·`` stands for ``*``, ``²`` and ``³`` for ``^2`` and ``^3``.

The number is read as a ratio of integers, as the factors of the units are, and the one division at the end rounds
once: ``"290 mm"`` is the float 0.29, and ``"90 deg"`` is ``math.pi / 2``.
"""

from __future__ import annotations

import cmath
import math
import re
from decimal import Context, Decimal
from fractions import Fraction
from functools import lru_cache
from typing import NamedTuple

from tmmcalc.spec.dimensions import DIMENSIONS, UNITS, Factor
from tmmcalc.spec.phrases import either, nearest, show

_QUARTERS = (1 + 0j, 1j, -1 + 0j, -1j)
FULL_TURN = 2 * math.pi * (1 + 1e-12)  # a bare angle above it is degrees in disguise
LARGEST = 1e250  # larger and smaller (1/LARGEST) magnitudes are slips, and their squares overflow
LONGEST = 400  # characters of a number, or of a unit

_PI_NUM = 3141592653589793238462643383279502884197169399375105820974944
_PI_DEN = 10**60


class UnitError(ValueError):
    """A quantity that cannot be read; ``remedy`` says what to write instead."""

    def __init__(self, message: str, remedy: str = "") -> None:
        self.message = message
        self.remedy = remedy
        super().__init__(message)


_DIMENSION_OF = {unit: dimension for dimension, units in UNITS.items() for unit in units}

_SPELLINGS = str.maketrans(
    {"·": "*", "⋅": "*", "×": "*", "²": "^2", "³": "^3", "¹": "^1", "⁻": "^-", "µ": "u", "μ": "u", "º": "°"}
)
_QUANTITY = re.compile(r"([+-]?)(\d++(?:\.\d*+)?|\.\d++)(?:[eE]([+-]?\d++))?\s*+(.*)", re.ASCII | re.DOTALL)


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


def unit_of(value: object) -> str:
    """Return the unit of a quantity string as the table spells it; empty for anything else.

    >>> unit_of("4.5 kg·m²"), unit_of("crank")
    ('kg*m^2', '')
    """
    reading = _take_apart(value) if isinstance(value, str) else None
    return reading.unit if reading is not None and reading.unit in _DIMENSION_OF else ""


def kind_of(unit: str) -> str | None:
    """The dimension of a unit; None of what is no unit.

    >>> kind_of("rpm"), kind_of("mesh")
    ('angular speed', None)
    """
    return _DIMENSION_OF.get(unit)


def conversion(unit: str, other: str) -> float:
    """What a value in one unit is multiplied by for another of its dimension.

    >>> conversion("m", "mm"), conversion("Pa", "MPa")
    (1000.0, 1e-06)
    """
    if unit == other:
        return 1.0
    dimension = _DIMENSION_OF[unit]
    return parse(f"1 {unit}", dimension) / parse(f"1 {other}", dimension)


def exact(value: str | float, unit: str) -> Fraction:
    """A bare number as it is written, or a quantity in ``unit``: a ratio of integers, the same on every machine.

    Between turns and radians it is that of pi to sixty digits. Raises UnitError for a unit of another kind, for one
    where ``unit`` is none, and for what is no number.

    >>> exact("7.5 cm", "mm"), exact(0.1, ""), exact("0.3", "m")
    (Fraction(75, 1), Fraction(1, 10), Fraction(3, 10))
    """
    reading = _take_apart(value if isinstance(value, str) else repr(value))
    if reading is None or max(len(reading.digits), len(reading.exponent)) > LONGEST or abs(int(reading.exponent)) > 250:
        raise UnitError(f"{show(value)} is no quantity")
    number = Fraction(f"{reading.sign}{reading.digits.rstrip('.') or '0'}e{reading.exponent}")
    if not reading.unit:
        return number
    dimension = _DIMENSION_OF.get(reading.unit)
    if dimension is None or _DIMENSION_OF.get(unit) != dimension:
        raise UnitError(f"{show(value)} is no number in {unit or 'no unit'}")
    own, other = (UNITS[dimension][each] for each in (reading.unit, unit))
    number *= Fraction(own.num * other.den, own.den * other.num)
    return number * Fraction(_PI_NUM, _PI_DEN) ** (own.pi - other.pi)


def written(value: float, unit: str) -> str:
    """Return the shortest string of a number and this unit that is read as exactly ``value`` [SI].

    >>> written(0.29, "mm"), written(math.pi / 2, "deg"), written(1 / 3, "mm")
    ('290 mm', '90 deg', '333.3333333333333 mm')
    """
    dimension = _DIMENSION_OF[unit]
    factor = UNITS[dimension][unit]
    number = Fraction(value) * Fraction(factor.den, factor.num)
    if factor.pi:
        number *= Fraction(_PI_DEN, _PI_NUM)
    digits, text = 0, f"0 {unit}"
    while parse(text, dimension) != value:
        digits += 1
        shown = Context(prec=digits).divide(Decimal(number.numerator), Decimal(number.denominator)).normalize()
        text = f"{shown:f} {unit}" if -6 <= shown.adjusted() < 16 else f"{shown} {unit}"
    return text


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


@lru_cache(maxsize=1024)  # variants of a spec repeat nearly all their texts
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
    match = _QUANTITY.fullmatch(text.replace("−", "-").strip())
    if match is None:
        return None
    sign, digits, exponent, unit = match.groups()
    if len(unit) > LONGEST:  # no unit; a search for spaces in it would take the square of their number
        return _Reading(sign, digits, exponent or "0", unit)
    unit = re.sub(r"\s*([*/^])\s*", r"\1", unit.translate(_SPELLINGS)).replace("^-^", "^-").replace("**", "^")
    return _Reading(sign, digits, exponent or "0", unit)


def _convert(text: str, reading: _Reading, factor: Factor, dimensions: tuple[str, ...]) -> float:
    """Return number times factor, rounded once: Python divides integers with correct rounding."""
    approximate = float(f"{reading.digits}e{reading.exponent}")
    if approximate == 0 and not reading.digits.strip("0."):
        return 0.0
    if max(len(reading.digits), len(reading.exponent)) > LONGEST or not 1 / LARGEST <= approximate <= LARGEST:
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
    from tmmcalc.spec.cyrillic import latin_units  # late: only faults need it

    if re.match(r",\d", reading.unit):
        pointed = latin_units(text.replace(",", ".", 1))
        return UnitError(f"{show(text)} has a decimal comma", f'write a point: "{pointed}"')
    if re.match(r"[\d.,/]", reading.unit):
        return UnitError(f"{show(text)} does not start with one plain number", _advice(dimensions))
    latin = _take_apart(latin_units(text))
    if latin is not None and latin != reading and latin.unit in _DIMENSION_OF:
        dimension = _DIMENSION_OF[latin.unit]
        if dimension not in dimensions:
            return UnitError(
                f"{show(text)} is {DIMENSIONS[dimension].noun}, {_wanted(dimensions)} is needed", _advice(dimensions)
            )
        told = f"{show(text)}: the unit {show(reading.unit)} is in Cyrillic letters"
        return UnitError(told, f'write it in Latin ones: "{latin_units(text)}"')
    own = [unit for dimension in dimensions for unit in UNITS[dimension]]
    guess = nearest(reading.unit, own) or nearest(reading.unit, list(_DIMENSION_OF))
    remedy = f'did you mean "{guess}"? ' if guess else ""
    return UnitError(f"{show(text)}: unknown unit {show(reading.unit)}", f"{remedy}known here: {', '.join(own)}")


def _wanted(dimensions: tuple[str, ...]) -> str:
    return either(DIMENSIONS[dimension].noun for dimension in dimensions)


def _advice(dimensions: tuple[str, ...]) -> str:
    examples = either(f'"{DIMENSIONS[dimension].example}"' for dimension in dimensions)
    return f"write a number and its unit in quotes, such as {examples}"
