"""Checks of ``[[constraints]]``: names, stages or what is given, one quantity, limits that can be kept."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.core.errors import UsageError
from tmmcalc.core.manifest import TABLES
from tmmcalc.core.stage import STAGES
from tmmcalc.naming.language import ROWS, is_name, parse
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline, Raw, tables
from tmmcalc.spec.phrases import Path, did_you_mean, listing, show
from tmmcalc.spec.units import dimension_of, unit_of

LIMITS = ("at_least", "at_most")
TRUTHS = ("function", "holds")  # what is given in place of a value with limits


def check_constraints(outline: Outline) -> Iterator[Finding]:
    """A constraint has a name of its own, an existing stage or a given value, one quantity, limits that can be kept."""
    seen: set[str] = set()
    for index, constraint in tables(outline.document, "constraints"):
        path: Path = ("constraints", index)
        name = constraint.get("name")
        if isinstance(name, str):
            if name in seen:
                yield Finding((*path, "name"), f"{show(name)} is already the name of another constraint", "rename one")
            seen.add(name)
        if "stage" in constraint:
            yield from _check_stage(path, constraint.get("stage"))
            yield from _check_quantity(path, constraint)
            yield from _check_alone(path, "stage", outline)
        elif is_name(constraint.get("value")):
            yield from _check_name(path, constraint)
            yield from _check_alone(path, "value", outline)
        else:
            yield from _check_given(path, constraint)
        if not {*TRUTHS} & {*constraint} and {"stage", "value", "column", *LIMITS} & {*constraint}:
            yield from _check_limits(path, constraint)


def _check_stage(path: Path, stage: object) -> Iterator[Finding]:
    known = [name for name in STAGES if name != "feasibility"]
    if isinstance(stage, str) and stage not in known:
        yield Finding(
            (*path, "stage"),
            f"there is no stage {show(stage)}",
            f"{did_you_mean(stage, known)} the stages are: {listing(known)}".strip(),
        )


def _check_quantity(path: Path, constraint: Raw) -> Iterator[Finding]:
    given: list[str] = [key for key in ("value", "column") if key in constraint]
    if "value" in constraint and not isinstance(constraint["value"], str):
        rule = f"{show(constraint['value'])} is a given value, and of the stage a fact is asked for by its name"
        yield Finding((*path, "value"), rule, 'write value = "stroke_D", or remove stage')
    elif isinstance(constraint.get("value"), str):
        yield from _check_language(path, f"{constraint.get('stage')}.{constraint['value']}")
    for key in TRUTHS:
        if key in constraint:
            yield Finding((*path, key), f"{key} together with stage: the result tells it", "remove one of them")
            given.append(key)
    if given[:2] == ["value", "column"]:
        yield Finding(
            (*path, "column"), "value together with column: a constraint has one quantity", "remove one of them"
        )
    if not given:
        yield Finding(path, "missing key: value or column", 'add value = "stroke_D", or column = "R_A" and of = "max"')
    if constraint.get("stage") in ROWS and "of" in constraint and "column" in constraint:
        yield Finding(
            (*path, "of"),
            f"of on a column of {show(constraint['stage'])}: its rows are sets to choose from, each is judged",
            "remove it",
        )
    if "of" in constraint and "column" not in constraint:
        yield Finding(
            (*path, "of"), "of without column: it tells what of a column is meant", "remove it, or name a column"
        )


def _check_language(path: Path, name: str) -> Iterator[Finding]:
    """A name of a result is one, and names one result."""
    try:
        asked = parse(name)
    except UsageError as error:
        yield Finding((*path, "value"), error.message, error.remedy)
        return
    if asked.wild:
        rule = f"{show(name)} may name several results: a constraint is on one"
        yield Finding((*path, "value"), rule, "write its name without * and ?")


def _check_name(path: Path, constraint: Raw) -> Iterator[Finding]:
    """A value that is a name of a result stands in place of stage and column."""
    yield from _check_language(path, constraint["value"])
    for key in ("column", "of", *TRUTHS):
        if key in constraint:
            rule = f"{key} together with a value that is a name: it says all"
            yield Finding((*path, key), rule, "remove one of them")


def _check_alone(path: Path, key: str, outline: Outline) -> Iterator[Finding]:
    """A result needs something that is computed."""
    if not any(entry.subject and entry.name in outline.document for entry in TABLES.values() if entry.name != path[0]):
        rule = "there is no result that it could be on: the spec has nothing to compute"
        yield Finding((*path, key), rule, 'add [mechanism] or another subject, or give the value: value = "35 deg"')


def _check_given(path: Path, constraint: Raw) -> Iterator[Finding]:
    """Without a stage one of a value, a function and a truth is given, a value with limits that can be compared."""
    value = constraint.get("value")
    if isinstance(value, str) and dimension_of(value) is None:
        yield Finding((*path, "value"), f"{show(value)} is no quantity", 'write a number, or one with a unit: "35 deg"')
        return
    of_stage = next((key for key in ("column", "of") if key in constraint), None)
    if of_stage:
        rule = f"missing key: {of_stage} names what a stage tells, and there is no stage"
        yield Finding(path, rule, 'add stage = "kinematics", or give the value: value = "35 deg"')
        return
    given = [key for key in ("value", *TRUTHS) if key in constraint]
    if not given:
        rule = "missing key: a constraint is on the result of a stage, or on what is given"
        yield Finding(path, rule, 'add stage = "kinematics", or value = "35 deg", function = 0.3 or holds = true')
    for key in given[1:]:
        yield Finding((*path, key), f"{key} together with {given[0]}: one of them is given", "remove one of them")
    for key in LIMITS:
        if key in constraint and {*TRUTHS} & {*given}:
            rule = f"{key} of {given[-1]}: limits are those of a value"
            yield Finding((*path, key), rule, f"remove it, or write value in place of {given[-1]}")
    if given == ["value"]:
        yield from _check_units(path, constraint)


def _check_units(path: Path, constraint: Raw) -> Iterator[Finding]:
    """A limit with a unit bounds a given value of the same kind."""
    value = constraint["value"]
    own = dimension_of(value)
    for key in LIMITS:
        limit = constraint.get(key)
        other = dimension_of(limit)
        if other is not None and other != own:
            told = f"in {unit_of(value)}" if own else "a bare number"
            yield Finding(
                (*path, key), f"{show(limit)} cannot be compared: the value is {told}", f"write a number {told}"
            )


def _check_limits(path: Path, constraint: Raw) -> Iterator[Finding]:
    given = [key for key in LIMITS if key in constraint]
    if not given:
        yield Finding(path, "missing key: at_least or at_most", 'add at_least = "200 mm", or at_most, or both')
    for key in given:
        written = constraint[key]
        if isinstance(written, str) and dimension_of(written) is None:
            yield Finding(
                (*path, key), f"{show(written)} is no quantity", 'write a number, or one with a unit: "200 mm"'
            )
    low, high = (constraint.get(key) for key in ("at_least", "at_most"))
    if isinstance(low, int | float) and isinstance(high, int | float) and low > high:
        yield Finding((*path, "at_most"), f"{high:g} is below at_least = {low:g}", "exchange the limits")


CHECKS = (check_constraints,)
