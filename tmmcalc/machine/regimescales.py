"""The time scales of a steady motion: how fast deviations from it die away, place by place.

    dw/dt = (M_d + M(theta, w)) / J,   tau_e dM_d/dt = M_static(w) - M_d

Its collocation takes the whole cycle at once and is implicit, so that its cost does not go with them; integration of
cycle after cycle in explicit steps, as in the course, has to follow the fastest.
"""

from __future__ import annotations

import numpy as np

from tmmcalc.core.numerics.panels import Values
from tmmcalc.machine.cycle import Cycle
from tmmcalc.machine.driver import Driver
from tmmcalc.machine.onemass import onto
from tmmcalc.machine.regime import Regime
from tmmcalc.machine.timescales import TimeScales, time_scales


def regime_scales(cycle: Cycle, regime: Regime, driver: Driver) -> TimeScales | None:
    """Time scales of the steady motion under a motor over one cycle, of all its places the fastest and the slowest."""
    values = _along(onto(cycle, regime.panels), regime, driver).ravel()
    size = np.abs(values)
    return time_scales(values[[int(np.argmax(size)), int(np.argmin(size))]], regime.cycle_time)


def _along(cycle: Cycle, regime: Regime, driver: Driver) -> Values:
    """Eigenvalues (K, N) or (2, K, N) [1/s] of the deviations of the speed and, where the motor lags, of its moment."""
    inertia = cycle.inertia + regime.constant_inertia
    slope = driver.characteristic.slope(regime.omega)
    own = (cycle.viscous + 2 * cycle.quadratic * regime.omega) / inertia
    if driver.time_constant == 0:
        eigenvalues: Values = own + slope / inertia
        return eigenvalues
    lag = 1 / driver.time_constant
    # of the matrix [[own, 1/J], [slope/tau, -1/tau]]; the larger root first, which loses no digits
    half, product = (own - lag) / 2, -lag * (own + slope / inertia)
    root = np.sqrt(half * half - product + 0j)
    larger = half + np.where(half >= 0, root, -root)
    return np.stack((larger, product / np.where(larger == 0, 1.0, larger)))
