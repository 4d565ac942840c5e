"""Paths of points of the part: displacement of a point r is (x, y, z) + (tilt_x, tilt_y, phi) x r.

In steady motion every point describes an ellipse in space: the real part of D e^(i psi), with semi-axes
sqrt((|D|^2 +- |D . D|)/2).
"""

from __future__ import annotations

import numpy as np

from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.quantity import quantity
from tmmcalc.core.records import record
from tmmcalc.vibration.vibrator.energies import gripper_jacobian
from tmmcalc.vibration.vibrator.forced import Steady

Named = tuple[tuple[str, tuple[float, float, float]], ...]
STEPS = 120  # of a turn
FLAT = 1e-14  # of the larger semi-axis: less is a straight line


@record
class PointPath:
    """The ellipse that a point of the part describes about its place at rest."""

    name: str
    at: Values  # (3,) place at rest [m]
    amplitude: Values = quantity("amplitude[m]", "amplitudes along x, y, z")  # (3,)
    major: float = quantity("major[m]", "larger semi-axis")
    minor: float = quantity("minor[m]", "smaller semi-axis")
    direction: Values = quantity("direction", "unit vector of the larger semi-axis")  # (3,)
    normal: Values = quantity("normal", "unit normal of the plane; zero if the path is straight")  # (3,)
    path: Values  # (STEPS + 1, 3) displacement over a turn of psi [m]


def point_paths(points: Named, steady: Steady) -> tuple[PointPath, ...]:
    """The ellipses of the points in the steady motion."""
    at = np.array([place for _, place in points]).reshape(-1, 3)
    jacobian = gripper_jacobian(at)
    psi = np.linspace(0.0, 2 * np.pi, STEPS + 1)
    return tuple(
        _path(name, where, over @ steady.cosine, over @ steady.sine, psi)
        for (name, _), where, over in zip(points, at, jacobian, strict=True)
    )


def _path(name: str, at: Values, cosine: Values, sine: Values, psi: Values) -> PointPath:
    whole = cosine - 1j * sine
    square = complex(whole @ whole)
    size = float(np.vdot(whole, whole).real)
    major = float(np.sqrt((size + abs(square)) / 2))
    normal = np.cross(cosine, sine)
    area = float(np.linalg.norm(normal))
    minor = area / major if major else 0.0
    along = (whole * np.exp(-0.5j * np.angle(square))).real
    flat = minor <= FLAT * major
    return PointPath(
        name=name,
        at=at,
        amplitude=np.abs(whole),
        major=major,
        minor=0.0 if flat else minor,
        direction=along / major if major else np.zeros(3),
        normal=np.zeros(3) if flat else normal / area,
        path=np.cos(psi)[:, None] * cosine + np.sin(psi)[:, None] * sine,
    )


def displacements(points: Named, q: Values) -> Values:
    """Displacements (k, 3, n) of the points over the coordinates q (7, n) [m]."""
    at = np.array([place for _, place in points]).reshape(-1, 3)
    found: Values = gripper_jacobian(at) @ q
    return found
