"""One condition on the teeth of a train: both sides in letters, with numbers and as values, and whether it is kept."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from fractions import Fraction

from tmmcalc.core.quantity import derived, quantity
from tmmcalc.core.records import record
from tmmcalc.gears.letters import filled

ROUNDING = 1e-12  # relative, of sides with cosines in them
Side = tuple[str, float | int | Fraction]  # formula and value


@record
class Condition:
    """One condition on the teeth of a train."""

    name: str = quantity("condition", "name of the condition")
    of: str = quantity("of", "the mesh or wheels that it is of; empty: the train")
    formula: str = quantity("formula", "the condition in letters")
    numbers: str = quantity("numbers", "the same with numbers")
    left: float = quantity("left", "left side of {formula}")
    relation: str = quantity("relation", "=, >, >= or <=")
    right: float = quantity("right", "right side of {formula}; of what has to be whole the nearest whole number")
    kept: bool = quantity("kept", "whether {formula} is kept")
    asked: bool = quantity("asked", "whether it was asked for; else it is custom")
    source: str = quantity("source", "formula of the textbook")
    letters: Mapping[str, float] = field(default_factory=dict)  # numbers of the letters; angles [rad]


@record
class Conditions:
    """All conditions of one tooth set."""

    layout: str = quantity("layout", "key of the layout")
    planets: int = quantity("planets", "number of planets or layshafts")
    teeth: tuple[int, ...] = quantity("teeth", "numbers of teeth")
    proportion: tuple[int, ...] = quantity(  # none: unfolded
        "mu", "the modules of the stages to one another in lowest terms"
    )
    conditions: tuple[Condition, ...]

    @derived("all_kept", "whether every condition that was asked for is kept")
    def kept(self) -> bool:
        """All of those asked for."""
        return all(each.kept for each in self.conditions if each.asked)


def condition(
    name: str,
    left: Side,
    relation: str,
    right: Side,
    letters: Mapping[str, float],
    *,
    of: str = "",
    source: str = "",
    asked: bool = True,
) -> Condition:
    """The condition of two sides; ``letters`` are the numbers of the letters of their formulas.

    >>> condition("coprime", ("gcd(Z1, Z2)", 2), "=", ("1", 1), {"Z1": 20, "Z2": 106}).kept
    False
    """
    formula, kept = f"{left[0]} {relation} {right[0]}", _holds(left[1], relation, right[1])
    numbers = filled(formula, letters)
    return Condition(
        name, of, formula, numbers, float(left[1]), relation, float(right[1]), kept, asked, source, dict(letters)
    )


def _holds(left: float | Fraction, relation: str, right: float | Fraction) -> bool:
    """Exactly of fractions and whole numbers; where a side is a float an equality is one up to rounding."""
    apart = Fraction(left) - Fraction(right)
    exact = not isinstance(left, float) and not isinstance(right, float)
    slack = 0 if exact else Fraction(ROUNDING) * abs(Fraction(right))
    if relation == ">":
        return apart > 0
    return {"=": abs(apart) <= slack, ">=": apart >= -slack, "<=": apart <= slack}[relation]
