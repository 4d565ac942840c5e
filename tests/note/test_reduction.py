"""The chapters on reduction and balance against the textbook's press (Appendix 3) and its balance (3.5)."""

from __future__ import annotations

import pytest

from note.scenes import told
from tmmcalc.note.assembled import Assembler
from tmmcalc.report.formula.tree import Name

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


def test_the_moments_of_the_press_are_those_of_the_textbook() -> None:
    found = results("8,10,11", "reduction")
    for position, moments in MOMENTS.items():
        for name, value in zip(("M_G", "M_Q3", "M_F"), moments, strict=True):
            assert found[name, f"pos. {position}"] == pytest.approx(value, rel=1e-4)


def test_works_by_simpson_and_the_efficiency_are_those_of_the_textbook() -> None:
    found = results("8", "reduction")
    assert found["A^S", "Q3"] == pytest.approx(-57.2859, rel=1e-4)
    assert found["A_c", ""] == pytest.approx(-57.2051, rel=1e-4)
    assert found["eta", ""] == pytest.approx(0.82251, abs=5e-5)


def test_the_counterweight_of_the_press_is_that_of_the_textbook() -> None:
    found = results("2", "balance")
    assert found["R", "pos. 2"] == pytest.approx(15.4165, rel=1e-4)
    assert found["U_1", ""] == pytest.approx(0.826339, rel=1e-4)
    assert found["D_1", ""] == pytest.approx(13.7444, rel=1e-4)
    assert found["D_L", ""] == pytest.approx(4.18569, rel=1e-4)
