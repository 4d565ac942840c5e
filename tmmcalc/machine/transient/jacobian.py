"""The analytic Jacobian of the equations of motion, for implicit methods and for the eigenvalues."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.numerics.steps import Derivative
from tmmcalc.machine.transient.equations import Regime, System
from tmmcalc.machine.transient.pointwise import Slopes, slopes
from tmmcalc.machine.transient.profile import Profile

Jacobian = Callable[[float, Values], Values]


def jacobian(system: System, profile: Profile, regime: Regime, f: Derivative) -> Jacobian:
    """The matrix df_i/dy_j (m, m) of one regime, whose right-hand side is ``f``, as a function of (t, y)."""
    layout = system.layout
    n, crank = layout.groups, layout.crank

    def matrix(t: float, y: Values) -> Values:
        at = slopes(profile, regime.stretch, regime.base, regime.factor, float(y[0]), float(y[crank]))
        inertia = np.array(system.chain.inertia)
        inertia[-1] += at.inertia
        carried = _carried(system, regime, y)
        net = _net(system, regime, carried, at, y)
        result = np.zeros((layout.size, layout.size))
        result[0, crank] = 1.0
        for i in range(n - 1):
            result[i + 1, [n + i, n + i + 1]] = 1.0, -1.0
        result[n : 2 * n] = net / inertia[:, None]
        result[crank, 0] -= f(t, y.tolist())[crank] * at.d_inertia / inertia[-1]
        result[[n + i for i in regime.held]] = 0.0
        if layout.lag and regime.motor:
            result[2 * n, [n, 2 * n]] = _slope(system, y) / system.time_constant, -1 / system.time_constant
        result[layout.works :] = _powers(system, regime, carried, at, y)
        return result

    return matrix


def _slope(system: System, y: Values) -> float:
    """Slope of the motor's static moment at the speed of its group [N*m*s]."""
    return system.slope(float(y[system.layout.speed])) if system.slope else 0.0


def _drive(system: System, regime: Regime, y: Values) -> float:
    """Moment of the motor [N*m]."""
    layout = system.layout
    if system.moment is None or not regime.motor:
        return 0.0
    return float(y[2 * layout.groups]) if layout.lag else system.moment(float(y[layout.speed]))


def _carried(system: System, regime: Regime, y: Values) -> Values:
    """Partial derivatives (n + 1, m) of the moments T_0 of the motor, T_1 to T_(n-1) of the shafts, T_n = 0."""
    layout = system.layout
    n = layout.groups
    carried = np.zeros((n + 1, layout.size))
    if system.moment is not None and regime.motor:
        carried[0, 2 * n if layout.lag else n] = 1.0 if layout.lag else _slope(system, y)
    for i, (c, k) in enumerate(zip(system.chain.stiffness, system.chain.damping, strict=True)):
        carried[i + 1, [i + 1, n + i, n + i + 1]] = c, k, -k
    return carried


def _net(system: System, regime: Regime, carried: Values, at: Slopes, y: Values) -> Values:
    """Partial derivatives (n, m) of the moment on every group."""
    n, crank = system.layout.groups, system.layout.crank
    net = carried[:-1] - carried[1:]
    if regime.braked:
        net[system.brake, n + system.brake] -= system.drag
    net[-1, 0] += at.d_angle - 0.5 * at.d2_inertia * y[crank] ** 2
    net[-1, crank] += at.d_speed - at.d_inertia * y[crank]
    return net


def _powers(system: System, regime: Regime, carried: Values, at: Slopes, y: Values) -> Values:
    """Partial derivatives (4, m) of the powers of motor, load, brake and dampers."""
    n, crank, braked = system.layout.groups, system.layout.crank, system.layout.speed + system.brake
    powers = np.zeros((4, system.layout.size))
    powers[0] = carried[0] * y[n]
    powers[0, n] += _drive(system, regime, y)
    powers[1, [0, crank]] = at.d_angle * y[crank], at.load + at.d_speed * y[crank]
    if regime.braked:
        powers[2, braked] = -regime.slip * system.grip - 2 * system.drag * y[braked]
    for i, k in enumerate(system.chain.damping):
        loss = 2 * k * (y[n + i] - y[n + i + 1])
        powers[3, [n + i, n + i + 1]] += -loss, loss
    return powers
