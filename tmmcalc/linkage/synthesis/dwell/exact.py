"""Exact figures of one six-bar over its turn: extremes of the output as roots of S', largest values refined.

Turns of the crank ``phi`` count from position 1, counter-clockwise, whatever its sense.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from tmmcalc.core.numerics.extrema import around, refine, turning, with_turning_points
from tmmcalc.core.numerics.roots import bracketed
from tmmcalc.core.plane import Real
from tmmcalc.linkage.synthesis.dwell.criteria import Criteria, StrokeTurns, strokes_of
from tmmcalc.linkage.synthesis.dwell.motion import Unknowns, pose
from tmmcalc.linkage.synthesis.dwell.task import DwellTask
from tmmcalc.linkage.synthesis.dwell.turn import TURN, Turn, along
from tmmcalc.linkage.synthesis.dwell.unitforces import UnitForces, unit_forces

SAMPLES = 720  # of a turn
REFINED = 3  # local extremes that are refined for the global one
Peak = tuple[float, float]  # value and place


class BarPeak(NamedTuple):
    """A bar where its unit force is largest on a stroke: ``at`` turned from position 1, the pins and forces there."""

    bar: str  # f3 or f4
    at: float
    pins: tuple[complex, ...]  # A, B, C, D, E
    forces: UnitForces  # each (1,)


class Figures(NamedTuple):
    """What the output does: reversals, stroke, dwell, strokes; the largest values; the criteria."""

    reversals: tuple[Peak, ...]  # S and phi, ascending phi
    stroke: float
    far: float  # phi of the reversal that is farthest from the dwell
    dwell: Peak  # largest |S| over the dwell
    strokes: StrokeTurns
    largest: dict[str, Peak]  # of |S'|, |S''|, |f3|, |f4|, R21 and |N|, tan|delta|
    criteria: Criteria
    bars: tuple[tuple[BarPeak, BarPeak], tuple[BarPeak, BarPeak]]  # of the working and of the idle stroke


def figures(turn: Turn, asked: DwellTask) -> Figures:
    """The figures of the turn of one linkage."""
    reversals = reversals_of(turn)
    values = [value for value, _ in reversals]
    far = max(reversals, key=lambda peak: abs(peak[0]))[1]
    stroke = max(values) - min(values)
    rests = [peak for peak in reversals if peak[1] <= asked.dwell]
    dwell = max(((abs(value), at) for value, at in rests), default=(0.0, 0.0))
    strokes = strokes_of(asked, np.array([far]))
    largest = {name: peak(turn, of) for name, of in MEASURES.items()}
    working, idle = (_bars(turn, *(float(end[0]) for end in window)) for window in strokes)
    parts = [sum(float(getattr(each.forces, each.bar)[0]) ** 2 for each in bars) for bars in (working, idle)]
    size = 0.0 if turn.linkages.rocks else 1 / float(turn.linkages.crank[0])
    f1 = dwell[0] / stroke
    criteria = Criteria(*(np.array([f]) for f in (f1, size, np.tan(largest["delta"][0]), *parts)))
    return Figures(reversals, stroke, far, dwell, strokes, largest, criteria, (working, idle))


def _bars(turn: Turn, low: float, high: float) -> tuple[BarPeak, BarPeak]:
    """Both bars where their unit forces are largest over a window of the turn."""
    return _bar(turn, "f3", low, high), _bar(turn, "f4", low, high)


def _bar(turn: Turn, bar: str, low: float, high: float) -> BarPeak:
    _, at = peak(turn, MEASURES[bar], low, high)
    state, forces = forces_at(turn, np.array([at]))
    pins = pose(turn.linkages, turn.linkages.phi0 + at, state.theta, state.s)
    places = (complex(np.ravel(each)[0]) for each in (pins.a, pins.b, pins.c, pins.d, pins.e))
    return BarPeak(bar, at, tuple(places), forces)


def forces_at(turn: Turn, phi: Real) -> tuple[Unknowns, UnitForces]:
    """States and unit forces (n,) of the turn of one linkage."""
    state = along(turn, phi)
    return state, unit_forces(turn.linkages, turn.linkages.phi0 + phi, state.theta, state.s)


def peak(turn: Turn, of: Callable[[Unknowns, UnitForces], Real], low: float = 0.0, high: float = TURN) -> Peak:
    """Largest size and its place of a quantity over a window of the turn."""
    x = np.linspace(low, high, max(round(SAMPLES * (high - low) / TURN), 8) + 1)

    def value(at: Real, _: object) -> Real:
        return np.abs(of(*forces_at(turn, at)))

    values = value(x, None)
    rows = turning(values, 1, False)
    rows = rows[np.argsort(-values[rows])][:REFINED]
    inner = rows[(rows > 0) & (rows < len(x) - 1)]
    at, sizes = refine(value, *around(x, inner, False))
    places: Real = np.append(at, x[[0, -1]])
    found: Real = np.append(sizes, values[[0, -1]])
    best = int(np.argmax(found))
    return float(found[best]), float(places[best])


def reversals_of(turn: Turn) -> tuple[Peak, ...]:
    """S and phi of all reversals of the output of one linkage, ascending phi."""

    def rate(at: Real, _: object) -> Real:
        return along(turn, at).ds

    x: Real = np.linspace(0.0, TURN, SAMPLES + 1)
    values = rate(x, None)
    values[-1] = values[0]
    x, values = with_turning_points(rate, x, values, near=0.02 * float(np.max(np.abs(values))), period=TURN)
    sign = np.signbit(values)
    change = np.flatnonzero(sign[1:] != sign[:-1])
    at = bracketed(rate, x[change], x[change + 1])
    return tuple(zip(along(turn, at).s.tolist(), at.tolist(), strict=True))


MEASURES: dict[str, Callable[[Unknowns, UnitForces], Real]] = {
    "ds": lambda state, forces: state.ds,
    "dds": lambda state, forces: state.dds,
    "f3": lambda state, forces: forces.f3,
    "f4": lambda state, forces: forces.f4,
    "r21": lambda state, forces: forces.r21,
    "normal": lambda state, forces: forces.normal,
    "delta": lambda state, forces: forces.delta,
}
