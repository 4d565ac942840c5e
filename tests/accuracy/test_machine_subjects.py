"""Studies of linkage and machine: known orders, references that hold, every method within what it promises."""

from __future__ import annotations

from pathlib import Path

import pytest

from tmmcalc import load_spec
from tmmcalc.accuracy.measure import Clock
from tmmcalc.accuracy.solve import solve_accuracy
from tmmcalc.accuracy.study import Series, Study
from tmmcalc.errors import UsageError
from tmmcalc.spec.loader import parse_spec

CONFIGS = Path(__file__).parents[2] / "configs"
ONCE = Clock(repeats=1, budget=0.0)
NEAR = 100.0  # times the tolerance of a step: what a method may leave in all


def _studies(name: str, stage: str, *overrides: str) -> dict[str, Study]:
    found = solve_accuracy(load_spec(CONFIGS / f"{name}.toml", overrides), stage, ONCE)
    return {study.quantity: study for study in found.studies}


def _series(study: Study, name: str) -> Series:
    return next(series for series in study.series if series.method == name)


def _errors(series: Series) -> list[float]:
    return [point.error for point in series.points if point.error is not None]


@pytest.mark.parametrize("name", ["shaper", "class-four", "four-dyads", "scotch-yoke"])
def test_derivatives(name: str) -> None:
    for quantity, study in _studies(name, "kinematics").items():
        if quantity == "positions":
            continue
        assert max(_errors(_series(study, "elimination (closed)"))) < 1e-13
        differences = _series(study, "central differences")
        assert differences.order == pytest.approx(2.0, abs=0.05)
        assert _errors(differences)[-1] > 10 * min(_errors(differences)) or quantity == "velocities", "rounding shows"
        assert min(_errors(_series(study, "differences, 6 decimals"))) > 1e-6


def test_splitting_beside_newton() -> None:
    for study in _studies("class-four", "kinematics").values():
        assert max(_errors(_series(study, "splitting into dyads"))) < 1e-12


def test_quadrature_of_smooth_moments_is_spectral() -> None:
    """Over a whole turn the trapezoid beats Simpson and reaches rounding with 24 steps."""
    study = _studies("class-three", "reduction")["work per cycle"]
    assert max(_errors(_series(study, "Gauss on panels"))) < 1e-12
    assert study.reference.error < 1e-12
    trapezoid, simpson = _series(study, "trapezoid"), _series(study, "Simpson")
    assert trapezoid.order is simpson.order is None
    assert _errors(trapezoid)[2] < 1e-14 < _errors(simpson)[2]


def test_quadrature_of_smooth_moments_over_a_part_of_a_turn_has_the_orders_of_the_rules() -> None:
    study = _studies("hydraulic-lift", "reduction")["work per cycle"]
    assert _series(study, "trapezoid").order == pytest.approx(2.0, abs=0.1)
    assert _series(study, "Simpson").order == pytest.approx(4.0, abs=0.2)


def test_quadrature_over_a_jump_of_the_load_is_of_first_order() -> None:
    study = _studies("shaper", "reduction")["work per cycle"]
    for rule in ("trapezoid", "Simpson"):
        assert _series(study, rule).order == pytest.approx(1.0, abs=0.15)
    assert study.cheapest(1e-6) is not None


def test_reduced_inertia_and_its_derivative() -> None:
    found = _studies("press", "reduction")
    values, slopes = found["reduced inertia"], found["derivative of the reduced inertia"]
    exact, pins = values.series
    assert max(_errors(exact)) < 1e-14
    assert 1e-6 < _errors(pins)[0] < 0.5, "the moment of inertia of the rods changes"
    exact, table = slopes.series
    assert max(_errors(exact)) < 1e-14
    assert table.order == pytest.approx(2.0, abs=0.1)


def test_steady_motion_by_every_method() -> None:
    (study,) = _studies("shaper", "motion").values()
    assert study.reference.error < 1e-12
    assert max(_errors(_series(study, "collocation"))) < 1e-12
    for series in study.series:
        if series.method.startswith("shooting"):
            errors = _errors(series)
            assert errors[-1] < NEAR * series.points[-1].size, series.method
            assert errors[-1] < 1e-3 * errors[0], series.method
    assert _series(study, "recurrence (3.57)").order is not None


START = """
[[transients]]
name = "start-up"
duration = "0.6 s"
"""


def test_a_start_by_every_method() -> None:
    text = (CONFIGS / "shaper.toml").read_text(encoding="utf-8") + START
    (study,) = solve_accuracy(parse_spec(text), "transient", ONCE).studies
    assert study.reference.error < 1e-12
    for name in ("merson", "rk4"):
        fixed = _series(study, f"{name}, fixed steps")
        assert fixed.order == pytest.approx(4.0, abs=0.35), name
    for name in ("merson", "collocation", "DOP853", "LSODA", "Radau", "BDF"):
        found = _series(study, name)
        errors = _errors(found)
        assert errors[-1] < min(0.1 * errors[0], NEAR * found.points[-1].size), name


def test_a_stage_without_a_choice_is_refused() -> None:
    with pytest.raises(UsageError, match="structure has one method only"):
        solve_accuracy(load_spec(CONFIGS / "shaper.toml"), "structure")
    with pytest.raises(UsageError, match="no stage is called"):
        solve_accuracy(load_spec(CONFIGS / "shaper.toml"), "nonsense")
