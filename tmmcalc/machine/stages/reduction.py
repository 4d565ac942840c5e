"""Stage ``reduction``: reduced moments and reduced inertia over the cycle, work per cycle."""

from __future__ import annotations

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


def solver(given: Mechanism | TorqueTask, *_: Any) -> str:
    """A linkage is reduced, a torque diagram is so already."""
    if isinstance(given, TorqueTask):
        return "tmmcalc.machine.diagram.reduced:reduced_diagram"
    return "tmmcalc.machine.reduction.solve:solve_reduction"


def task(
    given: Mechanism | TorqueTask,
    loading: Loading | None = None,
    rods: str = "exact",
    *,
    kinematics: Kinematics | None = None,
    **attached: Attached,
) -> tuple[Any, ...]:
    """What is reduced, and what is attached to the input link beside it."""
    beside = tuple(attached.values())
    return (given, beside) if isinstance(given, TorqueTask) else (given, loading, kinematics, rods, beside)


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
    from tmmcalc.machine.attached import Attached, common_turns
    from tmmcalc.machine.reduction.further import Linkage, further_columns

    given, linkage = inputs(spec), None
    attached = [each for each in results.values() if isinstance(each, Attached)]
    if not isinstance(given, TorqueTask):
        mechanism, loading, _ = given
        linkage = Linkage(mechanism, loading, results["kinematics"], common_turns(attached))
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
