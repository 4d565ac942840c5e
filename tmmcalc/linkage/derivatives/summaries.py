"""Derivatives of what is summed up of an output: dead centres, strokes, their times, extremes.

Extremes of a smooth function change as the function at their place does (the envelope theorem), those at the ends of a
range with the ends. Where two places have the same extreme, it is followed at the one that the result names, which is
one side of a kink.
"""

from __future__ import annotations

import numpy as np

from tmmcalc.core.derivatives import Derivative
from tmmcalc.core.plane import Real
from tmmcalc.core.records import record
from tmmcalc.linkage.assembly import TURN
from tmmcalc.linkage.derivatives.closure import EPS
from tmmcalc.linkage.derivatives.rates import MARGIN, Rates, size_of
from tmmcalc.linkage.derivatives.rows import SAME, Directions, Placing, ends_of
from tmmcalc.linkage.model import Output
from tmmcalc.linkage.outputs import default_outputs
from tmmcalc.linkage.results import Extreme, OutputSummary


@record
class OutputDerivatives:
    """Derivatives of a summary of an output, by the names of its fields; None: not given exactly, or not there.

    ``dead_centres`` are those of the input coordinates (K, m), ``dead_values`` of the output there (K, m); ``velocity``
    and ``acceleration`` are those of the least and of the largest.
    """

    name: str
    dead_centres: Derivative
    dead_values: Derivative
    stroke: Derivative | None
    working_angle: Derivative | None
    idle_angle: Derivative | None
    time_ratio: Derivative | None
    velocity: tuple[Derivative, Derivative]
    acceleration: tuple[Derivative, Derivative]


def summary_of(
    directions: Directions, placed: Placing, rates: Rates, number: int, output: Output, summary: OutputSummary
) -> OutputDerivatives:
    """Of the summary of an output by its number."""
    turns = placed.turns[number]
    working = idle = ratio = None
    if summary.working_angle is not None and summary.idle_angle:
        change = directions.sense * (turns.x[:, 1] - turns.x[:, 0])
        error = 2 * MARGIN * turns.x_error
        working, idle = Derivative(change, error), Derivative(-change, error)
        factor = TURN / summary.idle_angle**2
        ratio = Derivative(factor * change, factor * error)
    kinds = (summary.velocity, summary.acceleration)
    extremes = [
        tuple(_extreme(directions, placed, rates, number, output, each, accelerates=bool(kind)) for each in pair)
        for kind, pair in enumerate(kinds)
    ]
    return OutputDerivatives(
        name=summary.name,
        dead_centres=Derivative(turns.x, MARGIN * turns.x_error),
        dead_values=Derivative(turns.value, MARGIN * turns.value_error),
        stroke=_stroke(directions, placed, number, output, summary),
        working_angle=working,
        idle_angle=idle,
        time_ratio=ratio,
        velocity=(extremes[0][0], extremes[0][1]),
        acceleration=(extremes[1][0], extremes[1][1]),
    )


def _stroke(
    directions: Directions, placed: Placing, number: int, output: Output, summary: OutputSummary
) -> Derivative | None:
    """Of the largest distance between dead centres, or ends of an open range; None of a link that goes round."""
    if summary.stroke is None:
        return None
    turns = placed.turns[number]
    values = np.array([centre.value for centre in summary.dead_centres])
    changes, error = turns.value, 2 * MARGIN * turns.value_error
    ends = ends_of(directions, placed)
    if ends:
        at = np.array([x for x, _ in ends])
        moved, along = directions.at(at)
        dx = np.stack([d for _, d in ends], axis=1)
        changes = np.concatenate((changes, moved.along(along, dx).output(output, number)[1][0]), axis=1)
        error = error + 2 * MARGIN * EPS * np.max(moved.condition) * moved.largest()[0]
        values = np.append(values, _values_at_ends(directions, number, at))
    low, high = int(np.argmin(values)), int(np.argmax(values))
    if abs(values[high] - values[low] - summary.stroke) > SAME * summary.stroke:
        return None  # a link that goes round has its longest stroke from one of its dead centres to the next
    return Derivative(changes[:, high] - changes[:, low], error)


def _values_at_ends(directions: Directions, number: int, at: Real) -> Real:
    """The output at both ends of the range, of which the rows hold the displacement; its first is position 0."""
    kinematics = directions.kinematics
    centres, s = kinematics.summaries[number].dead_centres, kinematics.s[number]
    rows = [int(np.argmin(np.abs(kinematics.x - x))) for x in at]
    value = s[rows]
    if centres:
        from tmmcalc.linkage.kinematics import output_row

        value = value + output_row(default_outputs(directions.chain)[number], kinematics.trace)[0][0]
    return value


def _extreme(
    directions: Directions,
    placed: Placing,
    rates: Rates,
    number: int,
    output: Output,
    extreme: Extreme,
    *,
    accelerates: bool,
) -> Derivative:
    """Of an extreme velocity or acceleration, which may stand at the end of a range."""
    moved, along = directions.at(np.array([extreme.x]))
    kind = rates.in_time if accelerates else rates.velocity
    jet, change = moved.output(output, number)
    value = kind(jet, change)[:, 0]
    for x, dx in ends_of(directions, placed):
        if abs(extreme.x - x) <= 1e-9 * max(1.0, abs(x)):
            still = Rates(rates.speed, rates.acceleration, np.zeros((1, 1)), np.zeros((1, 1)))
            steady = still.in_time if accelerates else still.velocity
            value = value + steady(jet, along.output(output, number)[1])[:, 0] * dx
    size = size_of(directions.kinematics, moved, along, placed.start, placed)
    size = size / (moved.reach if output.link is not None else 1.0)
    return Derivative(value, rates.sizes(size)[2 if accelerates else 1])
