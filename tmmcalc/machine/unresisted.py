"""Steady motion at a mean speed under a driving moment that closes the work, where nothing depends on the speed.

The kinetic energy is T = T0 + A(theta), where A is the work of all moments with the driving one; T0 sets the mean
speed. The speed is omega = sqrt(2 T / J) (3.48).
"""

from __future__ import annotations

import numpy as np

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.numerics.collocation import TOLERANCE
from tmmcalc.core.numerics.extended import EPS
from tmmcalc.core.numerics.panels import NARROWEST, PASSES, Panels, Values
from tmmcalc.machine.cycle import Cycle, place
from tmmcalc.machine.onemass import onto
from tmmcalc.machine.regime import Regime, regime_of
from tmmcalc.machine.regimeerrors import ROUNDED

WHERE = "steady motion"
LEVEL = 1e-15  # relative change of the energy at which its level is found
LEVELS = 60
ROUNDINGS = 4.0  # that an interpolated inertia or a sum of works adds up: finer panels would follow them


def free(cycle: Cycle, constant: float, mean: float, driving: Values, sense: float) -> Regime:
    """The regime under the ``driving`` moment (K, N), which closes the work, where nothing depends on the speed."""
    on, moment = cycle, driving
    for meshes in range(1, PASSES + 1):
        inertia = on.inertia + constant
        work = on.panels.primitive(on.moment + moment)[0]
        if meshes == 1:
            _check_energy(on, work, constant, mean, sense)
        energy = _level(on.panels, work, inertia, mean) + work
        omega = np.sqrt(2 * energy / inertia)
        tail = on.panels.tail(omega) / np.max(omega)
        noise = _rounding(cycle, on.panels) * np.max(omega / inertia, axis=1) / (2 * np.max(omega))
        rough = (tail > np.maximum(TOLERANCE, noise)) & (on.panels.width > NARROWEST * cycle.period)
        if not rough.any():
            break
        on = onto(cycle, on.panels.split(rough))
        moment = cycle.panels.at(driving, on.panels.x.ravel()).reshape(on.moment.shape)
    rounding = ROUNDINGS * EPS * float(np.ptp(work) / np.min(energy)) / 2
    drive, turned = float(np.max(np.abs(moment))), float(on.panels.total(np.abs(on.moment))) / on.period
    return regime_of(
        on,
        constant,
        omega,
        moment,
        (1 + 0j,),
        np.maximum(tail - ROUNDED, 0.0) + rounding,
        {"newton": 0, "meshes": meshes},
        own=(ROUNDINGS * EPS + cycle.error) * turned / drive if drive else 0.0,
    )


def _rounding(cycle: Cycle, panels: Panels) -> Values:
    """Rounding (K,) [kg*m^2] of the inertia on finer panels: that of the largest one from which it is interpolated."""
    whole = np.searchsorted(cycle.panels.edges, (panels.edges[:-1] + panels.edges[1:]) / 2) - 1
    return ROUNDINGS * EPS * np.max(cycle.inertia, axis=1)[whole]


def _check_energy(cycle: Cycle, work: Values, constant: float, mean: float, sense: float) -> None:
    """Raise `NoSolutionError` if the energy at the mean speed does not last for the cycle.

    With the least inertia that does, the speed falls to zero once a cycle and rises to twice the mean.
    """
    (least, at), _ = cycle.panels.extremes(work)
    need = cycle.panels.extremes((work - least) / (2 * mean * mean) - cycle.inertia)[1][0]
    if constant > need:
        return
    raise NoSolutionError(
        f"the machine would stop at {place(at, sense)} of the cycle: at a mean speed of {mean:.6g} rad/s "
        f"the kinetic energy of {constant:.6g} kg*m^2 does not last",
        where=WHERE,
        value=constant,
        limit=need,
        remedy=f"a constant inertia of more than {need:.4g} kg*m^2 (a flywheel), or a higher speed",
    )


def _level(panels: Panels, work: Values, inertia: Values, mean: float) -> float:
    """T0, the kinetic energy at theta = 0, for which the extremes of the speed have the mean asked for.

    At an extreme the speed is stationary, so renewing the places and the speeds there in turn doubles the digits.
    """
    lowest = panels.extremes(work)[0][0]
    level = max(mean * mean * float(np.mean(inertia)) / 2, 0.1 * float(np.ptp(work))) - lowest
    for _ in range(LEVELS):
        omega = np.sqrt(2 * (level + work) / inertia)
        (slow, a), (fast, b) = panels.extremes(omega)
        work_a, work_b = panels.at(work, np.array([a, b]))
        inertia_a, inertia_b = 2 * (level + work_a) / slow**2, 2 * (level + work_b) / fast**2
        fast = _faster(inertia_a, inertia_b, float(work_b - work_a), mean)
        before = level
        level = max(inertia_b * fast**2 / 2 - float(work_b), (before + lowest) / 4 - lowest)
        if abs(level - before) <= LEVEL * (level + np.ptp(work)):
            break
    return level


def _faster(inertia_a: float, inertia_b: float, gain: float, mean: float) -> float:
    """The speed at b where J_b w_b^2 - J_a w_a^2 = 2 ``gain`` and w_a + w_b = 2 ``mean``."""
    linear = 4 * mean * inertia_a
    constant = 4 * mean * mean * inertia_a + 2 * gain
    root = linear * linear + 4 * (inertia_b - inertia_a) * constant
    return 2 * constant / (linear + float(np.sqrt(max(root, 0.0))))
