"""The tables are whole and strict, steels are found by any spelling, hardness is read as drawings write it."""

from __future__ import annotations

from dataclasses import fields
from itertools import pairwise
from pathlib import Path

import pytest

from gears.strength.scenes import CASES
from tmmcalc.core.errors import UsageError
from tmmcalc.gears.strength.material import BLANKS, LOADS, STRUCTURES, TREATMENTS, WEARS, Hardness, parse_hardness
from tmmcalc.gears.strength.steels import check_steel, known, latin, steel_key
from tmmcalc.gears.strength.tables import (
    ANY,
    FILES,
    Arrangement,
    BendingRow,
    BlankSafety,
    ContactRow,
    ContactSafety,
    LoadSides,
    StandardModule,
    WidthRange,
    parse,
    table,
)

SIZES = {
    Arrangement: 7,
    WidthRange: 3,
    BendingRow: 12,
    ContactRow: 4,
    ContactSafety: 2,
    BlankSafety: 6,
    LoadSides: 4,
    StandardModule: 33,
}


@pytest.mark.parametrize("kind", FILES, ids=lambda kind: kind.__name__)
def test_every_table_is_whole_and_every_row_has_its_source(kind: type) -> None:
    rows = table(kind)
    assert len(rows) == SIZES[kind]
    number = {
        Arrangement: 1,
        WidthRange: 2,
        BendingRow: 3,
        ContactRow: 4,
        ContactSafety: 5,
        BlankSafety: 6,
        LoadSides: 7,
    }
    assert all(f"D.4.{number.get(kind, 8)}" in row.source for row in rows)
    assert {*FILES.values()} == {file.name for file in _folder().iterdir()}


def _folder() -> Path:
    from tmmcalc.gears.strength import tables

    return Path(tables.__file__).parent / "data"


def test_factors_grow_as_they_must() -> None:
    """Hard wheels and overhung ones spread the load worse; bending factors stand above those of contact."""
    rows = table(Arrangement)
    for row in rows:
        assert row.soft_contact < row.hard_contact
        assert row.soft_bending < row.hard_bending
        assert row.soft_contact < row.soft_bending
    for before, after in pairwise(rows):
        assert before.soft_contact > after.soft_contact
        assert before.soft_bending > after.soft_bending
        assert before.hard_contact > after.hard_contact
    assert {row.position for row in rows} == {row.position for row in table(WidthRange)}
    for width in table(WidthRange):
        assert width.hard_low < width.soft_low < width.soft_high
        assert width.hard_high < width.soft_high


def test_the_words_of_tables_and_materials_are_the_same() -> None:
    assert {t for row in table(BendingRow) for t in row.treatments} == {*TREATMENTS} - {"annealed"}
    assert {t for row in table(ContactRow) for t in row.treatments} == {*TREATMENTS} - {"through-hardened"}
    assert {t for row in table(LoadSides) for t in row.treatments} == {*TREATMENTS, ANY}
    assert {row.load for row in table(LoadSides)} == {*LOADS}
    assert {row.structure for row in table(ContactSafety)} == {*STRUCTURES}
    assert {(row.blank, row.wear) for row in table(BlankSafety)} == {(b, w) for b in BLANKS for w in WEARS}
    for row in table(BendingRow):
        assert {*row.doubtful} <= {*row.steels}
        assert row.base_protected_mpa >= row.base_mpa
        assert row.safety_protected <= row.safety


def test_modules_of_the_standard() -> None:
    modules = [entry.module_mm for entry in table(StandardModule)]
    assert modules == sorted({*modules})
    assert sum(entry.row == 1 for entry in table(StandardModule)) == 17
    assert all(8 * module == int(8 * module) for module in modules)
    both = CASES["GT-S23"]["expected"]
    assert {*both["both_rows"], *both["row1_only"]} <= {*modules}


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("", "columns are not load"),
        ("load,factor,treatments,source\n", "columns are not load"),
        ("load,treatments,factor,source\nx,*,1\n", "line 2: not 4 cells"),
        ("load,treatments,factor,source\nx,*,1,\n", "line 2: not 4 cells"),
        ("load,treatments,factor,source\nx,*,1,y\nx,*,one,y\n", "line 3: could not convert"),
        ("load,treatments,factor,source\nx,*,nan,y\n", "line 2: 'nan' is not a finite number"),
    ],
)
def test_a_damaged_table_is_told(text: str, says: str) -> None:
    with pytest.raises(UsageError, match=says):
        parse(text, LoadSides, "own.csv")


def test_flags_and_empty_cells() -> None:
    names = ",".join(field.name for field in fields(BendingRow))
    (row,) = parse(f"{names}\nx,a b,,,,S T,,yes,1,2,0,,1,1,y\n", BendingRow, "own.csv")
    assert (row.treatments, row.low, row.similar, row.doubtful) == (("a", "b"), None, True, ())
    with pytest.raises(UsageError, match="neither yes nor no"):
        parse(f"{names}\nx,a b,,,,S T,,maybe,1,2,0,,1,1,y\n", BendingRow, "own.csv")


@pytest.mark.parametrize(
    ("written", "key"),
    [
        ("40Х", "40Х"),
        ("40Kh", "40Х"),
        ("40kh", "40Х"),
        ("40X", "40Х"),
        ("Сталь 45", "45"),
        ("steel 40XH", "40ХН"),
        ("40KhN2M", "40ХН2М"),
        ("40ХН2МА", "40ХН2МА"),
        ("18X2H4BA", "18Х2Н4ВА"),
        ("18Kh2N4VA", "18Х2Н4ВА"),
        ("38KhMYuA", "38ХМЮА"),
        ("20KhGR", "20ХГР"),
        ("20ХGР", "20ХГР"),
        ("35KhGS", "35ХГС"),
        ("40 Kh F A", "40ХФА"),
    ],
)
def test_spellings_of_a_steel(written: str, key: str) -> None:
    assert steel_key(written) == key == check_steel(written, "", "")


def test_transliteration_of_every_steel_leads_back() -> None:
    assert len(known()) > 25
    for steel in known():
        assert latin(steel).isascii()
        assert steel_key(latin(steel)) == steel


def test_an_unknown_steel_has_its_nearest() -> None:
    with pytest.raises(UsageError, match="no steel '40KhM'") as error:
        check_steel("40KhM", "wheel 1", "give bending_limit")
    assert "did you mean 40Kh" in error.value.remedy
    assert "bending_limit" in error.value.remedy
    with pytest.raises(UsageError) as other:
        check_steel("brass", "wheel 1", "give bending_limit")
    assert other.value.remedy == "give bending_limit"


@pytest.mark.parametrize("text", ["300 HB", "HB 300", "300HB", "hb300", " 300 HBW ", "НВ 300"])
def test_spellings_of_hardness(text: str) -> None:
    assert parse_hardness(text) == Hardness(300.0, "HB")


def test_a_hardness_that_cannot_be() -> None:
    for text in ("300", "HB", "300 MPa", "", "-300 HB", "45..50 HRC"):
        with pytest.raises(UsageError, match="not a hardness") as error:
            parse_hardness(text)
        assert "300 HB" in error.value.remedy
    for text in ("300 HRC", "20 HB", "9000 HV"):
        with pytest.raises(UsageError, match="cannot be"):
            parse_hardness(text)
    with pytest.raises(UsageError, match="no scale"):
        Hardness(60.0, "HRA")
    assert parse_hardness("350 HB").soft
    assert not parse_hardness("351 HB").soft
    assert not parse_hardness("40 HRC").soft
