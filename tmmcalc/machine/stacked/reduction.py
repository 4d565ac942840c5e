"""Reduced moments and inertia of many variants over one turn, at their mean speeds, on panels that resolve them."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from tmmcalc.core.numerics.gauss import ORDER, tail
from tmmcalc.core.numerics.roots import Indices
from tmmcalc.core.plane import Real
from tmmcalc.linkage.assembly import TURN
from tmmcalc.linkage.forces.kinks import SLIVER
from tmmcalc.linkage.stacked.kinks import kinks
from tmmcalc.linkage.stacked.ragged import Cut, Ragged, cut, first, largest_of_owners
from tmmcalc.linkage.stacked.scene import Block
from tmmcalc.linkage.stacked.tables import SAFE, turning_of
from tmmcalc.linkage.stacked.zeros import Flags
from tmmcalc.machine.reduction import mesh as alone
from tmmcalc.machine.stacked.causes import MOMENTS, Names, Sample, most, names_of, sampled

HALF = np.array([0.5])


class Fineness(NamedTuple):
    """How panels are laid out and cut."""

    parts: int  # of a turn: no first panel is wider
    tolerance: float  # last coefficients against the largest value
    cuts: Real  # where a panel that resolves nothing is cut
    rounds: int  # of cutting, at kinks of friction too
    halvings: int  # after these
    idle: bool  # friction without technological loads is asked for


COARSE = Fineness(8, 1e-12, HALF, 8, 0, idle=False)  # for the motion alone: some panels less
AS_ALONE = Fineness(alone.PARTS, alone.TOLERANCE, alone.QUARTERS, alone.ROUNDS, 12, idle=True)


class Cycles(NamedTuple):
    """What is reduced of V variants, on the points of their panels."""

    panels: Ragged  # of numbers from 0 to V - 1
    names: Names  # (S,) of the causes
    rows: Real  # (3 + S, P, N) J [kg*m^2], dJ/dtheta, idle friction, moments of the causes per power of the speed
    tail: Real  # (V,) what the panels leave out, relative
    clear: Flags  # (V,)

    @property
    def values(self) -> Real:
        """J, dJ/dtheta, moment [N*m], moment per speed [N*m*s], (4, P, N), of all causes."""
        return self._summed(np.ones(len(self.names), bool), 0.0)

    @property
    def idle(self) -> Real:
        """The same without technological loads."""
        quiet = np.array([kind not in ("load", "friction") for _, kind, _ in self.names], bool)
        return self._summed(quiet, self.rows[2])

    def _summed(self, which: Flags, further: Real | float) -> Real:
        orders, moments = np.array([order for _, _, order in self.names], int), self.rows[MOMENTS:]
        positional, viscous = (moments[which & (orders == order)].sum(axis=0) for order in (0, 1))
        return np.stack((self.rows[0], self.rows[1], positional + further, viscous))


def cycles_of(block: Block, variants: Indices, fine: Fineness = COARSE) -> Cycles:
    """The cycles of some variants (v,)."""
    scene, names = block.same.scene, names_of(block.same)
    assert scene is not None
    count = len(variants)
    breaks = np.concatenate((np.tile(scene.angles, (count, 1)), turning_of(block, variants)), axis=1)
    on = first(TURN, np.maximum(breaks, 0.0), TURN / fine.parts)
    sample = _over(block, variants, on, names, fine)
    largest = [largest_of_owners(on, np.max(np.abs(part), axis=-1)) for part in sample]
    measure = _Measure(_scales(block, variants, largest[0], names, fine), largest_of_owners(on, on.width))
    mesh = _Mesh(on, sample, measure.tail(on, sample.rows), np.ones(len(on.owner), bool))
    growth = largest[-1]
    for early, rounds in ((True, fine.rounds), (False, fine.halvings)):
        for _ in range(rounds):
            by = _cut(mesh, largest, fine, early=early)
            if not by.fresh.any():
                break
            new = by.panels.at(by.fresh)
            fresh = _over(block, variants, new, names, fine)
            np.maximum.at(growth, new.owner, np.max(fresh.growth, axis=1))
            mesh = mesh.with_cut(by, fresh, measure.tail(new, fresh.rows))
    left_out = largest_of_owners(mesh.on, mesh.tail)
    clear = (growth < SAFE) & (left_out <= fine.tolerance)
    return Cycles(mesh.on, names, mesh.sample.rows, left_out, clear)


class _Measure(NamedTuple):
    """What tails are measured against."""

    scales: Real  # (3 + S, V) of the rows
    span: Real  # (V,) widest first panel: a panel counts by what it adds to an integral

    def tail(self, on: Ragged, rows: Real) -> Real:
        """What every panel (P,) leaves out of a function, relative."""
        return np.asarray(np.max(tail(rows) / self.scales[:, on.owner], axis=0) * on.width / self.span[on.owner])


class _Mesh(NamedTuple):
    """Panels so far: everything on them, what they leave out (P,), and which have not been looked at yet."""

    on: Ragged
    sample: Sample
    tail: Real
    fresh: Flags

    def with_cut(self, by: Cut, fresh: Sample, tail: Real) -> _Mesh:
        """The same on panels some of which are cut."""
        sample = Sample(*(by.merged(old, new) for old, new in zip(self.sample, fresh, strict=True)))
        whole = by.merged(self.tail[:, None], tail[:, None])[:, 0]
        return _Mesh(by.panels, sample, whole, by.fresh)


def _cut(mesh: _Mesh, largest: list[Real], fine: Fineness, *, early: bool) -> Cut:
    """The panels cut where they do not resolve a function, ``early`` also at kinks; those that stayed are left out."""
    on = mesh.on
    rough = np.flatnonzero((mesh.tail > fine.tolerance) & (mesh.fresh if early else True))
    inside = fine.cuts if early else HALF
    panels: list[Indices] = [np.repeat(rough, len(inside))]
    places: list[Real] = [(on.low[rough, None] + on.width[rough, None] * inside).ravel()]
    new = np.flatnonzero(mesh.fresh)
    for part in (1, 2) if early else ():
        panel, place = kinks(on.at(new), mesh.sample[part][:, new], largest[part])
        panels.append(new[panel])
        places.append(place)
    return cut(on, np.concatenate(panels), np.concatenate(places), SLIVER * TURN if early else 0.0)


def _over(block: Block, variants: Indices, on: Ragged, names: Names, fine: Fineness) -> Sample:
    """Everything at the points of panels: parts (..., P, N)."""
    owner = variants[np.repeat(on.owner, ORDER)]
    found = sampled(block, owner, on.x.ravel(), np.ones(on.x.size), names, idle=fine.idle)
    parts: list[Any] = [part.reshape(*part.shape[:-1], *on.x.shape) for part in found]
    return Sample(*parts)


def _scales(block: Block, variants: Indices, largest: Real, names: Names, fine: Fineness) -> Real:
    """What the tails of all rows are measured against, (3 + S, V): J, and the largest moment at the mean speed."""
    speed = np.abs(np.broadcast_to(np.asarray(block.chain.tree.mechanism.input.speed), block.size))[variants]
    powers = speed ** np.array([order for _, _, order in names], int)[:, None]
    powers = np.where(powers > 0, powers, 1.0)
    inertia, moment = largest[0], np.max(np.concatenate((largest[2:3], largest[MOMENTS:] * powers)), axis=0)
    if fine.idle:
        theta = np.linspace(0.0, TURN, alone.SAMPLED)
        moment = np.maximum(moment, alone.SLIGHT * most(block, variants, theta))
    scales = np.stack((inertia, inertia, moment, *(moment / powers)))
    return np.where(scales > 0, scales, 1.0)
