"""From ``[synthesis.dwell]`` to its task."""

from __future__ import annotations

from typing import TYPE_CHECKING, cast

from tmmcalc.linkage.synthesis.dwell.task import DwellTask, Lengths, Optimum, OutputKind, Stroke, ThreePositions

if TYPE_CHECKING:
    from tmmcalc.linkage.tables.synthesis_dwell import DwellOptimumTable, DwellTable

# Names of parameters in the ranges of a spec and of the task.
RANGES = {"CB": "bar", "CD": "side"}


def to_dwell(table: DwellTable) -> DwellTask:
    """The six-bar that is asked for."""
    p = table.positions
    return DwellTask(
        dwell=table.dwell,
        output=cast(OutputKind, table.output),
        positions=ThreePositions(p.phi12, p.psi0, p.psi12, p.psi13, p.CB, p.CD, p.alpha),
        lengths=_lengths(table),
        n=table.n,
        reverse=bool(table.k),
        clockwise=table.crank_sense == "cw",
        pivot=None if table.pivot is None else complex(*table.pivot),
        swing=table.swing,
        pivot_left=None if table.pivot_side is None else table.pivot_side == "left",
        exact=table.exact,
        working_angle=table.working_angle,
        working=cast(Stroke, table.working),
        frame=table.frame,
        stroke=table.stroke,
        resistance=1.0 if table.resistance is None else table.resistance,
        arc_steps=table.arc_steps,
        optimum=None if table.optimum is None else _optimum(table.optimum, table.output == "rocker"),
    )


def _lengths(table: DwellTable) -> Lengths | None:
    given = table.lengths
    if given is None:
        return None
    phi12 = table.dwell / 2 if given.phi12 is None else given.phi12
    return Lengths(given.OA, given.AC, given.CB, given.CD, given.alpha, given.phi0, phi12, given.side == "left")


def _optimum(table: DwellOptimumTable, rocks: bool) -> Optimum:
    w = table.weights
    size = w.f2 if w.f2 is not None else float(not rocks)
    ranges = {RANGES.get(name, name): tuple(ends) for name, ends in table.ranges.model_dump().items() if ends}
    return Optimum((w.f1, size, w.f3, w.f4, w.f5), ranges, table.population, table.generations, table.polish)
