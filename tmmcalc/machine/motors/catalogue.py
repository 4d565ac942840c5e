"""Catalogue of motors: the one that comes with the program, or a CSV file of the user's own.

A row is ``name,power_kW,synchronous_rpm,speed_rpm,overload,start,inertia_kgm2,source``; the last four columns may be
left out, and their cells empty (not known). Semicolons and tabs separate as well as commas. Lines that begin with #
are comments. Every row of the program's catalogue names its source.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import cache
from pathlib import Path

from tmmcalc.core.errors import Fault, SpecError, UsageError
from tmmcalc.core.files import read_file
from tmmcalc.machine.motors.model import Motor

REQUIRED = ("name", "power_kW", "synchronous_rpm", "speed_rpm")
OPTIONAL = ("overload", "start", "inertia_kgm2", "source")
COLUMNS = REQUIRED + OPTIONAL
TEXTS = ("name", "source")

MOST_BYTES = 1_000_000  # of a catalogue: some ten thousand motors

_RPM = math.pi / 30  # [rad/s]
_LOOKALIKES = str.maketrans("АВЕКМНОРСТУХ", "ABEKMHOPCTYX", " -_")


def load_catalogue(path: str | Path | None = None) -> tuple[Motor, ...]:
    """All motors of a CSV file, by default of the program's catalogue, in its order.

    Raises `UsageError` if the file cannot be read, and `SpecError` with every faulty cell and its line.

    >>> len(load_catalogue()) > 100
    True
    """
    if path is None:
        return _packaged()
    try:
        content = read_file(Path(path), MOST_BYTES)
        text = content.decode("utf-8-sig")
    except OSError as error:
        raise UsageError(f"cannot read the motor catalogue {path}: {error.strerror}", where="motor catalogue") from None
    except UnicodeDecodeError:
        remedy = "save it as CSV in UTF-8"
        raise UsageError(f"the motor catalogue {path} is not text in UTF-8", remedy=remedy) from None
    if len(content) > MOST_BYTES:
        limit = f"{MOST_BYTES // 10**6} MB"
        raise UsageError(f"the motor catalogue {path} is larger than {limit}", remedy="keep motors that may be chosen")
    return _parsed(text, str(path))


def find(name: str, catalogue: Sequence[Motor] | None = None) -> Motor:
    """The motor of this name, by default in the program's catalogue.

    Capitals, spaces, hyphens, letters that look alike in Cyrillic, and the mark of climate (U3) do not matter.
    Raises `UsageError` with the nearest names.

    >>> find("4a 132 s4").speed == find("4А132S4У3").speed
    True
    """
    named = _known() if catalogue is None else _named(catalogue)
    key = _key(name)
    motor = named.get(key) or named.get(key[:-2] if key[-2:-1] in {"Y", "U"} else key)
    if motor is not None:
        return motor
    from difflib import get_close_matches  # late: only faults need it

    close = [named[match].name for match in get_close_matches(key, named, 3, 0.6)]
    remedy = f"did you mean {', '.join(close)}?" if close else "give its rated data, or a catalogue of your own"
    raise UsageError(f"the catalogue has no motor {name!r}", where="motor catalogue", remedy=remedy)


def _key(name: str) -> str:
    return name.upper().translate(_LOOKALIKES).replace("AИP", "AIR")


@cache
def _packaged() -> tuple[Motor, ...]:
    file = Path(__file__).with_name("catalogue.csv")
    return _parsed(file.read_text(encoding="utf-8"), file.name)


@cache
def _known() -> dict[str, Motor]:
    return _named(_packaged())


def _named(motors: Sequence[Motor]) -> dict[str, Motor]:
    """The motors by what distinguishes their names, of two alike the first."""
    return {_key(motor.name): motor for motor in reversed(motors)}


def _parsed(text: str, file: str) -> tuple[Motor, ...]:
    (top, header), *rows = _rows(text, file)
    faults = _header(top, header)
    if not rows:
        faults.append(Fault("", top, "no motor follows the header"))
    if faults:
        raise SpecError(file, faults)
    motors: dict[str, tuple[int, Motor]] = {}
    for line, cells in rows:
        motor = _motor(header, line, cells, faults)
        if motor is None:
            continue
        first, _ = motors.setdefault(_key(motor.name), (line, motor))
        if first != line:
            faults.append(Fault("name", line, f"motor {motor.name} stands in line {first} already"))
    if faults:
        raise SpecError(file, faults)
    return tuple(motor for _, motor in motors.values())


def _rows(text: str, file: str) -> list[tuple[int, list[str]]]:
    """The number and the cells of every line that is neither blank nor a comment, the header first."""
    import csv  # late, as all of this module's work: most runs name no catalogue

    lines = [line if not line.lstrip().startswith("#") else "" for line in text.split("\n")]
    header = next(filter(str.strip, lines), "")
    if not header:
        raise SpecError(file, [Fault("", None, "no header", f"begin with {','.join(COLUMNS)}")])
    reader = csv.reader(lines, delimiter=max(",;\t", key=header.count))
    try:
        return [(reader.line_num, [cell.strip() for cell in row]) for row in reader if any(map(str.strip, row))]
    except csv.Error as error:
        raise SpecError(file, [Fault("", reader.line_num, f"not CSV: {error}")]) from None


def _header(line: int, header: list[str]) -> list[Fault]:
    faults = [Fault(name, line, "column is missing") for name in REQUIRED if name not in header]
    for name in header:
        if name not in COLUMNS:
            faults.append(Fault(name, line, "unknown column", f"columns: {', '.join(COLUMNS)}"))
        elif header.count(name) > 1:
            faults.append(Fault(name, line, "column stands twice"))
    return faults


def _motor(header: list[str], line: int, cells: list[str], faults: list[Fault]) -> Motor | None:
    """The motor of one row; None, and its faults added to ``faults``, if it has any."""
    if len(cells) != len(header):
        remedy = "a cell that contains a separator stands in quotes" if len(cells) > len(header) else ""
        faults.append(Fault("", line, f"{len(cells)} cells under {len(header)} columns", remedy))
        return None
    row = dict(zip(header, cells, strict=True))
    wrong = [Fault(name, line, "is empty") for name in REQUIRED if not row[name]]
    numbers: dict[str, float] = {}
    for name, cell in row.items():
        if name in TEXTS or not cell:
            continue
        try:
            numbers[name] = float(cell)
        except ValueError:
            remedy = "write a decimal point" if "," in cell else ""
            wrong.append(Fault(name, line, f"{cell!r} is not a number", remedy))
    if wrong:
        faults.extend(wrong)
        return None
    try:
        return Motor(
            row["name"],
            numbers["power_kW"] * 1000,
            numbers["speed_rpm"] * _RPM,
            numbers["synchronous_rpm"] * _RPM,
            numbers.get("overload"),
            numbers.get("inertia_kgm2"),
            numbers.get("start"),
            source=row.get("source", ""),
        )
    except UsageError as error:
        faults.append(Fault(error.where, line, error.message, error.remedy))
        return None
