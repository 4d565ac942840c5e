"""The small calculators against other methods: quadrature, differential equations, closed forms, dense solutions."""

from __future__ import annotations

from dataclasses import replace
from math import exp, pi, radians
from typing import Any

import numpy as np
import pytest
from scipy.integrate import dblquad, quad, solve_ivp
from scipy.special import ellipe, ellipk

import tmmcalc
from tmmcalc.core.errors import AccuracyError, NoSolutionError, UsageError
from tmmcalc.extras.activeset import active_set
from tmmcalc.extras.contact import ContactTask, GapTable
from tmmcalc.extras.falling_ball import BallTask
from tmmcalc.extras.hertz import hertz
from tmmcalc.extras.influence import hexagon, influence, settlement
from tmmcalc.extras.reliability import LifeTest, ReliabilityTask
from tmmcalc.extras.tie_down import Support, TieDownTask

pytestmark = pytest.mark.slow


def pyramid(x: float, y: float) -> float:
    """The unit hexagonal pyramid at the origin."""
    turn = np.radians(30.0 + 60.0 * np.arange(6))
    return max(0.0, 1 - float(np.max(x * np.cos(turn) + y * np.sin(turn))) / (3**0.5 / 2))


@pytest.mark.parametrize(("i", "j"), [(2, 1), (3, -2)])
def test_influence_outside_is_the_integral(i: int, j: int) -> None:
    at = i + j / 2, j * 3**0.5 / 2
    found = dblquad(lambda y, x: pyramid(x, y) / np.hypot(x - at[0], y - at[1]), -1, 1, -0.9, 0.9, epsabs=1e-7)[0]
    assert influence(np.array([i]), np.array([j]))[0] == pytest.approx(found, abs=2e-6)


def test_influence_is_symmetric_and_ends_as_that_of_a_point() -> None:
    i, j = hexagon(6)
    w = influence(i, j)
    assert np.allclose(w, influence(-j, i + j), rtol=1e-12)  # turned by 60 deg
    assert np.allclose(w, influence(j, i), rtol=1e-12)
    far = influence(np.array([60, 160]), np.zeros(2, int))
    assert np.all(np.abs(far * [60, 160] / (3**0.5 / 2) - 1) < [3e-5, 5e-6])
    assert influence(np.array([0, 1]), np.array([0, 0])) == pytest.approx(
        [1.5 * 3**0.5 * np.log(3), 3**0.5 / 2 * np.log(3)], rel=1e-14
    )


def test_the_active_set_is_that_of_the_quadratic_programme() -> None:
    from scipy.optimize import nnls

    i, j = hexagon(5)
    w = influence((i[:, None] - i).ravel(), (j[:, None] - j).ravel()).reshape(len(i), -1)
    gap = 0.3 * ((i + j / 2) ** 2 + 0.5 * j**2) * (1 + 0.2 * np.cos(3.0 * i))
    q, delta, opening, touching, _ = active_set(settlement(i, j), gap, 2.0, np.ones(len(i), bool))
    assert q.sum() == pytest.approx(2.0, rel=1e-12)
    assert np.allclose((w @ q + gap - delta)[touching], 0, atol=1e-10)
    assert np.all((w @ q + gap - delta)[~touching] > 0)
    assert np.allclose(opening, w @ q + gap - delta, atol=1e-10)
    root = np.linalg.cholesky(w)  # min 1/2 q'Wq + q'(h - delta), q >= 0, at the same approach
    other, _ = nnls(root.T, np.linalg.solve(root, delta - gap))
    assert np.allclose(other, q, atol=1e-9)


@pytest.mark.parametrize("ratio", [1.0, 1.0 + 1e-9, 3.0, 50.0, 1e4])
def test_hertz_by_complete_elliptic_integrals(ratio: float) -> None:
    load, modulus, rx = 700.0, 1.1e11, 0.02
    found = hertz(load, modulus, (rx, ratio * rx))
    b, a = found.along_x, found.along_y
    assert a >= b
    assert found.peak == pytest.approx(1.5 * load / (pi * a * b), rel=1e-12)
    e2 = 1 - (b / a) ** 2
    if ratio > 2:
        big, small = ellipk(e2), ellipe(e2)
        curved, flat = (small * (a / b) ** 2 - big, big - small)
        factor = found.peak * b / (modulus * e2 * a**2)
        assert factor * curved == pytest.approx(1 / (2 * rx), rel=1e-9)
        assert factor * flat == pytest.approx(1 / (2 * ratio * rx), rel=1e-9)
        assert found.approach == pytest.approx(found.peak * b * big / modulus, rel=1e-9)
    else:
        assert a == pytest.approx((0.75 * load * rx / modulus) ** (1 / 3), rel=1e-8)


def test_contact_converges_to_hertz_and_tells_its_change() -> None:
    errors = []
    for cells in (10, 20, 40):
        found = tmmcalc.solve_contact(ContactTask(1e3, 1.13e11, (0.02, 0.04), cells=cells))
        assert found.hertz is not None
        errors.append(abs(found.approach / found.hertz.approach - 1))
        assert errors[-1] < 5 * found.approach_change
        assert found.load_error < 1e-12
        assert np.all(found.pressure >= 0)
        assert np.all(found.opening > -1e-12)
    assert errors[2] < errors[1] < errors[0] < 0.01


@pytest.mark.parametrize(("load", "warned"), [(1e3, False), (1e9, True)])
def test_a_contact_as_large_as_its_body_is_warned_of(load: float, warned: bool) -> None:
    found = tmmcalc.solve_contact(ContactTask(load, 1.13e11, (0.02, 0.04), cells=8))
    assert found.hertz is not None
    assert (found.hertz.along_x > 0.3 * 0.02) == warned
    assert any("half-axis" in note for note in found.notes) == warned


def test_gaps_by_formula_and_table_are_those_of_radii() -> None:
    size = 1e-3
    by_radii = tmmcalc.solve_contact(ContactTask(1e3, 1.13e11, (0.02, 0.04), cells=12, size=size))
    formula = "x**2/(2*0.02) + y**2/(2*0.04)"
    by_formula = tmmcalc.solve_contact(ContactTask(1e3, 1.13e11, formula=formula, cells=12, size=size))
    x = tuple(np.linspace(-1.2e-3, 1.2e-3, 9))
    rows = tuple(tuple(a**2 / 0.04 + b**2 / 0.08 for a in x) for b in x)
    by_table = tmmcalc.solve_contact(ContactTask(1e3, 1.13e11, table=GapTable(x, x, rows), cells=12, size=size))
    for other in (by_formula, by_table):
        assert other.approach == pytest.approx(by_radii.approach, rel=1e-9)
        assert np.allclose(other.pressure, by_radii.pressure, atol=1e-6 * by_radii.peak)


def test_a_flat_punch_sinks_as_in_closed_form() -> None:
    found = tmmcalc.solve_contact(ContactTask(1.0, 1.0, formula="0 if x**2 + y**2 < 1 else 10", size=1.5, cells=40))
    assert found.approach == pytest.approx(0.5, rel=5e-3)  # P/(2 a E*)


def test_contacts_that_are_not_told() -> None:
    with pytest.raises(NoSolutionError, match="too few"):
        tmmcalc.solve_contact(ContactTask(1.0, 1e9, (1.0, 1.0), cells=6, size=1.0))
    with pytest.raises(UsageError, match="no finite value at x"):
        tmmcalc.solve_contact(ContactTask(1.0, 1.0, formula="1/x", size=1.0))
    table = GapTable((-0.5, 0.0, 0.5), (-1.0, 0.0, 1.0), ((0.0, 0.0, 0.0),) * 3)
    with pytest.raises(UsageError, match="the table of the gap does not"):
        tmmcalc.solve_contact(ContactTask(1.0, 1.0, table=table, size=1.0))
    wide = tmmcalc.solve_contact(ContactTask(1.0, 1.0, formula="0", size=1.0))
    assert "border" in wide.notes[0]


PRODUCTS = [
    (2.0, 2.5, 0.36, 2.5594, 2.567e-4),
    (0.0, 2.5, 0.36, 3.0, 0.02),
    (2.0, 2.5, 0.36, 2.2, 0.01),
    (1.0, 2.5, 0.02, 5.0, 0.3),
    (2.0, 2.5, 0.36, 1.5, 0.01),
]


@pytest.mark.parametrize(("a", "b", "h", "r", "beta"), PRODUCTS)
def test_reliability_is_the_integral_of_the_intensity(a: float, b: float, h: float, r: float, beta: float) -> None:
    task = ReliabilityTask(a, b, h, r, beta)
    found = tmmcalc.solve_reliability(task)

    def intensity(t: float) -> float:
        return h * min(max((b - r * exp(-beta * t)) / (b - a), 0.0), 1.0)

    edges = [t for t in (found.threshold, found.floor) if t]
    for k in (20, 60, 100):
        t = float(found.t[k])
        inside = [edge for edge in edges if edge < t]
        hazard = quad(intensity, 0, t, points=inside or None, epsabs=1e-13, epsrel=1e-12)[0]
        assert found.kept[k] == pytest.approx(exp(-hazard), rel=1e-9)
    solution = solve_ivp(
        lambda t, y: [-intensity(t), np.exp(y[0])],
        (0, 60 * found.mean),
        [0, 0],
        rtol=1e-10,
        atol=1e-12,
        max_step=found.mean / 40,
    )
    assert found.mean == pytest.approx(solution.y[1][-1], rel=1e-6)
    for part, life in found.lives:
        hazard = quad(intensity, 0, life, points=[e for e in edges if e < life] or None, epsabs=1e-13)[0]
        assert exp(-hazard) == pytest.approx(part, rel=1e-9)


def test_shocks_without_end_fail_at_once() -> None:
    """At an immense rate of shocks the mean life is the threshold t0, and nothing overflows."""
    found = tmmcalc.solve_reliability(ReliabilityTask(2, 2.5, 1e200, strength=2.6, decay=1e-3))
    assert found.mean == pytest.approx(1e3 * np.log(2.6 / 2.5), rel=1e-12)


def test_estimates_satisfy_their_equations() -> None:
    found = tmmcalc.solve_reliability(ReliabilityTask(2, 2.5, 0.36, test=LifeTest(30, 100, 150)))
    assert found.mean == pytest.approx(150, rel=1e-10)
    t = np.linspace(99, 101, 20001)  # density of the shortest of 30 lives
    x = found.strength * np.exp(-found.decay * t)
    hazard = 0.36 * (2.5 - x) / 0.5
    log_r = -np.concatenate(([0.0], np.cumsum((hazard[1:] + hazard[:-1]) / 2 * np.diff(t))))
    assert t[np.argmax(np.log(hazard) + 30 * log_r)] == pytest.approx(100, abs=2e-4)
    with pytest.raises(NoSolutionError, match="no decay of the strength"):
        tmmcalc.solve_reliability(ReliabilityTask(2, 2.5, 0.36, test=LifeTest(30, 100, 100.1)))


BALLS = [
    BallTask(1e-3, 1e-4, 0.5, sign=-1, relative=10.0, initial=7.0, duration=3.0, times=(0.3, 2.5)),
    BallTask(1e-3, 1e-4, 0.5, sign=-1, relative=4.0, initial=30.0, duration=6.0, times=(0.01, 5.0)),
    BallTask(1e-3, 1e-4, 0.5, relative=4.0, duration=6.0, times=(0.5, 5.0)),
    BallTask(1e-3, 1e-4, 0.5, sign=-1, relative=9.81 / 1.5, initial=2.0, duration=4.0, times=(1.0,)),
    BallTask(1e-3, 1e-4, 0.5, relative=None, initial=50.0, duration=8.0, times=(0.1, 8.0)),
    BallTask(1e-3, 1e-4, 0.5, sign=-1, relative=None, duration=8.0, times=(0.1, 8.0)),
    BallTask(1e-5, 1e-1, 1e-3, initial=0.0, duration=1.0, times=(0.005, 1.0)),
    BallTask(1e-3, 1e-4, 0.5, sign=-1, relative=10.0, duration=2.0, times=(1.0,)),
]


@pytest.mark.parametrize("task", BALLS)
def test_balls_by_the_differential_equation(task: BallTask) -> None:
    found = tmmcalc.solve_falling_ball(task)

    def slope(t: float, y: list[float]) -> list[float]:
        speed = y[0]
        v = speed if task.relative is None else task.relative
        drag = task.drag / task.radius * np.exp(task.decay * t) * speed * abs(speed)
        return [task.gravity - drag + 3 * task.sign * task.decay * v, speed]

    at = [each.t for each in found.asked]
    method = "LSODA" if task.drag > 0.01 else "DOP853"
    solution = solve_ivp(
        slope,
        (0, found.t[-1]),
        [task.initial, 0.0],
        method=method,
        rtol=1e-11,
        atol=1e-13,
        t_eval=sorted({*at, float(found.t[-1])}),
    )
    exact = dict(zip(solution.t, solution.y.T, strict=True))
    for each in found.asked:
        assert each.v == pytest.approx(exact[each.t][0], rel=1e-7, abs=1e-9)
        assert each.way == pytest.approx(exact[each.t][1], rel=1e-7, abs=1e-9)
    assert found.way[-1] == pytest.approx(exact[float(found.t[-1])][1], rel=1e-7)
    turned = np.gradient(found.v, found.t)[5:-5]
    away = np.abs(found.t[5:-5] - (found.stop.t if found.stop else -1.0)) > 3 * found.t[1]
    steep = np.max(np.abs(found.a))
    assert np.all(np.abs(turned - found.a[5:-5])[away] < 0.02 * steep)
    assert np.isfinite(found.error["way"])


def test_a_ball_without_balance_has_its_whole_way() -> None:
    found = tmmcalc.solve_falling_ball(BallTask(1e-3, 1e-4, 0.5, relative=4.0))
    end = tmmcalc.solve_falling_ball(BallTask(1e-3, 1e-4, 0.5, relative=4.0, times=(150.0,)))
    assert found.stop is None
    assert found.total == pytest.approx(end.asked[0].way, rel=1e-9)
    with pytest.raises(AccuracyError, match="Bessel"):
        tmmcalc.solve_falling_ball(BallTask(1e-9, 10.0, 1e-6, sign=-1, relative=1e9, initial=1.0))


def ties(**given: Any) -> TieDownTask:
    usual = TieDownTask(weight=5e4, factor=0.9, elevation=radians(30), plan=radians(10), friction=0.4)
    return replace(usual, **given)


def test_ties_balance_the_load() -> None:
    for preload in (2e3, 8e3, 1e4, 3e4):
        task = ties(preload=preload)
        found = tmmcalc.solve_tie_down(task)
        high = found.balanced
        low = max(2 * preload - high, 0.0) if found.held == "all ties" else 0.0 if found.held == "two ties" else high
        press = 5e4 + 2 * (high + low) * np.sin(task.elevation)
        along = 2 * (high - low) * np.cos(task.elevation) * np.cos(task.plan)
        if found.held == "friction":
            assert 0.4 * press >= 4.5e4
        else:
            assert 0.4 * press + along == pytest.approx(4.5e4, rel=1e-12)


def test_the_best_elevation_has_the_least_force() -> None:
    best = tmmcalc.solve_tie_down(ties()).best_elevation
    forces = [tmmcalc.solve_tie_down(ties(elevation=best + step)).force for step in (-0.01, 0.0, 0.01)]
    assert forces[1] < min(forces[0], forces[2])
    with pytest.raises(NoSolutionError, match="leaves its cradle"):
        tmmcalc.solve_tie_down(TieDownTask(1e4, 1.0, 0.5, 0.0, 0.3, support=Support(0, 0.2, 2.0, 0.1, 0.1, 3.0)))
