"""ISO 286: standard tolerances IT01 to IT18, and fundamental deviations of shafts and holes, sizes up to 3150 mm.

The standard's rounded values, ISO 286-1:2010, tables 1 to 5. Holes D to H are shafts mirrored at the nominal size,
holes K to P with the addition Delta = IT(n) - IT(n - 1) where the grade is fine and the size is above 3 mm.
"""

from __future__ import annotations

import re

from tmmcalc.spec.phrases import did_you_mean, listing, show
from tmmcalc.spec.units import UnitError

Deviations = tuple[float, float]  # lower and upper [m]

STEPS = (3, 6, 10, 18, 30, 50, 80, 120, 180, 250, 315, 400, 500, 630, 800, 1000, 1250, 1600, 2000, 2500, 3150)  # [mm]
LARGEST = STEPS[-1]
FINE_TO, DELTA_TO = 500, 500  # [mm] sizes that have IT01 and IT0, and holes K to P here

# [um] rows by STEPS; of the first two there is none above 500 mm
WIDTHS = {
    "01": (0.3, 0.4, 0.4, 0.5, 0.6, 0.6, 0.8, 1, 1.2, 2, 2.5, 3, 4),
    "0": (0.5, 0.6, 0.6, 0.8, 1, 1, 1.2, 1.5, 2, 3, 4, 5, 6),
    "1": (0.8, 1, 1, 1.2, 1.5, 1.5, 2, 2.5, 3.5, 4.5, 6, 7, 8, 9, 10, 11, 13, 15, 18, 22, 26),
    "2": (1.2, 1.5, 1.5, 2, 2.5, 2.5, 3, 4, 5, 7, 8, 9, 10, 11, 13, 15, 18, 21, 25, 30, 36),
    "3": (2, 2.5, 2.5, 3, 4, 4, 5, 6, 8, 10, 12, 13, 15, 16, 18, 21, 24, 29, 35, 41, 50),
    "4": (3, 4, 4, 5, 6, 7, 8, 10, 12, 14, 16, 18, 20, 22, 25, 28, 33, 39, 46, 55, 68),
    "5": (4, 5, 6, 8, 9, 11, 13, 15, 18, 20, 23, 25, 27, 32, 36, 40, 47, 55, 65, 78, 96),
    "6": (6, 8, 9, 11, 13, 16, 19, 22, 25, 29, 32, 36, 40, 44, 50, 56, 66, 78, 92, 110, 135),
    "7": (10, 12, 15, 18, 21, 25, 30, 35, 40, 46, 52, 57, 63, 70, 80, 90, 105, 125, 150, 175, 210),
    "8": (14, 18, 22, 27, 33, 39, 46, 54, 63, 72, 81, 89, 97, 110, 125, 140, 165, 195, 230, 280, 330),
    "9": (25, 30, 36, 43, 52, 62, 74, 87, 100, 115, 130, 140, 155, 175, 200, 230, 260, 310, 370, 440, 540),
    "10": (40, 48, 58, 70, 84, 100, 120, 140, 160, 185, 210, 230, 250, 280, 320, 360, 420, 500, 600, 700, 860),
    "11": (60, 75, 90, 110, 130, 160, 190, 220, 250, 290, 320, 360, 400, 440, 500, 560, 660, 780, 920, 1100, 1350),
    "12": (100, 120, 150, 180, 210, 250, 300, 350, 400, 460, 520, 570, 630, 700, 800, 900, 1050, 1250, 1500, 1750,
           2100),
    "13": (140, 180, 220, 270, 330, 390, 460, 540, 630, 720, 810, 890, 970, 1100, 1250, 1400, 1650, 1950, 2300, 2800,
           3300),
    "14": (250, 300, 360, 430, 520, 620, 740, 870, 1000, 1150, 1300, 1400, 1550, 1750, 2000, 2300, 2600, 3100, 3700,
           4400, 5400),
    "15": (400, 480, 580, 700, 840, 1000, 1200, 1400, 1600, 1850, 2100, 2300, 2500, 2800, 3200, 3600, 4200, 5000, 6000,
           7000, 8600),
    "16": (600, 750, 900, 1100, 1300, 1600, 1900, 2200, 2500, 2900, 3200, 3600, 4000, 4400, 5000, 5600, 6600, 7800,
           9200, 11000, 13500),
    "17": (1000, 1200, 1500, 1800, 2100, 2500, 3000, 3500, 4000, 4600, 5200, 5700, 6300, 7000, 8000, 9000, 10500, 12500,
           15000, 17500, 21000),
    "18": (1400, 1800, 2200, 2700, 3300, 3900, 4600, 5400, 6300, 7200, 8100, 8900, 9700, 11000, 12500, 14000, 16500,
           19500, 23000, 28000, 33000),
}  # fmt: skip
GRADES = tuple(WIDTHS)
# [um] magnitudes of the fundamental deviation of shafts: upper ones, below the nominal size, then lower ones, above it
UPPER = {
    "d": (20, 30, 40, 50, 65, 80, 100, 120, 145, 170, 190, 210, 230, 260, 290, 320, 350, 390, 430, 480, 520),
    "e": (14, 20, 25, 32, 40, 50, 60, 72, 85, 100, 110, 125, 135, 145, 160, 170, 195, 220, 240, 260, 290),
    "f": (6, 10, 13, 16, 20, 25, 30, 36, 43, 50, 56, 62, 68, 76, 80, 86, 98, 110, 120, 130, 145),
    "g": (2, 4, 5, 6, 7, 9, 10, 12, 14, 15, 17, 18, 20, 22, 24, 26, 28, 30, 32, 34, 38),
    "h": (0,) * len(STEPS),
}
LOWER = {
    "k": (0, 1, 1, 1, 2, 2, 2, 3, 3, 4, 4, 4, 5, 0, 0, 0, 0, 0, 0, 0, 0),  # IT4 to IT7; of other grades 0
    "m": (2, 4, 6, 7, 8, 9, 11, 13, 15, 17, 20, 21, 23, 26, 30, 34, 40, 48, 58, 68, 76),
    "n": (4, 8, 10, 12, 15, 17, 20, 23, 27, 31, 34, 37, 40, 44, 50, 56, 66, 78, 92, 110, 135),
    "p": (6, 12, 15, 18, 22, 26, 32, 37, 43, 50, 56, 62, 68, 78, 88, 100, 120, 140, 170, 195, 240),
}
LETTERS = (*UPPER, "js", *LOWER)
_CLASS = re.compile(r"(IT|[A-Za-z]{1,2})(\d{1,2})")
_MICRON = 1e-6
M6 = (250, 315, -9.0)  # the exception of the standard: ES of the hole M6 of these sizes


def is_class(text: str) -> bool:
    """Whether a text may be a tolerance class or a grade.

    >>> is_class("H7"), is_class("IT01"), is_class("0.1 mm")
    (True, True, False)
    """
    return _CLASS.fullmatch(text) is not None


def grade_width(grade: str, size: float) -> float:
    """Width [m] of a grade, ``"7"`` or ``"01"``, for a nominal size [m]; raises UnitError beyond the table.

    >>> grade_width("7", 0.025)
    2.1e-05
    """
    row = _row(size)
    if grade not in WIDTHS:
        raise UnitError(f"there is no grade IT{grade}", "the grades are IT01, IT0, IT1 to IT18")
    widths = WIDTHS[grade]
    if row >= len(widths):
        raise UnitError(f"IT{grade} is not given above {FINE_TO} mm", "take IT1 or a coarser grade")
    return round(widths[row] * _MICRON, 12)


def deviations(text: str, size: float) -> Deviations:
    """Lower and upper deviation [m] of a size [m] by its class, ``"h7"``, ``"H8"``, ``"js6"``, or a grade, ``"IT7"``,
    which lies evenly about it; raises UnitError for what the tables here have not.

    >>> deviations("k6", 0.03), deviations("N7", 0.025), deviations("IT7", 0.025)
    ((2e-06, 1.5e-05), (-2.8e-05, -7e-06), (-1.05e-05, 1.05e-05))
    """
    match = _CLASS.fullmatch(text)
    if match is None:
        raise UnitError(f"{show(text)} is no tolerance class", 'write a grade or a class: "IT7", "h7", "H8"')
    letter, grade = match.groups()
    width = grade_width(grade, size)
    if letter in ("IT", "js", "JS"):
        return -width / 2, width / 2
    row, micron = _row(size), _MICRON
    if letter.lower() not in LETTERS or letter not in (letter.lower(), letter.upper()):
        known = (*LETTERS, *(each.upper() for each in LETTERS))
        guess = did_you_mean(letter, known)
        raise UnitError(
            f"{show(text)}: {show(letter)} is none of the letters here", f"{guess} {listing(known)}".strip()
        )
    if letter in UPPER:
        upper = -UPPER[letter][row] * micron
        return round(upper - width, 12), round(upper, 12)
    if letter in LOWER:
        lower = (0 if letter == "k" and not 4 <= _order(grade) <= 7 else LOWER[letter][row]) * micron
        return round(lower, 12), round(lower + width, 12)
    if letter.lower() in UPPER:
        lower = UPPER[letter.lower()][row] * micron
        return round(lower, 12), round(lower + width, 12)
    upper = _upper_of_hole(letter.lower(), grade, size) * micron
    return round(upper - width, 12), round(upper, 12)


def _upper_of_hole(letter: str, grade: str, size: float) -> float:
    """ES [um] of the holes K, M, N and P: the shaft mirrored, with Delta where it is fine."""
    row, order, millimetres = _row(size), _order(grade), round(size * 1e3, 9)
    if not 3 <= order <= 8 or millimetres > DELTA_TO:
        text = f"{letter.upper()}{grade}"
        raise UnitError(
            f"{text} is not given here for {millimetres:g} mm", "grades 3 to 8, up to 500 mm; or [low, high]"
        )
    low, high, told = M6
    if letter == "m" and order == 6 and low < millimetres <= high:
        return told
    fine = millimetres > STEPS[0] and order <= (7 if letter == "p" else 8)
    return -LOWER[letter][row] + (WIDTHS[grade][row] - WIDTHS[str(order - 1)][row] if fine else 0.0)


def _order(grade: str) -> int:
    return -1 if grade == "01" else int(grade)


def _row(size: float) -> int:
    """The row of a nominal size [m]: above the step before, up to its own."""
    millimetres = round(abs(size) * 1e3, 9)
    if not 0 < millimetres <= LARGEST:
        remedy = 'write the tolerance itself: "0.1 mm"'
        raise UnitError(f"ISO 286 has sizes above 0 up to {LARGEST} mm, and this is {millimetres:g} mm", remedy)
    return next(row for row, step in enumerate(STEPS) if millimetres <= step)
