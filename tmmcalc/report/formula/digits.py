"""A line with numbers: how many digits are printed, so that whoever works it out gets what is printed as the result.

Operands are values of the program, never the rounded result of another line.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import NamedTuple

from tmmcalc.core.records import record
from tmmcalc.report.formula.setting import Shown
from tmmcalc.report.formula.tree import Name, Node, Value, largest_term, names, value, written_out

RESULT = 5  # digits of a result
WHOLE = 10  # digits up to which a number that is given by them is told whole
FEWEST, MOST = 5, 13  # digits of operands that are tried
EXACT = 1e-9  # of the largest term: what a line may differ from the program's result
PLAIN = (-4, 6)  # exponents of numbers that are written without a power of ten


class Given(NamedTuple):
    """A quantity with its value, or values over an index, in the unit in which it is printed; ``deg`` is an angle."""

    value: Value
    unit: str = ""
    meaning: str = ""


@record
class Worked:
    """A side worked out: the tree with sums written out, what is printed for its names, and the printed result."""

    tree: Node
    shown: Mapping[str, Shown]
    result: str
    off: float  # of the printed operands' value from the printed result, in units of its last digit
    error: float  # of the value at full precision from the result, in parts of the largest term


def worked(side: Node, given: Mapping[str, Given], result: float, *, unit: str = "", digits: int = RESULT) -> Worked:
    """Numbers for a side whose value by the program is ``result``, in ``unit``.

    Raises `KeyError` for a name that is not given, `ValueError` or `ArithmeticError` where the side has no value.
    """
    own = {key: given[key] for key in names(side)}
    full = {key: _inner(each.value, each.unit) for key, each in own.items()}
    tree = written_out(side, full)
    flat, units = _flat(own)
    size = _size(side, full, result, unit)
    last = _last(result, size, digits)
    text = rounded(result, last)
    best: tuple[float, dict[str, str]] | None = None
    for count in range(FEWEST, MOST + 1):
        texts = {key: significant(each, count) for key, each in flat.items()}
        printed = {key: _inner(float(each), units[key]) for key, each in texts.items()}
        off = abs(_apart(_outer(_value(tree, printed), unit), float(text), unit)) / last
        if best is None or off < best[0]:
            best = off, texts
        if off <= 0.5 + 1e-6:
            break
    assert best is not None
    shown = {key: Shown(each, units[key] == "deg") for key, each in best[1].items()}
    return Worked(tree, shown, text, best[0], off_by(side, given, result, unit))


def off_by(side: Node, given: Mapping[str, Given], result: float, unit: str) -> float:
    """What the value at full precision is off from the result, in parts of the largest term.

    Raises as `worked` does.
    """
    full = {key: _inner(given[key].value, given[key].unit) for key in names(side)}
    exact, size = _outer(value(side, full), unit), _size(side, full, result, unit)
    return abs(_apart(exact, result, unit)) / size if size else 0.0


def of_given(values: Sequence[float]) -> int:
    """How many digits numbers that are given have: as they were written, or, found of what was, those of a result.

    >>> of_given([3.03125]), of_given([2 / 3])
    (10, 5)
    """
    whole = all(math.isclose(value, float(f"{value:.{WHOLE}g}"), rel_tol=1e-12) for value in values)
    return WHOLE if whole else RESULT


def _size(side: Node, full: Mapping[str, Value], result: float, unit: str) -> float:
    """The size against which errors count: that of the largest term."""
    return max(_outer(largest_term(side, full), unit), abs(result))


def result_of(left: Node, given: Mapping[str, Given]) -> Given:
    """What stands on the left of a line, as the program has it: a quantity, or a number that is a function of some."""
    return given[left.key] if isinstance(left, Name) else Given(value_of(left, given, ""))


def value_of(side: Node, given: Mapping[str, Given], unit: str) -> float:
    """The value of a side at full precision, in ``unit``."""
    return _outer(value(side, {key: _inner(given[key].value, given[key].unit) for key in names(side)}), unit)


def _value(tree: Node, values: Mapping[str, Value]) -> float:
    """The value; infinite where rounded numbers have none, as the root of a small difference."""
    try:
        return value(tree, values)
    except (ValueError, ArithmeticError):
        return math.inf


def _flat(given: Mapping[str, Given]) -> tuple[dict[str, float], dict[str, str]]:
    """Values and units by the names that stand in a tree with sums written out."""
    values: dict[str, float] = {}
    units: dict[str, str] = {}
    for key, each in given.items():
        several = not isinstance(each.value, float | int)
        for k, one in enumerate(each.value if isinstance(each.value, Sequence) else [each.value]):
            name = f"{key}#{k}" if several else key
            values[name], units[name] = float(one), each.unit
    return values, units


def _inner(given: Value, unit: str) -> Value:
    """Values as a tree takes them: angles in rad."""
    if unit != "deg":
        return given
    return math.radians(given) if isinstance(given, float | int) else [math.radians(each) for each in given]


def _outer(found: float, unit: str) -> float:
    return math.degrees(found) if unit == "deg" else found


def _apart(found: float, other: float, unit: str) -> float:
    """The difference of two values; of angles without whole turns."""
    if unit != "deg" or not math.isfinite(found):
        return found - other
    return (found - other + 180.0) % 360.0 - 180.0


def _last(result: float, size: float, digits: int) -> float:
    """The unit of the last printed digit of a result; of one that is nothing against its terms that of the largest."""
    top = size if abs(result) <= EXACT * size else abs(result)
    return 10.0 ** (math.floor(math.log10(top)) - digits + 1) if top > 0 else 10.0**-digits


def rounded(number: float, last: float) -> str:
    """A number to a unit of its last digit, zeros at its end left out.

    >>> rounded(12.34567, 1e-3), rounded(-1e-17, 1e-9), rounded(1234567.0, 100.0)
    ('12.346', '0', '1.2346e6')
    """
    steps = round(number / last)
    return _written(steps, round(math.log10(last)))


def significant(number: float, digits: int) -> str:
    """A number with at most so many significant digits, zeros at its end left out.

    >>> significant(0.2, 5), significant(1 / 3, 5), significant(2.5e-7, 4), significant(101325.0, 4)
    ('0.2', '0.33333', '2.5e-7', '101300')
    """
    if number == 0:
        return "0"
    exponent = int(f"{number:.{digits - 1}e}".partition("e")[2])
    return rounded(number, 10.0 ** (exponent - digits + 1))


def _written(steps: int, decimals: int) -> str:
    """``steps`` times ten to the power of ``decimals``."""
    if not steps:
        return "0"
    while steps % 10 == 0:
        steps, decimals = steps // 10, decimals + 1
    sign, figures = "-" if steps < 0 else "", str(abs(steps))
    exponent = len(figures) - 1 + decimals
    if not PLAIN[0] <= exponent < PLAIN[1]:
        rest = figures[1:]
        return f"{sign}{figures[0]}{'.' if rest else ''}{rest}e{exponent}"
    if decimals >= 0:
        return f"{sign}{figures}{'0' * decimals}"
    figures = figures.rjust(1 - decimals, "0")
    return f"{sign}{figures[:decimals]}.{figures[decimals:]}"
