"""The chapter on gears, its trains: the textbook's numbers, the order of equations, formulas of layouts."""

from __future__ import annotations

import math
import re
from itertools import pairwise

import numpy as np
import pytest

from note.scenes import CONFIGS, lines, told
from note.test_lines import mutants, wrong
from tmmcalc.gears.criteria.size import RACK, centre_distances, size
from tmmcalc.gears.layouts import LAYOUTS
from tmmcalc.gears.model import ToothSets
from tmmcalc.gears.notes.inorder import Equation, Together, in_order
from tmmcalc.gears.notes.letters import noted
from tmmcalc.note.assembled import Assembler
from tmmcalc.note.plaintext import text
from tmmcalc.pipeline.chapters import chapters_of, stages_of
from tmmcalc.pipeline.runner import run
from tmmcalc.project import parse_spec
from tmmcalc.report.formula.syntax import read
from tmmcalc.report.formula.tree import Name, value
from tmmcalc.report.manuscript import Block, Heading, Line, Result, Table

TEETH = {
    "unfolded2": (20, 60, 18, 42),
    "unfolded3": (18, 54, 18, 45, 18, 36),
    "coaxial": (20, 70, 27, 63),
    "AIbar": (18, 48, 114),
    "AI": (22, 118, 17, 97),
    "AA": (30, 40, 24, 46),
    "II": (96, 40, 30, 86),
    "AII": (20, 25, 28, 70, 73),
    "2A-AA": (18, 24, 66, 66),
}


def found(name: str) -> dict[tuple[str, str], float]:
    """What the lines of a note give, by letter and place; the first of a letter."""
    values: dict[tuple[str, str], float] = {}
    for line in lines(name):
        left = line.formula.sides[0]
        assert isinstance(left, Name)
        values.setdefault((left.key, line.place), float(line.found.result))
    return values


def test_the_split_of_the_textbook() -> None:
    """U = 8.15 (4.5): 3.52 and 2.31; permissible stresses of improved 40Kh of HB 300 under a load that reverses."""
    told = found("gears-unfolded")
    assert told["u_1", ""] == pytest.approx(3.521, abs=1e-3)
    assert told["u_2", ""] == pytest.approx(2.3145, abs=1e-3)
    assert told["sigma_HP", ""] == pytest.approx(609, abs=0.5)
    assert told["sigma_FP", ""] == pytest.approx(200.6, abs=0.05)


def test_the_module_of_the_second_stage_bears_the_torque_of_the_first_wheel_times_its_ratio() -> None:
    """(4.38), (4.40) worked out anew: A_H of the second stage with K_Hbeta = 1 + 0.07*0.9, q = U1 = 3."""
    told = found("gears-unfolded")
    factor = 770 * (22 * (1 + 0.07 * 0.9) / (0.9 * (670 / 1.1) ** 2)) ** (1 / 3)
    u = 46 / 17
    assert told["A_H", "for the mesh 2'–3"] == pytest.approx(factor, rel=1e-4)
    assert told["m_H", "for the mesh 2'–3"] == pytest.approx(factor / 17 * ((u + 1) / u * 3) ** (1 / 3), rel=1e-4)


def test_a_train_turns_by_willis_and_loses_no_power() -> None:
    """AI 24/132/23/127: i_1H = 1 + z2 z3/(z1 z2'); what is lost in the meshes is what the shafts leave."""
    told = found("gears-double-planets")
    ratio = 1 + 132 * 127 / (24 * 23)
    assert told["i_1H", ""] == pytest.approx(ratio, rel=1e-4)
    assert told["omega_H", ""] == pytest.approx(1 / ratio, rel=1e-4)
    eta = told["eta", ""]
    assert eta == pytest.approx((1 - 0.975 * 0.985 * (1 - ratio)) / ratio, rel=1e-4)
    assert told["P_H", ""] == pytest.approx(-eta * 75, rel=1e-3)
    assert told["P_v", ""] == pytest.approx(75 * (1 - eta), rel=1e-3)
    assert told["T_H", ""] + told["T_3", ""] + 75 == pytest.approx(0, abs=0.1)


def test_a_closed_train_is_told_though_its_torques_hang_together() -> None:
    """The ring takes more than is put in: its mesh with the input rolls 2.6 times as much power."""
    told = found("gears-circulating")
    assert told["omega_H", ""] == pytest.approx(-1450 / 4 * math.pi / 30, rel=1e-4)
    assert told["P^III", ""] > 2 * 3000
    assert 0.8 < told["eta", ""] < 0.9


def test_simultaneous_equations_give_one_quantity_and_then_follow() -> None:
    ring = [Equation({a: f"{a} = {b}", b: f"{b} = {a}"}) for a, b in pairwise("abca")]
    assert [*in_order(ring, set())] == [Together("a"), "b = a", "c = b", "c = a"]
    assert [*in_order(ring, {"b"})] == ["a = b", "c = b", "c = a"]


@pytest.mark.parametrize("key", LAYOUTS)
@pytest.mark.parametrize("planets", [1, 3])
def test_the_size_of_a_layout_is_its_formula(key: str, planets: int) -> None:
    layout = LAYOUTS[key]
    module = np.array([[0.002, 0.003, 0.0025][: layout.stages]])
    angles = np.full((1, len(layout.meshes)), RACK) + 0.02 * np.arange(len(layout.meshes))
    sets = ToothSets(key, np.array([TEETH[key]]), np.ones((1, layout.stages), int), angles, planets)
    text = layout.lone_size_letters if planets == 1 and layout.lone_size_letters else layout.size_letters
    values = {f"z_{{{wheel}}}" if "'" in wheel else f"z_{wheel}": float(z[0]) for wheel, z in sets.by_wheel.items()}
    values |= {f"m_{k}": float(m) for k, m in enumerate(module[0], 1)}
    for mesh, distance in zip(layout.meshes, centre_distances(sets, module)[0].tolist(), strict=True):
        index = mesh.first + mesh.second
        values[f"a_{{{index}}}" if "'" in index else f"a_{index}"] = distance
    assert value(read(noted(text)).sides[0], values) == pytest.approx(float(size(sets, module)[0]), rel=1e-12)


def test_every_condition_of_the_chosen_train_is_told() -> None:
    table = next(
        each for each in blocks("gears-double-planets") if isinstance(each, Table) and "conditions" in each.key
    )
    names = [row[0] for row in table.rows]
    assert {"ratio", "common axis", "assembly", "neighbours' gap", "ring difference", "undercut"} <= set(names)
    assert [row[-1] for row in table.rows].count("not recommended") == 1  # gcd(24, 132) is 12


def test_stresses_stand_in_the_conclusions_with_their_limits() -> None:
    results = [each for each in blocks("gears-single-planets") if isinstance(each, Result) and each.limit is not None]
    assert {each.key for each in results} == {"delta", "sigma_{H}", "sigma_{F}"}
    for each in results:
        assert isinstance(each.given.value, float)
        assert each.limit is not None
        assert each.given.value <= each.limit


def test_a_variant_without_sets_is_told_as_one() -> None:
    titles = [each.text for each in blocks("gears-single-planets") if isinstance(each, Heading) and each.level == 2]
    assert any("4 planets" in title for title in titles)


def test_mutants_are_caught() -> None:
    """A wrong formula gives another number, in a scene whose factors are not one: less than 1 in 100 are missed."""
    text = (CONFIGS / "gears-double-planets.toml").read_text(encoding="utf-8")
    text = text.replace('load = "one-sided"', 'load = "two-sided"\nblank = "rolled"')
    text = text.replace('ratio = "31.29"', 'input_speed = "1450 rpm"\noutput_speed = "46.34 rpm"\naddendum = 0.9')
    done = run(parse_spec(text), target=stages_of(["gears"]))
    caught = missed = 0
    for chapter in chapters_of({"gears": "Gears"}, done.spec, done.results):
        for block in chapter.blocks:
            if isinstance(block, Line):
                for mutant in mutants(block.formula):
                    found = any(wrong(mutant, place.lexicon) for place in block.places)
                    caught, missed = caught + found, missed + (not found)
    assert caught > 150
    assert missed <= 0.01 * (caught + missed), (missed, caught)


def blocks(name: str) -> list[Block]:
    return [block for chapter in told(name, only=("gears",)) for block in chapter.blocks]


@pytest.mark.parametrize("name", ["gears-coaxial", pytest.param("gears-single-planets", marks=pytest.mark.slow)])
def test_the_course_of_the_choice_adds_up_and_its_best_train_is_the_chosen_one(name: str) -> None:
    """Of the sets that are found those that fall away leave those that are compared; of these the first was taken."""
    tables = {block.key: block for block in blocks(name) if isinstance(block, Table)}
    sieve = tables["criteria_sieve"]
    for column in range(1, len(sieve.head)):
        found, *lost, left = (int(row[column]) for row in sieve.rows)
        assert found - sum(lost) == left
    best = tables["criteria_best"]
    assert best.rows[0][1] == tables["criteria_front"].rows[0][0]
    by = -1 if best.head[-1] == "$S$" else best.head.index("inertia, kg·m²")
    order = [float(row[by]) for row in best.rows]
    assert order == sorted(order)
    for key in (each for each in tables if each.endswith("_removed")):
        counts = [[int(cell.replace("\u202f", "")) for cell in row[2:]] for row in tables[key].rows]
        assert all(before - removed == after for (before, removed), (after, _) in pairwise(counts))


@pytest.mark.slow
def test_a_whole_number_is_said_to_be_one_and_trains_are_named_by_their_teeth() -> None:
    said = text(Assembler().written(told("course-project", only=("gears",))))
    assert re.search(r"assembly +2010 is whole +kept", said)
    assert "2010 = 2010" not in said
    assert re.search(r"The best mass: [\d.]+ kg, train \d+/\d+/\d+/\d+\.", said)
