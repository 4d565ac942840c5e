"""Numerical differentiation of the position function, the method of textbook 2.4 and 2.9.

    S'  = [S(phi + theta) - S(phi - theta)] / (2 theta)                        (2.62)
    S'' = [S(phi + theta) - 2 S(phi) + S(phi - theta)] / theta^2               (2.63)

Truncation errs by theta^2/6 |S'''| and theta^2/12 |S''''|, rounding of S by e/theta and 4 e/theta^2. For
positions written with six decimals the best step is 1.5 to 2 degrees, as the textbook advises.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from tmmcalc.core.plane import Real
from tmmcalc.core.quantity import quantity
from tmmcalc.core.records import record
from tmmcalc.linkage.chain import Chain
from tmmcalc.linkage.results import Trace
from tmmcalc.linkage.trace import TURN, trace

STEPS_DEG = (0.1, 0.25, 0.5, 1.0, 1.5, 2.0, 3.0, 5.0)  # steps of the study in the textbook's range


def differentiate(chain: Chain, x: Real, step: float, decimals: int | None = None, unit: float = 1.0) -> Trace:
    """Positions at ``x`` (n,) with central differences of ``step`` [rad or m] in place of the derivatives.

    ``decimals`` rounds every position, in units of ``unit`` [m] for lengths and of 1 rad for angles, as a table
    on paper would.
    """
    before, here, after = (_rounded(trace(chain, x + shift, order=0), decimals, unit) for shift in (-step, 0.0, step))
    r, dr, ddr = _differences(before.r, here.r, after.r, step)
    angles = [here.angle + _wrapped(t.angle - here.angle) for t in (before, here, after)]
    s, ds, dds = _differences(before.s, here.s, after.s, step)
    angle, dangle, ddangle = _differences(angles[0], angles[1], angles[2], step)
    return replace(here, r=r, dr=dr, ddr=ddr, angle=angle, dangle=dangle, ddangle=ddangle, s=s, ds=ds, dds=dds)


def _differences(before: np.ndarray, here: np.ndarray, after: np.ndarray, step: float) -> tuple[np.ndarray, ...]:
    return here, (after - before) / (2 * step), (after - 2 * here + before) / step**2


def _wrapped(angle: Real) -> Real:
    return angle - TURN * np.rint(angle / TURN)


def _rounded(positions: Trace, decimals: int | None, unit: float) -> Trace:
    if decimals is None:
        return positions
    points = (positions.r / unit).round(decimals) * unit
    return replace(
        positions,
        r=points,
        s=np.round(positions.s / unit, decimals) * unit,
        angle=np.round(positions.angle, decimals),
    )


@record
class DifferenceError:
    """Errors of central differences over the positions."""

    first: float = quantity("dS[{precision}]", "largest error of the first transfer function, lengths in units of l_1")
    second: float = quantity(
        "ddS[{precision}]", "largest error of the second transfer function, lengths in units of l_1"
    )


@record
class StepError:
    """Errors of one step, from positions rounded to some decimals and in double precision."""

    step: float = quantity("step[{unit}]", "step of the central differences")
    rounded: DifferenceError
    double: DifferenceError


def difference_error(exact: tuple[Real, Real], found: tuple[Real, Real], unit: float) -> DifferenceError:
    """Compare S', S'' (n,) by differences with the exact ones, in multiples of ``unit``."""
    first, second = (float(np.max(np.abs(a - b) / unit)) for a, b in zip(exact, found, strict=True))
    return DifferenceError(first, second)
