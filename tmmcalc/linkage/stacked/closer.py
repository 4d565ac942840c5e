"""A closer look at variants that come near to a limit position: whether they pass it, and how swiftly their links turn.

The margins of their dyads are sampled as densely as those of one variant by itself, and every minimum that may lie
below zero between two samples is refined, as there (`assembly.find_domain`). So a variant whose least margin is above
zero by more than rounding turns on its assembly, and one of which a margin is below zero by more than rounding does
not.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from tmmcalc.core.numerics.alike import Rows
from tmmcalc.core.numerics.extrema import around, maxima, refine
from tmmcalc.core.numerics.roots import Indices
from tmmcalc.core.plane import Real, square
from tmmcalc.linkage.assembly import NEAR, SAMPLES
from tmmcalc.linkage.chain import Chain, Configuration
from tmmcalc.linkage.stacked.zeros import Flags

LEAST = (
    1e-4  # squared sine of a dyad that passes its limit position with most digits left: second rates lose one over it
)
PLACED = 1e-8  # the same where places alone are asked for, which lose one over its root
BELOW = 1e-9  # the same of one that does not assemble beyond doubt, with the other sign
REACH = 1e-3  # the least distance of the pivots of an RPR dyad against their largest
X = np.linspace(-math.pi, math.pi, SAMPLES + 1)


class Closer(NamedTuple):
    """What is seen of V variants."""

    passes: Flags  # (V,) whose dyads assemble and transmit all over the turn, with digits left
    fails: Flags  # (V,) of which a dyad does not assemble somewhere in the turn, beyond doubt
    turns: Real  # (V,) the largest angle by which a link turns between two samples [rad]
    before: Real  # (V,) the same of the links from which further dyads go on


def closer(chain: Rows[Chain], variants: Indices, placed: bool) -> Closer:
    """Look at some variants (V,) of which the survey leaves doubt; ``placed``: places of points alone are asked for."""
    own = chain(np.repeat(variants, len(X)))
    configuration = own.evaluate(np.tile(X, len(variants)), order=0)
    shape = len(variants), len(X)
    passes, fails = np.ones(len(variants), bool), np.zeros(len(variants), bool)
    turns, before = np.zeros(len(variants)), np.zeros(len(variants))
    for k, step in enumerate(own.steps):
        before = turns
        least = _least(chain, variants, k, _margins(own, k, configuration, shape))
        with np.errstate(invalid="ignore"):  # of those whose dyads before have no place
            fails |= passes & (least < -BELOW)
            passes &= least > (PLACED if placed else LEAST)
            if step.group.kind == "RPR":
                first, second = configuration.ports[k]
                apart = np.broadcast_to(square(first.r - second.r), math.prod(shape)).reshape(shape)
                passes &= np.min(apart, axis=1) > REACH * np.max(apart, axis=1)
            for link in step.group.links:
                turns = np.maximum(turns, _turned(configuration, link, shape))
    return Closer(passes, fails, turns, before)


def _margins(chain: Chain, k: int, configuration: Configuration, shape: tuple[int, int]) -> Real:
    """Margins (V, m) of dyad k; the last sample is the first, whatever the rounding."""
    margins = np.broadcast_to(chain.dyad(k).dyad.margin(*configuration.ports[k]), math.prod(shape)).reshape(shape)
    return np.concatenate((margins[:, :-1], margins[:, :1]), axis=1)


def _least(chain: Rows[Chain], variants: Indices, k: int, margins: Real) -> Real:
    """The least margins (V,) of dyad k over the turn, from samples (V, m); NaN where it has no place somewhere."""
    steps = np.abs(np.diff(margins, axis=1))
    with np.errstate(invalid="ignore"):
        moves = np.maximum(steps, np.roll(steps, 1, axis=1))
        inner = margins[:, :-1]
        row, at = np.nonzero(maxima(-inner, True) & (inner >= 0) & (inner < np.maximum(NEAR, moves)))
    least = np.min(margins, axis=1)
    _, lowest = refine(
        lambda x, which: chain(variants[row[which]]).margins(x, k), *around(X, at, True, np.zeros_like(at))
    )
    np.minimum.at(least, row, lowest)
    return least


def _turned(configuration: Configuration, link: int, shape: tuple[int, int]) -> Real:
    """The largest angle (V,) by which a link turns between two samples [rad]."""
    u = np.broadcast_to(configuration.motions[link].u, math.prod(shape)).reshape(shape)
    return np.asarray(np.max(np.abs(np.angle(u[:, 1:] * np.conj(u[:, :-1]))), axis=1))
