"""Checks of numbers that are chosen: each key holds a number and stands once, limits or values leave something.

Searched variables and numbers that are drawn for a class are written alike, so that they have the same faults.
"""

from __future__ import annotations

from collections.abc import Generator, Iterator
from math import isfinite

from tmmcalc.core.errors import UsageError
from tmmcalc.naming.rows import in_unit
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Raw
from tmmcalc.spec.override import apply
from tmmcalc.spec.phrases import Path, show
from tmmcalc.spec.units import UnitError, dimension_of
from tmmcalc.spec.units import parse as in_si
from tmmcalc.spec.variants import given

RANGE = ("at_least", "at_most")


def listed(value: object) -> list[str]:
    """The keys or names that stand as one or as several, without what is none."""
    given = value if isinstance(value, list) else [value]
    return [each.strip() for each in given if isinstance(each, str) and "=" not in each.rpartition("]")[2]]


def check_keys(
    path: Path, table: Raw, document: Raw, seen: dict[Path, str], how: str, whose: str
) -> Generator[Finding, None, list[str]]:
    """The units of the keys of a table; a finding for one that holds no number or stands in ``seen``, of all before.

    ``how`` says what twice would be, "varied", ``whose`` where one of both is removed, "the variables".
    """
    units = []
    for key in filter(None, listed(table.get("of"))):
        if any(wild in key for wild in "*?"):
            yield Finding((*path, "of"), f"{show(key)} may name several keys", "write each: of = [...]")
            continue
        try:
            units.append(given(key, document)[1])
        except UsageError as error:
            yield Finding((*path, "of"), error.message, error.remedy)
            continue
        place = place_of(key, document)
        if place in seen:
            also = "" if seen[place] == key else f", as {seen[place]} too"
            yield Finding((*path, "of"), f"{key} is {how} twice{also}", f"remove it from one of {whose}")
        seen.setdefault(place, key)
    return units


def place_of(key: str, document: Raw) -> Path:
    """Where a key stands in a document, however it is written."""
    return apply(document, [f"{key}=0"])[1][0]


def check_values(path: Path, table: Raw, units: list[str], how: str, whose: str) -> Iterator[Finding]:
    """Either values or both limits are given, and leave something to choose.

    ``how`` says what is done with them, "sought", ``whose`` what they are those of, "the variable".
    """
    if "among" in table:
        for key in (*RANGE, "step"):
            if key in table:
                rule = f"{key} together with among, which says all values"
                yield Finding((*path, key), rule, "remove one of them")
        values = table["among"] if isinstance(table["among"], list) else []
        if len(values) == 1:
            yield Finding((*path, "among"), "one value leaves nothing to choose", "write two or more")
        known = yield from numbers_in((*path, "among"), values, units)
        if len({*known}) < len(known):
            yield Finding((*path, "among"), "a value stands twice", "write each once")
        return
    missing = [key for key in RANGE if key not in table]
    if missing:
        rule = f"missing key: {' and '.join(missing)}, between which it is {how}"
        yield Finding(path, rule, 'add at_least = "20 mm" and at_most = "80 mm", or among = [...]')
        return
    ends = yield from numbers_in((*path, "at_most"), [table[key] for key in RANGE], units)
    steps = yield from numbers_in((*path, "step"), [table["step"]] if "step" in table else [], units)
    if len(ends) == 2 and not ends[0] < ends[1]:
        rule = f"at_most {show(table['at_most'])} is not above at_least {show(table['at_least'])}"
        yield Finding((*path, "at_most"), rule, f"widen the limits, or remove {whose}")
    elif steps and steps[0] <= 0:
        yield Finding((*path, "step"), f"a step of {show(table['step'])} goes nowhere", "write one above 0")
    elif steps and len(ends) == 2 and steps[0] > ends[1] - ends[0]:
        rule = f"a step of {show(table['step'])} leaves the least value alone"
        yield Finding((*path, "step"), rule, "write a smaller one, or widen the limits")


def numbers_in(path: Path, values: list[object], units: list[str]) -> Generator[Finding, None, list[float]]:
    """The values in the unit of the first key; a finding for one that does not fit, none for what is no number.

    Where no key has a unit, as none holds a number, there is nothing that they could be compared in: none is known.
    """
    known: list[float] = []
    if not units:
        return known
    for value in values:
        if isinstance(value, bool) or not isinstance(value, str | int | float):
            continue
        if isinstance(value, float) and not isfinite(value):
            continue
        try:
            known.append(_comparable(value, units[0]))
        except UnitError as error:
            yield Finding(path, str(error), f"write it in {units[0]}" if units[0] else "write a number without a unit")
    return known


def _comparable(value: str | float, unit: str) -> float:
    """The value in the unit of its key; without one in SI."""
    dimension = None if unit else dimension_of(value)
    return in_unit(value, unit) if dimension is None else in_si(value, dimension)
