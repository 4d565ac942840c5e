"""``tmmcalc forces``."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

import typer

from tmmcalc.cli.job import Job, with_flags
from tmmcalc.cli.options import Columns, Form, Format, Positions, patterns_of
from tmmcalc.cli.output import table_file, title
from tmmcalc.core.errors import UsageError
from tmmcalc.report.rows import rows_of

if TYPE_CHECKING:
    from tmmcalc.linkage.forces.results import Forces
    from tmmcalc.linkage.results import Kinematics
    from tmmcalc.project import Spec
    from tmmcalc.report.document import Document

ITERATIONS, STOP = "--iterations", "--stop"
EXAMPLE = f"write e.g. {ITERATIONS} 'RRP(2,3)@6', or '...@67.5 deg'"


@with_flags
def command(
    job: Job,
    form: Form = Format.table,
    columns: Columns = None,
    positions: Positions = None,
    iterations: Annotated[
        str | None,
        typer.Option(
            ITERATIONS,
            metavar="GROUP@POSITION",
            help="Print the passes by which the textbook finds the friction of a group there, instead.",
        ),
    ] = None,
    stop: Annotated[
        float | None,
        typer.Option(STOP, metavar="PART", help="Relative change at which the passes end (default: 0.03)."),
    ] = None,
) -> None:
    """Forces: reactions in all pairs, with friction where the pairs have it, and what the drive must apply.

    Example: tmmcalc forces my.toml --columns 'phi,M_drive,R_*' --positions 0:12:2
    """
    _check_flags(iterations, stop, columns, positions)
    scene = job.spec()
    run = job.run(scene, "forces")
    result = run.results["forces"]
    heading = title(scene, job.file, "forces")
    if iterations is not None:
        document = _iterations(scene, run.results["kinematics"], result, heading, iterations, stop)
    else:
        from tmmcalc.linkage.facts.forces import document as forces_document

        document = forces_document(
            result,
            heading,
            patterns=patterns_of(columns),
            rows=rows_of(positions, result.labels),
            everything=form is not Format.table,
            where=table_file(run, "forces"),
        )
    job.finish(document, run, form)


def _check_flags(iterations: str | None, stop: float | None, columns: str | None, positions: str | None) -> None:
    """Refuse flags that would have no effect together, rather than pass them over."""
    if iterations is None and stop is not None:
        raise UsageError("only the textbook's passes are stopped by it", where=STOP, remedy=f"add {ITERATIONS}")
    if stop is not None and not 0 < stop < 1:
        raise UsageError(f"{stop:g} is not between 0 and 1", where=STOP, remedy="write e.g. --stop 0.001")
    if iterations is not None and (columns is not None or positions is not None):
        remedy = "leave --columns and --positions out"
        raise UsageError("prints a table of its own", where=ITERATIONS, remedy=remedy)


def _iterations(
    scene: Spec, kinematics: Kinematics, result: Forces, heading: str, text: str, stop: float | None
) -> Document:
    """The passes of the group and at the place that the flag names."""
    from tmmcalc.linkage.facts.iteration import iteration_document
    from tmmcalc.linkage.forces.iteration import STOP as USUAL
    from tmmcalc.linkage.forces.iteration import textbook_iteration
    from tmmcalc.linkage.forces.kinetostatics import compile_statics
    from tmmcalc.linkage.loads.scene import compile_scene
    from tmmcalc.linkage.tables.tasks.loading import to_loading
    from tmmcalc.linkage.tables.tasks.mechanism import to_linkage

    group, sign, where = text.rpartition("@")
    if not sign:
        raise UsageError(f"{text!r} names no group and position", where=ITERATIONS, remedy=EXAMPLE)
    theta, side, place = _place(result, where.strip())
    statics = compile_statics(compile_scene(to_linkage(scene.linkage), to_loading(scene), kinematics))
    stop = USUAL if stop is None else stop
    found = textbook_iteration(statics, group.strip(), theta, side, stop)
    return iteration_document(found, f"{heading}, friction by passes at {place}", stop)


def _place(result: Forces, where: str) -> tuple[float, float, str]:
    """theta of a position or of a distance along the motion, the side that it is seen from, and how it is called."""
    if where in result.labels:
        row = result.labels.index(where)
        before = where.endswith("-") or row == len(result.labels) - 1
        return float(result.theta[row]), -1.0 if before else 1.0, f"position {where}"
    from tmmcalc.spec.units import UnitError, parse

    if not where or where.isdecimal():
        rows_of(where, result.labels, ITERATIONS)
    try:
        theta = parse(where, "angle" if result.turns else "length")
    except UnitError as error:
        raise UsageError(error.message, where=ITERATIONS, remedy=EXAMPLE) from None
    end = float(result.theta[-1])
    if not 0 <= theta <= end:
        raise UsageError(f"{where!r} lies outside the motion", where=ITERATIONS, value=theta, limit=end, remedy=EXAMPLE)
    return theta, 1.0 if theta < end else -1.0, where
