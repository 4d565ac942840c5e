"""Stage ``kinematics``: positions, velocities, accelerations, transfer functions."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from typing import TYPE_CHECKING, Any, get_type_hints

import numpy as np

from tmmcalc.core.conversion import plain, restore
from tmmcalc.core.stage import said
from tmmcalc.core.stored import Record
from tmmcalc.linkage.results import Kinematics, Trace
from tmmcalc.linkage.wanted import NO_CSV, is_long

if TYPE_CHECKING:
    from tmmcalc.core.columns import Column
    from tmmcalc.linkage.model import Mechanism
    from tmmcalc.linkage.room import LinkageTables

LOOPS = "all groups are dyads, in closed form: no loops are iterated, no branches followed"
EXTRA = "no extra positions and no dead centres among the positions: equal steps alone"


_TRACE_ARRAYS = ("r", "dr", "ddr", "angle", "dangle", "ddangle", "joint_s", "joint_ds", "joint_dds")
_TRACE_FIELDS = ("r", "dr", "ddr", "angle", "dangle", "ddangle", "s", "ds", "dds")
_OUTPUT_ARRAYS = ("s", "ds", "dds")

solve = "tmmcalc.linkage.kinematics:solve_kinematics"
kind = Kinematics
columns = "tmmcalc.linkage.columns:columns"
placed = "tmmcalc.linkage.tables.tasks.placed:with_position"
dense = "tmmcalc.linkage.tables.tasks.placed:with_positions"
derivatives = "tmmcalc.linkage.derivatives.told:of_kinematics"
words = "tmmcalc.linkage.tables.tasks.words:words_of"
declares = ("tmmcalc.linkage.relative", "tmmcalc.linkage.special", "tmmcalc.linkage.further")


def inputs(spec: LinkageTables) -> Mechanism:
    """The linkage as plain numbers; masses, gravity and the project's title are not read."""
    from tmmcalc.linkage.tables.tasks.mechanism import to_linkage

    return to_linkage(spec.linkage)


def dump(result: Kinematics) -> Record:
    """Arrays go to npz: x (n,), outputs s, ds, dds (O, n), points r (P, n), links angle (L, n), joints (J, n)."""
    arrays: dict[str, np.ndarray] = {"label": np.array(result.labels), "phi": result.phi, "x": result.x}
    arrays |= {f"output_{name}": getattr(result, name) for name in _OUTPUT_ARRAYS}
    arrays |= {name: getattr(result.trace, own) for name, own in zip(_TRACE_ARRAYS, _TRACE_FIELDS, strict=True)}
    left_out = {"labels", "phi", "x", *_OUTPUT_ARRAYS, "trace", "branches", "error", "counters"}
    scalars = {name: plain(value) for name, value in vars(result).items() if name not in left_out and value is not None}
    branches = plain(result.branches, arrays, "branches")
    if branches:
        scalars["branches"] = branches
    names = {"points": result.trace.point_names, "links": result.trace.link_ids, "joints": result.trace.joint_names}
    return Record({**scalars, "rows": plain(names)}, arrays, plain(result.error), result.counters)


def load(record: Record) -> Kinematics:
    """Build the result from its record."""
    arrays, rows = record.arrays, record.scalars["rows"]
    own = (arrays[name] for name in _TRACE_ARRAYS)
    r, dr, ddr, angle, dangle, ddangle, s, ds, dds = own
    points, links, joints = (tuple(rows[name]) for name in ("points", "links", "joints"))
    trace = Trace(points, r, dr, ddr, links, angle, dangle, ddangle, joints, s, ds, dds)
    given: dict[str, Any] = {
        "labels": tuple(arrays["label"].tolist()),
        "phi": arrays["phi"],
        "x": arrays["x"],
        **{name: arrays[f"output_{name}"] for name in _OUTPUT_ARRAYS},
        "trace": trace,
    }
    hints = _hints()
    given["branches"] = restore(hints["branches"], record.scalars.get("branches", {}), arrays, "branches")
    stored = {**record.scalars, "error": record.error, "counters": record.counters}
    return Kinematics(**given, **{f: restore(hints[f], stored.get(f)) for f in hints if f not in given})


@cache
def _hints() -> dict[str, Any]:
    """Types of the fields of a result."""
    return get_type_hints(Kinematics)


def further(spec: LinkageTables, results: Mapping[str, Any], *, dimensionless: bool = False) -> list[Column]:
    """Terms of the vector equations, and outputs by differences of positions."""
    from tmmcalc.linkage.further import further_columns
    from tmmcalc.linkage.tables.tasks.mechanism import to_linkage

    return further_columns(to_linkage(spec.linkage), results["kinematics"], dimensionless=dimensionless)


def omits(spec: LinkageTables) -> tuple[str, ...]:
    """Positions and groups that the mechanism has not."""
    grid = spec.linkage.grid
    return said(
        (_dyads(spec), LOOPS),
        (not grid.extra and not grid.extremes, EXTRA),
        (is_long(spec), NO_CSV),
    )


def _dyads(spec: LinkageTables) -> bool:
    """Whether all groups have a kind of dyad, as the chain asks when it places them."""
    from tmmcalc.linkage.structure import solve_structure
    from tmmcalc.linkage.tables.tasks.mechanism import to_linkage

    return all(group.kind for group in solve_structure(to_linkage(spec.linkage)).groups)
