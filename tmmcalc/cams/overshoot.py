"""Where a law of one's own leaves the stroke, and where it goes back on its way: both amounts and angles are exact.

The laws of the catalogue do neither; one through points or of a polynomial may do both.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import degrees

import numpy as np

from tmmcalc.cams.program import SAME, PhaseKind, Program
from tmmcalc.core.records import record

LEVEL = 1e-9  # of the stroke: what counts


@record
class Backward:
    """A part of a phase in which the follower moves against the sense of the phase; angles [rad]."""

    kind: PhaseKind
    begin: float
    end: float
    amount: float  # [m or rad]


def backward(program: Program) -> tuple[Backward, ...]:
    """The parts of rise and return in which the follower turns back, by angle."""
    at, y = program.turned
    order = np.argsort(at, kind="stable")
    order = order[np.concatenate(([True], np.diff(at[order]) > SAME * program.starts[-1]))]
    at, y = at[order], y[order]
    found: list[Backward] = []
    for start, phase in zip(program.starts.tolist(), program.phases, strict=False):
        if not phase.moves:
            continue
        sense = 1.0 if phase.end > phase.start else -1.0
        inside = (at > start) & (at < start + phase.angle)
        places = np.concatenate(([start], at[inside], [start + phase.angle]))
        height = sense * np.concatenate(([phase.start], y[inside], [phase.end]))
        falls = np.concatenate(([False], np.diff(height) < 0, [False]))
        change = np.flatnonzero(falls[1:] != falls[:-1])
        for first, last in zip(change[::2], change[1::2], strict=True):
            amount = float(height[first] - height[last])
            if amount > LEVEL * program.stroke:
                found.append(Backward(phase.kind, float(places[first]), float(places[last]), amount))
    return tuple(found)


def overshoot_remarks(program: Program, turns: bool) -> Iterator[str]:
    """Warnings of a follower that leaves the stroke or turns back, with amount and angle."""

    def shown(amount: float) -> str:
        return f"{degrees(amount):.6g} deg" if turns else f"{1e3 * amount:.6g} mm"

    (least, low), (largest, high) = program.span
    if largest - program.stroke > LEVEL * program.stroke:
        yield (
            f"warning: overshoot: the follower rises {shown(largest - program.stroke)} above the stroke at phi = "
            f"{degrees(high):.6g} deg; guide and spring are taken to that"
        )
    if -least > LEVEL * program.stroke:
        yield (
            f"warning: undershoot: the follower falls {shown(-least)} below its lowest position at phi = "
            f"{degrees(low):.6g} deg"
        )
    for part in backward(program):
        yield (
            f"warning: the {part.kind} is not monotone: the follower goes back by {shown(part.amount)} for phi from "
            f"{degrees(part.begin):.6g} to {degrees(part.end):.6g} deg"
        )
