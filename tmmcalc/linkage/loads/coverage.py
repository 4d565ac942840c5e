"""Whether a load's table covers what the mechanism passes: beyond its ends the end values hold, which is told."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator

import numpy as np

from tmmcalc.core.plane import Real
from tmmcalc.linkage.assembly import TURN
from tmmcalc.linkage.loading import Load, Tabulated
from tmmcalc.linkage.loads.sources import Place
from tmmcalc.linkage.loads.strokes import Displacement
from tmmcalc.linkage.loads.travel import EDGE, Travel
from tmmcalc.linkage.loads.windows import Inside
from tmmcalc.linkage.results import Grade
from tmmcalc.linkage.survey import Survey

SLACK = 1e-3  # of the whole way: abscissae are rounded


def of_displacement(
    travel: Travel, dense: Survey, load: Load, law: Tabulated, window: Inside, displacement: Displacement, unit: float
) -> Iterator[Grade]:
    """What of a table the output never reaches, and where the output goes beyond it; ``unit`` [m or rad] of its x."""
    where, reach = f"load {load.name}", displacement.reach
    low, high = law.x[0] * unit, law.x[-1] * unit
    said, factor = ("deg", math.degrees(1.0)) if displacement.output.link is not None else ("mm", 1e3)
    stroke = f"the stroke of {displacement.output.name} is {reach * factor:.5g} {said}"
    if high > reach * (1 + EDGE):
        only = "; the whole table lies beyond it, and its first value holds throughout" if low >= reach else ""
        yield Grade("warning", where, f"its table goes to {high * factor:.5g} {said}, but {stroke}{only}")
    passed = (0.0, reach) if _whole(load) else _passed(travel, dense, window, displacement.at(dense.configuration))

    def named(x: float) -> str:
        return f"{x * unit * factor:.5g} {said}"

    if low < reach:
        yield from _held(load, law, (passed[0] / unit, passed[1] / unit), reach / unit, named, stroke)


def of_range(travel: Travel, dense: Survey, load: Load, law: Tabulated, x: Real, window: Inside) -> Iterator[Grade]:
    """Where a motion that is no cycle goes beyond a table of the angle with the abscissae ``x``."""
    theta = travel.theta(dense.x)
    passed = (0.0, travel.period) if _whole(load) else _passed(travel, dense, window, theta)
    (end,) = travel.named(np.array([travel.period]))

    def named(at: float) -> str:
        return travel.named(np.array([at]))[0]

    yield from _held(load, law, passed, travel.period, named, f"the motion goes from 0 to {end}", x)


def _whole(load: Load) -> bool:
    """Whether a load acts from one end of the way to the other."""
    return load.window is None or load.window.stroke is not None


def _passed(travel: Travel, dense: Survey, window: Inside, values: Real) -> tuple[float, float]:
    """Least and largest of some values (m,) over the survey where the load acts."""
    theta = travel.theta(dense.x)
    turns = round(travel.period / TURN) if travel.whole else 1
    acts = np.zeros(theta.shape, dtype=bool)
    for k in range(turns):
        acts |= window.inside(Place(theta + TURN * k, dense.configuration))
    inside = values[acts]
    return (float(inside.min()), float(inside.max())) if inside.size else (math.inf, -math.inf)


def _held(
    load: Load,
    law: Tabulated,
    passed: tuple[float, float],
    way: float,
    named: Callable[[float], str],
    limit: str,
    x: Real | None = None,
) -> Iterator[Grade]:
    """The values other than zero that hold beyond the ends of a table."""
    at = law.x if x is None else x
    first, last, unit = float(at[0]), float(at[-1]), "N" if load.kind == "force" else "N*m"
    ends, held = [], []
    if passed[0] < first - SLACK * way and law.values[0]:
        ends.append(f"begins at {named(first)}")
        held.append(f"before it the first value {law.values[0]:.5g} {unit} is held")
    if passed[1] > last + SLACK * way and law.values[-1]:
        ends.append(f"ends at {named(last)}")
        held.append(f"beyond it the last value {law.values[-1]:.5g} {unit} is held")
    if ends:
        text = f"its table {' and '.join(ends)}, but {limit}: {', '.join(held)}"
        remedy = "extend the table, end it with 0, or give the load a window"
        yield Grade("warning", f"load {load.name}", f"{text}; {remedy}")
