"""What the summary of kinematics tells of many variants: strokes and extremes of outputs, transmission of dyads."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from tmmcalc.core.numerics.roots import Indices
from tmmcalc.core.plane import Real
from tmmcalc.linkage.assembly import TURN
from tmmcalc.linkage.outputs import (
    coordinate_of,
    default_outputs,
    extremes_of,
    gain_of,
    order_from_working,
    stroke_of,
    summary_of,
)
from tmmcalc.linkage.quality import assessed
from tmmcalc.linkage.results import GroupQuality, OutputSummary
from tmmcalc.linkage.stacked.dense import Dense, dense_of, evaluated, values_at
from tmmcalc.linkage.stacked.scene import Block
from tmmcalc.linkage.survey import Evaluate, along_motion, three_turns
from tmmcalc.linkage.trace import continuous


def qualities_of(block: Block, dense: Dense) -> list[tuple[GroupQuality, ...]]:
    """Quality of all groups of every variant of a survey."""
    evaluate = _evaluate(block, dense)
    return assessed(block.chain(0), evaluate, dense.measures, dense.x, dense.squares, dense.start, full=True)


def transmissions_of(block: Block, variants: Indices) -> dict[str, Real]:
    """Transmission and pressure angles [deg] (v,) of all groups of some variants, by their names in the summary."""
    found: dict[str, Real] = {}
    for own in zip(*qualities_of(block, dense_of(block, variants)), strict=True):
        angles = np.degrees([np.nan if each.transmission is None else each.transmission for each in own])
        names = transmissions((own[0],))
        found |= dict(zip(names, (angles, 90.0 - angles), strict=True))
    return found


def transmissions(qualities: Sequence[GroupQuality]) -> tuple[str, ...]:
    """The names of transmission and pressure angles of groups."""
    return tuple(f"{kind}_{each.group}" for each in qualities for kind in ("transmission_min", "pressure_max"))


def summaries_of(block: Block, dense: Dense) -> list[tuple[OutputSummary, ...]]:
    """Summaries of all outputs of every variant of a survey."""
    by_output = [list(_summaries(block, dense, o)) for o in range(len(dense.outputs))]
    return list(zip(*by_output, strict=True)) if by_output else [() for _ in dense.variants]


def _evaluate(block: Block, dense: Dense) -> Evaluate:
    """How the variants of a survey are evaluated."""
    return lambda x, variants, quantity, order: evaluated(block, dense.variants[variants], x, quantity, order)


def _summaries(block: Block, dense: Dense, o: int) -> Iterator[OutputSummary]:
    output, coordinates = dense.outputs[o], dense.coordinates[o, 0]
    centres = block.settled.reversals[o][dense.variants]
    # in the order of the survey, which begins at position 0
    begin = dense.x[:, :1]
    centres = np.sort(begin + np.mod(centres - begin, TURN), axis=1)
    values, gains = _values(block, dense, o, centres), [gain_of(output, track) for track in coordinates]
    owns = [block.chain(int(v)) for v in dense.variants]
    ordered = centres
    if centres.shape[1] > 1:
        rows = zip(owns, centres, values, gains, dense.start, strict=True)
        ordered = np.array(
            [along_motion(own, order_from_working(own, output, *row), start) for own, *row, start in rows]
        )
    reached = _values(block, dense, o, ordered)
    drive = block.chain.tree.mechanism.input
    speed, acceleration = (
        np.broadcast_to(np.asarray(v, float), block.size)[dense.variants] for v in (drive.speed, drive.acceleration)
    )
    extremes = extremes_of(
        block.chain(0),
        _evaluate(block, dense),
        lambda own, configuration: coordinate_of(own, default_outputs(own)[o], configuration),
        dense.x,
        (dense.coordinates[o, 1], dense.coordinates[o, 2]),
        dense.start,
        (speed, acceleration),
        full=True,
    )
    for own, at, there, met, gain, each in zip(owns, ordered, reached, values, gains, extremes, strict=True):
        yield summary_of(own, output, (at, there), stroke_of(met, gain), True, each)


def _values(block: Block, dense: Dense, o: int, at: Real) -> Real:
    """Coordinate of an output at places (V, c), angles continuous."""
    output = dense.outputs[o]
    if not at.size:
        return at
    found = values_at(block, o, np.repeat(dense.variants, at.shape[1]), at.ravel()).reshape(at.shape)
    if output.link is None:
        return found
    rows = zip(found, at, dense.x, dense.coordinates[o, 0], strict=True)
    return np.array([continuous(raw[None], own, *three_turns(x, track[None]))[0] for raw, own, x, track in rows])
