"""Files that a spec names: tables in CSV, and files that rooms read themselves, such as a catalogue.

Which keys name a file is said in the manifests; their paths count from the folder of the spec. A table is two columns
under a header ``name[unit]``, separated by commas, semicolons or tabs:

    phi[deg],Q[N]
    0,0
    30,1500

Its values take their place in the document as numbers in SI, so that checks, tables and hashes see them as if they
stood in the spec. Blank lines, and lines that begin with ``#``, are passed over.
"""

from __future__ import annotations

from importlib import import_module
from pathlib import Path as FilePath
from typing import TYPE_CHECKING, Any

from tmmcalc.project.filekeys import TABLE, keys, places
from tmmcalc.spec.csvtables import FileError, Form, are_numbers, cells, columns_of
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Raw, Rows, word
from tmmcalc.spec.phrases import Path, show
from tmmcalc.spec.units import UnitError

if TYPE_CHECKING:
    from tmmcalc.project.root import Spec

LARGEST_FILE = 10_000_000  # bytes
_MOST_FAULTS = 10  # of one file; the rest is counted


def read_files(data: Raw, folder: FilePath) -> tuple[list[Finding], dict[Path, Rows]]:
    """Put the values of every table in CSV, and the places of other files, into the document.

    Returns the faults of the files, and what was read by the place of its table.
    """
    found: list[Finding] = []
    rows: dict[Path, Rows] = {}
    for entry, steps, key in keys():
        for path, table in places(data, entry, steps):
            file = table.get(key)
            if not isinstance(file, str):
                continue
            if key != TABLE:
                found += _findings(file, _absent(folder / file), (*path, key))
                table[key] = str(folder / file)
                continue
            form: Form = import_module(f"{entry.home}.tables.files").FORMS[".".join((entry.name, *steps))]
            if not form.keys & {*table}:
                read, faults = _read_table(table, folder, form)
                found += _findings(file, faults, (*path, key))
                if read is not None:
                    rows[path] = read
    return found, rows


def named_files(spec: Spec, folder: FilePath) -> list[FilePath]:
    """Return the files that a spec from this folder was read with, its tables first."""
    found: list[FilePath] = []
    for entry, steps, key in keys():
        held: Any = getattr(spec, entry.name)
        for table in held if entry.several else [held]:
            for step in (*steps, key):
                table = getattr(table, step, None)
            if isinstance(table, str):
                found.append(folder / table if key == TABLE else FilePath(table))
    return list(dict.fromkeys(found))


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
        named = form.by_name
        header, body = (named.without, split) if named and are_numbers(first) else (first, split[1:])
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
    if form.by_name:
        table[columns.key] = [[*pair] for pair in pairs]
    else:
        at, table[columns.key] = map(list, zip(*pairs, strict=True))
        table[form.key] = [f"{angle!r} rad" for angle in at] if form.turns else at
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
