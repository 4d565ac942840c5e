"""The table of a sweep, one row a point in their order, and ``FILE.toml`` beside it, which vouches for it.

It is a tidy CSV, or by the suffix of its file Parquet, with the same headers.
"""

from __future__ import annotations

import csv
import io
import tomllib
from array import array
from collections.abc import Iterable, Iterator, Sequence
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmmcalc._version import __version__
from tmmcalc.batch.table import is_key
from tmmcalc.batch.task import OK, Row, Task
from tmmcalc.core.atomic import replace_file
from tmmcalc.core.errors import UsageError
from tmmcalc.core.files import read_file
from tmmcalc.core.headers import key_and_unit
from tmmcalc.core.quantity import truths
from tmmcalc.core.records import record
from tmmcalc.naming.language import parse, rank
from tmmcalc.naming.meanings import described
from tmmcalc.pipeline.manifest import seal
from tmmcalc.report.parquet import Field, check_pyarrow, parquet_bytes, read_parquet
from tmmcalc.rooms import STAGES

_HEAD = "# Written by tmmcalc sweep. If the {} is changed by hand it is made again.\n\n"
PARQUET = ".parquet"  # suffix of its files; any other is of CSV
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

    def to_frame(self, library: str | None = None) -> Any:
        """A row a point of a frame of ``pandas`` or ``polars`` (None: of the first that is installed).

        Its columns have the headers of the CSV. Raises `UsageError` where the library is not installed.
        """
        from tmmcalc.report.frames import frame

        return frame({field.header: field.plain for field in _fields(self)}, library)


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
    """Write the table and what vouches for it, the latter last; each in one step."""
    import tomli_w

    form, data = ("Parquet", parquet_bytes(_fields(sheet))) if is_parquet(file) else ("CSV", csv_bytes(sheet))
    replace_file(file, data)
    whole = seal(data)
    told = {"program": __version__, "hash": key, "points": len(sheet.status), "failed": sheet.failed}
    content = {"sweep": told, "file": {"size": whole.size, "sha256": whole.sha256}}
    replace_file(voucher(file), (_HEAD.format(form) + tomli_w.dumps(content)).encode())


def current(task: Task, key: str, file: Path) -> Sheet | None:
    """The sheet in the file if it is that of this very task and nobody has changed it."""
    try:
        content: Any = tomllib.loads(read_file(voucher(file)).decode())
        data = read_file(file)
        whole = seal(data)
        same = content["sweep"]["hash"] == key and content["file"] == {"size": whole.size, "sha256": whole.sha256}
    except (OSError, ValueError, KeyError, TypeError):
        return None
    if not same:
        return None
    return _read_parquet(task, data) if is_parquet(file) else _read(task, data)


def is_parquet(file: Path) -> bool:
    """Whether the table in a file is Parquet, by its suffix."""
    return file.suffix.lower() == PARQUET


def check_form(file: Path) -> None:
    """Raise `UsageError` for a suffix of another form, and where what writes this one is not installed."""
    if file.suffix.lower() in (".xlsx", ".json", ".toml"):
        raise UsageError(
            f"{file.name}: a sweep is written as CSV or Parquet", where="-o", remedy="name a file .csv or .parquet"
        )
    if is_parquet(file):
        check_pyarrow()


def voucher(file: Path) -> Path:
    """The file beside the table that says what it was made of."""
    return file.with_name(f"{file.name}.toml")


def csv_bytes(sheet: Sheet) -> bytes:
    """The sheet as CSV: numbers at full round-trip precision, empty cells where there is none."""
    buffer = io.StringIO()
    writer = csv.writer(buffer, lineterminator="\n")
    writer.writerow((*sheet.keys, *sheet.names, *_LAST))
    rows = zip(sheet.given, sheet.values, sheet.status, sheet.reasons, strict=True)
    writer.writerows((*given, *_cells(values), status, reason) for given, values, status, reason in rows)
    return buffer.getvalue().encode()


def _fields(sheet: Sheet) -> list[Field]:
    """The columns of a sheet: labels and verdicts are texts, keys and quantities numbers, what is yes or no is so."""
    given = zip(sheet.keys, zip(*sheet.given, strict=True), strict=True)
    keys = (_key(header, cells) if is_key(header) else Field(header, cells) for header, cells in given)
    quantities = (Field(name, column, *_told(name)) for name, column in zip(sheet.names, sheet.values.T, strict=True))
    last = (Field(header, cells) for header, cells in zip(_LAST, (sheet.status, sheet.reasons), strict=True))
    return [*keys, *quantities, *last]


def _key(header: str, cells: Sequence[str]) -> Field:
    return Field(header, np.array(cells, float), {"unit": key_and_unit(header)[1]})


def _told(name: str) -> tuple[dict[str, str], bool]:
    """What a quantity says of itself, unit, meaning and symbol; whether it is yes or no."""
    own = parse(name)
    meaning, symbol = described(own.stage, not own.fact)(own.what.rpartition(".")[2], own.unit or "")
    yes_or_no = own.fact and own.what.rpartition(".")[2] in _truths(own.stage)
    return {"unit": own.unit or "", "meaning": meaning, "symbol": symbol}, yes_or_no


@cache
def _truths(stage: str) -> frozenset[str]:
    return frozenset(key for kind in STAGES[stage].kinds for key in truths(kind))


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


def _read_parquet(task: Task, data: bytes) -> Sheet:
    columns = read_parquet(data)
    first = len(task.labels) + len(task.axes)
    headers = list(columns)
    names, (status, reasons) = headers[first:-2], (columns[header] for header in _LAST)
    values = np.column_stack([columns[name] for name in names]) if names else np.empty((len(status), 0))
    given = tuple(_given(task, point) for point in range(task.count))
    return Sheet(tuple(headers[:first]), tuple(names), given, values, tuple(map(str, status)), tuple(map(str, reasons)))


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
