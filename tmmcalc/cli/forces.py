"""``tmmcalc forces``."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Annotated

import typer

from tmmcalc.cli.job import Job, of_stage
from tmmcalc.cli.makers import check_names, positions_document
from tmmcalc.cli.options import Columns, Positions
from tmmcalc.cli.output import Solved
from tmmcalc.core.errors import UsageError
from tmmcalc.report.document import Document
from tmmcalc.report.rows import rows_of

if TYPE_CHECKING:
    from tmmcalc.linkage.forces.kinetostatics import Statics
    from tmmcalc.linkage.forces.results import Forces
    from tmmcalc.linkage.results import Kinematics
    from tmmcalc.project import Spec

ITERATIONS, STOP, BODIES, LEVER = "--iterations", "--stop", "--bodies", "--lever"
EXAMPLE = f"write e.g. {ITERATIONS} 'RRP(2,3)@6', or '...@67.5 deg'"


def _asked(
    job: Job,
    columns: str | None,
    positions: str | None,
    iterations: str | None,
    bodies: str | None,
    lever: str | None,
    stop: float | None,
) -> tuple[Job, Spec]:
    _check_flags({ITERATIONS: iterations, BODIES: bodies, LEVER: lever}, stop, columns, positions)
    scene = job.spec()
    check_names(columns, "forces", scene)
    return job, scene


@of_stage("forces", asked=_asked)
def command(
    solved: Solved,
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
    bodies: Annotated[
        str | None,
        typer.Option(
            BODIES,
            metavar="LIST",
            help="Print all that acts on every link in these positions, with the terms of its moments, instead.",
        ),
    ] = None,
    lever: Annotated[
        str | None,
        typer.Option(LEVER, metavar="LIST", help="Print Zhukovsky's lever of these positions, instead."),
    ] = None,
    stop: Annotated[
        float | None,
        typer.Option(STOP, metavar="PART", help="Relative change at which the passes end (default: 0.03)."),
    ] = None,
) -> Document:
    """Forces: reactions in all pairs, with friction where the pairs have it, and what the drive must apply.

    Example: tmmcalc forces my.toml --columns 'phi,M_drive,R_*' --positions 0:12:2

    By name alone: loads of inertia (Pi_*,Mi_*), parts of reactions in outer pins (RN_*,RT_*), arms (h_*), directions
    (angle_R_*), all without friction (R0_*,RN0_*,RT0_*,N0_*,M0_drive), the drive by Zhukovsky's lever (M_drive_lever),
    friction of each pair: reduced moment, power, work (M_red_fr_*,P_fr_*,A_fr_*); by force its size, arm and moment on
    the lever (lever_F_*,lever_h_*,lever_M_*) and in the equations of link 3 (eq_3_F_*,eq_3_h_*,eq_3_M_*).
    """
    scene, result, heading = solved.spec, solved.result, solved.title
    if iterations is not None:
        return _iterations(scene, solved.run.results["kinematics"], result, heading, iterations, stop)
    if bodies is not None:
        from tmmcalc.linkage.facts.bodies import bodies_document

        statics = _statics(scene, solved.run.results["kinematics"])
        rows = rows_of(bodies, result.labels, BODIES) or []
        return bodies_document(statics, result, f"{heading}, links by themselves", rows)
    if lever is not None:
        from tmmcalc.linkage.facts.lever import lever_document

        kinematics = solved.run.results["kinematics"]
        rows = rows_of(lever, result.labels, LEVER) or []
        heading = f"{heading}, Zhukovsky's lever"
        return lever_document(_statics(scene, kinematics), kinematics, result, heading, rows)
    return positions_document(solved, columns, positions)


def _check_flags(
    tables: Mapping[str, str | None], stop: float | None, columns: str | None, positions: str | None
) -> None:
    """Refuse flags that would have no effect together, rather than pass them over."""
    asked = [flag for flag, given in tables.items() if given is not None]
    if stop is not None and ITERATIONS not in asked:
        raise UsageError("only the textbook's passes are stopped by it", where=STOP, remedy=f"add {ITERATIONS}")
    if stop is not None and not 0 < stop < 1:
        raise UsageError(f"{stop:g} is not between 0 and 1", where=STOP, remedy="write e.g. --stop 0.001")
    if len(asked) > 1:
        where = ", ".join(asked)
        raise UsageError("print one table each", where=where, remedy="leave all but one of them out")
    if asked and (columns is not None or positions is not None):
        remedy = "leave --columns and --positions out"
        raise UsageError("prints a table of its own", where=asked[0], remedy=remedy)


def _statics(scene: Spec, kinematics: Kinematics) -> Statics:
    """The force analysis of the scene, to be asked at single places."""
    from tmmcalc.linkage.forces.kinetostatics import compile_statics
    from tmmcalc.linkage.loads.scene import compile_scene
    from tmmcalc.linkage.tables.tasks.loading import to_loading
    from tmmcalc.linkage.tables.tasks.mechanism import to_linkage

    return compile_statics(compile_scene(to_linkage(scene.linkage), to_loading(scene), kinematics))


def _iterations(
    scene: Spec, kinematics: Kinematics, result: Forces, heading: str, text: str, stop: float | None
) -> Document:
    """The passes of the group and at the place that the flag names."""
    from tmmcalc.linkage.facts.iteration import iteration_document
    from tmmcalc.linkage.forces.iteration import STOP as USUAL
    from tmmcalc.linkage.forces.iteration import textbook_iteration

    group, sign, where = text.rpartition("@")
    if not sign:
        raise UsageError(f"{text!r} names no group and position", where=ITERATIONS, remedy=EXAMPLE)
    theta, side, place = _place(result, where.strip())
    statics = _statics(scene, kinematics)
    stop = USUAL if stop is None else stop
    found = textbook_iteration(statics, group.strip(), theta, side, stop)
    return iteration_document(found, f"{heading}, friction by passes at {place}", stop)


def _place(result: Forces, where: str) -> tuple[float, float, str]:
    """theta of a position or of a distance along the motion, the side that it is seen from, and how it is called."""
    if where in result.labels:
        from tmmcalc.linkage.forces.results import side_of

        row = result.labels.index(where)
        return float(result.theta[row]), side_of(result, row), f"position {where}"
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
