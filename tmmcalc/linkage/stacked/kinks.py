"""Kinks of friction on the panels of many variants: zeros of the forces on the faces of sliders."""

from __future__ import annotations

import numpy as np

from tmmcalc.linkage.forces.kinks import NEWTON, NOISE, SIDE, turned
from tmmcalc.linkage.plane import Plane, Real
from tmmcalc.linkage.stacked.ragged import Ragged
from tmmcalc.numerics.gauss import ORDER, rule
from tmmcalc.numerics.roots import Indices


def kinks(on: Ragged, forces: Real | Plane, largest: Real) -> tuple[Indices, Real]:
    """Panels (m,) and places (m,) of the kinks of forces (F, P, N) on faces or in pins.

    ``largest`` are the sizes (F, V) of which a small part is noise.
    """
    if not len(forces):
        return np.zeros(0, np.intp), np.zeros(0)
    low, high = rule(ORDER).ends
    v = np.concatenate(((forces @ low)[..., None], forces, (forces @ high)[..., None]), axis=-1)
    size = np.abs(v)
    loud = np.maximum(size[..., :-1], size[..., 1:]) > NOISE * largest[:, on.owner, None]
    force, panel, cell = np.nonzero(turned(v[..., :-1], v[..., 1:]) & loud)
    step = v[force, panel, cell + 1] - v[force, panel, cell]
    place = _zeros(np.asarray((np.conj(step)[:, None] * forces[force, panel]).real), cell)
    inside = (place > 0) & (place < 1)
    panel, place = panel[inside], place[inside]
    return panel, on.low[panel] + on.width[panel] * place


def _zeros(force: Real, before: Indices) -> Real:
    """Zeros (m,) of forces (m, N) between their points ``before`` - 1 and ``before``, each from its longer side."""
    points = rule(ORDER).points
    late = before > ORDER // 2
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
    inner = (before > 0) & (before < ORDER)
    bounds = points[np.maximum(before - 1, 0)], points[np.minimum(before, ORDER - 1)]
    return np.where(inner, np.clip(near + at, *bounds), near + at)
