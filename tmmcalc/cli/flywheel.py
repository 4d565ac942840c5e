"""``tmmcalc flywheel``."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

import typer

from tmmcalc.cli.job import Job, of_stage
from tmmcalc.cli.output import Solved
from tmmcalc.core.errors import UsageError
from tmmcalc.report.document import Document

if TYPE_CHECKING:
    from tmmcalc.project import Spec

TANGENTS, METHODS = "--tangents", "--methods"


def _asked(job: Job, *, tangents: bool, methods: bool, **others: object) -> tuple[Job, Spec]:
    scene = job.spec()
    if tangents and methods:
        where = f"{TANGENTS}, {METHODS}"
        raise UsageError("print one table each", where=where, remedy="leave all but one of them out")
    return job, scene


@of_stage("flywheel", asked=_asked, found="flywheel")
def command(
    solved: Solved,
    tangents: Annotated[
        bool,
        typer.Option(TANGENTS, help="Print Wittenbauer's tangents with their angles and the curve, instead."),
    ] = False,
    methods: Annotated[
        bool, typer.Option(METHODS, help="Print what every method works out on its way, instead.")
    ] = False,
) -> Document:
    """Flywheel: the one that keeps the allowed unevenness, by all methods side by side, its shaft and its rim.

    --spec writes the spec with its inertia in the place of the unevenness.

    Example: tmmcalc flywheel my.toml
    """
    if not (tangents or methods):
        return solved.document()
    from tmmcalc.machine.facts.worked import methods_document, tangents_document
    from tmmcalc.machine.stages.flywheel import mean, methods_of

    result, reduction = solved.result, solved.run.results["reduction"]
    speed = mean(solved.spec, solved.run.results)
    if methods:
        rows = methods_of(solved.spec, solved.run.results)
        return methods_document(rows, result, speed, f"{solved.title}, methods")
    positions = reduction.labels, reduction.phi - reduction.phi[0]
    title, everything = f"{solved.title}, tangents", solved.everything
    return tangents_document(result, reduction.cycle, positions, speed, title, everything=everything)
