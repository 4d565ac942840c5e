"""``tmmcalc kinematics``."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from enum import StrEnum
from typing import TYPE_CHECKING, Annotated

import typer

from tmmcalc.cli.job import Job, of_stage
from tmmcalc.cli.makers import check_names
from tmmcalc.cli.options import Columns, Positions, patterns_of
from tmmcalc.cli.output import Solved
from tmmcalc.core.errors import UsageError
from tmmcalc.report.document import Document
from tmmcalc.report.rows import rows_of

if TYPE_CHECKING:
    from tmmcalc.core.columns import Column
    from tmmcalc.pipeline.outcome import RunResult
    from tmmcalc.project import Spec

POLYGONS = "--polygons"
CRANK, LARGEST = 50.0, 1e4  # length of the crank's segments that nobody told, of those that can be told [mm]


class MethodChoice(StrEnum):
    """How velocities and accelerations are found; by splitting, positions of groups of class III and IV too."""

    closed = "closed"
    projection = "projection"
    differences = "differences"
    splitting = "splitting"


def _asked(
    job: Job,
    columns: str | None,
    positions: str | None,
    dimensionless: bool,
    method: MethodChoice,
    step: str | None,
    decimals: int | None,
    compare: bool,
    plan: bool,
    polygons: str | None,
    scale: str | None,
    study: bool,
    output: str | None,
) -> tuple[Job, Spec]:
    """The job by the method that is asked for, and its spec."""
    _check_kind(plan, study, compare, columns, positions, dimensionless, output, polygons)
    _crank_segment(polygons, scale)
    _check_method(study, compare, method, step, decimals)
    if polygons is not None and method is not MethodChoice.closed:
        remedy = f"leave --method out, or print its table without {POLYGONS}"
        raise UsageError("the plans are those of the exact derivatives", where="--method", remedy=remedy)
    scene = job.spec()
    if not compare:
        check_names(columns, "kinematics", scene)
    return replace(job, settings={"kinematics": _settings(scene, method, step, decimals)}), scene


@of_stage("kinematics", asked=_asked)
def command(
    solved: Solved,
    columns: Columns = None,
    positions: Positions = None,
    dimensionless: Annotated[
        bool, typer.Option("--dimensionless", help="The table in units of the crank length and its speed.")
    ] = False,
    method: Annotated[
        MethodChoice, typer.Option("--method", help="How velocities and accelerations are found.")
    ] = MethodChoice.closed,
    step: Annotated[
        str | None,
        typer.Option(
            "--step",
            metavar="QUANTITY",
            help="Step of --method differences (default: '1.5 deg', or 1/240 of a slider's range).",
        ),
    ] = None,
    decimals: Annotated[
        int | None,
        typer.Option(
            "--decimals",
            metavar="N",
            min=1,
            max=15,
            help="Round positions to N decimals of l_1 before --method differences, as on paper.",
        ),
    ] = None,
    compare: Annotated[
        bool, typer.Option("--compare", help="Print the outputs by --method beside the exact ones, instead.")
    ] = False,
    plan: Annotated[bool, typer.Option("--plan", help="Print the position plan with the strokes, instead.")] = False,
    polygons: Annotated[
        str | None,
        typer.Option(
            "--polygons",
            metavar="LIST",
            help="Print the vectors of the plans of velocities and accelerations of these positions, instead.",
        ),
    ] = None,
    scale: Annotated[
        str | None,
        typer.Option(
            "--scale",
            metavar="LENGTH",
            help="Scale of --polygons: 'crank' or the length of the crank's segments (default: round factors).",
        ),
    ] = None,
    study: Annotated[
        bool, typer.Option("--study", help="Print the error of differences against their step, instead.")
    ] = False,
    output: Annotated[
        str | None,
        typer.Option("--output", metavar="NAME", help="The output of --plan or --study (default: the first)."),
    ] = None,
) -> Document:
    """Kinematics: positions, velocities, accelerations, transfer functions, dead centres, strokes.

    Example: tmmcalc kinematics my.toml --columns 'phi,x_*' --positions 0:12:2

    By name alone: relative velocities of two points of a link (vrel_*), normal, tangential and Coriolis accelerations
    (an_*,at_*,aK_*), special points of groups of class III and IV ('*_W*'), outputs by numerical differentiation
    ('*_differences').
    """
    scene, result, heading = solved.spec, solved.result, solved.title
    if plan:
        from tmmcalc.linkage.facts.plan import plan_document
        from tmmcalc.linkage.plan import position_plan
        from tmmcalc.linkage.tables.tasks.mechanism import to_linkage

        told = position_plan(to_linkage(scene.linkage), result, output)
        return plan_document(told, f"{heading}, position plan", rows_of(positions, told.labels))
    if polygons is not None:
        from tmmcalc.linkage.facts.polygons import polygons_document
        from tmmcalc.linkage.tables.tasks.mechanism import to_linkage

        rows = rows_of(polygons, result.labels, POLYGONS) or []
        heading = f"{heading}, plans of velocities and accelerations"
        return polygons_document(to_linkage(scene.linkage), result, heading, rows, _crank_segment(polygons, scale))
    if study:
        from tmmcalc.linkage.facts.methods import study_document
        from tmmcalc.linkage.tables.tasks.mechanism import to_linkage

        heading = f"{heading}, error of differences"
        return study_document(to_linkage(scene.linkage), result, heading, decimals, output)
    if compare:
        from tmmcalc.linkage.facts.methods import comparison_document
        from tmmcalc.linkage.tables.tasks.mechanism import to_linkage

        return comparison_document(
            to_linkage(scene.linkage),
            result,
            f"{heading}, {method.value} beside the exact values",
            patterns=patterns_of(columns),
            rows=rows_of(positions, result.labels),
            dimensionless=dimensionless,
        )
    patterns = patterns_of(columns)
    return solved.document(
        patterns=patterns,
        rows=rows_of(positions, result.labels),
        dimensionless=dimensionless,
        everything=solved.everything,
        where=solved.where,
        further=_further(solved.run, dimensionless) if patterns else (),
    )


def _further(run: RunResult, dimensionless: bool) -> Sequence[Column]:
    """The columns that are printed by name alone; of the table in units of the crank in these too."""
    from tmmcalc.linkage.stages.kinematics import further

    return further(run.spec, run.results, dimensionless=dimensionless)


def _check_kind(
    plan: bool,
    study: bool,
    compare: bool,
    columns: str | None,
    positions: str | None,
    dimensionless: bool,
    output: str | None,
    polygons: str | None,
) -> None:
    """Refuse flags that would have no effect on the table that is asked for, rather than pass them over."""
    if plan + study + compare + (polygons is not None) > 1:
        where = f"--plan, --study, --compare, {POLYGONS}"
        raise UsageError("print one table each", where=where, remedy="leave all but one of them out")
    if output is not None and not (plan or study):
        remedy = "add --plan or --study, or choose with --columns"
        raise UsageError("only the plan and the study are of one output", where="--output", remedy=remedy)
    given = {
        "--columns": columns is not None,
        "--dimensionless": dimensionless,
        "--positions": positions is not None and not plan,
    }
    in_vain = [flag for flag, there in given.items() if there]
    if (plan or study or polygons is not None) and in_vain:
        where = "--plan" if plan else "--study" if study else POLYGONS
        raise UsageError("prints a table of its own", where=where, remedy=f"leave {' and '.join(in_vain)} out")


def _crank_segment(polygons: str | None, scale: str | None) -> float | None:
    """The length of the crank's segments [mm] that the flags ask for; None: round factors."""
    from tmmcalc.spec.units import UnitError, parse

    if scale is None:
        return None
    if polygons is None:
        raise UsageError("only the plans have a scale", where="--scale", remedy=f"add {POLYGONS} 4,9")
    if scale.strip() == "crank":
        return CRANK
    example = "write --scale crank, or a length such as --scale '40 mm'"
    try:
        length = 1e3 * parse(scale, "length")
    except UnitError as error:
        raise UsageError(error.message, where="--scale", remedy=example) from None
    if not 0 < length < LARGEST:
        said = f"{scale!r} is no length of a segment, which is above 0 and below {LARGEST:g} mm"
        raise UsageError(said, where="--scale", remedy=example)
    return length


def _check_method(study: bool, compare: bool, method: MethodChoice, step: str | None, decimals: int | None) -> None:
    """Refuse flags of a method that is not taken."""
    differences = method is MethodChoice.differences
    if compare and method is MethodChoice.closed:
        remedy = "add --method differences, --method projection or --method splitting"
        raise UsageError("the method is the exact one itself", where="--compare", remedy=remedy)
    if step is not None and not differences:
        raise UsageError("only differences have a step", where="--step", remedy="add --method differences")
    if decimals is not None and not differences and not study:
        remedy = "add --method differences, or --study"
        raise UsageError("only differences are taken of rounded positions", where="--decimals", remedy=remedy)


def _settings(scene: Spec, method: MethodChoice, step: str | None, decimals: int | None) -> dict[str, object]:
    """Options of the stage; the step and the rounding belong to the differences alone."""
    if method is not MethodChoice.differences:
        return {"method": method.value}
    size = 0.0 if step is None else _step(scene, step)
    return {"method": method.value, "step": size, "decimals": decimals or 0}


def _step(scene: Spec, text: str) -> float:
    """The step in the dimension of the input coordinate, above zero."""
    from tmmcalc.spec.units import UnitError, parse

    mechanism = scene.linkage
    drive = next(joint for joint in mechanism.joints if joint.name == mechanism.input.joint)
    try:
        size = parse(text, "angle" if drive.kind == "revolute" else "length")
    except UnitError as error:
        example = "1.5 deg" if drive.kind == "revolute" else "2 mm"
        raise UsageError(error.message, where="--step", remedy=f"write e.g. --step '{example}'") from None
    if not size > 0:
        raise UsageError(f"{text!r} is not above zero", where="--step", remedy="write e.g. --step '1.5 deg'")
    return size
