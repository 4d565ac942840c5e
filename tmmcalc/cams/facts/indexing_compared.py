"""The reference tables of indexing drives: one law over numbers of rollers, then all laws, for people in parts."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from tmmcalc.cams.indexing.compare import Compared, at_ratio, compared_columns
from tmmcalc.core.columns import picked
from tmmcalc.report.document import Document, View
from tmmcalc.report.numbers import number

MECHANISM = ("ratio", "start", "tip", "takeover", "source")  # columns of the mechanism at one lambda
LIMITS = {"z2_max": "z2_max", "fits": "possible"}
SOURCE = (
    "note: source2 is theta2 as the printed tables have it, with +beta' in place of -beta': too large where cams and "
    "wheel turn oppositely"
)


def comparison_document(
    rows: tuple[Compared, ...], title: str, patterns: Sequence[str] = (), *, everything: bool = False
) -> Document:
    """Laws and numbers of rollers at both ends of lambda, at that of the task if it has one, and the limits.

    With ``patterns``, which choose columns by name, or ``everything`` one table; else a part for each.
    """
    columns = compared_columns(rows)
    if everything or patterns:
        chosen = picked(columns, patterns)
        return Document(title, notes=(SOURCE,), table=View(list(chosen), list(chosen.values())))
    return Document(title, notes=(SOURCE,), parts=tuple(_parts(rows, columns)))


def _parts(rows: tuple[Compared, ...], columns: Mapping[str, Sequence[Any]]) -> Iterator[Document]:
    ends = {"min": "at lambda_min", "max": "at lambda_max, where theta1m reaches its limit"}
    for end, title in ends.items():
        yield _part(title, columns, {"B": "B", **_named(end, MECHANISM)})
    given = rows[0].given
    if given is not None:
        yield _part(f"at lambda = {number(given.ratio, 6)}", columns, _named("given", MECHANISM[1:]) | _steps("given"))
    ratios = {"lambda from": at_ratio("ratio", "_min")[0], "to": at_ratio("ratio", "_max")[0]}
    yield _part("limits, those of phi_p at lambda_max", columns, ratios | _steps("max") | LIMITS)


def _named(end: str, names: Sequence[str]) -> dict[str, str]:
    """Columns at one lambda by what they are called in a table that has no other."""
    return {at_ratio(name, "")[0]: at_ratio(name, f"_{end}")[0] for name in names}


def _steps(end: str) -> dict[str, str]:
    low, high = (at_ratio(name, f"_{end}")[0] for name in ("step_min", "step_max"))
    return {"phi_p from[deg]": low, "to [deg]": high}


def _part(title: str, columns: Mapping[str, Sequence[Any]], chosen: Mapping[str, str]) -> Document:
    """A table of laws, numbers of rollers and the columns that are chosen, by what they are called in it."""
    named = {"law": "law", "z2": "z2", **chosen}
    return Document(title, table=View(list(named), [columns[header] for header in named.values()]))
