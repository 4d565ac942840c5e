"""Flywheel for forces of position: the classical methods side by side, each tried on the exact motion.

Each method is a choice of two slopes. All take the constant inertia J_F from the intercepts of an upper and a lower
tangent of the energy-mass curve, J_F = (b_max - b_min) / (delta w^2), with b_max = max(A - k_max J) and b_min =
min(A - k_min J), w the mean speed (textbook 3.53; in its Fig. 3.17 graphically, as the segment GH between the tangents
on the axis of energies).

The inertia is asked for as the total constant inertia J_F reduced to the input shaft, beyond the variable one of the
cycle; what the rotor, the gears and the crank have of it already (``constant_inertia``) need not be added.
"""

from __future__ import annotations

import math
from typing import Literal, NamedTuple

import numpy as np

from tmmcalc.core.errors import UsageError
from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.quantity import quantity
from tmmcalc.core.records import record
from tmmcalc.machine.cycle import Cycle
from tmmcalc.machine.flywheel.curve import EnergyCurve, Touching, energy_curve, nodal_curve
from tmmcalc.machine.flywheel.resimulation import motions

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
class FlywheelMethod:
    """What one method asks for, and what comes of it."""

    method: str
    inertia: float = quantity(
        "J_F[kg*m^2]", "total constant inertia asked for; negative if the links alone suffice", source="(3.53)"
    )
    addition: float = quantity("J_add[kg*m^2]", "inertia to be added beyond the constant one at hand, not negative")
    theta_max: float  # position of the tangent of the largest speed [rad]
    theta_min: float  # position of the tangent of the smallest speed [rad]
    delta: float | None = quantity(  # None: it cannot carry the cycle
        "delta", "coefficient of speed fluctuation reached with it, exactly"
    )
    error: float = quantity("error", "relative error of J_F against the exact method")
    remark: str


def positional_flywheels(
    cycle: Cycle,
    constant_inertia: float,
    delta: float,
    speed: float | None = None,
    moment: float | Values | None = None,
) -> tuple[FlywheelMethod, ...]:
    """All methods of `METHODS` for the coefficient ``delta`` at the mean ``speed`` [rad/s], the exact first.

    ``moment`` is the driving moment [N*m], constant or (K, N); by default the constant one that closes the work of the
    cycle (3.45). Forces that depend on speed are taken at the mean speed. Raises `UsageError` for a ``delta`` outside
    (0, 1), a speed or inertia out of range, or a moment that leaves work over.
    """
    w = cycle.speed if speed is None else speed
    check(delta, w, constant_inertia)
    return all_methods(energy_curve(cycle, w, moment), constant_inertia, delta, w)


def nodal_flywheels(
    work: Values,
    inertia: Values,
    constant_inertia: float,
    delta: float,
    speed: float,
    *,
    period: float = 2 * math.pi,
    theta: Values | None = None,
) -> tuple[FlywheelMethod, ...]:
    """The same on the nodes of a table: ``work`` A [J] and ``inertia`` J [kg*m^2], both (n + 1,), as the textbook does.

    Extremes between the nodes are missed, so J_F comes out too small (by 9 % at 12 nodes of a press).
    `nodes.nodal_work` gives A of nodal moments by the trapezoid rule. ``delta`` of the result is over the nodes too.
    """
    check(delta, speed, constant_inertia)
    return all_methods(nodal_curve(work, inertia, period, theta), constant_inertia, delta, speed)


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


def all_methods(curve: EnergyCurve, constant_inertia: float, delta: float, speed: float) -> tuple[FlywheelMethod, ...]:
    """What all methods ask for on an energy-mass curve, and what comes of it; the exact one first."""
    found = tangents(curve, delta, speed)
    tried = motions(curve, np.maximum(found.inertia, constant_inertia), speed)
    exact, methods = float(found.inertia[0]), []
    for i, rule in enumerate(METHODS):
        inertia, runs = float(found.inertia[i]), bool(tried.exists[i])
        methods.append(
            FlywheelMethod(
                rule.name,
                inertia,
                max(0.0, inertia - constant_inertia),
                float(found.fastest.theta[i]),
                float(found.slowest.theta[i]),
                float(tried.spread[i]) / speed if runs else None,
                (inertia - exact) / abs(exact) if exact else 0.0,
                rule.statement + ("" if runs else "; with it the machine cannot run at this mean speed"),
            )
        )
    return tuple(methods)
