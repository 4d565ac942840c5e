"""The conditions of one tooth set: both sides worked out again, and against what the search itself keeps."""

from __future__ import annotations

import math
from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest

import tmmcalc
from gears.formulas import worked
from gears.strength.scenes import CASES, TRAINS
from tmmcalc.gears.chosen.choice import Chosen, chosen_sets, written_set
from tmmcalc.gears.chosen.condition import Condition, Conditions
from tmmcalc.gears.chosen.conditions import conditions
from tmmcalc.gears.gearingtask import layout_task
from tmmcalc.gears.search.measures import block_of
from tmmcalc.gears.search.search import synthesise
from tmmcalc.gears.train import solve_train
from tmmcalc.gears.trains import Asked, Trains
from tmmcalc.pipeline.runner import run

CONFIGS = Path(__file__).parents[3] / "configs"
READY = ("single-planets", "double-planets", "radial-planets", "three-centrals", "unfolded", "coaxial", "kinematic")


def ready(name: str) -> Trains:
    found: Trains = run(tmmcalc.load_spec(CONFIGS / f"gears-{name}.toml"), target="train").results["train"]
    return found


def of_written(layout: str, teeth: tuple[int, ...], planets: int = 3) -> Conditions:
    chosen = written_set(layout_task(layout, teeth, planets))
    assert chosen is not None
    return conditions(chosen)


def named(found: Conditions, name: str) -> list[Condition]:
    return [each for each in found.conditions if each.name == name]


def check_sides(each: Condition) -> None:
    """Both sides and the verdict are what the formula with its numbers gives, to the digits that it shows."""
    left, right = each.numbers.split(f" {each.relation} ")
    assert worked(left) == pytest.approx(each.left, rel=3e-8), each
    assert worked(right) == pytest.approx(each.right, rel=3e-8), each
    by_hand = {"=": each.left == pytest.approx(each.right, rel=1e-12), ">": each.left > each.right}
    by_hand |= {">=": each.left >= each.right - 1e-12, "<=": each.left <= each.right + 1e-12}
    assert each.kept == by_hand[each.relation]


@pytest.mark.parametrize("name", READY)
def test_sets_that_a_search_finds_keep_every_condition(name: str) -> None:
    trains = ready(name)
    most = max(len(variant.sets) for variant in trains.variants)
    for number in sorted({1, most // 2, most} - {0}):
        for chosen in chosen_sets(trains, number=number):
            found = conditions(chosen)
            assert found.kept
            for each in found.conditions:
                check_sides(each)


@pytest.mark.parametrize("layout", [name for name in TRAINS if not name.startswith("unfolded")])
def test_given_teeth_are_refused_for_the_conditions_that_they_break(layout: str) -> None:
    """The search tests given teeth constraint by constraint; it keeps them exactly where all conditions are kept."""
    rng = np.random.default_rng(5)
    usual, proportion = TRAINS[layout]
    verdicts = []
    for _ in range(150):
        moved = rng.integers(-2, 3, len(usual)) * (rng.random(len(usual)) < 0.3)
        teeth = tuple(int(z) for z in np.array(usual) + moved)
        chosen = written_set(layout_task(layout, teeth, int(rng.integers(1, 6))))
        assert chosen is not None
        task = replace(chosen.task, proportions=(tuple(proportion),))
        top, below = (int(part[0]) for part in chosen.sets.scheme.tooth_ratio(chosen.sets.by_wheel))
        if not below:
            continue  # wheel 4 stands
        u = Fraction(top, below)
        task = replace(task, ratio=replace(task.ratio, low=u, high=u))
        chosen = replace(chosen, task=task, sets=replace(chosen.sets, modules=np.array([proportion])))
        kept = conditions(chosen).kept
        assert kept == (synthesise(task).count == 1), teeth
        verdicts.append(kept)
    assert {*verdicts} == {True, False}


def test_the_conditions_of_a_reducer_by_hand() -> None:
    """AI 22/118/17/97 with three planets, m_1 : m_2 = 4 : 7, as the textbook has it."""
    found = of_written("AI", (22, 118, 17, 97))
    (axis,), (whole,), (first, second) = (named(found, name) for name in ("coaxiality", "assembly", "adjacency"))
    assert found.proportion == (4, 7)
    assert (axis.left, axis.right) == (4 * (22 + 118), 7 * (97 - 17)) == (560, 560)
    assert whole.left == (118 * 97 + 22 * 17) / 3 == 3940
    assert (first.left, first.right) == (pytest.approx(140 * math.sqrt(3) / 2, rel=1e-15), 118 + 3)
    assert (second.left, second.right) == (pytest.approx(80 * math.sqrt(3) / 2, rel=1e-15), 17 + 3)
    assert first.formula == "(Z1 + Z2)*sin(pi/K) > Z2 + 2*h_a + gap"
    assert [each.left for each in named(found, "coprime")] == [math.gcd(22, 118), math.gcd(17, 97)]
    assert all(each.kept for each in (axis, whole, first, second))


@pytest.mark.parametrize("k", range(6))
def test_assembly_of_the_worked_cases(k: int) -> None:
    """GT-S10."""
    case = CASES["GT-S10"]
    given, expected = case["inputs"]["items"][k], case["expected"]["items"][k]
    (whole,) = named(of_written(given["type"], tuple(given["z"]), given["K"]), "assembly")
    assert whole.left == pytest.approx(expected["R"], abs=case["tolerance"]["all"])
    assert whole.kept == expected["assembles"]


def test_single_planets_of_the_worked_case() -> None:
    """GT-S06: ratio, common axis and assembly of every listed train, from its teeth."""
    for row in CASES["GT-S06"]["expected"]["solutions"]:
        z1, z2, z3 = row["z"]
        found = of_written("AIbar", (z1, z2, z3))
        (axis,), (whole,) = named(found, "coaxiality"), named(found, "assembly")
        assert (axis.left, axis.right, axis.kept) == (z1 + z2, z3 - z2, True)
        assert (whole.left, whole.kept) == ((z1 + z3) // 3, True)


def test_a_broken_condition_is_told_with_its_sides() -> None:
    found = of_written("AIbar", (18, 47, 113), 4)  # 65 sin 45 deg = 45.96 under 50
    assert not found.kept
    broken = {each.name for each in found.conditions if each.asked and not each.kept}
    assert broken == {"coaxiality", "assembly", "adjacency"}


def test_the_ratio_is_told_in_the_kind_that_was_asked_for() -> None:
    (chosen,) = chosen_sets(ready("kinematic"))
    low, high = named(conditions(chosen), "ratio")
    assert low.of == "i_H1"
    assert low.left == high.left == 10000
    assert low.formula == "1/(1 - Z2*Z3/(Z1*Z2')) >= i_H1_min"


def test_sides_of_neighbours_are_those_of_the_search() -> None:
    from tmmcalc.gears.search.constraints import rooms

    for name in ("double-planets", "radial-planets", "three-centrals", "coaxial"):
        for chosen in chosen_sets(ready(name)):
            sides = named(conditions(chosen), "adjacency")
            apart = [float(room[0]) for room in rooms(chosen.task, block_of(chosen.sets))]
            assert [each.left - each.right for each in sides] == pytest.approx(apart, abs=1e-11)


def test_limits_that_are_asked_for() -> None:
    """Centre distance, envelope, sum of teeth, stage ratio: every condition that a table can ask for has its row."""
    text = """
[train]
layout = "coaxial"
ratio = "8.15"
tolerance = "0.1"
tolerance_kind = "absolute"
planets = 3
module = "2 mm"
module_ratios = [[2, 3]]
sum_max = 120
[train.constraints]
centre_distance = ["60 mm", "140 mm"]
envelope = "400 mm"
stage_ratio_max = 6
coprime = true
"""
    spec = tmmcalc.parse_spec(text)
    (chosen,) = chosen_sets(run(spec, target="train").results["train"])
    found = conditions(chosen)
    names = [each.name for each in found.conditions]
    assert names.count("centre_distance") == 2
    assert {"envelope", "largest_sum", "stage_ratio", "coprime"} <= {*names}
    assert found.kept
    assert all(each.asked for each in named(found, "coprime"))
    for each in found.conditions:
        check_sides(each)
    distance = named(found, "centre_distance")[0].left
    assert distance == pytest.approx(0.001 * (chosen.teeth["1"] + chosen.teeth["2"]), rel=1e-15)


def test_every_constraint_of_the_search_has_its_name_in_the_conditions() -> None:
    from tmmcalc.gears.advice import ORDER

    text = (Path(__file__).parents[3] / "tmmcalc" / "gears" / "chosen" / "conditions.py").read_text()
    assert [name for name in ORDER if f'"{name}"' not in text] == []


def test_a_train_that_is_chosen_is_the_winner_of_criteria() -> None:
    spec = tmmcalc.load_spec(CONFIGS / "gears-double-planets.toml")
    results = run(spec, target="criteria").results
    (chosen,) = chosen_sets(results["train"], results["criteria"])
    winner = results["criteria"].winner
    assert tuple(chosen.teeth.values()) == winner.teeth
    assert chosen.modules == winner.modules
    assert isinstance(chosen, Chosen)


def test_solving_again_by_its_teeth_alone_keeps_the_set() -> None:
    variant = ready("single-planets").variants[0]
    chosen = chosen_sets(Trains((variant,)), number=3)[0]
    request = replace(variant.request, task=replace(variant.request.task, teeth=tuple(chosen.teeth.values())))
    assert solve_train(Asked((request,))).variants[0].synthesis.count == 1
