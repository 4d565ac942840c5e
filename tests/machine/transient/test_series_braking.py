"""Braking of a series machine: its circuit with inductance beside it, where its heat goes, when it excites itself."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.interpolate import PchipInterpolator
from scipy.optimize import brentq

import tmmcalc
from tests.machine.transient.test_braking import SPEC as SHUNT
from tmmcalc.core.errors import NoSolutionError, SpecError, UsageError
from tmmcalc.machine.motors.braking import Braking, braking, critical_speed
from tmmcalc.machine.motors.model import Motor
from tmmcalc.machine.transient.timed import TimedMotion
from tmmcalc.project import load_spec, parse_spec, templates

CASES = Path(__file__).parents[2] / "cases" / "dynamics.json"
U, R, RATIO, LOAD = 220.0, 0.85, 15.0, 300.0
RATED, POWER, SATURATION, FIELD = 30 * math.pi, 5500.0, 0.3, 0.3
INERTIA = 900.0 + 0.32 * RATIO**2 + 2.0
CURRENT = (U - math.sqrt(U * U - 4 * R * POWER)) / (2 * R)  # of the power (U - I R) I at the rated point
SPEC = """
[torque]
speed = "60 rpm"
formula = "{load}"
inertia = 900
[motor]
kind = "series"
power = 5500
speed = "900 rpm"
voltage = "220 V"
resistance = "0.85 ohm"
field_resistance = "0.3 ohm"
inertia = 0.32
{motor}
[transmission]
ratio = 15
efficiency = {efficiency}
inertia = 2
[[transients]]
name = "braking"
start_speed = "6.4 rad/s"
{more}
"""


def run(more: str, load: float = -LOAD, motor: str = "saturation = 0.3", efficiency: float = 1.0) -> TimedMotion:
    spec = parse_spec(SPEC.format(more=more, load=load, motor=motor, efficiency=efficiency))
    (found,) = tmmcalc.run(spec).results["transient"].motions
    return found


def flux(current: Any, saturation: float = SATURATION) -> Any:
    """E over omega by Froehlich's curve through the rated point [V*s/rad]."""
    bend = saturation / (1 - saturation)
    slope = (U - CURRENT * R) / (CURRENT * RATED) * (1 + bend)
    return slope * current / (1 + bend * current / CURRENT)


def motor(saturation: float = SATURATION) -> Motor:
    return Motor("m", POWER, RATED, kind="series", voltage=U, resistance=R, saturation=saturation, field_resistance=0.3)


def moment(current: Any, saturation: float = SATURATION) -> Any:
    return flux(current, saturation) * current


@pytest.mark.parametrize("saturation", [0.0, 0.05, 0.3, 0.7])
@pytest.mark.parametrize("omega", [0.0, 40.0, 94.0, 700.0])
def test_the_machine_that_drives_obeys_its_circuit(saturation: float, omega: float) -> None:
    from tmmcalc.machine.motors.model import characteristic

    current = brentq(lambda i: U - i * R - flux(i, saturation) * omega, 0.0, 1.01 * U / R, xtol=1e-13, rtol=1e-14)
    found = characteristic(motor(saturation), "series")
    assert found.moment(omega) == pytest.approx(moment(current, saturation), rel=1e-11)
    assert found.moment(RATED) == pytest.approx(POWER / RATED, rel=1e-13)


@pytest.mark.parametrize("saturation", [0.0, 1e-9, 0.05, 0.3, 0.7])
@pytest.mark.parametrize("added", [11.0, 30.0])
def test_plugging_obeys_its_circuit(saturation: float, added: float) -> None:
    """U + E = I (R + R_a), with the flux in its sense also after the machine has turned back."""
    curve = braking(motor(saturation), Braking("plugging", resistance=added))
    for omega in (-90.0, 0.0, 30.0, 60.0, 90.0):
        current = brentq(
            lambda i, w=omega: U + flux(i, saturation) * w - i * (R + added), 0.0, 1e4, xtol=1e-12, rtol=1e-14
        )
        assert curve.moment(omega) == pytest.approx(-moment(current, saturation), rel=1e-10)


@pytest.mark.parametrize("added", [0.0, 4.5, 12.0])
def test_the_current_that_excites_itself_is_that_of_its_circuit(added: float) -> None:
    """E = I (R + R_a), at the speeds where the tangent of the magnetisation curve at no current is steeper."""
    curve = braking(motor(), Braking("dynamic", resistance=added))
    critical = (R + added) / (flux(1e-9) / 1e-9)
    assert critical_speed(curve) == pytest.approx(critical, rel=1e-8)
    for part in (-1.0, 0.0, 0.5, 0.999):
        assert curve.moment(part * critical) == 0.0
    for part in (1.01, 1.5, 4.0):
        omega = part * critical
        current = brentq(lambda i, w=omega: flux(i) * w - i * (R + added), 1e-6, 1e6, xtol=1e-12, rtol=1e-14)
        assert curve.moment(omega) == pytest.approx(-moment(current), rel=1e-9)
        # all that the shaft gives becomes heat of the circuit
        assert -curve.moment(omega) * omega == pytest.approx((R + added) * current**2, rel=1e-9)


def test_the_case_worked_by_hand() -> None:
    case = next(case for case in json.loads(CASES.read_text()) if case["id"] == "dyn-series-braking")
    given, expected, tolerance = case["inputs"], case["expected"], case["tolerance"]["rel"]
    own = {"voltage": given["U"], "resistance": given["R"], "saturation": given["saturation"]}
    machine = Motor("m", given["P"], given["omega_N"], kind="series", **own)
    excited, turned, apart = given["self_excited"], given["plugging"], given["field_apart"]
    curve = braking(machine, Braking("dynamic", excited["R_a"]))
    assert critical_speed(curve) == pytest.approx(expected["omega_critical"], rel=tolerance)
    assert curve.moment(excited["omega"]) == pytest.approx(expected["M_self_excited"], rel=tolerance)
    assert curve.moment(0.99 * expected["omega_critical"]) == expected["M_self_excited_below"]
    found = braking(machine, Braking("plugging", turned["R_a"])).moment(turned["omega"])
    assert found == pytest.approx(expected["M_plugging"], rel=tolerance)
    found = braking(machine, Braking("dynamic", apart["R_a"], field=apart["field"])).moment(apart["omega"])
    assert found == pytest.approx(expected["M_field_apart"], rel=tolerance)


WAYS = [
    ('kind = "dynamic", resistance = "4.5 ohm"', 0.0, 4.5, None),
    ('kind = "plugging", resistance = "10 ohm"', U, 10.0, None),
    ('kind = "dynamic", resistance = "4 ohm", field = 0.8', 0.0, 4.0, 0.8),
    ('kind = "plugging", resistance = "10 ohm", field = 1', U, 10.0, 1.0),
]


@pytest.mark.parametrize(("keys", "source", "added", "field"), WAYS)
def test_the_motion_is_that_of_a_circuit_whose_inductance_vanishes(
    keys: str, source: float, added: float, field: float | None
) -> None:
    """L dI/dt = V + k(I) omega - I R and J domega/dt = -k(I) I - M_F: the difference falls with L, to nothing."""
    found = run(f"duration = 3\nbraking = {{ {keys} }}")
    resistance = R + added if field is None else R - FIELD + added

    def k(current: float) -> float:
        return float(flux(current)) if field is None else float(flux(field * CURRENT))

    def off(inductance: float) -> float:
        def rates(_: float, y: np.ndarray) -> list[float]:
            omega, current = float(y[0]), float(y[1])
            emf = k(current) * omega * RATIO
            return [
                (-k(current) * current * RATIO - LOAD) / INERTIA,
                (source + emf - resistance * current) / inductance,
                resistance * current**2,
                source * current,
                omega,
            ]

        def voltage(current: float) -> float:
            return source + k(current) * 6.4 * RATIO - resistance * current

        begin = [6.4, brentq(voltage, 1e-3, 1e5, xtol=1e-12), 0.0, 0.0, 0.0]
        there = solve_ivp(rates, (0.0, 3.0), begin, "Radau", found.t, rtol=1e-9, atol=1e-9)
        omega, heat, taken, angle = there.y[[0, 2, 3, 4], -1]
        # kinetic energy and what the source gives become heat of the circuit and work against friction
        kinetic = INERTIA * (6.4**2 - omega**2) / 2 + inductance * (begin[1] ** 2 - there.y[1, -1] ** 2) / 2
        assert heat + LOAD * angle == pytest.approx(kinetic + taken, rel=1e-6)
        return float(np.abs(there.y[0] - found.omega[0]).max())

    large, small = off(2e-2), off(2e-3)
    assert small < 0.13 * large
    assert small < 2e-3
    # and by the motion itself: what the motor takes off is heat less what the source gives
    assert found.motor_work[-1] + found.load_work[-1] == pytest.approx(
        INERTIA * (found.omega[0, -1] ** 2 - 6.4**2) / 2, rel=1e-8
    )


def test_kinetic_energy_becomes_heat_and_friction() -> None:
    """The work of the motor on a resistor alone is the heat -int (R + R_a) I^2 dt with I of the circuit."""
    found = run('braking = { kind = "dynamic", resistance = "4.5 ohm" }')
    assert found.end == "standstill"
    bend = SATURATION / (1 - SATURATION)
    slope = flux(1e-9) / 1e-9
    resistance = R + 4.5
    excess = np.maximum(slope * found.omega[0] * RATIO / resistance - 1, 0)
    heat = float(PchipInterpolator(found.t, resistance * (CURRENT * excess / bend) ** 2).integrate(0.0, found.t[-1]))
    assert -found.motor_work[-1] == pytest.approx(heat, rel=1e-4)
    assert heat + LOAD * found.theta[0, -1] == pytest.approx(INERTIA * 6.4**2 / 2, rel=1e-4)


def test_below_the_critical_speed_nothing_but_the_load_brakes() -> None:
    found = run('braking = { kind = "dynamic", resistance = "4.5 ohm" }')
    critical = (R + 4.5) / (flux(1e-9) / 1e-9) / RATIO
    slow = found.omega[0] < critical * (1 - 1e-9)
    assert slow.any()
    assert not found.motor_moment[slow].any()
    assert (found.motor_moment[found.omega[0] > critical * 1.01] < 0).all()
    note = next(verdict for verdict in found.verdicts if "excites itself" in verdict.message)
    assert note.severity == "note"
    assert (note.value, note.limit) == (pytest.approx(5.35), pytest.approx(5.35 * 6.4 / critical, rel=1e-8))


def test_too_much_resistance_excites_nothing() -> None:
    found = run('braking = { kind = "dynamic", resistance = "20 ohm" }')
    assert not found.motor_moment.any()
    assert found.t[-1] == pytest.approx(INERTIA * 6.4 / LOAD, rel=1e-9)
    warning = found.verdicts[0]
    assert warning.severity == "warning"
    assert "does not excite itself" in warning.message
    assert warning.value == pytest.approx(20.85)
    assert warning.limit is not None
    assert warning.limit < 20.85
    assert f"{warning.limit:.5g}" in warning.message


def test_the_critical_resistance_is_that_of_the_speed_at_which_the_motor_is_switched() -> None:
    found = run('motor_on = [["2 s", "60 s"]]\nbraking = { kind = "dynamic", resistance = "4.5 ohm" }')
    note = next(verdict for verdict in found.verdicts if "excites itself" in verdict.message)
    speed = (6.4 - LOAD / INERTIA * 2.0) * RATIO
    assert note.limit == pytest.approx(flux(1e-9) / 1e-9 * speed, rel=1e-7)


def test_plugging_turns_the_crank_back_where_it_may() -> None:
    more = 'standstill = "pass"\nduration = 12\nbraking = { kind = "plugging", resistance = "10 ohm" }'
    found = run(more)
    assert found.omega[0, -1] < -1
    curve = braking(motor(), Braking("plugging", resistance=10.0))
    expected = np.array([RATIO * curve.moment(RATIO * w) for w in found.omega[0].tolist()])
    np.testing.assert_allclose(found.motor_moment, expected, rtol=1e-12)


def test_plugging_without_saturation_needs_more_than_the_critical_resistance() -> None:
    """U + c I omega = I (R + R_a) has an answer for c omega < R + R_a alone."""
    critical = (U - CURRENT * R) / (CURRENT * RATED) * 6.4 * RATIO
    enough, little = (f'braking = {{ kind = "plugging", resistance = {critical - R + off} }}' for off in (0.2, -0.2))
    assert run(enough, motor="").end == "standstill"
    with pytest.raises(NoSolutionError, match="has no limit") as raised:
        run(little, motor="")
    assert raised.value.limit == pytest.approx(critical, rel=1e-12)
    assert raised.value.value == pytest.approx(critical - 0.2, rel=1e-12)


@pytest.mark.parametrize("efficiency", [1.0, 0.9])
@pytest.mark.parametrize("method", ["merson", "collocation"])
def test_plugging_beyond_the_pole_when_the_motor_is_switched_on_late(efficiency: float, method: str) -> None:
    """Alone the load slows the crank evenly; at 2 s the circuit has an answer above the critical resistance alone."""
    speed = 6.4 - LOAD / INERTIA * 2.0
    critical = (U - CURRENT * R) / (CURRENT * RATED) * speed * RATIO
    late = f'method = "{method}"\nduration = 20\nmotor_on = [["2 s", "60 s"]]\n'
    enough, little = (
        f'{late}braking = {{ kind = "plugging", resistance = {critical - R + off} }}' for off in (0.05, -0.05)
    )
    assert run(enough, motor="", efficiency=efficiency).end == "standstill"
    with pytest.raises(NoSolutionError, match="scenario braking: the motor is switched on at t = 2 s") as raised:
        run(little, motor="", efficiency=efficiency)
    assert raised.value.value == pytest.approx(speed, rel=1e-9)
    assert raised.value.limit == pytest.approx(speed * (critical - 0.05) / critical, rel=1e-12)
    assert f"more than {critical / (critical - 0.05):.5g} times" in raised.value.remedy


def test_a_field_apart_is_a_shunt_machine() -> None:
    """The same line as a shunt machine with the flux of that field, regenerating or not."""
    k = float(flux(0.8 * CURRENT))
    same = Motor("s", POWER, RATED, kind="shunt", voltage=U, resistance=R - FIELD, constant=k)
    for how in (Braking("regenerative", 1.5, 110.0), Braking("dynamic", 4.0), Braking("plugging", 10.0)):
        mine = braking(motor(), Braking(how.kind, how.resistance, how.voltage, field=0.8))
        for omega in (-20.0, 0.0, 50.0, 120.0):
            assert mine.moment(omega) == pytest.approx(braking(same, how).moment(omega), rel=1e-12, abs=1e-12)


@pytest.mark.parametrize(
    ("how", "says"),
    [(Braking("regenerative"), "cannot feed a source"), (Braking("dynamic"), "nothing that limits the current")],
)
def test_what_a_series_machine_cannot(how: Braking, says: str) -> None:
    with pytest.raises(UsageError, match=says):
        braking(motor(0.0), how)


def test_the_ready_spec() -> None:
    """Every motion ends as it should, and slower than the one before only where less brakes."""
    found = tmmcalc.run(load_spec(templates.folder() / "series-braking.toml")).results["transient"].motions
    alone, excited, apart, turned, source = found
    assert [motion.end for motion in found] == ["standstill"] * 4 + ["time"]
    assert turned.t[-1] < apart.t[-1] < excited.t[-1] < alone.t[-1]
    assert source.omega[0, -1] > 0


BRAKING = 'braking = { kind = "dynamic", resistance = "4.5 ohm" }'


@pytest.mark.parametrize(
    ("more", "change", "path", "message"),
    [
        ('braking = { kind = "regenerative" }', ("", ""), "transients[0].braking.kind", "cannot feed a source"),
        (BRAKING, ("saturation = 0.3", ""), "transients[0].braking.kind", "nothing limits the current"),
        (BRAKING, ("saturation = 0.3", "saturation = 1"), "motor.saturation", "below 1"),
        (BRAKING, ('voltage = "220 V"', "efficiency = 0.9"), "transients[0].braking", "braking of a motor that is no"),
        (BRAKING, ('"0.3 ohm"', '"0.85 ohm"'), "motor.field_resistance", "is not below resistance"),
        (BRAKING.replace("}", ", field = 0 }"), ("", ""), "transients[0].braking.field", "above 0"),
    ],
)
def test_faults(more: str, change: tuple[str, str], path: str, message: str) -> None:
    text = SPEC.format(more=more, load=-300, motor="saturation = 0.3", efficiency=1).replace(*change)
    with pytest.raises(SpecError) as raised:
        parse_spec(text)
    assert any(fault.path == path and message in fault.message for fault in raised.value.faults)


def test_the_field_of_a_shunt_machine_is_apart_already() -> None:
    text = SHUNT.format(
        more='braking = { kind = "dynamic", field = 1 }', moment="-60", efficiency=1, inertia="28", lag=""
    )
    with pytest.raises(SpecError, match="already"):
        parse_spec(text)
