"""Methods of the kinematics stage: closed elimination, projections, splitting, numerical differentiation.

The reference is the chain in extended precision, whose rounding unit is 2000 times finer; that the formulas themselves
are right is a matter of tests against a solver that knows nothing of groups.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from functools import partial
from operator import attrgetter

import numpy as np

from tmmcalc.core.numerics.extended import WIDER
from tmmcalc.core.plane import Plane, Real
from tmmcalc.core.studies.measure import Clock, Way, relative, series
from tmmcalc.core.studies.scene import Scene
from tmmcalc.core.studies.study import Reference, Series, Study
from tmmcalc.linkage import solvers
from tmmcalc.linkage.chain import Chain, chain_of
from tmmcalc.linkage.differentiation import differentiate
from tmmcalc.linkage.kinematics import crank_length
from tmmcalc.linkage.results import Kinematics, Trace
from tmmcalc.linkage.trace import trace

STEPS_DEG = (10.0, 5.0, 2.0, 1.0, 0.5, 0.2, 0.1, 0.02, 0.002, 2e-4)
ROUNDED = 6  # decimals of a table on paper
VANISHES = 1e-9  # part of what a quantity is made of: a smaller one is zero but for rounding

Quantity = Callable[[Trace], Plane | Real]  # of points, links or prismatic joints: measured by its own largest value

EXTENDED = float(np.finfo(np.longdouble).eps)


def studies(scene: Scene) -> Iterator[Study]:
    """Positions, velocities and accelerations of all points and links by every method."""
    result: Kinematics = scene.results["kinematics"]
    chain = chain_of(scene.inputs, result)
    if not WIDER:
        return  # the platform has no wider float to compare with
    exact = trace(chain, result.x.astype(np.longdouble))
    reference = Reference("the same formulas in extended precision (64-bit mantissa)", EXTENDED)
    yield Study("kinematics", "positions", reference, _positions(chain, result, exact, scene.clock))
    of = _quantities(exact)
    for quantity, each in (("velocities", of[0]), ("accelerations", of[1])):
        if each:
            yield Study("kinematics", quantity, reference, _derivatives(chain, result, exact, each, scene.clock))


def _positions(chain: Chain, result: Kinematics, exact: Trace, clock: Clock) -> tuple[Series, ...]:
    def error(found: Trace) -> float:
        return relative(found.r, exact.r)

    name = "closed form" if all(group.kind for group in chain.structure.groups) else "Newton from the branch"
    found = [series(name, [Way("", None, partial(trace, chain, result.x, order=0))], error, clock)]
    return (*found, *_splitting(chain, result, error, clock, 0))


def _derivatives(
    chain: Chain, result: Kinematics, exact: Trace, of: tuple[Quantity, ...], clock: Clock
) -> tuple[Series, ...]:
    def error(found: Trace) -> float:
        return max(relative(each(found), each(exact)) for each in of)

    x, unit = result.x, crank_length(chain) or 1.0
    per_degree = math.radians(1.0) if result.turns else float(np.ptp(x)) / 360
    told = "deg" if result.turns else "of 360 parts"

    def ways(decimals: int | None) -> list[Way]:
        return [
            Way(f"{step:g} {told}", step, partial(differentiate, chain, x, step * per_degree, decimals, unit))
            for step in STEPS_DEG
        ]

    return (
        series("elimination (closed)", [Way("", None, partial(trace, chain, x))], error, clock),
        series("projections", [Way("", None, partial(trace, chain, x, solvers.projection))], error, clock),
        *_splitting(chain, result, error, clock, 2),
        series("central differences", ways(None), error, clock, expected=2.0),
        series(
            f"differences, {ROUNDED} decimals",
            ways(ROUNDED),
            error,
            clock,
            note=f"positions rounded to {ROUNDED} decimals of the crank's length, as on paper",
        ),
    )


def _splitting(
    chain: Chain, result: Kinematics, error: Callable[[Trace], float], clock: Clock, order: int
) -> tuple[Series, ...]:
    """Splitting into dyads, which is a method of its own for groups of class III and higher alone."""
    if all(group.kind for group in chain.structure.groups):
        return ()
    from tmmcalc.linkage.loops.splitstep import split_chain

    def solve() -> Trace:
        return trace(split_chain(chain), result.x, order=order)

    return (series("splitting into dyads", [Way("", None, solve)], error, clock),)


def _quantities(exact: Trace) -> tuple[tuple[Quantity, ...], tuple[Quantity, ...]]:
    """Velocities and accelerations of points, links and prismatic joints, without those that are zero but for rounding.

    Such are the acceleration of a driven slider by its own coordinate, and the turning of links that only slide.
    """
    length = float(np.ptp(exact.r.real) + np.ptp(exact.r.imag)) or 1.0
    speed = max(_largest(exact.dr), _largest(exact.ds), length * _largest(exact.dangle))
    made_of = (speed, speed / length, speed), (speed**2 / length, (speed / length) ** 2, speed**2 / length)
    names = ("dr", "dangle", "ds"), ("ddr", "ddangle", "dds")
    velocities, accelerations = (
        tuple(
            attrgetter(name)
            for name, size in zip(order, sizes, strict=True)
            if _largest(getattr(exact, name)) > VANISHES * size
        )
        for order, sizes in zip(names, made_of, strict=True)
    )
    return velocities, accelerations


def _largest(values: Plane | Real) -> float:
    return float(np.max(np.abs(values), initial=0.0))
