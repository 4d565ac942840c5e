"""The studies of a scene: its stages are run once, then every method of each."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from tmmcalc.core.errors import TmmError, UsageError
from tmmcalc.core.stage import resolve
from tmmcalc.core.studies.measure import Clock
from tmmcalc.core.studies.scene import Scene
from tmmcalc.core.studies.study import Accuracy, Ladder, Study
from tmmcalc.pipeline.runner import run
from tmmcalc.rooms import STAGES

SUBJECTS = {name: stage.studies for name, stage in STAGES.items() if stage.studies}  # stages with a choice of methods

if TYPE_CHECKING:
    from tmmcalc.project import Spec


def solve_accuracy(
    spec: Spec,
    stage: str | None = None,
    clock: Clock | None = None,
    tell: Callable[[str], None] | None = None,
) -> Accuracy:
    """Error against run time of every method of a stage, or of all stages that the scene has.

    ``tell`` is called with a few words whenever a stage is begun and one of its studies is done. Of all stages one
    without a solution ends only the study of those that read it, and is told in ``failures``, as is one whose reference
    has no result. Raises `UsageError` for a stage that has no choice of methods or that the scene leaves out, and what
    a stage raises that is asked for.
    """
    clock = clock or Clock()
    if stage is not None and stage in STAGES and stage not in SUBJECTS:
        raise UsageError(
            f"{stage} has one method only", where="accuracy", remedy=f"stages with a choice: {', '.join(SUBJECTS)}"
        )
    ran = run(spec, target=stage, keep_going=stage is None)
    running = ran.plan.running
    asked = [name for name in running if name in SUBJECTS and stage in (None, name)]
    studies: list[Study] = []
    ladders: list[Ladder] = []
    failures = dict(ran.failures)
    for name in (name for name in asked if name in ran.outcomes):
        scene = Scene(STAGES[name].inputs(ran.spec), ran.results, clock)
        if tell is not None:
            tell(f"{name}: methods are run")
        try:
            for part in resolve(SUBJECTS[name])(scene):
                (studies if isinstance(part, Study) else ladders).append(part)
                if tell is not None:
                    tell(f"{name}: {part.quantity}: done")
        except TmmError as fault:  # of a reference: what methods raise stands with their settings
            if stage is not None:
                raise
            failures[name] = fault
    studied = {study.stage for study in studies} | {ladder.stage for ladder in ladders}
    return Accuracy(
        tuple(studies),
        tuple(name for name in ran.outcomes if name not in SUBJECTS and stage is None),
        tuple(ladders),
        tuple(name for name in asked if name in ran.outcomes and name not in studied | failures.keys()),
        failures,
    )
