"""Contradictions among the data of a motor, from the equations of its circuit."""

from __future__ import annotations

from dataclasses import replace

import pytest

from tmmcalc.machine.motors.model import Motor
from tmmcalc.machine.motors.plausibility import contradictions, curve_of

U, R, K = 220.0, 0.5, 1.375
SHUNT = Motor("m", 1.0, 150.0, kind="shunt", voltage=U, resistance=R, constant=K)
RATED = K * (U - K * 150.0) / R  # N*m at 150 rad/s


@pytest.mark.parametrize(("factor", "told"), [(1.0, False), (1.04, False), (0.96, False), (1.06, True), (0.9, True)])
def test_the_rated_point_of_a_shunt_motor(factor: float, told: bool) -> None:
    found = contradictions(replace(SHUNT, power=factor * RATED * 150.0), "shunt")
    assert bool(found) is told
    assert all(f"({100 * (1 / factor - 1):+.3g} %)" in text for text in found)


def test_two_speeds_without_load() -> None:
    motor = replace(SHUNT, power=RATED * 150.0)
    assert contradictions(replace(motor, synchronous=161.0), "shunt") == ()
    (found,) = contradictions(replace(motor, synchronous=180.0), "shunt")
    assert found.text == "U/k gives no load at 1527.89 rpm, and not at the 1718.87 rpm given"


def test_more_heat_than_losses() -> None:
    """I = 50 A at 200 V and 1 ohm: 7.5 kW out of 10, so that no efficiency above 0.75 is possible."""
    motor = Motor("m", 7500.0, 100.0, kind="series", voltage=200.0, resistance=1.0)
    assert contradictions(motor, "series") == ()
    assert contradictions(replace(motor, efficiency=0.72), "series") == ()
    (found,) = contradictions(replace(motor, efficiency=0.85), "series")
    assert found.text.startswith("its windings lose 25 % of the rated input")


def test_a_curve_by_points_away_from_the_rated_point() -> None:
    points = ((0.0, 80.0), (140.0, 40.0), (157.0, 0.0))
    motor = Motor("m", 40.0 * 140.0, 140.0, points=points, interpolation="linear")
    assert contradictions(motor, "table") == ()
    (found,) = contradictions(replace(motor, power=50.0 * 140.0), "table")
    assert "gives 40 N*m, the rated power asks for 50 N*m (-20 %)" in found
    (beyond,) = contradictions(replace(motor, speed=160.0), "table")
    assert beyond.endswith("at the rated speed it gives nothing")


def test_forms_through_the_rated_point_are_not_asked() -> None:
    assert contradictions(Motor("m", 1100.0, 146.6, 157.08, 2.2), "kloss") == ()
    assert curve_of(Motor("m", 1100.0, 146.6, 157.08, 2.2), "kloss") is None


def test_ends_of_the_curve() -> None:
    """A series motor at standstill: k I^2 with I = U/R against I_N^2 at the rated point."""
    motor = Motor("m", 7500.0, 100.0, kind="series", voltage=200.0, resistance=1.0)
    curve = curve_of(motor, "series")
    assert curve is not None
    assert curve.no_load is None
    assert curve.stall == pytest.approx(75.0 * (200.0 / 50.0) ** 2, rel=1e-12)
