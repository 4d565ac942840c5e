"""The search against optima that are known: closed forms, complete enumeration, regions that are balls."""

import itertools

import numpy as np
import pytest
from scipy.optimize import linprog
from sparing import sparing

from tests.design.optimize.fake import problem
from tmmcalc.core.errors import NoSolutionError
from tmmcalc.design.optimize.optimum import bindings, flatness
from tmmcalc.design.optimize.problem import Limit, Variable
from tmmcalc.design.optimize.search import search


def quiet(words, scores):
    assert len(scores.violation)


def found(made, budget=4000, seed=1, designs=25, start=None):
    start = np.array([(each.low + each.high) / 2 for each in made.variables]) if start is None else start
    return search(made, start, budget, seed, designs, quiet)


def rosenbrock(x):
    return (100 * (x[:, 1:] - x[:, :-1] ** 2) ** 2 + (1 - x[:, :-1]) ** 2).sum(axis=1)[:, None]


def rastrigin(x):
    return (x**2 - 10 * np.cos(2 * np.pi * x) + 10).sum(axis=1)[:, None]


@sparing("seed", [1, 2, 3], every=3)
def test_a_curved_valley_is_followed_to_its_end(seed):
    made = problem(rosenbrock, [(-5.0, 5.0)] * 4)
    course = found(made, 8000, seed)
    assert made.inside(course.places)[0] == pytest.approx(np.ones(4), abs=1e-6)
    assert course.second is not None
    assert course.second.hits[0] > 0
    assert course.second.better == (False,)


@sparing("seed", [1, 2, 3], every=3)
def test_the_best_of_thousands_of_hollows_is_found(seed):
    made = problem(rastrigin, [(-4.1, 6.3)] * 4)
    course = found(made, 8000, seed)
    assert float(course.scores.objectives[0, 0]) < 1e-9


def test_on_a_ball_the_optimum_and_its_costs_are_those_of_the_closed_form():
    """Greatest a.x with |x| <= r is r |a|, and grows by |a| for a unit of r."""
    a = np.array([3.0, -4.0, 12.0])

    def both(x):
        return np.array([x @ a, np.linalg.norm(x, axis=1)]).T

    made = problem(both, [(-5.0, 5.0)] * 3, [Limit("ball", 1, "", None, 2.0)], [-1])
    course = found(made)
    assert -course.scores.objectives[0, 0] == pytest.approx(26.0, rel=1e-8)
    x = made.inside(course.places)[0]
    held, balance = bindings(made, course.places[0], 10 * np.array([a, x / np.linalg.norm(x)]))
    assert [(each.name, each.side) for each in held] == [("ball", "at most")]
    assert held[0].cost == pytest.approx(13.0, rel=1e-5)
    assert balance.gain < 1e-9
    flat = flatness(made, course.places[0])
    for each, value in zip(flat, 2 * a / 13, strict=True):
        assert each.value == pytest.approx(value, abs=1e-4)
        assert each.low <= each.value <= each.high


def test_a_small_share_of_the_box_is_found_as_large_as_it_is():
    """The share of a spread that keeps a ball is the ball's: pi/6 of a cube in three dimensions."""
    made = problem(lambda x: np.array([x[:, 0], np.linalg.norm(x, axis=1)]).T, [(-1.0, 1.0)] * 3,
                   [Limit("ball", 1, "", None, 1.0)])  # fmt: skip
    from tmmcalc.design.optimize.evolution import spread

    scores = made.scores(spread(3, 2**14, 5))
    assert (scores.violation == 0).mean() == pytest.approx(np.pi / 6, abs=2e-3)


def test_whole_numbers_and_a_catalogue_are_searched_completely_where_that_is_small():
    """The split of a ratio over two pairs, as enumeration has it."""
    teeth = Variable("z1", (0,), "", 17, 40, tuple(map(float, range(17, 41))))
    wheel = Variable("z2", (1,), "", 20, 120, tuple(map(float, range(20, 121))))

    def ratio(x):
        return np.array([np.abs(x[:, 1] / np.maximum(x[:, 0], 1.0) - np.pi), x.sum(axis=1)]).T

    made = problem(ratio, [teeth, wheel], [Limit("sum", 1, "", None, 150.0)])
    course = found(made)
    best = min(
        (abs(two / one - np.pi), one, two)
        for one, two in itertools.product(range(17, 41), range(20, 121))
        if one + two <= 150
    )
    assert course.complete
    assert made.solved == 24 * 101
    assert course.scores.objectives[0, 0] == pytest.approx(best[0], rel=1e-12)
    assert made.inside(course.places)[0].tolist() == [best[1], best[2]]


def test_whole_numbers_too_many_for_that_are_found_by_both_methods():
    """Integer programme with a known answer: max 5a + 4b + 3c, 2a + 3b + c <= 5, 4a + b + 2c <= 11, ..."""
    every = [Variable(f"x{k}", (k,), "", 0, 999, tuple(map(float, range(1000)))) for k in range(3)]
    rows = np.array([[2, 3, 1], [4, 1, 2], [3, 4, 2]])
    ends = np.array([905.0, 1711.0, 1808.0])

    def linear(x):
        return np.column_stack((x @ [5, 4, 3], x @ rows.T))

    limits = [Limit(f"row{k}", k + 1, "", None, float(end)) for k, end in enumerate(ends)]
    made = problem(linear, every, limits, [-1])
    course = found(made, 6000)
    truth = linprog([-5, -4, -3], rows, ends, bounds=[(0, 999)] * 3, integrality=[1, 1, 1])
    assert -course.scores.objectives[0, 0] == pytest.approx(-truth.fun, abs=1e-9)


def test_mixed_variables_go_to_the_best_of_both():
    steps = Variable("n", (0,), "", 0, 20, tuple(map(float, range(21))))
    made = problem(lambda x: ((x[:, 0] - 7.3) ** 2 + (x[:, 1] - x[:, 0] / 3) ** 2)[:, None], [steps, (-10.0, 10.0)])
    course = found(made, 2000)
    assert made.inside(course.places)[0] == pytest.approx([7.0, 7 / 3], abs=1e-6)


def test_a_front_is_that_of_the_closed_form():
    """Least x^2 + y^2 and (x - 1)^2 + y^2: y = 0 and sqrt(f1) + sqrt(f2) = 1."""

    def both(x):
        return np.array([(x**2).sum(axis=1), ((x - [1.0, 0.0]) ** 2).sum(axis=1)]).T

    made = problem(both, [(-2.0, 2.0)] * 2, signs=(1, 1))
    course = found(made, 4000, designs=15)
    roots = np.sqrt(np.maximum(course.scores.objectives, 0.0))
    assert len(roots) == 15
    assert roots.sum(axis=1) == pytest.approx(np.ones(15), abs=1e-5)
    assert roots.min(axis=0) == pytest.approx(np.zeros(2), abs=1e-4)
    assert np.diff(np.sort(roots[:, 0])).max() < 0.2


def test_a_kink_is_found_though_slopes_fail_there():
    made = problem(lambda x: np.abs(x - [0.3, -0.2]).max(axis=1)[:, None], [(-1.0, 1.0)] * 2)
    course = found(made, 4000)
    assert float(course.scores.objectives[0, 0]) < 1e-8


@pytest.mark.slow
def test_the_same_seed_finds_the_same_and_another_the_same_optimum():
    one, two = (found(problem(rosenbrock, [(-5.0, 5.0)] * 2), 3000, 4) for _ in range(2))
    assert one.places.tolist() == two.places.tolist()
    other = found(problem(rosenbrock, [(-5.0, 5.0)] * 2), 3000, 5)
    assert other.places == pytest.approx(one.places, abs=1e-6)


def test_bounds_within_which_nothing_has_a_solution():
    made = problem(lambda x: np.full((len(x), 1), np.nan), [(0.0, 1.0)] * 2)
    with pytest.raises(NoSolutionError, match=r"none of \d+ designs has a solution; most often, \d+ times: no way"):
        found(made, 400)


def test_constraints_that_contradict_each_other():
    made = problem(lambda x: np.array([x[:, 0], x[:, 0] ** 2]).T, [(-3.0, 3.0)],
                   [Limit("large", 0, "mm", 2.0, None), Limit("small", 1, "", None, 1.0)])  # fmt: skip
    with pytest.raises(
        NoSolutionError,
        match=r"none of \d+ designs keeps the constraints; of the nearest large is 1\.\d+ mm "
        r"\(at least 2; \d+ of \d+ designs keep it\), small",
    ):
        found(made, 400)


def test_an_objective_that_nothing_changes():
    made = problem(lambda x: np.full((len(x), 1), 7.0), [(0.0, 1.0)] * 2)
    with pytest.raises(NoSolutionError, match="y0 is the same of all"):
        found(made, 400)


def test_a_rule_with_or_leaves_the_better_branch():
    def both(x):
        return np.array([(x[:, 0] - 0.1) ** 2, x[:, 0]]).T

    limits = [Limit("left", 1, "", None, -1.0), Limit("right", 1, "", 0.5, None)]
    made = problem(both, [(-3.0, 3.0)], limits, rule="left or right")
    course = found(made, 1000)
    assert made.inside(course.places)[0, 0] == pytest.approx(0.5, abs=1e-6)
