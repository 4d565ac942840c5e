"""Flywheel for forces of position: all classical methods side by side, each tried on the exact motion.

The inertia is asked for as the total constant inertia J_F reduced to the input shaft, beyond the variable one of the
cycle; what the rotor, the gears and the crank have of it already (``constant_inertia``) need not be added.
"""

from __future__ import annotations

import math

import numpy as np

from tmmcalc.core.errors import UsageError
from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.quantity import quantity
from tmmcalc.core.records import record
from tmmcalc.machine.cycle import Cycle
from tmmcalc.machine.flywheel.curve import EnergyCurve, energy_curve, nodal_curve
from tmmcalc.machine.flywheel.methods import METHODS, Tangents, tangents
from tmmcalc.machine.flywheel.resimulation import Motion, motions


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
    """All methods of `methods.METHODS` for the coefficient ``delta`` at the mean ``speed`` [rad/s], the exact first.

    ``moment`` is the driving moment [N*m], constant or (K, N); by default the constant one that closes the work of the
    cycle (3.45). Forces that depend on speed are taken at the mean speed. Raises `UsageError` for a ``delta`` outside
    (0, 1), a speed or inertia out of range, or a moment that leaves work over.
    """
    w = cycle.speed if speed is None else speed
    check(delta, w, constant_inertia)
    return _compared(energy_curve(cycle, w, moment), constant_inertia, delta, w)


def on_nodes(
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
    `curve.nodal_work` gives A of nodal moments by the trapezoid rule. ``delta`` of the result is over the nodes too.
    """
    check(delta, speed, constant_inertia)
    return _compared(nodal_curve(work, inertia, period, theta), constant_inertia, delta, speed)


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


def _compared(curve: EnergyCurve, constant_inertia: float, delta: float, speed: float) -> tuple[FlywheelMethod, ...]:
    found = tangents(curve, delta, speed)
    tried = motions(curve, np.maximum(found.inertia, constant_inertia), speed)
    return tuple(_method(i, found, tried, constant_inertia, speed) for i in range(len(METHODS)))


def _method(i: int, found: Tangents, tried: Motion, constant_inertia: float, speed: float) -> FlywheelMethod:
    inertia, exact = float(found.inertia[i]), float(found.inertia[0])
    reached = float(tried.spread[i]) / speed if tried.exists[i] else None
    remark = METHODS[i].statement
    if reached is None:
        remark += "; with it the machine cannot run at this mean speed"
    return FlywheelMethod(
        METHODS[i].name,
        inertia,
        max(0.0, inertia - constant_inertia),
        float(found.fastest.theta[i]),
        float(found.slowest.theta[i]),
        reached,
        (inertia - exact) / abs(exact) if exact else 0.0,
        remark,
    )
