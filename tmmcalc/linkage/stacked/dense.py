"""The survey of the turn from position 0 on, of many variants: what their extremes are refined from.

It has the places of the survey of one variant, so that the extremes of both are sought between the same places.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tmmcalc.core.numerics.roots import Indices
from tmmcalc.core.plane import Real
from tmmcalc.linkage.assembly import TURN
from tmmcalc.linkage.chain import Chain, Configuration
from tmmcalc.linkage.model import Output
from tmmcalc.linkage.outputs import coordinate_of, default_outputs
from tmmcalc.linkage.quality import Measure, kinds_of
from tmmcalc.linkage.stacked.scene import Block
from tmmcalc.linkage.stacked.survey import ROWS
from tmmcalc.linkage.survey import STEPS, Quantity
from tmmcalc.linkage.trace import principal, unwrapped


class Dense(NamedTuple):
    """Samples of V variants at m places."""

    variants: Indices  # (V,) their numbers in the block
    x: Real  # (V, m) ascending, a turn from position 0 less half a step
    start: Real  # (V,) position 0
    measures: tuple[Measure, ...]  # (M,) their reach (V,)
    squares: Real  # (M, V, m)
    outputs: tuple[Output, ...]  # (O,)
    coordinates: Real  # (O, 3, V, m) value and derivatives; angles are continuous, within half a turn at position 0


def dense_of(block: Block, variants: Indices) -> Dense:
    """The survey of some variants."""
    start = np.broadcast_to(np.asarray(block.settled.start), block.size)[variants]
    x = places_of(start, positive=bool(block.chain.tree.mechanism.input.speed > 0))
    own = block.chain(0)
    kinds = kinds_of(own)
    outputs = default_outputs(own)
    reach = {k: np.empty(len(variants)) for k, regularity in kinds if regularity}
    squares = np.empty((len(kinds), *x.shape))
    coordinates = np.empty((len(outputs), 3, *x.shape))
    size = max(1, ROWS // x.shape[1])
    for at in range(0, len(variants), size):
        some = np.s_[at : at + size]
        chain = block.chain(np.repeat(variants[some], x.shape[1]))
        configuration = chain.evaluate(x[some].ravel())
        for k, row in reach.items():
            q = np.abs(configuration.placed[k].q)
            row[some] = np.max(np.broadcast_to(q, x[some].size).reshape(x[some].shape), axis=1)
        for m, (k, regularity) in enumerate(kinds):
            measure = Measure(k, regularity, np.repeat(reach[k][some], x.shape[1]) if regularity else 0.0)
            squares[m, some] = measure(chain, configuration, x[some].ravel()).reshape(x[some].shape)
        for o, output in enumerate(default_outputs(chain)):
            for part, values in enumerate(coordinate_of(chain, output, configuration)):
                coordinates[o, part, some] = np.broadcast_to(values, x[some].size).reshape(x[some].shape)
    measures = tuple(Measure(k, regularity, reach[k] if regularity else 0.0) for k, regularity in kinds)
    found = Dense(variants, x, start, measures, squares, outputs, coordinates)
    _count_turns(block, found)
    return found


def evaluated(block: Block, variants: Indices, x: Real, quantity: Quantity, order: int = 2) -> Real:
    """A quantity (..., m) at input coordinates x (m,) of the variants (m,) of a block, in parts that stay in cache."""
    parts = []
    for rows in np.split(np.arange(len(x)), range(ROWS, len(x), ROWS)):
        chain = block.chain(variants[rows])
        parts.append(quantity(chain, chain.evaluate(x[rows], order=order), rows))
    return np.concatenate(parts, axis=-1)


def values_at(block: Block, o: int, variants: Indices, at: Real) -> Real:
    """Coordinate of an output at places (m,) of the variants (m,); angles are not continuous."""

    def value(chain: Chain, configuration: Configuration, rows: Indices) -> Real:
        return np.broadcast_to(coordinate_of(chain, default_outputs(chain)[o], configuration)[0], rows.shape)

    return evaluated(block, variants, at, value)


def places_of(start: Real, *, positive: bool) -> Real:
    """Places (V, m) of the survey of one turn of the motion from the ``start`` (V,)."""
    low, high = (start, start + TURN) if positive else (start - TURN, start)
    return np.ascontiguousarray(np.linspace(low, high, STEPS + 1, axis=1)) - TURN / STEPS / 2


def _count_turns(block: Block, dense: Dense) -> None:
    """Make the angles of outputs continuous, as those of one variant are; that of the crank is its coordinate."""
    for o, (output, (value, _, _)) in enumerate(zip(dense.outputs, dense.coordinates, strict=True)):
        if output.link is None:
            continue
        if output.link == block.same.kinematics.structure.input_link:
            value[:] = dense.x
            continue
        value[:] = unwrapped(value)

        first = principal(values_at(block, o, dense.variants, dense.start))
        near = np.array([np.interp(s, x, row) for s, x, row in zip(dense.start, dense.x, value, strict=True)])
        value += TURN * np.rint((first - near) / TURN)[:, None]
