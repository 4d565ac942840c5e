"""Formulas that are wider than a line: rows that fit, and that say the same."""

from __future__ import annotations

import math
import re

import pytest

from tmmcalc.report.formula.breaking import broken, width
from tmmcalc.report.formula.layout import Row
from tmmcalc.report.formula.plain import plain
from tmmcalc.report.formula.setting import side
from tmmcalc.report.formula.syntax import read

NUMBERS = (
    "x = 2*(55.1*(0.7017*1.205 + 0.0114*(3.1 - 0.983)) + 4.55*(1.3 + 2.5*(0.0872 - 3.25)))/5.7596**3",
    "x = (1.25 + 2.5*3.75 - 4.125 + (5.5 + 6.125*(7.25 + 8.5)))**2*(1.5 + (0.25 - 3.5)*4.5)/(2.5*3.5 + 1.25)",
    "x = sqrt(2.5**2 + 3.25**2 + (1.125 + 4.5)*(6.25 - 2.125) + 8.5 + 9.75)",
)


@pytest.mark.parametrize("text", NUMBERS)
@pytest.mark.parametrize("wide", [40.0, 20.0, 14.0])
def test_rows_fit_and_have_the_value_of_the_whole(text: str, wide: float) -> None:
    statement = read(text)
    rows = broken([side(each) for each in statement.sides], wide)
    assert all(width(row) <= wide for row in rows)
    assert len(rows) > 1 or wide == 40.0
    assert worked_out("".join(map(plain, rows))) == pytest.approx(worked_out(text.replace("**", "^")), rel=1e-12)


def test_a_formula_that_fits_stays_as_it_is() -> None:
    parts = [side(each) for each in read("x = sqrt((a + b)/c)").sides]
    (row,) = broken(parts, 40.0)
    assert plain(row) == "x = √((a + b)/c)"


def test_an_operand_of_a_stroke_keeps_its_bracket() -> None:
    parts: list[Row] = [side(each) for each in read("x = (a + b*(c - d))/(e*f)").sides]
    assert "".join(map(plain, broken(parts, 8.0))) == "x = (a + b (c − d))/(e f)"


def worked_out(text: str) -> float:
    """The value of the right side of a formula of numbers as it is printed."""
    said = text.partition("=")[2].replace("−", "-").replace("·", "*").replace("^", "**").replace("√", "sqrt")
    said = re.sub(r"\*\*\(?1/2\)?", "**0.5", said)
    return float(eval(said, {"sqrt": math.sqrt}))
