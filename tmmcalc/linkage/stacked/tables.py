"""Results whose rows are those of many variants, one behind the other, so that their columns are made at once."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from tmmcalc.core.numerics.roots import Indices
from tmmcalc.core.plane import Real
from tmmcalc.linkage.assembly import TURN
from tmmcalc.linkage.forces.results import Forces
from tmmcalc.linkage.forces.stack import stacked
from tmmcalc.linkage.kinematics import output_row
from tmmcalc.linkage.loads.travel import EDGE
from tmmcalc.linkage.outputs import default_outputs, working_angle
from tmmcalc.linkage.results import Kinematics, Trace
from tmmcalc.linkage.stacked.scene import Block
from tmmcalc.linkage.stacked.survey import STEP, STEPS, X
from tmmcalc.linkage.stacked.zeros import Flags
from tmmcalc.linkage.trace import principal, trace

SAFE = 2.0  # growth of errors in the friction (loop gain of a half) up to which nothing is near to locking
BETWEEN = 96  # further angles at which that is looked at, where no panels are
SURE, NEVER = EDGE / 4, 4 * EDGE  # a position nearer to a reversal of a rubbing pair is two, one farther is one


def kinematics_of(block: Block, variants: Indices) -> Kinematics:
    """Positions, velocities and accelerations of some variants (v,): every array (..., v n)."""
    base, n = block.same.kinematics, block.labels
    rows = np.repeat(variants, n)
    chain = block.chain(rows)
    start = np.broadcast_to(np.asarray(block.settled.start), block.size)[variants]
    x = (start[:, None] + base.phi).ravel()
    values = trace(chain, x)
    if block.settled.link_angles is not None:
        values = replace(values, angle=_continuous(values, block.settled.link_angles[:, variants], x))
    drive: Any = chain.mechanism.input
    s, ds, dds = (np.array(part) for part in zip(*_outputs(chain, values), strict=True))
    first = s.reshape(len(s), len(variants), n)[:, :, :1]
    return replace(
        base,
        speed=drive.speed,
        acceleration=drive.acceleration,
        phi=np.tile(base.phi, len(variants)),
        x=x,
        trace=values,
        s=(s.reshape(len(s), len(variants), n) - first).reshape(s.shape),
        ds=ds,
        dds=dds,
    )


def strokes_of(block: Block) -> dict[str, Real]:
    """Stroke, angles of the crank [deg] and time ratio (V,) of the first output, whose dead centre is position 0.

    They stand under the names of the summary, less that of the output.
    """
    settled = block.settled
    sense = 1.0 if block.chain.tree.mechanism.input.speed > 0 else -1.0
    working = working_angle(settled.centres, sense)
    return {
        "stroke": np.ptp(settled.reached, axis=1),
        "working": np.degrees(working),
        "idle": np.degrees(TURN - working),
        "K": working / (TURN - working),
    }


STROKES = ("stroke", "working", "idle", "K")


def _outputs(chain: Any, values: Trace) -> list[tuple[Real, Real, Real]]:
    return [output_row(output, values) for output in default_outputs(chain)]


def _continuous(values: Trace, link_angles: Real, x: Real) -> Real:
    """Angles (L, v n) in the turns of the survey (L, v, STEPS + 1), in (-pi, pi] at the first position of each."""
    turned, place = np.divmod((x - X[0]) / STEP, STEPS)
    cell = np.minimum(place.astype(int), STEPS - 1)
    variant = np.repeat(np.arange(link_angles.shape[1]), len(x) // link_angles.shape[1])
    low, high = link_angles[:, variant, cell], link_angles[:, variant, cell + 1]
    near = low + (high - low) * (place - cell) + turned * (link_angles[:, :, -1] - link_angles[:, :, 0])[:, variant]
    shape = (len(near), link_angles.shape[1], -1)
    first = values.angle.reshape(shape)[:, :, 0]
    offset = np.rint((principal(first) - near.reshape(shape)[:, :, 0]) / TURN)[:, :, None]
    near = (near.reshape(shape) + TURN * offset).reshape(near.shape)
    return np.asarray(values.angle + TURN * np.rint((near - values.angle) / TURN))


def forces_of(block: Block, variants: Indices, base: Forces, between: bool) -> tuple[Forces, Flags]:
    """Reactions and drive of some variants (v,): every array (..., v n); and which of them are clear.

    ``between`` the positions the friction is looked at too.
    """
    theta, side, labels = block.rows
    count, n = len(variants), len(theta)
    statics = block.statics(np.repeat(variants, n))
    travel = statics.scene.travel
    over, solutions = stacked(statics, np.tile(theta, count), np.tile(side, count), checked=False)
    clear = jumps_alike(block, variants)
    for solution in solutions.values():
        clear &= np.max(solution.amplification.reshape(count, n), axis=1) < SAFE
    if between and solutions:
        clear &= _moves(block, variants)
    parts: Any = [
        replace(pair, length=length) for pair, length in zip(base.pairs, _lengths(statics.pairs, base), strict=True)
    ]
    speed: Any = travel.speed
    return replace(
        base,
        labels=labels * count,
        phi=np.tile(travel.sense * theta + travel.first + 0.0, count),
        theta=np.tile(theta, count),
        speed=speed,
        pairs=tuple(parts),
        reaction=over.reaction,
        normal=over.normal,
        couple=over.couple,
        friction=over.friction,
        drive=over.drive,
        power=over.drive * speed,
        mesh=over.mesh,
    ), clear


def _lengths(pairs: dict[str, Any], base: Forces) -> list[Any]:
    """Lengths of the sliders of the pairs."""
    return [pairs[pair.joint].length if pair.joint in pairs else None for pair in base.pairs]


def jumps_alike(block: Block, variants: Indices) -> Flags:
    """Variants (v,) whose rubbing pairs turn back at those positions alone that have two rows."""
    theta, _, labels = block.rows
    twice = np.array([f"{label}-" in labels for label in labels])[1:-1]
    apart = np.min(np.abs(turning_of(block, variants)[:, :, None] - theta[1:-1]), axis=1, initial=np.inf)
    return np.asarray(np.all(np.where(twice | np.roll(twice, -1), apart < SURE, apart > NEVER), axis=1))


def turning_of(block: Block, variants: Indices) -> Real:
    """theta (v, R) in [0, 2 pi), but for rounding, where rubbing pairs turn back."""
    start = np.broadcast_to(np.asarray(block.settled.start), block.size)[variants]
    assert block.same.scene is not None
    sense = block.same.scene.travel.sense
    return np.asarray(np.mod((block.settled.turning[variants] - start[:, None]) * sense + EDGE, TURN) - EDGE)


def _moves(block: Block, variants: Indices) -> Flags:
    """Variants (v,) that are far from self-locking between the positions too."""
    clear = np.ones(len(variants), bool)
    theta = TURN * (np.arange(BETWEEN) + 0.5) / BETWEEN
    statics = block.statics(np.repeat(variants, BETWEEN))
    state = statics.solve(statics.scene.place(np.tile(theta, len(variants))))
    for solution in state.solutions.values():
        clear &= np.max(solution.amplification.reshape(len(variants), BETWEEN), axis=1) < SAFE
    return clear
