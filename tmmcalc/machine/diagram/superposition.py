"""Several diagrams on one shaft, each with its delay, and the constant load that closes the work of a cycle."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from tmmcalc.core.errors import UsageError
from tmmcalc.core.numerics.panels import Panels, Values, panels
from tmmcalc.machine.cycle import Cycle

PARTS = ("inertia", "slope", "moment", "viscous", "quadratic")


def even_delays(count: int, period: float = 2 * math.pi) -> tuple[float, ...]:
    """Delays [rad] of ``count`` equal cylinders that fire at equal intervals.

    >>> [round(math.degrees(d)) for d in even_delays(4, 4 * math.pi)]
    [0, 180, 360, 540]
    """
    return tuple(i * period / count for i in range(count))


def superposed(cycle: Cycle, delays: Sequence[float]) -> Cycle:
    """Equal engines or cylinders on one shaft, each the ``cycle`` delayed by one of ``delays`` [rad].

    A delay may be negative or above the period. Masses count as often as cylinders; give the delay 0 for the first.
    """
    return combined([(cycle, delay) for delay in delays])


def combined(parts: Sequence[tuple[Cycle, float]]) -> Cycle:
    """Different cycles on one shaft: the sum of the ``parts`` (cycle, delay [rad]).

    The result has the longest period, and every period must divide it: a two-stroke compressor runs twice in
    the cycle of a four-stroke engine. The speed is the first part's. Raises `UsageError` if a period does not fit.
    """
    if not parts:
        raise UsageError("no diagrams to superpose", where="torque diagram", remedy="give one delay or more")
    period = max(cycle.period for cycle, _ in parts)
    on = _union(parts, period)
    total = dict.fromkeys(PARTS, np.zeros(on.x.shape))
    for cycle, delay in parts:
        for name, values in zip(PARTS, _delayed(cycle, delay, on), strict=True):
            total[name] = total[name] + values
    return Cycle(
        on,
        inertia=total["inertia"],
        slope=total["slope"],
        moment=total["moment"],
        viscous=total["viscous"],
        quadratic=total["quadratic"],
        speed=parts[0][0].speed,
        error=max(cycle.error for cycle, _ in parts),
        balancing=sum(cycle.balancing for cycle, _ in parts),
    )


def _union(parts: Sequence[tuple[Cycle, float]], period: float) -> Panels:
    """Panels with an edge wherever one of the delayed parts has one."""
    edges: list[Values] = []
    for cycle, delay in parts:
        times = period / cycle.period
        if abs(times - round(times)) > 1e-9:
            raise UsageError(
                f"a cycle of {cycle.period:.6g} rad does not fit a whole number of times into {period:.6g} rad",
                where="torque diagram",
                value=times,
                remedy="bring the diagrams to one shaft, or to periods that divide each other",
            )
        starts = np.arange(round(times)) * cycle.period + delay
        edges.append(np.mod(np.add.outer(starts, cycle.panels.edges[:-1]).ravel(), period))
    # the parts are smooth on their own panels, so no width need be asked for
    return panels(0.0, period, np.concatenate(edges), widest=period)


def _delayed(cycle: Cycle, delay: float, on: Panels) -> Values:
    """The five functions (5, K, N) of a cycle delayed by ``delay``, at the points of ``on``."""
    functions = np.stack([getattr(cycle, name) for name in PARTS])
    # every panel of ``on`` lies inside one panel of the part, so its polynomial is carried over exactly
    x = np.mod(on.x - delay - cycle.panels.edges[0], cycle.period) + cycle.panels.edges[0]
    return cycle.panels.at(functions, x.ravel()).reshape(len(PARTS), *on.x.shape)


def balanced(cycle: Cycle, speed: float | None = None) -> Cycle:
    """The cycle with the constant moment added that makes its work zero (3.45).

    Forces that depend on speed count at ``speed`` [rad/s], by default the cycle's own. An engine gets its constant load
    so, a working machine its constant drive.
    """
    w = cycle.speed if speed is None else speed
    work = float(cycle.panels.total(cycle.moment + cycle.viscous * w + cycle.quadratic * w * w))
    added = -work / cycle.period
    return replace(cycle, moment=cycle.moment + added, speed=w, balancing=cycle.balancing + added)
