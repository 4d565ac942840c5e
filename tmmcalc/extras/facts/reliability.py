"""The documents of the reliability: strength, threshold, mean life, lives, its course over the time."""

from __future__ import annotations

from collections.abc import Sequence

from tmmcalc.core.quantity import keyed
from tmmcalc.extras.columns import reliability_columns
from tmmcalc.extras.facts.rows import even, view_of, with_table
from tmmcalc.extras.reliability import Reliability
from tmmcalc.report.document import Document, Fact
from tmmcalc.report.numbers import number


def summary(result: Reliability, title: str) -> Document:
    """Strength, threshold, mean life, lives and reliabilities that are asked for."""
    never = "never" if result.floor is None else f"from {number(result.floor, 8)}"
    lives = ", ".join(f"{number(life)} with {number(part)}" for part, life in result.lives)
    facts = [
        Fact(
            "strength",
            f"r = {number(result.strength, 10)}, beta = {number(result.decay, 10)}",
            keyed(result, "strength", "decay"),
        ),
        Fact("loads", f"from {number(result.low)} to {number(result.high)}", keyed(result, "low", "high")),
        Fact(
            "no failure up to",
            f"t0 = {number(result.threshold, 9)}; every shock is a failure {never}",
            keyed(result, "threshold", "floor"),
        ),
        Fact("mean life", number(result.mean, 9), keyed(result, "mean")),
        Fact("life", lives, {"lives": [{"R": part, "t": life} for part, life in result.lives]}),
    ]
    if result.asked:
        text = "\n".join(f"R({number(t)}) = {number(r, 6)}" for t, r in result.asked)
        facts.append(Fact("reliability", text, {"R_at": [{"t": t, "R": r} for t, r in result.asked]}))
    return Document(title, tuple(facts), result.notes)


def document(
    result: Reliability,
    title: str,
    *,
    patterns: Sequence[str] = (),
    rows: Sequence[int] | None = None,
    everything: bool = False,
    where: str = "",
) -> Document:
    """The summary with the reliability over the time."""
    view = view_of(reliability_columns(result), patterns, rows, everything, even(len(result.t)))
    return with_table(summary(result, title), view, everything or rows is not None)
