"""Choice of a motor: the least that suffices, told with its reasons, and a reason against every other one."""

from __future__ import annotations

import math
import random
from typing import Any

import pytest

from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.machine.motors.catalogue import load_catalogue
from tmmcalc.machine.motors.choice import Choice, choose
from tmmcalc.machine.motors.model import Motor

RPM = math.pi / 30
MOTORS = load_catalogue()
SERIES_4A = [motor for motor in MOTORS if motor.name.startswith("4A")]


def refusal(choice: Choice, name: str) -> str:
    return next(refused.reason for refused in choice.refused if refused.motor.name == name)


def told(choice: Choice) -> str:
    return "\n".join(choice.reasons)


def test_least_power_of_a_series() -> None:
    choice = choose(6200.0, SERIES_4A, synchronous=1500 * RPM)
    assert choice.motor.name == "4A132S4"
    assert choice.ratio is None
    assert choice.reasons == ("7.5 kW cover the required 6.2 kW with 21% in reserve",)
    assert refusal(choice, "4A112M4") == "its 5.5 kW are less than the required 6.2 kW"
    assert refusal(choice, "4A132M4") == "11 kW where 7.5 kW suffice"
    assert refusal(choice, "4A132M6") == "its synchronous speed is 1000 rpm, not 1500 rpm"


def test_exactly_the_rated_power_suffices() -> None:
    assert choose(7500.0, SERIES_4A, synchronous=1500 * RPM).motor.power == 7500
    assert choose(7500.1, SERIES_4A, synchronous=1500 * RPM).motor.power == 11000


def test_every_motor_is_accounted_for_once() -> None:
    choice = choose(3000.0, MOTORS, input_speed=10.0, peak_moment=400.0)
    names = [refused.motor.name for refused in choice.refused]
    assert sorted([*names, choice.motor.name]) == sorted(motor.name for motor in MOTORS)
    assert all(refused.reason for refused in choice.refused)


def test_peak_of_the_load_asks_for_a_larger_motor() -> None:
    """2.2 M_N of 4A132S4 are 108.3 N*m; the next size has 158.3 N*m."""
    speed = 55 * RPM
    choice = choose(6200.0, SERIES_4A, synchronous=1500 * RPM, input_speed=speed, peak_moment=3300.0)
    assert choice.motor.name == "4A132M4"
    assert choice.ratio == pytest.approx(1460 / 55, rel=1e-14)
    against = refusal(choice, "4A132S4")
    assert f"{3300 / (1455 / 55):.4g} N*m at its shaft" in against
    assert f"{2.2 * 7500 / (1455 * RPM):.4g} N*m" in against
    assert "the next smaller of enough power, 7.5 kW, is refused" in told(choice)
    assert "break-down moment" in told(choice)
    assert "takes its 1460 rpm to 55 rpm" in told(choice)
    below = choose(6200.0, SERIES_4A, synchronous=1500 * RPM, input_speed=speed, peak_moment=2800.0)
    assert below.motor.name == "4A132S4"


def test_load_at_standstill() -> None:
    """1.4 M_N of 4A160S4 are 136.9 N*m, 2 M_N of 4A132M4 are 143.9 N*m."""
    demand: dict[str, Any] = {"synchronous": 1500 * RPM, "ratio": 25.0}
    assert choose(10e3, SERIES_4A, **demand, start_moment=25 * 140.0).motor.name == "4A132M4"
    beyond = choose(12e3, SERIES_4A, **demand, start_moment=25 * 140.0)
    assert beyond.motor.name == "4A160M4"
    assert "exceeds its starting moment of 136.9 N*m" in refusal(beyond, "4A160S4")
    assert "overcomes the load at standstill, 140 N*m" in told(beyond)


def test_given_ratio_and_speed_exclude_other_speeds() -> None:
    choice = choose(6200.0, SERIES_4A, input_speed=55 * RPM, ratio=1500 / 55)
    assert choice.motor.name == "4A132S4"
    assert choice.ratio == 1500 / 55
    assert "turns the input shaft at 35.567 rpm, not 55 rpm" in refusal(choice, "4A132M6")


def test_unknown_data_count_against_a_motor() -> None:
    bare = Motor("bare", 7500.0, 1455 * RPM, 1500 * RPM)
    full = Motor("full", 7500.0, 1455 * RPM, 1500 * RPM, 2.2, start=2.0)
    assert choose(7000.0, [bare, full]).motor is bare
    assert choose(7000.0, [bare, full], ratio=20.0, peak_moment=10.0).motor is full
    choice = choose(7000.0, [bare, full], ratio=20.0, start_moment=10.0)
    assert refusal(choice, "bare") == "its starting moment is not known"


def test_of_equal_powers_the_known_inertia_and_the_usual_speed() -> None:
    slow = Motor("slow", 3000.0, 950 * RPM, 1000 * RPM, inertia=0.02)
    usual = Motor("usual", 3000.0, 1430 * RPM, 1500 * RPM, inertia=0.01)
    unknown = Motor("unknown", 3000.0, 1430 * RPM, 1500 * RPM)
    choice = choose(2500.0, [unknown, slow, usual])
    assert choice.motor is usual
    assert "rotor inertia is not known" in refusal(choice, "unknown")
    assert refusal(choice, "slow") == "it suffices too; usual of the same power comes first"


def test_nothing_suffices() -> None:
    with pytest.raises(NoSolutionError, match=r"4A250M4.* 90 kW are less than the required 120 kW") as error:
        choose(120e3, SERIES_4A, synchronous=1500 * RPM)
    assert (error.value.value, error.value.limit) == (120e3, 90e3)
    with pytest.raises(NoSolutionError, match="synchronous speed 1800 rpm") as other:
        choose(1e3, SERIES_4A, synchronous=1800 * RPM)
    assert "1500 rpm" in other.value.remedy
    with pytest.raises(NoSolutionError, match="break-down moment") as third:
        choose(1e3, SERIES_4A, ratio=1.0, peak_moment=1e5)
    assert "flywheel" in third.value.remedy
    with pytest.raises(NoSolutionError, match="no motors"):
        choose(1e3, [])


@pytest.mark.parametrize(
    ("power", "demand"),
    [
        (0.0, {}),
        (math.nan, {}),
        (1e3, {"ratio": -2.0}),
        (1e3, {"input_speed": 0.0}),
        (1e3, {"peak_moment": 5.0}),
        (1e3, {"start_moment": 5.0}),
        (1e3, {"ratio": 5.0, "peak_moment": -5.0}),
    ],
)
def test_impossible_demands(power: float, demand: dict[str, float]) -> None:
    with pytest.raises(UsageError) as error:
        choose(power, SERIES_4A, **demand)
    assert error.value.where == "choice of the motor"


def test_choice_is_the_least_of_all_that_suffice() -> None:
    """Against the conditions written out anew, over random demands."""
    chance = random.Random(4)
    found = 0
    for _ in range(200):
        power, speed = 10 ** chance.uniform(2.5, 5.1), 10 ** chance.uniform(0.3, 1.5)
        peak = power / speed * chance.uniform(0.5, 4)
        start = power / speed * chance.uniform(0.2, 3)
        enough = [
            motor.power
            for motor in MOTORS
            if motor.power >= power
            and peak * speed <= (motor.overload or 0) * motor.power
            and start * speed <= (motor.start or 0) * motor.power
        ]
        demand = {"input_speed": speed, "peak_moment": peak, "start_moment": start}
        if enough:
            found += 1
            assert choose(power, MOTORS, **demand).motor.power == min(enough)
        else:
            with pytest.raises(NoSolutionError):
                choose(power, MOTORS, **demand)
    assert 50 < found < 200
