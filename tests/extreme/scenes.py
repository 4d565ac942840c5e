"""The extreme specs of configs/extreme: run them, and look for numbers that are none in all they leave."""

from __future__ import annotations

import csv
import math
import tomllib
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import tmmcalc
from tmmcalc.pipeline.outcome import RunResult

FOLDER = Path(__file__).parents[2] / "configs" / "extreme"
NAMES = sorted(file.stem for file in FOLDER.glob("*.toml"))
LONG = ("positions-many",)  # some seconds each
MARKED = [pytest.param(name, marks=pytest.mark.slow) if name in LONG else name for name in NAMES]


def solved(name: str, *overrides: str, target: str | None = None) -> RunResult:
    """Run a scene up to a stage; whatever it leaves has to be finite."""
    result = tmmcalc.run(tmmcalc.load_spec(FOLDER / f"{name}.toml", overrides), target=target)
    faults = [fault for stage in result.outcomes for fault in not_finite(result, stage)]
    assert not faults, faults
    return result


def not_finite(result: RunResult, stage: str) -> Iterator[str]:
    """Places in the record and the table of a stage that hold NaN or an infinity."""
    record, table = result.record(stage), result.table(stage)
    for part in (record.scalars, record.error, record.counters):
        yield from (f"{stage}.{place}" for place, value in numbers(part) if not math.isfinite(value))
    columns = dict(zip(table.header, table.columns, strict=True)) if table is not None else {}
    for place, array in {**record.arrays, **columns}.items():
        if array.dtype.kind not in "US" and not np.isfinite(array).all():
            yield f"{stage}.{place}"


def numbers(value: Any, place: str = "") -> Iterator[tuple[str, float]]:
    """All numbers of a nest of tables and lists, with their places."""
    if isinstance(value, Mapping):
        for key, part in value.items():
            yield from numbers(part, f"{place}.{key}")
    elif isinstance(value, list | tuple):
        for index, part in enumerate(value):
            yield from numbers(part, f"{place}.{index}")
    elif isinstance(value, float | np.floating):
        yield place, float(value)


def files_not_finite(folder: Path) -> list[str]:
    """Stage files of a folder that hold NaN or an infinity, in words or in numbers."""
    return [file.name for file in sorted(folder.iterdir()) if file.suffix in READERS and READERS[file.suffix](file)]


def _toml(file: Path) -> bool:
    return any(not math.isfinite(value) for _, value in numbers(tomllib.loads(file.read_text(encoding="utf-8"))))


def _npz(file: Path) -> bool:
    with np.load(file) as arrays:
        return any(a.dtype.kind not in "US" and not np.isfinite(a).all() for a in arrays.values())


def _csv(file: Path) -> bool:
    with file.open(encoding="utf-8", newline="") as lines:
        return any(cell.strip().lower() in {"nan", "inf", "-inf"} for row in csv.reader(lines) for cell in row)


READERS = {".toml": _toml, ".npz": _npz, ".csv": _csv}
