"""Wittenbauer's picture (textbook Fig. 3.17): the closed energy-mass curve with its two outer tangents."""

from __future__ import annotations

import math

import numpy as np

from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.quantity import derived, quantity
from tmmcalc.core.records import record
from tmmcalc.machine.cycle import Cycle
from tmmcalc.machine.flywheel.curve import energy_curve
from tmmcalc.machine.flywheel.methods import METHODS, check, tangents


@record
class EnergyMass:
    """The energy-mass curve and the exact tangents.

    Both tangents meet in the origin of the total inertia and the total energy, the point (-inertia, -energy)
    of the picture.
    """

    theta: Values  # [rad], (m,), from 0 to the period, the touching points among them
    links: Values  # J of the links, abscissa [kg*m^2], (m,)
    work: Values  # A, change of kinetic energy, ordinate [J], (m,)
    slopes: tuple[float, float]  # k_max, k_min: half the square of the extreme speeds [rad^2/s^2]
    intercepts: tuple[float, float]  # b_max, b_min on the axis of energies [J]; their distance is the segment GH
    touching: tuple[float, float]  # angles where the tangents touch [rad]
    inertia: float = quantity("J_F_exact[kg*m^2]", "total constant inertia by the exact tangents", symbol="J_F")
    energy: float = quantity("T_0[J]", "kinetic energy of the whole machine at theta = 0")
    drive: float = quantity("M_d_mean[N*m]", "constant driving moment that closes the cycle")

    @derived("slope_max[rad^2/s^2]", "slope of the tangent of the largest speed", symbol="k_max")
    def slope_max(self) -> float:
        """Half the square of that speed."""
        return self.slopes[0]

    @derived("slope_min[rad^2/s^2]", "slope of the tangent of the least speed", symbol="k_min")
    def slope_min(self) -> float:
        """Half the square of that speed."""
        return self.slopes[1]

    @derived("G[J]", "intercept of the tangent of the largest speed on the axis of energies")
    def upper(self) -> float:
        """b_max."""
        return self.intercepts[0]

    @derived("H[J]", "intercept of the tangent of the least speed on the axis of energies")
    def lower(self) -> float:
        """b_min."""
        return self.intercepts[1]

    @property
    def speed(self) -> float:
        """Mean of the extreme speeds [rad/s]."""
        return (math.sqrt(2 * self.slopes[0]) + math.sqrt(2 * self.slopes[1])) / 2

    def angles(self, scale: float) -> tuple[float, float]:
        """Angles [rad] of the tangents in a drawing, ``scale`` = mu_J/mu_T [kg*m^2/mm over J/mm] (3.50)."""
        return math.atan(self.slopes[0] * scale), math.atan(self.slopes[1] * scale)


def energy_mass(
    cycle: Cycle, delta: float, speed: float | None = None, moment: float | Values | None = None
) -> EnergyMass:
    """The picture for the coefficient ``delta``; arguments as in `positional_flywheels`."""
    w = cycle.speed if speed is None else speed
    check(delta, w, 0.0)
    curve = energy_curve(cycle, w, moment)
    exact = tangents(curve, delta, w, METHODS[:1])
    on = cycle.panels
    k_max, k_min = float(exact.slope_max[0]), float(exact.slope_min[0])
    b_max, b_min = float(exact.intercept_max[0]), float(exact.intercept_min[0])
    inertia = float(exact.inertia[0])
    touching = float(exact.fastest.theta[0]), float(exact.slowest.theta[0])
    every = np.append(np.column_stack((on.edges[:-1], on.x)).ravel(), on.edges[-1])
    theta = np.sort(np.append(every, [at for at in touching if at not in every]))
    work, links = on.at(np.stack((curve.work, curve.inertia)), theta)
    return EnergyMass(
        theta,
        links,
        work,
        (k_max, k_min),
        (b_max, b_min),
        touching,
        inertia,
        k_max * inertia - b_max,
        curve.drive,
    )
