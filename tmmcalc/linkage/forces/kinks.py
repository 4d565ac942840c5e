"""Where friction has a kink without a reversal: a slider lifts off one face of its guide and lies on the other.

Friction goes with |N|, of a slider with edges with |N'| + |N''|, so its kinks are the zeros of N, or of N' and N''. No
position tells them beforehand: they are seen on panels, and located by the points on one side of the kink, where
everything is smooth. Only panels with a kink are cut.
"""

from __future__ import annotations

from collections.abc import Iterable
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.numerics.gauss import rule
from tmmcalc.core.numerics.panels import Panels
from tmmcalc.core.numerics.roots import Indices
from tmmcalc.core.plane import Plane, Real
from tmmcalc.linkage.forces.edges import edge_reactions
from tmmcalc.linkage.forces.kinetostatics import State, Statics
from tmmcalc.linkage.forces.wrench import Slideway

SIDE = 8  # points of the polynomial that locates a kink
NEWTON = 6
SLIVER = 1e-6  # part of the range: a kink so near to an edge does not show, and may be what it was put for
SAME = 1e-9  # part of the range: an edge so near to a kink stands at it
NOISE = 1e-9  # part of its largest value below which the sign of a force says nothing

Flags = NDArray[np.bool_]


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
        found += edge_reactions(normal, reaction.wrench.moment, pair.length)
    return np.array([np.broadcast_to(force, n) for force in found]).reshape(len(found), n)


def pins(statics: Statics, state: State, n: int) -> Plane:
    """The reactions (F, n) in rubbing pins, whose friction goes with their size: it has a kink where they pass zero."""
    forces = (state.reactions[joint.name].wrench.force for joint in statics.rubbing if joint.kind == "revolute")
    found = [np.broadcast_to(force, n) for force in forces]
    return np.array(found).reshape(len(found), n)


class Cut(NamedTuple):
    """Panels with further edges: ``fresh`` (K,) tells the new ones, ``kept`` (K_0,) the old ones that are left."""

    panels: Panels
    fresh: Flags
    kept: Flags

    @property
    def theta(self) -> Real:
        """Points (m,) of the fresh panels."""
        return self.panels.x[self.fresh].ravel()

    def merged(self, old: Any, new: Any) -> Any:
        """Values (..., n) at the points of all panels, from those at the old ones and at the fresh ones."""
        points = np.repeat(self.fresh, self.panels.order)
        result = np.empty((*old.shape[:-1], len(points)), old.dtype)
        result[..., points] = new
        result[..., ~points] = old[..., np.repeat(self.kept, self.panels.order)]
        return result


def cut(panels: Panels, places: list[float], fixed: Iterable[float] | None = None) -> Cut:
    """The panels with an edge at every place, but for places at an edge or at another place.

    Edges that are not ``fixed`` (None: all are) move to a place that is near to them: most were put for it, by a guess.
    What is near to a place of the same pass is another kink, and gets its own edge.
    """
    old, span = panels.edges, float(panels.edges[-1] - panels.edges[0])
    edges = old.tolist()
    held = set(edges) if fixed is None else {edges[0], edges[-1], *fixed}
    taken = set[float]()
    for place in sorted(places):
        k = int(np.searchsorted(edges, place))
        near = k if edges[k] - place < place - edges[k - 1] else k - 1
        gap = abs(edges[near] - place)
        apart = SAME if edges[near] in taken else SLIVER
        if gap > apart * span:
            edges.insert(k, place)
        elif gap > SAME * span and edges[near] not in held:
            edges[near] = place
        else:
            place = edges[near]
        taken.add(place)
    finer = Panels(np.array(edges), panels.order)
    before, after = (list(pairwise(each)) for each in (old.tolist(), edges))
    known, left = set(before), set(after)
    return Cut(finer, np.array([p not in known for p in after]), np.array([p in left for p in before]))


def kinks(on: Panels, values: Real | Plane, where: Flags | bool = True) -> list[float]:
    """Places of the kinks in the panels of ``where`` (K,), by default in all.

    ``values`` (F, n) are the forces on faces, or in pins, at the points of the panels.
    """
    if not len(values):
        return []
    forces = values.reshape(-1, *on.x.shape)
    looked = np.flatnonzero(np.broadcast_to(where, on.count))
    panel, place = passing(forces[:, looked], np.max(np.abs(forces), axis=(1, 2))[:, None])
    panel = looked[panel]
    found: list[float] = (on.edges[panel] + on.width[panel] * place).tolist()
    return found


def passing(forces: Real | Plane, largest: Real) -> tuple[Indices, Real]:
    """Panels (m,) and places (m,) in them, between 0 and 1, where forces (F, K, N) at Gauss points pass zero.

    ``largest`` are the sizes (F, 1) or (F, K) of which a small part is noise. The force in a pin seldom passes zero
    itself, but turns by more than a right angle as it passes by.
    """
    low, high = rule(forces.shape[-1]).ends
    v = np.concatenate(((forces @ low)[..., None], forces, (forces @ high)[..., None]), axis=-1)
    size = np.abs(v)
    loud = np.maximum(size[..., :-1], size[..., 1:]) > NOISE * largest[..., None]
    force, panel, cell = np.nonzero(turned(v[..., :-1], v[..., 1:]) & loud)
    step = v[force, panel, cell + 1] - v[force, panel, cell]
    place = _zeros(np.asarray((np.conj(step)[:, None] * forces[force, panel]).real), cell)
    inside = (place > 0) & (place < 1)
    return panel[inside], place[inside]


def turned(before: Real | Plane, after: Real | Plane) -> Flags:
    """Whether a force changes its sign, or turns by more than a right angle."""
    if np.iscomplexobj(before):
        return np.asarray((np.conj(before) * after).real < 0)
    return np.asarray(np.signbit(before) != np.signbit(after))


def _zeros(force: Real, before: Indices) -> Real:
    """Zeros (m,) of forces (m, N) between their points ``before`` - 1 and ``before``, each from its longer side."""
    points, count = rule(force.shape[1]).points, force.shape[1]
    late = before > count // 2
    start = np.where(late, before - SIDE, before)
    side = start[:, None] + np.arange(SIDE)
    near = points[np.where(late, before - 1, before)]
    powers = (points[side] - near[:, None])[:, :, None] ** np.arange(SIDE - 1, -1, -1)
    fit = np.linalg.solve(powers, np.take_along_axis(force, side, axis=1)[:, :, None])[:, :, 0]
    at = np.zeros(len(force))
    for _ in range(NEWTON):
        value, slope = np.zeros(len(force)), np.zeros(len(force))
        for c in fit.T:
            slope = slope * at + value
            value = value * at + c
        at = at - value / np.where(slope == 0, 1.0, slope)
    inner = (before > 0) & (before < count)
    bounds = points[np.maximum(before - 1, 0)], points[np.minimum(before, count - 1)]
    return np.where(inner, np.clip(near + at, *bounds), near + at)
