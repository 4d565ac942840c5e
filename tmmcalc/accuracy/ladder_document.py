"""The document of a ladder of stiffness: what the textbook's fixed step would take beside the program's choice."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import fields
from typing import Any

from tmmcalc.core.studies.study import Ladder, Rung
from tmmcalc.report.document import Document, Fact, View
from tmmcalc.report.numbers import number


def ladder_document(ladder: Ladder) -> Document:
    """The limit of the textbook's step and how it falls, the cost of the choice, a table with a row a rung."""
    rungs = [_plain(rung) for rung in ladder.rungs]
    facts = (
        Fact(
            "reference",
            f"{ladder.reference.name}, error {ladder.reference.error:.1e}",
            {"reference": ladder.reference.name, "reference_error": ladder.reference.error},
        ),
        _textbook_fact(ladder),
        _choice_fact(ladder),
        Fact("rungs", f"{len(rungs)}, motion of {number(ladder.duration)} s", {"rungs": rungs}),
    )
    notes = ("estimated: a shaft swings too fast to be followed and is taken as rigid",)
    return Document(
        f"{ladder.stage}, ladder: {ladder.quantity}",
        facts,
        notes if any(not rung.reference for rung in ladder.rungs) else (),
        _view(ladder),
    )


def _plain(rung: Rung) -> dict[str, Any]:
    values = {field.name: getattr(rung, field.name) for field in fields(rung)}
    return {name: value for name, value in values.items() if value not in (None, "")}


def ladder_rows(ladder: Ladder) -> Iterator[tuple[Any, ...]]:
    """Rows for programs: the program's choice on every rung, then the textbook's step; columns of `TOLD`."""
    head = (ladder.stage, f"ladder: {ladder.quantity}", ladder.reference.name, ladder.reference.error)
    for rung in ladder.rungs:
        setting = f"{rung.value:.0e} {ladder.unit}"
        name = f"choice of the program, {rung.method}"
        yield (*head, name, setting, rung.value, rung.error, rung.seconds, None, rung.evaluations, None, None, "", "")
    for rung in ladder.rungs:
        setting, name = f"{rung.value:.0e} {ladder.unit}", f"fixed step of {number(ladder.step)} s"
        count, fails = rung.textbook_evaluations, rung.textbook_fails
        yield (*head, name, setting, rung.value, rung.textbook_error, None, None, count, None, None, fails, "")


def _textbook_fact(ladder: Ladder) -> Fact:
    limits = [rung.limit for rung in ladder.rungs]
    steps = [rung.steps for rung in ladder.rungs]
    text = f"a step of {number(ladder.step)} s is asked for, the limit of stability falls from {max(limits):.3g} s to "
    text += f"{min(limits):.3g} s: {max(steps):.3g} steps in place of {ladder.duration / ladder.step:.3g}"
    if ladder.power is not None:
        text += f"\nthe limit goes as the value to the power {number(ladder.power, 2)} where that is the fast part"
    values = {"step_asked[s]": ladder.step, "limit_least[s]": min(limits), "limit_power": ladder.power}
    return Fact("fixed steps of the textbook", text, values)


def _choice_fact(ladder: Ladder) -> Fact:
    counts = [rung.evaluations for rung in ladder.rungs]
    worst = max(rung.error for rung in ladder.rungs)
    text = f"{min(counts)} to {max(counts)} evaluations, largest error {worst:.1e}"
    return Fact("choice of the program", text, {"evaluations_most": max(counts), "error_worst": worst})


def _view(ladder: Ladder) -> View:
    rungs = ladder.rungs
    headers = [
        f"value[{ladder.unit}]",
        "fastest[s]",
        "limit[s]",
        "steps",
        f"error at {number(ladder.step)} s",
        "choice",
        "evaluations",
        "time[ms]",
        "error",
    ]
    columns: list[list[str]] = [
        [f"{rung.value:.0e}" for rung in rungs],
        [f"{rung.fastest:.2e}" for rung in rungs],
        [f"{rung.limit:.2e}" for rung in rungs],
        [f"{rung.steps:.3g}" for rung in rungs],
        [_asked(rung) for rung in rungs],
        [f"{rung.method}, rigid" if rung.rigid else rung.method for rung in rungs],
        [str(rung.evaluations) for rung in rungs],
        [f"{rung.seconds * 1e3:.3g}" for rung in rungs],
        [f"{rung.error:.1e}" if rung.reference else f"{rung.error:.1e} est." for rung in rungs],
    ]
    return View(headers, columns)


def _asked(rung: Rung) -> str:
    if rung.textbook_error is not None:
        return f"{rung.textbook_error:.1e}"
    return "unstable" if rung.textbook_fails else "not known"
