"""Trailing rods of V-engines: the textbook's engine, a search by scipy on its demands, sizes that are given."""

from __future__ import annotations

import json
import math
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.optimize import brentq, minimize_scalar

import tmmcalc
from tmmcalc.core.errors import NoSolutionError
from tmmcalc.linkage.synthesis.kinds import solve_synthesis
from tmmcalc.linkage.synthesis.results import Synthesis
from tmmcalc.linkage.synthesis.task import SynthesisTask, TrailingRodTask

ROOT = Path(__file__).parents[3]
CASE = next(
    case for case in json.loads((ROOT / "tests" / "cases" / "kinematics.json").read_text()) if case["id"] == "KIN-S23"
)
ENGINE = TrailingRodTask(math.radians(45), 0.07, 0.25, 0.06)


def solved(asked: TrailingRodTask) -> Synthesis:
    return solve_synthesis(SynthesisTask("trailing_rod", asked))


def test_the_worked_engine_from_its_v_angle() -> None:
    given, expected = CASE["inputs"], CASE["expected"]
    lengths = (given[key] / 1000 for key in ("l1", "l2", "lC"))
    best = solved(TrailingRodTask(math.radians(given["beta_deg"]), *lengths)).best
    degrees, absolute = CASE["tolerance"]["abs_deg"], CASE["tolerance"]["abs"]
    assert math.degrees(best.size("alpha")) == pytest.approx(expected["alpha_deg"], abs=degrees)
    assert best.size("l_4") == pytest.approx(given["l4"] / 1000, rel=1e-15)
    bottom = math.degrees(best.check("crank at the bottom of the left piston").achieved) - 180
    assert bottom == pytest.approx(expected["bdc_left_phi_deg"], abs=degrees)
    for name, key in (("S", "right"), ("S of the left piston", "left")):
        stroke = best.check(name).achieved / (given["l1"] / 1000)
        assert stroke == pytest.approx(expected[f"stroke_{key}_over_l1"], abs=absolute)


def test_the_engine_found_moves_as_the_typed_one() -> None:
    """`v-engine` has alpha typed with 14 digits and l_4 as it is."""
    found = tmmcalc.solve_synthesis(tmmcalc.load_spec(ROOT / "configs" / "synth-trailing-rod.toml"))
    own, typed = (
        tmmcalc.solve_kinematics(spec)
        for spec in (tmmcalc.parse_spec(found.best.spec), tmmcalc.load_spec(ROOT / "configs" / "v-engine.toml"))
    )
    assert own.summaries[1].stroke == pytest.approx(typed.summaries[1].stroke, rel=1e-13)
    names = own.trace.point_names
    assert names == typed.trace.point_names
    same = [k for k, x in enumerate(own.x) if np.min(np.abs(typed.x - x)) < 1e-12]  # the extremes stand between
    assert len(same) == len(typed.x)
    for name in ("r", "dr", "ddr"):
        one, two = getattr(own.trace, name), getattr(typed.trace, name)
        assert np.max(np.abs(one[:, same] - two)) < 1e-12 * np.max(np.abs(two))


@pytest.mark.parametrize(("beta", "r", "lug"), [(45, 0.07, 0.06), (90, 0.07, 0.06), (120, 0.05, 0.04), (15, 0.1, 0.09)])
def test_a_search_for_equal_tops_finds_the_same(beta: float, r: float, lug: float) -> None:
    """Of the slide of D alone: its top at the crank's angle beta settles alpha, its height l_4."""
    l, left = 0.25, math.radians(beta)

    def slide(phi: float, alpha: float, length: float) -> float:
        pin = r * np.exp(1j * phi) + lug * np.exp(1j * (alpha - math.asin(r / l * math.sin(phi))))
        pin *= np.exp(-1j * left)
        return float(pin.real + math.sqrt(length**2 - pin.imag**2))

    def top(alpha: float, length: float) -> Any:
        near = (left - 0.6, left + 0.6)
        options = {"xatol": 1e-13}
        return minimize_scalar(lambda x: -slide(x, alpha, length), bounds=near, method="bounded", options=options)

    def rate(alpha: float, length: float, step: float = 1e-4) -> float:
        return slide(left + step, alpha, length) - slide(left - step, alpha, length)

    alpha, length = left, 0.15
    for _ in range(30):
        alpha = float(brentq(rate, left - 0.5, left + 0.9, args=(length,), xtol=1e-15))
        length = float(brentq(lambda y, at=alpha: -top(at, y).fun - (r + l), 0.12, 0.28, xtol=1e-15))
    best = solved(TrailingRodTask(left, r, l, lug)).best
    assert length == pytest.approx(best.size("l_4"), rel=1e-9)
    assert alpha == pytest.approx(best.size("alpha"), abs=1e-6)  # a difference quotient is exact to its step squared
    assert top(alpha, length).x == pytest.approx(left, abs=1e-6)


def test_an_engine_without_v_is_its_own_mirror() -> None:
    """Opposed cylinders: sin(180 deg) = 0, so the lug lies along the master rod, turned by half a turn."""
    best = solved(replace(ENGINE, v_angle=math.pi)).best
    assert best.size("alpha") == pytest.approx(math.pi, abs=1e-15)
    assert best.check("top of the left piston").achieved == pytest.approx(0.32, rel=1e-14)


def test_sizes_that_are_given_are_compared() -> None:
    typed = solved(replace(ENGINE, lug_angle=math.radians(56.41944), length=0.19)).best
    assert not typed.defects
    off = solved(replace(ENGINE, lug_angle=math.radians(50), length=0.195)).best
    assert [words.partition(",")[0] for words in off.defects] == [
        "the lug stands at 50 deg",
        "the trailing rod has 195 mm",
    ]
    assert "the top of the left piston is 324.511 mm from the crank's axis" in off.defects[1]
    top = off.check("top of the left piston")
    assert top.target is None
    assert top.achieved > 0.32


def test_a_trailing_rod_that_does_not_reach_is_refused() -> None:
    with pytest.raises(NoSolutionError, match=r"rod, 70 mm, does not reach .* 85\.1357 mm off at phi = 180"):
        solved(replace(ENGINE, lug=0.18))
