"""The classical methods for the inertia of a flywheel under forces of position: each is a choice of two slopes.

All take the constant inertia J_F from the intercepts of an upper and a lower tangent of the energy-mass curve, J_F =
(b_max - b_min) / (delta w^2), with b_max = max(A - k_max J) and b_min = min(A - k_min J), w the mean speed (textbook
3.53; in its Fig. 3.17 graphically, as the segment GH between the tangents on the axis of energies).
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from tmmcalc.core.numerics.panels import Values
from tmmcalc.machine.flywheel.curve import EnergyCurve, Touching

Slopes = tuple[float, float]  # k_max, k_min in units of w^2 / 2


class Rule(NamedTuple):
    """A method: the slopes that find the touching points, and those of the tangents through them."""

    name: str
    find: Callable[[float], Slopes]  # of delta
    draw: Callable[[float], Slopes]
    statement: str


def squares_kept(delta: float) -> Slopes:
    """w_max^2 and w_min^2 over w^2, exactly."""
    return (1 + delta / 2) ** 2, (1 - delta / 2) ** 2


def squares_dropped(delta: float) -> Slopes:
    """The same without delta^2 / 4 (3.53)."""
    return 1 + delta, 1 - delta


def mean_speed(delta: float) -> Slopes:
    """The energy of the links taken at the mean speed."""
    return 1.0, 1.0


def no_links(delta: float) -> Slopes:
    """The energy of the links neglected."""
    return 0.0, 0.0


METHODS = (
    Rule(
        "exact",
        squares_kept,
        squares_kept,
        "Wittenbauer's tangents with the true slopes w^2 (1 +- delta/2)^2 / 2; Gutyar's refinement gives the same",
    ),
    Rule("book", squares_dropped, squares_dropped, "Wittenbauer's tangents with delta^2 dropped: w^2 (1 +- delta) / 2"),
    Rule("mertsalov", mean_speed, mean_speed, "energy of the links taken at the mean speed: A - J w^2 / 2"),
    Rule(
        "artobolevsky",
        no_links,
        squares_dropped,
        "extreme speeds taken where the excess work is extreme; there the links count with w^2 (1 +- delta) / 2",
    ),
    Rule("excess work", no_links, no_links, "largest excess work over delta w^2, energy of the links neglected"),
)
"""What each takes and from where.

``exact``: section 3.4.2 of the textbook with no square dropped. ``book``: its formula (3.53), Wittenbauer's method as
most textbooks print it, Artobolevsky's among them. ``mertsalov``: the change of energy of the first group of links
(those with a constant ratio to the flywheel) is Delta T_I = A - T_II with T_II = J w^2 / 2. ``artobolevsky``: the
textbook only names this variant (3.4.2.5), and authors differ in what they call so; taken here is the energy equation
between the positions of the largest and the smallest excess work, which needs no tangents: J_F delta w^2 = A_a - A_b
- [J_a (1 + delta) - J_b (1 - delta)] w^2 / 2. ``excess work``: J_F = (A_max - A_min) / (delta w^2), the formula for a
torque diagram without a mechanism, where all five agree.
"""


class Tangents(NamedTuple):
    """Upper and lower tangent of every method, arrays (m,)."""

    inertia: Values  # J_F [kg*m^2]
    slope_max: Values  # k_max [rad^2/s^2]
    slope_min: Values
    intercept_max: Values  # b_max [J]
    intercept_min: Values
    fastest: Touching
    slowest: Touching


def tangents(curve: EnergyCurve, delta: float, speed: float, rules: tuple[Rule, ...] = METHODS) -> Tangents:
    """Tangents of the ``rules`` and the constant inertia J_F that each asks for, all found in one pass."""
    m = len(rules)
    half = speed**2 / 2
    find = half * np.array([rule.find(delta) for rule in rules]).T.ravel()
    k_max, k_min = half * np.array([rule.draw(delta) for rule in rules]).T
    at = curve.touching(find, np.repeat((True, False), m))
    fastest, slowest = (Touching(*(column[part] for column in at)) for part in (slice(m), slice(m, None)))
    b_max = fastest.work - k_max * fastest.inertia
    b_min = slowest.work - k_min * slowest.inertia
    return Tangents((b_max - b_min) / (delta * speed**2), k_max, k_min, b_max, b_min, fastest, slowest)
