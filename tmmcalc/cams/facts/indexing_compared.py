"""The reference tables of indexing drives: one law over numbers of rollers, then all laws, for people in parts."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from tmmcalc.cams.indexing.compare import Compared, compared_columns
from tmmcalc.core.columns import picked
from tmmcalc.report.document import Document, View
from tmmcalc.report.numbers import number

AT = {  # columns at one lambda, by their names in all columns
    "lambda": "lambda_{}",
    "theta1m[deg]": "theta1m_{}[deg]",
    "k_m": "k_m_{}",
    "theta2[deg]": "theta2_{}[deg]",
    "source2[deg]": "source2_{}[deg]",
}
LIMITS = {
    "lambda from": "lambda_min",
    "to": "lambda_max",
    "phi_p from[deg]": "least_step_max[deg]",
    "to [deg]": "largest_step_max[deg]",
    "z2_max": "z2_max",
    "fits": "possible",
}
STEPS = {"phi_p from[deg]": "least_step_given[deg]", "to [deg]": "largest_step_given[deg]"}
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
        yield _part(title, columns, {"B": "B", **{header: name.format(end) for header, name in AT.items()}})
    given = rows[0].given
    if given is not None:
        own = {header: name.format("given") for header, name in AT.items() if header != "lambda"}
        yield _part(f"at lambda = {number(given.ratio, 6)}", columns, own | STEPS)
    yield _part("limits, those of phi_p at lambda_max", columns, LIMITS)


def _part(title: str, columns: Mapping[str, Sequence[Any]], chosen: Mapping[str, str]) -> Document:
    """A table of laws, numbers of rollers and the columns that are chosen, by what they are called in it."""
    named = {"law": "law", "z2": "z2", **chosen}
    return Document(title, table=View(list(named), [columns[header] for header in named.values()]))
