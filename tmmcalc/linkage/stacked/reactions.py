"""Largest reactions of many variants over one turn, on panels that resolve them."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tmmcalc.core.numerics.gauss import ORDER, tail
from tmmcalc.core.numerics.roots import Indices
from tmmcalc.core.plane import Real
from tmmcalc.linkage.assembly import TURN
from tmmcalc.linkage.forces import forces
from tmmcalc.linkage.forces.kinks import SLIVER
from tmmcalc.linkage.forces.maxima import functions_of, open_maxima
from tmmcalc.linkage.forces.stack import stacked
from tmmcalc.linkage.stacked.kinks import kinks
from tmmcalc.linkage.stacked.ragged import Cut, Ragged, cut, first, largest_of_owners
from tmmcalc.linkage.stacked.scene import Block
from tmmcalc.linkage.stacked.settle import ROWS
from tmmcalc.linkage.stacked.tables import turning_of
from tmmcalc.linkage.stacked.zeros import Flags


class Reactions(NamedTuple):
    """The functions whose maxima are asked for, of V variants on the points of their panels."""

    panels: Ragged  # of numbers from 0 to V - 1
    values: Real  # (F, P, N)
    couples: dict[int, int]  # joint -> row
    pressures: dict[int, int]
    growth: Real  # (V,) largest growth of errors in the friction
    resolved: Flags  # (V,)


class _Sample(NamedTuple):
    values: Real  # (F, P, N)
    faces: Real  # (F', P, N)
    growth: Real  # (1, P, N)

    def with_cut(self, by: Cut, fresh: _Sample) -> _Sample:
        """The same on panels some of which are cut."""
        return _Sample(*(by.merged(old, new) for old, new in zip(self, fresh, strict=True)))


def reactions_of(block: Block, variants: Indices) -> Reactions:
    """The reactions of some variants (v,) between their positions."""
    scene, rows = block.same.scene, dict[str, dict[int, int]]()
    assert scene is not None
    count = len(variants)
    breaks = np.concatenate((np.tile(scene.angles, (count, 1)), turning_of(block, variants)), axis=1)
    on = first(TURN, np.maximum(breaks, 0.0), TURN / forces.PARTS)
    sample = _sampled(block, variants, on, rows)
    growth, noisy = (largest_of_owners(on, np.max(np.abs(part), axis=-1)) for part in (sample.growth[0], sample.faces))
    rough = _unresolved(on, sample.values)
    for _ in range(forces.ROUNDS):
        if not rough.any():
            break
        which = np.flatnonzero(rough)
        panel, place = kinks(on.at(which), sample.faces[:, which], noisy)
        quarters = on.low[rough, None] + on.width[rough, None] * forces.QUARTERS
        by = cut(
            on,
            np.concatenate((np.repeat(which, len(forces.QUARTERS)), which[panel])),
            np.concatenate((quarters.ravel(), place)),
            SLIVER * TURN,
        )
        if not by.fresh.any():
            break
        fresh = _sampled(block, variants, by.panels.at(by.fresh), rows)
        np.maximum.at(growth, by.panels.owner[by.fresh], np.max(fresh.growth[0], axis=1))
        on, sample = by.panels, sample.with_cut(by, fresh)
        rough = _unresolved(on, sample.values)
    resolved = np.ones(count, bool)
    resolved[on.owner[rough]] = False
    return Reactions(on, sample.values, rows["couples"], rows["pressures"], growth, resolved)


def _sampled(block: Block, variants: Indices, on: Ragged, rows: dict[str, dict[int, int]]) -> _Sample:
    """The functions at the points of panels; which ``rows`` are couples and edge reactions is noted."""
    theta, owner = on.x.ravel(), variants[np.repeat(on.owner, ORDER)]
    parts = []
    for some in (slice(at, at + ROWS) for at in range(0, len(theta), ROWS)):
        statics = block.statics(owner[some])
        over, solutions = stacked(statics, theta[some], np.ones(len(theta[some])), checked=False)
        values, rows["couples"], rows["pressures"] = functions_of(statics, over)
        growth = [solution.amplification for solution in solutions.values()]
        parts.append(
            _Sample(values, over.faces, np.max(growth, axis=0, initial=1.0)[None] if growth else values[:1] * 0 + 1)
        )
    joined = (np.concatenate(column, axis=-1) for column in zip(*parts, strict=True))
    return _Sample(*(part.reshape(-1, *on.x.shape) for part in joined))


def _unresolved(on: Ragged, values: Real) -> Flags:
    """Panels (P,) that may hold the maximum of a function and leave something of it out, as of one variant."""
    high = np.max(np.abs(values), axis=2)
    return open_maxima(high, tail(values), largest_of_owners(on, high)[:, on.owner])
