"""Numbers as people read them: the same decimals down a column, no noise where a value is zero."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from tmmcalc.report.language import tr_number

DIGITS = 6  # significant digits of the largest value of a column
MIDDLE_DIGITS = 4  # at least, of a value of middle size, where a few tower above the rest
NOISE = 1e-12  # a value this small against the largest of its column is zero
ANGLE_DECIMALS = 5  # of an angle in degrees
ROUND = (1.0, 1.25, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0)  # scales of drawings


def number(value: float, digits: int = 7, peak: float = 0.0) -> str:
    """One number of ``digits`` significant digits at most; 0 if it is noise against ``peak``.

    >>> number(1 / 3), number(2e-17, peak=1.0)
    ('0.3333333', '0')
    """
    return tr_number(_unsigned_zero(f"{_cleaned(value, peak):.{digits}g}"))


def percent(part: float, digits: int = 5) -> str:
    """A part of a whole in per cent.

    >>> percent(0.00135), percent(1.0)
    ('0.135 %', '100 %')
    """
    return f"{number(100 * part, digits)} %"


def angle(degrees: float) -> str:
    """An angle in degrees, five decimals at most.

    >>> angle(-18.8190633), angle(-3e-12), angle(180.0)
    ('-18.81906', '0', '180')
    """
    text = f"{degrees:.{ANGLE_DECIMALS}f}".rstrip("0").rstrip(".")
    return tr_number(_unsigned_zero(text))


def column(values: Sequence[float], peak: float = 0.0) -> list[str]:
    """A column with common decimals, or in powers of ten where it is very large or small.

    ``peak`` is the largest magnitude of the column that the values were chosen from, if they are not all of it:
    what is noise there is 0 here.
    """
    peak = max([*map(abs, values), peak])
    cleaned = [_cleaned(v, peak) for v in values]
    if not any(cleaned):
        return ["0"] * len(values)
    places = decimals(cleaned)
    if places is None:
        return scientific(cleaned, DIGITS)
    return [tr_number(cell) for cell in _trimmed([_unsigned_zero(f"{v:.{places}f}") for v in cleaned])]


def decimals(values: Sequence[float]) -> int | None:
    """Decimals that a column has in common; None where it is so large or small that it has powers of ten.

    >>> decimals([0.0, 0.25, 12.5]), decimals([0.0]), decimals([2e9])
    (4, 0, None)
    """
    sizes = sorted(abs(v) for v in values if v)
    if not sizes:
        return 0
    largest, middle = _exponent(sizes[-1]), _exponent(sizes[len(sizes) // 2])
    if not -4 <= largest <= 7:
        return None
    return min(max(DIGITS - 1 - largest, MIDDLE_DIGITS - 1 - middle, 0), DIGITS)


def counted_back(cells: Sequence[Any]) -> Sequence[Any]:
    """A column of texts that are all numbers, as they are written in full, or empty: as numbers, None where empty.

    Any other column, one with other texts too, stays as it is.

    >>> counted_back(["0", "1"]), counted_back(["0.5", ""]), counted_back(["0", "0'"]), counted_back(["007"])
    ([0, 1], [0.5, None], ['0', "0'"], ['007'])
    """
    if not any(isinstance(cell, str) for cell in cells):
        return cells
    found = [as_number(cell) if isinstance(cell, str) else cell for cell in cells]
    return cells if any(isinstance(cell, str) for cell in found) else found


def as_number(text: str) -> float | str | None:
    """The number that a text is in full, None for an empty one, else the text itself."""
    if not text:
        return None
    for kind in (int, float):
        try:
            value = kind(text)
        except ValueError:
            continue
        if repr(value) == text and math.isfinite(value):
            return value
    return text


def scientific(values: Sequence[float], digits: int = 3) -> list[str]:
    """Numbers in powers of ten; zero stays 0."""
    return [tr_number(f"{v:.{digits - 1}e}") if v else "0" for v in values]


def round_scale(least: float, steps: Sequence[float] = ROUND) -> float:
    """The next scale above, out of a series of round numbers from 1 to 10.

    >>> round_scale(0.0173), round_scale(0.0173, (1, 2.5, 5, 10)), round_scale(0.0)
    (0.02, 0.025, 1.0)
    """
    if least <= 0:
        return 1.0
    power = 10.0 ** math.floor(math.log10(least))
    found = next(step for step in steps if step * power >= least * (1 - 1e-9)) * power
    return float(f"{found:.3g}")


def _exponent(size: float) -> int:
    return math.floor(math.log10(size))


def _cleaned(value: float, peak: float) -> float:
    return 0.0 if abs(value) < NOISE * abs(peak) else value


def _unsigned_zero(text: str) -> str:
    return text[1:] if text.startswith("-") and not text.strip("-0.") else text


def _trimmed(cells: list[str]) -> list[str]:
    """The same decimals without the zeros that end every cell: 0, 15, 30 instead of 0.000, 15.000, 30.000."""
    if not cells or "." not in cells[0]:
        return cells
    spare = min(len(cell) - len(cell.rstrip("0")) for cell in cells)
    if spare == len(cells[0].partition(".")[2]):
        spare += 1  # the point goes as well
    return [cell[: len(cell) - spare] for cell in cells]
