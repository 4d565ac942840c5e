"""Random drives: energy balances, methods agree, the error estimate holds, time and direction do not matter."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from sparing import sparing

from machine.transient.scenes import Motor, Shape, cycle, kloss, run
from tmmcalc.machine.transient.model import Drive, Mass, Shaft
from tmmcalc.machine.transient.scenario import Brake, LoadStep, Scenario


def waves(rng: np.random.Generator, size: float, jumps: tuple[float, ...] = ()) -> Shape:
    a, b = rng.normal(size=(2, 4)) * size / np.arange(1, 5)
    steps = rng.normal(size=len(jumps)) * size

    def f(p: np.ndarray) -> np.ndarray:
        k = np.arange(1, 5)[:, None, None]
        smooth = (a[:, None, None] * np.cos(k * p) + b[:, None, None] * np.sin(k * p)).sum(axis=0)
        return smooth + sum((s * (p > j) for s, j in zip(steps, jumps, strict=True)), np.zeros_like(p))

    return f


def random_drive(seed: int) -> tuple[Drive, Scenario]:
    """A Kloss motor, an inertia that varies, a moment with jumps, resistances, one to three masses, sometimes lag."""
    rng = np.random.default_rng(seed)
    jumps = tuple(np.sort(rng.uniform(0.2, 6.0, rng.integers(0, 4))))
    wavy, load = waves(rng, 0.15), waves(rng, 15.0, jumps)
    given = cycle(
        lambda p: load(p) - 25.0,
        lambda p: 0.8 + np.abs(wavy(p)) ** 2,
        jumps,
        viscous=-rng.uniform(0, 1),
        quadratic=-0.02,
    )
    motor: Motor = kloss(rng.uniform(120, 200), rng.uniform(0.2, 0.5), 12.0, 11.0)
    count = int(rng.integers(1, 4))
    masses = tuple(Mass(float(j)) for j in rng.uniform(0.5, 3.0, count))
    shafts = tuple(Shaft(float(c), float(c) * 2e-3) for c in rng.uniform(500, 5000, count - 1))
    drive = Drive(masses, shafts, motor, given, time_constant=float(rng.choice([0.0, 0.03])))
    steps = (LoadStep(0.2), LoadStep(1.0, speed=8.0), LoadStep(0.5, time=0.9))
    brake = Brake(float(rng.uniform(0, 60)), float(rng.uniform(0, 2)), int(rng.integers(0, count)), 1.0)
    return drive, Scenario(f"random {seed}", 1.3, motor=((0.0, 1.0),), load=steps, brake=brake)


@sparing("seed", range(8), every=4)
def test_methods_agree_and_energy_balances(seed: int) -> None:
    drive, scenario = random_drive(seed)
    one, other = run(drive, scenario, "merson"), run(drive, scenario, "DOP853", tolerance=1e-12)
    assert one.end == other.end
    assert one.t[-1] == pytest.approx(other.t[-1], abs=1e-7)
    assert [e.kind for e in one.events] == [e.kind for e in other.events]
    gap = float(np.max(np.abs(one.omega[:, -1] - other.omega[:, -1]))) / 12
    assert gap < 1e-8
    assert gap < 10 * one.error
    np.testing.assert_allclose(one.theta[:, -1], other.theta[:, -1], atol=1e-7)
    assert one.imbalance < 1e-9
    assert other.imbalance < 1e-10


@pytest.mark.slow
@sparing("seed", [2, 3], every=2)
def test_the_origin_of_the_angle_does_not_matter(seed: int) -> None:
    drive, scenario = random_drive(seed)
    turned = replace(scenario, angle=14 * math.pi)
    one, other = run(drive, scenario), run(drive, turned)
    np.testing.assert_allclose(other.theta[-1, -1] - 14 * math.pi, one.theta[-1, -1], atol=1e-8)
    assert other.t[-1] == pytest.approx(one.t[-1], abs=1e-9)


@sparing("seed", range(3), every=3)
def test_a_free_motion_runs_back_to_where_it_began(seed: int) -> None:
    """Without losses the motion with the opposite speed returns along the same angles."""
    rng = np.random.default_rng(seed)
    wavy, load = waves(rng, 0.2), waves(rng, 6.0, (1.0, 4.0))
    drive = Drive((Mass(1.0),), cycle=cycle(load, lambda p: 0.5 + wavy(p) ** 2, (1.0, 4.0)))
    forth = run(drive, Scenario("forth", 2.0, speed=4.0, standstill="pass"))
    back = run(drive, Scenario("back", 2.0, speed=-forth.omega[0, -1], angle=forth.theta[0, -1], standstill="pass"))
    assert back.theta[0, -1] == pytest.approx(0.0, abs=1e-7)
    assert back.omega[0, -1] == pytest.approx(-4.0, abs=1e-7)
