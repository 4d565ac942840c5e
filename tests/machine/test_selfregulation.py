"""Machines that only their loads drive, against closed forms and an integration by scipy."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from machines import TURN, positions, steps
from written import PINS, link, slide

from machine.motion import cycle_of, reference
from tmmcalc.core.errors import NoSolutionError
from tmmcalc.machine.cycle import Cycle
from tmmcalc.machine.driver import ConstantInertia
from tmmcalc.machine.facts.motion import summary as motion_summary
from tmmcalc.machine.motion import solve_motion
from tmmcalc.machine.selfregulation import balance_speed, self_regulated
from tmmcalc.project import parse_spec


def engine(viscous: float = 0.0, quadratic: float = 0.0, drive: float = 20.0, speed: float = 10.0) -> Cycle:
    return _resisted(steps((drive, drive), speed=speed), viscous, quadratic)


def _resisted(cycle: Cycle, viscous: float, quadratic: float) -> Cycle:
    return replace(cycle, viscous=cycle.viscous + viscous, quadratic=cycle.quadratic + quadratic)


class TestConstant:
    """A constant moment against resistances of the speed: the speed is constant, and known."""

    @pytest.mark.parametrize("asked", [1.0, 10.0, 400.0])
    @pytest.mark.parametrize(
        ("viscous", "quadratic", "speed"),
        [(-2.0, 0.0, 10.0), (0.0, -0.2, 10.0), (-1.0, -0.1, 10.0), (1.0, -0.3, 10.0), (-3.0, 0.1, 10.0)],
    )
    def test_the_speed_that_balances(self, viscous: float, quadratic: float, speed: float, asked: float) -> None:
        regime = self_regulated(engine(viscous, quadratic, speed=asked), 3.0)
        assert regime.mean == pytest.approx(speed, rel=1e-12)
        assert regime.delta < 1e-12
        falls = viscous + 2 * quadratic * speed
        assert regime.multipliers[0].real == pytest.approx(math.exp(falls / (4.0 * speed) * TURN), rel=1e-9)

    @pytest.mark.parametrize(
        ("cycle", "says"),
        [
            (engine(), "no load depends on the speed.*speeds up without end"),
            (engine(drive=-5.0), "no load depends on the speed.*the machine stops"),
            (engine(viscous=1.0), "balance at no speed.*speeds up without end"),
            (engine(viscous=-1.0, drive=-5.0), "balance at no speed.*the machine stops"),
            (engine(viscous=-1.0, quadratic=0.1), "balance at no speed.*speeds up without end"),
            (engine(viscous=-4.0, quadratic=0.2), "balance at no speed"),
        ],
    )
    def test_where_there_is_no_regime(self, cycle: Cycle, says: str) -> None:
        with pytest.raises(NoSolutionError, match=says) as caught:
            self_regulated(cycle, 3.0)
        assert caught.value.remedy


def test_a_pulsating_engine_with_a_fan() -> None:
    """M = 40 (1 + 1.5 sin phi) - 0.35 omega^2 on a shaft with the inertia 1 + 0.3 cos phi."""

    def at(phi: Any) -> tuple[Any, Any, Any]:
        return 1 + 0.3 * np.cos(phi), -0.3 * np.sin(phi), 40 * (1 + 1.5 * np.sin(phi))

    cycle, theta = cycle_of(at, quadratic=-0.35), np.linspace(0.0, TURN, 50)
    regime = self_regulated(cycle, 2.0)

    class Nothing:
        def moment(self, omega: Any) -> Any:
            return 0 * omega

    omega = reference(at, [0.0, TURN], 2.0, Nothing(), (regime.omega_at(np.zeros(1))[0],), quadratic=-0.35)
    assert np.max(np.abs(omega(theta) - regime.omega_at(theta))) < 1e-10 * regime.mean
    assert abs(omega(np.array([TURN]))[0] - omega(np.zeros(1))[0]) < 1e-10 * regime.mean
    assert balance_speed(cycle) == pytest.approx(math.sqrt(40 / 0.35))
    assert regime.stable
    assert np.all(regime.driving == 0)


def test_kinetic_energy_that_does_not_last() -> None:
    with pytest.raises(NoSolutionError, match=r"stalls at .* the speed that balances its mean load") as caught:
        self_regulated(_resisted(steps((-500.0, 540.0), inertia=0.0), -2.0, 0.0), 0.5)
    assert "motor" not in str(caught.value.remedy)


def test_what_a_motion_without_drive_says() -> None:
    cycle = engine(quadratic=-0.2, speed=10.0)
    motion = solve_motion(
        cycle, None, ConstantInertia(further=3.0), None, 10.0, positions(12), "torque.speed", undriven=True
    )
    assert (motion.kind, motion.characteristic, motion.idle) == ("none", "none", None)
    document = motion_summary(motion, "t")
    facts = {fact.label: fact.text for fact in document.facts}
    assert facts["driven by"] == "nothing but its loads, which set the speed"
    assert "driving moment" not in facts


LINKS = (
    link(1, "O = [0, 0], A = [0.1, 0]")
    + link(2, "A = [0, 0], B = [0.4, 0]", "mass = 1")
    + link(3, "B = [0, 0]", "mass = 2")
)
JOINTS = PINS + slide("S", 3, 0, 'through = "O", angle = 0')
ENGINE = """
[mechanism.input]
joint = "O"
speed = "{speed}"
[mechanism.fixed]
O = [0, 0]
{links}{joints}[mechanism.assembly.sketch]
B = [0.5, 0]
[[loads]]
name = "gas"
link = 1
moment = 40
role = "drive"
[[loads]]
name = "generator"
link = 1
viscous = 2
[motion]
drive = "none"
inertia = 0.5
[flywheel]
delta = 0.01
[[transients]]
from = "steady"
motor = "off"
duration = "3 s"
"""


@pytest.fixture(scope="module")
def whole() -> Any:
    from tmmcalc.api import run

    return run(parse_spec(ENGINE.format(links=LINKS, joints=JOINTS, speed="20 rad/s"))).results


def test_the_flywheel_of_a_machine_without_drive_is_the_true_one(whole: Any) -> None:
    """The flywheel's table and the motion with it tell the same unevenness."""
    from tmmcalc.machine.facts.flywheel import document as flywheel_document

    assert whole["motion"].regime.delta == pytest.approx(0.01, rel=1e-8)
    assert whole["flywheel"].required.delta == pytest.approx(whole["motion"].regime.delta, rel=1e-9)
    needed = flywheel_document(whole["flywheel"], "t")
    assert "under its loads at" in next(fact.text for fact in needed.facts if fact.label == "flywheel needed")
    assert not any("motor" in fact.text for fact in needed.facts if fact.label != "or on the motor shaft")


def test_a_motion_in_time_begun_in_it_repeats_it(whole: Any) -> None:
    regime, motion = whole["motion"].regime, whole["transient"].motions[0]
    turned = np.mod(motion.theta[-1], TURN)
    np.testing.assert_allclose(motion.omega[-1], regime.omega_at(turned), rtol=1e-6)


def test_the_work_of_a_cycle_is_zero(whole: Any) -> None:
    regime = whole["motion"].regime
    theta = np.linspace(0.0, TURN, 4000, endpoint=False)
    assert 40 - 2 * np.mean(regime.omega_at(theta)) == pytest.approx(0.0, abs=1e-9)
