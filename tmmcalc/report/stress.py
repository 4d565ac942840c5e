"""The document of a stress test: where digits go, and every rung of every ladder.

The table on top has a row for every stage that loses more than three digits on a ladder: what it loses on an ordinary
rung and on its worst, with the condition number and the stage's own estimate there, and whether the program tells it.
"""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.report.document import Document, Fact, View
from tmmcalc.stress.results import ERROR, FAULT, LIMITS, OK, WARNING, Ladder, Loss, Met, Rung, Stress

TOLD = (
    "ladder", "setting", "size", "condition", "stage", "status", "code", "error", "quantity", "estimate", "told",
    "message",
)  # fmt: skip
KEPT = 1e-12  # observed errors up to that are no loss to speak of
# how reasons begin that say no more than the name of a ladder
LACKS = ("the scene has n", "the motor of the scene has no", "no linkage is sought")
LOSSES = ("ladder", "stage", "error at first", "at worst", "condition", "estimate", "told by", "of", "on rung")


def stress_document(result: Stress, title: str) -> Document:
    """What is lost where; then one part a ladder: its rungs with the worst stage of each, and the errors met."""
    facts = [Fact("ladders", ", ".join(ladder.name for ladder in result.ladders) or "none")]
    facts += _without(result)
    count = len(result.faults)
    facts.append(Fact("faults of the program", str(count) if count else "none", {"faults": count}))
    lost = [(ladder, loss) for ladder in result.ladders for loss in ladder.losses() if (loss.met.error or 0.0) > KEPT]
    facts.append(_kept(result, {(ladder.name, loss.stage) for ladder, loss in lost}))
    notes = tuple(f"warning: {name}, {rung.setting}: {met.stage}: {met.message}" for name, rung, met in result.faults)
    table = View(LOSSES, _transposed([_row(*each) for each in lost], LOSSES)) if lost else None
    return Document(title, tuple(facts), notes, table, parts=tuple(_part(ladder) for ladder in result.ladders))


def tidy_stress(result: Stress, title: str) -> Document:
    """One table of all stages on all rungs, for programs; what does not apply is empty."""
    rows = [
        (ladder.name, rung.setting, rung.size, rung.condition, met.stage, met.status, met.code, met.error, met.quantity,
         met.estimate, met.told, met.message)
        for ladder in result.ladders
        for rung in ladder.rungs
        for met in rung.met
    ]  # fmt: skip
    columns = [["" if cell is None else cell for cell in column] for column in zip(*rows, strict=True)]
    return Document(title, table=View(TOLD, columns or [[] for _ in TOLD]))


def _without(result: Stress) -> Iterator[Fact]:
    """The ladders that the scene has not: those of other kinds of scene by name, the rest with their reasons."""
    plain = [(name, reason) for name, reason in result.without if reason.startswith(LACKS)]
    if plain:
        names = ", ".join(name for name, _ in plain)
        yield Fact("of other scenes", names, {f"without_{name}": reason for name, reason in plain})
    for name, reason in result.without:
        if not reason.startswith(LACKS):
            yield Fact(f"no {name}", reason, {f"without_{name}": reason})


def _kept(result: Stress, lost: set[tuple[str, str]]) -> Fact:
    """The worst of all stages that lose nothing to speak of."""
    others = [loss for ladder in result.ladders for loss in ladder.losses() if (ladder.name, loss.stage) not in lost]
    largest = max((loss.met.error or 0.0 for loss in others), default=0.0)
    every = "all other stages on all ladders" if lost else "all stages on all ladders"
    text = f"{every} keep twelve digits: errors up to {largest:.1e}" if others else "nothing could be compared"
    return Fact("digits", text, {"largest_of_the_others": largest})


def _row(ladder: Ladder, loss: Loss) -> tuple[str, ...]:
    met = loss.met
    condition = "" if loss.rung.condition is None else f"{loss.rung.condition:.1e}"
    return (
        ladder.name, loss.stage, _power(loss.ordinary), _power(met.error), condition, _power(met.estimate),
        _teller(met), met.quantity, loss.rung.setting,
    )  # fmt: skip


def _teller(met: Met) -> str:
    """What tells of the loss: the estimate that is as large, a warning, or nothing."""
    if met.estimate is not None and met.error is not None and met.estimate >= met.error:
        return "estimate"
    return {OK: "nothing", WARNING: "warning"}.get(met.status, met.status)


def _transposed(rows: list[tuple[str, ...]], headers: tuple[str, ...]) -> list[list[str]]:
    return [[row[k] for row in rows] for k in range(len(headers))]


def _part(ladder: Ladder) -> Document:
    facts = (Fact("observed error", f"against {ladder.against}"), *_degraded(ladder))
    return Document(f"{ladder.name}: {ladder.title}", facts, tuple(_messages(ladder)), _view(ladder))


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
    """Errors by name, each once with its first rung."""
    said: set[tuple[str, int]] = set()
    for rung in ladder.rungs:
        for met in rung.met:
            if met.status in (ERROR, FAULT) and (met.stage, met.code) not in said:
                said.add((met.stage, met.code))
                yield f"{rung.setting}: exit code {met.code}, {met.message}"


def _view(ladder: Ladder) -> View:
    answers = [rung.answer for rung in ladder.rungs]
    headers = ["rung", ladder.condition, "worst", "error", "estimate", "ends"]
    worst = [_worst(rung) for rung in ladder.rungs]
    columns: list[list[str]] = [
        [rung.setting for rung in ladder.rungs],
        ["" if rung.condition is None else f"{rung.condition:.1e}" for rung in ladder.rungs],
        ["" if met is None else f"{met.stage}, {met.quantity}" for met in worst],
        [_power(None if met is None else met.error) for met in worst],
        [_power(None if met is None else met.estimate) for met in worst],
        [_ends(rung) for rung in ladder.rungs],
    ]
    return View([*headers, "answer"], [*columns, answers]) if any(answers) else View(headers, columns)


def _worst(rung: Rung) -> Met | None:
    return max((met for met in rung.met if met.error is not None), key=lambda met: met.error or 0.0, default=None)


def _power(value: float | None) -> str:
    return "" if value is None else f"{value:.1e}"


def _ends(rung: Rung) -> str:
    """How the stages of a rung end, those that are well left out."""
    words = [f"{met.stage}: exit {met.code}" for met in rung.met if met.status in (ERROR, FAULT)]
    warned = sum(met.status == WARNING for met in rung.met)
    return ", ".join([*words, *([f"{warned} warned"] if warned else [])]) or "ok"
