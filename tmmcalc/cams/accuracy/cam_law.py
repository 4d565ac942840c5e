"""Methods for the law of motion: exact derivatives, differences of the displacement, the acceleration integrated.

The reference is the same law in extended precision; that its formulas are right is a matter of tests at 50 digits.
Differences are taken within the pieces of the laws, between which derivatives jump. The acceleration is integrated
twice over every piece. A law of the user's own by points is set beside the law that the points are taken of.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial

import numpy as np

from tmmcalc.cams.laws.law import Indices, Law, Values
from tmmcalc.cams.laws.own import of_points
from tmmcalc.cams.program import Program
from tmmcalc.cams.wide import wide
from tmmcalc.core.numerics.extended import WIDER
from tmmcalc.core.numerics.simpson import running_simpson
from tmmcalc.core.studies.measure import Clock, Way, relative, series
from tmmcalc.core.studies.scene import Scene
from tmmcalc.core.studies.study import Reference, Series, Study

PARTS = np.array([0.4, 0.5, 0.6])  # of a piece: where derivatives are compared
STEPS = (0.3, 0.1, 0.03, 0.01, 3e-3, 1e-3, 3e-4, 1e-4, 1e-5, 1e-6)  # of a piece
COUNTS = (2, 4, 8, 16, 32, 64, 128, 256)  # steps of a piece
POINTS = (6, 8, 12, 16, 24, 32, 48, 64)  # of a law by points
PLACES = np.linspace(0.02, 0.98, 97)  # k at which it is compared
FOURTH = "the acceleration of a spline of the fifth degree is of order 4 for a law without jumps, at rest at its ends"

EXTENDED = float(np.finfo(np.longdouble).eps)


def studies(scene: Scene) -> Iterator[Study]:
    """Velocity, acceleration, the displacement by integration, and laws by points."""
    program: Program = scene.inputs.program
    if not WIDER:
        return
    phi, piece, width = _places(program)
    exact = program.wider.at(wide(phi), piece)
    reference = Reference("the same law in extended precision (64-bit mantissa)", EXTENDED)
    for order, name in ((1, "velocity"), (2, "acceleration")):
        found = _derivatives(program, (phi, piece, width), order, exact[order], scene.clock)
        yield Study("cam_law", name, reference, found)
    yield Study("cam_law", "displacement, from the acceleration", reference, _integrals(program, scene.clock))
    laws = {phase.law.name: phase.law for phase in program.phases if phase.law is not None}
    for law in laws.values():
        yield Study("cam_law", f"acceleration of {law.name} by points", reference, _by_points(law, scene.clock))


def _moving(program: Program) -> Indices:
    """Numbers of the pieces of moving phases."""
    moves = np.array([phase.moves for phase in program.phases])
    return np.flatnonzero(moves[program.places[0]])


def _places(program: Program) -> tuple[Values, Indices, Values]:
    """Angles (m,) within the moving pieces, the numbers of these, and their widths."""
    moving = _moving(program)
    start, width = program.edges[moving], np.diff(program.edges)[moving]
    phi = start[:, None] + width[:, None] * PARTS
    return phi.ravel(), np.repeat(moving, len(PARTS)), np.repeat(width, len(PARTS))


def _derivatives(
    program: Program, places: tuple[Values, Indices, Values], order: int, exact: Values, clock: Clock
) -> tuple[Series, ...]:
    phi, piece, width = places

    def closed() -> Values:
        return np.asarray(program.at(phi, piece)[order])

    def differences(part: float) -> Values:
        step = part * width
        low, here, high = (program.at(phi + side * step, piece)[0] for side in (-1, 0, 1))
        return (high - low) / (2 * step) if order == 1 else (high - 2 * here + low) / step**2

    def error(found: Values) -> float:
        return relative(found, exact)

    ways = [Way(f"{part:g} of a piece", part, partial(differences, part)) for part in STEPS]
    return (
        series("exact derivative", [Way("", None, closed)], error, clock),
        series("central differences", ways, error, clock, expected=2.0),
    )


def _integrals(program: Program, clock: Clock) -> tuple[Series, ...]:
    moving = _moving(program)
    ends = program.edges[np.concatenate((moving, moving + 1))]
    exact = program.wider.at(wide(ends), np.tile(moving, 2))[0].reshape(2, -1)
    rises = exact[1] - exact[0]

    def integrated(count: int, rule: Callable[[Values, Values], Values]) -> Values:
        """What y gains over every piece."""
        start, width = program.edges[moving], np.diff(program.edges)[moving]
        phi = start[:, None] + width[:, None] * np.arange(count + 1) / count
        motion = program.at(phi.ravel(), np.repeat(moving, count + 1)).reshape(4, len(moving), -1)
        step = width / count
        speed = motion[1][:, :1] + rule(motion[2], step)
        return np.asarray(rule(speed, step)[:, -1])

    def error(found: Values) -> float:
        return relative(found, rises)

    def ways(rule: Callable[[Values, Values], Values]) -> list[Way]:
        return [Way(f"{n} steps a piece", 1 / n, partial(integrated, n, rule)) for n in COUNTS]

    return (
        series("trapezoid, twice", ways(_trapezoid), error, clock, expected=2.0),
        series("Simpson, twice", ways(running_simpson), error, clock, expected=4.0),
    )


def _trapezoid(values: Values, step: Values) -> Values:
    """The integral (P, n + 1) from the first node to every node of values (P, n + 1)."""
    parts = (values[:, 1:] + values[:, :-1]) / 2 * step[:, None]
    return np.concatenate((np.zeros((len(values), 1)), np.cumsum(parts, axis=1)), axis=1)


def _by_points(law: Law, clock: Clock) -> tuple[Series, ...]:
    exact = wide(law).at(wide(PLACES))[2]

    def splined(count: int) -> Values:
        k = np.arange(count + 1) / count
        s = np.concatenate(([0.0], law.at(k)[0, 1:-1], [1.0]))  # exact ends
        return np.asarray(of_points(k, s).at(PLACES)[2])

    def differenced(count: int) -> Values:
        k = np.arange(count + 1) / count
        second = np.diff(law.at(k)[0], 2) * count**2
        return np.interp(PLACES, k[1:-1], second)

    def error(found: Values) -> float:
        return relative(found, exact)

    def ways(solve: Callable[[int], Values]) -> list[Way]:
        return [Way(f"{n} parts", 1 / n, partial(solve, n)) for n in POINTS]

    return (
        series("spline through the points", ways(splined), error, clock, note=FOURTH),
        series("second differences of the table", ways(differenced), error, clock),
    )
