"""What students hand in: every kind of file and table, by name, number, position and unit."""

from __future__ import annotations

import math
import os
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import pytest
from xlsxwriter.workbook import Workbook

from classroom.books import STUDENTS, VALUES, item, press_class
from tmmcalc.classroom.answers.handed import HandIn, Pile
from tmmcalc.classroom.answers.naming import Names
from tmmcalc.classroom.answers.positions import UNKNOWN, Steps
from tmmcalc.classroom.answers.reading import read_answers
from tmmcalc.classroom.grading import steps_of
from tmmcalc.classroom.model import Item, Key
from tmmcalc.project.loader import load_spec

BOOK = press_class()
FIRST = VALUES[0]
PRESS = Path(__file__).parents[2] / "configs" / "assignment-press.toml"


def read(place: Path, steps: Steps = UNKNOWN) -> Pile:
    return read_answers(place, BOOK.items, BOOK.keys, steps)


def only(place: Path, steps: Steps = UNKNOWN) -> HandIn:
    pile = read(place, steps)
    assert pile.refused == ()
    (found,) = pile.hand_ins
    return found


def values(found: HandIn) -> tuple[float, ...]:
    return tuple(answer.value for answer in found.answers)


def written(folder: Path, name: str, text: str, encoding: str = "utf-8") -> Path:
    file = folder / name
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_bytes(text.encode(encoding))
    return file


PAIRS = "H;120,5;мм\nω2;3,25;с⁻¹\nK;1,213\nR_A@3;4512;Н\nforces.R_A@7;6,03\nv_D;−812;mm/s\n"


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16", "utf-16-le", "utf-16-be"])
def test_pairs_in_any_encoding(tmp_path: Path, encoding: str) -> None:
    found = only(written(tmp_path, "01.csv", PAIRS, encoding))
    assert found.number == 1
    assert values(found) == pytest.approx(FIRST, rel=1e-12)


def test_cp1251(tmp_path: Path) -> None:
    text = "хід;120,5;мм\nкоефіцієнт K;1,213;\nреакція R_A@3;4512;Н\n"
    found = only(written(tmp_path, "Коваль.csv", text, "cp1251"))
    assert (found.number, values(found)[0], values(found)[2], values(found)[3]) == (2, 120.5, 1.213, 4.512)


@pytest.mark.parametrize("delimiter", [",", ";", "\t", "|"])
def test_any_delimiter(tmp_path: Path, delimiter: str) -> None:
    rows = [("H", "120.5", "mm"), ("omega_2", "3.25", "rad/s"), ("K", "1.213", ""), ("v_D", "-0.812", "m/s")]
    found = only(written(tmp_path, "1.csv", "\n".join(map(delimiter.join, rows))))
    assert values(found)[:3] == FIRST[:3]


def test_lines_of_a_text(tmp_path: Path) -> None:
    found = only(written(tmp_path, "1.txt", "H = 120,5 мм\nK: 1,213\nomega_2 = 31,04 об/хв\n"))
    assert values(found)[:3] == pytest.approx((120.5, 31.04 * math.pi / 30, 1.213))


def test_a_quoted_decimal_comma(tmp_path: Path) -> None:
    found = only(written(tmp_path, "1.csv", 'H,"120,5",mm\nK,"1,213",\n'))
    assert values(found)[0] == 120.5


@pytest.mark.parametrize(
    "head", ["студент;H, мм;ω2 [1/с];K", "student;stroke h (mm);OMEGA_2;k", "№;H;ω 2;К\n;мм;рад/с;-", "Прізвище;H;ω2;K"]
)
def test_one_table_for_the_class(tmp_path: Path, head: str) -> None:
    rows = [f"{name};{v[0]};{v[1]};{v[2]}".replace(".", ",") for name, v in zip(STUDENTS, VALUES, strict=True)]
    pile = read(written(tmp_path, "class.csv", "\n".join([head, *rows])))
    assert pile.refused == ()
    assert [(each.number, *values(each)[:3]) for each in pile.hand_ins] == [
        (k + 1, *v[:3]) for k, v in enumerate(VALUES)
    ]


def test_a_column_a_student(tmp_path: Path) -> None:
    text = "величина;Бондар Іван;Коваль Олена;№ 3\nH, мм;120,5;131,2;118,4\nK;1,213;;1,188\n"
    pile = read(written(tmp_path, "class.csv", text))
    assert [(each.number, each.answers[0].value, each.answers[2].text) for each in pile.hand_ins] == [
        (1, 120.5, "1,213"),
        (2, 131.2, ""),
        (3, 118.4, "1,188"),
    ]


def test_the_long_form(tmp_path: Path) -> None:
    text = "варіант;величина;значення;одиниця\n1;H;12,05;см\n;K;1,213;\n2;хід;131,2;мм\n2;K;abc;\n"
    pile = read(written(tmp_path, "all.csv", text))
    first, second = pile.hand_ins
    assert values(first)[0] == 120.5
    assert values(first)[2] == 1.213
    assert values(second)[0] == 131.2
    assert (second.answers[2].text, second.answers[2].fault) == ("abc", "no number")


def test_a_column_of_names_is_that_of_items_where_they_stand_in_it(tmp_path: Path) -> None:
    """A table of students has a column of names too."""
    found = only(written(tmp_path, "5.csv", "name;unit;value\nH;cm;12.05\nK;;1.213\n"))
    assert (found.number, values(found)[0], values(found)[2]) == (5, 120.5, 1.213)
    pile = read(written(tmp_path, "all.csv", "name;item;value\nБондар Іван;H;120.5\n;K;1.213\n"))
    assert [(each.number, values(each)[2]) for each in pile.hand_ins] == [(1, 1.213)]


@pytest.mark.parametrize(
    "name", ["5.csv", "05-x.csv", "variant5.csv", "Варіант 5.csv", "шевчук.csv", "Олег Шевчук_лаб2.csv"]
)
def test_the_name_of_a_file_says_whose_it_is(tmp_path: Path, name: str) -> None:
    assert only(written(tmp_path, name, "H;1\nK;2\n")).number == 5


@pytest.mark.parametrize(
    "name",
    ["Ковалеко Олена КМ-3 лаб.csv", "3 Шевчук_лаб.csv", "лаб 3.csv", "3-Ковль.csv", "№3 Олена.csv", "1.5.csv", "в.csv"],
)
def test_a_number_of_something_else_is_nobody(tmp_path: Path, name: str) -> None:
    """Of a group, of a task, beside a misspelled name: it is not taken for that of a variant."""
    pile = read(written(tmp_path, name, "H;1\nK;2\n"))
    if "Шевчук" in name:
        assert [each.number for each in pile.hand_ins] == [5]
    else:
        assert pile.hand_ins == ()
        assert [each.message for each in pile.refused] == ["does not say whose it is"]


@pytest.mark.parametrize(
    "name", ["КМ-3 вар 5.csv", "5 лаб 3.csv", "lab3_v5.csv", "№ 05, лаб 3.csv", "Шевчук Олег/3.csv"]
)
def test_a_number_of_a_variant_among_others(tmp_path: Path, name: str) -> None:
    written(tmp_path, name, "H;1\nK;2\n")
    assert only(tmp_path).number == 5


def test_without_names_a_number_is_of_the_variant(tmp_path: Path) -> None:
    keys = [Key(k + 1, "", values, ()) for k, values in enumerate(VALUES)]
    written(tmp_path, "КМ лаб 5.csv", "H;1\nK;2\n")
    assert [each.number for each in read_answers(tmp_path, BOOK.items, keys).hand_ins] == [5]


def test_empty_rows_are_no_hand_in(tmp_path: Path) -> None:
    names = [f"{name};;" for name in STUDENTS[1:]]
    wide = written(tmp_path, "wide.csv", "\n".join(["студент;H;K", f"{STUDENTS[0]};120,5;", *names]))
    turned = written(tmp_path, "turned.csv", "величина;№ 1;№ 2;№ 3\nH;120,5;;-\nK;;;\n")
    for file in (wide, turned):
        assert only(file).number == 1


@pytest.mark.parametrize("line", ["stroke H;240", "H;240;мм", "хід\t240", "H = 240 мм"])
def test_one_line(tmp_path: Path, line: str) -> None:
    assert only(written(tmp_path, "1.csv", line)).answers[0].value == 240.0


GREEK = {
    "epsilon_3": ("ε3", "ε_3", "eps_3", "eps3", "ϵ₃", "епсилон 3", "Epsilon3"),
    "ω_2": ("omega_2", "Ω2", "омега2", "ω₂", "omega 2"),
    "alpha": ("α", "альфа", "Alpha"),
    "фі": ("φ", "ϕ", "phi", "fi", "Фи"),
}


@pytest.mark.parametrize("name", GREEK)
def test_greek_letters_by_any_name(name: str) -> None:
    names = Names([item(name), item("x")])
    assert [names.item(text) for text in (name, *GREEK[name])] == [0] * (1 + len(GREEK[name]))


@pytest.mark.parametrize("name", ["Шевчук Олег_123456_assignsubmission_file_/answers.csv", "2026-01-02/Шевчук.csv"])
def test_a_folder_says_whose_it_is_by_name(tmp_path: Path, name: str) -> None:
    written(tmp_path, name, "H;1\nK;2\n")
    assert only(tmp_path).number == 5


@pytest.mark.parametrize("row", ["student;Шевчук Олег", "варіант;5", "Варіант: 5", "Студент Шевчук"])
@pytest.mark.parametrize("table", ["H;1\nK;2\n", "H;K\n1;2\n"])
def test_a_row_says_whose_it_is(tmp_path: Path, row: str, table: str) -> None:
    found = only(written(tmp_path, "answers.csv", f"{row}\n{table}"))
    assert (found.number, *values(found)[::2][:2]) == (5, 1.0, 2.0)


def test_positions_by_number(tmp_path: Path) -> None:
    rows = [f"{n};{n * 30};{100 + n};{0.1 * n:.2f}" for n in range(12)]
    found = only(written(tmp_path, "1.csv", "положення;φ, °;R_A, Н;omega_2, рад/с\n" + "\n".join(rows)))
    assert (found.answers[3].value, found.answers[4].value, found.answers[1].value) == (0.103, 0.107, 0.3)


def test_positions_by_angle(tmp_path: Path) -> None:
    rows = [f"{20 + n * 30};{100 + n};{0.1 * n:.2f}" for n in range(12)]
    text = "φ;R_A;omega_2\n°;Н;рад/с\n" + "\n".join(rows)
    found = only(written(tmp_path, "1.csv", text), steps=Steps(30.0))
    assert (found.answers[3].value, found.answers[4].value, found.answers[1].value) == (0.103, 0.107, 0.3)


def test_a_place_by_its_angle(tmp_path: Path) -> None:
    found = only(written(tmp_path, "1.csv", "phi[rad];vS_D[m/s]\n0;1\n0,785398;−0,812\n1,5708;3\n"))
    assert found.answers[5].value == -0.812


def test_toml(tmp_path: Path) -> None:
    text = 'student = "Коваль"\n"ω2" = 2.880\n[answers]\nH = "131,2 мм"\nK = {value = 1.301, unit = ""}\n'
    found = only(written(tmp_path, "answers.toml", text))
    assert (found.number, *values(found)[:3]) == (2, 131.2, 2.88, 1.301)
    assert found.answers[1].figures == 4  # as it is written


def test_toml_of_a_class(tmp_path: Path) -> None:
    pile = read(written(tmp_path, "all.toml", '[1]\nH = 1\n["Коваль Олена"]\nkinematics.stroke_D = 2\n'))
    assert [(each.number, each.answers[0].value) for each in pile.hand_ins] == [(1, 1.0), (2, 2.0)]


def book(file: Path, *sheets: list[list[object]]) -> Path:
    made = Workbook(file)
    for rows in sheets:
        sheet = made.add_worksheet()
        for k, row in enumerate(rows):
            for j, cell in enumerate(row):
                if isinstance(cell, tuple):
                    sheet.write_formula(k, j, *cell)
                elif isinstance(cell, str):
                    sheet.write_string(k, j, cell)
                else:
                    sheet.write(k, j, cell)
    made.close()
    return file


def test_a_workbook(tmp_path: Path) -> None:
    file = book(
        tmp_path / "1.xlsx",
        [["notes of mine"], [1, 2]],
        [["H", 0.1 + 0.2, "м"], ["K", ("=1+1", None, 1.25)], ["omega_2", "3,25", "1/с"], ["v_D", ("=2+2", None, "")]],
    )
    found = only(file)
    assert (found.answers[0].value, found.answers[0].figures) == (300.0, 1)
    assert found.answers[2].value == 1.25
    assert found.answers[1].value == 3.25
    assert found.answers[5].fault == "a formula; write the number"


def test_a_workbook_of_openpyxl(tmp_path: Path) -> None:
    import datetime

    import openpyxl

    made = openpyxl.Workbook()
    sheet = made.active
    for row in (["student", "H [mm]", "K"], ["Коваль", 131.2, "=1+1"], [1, 120.5, datetime.date(2026, 5, 11)]):
        sheet.append(row)
    made.save(tmp_path / "x.xlsx")
    first, second = read(tmp_path / "x.xlsx").hand_ins
    assert (first.number, first.answers[0].value, first.answers[2].fault[:9]) == (2, 131.2, "a formula")
    assert (second.number, second.answers[0].value, second.answers[2].text) == (1, 120.5, "a date")


def test_the_later_of_two_comes_last(tmp_path: Path) -> None:
    for folder, name, at in (("2", "1.csv", 10), ("1", "1.csv", 20), ("1", "01.csv", 30)):
        os.utime(written(tmp_path, f"{folder}/{name}", f"H;{at}\nK;2\n"), (at, at))
    assert [each.answers[0].value for each in read(tmp_path).hand_ins] == [20.0, 30.0, 10.0]
    by_date = tmp_path / "by date"
    for folder, at in (("01.06.2026", 10), ("2026-05-30", 20)):
        os.utime(written(by_date, f"{folder}/1.csv", f"H;{at}\nK;2\n"), (at, at))
    assert [each.answers[0].value for each in read(by_date).hand_ins] == [20.0, 10.0]


def test_an_item_that_stands_twice(tmp_path: Path) -> None:
    found = only(written(tmp_path, "1.csv", "H;1\nK;2\nхід;3\nsize;7\n"))
    assert found.answers[0].value == 3.0
    assert len(found.remarks) == 2
    assert "twice" in found.remarks[0]
    assert "'size'" in found.remarks[1]


def handed(folder: Path, text: str, items: Sequence[Item], **more: Any) -> HandIn:
    """What a table tells of a class of one."""
    key = Key(1, "", (1.0,) * len(items), ())
    pile = read_answers(written(folder, "1.csv", text), items, [key], **more)
    assert pile.refused == ()
    (found,) = pile.hand_ins
    return found


CAM = (item("s", result="cam_law.dS@4", unit="mm"), item("ds", result="cam_law.S1@4", unit="mm"))


def test_what_an_item_is_called_goes_before_the_result_of_another(tmp_path: Path) -> None:
    found = handed(tmp_path, "n;s;ds\n3;1;2\n4;4,75;15,59\n", CAM)
    assert (values(found), found.remarks) == ((4.75, 15.59), ())
    one, other = item("x", result="kinematics.K"), item("K", result="kinematics.K_D")
    assert [Names([one, other]).item(text) for text in ("k", "x", "kinematics.K")] == [1, 0, 0]


def test_a_column_of_two_results_is_of_none(tmp_path: Path) -> None:
    items = [item("first", result="cam_law.v@4"), item("other", result="kinematics.v@4")]
    found = handed(tmp_path, "n;v;first;other\n4;1;2;3\n", items)
    assert (values(found), found.remarks) == ((2.0, 3.0), ())


MIXED = (
    item("H", result="kinematics.stroke_B", unit="mm"),
    item("R", result="forces.R_B@1", unit="kN"),
    item("K", result="kinematics.K_B"),
)


@pytest.mark.parametrize(
    "head",
    ["Од.", "од", "Од. виміру", "Од. вим.", "Одиниці виміру", "[од.]", "Одиниця вимірювання", "(units)", "У чому", ""],
)
def test_a_column_of_units_by_any_header(tmp_path: Path, head: str) -> None:
    found = handed(tmp_path, f"Назва;Значення;{head}\nH;12,05;см\nR;4512;Н\nK;1,2;-\n", MIXED)
    assert values(found) == pytest.approx((120.5, 4.512, 1.2), rel=1e-12)
    assert found.remarks == ()


@pytest.mark.parametrize("head", ["Од.", "Од. виміру", "Одиниці виміру", "[од.]"])
def test_a_header_of_units_is_known_whatever_stands_under_it(tmp_path: Path, head: str) -> None:
    found = handed(tmp_path, f"Назва;Значення;{head}\nH;12,05;см\nR;4;умовна\nK;1,2;немає\n", MIXED)
    assert (found.answers[0].value, found.answers[1].fault) == (120.5, "'умовна' is no unit that is known")


def test_a_column_that_is_not_used_is_told(tmp_path: Path) -> None:
    text = "№;Назва;Значення;Перевірка;Од.;Примітка\n1;H;12,05;12;см;за планом\n2;R;4;4;кН;\n3;K;1,2;1;;\n"
    found = handed(tmp_path, text, MIXED)
    assert values(found) == pytest.approx((120.5, 4.0, 1.2), rel=1e-12)
    assert found.remarks == ("columns of which nothing is read: 'Перевірка', 'Примітка'",)


def test_many_columns_that_are_not_used_are_told_in_short(tmp_path: Path) -> None:
    heads = ";".join(f"x{k}" for k in range(7))
    found = handed(tmp_path, f"Назва;Значення;{heads}\nH;12{';0' * 7}\n", MIXED)
    assert found.remarks == ("columns of which nothing is read: 'x0', 'x1', 'x2', 'x3', 'x4' and 2 more",)


def test_a_unit_of_the_header_is_of_the_results_that_it_fits(tmp_path: Path) -> None:
    found = handed(tmp_path, "Назва;Значення, Н\nH;120,5\nR;4512\nK;1,2\n", MIXED)
    assert values(found) == pytest.approx((120.5, 4.512, 1.2), rel=1e-12)


DRAWN = '[[class.drawn]]\nof = "mechanism.input.start"\namong = ["0 deg", "10 deg"]'
AT = (item("R", result="forces.R_B@10"), item("M", result="forces.M@4"))
TURN = range(12)


def over(*angles: float, head: str = "φ, °;R;M") -> str:
    """A table whose values tell the angles of their rows."""
    return "\n".join([head, *(f"{angle:g};{1000 + angle:g};{2000 + angle:g}" for angle in angles)])


@pytest.mark.parametrize(
    ("steps", "angles", "at"),
    [
        (Steps(30.0, 0.0), [30.0 + 30 * k for k in TURN], (300, 120)),  # begins with position 1
        (Steps(30.0, 0.0), [90.0, 120, 300], (300, 120)),
        (Steps(30.0, 0.0), [300.0, 120], (300, 120)),
        (Steps(30.0, 20.0), [50.0 + 30 * k for k in TURN], (320, 140)),
        (Steps(30.0, 20.0), [30.0 + 30 * k for k in TURN], (300, 120)),  # counted from position 0
        (Steps(-30.0, 20.0), [20.0 - 30 * k for k in TURN], (-280, -100)),
        (Steps(30.0), [30.0 * k for k in TURN], (300, 120)),
        (Steps(30.0), [20 + 30.0 * k for k in TURN], (320, 140)),
        (Steps(30.0), [20 - 30.0 * k for k in TURN], (-280, -100)),
    ],
)
def test_a_table_over_angles(tmp_path: Path, steps: Steps, angles: list[float], at: tuple[int, int]) -> None:
    found = handed(tmp_path, over(*angles), AT, steps=steps)
    assert (values(found), found.remarks) == ((1000.0 + at[0], 2000.0 + at[1]), ())


@pytest.mark.parametrize(
    ("steps", "angles", "what"),
    [
        (Steps(30.0, 60.0), [30.0 * k for k in TURN], "two rows may be that of position 10, at 0 deg or 300 deg"),
        (Steps(30.0, 0.0), [15.0 + 30 * k for k in TURN], "no row is that of position 10, at 300 deg"),
        (Steps(30.0), [30.0 + 30 * k for k in TURN], "two rows may be that of position 10, at 330 deg or 300 deg"),
        (Steps(30.0), [90.0, 120, 300], "no row is that of position 10, whose angle is not known"),
        (UNKNOWN, [30.0 * k for k in TURN], "no row is that of position 10, whose angle is not known"),  # as of a cam
    ],
)
def test_a_row_that_is_not_found_for_certain(tmp_path: Path, steps: Steps, angles: list[float], what: str) -> None:
    key = Key(1, "", (1.0, 1.0), ())
    (refused,) = read_answers(written(tmp_path, "1.csv", over(*angles)), AT, [key], steps).refused
    assert refused.message.startswith(f"names results over positions, and answers none: R: {what}; M: ")
    assert refused.remedy == "write the number of each position in a column position"


def test_a_position_that_is_not_there_is_told_beside_the_others(tmp_path: Path) -> None:
    found = handed(tmp_path, over(90, 120), AT, steps=Steps(30.0, 0.0))
    assert found.remarks == ("R: no row is that of position 10, at 300 deg",)
    assert found.answers[1].value == 2120.0
    by_angle = [item("M", result="forces.M[phi=45 deg]"), item("R", result="forces.R_B[phi=60 deg]")]
    found = handed(tmp_path, over(45, 50), by_angle)
    assert (found.answers[0].value, found.remarks) == (2045.0, ("R: no row is that of the angle 60 deg",))
    found = handed(tmp_path, over(3, 4, head="положення;R;M"), AT)
    assert found.remarks == ("R: no row is that of position 10",)


def test_a_position_in_another_sheet_is_there(tmp_path: Path) -> None:
    sheets: list[list[list[object]]] = [[["n", "R", "M"], [k, 100 + k, 200 + k]] for k in (10, 4)]
    (found,) = read_answers(book(tmp_path / "1.xlsx", *sheets), AT, [Key(1, "", (1.0, 1.0), ())]).hand_ins
    assert (values(found), found.remarks) == ((110.0, 204.0), ())


@pytest.mark.parametrize(
    ("changes", "steps"),
    [
        ({}, Steps(30.0, 0.0)),
        ({'start = "0 deg"': 'start = "20 deg"', 'speed = "120 rpm"': 'speed = "-120 rpm"'}, Steps(-30.0, 20.0)),
        ({"[[class.asked]]": f"{DRAWN}\n\n[[class.asked]]"}, Steps(30.0)),
        ({"positions = 12": "positions = 12\nextremes = true"}, UNKNOWN),
    ],
)
def test_where_the_positions_of_an_assignment_are(tmp_path: Path, changes: dict[str, str], steps: Steps) -> None:
    text = PRESS.read_text(encoding="utf-8")
    for old, new in changes.items():
        assert old in text
        text = text.replace(old, new, 1)
    found = steps_of(load_spec(written(tmp_path, "press.toml", text)))
    assert (found.step, found.start) == pytest.approx((steps.step, steps.start), nan_ok=True)


def test_angles_in_minutes_and_seconds(tmp_path: Path) -> None:
    items = [item("alpha", unit="deg"), item("beta", unit="rad"), item("H", unit="mm")]
    found = handed(tmp_path, "alpha;20°38'\nbeta;20° 38' 15\"\nH;20°38'\n", items)
    assert values(found)[:2] == pytest.approx((20 + 38 / 60, math.radians(20 + 38 / 60 + 15 / 3600)), rel=1e-12)
    assert "no unit of" in found.answers[2].fault


@pytest.mark.parametrize("prime", ["'", "′", "’", "''", "″"])
def test_a_derivative_is_not_what_it_is_of(tmp_path: Path, prime: str) -> None:
    found = handed(tmp_path, f"n;s;s{prime};ds\n4;4,75;9;15,59\n", CAM)
    assert (values(found), found.remarks) == ((4.75, 15.59), ())
    names = Names([item("s"), item(f"s{prime}"), item("x", result="forces.R_A@6"), item("y", result="forces.R_A@6'")])
    assert [names.item(text) for text in ("s", f"S {prime}", "'s'", "R A @ 6", "R A @ 6′")] == [0, 1, 0, 2, 3]
