"""Inverse and direct problem of the arms: gripper to joints and back, with both derivatives (textbook 2.10.3).

    base            ψ about the vertical axis; r = |x + iy|, ψ = arg(x + iy), in an arm without base r = x
    spherical       l_3 e^(iφ_2) = r + i z                                            (2.100) to (2.103)
    cylindrical     r, h = z
    angular         l_a e^(iφ_2) + l_b e^(iφ_3) = r + i z, φ_3 from the elbow to the gripper

Points of the vertical plane are complex, r + iz from the shoulder. States have the shape (3, ..., n): value, first and
second derivative. Angles are principal values.
"""

from __future__ import annotations

import math

import numpy as np

from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.plane import Plane
from tmmcalc.manipulators.task import Arm

TURN = 2 * math.pi


def inverse(arm: Arm, p: Values) -> Values:
    """Joint coordinates (3, J, n) of gripper states p (3, D, n); NaN where the gripper is out of reach or singular."""
    with np.errstate(divide="ignore", invalid="ignore"):
        w = meridian(arm, p)
        rows = _IN_PLANE[arm.kind](arm, w)
        if not arm.spatial:
            return rows
        base = polar(p[:, 0] + 1j * p[:, 1])[:, 1:]
        return np.concatenate((base, rows), axis=1)


def direct(arm: Arm, q: Values) -> Values:
    """Gripper states (3, D, n) of joint coordinates q (3, J, n)."""
    rows = q[:, 1:] if arm.spatial else q
    w = _TO_PLANE[arm.kind](arm, rows)
    height = w.imag + np.array([arm.height, 0.0, 0.0])[:, None]
    if not arm.spatial:
        return np.stack((w.real, height), axis=1)
    flat = from_polar(w.real, q[:, 0])
    return np.stack((flat.real, flat.imag, height), axis=1)


def meridian(arm: Arm, p: Values) -> Plane:
    """States (3, n) of the gripper in the vertical plane of the arm, r + iz from the shoulder."""
    height = p[:, -1] - np.array([arm.height, 0.0, 0.0])[:, None]
    if not arm.spatial:
        return np.asarray(p[:, 0] + 1j * height)
    return np.asarray(polar(p[:, 0] + 1j * p[:, 1])[:, 0] + 1j * height)


def polar(w: Plane) -> Values:
    """Distance and angle with their derivatives, (3, 2, n), of plane states w (3, n) ((2.100) to (2.103))."""
    length = np.abs(w[0])
    e = np.conj(w[0]) / length
    v, a = w[1] * e, w[2] * e
    omega = v.imag / length
    eps = (a.imag - 2 * v.real * omega) / length
    return np.array(((length, np.angle(w[0])), (v.real, omega), (a.real + length * omega**2, eps)))


def from_polar(length: Values, angle: Values) -> Plane:
    """Plane states (3, n) of distances (3, n) and angles (3, n): `polar` read the other way."""
    e = np.exp(1j * angle[0])
    v = length[1] + 1j * length[0] * angle[1]
    a = length[2] - length[0] * angle[1] ** 2 + 1j * (length[0] * angle[2] + 2 * length[1] * angle[1])
    return np.stack((length[0] * e, v * e, a * e))


def elbow_angle(q: Values, start: Values) -> Values:
    """States (3, n) of the angle from the upper arm to the forearm at joint states q (3, J, n).

    It is within half a turn of zero at the joint coordinates ``start`` (J,), and continuous from there.
    """
    rows = q[:, -1] - q[:, -2]
    rows[0] -= TURN * np.rint((start[-1] - start[-2]) / TURN)
    return np.asarray(rows)


def elbow_point(arm: Arm, q: Values) -> Values:
    """Places (D, n) of the elbow of an angular arm at joint coordinates q (3, J, n)."""
    rows = q[0, 1:] if arm.spatial else q[0]
    w = arm.upper * np.exp(1j * rows[0])
    if not arm.spatial:
        return np.stack((w.real, w.imag + arm.height))
    return np.stack((w.real * np.cos(q[0, 0]), w.real * np.sin(q[0, 0]), w.imag + arm.height))


def _spherical(arm: Arm, w: Plane) -> Values:
    return polar(w)[:, ::-1]


def _cylindrical(arm: Arm, w: Plane) -> Values:
    return np.stack((w.imag, w.real), axis=1)


def _angular(arm: Arm, w: Plane) -> Values:
    """The dyad between shoulder and gripper; both rates from the components along the other arm."""
    a, b = arm.upper, arm.forearm
    square = w[0].real ** 2 + w[0].imag ** 2
    area = arm.elbow * np.sqrt(elbow_margin(arm, w[0]))  # 2 l_a l_b |sin|, with the side of the elbow
    e2 = w[0] * (square + a * a - b * b + 1j * area)
    e2 = e2 / np.abs(e2)
    turn = square - a * a - b * b - 1j * area
    turn = turn / np.abs(turn)
    e3 = e2 * turn
    sine = turn.imag

    def rates(v: Plane) -> tuple[Values, Values]:
        return (v * np.conj(e3)).real / (a * sine), -(v * np.conj(e2)).real / (b * sine)

    omega2, omega3 = rates(w[1])
    eps2, eps3 = rates(w[2] + a * omega2**2 * e2 + b * omega3**2 * e3)
    return np.array(((np.angle(e2), np.angle(e3)), (omega2, omega3), (eps2, eps3)))


def elbow_margin(arm: Arm, w: Plane) -> Values:
    """(2 l_a l_b sin)^2 of the angle between the arms at places w (n,) [m^4]; negative out of reach."""
    square = w.real**2 + w.imag**2
    return np.asarray(((arm.upper + arm.forearm) ** 2 - square) * (square - (arm.upper - arm.forearm) ** 2))


def _from_spherical(arm: Arm, q: Values) -> Plane:
    return from_polar(q[:, 1], q[:, 0])


def _from_cylindrical(arm: Arm, q: Values) -> Plane:
    return np.asarray(q[:, 1] + 1j * q[:, 0])


def _from_angular(arm: Arm, q: Values) -> Plane:
    still = np.zeros_like(q[0, 0])
    arms = (np.stack((still + length, still, still)) for length in (arm.upper, arm.forearm))
    return sum((from_polar(length, q[:, k]) for k, length in enumerate(arms)), start=np.zeros((3, 1), complex))


_IN_PLANE = {"spherical": _spherical, "cylindrical": _cylindrical, "angular": _angular}
_TO_PLANE = {"spherical": _from_spherical, "cylindrical": _from_cylindrical, "angular": _from_angular}
