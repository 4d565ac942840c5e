"""From [[constraints]] and [feasibility] to the task: every key, defaults, the docs, hostile values."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from faults import HOSTILE, check_lines

import tmmcalc
from tmmcalc.feasibility.judge import FeasibilityTask
from tmmcalc.feasibility.logic import FORMS
from tmmcalc.feasibility.tables.constraints import ConstraintTable
from tmmcalc.feasibility.tables.feasibility import FeasibilityTable
from tmmcalc.feasibility.tables.tasks.feasibility import to_feasibility
from tmmcalc.naming.language import OF

DOCS = Path(__file__).parents[3] / "docs" / "spec.md"
BASE = '[synthesis.crank_rocker]\nswing = "40 deg"\nrocker = 1\n'
NEEDED = {"name": '"swift"', "stage": '"kinematics"', "column": '"vS_D"', "at_most": '"2 m/s"'}


def text(feasibility: str = "", without: str = "", **given: str) -> str:
    kept = {key: value for key, value in {**NEEDED, **given}.items() if key != without}
    lines = "".join(f"{key} = {value}\n" for key, value in kept.items())
    return f"{BASE}\n[[constraints]]\n{lines}" + (f"\n[feasibility]\n{feasibility}\n" if feasibility else "")


def asked(feasibility: str = "", without: str = "", **given: str) -> FeasibilityTask:
    return to_feasibility(tmmcalc.parse_spec(text(feasibility, without, **given)))


def ruled(lines: str) -> FeasibilityTask:
    """A constraint on what is given, in a spec of its own."""
    return to_feasibility(tmmcalc.parse_spec(f'[[constraints]]\nname = "calm"\n{lines}\n'))


def told(task: FeasibilityTask, sense: str, at_least: float) -> float | str | None:
    """What is given, of this sense and with this limit."""
    (constraint,) = task.constraints
    assert (constraint.sense, constraint.at_least) == (sense, at_least)
    return constraint.given


KEYS: dict[str, tuple[Callable[[], FeasibilityTask], Callable[[FeasibilityTask], Any], Any]] = {
    "name": (asked, lambda task: task.constraints[0].name, "swift"),
    "stage": (asked, lambda task: task.constraints[0].stage, "kinematics"),
    "value": (lambda: asked(without="column", value='"stroke_D"'), lambda task: task.constraints[0].value, "stroke_D"),
    "column": (asked, lambda task: task.constraints[0].column, "vS_D"),
    "of": (lambda: asked(of='"size"'), lambda task: task.constraints[0].of, "size"),
    "at_least": (lambda: asked(at_least="1"), lambda task: task.constraints[0].at_least, 1),
    "at_most": (asked, lambda task: task.constraints[0].at_most, "2 m/s"),
    "function": (lambda: ruled("function = -0.25"), lambda task: told(task, "function", 0.0), -0.25),
    "holds": (lambda: ruled("holds = false"), lambda task: told(task, "truth", 0.0), -1),
}
COMBINED: dict[str, tuple[str, Callable[[FeasibilityTask], Any], Any]] = {
    "rule": ('rule = "not swift"', lambda task: task.rule, "not swift"),
    "form": ('form = "R0"', lambda task: task.form, "R0"),
    "smoothness": ('form = "Rm"\nsmoothness = 3', lambda task: task.m, 3),
}


@pytest.mark.parametrize("key", KEYS)
def test_every_key_of_a_constraint_reaches_the_task(key: str) -> None:
    task, read, value = KEYS[key]
    assert read(task()) == value


@pytest.mark.parametrize("key", COMBINED)
def test_every_key_of_the_rule_reaches_the_task(key: str) -> None:
    lines, read, value = COMBINED[key]
    assert read(asked(lines)) == value


def test_every_key_has_its_test_and_its_line_in_the_docs() -> None:
    assert KEYS.keys() == ConstraintTable.model_fields.keys()
    assert COMBINED.keys() == FeasibilityTable.model_fields.keys()
    section = DOCS.read_text().split("## `[[constraints]]`")[1].split("## Values")[0]
    assert [name for name in (*KEYS, *COMBINED) if f"`{name}`" not in section] == []
    assert [word for word in (*{*OF} - {"chosen"}, *FORMS) if f'`"{word}"`' not in section] == []


def test_defaults() -> None:
    task = asked()
    assert (task.constraints[0].of, task.constraints[0].at_least, task.form, task.m) == ("max", None, "minmax", 1)
    assert (task.rule, task.combined) == ("", "swift")
    assert not tmmcalc.parse_spec(BASE).constraints


def test_rows_that_are_judged_one_by_one_have_no_of() -> None:
    with pytest.raises(tmmcalc.SpecError) as refused:
        asked(stage='"criteria"', of='"min"')
    assert [fault.path for fault in refused.value.faults] == ["constraints[0].of"]
    assert asked(stage='"criteria"').constraints[0].quantity == "criteria vS_D"


@pytest.mark.parametrize(
    ("key", "value", "message"),
    [
        ("name", '"not"', "'not' cannot name a constraint: rules keep this word"),
        ("name", '"class"', "'class' cannot name a constraint: rules keep this word"),
        ("name", '"o k"', "'o k' cannot name a constraint"),
        ("name", "3", "3 cannot name a constraint"),
        ("at_most", "[1]", "[1] is not a limit"),
        ("at_most", "true", "true is not a limit"),
        ("at_most", "nan", "nan is not a finite number of ordinary size"),
        ("at_most", '"6 cows"', "'6 cows' is no quantity"),
    ],
)
def test_names_and_limits_that_cannot_be_are_one_fault(key: str, value: str, message: str) -> None:
    with pytest.raises(tmmcalc.SpecError) as refused:
        asked(**{key: value})
    assert [(fault.path, fault.message) for fault in refused.value.faults] == [(f"constraints[0].{key}", message)]


@pytest.mark.parametrize(
    ("lines", "path", "message"),
    [
        ("", "", "missing key: a constraint is on the result of a stage, or on what is given"),
        ("at_most = 2", "", "missing key: a constraint is on the result of a stage, or on what is given"),
        ('column = "R_A"\nat_most = 2', "", "missing key: column names what a stage tells, and there is no stage"),
        ('value = "stroke_D"\nat_most = 2', ".value", "there is no result that it could be on"),
        ('value = "35 deg"', "", "missing key: at_least or at_most"),
        ("value = true\nat_most = 2", ".value", "true is not a value"),
        ('value = "35"\nat_most = 2', ".value", "'35' is no quantity"),
        ('value = "-6 cows"\nat_most = 2', ".value", "'-6 cows' is no quantity"),
        ("value = nan\nat_most = 2", ".value", "nan is not a finite number of ordinary size"),
        ("function = 0.2\nholds = true", ".holds", "holds together with function: one of them is given"),
        ("holds = true\nat_least = 2", ".at_least", "at_least of holds: limits are those of a value"),
        ("holds = 1", ".holds", "1 is neither true nor false"),
        ('function = "fast"', ".function", "'fast' is not a signed value"),
        ('value = "35 deg"\nat_most = "2 m"', ".at_most", "'2 m' cannot be compared: the value is in deg"),
        ('value = 35\nat_most = "2 m"', ".at_most", "'2 m' cannot be compared: the value is a bare number"),
        ('stage = "kinematics"\nvalue = "a"\nat_most = 2', ".stage", "there is no result that it could be on"),
    ],
)
def test_what_is_given_in_a_wrong_way_is_one_fault(lines: str, path: str, message: str) -> None:
    with pytest.raises(tmmcalc.SpecError) as refused:
        ruled(lines)
    (fault,) = refused.value.faults
    assert fault.path == f"constraints[0]{path}"
    assert fault.message.startswith(message)
    assert fault.line
    assert fault.remedy


@pytest.mark.parametrize(
    ("given", "path", "message"),
    [
        ({"value": "3.5", "without": "column"}, "value", "3.5 is a given value"),
        ({"holds": "true"}, "holds", "holds together with stage"),
        ({"function": "0.2"}, "function", "function together with stage"),
    ],
)
def test_a_result_is_not_given_besides(given: dict[str, str], path: str, message: str) -> None:
    with pytest.raises(tmmcalc.SpecError) as refused:
        asked(**given)
    assert [fault.path for fault in refused.value.faults] == [f"constraints[0].{path}"]
    assert refused.value.faults[0].message.startswith(message)


@pytest.mark.parametrize("key", KEYS)
def test_no_value_breaks_the_checks(key: str) -> None:
    for value in HOSTILE:
        check_lines(text(**{key: value}))
        given = "" if key == "name" else f"{key} = {value}\n"
        check_lines(f'[[constraints]]\nname = "calm"\n{given}at_most = "2 m/s"\n')


@pytest.mark.parametrize("key", COMBINED)
def test_no_value_of_the_rule_breaks_the_checks(key: str) -> None:
    for value in HOSTILE:
        check_lines(text(f"{key} = {value}"))


def test_no_table_of_another_type_breaks_the_checks() -> None:
    for value in HOSTILE:
        check_lines(f"constraints = {value}\n{BASE}")
        check_lines(f"feasibility = {value}\n{text()}")
