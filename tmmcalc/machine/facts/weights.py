"""How large a force or a couple is over a turn, and where a weight stands, as the documents of balancing say it."""

from __future__ import annotations

import math

from tmmcalc.core.numerics.fourier import Magnitude
from tmmcalc.report.numbers import NOISE, number

SAME = 1e-9  # relative: a largest value so near to the root mean square belongs to a constant


def size_text(size: Magnitude, unit: str, peak: float, place: str) -> str:
    """Root mean square and largest value with its ``place``; 0 if it is noise against ``peak``."""
    if size.largest <= NOISE * peak:
        return f"0 {unit}"
    if size.largest <= size.rms * (1 + SAME):
        return f"{number(size.rms)} {unit} everywhere"
    return f"rms {number(size.rms)} {unit}, max {number(size.largest)} {unit}{place}"


def size_values(size: Magnitude, key: str, unit: str, place: str, degrees: float) -> dict[str, float]:
    """The same for programs, the place under ``key_max_at_place[deg]``."""
    return {f"{key}_rms[{unit}]": size.rms, f"{key}_max[{unit}]": size.largest, f"{key}_max_at{place}[deg]": degrees}


def direction(radians: float) -> str:
    """An angle in degrees, six digits at most, above -180.

    >>> direction(-math.pi), direction(-1.0)
    ('180', '-57.2958')
    """
    text = number(math.degrees(radians), 6, peak=180.0)
    return "180" if text == "-180" else text
