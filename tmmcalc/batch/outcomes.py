"""The result of one stage at every point of a task, or why there is none."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from tmmcalc.batch.choice import chosen
from tmmcalc.batch.preparing import prepared
from tmmcalc.batch.stacked import SOLVER
from tmmcalc.batch.stacked_results import BLOCK, Results
from tmmcalc.batch.task import Task
from tmmcalc.core.errors import TmmError, UsageError
from tmmcalc.pipeline.runner import run

if TYPE_CHECKING:
    from tmmcalc.project.loader import Variants


def outcomes(task: Task) -> Iterator[Any | TmmError]:
    """Results of the one target of a task, in the order of the points; solved together where they can be.

    A faulty spec and a scene without a solution are told. Raises `UsageError` for what no other value of a key would
    mend.
    """
    together = prepared(task) if chosen(task, 1, 1)[0].solver == SOLVER else None
    variants = task.variants()
    for first in range(0, task.count, BLOCK):
        block = range(first, min(first + BLOCK, task.count))
        given = np.array([task.values(point) for point in block])
        found = together.results(given).found if isinstance(together, Results) else {}
        for k, point in enumerate(block):
            yield found[k][task.targets[0]] if k in found else _alone(task, variants, point)


def _alone(task: Task, variants: Variants, point: int) -> Any | TmmError:
    overrides, (target,) = task.assignments(point), task.targets
    try:
        return run(variants.spec(overrides), target=target).results[target]
    except UsageError as error:
        where = f"{error.where}, with {', '.join(overrides)}" if error.where else f"with {', '.join(overrides)}"
        raise UsageError(error.message, where=where, remedy=error.remedy) from None
    except TmmError as error:
        return error
