"""Steady motion at a mean speed against resistances that depend on the speed, under a constant driving moment.

The driving moment that closes the work of the cycle (textbook 3.45) is not known beforehand: it is a second state,
which does not change, beside the kinetic energy.
"""

from __future__ import annotations

import numpy as np

from tmmcalc.core.errors import AccuracyError, NoSolutionError
from tmmcalc.core.numerics.collocation import TOLERANCE, Orbit, solve
from tmmcalc.core.numerics.newton import Ends, Rates
from tmmcalc.core.numerics.panels import Panels, Values
from tmmcalc.core.numerics.radau import radau
from tmmcalc.machine.cycle import Cycle
from tmmcalc.machine.onemass import onto
from tmmcalc.machine.regime import Regime, regime_of
from tmmcalc.machine.regimeerrors import ROUNDED
from tmmcalc.machine.unresisted import LEVELS, WHERE, free

RAISED = 0.2  # to the logarithm of the energy's level, where the first guess of it does not last
MEAN = 1e-14  # relative deviation of the mean speed


def resisted(cycle: Cycle, constant: float, mean: float, sense: float = 1.0) -> Regime:
    """The regime at the ``mean`` speed [rad/s] with the ``constant`` inertia [kg*m^2] added to that of the cycle.

    Raises `NoSolutionError` where the energy does not last for the cycle.
    """
    frozen = cycle.moment + (cycle.viscous + cycle.quadratic * mean) * mean
    still = Cycle(cycle.panels, cycle.inertia, cycle.slope, frozen, cycle.viscous, cycle.quadratic, mean, cycle.error)
    level = -float(cycle.panels.total(frozen)) / cycle.period
    start = free(still, constant, mean, np.full(frozen.shape, level), sense)
    orbit, off = _at_mean(cycle, constant, mean, start)
    on = onto(cycle, orbit.panels)
    omega = np.sqrt(2 * orbit.y[0] / (on.inertia + constant))
    counters = {"newton": orbit.iterations, "meshes": orbit.passes}
    missing = orbit.missing[0] + off
    multiplier = complex(np.exp(orbit.trace))
    own = float(np.max(orbit.missing[1])) + off + ROUNDED
    return regime_of(on, constant, omega, orbit.y[1], (multiplier,), missing, counters, own=own)


def _at_mean(cycle: Cycle, constant: float, mean: float, start: Regime) -> tuple[Orbit, float]:
    """The periodic motion with the mean speed asked for, and what that is off, relative.

    By the secant in the logarithms of T0 and the mean.
    A level with which the energy does not last for the cycle is too low: the next one lies half-way back.
    """
    panels = start.panels
    energy = (onto(cycle, panels).inertia + constant) * start.omega**2 / 2
    guess = np.stack((energy, start.driving))
    log_level, power = float(np.log(panels.ends(energy)[0][0])), 2.0
    known: list[tuple[float, float]] = []  # logarithms of the level, and of the mean over that asked for
    for _ in range(LEVELS):
        try:
            orbit = _from_level(cycle, constant, panels, guess, float(np.exp(log_level)))
        except AccuracyError:
            log_level = (log_level + known[-1][0]) / 2 if known else log_level + RAISED
            continue
        omega = np.sqrt(2 * orbit.y[0] / (onto(cycle, orbit.panels).inertia + constant))
        (slow, _), (fast, _) = orbit.panels.extremes(omega)
        off = float(np.log((slow + fast) / (2 * mean)))
        if abs(off) < MEAN:
            return orbit, abs(off)
        if known and off != known[-1][1]:
            power = (log_level - known[-1][0]) / (off - known[-1][1])
        known.append((log_level, off))
        log_level -= power * off
        panels, guess = orbit.panels, orbit.y
    raise NoSolutionError(
        f"the kinetic energy of {constant:.6g} kg*m^2 does not last for the cycle at a mean speed of {mean:.6g} rad/s",
        where=WHERE,
        value=constant,
        remedy="more constant inertia (a flywheel), or a higher speed",
    )


def _from_level(cycle: Cycle, constant: float, panels: Panels, guess: Values, level: float) -> Orbit:
    """The motion that begins with the energy ``level`` [J] and the constant moment that makes it periodic."""
    # E(end) = E(0) and E(0) = level
    ends = Ends(np.array([[-1.0, 0.0], [1.0, 0.0]]), np.array([[1.0, 0.0], [0.0, 0.0]]), np.array([0.0, level]))
    return solve(
        lambda on: _governed(cycle, constant, on),
        panels,
        guess,
        ends=ends,
        floor=np.array([0.0, -np.inf]),
        tolerance=max(TOLERANCE, cycle.error),
    )


def _governed(cycle: Cycle, constant: float, panels: Panels) -> Rates:
    """The equations of the states (E, M_d) with a driving moment that does not change."""
    on = onto(cycle, panels)
    data = np.stack((on.inertia + constant, on.moment, on.viscous, on.quadratic))
    inertia, moment, viscous, quadratic = data @ radau(panels.order).from_gauss.T

    def rates(y: Values) -> tuple[Values, Values, Values]:
        omega = np.sqrt(2 * y[0] / inertia)
        f, jacobian = np.zeros_like(y), np.zeros((2, *y.shape))
        f[0] = y[1] + moment + (viscous + quadratic * omega) * omega
        jacobian[0, 0] = (viscous + 2 * quadratic * omega) / (inertia * omega)
        jacobian[0, 1] = 1.0
        return f, jacobian, omega[None]

    return rates
