"""The estimated error of the speeds bounds the true one in random drives, and is not far from it.

Drives of one to three masses, with motors of three kinds that may lag, loads with jumps, and shafts of all stiffnesses;
the truth is collocation of order 13 at a tolerance a thousand times finer, which closed solutions and DOP853 confirm.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from machine.transient.scenes import cycle, kloss, line, parabola, run
from tmmcalc.errors import AccuracyError
from tmmcalc.machine.transient.model import Drive, Mass, Shaft
from tmmcalc.machine.transient.results import Transient
from tmmcalc.machine.transient.scenario import Scenario

pytestmark = pytest.mark.slow

TURN = 2 * math.pi
LEAST = 2.0**-53
TRUTH = 1e-11


def drawn(rng: np.random.Generator) -> tuple[Drive, Scenario]:
    """A random drive and what happens to it."""
    count, waves = int(rng.integers(0, 3)), rng.normal(size=(2, 3))
    speed, inertia = 10 ** rng.uniform(0.3, 2), 10 ** rng.uniform(-1, 2)
    rated = inertia * speed * 10 ** rng.uniform(-0.5, 1)
    jumps, (low, high), depth = rng.random() < 0.5, np.sort(rng.uniform(0.2, 6, 2)), rng.uniform(0.1, 0.8) * rated

    def moment(p: np.ndarray) -> np.ndarray:
        wavy = sum(a * np.cos(k * p) + b * np.sin(k * p) for k, (a, b) in enumerate(waves.T, 1))
        return 0.1 * rated * wavy - 0.2 * rated - (depth * ((p > low) & (p < high)) if jumps else 0.0)

    swing = rng.uniform(0, 0.4) * inertia
    load = cycle(moment, lambda p: swing * (1 + np.sin(2 * p)), (low, high) if jumps else (), speed=speed)
    motors = [
        kloss(2.5 * rated, rng.uniform(0.1, 0.4), 1.05 * speed, speed),
        line(rated / (speed * rng.uniform(0.03, 0.3)), 1.05 * speed),
        parabola(2 * rated, rated / speed**2),
    ]
    motor = motors[int(rng.integers(3))]
    lag = 10 ** rng.uniform(-5, -1) if rng.random() < 0.4 else 0.0
    masses = [Mass(inertia * 10 ** rng.uniform(-1.5, 0.5)) for _ in range(count)] + [Mass(inertia)]
    shafts = []
    for mass in masses[:-1]:
        stiffness = inertia * speed**2 * 10 ** rng.uniform(1, 6)
        shafts.append(Shaft(stiffness, 2 * rng.uniform(0.02, 0.5) * math.sqrt(stiffness * mass.inertia)))
    duration = rng.uniform(0.2, 2.4) * TURN / speed
    start = 0.0 if rng.random() < 0.5 else speed * rng.uniform(0.9, 1.0)
    return Drive(tuple(masses), tuple(shafts), motor, load, None, lag), Scenario("drawn", duration, speed=start)


def ratios(seed: int, count: int) -> np.ndarray:
    """Estimated over true error of ``count`` drives."""
    rng = np.random.default_rng(seed)
    found: list[float] = []
    while len(found) < count:
        drive, scenario = drawn(rng)
        instants = np.linspace(0.0, scenario.duration, 62)[1:-1]
        times = instants.tolist()
        try:
            exact = run(drive, scenario, "collocation", times, tolerance=TRUTH, compared=False, budget=100_000)
            motion = run(drive, scenario, "auto", times)
        except AccuracyError:
            continue  # the truth is too dear: a shaft swings a thousand times
        if motion.rigid:
            continue

        def speeds(of: Transient, at: np.ndarray = instants) -> np.ndarray:
            return of.omega[:, np.minimum(np.searchsorted(of.t, at), len(of.t) - 1)]

        missed = np.max(np.abs(speeds(motion) - speeds(exact))) / np.max(np.abs(exact.omega))
        found.append(motion.error / max(missed, LEAST))
    return np.array(found)


def check(found: np.ndarray) -> None:
    bound, median = float((found >= 1).mean()), float(np.median(found))
    assert bound >= 0.99, (bound, median)
    assert median < 30, (bound, median)


def test_estimates_of_some_drives() -> None:
    check(ratios(5, 8))


@pytest.mark.slow
def test_estimates_of_many_drives() -> None:
    check(ratios(17, 200))
