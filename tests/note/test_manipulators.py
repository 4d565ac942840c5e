"""The note on manipulators: every arm, path and motion that a spec allows, beside the textbook's program 2.2."""

from __future__ import annotations

import json
import re
from math import radians
from pathlib import Path

import pytest
from sparing import sparing

from note.naming import unnamed
from note.scenes import told, written
from note.test_lines import mutants, wrong
from tmmcalc.note.assembled import Assembler, Checked
from tmmcalc.note.conclusions import conclusions
from tmmcalc.note.plaintext import text
from tmmcalc.note.tree import Written
from tmmcalc.pipeline.chapters import chapters_of, stages_of, warnings_of
from tmmcalc.pipeline.picturing import NONE
from tmmcalc.pipeline.runner import run
from tmmcalc.project import load_spec
from tmmcalc.report.formula.digits import EXACT
from tmmcalc.report.formula.tree import Name
from tmmcalc.report.language import speaking
from tmmcalc.report.manuscript import Block, Line, Result

CASES = Path(__file__).parents[1] / "cases" / "kinematics.json"
ONLY = ("manipulator",)
HEAD = '[project]\ntitle = "t"\n\n[manipulator]\n'
DRIVEN = 'speed = "0.6 m/s"\nacceleration = "2 m/s^2"\n'
ARC = '[manipulator.path]\nkind = "arc"\nstart = [1.2, 0.3]\nend = [0.5, 1.1]\n'
SPACE = '[manipulator.path]\nkind = "arc"\nstart = [1.2, 0.3, 0.5]\nend = [0.5, 1.1, 0.9]\n'
CORNERS = "points = [[1.2, 0.2], [1.1, 0.8], [0.5, 0.9], [0.3, 0.5]]\n"
ANGULAR = 'arm = "angular"\nupper_arm = 0.9\nforearm = 0.8\n'
SPHERICAL, CYLINDRICAL = 'arm = "spherical"\n', 'arm = "cylindrical"\n'
KINDS = {
    "arc to the left": SPHERICAL + DRIVEN + "height = 0.1\n" + ARC + 'radius = 0.7\nside = "left"\n',
    "half circle": SPHERICAL + DRIVEN + ARC.replace("[0.5, 1.1]", "[0.6, 1.1]") + 'radius = 0.5\nside = "right"\n',
    "arc past the axis": SPHERICAL + DRIVEN + "[manipulator.path]\n"
    'kind = "arc"\nstart = [0.2, 0.9]\nend = [0.2, -0.7]\nradius = 0.9\nside = "left"\n',
    "arc through a point": CYLINDRICAL + DRIVEN + ARC + "via = [1.3, 1.0]\n",
    "arc through a point below": SPHERICAL + DRIVEN + ARC + "via = [0.6, 0.5]\n",
    "arc in space": CYLINDRICAL + DRIVEN + "total_acceleration = 3\n" + SPACE + 'radius = 0.8\nside = "right"\n',
    "arc in a tilted plane": SPHERICAL + DRIVEN + SPACE + 'radius = 0.8\nside = "left"\nnormal = [0.2, -0.1, 0.9]\n',
    "arc in space through a point": ANGULAR + DRIVEN + "height = 0.4\n" + SPACE + "via = [0.9, 0.9, 0.8]\n",
    "line": ANGULAR
    + 'elbow = "down"\n'
    + DRIVEN
    + '[manipulator.path]\nkind = "line"\nstart = [1.2, 0.2]\n'
    + "end = [0.4, 0.9]\n",
    "short line": CYLINDRICAL + DRIVEN + '[manipulator.path]\nkind = "line"\nstart = [1.2, 0.2]\nend = [1.15, 0.25]\n',
    "line in a given time": SPHERICAL
    + 'acceleration = 2\nduration = "3 s"\n[manipulator.path]\nkind = "line"\nstart = [1.2, 0.2, 0.1]\n'
    + "end = [0.4, 0.9, 0.3]\n",
    "stops": SPHERICAL + DRIVEN + '[manipulator.path]\nkind = "polyline"\n' + CORNERS,
    "rounded": ANGULAR
    + DRIVEN
    + 'normal_acceleration = 1\ntotal_acceleration = 2.5\n[manipulator.path]\nkind = "polyline"\ncorner_radius = 0.1\n'
    + CORNERS,
    "rounded in a given time": SPHERICAL
    + 'acceleration = 2\nnormal_acceleration = 3\nduration = "4 s"\n'
    + '[manipulator.path]\nkind = "polyline"\ncorner_radius = 0.1\n'
    + CORNERS,
    "past the limits": SPHERICAL
    + DRIVEN
    + ARC
    + 'radius = 0.8\nside = "right"\n[manipulator.limits]\nl_3 = [0.95, 1.2]\nphi_2 = ["20 deg", "60 deg"]\n'
    + '[[manipulator.obstacles]]\nname = "press"\nbox = [[0.6, 0.5], [1.05, 0.85]]\n',
    "near the shoulder": SPHERICAL
    + DRIVEN
    + '[manipulator.path]\nkind = "line"\nstart = [1.2, 0.02]\nend = [-1.0, 0.05]\n',
    "joints by laws": ANGULAR
    + "[manipulator.joints]\npsi = { from = 0, to = 1.2, speed = 0.9, acceleration = 2 }\n"
    + 'phi_2 = { from = "80 deg", to = "20 deg", speed = 0.8, acceleration = 3 }\n'
    + 'phi_3 = { from = "-10 deg" }\n',
    "each as quick as it can": SPHERICAL
    + "[manipulator.joints]\ntogether = false\n"
    + "phi_2 = { from = 0.2, to = 0.4, speed = 1, acceleration = 2 }\n"
    + "l_3 = { from = 1.2, to = 0.5, speed = 0.5, acceleration = 0.9 }\n",
    "a reach by laws": CYLINDRICAL
    + "height = 0.3\n[manipulator.joints]\nh = { from = 0.2, to = 0.5, speed = 0.4, acceleration = 2 }\n"
    + "r = { from = 1.2, to = 0.5, speed = 0.5, acceleration = 0.9 }\n",
    "joints by a table": SPHERICAL
    + "[manipulator.motion]\nt = [0, 0.8, 1.5, 3.1, 4]\n"
    + "phi_2 = [0.1, 0.7, 0.9, 0.4, 0.3]\nl_3 = [0.6, 0.9, 0.7, 0.8, 0.65]\n",
    "joints by two rows": ANGULAR
    + "[manipulator.motion]\nt = [0.5, 2]\npsi = [0, 0.9]\nphi_2 = [1.2, 0.7]\nphi_3 = [-0.5, -0.2]\n",
}


def of_kind(kind: str, folder: Path) -> tuple[list[Block], list[Checked], list[Written]]:
    """The blocks of a spec, its lines, and what is written."""
    spec = folder / "spec.toml"
    spec.write_text(HEAD + KINDS[kind], encoding="utf-8")
    done = run(load_spec(spec), target=stages_of(ONLY))
    chapters = chapters_of({"manipulator": "Manipulator"}, done.spec, done.results, NONE)
    found = Assembler()
    note = found.written(chapters)
    return [block for chapter in chapters for block in chapter.blocks], found.lines, note


@sparing("kind", KINDS, every=4)
def test_every_kind_of_motion_is_exact_and_works_out_as_printed(kind: str, tmp_path: Path) -> None:
    blocks, found, note = of_kind(kind, tmp_path)
    assert not [*unnamed(blocks)]
    assert len(found) > 15
    for line in found:
        assert line.found.error <= EXACT, (line.formula, line.place, line.found.error)
        assert line.found.off <= 0.5 + 1e-6, (line.formula, line.place, line.found)
    assert "nan" not in text(note)


def test_the_textbooks_arc() -> None:
    """Case KIN-S11: centre, angles, times, and the arm in its row 1, which is row 2 of the ready spec."""
    case = next(each for each in json.loads(CASES.read_text(encoding="utf-8")) if each["id"] == "KIN-S11")
    header, row = case["expected"]["header"], case["expected"]["rows"][1]
    assembler = Assembler()
    assembler.written(told("manipulator", only=ONLY))
    found: dict[str, float] = {}
    for line in assembler.lines:
        if line.place in ("", "in row 2") and isinstance(line.formula.sides[0], Name):
            found.setdefault(line.formula.sides[0].key, float(line.found.result))
    names = {"d": "d", "x_c": "xc", "y_c": "yc", "theta_1": "th1", "theta_2": "th2", "S_m": "S", "t_2": "t2", "T": "T"}
    for name, key in names.items():
        assert found[name] == pytest.approx(header[key], rel=5e-5), name
    assert radians(found["phi_0"]) == pytest.approx(header["f0"], rel=5e-5)
    assert radians(found["beta"]) == pytest.approx(header["b"], rel=5e-5)
    names = {"s": "s", "x": "xA", "a_y": "ay", "l_3": "l3", "omega_2": "w2", "v_3": "vs", "a_3": "as_", "eps_2": "e2"}
    for name, key in names.items():
        assert found[name] == pytest.approx(row[key], rel=5e-5), name
    assert radians(found["phi_2"]) == pytest.approx(row["f2"], rel=5e-5)


def test_what_limits_the_motion_is_told(tmp_path: Path) -> None:
    blocks, _, note = of_kind("past the limits", tmp_path)
    kept = {each.key: (each.given.value, each.limit) for each in blocks if isinstance(each, Result) and each.sense}
    assert kept["l_{3,min}"][0] < kept["l_{3,min}"][1] == 0.95
    assert "These joints leave their ranges:" in text(note)
    assert "crosses it, t, s:" in text(note)
    assert "All joints stay within their ranges." in text(written("manipulator", only=ONLY))


def test_a_singular_place_is_told(tmp_path: Path) -> None:
    said = text(of_kind("near the shoulder", tmp_path)[2])
    assert "The motion comes near to such places:" in said
    assert re.search(r"l_3 = 0\.0\d+ m at t = ", said)


@pytest.mark.parametrize("kind", ["past the limits", "near the shoulder", "joints by a table"])
def test_warnings_are_in_ukrainian(kind: str, tmp_path: Path) -> None:
    spec = tmp_path / "spec.toml"
    spec.write_text(HEAD + KINDS[kind], encoding="utf-8")
    done = run(load_spec(spec), target=stages_of(ONLY))
    with speaking("uk"):
        said = text(Assembler().written([conclusions([], warnings_of(done, stages_of(ONLY)), ())]))
    assert not re.findall(r"[A-Za-z]{4,}", said.replace("press", ""))
    assert not re.search(r"\d (m|deg|s)\b", said)


@pytest.mark.slow
def test_mutants_of_all_kinds_are_caught(tmp_path: Path) -> None:
    caught, missed = 0, []
    for kind in KINDS:
        for block in of_kind(kind, tmp_path)[0]:
            if isinstance(block, Line):
                for mutant in mutants(block.formula):
                    if any(wrong(mutant, place.lexicon) for place in block.places):
                        caught += 1
                    else:
                        missed.append((kind, mutant))
    assert len(missed) <= 0.01 * (caught + len(missed)), (caught, missed)
