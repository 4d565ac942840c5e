"""``tmmcalc plot``."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from tmmcalc.cli.drawings import CHOOSE, DRAWINGS, PHASE, POLYGONS, POSITIONS, Order, drawing_of
from tmmcalc.cli.messages import note_written
from tmmcalc.cli.options import Quiet, Set, SpecFile
from tmmcalc.cli.work import Job, check_place


def command(
    spec: SpecFile,
    stage: Annotated[
        str, typer.Argument(help=f"Stage to draw: {', '.join(DRAWINGS)}.", metavar="STAGE")
    ] = "kinematics",
    out: Annotated[
        Path | None,
        typer.Option(
            "-o",
            "--out",
            metavar="FILE",
            help="Picture, by suffix svg, png or pdf (default: <spec>.svg).",
            show_default=False,
        ),
    ] = None,
    positions: Annotated[
        str | None,
        typer.Option(POSITIONS, metavar="LIST", help="Positions of the scheme, the first bold: '7,0:24:2'."),
    ] = None,
    polygons: Annotated[
        str | None,
        typer.Option(POLYGONS, metavar="POSITION", help="Add the polygons of velocities, or of forces, there."),
    ] = None,
    choose: Annotated[
        int | None,
        typer.Option(
            CHOOSE,
            metavar="N",
            min=1,
            help="Train or pair to draw, from 1: of train set N as gears synth lists them, of criteria row N of "
            "criteria.csv, of synthesis solution N, of pair, blocking and profile pair N (default: all).",
            show_default=False,
        ),
    ] = None,
    phase: Annotated[
        str | None,
        typer.Option(
            PHASE,
            metavar="ANGLE",
            help="Turn of the pinion from the contact at P, of indexing cams from the step: '10 deg'.",
        ),
    ] = None,
    quiet: Quiet = False,
    overrides: Set = None,
) -> None:
    """Draw the result of a stage.

    synthesis: the linkage found in its extreme positions with dimensions, or at its points with the coupler curve.
    kinematics: the scheme in its positions, paths of points, diagrams of the outputs; with --polygons velocities and
    accelerations. forces: reactions, hodographs, drive; with --polygons load diagrams and force polygons.
    reduction: reduced moments and inertia. flywheel: energy-mass curve with its tangents, work over the cycle, all
    methods. motion: speed and moments over the cycle, the motor's characteristic. transient: speeds and moments over
    the time. unsteady: input, outputs and links over the time. manipulator: the path with points equally spaced in
    time, the arm, obstacles, the joints. balance: hodographs of the shaking force, what the schemes leave of it, an
    engine's force and couple.
    train: a tooth set to scale from the side and from the end, all sets by size and error, what the constraints
    removed, curves of ratio, efficiency and module ratio. criteria: inertia against mass with the Pareto front, pairs
    of criteria, the chosen train to scale. pair: teeth in mesh with the line of action, sliding and pressure along it.
    blocking: the blocking contour with its numbered lines and points. profile: how the rack cuts the teeth, each tooth
    enlarged. cam_law: displacement and its derivatives over the turn. cam_synthesis: the admissible places of the
    cam's axis. cam_profile: the cam to scale, its curvature. cam_pressure: the pressure angle. cam_forces: spring,
    reactions, torque. cam_strength: slip and contact stress. cam_optimum: the blocking contour. cam_elastic: the
    follower's vibration over the turn, what the laws leave of it. indexing: the scheme at --phase from the
    beginning of a step, pressure angles, tip of the lobe, efficiency, what lambda and the step decide.
    feasibility: the margin of every constraint, and the rule.
    vibrator: modes, resonance curve, starts, paths of points. pendulum: mode shapes, Campbell diagram, path of the end.
    The stage is computed afresh; no stage files are read or written.

    Example: tmmcalc plot my.toml kinematics -o my.svg --polygons 6
    """
    flags = {POSITIONS: positions, POLYGONS: polygons, CHOOSE: None if choose is None else str(choose), PHASE: phase}
    drawing = drawing_of(stage, flags)
    file = out or Path(f"{spec.stem}.svg")
    check_place(file, "plot")
    job = Job(spec, store=False, quiet=True, overrides=overrides or ())
    scene = job.spec()
    drawing.draw(Order(scene, job.run(scene, stage).results, file, flags))
    if not quiet:
        note_written(file)
