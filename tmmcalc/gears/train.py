"""The synthesis of one or several layouts: tooth sets, which of them the textbook finds, and what would help."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.core.progress import tell
from tmmcalc.gears.advice import remedies, why_none
from tmmcalc.gears.model import ToothSets, TrainTask
from tmmcalc.gears.nominal import with_speeds
from tmmcalc.gears.search.blocks import Tally
from tmmcalc.gears.search.constraints import sieve
from tmmcalc.gears.search.measures import block_of
from tmmcalc.gears.search.relaxation import relaxations
from tmmcalc.gears.search.search import Synthesis, angle_error, synthesise
from tmmcalc.gears.stepping import found_by_textbook, stepped
from tmmcalc.gears.trains import Asked, Request, Trains, Variant


def solve_train(asked: Asked, drive: Any = None, *, advised: bool = True) -> Trains:
    """The tooth sets of every request that keep the user's constraints; ``drive`` gives a ratio that they have not.

    ``advised``: what would help one without any is sought, which takes longer than to see that there is none. Raises
    `UsageError` where neither gives a ratio, `NoSolutionError` if no request has any tooth set, with that advice, or if
    none keeps the constraints.
    """
    if asked.by_drive and drive is None:
        raise UsageError(
            "the ratio of the train is not known",
            where="train",
            remedy="give ratio, or a machine whose motor and mean speed lead to it",
        )
    variants = []
    for each in asked.requests:
        request = with_speeds(each, drive.ratio, drive.origin) if asked.by_drive else each
        title = request.title

        def progress(part: float, count: int, title: str = title) -> None:
            tell(part, f"{title}: {count} tooth sets")

        by_program = request.method == "textbook" and request.task.teeth is None
        synthesis = programmed(request) if by_program else synthesise(request.task, request.keep, progress)
        if synthesis.count:
            found, error = found_by_textbook(request.task, synthesis.sets), angle_error(request.task, synthesis.sets)
            variants.append(Variant(request, synthesis, found, error=error))
            continue
        if request.task.teeth is not None or not advised:
            variants.append(Variant(request, synthesis, None))
            continue
        tell(1.0, f"{title}: no tooth set; seeking the least change that gives one")
        variants.append(Variant(request, synthesis, None, relaxations(request.task, request.kind)))
    if not any(variant.synthesis.count for variant in variants):
        raise _no_solution(variants, advised)
    trains = Trains(tuple(variants))
    if asked.kept is None:
        return trains
    from tmmcalc.gears.userconstraints import kept_sets  # only constraints need the tables of the criteria

    return kept_sets(trains, asked.kept)


def programmed(request: Request) -> Synthesis:
    """The sets of the textbook's programs, without those that break a constraint which the programs do not know."""
    tally, found = Tally(), []
    for proportion, sets in _programs(request.task):
        tally.begin(len(sets))
        block = replace(block_of(sets).join(row=np.arange(len(sets))), proportion=proportion)
        found.append((sets, sieve(request.task, block, tally)["row"]))
    teeth, modules, angles = (
        np.concatenate([getattr(sets, name)[rows] for sets, rows in found]) for name in ("teeth", "modules", "angles")
    )
    keep, task = request.keep, request.task
    sets = ToothSets(task.layout, teeth[:keep], modules[:keep], angles[:keep], task.planets)
    return Synthesis(sets, len(teeth), tally.candidates, {name: n for name, n in tally.removed.items() if n})


def _programs(task: TrainTask) -> Iterator[tuple[tuple[int, ...], ToothSets]]:
    """The sets of each proportion of modules; planets that overlap whatever the teeth leave none."""
    for proportion in task.proportions:
        try:
            yield proportion, stepped(replace(task, proportions=(proportion,))).sets
        except NoSolutionError:
            scheme = task.scheme
            teeth = np.zeros((0, len(scheme.wheels)), np.int64)
            modules, angles = np.zeros((0, scheme.stages), np.int64), np.zeros((0, len(scheme.meshes)))
            yield proportion, ToothSets(task.layout, teeth, modules, angles, task.planets)


def _no_solution(variants: Sequence[Variant], advised: bool) -> NoSolutionError:
    message = "\n  ".join(line for variant in variants for line in why_none(variant))
    if not advised:
        return NoSolutionError(message, where="train", remedy="tmmcalc run tells what would help")
    advice = [f"{variant.request.title}: {text}" for variant in variants for text in remedies(variant)]
    if len(variants) == 1:
        advice = remedies(variants[0])
    return NoSolutionError(message, where="train", remedy="\n  -> ".join(advice))
