"""Points of a moving body whose places at n poses lie on a circle (Burmester) or on a line.

A pose j moves the body point z (in axes that stand at the first pose) to Z_j = P_j + E_j z, E_j = e^(i (theta_j -
theta_1)). The places lie on the circle about C where 2 C . (Z_j - Z_1) = |Z_j|^2 - |Z_1|^2: with z also linear, for |z|
cancels, so that [a_j, b_j, d_j] (C_x, C_y, -1) = 0 with entries linear in z. Three poses leave z free, four a curve
(every row of minors a cubic), five at most four real points: the solutions of a two-parameter eigenvalue problem.
"""

from __future__ import annotations

import numpy as np

from tmmcalc.core.plane import Plane, Real, cross, square
from tmmcalc.core.records import record

MIXTURE = 7  # seed of the projective change of axes in which no solution is at infinity
POLISH = 8  # steps of Newton's method
RANK = 1e-9  # a least singular value below this, of rows of unit size, is a solution
APART = 1e-7  # solutions nearer to each other than this part of their size are one


@record
class Poses:
    """Places of a body's reference point (n,) and its angles from the first pose (n,) [rad]."""

    points: Plane
    angles: Real

    def places(self, z: Plane) -> Plane:
        """Places (k, n) of body points z (k,), given in axes along the first pose."""
        return np.asarray(self.points + np.exp(1j * self.angles) * np.asarray(z)[:, None])


def rows(poses: Poses, z: Plane) -> Real:
    """The system (k, n - 1, 3) whose null vector is (C_x, C_y, -1), rows in units of the poses' size."""
    places = poses.places(z)
    step = 2 * (places[:, 1:] - places[:, :1])
    return np.stack((step.real, step.imag, square(places[:, 1:]) - square(places[:, :1])), axis=-1)


def centres(poses: Poses, z: Plane) -> Plane:
    """Centres (k,) of the circles that fit the places of z (k,) in the least squares of the rows."""
    system = rows(poses, z)
    solved = np.linalg.pinv(system[..., :2]) @ system[..., 2:]
    return np.asarray(solved[:, 0, 0] + 1j * solved[:, 1, 0])


def circle_points(poses: Poses) -> tuple[Plane, Plane]:
    """Body points z (k,) of five poses whose places lie on circles, and their centres (k,); k is 0 to 4.

    Source: the rectangular eigenvalue problem M0 + x M1 + y M2 of 4 rows and 3 columns, made square by mixtures of its
    rows, through operator determinants.
    """
    unit, middle = _scale(poses)
    scaled = Poses((poses.points - middle) / unit, poses.angles)
    base, along_x, along_y = _linear(scaled)
    candidates = _eigenpoints(base, along_x, along_y)
    z = _polished(scaled, candidates)
    good = _defect(scaled, z) < RANK
    z = _distinct(z[good])
    found = centres(scaled, z) if len(z) else np.zeros(0, complex)
    return z * unit, found * unit + middle


def _scale(poses: Poses) -> tuple[float, complex]:
    middle = complex(poses.points.mean())
    return float(np.max(np.abs(poses.points - middle))) or 1.0, middle


def _linear(poses: Poses) -> tuple[Real, Real, Real]:
    """M0, M1, M2 (n - 1, 3) of the system at z = x + i y."""
    base, one, other = rows(poses, np.array([0j, 1 + 0j, 1j]))
    return base, one - base, other - base


def _eigenpoints(base: Real, along_x: Real, along_y: Real) -> Plane:
    """Candidates z (9,) for four rows; infinite ones come out as numbers that no pose confirms."""
    rng = np.random.default_rng(MIXTURE)
    mix = rng.normal(size=(3, 3))  # projective axes (x, y, 1) = mix (s, t, 1)
    parts = [mix[0, k] * along_x + mix[1, k] * along_y + mix[2, k] * base for k in range(3)]
    left = rng.normal(size=(2, 3, 4))
    one, two = ([side @ part for part in parts] for side in left)
    zero = np.kron(one[0], two[1]) - np.kron(one[1], two[0])
    first = np.kron(one[1], two[2]) - np.kron(one[2], two[1])
    second = np.kron(one[2], two[0]) - np.kron(one[0], two[2])
    values, vectors = np.linalg.eig(np.linalg.solve(zero, first))
    images = np.linalg.solve(zero, second) @ vectors
    largest = np.argmax(np.abs(vectors), axis=0)
    t = images[largest, np.arange(9)] / vectors[largest, np.arange(9)]
    x, y, w = mix @ np.array([values, t, np.ones(9)])
    real = np.abs(w) > 1e-12
    x, y = x[real] / w[real], y[real] / w[real]
    near = (np.abs(x.imag) < 1e-3 * (1 + np.abs(x))) & (np.abs(y.imag) < 1e-3 * (1 + np.abs(y)))
    return np.asarray(x.real[near] + 1j * y.real[near])


def _system(poses: Poses, z: Plane, c: Plane) -> Real:
    places = poses.places(z) - c[:, None]
    return np.asarray(square(places[:, 1:]) - square(places[:, :1]))


def _polished(poses: Poses, z: Plane) -> Plane:
    """Newton's method on body point and centre together."""
    c = centres(poses, z) if len(z) else z
    turn = np.exp(1j * poses.angles)
    for _ in range(POLISH):
        gap = poses.places(z) - c[:, None]
        by_z = 2 * (np.conj(gap) * turn)
        slopes = np.stack(
            (
                (by_z[:, 1:] - by_z[:, :1]).real,
                -(by_z[:, 1:] - by_z[:, :1]).imag,
                -2 * (gap[:, 1:] - gap[:, :1]).real,
                -2 * (gap[:, 1:] - gap[:, :1]).imag,
            ),
            axis=-1,
        )
        step = (np.linalg.pinv(slopes) @ _system(poses, z, c)[..., None])[..., 0]
        z, c = z - (step[:, 0] + 1j * step[:, 1]), c - (step[:, 2] + 1j * step[:, 3])
    return z


def _defect(poses: Poses, z: Plane) -> Real:
    """Least singular value (k,) of the system, rows of unit size."""
    if not len(z):
        return np.zeros(0)
    system = rows(poses, z)
    system = system / np.maximum(np.linalg.norm(system, axis=2, keepdims=True), 1e-300)
    return np.asarray(np.linalg.svd(system, compute_uv=False)[:, -1])


def _distinct(z: Plane) -> Plane:
    kept: list[complex] = []
    for each in z.tolist():
        if all(abs(each - other) > APART * (1 + abs(each)) for other in kept):
            kept.append(each)
    return np.array(sorted(kept, key=lambda each: (round(each.real, 9), each.imag)), complex)


def curve_points(poses: Poses, reach: float, count: int) -> Plane:
    """Points (k,) of the circle-point curve of four poses, cut by ``count`` lines of every direction within reach."""
    unit, middle = _scale(poses)
    scaled = Poses((poses.points - middle) / unit, poses.angles)
    angles = np.pi * (np.arange(count) + 0.5) / count
    far = reach / unit
    found: list[Plane] = []
    for shift in np.linspace(-0.6, 0.6, 7) * far:
        along = np.exp(1j * angles)
        origin = 1j * along * shift
        found.append(_cubic(scaled, origin, along, far))
    z = np.concatenate(found)
    return np.asarray(z * unit)


def _cubic(poses: Poses, origin: Plane, along: Plane, far: float) -> Plane:
    """Zeros of the determinant (a cubic) on lines (k,), within ``far`` of their origins."""
    nodes = np.array([-1.0, -1 / 3, 1 / 3, 1.0])
    z = origin[:, None] + along[:, None] * nodes
    values = np.linalg.det(rows(poses, z.ravel())).reshape(z.shape)
    coefficients = values @ np.linalg.inv(np.vander(nodes)).T
    found = []
    for start, direction, cubic in zip(origin, along, coefficients, strict=True):
        size = np.max(np.abs(cubic))
        if size:
            roots = np.roots(np.where(np.abs(cubic) < 1e-13 * size, 0.0, cubic))
            real = roots.real[(np.abs(roots.imag) < 1e-9) & (np.abs(roots.real) < far)]
            found.append(start + direction * real)
    z = np.concatenate(found) if found else np.zeros(0, complex)
    return _polished(poses, z) if len(z) else z


def line_points(poses: Poses, count: int) -> Plane:
    """Body points (k,) whose places lie on one line: those of three poses on a circle, of four one at most.

    Of three poses ``count`` points of the circle are taken. For j > 2 the area of Z_1 Z_2 Z_j is
    k + g . z + h |z|^2, zero on a circle; all circles pass through the pole of the poses 1 and 2, which is left out.
    """
    steps = poses.points[1:] - poses.points[0]
    turns = np.exp(1j * poses.angles[1:]) - np.exp(1j * poses.angles[0])
    u, s, v, t = steps[0], turns[0], steps[1:], turns[1:]
    k, h = cross(u + 0 * v, v), cross(s + 0 * t, t)
    none = np.zeros(0, complex)
    g = np.conj(1j * (np.conj(v) * s - np.conj(u) * t))  # the linear part is Re(conj(g) z)
    if len(v) == 1:
        return _circle(float(k[0]), complex(g[0]), float(h[0]), count)
    if len(v) > 2 or abs(s) < 1e-12:
        return none
    pole = -u / s
    # the chord of the two circles passes through the pole; the other end of it is the point
    chord = h[1] * g[0] - h[0] * g[1]
    if abs(chord) < 1e-300:
        return none
    way = 1j * chord / abs(chord)
    q = 0 if abs(h[0]) >= abs(h[1]) else 1
    if h[q] == 0:
        return none
    slope = float((np.conj(g[q]) * way).real + 2 * h[q] * (np.conj(pole) * way).real)
    return np.array([pole - way * slope / h[q]])


def _circle(k: float, g: complex, h: float, count: int) -> Plane:
    """Points of k + g . z + h |z|^2 = 0."""
    if abs(h) < 1e-12 * abs(g):
        if g == 0:
            return np.zeros(0, complex)
        foot = -k * g / abs(g) ** 2
        return np.asarray(foot + 1j * g / abs(g) * np.linspace(-3, 3, count) * max(abs(foot), 1e-3))
    centre = -g / (2 * h)
    square_ = abs(centre) ** 2 - k / h
    if square_ <= 0:
        return np.zeros(0, complex)
    return np.asarray(centre + np.sqrt(square_) * np.exp(2j * np.pi * (np.arange(count) + 0.5) / count))
