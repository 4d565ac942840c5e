"""The printed tables of the method and the worked cases, through the public functions."""

from __future__ import annotations

from math import degrees, radians

import numpy as np
import pytest

from cams.indexing_scene import CASES, PAPER
from tmmcalc.cams.indexing import solve_indexing
from tmmcalc.cams.indexing.bounds import bounds, largest_ratio, least_ratio, start_pressure
from tmmcalc.cams.indexing.choice import most_rollers
from tmmcalc.cams.indexing.compare import compare, compared
from tmmcalc.cams.indexing.efficiency import against, aiding
from tmmcalc.cams.indexing.handover import handover
from tmmcalc.cams.indexing.laws import step_law
from tmmcalc.cams.indexing.solve import drive_of
from tmmcalc.cams.indexing.task import IndexingTask

RIGHT = radians(90)
SIXTEEN = IndexingTask(step_law("0000"), 16, RIGHT, 1.0)


def of_case(case, number, **given):
    inputs = case["inputs"]
    law = given.pop("law", inputs["law"])
    return IndexingTask(step_law(PAPER.get(law, law)), number, radians(inputs["phi_p_deg"]), 1.0, **given)


def test_table_1_over_the_number_of_rollers() -> None:
    case = CASES["c2008-lantern-01"]
    expected, exact, tol = case["expected"], case["expected"]["recomputed"], case["tolerance"]
    near = tol["recomputed_rel"]
    for i, z2 in enumerate(case["inputs"]["z2"]):
        row = compared(of_case(case, z2, limit=radians(case["inputs"]["theta_d_deg"])))
        for name, end in (("min", row.low), ("max", row.high)):
            assert end is not None
            tip = end.handover
            assert tip is not None
            assert end.ratio == pytest.approx(expected[f"lambda_{name}"][i], abs=tol["lambda_abs"])
            assert end.ratio == pytest.approx(exact[f"lambda_{name}"][i], rel=near)
            assert tip.part == pytest.approx(expected[f"k_m_at_lambda_{name}"][i], abs=tol["k_m_abs"])
            assert tip.part == pytest.approx(exact[f"k_m_at_lambda_{name}"][i], rel=near)
            source = degrees(tip.source_angle)
            printed = expected[f"theta2_source_deg_at_lambda_{name}"][i]
            assert source == pytest.approx(printed, abs=tol["theta2_source_deg"])
            assert source == pytest.approx(exact[f"theta2_source_deg_at_lambda_{name}"][i], rel=near)
            assert degrees(tip.angle) == pytest.approx(exact[f"theta2_true_deg_at_lambda_{name}"][i], rel=near)
        printed = expected["theta_1m_deg_at_lambda_min"][i]
        assert degrees(row.low.start) == pytest.approx(printed, abs=tol["theta_deg"])
    for ratio in (least_ratio(1.5, 16, RIGHT), largest_ratio(16, radians(50))):
        assert ratio is not None
        drive = drive_of(SIXTEEN, ratio)
        assert drive is not None
        assert (handover(drive) is not None) == expected["z2_16_exists"]


def test_table_3_over_the_laws() -> None:
    case = CASES["c2008-lantern-02"]
    expected, tol = case["expected"], case["tolerance"]
    limit = radians(case["inputs"]["theta_d_deg"])
    for i, law in enumerate(case["inputs"]["law"]):
        given = of_case(case, case["inputs"]["z2"], law=law, limit=limit)
        row = compared(given)
        assert row.peak == pytest.approx(expected["B"][i], abs=tol["B"])
        assert row.low.ratio == pytest.approx(expected["lambda_min"][i], abs=tol["lambda_abs"])
        assert degrees(row.low.start) == pytest.approx(expected["theta_1m_deg_at_lambda_min"][i], abs=tol["theta_deg"])
        for name, end in (("min", row.low), ("max", row.high)):
            assert end is not None
            assert end.handover is not None
            assert end.handover.part == pytest.approx(expected[f"k_m_at_lambda_{name}"][i], abs=tol["k_m_abs"])
            for key, angle in (("source", end.handover.source_angle), ("true", end.handover.angle)):
                printed = expected[f"theta2_{key}_deg_at_lambda_{name}"][i]
                assert degrees(angle) == pytest.approx(printed, abs=tol[f"theta2_{key}_deg"])
        assert row.most == expected["z2_max"][i]


def test_table_2_of_the_sine_law() -> None:
    """The paper prints it for z2 = 6, 8, 10; the last has no lambda: lambda_min is above lambda_max."""
    rows = {row.rollers: row for row in compare(IndexingTask(step_law("sine"), 6, RIGHT, 1.0)) if row.law == "sine"}
    assert [rows[z2].possible for z2 in (6, 8, 10)] == [True, True, False]
    for z2 in (6, 8, 10):
        assert rows[z2].low.ratio == pytest.approx(1 + 8 / z2, rel=1e-14)  # 2 pi 2/(z2 pi/2)
    assert degrees(rows[6].low.start) == pytest.approx(41.2, abs=0.05)  # as table 3 has it


def test_table_4_of_the_limits_of_the_step() -> None:
    """Its least steps are those of B = 1.875 at lambda_max in two decimals, its largest those of lambda = 1.75."""
    for z2 in (6, 8, 10, 12, 14):
        row = compared(IndexingTask(step_law("shun"), z2, RIGHT, 1.0, 1.75))
        assert row.high is not None
        assert row.given is not None
        assert row.low.step_min == pytest.approx(RIGHT, rel=1e-14)
        assert row.high.step_min == pytest.approx(2 * np.pi * 1.875 / (z2 * (row.high.ratio - 1)), rel=1e-13)
        # at lambda_max the limit of the pressure angle is reached: pi - 2 delta_0 = 2 (beta_0 + theta_d)
        assert row.high.step_max == pytest.approx(2 * (np.pi / z2 + radians(50)), rel=1e-13)
        rounded = bounds(1.875, z2, RIGHT, radians(50), round(row.high.ratio, 2))
        assert rounded.step_min == pytest.approx(row.high.step_min, rel=0.015)
        delta = np.arctan2(np.sin(np.pi / z2), 1.75 - np.cos(np.pi / z2))
        assert row.given.step_max == pytest.approx(np.pi - 2 * delta, rel=1e-14)


def test_profiles_of_the_third_case() -> None:
    case = CASES["c2008-lantern-03"]
    inputs, expected, tol = case["inputs"], case["expected"], case["tolerance"]
    wheel = inputs["l_k_mm"] / 1e3
    found = solve_indexing(
        IndexingTask(
            step_law("shun"),
            inputs["z2"],
            radians(inputs["phi_p_deg"]),
            wheel,
            inputs["a_mm"] / inputs["l_k_mm"],
            limit=radians(inputs["theta_d_deg"]),
        )
    )
    cam = found.cam
    assert cam is not None
    assert found.ratio == pytest.approx(expected["lambda_"])
    assert found.bounds.ratio_min == pytest.approx(expected["lambda_min"])
    assert 1e3 * found.base == pytest.approx(expected["R0_mm"], abs=tol["R_mm"])
    for value, key in (
        (found.start_angle, "delta0_deg"),
        (found.start_pressure, "theta_1m_deg"),
        (cam.handover.angle, "theta2_true_deg_at_k_m"),
        (cam.handover.source_angle, "theta2_source_deg_at_k_m"),
        (found.bounds.step_min, "phi_p_min_deg"),
        (found.bounds.step_max, "phi_p_max_paper_deg"),
    ):
        assert degrees(value) == pytest.approx(expected[key], abs=tol["angles_deg"])
    assert cam.handover.part == pytest.approx(expected["k_m"], abs=tol["k_m"])
    assert 1e3 * cam.bottom == pytest.approx(expected["rho_B_mid_mm"], rel=tol["rho_rel"])
    for limit, key in zip(cam.roller_limits, ("rho_convex_min_A_mm", "rho_convex_min_B_mm"), strict=False):
        assert limit.radius is not None
        assert 1e3 * limit.radius == pytest.approx(expected[key], rel=tol["rho_rel"])
    rows = [int(np.argmin(np.abs(found.k - k))) for k in expected["profile_k"]]
    for name, flank in (("A", cam.a), ("B", cam.b)):
        assert 1e3 * flank.radius[rows] == pytest.approx(expected[f"{name}_R_mm"], abs=tol["R_mm"])
        assert np.degrees(flank.polar[rows]) == pytest.approx(expected[f"{name}_delta_deg"], abs=tol["angles_deg"])
        angles = np.degrees(flank.pressure[rows])
        assert angles == pytest.approx(expected[f"{name}_vartheta_deg"], abs=tol["angles_deg"])
        assert 1e3 * flank.bend[rows] == pytest.approx(expected[f"{name}_rho_mm"], rel=tol["rho_rel"])


def test_efficiencies_of_the_fourth_case() -> None:
    case = CASES["c2008-lantern-04"]
    inputs, expected = case["inputs"], case["expected"]
    f1 = inputs["f1"]
    given = np.radians(inputs["theta_deg"]), np.radians(inputs["sigma_deg"]), f1, inputs["f2_over_f1"] * f1
    assert against(*given)[0] == pytest.approx(expected["eta_against"], abs=case["tolerance"]["abs"])
    assert aiding(*given)[0] == pytest.approx(expected["eta_aiding"], abs=case["tolerance"]["abs"])
    assert not against(*given)[1].any()


def test_the_law_that_is_known_by_its_b_alone() -> None:
    """Column 2.9 of table 3, B = 1.625; its printed z2_max is 10, where the rule of the other columns gives 12."""
    rows = compare(IndexingTask(step_law("0000"), 6, RIGHT, 1.0))
    row = next(row for row in rows if row.law.startswith("2.9"))
    assert row.low.ratio == pytest.approx(2.08, abs=0.006)
    assert degrees(row.low.start) == pytest.approx(37.7, abs=0.05)
    assert row.low.handover is None
    assert row.possible
    assert row.most == 12
    like = next(row for row in rows if row.law == "poly5")  # it has all printed values but one, 59.5 deg against 59.9
    assert like.peak == row.peak
    assert like.low.handover is not None
    assert like.high is not None
    assert like.high.handover is not None
    assert like.low.handover.part == pytest.approx(0.795, abs=5e-4)
    assert like.high.handover.part == pytest.approx(0.674, abs=5e-4)
    assert degrees(like.high.handover.source_angle) == pytest.approx(73.5, abs=0.05)


def test_every_printed_law_stands_in_one_table() -> None:
    rows = compare(IndexingTask(step_law("0000"), 6, RIGHT, 1.0))
    assert [row.rollers for row in rows[:5]] == [6, 8, 10, 12, 14]
    assert {"sine", "cosine", "const", "shun", "0010", "modified_sine"} <= {row.law for row in rows[5:]}
    assert len({(row.law, row.rollers) for row in rows}) == len(rows)


def test_the_start_of_the_step_at_its_limit() -> None:
    for z2 in (6, 8, 10, 12, 14):
        ratio = largest_ratio(z2, radians(50))
        assert ratio is not None
        assert degrees(start_pressure(z2, ratio)) == pytest.approx(50, rel=1e-13)
    assert largest_ratio(6, radians(61)) is None  # theta_1m stays below 90 - 30 deg
    assert most_rollers(IndexingTask(step_law("sine"), 6, radians(40), 1.0)) is None
