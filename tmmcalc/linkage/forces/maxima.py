"""The largest reactions and the range of the drive over the whole motion, between the positions too."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmmcalc.linkage.forces.kinetostatics import Statics
from tmmcalc.linkage.forces.results import PairForces
from tmmcalc.linkage.forces.stack import Stack
from tmmcalc.linkage.model import Joint
from tmmcalc.linkage.plane import Real
from tmmcalc.linkage.results import Extreme
from tmmcalc.numerics.panels import Panels, rule

MARGIN = 4.0  # a panel may hold a value higher than its points by that many times what it leaves out
RESOLVED = 1e-8  # last coefficients of a panel, against the largest value, that need no halving
NOISE = 1e-9  # a function below this part of the largest is rounding
TERMS = 7  # of the Taylor polynomial: what is left out is less than 1e-10 between two points
NEWTON = 3

Flags = NDArray[np.bool_]


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


class Held(NamedTuple):
    """The functions whose maxima are asked for, on panels: values (F, K, N), and the rows of couples and edges."""

    values: Real
    couples: dict[int, int]  # joint -> row
    pressures: dict[int, int]


def held(statics: Statics, dense: Panels, over: Stack) -> Held:
    """Drive both ways, forces, couples and edge reactions; ``over`` has one column a point."""
    rows: list[Real] = [-over.drive, over.drive, *np.abs(over.reaction)]
    couples, pressures = {}, {}
    for j, joint in enumerate(statics.joints):
        if joint.kind == "prismatic":
            couples[j] = len(rows)
            rows.append(np.abs(over.couple[j]))
            if length := length_of(statics, joint):
                pressures[j] = len(rows)
                ahead, behind = edge_reactions(over.normal[j], over.couple[j], length)
                rows.append(np.maximum(np.abs(ahead), np.abs(behind)))
    return Held(np.array(rows).reshape(len(rows), *dense.x.shape), couples, pressures)


def unresolved(dense: Panels, values: Real) -> Flags:
    """Panels (K,) that may hold the maximum of a function (F, K, N) and leave something of it out."""
    high, tail = np.max(np.abs(values), axis=2), dense.tail(values)
    top = np.max(high, axis=1)[:, None]
    counts = (high + MARGIN * tail >= top) & (top > NOISE * np.max(top))
    return np.any(counts & (tail > RESOLVED * top), axis=0)


def maxima(statics: Statics, dense: Panels, functions: Held) -> Maxima:
    """The extremes of everything held on panels."""
    joints = range(len(statics.joints))
    found, at = peaks(dense, functions.values)
    extremes = [Extreme(float(value), float(place)) for value, place in zip(found, at, strict=True)]

    def of(rows: dict[int, int]) -> list[Extreme | None]:
        return [extremes[rows[j]] if j in rows else None for j in joints]

    return Maxima(
        force=extremes[2 : 2 + len(joints)],
        couple=of(functions.couples),
        pressure=of(functions.pressures),
        drive=(Extreme(-extremes[0].value, extremes[0].x), extremes[1]),
    )


def peaks(dense: Panels, values: Real) -> tuple[Real, Real]:
    """Largest value of every function (F, K, N) and its place, each (F,); limits at edges included.

    The highest point is refined by the Taylor polynomial there, whose terms the panel gives.
    """
    r, functions = rule(dense.order), np.arange(len(values))
    k, i = np.divmod(np.argmax(values.reshape(len(values), -1), axis=1), dense.order)
    derivatives = [values[functions, k]]
    for _ in range(TERMS):
        derivatives.append(derivatives[-1] @ r.slope.T)
    terms = [row[functions, i] / math.factorial(m) for m, row in enumerate(derivatives)]
    d = np.zeros(len(values))
    for _ in range(NEWTON):
        first = _horner([m * term for m, term in enumerate(terms)][1:], d)
        second = _horner([m * (m - 1) * term for m, term in enumerate(terms)][2:], d)
        move = np.where(second < 0, -first / np.where(second < 0, second, 1.0), 0.0)
        d = np.clip(d + move, -1 / dense.order, 1 / dense.order)
    t = np.clip(r.points[i] + d, 0.0, 1.0)
    low, high = dense.ends(values)
    refined, point = _horner(terms, t - r.points[i]), values[functions, k, i]
    found = np.concatenate((refined[:, None], point[:, None], low, high), axis=1)
    inside = (dense.edges[k] + np.stack((t, r.points[i])) * dense.width[k]).T
    edges = np.broadcast_to(np.concatenate((dense.edges[:-1], dense.edges[1:])), (*low.shape[:1], 2 * dense.count))
    best = np.argmax(found, axis=1)
    return found[functions, best], np.concatenate((inside, edges), axis=1)[functions, best]


def _horner(terms: Sequence[Real], d: Real) -> Real:
    value = terms[-1]
    for term in reversed(terms[:-1]):
        value = value * d + term
    return value


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
