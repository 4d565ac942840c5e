"""Largest reactions of many variants over one turn, on panels that resolve them."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tmmcalc.core.numerics.gauss import ORDER
from tmmcalc.core.numerics.mesh import Flags, Mesh, laid
from tmmcalc.core.numerics.roots import Indices
from tmmcalc.core.plane import Real
from tmmcalc.linkage.assembly import TURN
from tmmcalc.linkage.forces.refinement import PARTS, Sample, resolved, sample_of
from tmmcalc.linkage.forces.stack import stacked
from tmmcalc.linkage.stacked.scene import Block
from tmmcalc.linkage.stacked.survey import ROWS
from tmmcalc.linkage.stacked.tables import turning_of


class Reactions(NamedTuple):
    """The functions whose maxima are asked for, of V variants on the points of their panels."""

    panels: Mesh  # of numbers from 0 to V - 1
    values: Real  # (F, P, N)
    growth: Real  # (V,) largest growth of errors in the friction
    resolved: Flags  # (V,)


def reactions_of(block: Block, variants: Indices) -> Reactions:
    """The reactions of some variants (v,) between their positions."""
    scene = block.same.scene
    assert scene is not None
    growth = np.ones(len(variants))

    def sampled(on: Mesh) -> Sample:
        theta, owner = on.x.ravel(), variants[np.repeat(on.owner, ORDER)]
        parts, grown = [], []
        for some in np.split(np.arange(len(theta)), range(ROWS, len(theta), ROWS)):
            statics = block.statics(owner[some])
            over, solutions = stacked(statics, theta[some], np.ones(len(some)), checked=False)
            parts.append((statics, over))
            grown.append(np.max([np.ones(len(some)), *(found.amplification for found in solutions.values())], axis=0))
        np.maximum.at(growth, on.owner, np.max(np.concatenate(grown).reshape(on.x.shape), axis=1))
        return sample_of(on, *parts)

    breaks = np.concatenate((np.tile(scene.angles, (len(variants), 1)), turning_of(block, variants)), axis=1)
    first = laid(TURN, np.maximum(breaks, 0.0), TURN / PARTS)
    on, values, clear = resolved(first, sampled(first), sampled, TURN)
    return Reactions(on, values, growth, clear)
