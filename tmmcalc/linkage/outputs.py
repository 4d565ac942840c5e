"""Outputs: displacement, dead centres, strokes, time ratio, extreme velocities and accelerations.

An output is the coordinate of a point along a direction, the angle of a link, or the coordinate of a
prismatic joint. Its dead centres are the roots of its first transfer function at which it changes sign,
found by bracketing on a dense sample and refined to full precision; extreme velocities and accelerations
are refined the same way, never read off the grid.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.core.numerics.extrema import around, maxima, refine, with_turning_points
from tmmcalc.core.numerics.roots import Indices, bracketed
from tmmcalc.core.plane import Real
from tmmcalc.linkage.assembly import TURN
from tmmcalc.linkage.chain import Chain, Configuration
from tmmcalc.linkage.model import Output
from tmmcalc.linkage.results import DeadCentre, Extreme, OutputSummary
from tmmcalc.linkage.survey import Evaluate, Survey, alone, along_motion
from tmmcalc.linkage.trace import continuous

STILL = 1e-12  # an output whose rate is below this, against the size of the mechanism, does not move
EQUAL = 1e-9  # strokes that differ by less [rad] count as equal
CONSTANT = 1e-13  # a rate that varies less, against its largest value, is constant
CANDIDATES = 2  # local extrema refined in the search for the global one
SIDES = np.array([-1.0, 1.0])  # the least and the largest

Coordinates = tuple[Real, Real, Real]
Extremes = tuple[tuple[Extreme, Extreme], tuple[Extreme, Extreme]]  # of velocity and acceleration


def coordinate_of(chain: Chain, output: Output, configuration: Configuration) -> Coordinates:
    """Value and both derivatives of an output, each (n,); the angle of a link is not yet continuous."""
    if output.link is not None:
        motion = configuration.motions[output.link]
        return np.arctan2(motion.u.imag, motion.u.real), motion.omega, motion.eps
    if output.joint is not None:
        return configuration.slides[output.joint]
    owner = next(link for link in chain.mechanism.links if output.point in link.points)
    at = configuration.motions[owner.id].point(owner.points[output.point or ""])
    turn = np.exp(-1j * output.direction) if output.direction else 1.0
    return (at.r * turn).real, (at.v * turn).real, (at.a * turn).real


def default_outputs(chain: Chain) -> tuple[Output, ...]:
    """The outputs of the spec, or else the last link that is joined to the frame."""
    if chain.mechanism.outputs:
        return chain.mechanism.outputs
    for group in reversed(chain.structure.groups):
        for joint in (chain.mechanism.joint(name) for name in reversed(group.outer)):
            if 0 not in joint.links:
                continue
            if joint.kind == "prismatic":
                return (Output(joint=joint.name),)
            return (Output(link=next(k for k in joint.links if k)),)
    return ()


def output_named(chain: Chain, name: str | None, where: str) -> Output:
    """The output of this name, the first one for None.

    Raises `UsageError` for another name, `NoSolutionError` if there is no output.
    """
    outputs = default_outputs(chain)
    found = next((output for output in outputs if name in {None, output.name}), None)
    if found is not None:
        return found
    if not outputs:
        raise NoSolutionError("the mechanism has no output", where=where, remedy="name one in [[mechanism.outputs]]")
    known = ", ".join(output.name for output in outputs)
    raise UsageError(f"there is no output {name!r}", where=where, remedy=f"outputs: {known}")


def sampled(chain: Chain, output: Output, dense: Survey) -> Coordinates:
    """Value (angles continuous) and both derivatives of an output over the survey, each (m,)."""
    value, rate, rate2 = coordinate_of(chain, output, dense.configuration)
    if output.link is not None:
        value = dense.angle(output.link)
    shape = dense.x.shape
    return np.broadcast_to(value, shape), np.broadcast_to(rate, shape), np.broadcast_to(rate2, shape)


def dead_centres(chain: Chain, output: Output, dense: Survey, rate: Real) -> Real:
    """Ascending input coordinates of all reversals of an output, from its rate (m,) over the survey."""

    def rates(at: Real, _: object) -> Real:
        return np.broadcast_to(coordinate_of(chain, output, chain.evaluate(at))[1], at.shape)

    largest = float(np.max(np.abs(rate)))
    if largest <= STILL * _scale(chain, output):
        return np.empty(0)
    if dense.full:
        rate = np.append(rate[:-1], rate[0])  # the same sign on both sides of the seam, whatever the rounding
    period = TURN if dense.full else None
    x, rate = with_turning_points(rates, dense.x, rate, near=0.02 * largest, period=period)
    sign = _signs(rate, dense.full)
    change = np.flatnonzero(sign[1:] != sign[:-1])
    low, high = rate[change], rate[change + 1]
    first = x[change] + (x[change + 1] - x[change]) * (low / (low - high))
    return bracketed(rates, x[change], x[change + 1], known=(low, high, first))


def _signs(rate: Real, periodic: bool) -> Real:
    """Signs of samples (n,), where a zero takes the sign before it: a rate that only touches zero reverses nothing."""
    sign = np.sign(rate)
    moving = np.flatnonzero(sign)
    last = np.maximum.accumulate(np.where(sign != 0, np.arange(len(sign)), -1))
    return sign[np.where(last >= 0, last, moving[-1] if periodic else moving[0])]


def _scale(chain: Chain, output: Output) -> float:
    """Scale of an output's rate, against which rounding is judged: sizes are the largest coordinate of the metric."""
    links = (chain.mechanism.frame, *chain.mechanism.links)
    size = max((abs(p) for link in links for p in link.points.values()), default=1.0) or 1.0
    return (1.0 if output.link is not None else size) / (1.0 if chain.turns else size)


def values_at(chain: Chain, output: Output, at: Real, dense: Survey) -> Real:
    """Output coordinate at ``at`` (m,), which of a full turn may lie a turn beside the survey; angles continuous."""
    raw = np.broadcast_to(coordinate_of(chain, output, chain.evaluate(at, order=0))[0], at.shape)
    if output.link is None:
        return raw
    x, link_angles = dense.link_angles()
    return continuous(raw[None], at, x, link_angles[[dense.links.index(output.link)]])[0]


def order_from_working(chain: Chain, output: Output, centres: Real, values: Real, gain: float) -> Real:
    """Rotate the dead centres of a full turn so that the first is the one before the working stroke.

    The working stroke is the one against the useful resistance if its sense is given, else the longest in
    crank angle; of equal ones the one that starts at the greatest coordinate (right, upper). ``gain`` is what the
    output gains over a positive turn of the crank: whole turns of a link that goes round.
    """
    if chain.mechanism.input.speed < 0:
        centres, values, gain = centres[::-1], values[::-1], -gain
    lengths = np.abs(np.diff(np.append(centres, centres[0] + math.copysign(TURN, chain.mechanism.input.speed))))
    travel = np.diff(np.append(values, values[0] + gain))
    keys = np.where(lengths > lengths.max() - EQUAL, values, -np.inf)
    if output.resistance is not None:
        against = travel < 0 if output.resistance == "positive" else travel > 0
        keys = np.where(against, lengths, -np.inf)
    return np.roll(centres, -int(np.argmax(keys)))


def working_centres(chain: Chain, dense: Survey) -> Real:
    """Dead centres (k,) of the first output over a full turn, the one before the working stroke first.

    Raises `NoSolutionError` if there is no output or it never reverses.
    """
    outputs = default_outputs(chain)
    if not outputs:
        raise NoSolutionError(
            'start = "extreme" needs an output, and no link of the groups is joined to the frame',
            where="kinematics, input.start",
            remedy="name one in [[mechanism.outputs]], or give input.start as a number",
        )
    value, rate, _ = sampled(chain, outputs[0], dense)
    centres = dead_centres(chain, outputs[0], dense, rate)
    if centres.size < 2:
        raise NoSolutionError(
            f"output {outputs[0].name} never reverses, so there is no extreme position to start from",
            where="kinematics, input.start",
            remedy='give input.start as a number, e.g. start = "0 deg"',
        )
    values = values_at(chain, outputs[0], centres, dense)
    return order_from_working(chain, outputs[0], centres, values, gain_of(outputs[0], value))


def gain_of(output: Output, track: Real) -> float:
    """What an output gains over the survey of a turn: nothing, but for the whole turns of a link."""
    return TURN * round(float(track[-1] - track[0]) / TURN) if output.link is not None else 0.0


def summarise(chain: Chain, output: Output, dense: Survey, start: float, known: Real | None = None) -> OutputSummary:
    """Dead centres, strokes and extremes of an output over the survey of a range that begins at ``start``.

    ``known`` are its dead centres (k,) of a full turn, if they have been searched before.
    """
    samples = sampled(chain, output, dense)
    if known is not None and dense.full and chain.structure.dyads_only:
        centres = np.sort(known)
    else:  # a chain of a higher group may come back after several turns, of which each is another one
        centres = dead_centres(chain, output, dense, samples[1])
    values = values_at(chain, output, centres, dense)
    gain, ends = gain_of(output, samples[0]), samples[0][[0, -1]]
    stroke = stroke_of(values, gain) if dense.full else float(np.ptp(np.append(values, ends)))
    if dense.full and centres.size > 1:
        ordered = order_from_working(chain, output, centres, values, gain)
        centres = along_motion(chain, ordered, start)
        values = values_at(chain, output, centres, dense)
    drive = chain.mechanism.input
    extremes = extremes_of(
        chain,
        alone(chain),
        lambda own, configuration: coordinate_of(own, output, configuration),
        dense.x[None],
        (samples[1][None], samples[2][None]),
        np.array([start]),
        (np.array([drive.speed]), np.array([drive.acceleration])),
        full=dense.full,
    )[0]
    return summary_of(chain, output, (centres, values), stroke, dense.full, extremes)


def summary_of(
    chain: Chain, output: Output, centres: tuple[Real, Real], stroke: float | None, full: bool, extremes: Extremes
) -> OutputSummary:
    """The summary of an output from its dead ``centres`` in order and its values there, each (m,)."""
    angles: tuple[float | None, float | None] = (None, None)
    if full and centres[0].size == 2:
        working = float(working_angle(centres[0], chain.mechanism.input.speed))
        angles = working, TURN - working
    return OutputSummary(
        output.name,
        output.link is not None,
        tuple(DeadCentre(float(a), float(b)) for a, b in zip(*centres, strict=True)),
        stroke,
        *angles,
        angles[0] / angles[1] if angles[0] is not None and angles[1] else None,
        *extremes,
    )


def working_angle(centres: Real, speed: float) -> Real:
    """Angle (...) of the crank [rad] over the working stroke, between two dead centres (..., 2) in their order."""
    return np.mod((centres[..., 1] - centres[..., 0]) * math.copysign(1.0, speed), TURN)


def stroke_of(values: Real, gain: float) -> float | None:
    """Largest distance between the dead centres of a full turn; None where the output does not reverse.

    A link that goes round and reverses, so that it has a ``gain``, has none: its longest single stroke is taken.
    """
    if values.size < 2:
        return None
    return float(np.max(np.abs(np.diff(np.append(values, values[0] + gain))))) if gain else float(np.ptp(values))


def _highest(samples: Real, full: bool) -> tuple[Indices, NDArray[np.bool_]]:
    """Where the highest local maxima of samples (..., m) stand, (..., CANDIDATES), and which of them there are.

    Samples without a local maximum have one guess, the highest of them.
    """
    inside = samples[..., :-1] if full else samples
    score = np.where(maxima(inside, full), inside, -np.inf).reshape(-1, inside.shape[-1])
    each = np.arange(len(score))
    rows = np.empty((len(score), CANDIDATES), np.intp)
    found = np.empty(rows.shape, bool)
    for k in range(CANDIDATES):
        rows[:, k] = highest = score.argmax(axis=1)
        found[:, k] = score[each, highest] > -np.inf
        score[each, highest] = -np.inf
    rows[:, 0] = np.where(found[:, 0], rows[:, 0], samples.argmax(axis=-1).ravel())
    found[:, 0] = True
    shape = *samples.shape[:-1], CANDIDATES
    return rows.reshape(shape), found.reshape(shape)


def extremes_of(
    chain: Chain,
    evaluate: Evaluate,
    coordinate: Callable[[Chain, Configuration], Coordinates],
    x: Real,
    samples: tuple[Real, Real],
    start: Real,
    drive: tuple[Real, Real],
    *,
    full: bool,
) -> list[Extremes]:
    """Smallest and largest velocity and acceleration in time of an output of V variants, at exact input coordinates.

    ``samples`` (V, m) of its first and second derivative stand at x (V, m), ``drive`` are speeds and accelerations (V,)
    of the input. The highest local extremes of the samples are refined, the ends among them on an open range. What does
    not change over the range is said to stand at ``start`` (V,), position 0.
    """
    speed, acceleration = drive

    def in_time(rate: Real, rate2: Real, w: Real, eps: Real) -> Real:
        return np.stack((rate * w, rate2 * w**2 + rate * eps))

    sampled = in_time(*samples, speed[:, None], acceleration[:, None])
    sided = SIDES[:, None, None] * sampled[:, None]  # (kind, side, V, m)
    rows, guessed = _highest(sided, full)
    kind, side, variant, _ = np.nonzero(guessed)
    row = rows[guessed]

    def rates(at: Real, which: Indices) -> Real:
        def of_kind(own: Chain, configuration: Configuration, part: Indices) -> Real:
            its = which[part]
            both = in_time(*coordinate(own, configuration)[1:], speed[variant[its]], acceleration[variant[its]])
            return np.asarray(both[kind[its], np.arange(len(its))])

        return evaluate(at, variant[which], of_kind, 2)

    at, values = refine(rates, *around(x, row, full, variant))
    values = SIDES[side] * values
    if full:
        at = along_motion(chain, at, start[variant])
    else:
        ends = sided[kind, side, variant, row]
        higher = ((row == 0) | (row == x.shape[1] - 1)) & (ends >= values)
        at, values = np.where(higher, x[variant, row], at), np.where(higher, ends, values)
    found, place = np.full(guessed.shape, -np.inf), np.empty(guessed.shape)
    found[guessed], place[guessed] = values, at
    value, best = np.max(found, axis=-1), np.argmax(found, axis=-1)[..., None]
    place = np.take_along_axis(place, best, -1)[..., 0]
    still = (np.ptp(sampled, axis=2) <= CONSTANT * np.max(np.abs(sampled), axis=2))[:, None]
    value = np.where(still, sampled[:, None, :, 0], SIDES[:, None] * value)
    place = np.where(still, start, place)

    def extreme(v: int, kind: int, side: int) -> Extreme:
        return Extreme(float(value[kind, side, v]), float(place[kind, side, v]))

    return [((extreme(v, 0, 0), extreme(v, 0, 1)), (extreme(v, 1, 0), extreme(v, 1, 1))) for v in range(len(x))]
