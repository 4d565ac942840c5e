"""Every design of a synthesis judged: by its own sizes and by the stages of its ready spec, the best design first.

Feasible designs come first in the order of the synthesis, then the others, the nearest to feasibility first, then
those of which a stage has no result.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from tmmcalc.core.errors import NoSolutionError, TmmError
from tmmcalc.core.stage import Another
from tmmcalc.feasibility.judge import Candidate, Feasibility, FeasibilityTask
from tmmcalc.feasibility.stages.judged import judged
from tmmcalc.naming.language import ANY


def judge_designs(task: FeasibilityTask, upstream: Mapping[str, Any], another: Another) -> Feasibility:
    """Judge all designs; raises `NoSolutionError` if no stage that is asked about has a result of any of them."""
    synthesis = upstream["synthesis"]
    found: list[tuple[Candidate, Feasibility | None]] = []
    for number, design in enumerate(synthesis.designs, 1):
        own = {**upstream, "synthesis": replace(synthesis, designs=(design,))}
        try:
            result = judged(task, {**own, **of_ready(task, design, own, another)})
        except TmmError as error:
            if error.exit_code < NoSolutionError.exit_code:
                raise
            refused = f"{error.where}: {error.message}" if error.where else error.message
            found.append((Candidate(number, design.name, False, None, (), (), refused), None))
        else:
            found.append((_candidate(number, design, result), result))
    found.sort(key=lambda pair: _rank(pair[0]))
    best = found[0][1]
    if best is None:
        raise NoSolutionError(
            f"no design can be judged; the first: {found[0][0].refused}",
            where="feasibility",
            remedy="constrain other stages, or change what the synthesis is asked",
        )
    return replace(best, candidates=tuple(candidate for candidate, _ in found))


def _candidate(number: int, design: Any, found: Feasibility) -> Candidate:
    return Candidate(number, design.name, found.feasible, found.function, found.failing, found.verdicts)


def _rank(candidate: Candidate) -> tuple[int, float]:
    if candidate.feasible or candidate.function is None:
        return (0 if candidate.feasible else 2), 0.0
    return 1, -candidate.function


def of_ready(task: FeasibilityTask, design: Any, own: Mapping[str, Any], another: Another) -> Mapping[str, Any]:
    """Results of the ready spec of a solution for stages that constraints ask about and the scene itself has not."""
    known = {"", ANY, *own}
    asked = [name for name in dict.fromkeys(each.stage for each in task.constraints) if name not in known]
    return another(design.spec, asked) if asked else {}
