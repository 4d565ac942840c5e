"""The survey of many variants: which of them are far from any trouble, their position 0, where rubbing pairs turn.

A variant is clear if every dyad assembles and transmits at all samples of a turn by more than its margin changes from
one sample to the next, or after a closer look (`closer`), and if its first output and its rubbing pairs turn as often
as those of the other variants.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from tmmcalc.core.numerics.alike import Alike, Rows
from tmmcalc.core.numerics.roots import Indices
from tmmcalc.core.plane import Real, square
from tmmcalc.linkage.assembly import TURN
from tmmcalc.linkage.chain import Chain, Configuration
from tmmcalc.linkage.forces.wrench import sliding
from tmmcalc.linkage.outputs import EQUAL, coordinate_of, default_outputs
from tmmcalc.linkage.stacked.closer import REACH, closer
from tmmcalc.linkage.stacked.zeros import Flags, Zeros, zeros
from tmmcalc.linkage.trace import principal, unwrapped

ROWS = 4096  # that are computed together: their temporaries stay in cache
STEPS = 180
TOGETHER = ROWS // STEPS  # variants whose surveys are evaluated together
MARGIN = 0.02  # squared sine above which a dyad is nowhere near to a limit position
SWIFT = 1.0  # a link that turns more in one step [rad] is looked at alone
SLOW = 0.125  # near to a limit position: the same where signs of rates are sampled, in half a step
ENDS = 2  # dead centres of the first output that make position 0
STEP = TURN / STEPS
X = STEP * np.arange(STEPS) - math.pi - STEP / 2


class Settled(NamedTuple):
    """What the survey tells of V variants."""

    clear: Flags  # (V,)
    stuck: Flags  # (V,) whose links do not reach somewhere in the turn, beyond doubt
    swift: Flags  # (V,) some link turns so swiftly somewhere that one variant alone is sampled more densely there
    start: Real | float  # input coordinate of position 0 [rad], (V,) or of all
    centres: Real  # (V, 2) dead centres of the first output, in order from the working stroke; (V, 0): not sought
    reached: Real  # (V, 2) its coordinate there
    reversals: tuple[Real, ...]  # (V, c) ascending dead centres of all outputs whose are sought
    turning: Real  # (V, R) where rubbing pairs turn back [rad]
    scales: dict[str, Real]  # largest relative rates (V,) in the rubbing joints
    link_angles: Real | None  # (L, V, STEPS + 1) continuous angles of the links over the survey [rad]


def settle(
    chain: Rows[Chain], count: int, rubbing: Sequence[str], tracked: bool, told: bool = False, placed: bool = False
) -> Settled:
    """Survey ``count`` variants; ``rubbing`` are the joints whose reversals are asked for.

    ``told``: the dead centres of all outputs are asked for, and not only those that make position 0. ``placed``: of
    points where they are is asked for, and nothing else.
    """
    asked = chain.tree.mechanism.input.start is None
    outputs = len(default_outputs(chain.tree)) if told else int(asked)
    looks = [
        _look(chain, np.arange(at, min(at + TOGETHER, count)), outputs, rubbing, tracked, placed)
        for at in range(0, count, TOGETHER)
    ]
    clear = np.concatenate([look.clear for look in looks])
    stuck = np.concatenate([look.stuck for look in looks])
    swift = np.concatenate([look.swift for look in looks])
    rates = np.concatenate([look.rates for look in looks], axis=1)
    link_angles = np.concatenate([look.link_angles for look in looks], axis=1) if tracked else None
    largest = np.max(np.abs(rates), axis=2)

    def f(at: Real, variant: Indices, function: Indices) -> Real:
        own = chain(variant)
        return np.asarray(_rates(own, own.evaluate(at), outputs, rubbing, at.size)[function, np.arange(at.size)])

    ends = ENDS if asked else None  # with others no position 0 is found
    turning = zeros(f, X, rates, largest, ends) if len(rates) else Zeros((), clear)
    clear = clear & turning.clear
    start: Real | float = chain.tree.mechanism.input.start or 0.0
    centres: Real = np.zeros((count, 0))
    reached: Real = centres
    reversals, backs = turning.places[:outputs], turning.places[outputs:]
    if asked:
        centres, reached, settled = _ordered(chain, reversals[0], count)
        clear, start = clear & settled, np.asarray(principal(centres[:, 0])).view(Alike)
    return Settled(
        clear,
        stuck,
        swift,
        start,
        centres,
        reached,
        reversals,
        np.concatenate([np.zeros((count, 0)), *backs], axis=1),
        {name: row.view(Alike) for name, row in zip(rubbing, largest[outputs:], strict=True)},
        link_angles,
    )


class _Look(NamedTuple):
    """Samples of some variants: which are clear (v,), stuck or swift, rates (F, v, STEPS), angles of the links."""

    clear: Flags
    stuck: Flags
    swift: Flags
    rates: Real
    link_angles: Real


def _look(
    chain: Rows[Chain], variants: Indices, outputs: int, rubbing: Sequence[str], tracked: bool, placed: bool
) -> _Look:
    own = chain(np.repeat(variants, STEPS))
    x = np.tile(X, len(variants))
    configuration = own.evaluate(x, order=2 if outputs or rubbing else 0)
    with np.errstate(invalid="ignore"):  # of those that do not assemble
        rates = _rates(own, configuration, outputs, rubbing, x.size).reshape(-1, len(variants), STEPS)
    clear, stuck = np.ones(len(variants), bool), np.zeros(len(variants), bool)
    for k in range(len(own.steps)):
        reaches, fails = _reaches(own, k, configuration, len(variants))
        clear, stuck = clear & reaches, stuck | fails
    swift = np.zeros(len(variants), bool)
    doubt = np.flatnonzero(~clear & ~stuck)
    if doubt.size:
        seen = closer(chain, variants[doubt], placed)
        most = SLOW if len(rates) else SWIFT / 2  # in half a step, wherever it begins
        swift[doubt] = seen.turns > most
        clear[doubt] = seen.passes & (seen.before < SWIFT / 2) & ~(swift[doubt] & (tracked or len(rates) > 0))
        stuck[doubt] = seen.fails
    link_angles: Real = np.zeros((0, len(variants), 0))
    if tracked:
        link_angles = _link_angles(own, configuration, len(variants))
        clear &= np.max(np.abs(np.diff(link_angles, axis=2)), axis=(0, 2)) < SWIFT
    return _Look(clear, stuck, swift, rates, link_angles)


def _rates(chain: Chain, configuration: Configuration, outputs: int, rubbing: Sequence[str], n: int) -> Real:
    """Rates (F, n) of the first outputs and in the rubbing joints."""
    found = [coordinate_of(chain, output, configuration)[1] for output in default_outputs(chain)[:outputs]]
    found += [sliding(chain.mechanism.joint(name), configuration)[0] for name in rubbing]
    rows = np.empty((len(found), n))
    for row, values in zip(rows, found, strict=True):
        row[:] = values
    return rows


def _reaches(chain: Chain, k: int, configuration: Configuration, count: int) -> tuple[Flags, Flags]:
    """Variants whose dyad k is far from limit positions and dead points; and those of which it does not assemble."""
    step, ports = chain.dyad(k), configuration.ports[k]
    margin = np.broadcast_to(step.dyad.margin(*ports), count * STEPS).reshape(count, STEPS)
    with np.errstate(invalid="ignore"):
        moves = np.max(np.abs(margin - np.roll(margin, 1, axis=1)), axis=1)
        least = np.min(margin, axis=1)
        clear = least > np.maximum(MARGIN, moves)
        if step.group.kind == "RPR":
            apart = np.broadcast_to(square(ports[0].r - ports[1].r), count * STEPS).reshape(count, STEPS)
            clear &= np.min(apart, axis=1) > REACH * np.max(apart, axis=1)
        fails = least < -MARGIN
    return np.asarray(clear), np.asarray(fails)


def _link_angles(chain: Chain, configuration: Configuration, count: int) -> Real:
    """Continuous angles (L, v, STEPS + 1) of the links in their order; the last sample is a turn after the first."""
    links = sorted(link.id for link in chain.mechanism.links)
    u = [np.broadcast_to(configuration.motions[k].u, count * STEPS).reshape(count, STEPS) for k in links]
    angles = np.angle(u)
    return unwrapped(np.concatenate((angles, angles[..., :1]), axis=-1))


def _ordered(chain: Rows[Chain], centres: Real, count: int) -> tuple[Real, Real, Flags]:
    """Two dead centres (V, 2) from that before the working stroke on, and the output there.

    And which variants leave no doubt about it.
    """
    if centres.shape[1] != ENDS:
        return np.zeros((count, ENDS)), np.zeros((count, ENDS)), np.zeros(count, bool)
    own = chain(np.repeat(np.arange(count), 2))
    output, speed = default_outputs(own)[0], chain.tree.mechanism.input.speed
    values = np.broadcast_to(coordinate_of(own, output, own.evaluate(centres.ravel()))[0], centres.size)
    values = values.reshape(centres.shape)
    if speed < 0:
        centres, values = centres[:, ::-1], values[:, ::-1]
    first = np.abs(centres[:, 1] - centres[:, 0])
    lengths = np.stack((first, TURN - first), axis=1)
    travel = np.stack((values[:, 1] - values[:, 0], values[:, 0] - values[:, 1]), axis=1)
    gap = np.abs(lengths[:, 0] - lengths[:, 1])
    keys = np.where(lengths > lengths.max(axis=1)[:, None] - EQUAL, values, -np.inf)
    if output.resistance is not None:
        keys = np.where(travel < 0 if output.resistance == "positive" else travel > 0, lengths, -np.inf)
    second = np.argmax(keys, axis=1) == 1
    tied = (gap < 4 * EQUAL) & ((gap > EQUAL / 4) | (np.abs(travel[:, 0]) <= REACH * np.max(np.abs(values), axis=1)))
    centres, values = (np.where(second[:, None], row[:, ::-1], row) for row in (centres, values))
    return centres, values, ~tied
