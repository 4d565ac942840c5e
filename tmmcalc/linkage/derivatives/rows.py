"""How the rows of the table, dead centres and the ends of the range move along the input when the inputs change.

Rows keep their labels. Position 0 is given, or a dead centre, where the first transfer function of an output vanishes:
S'(x, p) = 0, hence dx = -dS'/S'' of its change at a fixed x.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from tmmcalc.core.plane import Real
from tmmcalc.linkage.assembly import TURN
from tmmcalc.linkage.chain import Chain
from tmmcalc.linkage.derivatives.closure import EPS, Closure, Moved, Slopes, changes_of
from tmmcalc.linkage.model import Mechanism, Output
from tmmcalc.linkage.results import Kinematics, OutputSummary

SAME = 1e-6  # a place nearer than this part of the range to what may stand there is that


class Turns(NamedTuple):
    """Dead centres of an output: how their input coordinates and the output there change, (K, m) each; their errors."""

    x: Real
    value: Real
    x_error: Real  # (K,)
    value_error: Real


class Placing(NamedTuple):
    """How position 0 moves, (K, 1); the dead centres of all outputs."""

    start: Real
    turns: tuple[Turns, ...]
    error: Real  # (K,) of that of position 0


class Directions(NamedTuple):
    """A solved mechanism and K directions along which its inputs change."""

    chain: Chain
    kinematics: Kinematics
    changes: Any  # the mechanism with its slopes
    along_x: Any  # the same with none, of one direction
    places: Real  # (p,) input coordinates of ``moved``, the changes there, and of ``along``, those along x
    moved: Moved
    along: Moved

    def at(self, x: Real) -> tuple[Moved, Moved]:
        """The changes at fixed input coordinates (m,), and the derivatives along the input coordinate."""
        first = np.minimum(np.searchsorted(self.places, x), len(self.places) - 1)
        if np.array_equal(self.places[first], x):
            return self.moved.some(first), self.along.some(first)
        closure = Closure(self.chain, x)
        return closure.moved(self.changes), closure.moved(self.along_x, along_x=True)

    @property
    def start(self) -> float:
        """Input coordinate of position 0."""
        return float(self.kinematics.x[0] - self.kinematics.phi[0])

    @property
    def sense(self) -> float:
        """Sign of the speed."""
        return math.copysign(1.0, self.kinematics.speed)


def directions_of(mechanism: Mechanism, chain: Chain, kinematics: Kinematics, slopes: Slopes, rows: Real) -> Directions:
    """The directions of slopes (K, L) of the numbers of the mechanism; ``rows`` are places that will be asked for."""
    changes = changes_of(mechanism, slopes)
    still = changes_of(mechanism, np.zeros((1, slopes.shape[1]), slopes.dtype))
    places = np.unique(np.concatenate((rows, kinematics.x, _special(kinematics))))
    closure = Closure(chain, places)
    moved, along = closure.moved(changes), closure.moved(still, along_x=True)
    return Directions(chain, kinematics, changes, still, places, moved, along)


def _special(kinematics: Kinematics) -> Real:
    """Dead centres, extremes, position 0."""
    found = [float(kinematics.x[0] - kinematics.phi[0])]
    for summary in kinematics.summaries:
        found += [centre.x for centre in summary.dead_centres]
        found += [extreme.x for extreme in (*summary.velocity, *summary.acceleration)]
    found += [each.transmission_at for each in kinematics.qualities if each.transmission_at is not None]
    return np.array(found)


def placing(directions: Directions, outputs: tuple[Output, ...]) -> Placing:
    """How position 0 and all dead centres move."""
    found = tuple(
        _turns(directions, output, k, np.array([centre.x for centre in summary.dead_centres]))
        for k, (output, summary) in enumerate(zip(outputs, directions.kinematics.summaries, strict=True))
    )
    given = directions.changes.input.start
    if given is not None:
        return Placing(np.asarray(given), found, EPS * np.abs(given[:, 0]))
    first = _turns(directions, outputs[0], 0, np.array([directions.start]))
    return Placing(first.x, found, first.x_error)


def _turns(directions: Directions, output: Output, number: int, x: Real) -> Turns:
    if not x.size:
        empty, none = np.zeros((len(directions.changes.input.speed), 0)), np.zeros(len(directions.changes.input.speed))
        return Turns(empty, empty, none, none)
    moved, along = directions.at(x)
    change, rates = moved.output(output, number)[1], along.output(output, number)[1]
    size = EPS * moved.largest() * np.max(moved.condition) / (moved.reach if output.link is not None else 1.0)
    least = float(np.min(np.abs(rates[1])))
    return Turns(-change[1] / rates[1], change[0], size[1] / least * _steepness(along, least), size[0])


def _steepness(along: Moved, least: float) -> float:
    """How much larger the derivatives are than the one that is divided by."""
    return max(1.0, float(along.largest().max()) / (along.reach * least)) if along.reach else 1.0


def row_shifts(directions: Directions, placed: Placing) -> Real:
    """Changes (K, n) of phi of all rows of the table.

    A base position is a part of the span, or of a stroke; one beside them is given, or a dead centre of an output.
    """
    grid, kinematics = directions.changes.grid, directions.kinematics
    base = directions.chain.mechanism.grid
    span = TURN if base.span is None else base.span
    way = math.copysign(1.0, span)
    along = kinematics.phi * way * directions.sense
    count = len(directions.changes.input.speed)
    result = np.zeros((count, len(along)))
    working = _working(directions, placed)
    for i, label in enumerate(kinematics.labels):
        if label.isdigit():
            number = int(label)
            if base.working is None or base.idle is None:
                own = np.zeros(count) if grid.span is None else way * grid.span[:, 0] * number / base.positions
            else:
                part = number / base.working if number <= base.working else 1 - (number - base.working) / base.idle
                own = working * part
        else:
            own = _beside(directions, placed, float(along[i]), way)
        result[:, i] = way * directions.sense * own
    return result


def _working(directions: Directions, placed: Placing) -> Real:
    """Change (K,) of the working angle of the first output; none without its two dead centres."""
    if not placed.turns or placed.turns[0].x.shape[1] != 2:
        return np.zeros(len(directions.changes.input.speed))
    x = placed.turns[0].x
    return directions.sense * (x[:, 1] - x[:, 0])


def _beside(directions: Directions, placed: Placing, along: float, way: float) -> Real:
    """Change (K,) of the way to a position beside the base: the nearest of those that are named."""
    base = directions.chain.mechanism.grid
    named = [(way * e, way * de[:, 0]) for e, de in zip(base.extra, directions.changes.grid.extra, strict=True)]
    if base.extremes:
        for turns, summary in zip(placed.turns, directions.kinematics.summaries, strict=True):
            for k, centre in enumerate(summary.dead_centres):
                at = way * directions.sense * (centre.x - directions.start)
                named.append((at, way * directions.sense * (turns.x[:, k] - placed.start[:, 0])))

    def apart(at: float) -> float:
        return abs(math.remainder(at - along, TURN)) if directions.chain.turns else abs(at - along)

    return min(named, key=lambda each: apart(each[0]))[1]


def ends_of(directions: Directions, placed: Placing) -> list[tuple[float, Real]]:
    """Both ends of an open range: input coordinate and its change (K,); a whole turn has none."""
    base, grid = directions.chain.mechanism.grid, directions.changes.grid
    span = TURN if base.span is None else base.span
    if directions.chain.turns and abs(abs(span) - TURN) < 1e-9:
        return []
    none = np.zeros(len(directions.changes.input.speed))
    places = [(0.0, none), (span, none if grid.span is None else grid.span[:, 0])]
    places += [(e, de[:, 0]) for e, de in zip(base.extra, grid.extra, strict=True)]
    found = (min(places, key=lambda place: place[0]), max(places, key=lambda place: place[0]))
    return [(directions.start + directions.sense * e, placed.start[:, 0] + directions.sense * de) for e, de in found]


def strokes(summary: OutputSummary) -> bool:
    """Whether an output has the two strokes of a whole turn."""
    return summary.working_angle is not None
