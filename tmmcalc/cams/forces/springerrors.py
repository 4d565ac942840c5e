"""The spring as its places ask for it, in extended precision: what the one that is found is off by.

Stiffness and preload follow from P and dS at a few places, where a function of the turn is largest or least. At a place
that is found such a function falls short of its peak by slope^2/(2 bend), so that the place itself need not be exact.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace

import numpy as np

from tmmcalc.cams.follower import Follower
from tmmcalc.cams.forces.results import SpringFound
from tmmcalc.cams.forces.spring import DEFLECTION, LEVEL, lifting_force
from tmmcalc.cams.forces.state import Carried, carried
from tmmcalc.cams.forces.turn import acceleration
from tmmcalc.cams.laws.law import Indices, Values
from tmmcalc.cams.program import SAME, TURN
from tmmcalc.cams.rounding import APART, crest, relative, sides
from tmmcalc.cams.task import CamTask, Loads
from tmmcalc.cams.wide import wide
from tmmcalc.core.records import record

OffAndLift = Callable[[Values, Values], Values]  # of P and dS


@record
class WideSpring:
    """Stiffness and preload in extended precision."""

    stiffness: np.longdouble
    preload: np.longdouble


def exact_carried(task: CamTask, follower: Follower, loads: Loads, spring: WideSpring) -> Carried:
    """What is the same all over the turn, in extended precision."""
    there = replace(task, guide=wide(task.guide))
    return carried(there, wide(follower), wide(loads), spring.stiffness, spring.preload)


def exact_spring(task: CamTask, loads: Loads, spring: SpringFound) -> WideSpring:
    """The spring of P and dS at its places; one that is given as it is."""
    asked, given = wide(loads.spring), WideSpring(np.longdouble(spring.stiffness), np.longdouble(spring.preload))
    if spring.method in ("none", "given") or spring.phi is None or not spring.stiffness or spring.lifting is None:
        return given
    turn = _Turn(task.sprung, wide(loads))
    if spring.method == "preload":
        first = wide(DEFLECTION * task.program.stroke) if asked.deflection is None else asked.deflection
        c = turn.peak(lambda force, lift: (force + asked.least) / (first + lift), spring.phi, spring.stiffness)
        return WideSpring(c, c * first)
    force, lift = turn.top(spring.phi, spring.lifting)
    preload = (asked.safety - 1) * force
    if asked.exact:
        if spring.preload > (asked.safety - 1) * spring.lifting * (1 + LEVEL):
            preload = asked.safety * turn.at_rest(spring.preload / asked.safety)
        return WideSpring(turn.needed(spring, asked.safety, preload), preload)
    if spring.governing is not None:
        force, lift = turn.top(spring.governing.phi, spring.governing.force)
    return WideSpring((asked.safety * force - preload) / lift, preload)


def spring_miss(spring: SpringFound, exact: WideSpring) -> float:
    """By how much stiffness and preload are off, the larger part of itself."""
    both = ((spring.stiffness, exact.stiffness), (spring.preload, exact.preload))
    return max((abs(float(true / found - 1)) for found, true in both if found), default=0.0)


def spring_error(task: CamTask, loads: Loads, spring: SpringFound, exact: WideSpring) -> float:
    """The largest estimate of stiffness, preload, the least stiffness and the safety reached, each of itself."""
    return max(_misses(task, loads, spring, exact), default=0.0)


def _misses(task: CamTask, loads: Loads, spring: SpringFound, exact: WideSpring) -> Iterator[float]:
    turn, moving = _Turn(task.sprung, wide(loads)), _Turn(task, wide(loads))
    for found, true in ((spring.stiffness, exact.stiffness), (spring.preload, exact.preload)):
        if found and spring.method not in ("none", "given"):
            yield relative([found], [true])
    if spring.exact and spring.exact_phi is not None and spring.asked is not None:
        yield relative([spring.exact], [turn.needed(spring, wide(spring.asked), exact.preload)])
    if spring.reached and spring.reached_phi is not None:

        def ratio(force: Values, lift: Values) -> Values:
            pressed = force > 0  # on the other side of a jump nothing may lift off
            held: Values = -(exact.preload + exact.stiffness * lift) / np.where(pressed, force, 1.0)
            return np.where(pressed, held, -np.inf)

        yield relative([spring.reached], [-moving.peak(ratio, spring.reached_phi, -spring.reached)])


@record
class _Turn:
    """P and dS over the turn in extended precision."""

    task: CamTask
    loads: Loads  # wide

    def at(self, phi: Values, piece: Indices) -> tuple[Values, Values]:
        """P and dS (n,) at angles phi (n,) on pieces (n,)."""
        motion = self.task.program.wider.at(phi, piece)
        return lifting_force(self.task, self.loads, acceleration(self.task, self.loads, phi, motion)), motion[0]

    def peak(self, f: OffAndLift, phi: float, found: float) -> np.longdouble:
        """The largest value of f near a place where ``found`` is; on an edge the nearer limit."""
        return self._moved(f, phi, found)[0]

    def top(self, phi: float, found: float) -> tuple[np.longdouble, np.longdouble]:
        """The largest P near a place, and dS there."""
        force, at = self._moved(lambda force, lift: force, phi, found)
        _, lift = self.at(np.array([at]), self.task.program.piece(np.array([phi])))
        return force, lift[0]

    def needed(self, spring: SpringFound, safety: float, preload: np.longdouble) -> np.longdouble:
        """The least stiffness that keeps the safety all over the turn; none where there is none."""
        phi, found = spring.exact_phi, spring.exact
        if phi is None or not found:
            return np.longdouble(spring.stiffness)
        return self.peak(lambda force, lift: (safety * force - preload) / lift, phi, found)

    def at_rest(self, found: float) -> np.longdouble:
        """P at the lowest position, of all edges that which is nearest to what is found."""
        rows = sides(self.task.program, self.task.program.edges)
        force, lift = self.at(wide(rows.phi), rows.piece)
        low = force[lift <= LEVEL * self.task.program.stroke]
        return low[int(np.argmin(np.abs(low - found)))] if low.size else np.longdouble(found)

    def _moved(self, f: OffAndLift, phi: float, found: float) -> tuple[np.longdouble, np.longdouble]:
        """Value and place of the peak of f near a place; on an edge of the limit that is nearer to ``found``."""
        program = self.task.program
        edge = int(np.argmin(np.abs(program.edges - phi)))
        gap = abs(float(program.edges[edge]) - phi)
        if gap <= SAME * TURN:
            rows = sides(program, np.array([phi]))
            place = program.wider.edges[edge]
            limits = f(*self.at(np.array([place, place]), rows.piece))
            return limits[int(np.argmin(np.abs(limits - found)))], place
        piece = program.piece(np.full(7, phi))
        return crest(lambda x: f(*self.at(x, piece)), phi, min(APART, gap / 4))
