"""Files that a spec names: CSV tables of loads, of a torque diagram, of laws of motion; a catalogue of motors.

Their paths count from the folder of the spec. A table is two columns under a header ``name[unit]``, separated by
commas, semicolons or tabs:

    phi[deg],Q[N]
    0,0
    30,1500

Its values take their place in the document as numbers in SI, so that checks, tables and hashes see them as if they
stood in the spec. Blank lines, and lines that begin with ``#``, are passed over.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path as FilePath
from typing import TYPE_CHECKING, Any, NamedTuple

from .checks.outline import Raw, subtable, tables, word
from .findings import Finding
from .phrases import Path, either, show
from .quantities import Number
from .units import UnitError, dimension_of, parse

if TYPE_CHECKING:
    from .root import Spec

LARGEST_FILE = 10_000_000  # bytes
_MOST_FAULTS = 10  # of one file; the rest is counted
_HEADER = re.compile(r"(.*?)\s*(?:\[\s*(.*?)\s*\])?")
_DECIMAL = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?", re.ASCII)
_COUNTED = {"position": "numbers of positions", "stroke": "parts of the stroke"}  # x without a unit
_PLAIN = ("", "-", "1")  # how a header says that


class _Form(NamedTuple):
    """What a table is of: its words, the key and the dimensions of x, the dimensions of the values."""

    noun: str
    key: str
    x: tuple[str, ...]  # an empty word among them: plain numbers
    values: tuple[str, ...]
    example: str

    @property
    def keys(self) -> set[str]:
        """Keys of the table that the file stands in place of."""
        return {self.key, *self.values} if self is not _LAW else {"points"}


_LOAD = _Form("a load", "x", ("angle", "length"), ("force", "moment"), "write a header such as phi[deg],Q[N]")
_TORQUE = _Form("a torque diagram", "theta", ("angle",), ("moment",), "write a header such as theta[deg],M[N*m]")
_FORCE = _Form("a force on a cam", "phi", ("angle",), ("force", "moment"), "write a header such as phi[deg],Q[N]")
_LAW = _Form(
    "a law of motion", "k", ("angle", ""), ("length", "angle", ""), "write a header such as k,s or phi[deg],s[mm]"
)
LAW_KEYS = ("law", "rise_law", "return_law")  # of [cam]


class Rows(NamedTuple):
    """What was read: the file as the spec names it, the line of each row, and one of the unit of x."""

    file: str
    lines: list[int]
    unit: str  # such as "1 deg"; empty for plain numbers


class _FileError(Exception):
    """A fault of a file: its line, what is wrong, what to write instead."""

    def __init__(self, line: int, message: str, remedy: str) -> None:
        self.line, self.message, self.remedy = line, message, remedy
        super().__init__(message)


class _Column(NamedTuple):
    """The unit of a column and its dimension, both empty for plain numbers."""

    unit: str
    dimension: str

    def is_of(self, dimensions: tuple[str, ...]) -> bool:
        """Whether it is of one of the dimensions; an unknown unit is of none."""
        return self.dimension in dimensions and bool(self.unit) == bool(self.dimension)

    def read(self, cell: str) -> float:
        """Return a number of the column in SI; raise UnitError if it is none."""
        text = cell.replace("−", "-")
        if not _DECIMAL.fullmatch(text):
            comma = re.fullmatch(r"([+-]?\d+),(\d+)", text)
            remedy = f"write a decimal point: {comma[1]}.{comma[2]}" if comma else "write a number without its unit"
            raise UnitError(f"{show(cell)} is not a number", remedy)
        return parse(f"{text} {self.unit}", self.dimension) if self.unit else Number("a number", "1").read(float(text))


def read_files(data: Raw, folder: FilePath) -> tuple[list[Finding], dict[Path, Rows]]:
    """Put the values of every CSV table, and the place of the catalogue, into the document.

    Returns the faults of the files, and what was read by the place of its table.
    """
    found: list[Finding] = []
    rows: dict[Path, Rows] = {}
    for path, table, form in _tables(data):
        if isinstance(table.get("file"), str) and not form.keys & {*table}:
            read, faults = _read_table(table, folder, form)
            found += _findings(table["file"], faults, (*path, "file"))
            if read is not None:
                rows[path] = read
    motor = subtable(data, "motor")
    if isinstance(motor.get("catalogue"), str):
        absent = _absent(folder / motor["catalogue"])
        found += _findings(motor["catalogue"], absent, ("motor", "catalogue"))
        motor["catalogue"] = str(folder / motor["catalogue"])
    return found, rows


def named_files(spec: Spec, folder: FilePath) -> list[FilePath]:
    """Return the files that a spec from this folder was read with: its tables, its catalogue."""
    curves: list[Any] = [load.table for load in spec.loads]
    curves.append(spec.torque.table if spec.torque is not None else None)
    if spec.cam is not None:
        curves += [getattr(spec.cam, key) for key in LAW_KEYS]
        curves.append(spec.cam.loads.force_table if spec.cam.loads is not None else None)
    names = [curve.file for curve in curves if curve is not None and not isinstance(curve, str)]
    catalogue = spec.motor.catalogue if spec.motor is not None else None
    found = [folder / name for name in names if name is not None]
    return list(dict.fromkeys([*found, *([FilePath(catalogue)] if catalogue is not None else [])]))


def _tables(data: Raw) -> Iterator[tuple[Path, Raw, _Form]]:
    for index, load in tables(data, "loads"):
        yield ("loads", index, "table"), subtable(load, "table"), _LOAD
    yield ("torque", "table"), subtable(subtable(data, "torque"), "table"), _TORQUE
    cam = subtable(data, "cam")
    for key in LAW_KEYS:
        yield ("cam", key), subtable(cam, key), _LAW
    yield ("cam", "loads", "force_table"), subtable(subtable(cam, "loads"), "force_table"), _FORCE


def _findings(file: str, faults: list[_FileError], path: Path) -> list[Finding]:
    shown = [
        Finding(path, f"{file}, line {f.line}: {f.message}" if f.line else f.message, f.remedy)
        for f in faults[:_MOST_FAULTS]
    ]
    more = len(faults) - len(shown)
    return [*shown, Finding(path, f"{file}: {more} more faults", "mend these first")] if more else shown


def _read_table(table: Raw, folder: FilePath, form: _Form) -> tuple[Rows | None, list[_FileError]]:
    """Put x and the values of a file into its table."""
    file = folder / table["file"]
    if faults := _absent(file):
        return None, faults
    try:
        (number, header), *body = _lines(file, form)
        separator = next((sign for sign in ";\t" if sign in header), ",")
        x, y = _columns(_cells(header, separator), word(table, "of", "angle"), number, form)
    except _FileError as fault:
        return None, [fault]
    pairs: list[tuple[float, float]] = []
    for line, text in body:
        try:
            pairs.append(_pair(_cells(text, separator), x, y))
        except UnitError as error:
            faults.append(_FileError(line, error.message, error.remedy))
    if not faults and len(pairs) < 2:
        faults.append(_FileError(number, "fewer than two rows under the header", "write one row for each x"))
    if faults:
        return None, faults
    if form is _LAW:
        table["points"] = [[*pair] for pair in pairs]
    else:
        at, table[y.dimension] = map(list, zip(*pairs, strict=True))
        # an angle beyond a turn has to say that it is one; of loads x may be a length or a plain number
        table[form.key] = [f"{angle!r} rad" for angle in at] if form in (_TORQUE, _FORCE) else at
    return Rows(table["file"], [line for line, _ in body], f"1 {x.unit}" if x.unit else ""), []


def _absent(file: FilePath) -> list[_FileError]:
    try:
        there, size = file.is_file(), file.stat().st_size
    except (OSError, ValueError):
        there, size = False, 0
    if not there:
        return [_FileError(0, f"there is no file {show(str(file))}", "its path counts from the folder of the spec")]
    if size > LARGEST_FILE:
        return [_FileError(0, f"{file} is larger than {LARGEST_FILE // 10**6} MB", "thin it out")]
    return []


def _lines(file: FilePath, form: _Form) -> list[tuple[int, str]]:
    """Return the lines that hold something, each with its number."""
    try:
        text = file.read_text("utf-8-sig")
    except UnicodeDecodeError:
        raise _FileError(0, f"{file} is not UTF-8 text", "save it as CSV in UTF-8") from None
    except OSError as error:
        raise _FileError(0, f"{file} cannot be read: {error.strerror}", "check its permissions") from None
    held = [(n, line) for n, line in enumerate(text.split("\n"), 1) if line.strip() and line.lstrip()[0] != "#"]
    if not held:
        raise _FileError(0, f"{file} is empty", form.example)
    return held


def _cells(line: str, separator: str) -> list[str]:
    return [cell.strip().strip('"').strip() for cell in line.split(separator)]


def _columns(header: list[str], of: str, line: int, form: _Form) -> tuple[_Column, _Column]:
    """Return the columns of x and of the values; raise _FileError if the header does not name them."""
    if len(header) != 2:
        count = f"{len(header)} column{'s' if len(header) != 1 else ''}"
        raise _FileError(line, f"{count}; a table of {form.noun} has two, {form.key} and the values", form.example)
    x, y = (_column(cell) for cell in header)
    if of in _COUNTED and x.unit:
        what = _COUNTED[of]
        raise _FileError(line, f"{show(header[0])} has a unit; x are {what}", "write a name without unit, such as i")
    if of not in _COUNTED and not x.is_of(form.x):
        raise _not_of(header[0], form.x, line, form)
    if not y.is_of(form.values):
        raise _not_of(header[1], form.values, line, form)
    return x, y


def _not_of(name: str, dimensions: tuple[str, ...], line: int, form: _Form) -> _FileError:
    kinds = either(f"{dimension}s" for dimension in dimensions if dimension)
    plain = ", or of numbers without one" if "" in dimensions else ""
    return _FileError(line, f"{show(name)} is not a column of {kinds} with its unit{plain}", form.example)


def _column(cell: str) -> _Column:
    match = _HEADER.fullmatch(cell)
    unit = (match[2] if match else None) or ""
    return _Column("", "") if unit in _PLAIN else _Column(unit, dimension_of(f"1 {unit}") or "")


def _pair(cells: list[str], x: _Column, y: _Column) -> tuple[float, float]:
    if len(cells) != 2:
        raise UnitError(
            f"{len(cells)} value{'s' if len(cells) != 1 else ''} in a table of two columns", "write x, value"
        )
    at, value = x.read(cells[0]), y.read(cells[1])
    if at < 0:
        raise UnitError(f"{show(cells[0])} is negative; x counts from 0", "write it without the minus")
    return at, value
