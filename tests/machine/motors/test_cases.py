"""Worked cases of the textbook and closed forms: motor data, run-up with the form of Kloss, lag of the motor."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.integrate import quad, solve_ivp

from tmmcalc.machine.motors.characteristics import Characteristic, kloss
from tmmcalc.machine.motors.gearing import reduced
from tmmcalc.machine.motors.model import Motor, characteristic, electromagnetic_time_constant, gd2

CASES = {
    case["id"]: case
    for case in json.loads((Path(__file__).parents[2] / "cases" / "dynamics.json").read_text(encoding="utf-8"))
}
RPM = math.pi / 30


def rated(inputs: dict[str, Any]) -> Motor:
    return Motor(
        "of the case",
        inputs["P_N_W"],
        inputs["n_N_rpm"] * RPM,
        inputs["n_sync_rpm"] * RPM,
        inputs.get("K_overload", inputs.get("K")),
    )


def test_kloss_of_the_textbook_motor() -> None:
    case = CASES["dyn-motor-kloss"]
    expected, rel = case["expected"], case["tolerance"]["rel"]
    motor = rated(case["inputs"])
    assert motor.nominal_moment == pytest.approx(expected["M_N_shaft_Nm"], rel=rel)
    assert motor.nominal_slip == pytest.approx(expected["s_N"], rel=rel)
    assert motor.critical_slip == pytest.approx(expected["s_K"], rel=1e-6)
    slips = np.array(expected["M_over_MN"]["s"])
    assert motor.synchronous is not None
    moments = characteristic(motor, "kloss").moment(motor.synchronous * (1 - slips))
    np.testing.assert_allclose(moments / motor.nominal_moment, expected["M_over_MN"]["ratio"], rtol=rel, atol=1e-12)


def test_flywheel_effect() -> None:
    case = CASES["dyn-gd2"]
    assert gd2(case["inputs"]["GD2_kgf_m2"]) == pytest.approx(case["expected"]["J_kg_m2"], rel=1e-15)


def test_constants_of_the_shaper_parabola() -> None:
    """A and B of the input shaft as the recurrence of the textbook uses them."""
    case = CASES["dyn-shaper-motion-idle"]
    inputs, expected = case["inputs"], case["expected"]
    motor = rated(inputs)
    parabola = reduced(characteristic(motor, "parabolic"), inputs["u_R"])
    assert parabola.a == pytest.approx(expected["A"], rel=1e-6)
    assert parabola.b == pytest.approx(expected["B"], rel=1e-6)
    assert parabola.nominal == pytest.approx(expected["omega_N"], rel=1e-7)
    assert parabola.synchronous == pytest.approx(expected["omega_sync"], rel=1e-7)
    assert parabola.moment(parabola.nominal) == pytest.approx(expected["M_N_Nm"], rel=1e-7)


def test_constants_of_the_upsetter_parabola() -> None:
    """The constants that the closed case of the parabola was worked with are those of the upsetter's motor."""
    inputs, closed = CASES["dyn-upsetter-regime-30"]["inputs"], CASES["dyn-closed-parabola-const"]["inputs"]
    motor = rated(inputs)
    parabola = reduced(characteristic(motor, "parabolic"), motor.speed / inputs["omega_N"])
    assert parabola.a == pytest.approx(closed["A"], rel=1e-9)
    assert parabola.b == pytest.approx(closed["B"], rel=1e-9)


@pytest.mark.parametrize("kind", ["parabolic", "linear", "kloss"])
def test_upsetter_characteristics_share_two_points(kind: Any) -> None:
    inputs = CASES["dyn-upsetter-regime-30"]["inputs"]
    motor = rated(inputs)
    on_crank = reduced(characteristic(motor, kind), motor.speed / inputs["omega_N"])
    assert on_crank.nominal == pytest.approx(inputs["omega_N"], rel=1e-15)
    assert on_crank.synchronous == pytest.approx(inputs["omega_sync"], rel=1e-9)
    assert on_crank.moment(10.0) == pytest.approx(1100 / 10.0, rel=1e-14)
    assert on_crank.moment(on_crank.synchronous) == pytest.approx(0.0, abs=1e-12)


def test_run_up_of_a_constant_inertia() -> None:
    """Time by quadrature of J/M(omega) against the closed form of the case."""
    case = CASES["dyn-closed-kloss-startup"]
    inputs = case["inputs"]
    motor = kloss(inputs["M_K"], inputs["s_K"], inputs["omega_sync"])
    for omega, t in zip(case["expected"]["omega"], case["expected"]["t"], strict=True):
        found = quad(lambda w: inputs["J"] / motor.moment(w), 0, omega, epsabs=0, epsrel=1e-12)[0]
        assert found == pytest.approx(t, rel=case["tolerance"]["rel"])


def test_run_up_of_the_upsetter() -> None:
    """The case's run-up in time, integrated with the characteristic of this room."""
    case = CASES["dyn-upsetter-startup"]
    inputs, expected = case["inputs"], case["expected"]
    crank, rod = inputs["l1"], inputs["l1"] * inputs["l2_over_l1"]
    motor = kloss(inputs["K"] * inputs["P_N_W"] / inputs["omega_N"], inputs["s_K"], inputs["omega_sync"])

    def rates(_: float, state: np.ndarray) -> list[float]:
        omega, phi = state
        sine, cosine = math.sin(phi), math.cos(phi)
        y, root = crank * sine, math.sqrt(rod**2 - (crank * sine) ** 2)
        first = -y - y * crank * cosine / root
        second = -crank * cosine - crank**2 * (cosine**2 - sine**2) / root - (y * crank * cosine) ** 2 / root**3
        inertia = inputs["J_c"] + inputs["m3"] * first**2
        moment = motor.moment(omega) - inputs["G3"] * first - omega**2 * inputs["m3"] * first * second
        return [moment / inertia, omega]

    times = expected["omega_at_t"]["t"]
    run = solve_ivp(rates, (0.0, 3.0), [0.0, 0.0], "DOP853", times, rtol=1e-10, atol=1e-12)
    np.testing.assert_allclose(run.y[0], expected["omega_at_t"]["omega"], rtol=1e-5)
    np.testing.assert_allclose(run.y[1], expected["omega_at_t"]["phi"], rtol=1e-5)


def test_time_constant_of_the_lagging_motor() -> None:
    """The lag of the case is that of the textbook motor, to its three figures."""
    motor = rated(CASES["dyn-motor-kloss"]["inputs"])
    tau = electromagnetic_time_constant(motor.critical_slip, 50.0)
    assert tau == pytest.approx(CASES["dyn-ext-motor-lag"]["inputs"]["tau_e"], abs=5e-5)


def test_stiffness_of_the_lagging_motor() -> None:
    """b = M_N/(omega_c - omega_N) of the upsetter's straight line on the crank, as the case has it."""
    inputs = CASES["dyn-upsetter-regime-30"]["inputs"]
    motor = rated(inputs)
    line: Characteristic = reduced(characteristic(motor, "linear"), motor.speed / inputs["omega_N"])
    assert -line.slope(10.2) == pytest.approx(CASES["dyn-ext-motor-lag"]["inputs"]["b"], rel=1e-12)
