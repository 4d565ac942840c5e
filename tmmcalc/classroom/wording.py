"""The words of marks for people, in the language in force; in files for programs they stand as they are."""

from __future__ import annotations

from typing import Any

from tmmcalc.classroom.verdicts import Standing
from tmmcalc.report.language import tr, tr_number, tr_unit
from tmmcalc.report.numbers import number

KNOWN = frozenset(map(str, Standing))
NONE = "nothing was handed in"  # in place of a file


def _titles() -> dict[str, str]:
    return {
        "marks": tr("Marks"),
        "marks, with the key": tr("Marks, with the key"),
        "answers": tr("Answers"),
        "mistakes": tr("Mistakes"),
        "items": tr("Asked results"),
        "common mistakes": tr("Common mistakes"),
        "remarks": tr("Remarks"),
    }


def _headers() -> dict[str, str]:
    return {
        "variant": tr("Variant"),
        "student": tr("Student"),
        "points": tr("Points for it"),
        "of": tr("Out of"),
        "file": tr("File"),
        "counts": tr("Counts"),
        "item": tr("Name"),
        "items": tr("Asked results"),
        "unit": tr("Unit"),
        "answer": tr("Answer"),
        "right": tr("Right value"),
        "off": tr("Off by"),
        "off by": tr("Off by"),
        "is": tr("It is"),
        "why": tr("Why"),
        "mistake": tr("Mistake"),
        "against it": tr("Against it"),
        "odds": tr("Odds"),
        "share of points": tr("Share of points"),
        "students": tr("Students"),
        "variants": tr("Variants"),
        "what": tr("Whose"),
        "remark": tr("Remark"),
    }


def title_of(sheet: str) -> str:
    """What a table is called."""
    return _titles().get(sheet, sheet)


def header_of(header: str, sheet: str) -> str:
    """What stands over a column of a table."""
    if sheet == "items" and header in KNOWN:
        said = standing_said(Standing(header))
        return said[:1].upper() + said[1:]
    if sheet == "remarks" and header == "of":
        return tr("About")
    name, mark, end = header.rpartition(": ")
    return f"{name}: {tr('It is')}" if mark and end == "is" else _headers().get(header, header)


def standing_said(standing: Standing) -> str:
    """What an answer is, in the language in force."""
    return {
        Standing.right: tr("right answer"),
        Standing.plans: tr("right by plans"),
        Standing.carried: tr("carried on"),
        Standing.wrong: tr("wrong answer"),
        Standing.unreadable: tr("unreadable"),
        Standing.missing: tr("missing"),
    }[standing]


def cell_of(cell: Any, header: str) -> str:
    """What stands in a cell under this header."""
    if isinstance(cell, int | float):
        return number(cell)
    if cell is None:
        return ""
    if header == "unit":
        return tr_unit(cell)
    if header == "counts":
        return tr("yes") if cell == "yes" else tr("no")
    if cell == NONE:
        return tr("nothing was handed in")
    if header in ("off", "off by"):
        return tr_number(cell)
    of_standing = (header == "is" or header.endswith(": is")) and cell in KNOWN
    return standing_said(Standing(cell)) if of_standing else str(cell)
