"""The speed of the cam over its turn: constant, or that of the machine whose crank it turns with."""

from __future__ import annotations

import numpy as np

from tmmcalc.cams.laws.law import Values
from tmmcalc.core.numerics.panels import Panels, panels
from tmmcalc.core.records import record

TURN = 2 * np.pi


@record
class Speed:
    """The speed of a shaft over its turn, at the points (K, N) of panels; the cam's rise begins at ``begin`` of it."""

    panels: Panels  # of [0, 2 pi]
    omega: Values  # (K, N) [rad/s]
    eps: Values  # (K, N) angular acceleration omega domega/dphi [rad/s^2]
    begin: float = 0.0  # [rad]

    def at(self, phi: Values) -> tuple[Values, Values]:
        """omega and eps (n,) at angles phi (n,) of the cam."""
        turned = np.asarray(phi) + self.begin
        inside = np.where(turned > TURN, turned - TURN, turned)  # the end of the turn keeps its own side
        omega, eps = self.panels.at(np.stack((self.omega, self.eps)), inside)
        return omega, eps

    @property
    def edges(self) -> Values:
        """Angles of the cam [rad] at which the speed may have a corner."""
        return np.sort(np.mod(self.panels.edges - self.begin, TURN))

    @property
    def mean(self) -> float:
        """The mean over the time of a turn [rad/s]."""
        return TURN / float(self.panels.total(1 / self.omega))

    def acceleration(self, phi: Values, motion: Values) -> Values:
        """y'' in time (n,): y'' omega^2 + y' eps, of the motion (4, n) by phi.

        >>> still = constant_speed(10.0)
        >>> still.acceleration(np.array([0.25]), np.array([[0.0], [0.01], [0.04], [0.0]])).round(9).tolist()
        [4.0]
        """
        omega, eps = self.at(phi)
        return motion[2] * omega**2 + motion[1] * eps


def constant_speed(omega: float) -> Speed:
    """The same speed all over the turn."""
    on = panels(0.0, TURN, widest=7.0)
    return Speed(on, np.full(on.x.shape, omega), np.zeros(on.x.shape))
