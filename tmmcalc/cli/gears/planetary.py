"""``tmmcalc gears planetary``."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Annotated, NamedTuple

import typer

from tmmcalc.cli.gears.known import Row, of_row
from tmmcalc.cli.job import Job, with_flags
from tmmcalc.cli.options import Form, Format
from tmmcalc.cli.output import show, title
from tmmcalc.core.errors import UsageError

if TYPE_CHECKING:
    from tmmcalc.gears.facts.planetary import ChosenTrain
    from tmmcalc.pipeline.outcome import RunResult
    from tmmcalc.project import Spec
    from tmmcalc.report.document import Document

SOURCES = {
    "given": "as [strength] gives it",
    "moment": "of the moment that [strength] gives",
    "reduction": "of the largest reduced moment of the machine",
}


class Asked(NamedTuple):
    """What is printed in place of the motion of a train."""

    conditions: bool
    willis: bool
    plans: bool


@with_flags
def command(
    job: Job,
    form: Form = Format.table,
    choose: Row = None,
    power: Annotated[bool, typer.Option("--power/--kinematic", help="Of a [train]: what the drive is for.")] = True,
    internal: Annotated[
        bool, typer.Option("--internal/--external", help="Of a [train]: whether internal wheels can be cut.")
    ] = True,
    conditions: Annotated[
        bool, typer.Option("--conditions", help="Instead: every condition of the teeth with both its sides.")
    ] = False,
    willis: Annotated[
        bool, typer.Option("--willis", help="Instead: Willis' equation of every carrier with its numbers.")
    ] = False,
    plans: Annotated[
        bool, typer.Option("--plans", help="Instead: plan of velocities and plan of speeds, to scale.")
    ] = False,
) -> None:
    """Any train: exact ratios, speeds, torques, power flow, efficiency both ways.

    Of a [gearing] all of it. Of a [train] the types that suit its ratio, how many planets go in, and the motion of
    the one that gears compare chooses, at the speed of its motor and under the torque of its teeth; without [strength]
    of one of its tooth sets, the first if none is asked for.

    Example: tmmcalc gears planetary my.toml --choose 2
    """
    scene = job.spec()
    if scene.gearing is None and scene.train is None:
        raise UsageError(
            "the spec has neither [gearing] nor [train]",
            where="gears planetary",
            remedy="write the train out in [gearing], or ask for tooth numbers in [train]",
        )
    if scene.gearing is not None:
        run = job.run(scene, "gearing")
    else:
        job, scene = of_row(job, scene, choose)
        run = job.run(scene, _target(scene))
    heading = title(scene, job.file, "gears")
    if conditions or willis or plans:
        asked = Asked(conditions, willis, plans)
        document = _by_choice(run, scene, heading, choose, asked, form is not Format.table)
        show(document, form)  # without the errors of the stage, which are of other numbers
        job.close(document, run)
        return
    job.finish(_printed(run, scene, heading, choose, power, internal, form), run, form)


def _target(scene: Spec) -> str:
    """The stage that tells most of the train: the motor that drives it, its choice, or its tooth sets alone."""
    from tmmcalc.core.plan import plan

    running = plan(scene).running
    wanted = ("power", "criteria") if scene.motor is not None else ("criteria",)
    return next((stage for stage in wanted if stage in running and "criteria" in running), "train")


def _printed(
    run: RunResult, scene: Spec, heading: str, choose: int | None, power: bool, internal: bool, form: Format
) -> Document:
    if scene.gearing is not None:
        from tmmcalc.gears.facts.gearing import document as gearing_document

        return gearing_document(run.results["gearing"], heading, everything=form is not Format.table)
    from tmmcalc.gears.facts.planetary import planetary_document

    assert scene.train is not None
    chosen = _chosen(run, scene) if "criteria" in run.outcomes else None
    asked = {"power": power, "internal": internal, "everything": form is not Format.table}
    speed = scene.train.input_speed
    return planetary_document(run.results["train"], heading, speed, choose=choose or 1, chosen=chosen, **asked)


def _by_choice(
    run: RunResult, scene: Spec, heading: str, choose: int | None, asked: Asked, everything: bool
) -> Document:
    """Conditions, Willis' equations and plans of every train that the command tells of, several as parts."""
    from tmmcalc.gears.chosen.conditions import conditions
    from tmmcalc.gears.chosen.motion import equations, plans_of
    from tmmcalc.gears.details import trains_in_motion
    from tmmcalc.gears.facts.chosen import conditions_document, plans_document, willis_document
    from tmmcalc.report.document import Document

    parts = []
    for named, found in trains_in_motion(scene, run.results, choose or 1):
        if asked.conditions:
            if found.chosen is None:
                raise UsageError(
                    "of a train that is written out mesh by mesh no conditions are known",
                    where="--conditions",
                    remedy="name its layout in [gearing], or leave the flag out",
                )
            parts.append(conditions_document(conditions(found.chosen), f"{named}: conditions", everything=everything))
        remarks = tuple(f"note: {remark}" for remark in found.remarks)
        if asked.willis:
            told = willis_document(equations(found), f"{named}: Willis' equations", everything=everything)
            parts.append(replace(told, notes=(*told.notes, *remarks)))
        if asked.plans:
            told = plans_document(plans_of(found), f"{named}: plans", everything=everything)
            parts.append(replace(told, notes=(*told.notes, *remarks)))
    if len(parts) == 1:
        return replace(parts[0], title=f"{heading}, {parts[0].title}")
    return Document(heading, parts=tuple(parts))


def _chosen(run: RunResult, scene: Spec) -> ChosenTrain:
    """The train that was chosen, with the torque that its teeth are sized for and the speed of its motor."""
    from tmmcalc.gears.facts.planetary import ChosenTrain
    from tmmcalc.gears.tables.tasks.sizing import to_selection

    assert scene.train is not None
    selection, duty = run.results["criteria"], run.results["power"].duty if "power" in run.outcomes else None
    torque = run.results["strength"].variants[selection.winner.variant].torque
    source = SOURCES[torque.source]
    speed, driven = scene.train.input_speed, "at input_speed"
    if duty is not None:
        speed, driven = duty.motor.speed, f"at the rated {duty.motor.rated_rpm:.6g} rpm of motor {duty.motor.name}"
    meshes = to_selection(scene).meshes
    return ChosenTrain(selection, meshes, torque.value, source, speed, driven if speed is not None else "")
