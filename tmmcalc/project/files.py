"""Files that a spec names: tables in CSV, and files that rooms read themselves, such as a catalogue.

Which keys name a file is said in the manifests; their paths count from the folder of the spec. A table is two columns
under a header ``name[unit]``, separated by commas, semicolons or tabs:

    phi[deg],Q[N]
    0,0
    30,1500

Of a file with more columns the key ``columns`` names two; labels of positions, ``i``, are passed over.

Its values take their place in the document as numbers in SI, so that checks, tables and hashes see them as if they
stood in the spec. Blank lines, and lines that begin with ``#``, are passed over.
"""

from __future__ import annotations

from importlib import import_module
from pathlib import Path as FilePath
from typing import TYPE_CHECKING, Any

from tmmcalc.core.files import other_kind, read_file
from tmmcalc.project.filekeys import TABLE, keys, places
from tmmcalc.spec.csvtables import CHOICE, FileError, Form, are_numbers, cells, columns_of
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Raw, Rows, word
from tmmcalc.spec.phrases import Path, show
from tmmcalc.spec.units import UnitError

if TYPE_CHECKING:
    from tmmcalc.project.root import Spec

MOST_BYTES = 10_000_000
MOST_ROWS = 100_000
MOST_SIGNS = 1000  # of a line
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
            if key == TABLE and CHOICE in table and TABLE not in table:
                found.append(Finding((*path, CHOICE), f"{CHOICE} without file: of which table", 'add file = "x.csv"'))
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
        columns = columns_of(header, word(table, "of", "angle"), number, form, word(table, CHOICE))
    except FileError as fault:
        return None, [fault]
    pairs: dict[int, tuple[float, float]] = {}  # by the line
    for line, row in body:
        try:
            pair = columns.pair(row)
        except UnitError as error:
            faults.append(FileError(line, error.message, error.remedy))
        else:
            # a position has two rows where some column jumps: of one that does not they are the same
            if not pairs or pair != next(reversed(pairs.values())):
                pairs[line] = pair
    along = form.by_name is None and "angle" in form.x and word(table, "of", "angle") == "angle"
    if along and pairs and max(at for at, _ in pairs.values()) <= 0:
        # phi falls where the input turns clockwise; a table counts along the motion
        pairs = {line: (0.0 - at, value) for line, (at, value) in pairs.items()}
    for line, row in body:
        if line in pairs and pairs[line][0] < 0:
            negative = columns.negative(row)
            faults.append(FileError(line, negative.message, negative.remedy))
    faults.sort(key=lambda fault: fault.line)
    if not faults and len(pairs) < 2:
        faults.append(FileError(number, "fewer than two rows under the header", "write one row for each x"))
    if faults:
        return None, faults
    if form.by_name:
        table[columns.key] = [[*pair] for pair in pairs.values()]
    else:
        at, table[columns.key] = map(list, zip(*pairs.values(), strict=True))
        table[form.key] = [f"{angle!r} rad" for angle in at] if form.turns else at
    return Rows(table["file"], [*pairs], f"1 {columns.x.unit}" if columns.x.unit else ""), []


def _absent(file: FilePath) -> list[FileError]:
    try:
        there, size = file.exists(), file.stat().st_size
    except (OSError, ValueError):
        there, size = False, 0
    if kind := other_kind(file):
        return [FileError(0, f"{show(str(file))} is {kind}, not a file", "name a CSV file")]
    if not there:
        return [FileError(0, f"there is no file {show(str(file))}", "its path counts from the folder of the spec")]
    if size > MOST_BYTES:
        return [FileError(0, f"{file} is larger than {MOST_BYTES // 10**6} MB", "thin it out")]
    return []


def _lines(file: FilePath, form: Form) -> list[tuple[int, str]]:
    """Return the lines that hold something, each with its number."""
    try:
        text = read_file(file, MOST_BYTES).decode("utf-8-sig")
    except UnicodeDecodeError:
        raise FileError(0, f"{file} is not UTF-8 text", "save it as CSV in UTF-8") from None
    except OSError as error:
        raise FileError(0, f"{file} cannot be read: {error.strerror}", "check its permissions") from None
    held = [(n, line) for n, line in enumerate(text.split("\n"), 1) if line.strip() and line.lstrip()[0] != "#"]
    if not held:
        raise FileError(0, f"{file} is empty", form.example)
    if len(held) > MOST_ROWS + 1:
        raise FileError(0, f"{file} has {len(held)} rows, more than {MOST_ROWS}", "thin it out")
    if long := next((n for n, line in held if len(line) > MOST_SIGNS), 0):
        raise FileError(long, f"a row of more than {MOST_SIGNS} characters", "write one row for each x, a line each")
    return held
