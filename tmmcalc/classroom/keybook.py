"""``keys.toml`` and ``keys.csv``: the keys of a class, for programs with all digits, for the teacher to read.

The file for programs ends with the digest of all that is before it, so that one that was torn or edited is noticed.
Mistakes stand there by their names; how they are told is what the program says.
"""

from __future__ import annotations

import csv
import hashlib
import io
import math
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from tmmcalc._version import __version__
from tmmcalc.classroom.keying import told_of
from tmmcalc.classroom.model import Item, Key, Keybook, Values
from tmmcalc.core.atomic import blamed_on, replace_file
from tmmcalc.core.errors import UsageError
from tmmcalc.core.files import read_file
from tmmcalc.core.records import names_of

FILE, TABLE = "keys.toml", "keys.csv"
MOST_BYTES = 100_000_000
HEAD = "# Keys of a class, written by tmmcalc class keys. For the teacher alone.\n"
DIGEST = b"\n# SHA-256 of the lines above: "
HEADERS = ("variant", "student", "name", "result", "value", "unit", "tolerance", "also right")
FORMULA = ("=", "+", "-", "@")  # what cells that are worked out begin with
AGAIN = "make the keys again: tmmcalc class keys --fresh"


def write_keybook(book: Keybook, folder: Path) -> tuple[Path, ...]:
    """Write both files into a folder, which is made; each is old or new, never half of one."""
    with blamed_on(folder, "made"):
        folder.mkdir(parents=True, exist_ok=True)
    written = {FILE: toml_bytes(book), TABLE: csv_bytes(book)}
    for name, data in written.items():
        replace_file(folder / name, data)
    return tuple(folder / name for name in written)


def read_keybook(folder: Path) -> Keybook:
    """The keys of a folder; raises UsageError where there are none, or what stands there is damaged."""
    path = folder / FILE
    if not path.is_file():
        raise UsageError(f"there are no keys in {folder}", remedy="make them: tmmcalc class keys")
    with blamed_on(path, "read"):
        data = read_file(path, MOST_BYTES)
    return keybook_of(data, str(path))


def toml_bytes(book: Keybook) -> bytes:
    """The content of ``keys.toml``."""
    import tomli_w

    tables = {
        "version": __version__,
        "mistakes": [each.name for each in book.mistakes],
        "items": [{name: getattr(item, name) for name in names_of(Item) or ()} for item in book.items],
        "keys": [
            {
                "number": key.number,
                "student": key.student,
                "made_of": made_of,
                "values": list(key.values),
                "mistaken": [list(values) for values in key.mistaken],
            }
            for key, made_of in zip(book.keys, book.made_of or [""] * len(book.keys), strict=True)
        ],
    }
    body = (HEAD + tomli_w.dumps(tables)).encode()
    return body + DIGEST + hashlib.sha256(body).hexdigest().encode() + b"\n"


def keybook_of(data: bytes, where: str = FILE) -> Keybook:
    """The keys that ``toml_bytes`` made; raises UsageError if it is not that any more."""
    import tomllib

    body, mark, tail = data.rpartition(DIGEST)
    if not mark or tail != hashlib.sha256(body).hexdigest().encode() + b"\n":
        raise UsageError(f"{where} is damaged or was edited: its last line does not fit", remedy=AGAIN)
    try:
        return _keybook(tomllib.loads(body.decode()))
    except (ValueError, KeyError, TypeError, AttributeError) as error:  # the digest is right: somebody has made it
        raise UsageError(f"{where} holds no keys ({type(error).__name__}: {error})", remedy=AGAIN) from None


def csv_bytes(book: Keybook) -> bytes:
    """The content of ``keys.csv``: a row for every variant and asked result, with the digits that are asked for."""
    text = io.StringIO()
    table = csv.writer(text, lineterminator="\n")
    table.writerow(HEADERS)
    table.writerows(rows_of(book))
    return text.getvalue().encode("utf-8-sig")


def rows_of(book: Keybook) -> Iterator[tuple[Any, ...]]:
    """The rows of `HEADERS`."""
    for key in book.keys:
        for item, value in zip(book.items, key.values, strict=True):
            allowed = significant(max(item.tolerance * abs(value), item.within), 2)
            shown = significant(value, item.digits)
            also = significant(-value, item.digits) if item.either_sense and value else ""
            yield key.number, _text(key.student), _text(item.name), item.result, shown, item.unit, allowed, also


def _text(name: str) -> str:
    """A name as a cell, which no spreadsheet takes for a formula."""
    return f"'{name}" if name.startswith(FORMULA) else name


def significant(value: float, digits: int) -> str:
    """A number with so many significant digits, without a power of ten.

    >>> significant(11956.4, 4), significant(0.82, 4), significant(-2e-4, 2)
    ('11960', '0.8200', '-0.00020')
    """
    if not value:
        return "0"
    decimals = digits - 1 - math.floor(math.log10(abs(value)))
    return f"{round(value, decimals):.{max(decimals, 0)}f}"


def _keybook(tables: Mapping[str, Any]) -> Keybook:
    items = tuple(_item(each) for each in tables["items"])
    mistakes = tuple(map(told_of, tables["mistakes"]))
    keys = tuple(_key(each, len(items), len(mistakes)) for each in tables["keys"])
    return Keybook(items, mistakes, keys, tuple(str(each["made_of"]) for each in tables["keys"]))


def _item(data: Mapping[str, Any]) -> Item:
    whole: dict[str, Any] = {name: tuple(value) if isinstance(value, list) else value for name, value in data.items()}
    return Item(**{name: whole[name] for name in names_of(Item) or ()})


def _key(data: Mapping[str, Any], items: int, mistakes: int) -> Key:
    mistaken = tuple(_values(each, items) for each in data["mistaken"])
    if len(mistaken) != mistakes:
        raise ValueError(f"variant {data['number']} has {len(mistaken)} mistakes of {mistakes}")
    values = _values(data["values"], items)
    if not all(map(math.isfinite, values)):
        raise ValueError(f"variant {data['number']} has no value of an asked result")
    return Key(int(data["number"]), str(data["student"]), values, mistaken)


def _values(data: Any, count: int) -> Values:
    if not isinstance(data, list) or len(data) != count:
        raise ValueError(f"{count} values are asked for")
    return tuple(map(float, data))
