"""Counterweights on the crank and on geared shafts: optimality against other optimisers, and turning weights."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import replace
from itertools import combinations

import numpy as np
import pytest
from linkage.scenes import crank_slider, four_bar, yoke
from scipy.optimize import least_squares, minimize
from sparing import sparing

from machine.balance.balanced import PRESS, SCENES, TURN, Array, Scene, derivative, scene
from tmmcalc import UsageError
from tmmcalc.core.numerics.fourier import Series
from tmmcalc.linkage.loading import Body
from tmmcalc.machine.balance.circle import enclosing_circle, smallest_circle
from tmmcalc.machine.balance.schemes import (
    Balance,
    RotatingWeight,
    lanchester,
    least_squares_counterweight,
    minimax_counterweight,
    rotating_weights,
    with_weights,
)
from tmmcalc.machine.balance.shaking import Shaking, crank_angle, crank_pivot, shaking
from tmmcalc.machine.balance.weights import Weight, sized

SPEED = -6.0
X = np.arange(96) * TURN / 96


def solved(make: Callable[[], Scene], acceleration: float = 0.0) -> Shaking:
    case = make()
    return shaking(case.chain, case.bodies, X, SPEED, acceleration)


every_scene = pytest.mark.parametrize("make", SCENES.values(), ids=SCENES)


@every_scene
@sparing("acceleration", [0.0, 15.0], every=4)
def test_least_squares_is_what_an_optimiser_finds(make: Callable[[], Scene], acceleration: float) -> None:
    """The static moment that scipy finds for the mean square over a dense turn, with the force of a turning mass."""
    found = solved(make, acceleration)
    best = least_squares_counterweight(found)
    force = found.series.even(4096) * np.exp(-1j * np.arange(4096) * TURN / 4096)

    def left(u: Array) -> Array:
        rest = force + complex(*u) * (SPEED**2 - 1j * acceleration)
        return np.concatenate((rest.real, rest.imag))

    other = least_squares(left, [0.0, 0.0], xtol=1e-15, ftol=1e-15, gtol=1e-15)
    (weight,) = best.weights
    scale = found.scale / SPEED**2
    assert abs(weight.moment - complex(*other.x)) < 1e-9 * scale
    assert best.after.rms == pytest.approx(math.sqrt(2 * other.cost / 4096), rel=1e-12)
    assert best.after.rms**2 + abs(found.series.coefficient(1)) ** 2 == pytest.approx(found.size.rms**2, rel=1e-12)
    assert best.moment_after == best.moment_before  # a weight about the pivot has no moment there


@every_scene
def test_minimax_is_what_an_optimiser_finds(make: Callable[[], Scene]) -> None:
    found = solved(make)
    best, mean = minimax_counterweight(found), least_squares_counterweight(found)
    hodograph = found.series.turned(-1).even(2**14)

    def largest(u: Sequence[float]) -> float:
        return float(np.max(np.abs(hodograph + complex(*u))))

    start = mean.weights[0].amplitude(SPEED)
    options = {"xatol": 1e-13 * found.scale, "fatol": 1e-15 * found.scale, "maxiter": 4000}
    other = minimize(largest, [start.real, start.imag], method="Nelder-Mead", options=options)
    amplitude = best.weights[0].amplitude(SPEED)
    assert largest([amplitude.real, amplitude.imag]) <= other.fun * (1 + 1e-7)
    assert best.after.largest == pytest.approx(other.fun, rel=1e-6)  # the optimiser sees samples only
    assert best.after.largest <= mean.after.largest * (1 + 1e-14)
    assert best.after.rms >= mean.after.rms * (1 - 1e-14)
    assert 0 <= best.gap < 1e-13


@every_scene
def test_minimax_touches_where_nothing_can_be_gained(make: Callable[[], Scene]) -> None:
    """Optimality of the circle: its contacts are on it and hold its centre between them, and all else is inside."""
    curve = solved(make).series.turned(-1)
    circle = enclosing_circle(curve)
    touched = curve.at(np.array(circle.contacts)) - circle.center
    assert 2 <= len(touched) <= 3
    np.testing.assert_allclose(np.abs(touched), circle.radius, rtol=1e-13)
    matrix = np.array([touched.real, touched.imag, np.full(len(touched), circle.radius)])
    held, rest = np.linalg.lstsq(matrix, np.array([0, 0, circle.radius]), rcond=None)[:2]
    assert np.all(held > -1e-9)
    assert np.sum(rest) < 1e-26 * circle.radius**2
    assert np.max(np.abs(curve.even(20000) - circle.center)) <= circle.radius * (1 + 1e-13)


@pytest.mark.parametrize("seed", range(40))
def test_the_smallest_circle_around_points_against_all_pairs_and_triples(seed: int) -> None:
    rng = np.random.default_rng(seed)
    points = rng.normal(size=9) + 1j * rng.normal(size=9) * rng.choice([1, 1e-6]) + 1e3 * (seed % 3)
    if seed % 4 == 0:
        points = np.round(points, 0)  # equal and collinear ones
    best = math.inf
    for size in (2, 3):
        for some in combinations(points, size):
            center = np.mean(some)
            if size == 3:
                matrix = 2 * np.array([[(p - some[0]).real, (p - some[0]).imag] for p in some[1:]])
                if abs(np.linalg.det(matrix)) < 1e-12:
                    continue
                place = np.linalg.solve(matrix, [abs(p - some[0]) ** 2 for p in some[1:]])
                center = some[0] + complex(*place)
            best = min(best, float(np.max(np.abs(points - center))))
    center, radius, support = smallest_circle(points)
    assert radius == pytest.approx(best, rel=1e-9, abs=1e-12)
    assert np.max(np.abs(points - center)) <= radius + 1e-12 * np.max(np.abs(points))
    assert len(support) <= 3


@pytest.mark.parametrize(
    ("coefficients", "center", "radius"),
    [
        ([0.2, 3 + 1j, 0.7], 3 + 1j, 0.9),  # an ellipse: half its longer axis
        ([0, 2 - 1j, 0.5], 2 - 1j, 0.5),  # a circle itself
        ([0, 5j, 0], 5j, 0.0),  # a point
        ([1, 0, 0, 0, 1], 0, 2.0),  # a stroke to and fro, run through twice
        ([0.3, 0, 0, 0, 1], 0, 1.3),
        ([0, 0.1, 0, 1, 0], 0, 1.1),
    ],
)
def test_circles_known_beforehand(coefficients: list[complex], center: complex, radius: float) -> None:
    circle = enclosing_circle(Series(np.array(coefficients, complex)))
    assert circle.center == pytest.approx(center, abs=1e-14)
    assert circle.radius == pytest.approx(radius, abs=1e-14)
    assert circle.gap < 1e-14


def test_a_deltoid_touches_at_three_places() -> None:
    """2 exp(it) + exp(-2it) has its cusps at the distance 3."""
    circle = enclosing_circle(Series(np.array([1, 0, 0, 2, 0], complex)).plus({0: 0.4 - 0.2j}))
    assert circle.center == pytest.approx(0.4 - 0.2j, abs=1e-14)
    assert circle.radius == pytest.approx(3.0, rel=1e-14)
    np.testing.assert_allclose(np.exp(3j * np.array(circle.contacts)), 1.0, atol=1e-6)


@pytest.mark.parametrize("seed", range(10))
def test_the_smallest_circle_around_random_curves(seed: int) -> None:
    rng = np.random.default_rng(seed)
    highest = 1 + seed
    curve = Series((rng.normal(size=2 * highest + 1) + 1j * rng.normal(size=2 * highest + 1)) / 2)
    circle = enclosing_circle(curve)
    sampled = smallest_circle(curve.even(2**15))
    assert sampled[1] <= circle.radius * (1 + 1e-14) <= sampled[1] * (1 + 1e-6)
    assert circle.gap <= 1e-13 * circle.radius


def on_crank(case: Scene, weight: Weight) -> Body:
    """The weight as a point mass of the crank; its angle counts from O->A."""
    arm = weight.radius * np.exp(1j * (weight.angle + crank_angle(case.chain)))
    return Body(case.chain.structure.input_link, weight.mass, 0.0, complex(crank_pivot(case.chain) + arm))


@every_scene
@sparing("acceleration", [0.0, 15.0], every=4, first=1)
@sparing("scheme", [least_squares_counterweight, minimax_counterweight], every=2)
@pytest.mark.parametrize("choice", [{"mass": 3.0}, {"radius": 0.08}])
def test_a_real_mass_on_the_crank_leaves_what_was_promised(
    make: Callable[[], Scene],
    acceleration: float,
    scheme: Callable[[Shaking], Balance],
    choice: dict[str, float],
) -> None:
    case = make()
    found = shaking(case.chain, case.bodies, X, SPEED, acceleration)
    promised = scheme(found)
    body = on_crank(case, sized(promised.weights[0].moment, **choice))
    again = shaking(case.chain, (*case.bodies, body), X, SPEED, acceleration)
    assert np.max(np.abs(again.force - promised.force)) < 1e-12 * found.scale
    assert np.max(np.abs(again.turned - promised.turned)) < 1e-12 * found.scale
    assert again.size.rms == pytest.approx(promised.after.rms, rel=1e-9)
    assert again.size.largest == pytest.approx(promised.after.largest, rel=1e-9)
    own = body.mass * abs(promised.weights[0].moment / body.mass) ** 2 * acceleration
    assert np.max(np.abs(again.moment + own - promised.moment)) < 1e-11 * found.moment_size.largest
    for name, value in choice.items():
        made = sized(promised.weights[0].moment, **choice)
        assert getattr(made, name) == value
        assert made.mass * made.radius == pytest.approx(abs(promised.weights[0].moment), rel=1e-14)


@every_scene
@sparing("highest", [1, 2], every=2, first=1)
@sparing("acceleration", [0.0, 15.0], every=2, first=1)
def test_weights_on_geared_shafts(make: Callable[[], Scene], highest: int, acceleration: float) -> None:
    """The weights as points that turn: their forces and moments by differentiating their places twice."""
    found = solved(make, acceleration)
    drawn = np.random.default_rng(highest)
    axes = {k: complex(*drawn.normal(size=2)) for k in (-1, 2, -2)}  # shafts beside the crank
    pairs = lanchester(found, highest)
    balance = with_weights(found, [replace(w, axis=axes.get(w.order, found.pivot)) for w in pairs.weights])
    n = 128
    phi = np.arange(n) * TURN / n
    force, moment = found.series.at(phi), found.moment_series.at(phi).real
    for weight in balance.weights:
        place = weight.moment * np.exp(1j * weight.order * phi)
        own = -(derivative(derivative(place)) * SPEED**2 + derivative(place) * acceleration)
        force = force + own
        moment = moment + (np.conj(weight.axis - found.about) * own).imag
    assert np.max(np.abs(force - balance.series.at(phi))) < 1e-11 * found.scale
    assert np.max(np.abs(moment - balance.moment_series.at(phi))) < 1e-11 * max(
        found.moment_size.largest, found.scale * max(abs(w.axis) for w in balance.weights)
    )
    spectrum = np.fft.fft(force) / n
    for order in range(1, highest + 1):
        assert abs(spectrum[order]) < 1e-13 * found.scale
        assert abs(spectrum[-order]) < 1e-13 * found.scale
    removed = sum(abs(found.series.coefficient(w.order)) ** 2 for w in balance.weights)
    assert balance.after.rms**2 + removed == pytest.approx(found.size.rms**2, rel=1e-12)
    assert np.max(np.abs(balance.force - balance.series.at(found.phi))) < 1e-12 * found.scale


def test_a_scotch_yoke_needs_the_pair_and_no_more() -> None:
    """Its slide moves with a pure cosine: half of it turns with the crank, half against it."""
    case = scene(yoke(0.1), Body(3, 4.0, 0.0, 0j))
    found = shaking(case.chain, case.bodies, X, SPEED)
    one, pair = least_squares_counterweight(found), lanchester(found)
    assert one.weights[0].moment == pytest.approx(-0.2, abs=1e-14)
    assert [w.moment for w in pair.weights] == pytest.approx([-0.2, -0.2], abs=1e-14)
    assert one.ratio == pytest.approx(math.sqrt(2), rel=1e-13)
    assert pair.ratio is None
    assert pair.after.largest < 1e-14 * found.scale


def test_the_rule_of_half_the_reciprocating_mass() -> None:
    case = scene(crank_slider(0.0375, 0.168), *PRESS)
    weight = least_squares_counterweight(shaking(case.chain, case.bodies, X, SPEED)).weights[0]
    at_b = 12.0 * 0.055 / 0.168
    assert weight.moment == pytest.approx(-0.0375 * (12.0 - at_b + (at_b + 24.0) / 2), rel=1e-13)


def test_a_chosen_weight_and_the_moment_about_another_point() -> None:
    case = SCENES["four-bar"]()
    about = 0.2 - 0.4j
    found = shaking(case.chain, case.bodies, X, SPEED, about=about)
    body = Body(1, 0.7, 0.0, -0.06 + 0.02j)
    given = with_weights(found, [RotatingWeight(1, 0.7 * (-0.06 + 0.02j), found.pivot)])
    again = shaking(case.chain, (*case.bodies, body), X, SPEED, about=about)
    assert np.max(np.abs(again.force - given.force)) < 1e-13 * found.scale
    assert np.max(np.abs(again.moment - given.moment)) < 1e-12 * found.moment_size.largest
    assert again.moment_size.rms == pytest.approx(given.moment_after.rms, rel=1e-12)
    assert again.moment_size.largest == pytest.approx(given.moment_after.largest, rel=1e-12)


def test_a_balanced_mechanism_asks_for_nothing() -> None:
    case = scene(four_bar(0.1, 0.3, 0.25, 0.3), Body(1, 2.0, 0.1, 0j))
    found = shaking(case.chain, case.bodies, X, SPEED)
    for balance in (least_squares_counterweight(found), minimax_counterweight(found), lanchester(found, 2)):
        assert all(weight.moment == 0 for weight in balance.weights)
        assert balance.ratio is None


def test_faulty_questions_are_refused() -> None:
    found = solved(SCENES["four-bar"])
    with pytest.raises(UsageError, match="not different whole numbers"):
        rotating_weights(found, (1, 0))
    with pytest.raises(UsageError, match="not different whole numbers"):
        rotating_weights(found, (1, 1))
    moment = lanchester(found).weights[0].moment
    for wrong in ({}, {"mass": 1.0, "radius": 0.1}, {"mass": 0.0}, {"radius": -0.1}, {"radius": math.inf}):
        with pytest.raises(UsageError, match=r"choose the mass or the radius|not positive"):
            sized(moment, **wrong)
