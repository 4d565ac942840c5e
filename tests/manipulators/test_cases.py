"""KIN-S11, through the public API."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

import tmmcalc

CASES = json.loads((Path(__file__).parents[1] / "cases" / "kinematics.json").read_text(encoding="utf-8"))
S11 = next(case for case in CASES if case["id"] == "KIN-S11")


def solved(steps: int) -> tmmcalc.Manipulator:
    given = S11["inputs"]
    side = {1: "left", -1: "right"}[given["K"]]
    text = f"""
[manipulator]
arm = "spherical"
speed = {given["v_max"]}
acceleration = {given["a_max"]}
steps = {steps}

[manipulator.path]
kind = "arc"
start = [{given["x1"]}, {given["y1"]}]
end = [{given["x2"]}, {given["y2"]}]
radius = {given["R"]}
side = "{side}"
"""
    return tmmcalc.solve_manipulator(tmmcalc.parse_spec(text))


def test_header() -> None:
    (leg,) = solved(8).legs
    (piece,) = leg.pieces
    found = {
        "xc": piece.centre[0],
        "yc": piece.centre[1],
        "th1": piece.theta,
        "th2": piece.theta_end,
        "q": piece.sense,
        "S": leg.law.travel,
        "t1": leg.law.ramp,
        "t2": leg.law.uniform,
        "T": leg.law.duration,
    }
    expected = S11["expected"]["header"]
    for name, value in found.items():
        assert value == pytest.approx(expected[name], abs=S11["tolerance"]["abs"]), name


def test_rows() -> None:
    result = solved(8)
    gripper, q = result.gripper, result.q
    found = {
        "t": result.t,
        **dict(zip(("s", "v", "a"), result.way, strict=True)),
        **{name: gripper[k, 0] for k, name in enumerate(("xA", "vx", "ax"))},
        **{name: gripper[k, 1] for k, name in enumerate(("yA", "vy", "ay"))},
        **{name: q[k, 0] for k, name in enumerate(("f2", "w2", "e2"))},
        **{name: q[k, 1] for k, name in enumerate(("l3", "vs", "as_"))},
    }
    equal = [k for k, label in enumerate(result.labels) if label.isdigit()]
    rows = S11["expected"]["rows"]
    assert len(equal) == len(rows)
    for k, row in zip(equal, rows, strict=True):
        for name, values in found.items():
            assert values[k] == pytest.approx(row[name], abs=S11["tolerance"]["abs"]), (row["i"], name)


def test_jumps_have_two_rows() -> None:
    result = solved(8)
    before = [k for k, label in enumerate(result.labels) if label.endswith("-")]
    assert [result.labels[k] for k in before] == ["1'-", "6'-"]
    for k in before:
        assert result.t[k] == result.t[k + 1]
        assert result.gripper[:2, :, k] == pytest.approx(result.gripper[:2, :, k + 1], abs=1e-14)
        assert np.max(np.abs(result.gripper[2, :, k] - result.gripper[2, :, k + 1])) > 1


def test_phases_of_the_rows() -> None:
    result = solved(8)
    assert result.phase.tolist() == [1, 1, 1, 2, 2, 2, 2, 2, 2, 2, 3, 3, 3]
