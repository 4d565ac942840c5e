"""Stage ``synthesis``: linkages by what they are to do, each simulated, with their ready specs."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

from tmmcalc.core.records import record
from tmmcalc.core.stage import Another, said
from tmmcalc.linkage.synthesis.results import Synthesis
from tmmcalc.linkage.synthesis.task import SynthesisTask

if TYPE_CHECKING:
    from tmmcalc.linkage.room import LinkageTables


NO_SIFT = "no [[constraints]]: solutions are not sifted"
CLOSED = "solutions in closed form, all listed: they are not sifted by the constraints"
NO_SEARCH = "no [synthesis.dwell.optimum]: no search for the best dwell"

kind = Synthesis
table = "tmmcalc.linkage.synthesis.columns:table"
found = "tmmcalc.linkage.tables.found:of_synthesis"
outlook = "tmmcalc.linkage.tables.found:outlook"


@record
class Request:
    """A synthesis, and the stages of the scene itself, whose constraints do not concern the designs."""

    task: SynthesisTask
    own: tuple[str, ...] = ()


def inputs(spec: LinkageTables) -> Request:
    """What is asked."""
    from tmmcalc.linkage.synthesis.kinds import SEARCHES
    from tmmcalc.linkage.tables.tasks.synthesis import to_synthesis

    task = to_synthesis(spec)
    if task.constraints is None or task.kind not in SEARCHES:
        return Request(task)
    from tmmcalc.core.plan import plan

    return Request(task, plan(spec).running)


def solve(given: Request, another: Another) -> Synthesis:
    """All solutions that are listed, the best first; those of a search that fail constraints are passed over."""
    from tmmcalc.linkage.synthesis.kinds import SEARCHES, solve_synthesis

    constraints, count = given.task.constraints, given.task.solutions
    if constraints is None or given.task.kind not in SEARCHES:
        return solve_synthesis(given.task)
    from tmmcalc.linkage.stages.sifted import SOUGHT, sifted

    found = solve_synthesis(replace(given.task, solutions=max(SOUGHT, count)))
    return sifted(constraints, found, frozenset(given.own), count, another)


def chosen(spec: LinkageTables, result: Synthesis, another: Another) -> int | None:
    """Of solutions in closed form the number of the first that keeps the constraints, where the spec chooses none."""
    from tmmcalc.linkage.tables.tasks.synthesis import to_synthesis

    assert spec.synthesis is not None
    count = len(result.designs)
    if not spec.constraints or spec.synthesis.choose or count == 1 or to_synthesis(spec).constraints is not None:
        return None
    from tmmcalc.core.plan import plan
    from tmmcalc.feasibility.tables.tasks.feasibility import to_feasibility
    from tmmcalc.linkage.stages.sifted import sifted

    best = sifted(to_feasibility(spec), result, frozenset(plan(spec).running), count, another).best
    return 1 + next(number for number, design in enumerate(result.designs) if design is best)


def errors(result: Synthesis) -> dict[str, Any]:
    """Estimates of its errors."""
    sizes = {} if result.error is None else {"sizes": result.error}
    return {"residual": result.residual, **sizes}


def omits(spec: LinkageTables) -> tuple[str, ...]:
    """Searches that are not asked for."""
    from tmmcalc.linkage.synthesis.dwell.task import DwellTask
    from tmmcalc.linkage.synthesis.kinds import SEARCHES
    from tmmcalc.linkage.tables.tasks.synthesis import to_synthesis

    task = to_synthesis(spec)
    asked = task.asked
    return said(
        (isinstance(asked, DwellTask) and asked.optimum is None, NO_SEARCH),
        (task.constraints is None, NO_SIFT),
        (task.constraints is not None and task.kind not in SEARCHES, CLOSED),
    )


def packages(spec: LinkageTables) -> tuple[str, ...]:
    """Searches over many parameters."""
    from tmmcalc.linkage.synthesis.dwell.task import DwellTask
    from tmmcalc.linkage.synthesis.task import FunctionTask
    from tmmcalc.linkage.tables.tasks.synthesis import to_synthesis

    asked = to_synthesis(spec).asked
    if isinstance(asked, FunctionTask):
        from tmmcalc.linkage.synthesis.function import is_exact

        return () if is_exact(asked) else ("scipy.optimize",)
    return ("scipy.optimize",) if isinstance(asked, DwellTask) and asked.optimum is not None else ()
