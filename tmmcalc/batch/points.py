"""Points solved one by one through the pipeline, whatever their stages are."""

from __future__ import annotations

from array import array
from collections.abc import Sequence
from typing import TYPE_CHECKING

from tmmcalc.batch.quantities import told
from tmmcalc.batch.task import Row, Task, verdict
from tmmcalc.core.errors import TmmError, UsageError
from tmmcalc.core.plan import Plan
from tmmcalc.naming.scene import Scene
from tmmcalc.pipeline.runner import run
from tmmcalc.pipeline.settling import planned
from tmmcalc.rooms import STAGES

if TYPE_CHECKING:
    from tmmcalc.pipeline.outcome import RunResult
    from tmmcalc.project import Spec
    from tmmcalc.project.loader import Variants

Names = tuple[str, ...]


def solve_points(task: Task, points: Sequence[int]) -> list[Row]:
    """Rows of the points, in their order. Nothing is raised for a variant: its row says why it failed."""
    variants = task.variants()
    shared: dict[Names, Names] = {}  # a thousand variants have the names of one
    return [_row(task, variants, point, shared) for point in points]


def solve_variant(task: Task, spec: Spec) -> tuple[dict[str, float], TmmError | None]:
    """The quantities of a variant, and the error of its first stage without a result.

    What other stages tell stays. Raises `UsageError` for a target that the variant leaves out.
    """
    result = run_of(task, spec)
    asked = result.outcomes if task.patterns or not task.targets else [t for t in task.targets if t in result.outcomes]
    found = dict(told(result.results, task.patterns, Scene(result.spec, result.results), [*asked]))
    return found, next(iter(result.failures.values()), None)


def run_of(task: Task, spec: Spec) -> RunResult:
    """The run of a variant up to its targets. Raises `UsageError` for a target that it leaves out."""
    scene = scene_to(spec, task.targets)
    return run(spec, target=task.targets or None, scene=scene, tolerance=task.tolerance, keep_going=True, by_name=True)


def _row(task: Task, variants: Variants, point: int, shared: dict[Names, Names]) -> Row:
    found: dict[str, float] = {}
    error: Exception | None
    try:
        found, error = solve_variant(task, variants.spec(task.assignments(point)))
    except Exception as fault:  # one variant that breaks the program must not end the others
        error = fault
    names = tuple(found)
    return Row(point, *verdict(error), shared.setdefault(names, names), array("d", found.values()))


def scene_to(spec: Spec, targets: Names) -> Plan:
    """The plan that leads to the targets; without targets to all stages."""
    scene = planned(spec, targets or None, STAGES)
    for target in targets:
        if target not in scene.running:
            raise UsageError(scene.step(target).reason, where=target)
    return scene
