"""The loops of a group as two ways of vectors from the source chain that end in one point.

A vector goes from one named point to another; both lie on links that turn together, as a piston and its cylinder do.
It is a constant one in axes that turn with these links, and the coordinates of their prismatic joints:

    r_E = r_S + l e(phi + alpha) + sum_j s_j e(phi + delta_j)
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from tmmcalc.linkage.chain import Chain
from tmmcalc.linkage.loops.equations import Equations, Turning, equations_of
from tmmcalc.linkage.model import Joint
from tmmcalc.linkage.notes.group import guide_name, plain_name
from tmmcalc.linkage.pins import Pin, find_pins
from tmmcalc.linkage.structure import Group

NOTHING = 1e-12  # [m] of a constant vector


class Spin(NamedTuple):
    """Links that turn together: the angle of a line of theirs, and the link whose rates it has."""

    angle: str  # ``phi_3``; of a guide of the source chain ``gamma_5``
    link: int  # with the angular velocity
    known: bool  # solved before
    line: tuple[int, complex]  # a link of the group with the line's unit vector in its axes


class Slid(NamedTuple):
    """The coordinate of a prismatic joint along a vector: the joint, +1 or -1, its angle against the line."""

    joint: Joint
    sign: int
    delta: float  # [rad]

    @property
    def pair(self) -> str:
        """The slider and its guide: ``23``."""
        return "".join(map(str, self.joint.links))


class Arm(NamedTuple):
    """A vector between named points."""

    start: str
    end: str
    spin: Spin
    fixed: complex  # its constant part in axes along the line [m]
    slid: tuple[Slid, ...]

    @property
    def ends(self) -> str:
        """Both points as an index."""
        return f"{self.start}{self.end}"


class Way(NamedTuple):
    """Vectors from a point of the source chain."""

    start: str
    arms: tuple[Arm, ...]


class Loop(NamedTuple):
    """Two ways to one point."""

    point: str
    first: Way
    second: Way


class _Move(NamedTuple):
    """A part of a vector before those that turn together are joined; ``end`` may have no name."""

    turning: tuple[bool, int]
    fixed: complex
    slid: tuple[tuple[Joint, int], ...]
    end: str


def loops_of(chain: Chain, group: Group) -> tuple[Loop, ...]:
    """The loops of a group in the order of its equations."""
    return _Paths(chain, group).loops


def spins_of(chain: Chain, group: Group) -> dict[int, tuple[Spin, complex]]:
    """Of every link of a group what it turns with, and the line's unit vector in its axes."""
    paths = _Paths(chain, group)
    return {link: (paths.spin(link), paths.line(link)) for link in group.links}


class _Paths:
    """The loops of one group while they are gathered."""

    def __init__(self, chain: Chain, group: Group) -> None:
        self.mechanism, self.group = chain.mechanism, group
        self.equations: Equations = equations_of(chain.mechanism, group)
        self.pins = find_pins(chain.mechanism)
        self.joints = [self.mechanism.joint(name) for name in (*group.inner, *group.outer)]
        self.grown = {each.link: each for each in self.equations.tree}
        self.spins: dict[tuple[bool, int], Spin] = {}

    @property
    def loops(self) -> tuple[Loop, ...]:
        tree = {each.joint.name for each in self.equations.tree}
        return tuple(self._loop(joint) for joint in self.joints if joint.name not in tree)

    def _loop(self, joint: Joint) -> Loop:
        one, first = self._seat(joint, 0)
        two, second = self._seat(joint, 1)
        if joint.kind == "prismatic":
            second.append(_Move(self._turning(joint.links[1]), 0j, ((joint, 1),), ""))
        first, second = _joined(first), _joined(second)
        if joint.kind == "prismatic" and first and second and first[-1].turning == second[-1].turning:
            end = second[-2].end if len(second) > 1 else two
            first[-1] = _less(first[-1], second.pop(), end)
        end = next((moves[-1].end for moves in (first, second) if moves and moves[-1].end), "")
        end = end or (one if not first else two)
        return Loop(end, self._way(one, first, end), self._way(two, second, end))

    def _way(self, start: str, moves: Sequence[_Move], end: str) -> Way:
        arms, at = [], start
        for k, move in enumerate(moves):
            to = end if k == len(moves) - 1 else move.end
            spin = self._spin(move.turning)
            slid = tuple(Slid(joint, sign, self._delta(joint, move.turning)) for joint, sign in move.slid)
            arms.append(Arm(at, to, spin, move.fixed, slid))
            at = to
        return Way(start, tuple(arms))

    def _seat(self, joint: Joint, side: int) -> tuple[str, list[_Move]]:
        """The way to the point of a joint on one of its links; of a guide to the point of its line."""
        link, point = joint.links[side], joint.points[side]
        if link not in self.grown:
            return self._source_point(joint, side), []
        start, moves = self._entry(link)
        entry = self.grown[link].joint
        vector = (point - entry.points[entry.links.index(link)]) / self.line(link)
        return start, [*moves, _Move(self._turning(link), vector, (), self._pin(link, point))]

    def _entry(self, link: int) -> tuple[str, list[_Move]]:
        """The way to the point through which a link hangs on the source chain."""
        joint = self.grown[link].joint
        side = joint.links.index(link)
        start, moves = self._seat(joint, 1 - side)
        if joint.kind == "prismatic":
            name = self._pin(link, joint.points[side])
            moves.append(_Move(self._turning(link), 0j, ((joint, 1 if side == 0 else -1),), name))
        return start, moves

    def _source_point(self, joint: Joint, side: int) -> str:
        if joint.kind == "revolute":
            return self._pin(joint.links[side], joint.points[side])
        return guide_name(self.pins, joint)

    def _pin(self, link: int, point: complex) -> str:
        return next((plain_name(pin.name) for pin in self.pins if pin.joints and pin.at.get(link) == point), "")

    def _turning(self, link: int) -> tuple[bool, int]:
        own: Turning = self.equations.turnings[link]
        return own.known, own.of

    def spin(self, link: int) -> Spin:
        """What a link of the group turns with."""
        return self._spin(self._turning(link))

    def _spin(self, turning: tuple[bool, int]) -> Spin:
        if turning not in self.spins:
            self.spins[turning] = self._found(turning)
        return self.spins[turning]

    def _found(self, turning: tuple[bool, int]) -> Spin:
        links = [k for k in self.group.links if self._turning(k) == turning]
        known, of = turning
        rails = [j for j in self.joints if j.kind == "prismatic" and set(j.links) & set(links)]
        if known:
            rail = next(j for j in rails if not set(j.links) <= set(self.group.links))
            own = next(k for k in rail.links if k in links)
            return Spin(f"gamma_{own}", of, True, (own, rail.directions[rail.links.index(own)]))
        if rails:
            own = rails[0].links[1]
            return Spin(f"phi_{own}", own, False, (own, rails[0].directions[1]))
        (own,) = links
        one, other = self._ends(own)
        return Spin(f"phi_{own}", own, False, (own, (other - one) / abs(other - one)))

    def _ends(self, link: int) -> tuple[complex, complex]:
        """The first two pins of a link, one of the source chain before others."""
        outer = set(self.group.outer)
        own = [pin for pin in self.pins if link in pin.at and pin.joints]
        own.sort(key=lambda pin: not outer & set(pin.joints))
        return own[0].at[link], own[1].at[link]

    def line(self, link: int) -> complex:
        """The unit vector of the line in the axes of a link."""
        own, direction = self.spin(link).line
        turnings = self.equations.turnings
        return direction * turnings[own].turn / turnings[link].turn

    def _delta(self, joint: Joint, turning: tuple[bool, int]) -> float:
        side = next(k for k, link in enumerate(joint.links) if link in self.group.links)
        return cmath.phase(joint.directions[side] / self.line(joint.links[side]))


def _joined(moves: Sequence[_Move]) -> list[_Move]:
    """The moves with those that turn together as one, and without those that are nothing."""
    found: list[_Move] = []
    for move in moves:
        if found and found[-1].turning == move.turning:
            last = found.pop()
            end = move.end if move.slid else move.end or last.end  # what slides on leaves the point before it
            move = _Move(move.turning, last.fixed + move.fixed, last.slid + move.slid, end)
        found.append(move)
    return [move for move in found if abs(move.fixed) > NOTHING or move.slid]


def _less(one: _Move, other: _Move, end: str) -> _Move:
    """A move less another one that turns with it."""
    slid = tuple((joint, -sign) for joint, sign in other.slid)
    return _Move(one.turning, one.fixed - other.fixed, one.slid + slid, end)


def projection(arm: Arm, function: str) -> Iterator[str]:
    """The terms of a projection of a vector, on x with ``cos``, on y with ``sin``."""
    if abs(arm.fixed) > NOTHING:
        letter = "h" if arm.slid else "l"
        yield f" + {letter}_{{{arm.ends}}}*{function}({arm.spin.angle} + alpha_{{{arm.ends}}})"
    for slid in arm.slid:
        yield f" {'+' if slid.sign > 0 else '-'} {coordinate(slid)}*{function}({direction(arm, slid)})"


def coordinate(slid: Slid) -> str:
    """The name of the coordinate of a joint."""
    return f"s_{slid.joint.links[0]}"


def direction(arm: Arm, slid: Slid) -> str:
    """The angle of a joint's line."""
    return arm.spin.angle if abs(slid.delta) < NOTHING else f"{arm.spin.angle} + delta_{slid.joint.links[0]}"


def degrees(vector: complex) -> float:
    """The angle of a vector [deg]."""
    return math.degrees(cmath.phase(vector))


def pin_of(pins: Sequence[Pin], name: str) -> Pin | None:
    """The point of this name, None: the point of a guide."""
    return next((pin for pin in pins if plain_name(pin.name) == name), None)
