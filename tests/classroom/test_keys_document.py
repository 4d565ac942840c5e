"""What is printed of keys: every column of what is right, and which mistakes cannot be seen."""

from __future__ import annotations

from dataclasses import replace

from mistakes import item

from tmmcalc.classroom.keying import told_of
from tmmcalc.classroom.keys_document import keys_document
from tmmcalc.classroom.model import Key, Keybook

ITEMS = (item("a", "mm"), item("b", "", either=True))
MISTAKES = (told_of("linkage.coriolis_once"), told_of("linkage.coriolis_left_out"))
BOOK = Keybook(ITEMS, MISTAKES, (Key(1, "Ada", (10.0, 20.0), ((10.05, 25.0), (12.0, 26.0))),))


def test_columns_that_say_something_are_there() -> None:
    right = keys_document(BOOK, "keys").parts[0].table
    assert right is not None
    assert [*zip(right.headers, right.columns, strict=True)] == [
        ("name", ["a", "b"]),
        ("value", ["10.00", "20.00"]),
        ("unit", ["mm", ""]),
        ("tolerance", ["0.10", "0.20"]),
        ("also right", ["", "-20.00"]),
    ]
    one_sense = replace(BOOK, items=(ITEMS[0], item("b", "")), keys=(*BOOK.keys, replace(BOOK.keys[0], number=2)))
    several = keys_document(one_sense, "keys").parts[0].table
    assert several is not None
    assert [*several.headers] == ["variant", "name", "value", "unit", "tolerance"]


def test_mistakes_that_cannot_be_seen_are_named_with_what_to_do() -> None:
    document = keys_document(BOOK, "keys")
    fact = next(each for each in document.facts if each.label == "right with a mistake")
    assert (fact.text, fact.values) == ("1 answer", {"right_too": 1})
    assert document.notes == (
        "note: a is right with a mistake too (linkage.coriolis_once): make its tolerance smaller, or ask another "
        "result",
    )
    assert document.facts[0].text == "1: number 1, Ada"
    assert keys_document(BOOK, "keys", 40).facts[0].text == "1 of 40: number 1, Ada"


def test_nothing_is_said_where_all_can_be_seen() -> None:
    clear = keys_document(replace(BOOK, keys=(Key(1, "", (10.0, 20.0), ((11.0, 25.0), (12.0, 26.0))),)), "keys")
    assert clear.notes == ()
    assert clear.facts[-1].text == "no answer"
