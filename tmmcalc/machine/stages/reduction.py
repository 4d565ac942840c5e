"""Stage ``reduction``: reduced moments and reduced inertia over the cycle, work per cycle."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np

from tmmcalc.core.stage import said
from tmmcalc.linkage.wanted import FRICTION, NO_CSV, SPRINGS, interpolated, is_long
from tmmcalc.machine.model import TorqueTask
from tmmcalc.machine.reduction.columns import EFFICIENCY, cells
from tmmcalc.machine.reduction.columns import columns as reduced_columns
from tmmcalc.machine.reduction.results import Reduction

if TYPE_CHECKING:
    from tmmcalc.core.columns import Column
    from tmmcalc.linkage.loading import Loading
    from tmmcalc.linkage.model import Mechanism
    from tmmcalc.linkage.results import Kinematics
    from tmmcalc.machine.attached import Attached
    from tmmcalc.machine.reduction.ordinates import Ordinates
    from tmmcalc.machine.room import MachineTables


REDUCED = "massless links: no reduced inertia is summed up"
RODS = "no connecting rods with mass: nothing is lumped in two masses"
DIAGRAM = "[torque] in place of a linkage: nothing is reduced, the diagram is taken as it is"


Given = tuple["Mechanism", "Loading", str] | TorqueTask

kind = Reduction
words = "tmmcalc.linkage.tables.tasks.words:words_of"
declares = (
    "tmmcalc.linkage.columns:PHI",
    "tmmcalc.machine.reduction.columns",
    "tmmcalc.machine.reduction.further",
    "tmmcalc.machine.reduction.ordinates",
    "tmmcalc.linkage.forces.further:FRICTION_REDUCED",
)
placed = "tmmcalc.linkage.tables.tasks.placed:with_position"
dense = "tmmcalc.linkage.tables.tasks.placed:with_positions"


def inputs(spec: MachineTables) -> Given:
    """The linkage, what acts on it, and how rods are reduced; or the torque diagram that stands in its place."""
    from tmmcalc.machine.tables.tasks.machine import to_torque

    torque = to_torque(spec)
    if torque is not None:
        return torque
    from tmmcalc.linkage.tables.tasks.loading import to_loading
    from tmmcalc.linkage.tables.tasks.mechanism import to_linkage

    rods = spec.reduction.rods if spec.reduction is not None else "exact"
    return to_linkage(spec.linkage), to_loading(spec), rods


def solve(
    given: Mechanism | TorqueTask,
    loading: Loading | None = None,
    rods: str = "exact",
    *,
    kinematics: Kinematics | None = None,
    **attached: Attached,
) -> Reduction:
    """Reduce everything to the input link, with what is attached to it beside the linkage."""
    turns = math.lcm(1, *(each.turns for each in attached.values()))
    if isinstance(given, TorqueTask):
        from tmmcalc.machine.diagram.solve import cycle_of
        from tmmcalc.machine.stages.diagram import reduced_diagram

        result = reduced_diagram(given.name, cycle_of(given), alone=not attached)
    else:
        from tmmcalc.machine.reduction.solve import solve_reduction  # a stored result is loaded without it

        assert loading is not None
        assert kinematics is not None
        result = solve_reduction(given, loading, kinematics, rods, turns)
    for each in attached.values():
        from tmmcalc.machine.attached import with_attached

        result = with_attached(result, each)
    return result


def columns(result: Reduction) -> Sequence[Column]:
    """All columns, one row a position; one with blanks is written as text."""
    return [
        column._replace(make=partial(_efficiency, result, column)) if column.name == EFFICIENCY.name else column
        for column in reduced_columns(result)
    ]


def _efficiency(result: Reduction, column: Column) -> np.ndarray:
    """The cells as texts of full precision (n,)."""
    values = cells(result, column)
    return np.array([value if isinstance(value, str) else repr(value) for value in values])


def further(spec: MachineTables, results: Mapping[str, Any]) -> Sequence[Column]:
    """Columns by choice: what every link, load and pair adds, the ordinates of Simpson's rule."""
    from tmmcalc.machine.attached import Attached
    from tmmcalc.machine.reduction.further import Linkage, further_columns

    given, linkage = inputs(spec), None
    attached = [each for each in results.values() if isinstance(each, Attached)]
    if not isinstance(given, TorqueTask):
        mechanism, loading, _ = given
        turns = math.lcm(1, *(each.turns for each in attached))
        linkage = Linkage(mechanism, loading, results["kinematics"], turns)
    return further_columns(results["reduction"], linkage, attached)


def details(spec: MachineTables, results: Mapping[str, Any]) -> Mapping[str, Ordinates]:
    """Facts by choice: the sums of Simpson's rule by cause; none where the positions are not fit for it."""
    from tmmcalc.machine.reduction.ordinates import ordinates

    result = results["reduction"]
    if any(contribution.simpson is None for contribution in result.contributions):
        return {}
    return {f"Simpson_{cause}": sums for cause, sums in ordinates(result).items()}


def omits(spec: MachineTables) -> tuple[str, ...]:
    """What does not act, and has no mass."""
    if spec.torque is not None:
        return (DIAGRAM,)
    from tmmcalc.linkage.tables.tasks.loading import to_loading
    from tmmcalc.linkage.tables.tasks.mechanism import to_linkage
    from tmmcalc.machine.reduction.inertia import rods_of

    loading = to_loading(spec)
    return said(
        (not loading.rubs, FRICTION),
        (not loading.heavy, REDUCED),
        (not loading.springs, SPRINGS),
        (not rods_of(to_linkage(spec.linkage), loading), RODS),
        (is_long(spec), NO_CSV),
    )


def packages(spec: MachineTables) -> tuple[str, ...]:
    """As of the forces; and of the points of a torque diagram."""
    curves = (spec.torque.table, spec.torque.reduced_inertia) if spec.torque is not None else ()
    own = any(curve is not None and curve.interpolation == "pchip" for curve in curves)
    return ("scipy.interpolate",) if own or interpolated(spec) else ()
