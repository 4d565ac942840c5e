"""The diagrams: a panel a study and a ladder, a curve a method, the tolerance across; and the table of both."""

from __future__ import annotations

import pytest
from paper import curves, written

from tmmcalc.accuracy.document import TOLD, accuracy_document, tidy_document
from tmmcalc.accuracy.picture import ASKED, accuracy_drawing
from tmmcalc.core.studies.study import Accuracy, Ladder, Point, Reference, Rung, Series, Study
from tmmcalc.report.drawing.diagram import Diagram
from tmmcalc.report.drawing.shapes import Drawing

EXACT = Reference("known", 1e-16)
FINE = Series("fine", (Point("a", 1.0, 1e-3, 1e-3), Point("b", 0.5, 1e-9, 2e-3)), order=2.0, expected=2.0)
ROUGH = Series("rough", (Point("a", 1.0, 1e-2, 1e-4),))
BROKEN = Series("broken", (Point("a", 1.0, None, None, failed="it does not converge"),))
STUDY = Study("motion", "speed", EXACT, (FINE, ROUGH, BROKEN))
ALONE = Study("kinematics", "positions", EXACT, (Series("closed", (Point("", 1.0, 1e-16, 1e-4),)),))


def _rung(value: float) -> Rung:
    return Rung(value, 1 / value, 3 / value, value, int(5 * value), None, "unstable", "collocation", False, 900, 0.1,
                1e-10, 1e-12)  # fmt: skip


LADDER = Ladder("transient", "stiffness", "N*m/rad", 0.2, 0.01, EXACT, tuple(_rung(10.0**k) for k in range(3, 7)), -0.5)
ALL = Accuracy((STUDY, ALONE), (), (LADDER,))


def _panels(drawing: Drawing) -> list[Diagram]:
    return [field for field in drawing.fields if isinstance(field, Diagram)]


def test_a_panel_a_study_and_a_ladder() -> None:
    drawing = accuracy_drawing(ALL, "All", 1e-6)
    study, ladder = _panels(drawing)  # one setting alone is no comparison
    said = written(drawing)
    assert {"motion: speed", "transient: stiffness"} <= set(said)
    assert "kinematics: positions" not in said
    names = ["fine (order 2)", "rough", "broken (no result)", "tolerance asked for"]
    assert [text for text in said if text in names] == names
    (asked,) = curves(study, ASKED)
    assert asked.imag == pytest.approx([1e-6, 1e-6])
    assert ladder.y.name == "evaluations"
    assert {"fixed steps at the limit of stability", "choice of the program"} <= set(said)


def test_axes_span_so_much_that_the_scatter_of_a_clock_is_small() -> None:
    (panel,) = _panels(accuracy_drawing(Accuracy((STUDY,), ()), "One"))
    low, high = panel.x.low, panel.x.high
    assert high / low > 10**1.5
    assert low < 0.1 < 2.0 < high, "all times are inside"


@pytest.mark.slow
def test_more_sheets_keep_the_size_of_the_panels() -> None:
    panels = _panels(accuracy_drawing(Accuracy((STUDY,) * 7, ()), "Seven"))
    widths = {round(panel.box.width, 2) for panel in panels}
    assert len(panels) == 7
    assert max(widths) < 1.5 * min(widths)


def test_nothing_to_draw() -> None:
    assert not _panels(accuracy_drawing(Accuracy((ALONE,), ()), "None"))


def test_rows_for_programs_hold_studies_and_ladders() -> None:
    table = tidy_document(ALL, "All").table
    assert table is not None
    assert tuple(table.headers) == TOLD
    rows = list(zip(*table.columns, strict=True))
    assert len(rows) == 5 + 2 * len(LADDER.rungs)
    assert [row[-1] for row in rows[:5]] == ["1e-03", "1e-06 1e-09", "", "", "1e-03 1e-06 1e-09 1e-12"]
    asked = tidy_document(ALL, "All", 1e-2).table
    assert asked is not None
    assert list(asked.columns[-1][:5]) == ["", "", "1e-02", "", "1e-02"]
    assert {row[4] for row in rows} >= {"fine", "broken", "choice of the program, collocation", "fixed step of 0.01 s"}


def test_tolerances_keep_their_digits() -> None:
    facts = accuracy_document(ALL, "All", 1.44e-6).parts[0].facts
    assert {fact.label for fact in facts} >= {"cheapest for 1.44e-06", "never 1.44e-06"}
    assert "cheapest_1.44e-06" in {key for fact in facts for key in fact.values}


def test_what_is_near_by_chance_is_told_so() -> None:
    lucky = Series("table", (Point("a", 1.0, 1e-16, 1e-4), Point("b", 0.5, 1e-3, 2e-4), Point("c", 0.2, 1e-4, 3e-4)))
    part = accuracy_document(Accuracy((Study("s", "q", EXACT, (lucky,)),), ()), "One", 1e-6).parts[0]
    facts = {fact.label: fact.text for fact in part.facts}
    assert facts["cheapest for 1e-06"] == "none reaches it"
    assert facts["never 1e-06"] == "table: 1.0e-16 at best, a, by chance: finer ones miss it"


def test_what_never_reaches_a_tolerance_says_so() -> None:
    part = accuracy_document(ALL, "All", 1e-6).parts[0]
    facts = {fact.label: fact.text for fact in part.facts}
    assert facts["never 1e-06"] == "rough: 1.0e-02 at best, a\nbroken: no result"
    assert facts["cheapest for 1e-06"].startswith("fine, b: error 1.0e-09")
    four = {fact.label: fact.text for fact in accuracy_document(ALL, "All").parts[0].facts}
    assert four["never 1e-03"] == "rough: 1.0e-02 at best, a\nbroken: no result"
    assert four["never 1e-12"] == "fine: 1.0e-09 at best, b", "each method once, at the loosest that it misses"
