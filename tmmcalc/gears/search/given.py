"""One tooth set that is given, tested as the search tests its candidates: exactly, constraint by constraint."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

import numpy as np

from tmmcalc.gears.model import ToothSets, TrainTask
from tmmcalc.gears.search import measures
from tmmcalc.gears.search.blocks import Block, Tally
from tmmcalc.gears.search.constraints import sums, undercut

ROUNDING = 1e-9  # relative, of ratios and diameters in floats


def given_candidates(task: TrainTask, proportion: tuple[int, ...], tally: Tally) -> Iterator[Block]:
    """The given teeth with a proportion of modules, unless they break what a search solves for."""
    assert task.teeth is not None
    tally.begin(1)
    block = Block({name: np.array([z]) for name, z in zip(task.scheme.wheels, task.teeth, strict=True)}, proportion)
    for name, holds in _solved_for(task, block):
        if len(block):
            block = tally.keep(name, block, np.array([holds]))
    if len(block):
        yield block


def _solved_for(task: TrainTask, block: Block) -> Iterator[tuple[str, bool]]:
    """The constraints that a search solves for, and so does not test."""
    scheme, demands = task.scheme, task.demands
    one = _one(task, block)
    numerator, denominator = (int(part[0]) for part in measures.tooth_ratio(one))
    largest = task.limits.largest_sum
    yield "largest_sum", largest is None or int(block["1"][0] + block["2"][0]) <= largest
    if scheme.branched and demands.largest_angle is None:
        yield "coaxiality", len({int(total[0]) for total in sums(task, block)}) == 1
    yield "ratio", task.ratio.low <= Fraction(numerator, denominator) <= task.ratio.high
    if demands.undercut is not None:
        yield "undercut", bool(undercut(task, block)[0])
    if scheme.branched:
        return
    if demands.stage_ratio is not None:
        yield "stage_ratio", float(measures.steepest(task, one)[0]) <= float(demands.stage_ratio) * (1 + ROUNDING)
    if demands.diameter_band is not None:
        yield "diameter_band", float(measures.unlikeness(task, one)[0]) <= float(demands.diameter_band) + ROUNDING
    if demands.equal_pinions:
        yield "equal_pinions", len({int(block[wheel][0]) for wheel in scheme.wheels[::2]}) == 1


def _one(task: TrainTask, block: Block) -> ToothSets:
    scheme = task.scheme
    teeth = np.stack([block[wheel] for wheel in scheme.wheels], axis=1)
    modules = np.array([block.proportion or (0,) * scheme.stages], np.int64)
    return ToothSets(task.layout, teeth, modules, np.zeros((1, len(scheme.meshes))), task.planets)
