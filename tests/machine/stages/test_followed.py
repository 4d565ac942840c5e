"""A mean speed by the motor: that of the motion itself, at which everything is computed."""

from __future__ import annotations

import math

import pytest
from gears.stages.trains import STEEL
from machines import MOTOR, spec_text
from scipy.optimize import brentq

import tmmcalc
from tmmcalc.core.errors import SpecError
from tmmcalc.pipeline.runner import run

RPM = math.pi / 30
RATIO = ("[transmission]\n", "[transmission]\nratio = 15\n")
BY = "by the motor"


@pytest.mark.parametrize("wheel", ["3 kg*m^2", ""])
def test_the_speed_of_the_motion_is_the_speed_of_the_spec(wheel: str) -> None:
    """With a flywheel that is there, and with the one that an allowed unevenness asks for."""
    text = spec_text(speed=BY, existing=wheel or "1 kg*m^2").replace(*RATIO)
    text = text if wheel else text.replace('inertia = "1 kg*m^2"\n', "")
    found = run(tmmcalc.parse_spec(text), target="motion").results
    motion, speed = found["motion"], found["kinematics"].speed
    assert motion.regime.mean == pytest.approx(speed, rel=1e-8)
    assert 1420 / 15 * RPM < speed < 1500 / 15 * RPM
    assert not any("of the spec" in verdict.message for verdict in motion.verdicts)
    number = run(tmmcalc.parse_spec(text.replace(BY, f"{speed!r} rad/s")), target="motion").results
    assert number["motion"].regime.delta == motion.regime.delta


def test_a_clockwise_crank() -> None:
    text = spec_text(speed=f"{BY}, clockwise").replace(*RATIO)
    found = run(tmmcalc.parse_spec(text), target="motion").results
    assert found["kinematics"].speed == pytest.approx(-found["motion"].regime.mean, rel=1e-8)
    assert not any("of the spec" in verdict.message for verdict in found["motion"].verdicts)


def test_a_diagram_without_inertia_balances_its_mean_moments() -> None:
    """The parabola M_N (w_c^2 - w^2)/(w_c^2 - w_N^2) against 80 N*m through 15 at 0.9, solved anew."""
    text = f'[torque]\nspeed = "{BY}"\nformula = "-80 + 20*sin(theta)"\n{MOTOR}[transmission]\nratio = 15\n'
    spec = tmmcalc.parse_spec(text.replace("inertia = 0.004\n", "") + "efficiency = 0.9\n")
    rated, idle = 1420 * RPM, 1500 * RPM

    def net(omega: float) -> float:
        own = 1500 / rated * (idle**2 - (15 * omega) ** 2) / (idle**2 - rated**2)
        return own * 15 * 0.9 - 80

    assert spec.torque is not None
    assert spec.torque.speed == pytest.approx(brentq(net, rated / 15 / 2, idle / 15, xtol=1e-14), rel=1e-9)


def test_through_the_train_that_is_chosen() -> None:
    train = f'[train]\nlayout = "AIbar"\nplanets = 2\nsum_max = 160\nratio = "15"\n[strength]\n{STEEL}\n'
    text = spec_text(speed=BY, more=train).replace("[transmission]\nefficiency = 1.0\ninertia = 0.4\n", "")
    found = run(tmmcalc.parse_spec(text), target="motion").results
    assert found["power"].duty.ratio != 15
    assert found["motion"].regime.mean == pytest.approx(found["kinematics"].speed, rel=1e-8)


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        (MOTOR, "", r"\"by the motor\" without \[motor\]"),
        (MOTOR, '[motor]\nname = "choose"\n', "the choice asks for the speed"),
        ("ratio = 15\n", "", "without a ratio: it would follow from the speed"),
        (BY, "by motor", 'did you mean "by the motor"'),
    ],
)
def test_faults(old: str, new: str, words: str) -> None:
    text = spec_text(speed=BY).replace(*RATIO)
    assert old in text
    with pytest.raises(SpecError, match=words) as error:
        tmmcalc.parse_spec(text.replace(old, new))
    assert len(error.value.faults) == 1
    assert error.value.faults[0].path == "mechanism.input.speed"
