"""Reduced moments and inertia of many variants over one turn, at their mean speeds, on panels that resolve them."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tmmcalc.core.numerics.gauss import ORDER
from tmmcalc.core.numerics.mesh import Flags, Mesh, laid
from tmmcalc.core.numerics.roots import Indices
from tmmcalc.core.plane import Real
from tmmcalc.linkage.assembly import TURN
from tmmcalc.linkage.stacked.scene import Block
from tmmcalc.linkage.stacked.tables import SAFE, turning_of
from tmmcalc.machine.reduction.causes import MOMENTS, Names, Sample, causes_in, joined, orders_of
from tmmcalc.machine.reduction.panels import FINE, SAMPLED, Fineness, resolved, scales_of

AT_ONCE = 16384  # rows that are computed together: calls cost nothing then
COARSE = Fineness(8, 1e-12, np.array([0.5]), 8, 0)  # for the motion alone: some panels less
AS_ALONE = FINE._replace(halvings=12)


class Cycles(NamedTuple):
    """What is reduced of V variants, on the points of their panels."""

    panels: Mesh  # of numbers from 0 to V - 1
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
        orders, moments = orders_of(self.names), self.rows[MOMENTS:]
        positional, viscous = (moments[which & (orders == order)].sum(axis=0) for order in (0, 1))
        return np.stack((self.rows[0], self.rows[1], positional + further, viscous))


def cycles_of(block: Block, variants: Indices, fine: Fineness = COARSE) -> Cycles:
    """The cycles of some variants (v,); ``COARSE`` ones have no friction without technological loads."""
    same, count, idle = block.same, len(variants), fine is not COARSE
    assert same.scene is not None
    assert same.statics is not None
    names = causes_in(same.statics).names
    breaks = np.concatenate((np.tile(same.scene.angles, (count, 1)), turning_of(block, variants)), axis=1)
    on = laid(TURN, np.maximum(breaks, 0.0), TURN / fine.parts)

    def over(on: Mesh) -> Sample:
        owner = variants[np.repeat(on.owner, ORDER)]
        return sampled(block, owner, on.x.ravel(), np.ones(on.x.size), idle=idle).over(on)

    speed = np.abs(np.broadcast_to(np.asarray(block.chain.tree.mechanism.input.speed), block.size))[variants]
    first, most = over(on), np.zeros(count)
    if idle:
        theta = np.linspace(0.0, TURN, SAMPLED)
        causes = causes_in(block.statics(np.repeat(variants, SAMPLED)))
        most = causes.possible(np.tile(theta, count)).reshape(count, SAMPLED).max(axis=1)
    largest = on.largest(np.max(np.abs(first.rows), axis=-1))
    scales, _ = scales_of(largest, speed ** orders_of(names)[:, None], most)
    found = resolved(on, first, over, scales, fine, TURN)
    clear = (found.growth < SAFE) & (found.left_out <= fine.tolerance)
    return Cycles(found.mesh, names, found.rows, found.left_out, clear)


def sampled(block: Block, owner: Indices, theta: Real, side: Real, *, idle: bool) -> Sample:
    """Everything at theta (n,) of the variants ``owner`` (n,); ``idle``: friction without technological loads too."""
    parts = []
    for rows in np.split(np.arange(len(theta)), range(AT_ONCE, len(theta), AT_ONCE)):
        causes = causes_in(block.statics(owner[rows]))
        causes = causes if idle else causes._replace(statics=causes.statics._replace(cases=None))
        parts.append(causes.at(causes.scene.place(theta[rows], side[rows]), side[rows]))
    return joined(parts)
