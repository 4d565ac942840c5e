"""Estimated errors of flywheels bound the true ones in random machines, and are not far from them.

The truth under a motor is the fluctuation of the exact motion with the inertia found, and by how much more inertia that
changes; under forces of position the formulas of the methods on the work written out.
"""

from __future__ import annotations

from collections import defaultdict
from typing import Any

import numpy as np
import pytest
from bounding import RATE, assert_bounds, part

from machine.drawn import TURN, Drawn
from machine.exact import WIDE
from machine.flywheel.test_solve import wanted
from machine.test_estimates import THETA, missed, peak, primitive
from tmmcalc.core.errors import TmmError
from tmmcalc.machine.driver import ConstantInertia
from tmmcalc.machine.flywheel.required import required_inertia
from tmmcalc.machine.flywheel.solve import Machine, solve_flywheel
from tmmcalc.machine.flywheel.wittenbauer import METHODS

TANGENT = tuple(rule for rule in METHODS if rule.find is rule.draw)  # those that draw the tangents that they find
APART = 1e-4  # relative step of the inertia from which its derivative is taken


def lacking(machine: Drawn, found: Any, delta: float) -> tuple[float, float, float]:
    """True relative error of the inertia under the motor, of the speeds with it, and of their unevenness."""
    machine.constant = found.inertia
    exact = machine.exact(found.regime)
    machine.constant = found.inertia * (1 + APART)
    more = machine.exact(found.regime)
    off, slope = np.log(exact.delta / WIDE(delta)), np.log(more.delta / exact.delta) / np.log1p(WIDE(APART))
    speed = missed(found.regime.omega_at(THETA), exact.at(exact.omega, THETA), exact.omega)
    return float(abs(off / slope)), speed, missed(found.regime.delta, exact.delta, exact.delta)


@pytest.mark.parametrize("count", [1, pytest.param(part(200, 8), marks=pytest.mark.slow)])
def test_under_the_motor(count: int) -> None:
    rng, found = np.random.default_rng(22), defaultdict[str, list[tuple[float, float]]](list)
    while len(found["speed"]) < count:
        machine = Drawn(rng, slips=(-3, -1), lagging=0.2)
        try:
            delta = machine.regime().delta * rng.uniform(0.3, 0.8)
            wheel = required_inertia(machine.cycle, machine.motor, delta, machine.constant, machine.lag)
            if not wheel.needed or machine.bends(wheel.regime):
                continue
            inertia, speed, fluctuation = lacking(machine, wheel, delta)
        except (TmmError, RuntimeError):
            continue
        found["inertia"].append((wheel.error, inertia))
        found["speed"].append((wheel.regime.error, speed))
        found["fluctuation"].append((wheel.regime.errors.fluctuation, fluctuation))
    # the unevenness is told as that of every regime is, and its usefulness held there
    assert np.mean([told >= error for told, error in found.pop("fluctuation")]) >= RATE
    for key, told in found.items():
        assert_bounds(told, key, scenes=count)


@pytest.mark.parametrize("count", [1, pytest.param(part(200, 8), marks=pytest.mark.slow)])
def test_under_forces_of_position(count: int) -> None:
    """The inertias of all methods by their own formulas, and the unevenness with the exact one by the energy."""
    rng, told, uneven = np.random.default_rng(24), list[tuple[float, float]](), list[tuple[float, float]]()
    while len(told) < count:
        machine = Drawn(rng)
        if machine.viscous or machine.jumps:
            continue
        delta = 10 ** rng.uniform(-3, -0.7)
        found = solve_flywheel(Machine(machine.cycle, ConstantInertia(), wanted(delta), None, machine.speed, 1.0))
        if found.inertia <= 0:
            continue
        exact = by_methods(machine, delta)
        told.append((found.error, float(abs(found.inertia / exact[0] - 1))))
        constant = found.inertia * rng.choice([1, 10, 1e6])
        again = solve_flywheel(
            Machine(machine.cycle, ConstantInertia(constant), wanted(delta), None, machine.speed, 1.0)
        )
        reached = unevenness(machine, constant)
        uneven.append((again.uneven, missed(again.rows[0].positional.delta, reached, reached)))
        rows = {row.positional.method: row for row in found.rows}
        for rule, inertia in zip(TANGENT, exact, strict=True):
            row = rows[rule.name]
            assert abs(row.positional.inertia - inertia) < 3 * found.error * abs(exact[0]) + 1e-15 * abs(inertia)
    assert_bounds(told, "inertia", scenes=count)
    assert_bounds(uneven, "fluctuation", scenes=count)


def unevenness(machine: Drawn, constant: float) -> Any:
    """The exact delta: the intercepts of the tangents with the slopes omega^2/2 are J_c times the slopes apart."""
    turn, w = WIDE(TURN), WIDE(machine.speed)
    fine = np.linspace(0, turn, 8001, dtype=WIDE)
    work, links = primitive(machine, -primitive(machine, WIDE(0), turn) / turn, fine), machine.links(fine)

    def left(delta: Any) -> Any:
        fast, slow = ((w + side * delta * w / 2) ** 2 / 2 for side in (1, -1))
        return peak(work - fast * links) + peak(slow * links - work) - constant * w * w * delta

    one, two = WIDE(0), left(WIDE(0)) / (constant * w * w)
    for _ in range(9):
        first, second = left(one), left(two)
        if first == second:
            break
        one, two = two, two - second * (two - one) / (second - first)
    return two


def by_methods(machine: Drawn, delta: float) -> list[Any]:
    """J_F of every method: intercepts of the tangents of its slopes, from the work written out."""
    turn, square, d = WIDE(TURN), WIDE(machine.speed) ** 2, WIDE(delta)
    fine = np.linspace(0, turn, 8001, dtype=WIDE)
    work, links = primitive(machine, -primitive(machine, WIDE(0), turn) / turn, fine), machine.links(fine)
    found = []
    for rule in TANGENT:
        one, none = (WIDE(1), WIDE(1)), (WIDE(0), WIDE(0))
        squares = {"true": ((1 + d / 2) ** 2, (1 - d / 2) ** 2), "dropped": (1 + d, 1 - d), "mean": one, "none": none}
        most, least = squares[rule.find]
        high, low = peak(work - most * square / 2 * links), -peak(least * square / 2 * links - work)
        found.append((high - low) / (d * square))
    return found
