"""The page of docs/make_accuracy.py: every stage with a choice of methods that its scenes run is there."""

from __future__ import annotations

from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path
from types import ModuleType

import pytest

from tmmcalc import load_spec
from tmmcalc.accuracy.solve import SUBJECTS
from tmmcalc.core.plan import plan
from tmmcalc.core.stage import resolve
from tmmcalc.core.studies.measure import Clock
from tmmcalc.rooms import STAGES

from .scenes import CONFIGS

PAGE = CONFIGS.parent / "docs" / "accuracy.md"


def _maker() -> ModuleType:
    found = spec_from_file_location("make_accuracy", CONFIGS.parent / "docs" / "make_accuracy.py")
    assert found is not None
    assert found.loader is not None
    module = module_from_spec(found)
    found.loader.exec_module(module)
    return module


MAKER = _maker()


@pytest.mark.parametrize("name", MAKER.SCENES)
def test_every_stage_that_a_scene_runs_stands_on_the_page(name: str) -> None:
    page = PAGE.read_text(encoding="utf-8")
    assert MAKER.HEAD.split("{cores}")[0] in page, "make accuracy writes the page afresh"
    part = page.split(f"\n## {MAKER.SCENES[name]}\n")[1].split("\n## ")[0]
    settled = next((line for line in part.splitlines() if line.startswith(MAKER.SETTLED)), "")
    running = plan(load_spec(CONFIGS / f"{name}.toml"), None).running
    told = {stage for stage in SUBJECTS if f"\n### {stage}" in part or f" {stage}" in settled}
    assert not [stage for stage in running if stage in SUBJECTS and stage not in told]


def test_every_subject_is_a_stage_and_has_its_studies() -> None:
    assert set(SUBJECTS) <= set(STAGES)
    assert all(callable(resolve(place)) for place in SUBJECTS.values())


def test_what_was_measured_is_kept_and_drawn_again(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A quick clock on one scene: what is read back is what was measured, and gives the same page and diagram."""
    monkeypatch.setattr(MAKER, "DATA", tmp_path)
    monkeypatch.setattr(MAKER, "HOME", tmp_path)
    monkeypatch.setattr(MAKER, "SCENES", {"gears-single-planets": "Planetary train"})
    with pytest.raises(SystemExit, match="nothing is kept of gears-single-planets"):
        MAKER.main(["--draw"])
    found = MAKER.measure("gears-single-planets", Clock(repeats=1, budget=0.0))
    cores, again = MAKER.kept("gears-single-planets")
    assert cores >= 1
    assert again == found
    MAKER.main(["--draw"])
    first = (tmp_path / "accuracy.md").read_bytes(), (tmp_path / "gears-single-planets.svg").read_bytes()
    assert f"on {cores} cores" in first[0].decode()
    assert "## Planetary train" in first[0].decode()
    MAKER.main(["--draw"])
    assert first == ((tmp_path / "accuracy.md").read_bytes(), (tmp_path / "gears-single-planets.svg").read_bytes())
    with pytest.raises(SystemExit, match="no scene shaper: scenes are gears-single-planets"):
        MAKER.main(["shaper"])
