"""The chapter on forces: the textbook's tables of the press, systems of higher groups, drives, friction, the lever."""

from __future__ import annotations

import math
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from note.scenes import CONFIGS, SPECS, blocks, told
from tmmcalc.note.assembled import Assembler
from tmmcalc.pipeline.chapters import chapters_of, stages_of
from tmmcalc.pipeline.picturing import NONE
from tmmcalc.pipeline.runner import run
from tmmcalc.project import load_spec
from tmmcalc.report.drawing.order import POSITIONS
from tmmcalc.report.formula.digits import EXACT
from tmmcalc.report.formula.tree import Name
from tmmcalc.report.manuscript import Block, Chapter, Figure, Line, Paragraph, Table

ONLY = ("forces",)
HIGHER = ("class-three", "class-three-slider", "class-four", "scissor-lift")


@cache
def forces(name: str, positions: str | None = None) -> tuple[Block, ...]:
    """The blocks of the chapter."""
    return tuple(blocks(told(name, positions, ONLY)))


def tables(found: tuple[Block, ...], caption: str) -> list[Table]:
    """The tables whose caption begins so."""
    return [each for each in found if isinstance(each, Table) and each.caption.startswith(caption)]


def columns(found: list[Table]) -> dict[tuple[str, str], float]:
    """All numbers of tables by row and the symbol of the column."""
    return {
        (row[0], head.partition(",")[0].strip("$")): number(cell)
        for table in found
        for row in table.rows
        for head, cell in zip(table.head[1:], row[1:], strict=True)
        if cell != "–"
    }


def number(cell: str) -> float:
    return float(cell.strip("$").replace("−", "-"))


def said(found: tuple[Block, ...]) -> str:
    return "\n".join(each.text for each in found if isinstance(each, Paragraph))


def name_of(line: Line) -> str:
    """The name on the left of a line."""
    left = line.formula.sides[0]
    assert isinstance(left, Name)
    return left.key


def lexicon(found: tuple[Block, ...], left: str, place: int = 0) -> dict[str, float]:
    """The quantities at a place of the line for this name."""
    line = next(each for each in found if isinstance(each, Line) and name_of(each) == left)
    return {key: each.value for key, each in line.places[place].lexicon.items() if isinstance(each.value, float)}


def test_the_press_without_friction_is_table_d_3_1() -> None:
    """Rows 1, 9 and 10; its R_32 is what acts on the slider, here R_23 acts on the rod."""
    own = columns(tables(forces("press"), "Reactions without friction"))
    for row, normal, x, y, drive in (
        ("1", 270.779, -22.0603, -35.3393, 3.15673),
        ("9", 163.649, 483.952, 71.7905, 18.1798),
        ("10", 64.3051, 1068.56, 171.135, 40.0721),
    ):
        assert own[row, "N_{30}"] == pytest.approx(normal, abs=0.006)
        assert own[row, "R_{23x}"] == pytest.approx(-x, abs=0.06)
        assert own[row, "R_{23y}"] == pytest.approx(-y, abs=0.006)
        assert own[row, "M_d"] == pytest.approx(drive, abs=6e-4)


def test_the_press_with_friction_is_table_d_3_2() -> None:
    """Rows 1, 9 (the limit before, as in the book) and 11: friction, arm, reactions, balancing moment."""
    own = columns(tables(forces("press"), "Reactions with friction"))
    names = ("M_{21}", "M_{23}", "F_{30}", "N_{30}", "h_{30}", "R_{10x}", "R_{10y}", "M_d")
    for row, values in (
        ("1", (0.255575, 0.0859596, 26.5749, 265.749, 0.323462, -58.7995, 83.6275, 4.07395)),
        ("9−", (1.35132, -0.758705, -15.6448, 156.448, -4.84956, 500.441, 204.279, 20.1178)),
        ("9", (1.35799, 0.759612, -14.7344, 147.344, 5.1554, 499.53, 213.38, 20.090)),
        ("11", (4.7879, 2.8611, -1.60887, 16.0887, 177.833, 1884.58, 340.855, 51.1934)),
    ):
        for name, value in zip(names, values, strict=True):
            assert own[row, name] == pytest.approx(value, abs=0.06 if name[0] == "R" else 0.006), (row, name)


def test_the_passes_of_the_press_are_table_d_3_3() -> None:
    """The friction that each solution of position 1 is found with."""
    (table,) = tables(forces("press", "1"), "Successive approximations")
    rows = {row[0].partition(",")[0].strip("$"): [number(cell) for cell in row[1:6]] for row in table.rows[:3]}
    assert rows["M_{21}"] == pytest.approx([0.0, 0.212367, 0.255601, 0.255643, 0.255574], abs=6e-6)
    assert rows["M_{23}"] == pytest.approx([0.0, 0.0624895, 0.086872, 0.0859957, 0.085958], abs=6e-7)
    assert rows["F_{30}"] == pytest.approx([0.0, 27.0779, 26.6092, 26.574, 26.5748], abs=6e-4)


def test_a_pair_at_rest_is_told_by_its_sense() -> None:
    """Positions 0 and 6 are dead points: no velocity has a sign there."""
    found = forces("press", "0,6")
    assembler = Assembler()
    assembler.written(told("press", "0,6", ONLY))
    assert all(line.found.error <= EXACT for line in assembler.lines)
    assert {lexicon(found, "F_30")["s_30"], lexicon(found, "M_23")["s_23"]} <= {1.0, -1.0}
    assert lexicon(found, "F_30")["F_30"] == pytest.approx(27.1827, abs=1e-4)


def test_the_inertia_of_the_shapers_rocker_is_that_of_its_turning() -> None:
    """P_3x = m_3 l_BS (omega_3^2 cos phi_3 + eps_3 sin phi_3) and its like (3.17), at every position."""
    spec = load_spec(CONFIGS / "shaper.toml")
    result = run(spec, target=stages_of(ONLY)).results["kinematics"]
    own = columns(tables(forces("shaper"), "Inertia forces"))
    k = list(result.trace.link_ids).index(3)
    omega, eps = result.in_time(result.trace.dangle[k], result.trace.ddangle[k])
    phi = result.trace.angle[k]
    x, y = (55 * 0.5 * (omega**2 * c + s * eps) for c, s in ((np.cos(phi), np.sin(phi)), (np.sin(phi), -np.cos(phi))))
    for row, label in enumerate(result.labels):
        assert own[label, "P_{3x}"] == pytest.approx(x[row], abs=0.006)
        assert own[label, "P_{3y}"] == pytest.approx(y[row], abs=0.006)
        assert own[label, "M_{3}"] == pytest.approx(-4.5 * eps[row], abs=6e-4)


@pytest.mark.parametrize("name", HIGHER)
def test_the_tables_of_a_system_give_its_reactions(name: str) -> None:
    """The printed coefficients and right sides, solved, are the printed unknowns."""
    found = forces(name)
    equations, solutions = tables(found, "Coefficients of the equations"), tables(found, "Reactions of group")
    assert equations
    for solution in solutions:
        unknowns = [row[0].partition(",")[0] for row in solution.rows]
        own = [each for each in equations if set(each.head[1:-1]) <= set(unknowns)]
        for k, label in enumerate(solution.head[1:], 1):
            rows = [(each.head[1:-1], row) for each in own for row in each.rows if row[0].endswith(f"({label})")]
            matrix = np.zeros((len(rows), len(unknowns)))
            for i, (names, row) in enumerate(rows):
                for symbol, cell in zip(names, row[1:-1], strict=True):
                    matrix[i, unknowns.index(symbol)] = number(cell)
            right = [number(row[-1]) for _, row in rows]
            printed = np.array([number(row[k]) for row in solution.rows])
            assert matrix.shape[0] == matrix.shape[1]
            assert np.linalg.solve(matrix, right) == pytest.approx(
                printed, rel=1e-2, abs=1e-2 * np.max(np.abs(printed))
            )


def test_nothing_is_left_untold() -> None:
    for name in HIGHER:
        assert "not written out" not in said(forces(name))
        assert any(isinstance(each, Line) and name_of(each).startswith("Sigma") for each in forces(name))


def test_the_force_of_a_mesh_lies_on_the_line_of_action() -> None:
    """F = |M|/(r_w cos alpha_w), 90 deg + alpha_w ahead of the pinion's direction where it drives counter-clockwise."""
    own = lexicon(forces("piston-pump"), "F_mesh")
    assert own["M_d"] > 0
    turn = math.radians(own["beta"] + 90 + own["alpha_w"])
    size = own["M_d"] / (own["r_w"] * math.cos(math.radians(own["alpha_w"])))
    assert own["F_mesh"] == pytest.approx(size)
    assert (own["F_{mesh,x}"], own["F_{mesh,y}"]) == pytest.approx((size * math.cos(turn), size * math.sin(turn)))


def test_a_driven_slider_has_a_balancing_force() -> None:
    own = lexicon(forces("hydraulic-lift"), "F_d")
    along = np.exp(1j * math.radians(own["gamma_10"]))
    assert own["F_d"] == pytest.approx(-(np.conj(along) * complex(own["T_1x"], own["T_1y"])).real)
    assert any(
        isinstance(each, Figure) and each.caption.startswith("Balancing force") for each in forces("hydraulic-lift")
    )


def test_a_slider_that_tips_bears_on_both_edges(tmp_path: Path) -> None:
    """The press with a slider of 50 mm: at position 11 the arm of its normal reaction is longer than half of it."""
    text = (CONFIGS / "press.toml").read_text(encoding="utf-8")
    file = tmp_path / "press.toml"
    file.write_text(text.replace('kind = "prismatic"\n', 'kind = "prismatic"\nlength = "50 mm"\n', 1), encoding="utf-8")
    chapters = of_file(file, "5,11")
    assembler = Assembler()
    assembler.written(chapters)
    assert all(line.found.error <= EXACT and line.found.off <= 0.5 + 1e-6 for line in assembler.lines)
    found = tuple(blocks(chapters))
    assert "tips and bears on both edges" in said(found)
    own = lexicon(found, "F_30", 1)
    edges = own["N'_30"], own["N''_30"]
    assert edges[0] * edges[1] < 0
    assert sum(edges) == pytest.approx(own["N_30"])
    assert abs(own["F_30"]) == pytest.approx(0.1 * sum(map(abs, edges)))


def of_file(file: Path, positions: str) -> list[Chapter]:
    done = run(load_spec(file), target=stages_of(ONLY))
    return chapters_of({"forces": "Force analysis"}, done.spec, done.results, {**NONE, POSITIONS: positions})


@pytest.mark.parametrize("name", ["shaper", "press", "class-four", "hydraulic-lift"])
def test_the_table_of_the_lever_sums_up_to_the_balancing_moment(name: str) -> None:
    """Printed moments sum up to -M_d omega_1/mu_v, that is to the power of the drive."""
    found = forces(name)
    for k, table in enumerate(tables(found, "Moments on the lever")):
        total = sum(number(row[3]) for row in table.rows)
        own = lexicon(found, "M_p", k)
        drive, speed = (own["M_d"], own["omega_1"]) if "M_d" in own else (own["F_d"], own["v_d"])
        assert total == pytest.approx(-drive * speed / own["mu_v"], rel=1e-3)


@pytest.mark.slow
@pytest.mark.parametrize("name", SPECS)
def test_keys_of_pictures_and_tables_stand_once(name: str) -> None:
    found = forces(name)
    keys = [each.key for each in found if isinstance(each, Figure | Table)]
    assert len(set(keys)) == len(keys)
