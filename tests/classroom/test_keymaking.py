"""Keys of a class: the same however they are made, kept when it is stopped, not made twice."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import NamedTuple

import pytest
from mistakes import CONFIGS, items

from tmmcalc.batch.choice import local
from tmmcalc.batch.executors import Block, solve_here
from tmmcalc.batch.task import Row, Task
from tmmcalc.classroom.keybook import keybook_of, toml_bytes
from tmmcalc.classroom.keying import key_of
from tmmcalc.classroom.keymaking import make_keys
from tmmcalc.core.errors import NoSolutionError
from tmmcalc.project import load_spec

SPEC = CONFIGS / "crank-slider.toml"
ASKED = items("kinematics.stroke_B mm", "kinematics.aS_B@3 m/s^2")


class Variant(NamedTuple):
    number: int
    student: str
    assignments: tuple[str, ...]


def variant(number: int, rod: int, student: str = "") -> Variant:
    return Variant(number, student, (f'mechanism.links[id=2].points.B[0]="{rod} mm"',))


CLASS = [variant(1, 300, "Ivanenko"), variant(2, 340), variant(3, 360)]


class Counting:
    """Solves here, counts what it is asked, and stops after so many."""

    def __init__(self, most: int = 100) -> None:
        self.most, self.asked = most, list[int]()

    def __call__(self, task: Task, blocks: Iterable[Block]) -> Iterator[list[Row]]:
        for block in blocks:
            if len(self.asked) == self.most:
                raise KeyboardInterrupt
            self.asked += [order.point for order in block]
            yield from solve_here(task, [block])


def test_the_book_has_the_keys_of_the_variants() -> None:
    book = make_keys(SPEC, CLASS, ASKED, solve_here)
    assert [(key.number, key.student) for key in book.keys] == [(1, "Ivanenko"), (2, ""), (3, "")]
    assert len({*book.made_of}) == 3
    for key, each in zip(book.keys, CLASS, strict=True):
        own = key_of(each.number, each.student, load_spec(SPEC, each.assignments), ASKED, book.mistakes)
        assert repr(own) == repr(key)
    names = {each.name for each in book.mistakes}
    assert "linkage.normal_left_out" in names
    assert "linkage.weights_left_out" not in names  # it changes nothing here


@pytest.mark.slow
def test_in_processes_it_is_the_same() -> None:
    pytest.importorskip("joblib")
    assert repr(make_keys(SPEC, CLASS, ASKED, local(2, print))) == repr(make_keys(SPEC, CLASS, ASKED, solve_here))


def test_it_goes_on_where_it_was_stopped(tmp_path: Path) -> None:
    journal, first, second, done = tmp_path / "keys.part", Counting(most=2), Counting(), list[int]()
    with pytest.raises(KeyboardInterrupt):
        make_keys(SPEC, CLASS, ASKED, first, journal)
    assert journal.is_file()
    book = make_keys(SPEC, CLASS, ASKED, second, journal, told=done.append)
    assert (first.asked, second.asked, done) == ([1, 2], [3], [2, 3])
    assert not journal.exists()
    assert repr(book) == repr(make_keys(SPEC, CLASS, ASKED, solve_here))


def test_what_was_kept_of_another_variant_is_not_taken(tmp_path: Path) -> None:
    journal, again = tmp_path / "keys.part", Counting()
    with pytest.raises(KeyboardInterrupt):
        make_keys(SPEC, CLASS, ASKED, Counting(most=2), journal)
    make_keys(SPEC, [variant(1, 310), *CLASS[1:]], ASKED, again, journal)
    assert again.asked == [1, 3]


@pytest.mark.slow
def test_keys_that_are_known_are_not_made_again() -> None:
    known = keybook_of(toml_bytes(make_keys(SPEC, CLASS, ASKED, solve_here)))
    more = [*CLASS[:2], variant(3, 380, "Petrenko"), variant(4, 400)]
    again, other = Counting(), Counting()
    book = make_keys(SPEC, more, ASKED, again, known=known)
    assert again.asked == [3, 4]
    assert repr(book) == repr(make_keys(SPEC, more, ASKED, solve_here))
    make_keys(SPEC, CLASS, items("kinematics.stroke_B m", "kinematics.aS_B@3 m/s^2"), other, known=known)
    assert other.asked == [1, 2, 3]


def test_a_variant_without_a_solution_is_named() -> None:
    with pytest.raises(NoSolutionError, match="variant 2"):
        make_keys(SPEC, [CLASS[0], variant(2, 30)], ASKED, solve_here)
