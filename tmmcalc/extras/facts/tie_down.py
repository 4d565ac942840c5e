"""The document of the tie-down: loads and forces of the ties."""

from __future__ import annotations

from math import degrees

from tmmcalc.core.quantity import keyed
from tmmcalc.extras.tie_down import TieDown
from tmmcalc.report.document import Document, Fact
from tmmcalc.report.numbers import angle, number

HELD = {
    "friction": "friction alone holds the load",
    "all ties": "all four ties hold the load",
    "two ties": "two ties hold the load, the opposite ones are slack",
}


def summary(result: TieDown, title: str) -> Document:
    """Loads and forces of the ties."""
    two = f"R = {number(result.force, 7)} N, dR = {number(result.change, 7)} N; of an opposite tie "
    facts = (
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
    )
    return Document(title, facts, result.notes)
