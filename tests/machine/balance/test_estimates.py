"""Estimated errors of engines and rotors bound the true ones, found with 40 digits, and are not far from them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import mpmath as mp
import numpy as np
import pytest

from tmmcalc.machine.balance.cylinders import Cylinder
from tmmcalc.machine.balance.engines import engine_balance
from tmmcalc.machine.balance.rotors import Rotor, Unbalance, rotor_balance

SCENES = [30, pytest.param(200, marks=pytest.mark.slow)]
SPEED = 10.0
LEAST = 2.0**-53


def check(ratios: list[float]) -> None:
    bound, median = float((np.array(ratios) >= 1).mean()), float(np.median(ratios))
    assert bound >= 0.99, (bound, median)
    assert median < 30, (bound, median)


def engine(rng: np.random.Generator) -> list[Cylinder]:
    cylinders = []
    for k in range(int(rng.integers(1, 7))):
        radius = 10 ** rng.uniform(-2, 0)
        offset = float(rng.choice([0.0, 0.1])) * radius
        cylinders.append(
            Cylinder(
                axis_angle=float(rng.choice([0.0, 0.7, 1.5])),
                crank_angle=rng.uniform(0, 6.28),
                position_along_shaft=0.1 * k,
                crank_radius=radius,
                rod_length=(radius + offset) * rng.uniform(1.15, 6),
                reciprocating_mass=rng.uniform(0.1, 3),
                rotating_mass=rng.uniform(0, 3),
                offset=offset,
            )
        )
    return cylinders


def force(cylinders: Sequence[Cylinder], phi: float) -> Any:
    """Shaking force with 40 digits [N]."""
    total = mp.mpc(0)
    for c in cylinders:
        radius, crank = mp.mpf(c.crank_radius), mp.mpf(phi) + mp.mpf(c.crank_angle)
        along = crank - mp.mpf(c.axis_angle)

        def place(a: Any, r: Any = radius, rod: float = c.rod_length, off: float = c.offset) -> Any:
            return r * mp.cos(a) + mp.sqrt(mp.mpf(rod) ** 2 - (r * mp.sin(a) - mp.mpf(off)) ** 2)

        turning = mp.mpf(c.rotating_mass) * radius * mp.expj(crank)
        sliding = mp.mpf(c.reciprocating_mass) * mp.diff(place, along, 2) * mp.expj(mp.mpf(c.axis_angle))
        total += mp.mpf(SPEED) ** 2 * (turning - sliding)
    return total


@pytest.mark.parametrize("scenes", SCENES)
def test_engines(scenes: int) -> None:
    rng, ratios = np.random.default_rng(3), []
    with mp.workdps(40):
        for _ in range(scenes):
            cylinders = engine(rng)
            balance = engine_balance(cylinders, SPEED)
            places = rng.uniform(0, 6.28, 3)
            found = balance.force.at(places)
            missed = max(float(abs(mp.mpc(f) - force(cylinders, p))) for f, p in zip(found, places, strict=True))
            ratios.append(balance.error / max(missed / balance.scales[0], LEAST))
    check(ratios)


def equivalents(unbalances: Sequence[Unbalance], planes: tuple[float, float]) -> tuple[Any, Any]:
    moments = [mp.mpf(u.mass) * mp.mpf(u.radius) * mp.expj(mp.mpf(u.angle)) for u in unbalances]
    low, high = map(mp.mpf, planes)
    arms = [mp.mpf(u.position) - low for u in unbalances]
    second = sum(arm * moment for arm, moment in zip(arms, moments, strict=True)) / (high - low)
    return sum(moments) - second, second


@pytest.mark.parametrize("scenes", SCENES)
def test_rotors(scenes: int) -> None:
    rng, ratios = np.random.default_rng(4), []
    with mp.workdps(40):
        for _ in range(scenes):
            begin = float(rng.choice([0.0, 1.0, 10.0]))
            unbalances = tuple(
                Unbalance(rng.uniform(0.01, 1), rng.uniform(0.01, 0.3), rng.uniform(0, 6.3), begin + rng.uniform(0, 1))
                for _ in range(int(rng.integers(1, 8)))
            )
            planes = begin + rng.uniform(0, 0.4), begin + rng.uniform(0.5, 1)
            rotor = Rotor(10.0, begin + 0.5, (begin, begin + 1), 100.0, unbalances)
            found = rotor_balance(rotor, planes)
            worst = 0.0
            for told, sign, at in ((found.moments, -1, planes), (found.before.equivalent, 1, rotor.bearings)):
                true = equivalents(unbalances, at)
                off = max(abs(mp.mpc(sign * a) - b) for a, b in zip(told, true, strict=True))
                worst = max(worst, float(off / max(map(abs, true))))
            ratios.append(found.error / max(worst, LEAST))
    check(ratios)
