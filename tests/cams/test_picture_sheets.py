"""The pictures of the ready specs with cams: all on their sheet, names where they cover nothing."""

from __future__ import annotations

from pathlib import Path

import pytest
from paper import on_sheet

from tmmcalc.core.stage import STAGES, resolve
from tmmcalc.pipeline.runner import run
from tmmcalc.project import load_spec, parse_spec
from tmmcalc.report.drawing.order import CHOOSE, PHASE, POLYGONS, POSITIONS, Order
from tmmcalc.report.drawing.shapes import Drawing

CONFIGS = Path(__file__).parents[2] / "configs"
QUICK = ("cam-groove", "cam-oscillating-against", "cam-synthesis")
SPECS = sorted(
    file.stem for file in CONFIGS.glob("*.toml") if "\n[cam]" in (text := file.read_text()) or "[indexing" in text
)
FREE = 0.99  # of the names stand where they cover nothing


def drawings(name: str) -> dict[str, Drawing]:
    """The pictures of the cams' stages of a ready spec."""
    spec = load_spec(CONFIGS / f"{name}.toml")
    results = run(spec).results
    flags = dict.fromkeys((POSITIONS, POLYGONS, CHOOSE, PHASE))
    order = Order(spec, results, flags, results.__getitem__, parse_spec)
    stages = [stage for stage in results if stage.startswith("cam_") or stage == "indexing"]
    return {stage: resolve(STAGES[stage].picture.figure)(order) for stage in stages if STAGES[stage].picture}


@pytest.mark.parametrize("name", QUICK)
def test_nothing_reaches_over_the_sheet(name: str) -> None:
    found = drawings(name)
    assert len(found) >= 4
    assert {stage: on_sheet(drawing) for stage, drawing in found.items() if on_sheet(drawing)} == {}


@pytest.mark.slow
def test_names_of_all_ready_specs_have_a_free_place() -> None:
    assert {"cam", "cam-lantern", "course-project"} < set(SPECS)
    count, faults = 0, []
    for name in SPECS:
        for stage, drawing in drawings(name).items():
            assert not on_sheet(drawing), (name, stage)
            count += sum(field.labels.count for field in drawing.fields)
            faults += [(name, stage, fault) for field in drawing.fields for fault in field.labels.faults]
    assert len(faults) <= (1 - FREE) * count, faults
