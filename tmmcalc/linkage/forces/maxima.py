"""The largest reactions and the range of the drive over the whole motion, between the positions too."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from tmmcalc.linkage.forces.kinetostatics import Statics
from tmmcalc.linkage.forces.results import PairForces
from tmmcalc.linkage.forces.stack import Stack
from tmmcalc.linkage.model import Joint
from tmmcalc.linkage.plane import Real
from tmmcalc.linkage.results import Extreme
from tmmcalc.numerics.panels import Panels


class Maxima(NamedTuple):
    """Largest force, couple and edge reaction of every pair (None where it has none), range of the drive."""

    force: list[Extreme]
    couple: list[Extreme | None]
    pressure: list[Extreme | None]
    drive: tuple[Extreme, Extreme]

    def power(self, speed: float) -> tuple[Extreme, Extreme]:
        """Least and largest power of the drive."""
        low, high = (Extreme(extreme.value * speed, extreme.x) for extreme in self.drive)
        return (low, high) if speed > 0 else (high, low)


def maxima(statics: Statics, dense: Panels, over: Stack) -> Maxima:
    """The extremes of everything held on panels: ``over`` has one column a point."""
    joints = statics.joints
    rows: list[Real] = [-over.drive, over.drive, *np.abs(over.reaction)]
    couples, pressures = {}, {}
    for j, joint in enumerate(joints):
        if joint.kind == "prismatic":
            couples[j] = len(rows)
            rows.append(np.abs(over.couple[j]))
            if length := length_of(statics, joint):
                pressures[j] = len(rows)
                ahead, behind = edge_reactions(over.normal[j], over.couple[j], length)
                rows.append(np.maximum(np.abs(ahead), np.abs(behind)))
    found, at = dense.largest(np.array(rows).reshape(len(rows), *dense.x.shape))
    extremes = [Extreme(float(value), float(place)) for value, place in zip(found, at, strict=True)]
    return Maxima(
        force=extremes[2 : 2 + len(joints)],
        couple=[extremes[couples[j]] if j in couples else None for j in range(len(joints))],
        pressure=[extremes[pressures[j]] if j in pressures else None for j in range(len(joints))],
        drive=(Extreme(-extremes[0].value, extremes[0].x), extremes[1]),
    )


def length_of(statics: Statics, joint: Joint) -> float | None:
    """Length of the slider of a joint, if it is given."""
    pair = statics.pairs.get(joint.name)
    return pair.length if pair is not None else None


def edge_reactions(normal: Real, couple: Real, length: float) -> tuple[Real, Real]:
    """Forces N', N'' at the two edges of a slider of this length, ahead of and behind its point, along the normal.

    They are the parallel forces that N and the couple stand for: N' + N'' = N, (N' - N'') length/2 = couple.
    """
    return normal / 2 + couple / length, normal / 2 - couple / length


def pairs_of(statics: Statics, found: Maxima, rows: Stack, labels: tuple[str, ...]) -> Iterator[PairForces]:
    """The records of all pairs."""
    for j, joint in enumerate(statics.joints):
        pair, length = statics.pairs.get(joint.name), length_of(statics, joint)
        low, high = sorted(joint.links)
        prismatic = joint.kind == "prismatic"
        yield PairForces(
            joint=joint.name,
            kind=joint.kind,
            links=(low, high),
            friction=pair.friction if pair is not None else 0.0,
            radius=pair.radius if pair is not None else 0.0,
            length=length,
            force=found.force[j],
            couple=found.couple[j],
            pressure=found.pressure[j],
            tips=tuple(labels[i] for i in _tips(rows, j, length)) if prismatic and length else (),
        )


def _tips(rows: Stack, j: int, length: float) -> list[int]:
    """Rows where the resultant falls outside the slider: it bears on two opposite edges."""
    return np.flatnonzero(np.abs(rows.couple[j]) > np.abs(rows.normal[j]) * length / 2).tolist()
