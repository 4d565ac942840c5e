"""Wanted paths of many variants: nearest places of all at once, their columns and facts, or the result of each."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from tmmcalc.core.numerics.alike import rows_of
from tmmcalc.core.numerics.extended import CHAIN, WIDER
from tmmcalc.core.numerics.roots import Indices
from tmmcalc.core.plane import Real
from tmmcalc.linkage.lastdigit import in_full
from tmmcalc.linkage.paths.deviations import Range, Reached, deviations, reached, told_by
from tmmcalc.linkage.paths.results import PathError, Paths
from tmmcalc.linkage.paths.solve import errors_of, joined, records_of
from tmmcalc.linkage.paths.task import WantedPath
from tmmcalc.linkage.results import Kinematics
from tmmcalc.linkage.stacked.dense import evaluated, places_of
from tmmcalc.linkage.stacked.scene import Block
from tmmcalc.linkage.survey import Evaluate, Quantity

Asked = tuple[WantedPath, ...]


def paths_of(block: Block, variants: Indices, asked: Asked, base: Paths) -> tuple[Paths, dict[str, Real]]:
    """The paths of some variants (v,), the points of one behind the other; and their facts (v,) by name."""
    over, own, found = _reached(block, variants, asked)
    facts: dict[str, Real] = {}
    for each, path in zip(found, own, strict=True):
        facts |= told_by(deviations(over, each, path), path.name)
    phi, wanted, place = joined(over, found)
    return replace(base, phi=phi.ravel(), wanted=wanted.ravel(), reached=place.ravel()), facts


def paths_records(
    block: Block, variants: Indices, asked: Asked, kinematics: Sequence[Kinematics], base: Paths
) -> list[Paths]:
    """The paths of some variants (v,), each by itself."""
    over, own, found = _reached(block, variants, asked)
    errors = [PathError(max(each.error.position, CHAIN), CHAIN) for each in kinematics]
    if WIDER:
        errors = errors_of(_evaluate(block, variants, wide=True), over, found, own)
    return records_of(over, found, own, base.turns, errors)


def _reached(block: Block, variants: Indices, asked: Asked) -> tuple[Range, Asked, list[Reached]]:
    """Where the paths of some variants are looked at, their own wanted points, and what is found."""
    start = np.broadcast_to(np.asarray(block.settled.start), block.size)[variants]
    positive = bool(block.chain.tree.mechanism.input.speed > 0)
    over = Range(places_of(start, positive=positive), start, 1.0 if positive else -1.0, closed=True)
    own, evaluate = rows_of(asked, variants), _evaluate(block, variants)
    return over, own, [reached(evaluate, over, path) for path in own]


def _evaluate(block: Block, variants: Indices, *, wide: bool = False) -> Evaluate:
    """How variants are evaluated, in extended precision where ``wide``."""

    def evaluate(x: Real, which: Indices, quantity: Quantity, order: int) -> Real:
        if not wide:
            return evaluated(block, variants[which], x, quantity, order)
        chain = in_full(block.chain(variants[which]))
        return quantity(chain, chain.evaluate(x, order=order), np.arange(len(x)))

    return evaluate
