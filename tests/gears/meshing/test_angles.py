"""Every intermediate quantity of a pair: formulas worked out by Python, involutes by another Newton, worked numbers."""

from __future__ import annotations

import math
from functools import cache
from math import radians, tan
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import tmmcalc
from gears.formulas import worked
from gears.involute.cases import case
from gears.meshing.pairs import MM, M, book, given
from tmmcalc.gears.facts.angles import Row, angle_rows
from tmmcalc.gears.meshing.angles import pair_angles
from tmmcalc.gears.meshing.further import further_columns
from tmmcalc.gears.meshing.results import MeshPair, Pairs
from tmmcalc.gears.meshing.solve import solve_pair
from tmmcalc.pipeline.runner import run

READY = ("pair", "pair-helical", "pair-internal", "pair-rack", "pair-spur", "gears-pairs", "geared-press")


COUNT = 13
SPEC: Any = None  # columns by choice of pairs read nothing of it
CONFIGS = Path(__file__).parents[3] / "configs"


@cache
def pairs() -> tuple[MeshPair, ...]:
    """Those of ready specs, of the worked cases, and one with undercut."""
    specs = (tmmcalc.load_spec(CONFIGS / f"{name}.toml") for name in READY)
    found = [pair for spec in specs for pair in run(spec, target="pair").results["pair"].pairs]
    tasks = given(14, 27, 0.52, 0.31, 15.0), book(), given(10, 40, 0.1, 0.3, refuse=False)
    return (*found, *map(solve_pair, tasks))


def newton(involute: float) -> float:
    """The angle of an involute from the right end, as a student does it (4.57)."""
    angle = 1.5
    for _ in range(200):
        angle -= (tan(angle) - angle - involute) / tan(angle) ** 2
    return angle


def in_formula(row: Row) -> float:
    """Lengths are in mm in formulas."""
    return 1e3 * row.value if row.told.unit == "m" else row.value


@pytest.mark.parametrize("k", range(COUNT))
def test_every_formula_gives_its_value(k: int) -> None:
    found = pairs()[k]
    rows = list(angle_rows(found))
    with_formulas = [row for row in rows if row.formula]
    assert len(with_formulas) > (35 if found.task.kind == "rack" else 70)
    for row in with_formulas:
        # differences lose digits of the nine that operands show
        assert worked(row.numbers) == pytest.approx(in_formula(row), rel=2e-5, abs=3e-7), row
    assert all(math.isfinite(row.value) for row in rows)
    assert len({(row.of, row.told.key) for row in rows}) == len(rows)


@pytest.mark.parametrize("k", range(COUNT))
def test_identities(k: int) -> None:
    """No backlash, contact ratio of its parts, pitch point at rest, involutes by another Newton."""
    found = pairs()[k]
    pair = pair_angles(found)
    assert newton(pair.involute_w) == pytest.approx(pair.angle_w, rel=1e-9)
    assert newton(pair.involute_t) == pytest.approx(pair.angle_t, rel=1e-9)
    for wheel in pair.wheels:
        assert wheel.tip_angle is not None
        assert wheel.tip_involute is not None
        assert newton(wheel.tip_involute) == pytest.approx(wheel.tip_angle, rel=1e-9)
    parts = [wheel.approach or 0.0 for wheel in pair.wheels]
    assert sum(parts) + (pair.rack_part or 0.0) == pytest.approx(pair.contact_ratio, rel=1e-11)
    thick = sum(wheel.operating_arc for wheel in pair.wheels)
    if found.task.kind != "rack":
        assert thick == pytest.approx(pair.operating_pitch, rel=1e-11)
    for wheel, size in zip(pair.wheels, found.sizes, strict=True):
        assert wheel.tip_thickness == pytest.approx(size.tip_thickness, abs=1e-13)
        assert wheel.operating_half_angle == pytest.approx(size.operating_half_angle, abs=1e-13)
        assert 2 * math.pi * wheel.operating / wheel.teeth == pytest.approx(pair.operating_pitch, rel=1e-11)
    for point in pair.points:
        if point.point == "P":
            assert (point.theta1, point.theta2) == (pytest.approx(0, abs=1e-12), pytest.approx(0, abs=1e-12))


def test_the_worked_pair_with_its_shifts() -> None:
    """IG-S02, the control example of program 1.11."""
    expected = case("IG-S02")["expected"]
    pair = pair_angles(solve_pair(given(14, 27, 0.52, 0.31, 15.0)))
    assert pair.involute_t == pytest.approx(expected["inv_alpha_t"], abs=1e-8)
    assert pair.involute_w == pytest.approx(expected["inv_alpha_tw"], abs=1e-8)
    assert pair.angle_w == pytest.approx(expected["alpha_tw_rad"], abs=1e-8)
    assert math.degrees(pair.angle_t) == pytest.approx(expected["alpha_t_deg"], abs=1e-6)


def test_the_worked_pair_at_its_distance() -> None:
    """IG-S04 and IG-S06: sum of shifts, radii, contact ratio, sliding at both ends."""
    expected, rows = case("IG-S04")["expected"], case("IG-S06")["expected"]["rows"]
    found = solve_pair(book())
    pair = pair_angles(found)
    assert pair.angle_w == pytest.approx(expected["alpha_tw_rad"], abs=1e-8)
    assert pair.between is not None
    assert pair.between / MM == pytest.approx(case("IG-S06")["expected"]["N1N2"], abs=1e-6)
    for point, row in ((pair.points[0], rows[0]), (pair.points[-1], rows[-1])):
        assert point.rho1 / MM == pytest.approx(row["rho1"], abs=1e-6)
        assert point.theta1 == pytest.approx(row["theta1"], abs=2e-6)
        assert point.theta2 == pytest.approx(row["theta2"], abs=2e-6)
        assert point.pressure == pytest.approx(row["lambda"], abs=2e-6)


def test_a_tip_within_the_base_circle_has_no_angle() -> None:
    """A cut tip: quantities of the tip are left out, not invented."""
    task = given(60, 20, 0.0, 0.0, tips=(60 * M / 2 * math.cos(radians(20)) * 0.99, None), refuse=False)
    found = solve_pair(task)
    assert pair_angles(found).wheels[0].tip_angle is None
    assert all(math.isfinite(row.value) for row in angle_rows(found))
    assert not any(row.told.name == "alpha_a" for row in angle_rows(found) if row.of == "wheel 1")


@pytest.mark.parametrize("k", range(COUNT))
def test_columns_by_choice(k: int) -> None:
    """Contact points lie on the line of action: by the law of cosines from either centre."""
    found = pairs()[k]
    told = {c.name: c.make() for c in further_columns(SPEC, {"pair": Pairs((found,), "", ())})}
    s, (one, *others) = found.sliding.along, found.sizes
    angle = math.pi / 2 + found.angle_w
    by_cosine = np.sqrt(one.operating**2 + s**2 - 2 * one.operating * s * math.cos(angle))
    assert told["r_1"] == pytest.approx(by_cosine, rel=1e-9)
    assert np.cos(told["alpha_1"]) * told["r_1"] == pytest.approx(np.full_like(s, one.base), rel=1e-12)
    if others:
        (two,) = others
        side = 1 if found.task.kind == "external" else -1
        by_cosine = np.sqrt(two.operating**2 + s**2 + 2 * side * two.operating * s * math.cos(angle))
        assert told["r_2"] == pytest.approx(by_cosine, rel=1e-9)
        # sliding is the difference of the rolling velocities along the tangent
        rolling = told["rho2"] * found.task.teeth[0] / found.task.teeth[1]
        assert told["v_s"] == pytest.approx(found.sliding.rho1 - rolling, abs=1e-12)
    else:
        assert "rho2" not in told
        assert told["v_s"] == pytest.approx(s, abs=1e-15)
    assert told["phi"] * one.base == pytest.approx(s, abs=1e-15)


def test_columns_of_several_pairs_are_one_under_another() -> None:
    several = run(tmmcalc.load_spec(CONFIGS / "gears-pairs.toml"), target="pair").results["pair"]
    count = sum(len(pair.sliding.rho1) for pair in several.pairs)
    for each in further_columns(SPEC, {"pair": several}):
        assert each.make().shape == (count,)


def test_all_pairs_are_looked_at() -> None:
    assert len(pairs()) == COUNT
    assert {pair.task.kind for pair in pairs()} == {"external", "internal", "rack"}
