"""Estimated errors of steady motions bound the true ones in random machines, and are not far from them.

The truth is Chebyshev collocation in extended precision for the difference of the speed from a reference, on panels of
its own; of forces of position the energy by its primitive written out.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from bounding import RATE, assert_bounds

from machine.drawn import TURN, Drawn
from machine.exact import WIDE, Exact
from machine.motion import cycle_of
from tmmcalc.core.errors import TmmError
from tmmcalc.machine.motors.characteristics import Straight
from tmmcalc.machine.positional import positional
from tmmcalc.machine.regime import Regime
from tmmcalc.machine.steady import driven

THETA = np.linspace(0, 6.28, 97)
KEPT = 1e-18  # relative, of a moment: what the mean speed leaves of it
MANY = pytest.param(200, marks=pytest.mark.slow)
Pairs = dict[str, list[tuple[float, float]]]


def missed(found: Any, exact: Any, scale: Any) -> float:
    """Largest difference over the largest exact value."""
    return float(np.max(np.abs(found - exact)) / np.max(np.abs(scale)))


def compared(found: Regime, exact: Exact) -> dict[str, tuple[float, float]]:
    """Estimate and true error of all that a regime tells."""
    told, on = found.errors, found.panels
    omega, drive, eps = exact.omega, exact.driving, exact.acceleration
    delta, time = exact.delta, exact.cycle_time
    at = np.concatenate((THETA, on.x.ravel()))
    return {
        "speed": (told.speed, missed(found.omega_at(at), exact.at(omega, at), omega)),
        "acceleration": (told.acceleration, missed(on.at(found.acceleration, at), exact.at(eps, at), eps)),
        "moment": (told.moment, missed(on.at(found.driving, at), exact.at(drive, at), drive)),
        "fluctuation": (told.fluctuation, missed(found.delta, delta, delta)),
        "time": (told.time, missed(found.cycle_time, time, time)),
    }


def pairs(seed: int, count: int, tolerance: float = 0.0, **drawn: Any) -> Pairs:
    """Estimates and true errors of ``count`` random machines with motors."""
    rng, found = np.random.default_rng(seed), defaultdict[str, list[tuple[float, float]]](list)
    while len(found["speed"]) < count:
        machine = Drawn(rng, **drawn)
        try:
            regime = machine.regime(tolerance=tolerance)
            if machine.bends(regime):
                continue
            exact = machine.exact(regime)
        except (TmmError, RuntimeError):
            continue  # refused, or a shaft that swings a thousand times
        for key, pair in compared(regime, exact).items():
            found[key].append(pair)
    return found


def check(found: Pairs, count: int) -> None:
    for key, told in found.items():
        assert_bounds(told, key, scenes=count)


@pytest.mark.parametrize("count", [20, MANY])
def test_motors_of_any_slip(count: int) -> None:
    check(pairs(21, count), count)


@pytest.mark.parametrize("count", [60, pytest.param(200, marks=pytest.mark.slow)])
def test_motors_that_lag(count: int) -> None:
    check(pairs(23, count, slips=(-3, -1), lagging=0.5), count)


@pytest.mark.parametrize("count", [6, MANY])
@pytest.mark.parametrize("tolerance", [1e-3, 1e-5])
def test_a_tolerance_is_kept_and_its_estimate_useful(tolerance: float, count: int) -> None:
    found = pairs(33, count, tolerance, slips=(-4, -1), lagging=0.3)
    check({key: told for key, told in found.items() if key != "fluctuation"}, count)
    assert np.mean([told >= error for told, error in found["fluctuation"]]) >= RATE
    for told in found.values():
        assert np.max(told) < tolerance


def test_the_truth_is_its_own() -> None:
    """Another order and other panels give the same."""
    rng = np.random.default_rng(4)
    for lagging in (0.0, 1.0):
        machine = Drawn(rng, slips=(-4, -3), lagging=lagging)
        regime = machine.regime()
        one, two = machine.exact(regime), machine.exact(regime, order=25, widest=0.1)
        assert missed(one.at(one.y[0], THETA), two.at(two.y[0], THETA), one.y[0]) < 3e-16
        assert missed(one.delta, two.delta, one.delta) < 3e-16
        assert missed(one.cycle_time, two.cycle_time, one.cycle_time) < 1e-17


def primitive(machine: Drawn, drive: Any, x: Any) -> Any:
    """Work of the load and a constant moment from 0 to x, written out."""
    work = (drive - WIDE(machine.mean)) * x
    for k, (a, b) in enumerate(machine.waves.T, 1):
        work = work + (WIDE(a) * np.sin(k * x) + WIDE(b) * (1 - np.cos(k * x))) / k
    if machine.jumps:
        low, high = map(WIDE, machine.jumps)
        work = work - WIDE(machine.depth) * np.clip(x - low, 0, high - low)
    return work


def at_mean(machine: Drawn) -> tuple[Any, Any, Any, Any]:
    """Exact speeds, accelerations at the angles, the largest acceleration and delta under a constant moment."""
    turn = WIDE(TURN)
    drive = -primitive(machine, WIDE(0), turn) / turn
    fine = np.unique(np.concatenate((np.linspace(0, turn, 8001, dtype=WIDE), np.array(machine.jumps, WIDE))))
    inertia = machine.links(fine) + WIDE(machine.constant)
    work = primitive(machine, drive, fine)
    low, high = -np.min(work), WIDE(20 * machine.inertia * machine.speed**2) + np.ptp(work)

    def extremes(level: Any) -> tuple[Any, Any]:
        omega = np.sqrt(2 * np.maximum(level + work, 0) / inertia)
        return peak(-omega) * -1, peak(omega)

    def excess(level: Any) -> Any:
        return sum(extremes(level)) - 2 * machine.speed

    level = root(excess, low, high)
    slow, fast = extremes(level)
    speeds = np.sqrt(2 * (level + work) / inertia)
    rates = (drive + machine.load(fine) - machine.bend(fine) * speeds**2 / 2) / inertia
    x = THETA.astype(WIDE)
    within = machine.links(x) + WIDE(machine.constant)
    omega = np.sqrt(2 * (level + primitive(machine, drive, x)) / within)
    eps = (drive + machine.load(x) - machine.bend(x) * omega**2 / 2) / within
    return omega, eps, np.max(np.abs(rates)), (fast - slow) / WIDE(machine.speed)


def root(function: Callable[[Any], Any], low: Any, high: Any) -> Any:
    """Of a function that rises from low to high, to the last digit: false position with the halving of Illinois."""
    below, above = function(low), function(high)
    assert below < 0 < above
    level, side = low, 0
    for _ in range(75):
        last, level = level, (low * above - high * below) / (above - below)
        value = function(level)
        if value == 0 or level in (last, low, high):
            break
        if value < 0:
            low, below, above = level, value, above / (2 if side < 0 else 1)
        else:
            high, above, below = level, value, below / (2 if side > 0 else 1)
        side = 1 if value > 0 else -1
    return level


def peak(values: Any) -> Any:
    """The largest of many values (n,), by the polynomial of degree 4 about it where it is smooth."""
    k = int(np.argmax(values[2:-2])) + 2
    a, b, c, d, e = values[k - 2 : k + 3]
    terms: tuple[Any, ...] = (c, (a - 8 * b + 8 * d - e) / 12, (-a + 16 * b - 30 * c + 16 * d - e) / 24)
    terms += ((e - 2 * d + 2 * b - a) / 12, (a - 4 * b + 6 * c - 4 * d + e) / 24)
    if terms[2] >= 0:
        return c
    t = WIDE(0)
    for _ in range(5):
        slope = sum(j * v * t ** (j - 1) for j, v in enumerate(terms) if j)
        t = t - slope / sum(j * (j - 1) * v * t ** (j - 2) for j, v in enumerate(terms) if j > 1)
    return max(c, sum(v * t**j for j, v in enumerate(terms)))


@pytest.mark.parametrize("count", [12, MANY])
def test_forces_of_position(count: int) -> None:
    rng, found = np.random.default_rng(25), defaultdict[str, list[tuple[float, float]]](list)
    while len(found["speed"]) < count:
        machine = Drawn(rng)
        if machine.viscous or machine.jumps:
            continue  # at a corner the extremes of the reference are those of its points alone
        try:
            regime = positional(machine.cycle, machine.constant, machine.speed)
        except TmmError:
            continue
        omega, eps, largest, delta = at_mean(machine)
        told, on = regime.errors, regime.panels
        found["speed"].append((told.speed, missed(regime.omega_at(THETA), omega, omega)))
        found["acceleration"].append((told.acceleration, missed(on.at(regime.acceleration, THETA), eps, largest)))
        found["fluctuation"].append((told.fluctuation, missed(regime.delta, delta, delta)))
    check(found, count)


class ConstantAt:
    """A constant moment for `drawn.over`."""

    name = "constant"

    def __init__(self, value: Any) -> None:
        self.value = value


def kept_at_mean(machine: Drawn, regime: Regime) -> Exact:
    """The exact motion under the constant moment that keeps the mean speed."""
    moment = WIDE(float(regime.driving.flat[0]))
    for _ in range(8):
        machine.motor = ConstantAt(moment)
        exact = machine.exact(regime)
        low, high = exact.extremes()
        # as the mean speed rises the resistance takes so much more
        more = WIDE(machine.viscous) * (exact.reference + (low + high) / 2 - WIDE(machine.speed))
        if abs(more) <= KEPT * abs(moment):
            break
        moment = moment + more
    return exact


@pytest.mark.parametrize("count", [4, MANY])
def test_resistance_under_a_constant_moment(count: int) -> None:
    rng, found = np.random.default_rng(26), defaultdict[str, list[tuple[float, float]]](list)
    while len(found["speed"]) < count:
        machine = Drawn(rng)
        if not machine.viscous:
            continue
        try:
            regime = positional(machine.cycle, machine.constant, machine.speed)
        except TmmError:
            continue
        for key, pair in compared(regime, kept_at_mean(machine, regime)).items():
            found[key].append(pair)
    check(found, count)


@pytest.mark.parametrize("drive", ["motor", "positional"])
@pytest.mark.parametrize("load", [0.0, -20.0])
def test_of_an_even_speed_the_errors_are_those_of_what_cancels(drive: str, load: float) -> None:
    """Nothing but rounding is left of delta and eps: an estimate relative to that would refuse every tolerance."""
    cycle = cycle_of(lambda x: (0.5 + 0 * x, 0 * x, load + 0 * x))
    regime = positional(cycle, 1.0, 10.0) if drive == "positional" else driven(cycle, 1.0, Straight(300.0, 10.0))
    assert regime.delta < 1e-14
    assert np.max(np.abs(regime.acceleration)) < 1e-11
    assert regime.errors.largest < 1e-12
