"""Pages of A4 for a printer at home: together they hold the whole sheet in true size."""

from __future__ import annotations

import pytest
from pages import lines, size, words

from tmmcalc.report.drawing.pens import THICK
from tmmcalc.report.drawing.shapes import Drawing, Words
from tmmcalc.report.sheets.formats import FORMATS
from tmmcalc.report.sheets.tiles import MARGIN, OVERLAP, tiled, tiles


@pytest.mark.parametrize("paper", FORMATS)
def test_pages_hold_the_sheet_and_overlap(paper: str) -> None:
    wide, high = FORMATS[paper]
    page, parts = tiles(wide, high)
    assert sorted(page) == [210.0, 297.0]
    for part in parts:
        assert part.part.width <= page[0] - 2 * MARGIN + 1e-9
        assert part.part.height <= page[1] - 2 * MARGIN + 1e-9
        right = [other.part for other in parts if (other.row, other.column) == (part.row, part.column + 1)]
        below = [other.part for other in parts if (other.row, other.column) == (part.row + 1, part.column)]
        assert [part.part.right - other.left for other in right] == pytest.approx([OVERLAP] * len(right))
        assert [other.top - part.part.bottom for other in below] == pytest.approx([OVERLAP] * len(below))
        assert right or part.part.right == wide
        assert below or part.part.bottom == 0.0
    assert (parts[0].part.left, parts[0].part.top) == (0.0, high)


def test_a_length_is_true_on_its_page() -> None:
    drawing = Drawing(420, 297)
    drawing.line([30 + 200j, 130 + 200j], THICK)
    drawing.line([300 + 30j, 400 + 30j], THICK)
    drawing.add(Words(80 + 205j, "upper left"), Words(350 + 35j, "lower right"))
    data = tiled(drawing, "sheet")
    page, parts = tiles(420, 297)
    assert size(data) == pytest.approx(page, abs=0.01)
    (line,) = [line for line in lines(data, 0) if abs(line.width - 0.7) < 0.01]
    assert abs(line.end - line.start) == pytest.approx(100.0, abs=0.01)
    assert "upper left" in words(data, 0)
    assert "lower right" not in words(data, 0)
    assert "lower right" in words(data, len(parts) - 1)
    for k, tile in enumerate(parts):
        assert f"sheet: row {tile.row}, column {tile.column}; {len(parts)} pages" in words(data, k)
