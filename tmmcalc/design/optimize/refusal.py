"""What stands in the way where no design can be chosen: none has a solution or keeps constraints, or all are alike."""

from __future__ import annotations

import re
from collections import Counter

import numpy as np

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.design.optimize.order import Scores
from tmmcalc.design.optimize.problem import Problem

_NUMBERS = re.compile(r"\d[\d.e+-]*")


def check(problem: Problem, scores: Scores) -> None:
    """Raise NoSolutionError where none of the designs that were solved can be chosen; ``scores`` are of the best."""
    refuse_constant(problem)
    if scores.violation.min() == 0:
        return
    if not np.isfinite(scores.violation.min()):
        reasons = [reason for reason in problem.reasons if reason]
        alike = Counter(_NUMBERS.sub("", each) for each in reasons)
        most, times = alike.most_common(1)[0] if alike else ("", 0)
        common = next((each for each in reasons if _NUMBERS.sub("", each) == most), "a result has no value")
        raise NoSolutionError(
            f"none of {problem.solved} designs has a solution; most often, {times} times: {common}",
            where="optimize.variables",
            value=problem.solved,
            remedy="move the limits of the variables to where the spec as it is has one",
        )
    raise _broken(problem)


def refuse_constant(problem: Problem) -> None:
    """Raise NoSolutionError if all that was solved is equally good."""
    for each in problem.objectives:
        own = problem.results[:, each.column]
        own = own[np.isfinite(own)]
        if own.size < 2 or np.ptp(own) > 0:
            return
    names = " and ".join(each.name for each in problem.objectives)
    raise NoSolutionError(
        f"{names} is the same of all {problem.solved} designs: no variable changes it",
        where="optimize",
        remedy="name another result, or other variables",
    )


def _broken(problem: Problem) -> NoSolutionError:
    """What stands in the way where no design keeps the constraints."""
    scores = problem.judged(problem.results)
    order = int(np.argmin(scores.violation))
    nearest = problem.results[order]
    told = []
    for each in problem.rule.limits:
        kept = problem.rule.kept(each, problem.results)
        value = float(nearest[each.column])
        limits = [f"at least {each.at_least:.7g}"] if each.at_least is not None else []
        limits += [f"at most {each.at_most:.7g}"] if each.at_most is not None else []
        told.append(
            f"{each.name} is {value:.7g} {each.unit}".rstrip() + f" ({' and '.join(limits)}; "
            f"{int(kept.sum())} of {len(kept)} designs keep it)"
        )
    return NoSolutionError(
        f"none of {problem.solved} designs keeps the constraints; of the nearest " + ", ".join(told),
        where="constraints",
        value=float(scores.violation[order]),
        limit=0.0,
        remedy="loosen what few keep, or widen the limits of the variables",
    )
