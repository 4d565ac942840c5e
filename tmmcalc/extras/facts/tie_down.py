"""The documents of the tie-down: loads and forces of the ties, from which inertia on they slip, slacken, yield."""

from __future__ import annotations

from collections.abc import Sequence
from math import degrees

from tmmcalc.core.quantity import keyed
from tmmcalc.extras.columns import tie_down_columns
from tmmcalc.extras.facts.rows import even, view_of, with_table
from tmmcalc.extras.tie_down import Thresholds, TieDown
from tmmcalc.report.document import Document, Fact
from tmmcalc.report.numbers import angle, number
from tmmcalc.report.sizes import quantity

HELD = {
    "friction": "friction alone holds the load",
    "all ties": "all four ties hold the load",
    "two ties": "two ties hold the load, the opposite ones are slack",
}
BEGINS = (
    "friction alone no longer holds the load",
    "the opposite ties are slack",
    "R by (3) is above P0: the load slips by the source",
    "R by (3) is above 2 P0: the opposite ties are slack by the source",
    "a stretched tie yields",
    "the load leaves its cradle",
)


def summary(result: TieDown, title: str) -> Document:
    """Loads and forces of the ties."""
    two = f"R = {number(result.force, 7)} N, dR = {number(result.change, 7)} N; of an opposite tie "
    facts = [
        Fact(
            "load",
            f"F = {number(result.push, 7)} N moves it, G = {number(result.press, 7)} N presses it on the cradle",
            keyed(result, "push", "press"),
        ),
        Fact("preload", f"P0 = {number(result.preload, 7)} N", keyed(result, "preload")),
        Fact(
            "R by formula (3)",
            f"{two}{number(result.opposite, 7)} N",
            keyed(result, "force", "change", "opposite"),
        ),
        Fact("vertical load of the ties", f"{number(result.vertical, 7)} N", keyed(result, "vertical")),
        Fact(
            "R by equilibrium",
            f"{number(result.balanced, 7)} N of a stretched tie; {HELD[result.held]}",
            keyed(result, "balanced", "held"),
        ),
        Fact(
            "best elevation",
            f"{angle(degrees(result.best_elevation))} deg",
            keyed(result, "best_elevation[deg]"),
        ),
    ]
    if result.stress is not None:
        safety = "" if result.safety is None else f", safety {number(result.safety, 5)} against yielding"
        text = f"{quantity(result.stress, 'Pa')} of a stretched tie{safety}"
        facts.append(Fact("stress by equilibrium", text, keyed(result, "stress", "safety")))
    at = result.thresholds
    begins = sorted((k, words) for k, words in zip(_values(at), BEGINS, strict=True) if k is not None)
    text = "\n".join(f"from k = {number(k, 5)}: {words}" for k, words in begins)
    facts.append(Fact("inertia over weight", text, {"thresholds": keyed(at)}))
    return Document(title, tuple(facts), result.notes)


def document(
    result: TieDown,
    title: str,
    *,
    patterns: Sequence[str] = (),
    rows: Sequence[int] | None = None,
    everything: bool = False,
    where: str = "",
) -> Document:
    """The summary with the forces over k."""
    view = view_of(tie_down_columns(result), patterns, rows, everything, even(len(result.k)))
    return with_table(summary(result, title), view, everything or rows is not None)


def _values(at: Thresholds) -> tuple[float | None, ...]:
    return at.slip, at.slack, at.source_slip, at.source_slack, at.yielding, at.tipping
