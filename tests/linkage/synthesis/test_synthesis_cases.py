"""Worked numbers of linkage synthesis, through the public interface: specs in, designs out, ready specs simulated."""

from __future__ import annotations

import json
import math
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import tmmcalc
from tmmcalc.linkage.synthesis.results import Synthesis
from tmmcalc.linkage.synthesis.strokes import stroke_times

FILE = Path(__file__).parents[2] / "cases" / "force-groups-and-linkage-synthesis.json"
SLIDER, SLOTTED, ROTATING = "slider_crank", "slotted_link", "rotating_slotted_link"
CASES = {"L-SYN-SC-EX1": SLIDER, "L-SYN-SC-02": SLIDER, "L-SYN-SLOT-EX2": SLOTTED, "L-SYN-SLOT-03": SLOTTED}
CASES["L-SYN-ROT-01"] = ROTATING
SIZES = {"lam": "lambda", "eps_lam": "eps_lambda", "eps": "eps", "l": "l", "r": "r", "e": "e", "R": "R", "L": "L"}
ANGLES = {"psi_deg": "psi", "two_phi_deg": "two_phi", "phi_zero_deg": "phi_zero"}
ANGLES["phi_second_extreme_deg"] = "phi_second"
TIMES = {
    "t_cycle": ("period", 1.0),
    "t_cycle_min": ("period", 1 / 60),
    "t_p": ("working_time", 1.0),
    "t_x": ("idle_time", 1.0),
    "v_x": ("idle_speed", 1.0),
    "v_x_m_per_min": ("idle_speed", 60.0),
}


@cache
def book(name: str) -> dict[str, Any]:
    return next(case for case in json.loads(FILE.read_text()) if case["id"] == name)


def spec_of(given: dict[str, Any], kind: str) -> str:
    unit = "m/min" if "m/min" in given["units"] else "m/s"
    keys = {"stroke": f'"{given["S"]} m"', "working_speed": f'"{given["v_p"]} {unit}"'}
    names = {"nu_p_deg": "pressure_working", "nu_x_deg": "pressure_idle", "nu_max_deg": "pressure_angle"}
    keys |= {own: f'"{given[printed]} deg"' for printed, own in names.items() if printed in given}
    keys |= {own: str(given[printed]) for printed, own in (("K", "time_ratio"),) if printed in given}
    lengths = {"guide_offset_e": "guide", "r": "crank"}
    keys |= {own: f'"{given[printed]} m"' for printed, own in lengths.items() if printed in given}
    if "crank_clearance_factor" in given:
        keys["clearance"] = str(given["crank_clearance_factor"])
    return f"[synthesis.{kind}]\n" + "".join(f"{key} = {value}\n" for key, value in keys.items())


@pytest.mark.parametrize("name", CASES)
def test_case(name: str) -> None:
    case = book(name)
    assert case["verified"]
    result = tmmcalc.solve_synthesis(tmmcalc.parse_spec(spec_of(case["inputs"], CASES[name])))
    design, tolerance = result.best, case["tolerance"]
    assert design.times is not None
    relative, absolute = tolerance["rel"], tolerance.get("abs", 1e-12)
    seen = set()
    for key, value in case["expected"].items():
        if key in SIZES:
            found = design.size(SIZES[key])
        elif key in ANGLES:
            found = math.degrees(design.size(ANGLES[key]))
            found = value + math.remainder(found - value, 360)
        elif key in TIMES:
            name_of, factor = TIMES[key]
            found = factor * getattr(design.times, name_of)
        else:
            found = {
                "K": design.times.time_ratio,
                "n_crank_rpm": design.times.crank_speed * 30 / math.pi,
                "alpha_p_deg": math.degrees(design.times.working_angle),
                "alpha_x_deg": math.degrees(design.times.idle_angle),
            }[key]
        seen.add(key)
        assert found == pytest.approx(value, rel=relative, abs=absolute), key
    assert len(seen) == len(case["expected"])
    assert result.residual < 1e-9
    assert_meets_targets(result, case["inputs"])


def assert_meets_targets(result: Synthesis, given: dict[str, Any]) -> None:
    """The ready spec, read as any other spec, has the stroke, the time ratio and the mean working speed."""
    motion = tmmcalc.solve_kinematics(tmmcalc.parse_spec(result.best.spec))
    summary = motion.summaries[0]
    assert summary.stroke is not None
    assert summary.time_ratio is not None
    assert summary.stroke == pytest.approx(given["S"], rel=1e-12)
    if "K" in given:
        assert summary.time_ratio == pytest.approx(given["K"], rel=1e-12)
    working = 2 * math.pi / motion.speed * summary.time_ratio / (1 + summary.time_ratio)
    speed = given["v_p"] / (60 if "m/min" in given["units"] else 1)
    assert summary.stroke / working == pytest.approx(speed, rel=1e-12)


def test_output_parameters() -> None:
    case = book("L-OUT-01")
    given, expected = case["inputs"], case["expected"]
    times = stroke_times(given["S"], given["K"], given["n_crank_rpm"] * math.pi / 30)
    found = {
        "t": times.period,
        "t_p": times.working_time,
        "t_x": times.idle_time,
        "v_p": times.working_speed,
        "v_x": times.idle_speed,
        "v_mean_cycle": times.mean_speed,
        "alpha_x_deg": math.degrees(times.idle_angle),
        "alpha_p_deg": math.degrees(times.working_angle),
        "psi_deg": math.degrees(times.overlap),
        "omega_crank": times.crank_speed,
    }
    assert found == pytest.approx(expected, rel=case["tolerance"]["rel"])


def test_position_plan() -> None:
    """L-PLAN-SC and L-PLAN-SLOT on the ready specs of their own syntheses."""
    for name, source, kind in (("L-PLAN-SC", "L-SYN-SC-EX1", SLIDER), ("L-PLAN-SLOT", "L-SYN-SLOT-EX2", SLOTTED)):
        expected = book(name)["expected"]
        text = spec_of(book(source)["inputs"], kind)
        ready = tmmcalc.solve_synthesis(tmmcalc.parse_spec("[synthesis]\npositions = 12\n" + text)).best.spec
        spec = tmmcalc.parse_spec(ready)
        plan = tmmcalc.position_plan(
            tmmcalc.linkage.tables.tasks.mechanism.to_linkage(spec.linkage), tmmcalc.solve_kinematics(spec)
        )
        plain = [k for k, label in enumerate(plan.labels) if "'" not in label]
        assert len(plain) == 12
        off = np.degrees(plan.x[plain]) - expected["crank_angles_deg"]
        assert np.max(np.abs(off - 360 * np.round(off / 360))) < 1e-6
        assert np.max(np.abs(plan.value[plain] - expected["slider_x"])) < 1e-6
        assert len(plan.labels) == 12 + expected["extra_position_added"]
        second = "6'" if expected["extra_position_added"] else str(expected["coincides_with_position"])
        at = [k for k, extreme in enumerate(plan.extremes) if extreme]
        assert [plan.labels[k] for k in at] == ["0", second]
        assert np.degrees(plan.phi[at[1]]) == pytest.approx(expected["second_extreme_relative_deg"], rel=1e-6)
        assert plan.strokes == ("working",) * at[1] + ("idle",) * (len(plan.labels) - at[1])
