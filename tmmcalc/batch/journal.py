"""``FILE.part``: the finished points of a sweep, appended as they come, so that a killed sweep goes on from there.

    tmmcalc sweep <hash of the task>
    1c291ca3 [1, ["kinematics.stroke_D[m]"]]
    5d3f9b1e [0, "ok", "", 1, [0.658], ""]

A line is a checksum and JSON: names with their number; or a point, its status and reason, the number of its names
(0: none), its values, and why it was solved alone if others were solved together. A line that is torn or changed is
passed over, and its point solved again.
"""

from __future__ import annotations

import json
import os
from array import array
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from types import TracebackType
from typing import Any, BinaryIO
from zlib import crc32

from tmmcalc.batch.task import Row
from tmmcalc.core.atomic import blamed_on
from tmmcalc.core.errors import UsageError
from tmmcalc.core.files import open_own
from tmmcalc.pipeline.lock import locked_at_once

_HEAD = "tmmcalc sweep"
Names = tuple[str, ...]


class Journal:
    """The journal of one task, which its ``key`` tells from any other; locked from first to last.

    Raises UsageError if the file cannot be written or another sweep writes it. At the end a journal without points
    is removed, and so is one that is ``done``.
    """

    def __init__(self, path: Path, key: str) -> None:
        self.path = path
        self.done = False
        self._head = f"{_HEAD} {key}\n".encode()
        with blamed_on(path, "written"):
            self._file: BinaryIO = os.fdopen(open_own(path, os.O_RDWR | os.O_APPEND), "a+b")
            if not locked_at_once(self._file):
                self._file.close()
                raise UsageError(
                    f"{path}: another sweep is writing it", remedy="wait for its end, or choose another file"
                )
            self._numbers, self._rows = self._read()

    def __enter__(self) -> Journal:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, at: TracebackType | None) -> None:
        empty = self._file.seek(0, os.SEEK_END) <= len(self._head)
        self._file.close()
        if self.done or empty:
            self.path.unlink(missing_ok=True)

    def rows(self) -> list[Row]:
        """The points that an earlier run has finished."""
        return self._rows

    def append(self, rows: Iterable[Row]) -> None:
        """Add finished points; they are there even if the next moment kills the process."""
        with blamed_on(self.path, "written"):
            self._file.write(b"".join(line for row in rows for line in self._lines(row)))
            self._file.flush()

    def _lines(self, row: Row) -> Iterator[bytes]:
        if row.names not in self._numbers:
            self._numbers[row.names] = 1 + max(self._numbers.values())
            yield _line([self._numbers[row.names], row.names])
        yield _line([row.point, row.status, row.reason, self._numbers[row.names], list(row.values), row.alone])

    def _read(self) -> tuple[dict[Names, int], list[Row]]:
        """What the file holds of this task; without its torn end, and emptied if it is of another."""
        self._file.seek(0)
        if self._file.readline() != self._head:
            self._file.truncate(0)
            self._file.write(self._head)
            self._file.flush()
            return {(): 0}, []
        named, rows, end = _entries(self._file, len(self._head))
        self._file.truncate(end)
        return {names: number for number, names in named.items()}, rows


def _entries(file: BinaryIO, end: int) -> tuple[dict[int, Names], list[Row], int]:
    """Names by number, points, and where the last whole line ends."""
    named: dict[int, Names] = {0: ()}
    rows: dict[int, Row] = {}
    for line in file:
        entry = _entry(line)
        if line.endswith(b"\n"):
            end += len(line)
        if entry is None:
            continue
        if len(entry) == 2:
            named[entry[0]] = tuple(entry[1])
        elif len(entry) == 6 and entry[3] in named:
            point, status, reason, number, values, alone = entry
            rows[point] = Row(point, status, reason, named[number], array("d", values), alone)
    return named, list(rows.values()), end


def _line(entry: Sequence[Any]) -> bytes:
    text = json.dumps(entry, ensure_ascii=False, separators=(",", ":"), allow_nan=False).encode()
    return b"%08x %s\n" % (crc32(text), text)


def _entry(line: bytes) -> list[Any] | None:
    """What a line holds, None if it is not as it was written."""
    check, _, text = line.rstrip(b"\n").partition(b" ")
    whole = line.endswith(b"\n") and check == b"%08x" % crc32(text)
    found: list[Any] | None = json.loads(text) if whole else None
    return found
