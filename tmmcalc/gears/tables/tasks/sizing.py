"""From the tables of a spec to what the strength and the choice of gear trains read."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from tmmcalc.core.errors import UsageError
from tmmcalc.feasibility.tables.tasks.kept_rows import kept_rows
from tmmcalc.gears.criteria.efficiency import MeshEfficiency
from tmmcalc.gears.selection.task import SelectionTask
from tmmcalc.gears.sizing import SizingTask
from tmmcalc.gears.tables.tasks.strength import to_strength

if TYPE_CHECKING:
    from tmmcalc.gears.room import GearTables
    from tmmcalc.gears.tables.criteria import CriteriaTable
    from tmmcalc.gears.tables.strength import StrengthTable

ANY = 1.0  # N*m: stands in for a torque that follows from the moment


def to_sizing(spec: GearTables) -> SizingTask:
    """What is asked of the strength of a train; raises `UsageError` for a spec without it."""
    from tmmcalc.gears.tables.tasks.open_pair import to_open_pair

    table, on_crank = _table(spec), to_open_pair(spec)
    torque = table.torque
    plain = {"torque": ANY if torque is None else torque, "moment": None, "moment_ratio": None}
    return SizingTask(
        strength=to_strength(table.model_copy(update=plain)),
        torque=torque,
        moment=None if table.moment is None else abs(table.moment),
        ratio=None if table.moment_ratio is None else abs(table.moment_ratio),
        beyond=1.0 if on_crank is None else on_crank.ratio,
    )


def to_selection(spec: GearTables) -> SelectionTask:
    """How the best train is chosen; without a table in the usual way."""
    table, kept = spec.criteria, kept_rows(spec, "criteria")
    return SelectionTask(kept=kept) if table is None else replace(_selection(table), kept=kept)


def _selection(table: CriteriaTable) -> SelectionTask:
    usual = SelectionTask()
    meshes = usual.meshes
    weights: dict[str, float] = {} if table.weights is None else table.weights.model_dump()
    return SelectionTask(
        objectives=usual.objectives if table.objectives is None else tuple(table.objectives),
        weights=tuple((key, weight) for key, weight in weights.items() if weight),
        choose=table.choose,
        meshes=MeshEfficiency(
            meshes.external if table.external_efficiency is None else table.external_efficiency,
            meshes.internal if table.internal_efficiency is None else table.internal_efficiency,
        ),
        series=table.series,
    )


def _table(spec: GearTables) -> StrengthTable:
    if spec.strength is None:
        raise UsageError("the spec has no [strength]", remedy="add [strength] with the material of the wheels")
    return spec.strength
