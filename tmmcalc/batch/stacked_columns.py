"""Columns of kinematics, paths, forces and motion of many variants at once, and the few facts of these."""

from __future__ import annotations

from array import array
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmmcalc.batch.stacked_inputs import STUCK, Inputs, Together
from tmmcalc.batch.task import OK, Row
from tmmcalc.naming.language import parse
from tmmcalc.naming.rows import REDUCED

if TYPE_CHECKING:
    from tmmcalc.batch.stacked_machine import Machine
    from tmmcalc.linkage.forces.results import Forces
    from tmmcalc.linkage.paths.task import WantedPath
    from tmmcalc.linkage.stacked.scene import Block, Same
    from tmmcalc.pipeline.outcome import RunResult

Values = NDArray[np.floating[Any]]
Flags = NDArray[np.bool_]

BLOCK = 256  # variants
STAGES = ("kinematics", "paths", "forces", "motion")  # whose columns blocks tell
ANGLES = ("transmission_min_", "pressure_max_")  # facts of groups
CHECKS = {"equilibrium", "virtual"}  # columns of forces that no block tells


class Asked(NamedTuple):
    """One quantity: what is asked of which column of which stage."""

    stage: str
    of: str  # empty: a fact of its summary
    column: str
    row: int | None = None  # the one that is asked for


def asked(name: str, base: RunResult) -> Asked | None:
    """What a name asks for; None for what is no column, and none of the few facts."""
    from tmmcalc.batch.stacked_machine import COLUMNS
    from tmmcalc.linkage.paths.deviations import names_of
    from tmmcalc.linkage.stacked.summaries import transmissions
    from tmmcalc.linkage.stacked.tables import STROKES
    from tmmcalc.machine.stacked.figures import FIGURES

    stage, of, fact, place, _ = parse(name)
    if of or place:
        told = fact in ("phi", *COLUMNS.values()) if stage == "motion" else fact not in CHECKS
        if stage not in STAGES or not told:
            return None
        if place is None:
            return Asked(stage, of, fact) if of in REDUCED else None
        labels = base.results[stage].labels
        one = not place.column and not place.last and place.first in labels and of in ("", *REDUCED)
        return Asked(stage, of or "first", fact, labels.index(place.first)) if one else None
    if stage == "paths":
        names = {name for path in base.results[stage].paths for name in names_of(path.name).values()}
        return Asked(stage, "", fact) if fact in names else None
    if stage == "motion" and fact in FIGURES:
        return Asked(stage, "", fact)
    kind, _, output = fact.partition("_")
    kinematics = base.results["kinematics"]
    if stage == "kinematics" and fact in transmissions(kinematics.qualities):
        return Asked(stage, "", fact)
    first = kinematics.outputs[0] if kinematics.outputs else None
    return Asked(stage, "", kind) if stage == "kinematics" and kind in STROKES and output == first else None


class Columns:
    """Solves blocks of points, of which only columns and the few facts are asked for."""

    block = BLOCK  # points that are solved together
    alone: tuple[str, ...] = ()  # stages that each variant runs by itself

    def __init__(self, inputs: Inputs, same: Same, base: RunResult, asked: dict[str, Asked]) -> None:
        self._inputs, self._same, self._base = inputs, same, base
        self._names, self._asked = tuple(asked), tuple(asked.values())
        self._transmits = any(each.stage == "kinematics" and each.column.startswith(ANGLES) for each in self._asked)
        self._tracked = any(each.column.startswith(("angle_", "S_")) for each in self._asked)

    def rows(self, points: Sequence[int], given: Values) -> Together[Row]:
        """Rows of those points of a block that are solved together; ``given`` are their values (v, axes)."""
        found, apart, refused = dict[int, Row](), dict[int, str](), dict[int, str]()
        for which, (values, clear, stuck) in self._inputs.parts(given, self._block, apart):
            refused.update(dict.fromkeys(which[stuck].tolist(), STUCK))
            clear = clear & np.all(np.isfinite(values), axis=1)
            for k, row in zip(which[clear].tolist(), values[clear], strict=True):
                found[k] = Row(points[k], OK, "", self._names, array("d", row.tolist()))
        return Together(found, apart, refused)

    def _block(self, tree: Any, count: int) -> tuple[Values, Flags, Flags]:
        """Values (v, names) of stacked inputs, which of the variants are clear, and which surely do not assemble."""
        from tmmcalc.linkage.stacked.scene import block_of
        from tmmcalc.linkage.stacked.tables import strokes_of

        mechanism, loading, machine, paths = tree
        targets = {each.stage for each in self._asked}
        block = block_of(self._same, count, mechanism, loading, self._tracked, placed=targets == {"paths"})
        values, clear = np.zeros((count, len(self._names))), block.settled.clear.copy()
        if machine is not None:
            self._motion(block, machine, values, clear)
        self._facts("kinematics", strokes_of(block) if block.settled.reached.size else {}, slice(None), values)
        if paths is not None:
            self._paths(block, paths, values, clear)
        for part in block.parts(block.labels):
            some = part[clear[part]]
            if some.size and "kinematics" in targets:
                self._kinematics(block, some, values)
            if some.size and "forces" in targets:
                clear[some] &= self._forces(block, some, values, machine is None)
        return values, clear, block.settled.stuck

    def _kinematics(self, block: Block, some: Any, values: Values) -> None:
        from tmmcalc.linkage.columns import columns
        from tmmcalc.linkage.stacked.summaries import transmissions_of
        from tmmcalc.linkage.stacked.tables import kinematics_of

        self._write("kinematics", columns(kinematics_of(block, some)), some, values)
        if self._transmits:
            self._facts("kinematics", transmissions_of(block, some), some, values)

    def _paths(self, block: Block, asked: tuple[WantedPath, ...], values: Values, clear: Flags) -> None:
        from tmmcalc.linkage.paths.columns import path_columns
        from tmmcalc.linkage.stacked.paths import paths_of

        swift = block.settled.swift
        for some in (np.flatnonzero(clear & ~swift), np.flatnonzero(clear & swift)):  # these have more samples
            if some.size:
                found, facts = paths_of(block, some, asked, self._base.results["paths"])
                self._write("paths", path_columns(found), some, values)
                self._facts("paths", facts, some, values)

    def _forces(self, block: Block, some: Any, values: Values, between: bool) -> Flags:
        from tmmcalc.linkage.forces.columns import columns
        from tmmcalc.linkage.stacked.tables import forces_of

        base: Forces = self._base.results["forces"]
        found, clear = forces_of(block, some, base, between)
        self._write("forces", columns(found), some, values)
        return clear

    def _motion(self, block: Block, machine: Machine, values: Values, clear: Flags) -> None:
        from tmmcalc.batch.stacked_machine import motions_of
        from tmmcalc.machine.columns import motion_columns

        some = np.flatnonzero(clear)
        if some.size:
            wanted = {each.column for each in self._asked if each.stage == "motion"}
            found, figures, clear[some] = motions_of(block, some, machine, self._base.results["motion"], wanted)
            self._write("motion", motion_columns(found), some, values)
            self._facts("motion", figures, some, values)

    def _write(self, stage: str, columns: Sequence[Any], some: Any, values: Values) -> None:
        """Write what is asked of columns with the rows of some variants (v,)."""
        made: dict[str, Values] = {}
        by_name = {column.name: column for column in columns}
        for k, asked in enumerate(self._asked):
            if asked.stage == stage and asked.of:
                if asked.column not in made:
                    made[asked.column] = np.asarray(by_name[asked.column].make(), float).reshape(len(some), -1)
                own = made[asked.column]
                values[some, k] = REDUCED[asked.of](own if asked.row is None else own[:, [asked.row]])

    def _facts(self, stage: str, found: dict[str, Values], some: Any, values: Values) -> None:
        """Write what is asked of facts (v,) of some variants."""
        for k, asked in enumerate(self._asked):
            if asked.stage == stage and not asked.of and asked.column in found:
                values[some, k] = found[asked.column]
