"""Rated data of motors: what is refused, and what is missing for a characteristic."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from tmmcalc.core.errors import UsageError
from tmmcalc.machine.motors.model import Motor, characteristic, electromagnetic_time_constant, with_lag

GOOD: dict[str, Any] = {"name": "X", "power": 7500.0, "speed": 152.0, "synchronous": 157.08, "overload": 2.2}


@pytest.mark.parametrize(
    ("wrong", "says"),
    [
        ({"power": 0.0}, "power is 0"),
        ({"power": math.nan}, "power"),
        ({"speed": -1.0}, "speed is -1"),
        ({"synchronous": 152.0}, "not below the synchronous"),
        ({"synchronous": 140.0}, "not below the synchronous"),
        ({"overload": 1.0}, "overload ratio"),
        ({"inertia": -0.1}, "inertia"),
        ({"time_constant": -1e-3}, "time_constant"),
        ({"start": 0.0}, "start"),
        ({"efficiency": 1.0}, "efficiency"),
        ({"kind": "steam"}, "steam"),
    ],
)
def test_impossible_data_are_refused(wrong: dict[str, Any], says: str) -> None:
    with pytest.raises(UsageError, match=says) as error:
        Motor(**{**GOOD, **wrong})
    assert error.value.where == "motor X"


@pytest.mark.parametrize(
    ("lacking", "kind", "says"),
    [
        ({"overload": None}, "kloss", "overload ratio K = M_K/M_N is not given"),
        ({"synchronous": None}, "parabolic", "synchronous .* is not given"),
        ({"synchronous": None}, "linear", "synchronous .* is not given"),
        ({}, "shunt", "kind 'induction' has no characteristic 'shunt'"),
        ({"kind": "shunt", "synchronous": None}, "shunt", "no-load"),
        ({"kind": "shunt", "voltage": 220.0, "resistance": 0.5}, "shunt", "constant k is not given"),
        ({"kind": "shunt", "voltage": 220.0, "resistance": 0.5, "constant": 1.5}, "shunt", "no-load speed U/k"),
        ({"kind": "series"}, "series", "efficiency is not given"),
        ({"kind": "series", "voltage": 220.0}, "series", "resistance R is not given"),
        ({"kind": "series", "voltage": 220.0, "resistance": 9.0}, "series", "cannot pass"),
        ({"kind": "series"}, "kloss", "kind 'series'"),
        ({}, "table", "0 points"),
        ({}, "sinus", "no characteristic 'sinus'"),
    ],
)
def test_missing_data_are_named(lacking: dict[str, Any], kind: Any, says: str) -> None:
    with pytest.raises(UsageError, match=says) as error:
        characteristic(Motor(**{**GOOD, **lacking}), kind)
    assert error.value.remedy


def test_every_kind_passes_the_rated_point() -> None:
    points = ((0.0, 80.0), (152.0, 7500 / 152), (157.08, 0.0))
    motor = Motor(**GOOD, points=points)
    for kind in ("parabolic", "linear", "kloss", "constant", "table"):
        made = characteristic(motor, kind)
        assert made.moment(152.0) == pytest.approx(7500 / 152, rel=1e-12)
        assert made.nominal == 152.0
        assert made.name == kind


def test_the_branches_know_where_the_motor_breaks_down() -> None:
    motor = Motor(**GOOD)
    of_kloss = characteristic(motor, "kloss").critical
    assert of_kloss is not None
    assert characteristic(motor, "parabolic").critical == pytest.approx(of_kloss, rel=1e-14)
    assert characteristic(motor, "linear").critical == pytest.approx(of_kloss, rel=1e-14)
    assert characteristic(Motor("X", 7500.0, 152.0, 157.08), "parabolic").critical is None


def test_interpolation_of_the_points() -> None:
    points = ((0.0, 80.0), (60.0, 60.0), (120.0, 100.0), (157.08, 0.0))
    linear = characteristic(Motor(**GOOD, points=points, interpolation="linear"), "table")
    assert linear.moment(30.0) == pytest.approx(70.0, rel=1e-15)
    smooth = characteristic(Motor(**GOOD, points=points), "table")
    assert smooth.slope(60.0) == pytest.approx(0.0, abs=1e-12)  # a monotone cubic rests at a minimum
    np.testing.assert_allclose(smooth.moment(np.array([0.0, 60.0, 120.0])), [80, 60, 100], rtol=1e-14)


def test_time_constant() -> None:
    assert electromagnetic_time_constant(0.2, 60.0) == pytest.approx(1 / (24 * math.pi), rel=1e-15)
    with pytest.raises(UsageError):
        electromagnetic_time_constant(0.0)


def test_the_lag_by_the_formula() -> None:
    motor = Motor("m", 1100.0, 146.6, 157.08, 2.2)
    assert with_lag(motor, 0.02).time_constant == 0.02
    slip = 1 - 146.6 / 157.08
    critical = slip * (2.2 + math.sqrt(2.2**2 - 1))
    assert with_lag(motor, None).time_constant == pytest.approx(1 / (100 * math.pi * critical), rel=1e-14)
    with pytest.raises(UsageError, match="overload ratio"):
        with_lag(Motor("m", 1100.0, 146.6, 157.08), None)
