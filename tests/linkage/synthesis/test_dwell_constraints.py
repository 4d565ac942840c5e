"""[[constraints]] in the search for a six-bar with a dwell: kept, counted, told under the names of the document."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import tmmcalc
from tmmcalc.core.facts import facts
from tmmcalc.feasibility.judge import Constraint, FeasibilityTask
from tmmcalc.linkage.synthesis.columns import table
from tmmcalc.linkage.synthesis.dwell.constraints import BARRIER, Rule, told_columns, told_values
from tmmcalc.linkage.synthesis.dwell.criteria import rated
from tmmcalc.linkage.synthesis.dwell.parameters import NAMES, drawn, given
from tmmcalc.linkage.synthesis.dwell.task import DwellTask
from tmmcalc.linkage.synthesis.dwell.turn import whole_turn
from tmmcalc.linkage.synthesis.results import Synthesis
from tmmcalc.linkage.tables.tasks.synthesis import to_synthesis
from tmmcalc.naming.rows import REDUCED

pytestmark = pytest.mark.slow

CONFIGS = Path(__file__).parents[3] / "configs"
SEARCH = """[synthesis]
solutions = 3
[synthesis.dwell]
dwell = "90 deg"
n = 0.5
stroke = "200 mm"
[synthesis.dwell.positions]
psi12 = "-43.5 deg"
psi13 = "-91.5 deg"
CD = 0.8
alpha = "-11 deg"
[synthesis.dwell.optimum]
population = 24
generations = 8
polish = 30
"""


def constraint(name: str, more: str) -> str:
    return f'[[constraints]]\nname = "{name}"\nstage = "synthesis"\n{more}\n'


def solved(more: str = "") -> Synthesis:
    return tmmcalc.solve_synthesis(tmmcalc.parse_spec(SEARCH + more))


def test_the_search_keeps_a_constraint_that_its_best_linkage_breaks() -> None:
    free = solved().best
    wanted = 1.5 * free.size("l_CB")
    kept = solved(constraint("long", f'value = "l_CB"\nat_least = "{1e3 * wanted!r} mm"'))
    assert kept.best.size("l_CB") >= wanted
    assert kept.best.merits["cost"] > free.merits["cost"]
    assert kept.counters["failed long"] > 0
    assert kept.counters["kept the constraints"] + kept.counters["failed long"] == kept.counters["worked"]


def test_a_rule_with_a_column_and_what_the_search_cannot_tell() -> None:
    """The driving moment is another stage's, and the rule excludes its constraint: it is taken as broken."""
    more = constraint("light", 'column = "R45"\nof = "size"\nat_most = "1.3 N"')
    more += constraint("large", 'value = "l_AC"\nat_least = "1 m"')
    more += '[[constraints]]\nname = "weak"\nstage = "forces"\ncolumn = "M_drive"\nof = "size"\nat_most = 1e-9\n'
    more += '[feasibility]\nrule = "(light or large) and not weak"\n'
    result = solved(more)
    assert np.max(np.abs(result.best.dwell.motion.f4)) <= 1.3
    spec = tmmcalc.parse_spec(SEARCH + more)
    verdict = tmmcalc.run(spec, target="feasibility").results["feasibility"]
    assert verdict.feasible
    assert verdict.chosen == 1


def test_constraints_are_no_part_of_the_task_where_nothing_is_sought() -> None:
    text = (CONFIGS / "synth-dwell.toml").read_text()
    more = constraint("small", 'value = "l_AC"\nat_most = "100 mm"')
    assert to_synthesis(tmmcalc.parse_spec(text + more)).constraints is None
    assert to_synthesis(tmmcalc.parse_spec(SEARCH)).constraints is None
    found = to_synthesis(tmmcalc.parse_spec(SEARCH + more)).constraints
    assert found is not None
    assert [each.name for each in found.constraints] == ["small"]


@pytest.mark.parametrize("config", ["synth-dwell", "synth-dwell-rocker"])
@pytest.mark.parametrize("sense", ["ccw", "cw"])
def test_what_a_candidate_tells_is_what_the_stage_tells(config: str, sense: str) -> None:
    """Under the same names, with the same units, at the same steps."""
    side = 'pivot_side = "left"\n' if config.endswith("rocker") else ""
    head = f'[synthesis.dwell]\ncrank_sense = "{sense}"\nexact = false\n{side}'
    text = (CONFIGS / f"{config}.toml").read_text().replace("[synthesis]\n", "[synthesis]\npositions = 120\n")
    spec = tmmcalc.parse_spec(text.replace("[synthesis.dwell]\n", head))
    asked = to_synthesis(spec).asked
    assert isinstance(asked, DwellTask)
    result = tmmcalc.solve_synthesis(spec)
    row = np.array([[0.5 if value is None else value for value in given(asked).values()]])
    turn = whole_turn(drawn(asked, row).linkages, 120)
    traits = rated(turn, asked)
    values = told_values(asked, turn, dict(zip(NAMES, row.T, strict=True)), traits)
    stage = dict(facts("synthesis", result))
    assert values.keys() <= stage.keys()
    for name, (value, unit) in values.items():
        assert unit == stage[name][1], name
        assert value[0] == pytest.approx(stage[name][0], rel=2e-2, abs=1e-6), name
    columns = told_columns(asked, turn, traits)
    printed = table(result)
    for header, exact in zip(printed.header[1:], printed.columns[1:], strict=True):
        name, _, unit = header.partition("[")
        column = columns[name]
        assert column.unit == unit.rstrip("]")
        for of in ("max", "min", "size", "first", "last"):
            tolerance = 1e-2 * max(np.max(np.abs(exact)), 1e-9)
            found, wanted = REDUCED[of](column.make().T)[0], float(REDUCED[of](exact))
            assert found == pytest.approx(wanted, abs=tolerance), (name, of)


def test_the_nearer_to_the_rule_the_cheaper() -> None:
    """Candidates that break the rule stand behind all that keep it, by their distance."""
    spec = tmmcalc.parse_spec(SEARCH)
    asked = to_synthesis(spec).asked
    rows = np.tile([0.5 if value is None else value for value in given(asked).values()], (12, 1))
    rows[:, 0], rows[:, 1], rows[:, 4] = 0.5, np.radians(125), np.linspace(0.25, 0.35, 12)
    turn = whole_turn(drawn(asked, rows).linkages, 120)
    parameters = dict(zip(NAMES, rows[turn.which].T, strict=True))
    traits = rated(turn, asked)
    lengths = told_values(asked, turn, parameters, traits)["l_CB"][0]
    limit = float(np.median(lengths))
    rule = Rule(FeasibilityTask((Constraint("short", "synthesis", value="l_CB", at_most=limit),)), asked)
    costs = rule.ranked(traits.criteria.cost((1.0,) * 5), turn, parameters, traits)
    broken = lengths > limit
    assert np.all(costs[~broken & (lengths < 0.99 * limit)] < BARRIER)
    assert np.all(costs[broken] > BARRIER)
    assert np.all(np.diff(costs[broken][np.argsort(lengths[broken])]) > 0)
    assert rule.kept == np.sum(~broken)
