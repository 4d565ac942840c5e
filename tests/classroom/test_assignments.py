"""The ready assignments: a class of each, its keys, and answers in files in which a known mistake was made."""

from __future__ import annotations

import math
import re
from pathlib import Path

import pytest

from classroom.leaking import given_in, leaks, words_of
from classroom.school import School
from tmmcalc.batch.executors import solve_here
from tmmcalc.classroom.grading import graded, own_marks
from tmmcalc.classroom.items import items_of
from tmmcalc.classroom.keybook import write_keybook
from tmmcalc.classroom.keymaking import make_keys
from tmmcalc.classroom.making import make_class
from tmmcalc.classroom.model import Keybook
from tmmcalc.classroom.papers.sheets import write_sheets
from tmmcalc.classroom.verdicts import Standing
from tmmcalc.project import load_spec
from tmmcalc.report.language import speaking

CONFIGS = Path(__file__).parents[2] / "configs"
DEAR = ("course-project", "press")
VARIANTS = 3
STRANGE = re.compile(r"\b[a-z_]+(\.[a-z_]+|\[\d+\])+|\b(of|the|and|with)\b")
READY = sorted(file.stem.partition("-")[2] for file in CONFIGS.glob("assignment-*.toml"))


def school_of(name: str, folder: Path) -> School:
    """A class of an assignment with its keys, in the folder."""
    file = CONFIGS / f"assignment-{name}.toml"
    made, items = make_class(file, folder, VARIANTS, 11, jobs=1), items_of(load_spec(file))
    book = make_keys(file, made.own.variants, items, solve_here)
    write_keybook(book, folder / "keys")
    return School(folder, made.own, items, book)


def hand_in(book: Keybook, at: int | None, place: Path) -> Path:
    """Answers to four digits of everybody, with a mistake in all that it changes."""
    place.mkdir()
    for key in book.keys:
        given = key.values if at is None else key.mistaken[at]
        rows = [
            f"{item.name};{(wrong if math.isfinite(wrong) else right):.3e};{item.unit}"
            for item, wrong, right in zip(book.items, given, key.values, strict=True)
        ]
        (place / f"{key.number}.csv").write_text("\n".join(["result;value;unit", *rows]), encoding="utf-8")
    return place


@pytest.mark.parametrize(
    "name", [pytest.param(each, marks=pytest.mark.slow) if each in DEAR else each for each in READY]
)
def test_a_class_is_drawn_keyed_and_marked(name: str, tmp_path: Path) -> None:
    """Right answers have all points; a mistake that makes several wrong is named by everybody's marks."""
    school = school_of(name, tmp_path / "class")
    book = school.book
    marks, *_ = graded(tmp_path / "class", hand_in(book, None, tmp_path / "right"), None)
    assert {*(each for marked in marks.marked for each in marked.standings)} == {Standing.right}
    assert [marked.total for marked in marks.marked] == pytest.approx([marks.most] * VARIANTS)
    named = []
    for at in range(len(book.mistakes)):
        marks, *_ = graded(tmp_path / "class", hand_in(book, at, tmp_path / f"{at}"), None)
        for marked in marks.marked:
            if sum(each in (Standing.wrong, Standing.carried) for each in marked.standings) > 1:
                named.append(at in marked.explanations[0].mistakes if marked.explanations else False)
    assert sum(named) >= 0.95 * len(named)
    assert len(named) >= 5 * VARIANTS
    with speaking("uk"):
        write_sheets(school.folder, school.made, school.items, "html", jobs=1)
    given = given_in(school)
    sheets = sorted((school.folder / "sheets").iterdir())
    assert len(sheets) == VARIANTS
    for sheet in sheets:
        text = words_of(sheet)
        assert leaks(text, school, given) == set()
        assert not STRANGE.search(text), "a key or a word of the program in place of what is given"


@pytest.mark.parametrize("name", ["gears", "train"])
def test_where_no_plans_are_drawn_nothing_is_right_by_plans(name: str) -> None:
    """A centre distance without the shifts is 2.3 % off: no part of its points."""
    for item in items_of(load_spec(CONFIGS / f"assignment-{name}.toml")):
        assert item.plans == item.tolerance, item.name


def test_planets_of_the_train_can_be_put_in_and_what_follows_from_the_carrier_is_carried_on() -> None:
    """Any teeth let one pair of planets in; while the ring stands both speeds go as that of the carrier."""
    file = CONFIGS / "assignment-train.toml"
    spec, items = load_spec(file), {item.name: item for item in items_of(load_spec(file))}
    assert spec.gearing is not None
    assert [member.count for member in spec.gearing.members] == [1]
    names = [*items]
    for name in ("omega_2", "omega_2H"):
        assert [names[k] for k in items[name].after] == ["omega_H"]
        assert items[name].powers == (1.0,)


def test_a_table_over_the_angle_of_a_cam_is_read_by_the_variant(tmp_path: Path) -> None:
    """Each has phases of its own, so a position has another angle in each of them."""
    folder = tmp_path / "class"
    book = school_of("cam", folder).book
    names = ["s", "v", "a"]
    places = [[item.name for item in book.items].index(name) for name in names]
    (tmp_path / "answers").mkdir()
    for key, each in zip(book.keys, sorted((folder / "variants").iterdir()), strict=True):
        cam = load_spec(each).cam
        assert cam is not None
        lines = ["φ, град;s, мм;v, м/с;a, м/с²"]
        for row in range(13):  # the asked values in the rows of their positions, 0 elsewhere
            cells = [key.values[k] if row == at else 0.0 for k, at in zip(places, (4, 4, 2), strict=True)]
            lines.append(";".join(f"{value:.5g}" for value in (math.degrees(cam.rise) * row / 12, *cells)))
        (tmp_path / "answers" / f"{key.number}.csv").write_text("\n".join(lines), encoding="utf-8")
    marks, *_ = graded(folder, tmp_path / "answers", None)
    assert [[marked.standings[k] for k in places] for marked in marks.marked] == [[Standing.right] * 3] * VARIANTS
    own, _ = own_marks(folder / "variants" / "02.toml", tmp_path / "answers" / "2.csv")
    assert [own.standings[k] for k in places] == [Standing.right] * 3
