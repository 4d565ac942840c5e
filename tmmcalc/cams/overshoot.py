"""Where a law of one's own leaves the stroke, and where it goes back on its way: both amounts and angles are exact.

The laws of the catalogue do neither; one through points or of a polynomial may do both.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import degrees
from typing import Any

import numpy as np

from tmmcalc.cams.program import SAME, PhaseKind, Program
from tmmcalc.core.notes import Said, held
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


def overshoot_remarks(program: Program, turns: bool) -> Iterator[Said]:
    """Warnings of a follower that leaves the stroke or turns back, with amount and angle."""

    def beyond(text: str, amount: float, name: str, **angles: float) -> Said:
        """A warning of an amount that should be none."""
        value, unit, mm = (degrees(amount), "deg", "") if turns else (amount, "m", "mm")
        places: dict[str, Any] = {word: degrees(phi) for word, phi in angles.items()}
        return held("warning", text, value, 0.0, unit, shown=mm, name=name, **places)

    (least, low), (largest, high) = program.span
    if largest - program.stroke > LEVEL * program.stroke:
        text = (
            "overshoot: the follower rises {value:.6g} {unit} above the stroke at phi = {phi:.6g} deg; guide and "
            "spring are taken to that"
        )
        yield beyond(text, largest - program.stroke, "overshoot", phi=high)
    if -least > LEVEL * program.stroke:
        text = "undershoot: the follower falls {value:.6g} {unit} below its lowest position at phi = {phi:.6g} deg"
        yield beyond(text, -least, "undershoot", phi=low)
    for part in backward(program):
        text = (
            "the return is not monotone: the follower goes back by {value:.6g} {unit} for phi from {begin:.6g} to "
            "{end:.6g} deg"
        )
        if part.kind == "rise":
            text = (
                "the rise is not monotone: the follower goes back by {value:.6g} {unit} for phi from {begin:.6g} to "
                "{end:.6g} deg"
            )
        yield beyond(text, part.amount, "motion back", begin=part.begin, end=part.end)
