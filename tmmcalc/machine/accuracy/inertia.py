"""Methods for the reduced inertia: masses where they are and rods lumped in their pins; its derivative by a table.

    dJ/dtheta = 2 sum m S'.S'' + J_S w' w''        exact, from the transfer functions
              = (J_i+1 - J_i-1)/(2 h)              off a table of n positions, as on paper

The reference is the exact formula in extended precision.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial

import numpy as np

from tmmcalc.core.numerics.extended import WIDER
from tmmcalc.core.plane import Real
from tmmcalc.core.studies.measure import Clock, Way, relative, series
from tmmcalc.core.studies.study import Reference, Study
from tmmcalc.linkage.loading import Body, Loading
from tmmcalc.linkage.loads.scene import Scene
from tmmcalc.linkage.model import Mechanism
from tmmcalc.machine.reduction.inertia import lumped, reduced_inertia, rods_of

POSITIONS = 96  # of the motion, where J is compared
COUNTS = (12, 24, 48, 96, 192, 384, 768)  # of the table
CONSTANT = 1e-9  # of J over the period: a smaller derivative is that of a constant, rounding and all
STATIC = "mass and centre of mass along the rods are kept, their moment of inertia is not"
EXTENDED = Reference("the exact formula in extended precision (64-bit mantissa)", float(np.finfo(np.longdouble).eps))


def studies(mechanism: Mechanism, loading: Loading, compiled: Scene, clock: Clock) -> Iterator[Study]:
    """J of the links with mass, where there are rods to lump, and its derivative, where it is not constant."""
    if not WIDER or not loading.heavy:
        return
    rods = rods_of(mechanism, loading)
    if rods:
        yield _values(mechanism, loading, rods, compiled, clock)
    theta, _ = _inner(compiled, COUNTS[-1])
    value, slope = _at(loading.heavy, compiled, theta)
    size = float(np.max(np.abs(slope)))
    if size > CONSTANT * float(np.max(value)) / compiled.travel.period:
        yield _slopes(loading.heavy, compiled, size, clock)


def _at(bodies: Sequence[Body], compiled: Scene, theta: Real) -> tuple[Real, Real]:
    """J and dJ/dtheta (n,), in the precision of theta."""
    value, slope = reduced_inertia(bodies, compiled.chain.evaluate(compiled.travel.x(theta)), len(theta))
    return value, compiled.travel.sense * slope


def _inner(compiled: Scene, count: int) -> tuple[Real, float]:
    """Positions (n - 1,) within the motion, and their step."""
    step = compiled.travel.period / count
    return step * np.arange(1, count), step


def _values(mechanism: Mechanism, loading: Loading, rods: tuple[int, ...], compiled: Scene, clock: Clock) -> Study:
    theta, _ = _inner(compiled, POSITIONS)
    exact, _ = _at(loading.heavy, compiled, theta.astype(np.longdouble))

    def error(found: Real) -> float:
        return relative(found, exact)

    def own() -> Real:
        return _at(loading.heavy, compiled, theta)[0]

    def by_pins() -> Real:
        return _at(lumped(mechanism, loading, rods), compiled, theta)[0]

    return Study(
        "reduction",
        "reduced inertia",
        EXTENDED,
        (
            series("masses where they are", [Way("", None, own)], error, clock),
            series("rods lumped in their pins (3.42)", [Way("", None, by_pins)], error, clock, note=STATIC),
        ),
    )


def _slopes(bodies: Sequence[Body], compiled: Scene, size: float, clock: Clock) -> Study:
    """Measured against the largest ``size`` of the derivative."""

    def own() -> tuple[Real, Real]:
        theta, _ = _inner(compiled, POSITIONS)
        return theta, _at(bodies, compiled, theta)[1]

    def tabled(count: int) -> tuple[Real, Real]:
        theta, step = _inner(compiled, count)
        inertia, _ = _at(bodies, compiled, theta)
        return theta[1:-1], (inertia[2:] - inertia[:-2]) / (2 * step)

    def error(found: tuple[Real, Real]) -> float:
        theta, slope = found
        exact = _at(bodies, compiled, theta.astype(np.longdouble))[1]
        return relative(slope, exact, size)

    ways = [Way(f"{n} positions", 1 / n, partial(tabled, n)) for n in COUNTS]
    return Study(
        "reduction",
        "derivative of the reduced inertia",
        EXTENDED,
        (
            series("exact derivative", [Way("", None, own)], error, clock),
            series("differences of the table", ways, error, clock, expected=2.0),
        ),
    )
