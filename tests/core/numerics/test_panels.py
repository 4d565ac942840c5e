"""Functions on panels: exact integrals, values, slopes and extremes; kinks, jumps and peaks are found and resolved."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from properties import examples

from tmmcalc.core.errors import AccuracyError
from tmmcalc.core.numerics.gauss import ORDER, rule
from tmmcalc.core.numerics.panels import LAID, MOST, NARROWEST, Panels, UnresolvedError, panels, resolved
from tmmcalc.core.numerics.peaks import peaks

TURN = 2 * math.pi


def sampled(f: Callable[[np.ndarray], np.ndarray], on: Panels) -> np.ndarray:
    return f(on.x)


@pytest.mark.parametrize("n", [2, 3, 8, ORDER, 24])
def test_rule_is_the_gauss_rule(n: int) -> None:
    t, w = np.polynomial.legendre.leggauss(n)
    r = rule(n)
    np.testing.assert_allclose(r.points, (t + 1) / 2, atol=2e-16)
    np.testing.assert_allclose(r.weights, w / 2, rtol=3e-13)  # numpy's own weights are good to 1e-13
    for degree in range(2 * n):
        assert r.weights @ r.points**degree == pytest.approx(1 / (degree + 1), rel=4e-15)


@pytest.mark.parametrize("n", [3, ORDER])
def test_matrices_are_exact_for_polynomials(n: int) -> None:
    r = rule(n)
    rng = np.random.default_rng(1)
    for _ in range(5):
        p = np.polynomial.Legendre(rng.uniform(-1, 1, n), domain=[0, 1])
        values = p(r.points)
        np.testing.assert_allclose(r.primitive @ values, p.integ(lbnd=0)(r.points), atol=3e-15)
        np.testing.assert_allclose(r.slope @ values, p.deriv()(r.points), atol=1e-14 * n**4)
        np.testing.assert_allclose(r.ends @ values, p([0.0, 1.0]), atol=2e-14)
        np.testing.assert_allclose(r.coefficients @ values, p.coef, atol=1e-14)


def test_integrals_of_smooth_functions_have_all_digits() -> None:
    on = panels(0.0, TURN)
    assert on.count == 12
    values = np.stack((np.cos(on.x) ** 2, np.exp(np.sin(on.x)), np.ones_like(on.x)))
    exact = [math.pi, TURN * float(np.i0(1.0)), TURN]
    np.testing.assert_allclose(on.total(values), exact, rtol=1e-15)
    points, edges = on.primitive(np.cos(on.x))
    np.testing.assert_allclose(points, np.sin(on.x), atol=1e-15)
    np.testing.assert_allclose(edges, np.sin(on.edges), atol=1e-15)
    x = np.array([0.0, 0.1, 2.5, math.pi, TURN])
    np.testing.assert_allclose(on.primitive_at(np.cos(on.x), x), np.sin(x), atol=1e-15)
    np.testing.assert_allclose(on.slope(np.sin(on.x)), np.cos(on.x), atol=2e-13)


def test_stacked_functions_are_those_alone() -> None:
    on = panels(0.0, 3.0, [1.0])
    rows = np.stack((np.cos(on.x), on.x**3)).reshape(2, 1, *on.x.shape)
    x = np.linspace(0, 3, 17)
    for i in range(2):
        np.testing.assert_array_equal(on.at(rows, x)[i, 0], on.at(rows[i, 0], x))
        np.testing.assert_array_equal(on.primitive(rows)[0][i, 0], on.primitive(rows[i, 0])[0])
        assert on.total(rows)[i, 0] == pytest.approx(on.total(rows[i, 0]), rel=1e-15)


def test_an_edge_belongs_to_the_panel_above_unless_asked_before() -> None:
    on = panels(0.0, 2.0, [1.0])
    step = np.where(on.x < 1, 3.0, on.x)
    assert on.at(step, np.array([1.0])) == pytest.approx(1.0, abs=1e-14)
    assert on.at(step, np.array([1.0]), before=True) == pytest.approx(3.0, abs=1e-14)
    np.testing.assert_allclose(on.at(step, np.array([0.0, 2.0]), before=True), [3.0, 2.0], atol=1e-14)
    np.testing.assert_allclose(on.at(step, np.array([0.0, 2.0])), [3.0, 2.0], atol=1e-14)
    low, high = on.ends(step)
    k = int(np.searchsorted(on.edges, 1.0))
    assert high[k - 1] == pytest.approx(3.0, abs=1e-14)
    assert low[k] == pytest.approx(1.0, abs=1e-14)
    assert on.at(step, on.x.ravel()) == pytest.approx(step.ravel(), rel=1e-15)


@given(st.lists(st.floats(-1, 1), min_size=ORDER, max_size=ORDER), st.floats(0, 1))
@examples(50)
def test_halving_changes_nothing(coefficients: list[float], place: float) -> None:
    p = np.polynomial.Legendre(coefficients, domain=[0, 1])
    whole = Panels(np.array([0.0, 1.0]))
    halves = whole.split(np.array([True]))
    assert halves.edges.tolist() == [0.0, 0.5, 1.0]
    x = np.array([place])
    assert halves.at(p(halves.x), x) == pytest.approx(whole.at(p(whole.x), x), abs=1e-13)
    assert halves.total(p(halves.x)) == pytest.approx(whole.total(p(whole.x)), abs=1e-14)


EXTREMES = [  # name, function, breaks, (least, place), (largest, place)
    ("cosine", lambda x: np.cos(x - 1), (), (-1.0, 1 + math.pi), (1.0, 1.0)),
    ("ends", lambda x: x, (), (0.0, 0.0), (TURN, TURN)),
    ("kink", lambda x: -np.abs(x - 2), (2.0,), (2 - TURN, TURN), (0.0, 2.0)),
    ("jump", lambda x: np.where(x < 3, x, x - 5), (3.0,), (-2.0, 3.0), (3.0, 3.0)),
    ("flat top", lambda x: -((x - 2.5) ** 4), (), (-((TURN - 2.5) ** 4), TURN), (0.0, 2.5)),
    ("narrow", lambda x: 1 / (1 + ((x - 4.2) / 0.05) ** 2), (), (None, None), (1.0, 4.2)),
    ("hardly varying", lambda x: 5 + 1e-7 * np.sin(x), (), (5 - 1e-7, 1.5 * math.pi), (5 + 1e-7, math.pi / 2)),
]


@pytest.mark.parametrize(("name", "f", "breaks", "least", "largest"), EXTREMES, ids=[e[0] for e in EXTREMES])
def test_extremes(
    name: str,
    f: Callable[[np.ndarray], np.ndarray],
    breaks: tuple[float, ...],
    least: tuple[float | None, float | None],
    largest: tuple[float, float],
) -> None:
    on, values, _ = resolved(lambda x: f(x)[None], panels(0.0, TURN, breaks))
    found = on.extremes(values[0])
    place = {"flat top": 5e-3, "hardly varying": 1e-5}.get(name, 1e-12)  # as far as rounding lets it be seen
    for (value, at), (expected, expected_at) in zip(found, (least, largest), strict=True):
        if expected is not None:
            assert value == pytest.approx(expected, rel=2e-15, abs=1e-13)
            assert at == pytest.approx(expected_at, abs=place)
    top, at_top = peaks(on, np.stack((values[0], -values[0])))
    size = {"flat top": 1e-11}.get(name, 1e-14) * float(np.max(np.abs(values)))
    assert top[0] == pytest.approx(found[1][0], abs=size)
    assert -top[1] == pytest.approx(found[0][0], abs=size)
    assert at_top[0] == pytest.approx(found[1][1], abs=2 * max(place, 1e-7))


def test_all_turning_points_are_found() -> None:
    on = panels(0.0, TURN)
    at, value = on.turning(np.sin(5 * on.x))
    for k in range(10):
        found = int(np.argmin(np.abs(at - (k + 0.5) * math.pi / 5)))
        assert at[found] == pytest.approx((k + 0.5) * math.pi / 5, abs=1e-13)
        assert value[found] == pytest.approx((-1.0) ** k, abs=1e-14)


@given(st.integers(0, 10_000))
@settings(max_examples=40, deadline=None)
def test_extremes_are_not_beaten_by_a_dense_sample(seed: int) -> None:
    rng = np.random.default_rng(seed)
    a, phase = rng.normal(size=6), rng.uniform(0, TURN, 6)
    on = panels(0.0, TURN)

    def f(x: np.ndarray) -> np.ndarray:
        return sum(a[k] * np.cos((k + 1) * x + phase[k]) for k in range(6))

    dense = f(np.linspace(0, TURN, 20001))
    (low, low_at), (high, high_at) = on.extremes(f(on.x))
    size = np.abs(a).sum()
    assert dense.min() - 1e-5 * size < low <= dense.min() + 1e-13 * size
    assert dense.max() + 1e-5 * size > high >= dense.max() - 1e-13 * size
    assert f(np.array(low_at)) == pytest.approx(low, abs=1e-13 * size)
    assert f(np.array(high_at)) == pytest.approx(high, abs=1e-13 * size)


def test_extremes_of_several_functions_are_those_of_each() -> None:
    """a + b cos(m x + p) lies between a - b and a + b, at angles in closed form."""
    on = panels(0.0, TURN)
    waves = [(0.3, 2.0, 1, 0.4), (-5.0, 0.1, 2, 2.0), (0.0, 7.0, 3, -1.0)]
    found = on.extremes_of(np.stack([a + b * np.cos(m * on.x + p) for a, b, m, p in waves]))
    for ((low, low_at), (high, high_at)), (a, b, m, p) in zip(found, waves, strict=True):
        assert (low, high) == pytest.approx((a - b, a + b), rel=2e-15, abs=1e-14)
        assert np.cos(m * low_at + p) == pytest.approx(-1, abs=1e-14)
        assert np.cos(m * high_at + p) == pytest.approx(1, abs=1e-14)


def test_a_constant_has_extremes() -> None:
    on = panels(0.0, 1.0)
    (low, _), (high, _) = on.extremes(np.full(on.x.shape, 7.0))
    assert low == pytest.approx(7.0, rel=1e-14)
    assert high == pytest.approx(7.0, rel=1e-14)


def test_breaks_become_edges_once() -> None:
    on = panels(0.0, 1.0, [0.5, 0.5 + 1e-12, -1.0, 0.0, 1.0, 2.0, 0.2], widest=0.3)
    assert {0.2, 0.5} <= set(on.edges.tolist())
    assert on.edges[0] == 0.0
    assert on.edges[-1] == 1.0
    assert np.all(on.width > NARROWEST)
    assert np.all(on.width <= 0.3 + 1e-12)
    assert np.sum(np.abs(on.edges - 0.5) < 1e-6) == 1


@pytest.mark.parametrize(
    ("low", "high", "count"), [(0.0, TURN, 12), (0.0, 2 * TURN, 24), (-1.0, 1.0, 4), (0.0, 0.1, 1)]
)
def test_panels_are_as_wide_as_allowed(low: float, high: float, count: int) -> None:
    assert panels(low, high).count == count


def test_smooth_functions_are_not_refined() -> None:
    first = panels(0.0, TURN)
    on, values, left = resolved(lambda x: np.stack((np.cos(x), 1e6 * np.sin(3 * x))), first)
    assert on.count == first.count
    assert left < 1e-13
    assert values.shape == (2, 12, ORDER)


ROUGH = [  # name, function, breaks, integral over [0, 4], error, most panels
    ("marked kink", lambda x: np.abs(x - 1.1), (1.1,), (1.1**2 + 2.9**2) / 2, 1e-15, 9),
    ("kink", lambda x: np.abs(x - 1.1), (), (1.1**2 + 2.9**2) / 2, 1e-13, 40),
    ("marked jump", lambda x: np.where(x < 1.1, x, 7.0), (1.1,), 1.1**2 / 2 + 2.9 * 7, 1e-15, 9),
    ("jump", lambda x: np.where(x < 1.1, x, 7.0), (), 1.1**2 / 2 + 2.9 * 7, 1e-7, 40),
    ("peak", lambda x: np.exp(-(((x - 1.7) / 0.01) ** 2)), (), 0.01 * math.sqrt(math.pi), 1e-13, 60),
    ("two poles", lambda x: 1 / (1e-4 + (x - 2.2) ** 2), (), None, 1e-13, 80),
    ("root", lambda x: np.sqrt(x), (), 16 / 3, 1e-13, 60),
]


@pytest.mark.parametrize(("name", "f", "breaks", "integral", "error", "most"), ROUGH, ids=[r[0] for r in ROUGH])
def test_rough_functions_are_resolved(
    name: str,
    f: Callable[[np.ndarray], np.ndarray],
    breaks: tuple[float, ...],
    integral: float | None,
    error: float,
    most: int,
) -> None:
    if integral is None:
        integral = (math.atan(1.8 / 1e-2) + math.atan(2.2 / 1e-2)) / 1e-2
    on, values, left = resolved(lambda x: f(x)[None], panels(0.0, 4.0, breaks))
    assert on.total(values)[0] == pytest.approx(integral, rel=error)
    assert on.count <= most
    np.testing.assert_array_equal(values[0], f(on.x))
    if name in ("jump", "root"):  # they end at the narrowest panel, and say so
        assert on.width.min() == pytest.approx(NARROWEST * 4, rel=0.5)
        assert left > 1e-13
    else:
        assert left <= 1e-13
        x = np.linspace(0, 4, 4001)
        assert np.max(np.abs(on.at(values[0], x) - f(x))) <= 1e-5 * np.max(np.abs(values))


def test_every_function_is_measured_by_its_own_size() -> None:
    """A small rough function beside a large smooth one is resolved; a scale says when it does not matter."""

    def f(x: np.ndarray) -> np.ndarray:
        return np.stack((1e9 + 0 * x, np.abs(x - 0.3)))

    first = panels(0.0, 1.0)
    fine, _, _ = resolved(f, first)
    assert fine.count > first.count + 10
    coarse, _, _ = resolved(f, first, scale=np.array([1e9, 1e15]))
    assert coarse.count == first.count


def test_the_tail_tells_the_error_of_a_panel() -> None:
    on = Panels(np.array([0.0, 1.0]))
    for width in (0.15, 0.3, 1.0):
        f = np.exp(-(((on.x - 0.4) / width) ** 2))
        x = np.linspace(0, 1, 301)
        error = np.max(np.abs(on.at(f, x) - np.exp(-(((x - 0.4) / width) ** 2))))
        assert error <= 3 * on.tail(f)[0] + 3e-15


def test_primitive_of_a_jump() -> None:
    on = panels(0.0, 2.0, [0.7])
    step = np.where(on.x < 0.7, 2.0, -1.0)
    x = np.array([0.3, 0.7, 1.0, 2.0])
    np.testing.assert_allclose(on.primitive_at(step, x), [0.6, 1.4, 1.1, 0.1], atol=1e-15)


def test_what_turns_too_often_is_given_up_with_its_number() -> None:
    with pytest.raises(UnresolvedError, match=f"{MOST} panels do not resolve it") as told:
        resolved(lambda x: np.sin(1e7 * x)[None], panels(0.0, TURN))
    assert told.value.turns > MOST
    assert 0 <= told.value.at < TURN
    assert told.value.exit_code == 4


def test_as_many_turns_as_there_is_room_for() -> None:
    on, values, left = resolved(lambda x: np.sin(2000 * x)[None] ** 2, panels(0.0, TURN))
    assert on.count < MOST
    assert left < 1e-12
    assert on.total(values[0]) == pytest.approx(math.pi, rel=1e-12)


def test_no_range_takes_panels_without_end() -> None:
    with pytest.raises(AccuracyError, match="takes more than"):
        panels(0.0, 1e12, widest=1.0)
    with pytest.raises(AccuracyError, match="jumps and kinks"):
        panels(0.0, 1.0, np.linspace(0.0, 1.0, LAID + 3))
