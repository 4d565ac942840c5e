"""A torque diagram alone in the form that a reduced linkage has, so that all machine stages take it."""

from __future__ import annotations

import math

import numpy as np

from tmmcalc.linkage.reduction.results import Contribution, Reduction
from tmmcalc.linkage.results import Extreme
from tmmcalc.machine.cycle import Cycle
from tmmcalc.numerics.simpson import simpson

POSITIONS = 24  # equal steps of a turn that are tabulated


def reduced_diagram(name: str, cycle: Cycle) -> Reduction:
    """The reduction of a shaft with a moment diagram; its inertia is constant."""
    on = cycle.panels
    steps = POSITIONS * max(1, round(cycle.period / (2 * math.pi)))
    theta = np.linspace(0.0, cycle.period, steps + 1)
    moment = on.at(cycle.moment, theta)
    moment[-1] = on.at(cycle.moment, theta[-1:], before=True)[0]
    least, largest = on.extremes(cycle.moment)
    contribution = Contribution(
        name,
        "load",
        None,
        0,
        float(on.total(cycle.moment)),
        simpson(theta, moment),
        Extreme(*least),
        Extreme(*largest),
    )
    inertia = float(cycle.inertia.flat[0])
    return Reduction(
        labels=tuple(map(str, range(steps + 1))),
        phi=theta,
        turns=True,
        whole=True,
        speed=cycle.speed,
        contributions=(contribution,),
        moment=moment[None],
        total=moment,
        inertia=np.full(steps + 1, inertia),
        slope=np.zeros(steps + 1),
        parts=cycle.moment[None],
        cycle=cycle,
        idle=None,
        inertia_range=(Extreme(inertia, 0.0), Extreme(inertia, 0.0)),
        rods="exact",
        rod_links=(),
        other=None,
        grades=(),
        counters={"panels": on.count, "points": on.x.size},
    )
