"""Widths of columns: what Typst measures of their texts fits into them, and they fit the page."""

from __future__ import annotations

import json
import re

import pytest
from sparing import sparing

from note.scenes import written
from tmmcalc.note.columns import asked, asked_by, least_width, widths_of
from tmmcalc.note.tree import ACROSS, ALONG, POINT, Caption, Grid, Text
from tmmcalc.note.typst import HEAD, pdf
from tmmcalc.note.typsttables import set_tables
from tmmcalc.note.typstwords import set_text
from tmmcalc.report.drawing.lettering import FONTS
from tmmcalc.report.language import speaking

SIZE = 10.0  # of letters [pt]
BEYOND = 0.15  # of an em: so much a single formula may be wider than it is taken for, which the cell leaves free


def grids(name: str, language: str) -> list[Grid]:
    with speaking(language):
        return [each for each in written(name) if isinstance(each, Grid)]


def measured(texts: list[str]) -> list[float]:
    """How wide Typst sets them on a line [em]."""
    typst = pytest.importorskip("typst")
    cells = "\n".join(f"#metadata(measure[{text}].width.pt())<wide>" for text in texts)
    source = f'#set text(font: "TMM Text", size: {SIZE}pt)\n#context [{cells}]'
    fonts = typst.Fonts(include_system_fonts=False, font_paths=[str(FONTS)])
    found = json.loads(typst.query(source.encode(), "<wide>", field="value", font_paths=fonts))
    return [each / SIZE for each in found]


@sparing(("name", "language"), [("shaper", "en"), ("press", "uk"), ("gears-pairs", "uk")], every=3)
def test_texts_fit_their_columns(name: str, language: str) -> None:
    found = grids(name, language)
    with speaking(language):
        cells: dict[str, Text] = {
            set_text(cell): cell for grid in found for row in (grid.head, *grid.rows) for cell in row
        }
        assert len(cells) > 300
        for text, wide in zip(cells, measured([*cells]), strict=True):
            room = asked(cells[text])
            assert wide <= room.whole + BEYOND, text
            if room.least == room.whole and text.isalnum():
                assert 0.95 * room.whole <= wide <= 1.03 * room.whole, text  # pairs of letters stand closer


def test_columns_fit_the_page() -> None:
    """As wide as their texts where there is room; else the widest give way first, to their longest words at most."""
    for grid in grids("shaper", "en"):
        columns = asked_by(grid)
        wished = [column.whole * 3.0 + 2.0 for column in columns]
        least = least_width(grid, 3.0, 2.0)
        assert widths_of(grid, 3.0, 2.0, sum(wished)) == pytest.approx(wished)
        for room in (0.5 * (least + sum(wished)), least):
            widths = widths_of(grid, 3.0, 2.0, room)
            assert sum(widths) == pytest.approx(room, abs=1e-3)
            each = zip(widths, wished, (column.least * 3.0 + 2.0 for column in columns), strict=True)
            kept, given = [], []
            for wide, wish, need in each:
                assert need - 1e-9 <= wide <= wish + 1e-9
                if need < wide == wish:
                    kept.append(wide)
                elif need < wide:
                    given.append(wide)
            assert given == pytest.approx([max(given, default=0.0)] * len(given))
            assert all(wide <= min(given) for wide in kept if given)


@pytest.mark.parametrize("count", [20, 26, 40])
def test_a_table_too_wide_for_a_page_is_turned(count: int) -> None:
    """On the length of the page, in letters in which it fits there; one that fits nowhere fills it."""
    reader = pytest.importorskip("pypdfium2")
    pytest.importorskip("typst")
    row = tuple(Text((f"−{k}.12345",)) for k in range(count))
    grid = Grid(Caption("Table", "2.1", Text(("Wide",))), row, (row,) * 3)
    text = set_tables([grid], floats=False, stays=False)
    assert text.startswith("#turned[")
    widths = [float(each) for each in re.findall(r"([\d.]+)mm, ", text.partition("(")[2])][:count]
    assert ACROSS < sum(widths) <= ALONG + 0.01 * count
    document = reader.PdfDocument(pdf(f"{HEAD.replace('LANGUAGE', 'en').replace('PLAIN', '3')}\n{text}"))
    [page] = [each for each in document if each.get_width() > each.get_height()]
    found = page.get_textpage()
    rights = [found.get_charbox(k)[2] for k in range(found.count_chars())]
    assert max(rights) <= page.get_width() - 10 / POINT
    assert count > 30 or all(found.get_text_bounded().count(f"{k}.12345") >= 4 for k in range(10, count))
