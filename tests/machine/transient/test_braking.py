"""Electric braking of a shunt machine: exponential decay in closed form, DOP853 beside it, the ready spec."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import tmmcalc
from tmmcalc.core.errors import SpecError, UsageError
from tmmcalc.machine.motors.braking import Braking, braking
from tmmcalc.machine.motors.model import Motor
from tmmcalc.machine.transient.timed import TimedMotion
from tmmcalc.project import load_spec, parse_spec, templates

U, R, K, RATIO, EFFICIENCY = 220.0, 0.32, 1.38, 9.8, 0.93
LOAD, INERTIA = 60.0, 28.0 + 0.24 * RATIO**2 + 1.5
SPEC = """
[torque]
speed = "150 rpm"
formula = "{moment}"
inertia = {inertia}
[motor]
kind = "shunt"
power = "7.5 kW"
speed = "1430 rpm"
voltage = "220 V"
resistance = "0.32 ohm"
constant = "1.38 V*s/rad"
inertia = 0.24
{lag}
[transmission]
ratio = 9.8
efficiency = {efficiency}
inertia = 1.5
[[transients]]
name = "braking"
start_speed = "16 rad/s"
{more}
"""


def run(more: str, moment: str = "-60", efficiency: float = 1.0, inertia: str = "28", lag: str = "") -> TimedMotion:
    text = SPEC.format(more=more, moment=moment, efficiency=efficiency, inertia=inertia, lag=lag)
    (found,) = tmmcalc.run(parse_spec(text)).results["transient"].motions
    return found


WAYS = [
    ('kind = "regenerative", voltage = "110 V", resistance = "1.2 ohm"', 110.0, 1.2),
    ('kind = "regenerative"', U, 0.0),
    ('kind = "dynamic", resistance = "1.2 ohm"', 0.0, 1.2),
    ('kind = "dynamic"', 0.0, 0.0),
    ('kind = "plugging", resistance = "2.8 ohm"', -U, 2.8),
]


@pytest.mark.parametrize(("keys", "voltage", "added"), WAYS)
def test_the_speed_decays_exponentially(keys: str, voltage: float, added: float) -> None:
    """J w' = b (w_s - w) - M_F: towards w_s - M_F/b with the time constant J (R + R_a)/(k u)^2."""
    found = run(f"duration = 0.3\nbraking = {{ {keys} }}")
    stiffness = (K * RATIO) ** 2 / (R + added)
    settles = voltage / (K * RATIO) - LOAD / stiffness
    tau = INERTIA / stiffness
    assert found.omega[0] == pytest.approx(settles + (16.0 - settles) * np.exp(-found.t / tau), rel=1e-8)
    assert found.motor_moment == pytest.approx(stiffness * (voltage / (K * RATIO) - found.omega[0]), rel=1e-8, abs=1e-5)


@pytest.mark.parametrize(("keys", "voltage", "added"), WAYS[2:])
def test_the_time_and_the_angle_to_rest(keys: str, voltage: float, added: float) -> None:
    found = run(f"braking = {{ {keys} }}")
    stiffness = (K * RATIO) ** 2 / (R + added)
    settles, tau = voltage / (K * RATIO) - LOAD / stiffness, INERTIA * (R + added) / (K * RATIO) ** 2
    stops = tau * math.log((16.0 - settles) / -settles)
    assert found.end == "standstill"
    assert found.t[-1] == pytest.approx(stops, rel=1e-8)
    assert found.theta[0, -1] == pytest.approx(settles * stops + 16.0 * tau, rel=1e-8)
    pulls = [str(verdict) for verdict in found.verdicts if "pulls back" in str(verdict)]
    assert len(pulls) == (voltage < 0)


def test_losses_of_the_gears_help_to_brake() -> None:
    """The braking moment passes them backwards: divided by the efficiency."""
    found = run('duration = 0.3\nbraking = { kind = "dynamic", resistance = "1.2 ohm" }', efficiency=EFFICIENCY)
    stiffness = (K * RATIO) ** 2 / (R + 1.2) / EFFICIENCY
    settles = -LOAD / stiffness
    exact = settles + (16.0 - settles) * np.exp(-found.t * stiffness / INERTIA)
    assert found.omega[0] == pytest.approx(exact, rel=1e-8)


def test_with_a_load_of_the_angle_an_inertia_of_the_angle_and_a_lag_against_dop853() -> None:
    table = "28\nreduced_inertia = { inertia = [6, 9, 19, 12, 7, 15, 20, 8] }"
    more = 'duration = 1\nbraking = { kind = "plugging", resistance = "2.8 ohm" }\nmotor_on = [[0, 0.4]]\n'
    found = run(more, "-60 + 150*sin(theta)", inertia=table, lag='time_constant = "30 ms"')
    from scipy.interpolate import CubicSpline

    points = np.array([6, 9, 19, 12, 7, 15, 20, 8, 6.0])
    curve = CubicSpline(np.arange(9) * math.pi / 4, points, bc_type="periodic")
    stiffness, backwards = (K * RATIO) ** 2 / (R + 2.8), -U / (K * RATIO)

    def rates(on: float):
        def f(t: float, y: np.ndarray) -> list[float]:
            theta, omega, motor = y
            place = theta % (2 * math.pi)
            moment = on * motor - 60 + 150 * math.sin(theta) - omega**2 / 2 * float(curve(place, 1))
            lag = (stiffness * (backwards - omega) - motor) / 0.03 if on else 0.0
            return [omega, moment / (INERTIA + float(curve(place))), lag]

        return f

    exact = solve_ivp(rates(1.0), (0, 0.4), [0.0, 16.0, 0.0], "DOP853", rtol=3e-14, atol=1e-12).y[:, -1]
    exact[2] = 0.0
    exact = solve_ivp(rates(0.0), (0.4, 1.0), exact, "DOP853", rtol=3e-14, atol=1e-12).y[:, -1]
    assert found.omega[0, -1] == pytest.approx(exact[1], rel=1e-7)
    assert found.theta[0, -1] == pytest.approx(exact[0], rel=1e-7)


def test_plugging_that_is_not_switched_off_turns_the_crank_back() -> None:
    found = run('standstill = "pass"\nduration = 3\nbraking = { kind = "plugging" }', "0")
    assert found.omega[0, -1] == pytest.approx(-U / (K * RATIO), rel=1e-6)
    assert [event.kind for event in found.events] == ["reversal"]


def test_the_ready_spec_from_its_steady_motion() -> None:
    """At the steady speed the motor gives the 60 N*m; each way to brake is faster than friction alone."""
    found = tmmcalc.run(load_spec(templates.folder() / "electric-braking.toml")).results["transient"].motions
    stiffness = (K * RATIO) ** 2 / R
    steady = U / (K * RATIO) - LOAD / stiffness
    assert all(motion.omega[0, 0] == pytest.approx(steady, rel=1e-9) for motion in found)
    alone, source, resistor, turned = found
    assert alone.t[-1] == pytest.approx(INERTIA * steady / LOAD, rel=1e-9)
    assert turned.t[-1] < resistor.t[-1] < alone.t[-1]
    assert source.omega[0, -1] == pytest.approx(110 / (K * RATIO) - LOAD * 1.52 / (K * RATIO) ** 2, rel=2e-4)


def test_what_the_motor_lacks() -> None:
    with pytest.raises(UsageError, match="the motor constant k is not given"):
        braking(Motor("m", 1e3, 100.0, kind="shunt", voltage=220.0, resistance=0.5), Braking("dynamic"))


@pytest.mark.parametrize(
    ("more", "change", "path", "message"),
    [
        (
            'braking = { kind = "dynamic" }\nmotor = "off"',
            ("", ""),
            "transients[0].braking",
            "a motor that is off does",
        ),
        (
            'braking = { kind = "dynamic", voltage = "9 V" }',
            ("", ""),
            "transients[0].braking.voltage",
            "only regenerative braking has a source",
        ),
        (
            'braking = { kind = "dynamic" }',
            ('constant = "1.38 V*s/rad"\n', 'no_load_speed = "1500 rpm"\n'),
            "transients[0].braking",
            "braking of a motor that is no shunt motor with voltage, resistance and constant",
        ),
        ("braking = { resistance = 2 }", ("", ""), "transients[0].braking.kind", "there are three ways to brake"),
        (
            'braking = { kind = "dynamic", resistance = -1 }',
            ("", ""),
            "transients[0].braking.resistance",
            "-1 is negative",
        ),
    ],
)
def test_faults(more: str, change: tuple[str, str], path: str, message: str) -> None:
    text = SPEC.format(more=more, moment="-60", efficiency=1, inertia="28", lag="").replace(*change)
    with pytest.raises(SpecError) as raised:
        parse_spec(text)
    (fault,) = [fault for fault in raised.value.faults if "braking" in fault.path]
    assert fault.path == path
    assert message in fault.message
