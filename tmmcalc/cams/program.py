"""The motion of a follower over a turn of the cam: phases with their laws, and dwells.

    rise     y = low + (high - low) s(k),   k = (phi - start)/angle                                  (5.1 to 5.5)
    return   the same with k = (end - phi)/angle, which runs from 1 to 0                             (5.9, 5.10)

y is the displacement from the lowest position, in metres or radians; its derivatives are by phi. Where a derivative
jumps, between two pieces, a row of a table stands for one side of it.
"""

from __future__ import annotations

from functools import cached_property
from math import pi
from typing import Literal

import numpy as np

from tmmcalc.cams.laws.law import ORDERS, Indices, Law, Values
from tmmcalc.core.columns import degrees
from tmmcalc.core.numerics.gauss import rule
from tmmcalc.core.numerics.panels import Extreme, Panels, panels
from tmmcalc.core.quantity import derived, quantity
from tmmcalc.core.records import record

PhaseKind = Literal["rise", "high dwell", "return", "low dwell"]
TURN = 2 * pi
SAME = 1e-12  # of the largest: a jump that is rounding
FLAT = 1e-13  # of the largest: what varies less on a panel is constant there, as all is in a dwell


@record
class Phase:
    """A part of the turn."""

    kind: PhaseKind
    angle: float  # [rad]
    start: float  # y at its begin
    end: float  # y at its end
    law: Law | None = None  # None: dwell

    @property
    def moves(self) -> bool:
        """Whether the follower moves."""
        return self.law is not None


@record
class Program:
    """The phases of a whole turn, from the start of the rise."""

    phases: tuple[Phase, ...]

    @cached_property
    def starts(self) -> Values:
        """Angles (phases + 1,) at which the phases begin, and the end of the last."""
        return np.concatenate(([0.0], np.cumsum([phase.angle for phase in self.phases])))

    @property
    def stroke(self) -> float:
        """h or psi_m: the largest displacement."""
        return max(max(phase.start, phase.end) for phase in self.phases)

    @cached_property
    def span(self) -> tuple[Extreme, Extreme]:
        """Least and largest y of the turn, each with its angle: a law of one's own may leave 0 to h."""
        at, y = self.turned
        low, high = int(np.argmin(y)), int(np.argmax(y))
        return (float(y[low]), float(at[low])), (float(y[high]), float(at[high]))

    @cached_property
    def turned(self) -> tuple[Values, Values]:
        """Angles and y (m,) of all places where the follower turns, and of both sides of all edges of the panels."""
        return self.panels.turning(levelled(self.sampled[0]))

    @property
    def lowest(self) -> float:
        """Least y of the turn; below 0 where a law undershoots."""
        least = self.span[0][0]
        return least if least < -SAME * self.stroke else 0.0

    @property
    def highest(self) -> float:
        """Largest y of the turn; above the stroke where a law overshoots."""
        largest = self.span[1][0]
        return largest if largest > self.stroke * (1 + SAME) else self.stroke

    @cached_property
    def edges(self) -> Values:
        """Angles (P + 1,) between which the motion is smooth: pieces of the laws, dwells."""
        parts = [np.zeros(1)]
        for start, phase in zip(self.starts, self.phases, strict=False):
            breaks = np.array([0.0, 1.0]) if phase.law is None else phase.law.breaks
            if phase.law is not None and phase.end < phase.start:
                breaks = 1 - breaks[::-1]
            parts.append(start + phase.angle * breaks[1:])
        return np.concatenate(parts)

    @cached_property
    def places(self) -> tuple[Indices, Indices]:
        """Of every piece (P,) the number of its phase, and of its piece in the law; both ascend with phi."""
        phases, pieces = [], []
        for number, phase in enumerate(self.phases):
            count = 1 if phase.law is None else phase.law.count
            order = range(count) if phase.end >= phase.start else reversed(range(count))
            pieces += list(order)
            phases += [number] * count
        return np.array(phases), np.array(pieces)

    def piece(self, phi: Values) -> Indices:
        """Numbers (n,) of the pieces that hold phi; between two of them the moving one, else the earlier.

        An angle within rounding of an edge counts as the edge.
        """
        near = SAME * float(self.starts[-1])
        after = np.clip(np.searchsorted(self.edges, phi + near, side="right") - 1, 0, len(self.edges) - 2)
        before = np.clip(np.searchsorted(self.edges, phi - near, side="left") - 1, 0, len(self.edges) - 2)
        moves = np.array([phase.moves for phase in self.phases])[self.places[0]]
        return np.where(moves[before] | ~moves[after], before, after)

    def at(self, phi: Values, piece: Indices | None = None) -> Values:
        """y, y', y'', y''' (4, n) at angles phi (n,) of the turn; ``piece`` (n,) says which side of a jump is meant."""
        phi = np.asarray(phi) + 0.0
        number = self.piece(phi) if piece is None else piece
        phase_of, law_piece = self.places
        values = np.zeros((ORDERS, len(phi)), phi.dtype)
        which = phase_of[number]
        for k, phase in enumerate(self.phases):
            rows = np.flatnonzero(which == k)
            if not rows.size:
                continue
            if phase.law is None:
                values[0, rows] = phase.start
                continue
            values[:, rows] = _moved(phase, phase.law, self.starts[k], phi[rows], law_piece[number[rows]])
        return values

    @cached_property
    def wider(self) -> Program:
        """The same in extended precision, for the estimates of errors."""
        from tmmcalc.cams.wide import wide

        laws = (None if each.law is None else each.law.wider for each in self.phases)
        ends = (wide((each.angle, each.start, each.end)) for each in self.phases)
        return Program(
            tuple(Phase(each.kind, *own, law) for each, own, law in zip(self.phases, ends, laws, strict=True))
        )

    @cached_property
    def panels(self) -> Panels:
        """Panels of the turn with edges where anything jumps, and in the middle of every moving phase.

        A whole period of a harmonic law on one panel would be good to ten digits only.
        """
        middles = [
            start + phase.angle / 2 for start, phase in zip(self.starts, self.phases, strict=False) if phase.moves
        ]
        return panels(0.0, float(self.starts[-1]), [*self.edges, *middles])

    @cached_property
    def sampled(self) -> Values:
        """y and its derivatives at the points of the panels, (4, K, N)."""
        on = self.panels
        middle = (on.edges[:-1] + on.edges[1:]) / 2
        number = np.clip(np.searchsorted(self.edges, middle) - 1, 0, len(self.edges) - 2)
        x = on.x
        return self.at(x.ravel(), np.repeat(number, on.order)).reshape(ORDERS, *x.shape)

    @cached_property
    def jumps(self) -> Values:
        """What y, y', y'', y''' jump by at every edge but the last, (4, P); at the first from the end of the turn."""
        count = len(self.edges) - 1
        every = np.arange(count)
        after, before = self.at(self.edges[:-1], every), self.at(self.edges[1:], every)
        jump = after - np.roll(before, 1, axis=1)
        size = np.max(np.abs(np.concatenate((after, before, self.sampled.reshape(ORDERS, -1)), axis=1)), axis=1)
        return np.where(np.abs(jump) > SAME * size[:, None], jump, 0.0)


def _moved(phase: Phase, law: Law, start: float, phi: Values, piece: Indices) -> Values:
    height, back = phase.end - phase.start, phase.end < phase.start
    part = np.clip((phi - start) / phase.angle, 0.0, 1.0)
    s = law.at(1 - part if back else part, piece)
    rate = np.array([1.0, -1.0, 1.0, -1.0]) if back else np.ones(ORDERS)
    values = abs(height) * rate[:, None] / phase.angle ** np.arange(ORDERS)[:, None] * s
    values[0] += min(phase.start, phase.end)
    return values


@record
class Positions:
    """Rows of the tables: angles of the cam, each on one side of what jumps there."""

    phi: Values = quantity("phi[rad]", "angle of the cam")  # (n,)
    piece: Indices  # (n,) of the program
    labels: tuple[str, ...] = quantity("i", "number of the position; 12- is the limit before a jump at position 12")

    @derived("phi[deg]", "angle of the cam")
    def degrees(self) -> Values:
        """(n,) where a step of 15 is 15."""
        return degrees(self.phi)


def positions(program: Program, phi: Values) -> Positions:
    """The rows at angles phi and at all ends of phases; two where y', y'' jumps."""
    end = float(program.starts[-1])
    every = np.concatenate((phi, program.starts))
    every = np.sort(every[(every >= 0) & (every <= end)])
    every = every[np.concatenate(([True], np.diff(every) > SAME * end))]
    after = np.minimum(np.searchsorted(every, program.edges), len(every) - 1)
    before = np.maximum(after - 1, 0)
    near = np.where(program.edges - every[before] < every[after] - program.edges, before, after)
    on_edge = np.abs(every[near] - program.edges) <= SAME * end
    every[near[on_edge]] = program.edges[on_edge]
    pieces, labels = program.piece(every), list(map(str, range(len(every))))
    jumps = np.flatnonzero(np.any(program.jumps[1:3] != 0, axis=0) & on_edge[:-1])
    jumps = jumps[jumps > 0]
    for edge in jumps[::-1].tolist():
        labels.insert(near[edge], f"{near[edge]}-")
    pieces[near[jumps]] = jumps - 1
    return Positions(
        np.insert(every, near[jumps] + 1, every[near[jumps]]), np.insert(pieces, near[jumps] + 1, jumps), tuple(labels)
    )


def of_steps(program: Program, count: int) -> Positions:
    """The textbook's rows: ``count`` equal steps of every moving phase, the ends of the dwells."""
    parts = np.arange(count + 1) / count
    moving = [
        start + phase.angle * parts for start, phase in zip(program.starts, program.phases, strict=False) if phase.moves
    ]
    return positions(program, np.concatenate(moving))


def of_step(program: Program, step: float) -> Positions:
    """Rows every ``step`` [rad], and at the ends of the phases."""
    end = float(program.starts[-1])
    return positions(program, step * np.arange(int(end / step + 1e-9) + 1))


def levelled(values: Values) -> Values:
    """Values (K, N) with a slope of rounding on panels where they are constant.

    Rounding would make such a panel full of turning points, which all would be looked for.
    """
    peak = np.max(np.abs(values))
    flat = np.max(values, axis=1) - np.min(values, axis=1) <= FLAT * peak
    if not flat.any():
        return values
    ramp = FLAT * peak * rule(values.shape[1]).points
    return np.where(flat[:, None], values[:, :1] + ramp, values)
