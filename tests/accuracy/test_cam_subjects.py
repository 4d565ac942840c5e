"""Studies of the cams: orders of the differences, integrals, envelopes and polygons; the exact ways to rounding."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from tmmcalc import load_spec
from tmmcalc.accuracy.measure import Clock
from tmmcalc.accuracy.solve import solve_accuracy
from tmmcalc.accuracy.study import Series, Study

CONFIGS = Path(__file__).parents[2] / "configs"
ONCE = Clock(repeats=1, budget=0.0)


def _studies(name: str, stage: str, *overrides: str) -> dict[str, Study]:
    found = solve_accuracy(load_spec(CONFIGS / f"{name}.toml", overrides), stage, ONCE)
    return {study.quantity: study for study in found.studies}


def _series(study: Study, name: str) -> Series:
    return next(series for series in study.series if series.method.startswith(name))


def _errors(series: Series) -> list[float]:
    return [point.error for point in series.points if point.error is not None]


@pytest.mark.parametrize("law", ["sine", "poly5", "modified_trapezoid"])
def test_differences_and_integrals_of_a_law(law: str) -> None:
    found = _studies("cam-synthesis", "cam_law", f'cam.law="{law}"')
    for name in ("velocity", "acceleration"):
        assert _errors(_series(found[name], "exact"))[0] < 1e-13
        differences = _series(found[name], "central")
        assert differences.order == pytest.approx(2.0, abs=0.05)
        assert _errors(differences)[-1] > 1e3 * _errors(_series(found[name], "exact"))[0], "rounding shows"
    integrals = found["displacement, from the acceleration"]
    assert _series(integrals, "trapezoid").order == pytest.approx(2.0, abs=0.1)
    assert _series(integrals, "Simpson").order == pytest.approx(4.0, abs=0.15)


def test_law_by_points_beside_the_law_itself() -> None:
    """The sine law has no acceleration at its ends, as the spline: order 4, against 2 of the table's differences."""
    study = _studies("cam-synthesis", "cam_law", 'cam.law="sine"')["acceleration of sine by points"]
    spline, table = _errors(_series(study, "spline")), _errors(_series(study, "second"))
    assert np.log(spline[2] / spline[5]) / np.log(32 / 12) == pytest.approx(4.0, abs=0.6)
    assert all(a < b for a, b in zip(spline, table, strict=True))


@pytest.mark.parametrize("name", ["cam-translating", "cam-flat", "cam-oscillating"])
def test_envelopes_curvature_and_chords(name: str) -> None:
    found = _studies(name, "cam_profile")
    for quantity in ("points of the working profile", "curvature"):
        exact, drawn = found[quantity].series
        assert _errors(exact)[0] < 1e-12
        assert drawn.order == pytest.approx(2.0, abs=0.15), quantity
        assert len(_errors(drawn)) >= 8
    equal, within = found["chords of the working profile"].series
    assert equal.order == pytest.approx(2.0, abs=0.1)
    assert within.order == pytest.approx(2.0, abs=0.1)
    for point in within.points:
        assert point.error is not None
        assert point.error <= point.size**2 * (1 + 1e-9), "the tolerance is kept"
        assert point.error > point.size**2 / 4, "and not by points that nobody asked for"


def test_least_base_circle_by_lines_and_by_a_raster() -> None:
    (study,) = _studies("cam-synthesis", "cam_synthesis").values()
    exact, lines, raster = study.series
    assert _errors(exact)[0] < 1e-14
    assert study.reference.error < 1e-13
    few, many = _errors(lines)[0], _errors(lines)[-1]
    assert np.log(few / many) / np.log(128) == pytest.approx(2.0, abs=0.5)
    assert _errors(raster)[-1] < 0.1 * _errors(raster)[0]
    assert all(error < 4 / grid for error, grid in zip(_errors(raster), (10, 20, 40, 80, 160, 320, 640), strict=True))
    cheapest = study.cheapest(1e-12)
    assert cheapest is not None
    assert cheapest[0].method == exact.method


def test_least_start_distance_of_a_flat_face() -> None:
    (study,) = _studies("cam-flat", "cam_synthesis").values()
    exact, positions = study.series
    assert _errors(exact)[0] < 1e-13
    assert _errors(positions)[-1] < 1e-3 * _errors(positions)[0]


def test_lowest_mechanism_in_ever_finer_steps() -> None:
    (study,) = _studies("cam-translating", "cam_optimum").values()
    exact, steps, grid = study.series
    assert _errors(exact)[0] < 1e-12
    assert study.reference.error < 1e-12
    found = _errors(steps)
    assert found[-1] < 0.5 * found[0]
    assert all(error < 2 * point.size / 0.06 for error, point in zip(found, steps.points, strict=True))
    assert _errors(grid)[1:] == pytest.approx(found[: len(_errors(grid)) - 1], rel=1e-9)
