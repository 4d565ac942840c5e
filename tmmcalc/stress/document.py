"""The document of a stress test: where digits go, and every rung of every ladder.

The table on top has a row for every stage that loses more than three digits on a ladder: what it loses on an ordinary
rung and on its worst, with the condition number, the stage's own estimate and what it says of the last digit of the
data there, and whether the program tells it: the loss is compared with the sum of both.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import fields
from typing import Any

from tmmcalc.report.document import Document, Fact, View
from tmmcalc.stress.results import DISPUTED, ERROR, FAULT, LIMITS, WARNING, Ladder, Loss, Met, Rung, Stress

TOLD = (
    "ladder", "setting", "size", "condition", "stage", "status", "code", "error", "quantity", "estimate", "last_digit",
    "told", "message", "skipped",
)  # fmt: skip
KEPT = 1e-12  # observed errors up to that are no loss to speak of
# how reasons begin that say no more than the name of a ladder
LACKS = ("the scene has n", "the motor of the scene has no", "no linkage is sought")
DIGIT = "last digit"  # column of what the last digit of the data does
LOSSES = ("ladder", "stage", "error at first", "at worst", "condition", "estimate", DIGIT, "told by", "of", "on rung")
POWERS = ("error at first", "at worst", "condition", "estimate", DIGIT)  # columns of many magnitudes
SELDOM = ("not compared", "answer", DIGIT)  # columns that are left out where they say nothing
MOST_NAMED = 4  # quantities in a note


def stress_document(result: Stress, title: str) -> Document:
    """What is lost where; then one part a ladder: its rungs with the worst stage of each, and the errors met."""
    facts = [Fact("ladders", ", ".join(ladder.name for ladder in result.ladders) or "none")]
    facts += _without(result)
    count = len(result.faults)
    facts.append(Fact("faults of the program", str(count) if count else "none", {"faults": count}))
    facts += _disputed(result)
    lost = [(ladder, loss) for ladder in result.ladders for loss in ladder.losses() if (loss.met.error or 0.0) > KEPT]
    facts.append(_digits_kept(result, {(ladder.name, loss.stage) for ladder, loss in lost}))
    notes = tuple(f"warning: {name}, {rung.setting}: {met.stage}: {met.message}" for name, rung, met in result.faults)
    rows = [_row(*each) for each in lost]
    table = View(LOSSES, list(zip(*rows, strict=True)), scientific=POWERS) if rows else None
    return Document(title, tuple(facts), notes, table, parts=tuple(_part(ladder) for ladder in result.ladders))


def tidy_stress(result: Stress, title: str) -> Document:
    """One table of all stages on all rungs, for programs; what does not apply is empty."""
    rows = [
        (ladder.name, rung.setting, rung.size, rung.condition, met.stage, met.status, met.code, met.error, met.quantity,
         met.estimate, met.last_digit, met.told, met.message, "; ".join(met.skipped) or rung.note)
        for ladder in result.ladders
        for rung in ladder.rungs
        for met in rung.met
    ]  # fmt: skip
    columns = [_cells(column) for column in zip(*rows, strict=True)]
    return Document(title, table=View(TOLD, columns or [[] for _ in TOLD]))


def _cells(values: Sequence[Any]) -> list[Any]:
    """A column; what does not apply is empty."""
    return ["" if value is None else value for value in values]


def _disputed(result: Stress) -> Iterator[Fact]:
    count = len(result.disputed)
    if count:
        told = dict.fromkeys(f"{met.stage} on {name}" for name, _, met in result.disputed)
        yield Fact("disputed", f"{', '.join(told)}: refused by the equivalent scene", {"disputed": count})


def _without(result: Stress) -> Iterator[Fact]:
    """The ladders that the scene has not: those of other kinds of scene by name, the rest with their reasons."""
    plain = [(name, reason) for name, reason in result.without if reason.startswith(LACKS)]
    if plain:
        names = ", ".join(name for name, _ in plain)
        yield Fact("of other scenes", names, {f"without_{name}": reason for name, reason in plain})
    for name, reason in result.without:
        if not reason.startswith(LACKS):
            yield Fact(f"no {name}", reason, {f"without_{name}": reason})


def _digits_kept(result: Stress, lost: set[tuple[str, str]]) -> Fact:
    """The worst of all stages that lose nothing to speak of."""
    others = [loss for ladder in result.ladders for loss in ladder.losses() if (ladder.name, loss.stage) not in lost]
    largest = max((loss.met.error or 0.0 for loss in others), default=0.0)
    every = "all other stages on all ladders" if lost else "all stages on all ladders"
    none = "nothing else is compared" if lost else "nothing could be compared"
    text = f"{every} keep twelve digits: errors up to {largest:.1e}" if others else none
    return Fact("digits", text, {"largest_of_the_others": largest})


def _row(ladder: Ladder, loss: Loss) -> list[Any]:
    met = loss.met
    return _cells((
        ladder.name, loss.stage, loss.ordinary, met.error, loss.rung.condition, met.estimate, met.last_digit,
        _teller(met), met.quantity, loss.rung.setting,
    ))  # fmt: skip


def _teller(met: Met) -> str:
    """What tells of the loss: the estimate, alone or with the last digit of the data, a warning, or nothing."""
    if met.error is not None and met.estimate is not None and met.covered is not None:
        if met.estimate >= met.error:
            return "estimate"
        if met.covered >= met.error:
            return "both"
    return "warning" if met.status == WARNING else "nothing"


def _part(ladder: Ladder) -> Document:
    values = {"against": ladder.against, "rungs": [_plain(rung) for rung in ladder.rungs]}
    facts = (Fact("observed error", f"against {ladder.against}", values), *_degraded(ladder))
    notes = (*_messages(ladder), *_uncompared(ladder))
    return Document(f"{ladder.name}: {ladder.title}", facts, notes, _view(ladder))


def _plain(row: Rung | Met) -> dict[str, Any]:
    """The fields of a record that say something, by name, with all their digits."""
    values = {field.name: getattr(row, field.name) for field in fields(row)}
    if isinstance(row, Rung):
        values["met"] = [_plain(met) | {"told": met.told} for met in row.met]
    return {
        name: list(value) if isinstance(value, tuple) else value
        for name, value in values.items()
        if value not in (None, "", ())
    }


def _degraded(ladder: Ladder) -> Iterator[Fact]:
    """One line a limit: the stages that pass it, each with its rung."""
    met = list(ladder.degraded())
    for limit in LIMITS:
        beyond = [each for each in met if each.limit == limit]
        values = {
            f"beyond_{limit:.0e}": [
                {"stage": each.stage, "setting": each.rung.setting, "told": each.told} for each in beyond
            ]
        }
        text = "; ".join(
            f"{each.stage} from {each.rung.setting} on{'' if each.told else ' (not told)'}" for each in beyond
        )
        if text or limit == LIMITS[0]:
            yield Fact(f"error beyond {limit:.0e}", text or "nowhere", values)


def _messages(ladder: Ladder) -> Iterator[str]:
    """Errors by name, and results that are disputed, each once with its first rung."""
    said: set[tuple[str, int]] = set()
    for rung in ladder.rungs:
        for met in rung.met:
            if met.status in (DISPUTED, ERROR, FAULT) and (met.stage, met.code) not in said:
                said.add((met.stage, met.code))
                how = f"{met.stage} is disputed" if met.status == DISPUTED else f"exit code {met.code}"
                yield f"{rung.setting}: {how}, {met.message}"


def _uncompared(ladder: Ladder) -> Iterator[str]:
    """What has nothing to be compared with, each once with its first rung."""
    said: set[tuple[str, ...]] = set()
    for rung in ladder.rungs:
        if rung.note and (rung.note,) not in said:
            said.add((rung.note,))
            yield f"{rung.setting}: {rung.note}"
        for met in rung.met:
            if met.skipped and (met.stage, *met.skipped) not in said:
                said.add((met.stage, *met.skipped))
                yield f"{rung.setting}: not compared in {met.stage}: {_listed(met.skipped)}"


def _listed(names: Sequence[str]) -> str:
    more = len(names) - MOST_NAMED
    return ", ".join(names[:MOST_NAMED]) + (f" and {more} more" if more > 0 else "")


def _view(ladder: Ladder) -> View:
    worst = [_worst(rung) for rung in ladder.rungs]
    columns: dict[str, list[Any]] = {
        "rung": [rung.setting for rung in ladder.rungs],
        ladder.condition: _cells([rung.condition for rung in ladder.rungs]),
        "worst": ["" if met is None else f"{met.stage}, {met.quantity}" for met in worst],
        "error": _cells([None if met is None else met.error for met in worst]),
        "estimate": _cells([None if met is None else met.estimate for met in worst]),
        DIGIT: _cells([None if met is None else met.last_digit for met in worst]),
        "ends": [_ends(rung) for rung in ladder.rungs],
        "not compared": [sum(len(met.skipped) for met in rung.met) for rung in ladder.rungs],
        "answer": [rung.answer for rung in ladder.rungs],
    }
    told = {name: cells for name, cells in columns.items() if name not in SELDOM or any(cells)}
    return View(list(told), list(told.values()), scientific=(ladder.condition, "error", "estimate", DIGIT))


def _worst(rung: Rung) -> Met | None:
    return max((met for met in rung.met if met.error is not None), key=lambda met: met.error or 0.0, default=None)


def _ends(rung: Rung) -> str:
    """How the stages of a rung end, those that are well left out."""
    words = [f"{met.stage}: exit {met.code}" for met in rung.met if met.status in (ERROR, FAULT)]
    words += [f"{met.stage}: disputed" for met in rung.met if met.status == DISPUTED]
    warned = sum(met.status == WARNING for met in rung.met)
    return ", ".join([*words, *([f"{warned} warned"] if warned else [])]) or "ok"
