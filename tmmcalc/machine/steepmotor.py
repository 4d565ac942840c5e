"""A steep motor: the regime solved once more for what its speed differs from a reference, so that moments keep digits.

    J omega dw/dtheta = M_d + M + (c + k omega) omega - J' omega^2 / 2,   omega = reference + w

A motor of the slip s gives its moment with the relative error eps/s at a speed that is rounded to eps, and the
acceleration is what two such moments leave. The difference w is rounded to its own size, s omega, and the moment at
``reference + w`` is taken in extended precision; panels resolve w where those of the energy resolved the whole speed.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from tmmcalc.core.errors import AccuracyError
from tmmcalc.core.numerics.collocation import TOLERANCE, Orbit, solve
from tmmcalc.core.numerics.panels import Panels, Values
from tmmcalc.core.numerics.radau import radau
from tmmcalc.core.records import record
from tmmcalc.machine.onemass import OneMass, onto
from tmmcalc.machine.regimeerrors import Excess

if TYPE_CHECKING:
    from tmmcalc.core.numerics.newton import Rates

NOISE = 2 * float(np.finfo(np.longdouble).eps)  # of a moment in extended precision, over that of the whole speed


@record
class Regained:
    """The solution for w on its panels."""

    orbit: Orbit
    excess: Excess
    driving: Values  # (K, N) [N*m]
    noise: float  # of w, relative to the size of the excess


def regained(machine: OneMass, panels: Panels, omega: Values, driving: Values) -> Regained | None:
    """The regime near a solution (K, N) on ``panels``, to more digits; None if panels do not resolve it so far."""
    reference = float(np.max(omega) + np.min(omega)) / 2
    fall = float(np.max(np.abs(machine.characteristic.slope(omega))))
    moved = _Moved(machine, reference)
    size = float(np.max(np.abs(driving))) / fall
    noise = NOISE * reference / size
    typical = np.array([size, machine.typical[-1]])[: machine.states]
    guess = np.stack((omega - reference, driving))[: machine.states]
    try:
        orbit = solve(
            moved.equations,
            panels,
            guess,
            typical=typical,
            kinks=machine.kinks,
            fixed=machine.cycle.panels.edges,
            tolerance=max(TOLERANCE, machine.cycle.error),
            noise=np.array([noise * size, 0.0])[: machine.states],
        )
    except AccuracyError:
        return None
    w = orbit.y[0]
    static = orbit.y[1] if machine.lag else moved.moment(w).astype(float)
    return Regained(orbit, Excess(reference, w, max(size, float(np.max(np.abs(w))))), static, noise)


@record
class _Moved:
    """The machine by its speed above a reference."""

    machine: OneMass
    reference: float  # [rad/s]

    def moment(self, w: Values) -> Any:
        """Static moment of the motor in extended precision."""
        return self.machine.characteristic.moment(np.longdouble(self.reference) + w)

    def equations(self, panels: Panels) -> Rates:
        """The equations of w, and with lag of the moment of the motor, at the Radau points."""
        cycle, machine = onto(self.machine.cycle, panels), self.machine
        rows = (cycle.inertia + machine.constant, cycle.slope, cycle.moment, cycle.viscous, cycle.quadratic)
        inertia, slope, moment, viscous, quadratic = np.stack(rows) @ radau(panels.order).from_gauss.T
        motor, lag = machine.characteristic, machine.lag

        def rates(y: Values) -> tuple[Values, Values, Values]:
            omega, static = self.reference + y[0], self.moment(y[0])
            per = 1 / (inertia * omega)
            driving = y[1] if lag else static
            f, jacobian = np.empty_like(y), np.zeros((len(y), *y.shape))
            f[0] = (driving + moment + (viscous + (quadratic - slope / 2) * omega) * omega) * per
            jacobian[0, 0] = (viscous + (2 * quadratic - slope) * omega) * per - f[0] / omega
            if not lag:
                jacobian[0, 0] += motor.slope(omega) * per
                return f, jacobian, omega[None]
            pace = 1 / (lag * omega)
            f[1] = (static - driving) * pace
            jacobian[0, 1], jacobian[1, 1] = per, -pace
            jacobian[1, 0] = motor.slope(omega) * pace - f[1] / omega
            return f, jacobian, omega[None]

        return rates
