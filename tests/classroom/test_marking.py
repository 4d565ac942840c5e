"""Verdicts on answers, points, what is carried on, second hand-ins, statistics and sheets."""

from __future__ import annotations

import math
import re
from pathlib import Path

import pytest

from classroom.books import PRESS, STUDENTS, VALUES, item, nothing, press_class
from tmmcalc.classroom.answers.handed import Answer, HandIn, Pile, Refused, answer_of
from tmmcalc.classroom.answers.layouts import Entry
from tmmcalc.classroom.answers.reading import read_answers
from tmmcalc.classroom.marking import Marked, Rules, mark
from tmmcalc.classroom.marksdocument import marks_document
from tmmcalc.classroom.marksheets import as_csv, as_markdown, grades, students_sheet, teachers
from tmmcalc.classroom.model import Item, Key, Keybook, Told
from tmmcalc.classroom.statistics import statistics_of
from tmmcalc.classroom.verdicts import Standing, standing_of

RULES = Rules()


def answer(text: str, of: Item) -> Answer:
    return answer_of(Entry("", 0, text, "", ""), of)


X = item("x")  # 1 %, by plans 3 %, four figures
ZEROS = ("0", "0.0", "0,00", "-0", "0e9", "0e1", "0·10^60")
VERDICTS = [
    ("100.0", X, 100.0, "right"),
    ("101.0", X, 100.0, "right"),  # at the tolerance
    ("101.1", X, 100.06, "right"),  # its rounding to four figures reaches it
    ("101.1", X, 100.0, "right by plans"),
    ("101", X, 99.6, "right"),  # 101 to three figures may be 100.5
    ("101", X, 99.4, "right by plans"),
    ("1.0e2", X, 104.0, "wrong"),  # two figures are as good as three
    ("1e2", X, 103.0, "right by plans"),
    ("103.0", X, 100.0, "right by plans"),
    ("104", X, 100.0, "wrong"),
    ("-100", X, 100.0, "wrong"),
    ("-100", item("x", either_sense=True), 100.0, "right"),
    ("0,1667·10^4", item("x", tolerance=1e-6), 1667.4, "right"),  # 1667 has four figures
    ("0,1667·10^4", item("x", tolerance=1e-6), 1667.6, "right by plans"),
    ("0.3", item("x", within=0.5), 0.0, "right"),
    ("0.6", item("x", within=0.5), 0.0, "wrong"),
    *((zero, X, 0.0, "right") for zero in ZEROS),
    *((zero, X, 0.004, "wrong") for zero in ZEROS),
    *((zero, item("x", unit="m"), 0.004, "wrong") for zero in ("0e9", "0e9 мм")),
    ("0e9", item("x", within=0.5), 0.4, "right"),
    ("0e9", item("x", within=0.5), 0.6, "wrong"),
    ("350°", item("x", unit="deg", within=1.0), -10.0, "right"),
    ("-0,1745 рад", item("x", unit="deg", within=1.0), 350.0, "right"),
    ("100 мм", item("x", unit="m"), 0.1, "right"),
    ("17", X, 18.0, "wrong"),
    ("", X, 1.0, "missing"),
    ("-", X, 1.0, "missing"),
    ("about ten", X, 1.0, "unreadable"),
]


@pytest.mark.parametrize(("text", "of", "right", "verdict"), VERDICTS)
def test_verdicts(text: str, of: Item, right: float, verdict: str) -> None:
    assert standing_of(answer(text, of), of, right) == verdict


CHAIN = (
    item("omega", unit="rad/s"),
    item("v", unit="m/s", after=(0,), powers=(1.0,)),
    item("a", unit="m/s^2", after=(0,), powers=(2.0,)),
    item("F", unit="N", after=(2,)),
    item("P", unit="W", after=(1, 3), weight=2.0),
    item("u", after=()),
)
RIGHT = (10.0, 2.5, 25.0, 75.0, 187.5, 3.0)


def chained(*texts: str, mistakes: tuple[Told, ...] = (), mistaken: tuple[tuple[float, ...], ...] = ()) -> Marked:
    key = Key(1, "Бондар", RIGHT, mistaken)
    handed = HandIn(1, "1.csv", tuple(answer(text, of) for text, of in zip(texts, CHAIN, strict=True)))
    (found,) = mark(Keybook(CHAIN, mistakes, (key,)), Pile((handed,), ()), RULES).marked
    return found


def test_a_wrong_value_is_carried_on_by_powers() -> None:
    found = chained("11.0", "2.750", "30.25", "90.75", "249.6", "3.000")
    assert found.standings == ("wrong", "carried on", "carried on", "carried on", "carried on", "right")
    assert found.points == (0.0, 0.8, 0.8, 0.8, 1.6, 1.0)
    assert found.total == pytest.approx(5.0)


def test_what_is_wrong_besides_is_not_carried_on() -> None:
    assert chained("11.0", "2.63", "30.25", "75.00", "187.5", "3.3").standings[1] == "wrong"  # v = 0.239 omega
    assert chained("11.0", "2.500", "25.00", "75.00", "187.5", "3.3").standings[5] == "wrong"  # it follows nothing


def test_of_a_value_by_plans_a_power_has_to_be_told() -> None:
    for powers, verdict in (((2.0,), "carried on"), ((), "wrong")):
        items = (CHAIN[0], item("a", unit="m/s^2", after=(0,), powers=powers))
        answers = tuple(answer(text, of) for text, of in zip(("10.28", "26.42"), items, strict=True))  # 2.8 % off
        book = Keybook(items, (), (Key(1, "", (10.0, 25.0), ()),))
        (found,) = mark(book, Pile((HandIn(1, "", answers),), ()), RULES).marked
        assert found.standings == ("right by plans", verdict)


@pytest.mark.parametrize(("omega", "v", "a"), [("1", "0.25", "0.25"), ("100", "25.0", "2500"), ("-10", "-2.5", "25")])
def test_an_implausible_value_carries_nothing(omega: str, v: str, a: str) -> None:
    found = chained(omega, v, a, "75.00", "187.5", "3.000")
    assert found.standings[:2] == ("wrong", "wrong")


def test_a_known_mistake_makes_any_value_plausible() -> None:
    rpm = Told("general.rpm", "rpm for rad/s", "Look at the unit.", True)
    given = (RIGHT[0] * 30 / math.pi, *nothing(5))
    found = chained("95.49", "23.87", "2280", "6839", "163300", "3.000", mistakes=(rpm,), mistaken=(given,))
    assert found.standings == ("wrong", "carried on", "carried on", "carried on", "carried on", "right")
    assert [(each.mistakes, each.items) for each in found.explanations] == [((0,), (0,))]


def test_what_a_mistake_gives_is_not_right_by_plans() -> None:
    """Of who computes with it; who draws and makes none keeps his points."""
    wrong = Told("linkage.x", "x left out", "Mind x.", False)
    given = (10.22, math.nan, 17.3, 51.7, 131.0, math.nan)
    found = chained("10.22", "2.500", "17.30", "51.70", "131.0", "3.000", mistakes=(wrong,), mistaken=(given,))
    assert found.standings[0] == "wrong"
    assert found.explanations[0].items[0] == 0
    drawn = chained("10.22", "2.500", "25.00", "75.00", "187.5", "3.000", mistakes=(wrong,), mistaken=(given,))
    assert drawn.standings[0] == "right by plans"


def test_a_mistake_that_explains_both_is_carried_on() -> None:
    wrong = Told("linkage.x", "x left out", "Mind x.", False)
    given = (math.nan, math.nan, 21.3, 61.7, math.nan, math.nan)  # no power of one another
    found = chained("10.00", "2.500", "21.30", "61.70", "187.5", "3.000", mistakes=(wrong,), mistaken=(given,))
    assert found.standings == ("right", "right", "wrong", "carried on", "right", "right")


def handed(number: int, *texts: str, source: str = "") -> HandIn:
    padded = [*texts, *[""] * (len(PRESS) - len(texts))]
    answers = tuple(answer(text, of) for text, of in zip(padded, PRESS, strict=True))
    return HandIn(number, source or f"{number}.csv", answers)


def test_the_later_counts_and_both_are_kept() -> None:
    first, second = handed(1, "119.9", source="1/1.csv"), handed(1, "130", "3.25", source="2/1.csv")
    marks = mark(press_class(), Pile((first, handed(2, "131.2"), second), ()), RULES)
    assert [(each.number, each.source, each.counts) for each in marks.marked] == [
        (1, "1/1.csv", False),
        (1, "2/1.csv", True),
        (2, "2.csv", True),
    ]
    assert [each.total for each in marks.counting] == [1.0, 1.0]
    assert [key.number for key in marks.absent] == [3, 4, 5]
    full = as_markdown(teachers(marks, press_class(), statistics_of(marks)), "all")
    assert "1/1.csv: 1 points; a later one counts" in full


def test_statistics() -> None:
    mistakes = (Told("a.turned", "sense reversed", "Mind the sense.", True),)
    book = press_class(mistakes, [[-1.0] * 6])
    pile = Pile((handed(1, "-120.5", "3.25"), handed(2, "-131.2", "9.87"), handed(3, "118.4", "9.87 рад/с")), ())
    marks = mark(book, pile, RULES)
    found = statistics_of(marks)
    assert (found.students, found.mean) == (3, pytest.approx(2 / 3))
    assert found.items[0].counts == {Standing.wrong: 2, Standing.right: 1}
    assert found.items[0].share == pytest.approx(1 / 3)
    assert [(each.mistakes, each.numbers) for each in found.made] == [((0,), (1, 2))]
    assert [(each.item, each.numbers) for each in found.equal] == [(1, (2, 3))]


def test_answers_of_another_variant_are_told() -> None:
    """Two wrong ones or more that are right there to the last figure; nothing is concluded."""
    own, other = VALUES[2], VALUES[3]
    copied = handed(3, "142.7", "2.654", f"{own[2]}")
    near = handed(4, "118", f"{VALUES[2][1] * 1.004:.4g}", "9.87")  # right there by tolerance alone, and too coarse
    marks = mark(press_class(), Pile((copied, near, handed(5, "142.7")), ()), RULES)
    found = statistics_of(marks)
    assert [(each.number, each.other, each.items) for each in found.foreign] == [(3, 4, (0, 1))]
    full = as_markdown(teachers(marks, press_class(), found), "all")
    assert "stroke H, omega\\_2: wrong here, right in variant 4 Шевченко Ірина" in full
    notes = marks_document(marks, found).notes
    assert "note: variant 3: of its wrong answers 2 are right in variant 4" in notes
    assert other[0] == 142.7


def test_percents_stand_still() -> None:
    far = ("120.50001", "3.40", "2.436", "9e9", "-6.03")
    marks = mark(press_class(), Pile((handed(1, *far),), ()), RULES)
    sheet = teachers(marks, press_class(), statistics_of(marks))[1]
    assert list(sheet.columns[sheet.headers.index("off")]) == ["0 %", "4.6 %", "101 %", "> 1000 %", "200 %", ""]


def test_the_table_of_marks_holds_no_formula() -> None:
    names = ("=cmd|' /C calc'!A0", "+1+1", "@SUM(A1)", " =1", "-2\u202e")
    keys = (Key(k + 1, name, VALUES[k], ()) for k, name in enumerate(names))
    book = Keybook(PRESS, (), tuple(keys))
    marks = mark(book, Pile((handed(1, "120.5", source="=x.csv"),), (Refused("a", "is empty"),)), RULES)
    lines = as_csv(grades(marks)).splitlines()
    assert lines[0].startswith("variant,student,points,of,file,stroke H,stroke H: is,")
    assert lines[1].startswith("1,'=cmd|' /C calc'!A0,1,6,'=x.csv,1,right,0,missing")
    for line in lines[1:]:
        assert not re.search(r"(^|,)\"?\s*[=+@-]", line)
    assert len(lines) == 6


def test_a_sheet_of_a_student_has_no_number_of_the_key() -> None:
    mistakes = (Told("a.turned", "sense reversed", "Mind the sense.", True),)
    book = press_class(mistakes, [[-1.0] * 6])
    marks = mark(book, Pile((handed(1, "-120.5", "9.876", "x|y<b>", "4510 Н"),), ()), RULES)
    text = students_sheet(marks, marks.marked[0])
    assert "Mind the sense." in text
    assert "x\\|y\\<b\\>" in text
    for value in (3.25, 1.213, 6.03, 0.812):
        assert f"{value:g}" not in text
    assert "sense reversed" not in text  # the mistake itself is told to the teacher


def test_a_class_of_files(tmp_path: Path) -> None:
    """From files to marks: one of each kind, one that cannot be read."""
    for k, values in enumerate(VALUES[:3]):
        rows = "".join(f"{of.name};{v};{of.unit}\n" for of, v in zip(PRESS, values, strict=True))
        (tmp_path / f"{STUDENTS[k]}.csv").write_text(rows.replace(".", ","), encoding="utf-16")
    (tmp_path / "4.csv").write_bytes(b"\x89PNG")
    book = press_class()
    marks = mark(book, read_answers(tmp_path, book.items, book.keys), RULES)
    assert [each.total for each in marks.counting] == [6.0] * 3
    assert [each.source for each in marks.refused] == ["4.csv"]
    assert [key.number for key in marks.absent] == [4, 5]
