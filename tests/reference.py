"""An independent solver of planar mechanisms, for comparison with the package.

Every moving link has three body coordinates (x, y, theta): its own origin and the angle of its own axes.
Each joint is two scalar equations, the input is one more, and nothing is known of structural groups.
Positions come from Newton's method with continuation, derivatives from two linear solves with the same
Jacobian. Two kinds of equation are enough:

    distance   w . (P_s - P_g) = c       P = r + a, a the arm of the point turned with its link;
                                         w fixed, or turning with link g
    angle      theta_s - theta_g = c

Residuals are taken in extended precision, so that results are exact to about one unit of double precision
times the condition of the question, not of the linear solve.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmmcalc.linkage.model import FRAME, Joint, Mechanism

Array = NDArray[Any]
Placements = Mapping[int, tuple[complex, float]]  # link number -> place of its origin, angle of its axes

TWO_PI = 8 * np.arctan(np.longdouble(1))


class NoPositionError(Exception):
    """The continuation could not pass this input coordinate: no position, or a singular one."""

    def __init__(self, coordinate: float) -> None:
        self.coordinate = coordinate
        super().__init__(f"no regular position beyond the input coordinate {coordinate!r}")


@dataclass(frozen=True)
class Motion:
    """A quantity over the positions, and its two derivatives by the input coordinate, each (n,)."""

    value: Array
    first: Array
    second: Array


@dataclass(frozen=True)
class Reference:
    """Positions of a mechanism over ``coordinate`` (n,), by link and name."""

    coordinate: Array
    points: dict[tuple[int, str], Motion]  # (link, point) -> complex x + iy
    angles: dict[int, Motion]  # link -> angle of its own axes, continuous
    slides: dict[str, Motion]  # prismatic joint -> distance from guide point to slider point
    residual: float  # largest closure error over the size of the mechanism
    bodies: Array  # (n, links, 3) body coordinates, in the order of ``Mechanism.links``

    def point(self, name: str) -> Motion:
        """Motion of the named point; if several links carry it, of any of them."""
        return next(motion for (_, point), motion in reversed(self.points.items()) if point == name)

    def placements(self, position: int, mechanism: Mechanism) -> dict[int, tuple[complex, float]]:
        """Body coordinates of one position in the form that ``solve`` takes as its start."""
        rows = self.bodies[position]
        return {link.id: (complex(x, y), float(t)) for link, (x, y, t) in zip(mechanism.links, rows, strict=True)}


@dataclass(frozen=True)
class Distance:
    """``weight . (P_s - P_g) = c``; the weight turns with body g, or is fixed in the frame."""

    bodies: tuple[int, int]  # s, g
    points: tuple[complex, complex]
    weight: complex
    turns: bool
    driven: bool = False  # c is the input coordinate, else 0


@dataclass(frozen=True)
class Angle:
    """``theta_s - theta_g = offset``, by whole turns; or the driven angle of body s."""

    bodies: tuple[int, int]
    offset: float
    driven: bool = False


class Distances:
    """All equations of distance of a mechanism at once; ``rows`` are their places among all equations."""

    def __init__(self, equations: Sequence[Distance | Angle]) -> None:
        chosen = {k: eq for k, eq in enumerate(equations) if isinstance(eq, Distance)}
        self.rows = np.array([*chosen], dtype=int)
        self.s, self.g = np.array([eq.bodies for eq in chosen.values()], dtype=int).reshape(-1, 2).T
        self.p_s, self.p_g = np.array([eq.points for eq in chosen.values()], dtype=complex).reshape(-1, 2).T
        self.weight = np.array([eq.weight for eq in chosen.values()], dtype=complex)
        self.turns = np.array([eq.turns for eq in chosen.values()], dtype=bool)
        self.driven = np.array([eq.driven for eq in chosen.values()], dtype=bool)

    def geometry(self, q: Array) -> tuple[Array, Array, Array, Array]:
        """Weights in the frame, arms of both points, their difference, each (n, distances)."""
        s, g = q[:, self.s], q[:, self.g]
        with_g = turn(g[..., 2])
        a_s, a_g = self.p_s * turn(s[..., 2]), self.p_g * with_g
        weight = self.weight * np.where(self.turns, with_g, 1)
        delta = s[..., 0] - g[..., 0] + 1j * (s[..., 1] - g[..., 1]) + a_s - a_g
        return weight, a_s, a_g, delta

    def residual(self, q: Array, coordinate: Array) -> Array:
        weight, _, _, delta = self.geometry(q)
        return dot(weight, delta) - np.where(self.driven, coordinate[:, None], 0)

    def derivatives(self, q: Array) -> tuple[Array, Array]:
        """Derivatives by the coordinates of body s and of body g, each (n, distances, 3)."""
        weight, a_s, a_g, delta = self.geometry(q)
        by_s = np.stack([weight.real, weight.imag, dot(weight, 1j * a_s)], axis=-1)
        by_g = np.stack([weight.real, weight.imag, dot(weight, 1j * a_g)], axis=-1)
        by_g[..., 2] -= np.where(self.turns, dot(1j * weight, delta), 0)
        return by_s, -by_g

    def second_order(self, q: Array, v: Array) -> Array:
        """Right side of the acceleration equation: the velocity terms, moved over."""
        weight, a_s, a_g, delta = self.geometry(q)
        v_s, v_g = v[:, self.s], v[:, self.g]
        w_s, w_g = v_s[..., 2], v_g[..., 2]
        rate = v_s[..., 0] - v_g[..., 0] + 1j * (v_s[..., 1] - v_g[..., 1]) + 1j * (w_s * a_s - w_g * a_g)
        turning = w_g**2 * dot(weight, delta) - 2 * w_g * dot(1j * weight, rate)
        return dot(weight, w_s**2 * a_s - w_g**2 * a_g) + np.where(self.turns, turning, 0)


class Angles:
    """All equations of angles of a mechanism at once; ``rows`` are their places among all equations."""

    def __init__(self, equations: Sequence[Distance | Angle]) -> None:
        chosen = {k: eq for k, eq in enumerate(equations) if isinstance(eq, Angle)}
        self.rows = np.array([*chosen], dtype=int)
        self.s, self.g = np.array([eq.bodies for eq in chosen.values()], dtype=int).reshape(-1, 2).T
        self.offset = np.array([eq.offset for eq in chosen.values()])
        self.driven = np.array([eq.driven for eq in chosen.values()], dtype=bool)

    def residual(self, q: Array, coordinate: Array) -> Array:
        open_ = q[:, self.s, 2] - q[:, self.g, 2] - self.offset
        whole = TWO_PI.astype(q.dtype)
        closed = open_ - whole * np.round(open_ / whole)
        left: Array = np.where(self.driven, q[:, self.s, 2] - coordinate[:, None], closed)
        return left


def turn(angle: Array) -> Array:
    return np.cos(angle) + 1j * np.sin(angle)


def dot(a: Array, b: Array) -> Array:
    """Scalar product of plane vectors."""
    product: Array = a.real * b.real + a.imag * b.imag
    return product


class System:
    """The equations of a mechanism; body coordinates are (n, links + 1, 3), the frame is the last row."""

    def __init__(self, mechanism: Mechanism) -> None:
        self.mechanism = mechanism
        self.index = {link.id: k for k, link in enumerate(mechanism.links)} | {FRAME: len(mechanism.links)}
        self.size = max(
            [abs(p) for link in mechanism.links for p in link.points.values()]
            + [abs(p) for joint in mechanism.joints for p in joint.points]
        )
        self.equations = [eq for joint in mechanism.joints for eq in self._joint(joint)] + [self._driver()]
        if len(self.equations) != 3 * len(mechanism.links):
            raise ValueError(f"{len(self.equations)} equations for {len(mechanism.links)} moving links")
        self.distances, self.angles = Distances(self.equations), Angles(self.equations)
        lengths = [self.size if isinstance(eq, Distance) else 1.0 for eq in self.equations]
        self.row_scale = np.array(lengths)
        self.body_scale = np.array([self.size, self.size, 1.0])

    def _joint(self, joint: Joint) -> list[Distance | Angle]:
        bodies = (self.index[joint.links[0]], self.index[joint.links[1]])
        if joint.kind == "revolute":
            return [Distance(bodies, joint.points, weight, turns=False) for weight in (1 + 0j, 1j)]
        along_s, along_g = joint.directions
        offset = float(np.angle(along_g) - np.angle(along_s))
        return [Distance(bodies, joint.points, 1j * along_g, turns=True), Angle(bodies, offset)]

    def _driver(self) -> Distance | Angle:
        joint = self.mechanism.joint(self.mechanism.input.joint)
        if joint.kind == "prismatic":
            bodies = (self.index[joint.links[0]], self.index[joint.links[1]])
            return Distance(bodies, joint.points, joint.directions[1], turns=True, driven=True)
        moving = next(number for number in joint.links if number != FRAME)
        return Angle((self.index[moving], self.index[FRAME]), 0.0, driven=True)

    def residual(self, q: Array, coordinate: Array) -> Array:
        """Closure errors (n, 3 links)."""
        left = np.empty((len(q), len(self.equations)), dtype=q.dtype)
        for kind in (self.distances, self.angles):
            left[:, kind.rows] = kind.residual(q, coordinate)
        return left

    def jacobian(self, q: Array) -> Array:
        """Derivatives of the closure errors (n, 3 links, 3 links)."""
        matrix = np.zeros((len(q), len(self.equations), *q.shape[1:]), dtype=q.dtype)
        far, near = self.distances, self.angles
        matrix[:, far.rows, far.s], matrix[:, far.rows, far.g] = far.derivatives(q)
        matrix[:, near.rows, near.s, 2], matrix[:, near.rows, near.g, 2] = 1, -1
        return matrix[:, :, :-1].reshape(*matrix.shape[:2], -1)

    def second_order(self, q: Array, v: Array) -> Array:
        """Right sides of the acceleration equations (n, 3 links)."""
        right = np.zeros((len(q), len(self.equations)), dtype=q.dtype)
        right[:, self.distances.rows] = self.distances.second_order(q, v)
        return right

    def scaled(self, matrix: Array) -> Array:
        """The Jacobian in lengths of one mechanism size: comparable rows and columns."""
        columns = np.tile(self.body_scale, len(self.mechanism.links))
        alike: Array = matrix.astype(float) * columns / self.row_scale[:, None]
        return alike

    def step(self, matrix: Array, right: Array) -> Array:
        """Solve ``matrix @ x = right`` in double precision; x as body coordinates, frame included."""
        x = np.linalg.solve(self.scaled(matrix), (right / self.row_scale).astype(float)[..., None])[..., 0]
        bodies = x.reshape(len(x), -1, 3) * self.body_scale
        return np.concatenate([bodies, np.zeros((len(x), 1, 3))], axis=1)

    def refined(self, matrix: Array, right: Array) -> Array:
        """Solve ``matrix @ x = right`` with the residual in the precision of the matrix."""
        x = self.step(matrix, right).astype(matrix.dtype)
        for _ in range(3 if matrix.dtype == np.longdouble else 0):
            flat = x[:, :-1].reshape(len(x), -1)
            x = x + self.step(matrix, right - np.einsum("nij,nj->ni", matrix, flat))
        return x

    def rates(self, q: Array) -> tuple[Array, Array]:
        """First and second derivatives of the body coordinates by the input coordinate."""
        matrix = self.jacobian(q)
        right = np.zeros(matrix.shape[:2], dtype=q.dtype)
        right[:, -1] = 1
        v = self.refined(matrix, right)
        return v, self.refined(matrix, self.second_order(q, v))

    def polished(self, q: Array, coordinate: Array) -> Array:
        """Newton's method in extended precision until the correction stagnates."""
        q, last = q.astype(np.longdouble), np.inf
        for _ in range(20):
            correction = self.step(self.jacobian(q), self.residual(q, coordinate.astype(np.longdouble)))
            q, size = q - correction, float(np.max(np.abs(correction / self.body_scale)))
            if size < 1e-18 or (size < 1e-12 and size > 0.5 * last):
                return q
            last = size
        raise NoPositionError(float(coordinate[0]))


def solve(mechanism: Mechanism, start: Placements, coordinate: Array, *, max_step: float | None = None) -> Reference:
    """Follow the mechanism along ``coordinate`` (n,) from its placement at ``coordinate[0]``.

    ``start`` gives every moving link roughly; Newton's method makes it exact. ``max_step`` bounds the
    continuation steps: by default three degrees, or 1/50 of the mechanism size for a prismatic input.
    Raises NoPositionError where the links do not reach or the Jacobian becomes singular.
    """
    system, coordinate = System(mechanism), np.asarray(coordinate, dtype=float)
    if max_step is None:
        max_step = np.radians(3.0) if isinstance(system.equations[-1], Angle) else system.size / 50
    q = follow(system, bodies_of(system, start, coordinate[0]), coordinate, max_step)
    q = system.polished(q, coordinate)
    v, a = system.rates(q)
    error = np.abs(system.residual(q, coordinate.astype(np.longdouble))) / system.row_scale
    return Reference(
        coordinate,
        points={
            (link.id, name): point_motion(q, v, a, system.index[link.id], p)
            for link in (mechanism.frame, *mechanism.links)
            for name, p in link.points.items()
        },
        angles={link.id: double(*(x[:, k, 2] for x in (q, v, a))) for k, link in enumerate(mechanism.links)},
        slides={
            joint.name: slide_motion(system, q, v, a, joint) for joint in mechanism.joints if joint.kind == "prismatic"
        },
        residual=float(np.max(error)),
        bodies=q[:, :-1].astype(float),
    )


def bodies_of(system: System, start: Placements, coordinate: float) -> Array:
    """Body coordinates (1, links + 1, 3) of given placements; a driven angle is set to the coordinate."""
    q = np.zeros((1, len(system.index), 3))
    for link in system.mechanism.links:
        place, angle = start[link.id]
        q[0, system.index[link.id]] = place.real, place.imag, angle
    driver = system.equations[-1]
    if isinstance(driver, Angle):
        q[0, driver.bodies[0], 2] = coordinate
    return q


def follow(system: System, q: Array, coordinate: Array, max_step: float) -> Array:
    """Positions (n, links + 1, 3) along the coordinates: predictor of second order, Newton as corrector."""
    q = newton(system, q, coordinate[0], iterations=50)
    at, found, sense = float(coordinate[0]), [q], determinant_sign(system, q)
    for target in coordinate[1:]:
        while at != target:
            at, q = advance(system, at, q, float(target), max_step, sense)
        found.append(q)
    return np.concatenate(found)


def advance(system: System, at: float, q: Array, target: float, max_step: float, sense: float) -> tuple[float, Array]:
    """One accepted step towards the target: short enough that the branch, with its sense, cannot be left unseen."""
    v, a = system.rates(q)
    step = float(np.clip(target - at, -max_step, max_step))
    while True:
        nearer = target if step == target - at else at + step
        guess = q + v * step + a * step**2 / 2
        try:
            found = newton(system, guess, nearer, iterations=6)
        except NoPositionError:
            found = np.full_like(guess, np.inf)
        near = np.max(np.abs(found - guess) / system.body_scale) < 0.01
        if near and determinant_sign(system, found) == sense:
            return nearer, found
        step /= 2
        if abs(step) < 1e-8 * max_step:
            raise NoPositionError(at)


def newton(system: System, q: Array, coordinate: float, iterations: int) -> Array:
    """Newton's method in double precision from one configuration (1, links + 1, 3)."""
    for _ in range(iterations):
        try:
            correction = system.step(system.jacobian(q), system.residual(q, np.array([coordinate])))
        except np.linalg.LinAlgError:
            raise NoPositionError(coordinate) from None
        q = q - correction
        if np.max(np.abs(correction / system.body_scale)) < 1e-11:
            return q
    raise NoPositionError(coordinate)


def determinant_sign(system: System, q: Array) -> float:
    if not np.all(np.isfinite(q)):
        return 0.0
    return float(np.linalg.slogdet(system.scaled(system.jacobian(q)))[0][0])


def double(value: Array, first: Array, second: Array) -> Motion:
    """Motion in double precision, real or complex."""
    kind = complex if np.iscomplexobj(value) else float
    return Motion(value.astype(kind), first.astype(kind), second.astype(kind))


def point_motion(q: Array, v: Array, a: Array, body: int, p: complex) -> Motion:
    """Place of a point fixed on a body, and its derivatives."""
    return double(*point_state(q, v, a, body, p))


def point_state(q: Array, v: Array, a: Array, body: int, p: complex) -> tuple[Array, Array, Array]:
    """Place, velocity and acceleration of a point fixed on a body, in extended precision."""
    arm, spin = p * turn(q[:, body, 2]), v[:, body, 2]
    origin = [x[:, body, 0] + 1j * x[:, body, 1] for x in (q, v, a)]
    return (
        origin[0] + arm,
        origin[1] + 1j * spin * arm,
        origin[2] + (1j * a[:, body, 2] - spin**2) * arm,
    )


def slide_motion(system: System, q: Array, v: Array, a: Array, joint: Joint) -> Motion:
    """Distance from the guide's point to the slider's point along the guide: Re(conj(u) (P_s - P_g))."""
    s, g = (system.index[number] for number in joint.links)
    slider, guide = (point_state(q, v, a, body, p) for body, p in zip((s, g), joint.points, strict=True))
    d0, d1, d2 = (x - y for x, y in zip(slider, guide, strict=True))
    spin, spin_rate = v[:, g, 2], a[:, g, 2]
    back = np.conj(joint.directions[1] * turn(q[:, g, 2]))
    back1, back2 = -1j * spin * back, (-1j * spin_rate - spin**2) * back
    return double(
        (back * d0).real,
        (back * d1 + back1 * d0).real,
        (back * d2 + 2 * back1 * d1 + back2 * d0).real,
    )
