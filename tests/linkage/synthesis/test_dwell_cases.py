"""Worked numbers of six-bars with a dwell, through the public interface: specs in, designs out."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import tmmcalc
from tmmcalc.linkage.synthesis.dwell.results import Dwell
from tmmcalc.linkage.synthesis.results import Design

FILE = Path(__file__).parents[2] / "cases" / "collection-2008.json"
CASES: dict[str, Any] = {case["id"]: case for case in json.loads(FILE.read_text()) if "sixbar" in case["id"]}
FIRST, SECOND, THIRD = (CASES[f"c2008-sixbar-0{k}"] for k in (1, 2, 3))


def positions(given: dict[str, Any]) -> str:
    angles = {
        "phi12": "phi12_deg",
        "psi0": "psi0_deg",
        "psi12": "psi12_deg",
        "psi13": "psi13_deg",
        "alpha": "alpha_deg",
    }
    lines = [f'{key} = "{given[name]} deg"' for key, name in angles.items()]
    return "\n".join(["[synthesis.dwell.positions]", *lines, f"CB = {given['l_CB']}", f"CD = {given['l_CD']}", ""])


def spec_of(given: dict[str, Any], more: str, sizes: str) -> str:
    head = f'[synthesis]\npositions = 12\n[synthesis.dwell]\ndwell = "{given["phi_dwell_deg"]} deg"\n'
    return f"{head}frame = {given['l_OB']}\n{more}\n{sizes}"


def solved(text: str) -> tuple[Design, Dwell]:
    best = tmmcalc.solve_synthesis(tmmcalc.parse_spec(text)).best
    assert best.dwell is not None
    return best, best.dwell


def rows(dwell: Dwell, degrees: list[float]) -> list[int]:
    """The rows of the table at these angles of the crank from position 1."""
    found = [int(np.argmin(np.abs(np.degrees(dwell.motion.phi) - at))) for at in degrees]
    assert np.degrees(dwell.motion.phi[found]) == pytest.approx(degrees, abs=1e-9)
    return found


@pytest.fixture(scope="module")
def slider() -> tuple[Design, Dwell]:
    given = FIRST["inputs"]
    return solved(spec_of(given, f"n = {given['n']}\nk = {given['k']}\nresistance = {given['F_C']}", positions(given)))


@pytest.fixture(scope="module")
def rocker() -> tuple[Design, Dwell]:
    given = SECOND["inputs"]
    f = given["F_polar"]["r"] * np.exp(1j * np.radians(given["F_polar"]["angle_deg"]))
    more = f'output = "rocker"\npivot = [{float(f.real)!r}, {float(f.imag)!r}]\nresistance = {given["M_C"]}'
    return solved(spec_of(given, more, positions(given)))


def test_lengths_of_the_slider(slider: tuple[Design, Dwell]) -> None:
    design, expected, rel = slider[0], FIRST["expected"], FIRST["tolerance"]["lengths_rel"]
    for name in ("l_OA", "l_AC", "l_DE", "l_BE", "l_AD"):
        assert design.size(name) == pytest.approx(expected[name], rel=rel)
    assert [design.size("x_E"), design.size("y_E")] == pytest.approx(expected["E_xy"], abs=1e-6)
    assert [design.size("x_D2"), design.size("y_D2")] == pytest.approx(expected["D_in_coupler_frame"], abs=1e-6)
    assert math.degrees(design.size("phi_0")) == pytest.approx(expected["phi0_deg"], abs=1e-5)
    printed = {"l_OA": "l_OA", "l_AC": "l_AC", "l_AD": "l_AD", "l_CD": "l_CD", "l_DE": "l_DE", "l_CB": "l_CB"}
    for name, key in printed.items():
        assert design.size(name) == pytest.approx(
            expected["printed"][key], abs=FIRST["tolerance"]["printed_lengths_abs"]
        )


def test_motion_of_the_slider(slider: tuple[Design, Dwell]) -> None:
    dwell, expected, tolerance = slider[1], FIRST["expected"], FIRST["tolerance"]
    at, motion = rows(slider[1], expected["table_from_phi0_deg"]), slider[1].motion
    assert motion.s[at] == pytest.approx(expected["S"], abs=tolerance["S_abs"])
    assert motion.ds[at] == pytest.approx(expected["dS"], abs=tolerance["dS_abs"])
    assert motion.dds[at] == pytest.approx(expected["d2S"], abs=tolerance["d2S_abs"])
    assert dwell.stroke == pytest.approx(expected["stroke_h"], abs=tolerance["S_abs"])
    assert dwell.dwell_error == pytest.approx(expected["dwell_max_abs_S"], rel=tolerance["dwell_rel"])
    assert dwell.dwell_ratio == pytest.approx(expected["dwell_ratio"], rel=tolerance["dwell_rel"])
    least = min(dwell.extremes, key=lambda each: each.value)
    most = max(dwell.extremes, key=lambda each: each.value)
    assert least.value == pytest.approx(expected["S_min"], abs=tolerance["S_abs"])
    assert math.degrees(least.at) == pytest.approx(expected["S_min_at_crank_from_phi0_deg"], abs=0.1)
    assert math.degrees(most.at) == pytest.approx(expected["S_max_at_crank_from_phi0_deg"], abs=0.1)
    largest = {each.name: each.value for each in dwell.maxima}
    assert largest["S'"] == pytest.approx(max(map(abs, expected["dS_range"])), abs=tolerance["dS_abs"])
    assert largest["S''"] == pytest.approx(max(map(abs, expected["d2S_range"])), abs=tolerance["d2S_abs"])


def test_forces_of_the_slider(slider: tuple[Design, Dwell]) -> None:
    dwell, expected, tolerance = slider[1], FIRST["expected"], FIRST["tolerance"]["forces_abs"]
    at, motion = rows(slider[1], expected["table_from_phi0_deg"]), slider[1].motion
    assert motion.f3[at] == pytest.approx(expected["f3"], abs=tolerance)
    assert motion.f4[at] == pytest.approx(expected["f4"], abs=tolerance)
    assert motion.r21[at] == pytest.approx(expected["R21"], abs=tolerance)
    assert motion.moment == pytest.approx(motion.ds, abs=1e-14)
    largest = {each.name: each.value for each in dwell.maxima}
    for name, key in (("f3", "max_abs_f3"), ("f4", "max_abs_f4"), ("R21", "max_R21")):
        assert largest[name] == pytest.approx(expected[key], abs=5e-6)


def test_the_rocker(rocker: tuple[Design, Dwell]) -> None:
    dwell, expected, tolerance = rocker[1], SECOND["expected"], SECOND["tolerance"]
    at, motion = rows(rocker[1], expected["table_from_phi0_deg"]), rocker[1].motion
    assert np.degrees(motion.s[at]) == pytest.approx(expected["S_deg"], abs=tolerance["S_deg_abs"])
    assert motion.ds[at] == pytest.approx(expected["dS_rad"], abs=tolerance["dS_abs"])
    assert motion.f3[at] == pytest.approx(expected["f3"], abs=tolerance["forces_abs"])
    assert motion.f4[at] == pytest.approx(expected["f4"], abs=tolerance["forces_abs"])
    assert motion.moment == pytest.approx(motion.ds, abs=1e-14)
    assert math.degrees(dwell.stroke) == pytest.approx(expected["swing_deg"], abs=tolerance["S_deg_abs"])
    assert math.degrees(dwell.stroke) == pytest.approx(
        expected["source_swing_rule_deg"], abs=tolerance["swing_rule_abs_deg"]
    )
    assert math.degrees(dwell.dwell_error) == pytest.approx(expected["dwell_max_abs_deg"], abs=tolerance["S_deg_abs"])
    ends = sorted((min(dwell.extremes, key=lambda e: e.value).at, max(dwell.extremes, key=lambda e: e.value).at))
    wanted = expected["swing_extremes_at_crank_from_phi0_deg"]
    assert np.degrees(ends) == pytest.approx(wanted, abs=tolerance["extreme_angle_deg"])
    largest = {each.name: each.value for each in dwell.maxima}
    for name, key in (("f3", "max_abs_f3"), ("f4", "max_abs_f4"), ("R21", "max_R21")):
        assert largest[name] == pytest.approx(expected[key], abs=5e-6)
    assert largest["S'"] == pytest.approx(max(map(abs, expected["dS_range_rad"])), abs=2e-6)
    assert largest["S''"] == pytest.approx(max(map(abs, expected["d2S_range_rad"])), abs=5e-6)


def test_the_relative_trajectory() -> None:
    given, expected, tolerance = THIRD["inputs"], THIRD["expected"], THIRD["tolerance"]
    sizes = (
        f"[synthesis.dwell.lengths]\nOA = {given['l_OA']}\nAC = {given['l_AC']}\nCB = {given['l_CB']}\n"
        f'CD = {given["l_CD"]}\nalpha = "{given["alpha_deg"]} deg"\nphi0 = "{given["phi0_deg"]} deg"\nside = "right"\n'
    )
    more = f"n = {given['n']}\narc_steps = {given['points_per_arc']}"
    design, dwell = solved(spec_of(given, more, sizes))
    assert design.size("l_DE") == pytest.approx(expected["l_DE"], rel=tolerance["lengths_rel"])
    assert [design.size("x_E"), design.size("y_E")] == pytest.approx(expected["E_xy"], rel=tolerance["lengths_rel"])
    assert dwell.stroke == pytest.approx(expected["stroke"], rel=1e-6)
    assert dwell.dwell_error == pytest.approx(expected["dwell_max"], rel=1e-4)
    found = dwell.cross_check
    assert found is not None
    assert np.degrees([found.first, found.last]) == pytest.approx(expected["phi3_arc_deg"], abs=tolerance["arc_deg"])
    error = expected["max_displacement_error_percent_of_stroke"]
    assert 100 * found.uniform == pytest.approx(error, abs=tolerance["error_percent_abs"])
    assert 100 * found.cosine < expected["cosine_spacing_error_percent_max"]
