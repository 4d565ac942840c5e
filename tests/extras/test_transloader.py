"""The transloader by hand: numbers of the source, its table of loads written out again, allowed stresses both ways."""

from __future__ import annotations

import csv
import io
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from bounding import assert_bounds
from typer.testing import CliRunner

import tmmcalc
from tmmcalc.cli.app import app
from tmmcalc.extras.loadcases import LOADS, MECHANISMS
from tmmcalc.extras.transloader import Part, Start, TransloaderTask, Way, Wind, solve_transloader
from tmmcalc.project import templates

FORCES = tuple((name, 1000.0 * 2**k) for k, name in enumerate(LOADS))  # any sum of them tells which they are
EACH = tuple((name, 1.0) for name in LOADS)
PART = Part("bar", 0.01, 240e6, EACH, endurance=180e6, mechanism="luffing")
TASK = TransloaderTask(16_000.0, loads=FORCES, parts=(PART,))
COMBINED = {  # loads by case, from the table of the source
    "A": {"dead_weight", "rated_load", "inertia", "equivalent_wind", "track"},
    "B1": {"dead_weight", "rated_load", "wind", "track", "drive"},
    "B2": {"dead_weight", "rated_load", "wind", "track", "shock"},
    "V1": {"dead_weight", "wind", "track"},
    "V2": {"dead_weight", "track", "hurricane", "seismic"},
}
BLANK = {"V1": {"equivalent_wind", "hurricane"}, "V2": {"equivalent_wind"}}


@pytest.mark.parametrize("blanks", ["without", "with"])
def test_loads_of_each_case(blanks: Any) -> None:
    found = solve_transloader(replace(TASK, blanks=blanks))
    sizes = dict(FORCES)
    for check in found.checks:
        acting = COMBINED[check.case] | (BLANK.get(check.case, set()) if blanks == "with" else set())
        assert check.force == pytest.approx(sum(sizes[name] for name in acting))
        assert check.stress == pytest.approx(check.force / 0.01)
    for load in found.loads:
        assert {*load.cases} >= {case for case, names in COMBINED.items() if load.load in names}


def test_weights_have_a_sense_and_other_loads_either() -> None:
    influence = (("dead_weight", -0.5), ("rated_load", 2.0), ("wind", -1.0), ("track", 0.5))
    found = solve_transloader(replace(TASK, parts=(replace(PART, influence=influence),)))
    sizes = dict(FORCES)
    (b1,) = [each for each in found.checks if each.case == "B1"]
    weights = abs(-0.5 * sizes["dead_weight"] + 2 * sizes["rated_load"])
    assert b1.force == pytest.approx(weights + sizes["wind"] + 0.5 * sizes["track"])


@pytest.mark.parametrize(
    ("mechanism", "duty", "case", "k1", "k2"),
    [
        ("hoist", None, "A", "1.2", "1.3"),
        ("closing", None, "B1", "1.1", "1.3"),
        ("trolley", "medium", "B2", "1.1", "1.1"),
        ("slewing", None, "A", "1.2", "1.2"),
        ("luffing", None, "A", "1.4", "1.2"),
        ("luffing", "light", "V1", "1.3", "1.0"),
        ("rail clamps", None, "A", "1.5", "1.0"),
        ("rail clamps", None, "B1", "1.4", "1.0"),
        ("rail clamps", "heavy", "V2", "1.3", "1.2"),
    ],
)
def test_allowed_stress_both_ways(mechanism: str, duty: str | None, case: str, k1: str, k2: str) -> None:
    task = replace(TASK, parts=(replace(PART, mechanism=mechanism, duty=duty, making="cast"),))
    one, two = Fraction(k1), Fraction(k2)
    for factors, km, other in (("sum", one + two, one * two), ("product", one * two, one + two)):
        found = solve_transloader(replace(task, factors="sum" if factors == "sum" else "product"))
        checks = {each.kind: each for each in found.checks if each.case == case}
        assert checks["strength"].allowed == pytest.approx(float(240_000_000 / km))
        assert checks["strength"].other == pytest.approx(float(240_000_000 / other))
        assert ("endurance" in checks) == (case == "A")
        if case == "A":
            assert checks["endurance"].allowed == pytest.approx(float(180_000_000 / (km * Fraction("1.3"))))
        assert any(("K1 + K2" if factors == "sum" else "K1 K2") in note for note in found.notes)


def test_sums_of_the_factors_are_those_that_the_source_tells() -> None:
    """It says 2.0...2.7; its own factors give 2.1 to 2.8, with its usual duties 2.3 to 2.6."""
    sums = [
        k1 + {"very heavy": 1.3, "heavy": 1.2, "light": 1.0}[mechanism.duty]
        for mechanism in MECHANISMS.values()
        for k1 in mechanism.importance
        if k1 is not None
    ]
    assert 2.0 <= min(sums) <= max(sums) <= 2.7


def test_cases_without_a_factor_are_left_out_and_told() -> None:
    found = solve_transloader(replace(TASK, parts=(replace(PART, mechanism="hoist"),)))
    assert {each.case for each in found.checks} == {"A", "B1", "B2"}
    assert any("no K1 out of service for bar" in note for note in found.notes)
    found = solve_transloader(replace(TASK, parts=(replace(PART, mechanism="bridge", importance=(1.2, 1.1, 1.0)),)))
    assert [each.importance for each in found.checks] == [1.2, 1.2, 1.1, 1.1, 1.0, 1.0]
    assert {each.duty for each in found.checks} == {1.0}


def test_speeds_by_integration_of_the_motion() -> None:
    """60 m at 0.6 m/s^2: peak 6 m/s in 20 s; at 3 m/s 25 s."""
    found = solve_transloader(replace(TASK, trolley=Way(60.0, 0.6, 3.0), hoist=Way(25.0, 1.1)))
    trolley, hoist = found.drives
    assert (trolley.peak, trolley.shortest, trolley.time) == pytest.approx((6.0, 20.0, 25.0))
    assert hoist.speed == pytest.approx(0.3 * 27.5**0.5)
    for drive in found.drives:
        t = np.linspace(0, drive.time, 200_001)
        v = np.minimum(np.minimum(drive.acceleration * t, drive.acceleration * (drive.time - t)), drive.speed)
        assert float(np.sum((v[1:] + v[:-1]) / 2 * np.diff(t))) == pytest.approx(drive.length, rel=1e-8)
    assert [each.holds for each in found.limits] == [True] * len(found.limits)


def test_a_way_without_a_speed_takes_the_largest_that_is_usual() -> None:
    found = solve_transloader(replace(TASK, trolley=Way(800.0, 0.6), hoist=Way(400.0, 1.0)))
    assert [each.speed for each in found.drives] == pytest.approx([6.0, 100 / 60])


@pytest.mark.parametrize(
    ("change", "what"),
    [
        ({"trolley": Way(60.0, 0.6, 3.1)}, "trolley by its way is 186 m/min, above 180 m/min"),
        ({"trolley": Way(60.0, 0.6, 0.8)}, "speed of the trolley is 48 m/min, below 50 m/min"),
        ({"hoist": Way(25.0, 1.3, 1.0)}, "acceleration of the hoist is 1.3 m/s^2, above 1.2 m/s^2"),
        ({"hoist": Way(25.0, 1.0, 1.0), "lowering": 1.5}, "lowering is 90 m/min, above 84 m/min"),
        ({"bridge_speed": 0.6}, "bridge is 36 m/min, above 35 m/min"),
        ({"span": 120.0}, "span is 120 m, above 115 m"),
        ({"span": 70.0, "deflection": 0.11}, "deflection of the bridge is 0.11 m, above 0.1 m"),
    ],
)
def test_limits_that_are_not_kept_are_told(change: dict[str, Any], what: str) -> None:
    notes = solve_transloader(replace(TASK, parts=(), **change)).notes
    warnings = [note for note in notes if note.startswith("warning")]
    assert len(warnings) == 1, warnings
    assert what in warnings[0]


def test_limits_by_their_names(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The limits of the source: 50 to 360 m/min, v <= 0.5 sqrt(L j), lowering at 1 to 1.4 of hoisting, span/700."""
    monkeypatch.chdir(tmp_path)
    spec = str(templates.path("extra-transloader"))
    told = CliRunner().invoke(app, ["names", spec, "limits.*", "-f", "csv"]).stdout
    listed = csv.DictReader(io.StringIO(told))
    rows = {(row["name"].removeprefix("transloader.limits."), row["unit"]): row for row in listed}
    expected = {
        ("trolley_speed.low", "m/s"): 50 / 60,
        ("trolley_speed.high", "m/s"): 360 / 60,
        ("trolley_speed_by_way.high", "m/s"): 0.5 * (60 * 0.6) ** 0.5,
        ("hoist_speed_by_height.high", "m/s"): 0.3 * (25 * 1.1) ** 0.5,
        ("hoist_acceleration.value", "m/s^2"): 1.1,
        ("lift.high", "m"): 30.0,
        ("lowering_speed.high", "m/s"): 1.4 * 1.5,
        ("deflection.high", "m"): 76 / 700,
        ("deflection.holds", ""): 1.0,
    }
    assert {key: float(rows[key]["value"]) for key in expected} == pytest.approx(expected)
    assert all(row["meaning"] and "{" not in row["meaning"] for row in rows.values())
    assert ("deflection.low", "m") not in rows


def test_inertia_and_wind_by_hand() -> None:
    """(100 + 147.15) kN * 2 m/s/(9.81 m/s^2 * 4 s) = 12.6 kN; 150 Pa * 1.2 * 1.4 * 1.1 * 1.5 * 20 m^2 = 8.316 kN."""
    wind = Wind(150.0, 20.0, 1.2, 1.4, 1.1, 1.5)
    start = Start((1e5, 147_150.0), 2.0, 4.0)
    found = solve_transloader(TransloaderTask(16_000.0, mass=1e5, inertia=start, winds=(("wind", wind),)))
    loads = {each.load: each.value for each in found.loads}
    assert found.inertia == pytest.approx(247_150 * 2 / (9.81 * 4))
    assert loads == pytest.approx(
        {"dead_weight": 981_000.0, "rated_load": 156_960.0, "inertia": 12_596.840, "wind": 8_316.0}
    )
    assert found.masses == pytest.approx((65_000.0, 30_000.0, 5_000.0))


def test_the_start_of_the_trolley_is_the_default() -> None:
    task = TransloaderTask(16_000.0, trolley=Way(60.0, 0.6, 3.0), inertia=Start((98_100.0,)))
    assert solve_transloader(task).inertia == pytest.approx(6000.0)  # 10 t at 0.6 m/s^2
    assert solve_transloader(replace(task, inertia=Start((98_100.0,), time=10.0))).inertia == pytest.approx(3000.0)


@pytest.mark.parametrize(("capacity", "notes"), [(12_500.0, 0), (50_000.0, 0), (15_000.0, 1)])
def test_capacities_of_the_series(capacity: float, notes: int) -> None:
    assert len(solve_transloader(TransloaderTask(capacity)).notes) == notes


def test_stress_above_the_allowed_one_is_a_warning() -> None:
    found = solve_transloader(replace(TASK, parts=(replace(PART, area=1e-3),)))
    assert {each.case for each in found.checks if not each.holds} == {
        each.case for each in found.checks if each.stress > each.allowed
    }
    warned = [note for note in found.notes if note.startswith("warning: bar")]
    assert len(warned) == sum(not each.holds for each in found.checks) > 0


def test_the_ready_spec() -> None:
    found = tmmcalc.solve_transloader(tmmcalc.load_spec(templates.path("extra-transloader")))
    worst = max(found.checks, key=lambda each: each.use)
    # 0.12 * 560 t g + 2.4 * 16 t g + 1.5 * 447 kN * 0.6/9.81, on 210 cm^2; 180 MPa/(2.5 * 1.1)
    force = 0.12 * 560e3 * 9.81 + 2.4 * 16e3 * 9.81 + 1.5 * 447e3 * 0.6 / 9.81
    assert (worst.case, worst.kind) == ("A", "endurance")
    assert worst.stress == pytest.approx(force / 0.021)
    assert worst.allowed == pytest.approx(180e6 / 2.75)


@pytest.mark.slow
def test_estimates_bound_their_errors() -> None:
    """Of a force of inertia, whose truth is a fraction."""
    rng = np.random.default_rng(11)
    pairs = []
    for _ in range(200):
        weights = tuple(float(each) for each in rng.uniform(1e4, 1e6, 3))
        speed, time = (float(each) for each in rng.uniform(0.1, 7, 2))
        found = solve_transloader(TransloaderTask(16_000.0, inertia=Start(weights, speed, time)))
        exact = sum(map(Fraction, weights)) * Fraction(speed) / (Fraction(9.81) * Fraction(time))
        assert found.inertia is not None
        pairs.append((found.error, abs(float(Fraction(found.inertia) / exact - 1))))
    assert_bounds(pairs, "numbers")


def test_loads_and_stresses_have_names() -> None:
    run = tmmcalc.run(tmmcalc.load_spec("configs/extra-transloader.toml"))
    loads = {each.load: each for each in run.results["transloader"].loads}
    told = run.tell("transloader.loads.wind.F")
    assert (told.value, told.unit, told.meaning) == (loads["wind"].value, "N", "size of load wind")
    stress, allowed, use = (
        run.value(f"transloader.beam of the trolley.B1.strength.{name}") for name in ("sigma", "sigma_allowed", "use")
    )
    assert use == pytest.approx(stress / allowed, rel=1e-14)
