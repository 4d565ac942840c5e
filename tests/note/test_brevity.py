"""What a note does not say twice or write out in full: formulas told before, long sums, long narrow tables."""

from __future__ import annotations

import pytest
from sparing import sparing

from note.scenes import written
from tmmcalc.note.assembled import Assembler
from tmmcalc.note.tree import Equation, Grid, plain_text
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.formula.plain import plain
from tmmcalc.report.language import speaking
from tmmcalc.report.manuscript import Block, Chapter, Heading, Place, Table
from tmmcalc.report.telling import lines, tabulated

AREA = "A = a*b"


def place(a: float, b: float, *, name: str = "", meaning: str = "side") -> Place:
    known = {"A": Given(a * b, "m^2", "area"), "a": Given(a, "m", meaning), "b": Given(b, "m", meaning)}
    return Place(name, known)


def equations(*blocks: Block) -> list[Equation]:
    found = Assembler().written([Chapter("one", "One", blocks)])
    return [each for each in found if isinstance(each, Equation)]


def test_a_formula_told_before_stands_with_its_numbers_alone() -> None:
    first, second = (next(lines([AREA], [place(2.0, b)])) for b in (3.0, 4.0))
    one, other = equations(first, second)
    assert (one.number, one.lead) == ("1.1", "")
    assert (other.number, other.lead) == ("", "by (1.1)")
    assert [plain(part) for part in other.parts] == ["A", "2·4", "8 m²"]
    with speaking("uk"):
        assert equations(first, second)[1].lead == "за (1.1)"


def test_at_several_places_it_says_where() -> None:
    first, second = (
        next(lines([AREA], [place(2.0, b, name="pos. 1"), place(b, b, name="pos. 2")])) for b in (3.0, 4.0)
    )
    assert [each.lead for each in equations(first, second)][-2:] == ["pos. 1, by (1.1)", "pos. 2, by (1.1)"]


def test_of_other_quantities_it_is_told_anew() -> None:
    first, second = (next(lines([AREA], [place(2.0, 3.0, meaning=what)])) for what in ("side", "edge"))
    assert [each.number for each in equations(first, second)] == ["1.1", "1.2"]


def test_in_another_chapter_it_is_told_anew() -> None:
    line = next(lines([AREA], [place(2.0, 3.0)]))
    found = Assembler().written([Chapter("one", "One", (line,)), Chapter("two", "Two", (line,))])
    assert [each.number for each in found if isinstance(each, Equation)] == ["1.1", "2.1"]


@pytest.mark.parametrize(("count", "said"), [(8, "1 + 2 + 3 + 4 + 5 + 6 + 7 + 8"), (9, "1 + 2 + 3 + … + 9")])
def test_a_long_sum_shows_its_first_terms_and_its_last(count: int, said: str) -> None:
    values = [float(k) for k in range(1, count + 1)]
    known = {"S": Given(sum(values), "N", "sum"), "F_i": Given(values, "N", "forces")}
    (found,) = equations(next(lines(["S = sum(F_i, i)"], [Place("", known)])))
    assert plain(found.parts[2]) == said


def table(columns: int, rows: int, key: str = "t") -> Table:
    labels = [str(k) for k in range(rows)]
    return tabulated("t", {f"$x_{k}$, mm": [1234.5] * rows for k in range(columns)}, labels, head="No.", key=key)


def grids(*blocks: Block) -> list[Grid]:
    found = Assembler().written([Chapter("one", "One", (Heading("h"), *blocks))])
    return [each for each in found if isinstance(each, Grid)]


def test_a_long_narrow_table_is_folded() -> None:
    (found,) = grids(table(3, 25))
    assert (len(found.head), len(found.rows)) == (8, 13)
    assert plain_text(found.rows[0][4]) == "13"


def test_a_broad_or_short_table_is_not_folded() -> None:
    assert [len(each.head) for each in grids(table(9, 25), Heading("h"), table(3, 15))] == [10, 4]


def test_narrow_tables_stay_beside_each_other() -> None:
    assert [len(each.head) for each in grids(table(3, 25), table(3, 25, "u"))] == [4, 4]


@pytest.mark.slow
@sparing("language", ["en", "uk"], every=2)
def test_heads_of_columns_begin_with_capitals(language: str) -> None:
    with speaking(language):
        heads = [plain_text(cell) for each in written("shaper") if isinstance(each, Grid) for cell in each.head]
    assert heads
    assert not [head for head in heads if head[:4].isalpha() and len(head) > 4 and head[0].islower()]
