"""Questions for Moodle, read back by the rules of its importer; the reader shares no code with the writer.

The importer (``question/format/xml/format.php``) takes a ``<quiz>`` of questions; a category holds for those after it;
a numerical answer counts if it is within an absolute tolerance, and the first that fits wins; a calculated question has
sets of data under numbers from 1 on.
"""

from __future__ import annotations

import math
import re
from base64 import b64decode
from dataclasses import replace
from typing import NamedTuple
from xml.etree import ElementTree
from xml.etree.ElementTree import Element

import pytest

from classroom.school import STUDENTS, TITLE, School
from tmmcalc.classroom.keymaking import Keybook
from tmmcalc.classroom.marking import Rules
from tmmcalc.classroom.moodle.dataset import MOST, dataset_questions_of
from tmmcalc.classroom.moodle.elements import category, element, html, quiz, words
from tmmcalc.classroom.moodle.numerical import questions_of, units_of
from tmmcalc.classroom.moodle.scenes import Told, scenes_of
from tmmcalc.core.errors import UsageError
from tmmcalc.report.language import speaking, tr_unit

PERMITTED = (100, 90, 83.33333, 80, 75, 70, 66.66667, 60, 50, 40, 33.33333, 30, 25, 20, 16.66667, 14.28571, 12.5)
SPELLED = str.maketrans("<>", "‹›")  # in names, as tags are stripped from them
PERMITTED += (11.11111, 10, 5, 0)


class Response(NamedTuple):
    """An answer of a numerical question."""

    text: str
    fraction: float
    tolerance: float
    feedback: str

    def fits(self, value: float) -> bool:
        return self.text == "*" or abs(value - float(self.text)) <= self.tolerance


def text_of(element: Element, path: str) -> str:
    found = element.find(f"{path}/text")
    assert found is not None, path
    assert len(found) == 0, "markup of a text stands in CDATA"
    return found.text or ""


def value_of(element: Element, path: str) -> str:
    found = element.find(path)
    assert found is not None, path
    return found.text or ""


def responses(question: Element) -> list[Response]:
    return [
        Response(
            text_of(each, ".").strip(),
            float(each.attrib["fraction"]),
            float(value_of(each, "tolerance")),
            text_of(each, "feedback"),
        )
        for each in question.findall("answer")
    ]


def read(data: bytes) -> list[tuple[str, list[Element]]]:
    """The questions by category; what every question must have is held."""
    assert data.startswith(b'<?xml version="1.0" encoding="UTF-8"?>\n')
    root = ElementTree.fromstring(data)
    assert root.tag == "quiz"
    assert {child.tag for child in root} == {"question"}
    assert root[0].attrib["type"] == "category"
    found: list[tuple[str, list[Element]]] = []
    for question in root:
        if question.attrib["type"] == "category":
            found.append((text_of(question, "category"), []))
            assert question.find("idnumber") is None, (
                "a course takes each but once, and two classes may be called alike"
            )
            continue
        assert 0 < len(text_of(question, "name")) <= 255
        body = question.find("questiontext")
        assert body is not None
        assert body.attrib["format"] == "html"
        assert_whole(text_of(question, "questiontext"), body)
        assert value_of(question, "hidden") == "0"
        assert 0 <= float(value_of(question, "penalty")) <= 1
        assert float(value_of(question, "defaultgrade")) >= 0
        assert 0 < len(value_of(question, "idnumber")) <= 100
        found[-1][1].append(question)
    keys = [value_of(each, "idnumber") for _, questions in found for each in questions]
    assert len(keys) == len(set(keys))
    return found


def assert_whole(markup: str, body: Element) -> None:
    """HTML whose elements close, and every picture of which is there."""
    closed = re.sub(r"<(img[^>]*|br)>", r"<\1/>", markup)
    ElementTree.fromstring(f"<div>{closed}</div>")
    named = {*re.findall(r"@@PLUGINFILE@@/([^\"]+)", markup)}
    files = {each.attrib["name"]: each for each in body.findall("file")}
    assert named == {*files}
    for each in files.values():
        assert each.attrib["encoding"] == "base64"
        assert each.attrib["path"] == "/"
        picture = b64decode(each.text or "", validate=True)
        assert ElementTree.fromstring(picture).tag == "{http://www.w3.org/2000/svg}svg"


@pytest.fixture(scope="module")
def scenes(school: School) -> list[Told]:
    return scenes_of(school.folder, school.made, school.items, jobs=1)


@pytest.fixture(scope="module")
def numerical(school: School, scenes: list[Told]) -> list[tuple[str, list[Element]]]:
    return read(quiz(questions_of(school.book, scenes, TITLE, "shaper", Rules())))


@pytest.fixture(scope="module")
def calculated(school: School, scenes: list[Told]) -> list[Element]:
    ((_, questions),) = read(quiz(dataset_questions_of(school.book, scenes, TITLE, "shaper", Rules())))
    return questions


def test_a_variant_is_a_category_with_its_scheme_and_a_question_an_item(
    numerical: list[tuple[str, list[Element]]], school: School
) -> None:
    assert len(numerical) == 3
    for number, (path, questions) in enumerate(numerical, 1):
        parts = [part.replace("//", "/") for part in re.split(r"(?<!/)/(?!/)", path)]
        assert parts == ["$course$", "top", TITLE.translate(SPELLED), f"Variant {number:02d}"]
        described, *asked = questions
        assert described.attrib["type"] == "description"
        assert described.find("questiontext/file") is not None
        assert {each.attrib["type"] for each in asked} == {"numerical"}
        assert [text_of(each, "name") for each in asked] == [f"{number:02d} {item.name}" for item in school.items]


@pytest.mark.parametrize(
    ("title", "name"),
    [("a/b", "a/b"), ("/lead and tail/", "/lead and tail/"), ("r<5 & z>17", "r‹5 & z›17"), ("x" * 300, "x" * 255)],
)
def test_a_title_is_one_category(title: str, name: str) -> None:
    """Moodle parts a path at single slashes, strips tags and has room for 255 characters."""
    path = text_of(ElementTree.fromstring(category((title, "Variant 01"), "")), "category")
    parts = [part.strip().replace("//", "/") for part in re.split(r"(?<!/)/(?!/)", path)]
    assert parts == ["$course$", "top", name, "Variant 01"]


def test_names_of_keys_are_cut_before_what_tells_them_apart(school: School, scenes: list[Told]) -> None:
    for made in (questions_of, dataset_questions_of):
        read(quiz(made(school.book, scenes, TITLE, "long" * 40, Rules())))


def test_a_question_says_in_which_sense_and_within_what(
    numerical: list[tuple[str, list[Element]]], calculated: list[Element], school: School
) -> None:
    """As the task sheet does: a sign that nobody can know is no question."""
    rule, parts = "positive counter-clockwise", [f"within {100 * item.tolerance:g} %" for item in school.items]
    for _, (described, *asked) in numerical:
        assert rule in text_of(described, "questiontext")
        assert "counted from 0 on" in text_of(described, "questiontext")
        assert all(part in text_of(each, "questiontext") for part, each in zip(parts, asked, strict=True))
    assert all(rule in text_of(each, "questiontext") for each in calculated if each.attrib["type"] == "calculated")


def test_what_is_right_is_right_and_nothing_else_is(numerical: list[tuple[str, list[Element]]], school: School) -> None:
    """The first answer that fits is asked, as Moodle does, at values about the right one."""
    for key, (_, questions) in zip(school.book.keys, numerical, strict=True):
        for item, right, question in zip(school.items, key.values, questions[1:], strict=True):
            found = responses(question)
            allowed = max(item.tolerance * abs(right), item.within)

            def grade(value: float, found: list[Response] = found) -> float:
                return next(each.fraction for each in found if each.fits(value))

            assert grade(right) == grade(right + 0.99 * allowed) == grade(right - 0.99 * allowed) == 100
            assert grade(right + 1.5 * allowed) < 100
            assert grade(right * (1 + item.plans) * 1.5) == 0
            assert grade(right * (1 + 0.99 * item.plans)) == (50 if item.plans * abs(right) > allowed else 100)
            assert (grade(-right) == 100) == item.either_sense
            assert found[-1][:2] == ("*", 0)
            assert sum(each.text == "*" for each in found) == 1
            assert all(each.fraction in PERMITTED for each in found)


def test_known_mistakes_have_a_hint_and_no_points(numerical: list[tuple[str, list[Element]]], school: School) -> None:
    told = 0
    for key, (_, questions) in zip(school.book.keys, numerical, strict=True):
        for at, question in enumerate(questions[1:]):
            found = responses(question)
            item, right = school.items[at], key.values[at]
            taken = max(item.plans * abs(right), item.within)
            for mistake, values in zip(school.book.mistakes, key.mistaken, strict=True):
                if math.isnan(values[at]):
                    continue
                first = next(each for each in found if each.fits(values[at]))
                near = min(abs(values[at] - right), abs(values[at] + right) if item.either_sense else math.inf)
                if near > taken + max(item.tolerance * abs(values[at]), item.within):
                    assert first.fraction == 0
                    assert first.feedback
                    told += mistake.hint[:20] in first.feedback
            wrong = [each for each in found if each.fraction == 0 and each.text != "*"]
            right_ones = [each for each in found if each.fraction > 0]
            for each in wrong:
                for other in right_ones:
                    assert abs(float(each.text) - float(other.text)) > each.tolerance + other.tolerance * 0.999
    assert told > 50


def test_units_say_how_many_make_one_of_the_asked_one(
    numerical: list[tuple[str, list[Element]]], school: School
) -> None:
    """1 m is 1000 mm, 1 rad/s is 30/pi rpm: by hand."""
    questions = dict(zip((item.name for item in school.items), numerical[0][1][1:], strict=True))
    for name, unit, other, by in (
        ("H", "mm", "m", 0.001),
        ("omega_3", "rad/s", "rpm", 30 / math.pi),
        ("v_D", "m/s", "mm/s", 1000),
    ):
        units = [
            (value_of(u, "unit_name"), float(value_of(u, "multiplier"))) for u in questions[name].findall("units/unit")
        ]
        assert units[0] == (unit, 1)
        assert dict(units)[other] == pytest.approx(by)
        assert len(units) == len(dict(units))
        assert value_of(questions[name], "showunits") == "0"
    assert questions["K"].find("units") is None
    assert value_of(questions["K"], "showunits") == "3"


def test_names_and_titles_come_back_as_they_are(
    numerical: list[tuple[str, list[Element]]], school: School, scenes: list[Told]
) -> None:
    data = quiz(questions_of(school.book, scenes, TITLE, "shaper", Rules()))
    infos = [
        text_of(each, "info") for each in ElementTree.fromstring(data).iter("question") if each.find("info") is not None
    ]
    assert infos == [*STUDENTS, ""]
    assert text_of(numerical[0][1][0], "name") == f"01 {TITLE.translate(SPELLED)}"


def test_texts_hold_whatever_stands_in_them() -> None:
    evil = "a]]>b & <c> \x00\x1b end ]]>"
    for made in (html(evil), words(evil)):
        assert ElementTree.fromstring(element("x", made))[0].text == "a]]>b & <c>  end ]]>"


def test_a_set_of_data_is_a_variant(calculated: list[Element], school: School) -> None:
    """Sets are numbered from 1 on in every list; formulas and texts name nothing that has none."""
    for at, (item, question) in enumerate(zip(school.items, calculated, strict=True)):
        assert question.attrib["type"] == "calculated"
        assert value_of(question, "synchronize") == "1"
        columns = {}
        for definition in question.findall("dataset_definitions/dataset_definition"):
            assert value_of(definition, "type") == "calculated"
            assert text_of(definition, "status") == "shared"
            assert text_of(definition, "distribution") == "uniform"
            entries = definition.findall("dataset_items/dataset_item")
            assert [value_of(each, "number") for each in entries] == ["1", "2", "3"]
            assert value_of(definition, "itemcount") == value_of(definition, "number_of_items") == "3"
            values = [float(value_of(each, "value")) for each in entries]
            assert float(text_of(definition, "minimum")) == min(values)
            assert float(text_of(definition, "maximum")) == max(values)
            columns[text_of(definition, "name")] = values
        said = text_of(question, "questiontext") + "".join(text_of(each, ".") for each in question.findall("answer"))
        assert {*re.findall(r"\{([A-Za-z]\w*)\}", said)} == {*columns}
        assert "{" not in re.sub(r"\{[A-Za-z]\w*\}", "", said)
        (of,) = {name.rpartition("_")[2] for name in columns}
        assert columns[f"v_{of}"] == [1, 2, 3]
        assert columns[f"a{at + 1}_{of}"] == pytest.approx([key.values[at] for key in school.book.keys], rel=1e-9)
        answers = question.findall("answer")
        assert text_of(answers[0], ".") == f"{{a{at + 1}_{of}}}"
        assert value_of(answers[0], "tolerancetype") == "1"
        assert float(value_of(answers[0], "tolerance")) == item.tolerance
        assert value_of(answers[0], "correctanswerformat") == "2"
        assert int(value_of(answers[0], "correctanswerlength")) == item.digits
        assert text_of(answers[-1], ".") == "*"
        assert [float(each.attrib["fraction"]) for each in answers] == sorted(
            (float(each.attrib["fraction"]) for each in answers), reverse=True
        )
        assert any(text_of(each, ".").startswith("-") for each in answers) == item.either_sense


def test_a_set_has_the_numbers_of_the_spec_that_was_given_out(calculated: list[Element], school: School) -> None:
    """The lengths of the cranks are among the data, whatever they are called there."""
    columns = [
        [float(value_of(each, "value")) for each in definition.findall("dataset_items/dataset_item")]
        for definition in calculated[0].findall("dataset_definitions/dataset_definition")
    ]
    of_crank = [
        next(a for a in each.assignments if "links[id=1].points.A[0]" in a).split('"')[1].split()
        for each in school.made.variants
    ]
    assert {unit for _, unit in of_crank} == {"mm"}
    wanted = [float(value) / 1000 for value, _ in of_crank]
    assert any(column == pytest.approx(wanted) for column in columns)


def test_shared_data_of_another_class_have_other_names(school: School, scenes: list[Told]) -> None:
    """Data of a name that a category has already stay as they are when a file is read."""

    def names(book: Keybook) -> set[str]:
        ((_, questions),) = read(quiz(dataset_questions_of(book, scenes, TITLE, "shaper", Rules())))
        return {text_of(each, "name") for question in questions for each in question.iter("dataset_definition")}

    first, *others = school.book.keys
    other = Keybook(school.items, school.book.mistakes, (replace(first, values=(*first.values[:-1], 1.0)), *others))
    assert names(school.book) == names(school.book)
    assert not names(school.book) & names(other)


def test_an_angle_is_right_a_whole_turn_aside_in_every_set(school: School, scenes: list[Told]) -> None:
    """Within what the least of the right values allows, for the tolerance of a turned angle is another."""
    keys = tuple(
        replace(key, values=(value, *key.values[1:]))
        for key, value in zip(school.book.keys, (40.0, -2.0, 90.0), strict=True)
    )
    items = (replace(school.items[0], unit="deg", tolerance=0.01, within=0.0, either_sense=False), *school.items[1:])
    ((_, (question, *_)),) = read(
        quiz(dataset_questions_of(Keybook(items, school.book.mistakes, keys), scenes, TITLE, "x", Rules()))
    )
    turned = [each for each in question.findall("answer") if text_of(each, ".").endswith("360")]
    assert [text_of(each, ".").partition("}")[2] for each in turned] == ["-360", "+360"]
    assert [(value_of(each, "tolerancetype"), float(value_of(each, "tolerance"))) for each in turned] == [
        ("2", 0.02)
    ] * 2


def test_tolerances_have_few_characters(school: School, scenes: list[Told]) -> None:
    """Moodle has room for twenty."""
    items = (replace(school.items[0], unit="rad", within=math.radians(0.05)), *school.items[1:])
    ((_, (question, *_)),) = read(
        quiz(dataset_questions_of(Keybook(items, school.book.mistakes, school.book.keys), scenes, TITLE, "x", Rules()))
    )
    assert max(len(value_of(each, "tolerance")) for each in question.findall("answer")) <= 20


@pytest.mark.parametrize("language", ["en", "uk"])
@pytest.mark.parametrize("unit", ["1/min", "s^-2", "mm/s^2", "kN*m", "deg/s^2"])
def test_a_unit_can_be_typed_and_is_not_read_as_a_number(unit: str, language: str) -> None:
    """No unit begins with a digit, which would go on the number before it; the first is what is asked for."""
    with speaking(language):
        named = dict(units_of(unit))
        said = tr_unit(unit)
    assert not any(each[:1].isdigit() for each in named)
    assert next(iter(named.values())) == 1
    keyed = said.replace("²", "^2").replace("·", "*")
    assert named[f"{keyed[2:]}^-1" if keyed.startswith("1/") else keyed] == 1
    for typed in [each for each in named if "^2" in each or "*" in each]:
        assert named[typed.replace("^2", "²").replace("*", "·")] == named[typed]


def test_moodle_has_no_more_sets_than_a_hundred(school: School, scenes: list[Told]) -> None:
    many = Keybook(school.items, school.book.mistakes, school.book.keys * (MOST // 3 + 1))
    with pytest.raises(UsageError, match="100 sets"):
        list(dataset_questions_of(many, scenes * (MOST // 3 + 1), TITLE, "shaper", Rules()))


def test_questions_speak_ukrainian(school: School) -> None:
    with speaking("uk"):
        told = scenes_of(school.folder, school.made, school.items, jobs=1)
        ((path, _), *_) = read(quiz(questions_of(school.book, told, TITLE, "shaper", Rules())))
    assert path.endswith("Варіант 01")


def test_data_that_are_no_numbers_in_every_variant_are_told_in_words(school: School, scenes: list[Told]) -> None:
    """A text that is the same stands there; one that differs, or is not in all variants, is on the task sheet."""
    texts = [("kind", "", "A"), ("kind", "", "A"), ("kind", "", "A")], [("law", "", "B"), ("law", "", "C"), None]
    changed = [
        scene._replace(
            own=[*scene.own, *([*row] for row in rows if row)],
            numbers=[*scene.numbers, *([] for row in rows if row)],
            units=[*scene.units, *("" for row in rows if row)],
        )
        for scene, rows in zip(scenes, zip(*texts, strict=True), strict=True)
    ]
    ((_, questions),) = read(quiz(dataset_questions_of(school.book, changed, TITLE, "shaper", Rules())))
    said = text_of(questions[0], "questiontext")
    assert "<td>kind</td><td></td><td>A</td>" in said
    assert "<td>law</td><td></td><td>see the task sheet</td>" in said
