"""The picture of a region: borders where the margins vanish, ticks and fill on the side that is told."""

from __future__ import annotations

import numpy as np
import pytest

pytest.importorskip("matplotlib")

from matplotlib.collections import Collection
from matplotlib.contour import QuadContourSet

from tmmcalc.core.errors import NoSolutionError, TmmError
from tmmcalc.feasibility.judge import Constraint, Feasibility, FeasibilityTask, judge
from tmmcalc.feasibility.maps import Parameter, RegionMap, region_map
from tmmcalc.feasibility.pictures.regions import region_figure

X = np.linspace(-2, 2, 41)
TASK = FeasibilityTask(
    (Constraint("disk", "s", value="r2", at_most=1.0), Constraint("right", "s", value="x", at_least=0.25))
)


def found(x: float, y: float) -> Feasibility | TmmError:
    if y < -1.5:
        return NoSolutionError("no such position")
    return judge(TASK, {"disk": (x * x + y * y, "", None, 1.0), "right": (x, "", 0.25, None)})


def parameter(name: str) -> Parameter:
    return Parameter(name, tuple(X), tuple(f"{name}={x}" for x in X))


def corners(drawn: Collection) -> np.ndarray:
    return np.concatenate([np.asarray(path.vertices) for path in drawn.get_paths()])


def plane() -> RegionMap:
    return region_map([parameter("x"), parameter("y")], [found(x, y) for x in X for y in X])


def test_borders_and_fill() -> None:
    axes = region_figure(plane()).axes[0]
    disk, right, fill = (each for each in axes.collections if isinstance(each, QuadContourSet))
    circle = corners(disk)
    assert np.hypot(*circle.T) == pytest.approx(np.ones(len(circle)), abs=0.006)
    line = corners(right)
    assert line[:, 0] == pytest.approx(np.full(len(line), 0.25), abs=1e-12)
    assert line[:, 1].min() == pytest.approx(-1.5)  # below there is no solution
    (region,) = fill.get_paths()
    inside = region.contains_points([(0.6, 0.0), (0.3, 0.9), (0.2, 0.0), (0.8, 0.8), (1.05, 0.0)])
    assert inside.tolist() == [True, True, False, False, False]


def test_curves_of_one_parameter() -> None:
    axes = region_figure(region_map([parameter("x")], [found(x, 0.0) for x in X])).axes[0]
    values = [np.asarray(line.get_ydata()) for line in axes.lines[:2]]
    assert values[0] == pytest.approx(100 * (1 - X**2))
    assert values[1] == pytest.approx(100 * (X - 0.25) / 0.25)
    (fill,) = axes.collections
    spans = corners(fill)[:, 0]
    assert (spans.min(), spans.max()) == pytest.approx((0.25, 1.0), abs=0.013)
