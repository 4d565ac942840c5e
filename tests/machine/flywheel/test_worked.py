"""What the methods work out: the press of the worked case, tangents that touch, the drawing measured with a ruler."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from machines import sine

import tmmcalc
from machine.flywheel.scenes import CASES, TURN, press_cycle, upsetter_cycle
from tmmcalc.machine.cycle import Cycle
from tmmcalc.machine.flywheel.methods import positional_flywheels
from tmmcalc.machine.flywheel.wittenbauer import energy_mass
from tmmcalc.machine.flywheel.worked import Worked, curve_columns, paper, round_scales, worked
from tmmcalc.pipeline.runner import run

CONFIGS = Path(__file__).parents[3] / "configs"
PRESS = CASES["dyn-flywheel-positional"]["expected"]


def by_key(found: tuple[Worked, ...]) -> dict[str, Worked]:
    return {each.key: each for each in found}


def test_press_of_the_textbook_by_its_table_and_finely() -> None:
    found = by_key(worked(press_cycle(), 0.04, 5.0, 12))
    for key, wanted in (("exact_by_positions", PRESS["nodes_12"]), ("exact_by_cycle", PRESS["fine"])):
        each = found[key]
        assert each.intercept_max == pytest.approx(wanted["b_max"], rel=2e-5)
        assert each.intercept_min == pytest.approx(wanted["b_min"], rel=2e-5)
        assert each.inertia == pytest.approx(wanted["J_F_exact"], rel=2e-5)
        assert each.divisor == pytest.approx(0.04 * 25)
        for method, key_of in (("book", "J_F_book_linearised_tangents"), ("mertsalov", "J_F_mertsalov")):
            assert found[f"{method}_by_{each.on}"].inertia == pytest.approx(wanted[key_of], rel=2e-5)
        excess = found[f"excess_work_by_{each.on}"]
        assert excess.work_max - excess.work_min == pytest.approx(wanted["A_max_minus_A_min"], rel=2e-6)
    table, work = found["exact_by_positions"], PRESS["nodes_12"]["A"]
    row = round(table.at_max / TURN * 12)
    assert (table.work_max, table.links_max) == pytest.approx((work[row], PRESS["nodes_12"]["J_var"][row]), rel=5e-6)
    assert table.at_max == pytest.approx(PRESS["nodes_12"]["phi_max_tangent_rad"], abs=1e-3)


def test_slopes_of_the_methods() -> None:
    """Half the squares of the extreme speeds, written out: 5 rad/s, 4 % about it."""
    found = by_key(worked(press_cycle(), 0.04, 5.0, None))
    assert len(found) == 5
    slopes = {
        "exact": (5.1**2 / 2, 4.9**2 / 2),
        "book": (12.5 * 1.04, 12.5 * 0.96),
        "mertsalov": (12.5, 12.5),
        "artobolevsky": (12.5 * 1.04, 12.5 * 0.96),
        "excess_work": (0.0, 0.0),
    }
    for method, pair in slopes.items():
        assert (found[f"{method}_by_cycle"].slope_max, found[f"{method}_by_cycle"].slope_min) == pytest.approx(pair)


@pytest.mark.parametrize("cycle", [press_cycle(), upsetter_cycle(), sine(100.0, 3.0)])
def test_every_number_follows_from_those_before_it(cycle: Cycle) -> None:
    found = worked(cycle, 0.03, cycle.speed, 24, sense=-1.0)
    methods = {each.method: each for each in positional_flywheels(cycle, 0.0, 0.03)}
    for each in found:
        assert each.intercept_max == pytest.approx(each.work_max - each.slope_max * each.links_max, rel=1e-12)
        assert each.intercept_min == pytest.approx(each.work_min - each.slope_min * each.links_min, rel=1e-12, abs=1e-9)
        assert each.segment == pytest.approx(each.intercept_max - each.intercept_min, rel=1e-12)
        assert each.inertia == pytest.approx(each.segment / each.divisor, rel=1e-12)
        assert -TURN <= each.at_max <= 0
        if each.on == "cycle":
            assert each.inertia == methods[each.method].inertia
            assert each.at_max == -methods[each.method].theta_max


def test_closed_form() -> None:
    """dyn-flywheel-sine: J_F = 2 M / (delta omega^2) by every method, from an excess work of 200 J."""
    for each in worked(sine(100.0), 0.02, 20.0, None):
        assert each.inertia == pytest.approx(25.0, rel=1e-12)
        assert each.segment == pytest.approx(200.0, rel=1e-12)


@pytest.mark.parametrize("cycle", [press_cycle(), upsetter_cycle()], ids=["press", "upsetter"])
def test_tangents_touch_from_one_side(cycle: Cycle) -> None:
    """On 20 001 places of the cycle the curve lies between both, and where they touch it is on them."""
    picture = energy_mass(cycle, 0.05)
    scales = round_scales(picture)
    at = np.append(np.linspace(0, TURN, 20001), picture.touching)
    found = {column.name: column.make() for column in curve_columns(picture, cycle, at, cycle.speed, scales)}
    size = np.ptp(found["A"])
    for name, k in (("below_max", -2), ("above_min", -1)):
        assert np.min(found[name]) > -1e-12 * size
        assert abs(found[name][k]) < 1e-12 * size
        assert np.min(found[name][:-2]) < 1e-5 * size
    assert max(found["x_curve"].max(), np.ptp(found["y_curve"])) <= 100 * (1 + 1e-9)
    np.testing.assert_allclose(found["T_rest"] + found["T_links"], found["A"], atol=1e-12 * size)


def test_the_drawing_measured() -> None:
    """Angles and the segment GH from points in mm alone: the origin, and where each tangent touches."""
    cycle = upsetter_cycle()
    picture = energy_mass(cycle, 0.08)
    scales = round_scales(picture)
    drawn = paper(picture, scales)
    at = np.array(picture.touching)
    found = {column.name: column.make() for column in curve_columns(picture, cycle, at, cycle.speed, scales)}
    x, y = found["x_curve"], found["y_curve"]
    angles = np.arctan2(y - drawn.origin_y, x - drawn.origin_x)
    assert (drawn.angle_max, drawn.angle_min) == pytest.approx(tuple(angles), rel=1e-12)
    crossing = drawn.origin_y - drawn.origin_x * np.tan(angles)  # of each tangent with the axis of energies
    assert drawn.segment == pytest.approx(crossing[0] - crossing[1], rel=1e-9)
    inertia = drawn.segment * drawn.energy_scale / (0.08 * cycle.speed**2)
    assert inertia == pytest.approx(-drawn.origin_x * drawn.inertia_scale, rel=1e-9)


def test_under_a_motor_the_speed_is_the_one_that_it_keeps() -> None:
    scene = run(tmmcalc.load_spec(CONFIGS / "shaper.toml", ["flywheel.delta=0.04"]), target="flywheel")
    result = scene.results["flywheel"]
    details = scene.outcomes["flywheel"].stage.part("details")(scene.spec, scene.results)
    assert len(details) == 11
    for row in result.rows:
        key = f"{row.positional.method.replace(' ', '_')}_by_cycle"
        assert details[key].inertia == pytest.approx(row.positional.inertia, rel=1e-12)
    assert details["book_by_positions"].inertia == pytest.approx(result.nodal.inertia, rel=1e-12)
    assert details["tangents"].segment * details["tangents"].energy_scale == pytest.approx(
        details["exact_by_cycle"].segment, rel=1e-12
    )
