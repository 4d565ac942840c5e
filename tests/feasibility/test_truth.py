"""Rules alone: values, functions and truths that are given, truth tables and short forms against plain logic."""

from __future__ import annotations

import json
import random
from itertools import product
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from typer.testing import CliRunner

import tmmcalc
from tmmcalc.cli.app import app
from tmmcalc.core.errors import LimitError, UsageError
from tmmcalc.feasibility.logic import FORMS, Form
from tmmcalc.feasibility.rule import names_of
from tmmcalc.feasibility.truth import ALWAYS, NEVER, TruthTable, truth_table
from tmmcalc.project import templates

RUNNER = CliRunner()
RULES = str(templates.path("rules"))


def random_rule(choice: random.Random, names: str, depth: int) -> str:
    if depth == 0 or choice.random() < 0.15:
        return choice.choice(names)
    kind = choice.choice(("and", "or", "not"))
    if kind == "not":
        return f"not ({random_rule(choice, names, depth - 1)})"
    return f"({random_rule(choice, names, depth - 1)} {kind} {random_rule(choice, names, depth - 1)})"


def random_rules(count: int, names: str = "abcde", depth: int = 5) -> list[str]:
    choice = random.Random(17)
    return [random_rule(choice, names, depth) for _ in range(count)]


def truths(rule: str, names: tuple[str, ...]) -> list[bool]:
    """By Python itself, in the order of the table."""
    return [
        bool(eval(rule, {}, dict(zip(names, state, strict=True))))
        for state in product((False, True), repeat=len(names))
    ]


def table_of(rule: str) -> TruthTable:
    return truth_table(rule, dict.fromkeys(names_of(rule), True))


def test_tables_and_short_forms_are_those_of_plain_logic() -> None:
    for rule in random_rules(150):
        table = table_of(rule)
        expected = truths(rule, table.names)
        assert table.holds.tolist() == expected
        assert table.states.tolist() == [list(state) for state in product((False, True), repeat=len(table.names))]
        assert table.now == 2 ** len(table.names) - 1
        if table.short in (ALWAYS, NEVER):
            assert set(expected) == {table.short == ALWAYS}
        else:
            assert truths(table.short, table.names) == expected
            assert table.short.count(" not ") <= len(table.short)


def test_nothing_can_be_left_out_of_a_short_form() -> None:
    """Neither a term nor a word of one, in either of its two forms."""
    for rule in random_rules(60, "abcd", 6):
        table = table_of(rule)
        if table.short in (ALWAYS, NEVER):
            continue
        outer, inner = (" and ", " or ") if "(" in table.short or " or " not in table.short else (" or ", " and ")
        terms = [term.strip("()").split(inner) for term in table.short.split(outer)]
        assert truths(outer.join(f"({inner.join(term)})" for term in terms), table.names) == table.holds.tolist()
        for k, term in enumerate(terms):
            shorter = [[*terms[:k], *terms[k + 1 :]]] if len(terms) > 1 else []
            shorter += [[*terms[:k], term[:i] + term[i + 1 :], *terms[k + 1 :]] for i in range(len(term)) if term[1:]]
            for left in shorter:
                text = outer.join(f"({inner.join(words)})" for words in left)
                assert truths(text, table.names) != table.holds.tolist(), (rule, table.short, text)


@pytest.mark.parametrize(
    ("rule", "short"),
    [
        ("a or not a", ALWAYS),
        ("a and not a", NEVER),
        ("a and b or a and not b", "a"),
        ("a and b or a and c", "a and (b or c)"),
        ("not (a and b)", "not a or not b"),
        ("a and b or not a and c or b and c", "a and b or not a and c"),
    ],
)
def test_known_short_forms(rule: str, short: str) -> None:
    assert table_of(rule).short == short


def test_a_table_has_ten_names_at_most() -> None:
    names = [f"n{k}" for k in range(11)]
    assert len(table_of(" or ".join(names[:10])).holds) == 1024
    with pytest.raises(UsageError, match="the rule has 11 names: a table of 2048 combinations") as refused:
        table_of(" and ".join(names))
    assert "10 names at most" in refused.value.remedy


@pytest.mark.parametrize("form", FORMS)
def test_given_functions_are_combined_by_the_rule(form: Form) -> None:
    """The sign of the function of a random rule of random functions is its truth."""
    generator = np.random.default_rng(3)
    for rule in random_rules(25, "abcd", 4):
        values = {name: float(value) for name, value in zip("abcd", generator.normal(size=4), strict=True)}
        text = "".join(f'[[constraints]]\nname = "{name}"\nfunction = {value}\n' for name, value in values.items())
        smooth = "smoothness = 2\n" if form == "Rm" else ""
        spec = tmmcalc.parse_spec(f'{text}[feasibility]\nrule = "{rule}"\nform = "{form}"\n{smooth}')
        found = tmmcalc.solve_feasibility(spec)
        expected = eval(rule, {}, {name: value >= 0 for name, value in values.items()})
        assert found.feasible == expected == (found.function >= 0)
        assert [verdict.margin for verdict in found.verdicts] == [*values.values()]


@pytest.mark.parametrize(
    ("lines", "holds", "margin"),
    [
        ('value = "35 deg"\nat_least = "35 deg"', True, 0.0),
        ('value = "30 deg"\nat_most = "0.5 rad"', False, (0.5 - np.pi / 6) / 0.5),
        ('value = "410 mm"\nat_least = "0.4 m"\nat_most = 450', True, 0.025),
        ("value = 11.5\nat_most = 12", True, 0.5 / 12),
        ("function = 0", True, 0.0),
        ("function = -1e-200", False, -1e-200),
        ("holds = true", True, 1.0),
        ("holds = false", False, -1.0),
    ],
)
def test_what_is_given_and_its_margin(lines: str, holds: bool, margin: float) -> None:
    found = tmmcalc.solve_feasibility(tmmcalc.parse_spec(f'[[constraints]]\nname = "a"\n{lines}\n'))
    assert found.feasible == holds
    assert found.verdicts[0].margin == pytest.approx(margin, rel=1e-12, abs=1e-310)


def printed(*words: str) -> Any:
    done = RUNNER.invoke(app, ["feasibility", RULES, "--no-store", "-q", *words])
    if done.exception is not None and not isinstance(done.exception, SystemExit):
        raise done.exception
    return done.stdout


def test_the_ready_rules() -> None:
    found = json.loads(printed("-f", "json"))
    assert found["feasible"] is True
    assert found["columns"]["holds"] == ["yes", "no", "yes", "no", "yes"]
    root = 1 / 6 + 1 - np.hypot(1 / 6, 1)  # the last step of R0 joins what is the least with what is larger
    assert 0 < found["function"] < root
    failed = printed("--set", "constraints[name=proven].holds=false", "--set", "constraints[name=stiff].function=1")
    assert "does not hold: compact, proven, stiff" in failed.replace("\n                ", " ")
    assert "warning: constraint proven: given as false; asked" in failed


def test_truth_on_the_command_line() -> None:
    out = printed("--truth")
    assert "short form  transmits and (compact or light) and (compact or proven) and (proven" in out
    assert "holds in    8 of 32 combinations" in out
    assert "        1        0      1       1      0      1  *" in out
    rows = [line.split(",") for line in printed("--truth", "-f", "csv").splitlines()]
    assert rows[0] == ["transmits", "compact", "light", "proven", "stiff", "holds", "now"]
    assert [row[-1] for row in rows[1:]].index("*") == 0b10110
    with pytest.raises(UsageError, match="together with --over"):
        printed("--truth", "--over", "constraints[name=light].value=1:2:3")
    with pytest.raises(LimitError, match="the rule does not hold"):
        printed("--truth", "--strict", "--set", "constraints[name=transmits].value='5 deg'")


def test_a_map_over_given_values() -> None:
    over = ["constraints[name=transmits].value=20 deg:50 deg:31", "constraints[name=light].value=9:14:6"]
    found = tmmcalc.map_feasibility(Path(RULES), over)
    angle, weight = np.meshgrid(np.linspace(20, 50, 31), np.linspace(9, 14, 6), indexing="ij")
    assert np.array_equal(found.feasible.reshape(found.shape), (angle >= 30) & (weight <= 12))


def test_given_and_found_together(tmp_path: Path) -> None:
    text = (
        templates.text("four-bar")
        + """
[[constraints]]
name = "found"
stage = "kinematics"
column = "omega_3"
of = "size"
at_least = 0

[[constraints]]
name = "given"
holds = true
"""
    )
    found = tmmcalc.solve_feasibility(tmmcalc.parse_spec(text))
    assert found.feasible
    assert [verdict.quantity for verdict in found.verdicts] == ["kinematics size omega_3", "given truth"]
