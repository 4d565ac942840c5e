"""The error of a run from a second one: what fixed steps miss of step control, what a tolerance leaves.

The classical Runge-Kutta step tells no error at all, that of Kutta-Merson is many times too large where the equations
are not linear, and neither tells of steps that are unstable: their motion is run a second time with step control. What
the steps under a tolerance leave together depends on how errors die away or add up, by five decades; a second run with
a tolerance a thousand times as large costs some third of the first and tells it: the error goes as a power of it.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from tmmcalc.core.errors import AccuracyError
from tmmcalc.core.numerics.panels import Values
from tmmcalc.machine.transient.model import ratios
from tmmcalc.machine.transient.results import Transient

INSTANTS = 120  # of a motion in fixed steps at which the two are compared
FEW = 32  # the same of a motion with step control
MARGIN = 1.5  # what the largest difference at these instants may be exceeded by between them
COARSER = 1e3  # times the tolerance: of the second run
# what the errors of speeds and of moments may be larger by than their power of the tolerance tells, where steps are at
# the border of stability and the error goes as the root of it: of 223 random drives against a truth of its own all but
# four need at most 3 for the speeds, three of these four 11 to 26; none needs 5 for the moments, that are compared by
# whole courses beside their largest
SCALED = 10.0, 5.0
POWER, POWERS = 0.8, {"collocation": 1.0}  # of the tolerance that the error goes as; Kutta-Merson: order 4 of 5
EPS = 8 * math.ulp(1.0)  # rounding of a step
NEWTON = 5e-5  # of the error allowed in a step: what Newton's method leaves of collocation
FINER = 1e-2  # times the tolerance: of a second run where a coarser one would have too few steps to tell anything
COARSE, COARSES = 1e-9, {"collocation": 3e-8}  # tolerances beyond which that is so


def instants_of(found: Transient, count: int = INSTANTS) -> list[float]:
    """Times of steps of a motion, evenly taken [s]."""
    chosen = np.linspace(0, len(found.t) - 1, min(count, len(found.t))).astype(int)
    times: list[float] = found.t[chosen].tolist()
    return times


def second(method: str, tolerance: float) -> float:
    """The tolerance of a second run that tells the error of a first one."""
    return tolerance * (FINER if tolerance > COARSES.get(method, COARSE) else COARSER)


def left(found: Transient, other: Transient, tolerance: float, allowed: float) -> tuple[float, float]:
    """Estimated relative errors of speeds and largest moments under a ``tolerance``, from the run of `second`.

    ``allowed`` is the error of the speeds that the tolerance allows in a step, relative to the largest.
    """
    times = instants_of(found, FEW)
    # two largest moments may agree by chance, their whole courses do not
    moments = max(_moments(found, other), _courses(found, other, times))
    differences = _difference(found, other, times, found), moments
    rounding = EPS * math.sqrt(found.counters["steps"]) + (NEWTON * allowed if found.method == "collocation" else 0.0)
    if second(found.method, tolerance) < tolerance:
        factors = [MARGIN, MARGIN]
    else:
        factors = [each / COARSER ** POWERS.get(found.method, POWER) for each in SCALED]
    speeds, moments = (rounding + factor * off for factor, off in zip(factors, differences, strict=True))
    return speeds, moments


def missed(found: Transient, controlled: Transient) -> tuple[float, float]:
    """Estimated relative errors of speeds and largest moments: what two runs differ by, and that of the better one.

    Raises `AccuracyError` where the difference is as large as the speeds, so that ``found`` is no result.
    """
    error = MARGIN * _difference(found, controlled, instants_of(found), controlled)
    if error > 1:
        raise AccuracyError(
            f"the fixed steps are too long: their speeds differ from those with step control by {error / MARGIN:.3g} "
            "times the largest speed",
            where=f"transient motion, scenario {found.scenario.name}",
            value=error,
            limit=1.0,
            remedy="take smaller steps, or step control (leave the step out), or an implicit method",
        )
    return error + controlled.error, MARGIN * _moments(found, controlled) + controlled.extremes_error


def _moments(one: Transient, other: Transient) -> float:
    """Largest relative difference of the largest moments."""
    own, others = np.abs(one.largest_moment[0]), np.abs(other.largest_moment[0])
    sizes = np.maximum(own, others)
    off = np.abs(own - others)[sizes > 0] / sizes[sizes > 0]
    return float(off.max(initial=0.0))


def _courses(one: Transient, other: Transient, times: list[float]) -> float:
    """Largest difference at ``times`` of rows of both of the moments that never jump, each relative to its largest.

    That of a rigid shaft jumps with the load, at times that the two runs do not find alike.
    """
    listed = [i for i, shaft in enumerate(one.drive.shafts) if math.isfinite(shaft.stiffness) and i not in one.rigid]
    own, others = (
        _rows_at(motion, times, (*motion.shaft_moment[listed], motion.motor_moment)) for motion in (one, other)
    )
    largest = np.abs(one.largest_moment[0][[*listed, -1]])
    off = np.abs(own - others).max(axis=1)
    return float((off[largest > 0] / largest[largest > 0]).max(initial=0.0))


def _difference(one: Transient, other: Transient, times: list[float], scale: Transient) -> float:
    """Largest difference of the speeds at ``times`` of rows of both, relative to the largest of ``scale``."""
    own, others = (_rows_at(motion, times, _speeds(motion)) for motion in (one, other))
    largest = float(np.abs(_speeds(scale)).max()) or 1.0
    return float(np.abs(own - others).max()) / largest


def _speeds(motion: Transient) -> Values:
    """Speeds (N, S) of all masses, as speeds of the crank."""
    speeds: Values = motion.omega / np.array(ratios(motion.drive))[:, None]
    return speeds


def _rows_at(motion: Transient, times: list[float], values: Values | Sequence[Values]) -> Values:
    """Values (N, S) of all rows at times of rows (N, m); after its end a motion stays as it is."""
    at = np.minimum(np.searchsorted(motion.t, times), len(motion.t) - 1)
    return np.array([each[at] for each in values])
