"""What ``[sheets]`` of a spec wishes to see on them; where it says nothing the pieces choose."""

from __future__ import annotations

from collections.abc import Sequence

from tmmcalc.report.drawing.order import Order
from tmmcalc.report.rows import rows_of


def positions_of(order: Order, labels: Sequence[str]) -> list[int] | None:
    """Indices of the positions of the plans, the first of them that of the forces; None: the spec says nothing.

    ``labels`` are those of the result. Raises `UsageError` for one that is not there.
    """
    sheets = order.spec.sheets
    if sheets is None or not sheets.positions:
        return None
    return rows_of(",".join(sheets.positions), labels, "sheets.positions")


def diagrams_of(order: Order, names: Sequence[str]) -> list[str] | None:
    """The columns of the diagrams, of these ``names``, in the order of the spec; None: it says nothing.

    A pattern may be a name or have wildcards, ``"S_*"``; one that names none of these is meant for another sheet.
    """
    from fnmatch import fnmatchcase

    sheets = order.spec.sheets
    if sheets is None or not sheets.diagrams:
        return None
    return list(dict.fromkeys(name for said in sheets.diagrams for name in names if fnmatchcase(name, said)))
