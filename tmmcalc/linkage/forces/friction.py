"""Friction in the pairs of a group, solved to the end: values, self-locking, further solutions.

Coulomb: against the sliding, f |N| in a prismatic pair (3.27), a moment f r |R| about the pin in a revolute one (3.28:
the friction circle). Reactions are linear in the friction values q, R_j = R_j0 + sum S_jk q_k, so the whole problem is

    q_j + c_j m_j(R_j0 + sum_k S_jk q_k) = 0        c_j = f (or f r) times the sense of sliding, m_j = |N_j| or |R_j|

for the k <= 3 rubbing pairs of a group. Where the loop gain, the largest sum_k |S_jk c_k|, is below one the
solution is the only one and Newton finds it. Elsewhere the solution is followed from no friction to the full one (of
one pair it has a closed form); where the determinant of that path vanishes on the way there is none: the group locks
itself.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import product
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.numerics.systems import cramer
from tmmcalc.core.plane import Real
from tmmcalc.linkage.forces.wrench import Seat, Slideway, Wrench

SAFE = 0.9  # loop gain below which the solution is unique and Newton needs no guidance
EXACT = 1e-8  # step of Newton, against the values, after which nothing is left: digits double
NEWTON = 40
TOGETHER = 5  # passes over all positions; the few that need more go on alone
FIRST_STEP, LEAST_STEP = 0.25, 1e-9  # of the path from no friction (0) to the full friction (1)
GROWTH = 10.0  # of the values in one step of the path
ASIDE = 0.1  # part of the values by which a step may miss what its tangent foretold
STEPS = 400
TINY = 1e-300  # a force without direction
APART = 1e-6  # relative difference that makes another solution of a Newton end

Flags = NDArray[np.bool_]


class Rubbing(NamedTuple):
    """A rubbing pair: its seat, c (n,), the wrenches R_0 and S_k on its receiver, half length of its slider [m]."""

    seat: Seat
    c: Real  # coefficient (times the pin radius) times the sense of sliding
    base: Wrench
    responses: tuple[Wrench, ...]  # to a unit value in each rubbing pair
    half: float | None


class Solution(NamedTuple):
    """Friction values q (k, n), where the group is locked, the part of the friction it can take, other solutions."""

    values: Real
    locked: Flags
    limit: Real  # (n,) part of the friction at which it locks; 1 where it does not
    ambiguous: Flags
    amplification: Real  # (n,) factor by which errors of the loads grow in the friction, at most
    passes: int

    def rows(self, which: slice | int) -> Solution:
        """The same at some of the positions, or in one of the cases of load."""
        return self._replace(
            values=self.values[:, which],
            locked=self.locked[which],
            limit=self.limit[which],
            ambiguous=self.ambiguous[which],
            amplification=self.amplification[which],
        )


def solve(pairs: Sequence[Rubbing], shape: tuple[int, ...]) -> Solution:
    """Solve all positions at once; values of locked positions are those of no friction.

    ``shape`` is (n,), or (C, n) of C cases of load at n positions, in place of every (n,).
    """
    problem = _problem(pairs, shape)
    n = problem.c.shape[1]
    with np.errstate(divide="ignore", invalid="ignore"):
        values, done, passes = problem.newton(problem.first(), np.ones(n))
        gain = problem.gain()
        wild = ~done | (gain >= SAFE)
        locked, ambiguous, limit, amplification = np.zeros(n, bool), np.zeros(n, bool), np.ones(n), 1 / (1 - gain)
        if wild.any():
            hard = problem.at(np.flatnonzero(wild))
            found, reached, further = hard.reached()
            values[:, wild], limit[wild], locked[wild] = found, reached, reached < 1
            ambiguous[wild] = further & (reached == 1)
            amplification[wild] = np.where(reached == 1, np.maximum(1.0, 1 / hard.determinant(found, reached)), 1.0)
    flags = (locked.reshape(shape), limit.reshape(shape), ambiguous.reshape(shape), amplification.reshape(shape))
    return Solution(values.reshape(len(values), *shape), *flags, passes)


def joined(parts: Sequence[Solution]) -> Solution:
    """The solutions of blocks of positions as one."""
    if len(parts) == 1:
        return parts[0]
    return Solution(
        np.concatenate([part.values for part in parts], axis=1),
        np.concatenate([part.locked for part in parts]),
        np.concatenate([part.limit for part in parts]),
        np.concatenate([part.ambiguous for part in parts]),
        np.concatenate([part.amplification for part in parts]),
        max(part.passes for part in parts),
    )


class _Problem(NamedTuple):
    """The equations of n positions in plain numbers.

    m_j is the length of the vector z_j = base_j + sum_k response_jk q_k: the force in a pin, the normal force on a
    guide. A slider of given length has a second vector, its couple over half that length: the longer one counts.
    """

    base: Real  # (2, m, n)
    response: Real  # (2, m, k, n)
    tipping: tuple[tuple[int, int], ...]  # pair and row of its couple
    c: Real  # (k, n)

    def at(self, rows: NDArray[np.intp]) -> _Problem:
        """The same equations at some positions."""
        return _Problem(self.base[..., rows], self.response[..., rows], self.tipping, self.c[:, rows])

    def sizes(self, z: Real) -> Real:
        """m_j (k, ...) of the vectors z (2, m, ...)."""
        length = np.sqrt(z[0] * z[0] + z[1] * z[1])
        for j, row in self.tipping:
            np.maximum(length[j], length[row], out=length[j])
        return length[: len(self.c)]

    def first(self) -> Real:
        """Two passes of the plain iteration from no friction: a start for Newton."""
        q = -self.c * self.sizes(self.base)
        return -self.c * self.sizes(self.base + np.add.reduce(self.response * q, axis=2))

    def gain(self) -> Real:
        """Largest loop gain (n,): the bound of how much one pass changes the reactions that it started from."""
        gains = self.sizes(self.response)
        return np.maximum.reduce(np.add.reduce(gains * np.abs(self.c), axis=1), axis=0)

    def residual(self, q: Real, part: Real) -> tuple[Real, Real]:
        """Left sides (k, n) with the friction multiplied by ``part`` (n,), and their Jacobian (k, k, n)."""
        k = len(q)
        work = self.response * q  # large: the second use of it saves fetching fresh memory
        z = np.add.reduce(work, axis=2)
        z += self.base
        length = np.sqrt(z[0] * z[0] + z[1] * z[1])
        z /= np.maximum(length, TINY)
        np.multiply(z[:, :, None], self.response, out=work)
        slopes = work[0]
        slopes += work[1]
        for j, row in self.tipping:
            tips = length[row] > length[j]
            length[j], slopes[j] = np.where(tips, length[row], length[j]), np.where(tips, slopes[row], slopes[j])
        c = part * self.c
        jacobian = np.multiply(slopes[:k], c[:, None], out=slopes[:k])
        jacobian[np.arange(k), np.arange(k)] += 1.0
        return q + c * length[:k], jacobian

    def newton(self, q: Real, part: Real, most: int = NEWTON) -> tuple[Real, Flags, int]:
        """Newton from q (k, n): values, which positions converged, passes."""
        q, done, passes = self._passes(q, part, min(most, TOGETHER))
        if passes < most and not done.all():
            rest = np.flatnonzero(~done)
            q[:, rest], done[rest], more = self.at(rest)._passes(q[:, rest], part[rest], most - passes)
            passes += more
        return q, done, passes

    def _passes(self, q: Real, part: Real, most: int) -> tuple[Real, Flags, int]:
        for count in range(most):
            left, jacobian = self.residual(q, part)
            step, _ = cramer(jacobian, left)
            q = q - step
            done = np.maximum.reduce(np.abs(step)) <= EXACT * np.maximum.reduce(np.abs(q))
            if done.all():
                return q, done, count + 1
        return q, done, most

    def reached(self) -> tuple[Real, Real, Flags]:
        """The solution that grows out of no friction (k, n), how far it goes (n,), whether there is another (n,)."""
        if len(self.c) == 1 and not self.tipping:
            return one_pair(self.base[:, 0], self.response[:, 0, 0], self.c[0])
        found, part = self.followed()
        return found, part, self.others(found)

    def followed(self) -> tuple[Real, Real]:
        """The solution on the path from no friction (k, n), and how far the path goes (n,): 1 if to the end."""
        k, n = self.c.shape
        q, part, step = np.zeros((k, n)), np.zeros(n), np.full(n, FIRST_STEP)
        for _ in range(STEPS):
            active = np.flatnonzero((part < 1) & (step >= LEAST_STEP))
            if not active.size:
                break
            some = self.at(active)
            target = np.minimum(part[active] + step[active], 1.0)
            expected = q[:, active] + some._direction(q[:, active], part[active]) * (target - part[active])
            tried, done, _ = some.newton(expected, target, 12)
            good = done & (some.determinant(tried, target) > 0) & _near(tried, expected, q[:, active])
            ok = active[good]
            q[:, ok], part[ok] = tried[:, good], target[good]
            step[active] = np.where(good, step[active] * 2, step[active] / 4)
        return np.where(part == 1, q, 0.0), part

    def _direction(self, q: Real, part: Real) -> Real:
        """Tangent dq/dpart (k, n) of the path."""
        left, _ = self.residual(q, np.ones(len(part)))
        return -cramer(self.residual(q, part)[1], left - q)[0]

    def determinant(self, q: Real, part: Real) -> Real:
        """Determinant (n,) of the equations: one without friction, zero where the path ends."""
        return cramer(self.residual(q, part)[1], q)[1]

    def others(self, q: Real) -> Flags:
        """Where Newton finds a further solution from the other senses of the reactions."""
        k, n = q.shape
        found = np.zeros(n, bool)
        scale = np.max(np.abs(q), axis=0)
        bare = np.abs(self.c) * self.sizes(self.base)
        for signs in product((-1.0, 1.0), repeat=k):
            for size in (10.0, 1000.0):
                start = np.array(signs)[:, None] * (bare + scale) * size
                other, done, _ = self.newton(start, np.ones(n))
                apart = np.max(np.abs(other - q), axis=0) > APART * np.maximum(scale, np.max(np.abs(other), axis=0))
                found |= done & apart
        return found


def one_pair(base: Real, response: Real, c: Real) -> tuple[Real, Real, Flags]:
    """Friction q = -c m (1, n) of one pair, the part of it that moves (n,), 1 if all, whether there is another.

    The size m of the force grows with the part p of the friction from |b| on, b the force without friction:

        m = |b - p c m S|,   (1 - p^2 c^2 S^2) m^2 + 2 p c (b.S) m = |b|^2

    Where friction loads the pair further (c b.S < 0) m has a pole at p |c S| = 1; elsewhere the path folds back at
    p |c (b x S)| = |b|, beyond which no m fulfils the equation. From p |c S| = 1 on to the fold there is a second one.

    ``base`` (2, n) is the force without friction, ``response`` (2, n) that to a unit of it, c (n,) the coefficient with
    its sign. Where the pair locks, q is zero.
    """
    own, along = base[0] * base[0] + base[1] * base[1], c * (base[0] * response[0] + base[1] * response[1])
    across = np.abs(c * (base[0] * response[1] - base[1] * response[0]))
    gain = np.abs(c) * np.sqrt(response[0] * response[0] + response[1] * response[1])
    leading = (1 - gain) * (1 + gain)
    root = np.sqrt(np.maximum(own - across * across, 0.0))  # of the discriminant, for 1 - gain^2 < 0 too
    with np.errstate(divide="ignore", invalid="ignore"):  # in the case that is not taken
        end = np.where(own == 0, np.inf, np.where(along < 0, 1 / gain, np.sqrt(own) / across))
        direct = np.where(along < 0, (root - along) / leading, own / (along + root))
    moves = end > 1
    size = np.where(moves & (own > 0), direct, 0.0)
    return -(c * size)[None], np.where(moves, 1.0, end), moves & (leading < 0) & (own > 0)


def _problem(pairs: Sequence[Rubbing], shape: tuple[int, ...]) -> _Problem:
    """The equations of the pairs, the positions of all cases one behind the other."""
    tipping = [(j, pair.half) for j, pair in enumerate(pairs) if pair.half is not None]
    k = len(pairs)
    base, response = np.zeros((2, k + len(tipping), *shape)), np.zeros((2, k + len(tipping), k, *shape))
    for j, pair in enumerate(pairs):
        _write(pair.seat, pair.base, base[:, j])
        for i, wrench in enumerate(pair.responses):
            _write(pair.seat, wrench, response[:, j, i])
    for row, (j, half) in enumerate(tipping, k):
        base[0, row] = pairs[j].base.moment / half
        for i, wrench in enumerate(pairs[j].responses):
            response[0, row, i] = wrench.moment / half
    c = np.empty((k, *shape))
    for j, pair in enumerate(pairs):
        c[j] = pair.c
    base, response, c = (part.reshape(*part.shape[: -len(shape)], -1) for part in (base, response, c))
    return _Problem(base, response, tuple((j, row) for row, (j, _) in enumerate(tipping, k)), c)


def _write(seat: Seat, wrench: Wrench, z: Real) -> None:
    """What friction is proportional to, as a vector z (2, ...): the force in a pin, on a guide its normal part."""
    if isinstance(seat, Slideway):
        z[0] = (np.conj(1j * seat.e) * wrench.force).real
    else:
        z[0], z[1] = wrench.force.real, wrench.force.imag


def _near(found: Real, expected: Real, before: Real) -> Flags:
    """Whether a step stayed on its path: Newton moved it by little against its size, and it did not leap."""
    size, old = np.max(np.abs(expected), axis=0), np.max(np.abs(before), axis=0)
    return (np.max(np.abs(found - expected), axis=0) <= ASIDE * size) & ((old == 0) | (size <= GROWTH * old))


def size_of(seat: Seat, wrench: Wrench, half: float | None) -> Real:
    """What friction is proportional to: |R| of a pin, |N| on a guide, N' + N'' of a slider that bears on its edges."""
    if not isinstance(seat, Slideway):
        return np.abs(wrench.force)
    normal = np.abs((np.conj(1j * seat.e) * wrench.force).real)
    return normal if half is None else np.maximum(normal, np.abs(wrench.moment) / half)
