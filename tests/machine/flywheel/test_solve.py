"""The flywheel stage as a whole: what it says beside the numbers."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import pytest
from machines import sine
from sparing import sparing

from tmmcalc.machine.cycle import Cycle
from tmmcalc.machine.driver import ConstantInertia, Driver
from tmmcalc.machine.flywheel.results import Flywheel
from tmmcalc.machine.flywheel.solve import Machine, solve_flywheel
from tmmcalc.machine.model import FlywheelTask
from tmmcalc.machine.motors.characteristics import Kloss, kloss
from tmmcalc.machine.positional import positional


def wanted(delta: float) -> FlywheelTask:
    nothing: dict[str, Any] = dict.fromkeys(("ratio", "diameter", "width", "thickness", "density", "speed_limit"))
    return FlywheelTask(**nothing, delta=delta, inertia=0.0, shaft="input", material="steel")


def flywheel(cycle: Cycle, delta: float, motor: Kloss | None = None, lag: float = 0.0) -> Flywheel:
    driver = Driver(motor, lag) if motor is not None else None
    return solve_flywheel(Machine(cycle, ConstantInertia(further=0.5), wanted(delta), driver, cycle.speed, 1.0))


@sparing("lag", [0.0, 0.02], every=2)
def test_rounding_of_a_tiny_delta_is_no_rise_of_it(lag: float) -> None:
    motor = kloss(100.0, 0.2, 21.0, 20.0)
    found = flywheel(sine(100.0), 1e-9, motor, lag)
    assert found.required is not None
    assert found.required.monotone
    assert not any("rises" in verdict.message for verdict in found.verdicts)


@pytest.mark.parametrize("viscous", [-5.0, -0.5])
def test_loads_of_the_speed_tell_the_delta_of_the_motion(viscous: float) -> None:
    """They even it out: of a small amplitude delta = 2 M/sqrt((J omega)^2 + c^2)/omega."""
    cycle = sine(100.0)
    cycle = replace(cycle, viscous=cycle.viscous + viscous)
    found = flywheel(cycle, 0.05)
    real = positional(cycle, found.inertia, cycle.speed).delta
    (verdict,) = [verdict for verdict in found.verdicts if "depend on the speed" in verdict.message]
    assert f"delta is {real:.7g}," in verdict.message
    assert real == pytest.approx(200 / math.hypot(found.inertia * 20, viscous) / 20, rel=1e-3)
    assumed = found.rows[0].positional.delta
    assert assumed is not None
    assert real < assumed


def test_forces_of_position_alone_say_nothing_of_it() -> None:
    assert not any("depend on the speed" in verdict.message for verdict in flywheel(sine(100.0), 0.05).verdicts)
