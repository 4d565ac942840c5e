"""Results of one stage at every point: maps of feasibility are solved together where they can be."""

from __future__ import annotations

from pathlib import Path

import pytest

import tmmcalc
from tmmcalc.batch import outcomes, stacked
from tmmcalc.batch.reading import task_of
from tmmcalc.batch.stacked_results import Results
from tmmcalc.core.errors import SpecError, TmmError, UsageError
from tmmcalc.feasibility.judge import Feasibility
from tmmcalc.project.loader import Variants

SHAPER = Path(__file__).parents[2] / "configs" / "shaper.toml"
CRANK = "mechanism.links[id=1].points.A[0]"
CONSTRAINTS = """
[[constraints]]
name = "even"
stage = "motion"
value = "delta"
at_most = 0.07

[[constraints]]
name = "light"
stage = "forces"
column = "R_A"
at_most = "13 kN"
"""


@pytest.fixture
def spec(tmp_path: Path) -> Path:
    file = tmp_path / "f.toml"
    file.write_text(SHAPER.read_text() + CONSTRAINTS)
    return file


@pytest.mark.slow
def test_a_map_is_that_of_each_point(spec: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    over = [f"{CRANK}=180 mm:220 mm:4", "flywheel.inertia=120:250:4"]
    together = tmmcalc.map_feasibility(spec, over)
    monkeypatch.setattr(stacked, "FEW", 1000)
    alone = tmmcalc.map_feasibility(spec, over)
    assert together.failing == alone.failing
    assert together.values == pytest.approx(alone.values, rel=1e-12)
    assert together.margins == pytest.approx(alone.margins, abs=1e-12)
    assert 0 < together.feasible.sum() < 16


def test_points_of_a_map_go_through_the_arrays(spec: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(outcomes, "run", lambda *_, **__: pytest.fail("a point was solved alone"))
    task = task_of(spec, [f"{CRANK}=180 mm:220 mm:16"], None, ("feasibility",), ())
    assert isinstance(stacked.prepared(task), Results)
    assert all(isinstance(found, Feasibility) for found in outcomes.outcomes(task))


def test_points_without_a_solution_are_told(spec: Path) -> None:
    sets = [f"{CRANK}=0.2,0.7", "mechanism.links[id=5].mass=-5,190"]
    found = list(outcomes.outcomes(task_of(spec, sets, None, ("feasibility",), ())))
    assert [isinstance(each, Feasibility) for each in found] == [False, True, False, False]
    assert isinstance(found[0], SpecError)
    assert isinstance(found[3], TmmError)


def test_a_quantity_that_is_not_there_ends_the_map(spec: Path) -> None:
    spec.write_text(spec.read_text().replace('"R_A"', '"R_Z"'))
    task = task_of(spec, [f"{CRANK}=180 mm:220 mm:20"], None, ("feasibility",), ())
    with pytest.raises(UsageError, match=r"with mechanism.* tells no 'R_Z'"):
        list(outcomes.outcomes(task))


def test_the_text_is_read_once_for_all_points(spec: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    task = task_of(spec, [f"{CRANK}=180 mm:220 mm:3", "mechanism.grid.positions=12"], None, ("feasibility",), ())
    read: list[str] = []
    real = Variants.__init__
    monkeypatch.setattr(Variants, "__init__", lambda self, *given: read.append(given[1]) or real(self, *given))
    assert len(list(outcomes.outcomes(task))) == 3
    assert len(read) == 2  # by what chooses the way, and for the points
