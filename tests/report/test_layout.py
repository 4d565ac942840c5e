from __future__ import annotations

from tmmcalc.report.document import Document, View
from tmmcalc.report.layout import GAP, fitted

VIEW = View(["i", "phi[deg]", "S_D[m]", "count"], [["0", "1"], [0.0, 15.0], [0.0, -0.25], [3, 12]])


def test_cells_have_name_and_unit() -> None:
    columns, cut = fitted(Document("t", table=VIEW), 80)
    assert cut == 0
    assert [(c.name, c.unit, c.text) for c in columns] == [
        ("i", "", True),
        ("phi", "deg", False),
        ("S_D", "m", False),
        ("count", "", False),
    ]
    assert columns[2].cells == ["0.00", "-0.25"]
    assert columns[3].cells == ["3", "12"]
    assert [c.width for c in columns] == [1, 3, 5, 5]


def test_a_wide_table_is_cut_to_the_width() -> None:
    document = Document("t", table=VIEW, wide=True)
    need = 1 + GAP + 3 + GAP + 5
    assert len(fitted(document, need)[0]) == 3
    assert fitted(document, need)[1] == 1
    assert len(fitted(document, need - 1)[0]) == 2
    assert len(fitted(document, 0)[0]) == 2  # two columns at least


def test_a_table_that_was_asked_for_is_whole() -> None:
    assert len(fitted(Document("t", table=VIEW), 5)[0]) == 4


def test_peaks_and_powers_of_ten() -> None:
    view = View(["step[m]", "error"], [[1e-17], [0.5]], peaks=[1.0, 0.5], scientific=["error"])
    columns, _ = fitted(Document("t", table=view), 80)
    assert [c.cells for c in columns] == [["0"], ["5.00e-01"]]


def test_no_table() -> None:
    assert fitted(Document("t"), 80) == ([], 0)


def test_a_word_among_numbers() -> None:
    view = View(["delta", "count"], [[0.0375, "stalls", 0.5], [1, "none", 12]])
    (delta, count), _ = fitted(Document("t", table=view), 80)
    assert (delta.cells, delta.text) == (["0.0375", "stalls", "0.5000"], False)
    assert (count.cells, count.text) == (["1", "none", "12"], True)
