"""Checks of ``[optimize]``: something is sought, each key is a number that varies once, limits leave room."""

from __future__ import annotations

from collections.abc import Generator, Iterator
from math import isfinite

from tmmcalc.core.errors import UsageError
from tmmcalc.naming.rows import in_unit
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline, Raw, tables
from tmmcalc.spec.override import apply
from tmmcalc.spec.phrases import Path, show
from tmmcalc.spec.units import UnitError, dimension_of
from tmmcalc.spec.units import parse as in_si
from tmmcalc.spec.variants import given

SENSES = ("least", "greatest")
RANGE = ("at_least", "at_most")


def check_optimize(outline: Outline) -> Iterator[Finding]:
    """One result at least is sought and none twice; variables are numbers of the spec, none twice."""
    optimize = outline.document.get("optimize", {})
    if not isinstance(optimize, dict):
        return
    sought = [name for sense in SENSES for name in _listed(optimize.get(sense))]
    if not sought:
        rule = "missing key: least or greatest, the result that is sought"
        yield Finding(("optimize",), rule, 'add least = "kinematics.max(aS_D)"')
    for name in {*_listed(optimize.get("least"))} & {*_listed(optimize.get("greatest"))}:
        rule = f"{show(name)} is to be least and greatest"
        yield Finding(("optimize", "greatest"), rule, "remove it from one of them")
    seen: dict[Path, str] = {}
    for index, variable in tables(optimize, "variables"):
        path: Path = ("optimize", "variables", index)
        units = []
        for key in filter(None, _listed(variable.get("of"))):
            if any(wild in key for wild in "*?"):
                yield Finding((*path, "of"), f"{show(key)} may name several keys", "write each: of = [...]")
                continue
            try:
                units.append(given(key, outline.document)[1])
            except UsageError as error:
                yield Finding((*path, "of"), error.message, error.remedy)
                continue
            place = apply(outline.document, [f"{key}=0"])[1][0]
            if place in seen:
                also = "" if seen[place] == key else f", as {seen[place]} too"
                yield Finding((*path, "of"), f"{key} is varied twice{also}", "remove it from one of the variables")
            seen.setdefault(place, key)
        yield from _check_values(path, variable, units)


def _listed(value: object) -> list[str]:
    given = value if isinstance(value, list) else [value]
    return [each.strip() for each in given if isinstance(each, str) and "=" not in each.rpartition("]")[2]]


def _check_values(path: Path, variable: Raw, units: list[str]) -> Iterator[Finding]:
    """Either values or both limits are given, and leave something to choose."""
    if "among" in variable:
        for key in (*RANGE, "step"):
            if key in variable:
                rule = f"{key} together with among, which says all values"
                yield Finding((*path, key), rule, "remove one of them")
        values = variable["among"] if isinstance(variable["among"], list) else []
        if len(values) == 1:
            yield Finding((*path, "among"), "one value leaves nothing to choose", "write two or more")
        known = yield from _numbers((*path, "among"), values, units)
        if len({*known}) < len(known):
            yield Finding((*path, "among"), "a value stands twice", "write each once")
        return
    missing = [key for key in RANGE if key not in variable]
    if missing:
        rule = f"missing key: {' and '.join(missing)}, between which it is sought"
        yield Finding(path, rule, 'add at_least = "20 mm" and at_most = "80 mm", or among = [...]')
        return
    ends = yield from _numbers((*path, "at_most"), [variable[key] for key in RANGE], units)
    steps = yield from _numbers((*path, "step"), [variable["step"]] if "step" in variable else [], units)
    if len(ends) == 2 and not ends[0] < ends[1]:
        rule = f"at_most {show(variable['at_most'])} is not above at_least {show(variable['at_least'])}"
        yield Finding((*path, "at_most"), rule, "widen the limits, or remove the variable")
    elif steps and steps[0] <= 0:
        yield Finding((*path, "step"), f"a step of {show(variable['step'])} goes nowhere", "write one above 0")
    elif steps and len(ends) == 2 and steps[0] > ends[1] - ends[0]:
        rule = f"a step of {show(variable['step'])} leaves the least value alone"
        yield Finding((*path, "step"), rule, "write a smaller one, or widen the limits")


def _numbers(path: Path, values: list[object], units: list[str]) -> Generator[Finding, None, list[float]]:
    """The values in the unit of the first key; a finding for one that does not fit, none for what is no number."""
    known: list[float] = []
    for value in values:
        if isinstance(value, bool) or not isinstance(value, str | int | float):
            continue
        if isinstance(value, float) and not isfinite(value):
            continue
        try:
            known.append(_comparable(value, units[0] if units else ""))
        except UnitError as error:
            yield Finding(path, str(error), f"write it in {units[0]}")
    return known


def _comparable(value: str | float, unit: str) -> float:
    """The value in the unit of its key; without one in SI."""
    dimension = None if unit else dimension_of(value)
    return in_unit(value, unit) if dimension is None else in_si(value, dimension)


CHECKS = (check_optimize,)
