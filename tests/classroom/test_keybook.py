"""The file of the keys: every digit comes back, damage is noticed, the table for the teacher opens in a spreadsheet."""

from __future__ import annotations

import csv
import hashlib
import io
import math
from pathlib import Path

import pytest
from mistakes import item

from tmmcalc.classroom.keybook import (
    DIGEST,
    csv_bytes,
    keybook_of,
    read_keybook,
    significant,
    toml_bytes,
    write_keybook,
)
from tmmcalc.classroom.keying import told_of
from tmmcalc.classroom.model import Item, Key, Keybook
from tmmcalc.core.errors import UsageError

NAMES = ("linkage.coriolis_left_out", "linkage.other_assembly:2-3", "classroom.sense_reversed")
BOOK = Keybook(
    (
        Item("stroke H", ("H", "хід"), "kinematics.stroke_D", "mm", 0.01, 0.5, 0.03, 2.0, 4, (), False),
        Item("a", (), "kinematics.aS_D@3", "m/s^2", 0.01, 0.0, 0.03, 1.0, 3, (0,), True),
    ),
    tuple(map(told_of, NAMES)),
    (
        Key(
            1,
            "Олена О’Ніл",
            (658.0999999999999, -1 / 3),
            ((math.nan, 0.1 + 0.2), (5e-324, 1.7e308), (-658.1, math.nan)),
        ),
        Key(2, "", (0.1, 2e-7), ((math.nan, math.nan), (math.nan, math.nan), (-0.1, math.nan))),
    ),
    ("abc", "def"),
)


def same(one: object, other: object) -> bool:
    return repr(one) == repr(other)  # nan is not itself


def test_every_digit_comes_back(tmp_path: Path) -> None:
    assert same(keybook_of(toml_bytes(BOOK)), BOOK)
    written = write_keybook(BOOK, tmp_path / "keys")
    assert [file.name for file in written] == ["keys.toml", "keys.csv"]
    assert same(read_keybook(tmp_path / "keys"), BOOK)
    times = [file.stat().st_mtime_ns for file in written]
    write_keybook(BOOK, tmp_path / "keys")
    assert [file.stat().st_mtime_ns for file in written] == times


@pytest.mark.parametrize("at", [0, 100, 700, -80, -2])
def test_a_changed_byte_is_noticed(at: int) -> None:
    data = bytearray(toml_bytes(BOOK))
    data[at] ^= 1
    with pytest.raises(UsageError, match="damaged or was edited"):
        keybook_of(bytes(data))


@pytest.mark.parametrize("kept", [0, 10, 500, -1, -66])
def test_a_torn_file_is_noticed(kept: int) -> None:
    with pytest.raises(UsageError, match="damaged or was edited"):
        keybook_of(toml_bytes(BOOK)[:kept])


def sealed(old: str, new: str) -> bytes:
    """The file with something else in it, and a digest that fits."""
    body, _, _ = toml_bytes(BOOK).rpartition(DIGEST)
    assert old.encode() in body
    body = body.replace(old.encode(), new.encode(), 1)
    return body + DIGEST + hashlib.sha256(body).hexdigest().encode() + b"\n"


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("[[items]]", "[[item]]"),
        ("linkage.coriolis_left_out", "linkage.no_such"),
        ("number = 2", 'number = "two"'),
        ("658.0999999999999", "nan"),
        ("658.0999999999999", "'a'"),
        ("tolerance = 0.01", "tolerances = 0.01"),
        ("version", "=version"),
    ],
)
def test_a_file_that_somebody_has_made_is_one_message(old: str, new: str) -> None:
    with pytest.raises(UsageError) as caught:
        keybook_of(sealed(old, new))
    assert "keys" in str(caught.value)


def test_a_folder_without_keys() -> None:
    with pytest.raises(UsageError, match="there are no keys in nowhere"):
        read_keybook(Path("nowhere"))


def test_the_table_for_the_teacher() -> None:
    data = csv_bytes(BOOK)
    assert data.startswith(b"\xef\xbb\xbf")  # spreadsheets read it as UTF-8
    head, first, second, *_ = csv.reader(io.StringIO(data.decode("utf-8-sig")))
    assert dict(zip(head, first, strict=True)) == {
        "variant": "1",
        "student": "Олена О’Ніл",
        "name": "stroke H",
        "result": "kinematics.stroke_D",
        "value": "658.1",
        "unit": "mm",
        "tolerance": "6.6",
        "also right": "",
    }
    assert second[4:] == ["-0.333", "m/s^2", "0.0033", "0.333"]


def test_a_name_that_is_a_formula_is_a_text() -> None:
    book = Keybook((item("a", ""),), (), (Key(1, '=HYPERLINK("x")', (1.0,), ()),))
    cell = csv_bytes(book).decode("utf-8-sig").splitlines()[1]
    assert cell.split(",")[1].startswith("\"'=")


@pytest.mark.parametrize(
    ("value", "digits", "text"),
    [
        (11956.4, 4, "11960"),
        (0.82, 4, "0.8200"),
        (-2e-4, 2, "-0.00020"),
        (99.996, 4, "100.00"),
        (0.0, 4, "0"),
        (1.0, 2, "1.0"),
    ],
)
def test_significant_digits(value: float, digits: int, text: str) -> None:
    assert significant(value, digits) == text
