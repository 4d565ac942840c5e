"""Cells of tables for spreadsheets, which take some texts for formulas."""

from __future__ import annotations

from typing import Any

from tmmcalc.core.printable import printable

FORMULAS = ("=", "+", "-", "@", "\t", "\r")  # what cells that are worked out begin with


def harmless(cell: Any) -> Any:
    """A cell of one line that no spreadsheet works out: such a text begins with an apostrophe; numbers stay.

    >>> harmless("=HYPERLINK(0)"), harmless("Ada"), harmless(-2.5)
    ("'=HYPERLINK(0)", 'Ada', -2.5)
    """
    if not isinstance(cell, str):
        return cell
    shown = printable(cell).replace("\n", " ")
    return f"'{shown}" if shown.lstrip().startswith(FORMULAS) or cell.startswith(FORMULAS) else shown
