"""Reactions between the positions: panels that resolve the maxima which they may hold, of one or of several variants.

Only panels that may hold the maximum of a function are cut, in quarters and at kinks of friction.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from tmmcalc.core.numerics.gauss import tail
from tmmcalc.core.numerics.mesh import Flags, Mesh
from tmmcalc.core.plane import Real
from tmmcalc.linkage.forces.kinetostatics import Statics
from tmmcalc.linkage.forces.kinks import kinks
from tmmcalc.linkage.forces.maxima import functions_of
from tmmcalc.linkage.forces.stack import Stack

PARTS = 16  # of a turn, or of the range: no first panel is wider
QUARTERS = np.array([0.25, 0.5, 0.75])
ROUNDS = 8  # of cutting: a pole of the force a millionth of a turn beside the path is resolved
MARGIN = 4.0  # a panel may hold a value higher than its points by that many times what it leaves out
RESOLVED = 1e-8  # last coefficients of a panel, against the largest value, that need no cutting
NOISE = 1e-9  # a function below this part of the largest is rounding


class Sample(NamedTuple):
    """At the points of panels: the functions whose maxima are asked for, and the forces on the faces of sliders."""

    values: Real  # (F, P, N)
    faces: Real  # (F', P, N)


def sample_of(on: Mesh, *parts: tuple[Statics, Stack]) -> Sample:
    """The sample from the reactions at the points of the panels, in parts one behind the other."""
    values = np.concatenate([functions_of(statics, over) for statics, over in parts], axis=-1)
    faces = np.concatenate([over.faces for _, over in parts], axis=-1)
    return Sample(values.reshape(len(values), *on.x.shape), faces.reshape(len(faces), *on.x.shape))


def resolved(on: Mesh, sample: Sample, sampled: Callable[[Mesh], Sample], period: float) -> tuple[Mesh, Real, Flags]:
    """Panels cut from the first ones ``on``, the functions (F, P, N) on them, and the variants (V,) they resolve.

    ``sample`` is that on the first panels; ``sampled`` gives it on further ones.
    """
    noisy = on.largest(np.max(np.abs(sample.faces), axis=-1))
    for _ in range(ROUNDS):
        rough = np.flatnonzero(_rough(on, sample.values))
        unresolved = on.owner[rough]
        if not rough.size:
            break
        panel, place = kinks(on.at(rough), sample.faces[:, rough], noisy)
        quarters = on.low[rough, None] + on.width[rough, None] * QUARTERS
        by = on.cut(
            np.concatenate((np.repeat(rough, len(QUARTERS)), rough[panel])),
            np.concatenate((quarters.ravel(), place)),
            period,
        )
        if not by.fresh.any():
            break
        fresh = sampled(by.new)
        on, sample = by.mesh, Sample(*(by.merged(*parts) for parts in zip(sample, fresh, strict=True)))
    clear = np.ones(on.owner[-1] + 1, bool)
    clear[unresolved] = False
    return on, sample.values, clear


def _rough(on: Mesh, values: Real) -> Flags:
    """Panels (P,) that may hold the maximum of a function (F, P, N) and leave something of it out."""
    high, left_out = np.max(np.abs(values), axis=2), tail(values)
    top = on.largest(high)[:, on.owner]
    counts = (high + MARGIN * left_out >= top) & (top > NOISE * np.max(top, axis=0))
    return np.asarray(np.any(counts & (left_out > RESOLVED * top), axis=0))
