"""Task sheets and empty tables of answers: what stands in them, in every form, and what becomes of them later."""

from __future__ import annotations

import re
from io import BytesIO
from pathlib import Path
from shutil import copytree
from typing import Any

import pytest
from mistakes import item

from classroom.school import SHAPER, STUDENTS, School, hand_in
from tmmcalc.classroom.answers.reading import read_answers
from tmmcalc.classroom.papers.making import traced
from tmmcalc.classroom.papers.overview import overview
from tmmcalc.classroom.papers.sheets import write_notes, write_sheets
from tmmcalc.classroom.papers.tasksheet import Given, task_sheet
from tmmcalc.core.errors import UsageError
from tmmcalc.note.forms import FORMS, check_form
from tmmcalc.note.plaintext import text as plain
from tmmcalc.project import load_spec
from tmmcalc.report.language import speaking
from tmmcalc.report.manuscript import Table


@pytest.fixture(scope="module")
def folder(school: School, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A copy of the class beside its assignment, with sheets in every form."""
    place = tmp_path_factory.mktemp("papers")
    copytree(school.folder.parent, place, dirs_exist_ok=True)
    for form in FORMS:
        with speaking("uk" if form == "html" else "en"):
            write_sheets(place / "class", school.made, school.items, form, jobs=1)
    return place / "class"


def sheet(folder: Path, number: int, form: str) -> bytes:
    (file,) = folder.glob(f"sheets/{number:02d}*.{form}")
    return file.read_bytes()


def test_every_variant_has_a_sheet_in_every_form(folder: Path) -> None:
    for form in FORMS:
        assert len([*folder.glob(f"sheets/*.{form}")]) == 3


def test_a_sheet_has_the_numbers_of_its_variant_and_what_is_asked(folder: Path, school: School) -> None:
    """Read from the spec that was given out, not from what the sheet was made of."""
    for variant in school.made.variants:
        text = sheet(folder, variant.number, "txt").decode()
        spec = load_spec(folder / "variants" / f"{variant.stem}.toml")
        own = text[text.index("alone\n") : text.index("Data of all variants")]
        assert spec.mechanism is not None
        crank = spec.mechanism.links[0].points
        assert re.search(rf"l_OA +{abs(complex(*crank['A']) - complex(*crank['O'])):g} m\n", own)
        assert re.search(rf"n_1 +{spec.mechanism.input.speed * 30 / 3.141592653589793:.6g} rpm\n", own)
        asked = text[text.index("Asked results") :]
        for each in school.items:
            assert re.search(rf"^ +{re.escape(each.name)} ", asked, re.MULTILINE), each.name
        assert "its sign is left open" in asked
        if variant.student:
            assert variant.student.split()[0] in text


def test_what_is_drawn_is_found_and_nothing_else(school: School) -> None:
    """Every drawn number is told by a datum; what the assignment fixes is in none of them."""
    own, further = traced(school.made.file(school.folder))
    names = {name for _, keys in own for name in keys}
    assert further == ()
    assert {"l_{OA}", "l_{BC}", "n_1"} <= names
    assert not {"g", "m_3", "l_{CD}", "n"} & names


@pytest.mark.slow
def test_the_task_of_the_press_tells_all_that_is_drawn() -> None:
    """Of what is solved too: phases of the cam, of which the last follows from the others; the rest is common."""
    own, further = traced(SHAPER.with_name("assignment-course-project.toml"))
    names = {name for _, keys in own for name in keys}
    assert further == ()
    assert names >= {"l_{OA}", "l_{AB}", "l_{CB}", "l_{BD}", "n_1", "m_5", "k_{Q,5}", "delta_0", "h", "phi_y", "phi_b"}
    assert not names & {"phi_c", "phi_d", "m_1", "J_1", "P_N"}


@pytest.mark.parametrize("unit", ["", "-"])
def test_a_number_has_no_unit(unit: str) -> None:
    """That of a fact is empty, that of a column -."""
    asked = (item("cam_law.s1@3", unit, within=0.01),)
    (chapter,) = task_sheet("", "Variant", Given((), (), (), ()), asked, ["slope"])
    (rows,) = [block.rows for block in chapter.blocks if isinstance(block, Table)]
    assert rows[0][1:5] == ("slope", "–", "4", "1 % or 0.01")


def test_plain_text_speaks_of_no_figure(folder: Path) -> None:
    """It has none; a page of the same sheet has both."""
    assert "figure" not in sheet(folder, 1, "txt").decode().casefold()
    assert "на рисунку" in sheet(folder, 1, "html").decode()


def test_a_pdf_is_whole_pages_of_a4_without_an_empty_one(folder: Path) -> None:
    reader = pytest.importorskip("pypdfium2")
    document = reader.PdfDocument(sheet(folder, 2, "pdf"))
    texts = [page.get_textpage().get_text_range() for page in document]
    assert all(len(text) > 300 for text in texts)
    assert STUDENTS[1].split()[0] in texts[0]


def test_ukrainian_has_no_english_left(folder: Path) -> None:
    body = sheet(folder, 1, "html").decode().partition("<body>")[2]
    text = re.sub(r"<[^>]+>", " ", re.sub(r"<style.*?</style>", "", body, flags=re.DOTALL))
    assert {*re.findall(r"\b[A-Za-z]{4,}\b", text)} == {"Shaper"}


def test_a_docx_is_opened(folder: Path) -> None:
    docx: Any = pytest.importorskip("docx")
    document = docx.Document(BytesIO(sheet(folder, 1, "docx")))
    cells = {cell.text for table in document.tables for row in table.rows for cell in row.cells}
    assert {"H", "K", "M_b"} <= cells


@pytest.mark.slow
def test_empty_tables_are_read_and_those_that_are_filled_stay(folder: Path, school: School) -> None:
    pile = read_answers(folder / "answers", school.items, school.book.keys)
    assert not pile.refused
    assert pile.hand_ins == ()  # an empty table is none
    assert pile.empty
    for file in (folder / "answers").glob("*.csv"):
        file.write_text(file.read_text(encoding="utf-8").replace(";;", ";1,5;"), encoding="utf-8")
    pile = read_answers(folder / "answers", school.items, school.book.keys)
    assert sorted(each.number for each in pile.hand_ins) == [1, 2, 3]
    assert all(answer.value == 1.5 for each in pile.hand_ins for answer in each.answers)
    hand_in(school, folder / "answers")
    write_sheets(folder, school.made, school.items, "txt", jobs=1)
    pile = read_answers(folder / "answers", school.items, school.book.keys)
    assert all(answer.text for each in pile.hand_ins for answer in each.answers)


@pytest.mark.slow
def test_sheets_of_other_students_go(folder: Path, school: School) -> None:
    left, kept = folder / "sheets" / "09-Ada.pdf", folder / "sheets" / "plan.txt"
    left.touch()
    kept.touch()
    write_sheets(folder, school.made, school.items, "txt", jobs=1)
    assert not left.exists()
    assert kept.exists()


def test_a_form_that_there_is_not_and_a_missing_package_are_told() -> None:
    with pytest.raises(UsageError, match="no form 'odt'") as fault:
        check_form("odt", "a task sheet", "--sheets")
    assert fault.value.where == "--sheets"


@pytest.mark.slow
def test_notes_are_written_beside_the_keys(folder: Path, school: School) -> None:
    write_notes(folder, school.made, folder / "keys", "txt", jobs=1)
    for variant in school.made.variants:
        text = (folder / "keys" / f"{variant.stem}.txt").read_text(encoding="utf-8")
        assert "Conclusions" in text


def test_the_page_of_the_keys_has_every_value(school: School) -> None:
    text = plain(overview(school.book, "Shaper"))
    rows = [line for line in text.splitlines() if re.match(r" +0[123] ", line)]
    assert len(rows) == 3
    for key, row in zip(school.book.keys, rows, strict=True):
        shown = [float(cell.replace("−", "-")) for cell in row.split()[-len(school.items) :]]
        assert shown == pytest.approx(key.values, rel=5.1e-4)
    assert "the other sign" in text
