"""Maps of regions against the closed form of the region, and what becomes of points without a solution."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pytest

from tmmcalc.core.errors import Fault, NoSolutionError, SpecError, TmmError
from tmmcalc.feasibility.judge import Constraint, Feasibility, FeasibilityTask, judge
from tmmcalc.feasibility.logic import FORMS, Form
from tmmcalc.feasibility.maps import Parameter, RegionMap, region_map

X, Y = np.linspace(-2, 2, 21), np.linspace(-1, 1.5, 13)
CONSTRAINTS = (Constraint("disk", "s", value="r2", at_most=1.0), Constraint("right", "s", value="x", at_least=0.25))
LOST = NoSolutionError("no such position", where="kinematics")


def parameter(name: str, values: np.ndarray) -> Parameter:
    return Parameter(name, tuple(values), tuple(f"{name}={value}" for value in values))


def points(rule: str, form: Form, lost: float) -> Iterator[Feasibility | TmmError]:
    for x in X:
        for y in Y:
            found = {"disk": (x * x + y * y, "m^2", None, 1.0), "right": (x, "m", 0.25, None)}
            yield LOST if y < lost else judge(FeasibilityTask(CONSTRAINTS, rule, form), found)


def mapped(rule: str = "", form: Form = "minmax", lost: float = -9.0) -> RegionMap:
    return region_map([parameter("x", X), parameter("y", Y)], points(rule, form, lost))


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize(("rule", "join"), [("disk and right", np.logical_and), ("disk or right", np.logical_or)])
def test_the_region_is_that_of_the_closed_form(rule: str, join: np.ufunc, form: Form) -> None:
    result = mapped(rule, form, lost=-0.5)
    x, y = np.meshgrid(X, Y, indexing="ij")
    truth = join(x**2 + y**2 <= 1, x >= 0.25) & (y >= -0.5)
    assert np.array_equal(result.feasible.reshape(result.shape), truth)
    assert np.array_equal(result.solved.reshape(result.shape), y >= -0.5)
    assert np.array_equal(result.function[result.solved] >= 0, truth.ravel()[result.solved])
    assert np.array_equal(result.exact([*result.margins])[result.solved] >= 0, truth.ravel()[result.solved])
    assert result.refused[0] == "kinematics: no such position"
    assert np.isfinite(result.margins).all()


def test_the_best_point_is_the_deepest() -> None:
    """min(1 - r^2, 4 x - 1) is greatest on the axis, where both meet: x = sqrt(6) - 2 = 0.449."""
    result = mapped()
    i, j = result.at(result.best)
    assert abs(X[i] - (6**0.5 - 2)) < 0.2
    assert abs(Y[j]) < 0.11
    assert result.feasible[result.best]


def test_without_a_feasible_point_the_nearest_is_told() -> None:
    result = mapped("disk and not disk", lost=0.0)
    assert not result.feasible.any()
    assert result.solved[result.best]
    assert result.function[result.best] == result.function[result.solved].max()


def test_where_nothing_has_a_solution() -> None:
    with pytest.raises(NoSolutionError, match="none of 2 points has a solution; the first: kinematics: no such"):
        region_map([parameter("x", X[:2])], [LOST, LOST])
    fault = SpecError("a.toml", [Fault("x", None, "negative")])
    with pytest.raises(SpecError, match="negative"):
        region_map([parameter("x", X[:2])], [fault, fault])
    with pytest.raises(NoSolutionError, match="no such position"):
        region_map([parameter("x", X[:2])], [fault, LOST])
