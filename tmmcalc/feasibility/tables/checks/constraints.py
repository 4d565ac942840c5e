"""Checks of ``[[constraints]]``: names, stages, one quantity, limits that can be kept."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.core.stage import STAGES
from tmmcalc.feasibility.judge import ROWS
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline, Raw, tables
from tmmcalc.spec.phrases import Path, did_you_mean, listing, show
from tmmcalc.spec.units import dimension_of


def check_constraints(outline: Outline) -> Iterator[Finding]:
    """A constraint has a name of its own, an existing stage, one quantity, and limits that can be kept."""
    seen: set[str] = set()
    for index, constraint in tables(outline.document, "constraints"):
        path: Path = ("constraints", index)
        name = constraint.get("name")
        if isinstance(name, str):
            if name in seen:
                yield Finding((*path, "name"), f"{show(name)} is already the name of another constraint", "rename one")
            seen.add(name)
        yield from _check_stage(path, constraint.get("stage"))
        yield from _check_quantity(path, constraint)
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
    given = [key for key in ("value", "column") if key in constraint]
    if len(given) == 2:
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


def _check_limits(path: Path, constraint: Raw) -> Iterator[Finding]:
    given = [key for key in ("at_least", "at_most") if key in constraint]
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
