"""A machine that nothing drives but its own loads, some of which depend on the speed: it regulates itself.

An engine with a generator or a fan settles at the speed at which the work of a cycle is zero. In the mean over a cycle
the moment is M_0 + c omega + k omega^2, and a regime is stable where it falls through zero (textbook 3.46). The exact
regime is that of a motor whose moment is zero at every speed.
"""

from __future__ import annotations

import math

import numpy as np

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.machine.cycle import Cycle
from tmmcalc.machine.driver import UNDRIVEN, Driver
from tmmcalc.machine.motors.characteristics import ConstantMoment
from tmmcalc.machine.regime import Regime

WHERE = "steady motion"
NOTHING = 1e-13  # mean moment, against the mean of its magnitude, that is none


def self_regulated(cycle: Cycle, constant_inertia: float, *, sense: float = 1.0) -> Regime:
    """The regime under the loads alone, with a ``constant_inertia`` [kg*m^2] beside that of the cycle.

    ``sense`` is -1 where the input turns clockwise. Raises `NoSolutionError` where the loads balance at no speed, or
    the kinetic energy does not last for the cycle.
    """
    from tmmcalc.machine.steady import driven

    return driven(cycle, constant_inertia, undriven(cycle), sense=sense)


def undriven(cycle: Cycle) -> ConstantMoment:
    """No motor: a moment of zero, whose reference is the speed at which the loads balance in the mean."""
    return ConstantMoment(0.0, balance_speed(cycle), name=UNDRIVEN)


def undriven_driver(cycle: Cycle) -> Driver:
    """No motor in place of one."""
    return Driver(undriven(cycle), 0.0)


def balance_speed(cycle: Cycle) -> float:
    """The speed [rad/s] at which the mean moment of the loads falls through zero.

    Raises `NoSolutionError` where there is none: the machine stops, or speeds up without end.
    """
    rows = np.stack((cycle.moment, cycle.viscous, cycle.quadratic))
    constant, linear, square = (float(value) / cycle.period for value in cycle.panels.total(rows))
    if abs(constant) * cycle.period <= NOTHING * float(cycle.panels.total(np.abs(cycle.moment))):
        constant = 0.0
    speed = _falling_root(constant, linear, square)
    if speed is None:
        raise _unbalanced(cycle, constant, linear, square)
    return speed


def _falling_root(constant: float, linear: float, square: float) -> float | None:
    """The positive root of the quadratic at which it falls; None: it has none. Both forms lose no digits.

    >>> _falling_root(10.0, 0.0, -0.1), _falling_root(10.0, -2.0, 0.0), _falling_root(-1.0, 0.0, -0.1)
    (10.0, 5.0, None)
    """
    inner = linear * linear - 4 * square * constant
    if inner <= NOTHING * linear * linear:
        return None
    root = math.sqrt(inner)
    if linear > 0 and not square:
        return None
    found = -(linear + root) / (2 * square) if linear > 0 else 2 * constant / (root - linear)
    return found if found > 0 else None


def _unbalanced(cycle: Cycle, constant: float, linear: float, square: float) -> NoSolutionError:
    """Why no speed balances the loads, at the speed that the spec asks for."""
    asked = cycle.speed
    left = (constant + (linear + square * asked) * asked) * cycle.period
    if not (np.any(cycle.viscous) or np.any(cycle.quadratic)):
        told = f"no load depends on the speed, and every cycle leaves {left:.6g} J over at any speed: "
    else:
        told = f"the loads balance at no speed; at {asked:.6g} rad/s a cycle leaves {left:.6g} J over: "
    if left > 0:
        told += "the machine speeds up without end"
        remedy = "a load that resists and grows with the speed: viscous or quadratic, such as a generator or a fan"
    elif left < 0:
        told += "the machine stops"
        remedy = "loads that drive more, less resistance, or a motor"
    else:
        told += "it keeps any speed that it is given"
        remedy = 'drive = "positional" holds the mean speed of the spec'
    return NoSolutionError(f"nothing drives the machine but its loads; {told}", where=WHERE, value=left, remedy=remedy)
