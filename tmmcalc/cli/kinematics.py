"""``tmmcalc kinematics``."""

from __future__ import annotations

from dataclasses import replace
from enum import StrEnum
from typing import TYPE_CHECKING, Annotated

import typer

from tmmcalc.cli.job import Job, with_flags
from tmmcalc.cli.options import Columns, Form, Format, Positions, patterns_of
from tmmcalc.cli.output import title
from tmmcalc.core.errors import UsageError
from tmmcalc.report.rows import rows_of

if TYPE_CHECKING:
    from tmmcalc.linkage.results import Kinematics
    from tmmcalc.project import Spec
    from tmmcalc.report.document import Document


class MethodChoice(StrEnum):
    """How velocities and accelerations are found; by splitting, positions of groups of class III and IV too."""

    closed = "closed"
    projection = "projection"
    differences = "differences"
    splitting = "splitting"


@with_flags
def command(
    job: Job,
    form: Form = Format.table,
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
    study: Annotated[
        bool, typer.Option("--study", help="Print the error of differences against their step, instead.")
    ] = False,
) -> None:
    """Kinematics: positions, velocities, accelerations, transfer functions, dead centres, strokes.

    Example: tmmcalc kinematics my.toml --columns 'phi,x_*' --positions 0:12:2
    """
    _check_plan(plan, study or compare, columns, positions, dimensionless)
    _check_flags(study, compare, method, step, decimals, columns, positions, dimensionless)
    scene = job.spec()
    job = replace(job, settings={"kinematics": _settings(scene, method, step, decimals)})
    heading = title(scene, job.file, "kinematics")
    run = job.run(scene, "kinematics")
    result = run.results["kinematics"]
    if plan:
        from tmmcalc.linkage.facts.plan import plan_document
        from tmmcalc.linkage.plan import position_plan
        from tmmcalc.linkage.tables.tasks.mechanism import to_linkage

        document = plan_document(position_plan(to_linkage(scene.linkage), result), f"{heading}, position plan")
    elif study or compare:
        document = _methods_document(scene, result, heading, method, decimals, study)
    else:
        from tmmcalc.linkage.facts.kinematics import document as kinematics_document

        document = kinematics_document(
            result,
            heading,
            patterns=patterns_of(columns),
            rows=rows_of(positions, result.labels),
            dimensionless=dimensionless,
            everything=form is not Format.table,
            where=next((str(file) for file in run.files if file.name == "kinematics.csv"), ""),
        )
    job.finish(document, run, form)


def _methods_document(
    scene: Spec, result: Kinematics, heading: str, method: MethodChoice, decimals: int | None, study: bool
) -> Document:
    """What --study or --compare prints instead of the table of positions."""
    from tmmcalc.linkage.facts.methods import comparison_document, study_document
    from tmmcalc.linkage.tables.tasks.mechanism import to_linkage

    mechanism = to_linkage(scene.linkage)
    if study:
        return study_document(mechanism, result, f"{heading}, error of differences", decimals)
    return comparison_document(mechanism, result, f"{heading}, {method.value} beside the exact values")


def _check_plan(plan: bool, other: bool, columns: str | None, positions: str | None, dimensionless: bool) -> None:
    """Refuse what the position plan does not go together with."""
    if plan and (other or columns is not None or positions is not None or dimensionless):
        raise UsageError(
            "prints a table of its own",
            where="--plan",
            remedy="leave --study, --compare, --columns, --positions and --dimensionless out",
        )


def _check_flags(
    study: bool,
    compare: bool,
    method: MethodChoice,
    step: str | None,
    decimals: int | None,
    columns: str | None,
    positions: str | None,
    dimensionless: bool,
) -> None:
    """Refuse flags that would have no effect together, rather than pass them over."""
    differences = method is MethodChoice.differences
    if study and compare:
        raise UsageError("print one table each", where="--study, --compare", remedy="leave one of them out")
    if compare and method is MethodChoice.closed:
        remedy = "add --method differences, --method projection or --method splitting"
        raise UsageError("the method is the exact one itself", where="--compare", remedy=remedy)
    if step is not None and not differences:
        raise UsageError("only differences have a step", where="--step", remedy="add --method differences")
    if decimals is not None and not differences and not study:
        remedy = "add --method differences, or --study"
        raise UsageError("only differences are taken of rounded positions", where="--decimals", remedy=remedy)
    if (study or compare) and (columns is not None or positions is not None or dimensionless):
        raise UsageError(
            "print a table of their own",
            where="--study, --compare",
            remedy="leave --columns, --positions and --dimensionless out",
        )


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
