"""``tmmcalc kinematics``."""

from __future__ import annotations

from dataclasses import replace
from enum import StrEnum
from typing import TYPE_CHECKING, Annotated

import typer

from tmmcalc.cli.options import (
    Csv,
    Depfile,
    Form,
    Format,
    Fresh,
    FromStage,
    Out,
    Quiet,
    Set,
    SpecFile,
    Store,
    Strict,
)
from tmmcalc.cli.work import Job, note_files, show, title
from tmmcalc.errors import UsageError

if TYPE_CHECKING:
    from collections.abc import Sequence

    from tmmcalc.spec import Spec


class MethodChoice(StrEnum):
    """How velocities and accelerations are found."""

    closed = "closed"
    projection = "projection"
    differences = "differences"


def command(
    spec: SpecFile,
    form: Form = Format.table,
    columns: Annotated[
        str | None,
        typer.Option("--columns", metavar="NAMES", help="Columns by name, with wildcards: 'phi,x_*,omega_3'."),
    ] = None,
    positions: Annotated[
        str | None,
        typer.Option("--positions", metavar="LIST", help="Positions to show: '0,6,18' or '0:24:2'."),
    ] = None,
    dimensionless: Annotated[
        bool, typer.Option("--dimensionless", help="In units of the crank length and its speed.")
    ] = False,
    method: Annotated[
        MethodChoice, typer.Option("--method", help="How velocities and accelerations are found.")
    ] = MethodChoice.closed,
    step: Annotated[
        str | None,
        typer.Option("--step", help="Step of --method differences (default: '1.5 deg', or 1/240 of a slider's range)."),
    ] = None,
    decimals: Annotated[
        int | None,
        typer.Option("--decimals", min=1, max=15, help="Round positions before the differences, as on paper."),
    ] = None,
    compare: Annotated[
        bool, typer.Option("--compare", help="Print the outputs by this method beside the exact ones.")
    ] = False,
    study: Annotated[
        bool, typer.Option("--study", help="Print the error of the differences against their step.")
    ] = False,
    out: Out = None,
    store: Store = True,
    fresh: Fresh = False,
    from_stage: FromStage = None,
    csv: Csv = None,
    depfile: Depfile = None,
    strict: Strict = False,
    quiet: Quiet = False,
    overrides: Set = None,
) -> None:
    """Kinematics: positions, velocities, accelerations, transfer functions, dead centres, strokes.

    Example: tmmcalc kinematics configs/shaper.toml --columns 'phi,S_D,omega_3' --positions 0:24:2
    """
    job = Job(spec, out, store, fresh, from_stage, csv, depfile, strict, quiet, overrides or ())
    scene = job.spec()
    job = replace(job, settings={"kinematics": _settings(scene, method, step, decimals)})
    heading = title(scene, spec, "kinematics")
    run = job.run(scene, "kinematics")
    result = run.results["kinematics"]
    job.check_limits([str(grade) for grade in result.grades if grade.severity == "warning"])
    from tmmcalc.report import linkage

    if study or compare:
        from tmmcalc.spec.linkage import to_linkage

        mechanism = to_linkage(scene.mechanism)
        if study:
            show(linkage.study_document(mechanism, result, heading, decimals), form)
        if compare:
            show(linkage.comparison_document(mechanism, result, heading), form)
        return
    document = linkage.kinematics_document(
        result,
        heading,
        patterns=[p.strip() for p in columns.split(",")] if columns else (),
        rows=rows_of(positions, result.labels),
        dimensionless=dimensionless,
        everything=form is not Format.table,
        where=f"{job.folder}/kinematics.csv" if job.folder else "",
    )
    show(document, form)
    note_files(run, quiet)


def _settings(scene: Spec, method: MethodChoice, step: str | None, decimals: int | None) -> dict[str, object]:
    """Options of the stage; the step and the rounding belong to the differences alone."""
    if method is not MethodChoice.differences:
        return {"method": method.value}
    size = 0.0 if step is None else _step(scene, step)
    return {"method": method.value, "step": size, "decimals": decimals or 0}


def _step(scene: Spec, text: str) -> float:
    """The step in the dimension of the input coordinate, above zero."""
    from tmmcalc.spec.units import UnitError, parse

    drive = next(joint for joint in scene.mechanism.joints if joint.name == scene.mechanism.input.joint)
    try:
        size = parse(text, "angle" if drive.kind == "revolute" else "length")
    except UnitError as error:
        raise UsageError(error.message, where="--step", remedy=error.remedy) from None
    if not size > 0:
        raise UsageError(f"{text!r} is not above zero", where="--step", remedy="write e.g. --step '1.5 deg'")
    return size


def rows_of(positions: str | None, labels: Sequence[str]) -> list[int] | None:
    """Indices of the positions asked for, by label or as slices of indices."""
    if positions is None:
        return None
    rows: list[int] = []
    for part in (p.strip() for p in positions.split(",")):
        if part in labels:
            rows.append(labels.index(part))
            continue
        pieces = part.split(":")
        if not 2 <= len(pieces) <= 3 or not all(p.strip().lstrip("-").isdigit() or not p.strip() for p in pieces):
            raise UsageError(
                f"no position is called {part!r}",
                where="--positions",
                remedy=f"positions are {labels[0]} to {labels[-1]}; write '0,6,18' or a range '0:24:2'",
            )
        start, stop, *rest = (int(p) if p.strip() else None for p in pieces)
        stride = rest[0] if rest else None
        if stride == 0:
            raise UsageError(f"{part!r} has a step of 0", where="--positions", remedy="write e.g. '0:24:2'")
        rows += range(*slice(start, None if stop is None else stop + 1, stride).indices(len(labels)))
    return rows
