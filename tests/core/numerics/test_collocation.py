"""Collocation against closed forms: periodic, initial and boundary problems, stiff ones, jumps, kinks, multipliers."""

from __future__ import annotations

import math
import warnings
from collections.abc import Callable

import numpy as np
import pytest

from tmmcalc.core.errors import AccuracyError
from tmmcalc.core.numerics.collocation import Orbit, initial, solve
from tmmcalc.core.numerics.gauss import rule
from tmmcalc.core.numerics.newton import Ends, Rates
from tmmcalc.core.numerics.panels import Panels, panels
from tmmcalc.core.numerics.radau import radau

TURN = 2 * math.pi
Scalar = Callable[[np.ndarray, np.ndarray], tuple[np.ndarray, np.ndarray]]


def points(on: Panels) -> np.ndarray:
    return on.edges[:-1, None] + on.width[:, None] * radau(on.order).points


def scalar(f: Scalar) -> Callable[[Panels], Rates]:
    """The system of one equation from f(x, y) -> (y', dy'/dy)."""

    def on(mesh: Panels) -> Rates:
        x = points(mesh)

        def rates(y: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
            slope, gain = f(x, y[0])
            return slope[None], np.broadcast_to(gain, x.shape)[None, None], y

        return rates

    return on


def settle(f: Scalar, guess: float = 0.0, on: Panels | None = None, **options: object) -> Orbit:
    mesh = panels(0.0, TURN) if on is None else on
    return solve(scalar(f), mesh, np.full((1, *mesh.x.shape), guess), **options)


@pytest.mark.parametrize("n", [2, 3, 5, 16, 24])
def test_radau_points_and_weights(n: int) -> None:
    r = radau(n)
    assert r.points[-1] == 1.0
    assert np.all(np.diff(r.points) > 0)
    for degree in range(2 * n - 1):  # exact to degree 2 n - 2, and no further
        assert r.primitive[-1] @ r.points**degree == pytest.approx(1 / (degree + 1), rel=4e-15)
    if n <= 5:
        assert abs(r.primitive[-1] @ r.points ** (2 * n - 1) - 1 / (2 * n)) > 1e-9
    p = np.polynomial.Legendre(np.linspace(1, -1, n), domain=[0, 1])
    values = p(r.points)
    gauss = rule(n).points
    np.testing.assert_allclose(r.primitive @ values, p.integ(lbnd=0)(r.points), atol=5e-15)
    np.testing.assert_allclose(r.to_gauss @ values, p(gauss), atol=1e-13)
    np.testing.assert_allclose(r.from_gauss @ p(gauss), values, atol=1e-13)
    np.testing.assert_allclose(r.interpolation(np.array([0.2, 0.7])) @ values, p([0.2, 0.7]), atol=1e-13)
    assert r.start @ values == pytest.approx(p(0.0), abs=2e-13)
    np.testing.assert_allclose(r.nodal, np.prod(1 - gauss[:, None] / r.points, axis=1), atol=1e-13)


def test_radau_points_of_three_stages() -> None:
    root = math.sqrt(6)
    np.testing.assert_allclose(radau(3).points, [(4 - root) / 10, (4 + root) / 10, 1.0], rtol=1e-15)


@pytest.mark.parametrize("rate", [1e-8, 1e-3, 0.1, 1.0, 30.0, 1e3, 1e5, 1e8, -0.5, -3.0])
def test_linear_equation_of_any_stiffness(rate: float) -> None:
    """y' = rate (1 - y) + cos x; the periodic solution is 1 + (rate cos x + sin x)/(1 + rate^2)."""
    orbit = settle(lambda x, y: (rate * (1 - y) + np.cos(x), np.array(-rate)), 0.3)
    exact = 1 + (rate * np.cos(orbit.panels.x) + np.sin(orbit.panels.x)) / (1 + rate * rate)
    np.testing.assert_allclose(orbit.y[0], exact, atol=3e-15 / min(abs(rate), 1.0))
    assert orbit.trace == pytest.approx(-TURN * rate, rel=1e-13)
    if abs(rate) <= 3:
        assert orbit.monodromy[0, 0] == pytest.approx(math.exp(-TURN * rate), rel=1e-11)
    assert orbit.iterations <= 4
    assert orbit.panels.count == 12
    np.testing.assert_allclose(orbit.edges[0, -1], orbit.edges[0, 0], rtol=1e-15)


def test_a_solution_that_hardly_varies_keeps_its_digits() -> None:
    """Closing the period on the state itself would leave the level wrong by rounding / (1 - multiplier) ~ 1e-2."""
    orbit = settle(lambda x, y: (1e-9 * (1e6 - y) + np.cos(x), np.array(-1e-9)), 9e5)
    exact = 1e6 + np.sin(orbit.panels.x) + 1e-9 * np.cos(orbit.panels.x)
    np.testing.assert_allclose(orbit.y[0], exact, rtol=1e-12)
    np.testing.assert_allclose(np.diff(orbit.y[0].ravel()), np.diff(np.sin(orbit.panels.x.ravel())), atol=5e-10)


@pytest.mark.parametrize("stiffness", [1.0, 1e2, 1e4, 1e7])
def test_nonlinear_equation(stiffness: float) -> None:
    """y' = cos x y + k (exp(2 sin x) - y^2) has the periodic solution exp(sin x)."""

    def f(x: np.ndarray, y: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        top = np.exp(np.sin(x))
        return np.cos(x) * y + stiffness * (top * top - y * y), np.cos(x) - 2 * stiffness * y

    orbit = settle(f, 2.0, floor=np.zeros(1))
    exact = np.exp(np.sin(orbit.panels.x))
    np.testing.assert_allclose(orbit.y[0], exact, rtol=2e-14)
    assert orbit.trace == pytest.approx(-2 * stiffness * TURN * float(np.i0(1.0)), rel=1e-12)
    assert np.max(np.abs(orbit.y[0] / exact - 1)) <= orbit.error


@pytest.mark.parametrize("rate", [3.0, 1e2, 1e4, 1e6])
def test_layers_after_jumps(rate: float) -> None:
    """y' = rate (S - y) with S = 1 up to x = 2 and S = -2 from there: exponentials on both sides."""
    cut = 2.0
    decay, rest = math.exp(-rate * cut), math.exp(-rate * (TURN - cut))
    first = (-2 * (1 - rest) + rest * (1 - decay)) / (1 - rest * decay)
    middle = 1 + (first - 1) * decay

    def exact(x: np.ndarray) -> np.ndarray:
        before = 1 + (first - 1) * np.exp(-rate * x)
        return np.where(x < cut, before, -2 + (middle + 2) * np.exp(-rate * np.maximum(x - cut, 0)))

    orbit = settle(
        lambda x, y: (rate * (np.where(np.broadcast_to(x[:, :1] < cut, x.shape), 1.0, -2.0) - y), np.array(-rate)),
        on=panels(0.0, TURN, [cut]),
    )
    error = np.max(np.abs(orbit.y[0] - exact(orbit.panels.x)))
    assert error < 1e-14 + 1e-15 * rate  # as far as the place itself is known
    assert error <= 2 * orbit.error + 1e-15 * rate
    assert orbit.passes <= 6
    near = cut + np.array([0.1, 0.5, 1.0, 2.0, 5.0, 12.0]) / rate
    np.testing.assert_allclose(orbit.panels.at(orbit.y[0], near), exact(near), atol=1e-11)


def test_order_of_convergence() -> None:
    """Radau IIA of n stages has the order 2 n - 1 at the ends of panels."""
    for n in (2, 3):
        errors = []
        for count in (8, 16, 32):
            mesh = Panels(np.linspace(0, 1, count + 1), n)
            orbit = settle(
                lambda x, y: (-4 * x * y, -4 * x), 1.0, mesh, ends=initial(np.ones(1)), tolerance=1.0, passes=1
            )
            errors.append(abs(orbit.edges[0, -1] - math.exp(-2)))
        slopes = np.log2(np.array(errors[:-1]) / errors[1:])
        np.testing.assert_allclose(slopes, 2 * n - 1, atol=0.2)


@pytest.mark.parametrize("rate", [1.0, 1e3, 1e6])
def test_initial_value_problem(rate: float) -> None:
    """Prothero and Robinson: y' = -rate (y - sin x) + cos x from y(0) = 1; y = sin x + exp(-rate x)."""
    orbit = settle(lambda x, y: (-rate * (y - np.sin(x)) + np.cos(x), np.array(-rate)), ends=initial(np.array([1.0])))
    x = orbit.panels.x
    np.testing.assert_allclose(orbit.y[0], np.sin(x) + np.exp(-rate * x), atol=2e-13)
    assert orbit.edges[0, 0] == 1.0


def oscillator(damping: float, frequency: float) -> Callable[[Panels], Rates]:
    """y'' + 2 damping y' + frequency^2 y = cos x as two states."""
    matrix = np.array([[0.0, 1.0], [-(frequency**2), -2 * damping]])

    def on(mesh: Panels) -> Rates:
        x = points(mesh)

        def rates(y: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
            f = np.einsum("ab,bkn->akn", matrix, y)
            f[1] += np.cos(x)
            return f, np.broadcast_to(matrix[..., None, None], (2, 2, *x.shape)), y

        return rates

    return on


@pytest.mark.parametrize(("damping", "frequency"), [(0.05, 0.7), (0.3, 3.5), (0.01, 1.0), (2.0, 0.5), (50.0, 1.0)])
def test_two_states_and_their_multipliers(damping: float, frequency: float) -> None:
    mesh = panels(0.0, TURN)
    orbit = solve(oscillator(damping, frequency), mesh, np.zeros((2, *mesh.x.shape)))
    gain = 1 / complex(frequency**2 - 1, 2 * damping)
    wave = gain * np.exp(1j * orbit.panels.x)
    size = max(abs(gain), 1.0)
    np.testing.assert_allclose(orbit.y[0], wave.real, atol=2e-13 * size)
    np.testing.assert_allclose(orbit.y[1], (1j * wave).real, atol=2e-13 * size)
    roots = np.roots([1, 2 * damping, frequency**2]).astype(complex)
    found = np.linalg.eigvals(orbit.monodromy)
    for expected in np.exp(TURN * roots):
        assert np.min(np.abs(found - expected)) < 1e-12
    assert orbit.trace == pytest.approx(-2 * damping * TURN, rel=1e-13)


def test_a_parameter_as_a_constant_state() -> None:
    """y' = p - 2 y + cos x, periodic, with y(0) = 3 given: p = 2 (3 - 2/5)."""
    mesh = panels(0.0, TURN)

    def on(panels_: Panels) -> Rates:
        x = points(panels_)

        def rates(y: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
            f, jacobian = np.zeros_like(y), np.zeros((2, *y.shape))
            f[0] = y[1] - 2 * y[0] + np.cos(x)
            jacobian[0, 0], jacobian[0, 1] = -2.0, 1.0
            return f, jacobian, y[:1]

        return rates

    ends = Ends(np.array([[-1.0, 0], [1, 0]]), np.array([[1.0, 0], [0, 0]]), np.array([0.0, 3.0]))
    orbit = solve(on, mesh, np.zeros((2, *mesh.x.shape)), ends=ends)
    np.testing.assert_allclose(orbit.y[1], 5.2, rtol=1e-14)
    assert orbit.edges[0, 0] == pytest.approx(3.0, rel=1e-15)


def bent(x: np.ndarray, y: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """y' = cos x - r y with r = 1 above zero and 4 below."""
    rate = np.where(y > 0, 1.0, 4.0)
    return np.cos(x) - rate * y, -rate


def bent_exactly(start: float) -> tuple[float, float]:
    """End of the piecewise solution from y(start) = 0 upwards, one turn later, and where it crosses downwards."""

    def piece(rate: float, a: float, b: float, y: float) -> float:
        def forced(x: float) -> float:
            return (rate * math.cos(x) + math.sin(x)) / (1 + rate * rate)

        return forced(b) + (y - forced(a)) * math.exp(-rate * (b - a))

    low, high = start + 1.0, start + 4.5
    for _ in range(100):
        middle = (low + high) / 2
        low, high = (middle, high) if piece(1.0, start, middle, 0.0) > 0 else (low, middle)
    return piece(4.0, low, start + TURN, 0.0), low


def test_kinks_at_the_solution_s_own_places() -> None:
    low, high = -1.5, 0.0
    for _ in range(100):  # the place where the solution comes up through zero
        middle = (low + high) / 2
        low, high = (low, middle) if bent_exactly(middle)[0] > 0 else (middle, high)
    up, down = low % TURN, bent_exactly(low)[1] % TURN

    def crossings(x: np.ndarray, watched: np.ndarray) -> np.ndarray:
        x, y = x.ravel(), watched.ravel()
        i = np.flatnonzero((y[:-1] < 0) != (y[1:] < 0))
        return x[i] - y[i] * (x[i + 1] - x[i]) / (y[i + 1] - y[i])

    def twice(x: np.ndarray, watched: np.ndarray) -> np.ndarray:
        return np.repeat(crossings(x, watched), 2)  # as of two equations that bend together

    plain, told, again = settle(bent), settle(bent, kinks=crossings), settle(bent, kinks=twice)
    assert np.all(again.panels.width > 0)
    for orbit in (plain, told, again):
        assert np.max(np.abs(orbit.panels.at(orbit.y[0], np.array([up, down])))) < 2e-12
    assert told.passes < plain.passes
    assert told.panels.count < plain.panels.count


def test_what_has_no_solution_is_refused() -> None:
    cases: list[tuple[Scalar, dict[str, object]]] = [
        (lambda x, y: (1 + y * y, 2 * y), {}),  # grows everywhere
        (lambda x, y: (1 + np.cos(x), np.array(0.0)), {}),  # no regulation at all
        (lambda x, y: (-1 - y, np.array(-1.0)), {"floor": np.zeros(1)}),  # the only solution is below the floor
        (lambda x, y: (np.where(x < 1.234, 1.0, -1.0) - y, np.array(-1.0)), {"passes": 2}),  # a jump no edge marks
    ]
    for f, options in cases:
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            with pytest.raises(AccuracyError):
                settle(f, 1.0, **options)


def test_a_jump_that_no_edge_marks_is_hunted_down() -> None:
    cut = 1.234
    orbit = settle(lambda x, y: (np.where(x < cut, 1.0, -1.0) - y, np.array(-1.0)))
    first = (-1 + 2 * math.exp(cut - TURN) - math.exp(-TURN)) / (1 - math.exp(-TURN))
    assert orbit.edges[0, 0] == pytest.approx(first, abs=1e-7)
    assert orbit.error > 1e-12


def test_a_good_guess_saves_steps() -> None:
    def f(x: np.ndarray, y: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        return np.cos(x) - np.sinh(y), -np.cosh(y)

    cold = settle(f)
    warm = solve(scalar(f), cold.panels, cold.y)
    assert warm.iterations < cold.iterations
    np.testing.assert_allclose(warm.y, cold.y, atol=1e-14)
