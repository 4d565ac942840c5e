"""Tooth sets and trains that keep the user's constraints, against the same search without them, row by row."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import tmmcalc
from tmmcalc.gears.advice import removals
from tmmcalc.gears.columns import set_columns
from tmmcalc.gears.selection.columns import chosen_columns
from tmmcalc.project import templates

GEARS = (templates.folder() / "gears-coaxial.toml").read_text()
SLIM = '\n[[constraints]]\nname = "slim"\nstage = "train"\ncolumn = "D"\nat_most = "400 mm"\n'
LIGHT = '\n[[constraints]]\nname = "light"\nstage = "criteria"\ncolumn = "mass"\nat_most = "2500 g"\n'
PRECISE = '\n[[constraints]]\nname = "precise"\nstage = "criteria"\ncolumn = "error"\nat_most = 0.002\n'


def run(text: str, target: str) -> Any:
    return tmmcalc.run(tmmcalc.parse_spec(GEARS + text), target=target).results


@pytest.fixture(scope="module")
def free() -> Any:
    return run("", "criteria")


def test_tooth_sets(free: Any) -> None:
    (whole,), (kept,) = free["train"].variants, run(SLIM, "train")["train"].variants
    before, after = set_columns(whole), set_columns(kept)
    rows = before["D[m]"] <= 0.4
    assert 0 < rows.sum() < len(rows)
    assert before.keys() == after.keys()
    assert all(np.array_equal(before[header][rows], after[header]) for header in before)
    assert kept.synthesis.count == rows.sum()
    assert kept.synthesis.complete
    assert removals(kept)[-1] == ("constraint slim", int(np.count_nonzero(~rows)), len(rows))


@pytest.mark.parametrize(("rule", "logic"), [("", np.logical_and), ("light or precise", np.logical_or)])
def test_trains(free: Any, rule: str, logic: Any) -> None:
    text = LIGHT + PRECISE + (f'\n[feasibility]\nrule = "{rule}"\n' if rule else "")
    results = run(text.replace("0.002", "0.008"), "feasibility")
    before, after = chosen_columns(free["criteria"]), chosen_columns(results["criteria"])
    rows = logic(before["mass[kg]"] <= 2.5, before["error"] <= 0.008)
    assert 0 < rows.sum() < len(rows)
    compared = [header for header in before if header not in ("i", "front", "rank")]
    assert all(np.array_equal(before[header][rows], after[header]) for header in compared)
    winner = results["criteria"].winner
    assert winner.values["inertia"] == before["inertia[kg*m^2]"][rows].min()
    assert results["feasibility"].feasible
    values = {verdict.name: verdict.value for verdict in results["feasibility"].verdicts}
    assert values == {"light": winner.values["mass"], "precise": winner.values["error"]}


def test_the_counts_of_trains(free: Any) -> None:
    mass, error = free["criteria"].pool.mass, free["criteria"].pool.error
    (each,) = run(LIGHT + PRECISE.replace("0.002", "0.008"), "criteria")["criteria"].variants
    assert each.refused == {"light": np.count_nonzero(mass > 2.5), "precise": np.count_nonzero(error > 0.008)}


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (SLIM.replace("400", "100"), "of 129 slim removed 129"),
        (LIGHT + PRECISE.replace("0.002", "0"), "no train keeps the constraints"),
    ],
)
def test_where_nothing_is_left(text: str, words: str) -> None:
    with pytest.raises(tmmcalc.NoSolutionError, match=words) as refused:
        run(text, "criteria")
    assert "is" in refused.value.remedy
    assert " to " in refused.value.remedy


def test_a_constraint_on_what_is_not_rows_leaves_the_search_alone() -> None:
    text = SLIM.replace('column = "D"', 'value = "count"').replace('"400 mm"', "100")
    results = run(text, "feasibility")
    assert len(results["train"].variants[0].sets) == 129
    assert results["feasibility"].failing == ("slim",)
