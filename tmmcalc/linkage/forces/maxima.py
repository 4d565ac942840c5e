"""The largest reactions and the range of the drive over the whole motion, between the positions too."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from tmmcalc.core.numerics.panels import Panels
from tmmcalc.core.numerics.peaks import peaks
from tmmcalc.core.plane import Real
from tmmcalc.linkage.forces.kinetostatics import Statics
from tmmcalc.linkage.forces.results import PairForces, edge_reactions
from tmmcalc.linkage.forces.stack import Stack, stacked
from tmmcalc.linkage.loads.travel import EDGE
from tmmcalc.linkage.model import Joint
from tmmcalc.linkage.results import Extreme

DRIVE = 1  # row of the drive; the one before it is the drive turned round


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


class ForceFunctions(NamedTuple):
    """The functions whose maxima are asked for, on panels: values (F, K, N), and the rows of couples and edges."""

    values: Real
    couples: dict[int, int]  # joint -> row
    pressures: dict[int, int]

    @property
    def drive(self) -> Real:
        """The drive along the positive input coordinate (K, N)."""
        return np.asarray(self.values[DRIVE])


def functions_of(statics: Statics, over: Stack) -> Real:
    """The functions (F, n) whose maxima are asked for: drive both ways, forces, couples and edge reactions."""
    rows: list[Real] = [-over.drive, over.drive, *np.abs(over.reaction)]
    for j, joint in enumerate(statics.joints):
        if joint.kind == "prismatic":
            rows.append(np.abs(over.couple[j]))
            if length := length_of(statics, joint):
                ahead, behind = edge_reactions(over.normal[j], over.couple[j], length)
                rows.append(np.maximum(np.abs(ahead), np.abs(behind)))
    return np.array(rows)


def force_functions(statics: Statics, values: Real) -> ForceFunctions:
    """These functions (F, K, N) on panels, with the numbers of their rows."""
    couples, pressures, row = {}, {}, 2 + len(statics.joints)
    for j, joint in enumerate(statics.joints):
        if joint.kind == "prismatic":
            couples[j], row = row, row + 1
            if length_of(statics, joint):
                pressures[j], row = row, row + 1
    return ForceFunctions(values, couples, pressures)


def maxima(statics: Statics, dense: Panels, functions: ForceFunctions, resolved: bool = True) -> Maxima:
    """The extremes of everything held on panels; from panels that are not ``resolved``, as the statics gives them."""
    joints = range(len(statics.joints))
    found, at = peaks(dense, functions.values)
    if not resolved:
        found, at = _confirmed(statics, dense, functions, at)
    extremes = [Extreme(float(value), float(place)) for value, place in zip(found, at, strict=True)]

    def of(rows: dict[int, int]) -> list[Extreme | None]:
        return [extremes[rows[j]] if j in rows else None for j in joints]

    return Maxima(
        force=extremes[2 : 2 + len(joints)],
        couple=of(functions.couples),
        pressure=of(functions.pressures),
        drive=(Extreme(-extremes[0].value, extremes[0].x), extremes[1]),
    )


def _confirmed(statics: Statics, dense: Panels, functions: ForceFunctions, at: Real) -> tuple[Real, Real]:
    """The higher of what the statics gives at the places (F,) found, from either side, and at the points; its place.

    The polynomial of a panel swings beyond a force that has a pole beside the path.
    """
    each = np.arange(len(at))
    after = np.where(at < statics.scene.travel.period - EDGE, 1.0, -1.0)
    before = np.where(at > EDGE, -1.0, 1.0)
    exact, _ = stacked(statics, np.tile(at, 2), np.concatenate((after, before)), checked=False)
    sides = functions_of(statics, exact)[each, [each, each + len(at)]]
    points = functions.values.reshape(len(at), -1)
    best = np.argmax(points, axis=1)
    values = np.vstack((np.max(sides, axis=0), points[each, best]))
    places = np.vstack((at, dense.x.ravel()[best]))
    higher = np.argmax(values, axis=0)
    return values[higher, each], places[higher, each]


def length_of(statics: Statics, joint: Joint) -> float | None:
    """Length of the slider of a joint, if it is given."""
    pair = statics.pairs.get(joint.name)
    return pair.length if pair is not None else None


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
