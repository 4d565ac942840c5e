"""Workbooks (xlsx) of sheets that other modules describe; XlsxWriter is needed only here.

Numbers are written in full and shown with the decimals that people read; a text stays a text, whatever it begins with.
Equal sheets give equal bytes: no clock times.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from datetime import datetime
from importlib.util import find_spec
from io import BytesIO
from typing import TYPE_CHECKING, Any

from tmmcalc.core.errors import UsageError
from tmmcalc.core.facts import named
from tmmcalc.core.printable import printable
from tmmcalc.report.numbers import decimals
from tmmcalc.report.worksheets import Curves, Worksheet, curves_of, sheet_names

if TYPE_CHECKING:
    from xlsxwriter.chart import Chart
    from xlsxwriter.format import Format
    from xlsxwriter.workbook import Workbook
    from xlsxwriter.worksheet import Worksheet as Page

MADE = datetime(1980, 1, 1)  # a workbook cannot do without a date; this is the first that its archive can have
ROWS, COLUMNS = 1_048_575, 16_384  # of a sheet, under its header
CELLS = 2_000_000  # of a workbook: they take a gigabyte and a minute while it is written
TEXT = 32_767  # characters of a cell
WIDEST, NARROWEST = 60, 6  # columns of a sheet, in characters
FREE = 3  # characters of a header for the arrow of the filter
LINKED = ("stage", "part")  # headers of columns whose cells lead to the sheets that they name
MIXED = "value"  # header of a column of all kinds of quantities
POWERS, ESTIMATE = "0.00000E+00", "0.0E+00"  # formats of numbers in powers of ten
AMBER = "#F2A900"  # tab of a sheet with a warning
CHART = {"width": 640, "height": 320}  # pixels
LINE = 1.5  # points
TALL, WIDE = 17, 10  # rows and columns of an empty sheet that a chart covers
CHARTS = "charts"  # the page that has all of them
ACROSS = 2  # charts beside each other there
TURN = 180.0  # angles over so much are marked in steps of 30, 60 ... deg
MARKS = (30.0, 60.0, 90.0, 180.0, 360.0)
MOST_MARKS = 13


def check_xlsxwriter() -> None:
    """Raise `UsageError` where XlsxWriter is not installed."""
    if find_spec("xlsxwriter") is None:
        from tmmcalc.core.installation import install

        raise UsageError(
            "workbooks need XlsxWriter, which is not installed", where="--format xlsx", remedy=install("xlsx")
        )


def workbook(sheets: Sequence[Worksheet], title: str) -> bytes:
    """The bytes of a workbook.

    Raises `UsageError` for more than its sheets can hold, and where XlsxWriter is not installed.
    """
    check_xlsxwriter()
    _check(sheets)
    from xlsxwriter.workbook import Workbook

    buffer = BytesIO()
    # without these texts that look like formulas, links or numbers would become such
    plain = {"in_memory": True, "strings_to_formulas": False, "strings_to_urls": False, "strings_to_numbers": False}
    book = Workbook(buffer, plain)
    book.set_properties({"title": printable(title), "created": MADE})
    formats = _Formats(book)
    charts, *names = sheet_names([CHARTS, *(sheet.name for sheet in sheets)])
    pages = {sheet.name: name for sheet, name in zip(sheets, names, strict=True)}
    drawn = [sheet for sheet in sheets if curves_of(sheet)]
    for sheet, name in zip(sheets, names, strict=True):
        if drawn and sheet is drawn[0]:
            _draw(book, formats, drawn, charts, pages)
        _write(book, formats, sheet, name, pages)
    book.close()
    return buffer.getvalue()


def _check(sheets: Sequence[Worksheet]) -> None:
    remedy = "name fewer columns (--columns 'phi,x_*') or positions (--positions 0:1000:10); --csv has no limit"
    for sheet in sheets:
        if sheet.rows > ROWS or len(sheet.headers) > COLUMNS - 3:
            raise UsageError(
                f"{sheet.name}: {sheet.rows} rows of {len(sheet.headers)} columns are more than a sheet can have",
                where="--format xlsx",
                limit=ROWS,
                remedy=remedy,
            )
    cells = sum(sheet.rows * len(sheet.headers) for sheet in sheets)
    if cells > CELLS:
        raise UsageError(
            f"{cells} cells are too many for a workbook", where="--format xlsx", value=cells, limit=CELLS, remedy=remedy
        )


class _Formats:
    """The formats of cells, each made once."""

    def __init__(self, book: Workbook) -> None:
        self._book = book
        self._made: dict[str, Format] = {}
        self.texts = book.add_format({"bold": True, "bottom": 1, "align": "left"})
        self.numbers = book.add_format({"bold": True, "bottom": 1, "align": "right"})

    def of(self, code: str) -> Format:
        """The format with this number code."""
        if code not in self._made:
            self._made[code] = self._book.add_format({"num_format": code})
        return self._made[code]


class _Whole(float):
    """A number that is written with all its digits: XlsxWriter asks for sixteen of the seventeen."""

    def __format__(self, digits: str) -> str:
        return repr(float(self))


def _write(book: Workbook, formats: _Formats, sheet: Worksheet, name: str, pages: Mapping[str, str]) -> None:
    """One page: the table from its first cell, what is said beside it, the charts."""
    page = book.add_worksheet(name)
    for k, (header, column) in enumerate(zip(sheet.headers, sheet.columns, strict=True)):
        _column(page, formats, k, header, column, pages if header in LINKED else {})
    if sheet.rows:
        page.freeze_panes(1, 1 if sheet.headers[0] == "i" else 0)
        page.autofilter(0, 0, sheet.rows, len(sheet.headers) - 1)
    if sheet.warns:
        page.set_tab_color(AMBER)
    at = len(sheet.headers) + 1 if sheet.headers else 0
    for row, (label, value) in enumerate(sheet.beside):
        _cell(page, row, at, label, formats.of("General"))
        _cell(page, row, at + 1, value, formats.of(ESTIMATE if _number(value) else "General"))
    if sheet.beside:
        page.set_column(at, at, max(len(label) for label, _ in sheet.beside) + 2)
    for number, curves in enumerate(curves_of(sheet)):
        page.insert_chart(len(sheet.beside) + 1 + number * TALL, at, _chart(book, sheet, name, curves))


def _draw(book: Workbook, formats: _Formats, sheets: Sequence[Worksheet], name: str, pages: Mapping[str, str]) -> None:
    """The page of all charts, where they are found at once: beside a wide table they are far away."""
    page, row = book.add_worksheet(name), 0
    for sheet in sheets:
        page.write_url(row, 0, f"internal:'{pages[sheet.name]}'!A1", string=sheet.name)
        curves = curves_of(sheet)
        for at, each in enumerate(curves):
            across, down = at % ACROSS, at // ACROSS
            page.insert_chart(row + 1 + down * TALL, across * WIDE, _chart(book, sheet, pages[sheet.name], each))
        row += 2 + -(-len(curves) // ACROSS) * TALL


def _column(
    page: Page, formats: _Formats, k: int, header: str, column: Sequence[Any], pages: Mapping[str, str]
) -> None:
    """A header and its cells, and a width at which people can read them; ``pages`` are those that cells lead to."""
    numbers = [value for value in column if _number(value)]
    code = "General" if header == MIXED else _code(numbers)
    own = formats.of(code)
    _cell(page, 0, k, header, formats.numbers if numbers and header != MIXED else formats.texts)
    for row, value in enumerate(column, 1):
        if value in pages:
            page.write_url(row, k, f"internal:'{pages[value]}'!A1", string=value)
        else:
            _cell(page, row, k, value, own)
    shown = [value for value in column if isinstance(value, str)]
    if numbers:
        shown.append(_longest(numbers, code))
    width = max(map(len, (header, *shown))) + FREE
    page.set_column(k, k, min(max(width, NARROWEST), WIDEST))


def _longest(numbers: Sequence[float], code: str) -> str:
    """A number as long as the longest of a column, as it is shown."""
    if code in ("General", POWERS):
        return POWERS
    return f"-{max(map(abs, numbers)):.{len(code.partition('.')[2])}f}"


def _cell(page: Page, row: int, column: int, value: Any, form: Format) -> None:
    """A value as what it is; nothing for what is none."""
    if isinstance(value, bool):
        page.write_boolean(row, column, value)
    elif isinstance(value, int | float):
        if math.isfinite(value):
            page.write_number(row, column, _Whole(value) if isinstance(value, float) else value, form)
    elif value is not None and value != "":
        text = printable(str(value))
        page.write_string(row, column, text if len(text) <= TEXT else f"{text[: TEXT - 4]} ...", form)


def _number(value: Any) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool)


def _code(numbers: Sequence[float]) -> str:
    """The number format of a column: the decimals that it has in a table for people.

    >>> _code([1, 2]), _code([0.5, 12.25]), _code([3e-9])
    ('0', '0.0000', '0.00000E+00')
    """
    if all(isinstance(value, int) for value in numbers):
        return "0"
    places = decimals([value for value in numbers if math.isfinite(value)])
    return POWERS if places is None else f"0.{'0' * places}".rstrip(".")


def _chart(book: Workbook, sheet: Worksheet, name: str, curves: Curves) -> Chart:
    """The columns of one unit over that which the rows run over."""
    over, drawn = curves
    chart = book.add_chart({"type": "scatter", "subtype": "straight"})
    for k in drawn:
        chart.add_series(
            {
                "name": [name, 0, k],
                "categories": [name, 1, over, sheet.rows, over],
                "values": [name, 1, k, sheet.rows, k],
                "line": {"width": LINE},
                "marker": {"type": "none"},
            }
        )
    alone = len(drawn) == 1
    told = _axis(sheet.headers[drawn[0]]) if alone else named(sheet.headers[drawn[0]])[1]
    chart.set_x_axis({"name": _axis(sheet.headers[over]), "label_position": "low", **_span(sheet, over)})
    chart.set_y_axis({"name": told, "label_position": "low"})
    chart.set_title({"none": True})
    chart.set_legend({"none": True} if alone else {"position": "bottom"})
    chart.set_size(CHART)
    return chart


def _axis(header: str) -> str:
    name, unit = named(header)
    return f"{name} [{unit}]" if unit else name


def _span(sheet: Worksheet, k: int) -> dict[str, Any]:
    """The ends of the axis that others are drawn over; angles are marked at parts of a turn."""
    column = sheet.columns[k]
    low, high = min(column[0], column[-1]), max(column[0], column[-1])
    span: dict[str, Any] = {"min": low, "max": high}
    if named(sheet.headers[k])[1] == "deg" and high - low >= TURN:
        span["major_unit"] = next((mark for mark in MARKS if (high - low) / mark <= MOST_MARKS), MARKS[-1])
    return span
