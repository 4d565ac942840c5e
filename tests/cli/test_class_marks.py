"""`tmmcalc class mark` and `class hints`: files in, marks out, and nothing of the key where students look."""

from __future__ import annotations

import csv
import io
import os
import re
from pathlib import Path

import openpyxl
import pytest

from cli.conftest import Cli
from tmmcalc.classroom.items import items_of
from tmmcalc.classroom.keybook import write_keybook
from tmmcalc.classroom.keying import key_of
from tmmcalc.classroom.model import Key, Keybook
from tmmcalc.classroom.state import Class, Variant, digest_of, write_class
from tmmcalc.project import load_spec

ASKED = """
[class]
tolerance = "1 %"

[[class.asked]]
result = "kinematics.stroke_D"
name = "H"
also = ["хід"]
unit = "mm"

[[class.asked]]
result = "kinematics.omega_3@3"
name = "omega_3"
weight = 2

[[class.asked]]
result = "kinematics.vS_D@3"
name = "v_D"
after = ["omega_3^1"]

[[class.asked]]
result = "kinematics.aS_D@3"
name = "a_D"
after = ["omega_3^2"]
"""
RIGHT = (100.0, -3.21, 0.456, -6.54)
STUDENTS = ("Бондар Іван", "Коваль Олена", "Мельник Петро")


@pytest.fixture
def spec(folder: Path) -> Path:
    """The shaper as an assignment, in which something is asked."""
    text = (folder / "my.toml").read_text(encoding="utf-8")
    file = folder / "assignment.toml"
    file.write_text(text + ASKED, encoding="utf-8")
    return file


def keys_of(spec: Path) -> Keybook:
    """Keys of three students, by hand: what is right of each is made up."""
    items = items_of(load_spec(spec))
    keys = tuple(Key(k + 1, name, tuple(v * (1 + k / 10) for v in RIGHT), ()) for k, name in enumerate(STUDENTS))
    book = Keybook(items, (), keys)
    write_keybook(book, spec.parent / "keys")
    return book


def handed(file: Path, *values: object) -> None:
    file.parent.mkdir(parents=True, exist_ok=True)
    names = ("H", "omega_3", "v_D", "a_D")
    file.write_text("".join(f"{name};{value}\n" for name, value in zip(names, values, strict=True)), encoding="utf-8")


def rows(text: str) -> list[dict[str, str]]:
    return list(csv.DictReader(io.StringIO(text.removeprefix("\ufeff"))))


def test_marks_of_a_class(cli: Cli, spec: Path, folder: Path) -> None:
    keys_of(spec)
    handed(folder / "answers" / "Бондар.csv", "100,0 мм", "-3,21", "0,456", "-6,54")
    handed(folder / "answers" / "2.csv", "0,110 м", "-3,88", "0,551", "-8,697")  # omega by 1.0988, carried on
    (folder / "answers" / "Мельник.xlsx").write_bytes(b"PK\x03\x04 broken")
    done = cli(
        "class", "mark", "assignment.toml", "answers", "-o", "marks.csv", "--full", "all.xlsx", "--sheets", "for"
    )
    assert done.code == 0
    found = rows((folder / "marks.csv").read_text(encoding="utf-8"))
    assert [(row["student"], row["points"], row["of"]) for row in found] == [
        ("Бондар Іван", "5", "5"),
        ("Коваль Олена", "2.6", "5"),
        ("Мельник Петро", "", "5"),
    ]
    assert [found[1][f"{name}: is"] for name in ("H", "omega_3", "v_D", "a_D")] == [
        "right",
        "wrong",
        "carried on",
        "carried on",
    ]
    assert "Мельник.xlsx is a damaged or locked workbook" in done.err
    book = openpyxl.load_workbook(folder / "all.xlsx")
    assert book.sheetnames == ["marks", "answers", "mistakes", "items", "common mistakes", "remarks"]
    assert sorted(file.name for file in (folder / "for").iterdir()) == ["01-Бондар_Іван.md", "02-Коваль_Олена.md"]
    sheet = (folder / "for" / "02-Коваль_Олена.md").read_text(encoding="utf-8")
    for k, value in enumerate(RIGHT[1:]):
        assert f"{abs(value) * 1.1:.3g}" not in sheet, k


def test_marks_again_after_a_changed_tolerance_and_a_second_hand_in(cli: Cli, spec: Path, folder: Path) -> None:
    keys_of(spec)
    handed(folder / "answers" / "1" / "1.csv", "104,0", "-3,21", "0,456", "-6,54")
    assert cli("class", "mark", "assignment.toml", "answers", "-o", "marks.csv").code == 0
    assert rows((folder / "marks.csv").read_text(encoding="utf-8"))[0]["points"] == "4"
    spec.write_text(spec.read_text(encoding="utf-8").replace('"1 %"', '"5 %"'), encoding="utf-8")
    assert cli("class", "mark", "assignment.toml", "answers", "-o", "marks.csv").code == 0
    assert rows((folder / "marks.csv").read_text(encoding="utf-8"))[0]["points"] == "5"
    handed(folder / "answers" / "2" / "1.csv", "104,0", "3,21", "", "")
    os.utime(folder / "answers" / "2" / "1.csv", (0, 0))
    assert cli("class", "mark", "assignment.toml", "answers", "-o", "marks.csv", "--full", "all.md").code == 0
    assert rows((folder / "marks.csv").read_text(encoding="utf-8"))[0]["points"] == "1"
    assert "1/1.csv: 5 points; a later one counts" in (folder / "all.md").read_text(encoding="utf-8")


def test_one_table_for_the_class(cli: Cli, spec: Path, folder: Path) -> None:
    keys_of(spec)
    (folder / "all.csv").write_text("студент;хід\nКоваль;0,11 м\nБондар;=1+1\nНетака;3\n", encoding="utf-8")
    done = cli("class", "mark", "assignment.toml", "all.csv", "-o", "marks.csv")
    assert done.code == 0
    assert [row["H: is"] for row in rows((folder / "marks.csv").read_text(encoding="utf-8"))] == [
        "unreadable",
        "right",
        "",
    ]
    assert "'Нетака' (row 4)" in done.err


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (('name = "H"', 'name = "H"\nresult2 = 1'), "result2"),
        (("kinematics.stroke_D", "kinematics.K_D"), "the keys have kinematics.stroke_D in mm"),
        (('unit = "mm"', 'unit = "m"'), "kinematics.stroke_D in m is asked"),
        (('after = ["omega_3^1"]', 'after = ["omega_3^x"]'), "no asked result is called"),
    ],
)
def test_keys_of_something_else(cli: Cli, spec: Path, folder: Path, change: tuple[str, str], message: str) -> None:
    keys_of(spec)
    handed(folder / "answers" / "1.csv", 1, 2, 3, 4)
    spec.write_text(spec.read_text(encoding="utf-8").replace(*change), encoding="utf-8")
    done = cli("class", "mark", "assignment.toml", "answers", "-o", "marks.csv")
    assert done.code == 2
    assert message in done.err
    assert not (folder / "marks.csv").exists()


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["nowhere.toml", "answers"], "nowhere.toml"),
        (["assignment.toml", "nowhere"], "there is no nowhere"),
        (["my.toml", "answers"], "nothing is asked"),
        (["assignment.toml", "answers", "-o", "marks.doc"], "no table of marks"),
        (
            ["assignment.toml", "answers", "-o", "a.csv", "--full", "a.csv"],
            "-o, --full, --gradebook, --sheets: a.csv would be",
        ),
        (
            ["assignment.toml", "answers", "-o", "a.csv", "--sheets", "a.csv"],
            "-o, --full, --gradebook, --sheets: a.csv would be",
        ),
        (["assignment.toml", "answers", "--keys", "nowhere"], "there are no keys"),
        (["assignment.toml", "answers", "--sheets", "my.toml"], "no folder"),
    ],
)
def test_faults_of_the_words(cli: Cli, spec: Path, folder: Path, words: list[str], message: str) -> None:
    keys_of(spec)
    handed(folder / "answers" / "1.csv", 1, 2, 3, 4)
    done = cli("class", "mark", *words)
    assert done.code == 2
    assert message in done.err
    assert not (folder / "a.csv").exists()


@pytest.mark.parametrize("content", [None, b"\x89PNG"])
@pytest.mark.parametrize("form", ["table", "json", "csv", "toml"])
def test_nothing_that_could_be_marked(cli: Cli, spec: Path, folder: Path, content: bytes | None, form: str) -> None:
    keys_of(spec)
    (folder / "answers").mkdir()
    if content is not None:
        (folder / "answers" / "1\n2.csv").write_bytes(content)
    done = cli("class", "mark", "assignment.toml", "answers", "-o", "marks.csv", "--full", "all.md", "-f", form)
    assert done.code == 0
    assert ("1\\n2.csv is a picture" in " ".join(done.err.split())) == (content is not None)
    assert [row["points"] for row in rows((folder / "marks.csv").read_text(encoding="utf-8"))] == [""] * 3


def test_hints_tell_of_strange_names_and_of_one_student(cli: Cli, spec: Path, folder: Path) -> None:
    (folder / "a.csv").write_text("H;100\nsize;7\n", encoding="utf-8")
    assert "not asked: 'size'" in cli("class", "hints", "assignment.toml", "a.csv").out
    (folder / "a.csv").write_text("student;H\nКоваль;100\nБондар;110\n", encoding="utf-8")
    done = cli("class", "hints", "assignment.toml", "a.csv")
    assert done.code == 2
    assert "tells of 2 students: 'Коваль', 'Бондар'" in done.err


@pytest.mark.slow
def test_hints_tell_no_number(cli: Cli, spec: Path, folder: Path) -> None:
    scene = load_spec(spec)
    values = key_of(1, "", scene, items_of(scene), ()).values
    handed(folder / "a.csv", f"{values[0]:.5g} mm", f"{-values[1]:.5g}", f"{values[2] * 1.37:.5g}", "about two")
    for form in ("table", "json", "csv", "toml"):
        done = cli("class", "hints", "assignment.toml", "a.csv", "-f", form)
        assert done.code == 0
        told = done.out + done.err
        assert "right" in told
        assert "wrong" in told
        own = told.replace(f"{-values[1]:.5g}", "")
        for value in values[1:]:
            for digits in (3, 4, 5, 6):
                assert f"{abs(value):#.{digits}g}" not in own


def test_hints_of_a_spec_that_has_no_solution_tell_no_number(cli: Cli, spec: Path, folder: Path) -> None:
    handed(folder / "a.csv", 1, 2, 3, 4)
    text = spec.read_text(encoding="utf-8")
    broken = re.sub(r'(id = 1\n.*?)"[\d.]+ mm"', r'\1"9000 mm"', text, count=1, flags=re.DOTALL)
    assert broken != text
    spec.write_text(broken, encoding="utf-8")
    done = cli("class", "hints", "assignment.toml", "a.csv")
    assert done.code == 2
    assert "its results cannot be computed" in done.err
    assert done.out == ""


def test_hints_are_told_in_the_language_of_the_student(cli: Cli, spec: Path, folder: Path) -> None:
    handed(folder / "a.csv", 1, 2, 3, 4)
    done = cli("class", "hints", "assignment.toml", "a.csv", "--language", "uk")
    assert done.code == 0
    assert "Оцінка" in done.out
    assert "неправильно" in done.out
    assert not re.search(r"\b(asked|wrong|hint|answer)\b", done.out)


def test_hints_of_what_cannot_be_read(cli: Cli, spec: Path, folder: Path) -> None:
    (folder / "a.csv").write_bytes(b"\x89PNG")
    done = cli("class", "hints", "assignment.toml", "a.csv")
    assert done.code == 2
    assert "is a picture" in done.err


def test_a_spec_in_which_something_is_asked_and_nothing_drawn_makes_no_class(
    cli: Cli, spec: Path, folder: Path
) -> None:
    done = cli("class", "make", "assignment.toml", "-n", "3")
    assert done.code == 2
    assert "nothing is drawn" in done.err
    assert not (folder / "class").exists()


def test_a_class_by_its_folder_is_that_of_its_assignment(cli: Cli, spec: Path, folder: Path) -> None:
    """Tolerances may change after it was made; what decides its numbers may not."""
    keys_of(spec)
    (folder / "class").mkdir()
    students = tuple(Variant(k + 1, name, (), k) for k, name in enumerate(STUDENTS))
    write_class(Class("../assignment.toml", digest_of(load_spec(spec)), 1, 3, students), folder / "class")
    handed(folder / "answers" / "1.csv", "104,0", "-3,21", "0,456", "-6,54")
    for old, new, points in (("", "", "4"), ('"1 %"', '"5 %"', "5")):
        spec.write_text(spec.read_text(encoding="utf-8").replace(old, new), encoding="utf-8")
        assert cli("class", "mark", "class", "answers", "-o", "marks.csv").code == 0
        assert rows((folder / "marks.csv").read_text(encoding="utf-8"))[0]["points"] == points
    spec.write_text(spec.read_text(encoding="utf-8").replace("200 mm", "210 mm"), encoding="utf-8")
    done = cli("class", "mark", "class", "answers", "-o", "marks.csv")
    assert done.code == 2
    assert "the assignment is not that of the class" in done.err
