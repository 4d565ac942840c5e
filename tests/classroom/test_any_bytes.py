"""Whatever bytes a file holds, reading ends with answers, with one message, or with a table that answers nothing."""

from __future__ import annotations

import contextlib
import io
import zipfile
from pathlib import Path
from tempfile import TemporaryDirectory

import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from classroom.books import press_class
from tmmcalc.classroom.answers.figures import NoNumberError, read_number
from tmmcalc.classroom.answers.measures import UnitOfAnswerError, factor_to
from tmmcalc.classroom.answers.positions import Steps
from tmmcalc.classroom.answers.reading import UNFORESEEN, read_answers

BOOK = press_class()
CELLS = st.text(alphabet='H;,\t|"=1.5e+-−·^ \n\rωкмφ№\u00a0\u202f[](){}<>&/\\', max_size=120)
WORDS = st.lists(
    st.sampled_from(
        ["H", "ω2", "K", "1,5", "-3", "student", "Коваль", "item", "value", "φ", "№", "R_A", "мм", "", "7"]
    ),
    max_size=30,
)


def read(name: str, content: bytes) -> None:
    with TemporaryDirectory() as folder:
        (Path(folder) / name).write_bytes(content)
        pile = read_answers(Path(folder), BOOK.items, BOOK.keys, Steps(30.0))
        assert pile.hand_ins or pile.refused or pile.empty
        assert all(len(each.answers) == len(BOOK.items) for each in pile.hand_ins)
        assert all("\n" not in each.message and UNFORESEEN not in each.message for each in pile.refused)


@pytest.mark.slow
@settings(max_examples=150, deadline=None)
@given(st.binary(max_size=300), st.sampled_from(["1.csv", "1.toml", "1.xlsx"]))
def test_bytes(content: bytes, name: str) -> None:
    read(name, content)


@pytest.mark.slow
@settings(max_examples=200, deadline=None)
@given(CELLS, st.sampled_from(["utf-8", "utf-16", "utf-8-sig"]), st.sampled_from(["1.csv", "x.csv", "1.toml"]))
def test_texts(text: str, encoding: str, name: str) -> None:
    read(name, text.encode(encoding))


@pytest.mark.slow
@settings(max_examples=200, deadline=None)
@example([["item", "value"], ["H"]], ";", "1.csv")
@given(st.lists(WORDS, max_size=8), st.sampled_from(";\t,"), st.sampled_from(["1.csv", "x.csv"]))
def test_tables_of_words_that_tell_something(rows: list[list[str]], delimiter: str, name: str) -> None:
    read(name, "\n".join(map(delimiter.join, rows)).encode())


@settings(max_examples=150, deadline=None)
@given(st.text(alphabet='<>/c rvsf="1A:&;tn\n!x-?[]', max_size=200), st.sampled_from(["sheet", "strings", "styles"]))
def test_workbooks(text: str, part: str) -> None:
    parts = {
        "xl/workbook.xml": "<workbook/>",
        "xl/worksheets/sheet1.xml": '<w><row><c t="s" s="1"><v>0</v></c><c><v>5</v></c></row></w>',
        "xl/sharedStrings.xml": "<s><si><t>H</t></si></s>",
        "xl/styles.xml": '<s><cellXfs><xf numFmtId="0"/></cellXfs></s>',
    }
    names = {"sheet": "xl/worksheets/sheet1.xml", "strings": "xl/sharedStrings.xml", "styles": "xl/styles.xml"}
    parts[names[part]] = f"<w>{text}</w>"
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w") as archive:
        for name, content in parts.items():
            archive.writestr(name, content)
    read("1.xlsx", buffer.getvalue())


@pytest.mark.slow
@settings(max_examples=300, deadline=None)
@given(st.text(max_size=40))
def test_numbers_and_units(text: str) -> None:
    try:
        written = read_number(text)
    except NoNumberError:
        return
    assert abs(written.value) < 10**130
    for asked in ("mm", "", "rad/s"):
        with contextlib.suppress(UnitOfAnswerError):
            assert factor_to(written.unit, asked) > 0
