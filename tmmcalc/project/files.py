"""Files that a spec names: CSV tables of loads, of a torque diagram, of laws of motion; a catalogue of motors.

Their paths count from the folder of the spec. A table is two columns under a header ``name[unit]``, separated by
commas, semicolons or tabs:

    phi[deg],Q[N]
    0,0
    30,1500

The columns of a law of motion go by their names, and may do without a header.
Its values take their place in the document as numbers in SI, so that checks, tables and hashes see them as if they
stood in the spec. Blank lines, and lines that begin with ``#``, are passed over.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path as FilePath
from typing import TYPE_CHECKING, Any

from tmmcalc.cams.tables.law_columns import NO_HEADER
from tmmcalc.project.filecolumns import FORCE, LAW, LOAD, TORQUE, FileError, Form, are_numbers, cells, columns_of
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Raw, Rows, subtable, tables, word
from tmmcalc.spec.phrases import Path, show
from tmmcalc.spec.units import UnitError

if TYPE_CHECKING:
    from tmmcalc.project.root import Spec

LARGEST_FILE = 10_000_000  # bytes
_MOST_FAULTS = 10  # of one file; the rest is counted
LAW_KEYS = ("law", "rise_law", "return_law")  # of [cam]


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
    curves: list[Any] = [getattr(load, key) for load in spec.loads for key in _load_files()]
    curves.append(spec.torque.table if spec.torque is not None else None)
    if spec.cam is not None:
        curves += [getattr(spec.cam, key) for key in LAW_KEYS]
        curves.append(spec.cam.loads.force_table if spec.cam.loads is not None else None)
    curves.append(spec.indexing.law if spec.indexing is not None else None)
    names = [curve.file for curve in curves if curve is not None and not isinstance(curve, str)]
    catalogue = spec.motor.catalogue if spec.motor is not None else None
    found = [folder / name for name in names if name is not None]
    return list(dict.fromkeys([*found, *([FilePath(catalogue)] if catalogue is not None else [])]))


def _tables(data: Raw) -> Iterator[tuple[Path, Raw, Form]]:
    for index, load in tables(data, "loads"):
        for key in _load_files():
            yield ("loads", index, key), subtable(load, key), LOAD
    yield ("torque", "table"), subtable(subtable(data, "torque"), "table"), TORQUE
    cam = subtable(data, "cam")
    for key in LAW_KEYS:
        yield ("cam", key), subtable(cam, key), LAW
    yield ("cam", "loads", "force_table"), subtable(subtable(cam, "loads"), "force_table"), FORCE
    yield ("indexing", "law"), subtable(subtable(data, "indexing"), "law"), LAW


def _load_files() -> tuple[str, ...]:
    """The keys of loads whose tables may name a file."""
    from tmmcalc.linkage.loadlaws import laws

    return tuple(key for key, law in laws().items() if key in law.files)


def _findings(file: str, faults: list[FileError], path: Path) -> list[Finding]:
    shown = [
        Finding(path, f"{file}, line {f.line}: {f.message}" if f.line else f.message, f.remedy)
        for f in faults[:_MOST_FAULTS]
    ]
    more = len(faults) - len(shown)
    return [*shown, Finding(path, f"{file}: {more} more faults", "mend these first")] if more else shown


def _read_table(table: Raw, folder: FilePath, form: Form) -> tuple[Rows | None, list[FileError]]:
    """Put x and the values of a file into its table."""
    file = folder / table["file"]
    if faults := _absent(file):
        return None, faults
    try:
        rows = _lines(file, form)
        separator = next((sign for sign in ";\t" if sign in rows[0][1]), ",")
        split = [(line, cells(text, separator)) for line, text in rows]
        number, first = split[0]
        header, body = (NO_HEADER, split) if form is LAW and are_numbers(first) else (first, split[1:])
        columns = columns_of(header, word(table, "of", "angle"), number, form)
    except FileError as fault:
        return None, [fault]
    pairs: list[tuple[float, float]] = []
    for line, row in body:
        try:
            pairs.append(columns.pair(row))
        except UnitError as error:
            faults.append(FileError(line, error.message, error.remedy))
    if not faults and len(pairs) < 2:
        faults.append(FileError(number, "fewer than two rows under the header", "write one row for each x"))
    if faults:
        return None, faults
    if form is LAW:
        table[columns.key] = [[*pair] for pair in pairs]
    else:
        at, table[columns.key] = map(list, zip(*pairs, strict=True))
        # an angle beyond a turn has to say that it is one; of loads x may be a length or a plain number
        table[form.key] = [f"{angle!r} rad" for angle in at] if form in (TORQUE, FORCE) else at
    return Rows(table["file"], [line for line, _ in body], f"1 {columns.x.unit}" if columns.x.unit else ""), []


def _absent(file: FilePath) -> list[FileError]:
    try:
        there, size = file.is_file(), file.stat().st_size
    except (OSError, ValueError):
        there, size = False, 0
    if not there:
        return [FileError(0, f"there is no file {show(str(file))}", "its path counts from the folder of the spec")]
    if size > LARGEST_FILE:
        return [FileError(0, f"{file} is larger than {LARGEST_FILE // 10**6} MB", "thin it out")]
    return []


def _lines(file: FilePath, form: Form) -> list[tuple[int, str]]:
    """Return the lines that hold something, each with its number."""
    try:
        text = file.read_text("utf-8-sig")
    except UnicodeDecodeError:
        raise FileError(0, f"{file} is not UTF-8 text", "save it as CSV in UTF-8") from None
    except OSError as error:
        raise FileError(0, f"{file} cannot be read: {error.strerror}", "check its permissions") from None
    held = [(n, line) for n, line in enumerate(text.split("\n"), 1) if line.strip() and line.lstrip()[0] != "#"]
    if not held:
        raise FileError(0, f"{file} is empty", form.example)
    return held
