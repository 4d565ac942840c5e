"""Studies of the cams: orders of the differences, integrals, envelopes and polygons; the exact ways to rounding."""

from __future__ import annotations

import numpy as np
import pytest
from sparing import sparing

from .scenes import errors_in, errors_of, series_of, studies_of


@pytest.mark.parametrize("law", ["sine", "poly5", "modified_trapezoid"])
def test_differences_and_integrals_of_a_law(law: str) -> None:
    found = studies_of("cam-synthesis", "cam_law", f'cam.law="{law}"')
    for name in ("velocity", "acceleration"):
        assert errors_of(found[name], "exact")[0] < 1e-13
        differences = series_of(found[name], "central")
        assert differences.order == pytest.approx(2.0, abs=0.05)
        assert errors_in(differences)[-1] > 1e3 * errors_of(found[name], "exact")[0], "rounding shows"
    integrals = found["displacement, from the acceleration"]
    assert series_of(integrals, "trapezoid").order == pytest.approx(2.0, abs=0.1)
    assert series_of(integrals, "Simpson").order == pytest.approx(4.0, abs=0.15)


def test_law_by_points_beside_the_law_itself() -> None:
    """The sine law has no acceleration at its ends, as the spline: order 4, against 2 of the table's differences."""
    study = studies_of("cam-synthesis", "cam_law", 'cam.law="sine"')["acceleration of sine by points"]
    spline, table = errors_of(study, "spline"), errors_of(study, "second")
    assert np.log(spline[2] / spline[5]) / np.log(32 / 12) == pytest.approx(4.0, abs=0.6)
    assert all(a < b for a, b in zip(spline, table, strict=True))


@sparing("name", ["cam-translating", "cam-flat", "cam-oscillating"], every=3)
def test_envelopes_curvature_and_chords(name: str) -> None:
    found = studies_of(name, "cam_profile")
    for quantity in ("points of the working profile", "curvature"):
        exact, drawn = found[quantity].series
        assert errors_in(exact)[0] < 1e-12
        assert drawn.order == pytest.approx(2.0, abs=0.15), quantity
        assert len(errors_in(drawn)) >= 8
    equal, within = found["chords of the working profile"].series
    assert equal.order == pytest.approx(2.0, abs=0.1)
    assert within.order is None, "a tolerance is no step"
    for point in within.points:
        assert point.error is not None
        assert point.size is not None
        assert point.error <= point.size * (1 + 1e-9), "the tolerance is kept"
        assert point.error > point.size / 4, "and not by points that nobody asked for"
    counts = [point.count for point in within.points]
    assert np.log(counts[-1] / counts[0]) / np.log(1e4) == pytest.approx(0.5, abs=0.05), "of order 2 in the points"


def test_least_base_circle_by_lines_and_by_a_raster() -> None:
    (study,) = studies_of("cam-synthesis", "cam_synthesis").values()
    exact, lines, raster = study.series
    assert errors_in(exact)[0] < 1e-14
    assert study.reference.error < 1e-13
    few, many = errors_in(lines)[0], errors_in(lines)[-1]
    assert np.log(few / many) / np.log(128) == pytest.approx(2.0, abs=0.5)
    assert errors_in(raster)[-1] < 0.1 * errors_in(raster)[0]
    assert all(error < 4 / grid for error, grid in zip(errors_in(raster), (10, 20, 40, 80, 160, 320, 640), strict=True))
    cheapest = study.cheapest(1e-12)
    assert cheapest is not None
    assert cheapest[0].method == exact.method


def test_least_start_distance_of_a_flat_face() -> None:
    (study,) = studies_of("cam-flat", "cam_synthesis").values()
    exact, positions = study.series
    assert errors_in(exact)[0] < 1e-13
    assert errors_in(positions)[-1] < 1e-3 * errors_in(positions)[0]


@pytest.mark.slow
def test_lowest_mechanism_in_ever_finer_steps() -> None:
    (study,) = studies_of("cam-translating", "cam_optimum").values()
    exact, steps, grid = study.series
    assert errors_in(exact)[0] < 1e-12
    assert study.reference.error < 1e-12
    found = errors_in(steps)
    assert found[-1] < 0.5 * found[0]
    assert all(error < 2 * point.size / 0.06 for error, point in zip(found, steps.points, strict=True))
    assert errors_in(grid)[1:] == pytest.approx(found[: len(errors_in(grid)) - 1], rel=1e-9)
