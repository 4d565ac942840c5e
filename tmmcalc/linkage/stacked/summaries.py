"""What the summary of kinematics tells of many variants: strokes and extremes of outputs, transmission of dyads."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from tmmcalc.core.numerics.extrema import refine
from tmmcalc.core.numerics.roots import Indices
from tmmcalc.core.plane import Real
from tmmcalc.linkage.chain import Chain, Configuration
from tmmcalc.linkage.outputs import (
    CANDIDATES,
    CONSTANT,
    Extremes,
    coordinate_of,
    default_outputs,
    gain_of,
    order_from_working,
    stroke_of,
    summary_of,
)
from tmmcalc.linkage.quality import CONSTANT as FLAT
from tmmcalc.linkage.quality import Measure, least_first, quality_of
from tmmcalc.linkage.results import Extreme, GroupQuality, OutputSummary
from tmmcalc.linkage.stacked.dense import Dense, looked_at, values_at
from tmmcalc.linkage.stacked.scene import Block
from tmmcalc.linkage.survey import Survey, along_motion
from tmmcalc.linkage.trace import continuous

SIDES = (-1, 1)  # the least and the largest


class _Guesses(NamedTuple):
    """Samples next to which extremes are sought: of which variant, kind (velocity or acceleration) and side, (m,)."""

    variant: Indices
    kind: Indices
    side: Indices
    row: Indices


def qualities_of(block: Block, dense: Dense) -> list[tuple[GroupQuality, ...]]:
    """Quality of all groups of every variant of a survey."""
    varied = np.ptp(dense.squares, axis=2) > FLAT
    inside = dense.squares[..., :-1]
    owner, variant, row = np.nonzero(_turning(inside, -1) & varied[..., None])

    def f(at: Real, which: Indices) -> Real:
        def look(chain: Chain, configuration: Configuration, rows: Indices) -> Real:
            own = variant[which[rows]]
            found = [_at_rows(measure, own)(chain, configuration, at[rows]) for measure in dense.measures]
            return np.asarray(np.array(found)[owner[which[rows]], np.arange(len(rows))])

        return looked_at(block, dense.variants[variant[which]], at, look, order=0)

    sampled, x = dense.squares[owner, variant, row], dense.x[variant, row]
    at, sine2 = refine(f, x, _radius(dense.x, variant, row)) if len(row) else (x, sampled)
    better = sampled < sine2
    at, sine2 = np.where(better, x, at), np.where(better, sampled, sine2)
    at = _along(block, at, dense.start[variant])
    minima: list[list[list[tuple[float, float]]]] = [[[] for _ in dense.measures] for _ in dense.variants]
    for m, v, place, value in zip(owner.tolist(), variant.tolist(), at.tolist(), sine2.tolist(), strict=True):
        minima[v][m].append((max(value, 0.0) + 0.0, place))
    chain, measures = block.chain(0), list(dense.measures)
    return [
        tuple(
            quality_of(chain, k, measures, dense.squares[:, v], [least_first(each) for each in own])
            for k in range(len(chain.steps))
        )
        for v, own in enumerate(minima)
    ]


def summaries_of(block: Block, dense: Dense) -> list[tuple[OutputSummary, ...]]:
    """Summaries of all outputs of every variant of a survey."""
    by_output = [list(_summaries(block, dense, o)) for o in range(len(dense.outputs))]
    return list(zip(*by_output, strict=True)) if by_output else [() for _ in dense.variants]


def _summaries(block: Block, dense: Dense, o: int) -> Iterator[OutputSummary]:
    output, tracks = dense.outputs[o], dense.coordinates[o, 0]
    centres = block.settled.reversals[o][dense.variants]
    # in the order of the survey, which begins at position 0
    begin = dense.x[:, :1]
    centres = np.sort(begin + np.mod(centres - begin, 2 * np.pi), axis=1)
    values, gains = _values(block, dense, o, centres), [gain_of(output, track) for track in tracks]
    owns = [block.chain(int(v)) for v in dense.variants]
    ordered = centres
    if centres.shape[1] > 1:
        rows = zip(owns, centres, values, gains, dense.start, strict=True)
        ordered = np.array(
            [along_motion(own, order_from_working(own, output, *row), start) for own, *row, start in rows]
        )
    reached = _values(block, dense, o, ordered)
    each = zip(owns, ordered, reached, values, gains, _extremes(block, dense, o), strict=True)
    for own, at, there, met, gain, extremes in each:
        yield summary_of(own, output, (at, there), stroke_of(met, gain), True, extremes)


def _values(block: Block, dense: Dense, o: int, at: Real) -> Real:
    """Coordinate of an output at places (V, c), angles continuous."""
    output = dense.outputs[o]
    if not at.size:
        return at

    found = values_at(block, o, np.repeat(dense.variants, at.shape[1]), at.ravel()).reshape(at.shape)
    if output.link is None:
        return found
    rows = []
    for raw, places, x, track in zip(found, at, dense.x, dense.coordinates[o, 0], strict=True):
        survey = Survey(x, Configuration({}, {}, [], []), (output.link,), track[None], True)
        rows.append(continuous(raw[None], places, *survey.tracks())[0])
    return np.array(rows)


def _extremes(block: Block, dense: Dense, o: int) -> list[Extremes]:
    """Smallest and largest velocity and acceleration of an output in time, of every variant."""
    drive = block.chain.tree.mechanism.input
    speed, acceleration = (
        np.broadcast_to(np.asarray(v, float), block.size)[dense.variants] for v in (drive.speed, drive.acceleration)
    )

    def in_time(rate: Real, rate2: Real, w: Real, eps: Real) -> Real:
        return np.stack((rate * w, rate2 * w**2 + rate * eps))

    sampled = in_time(dense.coordinates[o, 1], dense.coordinates[o, 2], speed[:, None], acceleration[:, None])
    g = _guesses(sampled)

    def f(at: Real, which: Indices) -> Real:
        def look(chain: Chain, configuration: Configuration, rows: Indices) -> Real:
            _, rate, rate2 = coordinate_of(chain, default_outputs(chain)[o], configuration)
            own = g.variant[which[rows]]
            both = in_time(rate, rate2, speed[own], acceleration[own])
            return np.asarray(both[g.kind[which[rows]], np.arange(len(rows))])

        return looked_at(block, dense.variants[g.variant[which]], at, look)

    at, values = refine(f, dense.x[g.variant, g.row], _radius(dense.x, g.variant, g.row))
    at = _along(block, at, dense.start[g.variant])
    return _best(dense, sampled, g, at, values)


def _best(dense: Dense, sampled: Real, g: _Guesses, at: Real, values: Real) -> list[Extremes]:
    """The highest of what was found beside the guesses; what does not change stands at position 0."""
    count = len(dense.variants)
    best = np.full((2, 2, count), -np.inf)
    place = np.empty((2, 2, count))
    for k in reversed(range(CANDIDATES)):  # of equal ones the first guess
        own = np.flatnonzero(_rank(g) == k)
        where = g.kind[own], (g.side[own] + 1) // 2, g.variant[own]
        higher = own[g.side[own] * values[own] >= best[where]]
        where = g.kind[higher], (g.side[higher] + 1) // 2, g.variant[higher]
        best[where], place[where] = g.side[higher] * values[higher], at[higher]
    best *= np.array(SIDES)[:, None]
    still = np.ptp(sampled, axis=2) <= CONSTANT * np.max(np.abs(sampled), axis=2)
    kind, variant = np.nonzero(still)
    best[kind, :, variant], place[kind, :, variant] = sampled[kind, variant, :1], dense.start[variant, None]

    def pair(v: int, kind: int) -> tuple[Extreme, Extreme]:
        low, high = (Extreme(float(best[kind, side, v]), float(place[kind, side, v])) for side in (0, 1))
        return low, high

    return [(pair(v, 0), pair(v, 1)) for v in range(count)]


def _guesses(sampled: Real) -> _Guesses:
    """The highest local extremes of samples (2, V, m), some of each side."""
    parts = []
    for side in SIDES:
        values = side * sampled[..., :-1]
        turns = _turning(sampled[..., :-1], side)
        score = np.where(turns, values, -np.inf)
        whole = np.argmax(side * sampled, axis=-1)
        for k in range(CANDIDATES):
            row = np.argmax(score, axis=-1)
            there = np.take_along_axis(score, row[..., None], axis=-1)[..., 0] > -np.inf
            if k == 0:
                row, there = np.where(there, row, whole), np.ones_like(there)
            kind, variant = np.nonzero(there)
            parts.append((variant, kind, np.full(len(kind), side), row[kind, variant]))
            np.put_along_axis(score, np.minimum(row, score.shape[-1] - 1)[..., None], -np.inf, axis=-1)
    return _Guesses(*(np.concatenate(column) for column in zip(*parts, strict=True)))


def _rank(g: _Guesses) -> Indices:
    """0 of the highest guess of a variant, kind and side, 1 of the next."""
    key = (g.variant * 2 + g.kind) * 2 + (g.side + 1) // 2
    order = np.argsort(key, kind="stable")
    first = np.append(True, np.diff(key[order]) > 0)
    rank = np.arange(len(key)) - np.maximum.accumulate(np.where(first, np.arange(len(key)), 0))
    found = np.empty_like(rank)
    found[order] = rank
    return found


def _turning(values: Real, side: int) -> Real:
    """Whether periodic samples (..., n) have a local maximum (``side`` +1) or minimum there."""
    v = side * values
    return np.asarray((v >= np.roll(v, 1, axis=-1)) & (v > np.roll(v, -1, axis=-1)))


def _radius(x: Real, variant: Indices, row: Indices) -> Real:
    """Half the interval around the samples ``row`` of some variants that holds the true extreme."""
    gap = np.diff(x, axis=1)
    return np.maximum(gap[variant, row - 1], gap[variant, np.minimum(row, gap.shape[1] - 1)])


def _at_rows(measure: Measure, variants: Indices) -> Measure:
    reach = np.asarray(measure.reach)
    return measure._replace(reach=reach[variants]) if reach.ndim else measure  # type: ignore[arg-type]


def _along(block: Block, at: Real, start: Real) -> Real:
    return along_motion(block.chain(0), at, start)  # type: ignore[arg-type]
