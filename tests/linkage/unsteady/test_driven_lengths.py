"""Crane and tipper: worked cases and closed forms of a driven length, through the public API."""

from __future__ import annotations

import json
import math
from pathlib import Path

import numpy as np
import pytest

import tmmcalc
from tmmcalc.core.errors import NoSolutionError, SingularityError
from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.timelaw import motion
from tmmcalc.linkage.tables.tasks.mechanism import to_linkage
from tmmcalc.linkage.unsteady.solve import solve_unsteady
from tmmcalc.linkage.unsteady.task import UnsteadyTask
from tmmcalc.project import templates

from .cranes import Crane

CONFIGS = templates.folder()
CASES = {
    case["id"]: case
    for case in json.loads((Path(__file__).parents[2] / "cases" / "kinematics.json").read_text(encoding="utf-8"))
}
BOOK = Crane(6.103, math.radians(125), 7.0, 17.0)


def crane(*overrides: str) -> tmmcalc.Unsteady:
    return tmmcalc.solve_unsteady(tmmcalc.load_spec(CONFIGS / "crane-luffing.toml", overrides))


def rows(result: tmmcalc.Unsteady) -> dict[str, Values]:
    """The quantities of the cases by their names."""
    moved = result.trace
    tip = moved.point_names.index("C")
    boom, rack = (moved.link_ids.index(k) for k in (1, 2))
    names = ("phi1", "om1", "ep1"), ("phi2", "om2", "ep2")
    found = {
        name: rows[k]
        for k, each in zip((boom, rack), names, strict=True)
        for name, rows in zip(each, (moved.angle, moved.dangle, moved.ddangle), strict=True)
    }
    found |= dict(zip(("l2", "v23", "a23"), result.drive, strict=True))
    found |= {"xC": moved.r[tip].real, "yC": moved.r[tip].imag}
    found |= {"vCx": moved.dr[tip].real, "vCy": moved.dr[tip].imag}
    return found | {"aCx": moved.ddr[tip].real, "aCy": moved.ddr[tip].imag}


def check(result: tmmcalc.Unsteady, case: dict, times: list[float]) -> None:
    found, tolerance = rows(result), case["tolerance"]
    for t, row in zip(times, case["expected"]["rows"], strict=True):
        at = np.flatnonzero(np.abs(result.t - t) < 1e-6)
        assert at.size, t
        for name in row.keys() - {"t"}:
            assert found[name][at[0]] == pytest.approx(row[name], rel=tolerance["rel"], abs=tolerance["abs"]), (t, name)


def test_kin_s08() -> None:
    case = CASES["KIN-S08"]
    result, expected = crane(), case["expected"]
    law = result.law
    found = (law.ramp, law.uniform, law.travel, law.ramp_travel, law.uniform_travel)
    assert found == pytest.approx([expected[key] for key in ("t1", "t2", "S", "S1", "S2")], rel=1e-12)
    assert (result.start, result.end) == pytest.approx((expected["l2_start"], expected["l2_end"]), abs=1e-6)
    angles = np.degrees(rows(result)["phi1"][[0, -1]])
    assert angles == pytest.approx([expected["phi1_start_deg"], expected["phi1_end_deg"]], abs=1e-4)
    assert angles[0] - angles[1] == pytest.approx(expected["turn_deg"], abs=1e-3)
    check(result, case, case["inputs"]["times"])


def test_kin_s25() -> None:
    case = CASES["KIN-S25"]
    given, expected = case["inputs"], case["expected"]
    result = crane(
        f'mechanism.fixed.A={{ length = "{given["l0"]} m", angle = "{given["phi0_deg"]} deg" }}',
        f'mechanism.links[id=1].points={{ O = [0, 0], B = ["{given["l1"]} m", 0], C = ["{given["lC"]} m", 0] }}',
        'mechanism.input.start="5 m"',
        'mechanism.grid.span="0.5 m"',
        'mechanism.assembly.sketch={ B = ["2.37 m", "5.94 m"] }',
        f'unsteady={{ travel = "{given["S"]} m", speed = "0.25 m/s", acceleration = "0.08 m/s^2", steps = 20 }}',
    )
    law = result.law
    found = (law.ramp, law.uniform, law.duration, law.speed)
    assert found == pytest.approx([expected[key] for key in ("t1", "t2", "T", "v_peak")], abs=1e-7)
    assert math.degrees(rows(result)["phi1"][0]) == pytest.approx(expected["phi1_start_deg"], abs=1e-4)
    check(result, case, [row["t"] for row in expected["rows"]])


@pytest.mark.parametrize("steps", [1, 24, 97])
def test_closed_forms(steps: int) -> None:
    """Both limits at the jumps included: the closed forms take the rack's acceleration as it is."""
    result = crane(f"unsteady.steps={steps}")
    found = rows(result)
    expected = BOOK.at(*result.drive)
    for name, values in expected.items():
        scale = float(np.max(np.abs(values)))
        assert np.max(np.abs(found[name] - values)) < 2e-13 * scale, name
    jumps = [label for label in result.labels if label.endswith("-")]
    assert len(jumps) == 2


def test_start_and_end_outreach() -> None:
    """Raising the boom: the rack is drawn in, so the travel is negative."""
    result = crane_of('to = "2.5 m"')
    assert result.start == pytest.approx(BOOK.rack(3.3), rel=1e-13)
    assert result.end == pytest.approx(BOOK.rack(2.5), rel=1e-13)
    assert result.law.travel < 0
    assert result.coordinate[0, 0, [0, -1]] == pytest.approx([3.3, 2.5], rel=1e-12)
    expected = BOOK.at(*result.drive)
    assert rows(result)["ep1"] == pytest.approx(expected["ep1"], rel=1e-11)


def crane_of(lines: str) -> tmmcalc.Unsteady:
    """The crane with other ends: from an outreach of 3.3 m."""
    text = (CONFIGS / "crane-luffing.toml").read_text(encoding="utf-8").replace('duration = "12 s"', lines)
    return tmmcalc.solve_unsteady(tmmcalc.parse_spec(text))


def test_end_and_duration() -> None:
    result = crane_of('to = "6 m"\nduration = "14 s"')
    assert result.law.duration == pytest.approx(14, rel=1e-13)
    assert result.coordinate[0, 0, -1] == pytest.approx(6, rel=1e-12)
    assert result.law.speed < 0.2


def test_extremes_against_a_dense_table() -> None:
    result = crane()
    t = np.linspace(0, 12, 40_001)
    for side in (-1, 1):
        s, v, a = motion(result.law, t[1:-1], side)
        dense = BOOK.at(result.start + s, v, a)
        for name, column in (("omega_1", "om1"), ("eps_1", "ep1"), ("eps_2", "ep2")):
            found = next(each for each in result.extremes if each.name == name)
            assert found.least <= np.min(dense[column]) + 1e-15
            assert found.largest >= np.max(dense[column]) - 1e-15
            assert found.least == pytest.approx(np.min(dense[column]), abs=5e-6)
            assert found.largest == pytest.approx(np.max(dense[column]), abs=5e-6)


def test_an_outreach_that_is_not_reached() -> None:
    with pytest.raises(NoSolutionError, match="output C never is 18 m: it reaches from") as caught:
        crane_of('to = "18 m"')
    assert caught.value.limit == pytest.approx(17, rel=1e-12)


def test_the_limit_of_an_outreach_is_told_with_all_its_digits() -> None:
    """With the boom along the mast, at 125 deg, its tip is farthest back."""
    limit = 17 * math.cos(math.radians(125))
    with pytest.raises(NoSolutionError, match=f"from {limit:.9g} to 17 m") as caught:
        crane_of('to = "-9.7508 m"')
    assert caught.value.limit == pytest.approx(limit, rel=2e-11)


@pytest.mark.parametrize("short", [1e-2, 1e-4])
def test_an_outreach_near_its_limit_is_reached(short: float) -> None:
    asked = 17 * math.cos(math.radians(125)) + short
    result = crane_of(f'to = "{asked!r} m"')
    assert result.coordinate[0, 0, -1] == pytest.approx(asked, abs=1e-9)
    assert result.end == pytest.approx(BOOK.rack(asked), abs=1e-12)


def test_nearer_to_a_limit_than_rounding_is_told() -> None:
    with pytest.raises(SingularityError, match="a limit position is so near that a rounding decides"):
        crane_of('to = "-9.75079 m"')


@pytest.mark.parametrize("lines", ['duration = "12 s"', 'to = "6 m"', 'to = "-7.276 m"'])
def test_extremes_at_the_end_stand_at_the_end(lines: str) -> None:
    result = crane_of(lines)
    end = result.law.duration
    times = [at for each in result.extremes for at in (each.least_at, each.largest_at)]
    assert any(at == end for at in times)
    assert not [at for at in times if 0 < end - at < 1e-6 * end]


def test_from_a_limit_position_there_is_no_way_beyond_it() -> None:
    """The rack is shortest, 7 - 6.103 m, where the boom lies along the mast."""
    mechanism = to_linkage(
        tmmcalc.load_spec(
            CONFIGS / "crane-luffing.toml", ["mechanism.input.start=0.897000002", "mechanism.grid.span=1.0"]
        ).linkage
    )
    task = UnsteadyTask(0.05, 0.2, end=3.3, output="C", sense=-1)
    with pytest.raises(NoSolutionError, match=r"no way on the negative side: .* \[897, 13103\] mm only"):
        solve_unsteady(mechanism, task)


def test_the_tipper_against_its_triangle() -> None:
    """Cosine law of the triangle O, A, B, whose side AB is the cylinder."""
    result = tmmcalc.solve_unsteady(tmmcalc.load_spec(CONFIGS / "tipper.toml"))
    a, b = complex(1.6, -0.35), complex(2.8, 0.25)
    length, speed, acceleration = result.drive
    cosine = (abs(a) ** 2 + abs(b) ** 2 - length**2) / (2 * abs(a) * abs(b))
    gamma = np.arccos(cosine)
    body = gamma + np.angle(a) - np.angle(b)
    k = result.trace.link_ids.index(1)
    assert result.trace.angle[k] == pytest.approx(body, abs=1e-13)
    assert math.degrees(body[-1]) == pytest.approx(45, rel=1e-12)
    # l dl = |a||b| sin(gamma) dgamma, and its derivative
    product = abs(a) * abs(b)
    omega = length * speed / (product * np.sin(gamma))
    eps = (speed**2 + length * acceleration - product * cosine * omega**2) / (product * np.sin(gamma))
    assert result.trace.dangle[k] == pytest.approx(omega, abs=1e-14)
    assert result.trace.ddangle[k] == pytest.approx(eps, abs=1e-13)
