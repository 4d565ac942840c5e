"""The analytic Jacobian against differences of the right-hand side."""

from __future__ import annotations

import numpy as np
import pytest

from machine.transient.scenes import cycle, kloss
from tmmcalc.machine.transient.equations import Regime, derivative
from tmmcalc.machine.transient.initial import assembled
from tmmcalc.machine.transient.jacobian import jacobian
from tmmcalc.machine.transient.model import Drive, Mass, Shaft
from tmmcalc.machine.transient.pointwise import stretches
from tmmcalc.machine.transient.profile import profile
from tmmcalc.machine.transient.scenario import Brake, Scenario

LOADED = cycle(
    lambda p: -30 - 20 * np.cos(p) + np.where(p < 2.0, 15.0, 0.0),
    lambda p: 0.5 + 0.4 * np.sin(p) ** 2,
    (2.0,),
    viscous=lambda p: -1.5 + np.sin(p),
    quadratic=lambda p: 0.1 * np.cos(2 * p),
)
MOTOR = kloss(2.0, 0.25, 30.0)
ONE = Drive((Mass(3.0),), characteristic=MOTOR, cycle=LOADED)
LAG = Drive((Mass(3.0),), characteristic=MOTOR, cycle=LOADED, time_constant=0.02)
CHAIN = Drive(
    (Mass(0.02), Mass(0.3), Mass(4.0)), (Shaft(90.0, 0.4, 4.0), Shaft(2e2, 9.0, 2.5)), MOTOR, LOADED, time_constant=0.02
)
REGIMES = [
    Regime(True, False, 0.0, frozenset(), 1.0, 0, 0.0),
    Regime(True, True, 1.0, frozenset(), 0.4, 1, 0.0),
    Regime(False, True, -1.0, frozenset(), 1.0, 1, 0.0),
    Regime(True, True, 0.0, frozenset({0}), 1.0, 1, 0.0),
]


@pytest.mark.parametrize("regime", REGIMES)
@pytest.mark.parametrize("mass", [0, -1])
@pytest.mark.parametrize("drive", [ONE, LAG, CHAIN], ids=["one", "lag", "chain"])
def test_every_entry(drive: Drive, mass: int, regime: Regime) -> None:
    scenario = Scenario("braking", 1.0, brake=Brake(0.5, 0.2, mass))
    shape = profile(drive.cycle)
    system = assembled(drive, scenario, shape, frozenset())
    f = derivative(system, regime, stretches(shape, regime.factor)[regime.stretch])
    rng = np.random.default_rng(3)
    for _ in range(5):
        y = rng.uniform(0.5, 1.5, system.layout.size)
        y[0] += 3.0 * regime.stretch
        if regime.held:
            y[system.layout.speed] = 0.0
        matrix = jacobian(system, shape, regime, f)(0.0, y)
        for j in range(len(y)):
            h = 1e-5
            up, down = y.copy(), y.copy()
            up[j] += h
            down[j] -= h
            column = (np.array(f(0.0, up.tolist())) - f(0.0, down.tolist())) / (2 * h)
            size = max(1.0, np.abs(matrix).max() * 1e-2)
            np.testing.assert_allclose(matrix[:, j], column, rtol=1e-6, atol=2e-6 * size)
