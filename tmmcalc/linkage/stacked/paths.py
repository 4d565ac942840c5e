"""Wanted paths of many variants: nearest places of all at once, their columns and facts, or the result of each."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from tmmcalc.core.numerics.alike import rows_of
from tmmcalc.core.numerics.extended import CHAIN, WIDER
from tmmcalc.core.numerics.roots import Indices
from tmmcalc.core.plane import Real
from tmmcalc.linkage.assembly import TURN
from tmmcalc.linkage.lastdigit import in_full
from tmmcalc.linkage.paths.deviations import Range, Reached, deviations, reached, told_by
from tmmcalc.linkage.paths.results import PathError, Paths
from tmmcalc.linkage.paths.solve import errors_of, joined, records_of
from tmmcalc.linkage.paths.task import WantedPath
from tmmcalc.linkage.results import Kinematics
from tmmcalc.linkage.stacked.dense import evaluated, places_of
from tmmcalc.linkage.stacked.scene import Block
from tmmcalc.linkage.survey import Evaluate, Quantity, survey

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
    x = places_of(start, positive=positive)
    if block.settled.swift[variants].any() and not all(path.at for path in asked):
        x = _denser(block, variants, start, positive=positive)
    over = Range(x, start, 1.0 if positive else -1.0, closed=True)
    own, evaluate = rows_of(asked, variants), _evaluate(block, variants)
    return over, own, [reached(evaluate, over, path) for path in own]


def _denser(block: Block, variants: Indices, start: Real, *, positive: bool) -> Real:
    """Places (v, m) of the survey of each by itself, denser where a link turns swiftly; the last stands in for more."""
    every = []
    for v, at in zip(variants.tolist(), start.tolist(), strict=True):
        low, high = (at, at + TURN) if positive else (at - TURN, at)
        every.append(survey(block.chain(v), low, high, at).x)
    most = max(map(len, every))
    return np.array([np.pad(x, (0, most - len(x)), mode="edge") for x in every])


def _evaluate(block: Block, variants: Indices, *, wide: bool = False) -> Evaluate:
    """How variants are evaluated, in extended precision where ``wide``."""

    def evaluate(x: Real, which: Indices, quantity: Quantity, order: int) -> Real:
        if not wide:
            return evaluated(block, variants[which], x, quantity, order)
        chain = in_full(block.chain(variants[which]))
        return quantity(chain, chain.evaluate(x, order=order), np.arange(len(x)))

    return evaluate
