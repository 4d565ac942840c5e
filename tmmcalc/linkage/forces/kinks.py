"""Where friction has a kink without a reversal: a slider lifts off one face of its guide and lies on the other.

Friction goes with |N|, of a slider with edges with |N'| + |N''|, so its kinks are the zeros of N, or of N' and N''. No
position tells them beforehand: they are seen on panels, first roughly by interpolation across the kink, and then,
with an edge put there, by the polynomial of the side that the kink is not on.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import NamedTuple

import numpy as np

from tmmcalc.linkage.forces.kinetostatics import State, Statics
from tmmcalc.linkage.forces.wrench import Slideway
from tmmcalc.linkage.plane import Real
from tmmcalc.numerics.panels import Panels, rule

NOISE = 1e-9  # part of its largest value below which the sign of a force says nothing


class Kink(NamedTuple):
    """A zero of one of the forces on faces, and its number."""

    force: int
    theta: float


def faces(statics: Statics, state: State, n: int) -> Real:
    """The forces (F, n) whose signs rubbing sliders depend on: N, or N' and N'' of a slider of given length."""
    found = []
    for joint in statics.rubbing:
        reaction, pair = state.reactions[joint.name], statics.pairs[joint.name]
        if not isinstance(reaction.seat, Slideway):
            continue
        normal = (np.conj(1j * reaction.seat.e) * reaction.wrench.force).real
        if not pair.length:
            found.append(normal)
            continue
        edge = 2 * reaction.wrench.moment / pair.length
        found += [normal + edge, normal - edge]
    return np.array([np.broadcast_to(force, n) for force in found]).reshape(len(found), n)


def kinked(
    first: Panels, values: Real, sample: Callable[[Panels], Real], build: Callable[[Iterable[float]], Panels]
) -> list[float]:
    """Places of all kinks; ``values`` (F, n) are the forces on faces at the points of ``first``.

    ``sample`` gives them on other panels, ``build`` makes panels with further edges.
    """
    rough = _rough(first, values)
    if not rough:
        return []
    finer = build(kink.theta for kink in rough)
    values = sample(finer).reshape(len(values), *finer.x.shape)
    return [_settled(finer, values[kink.force], kink.theta) for kink in rough]


def _rough(on: Panels, values: Real) -> list[Kink]:
    """Sign changes within a panel, interpolated."""
    found: list[Kink] = []
    x = np.concatenate((on.edges[:-1, None], on.x, on.edges[1:, None]), axis=1)
    for k, force in enumerate(values):
        inside = force.reshape(on.x.shape)
        low, high = on.ends(inside)
        v = np.concatenate((low[:, None], inside, high[:, None]), axis=1)
        a, b = v[:, :-1], v[:, 1:]
        loud = np.maximum(np.abs(a), np.abs(b)) > NOISE * np.max(np.abs(inside))
        rows, cells = np.nonzero((np.signbit(a) != np.signbit(b)) & loud)
        for row, cell in zip(rows, cells, strict=True):
            at, step = x[row, cell], x[row, cell + 1] - x[row, cell]
            found.append(Kink(k, float(at + step * a[row, cell] / (a[row, cell] - b[row, cell]))))
    return found


def _settled(on: Panels, force: Real, theta: float) -> float:
    """The zero near the edge at theta, by the polynomial of the panel beside it that keeps its sign."""
    m = int(np.argmin(np.abs(on.edges[1:-1] - theta))) + 1
    for k, end in ((m - 1, 1), (m, 0)):
        inside = force[k]
        if np.all(np.signbit(inside) == np.signbit(inside[0])):
            r, width = rule(on.order), on.width[k]
            slopes = inside @ r.slope.T / width
            bends = slopes @ r.slope.T / width
            v, first, second = (float(r.ends[end] @ row) for row in (inside, slopes, bends))
            move = -v / (first - second * v / first / 2) if first else 0.0
            if abs(move) < width / 2:
                return float(on.edges[m]) + move
    return theta
