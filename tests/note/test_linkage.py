"""What the note tells of the motion of linkages: strokes, loops, drives, plans, numerical differentiation."""

from __future__ import annotations

import math
import re
from functools import cache

import numpy as np
import pytest
from sparing import sparing

from note.scenes import blocks, told
from tmmcalc.note.assembled import Assembler
from tmmcalc.note.tree import Equation, Reference, Text
from tmmcalc.report.formula.digits import value_of
from tmmcalc.report.formula.plain import plain
from tmmcalc.report.formula.symbols import canonical
from tmmcalc.report.formula.tree import Name, Statement, names
from tmmcalc.report.manuscript import Block, Line, Paragraph, Result, Table

CHAPTERS = ("structure", "kinematics")


@cache
def chapters(name: str) -> tuple[Block, ...]:
    return tuple(blocks(told(name, "6,18" if name == "shaper" else None, only=CHAPTERS)))


def values(name: str) -> dict[str, float]:
    """The results of the lines by what stands before them: a place, and the left side."""
    assembler = Assembler()
    assembler.written(told(name, "6,18" if name == "shaper" else None, only=CHAPTERS))
    return {f"{line.place} {_left(line.formula)}".strip(): float(line.found.result) for line in assembler.lines}


def _left(formula: Statement) -> str:
    left = formula.sides[0]
    assert isinstance(left, Name)
    return left.key


def tables(name: str, key: str) -> Table:
    return next(each for each in chapters(name) if isinstance(each, Table) and each.key == key)


def number(cell: str) -> float:
    return float(cell.strip("$").replace("−", "-"))


def test_the_shaper_has_the_strokes_of_the_textbook() -> None:
    found = values("shaper")
    psi = math.degrees(math.acos(0.2 / 0.62))  # of the slotted link's tangent
    assert found["phi_1^I"] == pytest.approx(-18.819, abs=5e-4)
    assert found["phi_{I,II}"] == pytest.approx(2 * (180 - psi), rel=1e-4)
    assert found["K"] == pytest.approx((180 - psi) / psi, rel=1e-4)


@pytest.mark.parametrize(
    ("row", "wanted"),
    [
        (6, {1: 90.0, 2: -1.232, 3: -1.219, 5: 85.442, 6: 0.2388, 8: -3.316, 9: -0.067, 12: 0.246}),
        (18, {4: 2.008, 7: -0.383, 10: 0.378, 13: 1.251}),
    ],
)
def test_the_table_of_the_shaper_is_that_of_the_textbook(row: int, wanted: dict[int, float]) -> None:
    """Table D.2.1, recomputed: S_D, v_D, phi_3, omega_3, phi_4, omega_4, v_23; a_D, eps_3, eps_4, a_23."""
    found = tables("shaper", "course").rows[row]
    assert found[0] == str(row)
    for k, value in wanted.items():
        assert number(found[k]) == pytest.approx(value, abs=6e-2 if k == 5 else 1e-3)


def test_numerical_differentiation_is_as_near_as_the_textbook_says() -> None:
    rows = tables("shaper", "differences_0").rows
    assert len(rows) == 25
    assert max(number(row[3]) for row in rows) <= 0.3
    assert max(number(row[6]) for row in rows) <= 0.17


def test_a_plan_differs_from_the_formulas_by_what_is_read_off_alone() -> None:
    for row in tables("shaper", "plan_compared").rows:
        length = number(row[2].partition(" = ")[2])
        near = 0.0501 / length + 5e-4
        assert abs(number(row[4]) / number(row[5]) - 1) <= near


@sparing(("name", "loops"), [("class-three", 2), ("class-four", 2), ("class-three-slider", 2)], every=3)
def test_newton_comes_to_the_assembly_and_its_system_holds(name: str, loops: int) -> None:
    steps = [each for each in chapters(name) if isinstance(each, Table) and each.head[0] == "Step"]
    assert len(steps) == 2
    for table in steps:
        residuals = [number(row[-1].replace("e", "E")) for row in table.rows]
        assert residuals == sorted(residuals, reverse=True)
        assert residuals[-1] < 1e-6
    systems = [each for each in chapters(name) if isinstance(each, Table) and each.head[0] == "Equation"]
    for table in systems:
        *equations, solution = [[number(cell) for cell in row[1:] if cell] for row in table.rows]
        assert len(equations) == 2 * loops
        for row in equations:
            sums = math.fsum(a * x for a, x in zip(row, solution, strict=False))
            assert sums == pytest.approx(row[-1], abs=2e-3 * max(1.0, *map(abs, solution)))


def test_a_driven_length_turns_the_boom_as_its_triangle_does() -> None:
    """Law of cosines differentiated: omega = -s v / (l_OA l_OB sin theta) is the rate of the boom's angle."""
    found = values("crane-luffing")
    place = next(key for key in found if key.endswith(" omega_1")).removesuffix(" omega_1")
    theta, s = math.radians(found[f"{place} theta_O"]), found[f"{place} s_2"]
    rate = s * 0.2 / (6.103 * 7.0 * math.sin(theta))  # of the angle between mast and boom
    assert found[f"{place} omega_1"] == pytest.approx(-rate, rel=2e-4)


def test_projections_of_a_vector_are_explained_together_and_once() -> None:
    written = Assembler().written(told("shaper", only=CHAPTERS))
    parts = [part for each in written if isinstance(each, Text) for part in (*each.parts, " ")]
    said = "".join(p if isinstance(p, str) else plain(p) for p in parts if not isinstance(p, Reference))
    assert "v_Dx, v_Dy – projections of the velocity of D, m/s" in said
    explained = re.findall(r"(\w+), \w+ – projections", said)
    assert len(explained) == len(set(explained)) > 4
    assert any(isinstance(each, Equation) and "vec" in plain(each.parts[0]) for each in written)


def test_the_extremes_of_a_crank_slider_are_those_of_its_closed_form() -> None:
    """S = r cos phi + sqrt(l^2 - r^2 sin^2 phi) differentiated on a fine grid; the angle of the rod is the pressure."""
    found = {canonical(each.key): each.given.value for each in chapters("press") if isinstance(each, Result)}
    angle = next(each.given.value for each in chapters("press") if isinstance(each, Result) and not each.key)
    r, length, omega = 0.0375, 0.168, 5.0
    phi = np.linspace(0.0, 2 * math.pi, 200001)
    s = r * np.cos(phi) + np.sqrt(length**2 - (r * np.sin(phi)) ** 2)
    assert found["H_B"] == pytest.approx(float(np.ptp(s)), rel=1e-9)
    assert found["v_B"] == pytest.approx(omega * float(np.max(np.abs(np.gradient(s, phi)))), rel=1e-7)
    assert angle == pytest.approx(math.degrees(math.asin(r / length)), rel=1e-9)


def test_a_note_on_motion_alone_has_results() -> None:
    """Both pistons of the engine: stroke, time ratio, largest velocity and acceleration."""
    found = {canonical(each.key) for each in chapters("v-engine") if isinstance(each, Result)}
    assert {f"{letter}_{piston}" for letter in "HKva" for piston in "BD"} <= found


def test_special_points_are_explained() -> None:
    """Those of the basic links of a class IV group stand in the plans."""
    assert any(isinstance(each, Paragraph) and "$W_{2(3,4)}$" in each.text for each in chapters("class-four"))


def test_the_position_of_the_working_stroke_is_one_with_its_load() -> None:
    """The sheet is cut from 105° on: a quarter of the turn, in the middle of the stroke, has no load."""
    places = {place.name for block in chapters("course-project") if isinstance(block, Line) for place in block.places}
    assert places - {""} == {"pos. 9", "pos. 18"}


@pytest.mark.parametrize(
    ("name", "wanted"), [("press", {"10", "2"}), ("shaper", {"7", "19"}), ("trammel", {"5", "17"})]
)
def test_a_position_is_shown_in_which_links_move_and_stand_aslant(name: str, wanted: set[str]) -> None:
    """In the middle of the strokes of the press its rod turns back and its crank stands across; 10 has more load."""
    lines = [block for block in blocks(told(name, only=("kinematics",))) if isinstance(block, Line)]
    assert {place.name for line in lines for place in line.places} - {""} == {f"pos. {label}" for label in wanted}
    for line in lines:
        side = line.formula.sides[0]
        if isinstance(side, Name) and side.key.startswith(("omega", "phi")):
            for place in line.places:
                found = place.lexicon[side.key].value
                assert isinstance(found, float)
                assert abs(found) > 1e-3, (side.key, place.name)


@pytest.mark.parametrize("name", ["course-project", "shaper", "four-dyads"])
def test_an_angle_has_the_same_whole_turns_in_all_chapters_and_in_the_table(name: str) -> None:
    known: dict[tuple[str, str], float] = {}
    for block in blocks(told(name, only=(*CHAPTERS, "forces"))):
        if not isinstance(block, Line):
            continue
        for place in block.places:
            for key in names(block.formula):
                value = place.lexicon[key].value
                if key.startswith("phi_") and key[4:].isdigit() and isinstance(value, float):
                    assert known.setdefault((place.name, key), value) == pytest.approx(value, abs=1e-6), key
    table = tables(name, "course_si")
    for column, head in enumerate(table.head):
        key = head.strip("$").partition("$")[0]
        for (place, one), value in known.items():
            if one == key:
                row = next(row for row in table.rows if f"pos. {row[0]}" == place)
                assert number(row[column]) == pytest.approx(value, abs=0.06), (place, key)


@pytest.mark.parametrize("name", ["course-project", "shaper", "four-bar", "crank-slider"])
def test_the_angle_of_an_extreme_position_is_on_the_turn_of_its_formula(name: str) -> None:
    """And the second one follows the first by the working angle that is told."""
    found: dict[str, float] = {}
    for block in chapters(name):
        for place in block.places if isinstance(block, Line) else ():
            left, right = block.formula.sides
            if isinstance(left, Name) and left.key in ("phi_1^I", "phi_1^II", "phi_{I,II}"):
                found[left.key] = value_of(right, place.lexicon, "deg")
                assert place.lexicon[left.key].value == pytest.approx(found[left.key], abs=1e-9), left.key
    assert abs(found["phi_1^II"] - found["phi_1^I"]) == pytest.approx(found["phi_{I,II}"], abs=1e-9)
