"""The picture of a region: borders where the margins vanish, ticks and fill on the side that is told."""

from __future__ import annotations

import numpy as np
import pytest
from paper import curves, diagram

from tmmcalc.core.errors import NoSolutionError, TmmError
from tmmcalc.feasibility.judge import Constraint, Feasibility, FeasibilityTask, judge
from tmmcalc.feasibility.maps import Parameter, RegionMap, region_map
from tmmcalc.feasibility.pictures.regions import REGION, region_drawing
from tmmcalc.report.drawing.pens import CURVES
from tmmcalc.report.drawing.shapes import Area, Drawing

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


def fills(drawing: Drawing) -> list[np.ndarray]:
    """Corners of the areas where the rule holds, on paper."""
    return [shape.points for shape in drawing.shapes if isinstance(shape, Area) and shape.fill == REGION]


def inside(at: complex, polygon: np.ndarray) -> bool:
    """Whether a polygon winds around a place."""
    turned = np.angle((np.roll(polygon, -1) - at) / (polygon - at))
    return bool(abs(np.sum(turned)) > np.pi)


def plane() -> RegionMap:
    return region_map([parameter("x"), parameter("y")], [found(x, y) for x in X for y in X])


def test_borders_and_fill() -> None:
    drawing = region_drawing(plane())
    field = diagram(drawing, "x")
    (circle,), (line,) = (curves(field, CURVES[k]._replace(dashes=())) for k in (0, 1))
    assert np.abs(circle) == pytest.approx(np.ones(len(circle)), abs=0.006)
    assert line.real == pytest.approx(np.full(len(line), 0.25), abs=1e-9)
    assert line.imag.min() == pytest.approx(-1.5)  # below there is no solution
    (area,) = fills(drawing)
    places = (0.6 + 0j, 0.3 + 0.9j, 0.2 + 0j, 0.8 + 0.8j, 1.05 + 0j)
    assert [inside(field.place(at), area) for at in places] == [True, True, False, False, False]


def test_curves_of_one_parameter() -> None:
    drawing = region_drawing(region_map([parameter("x")], [found(x, 0.0) for x in X]))
    field = diagram(drawing, "x")
    values = [np.concatenate(curves(field, CURVES[k])) for k in (0, 1)]
    shown = values[0].real, values[1].real
    assert values[0].imag == pytest.approx(100 * (1 - shown[0] ** 2), abs=0.3)
    assert values[1].imag == pytest.approx(100 * (shown[1] - 0.25) / 0.25, abs=1e-6)
    (area,) = fills(drawing)
    spans = [field.data(complex(at)).real for at in area]
    assert (min(spans), max(spans)) == pytest.approx((0.25, 1.0), abs=0.013)
