"""Steady motion under forces of position alone, kept at a mean speed by the driving moment.

The kinetic energy is T = T0 + A(theta), where A is the work of all moments with the driving one; a constant driving
moment closes the work of the cycle (textbook 3.45), and T0 sets the mean speed. The speed is omega = sqrt(2 T / J)
(3.48).
"""

from __future__ import annotations

import numpy as np

from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.core.numerics.panels import Values
from tmmcalc.machine.cycle import Cycle
from tmmcalc.machine.onemass import check_inertia
from tmmcalc.machine.regime import Regime
from tmmcalc.machine.unresisted import WHERE, free

BALANCED = 1e-6  # work that a given driving moment may leave over, against the work of all moments
CLOSED = 1e-14  # the same, as mere rounding of a diagram that closes by itself


def positional(
    cycle: Cycle,
    constant_inertia: float,
    speed: float | None = None,
    given_moment: float | Values | None = None,
    *,
    sense: float = 1.0,
) -> Regime:
    """The regime whose mean speed (omega_max + omega_min)/2 is ``speed`` [rad/s], by default that of the cycle.

    The driving moment is constant and closes the work of a cycle, or it is the ``given_moment`` [N*m], a number or a
    function (K, N) on the panels of the cycle. ``constant_inertia`` [kg*m^2] may be zero. With resistances that depend
    on speed the constant driving moment is found together with the motion. ``sense`` is -1 where the input turns
    clockwise: messages tell places by its coordinate. Raises `NoSolutionError` where the energy
    does not last for the cycle (with the angle and the inertia that would do), or where a given moment leaves work
    over; `UsageError` for impossible arguments.
    """
    mean = cycle.speed if speed is None else speed
    if not (0 < mean < np.inf and 0 <= constant_inertia < np.inf):
        raise UsageError(
            f"a mean speed of {mean:g} rad/s with a constant inertia of {constant_inertia:g} kg*m^2",
            where=WHERE,
            remedy="the speed is positive, the inertia not negative, both finite",
        )
    check_inertia(cycle, constant_inertia, sense)
    if not np.any(cycle.viscous) and not np.any(cycle.quadratic):
        return free(cycle, constant_inertia, mean, _driving(cycle, given_moment), sense)
    if given_moment is not None:
        raise UsageError(
            "with a resistance that depends on speed a given driving moment sets the speed itself",
            where=WHERE,
            remedy="leave the moment out, or give it as a motor's constant characteristic",
        )
    from tmmcalc.machine.resisted import resisted  # late: few machines have resistances

    return resisted(cycle, constant_inertia, mean, sense)


def _driving(cycle: Cycle, given: float | Values | None) -> Values:
    """The driving moment (K, N): the constant one that closes the work of the cycle, or the given one if it does."""
    load = float(cycle.panels.total(cycle.moment))
    if given is None:
        closed = abs(load) <= CLOSED * float(cycle.panels.total(np.abs(cycle.moment)))
        return np.full(cycle.moment.shape, 0.0 if closed else -load / cycle.period)
    driving = np.broadcast_to(np.asarray(given, float), cycle.moment.shape)
    surplus = float(cycle.panels.total(driving)) + load
    turnover = float(cycle.panels.total(np.abs(driving) + np.abs(cycle.moment)))
    if abs(surplus) <= BALANCED * turnover:
        return driving - surplus / cycle.period
    raise NoSolutionError(
        f"the given driving moment leaves {surplus:.6g} J over in every cycle, so the speed {_drifts(surplus)}",
        where=WHERE,
        value=surplus,
        limit=BALANCED * turnover,
        remedy=f"a moment with the mean {-load / cycle.period:.6g} N*m, or none: then a constant one is found",
    )


def _drifts(surplus: float) -> str:
    return "grows without end" if surplus > 0 else "falls to a stand"
