"""Stage ``contact``: pressure and approach of two elastic bodies by boundary integral equations."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from tmmcalc.core.conversion import from_record, plain, to_record
from tmmcalc.core.numerics.extended import EPS
from tmmcalc.core.stage import Record, Table
from tmmcalc.extras.contact import Contact, ContactTask, solve_contact

if TYPE_CHECKING:
    from tmmcalc.project import Spec


def inputs(spec: Spec) -> ContactTask:
    """What the table says, in SI."""
    from tmmcalc.extras.tables.tasks.extras import to_contact

    return to_contact(spec)


def solve(given: ContactTask, upstream: Mapping[str, Any], settings: Mapping[str, Any]) -> Contact:
    """All of it."""
    return solve_contact(given)


def dump(result: Contact) -> Record:
    """Arrays by the names of the fields."""
    return to_record(result, {**plain(result.error), "load": max(result.load_error, EPS)})


def load(record: Record) -> Contact:
    """Build the result from its record."""
    result: Contact = from_record(Contact, record)
    return result


def table(result: Contact) -> Table:
    """One row a node of the grid."""
    from tmmcalc.extras.columns import contact_columns

    columns = contact_columns(result)
    return Table(list(columns), list(columns.values()))
