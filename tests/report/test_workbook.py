"""Workbooks read back by openpyxl, which shares no code with what writes them; charts by their XML."""

from __future__ import annotations

import io
import math
import time
import zipfile
from xml.etree import ElementTree

import openpyxl
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from openpyxl.utils import range_boundaries

from tmmcalc.core.errors import UsageError
from tmmcalc.report.document import Document, Fact, View
from tmmcalc.report.workbook import workbook
from tmmcalc.report.worksheets import Worksheet, curves_of, sheet_names, sheets_of

PHI = [15.0 * k for k in range(25)]
SINE = [math.sin(math.radians(phi)) for phi in PHI]
WAVE = Worksheet(
    "wave", ["i", "phi[deg]", "S[m]", "v[m/s]"], [list(range(25)), PHI, SINE, SINE[::-1]], main=["phi", "S", "v"]
)


def read(*sheets: Worksheet) -> openpyxl.Workbook:
    return openpyxl.load_workbook(io.BytesIO(workbook(sheets, "a title")))


def cells(*column: object, header: str = "x") -> list[object]:
    """A column as it is read back."""
    page = read(Worksheet("one", [header], [column]))["one"]
    return [page.cell(row, 1).value for row in range(2, 2 + len(column))]


@settings(deadline=None)  # a workbook is written for every number
@given(st.floats(allow_nan=False, allow_infinity=False, allow_subnormal=False))
def test_a_number_is_read_back_bit_by_bit(value: float) -> None:
    assert cells(value) == [value]


def test_integers_truth_values_and_what_is_none() -> None:
    found = cells(7, True, False, math.nan, math.inf, None, "", 0.5)
    assert found == [7, True, False, None, None, None, None, 0.5]
    assert [type(each) for each in found[:3]] == [int, bool, bool]


@pytest.mark.parametrize(
    "text", ["=cmd|'/c calc'!A1", "=1+1", "{=SUM(A1)}", "+3", "-x", "@SUM(1)", "http://a.b", "012", "1e5", "'a", " a "]
)
def test_a_text_stays_a_text(text: str) -> None:
    page = read(Worksheet("one", [text], [[text]], beside=[(text, text)]))["one"]
    for place in ("A1", "A2", "C1", "D1"):
        cell = page[place]
        assert (cell.value, cell.data_type, cell.hyperlink) == (text, "s", None)


def test_texts_that_no_file_of_xml_can_hold_are_written_out() -> None:
    assert cells("a\x00b\u202ec", "x" * 40_000) == [r"a\x00b\u202ec", "x" * 32_763 + " ..."]


def test_the_number_format_of_a_column() -> None:
    page = read(Worksheet("one", ["a", "b", "c", "value"], [[1, 20], [0.5, 12.25], [3e-9, 1e-7], [1.0, 1e9]]))["one"]
    assert [page.cell(2, k).number_format for k in range(1, 5)] == ["0", "0.0000", "0.00000E+00", "General"]


def test_header_filter_and_widths() -> None:
    page = read(WAVE)["wave"]
    assert [cell.value for cell in page[1]] == list(WAVE.headers)
    assert (page.freeze_panes, page.auto_filter.ref) == ("B2", "A1:D26")
    assert all(6 <= each.width <= 61 for each in page.column_dimensions.values())
    assert page["A1"].font.bold


def test_equal_sheets_give_equal_bytes() -> None:
    first = workbook([WAVE], "t")
    time.sleep(2.1)  # an archive counts time in steps of two seconds
    assert workbook([WAVE], "t") == first
    core = zipfile.ZipFile(io.BytesIO(first)).read("docProps/core.xml").decode()
    assert core.count("1980-01-01T00:00:00Z") == 2


def test_charts_name_the_cells_of_their_columns() -> None:
    """A chart for each unit: the cells that it names hold its columns, and what it keeps of them is the same."""
    archive = zipfile.ZipFile(io.BytesIO(workbook([WAVE], "t")))
    page = read(WAVE)["wave"]
    charts = [name for name in archive.namelist() if name.startswith("xl/charts/chart")]
    assert len(charts) == 4  # on the page of the table and on that of all charts
    spaces = {"c": "http://schemas.openxmlformats.org/drawingml/2006/chart"}
    for name, column, header in zip(sorted(charts), (2, 3, 2, 3), ("S", "v") * 2, strict=True):
        tree = ElementTree.fromstring(archive.read(name))
        (series,) = tree.iterfind(".//c:scatterChart/c:ser", spaces)
        for axis, expected in (("xVal", PHI), ("yVal", WAVE.columns[column])):
            place = series.find(f"c:{axis}/c:numRef/c:f", spaces)
            assert place is not None
            assert place.text is not None
            sheet, _, area = place.text.replace("$", "").partition("!")
            left, top, right, bottom = range_boundaries(area)
            named = [page.cell(row, left).value for row in range(top, bottom + 1)]
            kept = [float(each.text or "") for each in series.iterfind(f"c:{axis}//c:v", spaces)]
            assert (sheet, left) == ("wave", right)
            assert named == list(expected) == kept
        titles = [each.text for each in tree.iter("{http://schemas.openxmlformats.org/drawingml/2006/main}t")]
        assert titles[0] == "phi [deg]"
        assert titles[1].startswith(f"{header} [m")
        (low, high) = (tree.find(f".//c:valAx/c:scaling/c:{end}", spaces) for end in ("min", "max"))
        assert low is not None
        assert high is not None
        assert (float(low.attrib["val"]), float(high.attrib["val"])) == (0.0, 360.0)


def test_what_has_no_chart() -> None:
    straight = [2 * phi - 7 for phi in PHI]
    mixed = ["", *SINE[1:]]
    sheet = Worksheet("w", ["phi[deg]", "a[deg]", "b", "c"], [PHI, straight, [4.0] * 25, mixed], main=["a", "b", "c"])
    assert curves_of(sheet) == []
    assert curves_of(Worksheet("w", ["z_1", "m[mm]"], [[17, 18, 19, 20, 21], SINE[:5]], main=["z_1", "m"])) == []


def test_names_of_sheets() -> None:
    names = ["a" * 40, "a" * 40, "A" * 31, "b[1]", "b:1/", "'q'", "", "History", "x", "X"]
    found = sheet_names(names)
    assert [each.title for each in read(*(Worksheet(name, ["x"], [[1]]) for name in names))] == found
    assert len({name.lower() for name in found}) == len(names)
    assert max(map(len, found)) <= 31
    assert not any(set(name) & set("[]:*?/\\") or name[:1] == "'" for name in found)


def test_more_than_a_sheet_can_hold_is_refused() -> None:
    long = Worksheet("long", ["x"], [range(1_048_576)])
    with pytest.raises(UsageError, match="long: 1048576 rows of 1 columns are more than a sheet can have"):
        workbook([long], "t")
    wide = Worksheet("wide", ["x"] * 1000, [range(3000)] * 1000)
    with pytest.raises(UsageError, match="3000000 cells are too many for a workbook"):
        workbook([wide], "t")


def test_the_sheets_of_a_document() -> None:
    facts = (
        Fact("strokes", "two", {"stroke_D[m]": 0.5, "ends[deg]": [1.0, 2.0], "many": list(range(20)), "kind": "RRR"}),
        Fact("error estimate", "small", {"error": {"position": 1e-15}}),
    )
    view = View(["i", "x[m]"], [["0", "0'"], [1.5, ""]])
    document = Document("t", facts, ("warning: too fast", "note: see there", "plain"), view)
    summary, table = sheets_of(document, "kinematics", ["x"])
    rows = list(zip(*summary.columns, strict=True))
    assert rows[0] == (
        "stroke_D",
        "",
        0.5,
        "m",
        "largest distance between dead centres of D, its longest stroke if it goes round",
    )
    assert [row[:4] for row in rows[1:4]] == [
        ("ends.0", "", 1.0, "deg"),
        ("ends.1", "", 2.0, "deg"),
        ("many", "", str(list(range(20))), ""),
    ]
    assert rows[-3:] == [
        ("warning", "", "too fast", "", ""),
        ("note", "", "see there", "", ""),
        ("note", "", "plain", "", ""),
    ]
    assert table.name == "kinematics"
    assert list(table.columns[0]) == [0, "0'"]
    assert table.beside[-1] == ("error estimate: position", 1e-15)
    assert read(summary, table)["kinematics"].sheet_properties.tabColor.rgb == "FFF2A900"
