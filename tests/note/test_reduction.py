"""The chapters on reduction and balance against the textbook's press (Appendix 3) and its balance (3.5)."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import pytest

from note.scenes import blocks, told
from tmmcalc.note.assembled import Assembler
from tmmcalc.pipeline.chapters import chapters_of
from tmmcalc.pipeline.runner import run
from tmmcalc.project import load_spec
from tmmcalc.report.formula.digits import RESULT
from tmmcalc.report.formula.tree import Name
from tmmcalc.report.manuscript import Heading, Line, Paragraph
from tmmcalc.rooms import CHAPTERS

SPRUNG = Path(__file__).parents[1] / "design" / "sprung.toml"
MOMENTS = {8: (1.48464, -3.44517, -1.16916), 10: (-1.48464, -38.9661, -3.42309), 11: (-2.57147, -42.8954, -6.31186)}


def results(positions: str, *only: str) -> dict[tuple[str, str], float]:
    """The printed results of the press by name and place."""
    assembler = Assembler()
    assembler.written(told("press", positions, only))
    found = {}
    for line in assembler.lines:
        left = line.formula.sides[0]
        assert isinstance(left, Name)
        found[left.key, line.place] = float(line.found.result)
    return found


def printed(value: float) -> Any:
    """A value of the textbook to half of the last digit that the note prints."""
    return pytest.approx(value, abs=0.501 * 10.0 ** (math.floor(math.log10(abs(value))) + 1 - RESULT))


def test_the_moments_of_the_press_are_those_of_the_textbook() -> None:
    found = results("8,10,11", "reduction")
    for position, moments in MOMENTS.items():
        for name, value in zip(("M_G", "M_Q3", "M_F"), moments, strict=True):
            assert found[name, f"pos. {position}"] == printed(value)


def test_works_by_simpson_and_the_efficiency_are_those_of_the_textbook() -> None:
    found = results("8", "reduction")
    assert found["A^S", "Q3"] == printed(-57.2859)
    assert found["A_c", ""] == printed(-57.2051)
    assert found["eta", ""] == printed(0.82251)


def test_the_counterweight_of_the_press_is_that_of_the_textbook() -> None:
    found = results("2", "balance")
    assert found["R", "pos. 2"] == printed(15.4165)
    assert found["U_1", ""] == printed(0.826339)
    assert found["D_1", ""] == printed(13.7444)
    assert found["D_L", ""] == printed(4.18569)


def test_what_is_zero_in_the_shown_positions_is_told() -> None:
    """The weights of the press do no work in the middle of the strokes; their column has a name all the same."""
    said = [each.text for each in blocks(told("press", "3,9", ("reduction",))) if isinstance(each, Paragraph)]
    assert any("$M_{G}$ (weights)" in each for each in said)
    said = [each.text for each in blocks(told("press", "8", ("reduction",))) if isinstance(each, Paragraph)]
    assert not any("are zero" in each for each in said)


def test_which_side_of_a_jump_a_load_is_told_of() -> None:
    """The load of a cam falls in position 18 and grows in 19: its moment is that after the jump in both of them."""
    force = '{ phi = ["0°", "40°", "40°", "55°", "55°", "180°"], force = [-90, -90, -20, -20, -80, 0] }'
    changes = [f'cam.loads={{ mass = "1.2 kg", force_table = {force}, gravity = -9.81, friction = 0.1 }}']
    found = blocks(told("course-project", only=("reduction",), changed=changes))
    said = " ".join(each.text for each in found if isinstance(each, Paragraph))
    assert "Where a load begins or ends in a position (here 19), it counts there." in said
    assert "Where the technological load jumps in a position (here 18), its value there is that after the jump." in said


def test_a_rod_whose_centre_of_mass_is_in_a_pin_is_divided_between_none(tmp_path: Path) -> None:
    """Its mass stands in the pin whole, at either end of the rod; the other masses have their lines."""
    for centre in ("", 'center = ["600 mm", 0]', 'center = ["300 mm", 0]'):
        words = SPRUNG.read_text(encoding="utf-8").replace('center = ["300 mm", 0]', centre)
        spec = tmp_path / "pinned.toml"
        spec.write_text(f"{words}\n[balance]\n", encoding="utf-8")
        done = run(load_spec(spec), target="balance")
        found = blocks([*chapters_of({"balance": CHAPTERS["balance"]}, done.spec, done.results)])
        divided = [line for line in found if isinstance(line, Line) and line.formula.sides[0] == Name("m_2A")]
        titles = [each.text for each in found if isinstance(each, Heading)]
        assert (len(divided), "Masses in points" in titles) == ((1, True) if "300" in centre else (0, False))
        assert "Shaking force and moment" in titles
