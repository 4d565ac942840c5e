"""Stage ``contact``: pressure and approach of two elastic bodies by boundary integral equations."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from tmmcalc.core.conversion import plain
from tmmcalc.core.numerics.extended import EPS
from tmmcalc.extras.contact import Contact, solve_contact
from tmmcalc.extras.tables.tasks.contact import to_contact

if TYPE_CHECKING:
    from tmmcalc.extras.room import ExtraTables

inputs = to_contact
solve = solve_contact
kind = Contact
columns = "tmmcalc.extras.columns:contact_columns"
declares = ()


def errors(result: Contact) -> dict[str, Any]:
    """Estimates of its errors."""
    return {**plain(result.error), "load": max(result.load_error, EPS)}


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
