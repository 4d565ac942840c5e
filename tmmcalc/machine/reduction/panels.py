"""The panels of a reduction: laid between jumps and reversals, cut at kinks of friction, halved until all is resolved.

What is reduced is sampled on them: inertia, its slope, and the moments of all causes. Several variants have one mesh.
"""

from __future__ import annotations

from collections.abc import Callable, Collection
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.numerics.gauss import tail
from tmmcalc.core.numerics.mesh import Cut, Flags, Mesh, laid
from tmmcalc.core.numerics.panels import NARROWEST, Panels
from tmmcalc.core.numerics.roots import Indices
from tmmcalc.core.plane import Plane, Real
from tmmcalc.linkage.assembly import TURN
from tmmcalc.linkage.forces.kinetostatics import reversals
from tmmcalc.linkage.forces.kinks import kinks
from tmmcalc.machine.reduction.causes import MOMENTS, Causes, Sample

SLIGHT = 1e-4  # part of the most that a moment could be: the tolerance of it is rounding
SAMPLED = 33  # places at which that most is taken


class Fineness(NamedTuple):
    """How panels are laid out and cut."""

    parts: int  # of a turn, or of the range: no first panel is wider
    tolerance: float  # of the panels: last coefficients against the largest value
    cuts: Real  # where a panel that resolves nothing is cut
    rounds: int  # of cutting, at kinks too: two kinks between the same points show one after the other
    halvings: int  # after these


FINE = Fineness(24, 1e-11, np.array([0.25, 0.5, 0.75]), 4, 40)


class Resolved(NamedTuple):
    """What is reduced, on panels that resolve it."""

    mesh: Mesh
    rows: Real  # (3 + S, P, N) as in a `Sample`
    left_out: Real  # (V,) what the panels leave out, relative
    growth: Real  # (V,) largest growth of errors in the friction; infinite where it locks the linkage


def reduced(
    causes: Causes, theta: Real, labels: tuple[str, ...]
) -> tuple[Sample, Panels, Real, tuple[float, bool, float]]:
    """Everything at the positions theta (n,); panels that resolve J, dJ and all moments, and these rows (3 + S, K, N).

    Besides the largest tail, whether the linkage sticks without its loads, and what the moments at the mean speed were
    measured against [N*m].
    """
    scene, n, period = causes.scene, len(theta), causes.scene.travel.period
    breaks, turning = scene.breaks(reversals(causes.statics))
    edges = [*breaks, *turning]
    on = laid(period, np.array([edges]), (TURN if scene.chain.turns else period) / FINE.parts)
    between = on.x.ravel()

    def named(rows: NDArray[np.intp]) -> list[str]:
        at_rows, beyond = rows[rows < n], rows[rows >= n] - n
        return [f"position {labels[i]}" for i in at_rows] or scene.travel.named(between[beyond])

    side = np.concatenate((scene.travel.sides(theta), np.ones(len(between))))
    everything = causes.sampled(np.concatenate((theta, between)), side, named)
    nodes, first = everything.columns(slice(n)), everything.columns(slice(n, None)).over(on)
    most = np.max(causes.possible(np.linspace(0.0, period, SAMPLED)), keepdims=True)
    largest = on.largest(np.max(np.abs(first.rows), axis=-1))
    scales, scale = scales_of(largest, causes.powers[:, None], most, 1.0 if scene.travel.turns else TURN / period)
    found = resolved(on, first, lambda new: causes.along(new.x.ravel()).over(new), scales, FINE, period, edges)
    stuck = bool(np.isinf(found.growth[0]))
    return nodes, found.mesh.panels_of(0)[0], found.rows, (float(found.left_out[0]), stuck, float(scale[0]))


def scales_of(largest: Real, powers: Real, most: Real, radian: float = 1.0) -> tuple[Real, Real]:
    """What the tails of J, dJ and all moments (3 + S, V) are measured against: J, J a radian, the largest moment [N*m].

    ``largest`` (3 + S, V) are the sizes of all rows. Moments count at the mean speed, multiplied by ``powers`` (S, V).
    Those that are nothing beside the ``most`` (V,) that they could be are rounding, which no panel resolves. A length
    has no radian of its own.
    """
    moment = np.max(np.concatenate((largest[2:MOMENTS], largest[MOMENTS:] * powers, SLIGHT * most[None])), axis=0)
    inertia = largest[0]
    scales = np.stack((inertia, inertia * radian, moment, *(moment / np.where(powers > 0, powers, 1.0))))
    return np.where(scales > 0, scales, 1.0), moment


def resolved(
    on: Mesh,
    sample: Sample,
    sampled: Callable[[Mesh], Sample],
    scales: Real,
    fine: Fineness,
    period: float,
    fixed: Collection[float] | None = None,
) -> Resolved:
    """Panels cut from the first ones ``on`` until they resolve all rows of a sample, measured against ``scales``.

    ``sample`` is that on the first panels; ``sampled`` gives it on further ones. Of a single linkage edges that are not
    ``fixed`` move to the kinks that they were put for.
    """
    noisy = [on.largest(np.max(np.abs(part), axis=-1)) for part in (sample.faces, sample.pins)]
    growth = on.largest(np.max(sample.growth, axis=-1))
    left_out, fresh = _left_out(on, sample, scales), np.ones(len(on.owner), bool)

    def with_cut(by: Cut) -> None:
        nonlocal on, sample, left_out, fresh
        new = by.new
        more = sampled(new)
        np.maximum.at(growth, new.owner, np.max(more.growth, axis=-1))
        left_out = by.merged(left_out[:, None], _left_out(new, more, scales)[:, None])[:, 0]
        on, sample, fresh = by.mesh, sample.with_cut(by, more), by.fresh

    for _ in range(fine.rounds):
        by = _cut(on, sample, _rough(on, left_out, fine), fresh, noisy, fine, period, fixed)
        if not by.fresh.any():
            break
        with_cut(by)
    span = on.largest(on.width)
    for _ in range(fine.halvings):
        rough = (left_out * on.width / span[on.owner] > fine.tolerance) & (on.width > NARROWEST * period)
        if not rough.any():
            break
        with_cut(on.halved(rough))
    return Resolved(on, sample.rows, on.largest(left_out * on.width / span[on.owner]), growth)


def _left_out(on: Mesh, sample: Sample, scales: Real) -> Real:
    """What every panel (P,) leaves out of a row, relative."""
    return np.asarray(np.max(tail(sample.rows) / scales[:, on.owner], axis=0))


def _rough(on: Mesh, left_out: Real, fine: Fineness) -> Flags:
    """Panels (P,) that do not resolve a row yet; each counts by what it adds to an integral."""
    return np.asarray(left_out * on.width > fine.tolerance * on.largest(on.width)[on.owner])


def _cut(
    on: Mesh,
    sample: Sample,
    rough: Flags,
    fresh: Flags,
    noisy: list[Real],
    fine: Fineness,
    period: float,
    fixed: Collection[float] | None,
) -> Cut:
    """The ``rough`` panels cut, and the ``fresh`` ones at kinks of friction, but for forces that are ``noisy``."""
    which, new = np.flatnonzero(rough), np.flatnonzero(fresh)
    panels: list[Indices] = [np.repeat(which, len(fine.cuts))]
    places: list[Real] = [(on.low[which, None] + on.width[which, None] * fine.cuts).ravel()]
    parts: tuple[Real | Plane, ...] = (sample.faces, sample.pins)
    for part, largest in zip(parts, noisy, strict=True):
        panel, place = kinks(on.at(new), part[:, new], largest)
        panels.append(new[panel])
        places.append(place)
    panel, place = np.concatenate(panels), np.concatenate(places)
    return on.cut(panel, place, period) if fixed is None else on.cut_or_moved(place, period, fixed)
