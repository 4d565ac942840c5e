"""Sweeps as Parquet, read back by pyarrow, pandas and polars beside the CSV of the same sweep."""

from __future__ import annotations

import csv
from pathlib import Path

import numpy as np
import pandas as pd
import pytest
import sweeptoy
from pyarrow import parquet

import tmmcalc
from tmmcalc.batch.executors import solve_here
from tmmcalc.batch.sweep import sweep

ROOT = Path(__file__).parents[2]
SHAPER = ROOT / "configs" / "shaper.toml"
RANGES = ("mechanism.links[id=4].points.D[0]=*0.1:1:5", "motion.inertia=20,200")  # the shortest rod is too short
COLUMNS = ("kinematics.*", "forces.max(R_?)", "flywheel.*")


@pytest.fixture(scope="module")
def tables(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The same sweep as ``t.csv`` and ``t.parquet``."""
    folder = tmp_path_factory.mktemp("tables")
    for name in ("t.csv", "t.parquet"):
        tmmcalc.sweep(SHAPER, RANGES, columns=COLUMNS, out=folder / name)
    return folder


def rows(tables: Path) -> tuple[list[str], list[list[str]]]:
    header, *found = csv.reader((tables / "t.csv").read_text().splitlines())
    return header, found


@pytest.mark.slow
def test_every_cell_is_that_of_the_csv(tables: Path) -> None:
    header, expected = rows(tables)
    table = parquet.read_table(tables / "t.parquet")
    assert table.column_names == header
    missing = 0
    for at, column in enumerate(table.columns):
        for cell, text in zip(column.to_pylist(), (row[at] for row in expected), strict=True):
            if isinstance(cell, str):
                assert cell == text
            else:
                assert cell == (float(text) if text else None)
                missing += cell is None
    assert missing
    assert "failed 3" in {row[-2] for row in expected}


def test_types_of_columns(tables: Path) -> None:
    schema = parquet.read_schema(tables / "t.parquet")
    kinds = {field.name: str(field.type) for field in schema}
    assert {name for name, kind in kinds.items() if kind == "string"} == {"status", "reason"}
    truths = {name for name, kind in kinds.items() if kind == "bool"}
    assert {"kinematics.assembles_everywhere", "flywheel.existing_suffices"} <= truths
    assert {kind for name, kind in kinds.items() if name not in truths} == {"double", "string"}


def test_units_and_meanings_stand_in_the_fields(tables: Path) -> None:
    schema = parquet.read_schema(tables / "t.parquet")
    for name, unit in (
        ("mechanism.links[id=4].points.D[0][mm]", b"mm"),
        ("motion.inertia[kg*m^2]", b"kg*m^2"),
        ("kinematics.stroke_D[m]", b"m"),
        ("forces.max(R_A)[N]", b"N"),
    ):
        assert schema.field(name).metadata[b"unit"] == unit
        assert name.startswith(("mechanism", "motion")) or schema.field(name).metadata[b"meaning"]
    assert schema.field("kinematics.K_D").metadata[b"symbol"] == b"K"
    assert schema.field("status").metadata is None


def test_pandas_and_polars_read_it(tables: Path) -> None:
    header, expected = rows(tables)
    frame = pd.read_parquet(tables / "t.parquet")
    assert list(frame.columns) == header
    for at, name in enumerate(header[:-2]):
        plain = [float(row[at]) if row[at] else np.nan for row in expected]
        assert np.array_equal(frame[name].astype(float), plain, equal_nan=True)
    polars = pytest.importorskip("polars")
    again = polars.read_parquet(tables / "t.parquet")
    assert again.columns == header
    assert again["forces.max(R_A)[N]"].null_count() == sum(row[-2] != "ok" for row in expected)


def test_frames_of_a_sweep(tables: Path) -> None:
    sheet = tmmcalc.sweep(SHAPER, RANGES, columns=COLUMNS, out=tables / "t.parquet")
    frame = sheet.to_frame("pandas")
    assert frame.shape == (10, len(sheet.keys) + len(sheet.names) + 2)
    assert frame["motion.inertia[kg*m^2]"].tolist() == [20.0, 200.0] * 5
    assert frame["status"].tolist() == list(sheet.status)


def test_equal_sweeps_give_equal_bytes(tmp_path: Path) -> None:
    for name in ("a.parquet", "b.parquet"):
        sweep(sweeptoy.task(tmp_path), solve_here, tmp_path / name)
    assert (tmp_path / "a.parquet").read_bytes() == (tmp_path / "b.parquet").read_bytes()


def test_labels_of_points_are_texts(tmp_path: Path) -> None:
    (tmp_path / "class.csv").write_text("variant,motion.inertia[kg*m^2]\n01,20\n02,200\n")
    tmmcalc.sweep(SHAPER, points=tmp_path / "class.csv", columns=["motion.delta"], out=tmp_path / "t.parquet")
    assert parquet.read_table(tmp_path / "t.parquet")["variant"].to_pylist() == ["01", "02"]
    assert tmmcalc.sweep(
        SHAPER, points=tmp_path / "class.csv", columns=["motion.delta"], out=tmp_path / "t.parquet"
    ).given == (("01", "20"), ("02", "200"))


@pytest.mark.parametrize("name", ["t.xlsx", "t.json", "t.toml"])
def test_another_form_is_refused_before_the_work(tmp_path: Path, name: str) -> None:
    with pytest.raises(tmmcalc.UsageError, match=f"{name}: a sweep is written as CSV or Parquet"):
        tmmcalc.sweep(SHAPER, RANGES, out=tmp_path / name)
    assert not list(tmp_path.iterdir())


def test_without_pyarrow_nothing_is_computed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("tmmcalc.report.parquet.find_spec", lambda name: None)
    with pytest.raises(tmmcalc.UsageError, match=r"Parquet needs pyarrow, which is not installed\n.*\[parquet\]"):
        tmmcalc.sweep(SHAPER, RANGES, out=tmp_path / "t.parquet")
    assert not list(tmp_path.iterdir())
