"""Pictures of the pairs and wheels of ready specs: all on the sheet, no words over others, names in free places."""

from __future__ import annotations

from functools import cache

import pytest
from paper import covered, on_sheet
from ready import SPECS

import tmmcalc
from tmmcalc.core.plan import plan
from tmmcalc.gears.pictures.blocking import blocking_drawing
from tmmcalc.gears.pictures.pair import pair_drawing
from tmmcalc.gears.pictures.profile import profile_drawing
from tmmcalc.gears.pictures.wheel import wheel_drawing
from tmmcalc.report.drawing.shapes import Drawing

DRAWINGS = {"pair": pair_drawing, "profile": profile_drawing, "blocking": blocking_drawing, "wheel": wheel_drawing}
SHOWN = {name: [stage for stage in plan(spec).running if stage in DRAWINGS] for name, spec in SPECS.items()}
QUICK = ("pair-rack", "wheel")  # the others are long
MOST = 0.01  # of the names have no free place


@cache
def drawings_of(name: str) -> dict[str, Drawing]:
    results = tmmcalc.run(SPECS[name]).results
    return {stage: DRAWINGS[stage](results["pair" if stage == "profile" else stage]) for stage in SHOWN[name]}


@pytest.mark.parametrize(
    "name", [pytest.param(k, marks=() if k in QUICK else pytest.mark.slow) for k, shown in SHOWN.items() if shown]
)
def test_all_is_on_the_sheet_and_no_words_cover_others(name: str) -> None:
    for drawing in drawings_of(name).values():
        assert not on_sheet(drawing)
        assert not covered(drawing, 0.3)


@pytest.mark.slow
def test_names_have_free_places() -> None:
    labels = [
        field.labels
        for name, shown in SHOWN.items()
        if shown
        for drawing in drawings_of(name).values()
        for field in drawing.fields
    ]
    faults = [fault for each in labels for fault in each.faults]
    assert len(faults) <= MOST * sum(each.count for each in labels), faults
