"""Steady motions of several machines at once, against each by itself."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import pytest

from tmmcalc.core.numerics.mesh import Mesh, laid
from tmmcalc.core.numerics.panels import Panels
from tmmcalc.machine.cycle import Cycle
from tmmcalc.machine.motors.characteristics import kloss, parabolic, straight
from tmmcalc.machine.motors.gearing import reduced
from tmmcalc.machine.stacked.places import places
from tmmcalc.machine.stacked.regimes import is_smooth, machines_of, regimes
from tmmcalc.machine.steady import driven

PERIOD = 2 * np.pi
LOADS = (200.0, 500.0, 800.0)
BREAKS = np.array([[1.0, 2.0], [1.0, 3.0], [0.5, 2.0]])  # where the load begins and ends
MOTORS = {
    "parabolic": parabolic(1200.0, 10.0, 10.7),
    "linear": straight(1200.0, 10.0, 10.7),
    "kloss": kloss(2600.0, 0.2773, 10.7),
    "with losses": reduced(parabolic(60.0, 200.0, 214.0), 20.0, 0.9),
}


class Given(NamedTuple):
    """What `machines_of` reads of cycles."""

    panels: Mesh
    values: np.ndarray


def cycles() -> tuple[Given, list[Cycle]]:
    on = laid(PERIOD, BREAKS, PERIOD / 20)
    load = (
        np.array(LOADS)[on.owner, None]
        * ((on.low >= BREAKS[on.owner, 0]) & (on.high <= BREAKS[on.owner, 1] + 1e-12))[:, None]
    )
    x = on.x
    values = np.stack((3 + np.cos(2 * x) / 5, -np.sin(2 * x) * 2 / 5, 0 * x - load - 250, 0 * x - 1.0))
    alone = []
    for k in range(len(BREAKS)):
        own = on.owner == k
        panels = Panels(np.append(on.low[own], PERIOD))
        inertia, slope, moment, viscous = values[:, own]
        alone.append(Cycle(panels, inertia, slope, moment, viscous, 0 * viscous, 10.0))
    return Given(on, values), alone


@pytest.mark.parametrize("name", MOTORS)
@pytest.mark.parametrize("constant", [5.0, 60.0])
def test_regimes_are_those_of_each_machine(name: str, constant: float) -> None:
    given, alone = cycles()
    found = regimes(machines_of(*given, len(alone), constant, MOTORS[name]))
    theta = np.linspace(0.0, PERIOD, 41)
    at = places(found.machines, theta, np.zeros(len(theta), bool))
    assert found.clear.all()
    for k, cycle in enumerate(alone):
        regime = driven(cycle, constant, MOTORS[name])
        omega = regime.omega_at(theta)
        assert np.max(np.abs(at.at(found.omega)[k] / omega - 1)) < 1e-11
        time = at.primitive(found.machines, 1 / found.omega)[k]
        assert np.max(np.abs(time - regime.time_at(theta))) < 1e-11 * time[-1]
        gap = at.at(found.acceleration)[k] - regime.panels.at(regime.acceleration, theta)
        assert np.max(np.abs(gap)) < 1e-9 * np.max(np.abs(regime.acceleration))


def test_machines_that_are_overloaded_are_left_alone() -> None:
    given, alone = cycles()
    weak = parabolic(100.0, 10.0, 10.7)
    found = regimes(machines_of(*given, len(alone), 20.0, weak))
    mean = [float(cycle.panels.total(cycle.moment)) / PERIOD for cycle in alone]
    top = weak.a  # at standstill
    assert all(not clear for clear, load in zip(found.clear, mean, strict=True) if -load > top)


def test_smooth_characteristics() -> None:
    assert all(is_smooth(motor) for motor in MOTORS.values())


def test_losses_of_gears_bend_at_the_no_load_speed() -> None:
    """Machines that run through it on their way are left alone."""
    given, alone = cycles()
    swinging = Given(given.panels, given.values * np.array([10.0, 10.0, 0.1, 1.0])[:, None, None])
    assert not regimes(machines_of(*swinging, len(alone), 5.0, MOTORS["with losses"])).clear.any()
    assert regimes(machines_of(*swinging, len(alone), 5.0, MOTORS["parabolic"])).clear.all()
