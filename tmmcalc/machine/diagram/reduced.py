"""A torque diagram alone in the form that a reduced linkage has, so that all machine stages take it.

A moment that balances the diagram is a cause of its own beside it: its work and the work of the diagram stand apart.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import Literal

import numpy as np

from tmmcalc.core.numerics.extended import EPS
from tmmcalc.core.numerics.panels import Panels, Values
from tmmcalc.core.numerics.simpson import simpson
from tmmcalc.linkage.results import Extreme
from tmmcalc.machine.attached import Attached, with_attached
from tmmcalc.machine.cycle import Cycle
from tmmcalc.machine.diagram.solve import cycle_of
from tmmcalc.machine.model import TorqueTask
from tmmcalc.machine.reduction.results import Contribution, Reduction, ReductionError

POSITIONS = 24  # equal steps of a turn that are tabulated
BALANCE = "balancing moment"


def reduced_diagram(task: TorqueTask, attached: Sequence[Attached] = ()) -> Reduction:
    """The reduction of a shaft with a moment diagram, and with its inertia, constant or over the angle.

    What is ``attached`` to it goes on where the diagram is switched off. Raises `UsageError` for a bad law.
    """
    cycle = cycle_of(task)
    on = cycle.panels
    steps = POSITIONS * max(1, round(cycle.period / (2 * math.pi)))
    theta = np.linspace(0.0, cycle.period, steps + 1)
    parts = (cycle.moment - cycle.balancing)[None]
    named: list[tuple[str, Literal["load", "balance"]]] = [(task.name, "load")]
    if cycle.balancing:
        parts = np.concatenate((parts, np.full_like(parts, cycle.balancing)))
        named.append((BALANCE, "balance"))
    moment = np.stack([_tabulated(on, part, theta) for part in parts])
    inertia, slope = (_tabulated(on, part, theta) for part in (cycle.inertia, cycle.slope))
    least, largest = on.extremes(cycle.inertia)
    alone = Reduction(
        labels=tuple(map(str, range(steps + 1))),
        phi=theta,
        turns=True,
        whole=True,
        speed=cycle.speed,
        contributions=tuple(
            _contribution(*what, on, part, simpson(theta, row))
            for what, part, row in zip(named, parts, moment, strict=True)
        ),
        moment=moment,
        total=moment.sum(axis=0),
        inertia=inertia,
        slope=slope,
        parts=parts,
        cycle=cycle,
        idle=replace(cycle, moment=np.zeros_like(cycle.moment), balancing=0.0) if attached else None,
        inertia_range=(Extreme(*least), Extreme(*largest)),
        rods="exact",
        rod_links=(),
        other=None,
        error=_error(cycle, parts),
        grades=(),
        counters={"panels": on.count, "points": on.x.size},
    )
    return with_attached(alone, attached)


def _error(cycle: Cycle, parts: Values) -> ReductionError:
    """Errors of moments (S, K, N) as the panels tell them: what polynomials leave out, and rounding.

    The inertia is a polynomial on each panel; its slope has the rounding of differences over the narrowest one.
    """
    on, steepest = cycle.panels, float(np.max(np.abs(cycle.slope)))
    of_slope = EPS * float(np.max(cycle.inertia)) / (float(np.min(on.width)) * steepest) if steepest else 0.0
    tail = on.tail(parts)
    of_value = EPS + float(np.max(tail)) / float(np.max(np.abs(parts)) or 1.0)
    of_work = EPS + float(np.max(tail @ on.width)) / float(np.max(on.total(np.abs(parts))) or 1.0)
    return ReductionError(EPS, EPS + of_slope, of_value, of_value, of_value, of_work)


def _tabulated(on: Panels, part: Values, theta: Values) -> Values:
    """A moment (K, N) at the positions ``theta`` (n,), at the last one from within the cycle."""
    moment = on.at(part, theta)
    moment[-1] = on.at(part, theta[-1:], before=True)[0]
    return moment


def _contribution(
    name: str, kind: Literal["load", "balance"], on: Panels, part: Values, by_simpson: float | None
) -> Contribution:
    least, largest = (Extreme(*each) for each in on.extremes(part))
    error = EPS * float(on.total(np.abs(part))) + float(on.tail(part) @ on.width)
    return Contribution(name, kind, None, 0, float(on.total(part)), error, by_simpson, least, largest)
