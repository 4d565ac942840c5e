"""Demands hold by their margin, and no decision hangs on the last digits."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tmmcalc.batch.task import Row
from tmmcalc.classroom.choosing import Chooser
from tmmcalc.classroom.demands import Limits, Spread, limits_of
from tmmcalc.classroom.judging import Judge
from tmmcalc.design.model import Answers, Model
from tmmcalc.feasibility.judge import Constraint, FeasibilityTask

SHAPER = Path(__file__).parents[2] / "configs" / "assignment-shaper.toml"


def limits(rule: str = "", margin: float = 0.1) -> Limits:
    """`swift` is at least 100, `light` between 10 and 20, `level` at least 0; the assignment has 150, 15 and 8."""
    constraints = (
        Constraint("swift", "kinematics", column="v_D", at_least=100.0),
        Constraint("light", "kinematics", column="m_D", at_least=10.0, at_most=20.0),
        Constraint("level", "kinematics", column="z_D", at_least=0.0),
    )
    columns = {"swift": (0, 150.0, ""), "light": (1, 15.0, ""), "level": (2, 8.0, "")}
    return limits_of(FeasibilityTask(constraints, rule), columns, margin)


def test_limits_are_kept_by_a_part_of_them() -> None:
    """110; 12 to 18, by a part of the larger limit; 0.8, by a part of what the assignment has."""
    rows = [(111, 15, 1), (109, 15, 1), (111, 11.9, 1), (111, 18.1, 1), (111, 15, 0.7), (111, 12.1, 0.9)]
    assert limits().broken(np.array(rows, float)) == ["", "swift", "light", "light", "level", ""]


def test_what_is_at_a_limit_but_for_rounding_is_within() -> None:
    ends = (110.0, 12.0, 0.8)
    for off in (-1e-14, 0.0, 1e-14):
        assert limits().broken(np.array([ends]) * (1 + off)) == [""]
    assert limits().broken(np.array([ends]) * (1 - 1e-8)) != [""]


def test_a_rule_with_not_is_kept_by_the_margin_on_the_other_side() -> None:
    """Not swift is below 90: what is between 90 and 110 is neither."""
    own = limits("not swift")
    rows = np.array([[v, 15, 1] for v in (89.0, 90.0, 91.0, 100.0, 109.0, 111.0)])
    assert [not each for each in own.broken(rows)] == [True, True, False, False, False, False]
    either = limits("swift or not light")
    assert [not each for each in either.broken(np.array([[111, 15, 1], [105, 15, 1], [105, 7.9, 1], [105, 9, 1]]))] == [
        True,
        False,
        True,
        False,
    ]


def test_what_is_not_known_yet_may_be_what_suits() -> None:
    part = limits().among({1: 0})
    assert part.broken(np.array([[15.0], [11.0]])) == ["", "light"]
    either = limits("swift or light").among({1: 0})
    assert either.broken(np.array([[15.0], [11.0]])) == ["", ""]


def test_a_result_is_within_the_root_of_the_spread() -> None:
    spread = Spread.of("H", -6.0, 9.0, 0.0)
    assert (spread.low, spread.high) == (2.0, 18.0)
    kept = [spread.refusal(value) is None for value in (1.99, 2.0 * (1 - 1e-12), -18.0, 18.1)]
    assert kept == [False, True, True, False]
    assert Spread.of("a", 0.01, 9.0, 0.05).refusal(1e6) is None
    assert math.isinf(Spread.of("a", 0.0, 9.0, 0.0).high)


@pytest.mark.slow
@pytest.mark.parametrize("seed", [1, 2])
def test_other_last_digits_choose_the_same(monkeypatch: pytest.MonkeyPatch, seed: int) -> None:
    """As on another machine: every result of every candidate is off by up to 1e-12 of itself."""
    before = Chooser(Judge(SHAPER, 1), 7).choose(15)
    rng = np.random.default_rng(seed)
    whole, answers = Judge.whole, Model.answers

    def off(values: Any) -> Any:
        return np.asarray(values) * (1 + 1e-12 * rng.uniform(-1, 1, np.shape(values)))

    def other_rows(self: Judge, candidates: Any) -> Any:
        return [Row(row.point, row.status, row.reason, row.names, off(row.values)) for row in whole(self, candidates)]

    def other_answers(self: Model, rows: Any) -> Answers:
        found = answers(self, rows)
        return Answers(off(found.values), found.reasons)

    monkeypatch.setattr(Judge, "whole", other_rows)
    monkeypatch.setattr(Model, "answers", other_answers)
    after = Chooser(Judge(SHAPER, 1), 7).choose(15)
    assert [each.assignments for each in after.chosen] == [each.assignments for each in before.chosen]
    assert after.refused == before.refused
    assert [each.values for each in after.chosen] != [each.values for each in before.chosen]
