"""Quantities by name and their limits in one unit: what a stage tells is ``name[unit]``."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from difflib import get_close_matches
from fnmatch import fnmatchcase
from typing import TypeVar

from tmmcalc.core.errors import UsageError
from tmmcalc.feasibility.judge import Constraint

Told = TypeVar("Told")
Limits = tuple[float | None, float | None]

# Quantities that were told in another unit before: a limit without a unit may be meant in either. By stage, whether it
# is a fact, and the unit of now: the unit of before, and the names.
BEFORE: Mapping[tuple[str, bool, str], tuple[str, tuple[str, ...]]] = {
    ("unsteady", True, "deg"): ("rad", ("*",)),
    ("manipulator", True, "deg"): ("rad", ("*",)),
    ("synthesis", True, "deg"): ("rad", ("*",)),
    ("synthesis", False, "deg"): ("rad", ("two_phi", "psi", "psi_*", "phi_?*", "body", "S")),
    ("synthesis", False, "m"): ("mm", ("error_max", "structural_error_*")),
    ("transient", False, "deg"): ("rad", ("theta*",)),
    ("cam_law", True, "deg"): ("rad", ("stroke",)),
    ("cam_law", False, "deg"): ("rad", ("dpsi",)),
    ("cam_forces", True, "deg"): ("rad", ("dpsi_M",)),
    ("cam_forces", False, "deg"): ("rad", ("dpsi",)),
    ("cam_synthesis", True, "deg"): ("rad", ("psi0",)),
    ("pair", True, "rad"): ("deg", ("alpha_t", "alpha_tw")),
}


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


def of_given(constraint: Constraint) -> tuple[float, str]:
    """What is given, and the unit in which it is written."""
    if not isinstance(constraint.given, str):
        return float(constraint.given or 0.0), ""
    from tmmcalc.spec.units import unit_of

    unit = unit_of(constraint.given)
    return _in_unit(constraint.given, unit, place(constraint)), unit


def limits(constraint: Constraint, unit: str) -> Limits:
    """Both limits in the unit of the quantity; raises `UsageError` for one of another kind."""
    before, names = BEFORE.get((constraint.stage, bool(constraint.value), unit), ("", ()))
    name = constraint.value or constraint.column or ""
    if any(fnmatchcase(name, each) for each in names):
        _told_with_unit(constraint, name, before, unit)
    low, high = (
        None if limit is None else _in_unit(limit, unit, place(constraint))
        for limit in (constraint.at_least, constraint.at_most)
    )
    return low, high


def _told_with_unit(constraint: Constraint, name: str, before: str, unit: str) -> None:
    """Raise `UsageError` for a limit that is a number other than 0, of a quantity that was told in another unit."""
    for key in ("at_least", "at_most"):
        limit = getattr(constraint, key)
        if isinstance(limit, int | float) and limit:
            raise UsageError(
                f"{key} = {limit:g} has no unit, and {name} is told in {unit} now, where it was {before}",
                where=place(constraint),
                remedy=f'write the unit: {key} = "{limit:g} {before}" if that was meant',
            )


def _in_unit(limit: float | str, unit: str, where: str) -> float:
    from tmmcalc.naming.rows import in_unit
    from tmmcalc.spec.units import UnitError

    try:
        return in_unit(limit, unit)
    except UnitError:
        told = f"in {unit}" if unit else "a bare number"
        raise UsageError(
            f"{limit!r} cannot be compared: the quantity is {told}", where=where, remedy=f"write a number {told}"
        ) from None
