"""Where friction has a kink without a reversal: a slider lifts off one face of its guide and lies on the other.

Friction goes with |N|, of a slider with edges with |N'| + |N''|, so its kinks are the zeros of N, or of N' and N''. No
position tells them beforehand: they are seen on panels, and located by the points on one side of the kink, where
everything is smooth. Only panels with a kink are cut.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.numerics.gauss import rule
from tmmcalc.core.numerics.mesh import Mesh
from tmmcalc.core.numerics.roots import Indices
from tmmcalc.core.plane import Plane, Real
from tmmcalc.linkage.forces.kinetostatics import ForceState, Statics
from tmmcalc.linkage.forces.results import edge_reactions
from tmmcalc.linkage.forces.wrench import Slideway

SIDE = 8  # points of the polynomial that locates a kink
NEWTON = 6
NOISE = 1e-9  # part of its largest value below which the sign of a force says nothing

Flags = NDArray[np.bool_]


def faces(statics: Statics, state: ForceState, shape: tuple[int, ...]) -> Real:
    """The forces (F, n) whose signs rubbing sliders depend on: N, or N' and N'' of a slider of given length.

    ``shape`` is (n,), or (C, n) in cases of load, in place of every (n,).
    """
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
    return np.array([np.broadcast_to(force, shape) for force in found]).reshape(len(found), *shape)


def pins(statics: Statics, state: ForceState, shape: tuple[int, ...]) -> Plane:
    """The reactions (F, n) in rubbing pins, whose friction goes with their size: it has a kink where they pass zero.

    ``shape`` is as of `faces`.
    """
    forces = (state.reactions[joint.name].wrench.force for joint in statics.rubbing if joint.kind == "revolute")
    found = [np.broadcast_to(force, shape) for force in forces]
    return np.array(found).reshape(len(found), *shape)


def kinks(on: Mesh, forces: Real | Plane, largest: Real) -> tuple[Indices, Real]:
    """Panels (m,) and places (m,) inside them where forces (F, P, N) on faces or in pins pass zero.

    ``largest`` are the sizes (F, V) of which a small part is noise. The force in a pin seldom passes zero itself, but
    turns by more than a right angle as it passes by.
    """
    if not len(forces):
        return np.zeros(0, np.intp), np.zeros(0)
    low, high = rule(forces.shape[-1]).ends
    v = np.concatenate(((forces @ low)[..., None], forces, (forces @ high)[..., None]), axis=-1)
    size = np.abs(v)
    loud = np.maximum(size[..., :-1], size[..., 1:]) > NOISE * largest[:, on.owner, None]
    force, panel, cell = np.nonzero(turned(v[..., :-1], v[..., 1:]) & loud)
    step = v[force, panel, cell + 1] - v[force, panel, cell]
    place = _zeros(np.asarray((np.conj(step)[:, None] * forces[force, panel]).real), cell)
    inside = (place > 0) & (place < 1)
    panel, place = panel[inside], place[inside]
    return panel, on.low[panel] + on.width[panel] * place


def turned(before: Real | Plane, after: Real | Plane) -> Flags:
    """Whether a force changes its sign, or turns by more than a right angle."""
    if np.iscomplexobj(before):
        return np.asarray((np.conj(before) * after).real < 0)
    return np.asarray(np.signbit(before) != np.signbit(after))


def _zeros(force: Real, before: Indices) -> Real:
    """Zeros (m,) of forces (m, N) between their points ``before`` - 1 and ``before``, each from its longer side."""
    points, count = rule(force.shape[1]).points, force.shape[1]
    in_second_half = before > count // 2
    start = np.where(in_second_half, before - SIDE, before)
    side = start[:, None] + np.arange(SIDE)
    near = points[np.where(in_second_half, before - 1, before)]
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
