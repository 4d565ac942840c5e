"""The document of the strength of one train step by step: every factor with its cell of a table or its formula."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import groupby

from tmmcalc.core.quantity import keyed, table
from tmmcalc.gears.facts.strength import together
from tmmcalc.gears.strength.chain import StrengthFactors
from tmmcalc.gears.strength.endurance import Coefficient, Factor
from tmmcalc.report.document import Document, Fact, View
from tmmcalc.report.sizes import quantity

CELL = ("table", "row", "column", "formula", "numbers", "formula_unit")


def factors_document(found: StrengthFactors, title: str, *, everything: bool = False) -> Document:
    """The factors in the order of the calculation; with ``everything`` a row each, as they are declared."""
    teeth, verdict = "/".join(map(str, found.teeth)), "strong enough" if found.accepted else "not strong enough"
    facts = (Fact("train", f"{found.layout}: {teeth}, {verdict}", keyed(found)),)
    if everything:
        columns = {
            **table([each.told for each in found.factors], Coefficient),
            **table(found.factors, Factor, *CELL),
        }
        return Document(title, facts, (), View(list(columns), list(columns.values())))
    return Document(title, (*facts, *_groups(found)))


def _groups(found: StrengthFactors) -> Iterator[Fact]:
    """The factors that follow one another of one wheel, stage or mesh; wheels that have the same ones together."""
    merged: list[tuple[list[str], list[str]]] = []
    for of, own in groupby(found.factors, key=lambda each: each.told.of):
        lines = [f"{each.told.symbol} = {quantity(each.told.value, each.told.unit)}: {_whence(each)}" for each in own]
        if merged and merged[-1][1] == lines:
            merged[-1][0].append(of)
        else:
            merged.append(([of], lines))
    for places, lines in merged:
        yield Fact(together(places), "\n".join(lines))


def _whence(each: Factor) -> str:
    """The cell, the formula and its numbers; of what has neither its source in words."""
    cell = f"Table {each.table}, row {each.row}; {each.column}" if each.table else ""
    if not each.formula:
        return cell or each.told.source
    unit = f" {each.formula_unit}" if each.formula_unit else ""
    formula = f"{each.formula} = {each.numbers}{unit}"
    return f"{cell}: {formula}" if cell else formula
