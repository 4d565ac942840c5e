"""Rotors: corrections against the equilibrium of the turning body, tolerances against the standard's example."""

from __future__ import annotations

import cmath
import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from tmmcalc import UsageError
from tmmcalc.machine.balance.grades import (
    EXAMPLES,
    GRADES,
    grade_reached,
    permissible_eccentricity,
    permissible_unbalance,
    shared,
)
from tmmcalc.machine.balance.rotors import (
    Rotor,
    Unbalance,
    correction,
    rotor_balance,
    state,
    static_correction,
    two_plane_correction,
    verdict,
)
from tmmcalc.machine.balance.weights import Weight, sized

Array = NDArray[Any]


def drawn(seed: int, bearings: tuple[float, float] = (0.1, 0.9)) -> Rotor:
    rng = np.random.default_rng(seed)
    unbalances = tuple(
        Unbalance(*(float(v) for v in (rng.uniform(0.01, 0.2), rng.uniform(0.05, 0.3), rng.uniform(-3, 3), z)))
        for z in rng.uniform(-0.2, 1.2, size=4)
    )
    return Rotor(40.0, 0.45, bearings, 150.0, unbalances)


def bearing_forces(rotor: Rotor, masses: tuple[Unbalance, ...]) -> tuple[complex, complex]:
    """Forces of the rotor on its bearings by six equations of equilibrium in space with centrifugal forces."""
    a, b = rotor.bearings
    total, moment = np.zeros(3), np.zeros(3)
    for u in masses:
        place = np.array([u.radius * math.cos(u.angle), u.radius * math.sin(u.angle), u.position])
        pull = u.mass * rotor.speed**2 * np.array([place[0], place[1], 0.0])
        total += pull
        moment += np.cross(place, pull)
    # unknown reactions (ax, ay, bx, by): they cancel forces across and moments about x and y
    matrix = np.array([[1.0, 0, 1, 0], [0, 1, 0, 1], [0, -a, 0, -b], [a, 0, b, 0]])
    ax, ay, bx, by = np.linalg.solve(matrix, [-total[0], -total[1], -moment[0], -moment[1]])
    return complex(-ax, -ay), complex(-bx, -by)


@pytest.mark.parametrize("seed", range(5))
@pytest.mark.parametrize("bearings", [(0.1, 0.9), (0.9, 0.1), (0.5, 0.7)])
@pytest.mark.parametrize("planes", [(0.0, 1.0), (0.8, 0.3)])
def test_bearing_loads_before_and_after(seed: int, bearings: tuple[float, float], planes: tuple[float, float]) -> None:
    rotor = drawn(seed, bearings)
    balance = rotor_balance(rotor, planes, static_plane=0.6)
    scale = sum(abs(u.moment) for u in rotor.unbalances) * rotor.speed**2
    assert balance.before.loads == pytest.approx(bearing_forces(rotor, rotor.unbalances), abs=1e-12 * scale)
    single = correction(balance.static_moment, balance.static_plane, 0.25)
    pair = [correction(m, z, 0.2) for m, z in zip(balance.moments, planes, strict=True)]
    expected = bearing_forces(rotor, (*rotor.unbalances, single))
    assert balance.static.loads == pytest.approx(expected, abs=1e-11 * scale)
    assert abs(sum(balance.static.loads)) < 1e-12 * scale  # a couple is left
    assert abs(balance.static.loads[0]) > 1e-3 * scale
    assert balance.static.eccentricity < 1e-15
    assert max(map(abs, bearing_forces(rotor, (*rotor.unbalances, *pair)))) < 1e-12 * scale
    assert max(map(abs, balance.dynamic.loads)) < 1e-12 * scale
    assert abs(balance.dynamic.couple) < 1e-15
    assert balance.before.eccentricity == pytest.approx(abs(sum(u.moment for u in rotor.unbalances)) / 40.0)


def test_a_textbook_pair_of_planes() -> None:
    """One unbalance of 1 kg at 0.1 m, a quarter of the way between the planes: three quarters and one quarter."""
    one = [Unbalance(1.0, 0.1, 0.0, 0.25)]
    assert static_correction(one) == pytest.approx(-0.1)
    assert two_plane_correction(one, (0.0, 1.0)) == pytest.approx((-0.075, -0.025))
    opposite = [Unbalance(1.0, 0.1, 0.0, 0.0), Unbalance(1.0, 0.1, math.pi, 1.0)]
    assert abs(static_correction(opposite)) < 1e-16
    assert two_plane_correction(opposite, (0.0, 1.0)) == pytest.approx((-0.1, 0.1))
    hole = [Unbalance(1.0, 0.1, 0.3, 0.5), Unbalance(-0.5, 0.2, 0.3, 0.5)]
    assert abs(static_correction(hole)) < 1e-16


def test_sizes_of_corrections() -> None:
    moment = -0.03 * cmath.exp(0.4j)
    assert correction(moment, 0.2, 0.15).mass == pytest.approx(0.2)
    assert correction(moment, 0.2, 0.15).moment == pytest.approx(moment)
    assert sized(moment, mass=0.1).radius == pytest.approx(0.3)
    assert sized(moment, radius=0.15).moment == pytest.approx(moment)


def in_steps(weight: Weight) -> Weight:
    """In whole 5 g at every 10 degrees."""
    angle = math.radians(10 * round(math.degrees(weight.angle) / 10))
    return Weight(0.005 * round(weight.mass / 0.005), weight.radius, angle)


def test_corrections_as_made_and_the_verdict() -> None:
    """Weights in whole 5 g at every 10 degrees leave a residual that the state and the verdict tell."""
    rotor = drawn(3)
    balance = rotor_balance(rotor, (0.0, 1.0))
    made = [in_steps(sized(m, radius=0.2)) for m in balance.moments]
    fitted = [Unbalance(w.mass, w.radius, w.angle, z) for w, z in zip(made, balance.planes, strict=True)]
    now = state(rotor, fitted)
    errors = [w.moment - m for w, m in zip(made, balance.moments, strict=True)]
    assert now.resultant == pytest.approx(sum(errors), abs=1e-15)
    assert all(
        0 < abs(e) < 0.2 * 0.0025 + abs(m) * math.radians(5.1) for e, m in zip(errors, balance.moments, strict=True)
    )
    limits = [
        abs(u) / (permissible_unbalance(1.0, 40.0, 150.0) * share)
        for u, share in zip(now.equivalent, shared(1.0, 0.45, (0.1, 0.9)), strict=True)
    ]
    for factor, passed in ((1.0001, True), (0.9999, False)):
        told = verdict(rotor, now, max(limits) * factor)
        assert told.passed is passed
        assert ("keeps" in told.message) is passed
        assert f"plane {'AB'[int(np.argmax(limits))]}" in told.message
    assert told.value == pytest.approx(now.eccentricity * 150.0 * 1e3)
    assert told.reached == min(g for g in GRADES if g >= told.value)
    assert verdict(rotor, balance.dynamic, 0.4).passed
    assert verdict(rotor, balance.dynamic, 0.4).reached == 0.4
    worst = verdict(replace(rotor, mass=1e-3), balance.before, 4000.0)
    assert not worst.passed


def test_the_example_of_the_standard() -> None:
    """Turbine rotor of 3600 kg at 3000 rpm, G 2.5: U_per 28.6e3 g mm, shared 10.7e3 and 17.9e3 (ISO 1940-1)."""
    speed = 3000 * math.pi / 30
    assert permissible_eccentricity(2.5, speed) == pytest.approx(7.96e-6, rel=1e-3)
    total = permissible_unbalance(2.5, 3600.0, speed)
    assert total * 1e6 == pytest.approx(28.6e3, rel=3e-3)
    parts = shared(total, 1.5, (0.0, 2.4))
    assert [p * 1e6 for p in parts] == pytest.approx([10.7e3, 17.9e3], rel=5e-3)
    assert permissible_unbalance(6.3, 10.0, -speed) * 1e6 == pytest.approx(9549.297 * 6.3 * 10 / 3000, rel=1e-6)


@pytest.mark.parametrize(
    ("center", "parts"),
    [
        (0.5, (0.5, 0.5)),
        (0.4, (0.6, 0.4)),
        (0.05, (0.7, 0.3)),
        (0.9, (0.3, 0.7)),
        (-0.1, (1.1, 0.3)),
        (-0.8, (1.3, 0.8)),
    ],
)
def test_shares_of_the_bearing_planes(center: float, parts: tuple[float, float]) -> None:
    assert shared(2.0, center, (0.0, 1.0)) == pytest.approx((2 * parts[0], 2 * parts[1]))
    assert shared(2.0, center + 5, (6.0, 5.0)) == pytest.approx((2 * parts[1], 2 * parts[0]))


def test_grades() -> None:
    assert grade_reached(1e-6, 2500.0) == (2.5, 2.5)
    assert grade_reached(1e-6, 2501.0)[1] == 6.3
    assert grade_reached(0.0, 100.0) == (0.0, 0.4)
    assert grade_reached(1.0, 100.0)[1] is None
    assert sorted(EXAMPLES) == sorted(GRADES)


def test_faulty_rotors_are_refused() -> None:
    with pytest.raises(UsageError, match="mass 0 kg"):
        Rotor(0.0, 0.5, (0.0, 1.0), 100.0)
    with pytest.raises(UsageError, match=r"bearings at 0\.5 and 0\.5 m"):
        Rotor(1.0, 0.5, (0.5, 0.5), 100.0)
    with pytest.raises(UsageError, match=r"both planes lie at 0\.5 m"):
        two_plane_correction([Unbalance(1, 1, 0, 0)], (0.5, 0.5))
    with pytest.raises(UsageError, match="radius 0 m"):
        correction(1.0, 0.0, 0.0)
    with pytest.raises(UsageError, match="gives no tolerance"):
        permissible_eccentricity(6.3, 0.0)
    with pytest.raises(UsageError, match="gives no tolerance"):
        permissible_eccentricity(-1.0, 10.0)
    with pytest.raises(UsageError, match="both bearings"):
        shared(1.0, 0.0, (1.0, 1.0))
