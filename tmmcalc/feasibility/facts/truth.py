"""The document of a rule by plain logic: its short form, and a row a combination of truths."""

from __future__ import annotations

from tmmcalc.core.quantity import keyed, quantity_of
from tmmcalc.feasibility.truth import TruthTable
from tmmcalc.report.document import Document, Fact, View


def truth_document(result: TruthTable, title: str) -> Document:
    """The table, 1 where a constraint or the rule holds; the combination that the spec has is marked."""
    rows, kept = len(result.holds), bool(result.holds[result.now])
    facts = (
        Fact("rule", result.rule, keyed(result, "rule")),
        Fact("short form", result.short, keyed(result, "short")),
        Fact("holds in", f"{result.count} of {rows} combinations", {"combinations": rows, "holding": result.count}),
        Fact("now", f"{'holds' if kept else 'does not hold'}, in the row that is marked", {"row": result.now}),
    )
    notes = () if kept else ("warning: the rule does not hold",)
    columns = [column.astype(int).tolist() for column in (*result.states.T, result.holds)]
    marks = ["*" if row == result.now else "" for row in range(rows)]
    headers = [*result.names, quantity_of(TruthTable, "holds").key, "now"]
    return Document(title, facts, notes, View(headers, [*columns, marks]))
