"""Random drives of one to three masses: their numbers, and the drive and scenario that these make.

Motors of three kinds that may lag, loads with jumps, shafts of all stiffnesses.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from machine.transient.scenes import cycle, kloss, line, parabola
from tmmcalc.machine.transient.model import Drive, Mass, Shaft
from tmmcalc.machine.transient.scenario import Scenario

TURN = 2 * math.pi


class Numbers(NamedTuple):
    """A drive whose shafts all turn at the speed of the crank."""

    waves: tuple[tuple[float, float], ...]  # of cos k phi and sin k phi in the load [N*m]
    mean: float  # of the load [N*m]
    depth: float  # of its jump [N*m]; 0: none
    jumps: tuple[float, float]  # where it is deeper [rad]
    swing: float  # inertia swing (1 + sin 2 phi) [kg*m^2]
    speed: float  # [rad/s]
    motor: int  # kloss, line or parabola
    kloss: tuple[float, float, float]  # largest moment, critical slip, synchronous speed
    line: tuple[float, float]  # stiffness, synchronous speed
    parabola: tuple[float, float]  # a - b w^2
    lag: float  # [s]
    masses: tuple[float, ...]
    shafts: tuple[tuple[float, float], ...]  # stiffness, damping
    duration: float
    start: float  # speed


def drawn(rng: np.random.Generator) -> Numbers:
    """Numbers of a random drive."""
    count, waves = int(rng.integers(0, 3)), rng.normal(size=(2, 3))
    speed, inertia = 10 ** rng.uniform(0.3, 2), 10 ** rng.uniform(-1, 2)
    rated = inertia * speed * 10 ** rng.uniform(-0.5, 1)
    jumps, (low, high), depth = rng.random() < 0.5, np.sort(rng.uniform(0.2, 6, 2)), rng.uniform(0.1, 0.8) * rated
    swing = rng.uniform(0, 0.4) * inertia
    kloss_, line_ = rng.uniform(0.1, 0.4), rng.uniform(0.03, 0.3)
    motor = int(rng.integers(3))
    lag = 10 ** rng.uniform(-5, -1) if rng.random() < 0.4 else 0.0
    masses = [inertia * 10 ** rng.uniform(-1.5, 0.5) for _ in range(count)] + [inertia]
    shafts = []
    for mass in masses[:-1]:
        stiffness = inertia * speed**2 * 10 ** rng.uniform(1, 6)
        shafts.append((stiffness, 2 * rng.uniform(0.02, 0.5) * math.sqrt(stiffness * mass)))
    return Numbers(
        waves=tuple((0.1 * rated * a, 0.1 * rated * b) for a, b in waves.T.tolist()),
        mean=-0.2 * rated,
        depth=depth if jumps else 0.0,
        jumps=(float(low), float(high)),
        swing=swing,
        speed=speed,
        motor=motor,
        kloss=(2.5 * rated, kloss_, 1.05 * speed),
        line=(rated / (speed * line_), 1.05 * speed),
        parabola=(2 * rated, rated / speed**2),
        lag=lag,
        masses=tuple(masses),
        shafts=tuple(shafts),
        duration=rng.uniform(0.2, 2.4) * TURN / speed,
        start=0.0 if rng.random() < 0.5 else speed * rng.uniform(0.9, 1.0),
    )


def made(of: Numbers) -> tuple[Drive, Scenario]:
    """The drive of these numbers and what happens to it."""
    low, high = of.jumps

    def moment(p: np.ndarray) -> np.ndarray:
        wavy = sum(a * np.cos(k * p) + b * np.sin(k * p) for k, (a, b) in enumerate(of.waves, 1))
        return wavy + of.mean - of.depth * ((p > low) & (p < high))

    breaks = of.jumps if of.depth else ()
    load = cycle(moment, lambda p: of.swing * (1 + np.sin(2 * p)), breaks, speed=of.speed)
    motor = (lambda: kloss(*of.kloss, of.speed), lambda: line(*of.line), lambda: parabola(*of.parabola))[of.motor]()
    shafts = tuple(Shaft(*each) for each in of.shafts)
    drive = Drive(tuple(map(Mass, of.masses)), shafts, motor, load, None, of.lag)
    return drive, Scenario("drawn", of.duration, speed=of.start)
