"""Whether a load's table covers what the mechanism passes: beyond its ends the end values hold, which is told."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence

import numpy as np

from tmmcalc.core.notes import Phrase, listed
from tmmcalc.core.plane import Real
from tmmcalc.linkage.assembly import TURN
from tmmcalc.linkage.loading import Load
from tmmcalc.linkage.loads.sources import Place
from tmmcalc.linkage.loads.strokes import Displacement
from tmmcalc.linkage.loads.travel import EDGE
from tmmcalc.linkage.loads.values import Acting
from tmmcalc.linkage.results import Grade

SLACK = 1e-3  # of the whole way: abscissae are rounded


def of_displacement(
    acting: Acting, x: Sequence[float], values: Sequence[float], displacement: Displacement, unit: float
) -> Iterator[Grade]:
    """What of a table the output never reaches, and where the output goes beyond it; ``unit`` [m or rad] of its x."""
    where, reach = acting.where, displacement.reach
    low, high = x[0] * unit, x[-1] * unit
    said, factor = ("deg", math.degrees(1.0)) if displacement.output.link is not None else ("mm", 1e3)
    stroke = Phrase(
        "the stroke of {name} is {reach:.5g} {unit}", name=displacement.output.name, reach=reach * factor, unit=said
    )
    if high > reach * (1 + EDGE):
        end = high * factor
        text = Phrase("its table goes to {high:.5g} {unit}, but {stroke}", high=end, unit=said, stroke=stroke)
        if low >= reach:
            text = Phrase("{text}; the whole table lies beyond it, and its first value holds throughout", text=text)
        numbers = (high, reach, "m") if said == "mm" else (high * factor, reach * factor, said)
        yield Grade("warning", where, text, *numbers, "end of the table")
    whole = _whole(acting.load)
    passed = (0.0, reach) if whole else _passed(acting, displacement.at(acting.dense.configuration))

    def named(x: float) -> str:
        return Phrase("{x:.5g} {unit}", x=x * unit * factor, unit=said)

    if low < reach:
        over = passed[0] / unit, passed[1] / unit
        yield from _held(acting.load, x, values, over, reach / unit, named, stroke)


def of_range(acting: Acting, x: Real, values: Sequence[float]) -> Iterator[Grade]:
    """Where a motion that is no cycle goes beyond a table of the angle with the abscissae ``x``."""
    travel = acting.travel
    passed = (0.0, travel.period) if _whole(acting.load) else _passed(acting, travel.theta(acting.dense.x))
    (end,) = travel.named(np.array([travel.period]))

    def named(at: float) -> str:
        return travel.named(np.array([at]))[0]

    yield from _held(
        acting.load, x, values, passed, travel.period, named, Phrase("the motion goes from 0 to {end}", end=end)
    )


def _whole(load: Load) -> bool:
    """Whether a load acts from one end of the way to the other."""
    return load.window is None or load.window.stroke is not None


def _passed(acting: Acting, values: Real) -> tuple[float, float]:
    """Least and largest of some values (m,) over the survey where the load acts."""
    travel, dense, window = acting.travel, acting.dense, acting.window
    theta = travel.theta(dense.x)
    turns = round(travel.period / TURN) if travel.whole else 1
    acts = np.zeros(theta.shape, dtype=bool)
    for k in range(turns):
        acts |= window.inside(Place(theta + TURN * k, dense.configuration))
    inside = values[acts]
    return (float(inside.min()), float(inside.max())) if inside.size else (math.inf, -math.inf)


def _held(
    load: Load,
    x: Sequence[float] | Real,
    values: Sequence[float],
    passed: tuple[float, float],
    way: float,
    named: Callable[[float], str],
    limit: str,
) -> Iterator[Grade]:
    """The values other than zero that hold beyond the ends of a table."""
    first, last, unit = float(x[0]), float(x[-1]), "N" if load.kind == "force" else "N*m"
    ends, held = [], []
    if passed[0] < first - SLACK * way and values[0]:
        ends.append(Phrase("begins at {named}", named=named(first)))
        held.append(Phrase("before it the first value {value:.5g} {unit} is held", value=values[0], unit=unit))
    if passed[1] > last + SLACK * way and values[-1]:
        ends.append(Phrase("ends at {named}", named=named(last)))
        held.append(Phrase("beyond it the last value {value:.5g} {unit} is held", value=values[-1], unit=unit))
    if ends:
        text = Phrase(
            "its table {ends}, but {limit}: {held}; extend the table, end it with 0, or give the load a window",
            ends=listed(ends, " and "),
            limit=limit,
            held=listed(held, ", "),
        )
        yield Grade("warning", Phrase("load {name}", name=load.name), text)
