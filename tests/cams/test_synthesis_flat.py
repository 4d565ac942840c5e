"""Flat faces: the worked case, jumps of acceleration, the shaft, reach of the face."""

import json
from math import radians
from pathlib import Path

import numpy as np
import pytest

from cams.turns import task_of, turn
from tmmcalc.cams.synthesis.results import Synthesis
from tmmcalc.cams.synthesis.solve import solve_synthesis
from tmmcalc.cams.task import AngleLimits
from tmmcalc.core.conversion import from_record, to_record
from tmmcalc.core.errors import NoSolutionError

CASES = {case["id"]: case for case in json.loads((Path(__file__).parents[1] / "cases" / "cams.json").read_text())}
PROGRAM = turn("sine", rise=70, high=20, back=70, stroke=0.012)
LIMITS = AngleLimits(radians(90), None, convex=0.003)


def test_worked_case():
    expected = CASES["cams-s13"]["expected"]
    found = solve_synthesis(task_of(PROGRAM, "flat", limits=LIMITS))
    assert found.convexity.least.value * 1e3 == pytest.approx(expected["F_min_mm"], rel=1e-6)
    assert found.convexity.least.phi / radians(70) == pytest.approx(expected["k_at_F_min"], rel=1e-6)
    assert found.follower.start * 1e3 == pytest.approx(expected["S0_min_mm"], rel=1e-6)
    assert found.convexity.left * 1e3 == pytest.approx(expected["plate_reach_left_mm"], rel=1e-6)
    assert found.convexity.right * 1e3 == pytest.approx(expected["plate_reach_right_mm"], rel=1e-6)
    assert found.convexity.radius == pytest.approx(0.003, rel=1e-12)
    assert found.governs == "convexity"
    assert found.rounded.start == pytest.approx(0.043, abs=1e-15)


def test_at_a_jump_the_braking_side_counts():
    program = turn("const", rise=90, high=20, back=60, stroke=0.01)
    found = solve_synthesis(task_of(program, "flat", limits=LIMITS)).convexity
    braking = 0.01 * (0.5 - 4 / radians(60) ** 2)  # the middle of the return, S'' = -4 h/phi^2 above it
    assert found.least.value == pytest.approx(braking, rel=1e-13)
    assert found.least.phi == pytest.approx(radians(140), abs=1e-12)


@pytest.mark.parametrize("sense", [1, -1])
def test_reach_of_the_face(sense):
    program = turn("sine", "shun", rise=70, high=20, back=110, stroke=0.012)
    found = solve_synthesis(task_of(program, "flat", limits=LIMITS, sense=sense, margin=0.002)).convexity
    rise, back = 0.012 * 2 / radians(70) + 0.002, 0.012 * 1.875 / radians(110) + 0.002
    expected = (rise, back) if sense > 0 else (back, rise)
    assert (found.left, found.right) == pytest.approx(expected, rel=1e-13)


def test_shaft_and_given_sizes():
    wide = AngleLimits(radians(90), None, convex=0.003, shaft=0.05)
    found = solve_synthesis(task_of(PROGRAM, "flat", limits=wide))
    assert found.governs == "shaft"
    assert found.follower.start == 0.05
    found = solve_synthesis(task_of(PROGRAM, "flat", limits=wide, start=0.03))
    assert found.follower.start == 0.03
    assert [note.split(":")[0] for note in found.notes] == ["warning", "warning"]
    assert "cusp" in found.notes[0]
    found = solve_synthesis(task_of(PROGRAM, "flat", limits=LIMITS, base=0.041))
    assert found.follower.start == 0.041
    assert "below the limit" in found.notes[0]


def test_nothing_that_asks_for_a_size():
    program = turn("cosine", rise=180, high=0, back=180, stroke=0.001)
    with pytest.raises(NoSolutionError):
        solve_synthesis(task_of(program, "flat", limits=AngleLimits(1.0, None, convex=0.0)))


def test_record():
    found = solve_synthesis(task_of(PROGRAM, "flat", limits=LIMITS))
    again = from_record(Synthesis, to_record(found))
    assert again == found
    assert np.isfinite(found.convexity.radius)
