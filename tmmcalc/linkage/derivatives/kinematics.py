"""Derivatives of the results of the kinematics stage by its inputs, exact: of every column, of strokes and extremes.

A column is followed at its row: dq/dp = q_p + q_x dx/dp, where x of the row moves with position 0. Extremes of a smooth
function change as the function at their place does (the envelope theorem), those at the ends of a range with the ends.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from tmmcalc.core.derivatives import Derivative
from tmmcalc.core.plane import Plane, Real
from tmmcalc.core.records import record
from tmmcalc.linkage.assembly import TURN
from tmmcalc.linkage.chain import Step, chain_of
from tmmcalc.linkage.columns import columns
from tmmcalc.linkage.derivatives.closure import EPS, Moved, Slopes
from tmmcalc.linkage.derivatives.rows import SAME, Directions, Placing, directions_of, ends_of, placing, row_shifts
from tmmcalc.linkage.model import Mechanism, Output
from tmmcalc.linkage.outputs import default_outputs
from tmmcalc.linkage.results import Extreme, Kinematics, OutputSummary

MARGIN = 8.0  # of the roundings of one solution, in units of the condition times the last digit
RIGHT = 1e-9  # a squared sine nearer than this to 1 is that of a right angle, which no change makes larger


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


@record
class KinematicsDerivatives:
    """Derivatives along K directions of the inputs.

    ``columns`` by ``name[unit]``; ``transmission`` by group: of its smallest angle [rad], None where it is a right
    angle. ``x`` (K, n): how the input coordinates of the rows move. Where two places have the same extreme, it is
    followed at the one that the result names, which is one side of a kink.
    """

    columns: dict[str, Derivative]
    outputs: tuple[OutputDerivatives, ...]
    transmission: dict[str, Derivative | None]
    x: Real
    speed: Real  # (K,) of the input, and its acceleration
    acceleration: Real


class _Rates(NamedTuple):
    """How speed and acceleration of the input change, (K, 1) each, and what they are."""

    speed: float
    acceleration: float
    dspeed: Real
    dacceleration: Real

    def velocity(self, jet: Real, change: Real) -> Real:
        """Change of S' omega, of a jet and its change."""
        return change[1] * self.speed + jet[1] * self.dspeed

    def in_time(self, jet: Real, change: Real) -> Real:
        """Change of S'' omega^2 + S' eps."""
        steady = change[2] * self.speed**2 + 2 * jet[2] * self.speed * self.dspeed
        return steady + change[1] * self.acceleration + jet[1] * self.dacceleration

    def sizes(self, size: Real) -> Real:
        """Errors (5, K) of value, velocity, acceleration and both transfer functions, from those of a jet (3, K)."""
        w, eps = abs(self.speed), abs(self.acceleration)
        own = np.abs(self.dspeed[:, 0]), np.abs(self.dacceleration[:, 0])
        velocity = size[1] * w + EPS * own[0] * size[1]
        return np.stack([size[0], velocity, size[2] * w**2 + size[1] * eps + EPS * sum(own) * size[2], *size[1:]])


def differentiate_kinematics(mechanism: Mechanism, kinematics: Kinematics, slopes: Slopes) -> KinematicsDerivatives:
    """Derivatives of a result along K directions: ``slopes`` (K, L) of the numbers of the mechanism.

    The numbers stand in the order of `core.numerics.alike.numbers`. The error of a derivative is the rounding of the
    linear systems: their condition times the last digit of the largest change, with the error of what they stand on.
    """
    chain = chain_of(mechanism, kinematics)
    directions = directions_of(mechanism, chain, kinematics, slopes, kinematics.x)
    outputs = default_outputs(chain)
    placed = placing(directions, outputs)
    shifts = row_shifts(directions, placed)
    dx = placed.start + shifts
    moved, along = directions.at(kinematics.x)
    whole = moved.along(along, dx)
    drive = directions.changes.input
    rates = _Rates(kinematics.speed, kinematics.acceleration, drive.speed, drive.acceleration)
    size = _size(kinematics, moved, along, dx, placed)
    found = [Derivative(shifts, placed.error + EPS * np.max(np.abs(shifts), axis=1))]
    found += _columns(whole, outputs, rates, size)
    told = columns(kinematics)
    scaled = {
        each.header: Derivative(np.degrees(one.value), np.degrees(one.error)) if each.unit == "deg" else one
        for each, one in zip(told, found, strict=True)
    }
    summaries = zip(outputs, kinematics.summaries, strict=True)
    return KinematicsDerivatives(
        columns=scaled,
        outputs=tuple(
            _summary(directions, placed, rates, k, output, summary) for k, (output, summary) in enumerate(summaries)
        ),
        transmission=dict(_transmissions(directions, placed)),
        x=dx,
        speed=np.asarray(drive.speed)[:, 0],
        acceleration=np.asarray(drive.acceleration)[:, 0],
    )


def _size(kinematics: Kinematics, moved: Moved, along: Moved, dx: Real, placed: Placing) -> Real:
    """Errors (3, K) of changes of points [m] of each order."""
    base = np.array([kinematics.error.position, kinematics.error.velocity, kinematics.error.acceleration])
    rounding = np.maximum(np.maximum.accumulate(base), EPS)[:, None]
    shift = np.max(np.abs(dx), axis=1)
    condition = float(np.max(moved.condition))
    return MARGIN * rounding * condition * (moved.largest() + along.largest() * shift) + along.largest() * placed.error


def _columns(whole: Moved, outputs: tuple[Output, ...], rates: _Rates, size: Real) -> Iterator[Derivative]:
    """Derivatives of all columns after phi in their order."""
    chain = whole.chain
    for number, output in enumerate(outputs):
        jet, change = whole.output(output, number)
        change = np.concatenate((change[:1] - change[:1, :, :1], change[1:]))
        yield from _five(jet, change, rates, 2 * size / (whole.reach if output.link is not None else 1.0))
    for link in chain.layout.links:
        u = whole.bodies[link].u
        omega, eps = (u[1] / u[0]).imag, (u[2] / u[0]).imag
        yield from _five(np.stack([omega, omega, eps]), whole.links[link].angle, rates, size / whole.reach)
    for name, link, _ in chain.layout.points:
        r, dr = whole.named(link, name)
        yield from _five(r.real, dr.real, rates, size)
        yield from _five(r.imag, dr.imag, rates, size)
    for joint in chain.layout.joints:
        yield from _five(*whole.slide(chain.mechanism.joint(joint)), rates, size)


def _five(jet: Real, change: Real, rates: _Rates, size: Real) -> Iterator[Derivative]:
    """Derivatives of a value, its velocity and acceleration, its first and second transfer function."""
    values = (change[0], rates.velocity(jet, change), rates.in_time(jet, change), change[1], change[2])
    for value, error in zip(values, rates.sizes(size), strict=True):
        yield Derivative(value, error)


def _summary(
    directions: Directions, placed: Placing, rates: _Rates, number: int, output: Output, summary: OutputSummary
) -> OutputDerivatives:
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
    rates: _Rates,
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
            still = _Rates(rates.speed, rates.acceleration, np.zeros((1, 1)), np.zeros((1, 1)))
            steady = still.in_time if accelerates else still.velocity
            value = value + steady(jet, along.output(output, number)[1])[:, 0] * dx
    size = _size(directions.kinematics, moved, along, placed.start, placed)
    size = size / (moved.reach if output.link is not None else 1.0)
    return Derivative(value, rates.sizes(size)[2 if accelerates else 1])


def _transmissions(directions: Directions, placed: Placing) -> Iterator[tuple[str, Derivative | None]]:
    """Of the smallest transmission angle of every dyad."""
    ends = ends_of(directions, placed)
    for step, quality in zip(directions.chain.steps, directions.kinematics.qualities, strict=True):
        if quality.transmission is None or not isinstance(step, Step):
            continue
        at = directions.start if quality.transmission_at is None else quality.transmission_at
        moved, along = directions.at(np.array([at]))
        (sine2, change), rate = _squared_sine(moved, step), _squared_sine(along, step)[1]
        if 1 - sine2 < RIGHT:
            yield quality.group, None
            continue
        for x, dx in ends:
            if quality.transmission_at is not None and abs(at - x) <= 1e-9 * max(1.0, abs(x)):
                change = change + rate * dx
        factor = 1 / (2 * math.sqrt(sine2 * (1 - sine2)))
        error = MARGIN * EPS * np.max(moved.condition) * moved.largest()[0] / moved.reach
        yield quality.group, Derivative(factor * change, factor * error)


def _squared_sine(moved: Moved, step: Step) -> tuple[float, Real]:
    """Squared sine of the transmission angle at one place, and its change (K,).

    Between the two links (RRR), between a rod, or the line of the pivots, and a guide it is that from the guide's
    normal (RRP, RPR), between two guides (PRP, RPP).
    """
    mechanism, kind = moved.chain.mechanism, step.group.kind
    outer = [mechanism.joint(name) for name in step.group.outer]
    inner = mechanism.joint(step.group.inner[0])

    def place(name: int) -> tuple[complex, Plane]:
        joint = (*outer, inner)[name]
        r, dr = moved.pin(joint, 0)
        return complex(r[0, 0, 0]), dr[0, :, 0]

    def line(name: int) -> tuple[complex, Plane]:
        e, de = moved.line((*outer, inner)[name])
        return complex(e[0, 0, 0]), de[0, :, 0]

    def between(one: int, other: int) -> tuple[complex, Plane]:
        (a, da), (b, db) = place(one), place(other)
        return b - a, db - da

    one, other = {
        "RRR": lambda: (between(0, 2), between(1, 2)),
        "RRP": lambda: (between(0, 2), line(1)),
        "RPR": lambda: (between(0, 1), line(2)),
        "PRP": lambda: (line(0), line(1)),
        "RPP": lambda: (line(2), line(1)),
    }[kind]()
    ratio = one[0] / other[0]
    turning = (one[1] / one[0] - other[1] / other[0]).imag
    angle = math.atan2(ratio.imag, ratio.real)
    if kind in ("RRP", "RPR"):
        return math.cos(angle) ** 2, -math.sin(2 * angle) * turning
    return math.sin(angle) ** 2, math.sin(2 * angle) * turning
