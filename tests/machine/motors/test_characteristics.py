"""Characteristics: points they pass through, slopes, electrical equations, reduction, floats and arrays alike."""

from __future__ import annotations

import math
import subprocess
import sys
from typing import Any

import numpy as np
import pytest
from scipy.interpolate import PchipInterpolator

from tmmcalc.core.errors import UsageError
from tmmcalc.machine.motors.characteristics import (
    Characteristic,
    ConstantMoment,
    kloss,
    parabolic,
    straight,
)
from tmmcalc.machine.motors.direct_current import series, shunt, voltage_drop
from tmmcalc.machine.motors.gearing import Reduced, reduced
from tmmcalc.machine.motors.model import Motor, characteristic, critical_slip
from tmmcalc.machine.motors.table import table

MOMENT, NOMINAL, SYNCHRONOUS, OVERLOAD = 49.3, 152.4, 157.08, 2.2
SLIP = 1 - NOMINAL / SYNCHRONOUS
CURVE = [(0.0, 90.0), (60.0, 75.0), (110.0, 118.0), (140.0, 100.0), (152.4, 49.3), (157.08, 0.0), (165.0, -60.0)]

CLOSED: list[Characteristic] = [
    parabolic(MOMENT, NOMINAL, SYNCHRONOUS),
    straight(MOMENT, NOMINAL, SYNCHRONOUS),
    kloss(OVERLOAD * MOMENT, critical_slip(OVERLOAD, SLIP), SYNCHRONOUS, NOMINAL),
    series(MOMENT, NOMINAL, 0.12),
    series(MOMENT, NOMINAL, 0.12, 0.3),
    series(MOMENT, NOMINAL, 0.12, 0.3)._replace(drop=0.9, way=-1.0, voltage=0.0, name="dynamic"),
    series(MOMENT, NOMINAL, 0.12, 0.3)._replace(drop=1.5, way=-1.0, name="plugging"),
    series(MOMENT, NOMINAL, 0.12)._replace(drop=2.5, way=-1.0, name="plugging"),
    shunt(220.0, 0.31, 1.33, NOMINAL),
    ConstantMoment(MOMENT),
]
POINTS: list[Characteristic] = [table(CURVE), table(CURVE, "pchip")]
SPEEDS = np.concatenate((np.linspace(0.0, 175.0, 71), [NOMINAL, SYNCHRONOUS]))


@pytest.mark.parametrize("motor", CLOSED, ids=lambda motor: f"{type(motor).__name__}-{motor.name}")
@pytest.mark.parametrize("efficiency", [1.0, 0.87])
def test_slopes_by_complex_step(motor: Any, efficiency: float) -> None:
    """Im M(omega + ih)/h is the derivative to rounding, no difference being taken."""
    seen = reduced(motor, 3.7)
    omega = SPEEDS / 3.7
    by_step = seen.moment(omega + 1e-30j).imag / 1e-30
    if efficiency < 1:
        factor = np.where(motor.moment(3.7 * omega) > 0, efficiency, 1 / efficiency)
        seen, by_step = reduced(motor, 3.7, efficiency), by_step * factor
    scale = np.max(np.abs(by_step)) + 1e-12
    np.testing.assert_allclose(seen.slope(omega), by_step, rtol=1e-12, atol=1e-13 * scale)


@pytest.mark.parametrize("motor", POINTS, ids=["linear", "pchip"])
def test_slopes_of_tables_by_central_differences(motor: Any) -> None:
    omega = np.array([-20.0, 13.0, 59.0, 61.0, 100.0, 125.0, 150.0, 155.0, 160.0, 190.0])
    by_difference = (motor.moment(omega + 1e-4) - motor.moment(omega - 1e-4)) / 2e-4
    np.testing.assert_allclose(motor.slope(omega), by_difference, rtol=1e-7, atol=1e-7)


@pytest.mark.parametrize(
    "motor", [*CLOSED, *POINTS, *(reduced(motor, 21.0, 0.9) for motor in CLOSED + POINTS)], ids=lambda m: m.name
)
def test_floats_and_arrays_agree(motor: Any) -> None:
    grid = SPEEDS[:70].reshape(7, 10)
    for f in (motor.moment, motor.slope):
        of_array = f(grid)
        assert of_array.shape == grid.shape
        singly = [f(float(omega)) for omega in grid.ravel()]
        assert all(isinstance(value, float) for value in singly)
        np.testing.assert_allclose(of_array.ravel(), singly, rtol=1e-15, atol=0)


def test_parabola_through_rated_and_synchronous_point() -> None:
    motor = parabolic(MOMENT, NOMINAL, SYNCHRONOUS)
    assert motor.moment(NOMINAL) == pytest.approx(MOMENT, rel=1e-13)
    assert motor.moment(SYNCHRONOUS) == 0.0
    assert (motor.least, motor.most) == (NOMINAL, SYNCHRONOUS)
    assert motor.a == pytest.approx(MOMENT * SYNCHRONOUS**2 / (SYNCHRONOUS**2 - NOMINAL**2), rel=1e-13)
    assert motor.b == pytest.approx(MOMENT / (SYNCHRONOUS**2 - NOMINAL**2), rel=1e-13)


def test_line_through_rated_and_synchronous_point() -> None:
    motor = straight(MOMENT, NOMINAL, SYNCHRONOUS)
    assert motor.moment(NOMINAL) == pytest.approx(MOMENT, rel=1e-14)
    assert motor.moment(SYNCHRONOUS) == 0.0
    assert motor.moment(motor.most) == pytest.approx(-MOMENT, rel=1e-13)


@pytest.mark.parametrize("overload", [1.001, 1.8, 2.2, 3.4, 20.0])
@pytest.mark.parametrize("nominal", [100.0, 140.0, 156.9])
def test_kloss_through_rated_point_with_its_maximum_at_the_critical_slip(overload: float, nominal: float) -> None:
    motor: Any = characteristic(Motor("m", MOMENT * nominal, nominal, SYNCHRONOUS, overload), "kloss")
    s_k = critical_slip(overload, 1 - nominal / SYNCHRONOUS)
    assert motor.moment(nominal) == pytest.approx(MOMENT, rel=1e-12)
    assert motor.moment(SYNCHRONOUS) == 0.0
    assert motor.critical == pytest.approx(SYNCHRONOUS * (1 - s_k), rel=1e-12, abs=1e-10)
    assert motor.moment(motor.critical) == pytest.approx(overload * MOMENT, rel=1e-14)
    assert motor.peak == pytest.approx(overload * MOMENT, rel=1e-14)
    assert motor.slope(motor.critical) == pytest.approx(0.0, abs=1e-12 * MOMENT / (SYNCHRONOUS - nominal))
    everywhere = motor.moment(np.linspace(-3 * SYNCHRONOUS, 4 * SYNCHRONOUS, 4001))
    assert np.max(np.abs(everywhere)) <= overload * MOMENT * (1 + 1e-14)


def test_kloss_is_the_quotient_form() -> None:
    """Against M = 2 M_K/(s_K/s + s/s_K) (textbook 3.66), where s is not 0."""
    s_k = critical_slip(OVERLOAD, SLIP)
    s = np.array([-2.0, -0.3, -1e-6, 1e-6, 0.02, 0.3, 1.0, 1.9])
    by_quotient = 2 * OVERLOAD * MOMENT / (s_k / s + s / s_k)
    found = kloss(OVERLOAD * MOMENT, s_k, SYNCHRONOUS).moment(SYNCHRONOUS * (1 - s))
    np.testing.assert_allclose(found, by_quotient, rtol=1e-9)


def test_series_motor_obeys_its_circuit() -> None:
    """U = R I + c I omega, M = c I^2, electrical power = heat + mechanical power, at every speed."""
    voltage, resistance, c, nominal = 220.0, 0.6, 0.045, 110.0
    current = voltage / (resistance + c * nominal)
    motor = series(c * current**2, nominal, current * resistance / voltage)
    omega = np.linspace(0.0, 600.0, 61)
    i = voltage / (resistance + c * omega)
    np.testing.assert_allclose(motor.moment(omega), c * i * i, rtol=1e-13)
    np.testing.assert_allclose(voltage * i, resistance * i * i + motor.moment(omega) * omega, rtol=1e-13)


def test_shunt_motor_obeys_its_circuit() -> None:
    voltage, resistance, k = 440.0, 0.8, 2.6
    motor = shunt(voltage, resistance, k)
    omega = np.linspace(-20.0, 260.0, 57)
    i = (voltage - k * omega) / resistance
    np.testing.assert_allclose(motor.moment(omega), k * i, rtol=1e-12, atol=1e-10)
    assert motor.synchronous == pytest.approx(voltage / k, rel=1e-15)
    assert motor.least is None
    assert motor.most is None


@pytest.mark.parametrize("share", [1e-9, 0.02, 0.3, 0.5])
def test_voltage_drop_from_power(share: float) -> None:
    voltage, resistance = 230.0, 1.7
    current = share * voltage / resistance
    power = (voltage - current * resistance) * current
    assert voltage_drop(voltage, resistance, power) == pytest.approx(share, rel=1e-12 if share < 0.5 else 1e-7)


def test_direct_current_motors_by_their_rated_data() -> None:
    by_speed = characteristic(Motor("s", 5000.0, 150.0, 165.0, kind="shunt"), "shunt")
    assert by_speed.moment(150.0) == pytest.approx(5000 / 150, rel=1e-14)
    assert by_speed.moment(165.0) == 0.0
    assert by_speed.least is None
    by_circuit = characteristic(
        Motor("s", 5000.0, 150.0, kind="shunt", voltage=220.0, resistance=0.5, constant=1.4), "shunt"
    )
    assert by_circuit.moment(150.0) == pytest.approx(1.4 * (220 - 1.4 * 150) / 0.5, rel=1e-13)
    by_efficiency = characteristic(Motor("c", 5000.0, 100.0, kind="series", efficiency=0.8), "series")
    by_resistance = characteristic(Motor("c", 5000.0, 100.0, kind="series", voltage=200.0, resistance=1.28), "series")
    assert by_efficiency.moment(100.0) == pytest.approx(50.0, rel=1e-14)
    # 5000 W = (200 - 1.28 I) I has I = 31.25 A, a drop of 0.2: the same motor as that of efficiency 0.8
    np.testing.assert_allclose(by_resistance.moment(SPEEDS), by_efficiency.moment(SPEEDS), rtol=1e-13)


@pytest.mark.parametrize("motor", CLOSED + POINTS, ids=lambda motor: f"{type(motor).__name__}-{motor.name}")
@pytest.mark.parametrize("efficiency", [1.0, 0.8])
def test_reduction_keeps_the_power_less_losses(motor: Any, efficiency: float) -> None:
    """Power of the input shaft is eta P of a driving motor, and P/eta of a braking one."""
    u = 26.45
    seen = reduced(motor, u, efficiency)
    omega = np.linspace(0.5, 7.5, 141)
    power = motor.moment(u * omega) * u * omega
    expected = np.where(power > 0, efficiency * power, power / efficiency)
    np.testing.assert_allclose(seen.moment(omega) * omega, expected, rtol=1e-11, atol=1e-12 * np.max(np.abs(power)))
    for name in ("synchronous", "nominal", "critical", "least", "most"):
        before, after = getattr(motor, name), getattr(seen, name)
        assert (after is None) if before is None else after == pytest.approx(before / u, rel=1e-15)
    assert seen.name == motor.name


@pytest.mark.parametrize("motor", CLOSED, ids=lambda motor: f"{type(motor).__name__}-{motor.name}")
def test_closed_forms_stay_closed_and_equal_the_general_reduction(motor: Any) -> None:
    closed = reduced(motor, 12.5)
    general = Reduced(motor, 12.5, 12.5, 0.0, None, None, None, None, None, "")
    assert type(closed) is type(motor)
    omega = SPEEDS / 12.5
    size = np.max(np.abs(general.moment(omega))) + 1e-12
    np.testing.assert_allclose(closed.moment(omega), general.moment(omega), rtol=1e-11, atol=1e-13 * size)
    np.testing.assert_allclose(closed.slope(omega), general.slope(omega), rtol=1e-11, atol=1e-13 * size)


def test_tables_pass_through_their_points_and_go_on_straight() -> None:
    speeds, moments = map(np.array, zip(*CURVE, strict=True))
    inside = np.linspace(0.0, 165.0, 331)
    linear, smooth = table(CURVE), table(CURVE, "pchip", NOMINAL)
    np.testing.assert_allclose(linear.moment(inside), np.interp(inside, speeds, moments), rtol=1e-13, atol=1e-12)
    reference = PchipInterpolator(speeds, moments)
    np.testing.assert_allclose(smooth.moment(inside), reference(inside), rtol=1e-13, atol=1e-12)
    for motor, low, high in (
        (linear, -15 / 60, -60 / 7.92),
        (smooth, float(reference(0.0, 1)), float(reference(165.0, 1))),
    ):
        assert motor.moment(-40.0) == pytest.approx(90 - 40 * low, rel=1e-13)
        assert motor.moment(200.0) == pytest.approx(-60 + 35 * high, rel=1e-13)
        assert motor.synchronous == pytest.approx(157.08, rel=1e-15)
        assert motor.critical == 110.0
        assert (motor.least, motor.most) == (0.0, 165.0)
    assert smooth.nominal == NOMINAL


def test_no_load_speed_of_a_table_between_points() -> None:
    assert table([(0.0, 8.0), (10.0, 4.0), (14.0, -4.0)]).synchronous == pytest.approx(12.0, rel=1e-15)
    assert table([(0.0, 8.0), (10.0, 4.0)]).synchronous is None
    assert table([(0.0, 8.0), (10.0, 4.0)]).critical is None
    smooth = table([(0.0, 8.0), (10.0, 4.0), (14.0, -4.0)], "pchip")
    assert smooth.synchronous is not None
    assert smooth.moment(smooth.synchronous) == pytest.approx(0.0, abs=1e-13)


@pytest.mark.parametrize(
    ("points", "says"),
    [
        ([], "0 points"),
        ([(0.0, 1.0)], "1 point of"),
        ([(0.0, 1.0), (5.0, 2.0), (5.0, 3.0)], "point 3 at 5"),
        ([(0.0, 1.0), (-1.0, 2.0)], "point 2 at -1"),
        ([(0.0, 1.0), (math.nan, 2.0)], "point 2"),
    ],
)
def test_faults_of_tables(points: list[tuple[float, float]], says: str) -> None:
    with pytest.raises(UsageError, match=says):
        table(points)


def test_unknown_interpolation() -> None:
    with pytest.raises(UsageError, match="spline") as error:
        table(CURVE, "spline")
    assert "pchip" in error.value.remedy


@pytest.mark.parametrize(
    "make",
    [
        lambda: parabolic(10.0, 150.0, 150.0),
        lambda: parabolic(10.0, 151.0, 150.0),
        lambda: straight(10.0, 0.0, 150.0),
        lambda: straight(10.0, 100.0, math.inf),
        lambda: kloss(10.0, 0.0, 150.0),
        lambda: kloss(10.0, 0.2, math.nan),
        lambda: shunt(220.0, -1.0, 1.0),
        lambda: series(10.0, 100.0, 1.0),
        lambda: series(10.0, 100.0, 0.0),
        lambda: voltage_drop(100.0, 1.0, 2501.0),
        lambda: reduced(ConstantMoment(1.0), 0.0),
        lambda: reduced(ConstantMoment(1.0), -3.0),
        lambda: reduced(ConstantMoment(1.0), 2.0, 1.01),
        lambda: reduced(ConstantMoment(1.0), 2.0, 0.0),
        lambda: critical_slip(1.0, 0.05),
        lambda: critical_slip(2.0, 0.0),
    ],
)
def test_impossible_constants_are_refused(make: Any) -> None:
    with pytest.raises(UsageError) as error:
        make()
    assert error.value.where


def test_the_forms_import_neither_csv_nor_scipy() -> None:
    heavy = ("csv", "scipy", "importlib.resources", "difflib", "pydantic")
    code = (
        "import sys, tmmcalc.machine.motors.characteristics, tmmcalc.machine.motors.gearing, "
        f"tmmcalc.machine.motors.model; print(*[m for m in {heavy} if m in sys.modules])"
    )
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert run.stdout.split() == []
