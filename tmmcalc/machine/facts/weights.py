"""How large a force or a couple is over a turn, and where a weight stands, as the documents of balancing say it."""

from __future__ import annotations

import cmath
import math

from tmmcalc.core.numerics.fourier import Magnitude
from tmmcalc.core.quantity import Quantity
from tmmcalc.report.numbers import NOISE, number

SAME = 1e-9  # relative: a largest value so near to the root mean square belongs to a constant

RMS = Quantity("{name}_rms[{unit}]", "root mean square over a turn")
MAX = Quantity("{name}_max[{unit}]", "largest magnitude over a turn")
MAX_AT = Quantity("{name}_max_at{place}[deg]", "angle of the largest magnitude")
RATIO = Quantity("{left}_{scheme}_ratio", "root mean square before over that of {left} after: {scheme}")
MAX_RATIO = Quantity("{left}_{scheme}_max_ratio", "largest magnitude before over that of {left} after: {scheme}")
PLANE = Quantity("z[m]", "place of the plane of a weight along the shaft")
MOMENT = Quantity("moment[kg*m]", "static moment of a weight")
DIRECTION = Quantity("{name}angle[deg]", "direction of a weight, of an unbalance")


def size_text(size: Magnitude, unit: str, peak: float, place: str) -> str:
    """Root mean square and largest value with its ``place``; 0 if it is noise against ``peak``."""
    if size.largest <= NOISE * peak:
        return f"0 {unit}"
    if size.largest <= size.rms * (1 + SAME):
        return f"{number(size.rms)} {unit} everywhere"
    return f"rms {number(size.rms)} {unit}, max {number(size.largest)} {unit}{place}"


def size_values(size: Magnitude, told: Quantity, place: str, degrees: float) -> dict[str, float]:
    """The same for programs, with the ``place`` of the largest value."""
    names = {"name": told.name, "unit": told.unit, "place": place}
    found = zip((RMS, MAX, MAX_AT), (size.rms, size.largest, degrees), strict=True)
    return {each.of(**names).key: value for each, value in found}


def polar(size: Quantity, angle: Quantity, value: complex) -> dict[str, float]:
    """Size and direction of a vector for programs."""
    return {**size.value(abs(value)), **angle.value(math.degrees(cmath.phase(value)))}


def ratios(left: str, scheme: str, before: Magnitude, after: Magnitude) -> dict[str, float]:
    """How many times less root mean square and largest value of what is ``left`` are than before, for programs."""
    return {
        RATIO.of(left=left, scheme=scheme).key: before.rms / after.rms,
        MAX_RATIO.of(left=left, scheme=scheme).key: before.largest / after.largest,
    }


def direction(radians: float) -> str:
    """An angle in degrees, six digits at most, above -180.

    >>> direction(-math.pi), direction(-1.0)
    ('180', '-57.2958')
    """
    text = number(math.degrees(radians), 6, peak=180.0)
    return "180" if text == "-180" else text
