"""Estimated errors of steady motions and flywheels bound the true ones in random machines, and are not far from them.

The truth is the same equations on panels cut twice, with the functions of the cycle taken afresh there; of a flywheel
the root by Brent's method.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.optimize import brentq

from machine.transient.scenes import cycle, kloss, line, parabola
from tmmcalc.errors import TmmError
from tmmcalc.machine.cycle import Cycle
from tmmcalc.machine.flywheel.required import required_inertia
from tmmcalc.machine.steady import driven

LEAST = 2.0**-53


class Drawn:
    """A random machine: its cycle as the program has it, the same on finer panels, motor, inertia, lag."""

    def __init__(self, rng: np.random.Generator) -> None:
        speed, self.inertia = 10 ** rng.uniform(0, 2), 10 ** rng.uniform(-1, 2)
        rated = self.inertia * speed**2 * 10 ** rng.uniform(-2, 0.3)
        waves, swing = rng.normal(size=(2, 3)), rng.uniform(0, 0.4) * self.inertia
        jumps, (low, high), depth = rng.random() < 0.5, np.sort(rng.uniform(0.2, 6, 2)), rng.uniform(0.1, 0.8) * rated

        def moment(p: np.ndarray) -> np.ndarray:
            wavy = sum(a * np.cos(k * p) + b * np.sin(k * p) for k, (a, b) in enumerate(waves.T, 1))
            return 0.15 * rated * wavy - 0.2 * rated - (depth * ((p > low) & (p < high)) if jumps else 0.0)

        def inertia(p: np.ndarray) -> np.ndarray:
            return swing * (1 + np.sin(2 * p))

        self.cycle = cycle(moment, inertia, (low, high) if jumps else (), speed=speed)
        fine = self.cycle.panels
        for _ in range(2):
            fine = fine.split(np.ones(fine.count, bool))
        x, none = fine.x, np.zeros(fine.x.shape)
        self.finer = Cycle(fine, inertia(x), 2 * swing * np.cos(2 * x), moment(x), none, none, speed)
        motors: list[Any] = [
            kloss(2.5 * rated, rng.uniform(0.05, 0.4), 1.05 * speed, speed),
            line(rated / (speed * rng.uniform(0.03, 0.3)), 1.05 * speed),
            parabola(2 * rated, rated / speed**2),
        ]
        self.motor = motors[int(rng.integers(3))]
        self.lag = 10 ** rng.uniform(-5, -1) if rng.random() < 0.4 else 0.0


def check(ratios: list[float]) -> None:
    bound, median = float((np.array(ratios) >= 1).mean()), float(np.median(ratios))
    assert bound >= 0.99, (bound, median)
    assert median < 30, (bound, median)


@pytest.mark.parametrize("count", [40, pytest.param(200, marks=pytest.mark.slow)])
def test_steady_motion(count: int) -> None:
    rng, theta, ratios = np.random.default_rng(21), np.linspace(0, 6.28, 97), list[float]()
    while len(ratios) < count:
        machine = Drawn(rng)
        try:
            found = driven(machine.cycle, machine.inertia, machine.motor, time_constant=machine.lag)
        except TmmError:
            continue
        exact = driven(machine.finer, machine.inertia, machine.motor, time_constant=machine.lag)
        missed = np.max(np.abs(found.omega_at(theta) - exact.omega_at(theta))) / exact.omega_max
        ratios.append(found.error / max(missed, LEAST))
    check(ratios)


@pytest.mark.parametrize("count", [12, pytest.param(100, marks=pytest.mark.slow)])
def test_flywheel(count: int) -> None:
    rng, ratios = np.random.default_rng(22), list[float]()
    while len(ratios) < count:
        machine = Drawn(rng)
        try:
            delta = driven(machine.cycle, machine.inertia, machine.motor).delta * rng.uniform(0.3, 0.8)
            found = required_inertia(machine.cycle, machine.motor, delta, machine.inertia)
        except TmmError:
            continue
        if not found.needed:
            continue

        def gap(inertia: float, machine: Drawn = machine, delta: float = delta) -> float:
            return driven(machine.finer, inertia, machine.motor).delta / delta - 1

        near = found.inertia
        true = brentq(gap, 0.99 * near, 1.01 * near, xtol=1e-15 * near, rtol=1e-14)
        ratios.append(found.error / max(abs(near - true) / true, LEAST))
    check(ratios)
