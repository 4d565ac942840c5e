"""Rules against Python's own logic, and what is no rule."""

from __future__ import annotations

import random
from itertools import product

import numpy as np
import pytest
from sparing import sparing

from tmmcalc import UsageError
from tmmcalc.feasibility.judge import Constraint, FeasibilityTask, judge, margin
from tmmcalc.feasibility.logic import FORMS, Form
from tmmcalc.feasibility.rule import check_names, failing, function, holds, names_of

RULES = ("a", "not a", "a and b", "a or b", "a and (b or not c)", "not (a and b) or c", "not (not a or b) and not c")
STATES = [dict(zip("abc", state, strict=True)) for state in product((True, False), repeat=3)]


@pytest.mark.parametrize("rule", RULES)
def test_truth(rule: str) -> None:
    for state in STATES:
        assert holds(rule, state) == eval(rule, {}, dict(state))


@pytest.mark.parametrize("rule", RULES)
@pytest.mark.parametrize("form", FORMS)
def test_the_sign_of_the_function_is_the_truth(rule: str, form: Form) -> None:
    generator = np.random.default_rng(5)
    for state in STATES:
        margins = {name: np.asarray(generator.uniform(0.1, 3) * (1 if on else -1)) for name, on in state.items()}
        assert (function(rule, margins, form, 1) >= 0) == holds(rule, state)


@pytest.mark.parametrize("rule", RULES)
def test_turning_all_causes_round_makes_a_rule_hold(rule: str) -> None:
    for state in STATES:
        causes = failing(rule, state)
        assert bool(causes) == (not holds(rule, state))
        assert holds(rule, {name: on != (name in causes) for name, on in state.items()})


@pytest.mark.parametrize("rule", ["a + b", "a and", "f(a)", "a if b else c", "a and 1", "(" * 900, "a " * 2000])
def test_what_is_no_rule(rule: str) -> None:
    with pytest.raises(UsageError) as refused:
        names_of(rule)
    assert refused.value.where == "feasibility.rule"
    assert refused.value.remedy


def test_a_name_that_no_constraint_has() -> None:
    with pytest.raises(UsageError, match="'swft'") as refused:
        check_names("stroke and swft", ["stroke", "swift"])
    assert 'did you mean "swift"?' in refused.value.remedy


def test_margins_and_verdicts() -> None:
    assert margin(3.0, 2.0, 4.0) == 0.25
    assert margin(-1.0, 0.0, None) == -1.0
    task = FeasibilityTask(
        (Constraint("a", "s", value="v", at_least=1.0), Constraint("b", "s", value="w", at_most=2.0))
    )
    result = judge(task, {"a": (0.5, "m", 1.0, None), "b": (1.0, "N", None, 2.0)})
    assert [verdict.holds for verdict in result.verdicts] == [False, True]
    assert result.rule == "a and b"
    assert result.failing == ("a",)
    assert not result.feasible
    assert result.function == -0.5


def some_rule(generator: random.Random, depth: int) -> str:
    """A random rule of the names a to f."""
    kind = generator.random()
    if depth == 0 or kind < 0.2:
        return generator.choice("abcdef")
    if kind < 0.4:
        return f"not ({some_rule(generator, depth - 1)})"
    word = generator.choice((" and ", " or "))
    return f"({word.join(some_rule(generator, depth - 1) for _ in range(generator.randint(2, 3)))})"


@sparing("form", FORMS, every=3)
def test_random_rules_keep_their_sign_however_deep(form: Form) -> None:
    generator, sizes = random.Random(7), np.random.default_rng(7)
    for _ in range(300):
        rule = some_rule(generator, 5)[:1990]
        margins = {name: np.asarray(sizes.normal() * 10.0 ** sizes.integers(-6, 7)) for name in "abcdef"}
        truths = {name: bool(value >= 0) for name, value in margins.items()}
        if rule.count("(") != rule.count(")"):
            continue
        assert holds(rule, truths) == eval(rule, {}, dict(truths))
        value = float(function(rule, margins, form, 9))
        assert np.isfinite(value)
        assert (value >= 0) == holds(rule, truths)


@pytest.mark.parametrize(
    ("rule", "words"),
    [
        ("not " * 160 + "a", "nested deeper than 150 times"),
        ("calm.x and a", "'calm.x' is no name of a constraint"),
        ("a < b < c", "'a < b < c' is no name"),
        ("a and 1e999", "is no name"),
        ("a; b", "not a rule at column 2"),
    ],
)
def test_faults_of_a_rule_tell_their_cause(rule: str, words: str) -> None:
    with pytest.raises(UsageError, match=words):
        names_of(rule)


def test_margins_are_finite() -> None:
    assert np.isfinite(margin(1e200, 1e-200, None))
