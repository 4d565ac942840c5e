"""From the table ``[synthesis]`` to the task of a synthesis; a further kind joins by one line in `TASKS`."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import fields
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from tmmcalc.core.errors import UsageError
from tmmcalc.linkage.synthesis.kinds import SEARCHES
from tmmcalc.linkage.synthesis.task import (
    CrankRockerTask,
    FunctionTask,
    MechanismName,
    PoseTask,
    RotatingTask,
    SliderCrankTask,
    SlottedTask,
    SynthesisTask,
    TrailingRodTask,
)

if TYPE_CHECKING:
    from tmmcalc.feasibility.judge import FeasibilityTask
    from tmmcalc.linkage.room import LinkageTables
    from tmmcalc.linkage.tables.synthesis_dwell import DwellTable
    from tmmcalc.linkage.tables.synthesis_generation import FunctionTable, MotionSynthesisTable, PathTable

FINE = 181  # places at which a generated function is compared


def to_synthesis(spec: LinkageTables) -> SynthesisTask:
    """The synthesis of a spec; raises `UsageError` if it has none."""
    table = spec.synthesis
    if table is None:
        raise UsageError("the spec has no [synthesis]", remedy="add [synthesis.slider_crank], for example")
    kind = table.kind
    asked = getattr(table, kind)
    return SynthesisTask(
        kind=kind,
        asked=TASKS[kind](asked),
        crank_speed=table.crank_speed,
        working_speed=getattr(asked, "working_speed", None),
        solutions=table.solutions,
        seed=table.seed,
        transmission=table.transmission or 0.0,
        positions=table.positions,
        title=spec.project.title,
        constraints=_searched(spec),
    )


def _searched(spec: LinkageTables) -> FeasibilityTask | None:
    """The constraints, where a search keeps them: that of a path, function or motion, and of the best dwell."""
    table = spec.synthesis
    if table is None or not spec.constraints:
        return None
    dwell = table.dwell is not None and table.dwell.optimum is not None
    if table.kind not in SEARCHES and not (dwell and any(each.stage == "synthesis" for each in spec.constraints)):
        return None
    from tmmcalc.feasibility.tables.tasks.feasibility import to_feasibility

    return to_feasibility(spec)


def _plain(record: Any, **renamed: str) -> Callable[[Any], Any]:
    """A record whose fields are keys of the table, some under another name."""

    def read(table: Any) -> Any:
        return record(**{f.name: getattr(table, renamed.get(f.name, f.name)) for f in fields(record)})

    return read


def _poses(table: PathTable | MotionSynthesisTable) -> PoseTask:
    """Points of a path or poses of a motion."""
    points = np.array([complex(*point) for point in table.points])
    angles, timing = getattr(table, "angles", None), getattr(table, "timing", None)
    low, high = (complex(*corner) for corner in table.region or ((0, 0), (0, 0)))
    return PoseTask(
        mechanism=cast(MechanismName, table.mechanism),
        points=points,
        angles=None if angles is None else np.unwrap(np.array(angles)),
        timing=None if timing is None else np.array(timing) - timing[0],
        region=None if table.region is None else (low, high),
        full_turn=table.full_turn,
        largest_ratio=table.largest_ratio,
    )


def _function(table: FunctionTable) -> FunctionTask:
    """Inputs and outputs at the precision points, and where the function is compared."""
    inputs, outputs, fine_inputs, fine_outputs = _samples(table)
    every = np.concatenate((inputs, fine_inputs))
    return FunctionTask(
        mechanism=cast(MechanismName, table.mechanism),
        inputs=inputs,
        outputs=outputs,
        fine_inputs=fine_inputs,
        fine_outputs=fine_outputs,
        span=(float(every.min()), float(every.max())),
        input_start=table.input_start,
        output_start=table.output_start,
        frame=table.frame,
    )


def _samples(table: FunctionTable) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    none = np.zeros(0)
    if table.inputs is not None and table.outputs is not None:
        inputs, outputs = np.array(table.inputs), np.array(table.outputs)
        return inputs - inputs[0], outputs - outputs[0], none, none
    turn, travel = table.input_range or 0.0, table.output_range or 0.0
    if table.table is not None:
        x, y = np.array(table.table).T
        return turn * _part(x, x[0], x[-1]), travel * _part(y, y[0], y[-1]), none, none
    y_of, (low, high) = formula_of(table.expression or ""), table.range or [0.0, 1.0]
    fine = np.linspace(low, high, FINE)
    first, last = y_of(np.array([low, high]))
    x = precision_points(table.points or 3, low, high, table.spacing)
    return (
        turn * _part(x, low, high),
        travel * _part(y_of(x), first, last),
        turn * _part(fine, low, high),
        travel * _part(y_of(fine), first, last),
    )


def _part(values: np.ndarray, first: float, last: float) -> np.ndarray:
    """Values as parts of the way from the first to the last."""
    return (values - first) / (last - first)


def precision_points(count: int, low: float, high: float, spacing: str) -> np.ndarray:
    """Precision points (count,) in the interval."""
    if spacing == "equal":
        return np.linspace(low, high, count)
    from tmmcalc.linkage.synthesis.function import chebyshev

    return chebyshev(count, low, high)


def formula_of(text: str) -> Callable[[np.ndarray], np.ndarray]:
    """The expression y(x); raises `UsageError` if it cannot be read."""
    from tmmcalc.core.expression import parse

    return parse(text.replace("^", "**"), variables=("x",), where="synthesis.function")


def _dwell(table: DwellTable) -> Any:
    from tmmcalc.linkage.tables.tasks.dwell import to_dwell

    return to_dwell(table)


TASKS: dict[str, Callable[[Any], Any]] = {
    "slider_crank": _plain(SliderCrankTask),
    "slotted_link": _plain(SlottedTask, pressure="pressure_angle"),
    "rotating_slotted_link": _plain(RotatingTask, pressure="pressure_angle"),
    "crank_rocker": _plain(CrankRockerTask, transmission="transmission_angle"),
    "trailing_rod": _plain(TrailingRodTask),
    "path": _poses,
    "function": _function,
    "motion": _poses,
    "dwell": _dwell,
}
