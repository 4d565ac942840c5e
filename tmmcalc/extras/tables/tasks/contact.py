"""From ``[contact]`` to the bodies, their load and the gap between them."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmmcalc.core.errors import UsageError

if TYPE_CHECKING:
    from tmmcalc.extras.contact import ContactTask
    from tmmcalc.extras.room import ExtraTables


def to_contact(spec: ExtraTables) -> ContactTask:
    """The contact of the spec; raises `UsageError` if it has none."""
    from tmmcalc.extras.contact import ContactTask, GapTable
    from tmmcalc.extras.hertz import composite_modulus

    table = spec.contact
    if table is None:
        raise UsageError("the spec has no [contact]", remedy="add [contact] with load and radii")
    given = table.table
    (first, second), (nu, other) = table.young, table.poisson
    return ContactTask(
        load=table.load,
        modulus=composite_modulus((first, second), (nu, other)) if table.modulus is None else table.modulus,
        radii=None if table.radii is None else (table.radii[0], table.radii[-1]),
        formula=table.gap or "",
        table=None if given is None else GapTable(tuple(given.x), tuple(given.y), tuple(map(tuple, given.h))),
        cells=table.cells,
        size=table.size,
    )
