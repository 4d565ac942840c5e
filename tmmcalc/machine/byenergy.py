"""The textbook's steady motion without a motor, by the kinetic energy at the nodes of a table (3.45) to (3.49).

A constant moment closes the work of the cycle; A is the work of all moments by the trapezoid rule, and

    T_i = T_0 + A_i,   T_0 = J_0 w_m^2 / 2 in the first approximation,   w_i = sqrt(2 T_i / J_i)

so that the speed at position 0 is the mean speed asked for, and the mean is what comes out. Where T_0 is corrected
until the mean is right, only the error of the nodes is left.
"""

from __future__ import annotations

import numpy as np

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.numerics.panels import Values
from tmmcalc.machine.cycle import Cycle
from tmmcalc.machine.nodes import nodal_tables, nodal_work
from tmmcalc.machine.textbook import EnergyMotion

WHERE = "motion by the energy (3.48)"
CORRECTED = 1e-14  # relative deviation of the mean speed, of a T0 that is corrected
ROUNDS = 100


def by_energy(cycle: Cycle, constant_inertia: float, speed: float, n: int, *, corrected: bool = False) -> EnergyMotion:
    """Speeds at ``n`` equal steps of a cycle, with ``constant_inertia`` [kg*m^2] added and the mean ``speed`` [rad/s].

    Resistances that depend on speed are taken at that speed. With ``corrected`` T_0 is the one for which
    (w_max + w_min)/2 over the nodes is the mean asked for. Raises `NoSolutionError` where T_0 does not last.

    >>> from tmmcalc.machine.diagram import from_formula
    >>> found = by_energy(from_formula("100*sin(theta)", speed=10), 8.0, 10.0, 4)
    >>> found.energy, found.omega[0].item()
    (400.0, 10.0)
    """
    moment, inertia = nodal_tables(cycle, n, speed)
    total = inertia + constant_inertia
    work, drive = nodal_work(moment, cycle.period)
    energy = float(total[0]) * speed**2 / 2
    omega = _speeds(energy + work, total)
    for _ in range(ROUNDS if corrected else 0):
        off = speed - float(np.max(omega) + np.min(omega)) / 2
        if abs(off) <= CORRECTED * speed:
            break
        energy += float(np.mean(total)) * speed * off
        omega = _speeds(energy + work, total)
    low, high = int(np.argmin(omega)), int(np.argmax(omega))
    mean = float(omega[high] + omega[low]) / 2
    return EnergyMotion(energy, drive, omega, low, high, mean, float(omega[high] - omega[low]) / mean)


def _speeds(energy: Values, inertia: Values) -> Values:
    """w = sqrt(2 T / J) (n + 1,) (3.48)."""
    least = int(np.argmin(energy / inertia))
    if not energy[least] > 0:
        raise NoSolutionError(
            f"the kinetic energy is {energy[least]:.4g} J at node {least}: it does not last for the cycle",
            where=WHERE,
            value=float(energy[least]),
            limit=0.0,
            remedy="more constant inertia (a flywheel), a higher speed, or the exact motion",
        )
    return np.sqrt(2 * energy / inertia)
