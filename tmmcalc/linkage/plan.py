"""The position plan: the numbered positions of a linkage with the stroke that each belongs to.

Position 0 is the dead centre before the working stroke (``start = "extreme"``); the other dead centres are positions of
their own, or coincide with one. A full turn has no closing position: it is position 0.
"""

from __future__ import annotations

import math

import numpy as np

from tmmcalc.core.plane import Real
from tmmcalc.core.quantity import quantity
from tmmcalc.core.records import record
from tmmcalc.linkage.assembly import TURN
from tmmcalc.linkage.chain import chain_of
from tmmcalc.linkage.grid import SAME
from tmmcalc.linkage.model import Mechanism
from tmmcalc.linkage.outputs import coordinate_of, output_named
from tmmcalc.linkage.results import Kinematics


@record
class PositionPlan:
    """n positions in the order of the motion, for one output."""

    output: str = quantity("output", "the output")
    angular: bool  # whether the output is an angle
    turns: bool  # crank (True) or driven slider
    labels: tuple[str, ...] = quantity("i", "number of the position")  # (n,)
    x: Real = quantity("input[{per}]", "input coordinate")  # (n,)
    phi: Real = quantity("phi[{per}]", "input coordinate counted from position 0")  # (n,)
    value: Real = quantity("{output}[{unit}]", "output coordinate")  # (n,)
    # (n,) working, idle, stroke 1 ... where there are more; empty without reversals
    strokes: tuple[str, ...] = quantity("stroke", "the stroke that the position belongs to")
    extremes: tuple[str, ...] = quantity("extreme", "whether the position is a dead centre")  # (n,) empty: it is not
    dead_centres: Real = quantity(  # (k,)
        "dead_centres[{per}]", "input coordinates of the dead centres, the one before the working stroke first"
    )
    stroke: float | None = quantity("stroke[{unit}]", "largest distance between dead centres")
    time_ratio: float | None = quantity("K", "ratio of the times of the strokes")


def position_plan(mechanism: Mechanism, result: Kinematics, output: str | None = None) -> PositionPlan:
    """The plan of a kinematics result for an output, the first by default; raises what `output_named` does."""
    chain = chain_of(mechanism, result)
    told = output_named(chain, output, "kinematics, --plan")
    summary = next(each for each in result.summaries if each.name == told.name)
    full = result.turns and abs(abs(float(result.phi[-1] - result.phi[0])) - TURN) < SAME
    count = len(result.x) - full
    if told.link is not None:
        value = result.trace.angle[result.trace.link_ids.index(told.link)]
    else:
        value = np.broadcast_to(coordinate_of(chain, told, chain.evaluate(result.x))[0], result.x.shape)
    centres = np.array([centre.x for centre in summary.dead_centres])
    strokes, extremes = _strokes(result, centres, count, full)
    return PositionPlan(
        output=summary.name,
        angular=summary.angular,
        turns=result.turns,
        labels=result.labels[:count],
        x=result.x[:count],
        phi=result.phi[:count],
        value=np.array(value[:count]),
        strokes=strokes,
        extremes=extremes,
        dead_centres=centres,
        stroke=summary.stroke,
        time_ratio=summary.time_ratio,
    )


def _strokes(result: Kinematics, centres: Real, count: int, full: bool) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """The stroke of each position, by the dead centre that it comes after, and whether it is one itself."""
    nothing = ("",) * count
    if not centres.size:
        return nothing, nothing
    sense = math.copysign(1.0, result.speed)
    step = float(np.min(np.abs(np.diff(result.x)))) if len(result.x) > 1 else 1.0
    along = sense * (result.x[:count, None] - centres)
    along = np.mod(along + SAME, TURN) - SAME if full else np.where(along < -SAME * step, np.inf, along)
    last = np.argmin(along, axis=1)
    names = ("working", "idle") if full and len(centres) == 2 else tuple(f"stroke {k + 1}" for k in range(len(centres)))
    strokes = tuple(names[k] if np.isfinite(along[row, k]) else "" for row, k in enumerate(last))
    at = np.abs(along[np.arange(count), last]) < max(SAME * step, 1e-9)
    return strokes, tuple("dead centre" if there else "" for there in at)
