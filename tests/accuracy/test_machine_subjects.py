"""Studies of linkage and machine: known orders, references that hold, every method within what it promises."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from sparing import sparing

from tmmcalc import load_spec
from tmmcalc.accuracy.solve import solve_accuracy
from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.core.plan import plan
from tmmcalc.core.studies.scene import Scene
from tmmcalc.core.studies.study import Study
from tmmcalc.linkage.accuracy import kinematics as accuracy_of_kinematics
from tmmcalc.project.loader import parse_spec

from .scenes import CONFIGS, ONCE, errors_in, errors_of, series_of, studies_of

NEAR = 100.0  # times the tolerance of a step: what a method may leave in all


@sparing("name", ["shaper", "class-four", "four-dyads", "scotch-yoke"], every=4)
def test_derivatives(name: str) -> None:
    for quantity, study in studies_of(name, "kinematics").items():
        if quantity == "positions":
            continue
        assert max(errors_of(study, "elimination (closed)")) < 1e-13
        differences = series_of(study, "central differences")
        assert differences.order == pytest.approx(2.0, abs=0.05)
        first, last = differences.points[0], differences.points[-1]
        assert None not in (first.error, first.size, last.error, last.size)
        truncated = first.error * (last.size / first.size) ** 2
        assert last.error > 3 * truncated, f"{quantity}: rounding shows"
        assert min(errors_of(study, "differences, 6 decimals")) > 1e-6


def test_an_acceleration_that_is_zero_but_for_rounding_is_left_out() -> None:
    """That of a driven slider by its own coordinate; what else accelerates is told to rounding."""
    study = studies_of("hydraulic-lift", "kinematics")["accelerations"]
    assert max(errors_of(study, "elimination (closed)")) < 1e-14
    assert max(errors_of(study, "projections")) < 1e-14
    assert series_of(study, "central differences").order == pytest.approx(2.0, abs=0.05)


@pytest.mark.slow
@pytest.mark.parametrize("name", sorted(file.stem for file in CONFIGS.glob("*.toml")))
def test_the_first_method_of_kinematics_has_a_result_in_every_ready_spec(name: str) -> None:
    if "kinematics" not in plan(load_spec(CONFIGS / f"{name}.toml"), None).running:
        pytest.skip("no linkage")
    for quantity, study in studies_of(name, "kinematics").items():
        assert max(errors_in(study.series[0]), default=1.0) < 1e-9, quantity


def test_splitting_beside_newton() -> None:
    for study in studies_of("class-four", "kinematics").values():
        assert max(errors_of(study, "splitting into dyads")) < 1e-12


def test_quadrature_of_smooth_moments_is_spectral() -> None:
    """Over a whole turn the trapezoid beats Simpson and reaches rounding with 24 steps."""
    study = studies_of("class-three", "reduction")["work per cycle"]
    assert max(errors_of(study, "Gauss on panels")) < 1e-12
    assert study.reference.error < 1e-12
    trapezoid, simpson = series_of(study, "trapezoid"), series_of(study, "Simpson")
    assert trapezoid.order is simpson.order is None
    assert errors_in(trapezoid)[2] < 1e-14 < errors_in(simpson)[2]


def test_quadrature_of_smooth_moments_over_a_part_of_a_turn_has_the_orders_of_the_rules() -> None:
    study = studies_of("hydraulic-lift", "reduction")["work per cycle"]
    assert series_of(study, "trapezoid").order == pytest.approx(2.0, abs=0.1)
    assert series_of(study, "Simpson").order == pytest.approx(4.0, abs=0.2)


def test_quadrature_over_a_jump_of_the_load_is_of_first_order() -> None:
    study = studies_of("shaper", "reduction")["work per cycle"]
    for rule in ("trapezoid", "Simpson"):
        assert series_of(study, rule).order == pytest.approx(1.0, abs=0.15)
    assert study.cheapest(1e-6) is not None


def test_reduced_inertia_and_its_derivative() -> None:
    found = studies_of("press", "reduction")
    values, slopes = found["reduced inertia"], found["derivative of the reduced inertia"]
    exact, pins = values.series
    assert max(errors_in(exact)) < 1e-14
    assert 1e-6 < errors_in(pins)[0] < 0.5, "the moment of inertia of the rods changes"
    exact, table = slopes.series
    assert max(errors_in(exact)) < 1e-14
    assert table.order == pytest.approx(2.0, abs=0.1)


@pytest.mark.slow
def test_steady_motion_by_every_method() -> None:
    (study,) = studies_of("shaper", "motion").values()
    assert study.reference.error < 1e-12
    assert max(errors_of(study, "collocation")) < 1e-12
    for series in study.series:
        if series.method.startswith("shooting"):
            errors = errors_in(series)
            assert errors[-1] < NEAR * series.points[-1].size, series.method
            assert errors[-1] < 1e-3 * errors[0], series.method
    recurrence = series_of(study, "recurrence (3.57)")
    assert recurrence.order == pytest.approx(1.0, abs=0.2), "the load jumps between its nodes"


def test_steady_motion_without_a_motor_by_every_method() -> None:
    (study,) = studies_of("press", "motion").values()
    assert study.reference.error < 1e-12
    assert max(errors_of(study, "closed form on panels")) < 1e-12
    first = errors_of(study, "energy (3.48), T0 = J(0) w_m^2/2")
    assert max(first) - min(first) < 1e-3 * min(first), "what T0 lacks no number of nodes mends"
    corrected = series_of(study, "energy (3.48), T0 by the mean")
    assert errors_in(corrected)[-1] < 1e-3 * errors_in(corrected)[0]
    assert corrected.order == pytest.approx(1.0, abs=0.2), "the load jumps between its nodes"


START = """
[[transients]]
name = "start-up"
duration = "0.6 s"
"""


@pytest.mark.slow
def test_a_start_by_every_method() -> None:
    text = (CONFIGS / "shaper.toml").read_text(encoding="utf-8") + START
    (study,) = solve_accuracy(parse_spec(text), "transient", ONCE).studies
    assert study.reference.error < 1e-12
    for name in ("merson", "rk4"):
        fixed = series_of(study, f"{name}, fixed steps")
        assert fixed.order == pytest.approx(4.0, abs=0.35), name
    for name in ("merson", "collocation", "DOP853", "LSODA", "Radau", "BDF"):
        found = series_of(study, name)
        errors = errors_in(found)
        assert errors[-1] < min(0.1 * errors[0], NEAR * found.points[-1].size), name


@pytest.mark.slow
def test_a_reference_without_a_result_ends_only_its_own_study(monkeypatch: pytest.MonkeyPatch) -> None:
    def fails(_: Scene) -> Iterator[Study]:
        raise NoSolutionError("no reference")
        yield

    monkeypatch.setattr(accuracy_of_kinematics, "studies", fails)
    found = solve_accuracy(load_spec(CONFIGS / "press.toml"), clock=ONCE)
    assert list(found.failures) == ["kinematics"]
    assert "kinematics" not in found.settled
    assert {study.stage for study in found.studies} >= {"forces", "reduction", "flywheel", "balance"}
    with pytest.raises(NoSolutionError, match="no reference"):
        solve_accuracy(load_spec(CONFIGS / "press.toml"), "kinematics", ONCE)


def test_a_stage_without_a_choice_is_refused() -> None:
    with pytest.raises(UsageError, match="structure has one method only"):
        solve_accuracy(load_spec(CONFIGS / "shaper.toml"), "structure")
    with pytest.raises(UsageError, match="no stage is called"):
        solve_accuracy(load_spec(CONFIGS / "shaper.toml"), "nonsense")
