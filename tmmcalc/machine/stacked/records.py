"""Results of single variants, cut out of those of many: what one run of the linkage stages leaves."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import partial
from itertools import pairwise
from typing import Any

import numpy as np

from tmmcalc.core.numerics.alike import alike, numbers, rebuilt
from tmmcalc.core.numerics.extended import WIDER
from tmmcalc.core.numerics.roots import Indices
from tmmcalc.core.plane import Real
from tmmcalc.linkage.errors import between, choice, estimate, least_regularity
from tmmcalc.linkage.forces.kinetostatics import Statics
from tmmcalc.linkage.forces.maxima import force_functions
from tmmcalc.linkage.forces.results import Forces
from tmmcalc.linkage.forces.solve import ROUNDING, forces_of
from tmmcalc.linkage.forces.stack import Stack, stacked
from tmmcalc.linkage.kinematics import crank_length
from tmmcalc.linkage.lastdigit import in_full
from tmmcalc.linkage.results import ErrorEstimate, Kinematics, Trace
from tmmcalc.linkage.stacked.dense import dense_of, evaluated
from tmmcalc.linkage.stacked.reactions import reactions_of
from tmmcalc.linkage.stacked.scene import Block
from tmmcalc.linkage.stacked.summaries import qualities_of, summaries_of
from tmmcalc.linkage.stacked.tables import SAFE, jumps_alike, kinematics_of
from tmmcalc.linkage.trace import trace
from tmmcalc.machine.reduction.causes import causes_in
from tmmcalc.machine.reduction.errors import unmeasured
from tmmcalc.machine.reduction.inertia import lumped, reduced_inertia, rods_of
from tmmcalc.machine.reduction.results import Reduction, Rods
from tmmcalc.machine.reduction.solve import reduction_of
from tmmcalc.machine.stacked.reduction import AS_ALONE, Cycles, cycles_of, sampled

_STACKS = ("r", "dr", "ddr", "angle", "dangle", "ddangle", "s", "ds", "dds")


def kinematics_records(block: Block, variants: Indices) -> list[Kinematics]:
    """The kinematics of some variants (v,), each by itself."""
    whole, dense, n = kinematics_of(block, variants), dense_of(block, variants), block.labels
    qualities, summaries = qualities_of(block, dense), summaries_of(block, dense)
    weakest = [[q.regularity_at for q in own if q.regularity_at is not None] for own in qualities]
    errors = _errors(block, variants, whole.x.reshape(-1, n), weakest)
    found = []
    for k, v in enumerate(variants.tolist()):
        rows, chain = np.s_[..., k * n : (k + 1) * n], block.chain(v)
        drive = chain.mechanism.input
        found.append(
            replace(
                whole,
                speed=float(drive.speed),
                acceleration=float(drive.acceleration),
                crank_length=crank_length(chain),
                frame_points={name: (at.real, at.imag) for name, at in chain.mechanism.frame.points.items()},
                phi=whole.phi[rows],
                x=whole.x[rows],
                trace=_rows(whole.trace, rows),
                s=whole.s[rows],
                ds=whole.ds[rows],
                dds=whole.dds[rows],
                summaries=summaries[k],
                qualities=qualities[k],
                grades=(),
                error=errors[k],
            )
        )
    return found


def _rows(values: Trace, rows: Any) -> Trace:
    return replace(values, **{name: getattr(values, name)[rows] for name in _STACKS})


def _errors(block: Block, variants: Indices, x: Real, weakest: Sequence[Sequence[float]]) -> list[ErrorEstimate]:
    """The estimated errors of kinematics at x (v, n), in extended precision of all together.

    What the last digit of the data does costs more than a variant, and is told of one that is solved alone.
    """
    if not WIDER:
        owns = [block.chain(v) for v in variants.tolist()]
        return [estimate(own, row, partial(trace, own), weak) for own, row, weak in zip(owns, x, weakest, strict=True)]
    regular = evaluated(
        block,
        np.repeat(variants, x.shape[1]),
        x.ravel(),
        lambda chain, configuration, rows: least_regularity(chain, configuration, len(rows)),
        order=0,
    ).reshape(x.shape)
    chosen = [
        row[choice(row, own.__getitem__, weak, turns=True)] for row, own, weak in zip(x, regular, weakest, strict=True)
    ]
    ends = np.cumsum([0, *map(len, chosen)]).tolist()
    at, chain = np.concatenate(chosen), block.chain(np.repeat(variants, np.diff(ends)))
    found, exact = trace(chain, at), trace(in_full(chain), at.astype(np.longdouble))
    parts = [np.s_[..., low:high] for low, high in pairwise(ends)]
    return [between(_rows(found, part), _rows(exact, part)) for part in parts]


def forces_records(block: Block, variants: Indices, kinematics: Sequence[Kinematics]) -> list[Forces | None]:
    """The forces of some variants (v,), each by itself; None of one that is not clear."""
    theta, side, labels = block.rows
    count, n = len(variants), len(theta)
    statics = block.statics(np.repeat(variants, n))
    rows, solutions = stacked(statics, np.tile(theta, count), np.tile(side, count))
    over = reactions_of(block, variants)
    growth = over.growth
    for solution in solutions.values():
        growth = np.maximum(growth, np.max(solution.amplification.reshape(count, n), axis=1))
    clear = over.resolved & (growth < SAFE) & jumps_alike(block, variants)
    passes = max((solution.passes for solution in solutions.values()), default=0)
    found: list[Forces | None] = []
    for k, v in enumerate(variants.tolist()):
        if not clear[k]:
            found.append(None)
            continue
        own, (panels, part) = _constants(block, v), over.panels.panels_of(k)
        error = max(kinematics[k].error.acceleration, ROUNDING) * float(growth[k])
        mine = rows.columns(slice(k * n, (k + 1) * n))
        found.append(
            forces_of(
                own,
                _copied(mine),
                theta,
                labels,
                (panels, force_functions(own, over.values[:, part]), True),
                error,
                passes,
                (),
            )
        )
    return found


def _copied(rows: Stack) -> Stack:
    parts: list[Any] = [None if part is None else part.copy() for part in rows]
    return Stack(*parts)


def reduction_records(
    block: Block, variants: Indices, kinematics: Sequence[Kinematics]
) -> tuple[list[Reduction | None], Cycles]:
    """What is reduced of some variants (v,), each by itself, None of one that is not clear; and all cycles."""
    count, n = len(variants), block.labels
    cycles = cycles_of(block, variants, AS_ALONE)
    statics = block.statics(np.repeat(variants, n))
    theta, labels = statics.scene.travel.rows(block.same.kinematics)
    side = statics.scene.travel.sides(theta)
    nodes = sampled(block, np.repeat(variants, n), np.tile(theta, count), np.tile(side, count), idle=True)
    clear = cycles.clear & (np.max(nodes.growth.reshape(count, n), axis=1) < SAFE)
    others, links = _others(block, variants, theta)
    found: list[Reduction | None] = []
    for k, v in enumerate(variants.tolist()):
        if not clear[k]:
            found.append(None)
            continue
        own, (panels, part) = _constants(block, v), cycles.panels.panels_of(k)
        node = nodes.columns(slice(k * n, (k + 1) * n))
        rows = cycles.rows[:, part].copy()
        error = unmeasured(float(cycles.tail[k]), kinematics[k].error)
        rods = Rods("exact", links, None if others is None else others[k])
        found.append(reduction_of(causes_in(own), (theta, labels, node), (panels, rows), error, rods, stuck=False))
    return found, cycles


def _others(block: Block, variants: Indices, theta: Real) -> tuple[Real | None, tuple[int, ...]]:
    """Reduced inertia (v, n) with the rods as masses in their pins, and the rods; None where there are none."""
    own, loading = block.chain(0).mechanism, block.loading(0)
    assert loading is not None
    links = rods_of(own, loading)
    if not links:
        return None, ()
    each = []
    for v in variants.tolist():
        its = block.loading(v)
        assert its is not None
        each.append(lumped(block.chain(v).mechanism, its, links))
    columns = zip(*map(numbers, each), strict=True)
    n = len(theta)
    bodies = rebuilt(each[0], [_repeated(column, n) for column in columns])
    scene = block.statics(np.repeat(variants, n)).scene
    place = scene.place(np.tile(theta, len(variants)))
    found = reduced_inertia(bodies, place.configuration, n * len(variants))[0]
    return found.reshape(len(variants), n), links


def _repeated(column: Sequence[float | complex], n: int) -> Any:
    """One constant of all variants at their rows."""
    values = alike(np.array(column))
    return values if np.ndim(values) == 0 else np.repeat(values, n)


def _constants(block: Block, variant: int) -> Statics:
    """The constants of one variant, as far as results ask for them."""
    same, chain, loading = block.same, block.chain(variant), block.loading(variant)
    assert same.scene is not None
    assert same.statics is not None
    assert loading is not None
    drive, start = chain.mechanism.input, np.broadcast_to(np.asarray(block.settled.start), block.size)[variant]
    travel = same.scene.travel._replace(
        start=float(start), speed=float(drive.speed), acceleration=float(drive.acceleration)
    )
    scene = same.scene._replace(chain=chain, loading=loading, travel=travel, grades=())
    return same.statics._replace(scene=scene, pairs={pair.joint: pair for pair in loading.pairs})
