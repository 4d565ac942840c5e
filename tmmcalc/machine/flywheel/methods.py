"""Flywheel for forces of position: the classical methods side by side, each tried on the exact motion.

All take the inertia from two tangents of the energy-mass curve, see `wittenbauer`.

The inertia is asked for as the total constant inertia J_F reduced to the input shaft, beyond the variable one of the
cycle; what the rotor, the gears and the crank have of it already (``constant_inertia``) need not be added.
"""

from __future__ import annotations

import math

import numpy as np

from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.quantity import quantity
from tmmcalc.core.records import record
from tmmcalc.machine.cycle import Cycle
from tmmcalc.machine.flywheel.curve import EnergyCurve, energy_curve, nodal_curve
from tmmcalc.machine.flywheel.resimulation import motions
from tmmcalc.machine.flywheel.wittenbauer import METHODS, check, tangents


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
