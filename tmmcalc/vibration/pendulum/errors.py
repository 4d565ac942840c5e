"""What rounding leaves of the frequencies of whirl: the quotient of the energies of each mode in extended precision.

By Rayleigh's principle it is in error by the square of what the mode is, and all of it is formed anew: points and
weights of the integrals, the functions, their integrals. The whirl of an unbalance is stationary in the same way.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from tmmcalc.core.numerics.extended import widened
from tmmcalc.core.numerics.panels import Values
from tmmcalc.vibration.pendulum.basis import Basis, gauss, sample
from tmmcalc.vibration.pendulum.task import PendulumTask


class _Bent(NamedTuple):
    """Shapes (k, m) at the points of the integrals: displacement, slope and curvature by a/l; their ends (k,)."""

    value: Values
    slope: Values
    curvature: Values
    hung: Values
    tip: Values
    end: Values


class Energies:
    """The energies of shapes in the functions of a basis, in extended precision."""

    def __init__(self, task: PendulumTask, basis: Basis, plane: int) -> None:
        """Sample the functions."""
        self.task, self.plane = widened(task), plane
        wide: Basis = widened(basis)
        self.points, self.weights = gauss(wide)
        self.at, self.ends = sample(wide, self.points), sample(wide, np.array([0, 1], np.longdouble))

    def shapes(self, z: Values) -> _Bent:
        """Shapes of coefficients z (n, k)."""
        value, slope, curvature = (z.T @ part for part in self.at)
        ends = z.T @ self.ends.slope
        return _Bent(value, slope, curvature, ends[:, 0], z.T @ self.ends.value[:, 1], ends[:, 1])

    def stiffness(self, one: _Bent) -> Values:
        """z'Kz (k,)."""
        task, l = self.task, self.task.rod.length
        tension = task.gravity * (task.rod.density * l * (1 - self.points) + task.disc.mass)
        bent = task.rod.bending[self.plane] / l**3 * self._over(one.curvature**2)
        pivot: Any = task.pivot or 0.0
        return np.asarray(bent + self._over(tension * one.slope**2) / l + pivot * (one.hung / l) ** 2)

    def mass(self, one: _Bent, two: _Bent) -> Values:
        """z'Mu (k,)."""
        rod, disc, l = self.task.rod, self.task.disc, self.task.rod.length
        turned = rod.density * rod.radius[self.plane] ** 2 * self._over(one.slope * two.slope) / l
        moved = rod.density * l * self._over(one.value * two.value) + disc.mass * one.tip * two.tip
        return np.asarray(moved + turned + disc.diametral[self.plane] * one.end * two.end / l**2)

    def spin(self, one: _Bent) -> Values:
        """z'Gz (k,)."""
        rod, disc, l = self.task.rod, self.task.disc, self.task.rod.length
        radii = rod.radius[0] ** 2 + rod.radius[1] ** 2
        return np.asarray(rod.density * radii * self._over(one.slope**2) / l + disc.polar * (one.end / l) ** 2)

    def _over(self, integrand: Values) -> Values:
        return np.asarray(integrand @ self.weights)


def whirl_error(energies: Energies, spin: float, mu: Values, y: Values) -> float:
    """Largest relative error of roots 1/w (k,) at a speed of spin, by their vectors (z, w z) (2n, k)."""
    n = len(y) // 2
    z, u = energies.shapes(y[:n]), energies.shapes(y[n:])
    above = 2 * energies.mass(z, u) - np.longdouble(spin) * energies.spin(z)
    return float(np.max(np.abs(above / (energies.stiffness(z) + energies.mass(u, u)) / mu - 1)))


def steady_end(energies: Energies, force: float, spin: float, z: Values) -> float:
    """Displacement of the lower end under a force there that turns with the rotor, by the shape z (n,) of that whirl.

    f_2 = 2 tip - z'(K - spin^2 (M - G))z/force is in error by the square of what the shape is.
    """
    one, square = energies.shapes(z[:, None]), np.longdouble(spin) ** 2
    held = energies.stiffness(one) - square * (energies.mass(one, one) - energies.spin(one))
    return float((2 * one.tip - held / np.longdouble(force))[0])


def critical_error(energies: Energies, sign: int, speeds: Values, y: Values) -> float:
    """Largest relative error of critical speeds (k,) by the roots 1/w^2 of K - w^2 (M + sign G) and vectors (n, k)."""
    z = energies.shapes(y)
    exact = np.sqrt(energies.stiffness(z) / (energies.mass(z, z) + sign * energies.spin(z)))
    return float(np.max(np.abs(speeds / exact - 1)))
