"""What a steady regime is known to: the speed, and what is a difference of nearly equal things.

The acceleration is what the moments leave over the inertia. Of a steep motor they nearly cancel, and then it is better
the slope of the speed along the cycle; each panel takes the way whose bound of the error is the smaller one.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tmmcalc.core.numerics.extended import EPS
from tmmcalc.core.numerics.gauss import ORDER, rule
from tmmcalc.core.numerics.panels import Extreme, Values
from tmmcalc.core.records import record
from tmmcalc.machine.cycle import Cycle

INTERPOLATION = ORDER * EPS  # of a function carried from one set of points to another: a rounding for each point
ROUNDED = 8 * EPS  # of a solution
STORED = 2 * EPS  # of a result: its last operations
STIFF = 100.0  # regulation beyond which the roundings of a moment come back twice
TERMS = 4  # roundings of each term of a sum of moments: functions carried to the panels, products


@record
class RegimeErrors:
    """Estimated relative errors of a regime: of a function to its largest size over the cycle."""

    speed: float  # of omega
    acceleration: float  # of eps
    moment: float  # of M_d
    fluctuation: float  # of delta
    time: float  # of the times, and of the cycle time

    @property
    def largest(self) -> float:
        """The largest of all."""
        return max(self.speed, self.acceleration, self.moment, self.fluctuation, self.time)


class Excess(NamedTuple):
    """The speed as a reference and what it is above that; the solution is relative to ``size``."""

    reference: float  # [rad/s]
    w: Values  # (K, N) [rad/s]
    size: float  # [rad/s]


class Solved(NamedTuple):
    """What a solution is known to, before what its data add."""

    missing: Values  # (K,) of the solution, relative to the size of the excess
    excess: Excess
    fall: Values | float  # (K, N) dM_d/domega of the motor, 0 where its moment does not follow the speed
    driving: float  # relative error of a driving moment that does not follow from the speed
    level: float  # relative error of the level of the speed
    ringing: float  # how far a motor that lags swings up what is rounded
    regulation: float  # how far a motor follows in a cycle, -ln of the multiplier
    lags: bool  # whether the motor does
    above: bool  # whether the excess alone was solved for, so that the whole speed was not rounded in its equations

    @property
    def off(self) -> Values:
        """Error of the speed within the panels (K,), but for its level [rad/s]."""
        return (self.missing + ROUNDED) * self.excess.size


class Balance(NamedTuple):
    """The moments of a regime on its panels, all (K, N)."""

    driving: Values  # M_d [N*m]
    load: Values  # [N*m]
    rising: Values  # J' omega^2 / 2 [N*m]
    inertia: Values  # [kg*m^2]


def accelerations(cycle: Cycle, omega: Values, at: Balance, solved: Solved) -> tuple[Values, float]:
    """Angular acceleration (K, N) [rad/s^2] and its relative error, panel by panel by the better of both ways."""
    w, off = solved.excess.w, solved.off[:, None]
    slope = np.abs(cycle.viscous) + (2 * np.abs(cycle.quadratic) + np.abs(cycle.slope)) * omega
    sides = np.abs(at.driving) + np.abs(at.load) + np.abs(at.rising)
    data = cycle.error * (np.abs(at.load) + np.abs(at.rising))
    rounding = TERMS * EPS * sides
    moved = np.abs(solved.fall) * off + slope * (off + EPS * omega) + solved.driving * np.max(np.abs(at.driving))
    by_moments, by_slope = (at.driving + at.load - at.rising) / at.inertia, omega * cycle.panels.slope(w)
    reach = np.sum(np.abs(rule(cycle.panels.order).slope), axis=1) / cycle.panels.width[:, None]
    of_moments, of_slope = (moved + rounding) / at.inertia, omega * reach * off
    better = np.max(of_slope, axis=1) < np.max(of_moments, axis=1)
    found = np.where(better[:, None], by_slope, by_moments)
    error = np.max(np.where(better[:, None], of_slope, of_moments) + data / at.inertia)
    made_of = np.max((np.abs(solved.fall) * omega + sides) / at.inertia)
    return found, _relative(float(error), float(np.max(np.abs(found))), float(made_of))


def regime_errors(
    cycle: Cycle, at: Balance, solved: Solved, share: float, extremes: tuple[Extreme, Extreme], eps: float
) -> RegimeErrors:
    """All estimates, with that of the acceleration, ``eps``.

    ``share`` is the relative error of the speed over that of the inertia of the links, ``extremes`` are those of the
    excess: of a difference of two speeds the level does not count, nor does what both have in common.
    """
    (low, low_at), (high, high_at) = extremes
    inexact = (cycle.error + INTERPOLATION) * share
    excess, fastest = solved.excess, solved.excess.reference + float(np.max(solved.excess.w))
    local = float(np.max(solved.off)) / fastest
    drive = float(np.max(np.abs(solved.fall) * (solved.off[:, None] + solved.level * fastest)))
    largest = float(np.max(np.abs(at.driving)))
    held = float(np.max(np.abs(solved.fall))) * fastest
    # of a solution for the excess alone rounding is that of its equations, of the whole speed that of two numbers, and
    # of what a motor that follows makes of the roundings of its moment
    fed_back = EPS / 2 * min(max(solved.regulation, 1.0), TERMS) * (2.0 if solved.regulation > STIFF else 1.0)
    # the slower the shaft at its slowest, the more of its energy there a rounding of the largest is
    slowest = max(excess.reference + float(np.min(excess.w)), EPS * fastest)
    rounding = solved.ringing * (ROUNDED if solved.above else fed_back) * max(1.0, (fastest / slowest / 2) ** 2)
    parts = solved.missing * cycle.panels.width / cycle.period * excess.size
    lost = float(np.sum(parts)) / fastest
    # what is missing anywhere goes on until regulation takes it; where a motor lags it swings on, and what comes from
    # many panels meets in all phases
    carried = float(np.linalg.norm(parts)) if solved.lags else float(np.sum(parts)) / max(solved.regulation, 1.0)
    near = _near(cycle, solved.missing, low_at) + _near(cycle, solved.missing, high_at)
    apart = near + 2 * (cycle.error * share + rounding)
    return RegimeErrors(
        speed=max(local, ROUNDED) + inexact + solved.level,
        acceleration=min(eps + STORED + inexact, 1.0),
        moment=_relative(drive + solved.driving * largest, largest, held) + STORED,
        fluctuation=_relative(apart * excess.size + carried, high - low, fastest) + STORED + 2 * solved.level,
        time=lost + inexact + solved.level + 2 * STORED,
    )


def _near(cycle: Cycle, missing: Values, place: float) -> float:
    """The larger of what is missing on the panels to both sides of a place."""
    edges = cycle.panels.edges
    sides = [np.searchsorted(edges, place, side) - 1 for side in ("left", "right")]
    return float(np.max(missing[np.clip(sides, 0, cycle.panels.count - 1)]))


def _relative(error: float, size: float, made_of: float) -> float:
    """An error over a size; where the error is all that is left, over what that is made of."""
    return error / size if error < size else error / made_of if error < made_of else float(error > 0)
