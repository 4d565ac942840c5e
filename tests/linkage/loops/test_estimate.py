"""The error estimate of groups of class III, IV and VI against their true error in random linkages.

The truth: the pins of all links, each with the axes that the task gives it, closed by Newton's method in extended
precision, and the linear equations of their rates.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from bounding import assert_bounds, part

from linkage.loops.groups import CLASS_III, CLASS_IV, CLASS_VI, MARK, scene
from linkage.scenes import with_grid
from tmmcalc import TmmError, solve_kinematics
from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.numerics.extended import WIDER
from tmmcalc.linkage.chain import Chain, chain_of
from tmmcalc.linkage.model import Mechanism
from tmmcalc.linkage.placing import placed
from tmmcalc.linkage.structure import solve_structure

pytestmark = pytest.mark.skipif(not WIDER, reason="no wider float here: the estimate has no reference")

KINDS = ("position", "velocity", "acceleration")
Array = np.ndarray[Any, Any]
STEPS = 6  # of Newton's method, each of which brings twelve digits of what is wrong


def drawn(seed: int) -> Mechanism:
    """A group of pins of one of three classes, on a crank that goes by half a turn at most."""
    rng = np.random.default_rng(10**6 + seed)
    found = scene(seed, (CLASS_IV, CLASS_III, CLASS_VI)[seed % 3], crank=float(10 ** rng.uniform(-1.2, -0.3)))
    return with_grid(found.mechanism, positions=40, span=float(10 ** rng.uniform(-2, -0.2)))


class Pins:
    """The equations of all pins: places of origins and angles of the links at one angle of the crank."""

    def __init__(self, mechanism: Mechanism) -> None:
        self.joints = mechanism.joints
        self.links = [link.id for link in mechanism.links]

    def at(self, q: Array, k: int, p: complex) -> Any:
        """The arm from the origin of link k (in its row of q: x, y, angle) to its point p."""
        return np.exp(1j * q[self.links.index(k), 2]) * p if k else np.clongdouble(0)

    def gaps(self, q: Array, x: Any) -> Array:
        """What is open in all pins, and between crank and coordinate."""
        found = []
        for joint in self.joints:
            ends = [self._place(q, k, p) for k, p in zip(joint.links, joint.points, strict=True)]
            found += [(ends[0] - ends[1]).real, (ends[0] - ends[1]).imag]
        return np.array([*found, q[self.links.index(1), 2] - x])

    def _place(self, q: Array, k: int, p: complex) -> Any:
        if not k:
            return np.clongdouble(p)
        x, y, _ = q[self.links.index(k)]
        return x + 1j * y + self.at(q, k, p)

    def jacobian(self, q: Array) -> Array:
        """Derivatives of the gaps by all unknowns."""
        rows = np.zeros((2 * len(self.joints) + 1, len(self.links), 3), np.longdouble)
        for i, joint in enumerate(self.joints):
            for sign, k, p in zip((1, -1), joint.links, joint.points, strict=True):
                if k:
                    turned = 1j * self.at(q, k, p)
                    rows[2 * i : 2 * i + 2, self.links.index(k)] += sign * np.array(
                        [[1, 0, turned.real], [0, 1, turned.imag]]
                    )
        rows[-1, self.links.index(1), 2] = 1
        return rows.reshape(len(rows), -1)

    def inward(self, q: Array, rate: Array) -> Array:
        """What of the second derivatives of the gaps the rates make by themselves."""
        found = []
        for joint in self.joints:
            ends = [
                -self.at(q, k, p) * (rate[self.links.index(k), 2] ** 2 if k else 0)
                for k, p in zip(joint.links, joint.points, strict=True)
            ]
            found += [(ends[0] - ends[1]).real, (ends[0] - ends[1]).imag]
        return np.array([*found, np.longdouble(0)])


def solved(matrix: Array, right: Array) -> Array:
    """The solution of linear equations in extended precision, by the residuals of those of double precision."""
    inverse, found = np.linalg.pinv(matrix.astype(float)), np.zeros(matrix.shape[1], np.longdouble)
    for _ in range(STEPS):
        found = found + inverse @ (right - matrix @ found)
    return found


def truth(mechanism: Mechanism, chain: Chain, x: Array) -> tuple[Array, Array, Array]:
    """Places of the marked points P and their two derivatives by the crank's angle, each (P, n)."""
    pins, motions = Pins(mechanism), chain.evaluate(x).motions
    columns = []
    for i, angle in enumerate(x.astype(np.longdouble)):
        start = [(m := motions[k], complex(np.broadcast_to(m.u, x.shape)[i])) for k in pins.links]
        origins = [complex(np.broadcast_to(m.r, x.shape)[i]) - u * m.base for m, u in start]
        q = np.array([(o.real, o.imag, np.angle(u)) for o, (_, u) in zip(origins, start, strict=True)], np.longdouble)
        q[pins.links.index(1), 2] = angle
        for _ in range(STEPS):
            q = q - solved(pins.jacobian(q), pins.gaps(q, angle)).reshape(q.shape)
        matrix, unit = pins.jacobian(q), np.zeros(2 * len(pins.joints) + 1, np.longdouble)
        unit[-1] = 1
        rate = solved(matrix, unit).reshape(q.shape)
        bend = solved(matrix, -pins.inward(q, rate)).reshape(q.shape)
        points = []
        for k, (x0, y0, _), (dx, dy, w), (ddx, ddy, e) in zip(pins.links, q, rate, bend, strict=True):
            arm = pins.at(q, k, MARK)
            points.append((x0 + 1j * y0 + arm, dx + 1j * dy + 1j * w * arm, ddx + 1j * ddy + (1j * e - w * w) * arm))
        columns.append(points)
    r, v, a = np.moveaxis(np.array(columns), 2, 0)
    return r.T, v.T, a.T


def near_limit(seed: int) -> Mechanism:
    """The same, up to the limit position of its branch but for 1e-2 to 1e-11 rad."""
    mechanism = with_grid(drawn(seed), positions=12)
    found = placed(mechanism, solve_structure(mechanism))
    branch = next(iter(found.chain.branches.values()))
    left = 10 ** np.random.default_rng(seed).uniform(-11, -2)
    if branch.high not in (limit.x for limit in branch.limits):
        raise NoSolutionError("the branch has no limit ahead")
    return with_grid(mechanism, span=branch.high - found.start - left)


def check(seeds: range, scenes: int, make: Callable[[int], Mechanism] = drawn, every: int = 4) -> None:
    pairs = defaultdict(list)
    for seed in seeds:
        try:
            mechanism = make(seed)
            result = solve_kinematics(mechanism)
        except TmmError:
            continue
        told, chain = result.trace, chain_of(mechanism, result)
        rows = [told.point_names.index(f"P{link.id}") for link in mechanism.links]
        exact = truth(mechanism, chain, result.x[::every])
        for kind, found, true in zip(KINDS, (told.r, told.dr, told.ddr), exact, strict=True):
            error = float(np.max(np.abs(found[rows, ::every] - true)) / np.max(np.abs(true)))
            pairs[kind].append((getattr(result.error, kind), error))
    for kind, values in pairs.items():
        assert_bounds(values, kind, scenes=scenes)


def test_estimates_of_some_groups() -> None:
    check(range(300, 303), 2)


@pytest.mark.slow
def test_estimates_of_many_groups() -> None:
    check(range(part(250, 8)), part(200, 10))


def test_estimates_of_some_groups_near_their_limits() -> None:
    check(range(6), 2, near_limit, 1)


@pytest.mark.slow
def test_estimates_of_groups_near_their_limits() -> None:
    check(range(110), 50, near_limit, 1)
