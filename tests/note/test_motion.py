"""What the note tells of motors, flywheels, steady and unsteady motion, beside the textbook and closed forms."""

from __future__ import annotations

import json
import math
import re
from pathlib import Path
from typing import Any

import pytest

from note.scenes import CONFIGS, blocks, told, written
from tmmcalc.note.assembled import Assembler
from tmmcalc.note.plaintext import text
from tmmcalc.pipeline.chapters import chapters_of, stages_of
from tmmcalc.pipeline.picturing import NONE
from tmmcalc.pipeline.runner import run
from tmmcalc.project import load_spec
from tmmcalc.report.drawing.order import POSITIONS
from tmmcalc.report.formula.tree import Name
from tmmcalc.report.manuscript import Chapter, Paragraph, Result, Table
from tmmcalc.rooms import CHAPTERS

CASES = {
    case["id"]: case["expected"]
    for case in json.loads((Path(__file__).parent.parent / "cases/dynamics.json").read_text(encoding="utf-8"))
}
SINE = """
[torque]
name = "sine"
speed = "20 rad/s"
formula = "100*sin(theta)"
[motion]
drive = "positional"
[flywheel]
delta = 0.02
"""
PUMP = """
[torque]
name = "pump"
speed = "10 rad/s"
formula = "-60 - 20*cos(theta)"
inertia = 2
[motor]
power = "1.1 kW"
speed = "1400 rpm"
synchronous_speed = "1500 rpm"
overload = 2.2
inertia = 0.002
characteristic = "kloss"
[transmission]
ratio = 14.66
"""


def of_text(spec: str, tmp_path: Path) -> list[Chapter]:
    """The chapters on reduction, with the motor, and on motion of a spec."""
    file = tmp_path / "spec.toml"
    file.write_text(spec, encoding="utf-8")
    titles = {name: CHAPTERS[name] for name in ("reduction", "motion")}
    done = run(load_spec(file), target=stages_of([*titles]))
    return chapters_of(titles, done.spec, done.results, {**NONE, POSITIONS: None})


def values(chapters: list[Chapter]) -> dict[str, float]:
    """What the lines give, the first of each name."""
    assembler = Assembler()
    assembler.written(chapters)
    found: dict[str, float] = {}
    for line in assembler.lines:
        left = line.formula.sides[0]
        assert isinstance(left, Name)
        found.setdefault(left.key, float(line.found.result))
    return found


def said(name: str) -> str:
    """The chapters on motion of a ready spec as plain text."""
    return text(written(name, only=("motion", "unsteady")))


def test_the_parabola_of_the_shaper_is_that_of_the_textbook() -> None:
    found, book = values(told("shaper", only=("reduction", "motion"))), CASES["dyn-shaper-motion-idle"]
    for name, key in (
        ("A_M", "A"),
        ("B_M", "B"),
        ("omega_N", "omega_N"),
        ("omega_c", "omega_sync"),
        ("M_N", "M_N_Nm"),
    ):
        assert found[name] == pytest.approx(book[key], rel=5e-5)


def test_the_recurrence_gives_the_squares_of_the_textbook() -> None:
    """(3.57) worked out anew from the table of turns, whose last digits let it be off by 1.5e-4."""
    told_of = blocks(told("shaper", only=("motion",)))
    (turns,) = (block for block in told_of if isinstance(block, Table) and block.key == "motion_turns")
    moments, inertias, last = ([float(row[k].replace("−", "-")) for row in turns.rows] for k in (1, 2, 4))
    step, a, b = math.pi / 12, 20548.67, 619.4426
    for i in range(1, 25):
        kept = (inertias[i - 1] - b * step) * last[i - 1] ** 2
        gained = (moments[i - 1] + moments[i] + 2 * a) * step
        assert math.sqrt((kept + gained) / (inertias[i] + b * step)) == pytest.approx(last[i], abs=2e-4)


def test_kloss_is_that_of_the_textbook(tmp_path: Path) -> None:
    found, book = values(of_text(PUMP, tmp_path)), CASES["dyn-motor-kloss"]
    assert found["s_N"] == pytest.approx(book["s_N"], rel=5e-5)
    assert found["s_K"] == pytest.approx(book["s_K"], rel=5e-5)
    ratios = dict(zip(book["M_over_MN"]["s"], book["M_over_MN"]["ratio"], strict=True))
    assert found["M_p"] / found["M_N"] == pytest.approx(ratios[1.0], rel=1e-4)


def test_all_methods_agree_on_a_sine(tmp_path: Path) -> None:
    """J_F = 2 M_1/(delta omega^2) = 25 kg*m^2 where the links have no inertia."""
    chapters = of_text(SINE, tmp_path)
    found = values(chapters)
    assert [found[f"J_F{mark}"] for mark in ("", "^{(2)}", "^{(3)}", "^{(4)}", "^{(5)}")] == pytest.approx([25.0] * 5)
    assert found["J_M"] == pytest.approx(CASES["dyn-flywheel-sine"]["J_F"])
    assert "touch it, at φ = 180° and φ = 0°" in text(Assembler().written(chapters))


@pytest.mark.slow
def test_the_rim_carries_its_share() -> None:
    """m (D^2 + h^2)/4 = 0.9 J of the flywheel, and J u^2 of it at the crank."""
    found = values(told("course-project", only=("motion",)))
    diameter, thickness = (found["D_o"] + found["D_i"]) / 2, (found["D_o"] - found["D_i"]) / 2
    assert found["m_r"] * (diameter**2 + thickness**2) / 4 == pytest.approx(0.9 * found["J_M1"], rel=2e-4)
    assert found["J_M1"] * 17.6316**2 == pytest.approx(found["J_M"], rel=5e-5)


def test_a_flywheel_that_is_there_has_its_rim_told() -> None:
    """The shaper needs none beside 43.2 kg*m^2; its own has 186 kg*m^2 at 1300 mm."""
    found = values(told("shaper", only=("motion",)))
    assert found["m_t"] == pytest.approx(4 * 186 / 1.3**2, rel=1e-4)
    assert found["m_r"] * (found["D_o"] ** 2 + found["D_i"] ** 2) / 8 == pytest.approx(0.9 * 186, rel=2e-4)


@pytest.mark.parametrize(
    ("sizes", "said"),
    [
        (('diameter="12000 mm"',), {"the rim runs at ": "The condition fails"}),
        (('width="15 mm"',), {"more disk than rim": "more disk than rim"}),
        (
            ('width="15 mm"', 'speed_limit="5 m/s"'),
            {"more disk than rim": "more disk than rim", "the rim runs at ": "5.8777 ≤ 5 m/s. The condition fails"},
        ),
        (('diameter="9 mm"',), {"no such rim": "No such rim"}),
    ],
)
def test_what_speaks_against_a_flywheel_that_is_there_is_told(sizes: tuple[str, ...], said: dict[str, str]) -> None:
    """The stage sizes its rim at the largest speed of the motion, and its verdicts are among those of the motion."""
    changes = [f"flywheel.{size}" for size in sizes]
    done = run(load_spec(CONFIGS / "shaper.toml", changes), target=["motion"])
    note = text(Assembler().written(told("shaper", only=("motion",), changed=changes)))
    for verdict, sentence in said.items():
        assert any(verdict in str(each) for each in done.results["motion"].verdicts)
        assert sentence in note


def test_a_time_optimal_motion_is_that_of_the_textbook() -> None:
    """Phases of 4 s each, a travel of 1.6 m (2.10.2.4)."""
    found = values(told("crane-luffing", only=("unsteady",)))
    assert [found[name] for name in ("t_1", "t_2", "S_1", "S_2", "S_m")] == pytest.approx([4.0, 4.0, 0.4, 0.8, 1.6])


@pytest.mark.parametrize(
    ("name", "there", "absent"),
    [
        ("shaper", "ω_min ≥ ω_N: 5.4789 ≥ 5.5676 rad/s. The condition fails.", "Sizes of the flywheel\n"),
        ("press", "Angular velocity by the kinetic energy", "Characteristic of the motor"),
        ("electric-braking", "do not change over the cycle", "Excess work"),
        pytest.param(
            *("elastic-drive", "M_i,i+1 = c_i (φ_i − φ_i+1)", "Angular velocity by the recurrence"),
            marks=pytest.mark.slow,
        ),
    ],
)
def test_the_chapter_follows_its_scene(name: str, there: str, absent: str) -> None:
    found = said(name)
    assert there in found
    assert absent not in found


def test_every_motion_in_time_is_told() -> None:
    found = said("series-braking")
    titles: list[Any] = re.findall(r"^1\.\d\.\d Motion “(.*)”$", found, re.MULTILINE)
    assert titles == ["run-down", "self-excited", "field apart", "plugging", "regenerative"]
    assert "ω_e = r_a/κ" in found


@pytest.mark.parametrize(
    ("name", "counted"), [("shaper", {"2", "12"}), ("press", set())], ids=("a load that jumps", "friction alone")
)
def test_a_moment_that_jumps_is_the_same_in_all_tables_or_it_is_said(name: str, counted: set[str]) -> None:
    """The cutting force counts at both ends of its action; positions 0 and n are two sides of one."""
    found = blocks(told(name, only=("reduction", "motion")))
    tables = {each.key: each for each in found if isinstance(each, Table)}
    said = " ".join(each.text for each in found if isinstance(each, Paragraph))
    reduced, exact = tables["reduction_moments"], tables["motion_exact"]
    nodal = tables["motion_turns" if name == "shaper" else "motion_energies"]
    whole = next(k for k, head in enumerate(reduced.head) if "M_red" in head)
    own = {row[0]: row[whole] for row in reduced.rows if row[1]}
    assert own == {row[0]: row[exact.head.index("$M_c$, N·m")] for row in exact.rows}
    taken = {row[0]: row[nodal.head.index("$M_c$, N·m")] for row in nodal.rows}
    apart = [label for label in own if own[label] != taken[label]]
    assert f"$M_c$ jumps in a position (here {', '.join(apart)})" in said
    assert f"Rows 0 and {reduced.rows[-2][0]} are one position" in said
    assert ("begins or ends in a position (here 2, 12)" in said) == bool(counted)


def test_the_exact_line_is_on_one_side_of_a_jump() -> None:
    """In position 12 the cutting force ends, and the acceleration of a cam on the crank changes its sign."""
    cam = (
        'shaft = "crank", follower = "translating", stroke = 0.024, rise = "80°", return_angle = "90°", law = "const", '
        'crank_angle = "140°", limits = { pressure_angle = "28°", shaft_radius = 0.02 }, '
        "loads = { mass = 12, force = -120 }, spring = { least_contact = 40, deflection = 0.025 }"
    )
    assembler = Assembler()
    assembler.written(told("shaper", "12", ("motion",), [f"cam={{ {cam} }}"]))
    (line,) = [each for each in assembler.lines if each.formula.sides[0] == Name("eps")]
    assert line.found.error < 1e-12


@pytest.mark.slow
def test_a_time_that_is_given_is_no_result() -> None:
    """The start-up is followed for 15 s; the stop ends by itself."""
    results = [each for each in blocks(told("course-project", only=("motion",))) if isinstance(each, Result)]
    assert [each.place for each in results if each.given.meaning == "time of the motion"] == ["emergency stop"]
