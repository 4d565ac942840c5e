"""The two steps of the course: tableau, printed numbers, order."""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from machine.transient.scenes import case
from tmmcalc.core.numerics.steps import MERSON, merson_step, rk4_step
from tmmcalc.machine.transient.stability import growth, stable_step


def f(x: float, y: Any) -> list[float]:
    return [y[0] - 2 * x / y[0]]


def test_the_worked_step() -> None:
    expected = case("dyn-merson-step")["expected"]
    y, error = merson_step(f, 0.0, [1.0], 0.2)
    assert y[0] == pytest.approx(expected["merson_y"], rel=1e-9)
    assert abs(error[0]) == pytest.approx(expected["merson_error_estimate"], rel=1e-5)
    assert rk4_step(f, 0.0, [1.0], 0.2)[0][0] == pytest.approx(expected["rk4_y"], rel=1e-9)


def march(step: Callable[..., Any], h: float) -> float:
    y = [1.0]
    for k in range(round(1 / h)):
        y = step(f, k * h, y, h)[0]
    return abs(y[0] - math.sqrt(3))


@pytest.mark.parametrize(("name", "step"), [("merson", merson_step), ("rk4", rk4_step)])
def test_errors_at_one_and_their_order(name: str, step: Callable[..., Any]) -> None:
    expected = case("dyn-merson-step")["expected"]["error_at_x1"]
    assert march(step, 0.1) == pytest.approx(expected["h_0_1"][name], rel=0.02)
    assert march(step, 0.05) == pytest.approx(expected["h_0_05"][name], rel=0.02)
    assert math.log2(march(step, 0.02) / march(step, 0.01)) == pytest.approx(4.0, abs=0.15)


def test_order_conditions_of_the_tableau() -> None:
    c, b, e = (np.array(part, dtype=float) for part in (MERSON.nodes, MERSON.weights, MERSON.error))
    a = np.array([(*row, *[0.0] * (5 - len(row))) for row in MERSON.rows])
    np.testing.assert_allclose(a.sum(axis=1), c, atol=1e-15)
    conditions = {
        1: b.sum(),
        1 / 2: b @ c,
        1 / 3: b @ c**2,
        1 / 6: b @ a @ c,
        1 / 4: b @ c**3,
        1 / 8: b @ (c * (a @ c)),
        1 / 12: b @ a @ c**2,
        1 / 24: b @ a @ a @ c,
    }
    np.testing.assert_allclose(list(conditions.values()), list(conditions), atol=1e-15)
    # the estimate vanishes to third order, so that it measures the fourth
    np.testing.assert_allclose([e.sum(), e @ c, e @ c**2, e @ a @ c], 0, atol=1e-15)


@pytest.mark.parametrize(("name", "step"), [("merson", merson_step), ("rk4", rk4_step)])
@pytest.mark.parametrize("direction", [180.0, 150.0, 120.0, 100.0, 92.0])
def test_the_polynomial_of_stability_is_what_a_step_does(name: str, step: Callable[..., Any], direction: float) -> None:
    """One step of dy/dt = lambda y, in two real components, multiplies the size by |R|; so does the bound."""
    way = cmath.rect(1.0, math.radians(direction))

    def grown(size: float) -> float:
        z = size * way
        turn = [[z.real, -z.imag], [z.imag, z.real]]
        y = step(lambda _, y: [a * y[0] + b * y[1] for a, b in turn], 0.0, [1.0, 0.0], 1.0)[0]
        return math.hypot(*y)

    for size in (0.3, 1.0, 2.5, 4.0):
        assert float(growth(name, np.array(size * way))) == pytest.approx(grown(size), rel=1e-14)
    bound = stable_step(name, np.array([1e6 * way, 1e6 * way.conjugate()]), 1e6) * 1e6
    assert grown(0.9999 * bound) < 1 < grown(1.0001 * bound)


def test_a_growth_that_the_duration_makes_little_of_is_let_pass() -> None:
    """A swing without damping, beyond the bound of 2.828: in a few steps it grows little, in many it explodes."""
    short, long = (stable_step("rk4", np.array([1000j, -1000j]), duration) for duration in (0.01, 30.0))
    assert long == pytest.approx(2.828e-3, rel=1e-3)
    assert short > 1.03 * long
    assert float(growth("rk4", np.array(1000j * short))) ** (0.01 / short) == pytest.approx(math.e, rel=1e-6)


def test_what_really_grows_bounds_no_step() -> None:
    assert stable_step("merson", np.array([50.0 + 0j]), 1.0) == math.inf
    assert stable_step("merson", np.zeros(3, complex), 1.0) == math.inf


def test_the_estimate_is_exact_for_linear_equations() -> None:
    y, error = merson_step(lambda _, y: [y[1], -y[0]], 0.0, [1.0, 0.0], 0.1)
    true = np.array([math.cos(0.1), -math.sin(0.1)])
    np.testing.assert_allclose(error, np.array(y) - true, rtol=0.05, atol=2e-9)


@pytest.mark.parametrize("step", [merson_step, rk4_step])
def test_integrals_need_no_stages(step: Callable[..., Any]) -> None:
    def g(x: float, y: Any) -> list[float]:
        return [y[0] - 2 * x / y[0], y[0] ** 2]

    whole, spared = step(g, 0.3, [1.2, 0.5], 0.1), step(g, 0.3, [1.2, 0.5], 0.1, None, 1)
    assert whole == spared
