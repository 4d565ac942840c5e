"""The constraints of a scene inside the search of a synthesis: designs that fail are told and passed over.

More designs are sought than are listed, and each is judged by its own sizes and by the stages of its ready spec. What
other stages of the scene give is the same for all designs and does not count here.
"""

from __future__ import annotations

import math
from collections import Counter
from dataclasses import replace

import numpy as np

from tmmcalc.core.errors import NoSolutionError, TmmError, UsageError
from tmmcalc.core.notes import Phrase
from tmmcalc.core.stage import Another
from tmmcalc.feasibility.judge import Feasibility, FeasibilityTask
from tmmcalc.feasibility.rule import failing, may_hold
from tmmcalc.feasibility.stages.candidates import of_ready
from tmmcalc.feasibility.stages.judged import judged
from tmmcalc.linkage.synthesis.results import Design, Synthesis

SOUGHT = 40  # designs that are judged
REFUSED = "no result"  # of a design whose ready spec cannot be solved


def sifted(task: FeasibilityTask, found: Synthesis, own: frozenset[str], count: int, another: Another) -> Synthesis:
    """The first ``count`` designs: those with which the rule may hold, then the others, the nearest to it first.

    ``own`` are the stages that the scene itself has: their constraints are left open, and those of stages that a
    linkage alone has not, such as the flywheel of its machine.
    """
    open_stages = own | {each.stage for each in task.constraints if not _has(found.designs[0], each.stage, another)}
    known = tuple(each for each in task.constraints if each.stage == "synthesis" or each.stage not in open_stages)
    names = {each.name for each in task.constraints}
    if not known:
        return replace(found, designs=found.designs[:count])
    whole = len(known) == len(task.constraints)
    sought = replace(task, constraints=known, rule=task.rule if whole else "")
    kept: list[Design] = []
    passed: list[tuple[float, Design]] = []
    reasons: Counter[str] = Counter()
    for design in found.designs:
        result = _judged(sought, found, design, another)
        if result is None:
            passed.append((math.inf, design))
            reasons[REFUSED] += 1
            continue
        truths = {verdict.name: verdict.holds for verdict in result.verdicts}
        if may_hold(task.combined, {name: np.array([truth]) for name, truth in truths.items()}, (1,))[0]:
            kept.append(design)
        else:
            passed.append((-result.function, design))
            reasons.update(
                name for name in failing(task.combined, dict.fromkeys(names, True) | truths) if name in truths
            )
    if not passed:
        return replace(found, designs=found.designs[:count])
    told = [Phrase("{name} ({number})", name=name, number=number) for name, number in reasons.items()]
    degree = "note" if kept else "warning"
    note = Phrase(
        "{degree}: {passed} of {designs} designs fail constraints and are passed over: {told}",
        degree=degree,
        passed=len(passed),
        designs=len(found.designs),
        told=told,
    )
    counters = {**found.counters, "passed over": len(passed)}
    rest = [design for _, design in sorted(passed, key=lambda each: each[0])]
    return replace(found, designs=tuple([*kept, *rest][:count]), notes=(*found.notes, note), counters=counters)


def _has(design: Design, stage: str, another: Another) -> bool:
    """Whether a stage is one of the ready spec, with a result or without."""
    try:
        another(design.spec, [stage])
    except UsageError:
        return False
    except TmmError:
        return True
    return True


def _judged(task: FeasibilityTask, found: Synthesis, design: Design, another: Another) -> Feasibility | None:
    """The verdicts on a design; None if a stage has no result of it."""
    alone = {"synthesis": replace(found, designs=(design,))}
    try:
        return judged(task, {**alone, **of_ready(task, design, alone, another)})
    except TmmError as error:
        if error.exit_code < NoSolutionError.exit_code:
            raise
        return None
