"""The note on pairs of gears beside the textbook's worked pair, and what each kind of pair tells."""

from __future__ import annotations

import re
from functools import cache
from math import degrees
from pathlib import Path

import pytest
from sparing import sparing

from note.naming import unnamed
from note.scenes import told, written
from tmmcalc.note.assembled import Assembler
from tmmcalc.note.plaintext import text
from tmmcalc.note.tree import Equation
from tmmcalc.pipeline.chapters import chapters_of, stages_of
from tmmcalc.pipeline.picturing import NONE
from tmmcalc.pipeline.runner import run
from tmmcalc.project import load_spec
from tmmcalc.report.formula.digits import EXACT
from tmmcalc.report.formula.plain import plain

ONLY = ("gears",)
HEAD = '[project]\ntitle = "t"\n\n'
KINDS = {  # specs in which formulas differ from those of the ready specs
    "undercut shortens": '[pair]\nteeth = [8, 12]\nmodule = "4 mm"\nx1 = -0.2\nx2 = -0.1\nrefuse = false\n',
    "pointed": '[pair]\nteeth = [9, 20]\nmodule = "4 mm"\nx1 = 1.4\nx2 = 0.9\nrefuse = false\n',
    "centre beyond the line": '[pair]\nteeth = [30, 40]\nmodule = "4 mm"\nx1 = 1.1\nx2 = 0.95\nrefuse = false\n',
    "own rounding": '[pair]\nteeth = [17, 40]\nmodule = "4 mm"\nrack = "ISO 53 C"\nx1 = 0.3\nx2 = 0.2\n',
    "given tips": '[pair]\nteeth = [20, 40]\nmodule = "4 mm"\nx1 = 0.1\nx2 = 0.2\n'
    'tip_diameters = ["87 mm", "168 mm"]\nrefuse = false\n',
    "pins": '[pair]\nteeth = [21, 41]\nmodule = "4 mm"\nhelix_angle = "12 deg"\nface_width = "30 mm"\n'
    'measure_over = "pins"\nx1 = 0.1\nx2 = 0.2\n',
    "ring by the rack": '[pair]\nkind = "internal"\nteeth = [20, 60]\nmodule = "3 mm"\nhelix_angle = "10 deg"\n'
    'centre_distance = "61.5 mm"\nx1 = 0.3\n',
    "ring by a cutter": '[pair]\nkind = "internal"\nteeth = [10, 40]\nmodule = "3 mm"\nx1 = -0.2\nx2 = 0\n'
    "refuse = false\ncutter = { teeth = 20, shift = 0.1, rounding = 0.2 }\n",
    "undercut on a rack": '[pair]\nkind = "rack"\nteeth = [10]\nmodule = "4 mm"\nx1 = 0\nrefuse = false\n',
    "ring alone": '[wheel]\nkind = "internal"\nteeth = 50\nmodule = "4 mm"\nx = 0.2\ncutter = { teeth = 20 }\n',
    "pointed wheel": '[wheel]\nteeth = 9\nmodule = "4 mm"\nx = 1.2\n',
}


FAILING = ("undercut shortens", "pointed", "ring by a cutter", "pointed wheel")


@cache
def worked(name: str) -> dict[str, float]:
    """What the lines of a ready spec give, by their left sides; the first of each."""
    found: dict[str, float] = {}
    for each in Assembler().written(told(name, only=ONLY)):
        if isinstance(each, Equation) and len(each.parts) > 1:
            number = plain(each.parts[-1]).split()[0].rstrip("°").replace("−", "-")
            if re.fullmatch(r"-?\d+(\.\d+)?", number):
                found.setdefault(plain(each.parts[0]), float(number))
    return found


def test_the_textbooks_helical_pair() -> None:
    """4.7.3 and 4.7.4: z = 14 and 17, m = 5 mm, beta = 15 deg, a_w = 85 mm, x1 = 0.6."""
    found = worked("pair-helical")
    for name, value in (
        ("a", 80.2339),
        ("α_t", degrees(0.3603563)),
        ("α_tw", 27.9568),
        ("x_Σ", 1.122194),
        ("r_1", 36.2347),
        ("r_2", 43.9992),
        ("θ_1", -1.408982),
        ("g", 10.151997 + 29.696548),
        ("ρ_p1", 10.151997),
        ("ε_β", 0.659077),
        ("W_1", 40.0360),
    ):
        assert found[name] == pytest.approx(value, rel=6e-6), name
    assert found["ε_γ"] == pytest.approx(found["ε_α"] + found["ε_β"], abs=1e-5)
    assert found["c_1"] == found["c_2"] == 1.25  # c* m


def test_the_inverse_involute_is_checked_by_its_own_line() -> None:
    """inv(alpha_tw) stands twice: by the shifts, and by the angle that was found."""
    said = text(written("pair-spur", only=ONLY))
    lines = [line for line in said.splitlines() if line.startswith("    inv α_tw = ") and "°" in line]
    by_shifts, by_angle = (line.rpartition(" = ")[2].partition("    (")[0] for line in lines)
    assert by_shifts == by_angle


def test_point_d_slides_evenly() -> None:
    found = worked("pair-spur")
    assert found["θ_1"] == pytest.approx(found["θ_2"], abs=2e-5)
    assert found["ε_α"] == pytest.approx(1.2, abs=1e-5)


@sparing("kind", KINDS, every=4)
def test_every_kind_of_pair_is_exact_and_works_out_as_printed(kind: str, tmp_path: Path) -> None:
    spec = tmp_path / "spec.toml"
    spec.write_text(HEAD + KINDS[kind], encoding="utf-8")
    done = run(load_spec(spec), target=stages_of(ONLY))
    found, chapters = Assembler(), chapters_of({"gears": "Gears"}, done.spec, done.results, NONE)
    assert not [each for chapter in chapters for each in unnamed(chapter.blocks)]
    note = found.written(chapters)
    assert len(found.lines) > 20
    for line in found.lines:
        assert line.found.error <= EXACT, (line.formula, line.found.error)
        assert line.found.off <= 0.5 + 1e-6, (line.formula, line.found)
    said = text(note)
    assert "nan" not in said
    assert ("Conditions that fail" in said) == (kind in FAILING)


def test_a_spur_wheel_has_no_normal_section() -> None:
    assert "s_n" not in text(written("pair-spur", only=ONLY))
    assert "β" not in text(written("pair-spur", only=ONLY))


@pytest.mark.slow
def test_a_wheel_of_two_meshes_is_told_once() -> None:
    said = text(written("gears-pairs", only=ONLY))
    assert said.count("Tooth of wheel 2 by points") == 1
    assert said.count("Index 1 is that of wheel 2, index 2 that of wheel 3.") == 1
    assert "External pair 19/38 (1–2)" in said


@pytest.mark.slow
def test_the_open_pair_on_the_crank() -> None:
    said = text(written("geared-press", only=ONLY))
    assert " = 60/18 = 3.3333" in said
    assert "J_ab = J_a u^2 + J_b" in said
    assert all(f"{name} = " in said for name in ("T_a", "F_t", "F_r", "F_n"))
    assert "Open pair" not in text(written("pair-helical", only=ONLY))
