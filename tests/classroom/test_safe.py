"""What students get tells no answer: every file is opened, and its text and what is said of it are searched."""

from __future__ import annotations

import re
from io import StringIO
from pathlib import Path
from shutil import copytree
from xml.etree import ElementTree

import pytest

from classroom.leaking import beginning, given_in, leaks, numbers_in, words_of
from classroom.school import School, hand_in
from tmmcalc.classroom.gradebook import gradebook
from tmmcalc.classroom.grading import graded, own_marks
from tmmcalc.classroom.marking import Rules
from tmmcalc.classroom.marksdocument import hints_document, marks_document
from tmmcalc.classroom.marksheets import as_csv, students_sheet
from tmmcalc.classroom.moodle.elements import quiz
from tmmcalc.classroom.moodle.numerical import questions_of
from tmmcalc.classroom.moodle.scenes import scenes_of
from tmmcalc.classroom.papers.making import named
from tmmcalc.classroom.papers.overview import overview
from tmmcalc.classroom.papers.results import student_results
from tmmcalc.classroom.papers.sheets import write_sheets
from tmmcalc.classroom.statistics import statistics_of
from tmmcalc.note.assembled import drawn
from tmmcalc.note.forms import FORMS, formed
from tmmcalc.pipeline.chapters import task_of
from tmmcalc.pipeline.runner import run
from tmmcalc.project import load_spec
from tmmcalc.report.document import Document
from tmmcalc.report.drawing import written
from tmmcalc.report.manuscript import Figure
from tmmcalc.report.render import render
from tmmcalc.report.worksheets import Worksheet


def printed(document: Document) -> str:
    stream = StringIO()
    render(document, "table", stream)
    return stream.getvalue()


@pytest.fixture(scope="module")
def given(school: School) -> set[str]:
    return given_in(school)


@pytest.fixture(scope="module")
def files(school: School, tmp_path_factory: pytest.TempPathFactory) -> list[Path]:
    """All that students of the class may get."""
    place = tmp_path_factory.mktemp("handed")
    copytree(school.folder.parent, place, dirs_exist_ok=True)
    folder = place / "class"
    for form in FORMS:
        write_sheets(folder, school.made, school.items, form, jobs=1)
    for each in school.made.variants:
        spec = load_spec(folder / "variants" / f"{each.stem}.toml")
        (scheme,) = (block for block in task_of(spec, run(spec).results) if isinstance(block, Figure))
        for suffix in ("svg", "png"):
            (place / f"{each.stem}.{suffix}").write_bytes(written(suffix, drawn(scheme)))
    (place / "keys").mkdir(exist_ok=True)
    wrong = hand_in(school, place / "wrong", 1.37)
    marks, _, _ = graded(folder, wrong, folder / "keys")
    assert marks.counting
    for marked in marks.counting:
        (place / f"result-{marked.number}.md").write_text(students_sheet(marks, marked), encoding="utf-8")
        for form in FORMS:
            who = named(marked.number, marked.student)
            (place / f"result-{marked.number}.{form}").write_bytes(
                formed(student_results(marks, marked, who), form, who)
            )
        stem = school.made.variants[marked.number - 1].stem
        hints = hints_document(*own_marks(folder / "variants" / f"{stem}.toml", wrong / f"{stem}.csv"))
        (place / f"hints-{marked.number}.txt").write_text(printed(hints), encoding="utf-8")
    (place / "gradebook.csv").write_text(as_csv(gradebook(marks, "Shaper")), encoding="utf-8")
    (place / "printed.txt").write_text(printed(marks_document(marks, statistics_of(marks))), encoding="utf-8")
    kept = {folder / "keys", place / "wrong", place / "keys"}
    return [each for each in sorted(place.rglob("*")) if each.is_file() and not {*each.parents} & kept]


@pytest.mark.slow
def test_no_file_for_students_tells_an_answer(files: list[Path], school: School, given: set[str]) -> None:
    kinds = {each.suffix for each in files}
    assert kinds >= {".pdf", ".docx", ".html", ".typ", ".txt", ".svg", ".png", ".toml", ".csv", ".md"}
    assert len(files) > 50
    found = {each.name: leaks(words_of(each), school, given) for each in files if each.name != "roster.txt"}
    assert {name: told for name, told in found.items() if told} == {}


def test_questions_tell_nothing_beside_their_answers(school: School, given: set[str]) -> None:
    """Texts, schemes and feedback of a quiz; its answers are for the course alone."""
    scenes = scenes_of(school.folder, school.made, school.items, jobs=1)
    root = ElementTree.fromstring(quiz(questions_of(school.book, scenes, "Shaper", "shaper", Rules())))
    for each in root.iter("answer"):
        for name in ("text", "tolerance"):
            part = each.find(name)
            assert part is not None
            part.text = ""
    for each in root.iter("file"):
        each.text = ""
    text = re.sub(r"<[^>]*>", " ", " ".join(root.itertext()))
    assert leaks(text, school, given) == set()
    for scene in scenes:
        assert leaks(" ".join(ElementTree.fromstring(scene.scheme).itertext()), school, given) == set()


@pytest.mark.parametrize("form", FORMS)
def test_what_is_looked_for_is_found_where_it_stands(
    form: str, school: School, given: set[str], tmp_path: Path
) -> None:
    """The page of the keys tells all answers, and each of them is found in it."""
    file = tmp_path / f"keys.{form}"
    file.write_bytes(formed(overview(school.book, "Shaper"), form, "Shaper"))
    found = leaks(words_of(file), school, given)
    everyone = {(key.number, item.name) for key in school.book.keys for item in school.items}
    chance = {
        (key.number, item.name)
        for key in school.book.keys
        for item, value in zip(school.items, key.values, strict=True)
        if beginning(value) in given
    }
    assert found >= everyone - chance
    assert len(chance) < len(everyone) / 4


@pytest.mark.parametrize("text", ["571,4 мм", "H = 0.57143 m", "<b>−571.4</b>", "5.714e2", "571.4285714"])
def test_a_number_is_known_in_any_clothes(text: str) -> None:
    assert "5714" in {*numbers_in(text)}


def test_pictures_and_workbooks_are_searched_too(school: School, given: set[str], tmp_path: Path) -> None:
    value = next(v for v in school.book.keys[0].values if beginning(v) not in given)
    picture = tmp_path / "a.svg"
    picture.write_text(f'<svg xmlns="http://www.w3.org/2000/svg"><desc>{value:.5g}</desc></svg>', encoding="utf-8")
    assert leaks(words_of(picture), school, given)
    from tmmcalc.report.workbook import workbook

    book = tmp_path / "a.xlsx"
    book.write_bytes(workbook([Worksheet("a", ["x"], [[f"{value:.5g}"]])], "a"))
    assert leaks(words_of(book), school, given)
