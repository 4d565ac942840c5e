"""Rows kept and counts of what constraints removed, against plain loops over rows and over what is not known."""

from __future__ import annotations

from itertools import product

import numpy as np
import pytest

from tmmcalc import UsageError
from tmmcalc.feasibility.judge import Constraint, FeasibilityTask
from tmmcalc.feasibility.rows import keep

CONSTRAINTS = (
    Constraint("a", "criteria", column="mass", at_most="2000 g"),
    Constraint("b", "criteria", column="z", at_least=20, at_most=30),
    Constraint("u", "kinematics", value="stroke_D", at_least=1.0),
    Constraint("v", "criteria", value="winner_row", at_most=3),
)
GENERATOR = np.random.default_rng(11)
COLUMNS = {"layout": np.full(40, "AI"), "mass[kg]": GENERATOR.uniform(1, 3, 40), "z": GENERATOR.integers(15, 36, 40)}
RULES = ("", "a and b", "a or b", "not a", "a and (b or u)", "u or v", "not (a and u) and b", "a and not b or v and u")


@pytest.mark.parametrize("rule", RULES)
def test_rows_that_the_rule_may_hold_with(rule: str) -> None:
    task = FeasibilityTask(CONSTRAINTS, rule)
    kept = keep(task, "criteria", COLUMNS)
    for k, (mass, z) in enumerate(zip(COLUMNS["mass[kg]"], COLUMNS["z"], strict=True)):
        state = {"a": mass <= 2, "b": 20 <= z <= 30}
        ways = ({**state, "u": u, "v": v} for u, v in product((True, False), repeat=2))
        assert kept.rows[k] == any(eval(rule or "a and b and u and v", {}, way) for way in ways)


def test_what_removed_rows() -> None:
    mass, z = COLUMNS["mass[kg]"], COLUMNS["z"]
    heavy, odd = mass > 2, (z < 20) | (z > 30)
    assert keep(FeasibilityTask(CONSTRAINTS), "criteria", COLUMNS).removed == {"a": heavy.sum(), "b": odd.sum()}
    both = keep(FeasibilityTask(CONSTRAINTS, "a or b"), "criteria", COLUMNS)
    assert both.removed == {"a": (heavy & odd).sum(), "b": (heavy & odd).sum()}
    excluded = keep(FeasibilityTask(CONSTRAINTS, "not a"), "criteria", COLUMNS)
    assert excluded.removed == {"a": (~heavy).sum(), "b": 0}
    assert keep(FeasibilityTask(CONSTRAINTS, "a or u"), "criteria", COLUMNS).rows.all()
    assert excluded.told[1] == f"b: z is {z.min()} to {z.max()}"


@pytest.mark.parametrize(("column", "limit"), [("layout", 1.0), ("weight", 1.0), ("mass", "3 mm")])
def test_columns_that_cannot_be_judged(column: str, limit: float | str) -> None:
    task = FeasibilityTask((Constraint("x", "train", column=column, at_most=limit),))
    with pytest.raises(UsageError) as refused:
        keep(task, "train", COLUMNS)
    assert refused.value.where == "constraints, x"
    assert refused.value.remedy
