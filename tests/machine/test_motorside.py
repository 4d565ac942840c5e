"""What the motor gives at its own shaft."""

from __future__ import annotations

import math

import numpy as np
import pytest
from machines import TURN, positions, sine, steps

from tmmcalc.machine.driver import ConstantInertia, Driver, driver_of
from tmmcalc.machine.facts.motion import summary as motion_summary
from tmmcalc.machine.motion import solve_motion
from tmmcalc.machine.motors.characteristics import Straight
from tmmcalc.machine.motors.model import Motor
from tmmcalc.machine.motorside import motor_side
from tmmcalc.machine.steady import driven

RPM = math.pi / 30
MOTOR = Motor("m", 2e3, 1400 * RPM, 1500 * RPM, 2.2)
RATED = 2e3 / (1400 * RPM)


@pytest.mark.parametrize("efficiency", [1.0, 0.5])
def test_a_constant_load_through_gears(efficiency: float) -> None:
    """A load of 50 N*m at the crank asks for 50/(u eta) at the motor, all the time."""
    driver = driver_of(MOTOR, "linear", 14.0, efficiency)
    regime = driven(steps((-50.0,)), 3.0, driver.characteristic)
    side, shaft = motor_side(regime, driver), 50 / (14 * efficiency)
    assert side.rms_moment == pytest.approx(shaft, rel=1e-12)
    assert side.largest == pytest.approx(shaft, rel=1e-12)
    assert side.mean_power == pytest.approx(50 * regime.mean / efficiency, rel=1e-12)
    assert side.rated_moment == pytest.approx(RATED, rel=1e-12)
    assert side.heating == pytest.approx(shaft / RATED, rel=1e-12)


def test_a_braking_motor_takes_less_than_the_crank_gives() -> None:
    """With 2000 (sin theta) a straight line brakes a while; the sums are taken apart by hand."""
    driver = driver_of(MOTOR, "linear", 14.0, 0.8)
    regime = driven(sine(400.0), 5.0, driver.characteristic)
    theta = (np.arange(200_000) + 0.5) * TURN / 200_000
    crank, omega = regime.panels.at(np.stack((regime.driving, regime.omega)), theta)
    assert np.min(crank) < 0 < np.max(crank)
    shaft = np.where(crank > 0, crank / 0.8, crank * 0.8) / 14
    time = np.mean(1 / omega)
    side = motor_side(regime, driver)
    assert side.rms_moment == pytest.approx(math.sqrt(np.mean(shaft**2 / omega) / time), rel=1e-6)
    assert side.mean_power == pytest.approx(np.mean(14 * shaft) / time, rel=1e-5)


@pytest.mark.parametrize(("load", "says"), [(100.0, "it bears that"), (200.0, "it overheats")])
def test_the_verdict_is_always_told(load: float, says: str) -> None:
    driver = driver_of(MOTOR, "linear", 14.0)
    motion = solve_motion(
        steps((-load,)), None, ConstantInertia(further=3.0), driver, 10.0, positions(12), "torque.speed"
    )
    (fact,) = [fact for fact in motion_summary(motion, "t").facts if fact.label == "heating of the motor"]
    assert fact.text.endswith(says)
    assert fact.values["M_motor_rms/M_N"] == pytest.approx(load / 14 / RATED, rel=1e-12)


def test_without_a_rated_point_there_is_no_ratio() -> None:
    line = Straight(10.0, 15.0)
    driver = Driver(line, 0.0)
    assert motor_side(driven(steps((-50.0,)), 3.0, line), driver).heating is None
