"""Constraints in the note: each with its value, its limits and what is left to them, the rule, and what follows."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from tmmcalc.feasibility.facts.feasibility import TRUTH
from tmmcalc.feasibility.judge import Feasibility, Verdict
from tmmcalc.feasibility.notes.worded import worded
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.formula.digits import RESULT, Given, significant
from tmmcalc.report.language import tr, tr_name, tr_unit
from tmmcalc.report.manuscript import Block, Paragraph, Result, Table
from tmmcalc.report.printing import printed_as

MARGIN = 3  # digits of what is left [%]
CONNECTIVES = ("and", "or", "not")


def blocks(order: Order) -> Iterator[Block]:
    """All constraints as a table, the rule with its verdict, and those that the rule asks for as main results."""
    result: Feasibility = order.results["feasibility"]
    yield Paragraph(tr("The constraints of the task, with the values that were found, are in table {tab:constraints}."))
    head = (
        tr("Named constraint"),
        tr("Quantity"),
        tr("Value"),
        tr("at least"),
        tr("at most"),
        tr("Margin, %"),
        tr("Kept"),
    )
    yield Table(tr("Constraints"), head, tuple(map(_row, result.verdicts)), key="constraints")
    if _is_combined(result):
        yield Paragraph(tr("The constraints are combined by the rule: {rule}.", rule=_spelt(result.rule)))
    yield Paragraph(" ".join(_concluded(result)))
    for verdict in result.verdicts:
        yield from _main(verdict, result)


def _row(verdict: Verdict) -> tuple[str, ...]:
    """A constraint; what is left is a part of the nearer limit. A truth has no numbers."""
    kept = tr("yes") if verdict.holds else tr("no")
    if verdict.quantity == TRUTH:
        said = tr("given as true") if verdict.value > 0 else tr("given as false")
        return verdict.name, said, "", "", "", "", kept
    numbers = (_number(each, verdict.unit) for each in (verdict.value, verdict.at_least, verdict.at_most))
    left = f"${significant(100 * verdict.margin, MARGIN)}$"
    return verdict.name, worded(verdict.quantity), *numbers, left, kept


def _number(value: float | None, unit: str) -> str:
    """A value in the unit in which it is printed; empty without one."""
    if value is None:
        return ""
    printed, factor = printed_as(unit)
    digits = f"${significant(factor * value, RESULT)}$"
    return f"{digits}°" if printed == "deg" else f"{digits} {tr_unit(printed)}".rstrip()


def _is_combined(result: Feasibility) -> bool:
    """Whether the rule is another than that all constraints hold."""
    return result.rule != " and ".join(verdict.name for verdict in result.verdicts)


def _spelt(rule: str) -> str:
    """The rule with its connectives in the language."""
    return re.sub(rf"\b(?:{'|'.join(CONNECTIVES)})\b", lambda word: tr_name(word[0]), rule)


def _concluded(result: Feasibility) -> Sequence[str]:
    """Whether all that is asked holds; of several solutions how many keep it, and which is taken."""
    failing = ", ".join(result.failing)
    if result.feasible:
        said = [tr("The rule holds.") if _is_combined(result) else tr("All constraints are kept.")]
    elif _is_combined(result):
        said = [tr("The rule does not hold; at fault: {failing}.", failing=failing)]
    else:
        said = [tr("Constraints that are not kept: {failing}.", failing=failing)]
    if len(result.candidates) > 1:
        values = {"good": sum(each.feasible for each in result.candidates), "count": len(result.candidates)}
        taken = tr(
            "Solutions that keep what is asked: {good} of {count}; number {n} is taken.", **values, n=result.chosen
        )
        said.append(taken)
    return said


def _main(verdict: Verdict, result: Feasibility) -> Iterator[Result]:
    """A row of the conclusions for each limit, unless the rule does without it or excludes what it says."""
    at_fault = verdict.name in result.failing
    if verdict.quantity == TRUTH or verdict.holds is at_fault:
        return
    meaning = tr("constraint {name}, {quantity}", name=verdict.name, quantity=worded(verdict.quantity))
    given = Given(verdict.value, verdict.unit, meaning)
    for limit, sense in ((verdict.at_least, ">="), (verdict.at_most, "<=")):
        if limit is not None:
            yield Result("", given, limit, sense)
