"""The speed of the spec against the speed of the motor and of the motion."""

from __future__ import annotations

import math

import pytest
from machines import positions, sine

from tmmcalc.machine.driver import ConstantInertia, driver_of
from tmmcalc.machine.motion import solve_motion
from tmmcalc.machine.motors.model import Motor
from tmmcalc.machine.offspeed import INPUT, off_rated, off_speed

RPM = math.pi / 30


@pytest.mark.parametrize(("off", "severity"), [(0.0049, None), (-0.0049, None), (0.0051, "note"), (-0.06, "warning")])
def test_a_mean_speed_off_the_speed_of_the_spec(off: float, severity: str | None) -> None:
    verdict = off_speed(10 * (1 + off), 10.0, 20.0, 1.0, INPUT)
    assert (verdict.severity if verdict is not None else None) == severity


def test_both_speeds_and_both_remedies_are_told() -> None:
    verdict = off_speed(20 * RPM, 10 * RPM, 30.0, -1.0, INPUT)
    assert verdict is not None
    for said in ("20 rpm", "100 % above", "10 rpm of the spec", f'set {INPUT} to "-20 rpm"', "ratio 60 in place of 30"):
        assert said in verdict.message
    without = off_speed(20 * RPM, 10 * RPM, None, 1.0, "torque.speed")
    assert without is not None
    assert "gear ratio" not in without.message
    assert "friction" not in without.message


def test_a_rated_speed_that_misses_the_speed_of_the_spec() -> None:
    assert off_rated(1440 * RPM, 15.0, 100 * RPM, 1.0, INPUT) is None
    said = off_rated(1440 * RPM, 10.0, 70 * RPM, 1.0, INPUT)
    assert said is not None
    assert "144 rpm through the ratio 10, 106 % above the 70 rpm" in said
    assert "transmission.ratio to 20.571" in said


@pytest.mark.parametrize(("ratio", "severities"), [(15.0, []), (10.0, ["warning"])])
def test_a_motion_at_half_as_much_speed_again(ratio: float, severities: list[str]) -> None:
    """A motor of 1500 rpm through 15 keeps the 100 rpm of the spec; through 10 it is 150 rpm."""
    motor = Motor("m", 5e3, 1490 * RPM, 1500 * RPM, 2.2)
    cycle = sine(-10.0, speed=100 * RPM)
    driver = driver_of(motor, "kloss", ratio)
    motion = solve_motion(cycle, None, ConstantInertia(further=50.0), driver, 100 * RPM, positions(12))
    assert [v.severity for v in motion.verdicts if "of the spec" in v.message] == severities
