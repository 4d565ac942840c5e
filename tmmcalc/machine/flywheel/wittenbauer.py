"""Wittenbauer's picture (textbook Fig. 3.17): the closed energy-mass curve with its two outer tangents.

Each classical method is a choice of two slopes. All take the constant inertia J_F from the intercepts of an upper and a
lower tangent of the curve, J_F = (b_max - b_min) / (delta w^2), with b_max = max(A - k_max J) and b_min =
min(A - k_min J), w the mean speed (textbook 3.53; in its Fig. 3.17 graphically, as the segment GH between the tangents
on the axis of energies).
"""

from __future__ import annotations

import math
from typing import Literal, NamedTuple

import numpy as np

from tmmcalc.core.errors import UsageError
from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.quantity import derived, quantity
from tmmcalc.core.records import record
from tmmcalc.machine.cycle import Cycle
from tmmcalc.machine.flywheel.curve import EnergyCurve, Touching, energy_curve

Squares = Literal["true", "dropped", "mean", "none"]  # how the squares of the extreme speeds are taken


class Rule(NamedTuple):
    """A method: the slopes that find the touching points, and those of the tangents through them."""

    name: str
    find: Squares
    draw: Squares
    statement: str


METHODS = (
    Rule(
        "exact",
        "true",
        "true",
        "Wittenbauer's tangents with the true slopes w^2 (1 +- delta/2)^2 / 2; Gutyar's refinement gives the same",
    ),
    Rule("book", "dropped", "dropped", "Wittenbauer's tangents with delta^2 dropped: w^2 (1 +- delta) / 2"),
    Rule("mertsalov", "mean", "mean", "energy of the links taken at the mean speed: A - J w^2 / 2"),
    Rule(
        "artobolevsky",
        "none",
        "dropped",
        "extreme speeds taken where the excess work is extreme; there the links count with w^2 (1 +- delta) / 2",
    ),
    Rule("excess work", "none", "none", "largest excess work over delta w^2, energy of the links neglected"),
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
    # k_max and k_min over half: squares of the extreme speeds over that of the mean one
    slopes: dict[Squares, tuple[float, float]] = {
        "true": ((1 + delta / 2) ** 2, (1 - delta / 2) ** 2),
        "dropped": (1 + delta, 1 - delta),  # delta^2/4 left out (3.53)
        "mean": (1.0, 1.0),
        "none": (0.0, 0.0),  # the energy of the links neglected
    }
    find = half * np.array([slopes[rule.find] for rule in rules]).T.ravel()
    k_max, k_min = half * np.array([slopes[rule.draw] for rule in rules]).T
    at = curve.touching(find, np.repeat((True, False), m))
    fastest, slowest = (Touching(*(column[part] for column in at)) for part in (slice(m), slice(m, None)))
    b_max = fastest.work - k_max * fastest.inertia
    b_min = slowest.work - k_min * slowest.inertia
    return Tangents((b_max - b_min) / (delta * speed**2), k_max, k_min, b_max, b_min, fastest, slowest)


@record
class EnergyMass:
    """The energy-mass curve and the exact tangents.

    Both tangents meet in the origin of the total inertia and the total energy, the point (-inertia, -energy)
    of the picture.
    """

    theta: Values  # [rad], (m,), from 0 to the period, the touching points among them
    links: Values  # J of the links, abscissa [kg*m^2], (m,)
    work: Values  # A, change of kinetic energy, ordinate [J], (m,)
    slopes: tuple[float, float]  # k_max, k_min: half the square of the extreme speeds [rad^2/s^2]
    intercepts: tuple[float, float]  # b_max, b_min on the axis of energies [J]; their distance is the segment GH
    touching: tuple[float, float]  # angles where the tangents touch [rad]
    inertia: float = quantity("J_F_exact[kg*m^2]", "total constant inertia by the exact tangents", symbol="J_F")
    energy: float = quantity("T_0[J]", "kinetic energy of the whole machine at theta = 0")
    drive: float = quantity("M_d_mean[N*m]", "constant driving moment that closes the cycle")

    @derived("slope_max[rad^2/s^2]", "slope of the tangent of the largest speed", symbol="k_max")
    def slope_max(self) -> float:
        """Half the square of that speed."""
        return self.slopes[0]

    @derived("slope_min[rad^2/s^2]", "slope of the tangent of the least speed", symbol="k_min")
    def slope_min(self) -> float:
        """Half the square of that speed."""
        return self.slopes[1]

    @derived("G[J]", "intercept of the tangent of the largest speed on the axis of energies")
    def upper(self) -> float:
        """b_max."""
        return self.intercepts[0]

    @derived("H[J]", "intercept of the tangent of the least speed on the axis of energies")
    def lower(self) -> float:
        """b_min."""
        return self.intercepts[1]

    @property
    def speed(self) -> float:
        """Mean of the extreme speeds [rad/s]."""
        return (math.sqrt(2 * self.slopes[0]) + math.sqrt(2 * self.slopes[1])) / 2

    def angles(self, scale: float) -> tuple[float, float]:
        """Angles [rad] of the tangents in a drawing, ``scale`` = mu_J/mu_T [kg*m^2/mm over J/mm] (3.50)."""
        return math.atan(self.slopes[0] * scale), math.atan(self.slopes[1] * scale)


def energy_mass(
    cycle: Cycle, delta: float, speed: float | None = None, moment: float | Values | None = None
) -> EnergyMass:
    """The picture for the coefficient ``delta``; arguments as in `positional_flywheels`."""
    w = cycle.speed if speed is None else speed
    check(delta, w, 0.0)
    curve = energy_curve(cycle, w, moment)
    exact = tangents(curve, delta, w, METHODS[:1])
    on = cycle.panels
    k_max, k_min = float(exact.slope_max[0]), float(exact.slope_min[0])
    b_max, b_min = float(exact.intercept_max[0]), float(exact.intercept_min[0])
    inertia = float(exact.inertia[0])
    touching = float(exact.fastest.theta[0]), float(exact.slowest.theta[0])
    every = np.append(np.column_stack((on.edges[:-1], on.x)).ravel(), on.edges[-1])
    theta = np.sort(np.append(every, [at for at in touching if at not in every]))
    work, links = on.at(np.stack((curve.work, curve.inertia)), theta)
    return EnergyMass(
        theta,
        links,
        work,
        (k_max, k_min),
        (b_max, b_min),
        touching,
        inertia,
        k_max * inertia - b_max,
        curve.drive,
    )


def check(delta: float, speed: float, constant_inertia: float) -> None:
    """Raise `UsageError` unless 0 < delta < 1, the speed is positive and the inertia not negative."""
    if not 0 < delta < 1:
        raise UsageError(
            f"the coefficient of speed fluctuation is {delta:g}, it must lie between 0 and 1",
            where="flywheel",
            value=delta,
            remedy="machines are designed for 1/5 to 1/300",
        )
    if not (math.isfinite(speed) and speed > 0):
        raise UsageError(f"the mean speed is {speed:g} rad/s, it must be above zero", where="flywheel", value=speed)
    if not (math.isfinite(constant_inertia) and constant_inertia >= 0):
        raise UsageError(
            f"the constant inertia is {constant_inertia:g} kg*m^2, it cannot be negative",
            where="flywheel",
            value=constant_inertia,
            limit=0.0,
        )
