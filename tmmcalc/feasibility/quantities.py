"""Quantities by name and their limits in one unit: what a stage tells is ``name[unit]``."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from difflib import get_close_matches
from typing import TypeVar

from tmmcalc.core.errors import UsageError
from tmmcalc.feasibility.judge import Constraint

Told = TypeVar("Told")
Limits = tuple[float | None, float | None]


def of_name(constraint: Constraint, told: Mapping[str, Told]) -> Told:
    """What is told under the name of a constraint; raises `UsageError` with the names that there are."""
    name = constraint.value or constraint.column or ""
    if name not in told:
        kind = "facts" if constraint.value else "columns"
        raise UsageError(
            f"{constraint.stage} tells no {name!r}", where=place(constraint), remedy=_names(name, told, kind)
        )
    return told[name]


def _names(name: str, told: Iterable[str], kind: str) -> str:
    near = get_close_matches(name, told, 3)
    guess = f"did you mean {' or '.join(near)}? " if near else ""
    return f"{guess}its {kind} are: {', '.join(sorted(told)) or 'none'}"


def place(constraint: Constraint) -> str:
    """Where a constraint stands, for messages."""
    return f"constraints, {constraint.name}"


def limits(constraint: Constraint, unit: str) -> Limits:
    """Both limits in the unit of the quantity; raises `UsageError` for one of another kind."""
    low, high = (
        None if limit is None else _in_unit(limit, unit, place(constraint))
        for limit in (constraint.at_least, constraint.at_most)
    )
    return low, high


def _in_unit(limit: float | str, unit: str, where: str) -> float:
    if not isinstance(limit, str):
        return float(limit)
    from tmmcalc.spec.units import UnitError, dimension_of, parse

    dimension = dimension_of(limit) or ""
    try:
        return parse(limit, dimension) / parse(f"1 {unit}", dimension)
    except UnitError:
        told = f"in {unit}" if unit else "a bare number"
        raise UsageError(
            f"{limit!r} cannot be compared: the quantity is {told}", where=where, remedy=f"write a number {told}"
        ) from None
