"""Studies of tables and raster beside exact extremes: forces, power, balance, pressure angle, forces of cams, tips."""

from __future__ import annotations

from itertools import pairwise
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


@pytest.mark.parametrize("name", ["shaper", "press"])
def test_passes_of_friction_fall_by_the_loop_gain(name: str) -> None:
    found = [study for quantity, study in _studies(name, "forces").items() if quantity.startswith("friction")]
    assert found
    for study in found:
        assert study.reference.error < 1e-12
        assert max(_errors(_series(study, "Newton"))) < 1e-12
        passes = _series(study, "passes")
        errors = _errors(passes)[:4]  # of 1, 2, 3 and 4 passes
        assert all(later < max(former / 2, 1e-13) for former, later in pairwise(errors)), "the friction is small"
        assert passes.order is None


@pytest.mark.parametrize("name", ["shaper", "press", "engine-compressor"])
def test_largest_reactions_off_a_table(name: str) -> None:
    study = _studies(name, "forces")["largest reactions"]
    assert max(_errors(_series(study, "extremes"))) < 1e-13
    table = _errors(_series(study, "table"))
    assert all(later <= former * (1 + 1e-9) for former, later in pairwise(table)), "more positions miss no more"
    if name == "engine-compressor":
        assert np.log2(table[0] / table[-1]) / 7 == pytest.approx(2.0, abs=0.25), "of 12 to 1536 positions"
    if name == "press":
        assert np.log2(table[-3] / table[-1]) / 2 == pytest.approx(1.0, abs=0.1), "the load jumps between positions"


def test_peaks_of_power_off_a_table() -> None:
    (study,) = _studies("shaper", "power").values()
    assert max(_errors(_series(study, "extremes"))) < 1e-13
    table = _errors(_series(study, "table"))
    assert 1e-9 < table[-1] < 1e-3 * table[0]


def test_balance_by_positions() -> None:
    mean, circle = _studies("shaper", "balance").values()
    assert mean.reference.error < 1e-18
    assert max(_errors(_series(mean, "series"))) < 1e-14
    errors = _errors(_series(mean, "mean of n"))
    # spectral: the digits grow with the positions, 6 to 36, and end in rounding
    digits = -np.log10(errors[:6])
    assert np.all(np.diff(digits) > 0)
    assert digits[5] > 5 * digits[0]
    assert errors[-1] < 1e-14
    assert _series(mean, "mean of n").order is None
    assert max(_errors(_series(circle, "circle around the curve"))) < 1e-14
    around = _errors(_series(circle, "circle around n"))
    assert around[-1] < 1e-3 * around[0]


@pytest.mark.parametrize("name", ["cam-translating", "cam-oscillating"])
def test_largest_pressure_angle(name: str) -> None:
    (study,) = _studies(name, "cam_pressure").values()
    assert max(_errors(_series(study, "extremes"))) < 1e-14
    table = _errors(_series(study, "table"))
    assert all(later <= former * (1 + 1e-9) for former, later in pairwise(table))
    assert table[-1] < 1e-3 * table[0]


def test_no_pressure_angle_of_a_flat_face() -> None:
    found = solve_accuracy(load_spec(CONFIGS / "cam-flat.toml"), "cam_pressure", ONCE)
    assert (found.studies, found.settled) == ((), ("cam_pressure",))


@pytest.mark.parametrize("name", ["cam-translating", "cam-oscillating", "cam-groove", "cam-flat"])
def test_largest_forces_of_a_cam(name: str) -> None:
    (study,) = _studies(name, "cam_forces").values()
    assert max(_errors(_series(study, "extremes"))) < 1e-13
    table = _errors(_series(study, "table"))
    assert table[-1] < 1e-2 * table[0]


@pytest.mark.parametrize("law", ["linear", "sine"])
def test_least_cam_under_a_rocker(law: str) -> None:
    (study,) = _studies("cam-rocker-synthesis", "cam_synthesis", f'cam.law="{law}"').values()
    assert max(_errors(_series(study, "exact"))) < 1e-14
    assert study.reference.error < 1e-12
    lines = _errors(_series(study, "lines of n"))
    assert lines[-1] < 1e-2 * lines[0]
    raster = _errors(_series(study, "raster"))
    # a square of the raster is 1.5/n of the base circle
    assert all(error < 2 * 1.5 / n for error, n in zip(raster, (10, 20, 40, 80, 160), strict=True))
    assert 1e-3 < min(_errors(_series(study, "textbook"))) < 0.2


def test_tip_of_an_indexing_cam() -> None:
    (study,) = _studies("cam-lantern", "indexing").values()
    assert max(_errors(_series(study, "root"))) < 1e-14
    halved = _series(study, "bisection")
    for point in halved.points:
        assert point.error is not None
        assert point.error < point.size + 1e-15
    table = _errors(_series(study, "table"))
    assert table[-1] < 1e-3 * table[0]
