"""What ``tmmcalc.run`` gives back: the names of the command line, frames, summaries and pictures for notebooks."""

from __future__ import annotations

import copy
import csv
import io
import json
import re
from html.parser import HTMLParser
from pathlib import Path

import numpy as np
import openpyxl
import pandas as pd
import pytest

import tmmcalc

SHAPER = Path(__file__).parents[1] / "configs" / "shaper.toml"
HOSTILE = "</script><script>alert(1)"


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("run")


@pytest.fixture(scope="module")
def run(folder: Path) -> tmmcalc.Run:
    return tmmcalc.run(tmmcalc.load_spec(SHAPER), out=folder)


def columns(folder: Path, stage: str) -> dict[str, np.ndarray]:
    """The CSV that the same run has left."""
    header, *rows = csv.reader(io.StringIO((folder / f"{stage}.csv").read_text()))
    cells = dict(zip(header, zip(*rows, strict=True), strict=True))
    return {name: np.array(column, float) for name, column in cells.items() if name != "i"}


def test_names_are_those_of_the_tables(run: tmmcalc.Run, folder: Path) -> None:
    forces = columns(folder, "forces")
    assert run["forces.max(R_A)"] == forces["R_A[N]"].max()
    assert run.value("forces.R_A@6") == forces["R_A[N]"][6]
    assert np.array_equal(run["forces.R_A"], forces["R_A[N]"])
    assert np.array_equal(run.forces.R_A, forces["R_A[N]"])
    assert run.forces["max(R_A)"] == run["forces"]["forces.max(R_A)"] == forces["R_A[N]"].max()
    assert run["max(R_A)"] == forces["R_A[N]"].max()


def test_facts_are_those_of_the_documents(run: tmmcalc.Run) -> None:
    solved = tmmcalc.solve_flywheel(tmmcalc.load_spec(SHAPER))
    assert run.flywheel.delta == solved.delta
    assert run.kinematics.trace.r.shape == (5, 25)
    assert run.kinematics.stroke_D == run["kinematics.stroke_D"] == run.kinematics.record.summaries[0].stroke
    assert run.structure.formula == "I(0,1) -> II RPR(2,3) -> II RRP(4,5)"
    assert run.flywheel.existing_suffices is True
    told = run.tell("kinematics.vS_D[phi=50 deg]")
    assert (told.unit, told.how) == ("m/s", "computed there")
    table = tmmcalc.run(tmmcalc.load_spec(SHAPER, ["mechanism.grid.positions=36"]), target="kinematics")
    assert told.value == pytest.approx(table.value("kinematics.vS_D@5"), rel=1e-12)


def test_names_by_pattern(run: tmmcalc.Run) -> None:
    assert run.names("motion.delta*") == ["motion.delta", "motion.delta_idle", "motion.delta_textbook"]
    assert run.names("forces.max(R_A)") == ["forces.max(R_A)[N]"]
    assert "kinematics.vS_D[m/s]" in run.names()
    for name in run.names("motion.*")[:20]:
        assert np.all(np.isfinite(run[name]))


def test_what_is_not_there_is_told(run: tmmcalc.Run) -> None:
    with pytest.raises(AttributeError, match="this run has no stage 'train'; it has structure, kinematics"):
        _ = run.train
    with pytest.raises(AttributeError, match=r"tells no 'dleta'\n.*did you mean delta"):
        _ = run.motion.dleta
    with pytest.raises(tmmcalc.UsageError, match=r"tells no 'R_Z'\n.*did you mean R_"):
        _ = run["forces.max(R_Z)"]
    with pytest.raises(tmmcalc.UsageError, match="is a column: it has a value at every row"):
        run.value("forces.R_A")


def test_frames_of_stages(run: tmmcalc.Run, folder: Path) -> None:
    frame = run.kinematics.to_frame()
    assert isinstance(frame, pd.DataFrame)
    expected = columns(folder, "kinematics")
    assert list(frame.columns) == ["i", *expected]
    assert frame["i"].tolist() == list(range(25))
    for name, values in expected.items():
        assert np.array_equal(frame[name], values)
    with pytest.raises(tmmcalc.UsageError, match="structure has no table"):
        run.structure.to_frame()
    polars = pytest.importorskip("polars")
    again = run.kinematics.to_frame("polars")
    assert isinstance(again, polars.DataFrame)
    assert np.array_equal(again["vS_D[m/s]"].to_numpy(), expected["vS_D[m/s]"])


def test_the_frame_of_a_run(run: tmmcalc.Run) -> None:
    frame = run.to_frame("pandas")
    assert list(frame.columns) == ["stage", "name", "symbol", "value", "unit", "meaning"]
    for stage, name, value in zip(frame["stage"], frame["name"], frame["value"], strict=True):
        assert run[f"{stage}.{name}"] == value


@pytest.mark.parametrize(
    ("library", "there", "said"),
    [
        (None, (), r"frames need pandas or polars, and neither is installed\n.*pip install pandas"),
        ("polars", ("pandas",), r"frames need polars, which is not installed\n.*pip install polars"),
        ("dask", ("pandas",), r"there are no frames of 'dask'\n.*choose pandas or polars"),
    ],
)
def test_without_the_library_of_frames(
    run: tmmcalc.Run, monkeypatch: pytest.MonkeyPatch, library: str | None, there: tuple[str, ...], said: str
) -> None:
    monkeypatch.setattr("tmmcalc.report.frames.find_spec", lambda name: name if name in there else None)
    with pytest.raises(tmmcalc.UsageError, match=said):
        run.kinematics.to_frame(library)


@pytest.mark.slow
def test_a_workbook(run: tmmcalc.Run, tmp_path: Path, folder: Path) -> None:
    run.to_xlsx(tmp_path / "a.xlsx")
    page = openpyxl.load_workbook(tmp_path / "a.xlsx")["forces"]
    header = [cell.value for cell in page[1]]
    at = header.index("R_A[N]")
    found = [row[at] for row in page.iter_rows(2, 26, values_only=True)]
    assert found == columns(folder, "forces")["R_A[N]"].tolist()


class _Elements(HTMLParser):
    """Elements and text of a piece of HTML; every element that is begun is ended."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.elements: set[str] = set()
        self.text = ""
        self._open: list[str] = []
        self.feed(text)
        assert self._open == []

    def handle_starttag(self, tag: str, attrs: object) -> None:
        self.elements.add(tag)
        if tag != "br":
            self._open.append(tag)

    def handle_endtag(self, tag: str) -> None:
        assert self._open.pop() == tag

    def handle_data(self, data: str) -> None:
        self.text += data


def test_summaries_for_notebooks(run: tmmcalc.Run) -> None:
    whole, stage = _Elements(run._repr_html_()), _Elements(run.motion._repr_html_())
    assert whole.elements == {"div", "strong", "details", "summary", "table", "thead", "tr", "th", "td", "p", "br"}
    for word in ("Shaper", "kinematics", "0.6580645", "overload"):
        assert word in whole.text
    assert "0.07148732" in stage.text


def test_hostile_titles_stay_texts() -> None:
    text = SHAPER.read_text().replace('title = "Shaper"', f"title = {json.dumps(HOSTILE)}")
    text = text.replace('name = "crank"', 'name = "<img src=x onerror=alert(1)>"')
    run = tmmcalc.run(tmmcalc.parse_spec(text), target="kinematics")
    page = _Elements(run._repr_html_())
    assert HOSTILE in page.text
    assert {"script", "img"}.isdisjoint(page.elements)
    svg = run._repr_svg_()
    assert svg is not None
    assert "<script" not in svg
    assert "<img" not in svg


def test_pictures_for_notebooks(run: tmmcalc.Run) -> None:
    svg = run.balance._repr_svg_()
    assert svg is not None
    assert re.search(r"<svg[^>]*>", svg)
    assert run.power._repr_svg_() is None  # has no picture


def test_a_run_can_be_copied_and_looked_at(run: tmmcalc.Run) -> None:
    assert copy.copy(run).motion.delta == run.motion.delta
    assert {"kinematics", "value", "names"} <= set(dir(run))
    assert {"trace", "to_frame"} <= set(dir(run.kinematics))
    assert repr(run.kinematics).startswith("<kinematics: positions")
    assert not hasattr(run, "_repr_png_")
    assert not hasattr(run.kinematics, "_repr_png_")


def test_a_stage_that_failed_says_so() -> None:
    from tmmcalc.pipeline.runner import run as run_on

    spec = tmmcalc.load_spec(SHAPER, ["mechanism.links[id=1].points.A[0]=0.7"])
    failed = tmmcalc.Run(**vars(run_on(spec, keep_going=True)))
    assert failed.failures
    stage = next(iter(failed.failures))
    with pytest.raises(AttributeError, match=f"{stage} has no result"):
        getattr(failed, stage)
    assert f"{stage} failed" in failed._repr_html_()
