"""The pictures that ``tmmcalc plot`` can draw: one function a stage, and the flags that are its own."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from tmmcalc.cli.work import within_turns
from tmmcalc.errors import UsageError

if TYPE_CHECKING:
    from tmmcalc.spec import Spec

POSITIONS, POLYGONS, CHOOSE, PHASE = "--positions", "--polygons", "--choose", "--phase"


class Order(NamedTuple):
    """What is to be drawn: the spec, the results of its stages, the picture's file, the flags as they were given."""

    spec: Spec
    results: Mapping[str, Any]
    file: Path
    flags: Mapping[str, str | None]

    def rows(self, flag: str, labels: Sequence[str]) -> list[int] | None:
        """Indices of the positions that a flag names."""
        from tmmcalc.cli.positions import rows_of

        return rows_of(self.flags[flag], labels, flag)

    def row(self, flag: str, labels: Sequence[str]) -> int | None:
        """The index of the one position that a flag names."""
        rows = self.rows(flag, labels)
        if rows is not None and len(rows) > 1:
            said = f"{self.flags[flag]!r} names {len(rows)} positions"
            raise UsageError(said, where=flag, remedy="name one of them")
        return rows[0] if rows else None

    def angle(self, flag: str) -> float:
        """The angle [rad] that a flag gives, 0 without it."""
        from tmmcalc.spec.units import UnitError, parse

        said = self.flags.get(flag)
        try:
            angle = 0.0 if said is None else parse(said, "angle")
        except UnitError as fault:
            raise UsageError(fault.message, where=flag, remedy=fault.remedy) from None
        return within_turns(angle, flag)

    @property
    def choice(self) -> int | None:
        """The number that --choose gives."""
        said = self.flags.get(CHOOSE)
        return None if said is None else int(said)


class Drawing(NamedTuple):
    """The picture of a stage: what draws it, and its own flags."""

    draw: Callable[[Order], None]
    flags: tuple[str, ...] = ()


def _kinematics(order: Order) -> None:
    from tmmcalc.report.pictures import draw_kinematics
    from tmmcalc.spec.linkage import to_linkage

    result = order.results["kinematics"]
    chosen, marked = order.rows(POSITIONS, result.labels), order.row(POLYGONS, result.labels)
    mechanism = to_linkage(order.spec.linkage)
    draw_kinematics(mechanism, result, order.file, positions=chosen, polygons=marked)


def _forces(order: Order) -> None:
    from tmmcalc.report.pictures import draw_forces
    from tmmcalc.spec.linkage import to_linkage
    from tmmcalc.spec.loading import to_loading

    result = order.results["forces"]
    marked = order.row(POLYGONS, result.labels)
    mechanism, loading = to_linkage(order.spec.linkage), to_loading(order.spec)
    draw_forces(mechanism, loading, order.results["kinematics"], result, order.file, polygons=marked)


def _reduction(order: Order) -> None:
    from tmmcalc.report.pictures import draw_reduction

    draw_reduction(order.results["reduction"], order.file)


def _flywheel(order: Order) -> None:
    from tmmcalc.report.pictures import draw_flywheel

    draw_flywheel(order.results["flywheel"], order.results["reduction"].phi, order.file)


def _motion(order: Order) -> None:
    from tmmcalc.report.pictures import draw_motion

    results = order.results
    draw_motion(results["motion"], results["power"], results["reduction"], order.file)


def _transient(order: Order) -> None:
    from tmmcalc.report.pictures import draw_transient

    draw_transient(order.results["transient"], order.file)


def _unsteady(order: Order) -> None:
    from tmmcalc.report.pictures import draw_unsteady
    from tmmcalc.spec.linkage import to_linkage
    from tmmcalc.spec.unsteadiness import to_unsteady

    mechanism, task = to_linkage(order.spec.linkage), to_unsteady(order.spec)
    draw_unsteady(mechanism, task, order.results["kinematics"], order.results["unsteady"], order.file)


def _manipulator(order: Order) -> None:
    from tmmcalc.report.pictures import draw_manipulator
    from tmmcalc.spec.manipulators import to_manipulator

    draw_manipulator(to_manipulator(order.spec), order.results["manipulator"], order.file)


def _balance(order: Order) -> None:
    from tmmcalc.report.pictures import draw_balance

    draw_balance(order.results["balance"], order.file)


def _train(order: Order) -> None:
    from tmmcalc.report.pictures import draw_train

    choose = order.choice
    draw_train(order.results["train"], order.file, choose=1 if choose is None else choose)


def _criteria(order: Order) -> None:
    from tmmcalc.report.pictures import draw_criteria

    draw_criteria(order.results["criteria"], order.results["train"], order.file, choose=order.choice)


def _pair(order: Order) -> None:
    from tmmcalc.report.pictures import draw_pair

    draw_pair(order.results["pair"], order.file, choose=order.choice, phase=order.angle(PHASE))


def _blocking(order: Order) -> None:
    from tmmcalc.report.pictures import draw_blocking

    draw_blocking(order.results["blocking"], order.file, choose=order.choice)


def _profile(order: Order) -> None:
    from tmmcalc.report.pictures import draw_profile

    draw_profile(order.results["pair"], order.file, choose=order.choice)


def _cam(stage: str) -> Callable[[Order], None]:
    """What draws a stage of the cam."""

    def draw(order: Order) -> None:
        from tmmcalc.report.pictures.cams import draw_cam
        from tmmcalc.spec.cams import to_cam
        from tmmcalc.stages.camparts import at_speed

        task = at_speed(to_cam(order.spec), order.results.get("motion"))
        draw_cam(stage, task, order.results[stage], order.file)

    return draw


def _indexing(order: Order) -> None:
    from tmmcalc.report.pictures.cams import draw_indexing
    from tmmcalc.spec.indexings import to_indexing

    draw_indexing(to_indexing(order.spec), order.results["indexing"], order.file, order.angle(PHASE))


def _synthesis(order: Order) -> None:
    from tmmcalc.report.pictures.synthesis import draw_synthesis
    from tmmcalc.spec import parse_spec
    from tmmcalc.spec.linkage import to_linkage

    result = order.results["synthesis"]
    choose = order.choice or _first_feasible(order.spec, result)
    if choose > len(result.designs):
        raise UsageError(f"there is no solution {choose}", where=CHOOSE, remedy=f"write 1 to {len(result.designs)}")
    mechanism = to_linkage(parse_spec(result.designs[choose - 1].spec).linkage)
    if result.designs[choose - 1].dwell is not None:
        from tmmcalc.report.pictures.dwell import draw_dwell

        draw_dwell(mechanism, result, order.file, choose=choose)
        return
    draw_synthesis(mechanism, result, order.file, choose=choose)


def _first_feasible(spec: Spec, synthesis: Any) -> int:
    """The number of the solution that ``tmmcalc synth`` chooses."""
    if not spec.constraints:
        return 1
    from tmmcalc.stages.feasibility import inputs, solve

    return solve(inputs(spec), {"synthesis": synthesis}, {}).chosen


def _feasibility(order: Order) -> None:
    from tmmcalc.report.pictures.feasibility import draw_feasibility

    draw_feasibility(order.results["feasibility"], order.file)


def _vibration(stage: str) -> Callable[[Order], None]:
    """What draws a stage of vibration."""

    def draw(order: Order) -> None:
        from tmmcalc.report.pictures.vibration import draw_vibration

        draw_vibration(stage, order.results[stage], order.file)

    return draw


def _extra(stage: str) -> Callable[[Order], None]:
    """What draws a small calculator."""

    def draw(order: Order) -> None:
        from tmmcalc.report.pictures.extras import draw_extra

        draw_extra(stage, order.results[stage], order.file)

    return draw


CAM_STAGES = tuple(
    f"cam_{stage}" for stage in ("law", "synthesis", "profile", "pressure", "forces", "strength", "optimum", "elastic")
)

DRAWINGS = {
    "kinematics": Drawing(_kinematics, (POSITIONS, POLYGONS)),
    "forces": Drawing(_forces, (POLYGONS,)),
    "reduction": Drawing(_reduction),
    "synthesis": Drawing(_synthesis, (CHOOSE,)),
    "flywheel": Drawing(_flywheel),
    "motion": Drawing(_motion),
    "transient": Drawing(_transient),
    "unsteady": Drawing(_unsteady),
    "manipulator": Drawing(_manipulator),
    "balance": Drawing(_balance),
    "train": Drawing(_train, (CHOOSE,)),
    "criteria": Drawing(_criteria, (CHOOSE,)),
    "pair": Drawing(_pair, (CHOOSE, PHASE)),
    "blocking": Drawing(_blocking, (CHOOSE,)),
    "profile": Drawing(_profile, (CHOOSE,)),
    **{stage: Drawing(_cam(stage)) for stage in CAM_STAGES},
    **{stage: Drawing(_vibration(stage)) for stage in ("vibrator", "pendulum")},
    "indexing": Drawing(_indexing, (PHASE,)),
    **{stage: Drawing(_extra(stage)) for stage in ("contact", "reliability", "falling_ball")},
    "feasibility": Drawing(_feasibility),
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
