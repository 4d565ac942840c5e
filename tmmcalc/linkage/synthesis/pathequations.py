"""Equations of path generation: two dyads carry the coupler point through n places, its angles being unknown.

With the coupler turned by E_j = e^(i theta_j) since the first place, a pin z on a circle about C has

    Re(conj(g) E_j) = h,   g = conj(z) (P_j - C),   h = (|P_1 - C|^2 - |P_j - C|^2)/2 + Re(conj(P_1 - C) z)

and a pin on a line the same form: two dyads give cos and sin of theta_j, and the equation is that they are those of one
angle. With the crank's angles prescribed the first dyad gives E_j itself. Places are in units of their spread.
"""

from __future__ import annotations

import numpy as np

from tmmcalc.core.plane import Plane, Real, square
from tmmcalc.core.records import record


@record
class Path:
    """Places of the coupler point (n,), in units of their spread about their middle, and the crank's angles."""

    points: Plane
    timing: Real | None
    slides: bool

    @property
    def unknowns(self) -> int:
        """C1, z1, z2 and C2, or the direction of the line in its place."""
        return 7 if self.slides else 8

    @property
    def most(self) -> int:
        """Points that can be met exactly."""
        if self.timing is None:
            return self.unknowns + 1
        return 1 + self.unknowns // 2


def unpacked(path: Path, x: Real) -> tuple[Plane, Plane, Plane, Plane]:
    """C1, z1, z2 and C2 (or the unit normal of the line), each (k, 1)."""
    pairs = [x[:, [2 * i]] + 1j * x[:, [2 * i + 1]] for i in range(3)]
    last = 1j * np.exp(1j * x[:, [6]]) if path.slides else x[:, [6]] + 1j * x[:, [7]]
    return pairs[0], pairs[1], pairs[2], last


def _circle(points: Plane, centre: Plane, z: Plane) -> tuple[Plane, Real]:
    """g and h of a pin on a circle, at the places after the first, for Re(conj(g) E) = h."""
    d = points[1:] - centre
    first = points[0] - centre
    return np.conj(z) * d, (square(first) - square(d)) / 2 + (np.conj(first) * z).real


def _line(points: Plane, normal: Plane, z: Plane) -> tuple[Plane, Real]:
    """The same of a pin on a line."""
    return normal * np.conj(z), (np.conj(normal) * (points[0] + z - points[1:])).real


def _both(path: Path, x: Real) -> tuple[Plane, Real, Plane, Real]:
    c1, z1, z2, last = unpacked(path, x)
    one = _circle(path.points, c1, z1)
    two = _line(path.points, last, z2) if path.slides else _circle(path.points, last, z2)
    return (*one, *two)


def residuals(path: Path, x: Real) -> Real:
    """Residuals (k, n - 1), or (k, 2 n - 2) with prescribed timing."""
    if path.timing is not None:
        return _timed(path, x)
    g1, h1, g2, h2 = _both(path, x)
    s1, s2 = np.abs(g1) + 1e-300, np.abs(g2) + 1e-300
    u1, u2, k1, k2 = g1 / s1, g2 / s2, h1 / s1, h2 / s2
    gap = square(k1 * u2 - k2 * u1) - (np.conj(u1) * u2).imag ** 2
    return gap / _sameness(path, x)


def _sameness(path: Path, x: Real) -> Real:
    """Small where both pins are one, which would seem to answer every path; it keeps solutions away from there."""
    _, z1, z2, _ = unpacked(path, x)
    return square(z1 - z2) / (1 + square(z1) + square(z2)) + 1e-12


def _timed(path: Path, x: Real) -> Real:
    assert path.timing is not None
    c1, z1, z2, last = unpacked(path, x)
    arm = path.points[0] + z1 - c1
    q = c1 + arm * np.exp(1j * path.timing[1:]) - path.points[1:]
    first = (square(q) - square(z1)) / (2 * np.abs(z1) + 1e-6)
    turn = q / (np.abs(q) + 1e-300) * np.exp(-1j * np.angle(z1))
    _, _, g2, h2 = _both(path, x)
    radius = 1.0 if path.slides else np.abs(path.points[0] + z2 - last) + 1e-6
    second = ((np.conj(g2) * turn).real - h2) / radius
    return np.concatenate((first, second), axis=1)


def turns(path: Path, x: Real) -> Plane:
    """Unit turns E (k, n) of the coupler at all places, the first 1."""
    if path.timing is not None:
        c1, z1, _, _ = unpacked(path, x)
        q = c1 + (path.points[0] + z1 - c1) * np.exp(1j * path.timing) - path.points
        turn = q / z1
    else:
        g1, h1, g2, h2 = _both(path, x)
        later = 1j * (h2 * g1 - h1 * g2) / (np.conj(g1) * g2).imag
        turn = np.concatenate((np.ones((len(x), 1)), later), axis=1)
    return np.asarray(turn / np.abs(turn))


def starts(path: Path, count: int, rng: np.random.Generator) -> Real:
    """Random starts (count, p): pivots about the path, pins of its size."""
    n = path.unknowns
    x = rng.normal(size=(count, n))
    size = np.exp(rng.normal(0.5, 0.6, size=(count, 1)))
    x[:, :6] *= size
    if path.slides:
        x[:, 6] = rng.uniform(-np.pi, np.pi, count)
    else:
        x[:, 6:] *= size
    return x
