"""A class of three with its keys, and what its students hand in."""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

from tmmcalc.batch.executors import solve_here
from tmmcalc.classroom.items import items_of
from tmmcalc.classroom.keybook import write_keybook
from tmmcalc.classroom.keymaking import make_keys
from tmmcalc.classroom.making import make_class
from tmmcalc.classroom.model import Item, Keybook
from tmmcalc.classroom.state import Class
from tmmcalc.project import load_spec

SHAPER = Path(__file__).parents[2] / "configs" / "assignment-shaper.toml"
TITLE = 'Shaper & <b>co</b> ]]> {x} "1/2"'
STUDENTS = ("Шевченко Тарас", 'Olena <Kovač> & "Co" ]]>')


class School(NamedTuple):
    """A class in its folder."""

    folder: Path
    made: Class
    items: tuple[Item, ...]
    book: Keybook


def school_in(place: Path) -> School:
    """The class in a folder, drawn and with its keys."""
    text = SHAPER.read_text(encoding="utf-8")
    text = text.replace('title = "Shaper: an assignment"', f"title = '{TITLE}'")
    text = text.replace("[class]\n", '[class]\nroster = "roster.txt"\n', 1)
    text = text.replace('name = "v_D"\n', 'name = "v_D"\neither_sense = true\n', 1)
    assert text.count("either_sense") == 1
    assert TITLE in text
    file = place / "assignment.toml"
    file.write_text(text, encoding="utf-8")
    (place / "roster.txt").write_text("\n".join(STUDENTS), encoding="utf-8")
    folder = place / "class"
    made = make_class(file, folder, 3, 5, jobs=1).own
    items = items_of(load_spec(file))
    book = make_keys(file, made.variants, items, solve_here)
    write_keybook(book, folder / "keys")
    return School(folder, made, items, book)


def hand_in(school: School, place: Path, factor: float = 1.0) -> Path:
    """Answers of all students, each right value times a factor, to four digits."""
    place.mkdir(exist_ok=True)
    for variant, key in zip(school.made.variants, school.book.keys, strict=True):
        rows = [
            f"{item.name};{value * factor:.4g};{item.unit}"
            for item, value in zip(school.items, key.values, strict=True)
        ]
        (place / f"{variant.stem}.csv").write_text("\n".join(["quantity;value;unit", *rows]), encoding="utf-8")
    return place
