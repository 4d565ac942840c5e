"""What rounding and quadrature leave of the vibration.

A few panels are integrated again in extended precision, each in halves, which has twice the order. By the largest miss
of what a panel adds to q, and the rounding of each step, the steady q is off by about the square root of the number of
panels that it remembers times that, over what a turn takes from a vibration. The natural frequency itself is rounded:
that turns the phase of what is remembered.
"""

from __future__ import annotations

from math import sqrt

import numpy as np

from tmmcalc.cams.laws.law import Law, Values
from tmmcalc.cams.program import Program
from tmmcalc.cams.response import SPAN, Response, kicks_of, residual
from tmmcalc.cams.rounding import FLOOR, MARGIN, Errors, relative
from tmmcalc.cams.speed import Speed
from tmmcalc.cams.wide import wide
from tmmcalc.core.numerics.extended import EPS
from tmmcalc.core.numerics.panels import Panels

FEW = 6  # panels integrated again
RATIOS = (0, -1)  # of a spectrum, the ends


def vibration_errors(program: Program, speed: Speed, course: Response, frequency: float, damping: float) -> Errors:
    """Estimates of the stretch z, of the acceleration of the mass and of that of the cam, and of the amplitudes."""
    on, rate = course.panels, complex(-damping * frequency, frequency * sqrt(1 - damping**2))
    ratio, found = course.ratio, course.kicks
    size = float(np.max(np.abs(course.edges)))
    few = np.linspace(0, on.count - 1, min(on.count, FEW)).astype(int)
    few = np.array(sorted({*few.tolist(), int(np.argmax(np.abs(found)))}))
    missed = max(abs(complex(found[k] - _again(program, speed, on, rate, k))) for k in few.tolist())
    steps = min(on.count, 1 / max(1 - float(np.max(np.abs(ratio))), 1 / on.count))
    total = np.exp(rate * float(course.time[-1]))
    turned = EPS * abs(rate) * float(course.time[-1]) * steps / on.count * size
    q = (MARGIN * sqrt(steps) * (missed + SPAN * EPS * size) + turned) / abs(1 - total)
    z, x = (float(np.max(np.abs(each))) for each in (course.stretch, course.mass))
    return {
        "stretch": _over(q / abs(rate.imag), z),
        "response": _over(q * frequency**2 / abs(rate.imag) * (1 + 2 * damping), x),
        "residual": _over(q, size),
    }


def _over(value: float, size: float) -> float:
    return max(value / size, FLOOR) if size else 0.0


def _again(program: Program, speed: Speed, on: Panels, rate: complex, k: int) -> complex:
    """What a panel adds to q, of its two halves in extended precision."""
    low, high = wide(on.edges[k : k + 2])
    halves = Panels(np.array([low, (low + high) / 2, high]), on.order)
    ratio, kicks = kicks_of(program.wider, speed, halves, np.clongdouble(rate))
    return complex(ratio[1] * kicks[0] + kicks[1])


def spectrum_error(law: Law, ratios: Values, found: Values, damping: float) -> float:
    """Estimate of a spectrum of residual vibration, relative to its largest value."""
    ends = np.array(RATIOS)
    exact = residual(wide(law), wide(ratios[ends]), damping)
    return relative(found[ends], exact, float(np.max(found)))
