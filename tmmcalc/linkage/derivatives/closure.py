"""How the links move when the inputs change: the closure of all joints, differentiated implicitly.

The unknowns are the origin z and the angle theta of every moving link, whatever groups they form. The joints hold

    revolute        z_i + p_i u_i = z_j + p_j u_j                       u = exp(i theta)
    prismatic       theta_i + arg d_i = theta_j + arg d_j,   e x D = 0
    the drive       theta = x of a crank,   e . D = x of a prismatic joint

with e = d_j u_j, D = z_i + p_i u_i - z_j - p_j u_j, which is F(q, x, p) = 0 with the inputs p. Along a change dp of the
inputs J dq = -F_p dp, J = F_q; the same matrix gives the changes of the transfer functions q' and q'' from the
equations differentiated once and twice by x, each with the lower ones on its right side. The input coordinate x is one
direction more, which gives the derivatives along x, by which rows follow an input coordinate that moves.

Jets are arrays (3, ...): a value and its first and second derivative by x. Their changes in K directions are
(3, K, n), those of inputs (K, 1). Lengths are in units of the reach in the matrix, so that its condition is a number.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.numerics.alike import numbers, rebuilt
from tmmcalc.core.plane import Plane, Real, cross
from tmmcalc.linkage.chain import Chain
from tmmcalc.linkage.model import FRAME, Joint, Output

EPS = float(np.finfo(float).eps)
BINOMIAL = ((1.0,), (1.0, 1.0), (1.0, 2.0, 1.0))

Slopes = NDArray[np.complexfloating[Any, Any]]
Indices = NDArray[np.intp]


def changes_of(tree: Any, slopes: Slopes) -> Any:
    """The tree with the slopes (K, L) of its L numbers, along K directions, in the place of these: (K, 1) each.

    The order of the numbers is that of `core.numerics.alike.numbers`.
    """
    plain = [isinstance(number, float) for number in numbers(tree)]
    columns = (slopes[:, k, None] for k in range(slopes.shape[1]))
    return rebuilt(tree, [column.real if real else column for column, real in zip(columns, plain, strict=True)])


def times(a: Any, b: Any) -> Any:
    """The product of two jets, by Leibniz' rule."""
    parts = [sum(c * a[m] * b[k - m] for m, c in enumerate(row)) for k, row in enumerate(BINOMIAL)]
    return np.stack(np.broadcast_arrays(*parts))


class Body(NamedTuple):
    """A link in place: jets (3, 1, n) of its origin and of the unit vector along its x axis."""

    z: Plane
    u: Plane


class Change(NamedTuple):
    """What a link does along K directions: jets (3, K, n) of the changes of origin, angle and unit vector."""

    z: Plane
    angle: Real
    u: Plane


class Moved(NamedTuple):
    """The links at n input coordinates and how they change along K directions.

    ``largest`` (3, K) is the largest change of an origin, or of an angle by the ``reach`` [m], of each order.
    """

    chain: Chain
    changes: Any  # the mechanism with the slopes of its numbers, (K, 1) each
    bodies: dict[int, Body]
    links: dict[int, Change]
    reach: float
    condition: Real  # (n,) of the matrix

    def point(self, link: int, p: complex, dp: Any) -> tuple[Plane, Plane]:
        """Jet of a point p of a link, and its change (3, K, n)."""
        body, change = self.bodies[link], self.links[link]
        return body.z + p * body.u, change.z + p * change.u + dp * body.u

    def named(self, link: int, name: str) -> tuple[Plane, Plane]:
        """The same of a point by its name."""
        own = self.chain.mechanism.link(link).points[name]
        return self.point(link, own, self.changes.link(link).points[name])

    def pin(self, joint: Joint, side: int) -> tuple[Plane, Plane]:
        """The same of the point of a joint on one of its links."""
        change = self.changes.joint(joint.name)
        return self.point(joint.links[side], joint.points[side], change.points[side])

    def line(self, joint: Joint, side: int = 1) -> tuple[Plane, Plane]:
        """Jet of the direction of a prismatic joint as one of its links carries it, and its change."""
        body, change, d = self.bodies[joint.links[side]], self.links[joint.links[side]], joint.directions[side]
        return d * body.u, d * change.u + self.changes.joint(joint.name).directions[side] * body.u

    def slide(self, joint: Joint) -> tuple[Real, Real]:
        """Jet of the coordinate of a prismatic joint, and its change."""
        (e, de), (gap, dgap) = self.line(joint), self.gap(joint)
        return times(np.conj(e), gap).real, (times(np.conj(de), gap) + times(np.conj(e), dgap)).real

    def gap(self, joint: Joint) -> tuple[Plane, Plane]:
        """Jet of the vector from the point of its second link to that of the first, and its change."""
        (one, done), (other, dother) = self.pin(joint, 0), self.pin(joint, 1)
        return one - other, done - dother

    def output(self, output: Output, number: int) -> tuple[Real, Real]:
        """Jet of the coordinate of an output and its change; the jet of an angle begins with zero.

        ``number`` is its place among the outputs of the mechanism, if it has any.
        """
        if output.link is not None:
            u = self.bodies[output.link].u
            omega = (u[1] / u[0]).imag
            return np.stack([np.zeros_like(omega), omega, (u[2] / u[0]).imag]), self.links[output.link].angle
        if output.joint is not None:
            return self.slide(self.chain.mechanism.joint(output.joint))
        owner = next(link.id for link in self.chain.mechanism.links if output.point in link.points)
        r, dr = self.named(owner, output.point or "")
        turn = np.exp(-1j * output.direction)
        return (r * turn).real, ((dr - 1j * self.changes.outputs[number].direction * r) * turn).real

    def largest(self) -> Real:
        """The largest change (3, K) of an origin, or of an angle by the reach, up to each order [m]."""
        parts = [
            np.maximum(np.abs(change.z), self.reach * np.abs(change.angle)).max(axis=-1)
            for change in self.links.values()
        ]
        return np.maximum.accumulate(np.max(np.broadcast_arrays(*parts), axis=0), axis=0)

    def some(self, rows: Indices) -> Moved:
        """The same at some of the input coordinates."""
        bodies = {k: Body(*(part[..., rows] for part in body)) for k, body in self.bodies.items()}
        links = {
            k: Change(change.z[..., rows], change.angle[..., rows], change.u[..., rows])
            for k, change in self.links.items()
        }
        return self._replace(bodies=bodies, links=links, condition=self.condition[rows])

    def along(self, other: Moved, dx: Real) -> Moved:
        """The whole changes where the input coordinate moves by dx (K, n): ``other`` is the change along it."""
        links = {
            k: Change(*(own + other_part * dx for own, other_part in zip(change, other.links[k], strict=True)))
            for k, change in self.links.items()
        }
        return self._replace(links=links)


class Closure:
    """The closure of a chain at input coordinates x (n,), ready to be solved along any directions."""

    def __init__(self, chain: Chain, x: Real) -> None:
        self.chain, n = chain, len(x)
        self.ids = tuple(link.id for link in chain.mechanism.links)
        motions = chain.evaluate(x).motions
        still = np.zeros(n, complex)
        self.bodies = {FRAME: Body(np.stack([still] * 3)[:, None], np.stack([still + 1, still, still])[:, None])}
        for k in self.ids:
            at, motion = motions[k].point(0j), motions[k]
            z, u = (
                np.stack([np.broadcast_to(part, (n,)) for part in jet])
                for jet in (at, (motion.u, motion.u1, motion.u2))
            )
            self.bodies[k] = Body(z[:, None], u[:, None])
        seats = np.array([self._seat(joint, side) for joint in chain.mechanism.joints for side in (0, 1)])
        self.reach = float(np.max(np.abs(seats - seats[0]))) or 1.0
        self.matrix = self._matrix(n)
        self.condition = np.linalg.cond(self.matrix, 1)

    def moved(self, changes: Any, along_x: bool = False) -> Moved:
        """How the links change along the directions of a mechanism of slopes (K, 1), or along x alone."""
        count = numbers_of(changes)
        shape = (3, count, self.matrix.shape[0])
        z = {k: np.zeros(shape, complex) for k in (FRAME, *self.ids)}
        angle = {k: np.zeros(shape) for k in z}
        for order in range(3):
            links = {k: Change(z[k], angle[k], times(1j * self.bodies[k].u, angle[k])) for k in z}
            found = Moved(self.chain, changes, self.bodies, links, self.reach, self.condition)
            sides = self._sides(found, order, along_x)
            solved = np.moveaxis(np.linalg.solve(self.matrix, -np.moveaxis(sides, (0, 1), (1, 2))), 0, 2)
            for row, k in enumerate(self.ids):
                z[k][order] = (solved[3 * row] + 1j * solved[3 * row + 1]) * self.reach
                angle[k][order] = solved[3 * row + 2]
        links = {k: Change(z[k], angle[k], times(1j * self.bodies[k].u, angle[k])) for k in z}
        return Moved(self.chain, changes, self.bodies, links, self.reach, self.condition)

    def _seat(self, joint: Joint, side: int) -> Plane:
        body = self.bodies[joint.links[side]]
        return (body.z + joint.points[side] * body.u)[0, 0]

    def _matrix(self, n: int) -> Real:
        """J (n, 3 m, 3 m): rows of the joints in their order, the drive last; unknowns x, y, theta of every link."""
        matrix = np.zeros((n, 3 * len(self.ids), 3 * len(self.ids)))
        row = 0
        for joint in self.chain.mechanism.joints:
            if joint.kind == "revolute":
                for side, sign in ((0, 1.0), (1, -1.0)):
                    arm = sign * 1j * joint.points[side] * self.bodies[joint.links[side]].u[0, 0] / self.reach
                    self._write(matrix, row, joint.links[side], (sign, 0.0, arm.real))
                    self._write(matrix, row + 1, joint.links[side], (0.0, sign, arm.imag))
            else:
                self._turning(matrix, row, joint)
                self._sliding(matrix, row + 1, joint, across=True)
            row += 2
        drive = self.chain.input_joint
        if drive.kind == "prismatic":
            self._sliding(matrix, row, drive, across=False)
        else:
            self._write(matrix, row, self.chain.structure.input_link, (0.0, 0.0, 1.0))
        return matrix

    def _write(self, matrix: Real, row: int, link: int, parts: tuple[Any, Any, Any]) -> None:
        if link != FRAME:
            column = 3 * self.ids.index(link)
            for k, part in enumerate(parts):
                matrix[:, row, column + k] += part

    def _turning(self, matrix: Real, row: int, joint: Joint) -> None:
        for link, sign in zip(joint.links, (1.0, -1.0), strict=True):
            self._write(matrix, row, link, (0.0, 0.0, sign))

    def _sliding(self, matrix: Real, row: int, joint: Joint, *, across: bool) -> None:
        """Row of e x D, or of e . D."""
        e = joint.directions[1] * self.bodies[joint.links[1]].u[0, 0]
        gap = (self._seat(joint, 0) - self._seat(joint, 1)) / self.reach

        def part(a: Plane, b: Plane | complex) -> Real:
            return cross(a, b) if across else (np.conj(a) * b).real

        for side, sign in ((0, 1.0), (1, -1.0)):
            link = joint.links[side]
            turned = 1j * joint.points[side] * self.bodies[link].u[0, 0] / self.reach
            arm = part(e, sign * turned) + (part(1j * e, gap) if side else 0.0)
            self._write(matrix, row, link, (part(e, sign + 0j), part(e, sign * 1j), arm))

    def _sides(self, moved: Moved, order: int, along_x: bool) -> Real:
        """Changes (3 m, K, n) of the equations of this order while those of the unknowns of this order are zero."""
        shape = moved.links[FRAME].angle.shape[1:]
        sides = np.zeros((3 * len(self.ids), *shape))
        row = 0
        for joint in self.chain.mechanism.joints:
            gap, dgap = moved.gap(joint)
            if joint.kind == "revolute":
                sides[row], sides[row + 1] = dgap[order].real / self.reach, dgap[order].imag / self.reach
            else:
                directions = zip(joint.directions, moved.changes.joint(joint.name).directions, strict=True)
                one, other = ((change / d).imag for d, change in directions)
                angles = [moved.links[k].angle[order] for k in joint.links]
                sides[row] = angles[0] - angles[1] + ((one - other) if order == 0 else 0.0)
                e, de = moved.line(joint)
                across = times(np.conj(de), gap) + times(np.conj(e), dgap)
                sides[row + 1] = across[order].imag / self.reach
            row += 2
        drive = self.chain.input_joint
        asked = 1.0 if along_x and order == 0 else 0.0
        if drive.kind == "prismatic":
            sides[row] = (moved.slide(drive)[1][order] - asked) / self.reach
        else:
            sides[row] = moved.links[self.chain.structure.input_link].angle[order] - asked
        return sides


def numbers_of(changes: Any) -> int:
    """Number K of the directions of a mechanism of slopes."""
    return len(changes.input.speed)
