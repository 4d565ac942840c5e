"""Angles in degrees, minutes and seconds, as calculations print them."""

from __future__ import annotations

from math import degrees, isfinite

from tmmcalc.core.errors import UsageError


def sexagesimal(angle: float, places: int = 2) -> tuple[int, int, int, float]:
    """Sign, degrees, minutes and seconds of an angle [rad]; seconds rounded, 60 of them carried over.

    >>> sexagesimal(0.441837586)
    (1, 25, 18, 55.54)
    """
    if not isfinite(angle):
        raise UsageError(f"{angle} is not an angle", where="degrees, minutes, seconds", remedy="a finite number")
    unit = 10**places
    total = round(abs(degrees(angle)) * 3600 * unit)
    minutes, rest = divmod(total, 60 * unit)
    whole, minutes = divmod(minutes, 60)
    return (-1 if angle < 0 and total else 1), whole, minutes, rest / unit


def dms(angle: float, places: int = 2) -> str:
    """An angle [rad] in degrees, minutes and seconds.

    >>> from math import radians
    >>> dms(0.441837586), dms(radians(-19.9999999)), dms(radians(0.5), 0)
    ('25°18\\'55.54"', '-20°00\\'00.00"', '0°30\\'00"')
    """
    sign, whole, minutes, seconds = sexagesimal(angle, places)
    width = places + 3 if places else 2
    return f"{'-' if sign < 0 else ''}{whole}°{minutes:02d}'{seconds:0{width}.{places}f}\""
