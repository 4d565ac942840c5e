"""Derivatives of the largest reactions, couples and edge reactions, and of the range of the drive."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from tmmcalc.core.derivatives import Derivative
from tmmcalc.core.plane import Real
from tmmcalc.core.records import record
from tmmcalc.linkage.assembly import TURN
from tmmcalc.linkage.derivatives.along import Along
from tmmcalc.linkage.derivatives.equilibrium import Equilibrium
from tmmcalc.linkage.derivatives.loads import edge_moves
from tmmcalc.linkage.forces.results import Forces, edge_reactions
from tmmcalc.linkage.forces.stack import stacked
from tmmcalc.linkage.loads.travel import EDGE
from tmmcalc.linkage.results import Extreme

LEVEL = 1e-5  # of the largest value for a radian or the reach: a slope below is that of the top of a smooth force
FORCES = ("force", "pressure")
SAME = 1e-9  # of the largest value: a side with this value is the one on which an extreme stands


@record
class ForceExtremes:
    """Derivatives (K,) of the largest ``force``, ``couple``, ``pressure`` of an edge by joint, and of ranges.

    ``drive`` and ``power`` are those of the least and the largest. None: not given exactly.
    """

    force: dict[str, Derivative | None]
    couple: dict[str, Derivative | None]
    pressure: dict[str, Derivative | None]
    drive: tuple[Derivative | None, Derivative | None]
    power: tuple[Derivative | None, Derivative | None]


class _Sought(NamedTuple):
    """One extreme: where it stands, how to read its value and changes, of which kind it is."""

    extreme: Extreme
    joint: int  # -1: the drive
    kind: str  # force, couple, pressure, drive


def extremes_of(along: Along, result: Forces) -> ForceExtremes:
    """All extremes of a result; the last direction of ``along`` is that of the input alone."""
    sought = [_Sought(each, -1, "drive") for each in result.drive_extremes]
    for j, pair in enumerate(result.pairs):
        own = (("force", pair.force), ("couple", pair.couple), ("pressure", pair.pressure))
        sought += [_Sought(extreme, j, kind) for kind, extreme in own if extreme is not None]
    low, high, *others = _followed(along, result, sought)

    def of(kind: str) -> dict[str, Derivative | None]:
        pairs = zip(sought[2:], others, strict=True)
        return {result.pairs[each.joint].joint: own for each, own in pairs if each.kind == kind}

    power = _powers(along, result, [low, high])
    return ForceExtremes(of("force"), of("couple"), of("pressure"), (low, high), power)


def _powers(
    along: Along, result: Forces, drive: list[Derivative | None]
) -> tuple[Derivative | None, Derivative | None]:
    """Of the least and the largest power, which stand where the drive is least and largest, or the other way round."""
    speed, dspeed = result.speed, along.directions.changes.input.speed[:-1, 0]
    found = [
        each and Derivative(each.value * speed + extreme.value * dspeed, each.error * abs(speed))
        for each, extreme in zip(drive, result.drive_extremes, strict=True)
    ]
    low, high = found if speed > 0 else found[::-1]
    return low, high


def _followed(along: Along, result: Forces, sought: list[_Sought]) -> list[Derivative | None]:
    """Of every extreme its derivatives, from the side on which it stands."""
    theta = np.tile([each.extreme.x for each in sought], 2)
    n = len(sought)
    side = np.repeat([1.0, -1.0], n)
    stack, _ = stacked(along.statics, theta, side, checked=False)
    dx = np.tile(along.begin[:, None], 2 * n)
    dx[-1] = 1.0
    made = along.equilibrium(theta, side, stack, dx, result.error)
    found: list[Derivative | None] = []
    for k, each in enumerate(sought):
        sides = [_read(made, result, each, at) for at in (k, k + n)]
        own = [change for value, change in sides if abs(value - each.extreme.value) <= SAME * _largest(result, each)]
        found.append(_at_its_place(along, made, result, each, own[0]) if own else None)
    return found


def _at_its_place(along: Along, made: Equilibrium, result: Forces, each: _Sought, change: Real) -> Derivative | None:
    """From changes (K + 1,) at a fixed angle along the motion, the last along it; None where it stands elsewhere."""
    slope, own = float(change[-1]), change[:-1]
    error = made.errors[0 if each.kind in FORCES or (each.joint < 0 and not result.turns) else 1][:-1]
    if abs(slope) * (1.0 if result.turns else made.reach) <= LEVEL * _largest(result, each):
        return Derivative(own, error + abs(slope) * made.gross[:-1])
    moves = _moves(along, made, each.extreme.x)
    if moves is None:
        return None
    return Derivative(own + slope * (moves - along.begin)[:-1], error + abs(slope) * along.placed.error[:-1])


def _moves(along: Along, made: Equilibrium, theta: float) -> Real | None:
    """Change (K,) of the input coordinate of a place that is the beginning, the end, a dead centre or a load's edge."""
    travel = along.statics.scene.travel
    if theta <= EDGE or theta >= travel.period - EDGE:
        return along.begin
    for turns, summary in zip(along.placed.turns, along.directions.kinematics.summaries, strict=True):
        for k, centre in enumerate(summary.dead_centres):
            apart = float(travel.theta(np.array(centre.x))) - theta
            if abs(math.remainder(apart, TURN) if along.directions.chain.turns else apart) <= EDGE:
                return np.asarray(turns.x[:, k])
    edge = edge_moves(made.given, theta)
    return None if edge is None else along.begin + travel.sense * edge


def _largest(result: Forces, each: _Sought) -> float:
    """What values of its kind are held against."""
    if each.joint < 0:
        return max(abs(extreme.value) for extreme in result.drive_extremes) or 1.0
    return abs(each.extreme.value) or 1.0


def _read(made: Equilibrium, result: Forces, each: _Sought, at: int) -> tuple[float, Real]:
    """The value of what is sought at a place by its number, and its change (K,)."""
    j, changes, rows = each.joint, made.changes, made.rows
    if each.kind == "drive":
        return float(rows.drive[at]), changes[-1][:, at]
    if each.kind == "couple":
        couple = float(rows.couple[j, at])
        # the couple about a pin is its friction, of which no extreme is told
        return abs(couple), math.copysign(1.0, couple) * changes[2 * j + 1][:, at]
    if each.kind == "force":
        force = complex(rows.reaction[j, at])
        whole = made.reaction(j)[:, at]
        return abs(force), np.asarray((np.conj(force) * whole).real / (abs(force) or 1.0))
    length = result.pairs[j].length or math.inf
    couple, dlength = float(rows.couple[j, at]), made.length_change(j)
    ahead, behind = (float(edge) for edge in edge_reactions(rows.normal[j, at], rows.couple[j, at], length))
    sign, edge = (1.0, ahead) if abs(ahead) >= abs(behind) else (-1.0, behind)
    arm = changes[2 * j + 1][:, at] / length - couple * dlength / length**2
    return abs(edge), math.copysign(1.0, edge) * (changes[2 * j][:, at] / 2 + sign * arm)
