"""Blocks of a document of Word: none of its pages is half empty, and no line begins with what belongs to a formula."""

from __future__ import annotations

import re
from itertools import pairwise

import pytest

from note.scenes import written
from tmmcalc.note.docxplaces import HIGH, LINE, holds, ordered
from tmmcalc.note.docxwords import cell_runs, runs
from tmmcalc.note.tree import Caption, Grid, Image, Text, Title, Written
from tmmcalc.report.drawing.shapes import Drawing
from tmmcalc.report.formula.setting import statement
from tmmcalc.report.formula.syntax import read

TITLE = Title("1", Text(("Forces",)), 1)


def words(lines: int) -> Text:
    return Text(("one two three four five six seven eight nine ten " * 2 * lines,))


def picture(key: str, high: float) -> Image:
    return Image(Caption("Figure", key, Text((key,))), Drawing(100.0, high))


def test_text_stands_before_a_picture_that_does_not_fit() -> None:
    paragraphs = [words(1) for _ in range(16)]
    first, second = picture("1.1", 100.0), picture("1.2", 150.0)
    found = [*ordered([TITLE, *paragraphs[:3], first, second, *paragraphs[3:]])]
    assert found.index(first) == 4
    above = found[: found.index(second)]
    assert all(isinstance(each, Text) for each in above[5:])
    high = 100.0 + LINE * sum(2 for each in above if isinstance(each, Text))
    assert HIGH - 50.0 < high < HIGH


def test_a_picture_that_fits_stays_and_none_leaves_its_chapter() -> None:
    blocks: list[Written] = [TITLE, words(1), picture("1.1", 100.0), words(1)]
    assert [*ordered(blocks)] == blocks
    long = [TITLE, *[words(2) for _ in range(8)], picture("1.1", 200.0), TITLE._replace(number="2"), words(9)]
    assert [*ordered(long)] == long


@pytest.mark.parametrize("name", ["press", "cam-oscillating", "gears-pairs"])
def test_all_blocks_are_there_in_an_order_that_tells_the_same(name: str) -> None:
    blocks = written(name)
    found = [*ordered(blocks)]
    assert sorted(map(id, found)) == sorted(map(id, blocks))
    for kind in (Image, Grid):
        assert [each for each in found if isinstance(each, kind)] == [each for each in blocks if isinstance(each, kind)]
    others = [each for each in blocks if not isinstance(each, Image | Grid)]
    assert [each for each in found if not isinstance(each, Image | Grid)] == others
    chapter = ""
    for each in found:
        if isinstance(each, Title) and each.level == 1:
            chapter = each.number
        elif isinstance(each, Image):
            assert each.caption.number.rpartition(".")[0] == chapter
    held = [(a, b) for a, b in pairwise(blocks) if holds(a, b) and not isinstance(b, Image | Grid)]
    after = {id(a): b for a, b in pairwise(found)}
    assert all(after[id(a)] is b for a, b in held)


def test_no_line_begins_with_what_belongs_to_the_formula_before_it() -> None:
    box = statement(read("omega_5"))
    said = runs(Text(("speeds ", box, ", ", box, " = 0.02 (m/s)/mm, and (", box, ")")))
    first, second, third = re.findall("<m:oMath>.*?</m:oMath>", said)
    assert first.endswith(">,</m:t></m:r></m:oMath>")
    assert "\u00a0=\u00a00.02\u00a0(m/s)/mm,</m:t>" in second
    assert ">(</m:t>" in third
    assert third.endswith(">)</m:t></m:r></m:oMath>")
    plain = re.sub("<[^>]*>", "", said).replace("\u00a0", " ")
    assert plain == "speeds ω5, ω5 = 0.02 (m/s)/mm, and (ω5)"


def test_letters_in_a_table_have_the_size_of_its_words() -> None:
    """LibreOffice writes every equation in 12 pt."""
    said = cell_runs(Text((statement(read("omega_5")), ", rad/s")))
    assert "oMath" not in said
    assert '<w:i/></w:rPr><w:t xml:space="preserve">ω</w:t>' in said
    assert '<w:vertAlign w:val="subscript"/></w:rPr><w:t xml:space="preserve">5</w:t>' in said
    assert "oMath" in cell_runs(Text((statement(read("z_2/z_1")),)))
