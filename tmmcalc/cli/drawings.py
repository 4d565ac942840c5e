"""The pictures that ``tmmcalc plot`` can draw: one function a stage, what it shows, and the flags that are its own."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any, NamedTuple

from tmmcalc.cli.order import CHOOSE, PHASE, POLYGONS, POSITIONS, Order
from tmmcalc.core.errors import UsageError
from tmmcalc.core.stage import resolve

if TYPE_CHECKING:
    from tmmcalc.project import Spec


class Drawing(NamedTuple):
    """The picture of a stage: what it shows, what draws it, and its own flags."""

    shows: str
    draw: Callable[[Order], None]
    flags: tuple[str, ...] = ()


def _result(stage: str, drawer: str, *, named: bool = False) -> Callable[[Order], None]:
    """What draws the result of a stage alone, with ``drawer``, a ``"module:function"`` of the pictures.

    ``named``: the function draws several stages and is told which.
    """

    def draw(order: Order) -> None:
        told = (stage,) if named else ()
        resolve(f"tmmcalc.{drawer}")(*told, order.results[stage], order.file)

    return draw


def _kinematics(order: Order) -> None:
    from tmmcalc.linkage.tables.tasks.mechanism import to_linkage
    from tmmcalc.report.drawing import draw_kinematics

    result = order.results["kinematics"]
    chosen, marked = order.rows(POSITIONS, result.labels), order.row(POLYGONS, result.labels)
    mechanism = to_linkage(order.spec.linkage)
    draw_kinematics(mechanism, result, order.file, positions=chosen, polygons=marked)


def _forces(order: Order) -> None:
    from tmmcalc.linkage.tables.tasks.loading import to_loading
    from tmmcalc.linkage.tables.tasks.mechanism import to_linkage
    from tmmcalc.report.drawing import draw_forces

    result = order.results["forces"]
    marked = order.row(POLYGONS, result.labels)
    mechanism, loading = to_linkage(order.spec.linkage), to_loading(order.spec)
    draw_forces(mechanism, loading, order.results["kinematics"], result, order.file, polygons=marked)


def _flywheel(order: Order) -> None:
    from tmmcalc.report.drawing import draw_flywheel

    draw_flywheel(order.results["flywheel"], order.results["reduction"].phi, order.file)


def _motion(order: Order) -> None:
    from tmmcalc.report.drawing import draw_motion

    results = order.results
    draw_motion(results["motion"], results["power"], results["reduction"], order.file)


def _unsteady(order: Order) -> None:
    from tmmcalc.linkage.tables.tasks.mechanism import to_linkage
    from tmmcalc.linkage.tables.tasks.unsteady import to_unsteady
    from tmmcalc.report.drawing import draw_unsteady

    mechanism, task = to_linkage(order.spec.linkage), to_unsteady(order.spec)
    draw_unsteady(mechanism, task, order.results["kinematics"], order.results["unsteady"], order.file)


def _manipulator(order: Order) -> None:
    from tmmcalc.manipulators.tables.tasks.manipulator import to_manipulator
    from tmmcalc.report.drawing import draw_manipulator

    draw_manipulator(to_manipulator(order.spec), order.results["manipulator"], order.file)


def _train(order: Order) -> None:
    from tmmcalc.report.drawing import draw_train

    choose = order.choice
    draw_train(order.results["train"], order.file, choose=1 if choose is None else choose)


def _criteria(order: Order) -> None:
    from tmmcalc.report.drawing import draw_criteria

    draw_criteria(order.results["criteria"], order.results["train"], order.file, choose=order.choice)


def _pair(order: Order) -> None:
    from tmmcalc.report.drawing import draw_pair

    draw_pair(order.results["pair"], order.file, choose=order.choice, phase=order.angle(PHASE))


def _blocking(order: Order) -> None:
    from tmmcalc.report.drawing import draw_blocking

    draw_blocking(order.results["blocking"], order.file, choose=order.choice)


def _profile(order: Order) -> None:
    from tmmcalc.report.drawing import draw_profile

    draw_profile(order.results["pair"], order.file, choose=order.choice)


def _cam(stage: str) -> Callable[[Order], None]:
    """What draws a stage of the cam."""

    def draw(order: Order) -> None:
        from tmmcalc.cams.pictures import draw_cam
        from tmmcalc.cams.stages.parts import at_speed
        from tmmcalc.cams.tables.tasks.cam import to_cam

        task = at_speed(to_cam(order.spec), order.results.get("motion"))
        draw_cam(stage, task, order.results[stage], order.file)

    return draw


def _indexing(order: Order) -> None:
    from tmmcalc.cams.pictures import draw_indexing
    from tmmcalc.cams.tables.tasks.indexing import to_indexing

    draw_indexing(to_indexing(order.spec), order.results["indexing"], order.file, order.angle(PHASE))


def _synthesis(order: Order) -> None:
    from tmmcalc.linkage.pictures.synthesis import draw_synthesis
    from tmmcalc.linkage.tables.tasks.mechanism import to_linkage
    from tmmcalc.project import parse_spec

    result = order.results["synthesis"]
    choose = order.choice or _first_feasible(order.spec, result)
    if choose > len(result.designs):
        raise UsageError(f"there is no solution {choose}", where=CHOOSE, remedy=f"write 1 to {len(result.designs)}")
    mechanism = to_linkage(parse_spec(result.designs[choose - 1].spec).linkage)
    if result.designs[choose - 1].dwell is not None:
        from tmmcalc.linkage.pictures.dwell import draw_dwell

        draw_dwell(mechanism, result, order.file, choose=choose)
        return
    draw_synthesis(mechanism, result, order.file, choose=choose)


def _first_feasible(spec: Spec, synthesis: Any) -> int:
    """The number of the solution that ``tmmcalc synth`` chooses."""
    if not spec.constraints:
        return 1
    from tmmcalc.feasibility.stages.feasibility import inputs, solve

    return solve(inputs(spec), {"synthesis": synthesis}, {}).chosen


DRAWINGS = {
    "kinematics": Drawing(
        f"scheme in its positions, paths of points, diagrams of the outputs; with {POLYGONS} velocities, accelerations",
        _kinematics,
        (POSITIONS, POLYGONS),
    ),
    "forces": Drawing(
        f"reactions, hodographs, drive; with {POLYGONS} load diagrams and force polygons", _forces, (POLYGONS,)
    ),
    "reduction": Drawing("reduced moments and inertia", _result("reduction", "report.drawing:draw_reduction")),
    "synthesis": Drawing(
        "the linkage found in its extreme positions with dimensions, or at its points with the coupler curve",
        _synthesis,
        (CHOOSE,),
    ),
    "flywheel": Drawing("energy-mass curve with its tangents, work over the cycle, all methods", _flywheel),
    "motion": Drawing("speed and moments over the cycle, the motor's characteristic", _motion),
    "transient": Drawing("speeds and moments over the time", _result("transient", "report.drawing:draw_transient")),
    "unsteady": Drawing("input, outputs and links over the time", _unsteady),
    "manipulator": Drawing("the path with points equally spaced in time, the arm, obstacles, the joints", _manipulator),
    "balance": Drawing(
        "hodographs of the shaking force, what the schemes leave of it, an engine's force and couple",
        _result("balance", "report.drawing:draw_balance"),
    ),
    "train": Drawing(
        "a tooth set to scale from two sides, all sets by size and error, what constraints removed, curves of choice",
        _train,
        (CHOOSE,),
    ),
    "criteria": Drawing(
        "inertia against mass with the Pareto front, pairs of criteria, the chosen train to scale",
        _criteria,
        (CHOOSE,),
    ),
    "pair": Drawing("teeth in mesh with the line of action, sliding and pressure along it", _pair, (CHOOSE, PHASE)),
    "blocking": Drawing("the blocking contour with its numbered lines and points", _blocking, (CHOOSE,)),
    "profile": Drawing("how the rack cuts the teeth, each tooth enlarged", _profile, (CHOOSE,)),
    "cam_law": Drawing("displacement and its derivatives over the turn", _cam("cam_law")),
    "cam_synthesis": Drawing("the admissible places of the cam's axis", _cam("cam_synthesis")),
    "cam_profile": Drawing("the cam to scale, its curvature", _cam("cam_profile")),
    "cam_pressure": Drawing("the pressure angle over the turn", _cam("cam_pressure")),
    "cam_forces": Drawing("spring, reactions, torque", _cam("cam_forces")),
    "cam_strength": Drawing("slip and contact stress", _cam("cam_strength")),
    "cam_optimum": Drawing("the blocking contour", _cam("cam_optimum")),
    "cam_elastic": Drawing("the follower's vibration over the turn, what the laws leave of it", _cam("cam_elastic")),
    "vibrator": Drawing(
        "modes, resonance curve, starts, paths of points",
        _result("vibrator", "vibration.pictures.draw:draw_vibration", named=True),
    ),
    "pendulum": Drawing(
        "mode shapes, Campbell diagram, path of the end",
        _result("pendulum", "vibration.pictures.draw:draw_vibration", named=True),
    ),
    "indexing": Drawing(
        f"scheme at {PHASE} of a step, pressure angles, tip of the lobe, efficiency, what lambda and the step decide",
        _indexing,
        (PHASE,),
    ),
    "contact": Drawing(
        "the field of pressure, and along the axis of x beside Hertz",
        _result("contact", "extras.pictures.extras:draw_extra", named=True),
    ),
    "reliability": Drawing(
        "reliability and density of failures over the time",
        _result("reliability", "extras.pictures.extras:draw_extra", named=True),
    ),
    "falling_ball": Drawing(
        "speed and way of the ball over the time",
        _result("falling_ball", "extras.pictures.extras:draw_extra", named=True),
    ),
    "feasibility": Drawing(
        "the margin of every constraint, and the rule",
        _result("feasibility", "feasibility.pictures.feasibility:draw_feasibility"),
    ),
}


def drawing_of(stage: str, flags: Mapping[str, str | None]) -> Drawing:
    """The picture of a stage; raises `UsageError` for a stage without one, and for flags that are not its own."""
    if stage not in DRAWINGS:
        raise UsageError(f"there is no picture of {stage!r}", where="plot", remedy=f"pictures: {', '.join(DRAWINGS)}")
    drawing = DRAWINGS[stage]
    strange = [flag for flag, value in flags.items() if value is not None and flag not in drawing.flags]
    if strange:
        own = f"its own flags: {', '.join(drawing.flags)}" if drawing.flags else "it has no flags of its own"
        raise UsageError(
            f"{' and '.join(strange)} cannot be used with the picture of {stage}", where="plot", remedy=own
        )
    return drawing
