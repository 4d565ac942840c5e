"""The machine with its motor as one rotating mass: equations of motion over the angle of the input shaft.

    dE/dtheta = M_d + M(theta) + viscous omega + quadratic omega^2,   E = (J_c + J) omega^2 / 2
    dM_d/dtheta = (M_static(omega) - M_d) / (tau_e omega)             where the motor lags

The kinetic energy as the unknown needs no dJ/dtheta and keeps the work of a cycle exactly (textbook 3.61 in the
form of the total equation of motion). Without lag the state is E alone, with it (E, M_d).
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.numerics.collocation import TOLERANCE
from tmmcalc.core.numerics.panels import Panels, Values
from tmmcalc.core.numerics.radau import radau
from tmmcalc.core.records import record
from tmmcalc.machine.cycle import Cycle, place

if TYPE_CHECKING:
    from tmmcalc.core.numerics.collocation import Kinks, System
    from tmmcalc.core.numerics.newton import Rates
    from tmmcalc.machine.motors.characteristics import Characteristic

UNRESOLVED = 30.0  # error of the regime over what its panels leave unresolved, at most: a weak motor adds it up
VANISHING = 1e-12  # least inertia against the largest: below it the speed has no bound
IDLE = 1e-3  # of the largest moment of the motor
BEND = 1e-9  # relative distance from the no-load speed at which slopes on both sides are compared
BENT = 1e-5  # relative difference of these slopes that is more than curvature
_AWAY = np.geomspace(1e-7, 0.9, 56)
SPEEDS = np.concatenate(([0.005], 1 - _AWAY[::-1], [1.0], 1 + _AWAY, [2.5, 3.0]))  # dense where a motor is steep


@record
class OneMass:
    """A cycle, what turns with the input shaft at a constant ratio, and the motor reduced to that shaft."""

    cycle: Cycle
    constant: float  # J_c [kg*m^2]
    characteristic: Characteristic
    lag: float = 0.0  # electromagnetic time constant tau_e [s]
    sense: float = 1.0  # of the input's motion: -1 clockwise; messages tell places as sense theta
    tolerance: float = 0.0  # relative, of the regime; 0: near rounding

    @property
    def states(self) -> int:
        """Number of states."""
        return 2 if self.lag else 1

    @property
    def floor(self) -> Values:
        """Lower bounds of the states: energy is positive."""
        return np.array([0.0, -np.inf])[: self.states]

    @property
    def typical(self) -> Values:
        """Sizes below which a state counts as zero: a thousandth of the motor's largest moment."""
        if not self.lag:
            return np.zeros(1)
        moments = self.characteristic.moment(self.reference * SPEEDS)
        return np.array([0.0, IDLE * float(np.max(np.abs(moments)))])

    @property
    def reference(self) -> float:
        """The speed from which a regime is reached [rad/s]: no-load speed, else the rated or the mean one."""
        motor = self.characteristic
        return motor.synchronous or motor.nominal or self.cycle.speed

    def inertia_on(self, panels: Panels) -> Values:
        """Total inertia (K, N) [kg*m^2] on other panels."""
        return onto(self.cycle, panels).inertia + self.constant

    def speed(self, panels: Panels, energy: Values) -> Values:
        """Angular speed (K, N) [rad/s] of the kinetic energy on ``panels``."""
        return np.sqrt(2 * energy / self.inertia_on(panels))

    def state(self, panels: Panels, omega: Values, driving: Values | None = None) -> Values:
        """States (m, K, N) of a speed and a driving moment on ``panels``, by default the static one."""
        energy = self.inertia_on(panels) * omega * omega / 2
        if not self.lag:
            return energy[None]
        moment = self.characteristic.moment(omega) if driving is None else driving
        return np.stack((energy, np.broadcast_to(moment, energy.shape)))

    def gain(self, cycle: Cycle, omega: Values) -> Values:
        """Slope of the static net moment over the speed [N*m*s/rad] at ``omega`` (..., K, N) on the cycle's panels."""
        return self.characteristic.slope(omega) + cycle.viscous + 2 * cycle.quadratic * omega

    def equations(self) -> System:
        """The equations for the collocation; the speed is to be resolved as well."""
        return self._lagging if self.lag else self._static

    @property
    def resolution(self) -> dict[str, Any]:
        """How a periodic motion is to be resolved, as keywords of the collocation."""
        return {
            "floor": self.floor,
            "typical": self.typical,
            "kinks": self.kinks,
            "fixed": self.cycle.panels.edges,
            "tolerance": max(TOLERANCE, self.cycle.error, self.tolerance / UNRESOLVED),
        }

    @property
    def kinks(self) -> Kinks | None:
        """Finds where the speed crosses one at which the characteristic is not smooth; None if it is smooth."""
        levels = self._bends()
        if not levels.size:
            return None

        def crossings(theta: Values, omega: Values) -> Values:
            x, off = theta.ravel(), omega.ravel() - levels[:, None]
            k, i = np.nonzero((off[:, :-1] < 0) != (off[:, 1:] < 0))
            return np.sort(x[i] + (x[i + 1] - x[i]) * off[k, i] / (off[k, i] - off[k, i + 1]))

        return crossings

    def _bends(self) -> Values:
        """Speeds (any number,) [rad/s] at the points of a table, and without load if losses of a gearing bend there."""
        from tmmcalc.machine.motors.gearing import points_of

        motor = self.characteristic
        found = list(points_of(motor))
        level = motor.synchronous
        if level is not None:
            below, above = motor.slope(level * np.array([1 - BEND, 1 + BEND]))
            if abs(above - below) > BENT * abs(above + below):
                found.append(level)
        return np.array(sorted(set(found)), float)  # np.unique imports the masked arrays

    def _static(self, panels: Panels) -> Rates:
        inertia, moment, viscous, quadratic = self._at_points(panels)
        motor = self.characteristic

        def rates(y: Values) -> tuple[Values, Values, Values]:
            omega = np.sqrt(2 * y / inertia)
            net = motor.moment(omega) + moment + (viscous + quadratic * omega) * omega
            gain = motor.slope(omega) + viscous + 2 * quadratic * omega
            return net, (gain / (inertia * omega))[None], omega

        return rates

    def _lagging(self, panels: Panels) -> Rates:
        inertia, moment, viscous, quadratic = self._at_points(panels)
        motor, lag = self.characteristic, self.lag

        def rates(y: Values) -> tuple[Values, Values, Values]:
            omega = np.sqrt(2 * y[0] / inertia)
            pace = 1 / (lag * omega)
            f = np.empty_like(y)
            f[0] = y[1] + moment + (viscous + quadratic * omega) * omega
            f[1] = (motor.moment(omega) - y[1]) * pace
            jacobian = np.empty((2, *y.shape))
            per_energy = 1 / (inertia * omega)
            jacobian[0, 0] = (viscous + 2 * quadratic * omega) * per_energy
            jacobian[0, 1] = 1.0
            jacobian[1, 0] = (motor.slope(omega) * pace - f[1] / omega) * per_energy
            jacobian[1, 1] = -pace
            return f, jacobian, omega[None]

        return rates

    def _at_points(self, panels: Panels) -> Values:
        """Total inertia, moment, viscous and quadratic factor (4, K, N) at the Radau points."""
        cycle = onto(self.cycle, panels)
        data = np.stack((cycle.inertia + self.constant, cycle.moment, cycle.viscous, cycle.quadratic))
        return data @ radau(panels.order).from_gauss.T


def onto(cycle: Cycle, panels: Panels) -> Cycle:
    """The cycle on panels that refine its own, or a part of them."""
    for known in (cycle, *cycle.finer):
        if panels is known.panels:
            return known
    rows = np.stack((cycle.inertia, cycle.slope, cycle.moment, cycle.viscous, cycle.quadratic))
    inside = cycle.panels.at(rows, panels.x.ravel()).reshape(5, panels.count, panels.order)
    inertia, slope, moment, viscous, quadratic = inside
    cycle.finer[:] = [Cycle(panels, inertia, slope, moment, viscous, quadratic, cycle.speed, cycle.error)]
    return cycle.finer[0]


def vanishing(cycle: Cycle, constant: float) -> tuple[float, float, float] | None:
    """Least total inertia [kg*m^2], its place [rad] and the largest; None unless the least is mere rounding."""
    if constant > VANISHING * float(np.max(cycle.inertia)):
        return None
    (least, at), (most, _) = cycle.panels.extremes(cycle.inertia + constant)
    return (least, at, most) if least <= VANISHING * most else None


def check_inertia(cycle: Cycle, constant: float, sense: float = 1.0) -> None:
    """Raise `NoSolutionError` where the total inertia vanishes: nothing would limit the speed there."""
    found = vanishing(cycle, constant)
    if found is None:
        return
    least, at, most = found
    raise NoSolutionError(
        f"the reduced inertia is {least:.4g} kg*m^2 at {place(at, sense)} of the cycle: nothing bounds the speed there",
        where="steady motion",
        value=least,
        limit=VANISHING * most,
        remedy="give the crank, the rotor or a flywheel its moment of inertia",
    )


def balanced_speed(machine: OneMass) -> float | None:
    """Speed [rad/s] nearest to the no-load speed at which the mean moments of the cycle balance; None: at none."""
    cycle = machine.cycle
    mean = cycle.panels.total(np.stack((cycle.moment, cycle.viscous, cycle.quadratic))) / cycle.period
    reference = machine.reference
    omega = reference * SPEEDS
    net = machine.characteristic.moment(omega) + mean[0] + (mean[1] + mean[2] * omega) * omega
    falls = np.flatnonzero((net[:-1] >= 0) & (net[1:] < 0))
    if not falls.size:
        return None
    k = falls[np.argmin(np.abs(omega[falls] - reference))]
    return float(omega[k] + (omega[k + 1] - omega[k]) * net[k] / (net[k] - net[k + 1]))
