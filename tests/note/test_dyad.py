"""The note on a dyad by itself, of every kind with moving joints."""

from __future__ import annotations

from pathlib import Path

import pytest

from note.scenes import told
from note.test_lines import mutants, wrong
from tmmcalc.note.assembled import Assembler
from tmmcalc.note.plaintext import text
from tmmcalc.pipeline.chapters import chapters_of
from tmmcalc.pipeline.picturing import NONE
from tmmcalc.pipeline.runner import run
from tmmcalc.project import load_spec
from tmmcalc.report.formula.digits import EXACT
from tmmcalc.report.formula.tree import Name
from tmmcalc.report.manuscript import Chapter, Line

FIRST = """[dyad.first]
point = ["100 mm", "200 mm"]
velocity = ["0.3 m/s", "-0.4 m/s"]
acceleration = ["0.5 m/s^2", "0.1 m/s^2"]
"""
SECOND = """[dyad.second]
point = ["500 mm", "300 mm"]
velocity = ["-0.2 m/s", "0.1 m/s"]
acceleration = ["0.2 m/s^2", "0.3 m/s^2"]
"""
GUIDE = 'angle = "20 deg"\nomega = "1.5 rad/s"\neps = "-2 rad/s^2"\n'
STEEP = GUIDE.replace("20 deg", "80 deg")
POINTS = 'points_a = { E = ["350 mm", "100 mm"] }\npoints_b = { F = ["50 mm", "-70 mm"], B = ["10 mm", "20 mm"] }\n'
KINDS = {
    "RRR": 'length_a = "400 mm"\nlength_b = "300 mm"\n' + POINTS + FIRST + SECOND,
    "RRR -": 'length_a = "400 mm"\nlength_b = "300 mm"\nvariant = -1\n' + FIRST + SECOND,
    "RRP": 'length_a = "400 mm"\noffset_b = "30 mm"\n' + POINTS + FIRST + SECOND + GUIDE,
    "RRP -": 'length_a = "400 mm"\nvariant = -1\n' + FIRST + SECOND + GUIDE,
    "RPR": 'offset_a = "30 mm"\n' + POINTS + FIRST + SECOND,
    "RPR -": 'offset_a = "-30 mm"\nvariant = -1\n' + FIRST + SECOND,
    "PRP": 'offset_a = "30 mm"\noffset_b = "40 mm"\n' + POINTS + FIRST + STEEP + SECOND + GUIDE,
    "RPP": 'offset_a = "30 mm"\noffset_b = "40 mm"\nturn = "60 deg"\n' + POINTS + FIRST + SECOND + GUIDE,
    "RPP plain": FIRST + SECOND,
}


def chapter(kind: str, folder: Path) -> Chapter:
    """The chapter on a dyad of this kind."""
    spec = folder / "spec.toml"
    head = f'[project]\ntitle = "t"\n\n[dyad]\nkind = "{kind.split()[0]}"\n'
    spec.write_text(head + KINDS[kind], encoding="utf-8")
    done = run(load_spec(spec), target=["dyad"])
    return chapters_of({"dyad": "Dyad"}, done.spec, done.results, NONE)[0]


@pytest.mark.parametrize("kind", KINDS)
def test_every_kind_is_exact_and_its_mutants_are_caught(kind: str, tmp_path: Path) -> None:
    found, assembler = chapter(kind, tmp_path), Assembler()
    said = text(assembler.written([found]))
    for line in assembler.lines:
        assert line.found.error <= EXACT, (line.formula, line.found.error)
        assert line.found.off <= 0.5 + 1e-6, (line.formula, line.found)
    assert ("variant" in said) == (kind[:3] not in ("PRP", "RPP"))
    if kind == "RPP plain":
        return  # its lines stand at right angles: a division by one
    caught = missed = 0
    for block in found.blocks:
        if isinstance(block, Line):
            for mutant in mutants(block.formula):
                off = any(wrong(mutant, place.lexicon) for place in block.places)
                caught, missed = caught + off, missed + (not off)
    assert caught > 50
    assert missed <= 0.01 * (caught + missed)


def test_the_dyad_of_the_doctest() -> None:
    """The angular velocity of link a that `solve_dyad` has in its documentation."""
    assembler = Assembler()
    assembler.written(told("dyad", only=("dyad",)))
    found = {line.formula.sides[0]: float(line.found.result) for line in assembler.lines}
    assert found[Name("omega_a")] == pytest.approx(0.45695885, rel=3e-5)


def test_joints_have_letters_that_no_point_has(tmp_path: Path) -> None:
    said = text(Assembler().written([chapter("RRR", tmp_path)]))
    assert "The links meet in the pin C." in said  # B, E and F are points of the links
