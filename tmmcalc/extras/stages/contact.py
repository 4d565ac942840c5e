"""Stage ``contact``: pressure and approach of two elastic bodies by boundary integral equations."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from tmmcalc.core.conversion import plain
from tmmcalc.core.numerics.extended import EPS
from tmmcalc.extras.contact import Contact, ContactTask, solve_contact

if TYPE_CHECKING:
    from tmmcalc.extras.room import ExtraTables


def inputs(spec: ExtraTables) -> ContactTask:
    """What the table says, in SI."""
    from tmmcalc.extras.tables.tasks.extras import to_contact

    return to_contact(spec)


def solve(given: ContactTask, upstream: Mapping[str, Any], settings: Mapping[str, Any]) -> Contact:
    """All of it."""
    return solve_contact(given)


def errors(result: Contact) -> dict[str, Any]:
    """Estimates of its errors."""
    return {**plain(result.error), "load": max(result.load_error, EPS)}


def columns(result: Contact) -> Mapping[str, Any]:
    """One row a node of the grid."""
    from tmmcalc.extras.columns import contact_columns

    return contact_columns(result)


def packages(spec: ExtraTables) -> tuple[str, ...]:
    """Hertz's ellipse has elliptic integrals; a table of the gap is a spline."""
    table = spec.contact
    if table is None:
        return ()
    return (
        ("scipy.optimize", "scipy.special")
        if table.radii is not None
        else ("scipy.interpolate",)
        if table.table is not None
        else ()
    )
