"""The document of a stress test: every rung of every ladder, where accuracy degrades, and whether it was told."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.report.document import Document, Fact, View
from tmmcalc.stress.results import ERROR, FAULT, LIMITS, Ladder, Met, Rung, Stress

TOLD = (
    "ladder", "setting", "size", "condition", "stage", "status", "code", "error", "quantity", "estimate", "told",
    "message",
)  # fmt: skip


def stress_document(result: Stress, title: str) -> Document:
    """One part a ladder: its rungs with the worst stage of each, where stages lose digits, and the errors met."""
    facts = [Fact("ladders", ", ".join(ladder.name for ladder in result.ladders) or "none")]
    facts += [Fact(f"no {name}", reason, {f"without_{name}": reason}) for name, reason in result.without]
    count = len(result.faults)
    facts.append(Fact("faults of the program", str(count) if count else "none", {"faults": count}))
    notes = tuple(f"warning: {name}, {rung.setting}: {met.stage}: {met.message}" for name, rung, met in result.faults)
    return Document(title, tuple(facts), notes, parts=tuple(_part(ladder) for ladder in result.ladders))


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
            f"{each.stage} from {each.rung.setting} on{'' if each.told else ' (the estimate did not tell)'}"
            for each in beyond
        )
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
    stages = ladder.stages()
    headers = ["rung", ladder.condition, "worst", "error", "estimate", *(["ends"] if stages else [])]
    worst = [_worst(rung) for rung in ladder.rungs]
    columns: list[list[str]] = [
        [rung.setting for rung in ladder.rungs],
        ["" if rung.condition is None else f"{rung.condition:.1e}" for rung in ladder.rungs],
        ["" if met is None else f"{met.stage}, {met.quantity}" for met in worst],
        [_power(None if met is None else met.error) for met in worst],
        [_power(None if met is None else met.estimate) for met in worst],
        [_ends(rung) for rung in ladder.rungs],
    ]
    return View(headers, columns)


def _worst(rung: Rung) -> Met | None:
    return max((met for met in rung.met if met.error is not None), key=lambda met: met.error or 0.0, default=None)


def _power(value: float | None) -> str:
    return "" if value is None else f"{value:.1e}"


def _ends(rung: Rung) -> str:
    """How the stages of a rung end, those that are well left out."""
    words = [f"{met.stage}: exit {met.code}" for met in rung.met if met.status in (ERROR, FAULT)]
    warned = sum(met.status == "warning" for met in rung.met)
    return ", ".join([*words, *([f"{warned} warned"] if warned else [])]) or "ok"
