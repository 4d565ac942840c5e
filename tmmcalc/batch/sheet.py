"""The tidy CSV of a sweep, one row a point in their order, and ``FILE.toml`` beside it, which vouches for it."""

from __future__ import annotations

import csv
import io
import tomllib
from array import array
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmmcalc._version import __version__
from tmmcalc.batch.task import OK, Row, Task
from tmmcalc.core.atomic import replace_file
from tmmcalc.core.files import read_file
from tmmcalc.core.records import record
from tmmcalc.naming.language import rank
from tmmcalc.pipeline.manifest import seal
from tmmcalc.rooms import STAGES

_HEAD = "# Written by tmmcalc sweep. If the CSV is changed by hand it is made again.\n\n"
_LAST = ("status", "reason")


@record
class Sheet:
    """All points in their order."""

    keys: tuple[str, ...]  # headers of the labels and of the keys
    names: tuple[str, ...]  # headers of the quantities
    given: tuple[tuple[str, ...], ...]  # cells of labels and keys, a tuple a point
    values: NDArray[np.float64]  # (points, quantities); NaN inside the program where a point has no value
    status: tuple[str, ...]
    reasons: tuple[str, ...]

    @property
    def failed(self) -> int:
        """Number of points without all that was asked."""
        return sum(status != OK for status in self.status)


def sheet_of(task: Task, rows: Iterable[Row]) -> Sheet:
    """The sheet of a task whose points are all done, in any order."""
    ordered = sorted(rows, key=lambda row: row.point)
    names = _names(ordered, task.patterns)
    place = {name: at for at, name in enumerate(names)}
    values = np.full((len(ordered), len(names)), np.nan)
    places: dict[tuple[str, ...], list[int]] = {}
    for at, row in enumerate(ordered):
        if row.names not in places:
            places[row.names] = [place[name] for name in row.names]
        values[at, places[row.names]] = row.values
    keys = (*(name for name, _ in task.labels), *(axis.name for axis in task.axes))
    given = tuple(_given(task, row.point) for row in ordered)
    return Sheet(keys, names, given, values, tuple(r.status for r in ordered), tuple(r.reason for r in ordered))


def rows_of(sheet: Sheet) -> Iterator[Row]:
    """The points of a sheet; how they were solved it does not tell."""
    shared: dict[tuple[str, ...], tuple[str, ...]] = {}  # a thousand variants have the names of one
    names = np.array(sheet.names, object)
    for point, (values, status, reason) in enumerate(zip(sheet.values, sheet.status, sheet.reasons, strict=True)):
        there = ~np.isnan(values)
        own = tuple(names[there])
        yield Row(point, status, reason, shared.setdefault(own, own), array("d", values[there].tolist()))


def save(sheet: Sheet, key: str, file: Path) -> None:
    """Write the CSV and what vouches for it, the latter last; each in one step."""
    import tomli_w

    data = csv_bytes(sheet)
    replace_file(file, data)
    whole = seal(data)
    told = {"program": __version__, "hash": key, "points": len(sheet.status), "failed": sheet.failed}
    content = {"sweep": told, "file": {"size": whole.size, "sha256": whole.sha256}}
    replace_file(voucher(file), (_HEAD + tomli_w.dumps(content)).encode())


def current(task: Task, key: str, file: Path) -> Sheet | None:
    """The sheet in the file if it is that of this very task and nobody has changed it."""
    try:
        content: Any = tomllib.loads(read_file(voucher(file)).decode())
        data = read_file(file)
        whole = seal(data)
        same = content["sweep"]["hash"] == key and content["file"] == {"size": whole.size, "sha256": whole.sha256}
    except (OSError, ValueError, KeyError, TypeError):
        return None
    return _read(task, data) if same else None


def voucher(file: Path) -> Path:
    """The file beside the CSV that says what it was made of."""
    return file.with_name(f"{file.name}.toml")


def csv_bytes(sheet: Sheet) -> bytes:
    """The sheet as CSV: numbers at full round-trip precision, empty cells where there is none."""
    buffer = io.StringIO()
    writer = csv.writer(buffer, lineterminator="\n")
    writer.writerow((*sheet.keys, *sheet.names, *_LAST))
    rows = zip(sheet.given, sheet.values, sheet.status, sheet.reasons, strict=True)
    writer.writerows((*given, *_cells(values), status, reason) for given, values, status, reason in rows)
    return buffer.getvalue().encode()


def _cells(values: NDArray[np.float64]) -> Iterator[str]:
    return (repr(value) if value == value else "" for value in values.tolist())


def _given(task: Task, point: int) -> tuple[str, ...]:
    """Cells of labels and keys, the numbers as the override has them."""
    return (
        *(texts[point] for _, texts in task.labels),
        *(axis.number(value) for axis, value in zip(task.axes, task.values(point), strict=True)),
    )


def _names(rows: Sequence[Row], patterns: Sequence[str]) -> tuple[str, ...]:
    """All names, in the order of the patterns or of the stages; a point may tell what another does not."""
    met = dict.fromkeys(name for names in dict.fromkeys(row.names for row in rows) for name in names)
    stages = list(STAGES)
    if patterns:
        return tuple(sorted(met, key=lambda name: rank(name, patterns) or 0))
    return tuple(sorted(met, key=lambda name: stages.index(name.partition(".")[0])))


def _read(task: Task, data: bytes) -> Sheet:
    header, *rows = csv.reader(io.StringIO(data.decode()))
    first = len(task.labels) + len(task.axes)
    values = [[float(cell) if cell else np.nan for cell in row[first:-2]] for row in rows]
    return Sheet(
        tuple(header[:first]),
        tuple(header[first:-2]),
        tuple(tuple(row[:first]) for row in rows),
        np.array(values, float).reshape(len(rows), len(header) - first - 2),
        tuple(row[-2] for row in rows),
        tuple(row[-1] for row in rows),
    )
