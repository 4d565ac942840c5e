"""All assemblies of a group at one position.

Those of groups of one or two loops (class III and IV of four links; a driven length with three or five) come from
`elimination`, which misses none. Groups of more loops are closed by Newton from many starts; an assembly that few
starts lead to can be missed there. Every assembly is polished by Newton and kept once.
"""

from __future__ import annotations

import math

import numpy as np

from tmmcalc.core.plane import Real
from tmmcalc.linkage.loops.closure import Loops
from tmmcalc.linkage.loops.elimination import near

STARTS = 600
SEED = 1
PASSES = 40
SAME = 1e-6  # unknowns, in radians and parts of the group's size, that make one assembly
CLOSED = 1e-10  # part of the group's size that an assembly may leave open


def assemblies(loops: Loops) -> Real:
    """Unknowns (N, a) of the a real assemblies of a group, angles in (-pi, pi], in ascending order of the angles.

    ``loops`` hold one position. Raises nothing: a group that does not assemble there has none.
    """
    eq = loops.equations
    size, count = loops.size, eq.classes.shape[1]
    start = near(loops) if len(eq.classes) < 3 else _starts(eq.unknowns, count, size)
    if not start.shape[1]:
        return start
    placed, done = loops.close(start, PASSES)
    largest = max(float(np.max(np.abs(eq.classes), initial=0.0)), float(np.max(np.abs(loops.given[0]), initial=0.0)))
    fine = done & (np.max(np.abs(placed.residual), axis=0) < CLOSED * largest)
    q = placed.q[:, fine]
    q[:count] = math.pi - np.mod(math.pi - q[:count], 2 * math.pi)
    return q[:, _distinct(q, size, count)]


def _starts(unknowns: int, count: int, size: Real) -> Real:
    """Unknowns (N, m) spread over all they can be."""
    start = np.random.default_rng(SEED).uniform(-1.0, 1.0, (unknowns, STARTS)) * size[:, None]
    start[:count] *= math.pi
    return start


def _distinct(q: Real, size: Real, count: int) -> list[int]:
    """Which columns of q (N, m) are an assembly each, sorted."""
    found: list[int] = []
    for k in range(q.shape[1]):
        if not any(_same(q[:, k] - q[:, other], size, count) for other in found):
            found.append(k)
    return sorted(found, key=lambda k: tuple(np.round(q[:, k], 9)))


def _same(gap: Real, size: Real, count: int) -> bool:
    angles = gap[:count] - 2 * math.pi * np.rint(gap[:count] / (2 * math.pi))
    return bool(np.max(np.abs(np.concatenate((angles, gap[count:])) / size)) < SAME)
