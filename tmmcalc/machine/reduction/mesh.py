"""The panels of a reduction: laid between jumps and reversals, cut at kinks of friction, halved until all is resolved.

What is reduced is sampled on them: inertia, its slope, and the moments of all causes.
"""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.numerics.panels import Panels, panels, resolved
from tmmcalc.core.plane import Real
from tmmcalc.linkage.assembly import TURN
from tmmcalc.linkage.forces.kinetostatics import reversals
from tmmcalc.linkage.forces.kinks import cut, kinks
from tmmcalc.linkage.loads.scene import Scene
from tmmcalc.machine.reduction.causes import Causes, Sample

Flags = NDArray[np.bool_]

TOLERANCE = 1e-11  # of the panels: last coefficients against the largest value
SLIGHT = 1e-4  # part of the most that a moment could be: the tolerance of it is rounding
SAMPLED = 33  # places at which that most is taken
PARTS = 24  # of a turn, or of the range: no first panel is wider
QUARTERS = np.array([0.25, 0.5, 0.75])  # that a panel which resolves nothing is cut in
ROUNDS = 4  # of cutting: two kinks between the same points show one after the other


def first_of(causes: Causes, theta: Real, labels: tuple[str, ...]) -> tuple[Sample, Panels, Sample, list[float]]:
    """Everything at the positions and on the first panels, in one run; places of jumps and bends."""
    scene, n = causes.scene, len(theta)
    breaks, turning = scene.breaks(reversals(causes.statics))
    on = _panels(scene, [*breaks, *turning])
    between = on.x.ravel()

    def named(rows: NDArray[np.intp]) -> list[str]:
        at_rows, beyond = rows[rows < n], rows[rows >= n] - n
        return [f"position {labels[i]}" for i in at_rows] or scene.travel.named(between[beyond])

    side = np.concatenate((scene.travel.sides(theta), np.ones(len(between))))
    everything = causes.sampled(np.concatenate((theta, between)), side, named)
    return everything.columns(slice(n)), on, everything.columns(slice(n, None)), [*breaks, *turning]


def refined(causes: Causes, on: Panels, sample: Sample, breaks: list[float]) -> tuple[Panels, Real, float, bool, float]:
    """Panels that resolve J, dJ and all moments, their values (3 + S, K, N), the largest tail.

    Besides whether idle sticks, and what the moments at the mean speed were measured against.
    """
    scales, scale = _scales(causes, sample)
    for _ in range(ROUNDS):
        rough = _rough(on, sample, scales)
        quarters = on.edges[:-1][rough, None] + on.width[rough, None] * QUARTERS
        finer = cut(on, [*kinks(on, sample.faces), *kinks(on, sample.pins), *quarters.flat], breaks)
        if not finer.fresh.any():
            break
        on, sample = finer.panels, sample.with_cut(finer, causes.along(finer.theta))
    samples, waiting = [sample], [sample]  # the first panels are sampled already

    def rows(theta: Real) -> Real:
        if waiting:
            return waiting.pop().rows
        samples.append(causes.along(theta))
        return samples[-1].rows

    return *resolved(rows, on, TOLERANCE, scales), any(sample.stuck for sample in samples), scale


def _rough(on: Panels, sample: Sample, scales: Real) -> Flags:
    """Panels (K,) that do not resolve a function yet; each counts by what it adds to an integral."""
    rows = sample.rows
    tails = on.tail(rows.reshape(len(rows), *on.x.shape)) / scales[:, None]
    return np.max(tails, axis=0) * on.width > TOLERANCE * np.max(on.width)


def _panels(scene: Scene, edges: Iterable[float]) -> Panels:
    whole = TURN if scene.chain.turns else scene.travel.period
    return panels(0.0, scene.travel.period, edges, whole / PARTS)


def _scales(causes: Causes, sample: Sample) -> tuple[Real, float]:
    """What the tails of J, dJ and all moments (3 + S,) are measured against: J, J a radian, the largest moment [N*m].

    Moments count at the mean speed. Those that are nothing beside the most that they could be are rounding, which no
    panel resolves.
    """
    inertia, powers = float(np.max(sample.inertia)), causes.powers
    most = SLIGHT * causes.most(np.linspace(0.0, causes.scene.travel.period, SAMPLED))
    largest = np.max(np.abs(sample.moments), axis=1, initial=0.0) * powers
    moment = max(float(np.max(largest, initial=most)), float(np.max(np.abs(sample.idle))))
    travel = causes.scene.travel
    slope = inertia if travel.turns else inertia * TURN / travel.period  # a length has no radian of its own
    scales = np.array([inertia, slope, moment, *moment / np.where(powers > 0, powers, 1.0)])
    return np.where(scales > 0, scales, 1.0), moment
