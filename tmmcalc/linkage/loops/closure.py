"""The loops of a group solved: positions by Newton's method, rates and second derivatives by one linear solve each.

All is one pass over arrays of n positions. The columns of the Jacobian are the derivatives of F by the angles of the
classes and by the free coordinates; rates and second derivatives have the same columns:

    J q'  = -(G' + known slides)                      J q'' = -(G'' - sum omega^2 W + 2 i omega s' D e + known slides)

W_c is all that turns with class c. The drive inside a group is its own variable: s' = 1, s'' = 0.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tmmcalc.core.numerics.systems import solve
from tmmcalc.core.plane import Guide, Plane, Point, Real, rotated
from tmmcalc.linkage.dyads.base import Motions, Slide, Slides, carried, slid
from tmmcalc.linkage.loops.equations import Equations

PASSES = 12
NEAR = 1e-7  # a step of Newton, against the unknowns, after which one more leaves nothing
REFINED = 1e-13  # and in extended precision, where the Jacobian is taken in double
STRAY = 1.0  # a step larger than this [rad], or in parts of the group's size, is cut to it


class PlacedGroup(NamedTuple):
    """A group in place: unknowns q (N, n), U (C, n), coordinates s and directions e (S, n) of the prismatic joints."""

    q: Real
    u: Plane
    s: Real
    e: Plane
    whirled: Plane  # (L, C, n) W: what turns with each class
    jacobian: Real  # (2 L, N, n)
    residual: Plane  # (L, n) F

    @property
    def regularity(self) -> Real:
        """Smallest singular value (n,) of the Jacobian with unit columns: 0 where the group is singular."""
        return unit_singular(self.jacobian)

    @property
    def determinant(self) -> Real:
        """Determinant (n,) of the Jacobian with unit columns; its sign is constant along a branch."""
        matrix, fine = _unit_columns(self.jacobian)
        found = np.zeros(len(fine))
        found[fine] = np.linalg.det(matrix)
        return found


def unit_singular(jacobian: Real) -> Real:
    """Smallest singular value (n,) of matrices (N, N, n) whose columns are brought to length one."""
    matrix, fine = _unit_columns(jacobian)
    found = np.zeros(len(fine))
    if len(matrix):
        found[fine] = np.linalg.svd(matrix, compute_uv=False)[:, -1]
    return found


def _unit_columns(jacobian: Real) -> tuple[Real, np.ndarray]:
    """Matrices (m, N, N) with columns of length one, and which (n,) they are: those without a column of zeros."""
    matrix = np.moveaxis(np.asarray(jacobian, dtype=float), -1, 0)
    lengths = np.sqrt(np.add.reduce(matrix * matrix, axis=1))
    fine = np.isfinite(lengths).all(axis=1) & (lengths > 0).all(axis=1)
    return matrix[fine] / lengths[fine, None], fine


class Loops(NamedTuple):
    """The equations of a group with what the source chain gives at n positions."""

    equations: Equations
    motions: Motions
    given: tuple[Plane, Plane, Plane]
    drive: Real  # (n,) the coordinate of the drive, read where it acts inside the group

    def place(self, q: Real) -> PlacedGroup:
        """The group at the unknowns q (N, n), closed or not."""
        eq = self.equations
        count = eq.classes.shape[1]
        u = np.exp(1j * q[:count])
        s = self.coordinates(q[count:], self.drive)
        e = self._directions(u)
        slides = eq.slides[:, :, None] * e * s
        whirled = eq.classes[:, :, None] * u
        for j, rail in enumerate(eq.rails):
            if not rail.along.known:
                whirled[:, rail.along.of] += slides[:, j]
        still = [j for j, rail in enumerate(eq.rails) if rail.along.known]
        residual = self.given[0] + whirled.sum(axis=1) + slides[:, still].sum(axis=1)
        columns = np.concatenate((1j * whirled, eq.slides[:, eq.free, None] * e[eq.free]), axis=1)
        return PlacedGroup(q, u, s, e, whirled, np.concatenate((columns.real, columns.imag)), residual)

    def close(self, q: Real, passes: int = PASSES) -> tuple[PlacedGroup, np.ndarray]:
        """Newton from q (N, n): the group in place, and where (n,) it converged."""
        limit = NEAR if q.dtype == np.float64 else REFINED
        size = self.size
        done = np.zeros(q.shape[1], bool)
        for _ in range(passes):
            q, relative = self.corrected(self.place(q), size)
            if np.all(done | ~np.isfinite(relative)):
                break
            done |= relative < limit
        return self.place(q), done

    def corrected(self, placed: PlacedGroup, size: Real) -> tuple[Real, Real]:
        """The unknowns after a step of Newton, cut where it strays, and what it is against their ``size``, (n,)."""
        q = placed.q
        step = solve(placed.jacobian, -_real(placed.residual)) if q.shape[1] else q
        relative = np.max(np.abs(step) / size[:, None], axis=0, initial=0.0)
        with np.errstate(invalid="ignore", over="ignore"):
            return q + step * np.minimum(1.0, STRAY / np.maximum(relative, STRAY)), relative

    @property
    def size(self) -> Real:
        """What each unknown (N,) is measured by: one radian, and the largest constant length [m]."""
        eq = self.equations
        count = eq.classes.shape[1]
        lengths = np.concatenate((np.abs(eq.classes).ravel(), np.abs(eq.axes).ravel(), np.abs(self.given[0]).ravel()))
        finite = lengths[np.isfinite(lengths)]
        return np.array([1.0] * count + [float(np.max(finite, initial=1e-300))] * len(eq.free))

    def rates(self, placed: PlacedGroup) -> tuple[Real, Real]:
        """First and second derivative (N, n) of the unknowns by the variable of the source chain."""
        eq, count = self.equations, self.equations.classes.shape[1]
        q1 = solve(placed.jacobian, -self.by_drive(placed))
        omega, speeds = q1[:count], self.coordinates(q1[count:], 1.0)
        second = self.given[2] - np.einsum("lcn,cn->ln", placed.whirled, (omega**2).astype(placed.u.dtype))
        for j, rail in enumerate(eq.rails):
            turning = self._derivative(j, 1) if rail.along.known else 1j * omega[rail.along.of] * placed.e[j]
            own = 2 * speeds[j] * turning + placed.s[j] * self._derivative(j, 2)
            second = second + eq.slides[:, j, None] * own
        return q1, solve(placed.jacobian, -_real(second))

    def by_drive(self, placed: PlacedGroup) -> Real:
        """Derivative (2 L, n) of F by the variable of the source chain while the unknowns stand still."""
        total = self.given[1] + 0 * placed.residual
        for j, rail in enumerate(self.equations.rails):
            own = placed.s[j] * self._derivative(j, 1) + (placed.e[j] if rail.driven else 0.0)
            total = total + self.equations.slides[:, j, None] * own
        return _real(total)

    def move(self, placed: PlacedGroup, q1: Real, q2: Real, motions: Motions, slides: Slides) -> None:
        """Add the motions of the links, and the sliding coordinates."""
        eq, count = self.equations, self.equations.classes.shape[1]
        rates = zip(placed.s, self.coordinates(q1[count:], 1.0), self.coordinates(q2[count:], 0.0), strict=True)
        for rail, slide in zip(eq.rails, rates, strict=True):
            slides[rail.joint] = Slide(*slide)
        turned = [rotated(0j, _NOWHERE, *state) for state in zip(placed.u, q1[:count], q2[:count], strict=True)]
        for link, joint, parent in eq.tree:
            side = joint.links.index(link)
            at, own = motions[parent].point(joint.points[1 - side]), eq.turnings[link]
            carrier = self.motions[own.of] if own.known else turned[own.of]
            if joint.kind == "prismatic":
                guide = Guide(*at, carrier.u * own.turn * joint.directions[side], carrier.omega, carrier.eps)
                ahead = 1.0 if side == 0 else -1.0  # a slider lies ahead of its guide's point, a guide behind it
                at = slid(guide, *(ahead * part for part in slides[joint.name]))
            motions[link] = carried(carrier, own.turn, joint.points[side], at)

    def coordinates(self, free: Real, drive: Real | float) -> Real:
        """Values (S, n) of all prismatic joints from the free ones; ``drive`` is that of the driven one."""
        values = np.empty((len(self.equations.rails), free.shape[1]), free.dtype)
        values[self.equations.free] = free
        for j, rail in enumerate(self.equations.rails):
            if rail.driven:
                values[j] = drive
        return values

    def _directions(self, u: Plane) -> Plane:
        """Directions e (S, n) of the prismatic joints."""
        e = np.empty((len(self.equations.rails), u.shape[1]), u.dtype)
        for j, (_, along, _) in enumerate(self.equations.rails):
            e[j] = along.turn * (self.motions[along.of].u if along.known else u[along.of])
        return e

    def _derivative(self, j: int, order: int) -> Plane:
        """First or second derivative of a direction that turns with the source chain; zero of another one."""
        along = self.equations.rails[j].along
        if not along.known:
            return _STILL
        motion = self.motions[along.of]
        return along.turn * (motion.u1 if order == 1 else motion.u2)


_STILL = np.zeros((), complex)
_NOWHERE = Point(_STILL, _STILL, _STILL)


def _real(f: Plane) -> Real:
    """Complex equations (L, n) as real ones (2 L, n)."""
    return np.concatenate((f.real, f.imag))
