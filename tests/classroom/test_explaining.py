"""Planted mistakes are named first, and numbers that come of nothing are not explained.

Keybooks are made at random: six to twelve items, twenty to forty mistakes that change some of them, by a few per cent
or by much, and misreadings of single answers. What is asserted here on some
hundred tables was measured on thousands: of mistakes planted to three digits 99 % are named first, of tables of numbers
that come of nothing less than 0.6 % are explained; with noise of 2 %, as by plans, 80 % and 0.9 %: the rest have too
few wrong answers to tell.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
import pytest
from numpy.random import Generator, default_rng
from sparing import sparing

from classroom.books import item
from tmmcalc.classroom.answers.handed import Answer, HandIn
from tmmcalc.classroom.marking import Marked, Rules, mark_one
from tmmcalc.classroom.model import Key, Keybook, Told
from tmmcalc.classroom.verdicts import Standing

MISREAD = (-1.0, 1000.0, 1e-3, math.pi / 180, 180 / math.pi, math.pi / 30, 30 / math.pi, 2.0)
ALL = (2.0, 0.5, -1.0, 9.81, 2 * math.pi, 1 / 9.81, math.pi)
TABLES = 200


def random_book(rng: Generator) -> Keybook:
    """A class of one variant; mistakes of single answers come last."""
    count = int(rng.integers(6, 13))
    right = rng.choice([-1, 1], count, p=[0.3, 0.7]) * np.exp(rng.normal(0, 3, count))
    mistaken, told = [], []
    for m in range(rng.integers(20, 41)):
        changed = rng.random(count) < rng.choice([0.2, 0.5, 0.9])
        changed[rng.integers(count)] = True
        ratios = (
            np.exp(rng.normal(0, 0.08, count)),
            np.exp(rng.normal(0, 0.6, count)),
            np.full(count, rng.choice(ALL)),
            np.exp(rng.normal(0, 0.3, count)) * rng.choice([-1, 1], count, p=[0.2, 0.8]),
        )[rng.integers(4)]
        mistaken.append(tuple(np.where(changed, right * ratios, math.nan)))
        told.append(Told(f"whole.{m}", f"mistake {m}", "Mind it.", False))
    for ratio in MISREAD:
        changed = rng.random(count) < (1 if ratio == -1 else 0.5)
        mistaken.append(tuple(np.where(changed, right * ratio, math.nan)))
        told.append(Told(f"single.{ratio:g}", f"times {ratio:g}", "Mind units.", True))
    items = tuple(item(f"x{k}") for k in range(count))
    return Keybook(items, tuple(told), (Key(1, "", tuple(right), tuple(mistaken)),))


def marked(book: Keybook, values: np.ndarray, digits: int = 3) -> Marked:
    """A student who writes these numbers, to three digits."""
    answers = []
    for value in values:
        text = f"{value:.{digits - 1}e}"
        step = 10.0 ** (math.floor(math.log10(abs(float(text)))) - digits + 1)
        answers.append(Answer(text, float(text), step, digits))
    return mark_one(book, book.keys[0], HandIn(1, "1.csv", tuple(answers)), Rules())


def with_mistake(book: Keybook, m: int) -> np.ndarray:
    given, right = np.array(book.keys[0].mistaken[m]), np.array(book.keys[0].values)
    return np.where(np.isfinite(given), given, right)


def share_named(seed: int, noise: float, least: int = 1) -> float:
    """How many of planted mistakes that make at least so many answers wrong are named first."""
    rng = default_rng(seed)
    named = []
    while len(named) < TABLES:
        book = random_book(rng)
        m = int(rng.integers(len(book.mistakes) - len(MISREAD)))
        values = with_mistake(book, m)
        found = marked(book, values * (1 + noise * rng.normal(size=len(values))))
        if found.standings.count(Standing.wrong) >= least:
            named.append(bool(found.explanations) and m in found.explanations[0].mistakes)
    return float(np.mean(named))


@pytest.mark.slow
def test_a_planted_mistake_is_named_first() -> None:
    assert share_named(1, noise=0.0) >= 0.95
    assert share_named(2, noise=0.0, least=2) >= 0.98


@pytest.mark.slow
def test_by_plans_it_is_named_where_enough_is_wrong() -> None:
    assert share_named(3, noise=0.02) >= 0.65
    assert share_named(4, noise=0.02, least=4) >= 0.90


Random = Callable[[Generator, np.ndarray], np.ndarray]
NOTHING: dict[str, Random] = {
    "within a half": lambda rng, right: right * rng.uniform(0.5, 1.5, len(right)),
    "near": lambda rng, right: right * np.exp(rng.normal(0, 0.3, len(right))),
    "a decade": lambda rng, right: right * 10 ** rng.uniform(-1, 1, len(right)) * rng.choice([-1, 1], len(right)),
    "decades": lambda rng, right: right * 10 ** rng.uniform(-3, 3, len(right)) * rng.choice([-1, 1], len(right)),
    "of other items": lambda rng, right: rng.permutation(right),
    "round": lambda rng, right: np.array([float(f"{v:.0e}") for v in right * np.exp(rng.normal(0, 1, len(right)))]),
}


@sparing("kind", NOTHING, every=len(NOTHING))
@pytest.mark.parametrize("wrong", [1, 3, 12])
def test_numbers_that_come_of_nothing_are_not_explained(kind: str, wrong: int) -> None:
    """In less than 1 % of tables, where one answer is random, three, or all of them."""
    rng = default_rng(wrong)
    explained = 0
    for _ in range(TABLES):
        book = random_book(rng)
        right = np.array(book.keys[0].values)
        values = np.where(rng.permutation(len(right)) < wrong, NOTHING[kind](rng, right), right)
        explained += bool(marked(book, values).explanations)
    assert explained <= 5  # a share of 1 % gives more in one run of sixty


@pytest.mark.slow
def test_one_wrong_answer_that_comes_of_nothing_is_seldom_explained() -> None:
    """In less than 1 % of tables where it is easiest: few mistakes, of few answers each, all within 40 %.

    It was 0.5 % of 1500 tables for 8, 20 and 40 mistakes, three digits and four.
    """
    rng = default_rng(5)
    tables, explained = 1500, 0
    told = tuple(Told(f"whole.{m}", f"{m}", "Mind it.", False) for m in range(8))
    for _ in range(tables):
        right = np.exp(rng.normal(0, 3, 8))
        mistaken = []
        for _ in told:
            changed = rng.random(8) < 0.2
            changed[rng.integers(8)] = True
            off = rng.choice([-1, 1]) * rng.uniform(0.02, 0.4, 8)
            mistaken.append(tuple(np.where(changed, right * (1 + off), math.nan)))
        book = Keybook(tuple(item(f"x{k}") for k in range(8)), told, (Key(1, "", tuple(right), tuple(mistaken)),))
        values = right.copy()
        values[int(rng.integers(8))] *= 1 + rng.choice([-1, 1]) * rng.uniform(0.05, 0.4)
        explained += bool(marked(book, values).explanations)
    assert explained / tables <= 0.006


@pytest.mark.slow
def test_the_mistake_and_misreadings_on_top_of_it() -> None:
    """A mistake of the whole solution, and one answer in other units besides."""
    rng = default_rng(7)
    both = []
    while len(both) < 100:
        book = random_book(rng)
        m = int(rng.integers(len(book.mistakes) - len(MISREAD)))
        values, right = with_mistake(book, m), np.array(book.keys[0].values)
        changed = np.flatnonzero(np.abs(values / right - 1) > 0.05)
        s = len(book.mistakes) - len(MISREAD) + 1  # times 1000
        on_top = [k for k in changed if np.isfinite(book.keys[0].mistaken[s][k])]
        if len(changed) < 4 or not on_top:
            continue
        values[on_top[0]] *= 1000.0
        found = marked(book, values).explanations
        both.append(bool(found) and m in found[0].mistakes and any(s in each.mistakes for each in found[1:]))
    assert np.mean(both) >= 0.9


@pytest.mark.slow
def test_two_mistakes_in_different_items() -> None:
    rng = default_rng(8)
    both = []
    while len(both) < 100:
        book = random_book(rng)
        a, b = (int(m) for m in rng.choice(len(book.mistakes) - len(MISREAD), 2, replace=False))
        right = np.array(book.keys[0].values)
        off = [np.abs(with_mistake(book, m) / right - 1) > 0.05 for m in (a, b)]
        if (off[0] & off[1]).any() or off[0].sum() < 2 or off[1].sum() < 2:
            continue
        values = np.where(off[0], with_mistake(book, a), with_mistake(book, b))
        found = marked(book, values).explanations
        both.append({a, b} <= {m for each in found for m in each.mistakes})
    assert np.mean(both) >= 0.9


@pytest.mark.parametrize("either_sense", [False, True])
def test_what_fits_is_not_against_it_though_it_is_carried_on(either_sense: bool) -> None:
    """A mistake in all answers, each of which follows from the one before too."""
    items = (
        item("omega"),
        item("v", after=(0,), powers=(1.0,), either_sense=either_sense),
        item("a", after=(0,), powers=(2.0,)),
        item("F", after=(2,), powers=(1.0,)),
    )
    right = np.array([3.217, -0.4561, 7.113, 42.84])
    for ratio in (1.31, 0.52, 3.3):
        given = right * ratio ** np.array([1, 1, 2, 2])
        told = (Told("whole.x", "x", "Mind it.", False), Told("whole.y", "y", "Mind it.", False))
        mistaken = (tuple(given), tuple(right * [1.1, 1.2, 1.3, 1.4]))
        book = Keybook(items, told, (Key(1, "", tuple(right), mistaken),))
        written = given * [1, -1, 1, 1] if either_sense else given
        for values in (written, written * [1, 1.003, 0.996, 1.002]):
            (found,) = marked(book, values, digits=4).explanations
            assert (found.mistakes, found.items, found.against) == ((0,), (0, 1, 2, 3), ())


def test_an_absolute_tolerance_counts_too() -> None:
    """What a mistake changes by less than that is right with it, and says nothing against it."""
    items = (item("x0"), item("x1"), item("x2", within=0.5))
    right, given = (3.217, 42.84, 1.234), (4.412, 61.31, 1.634)
    told = (Told("whole.x", "x", "Mind it.", False), Told("whole.y", "y", "Mind it.", False))
    twin = (4.412, 61.31, 1.934)  # the same within 0.5
    book = Keybook(items, told, (Key(1, "", right, (given, twin)),))
    (found,) = marked(book, np.array([4.412, 61.31, 1.234]), digits=4).explanations
    assert (found.mistakes, found.items, found.against) == ((0, 1), (0, 1), ())


def test_mistakes_that_give_equal_numbers_are_one() -> None:
    rng = default_rng(9)
    book = random_book(rng)
    key = book.keys[0]
    twin = tuple(value * 1.002 for value in key.mistaken[0])
    book = Keybook(
        book.items,
        (*book.mistakes, Told("whole.twin", "twin", "Mind it.", False)),
        (Key(1, "", key.values, (*key.mistaken, twin)),),
    )
    (found,) = marked(book, with_mistake(book, 0)).explanations
    assert {0, len(book.mistakes) - 1} <= {*found.mistakes}


def test_right_answers_need_no_explanation() -> None:
    rng = default_rng(10)
    for _ in range(50):
        book = random_book(rng)
        found = marked(book, np.array(book.keys[0].values))
        assert {*found.standings} == {Standing.right}
        assert found.explanations == ()


def test_a_sign_alone_is_told() -> None:
    rng = default_rng(11)
    told = []
    for _ in range(50):
        book = random_book(rng)
        values = np.array(book.keys[0].values)
        values[2] *= -1
        found = marked(book, values).explanations
        told.append(len(found) == 1 and len(book.mistakes) - len(MISREAD) in found[0].mistakes)
    assert np.mean(told) >= 0.95


@pytest.mark.slow
def test_a_coarse_number_proves_nothing() -> None:
    """Of numbers of one figure one in five or so meets whatever is predicted near it."""
    rng = default_rng(12)
    explained = 0
    for _ in range(TABLES):
        book = random_book(rng)
        right = np.array(book.keys[0].values)
        explained += bool(marked(book, NOTHING["near"](rng, right), digits=1).explanations)
    assert explained <= 5


@pytest.mark.slow
def test_what_comes_of_nothing_beside_a_mistake_stays_open() -> None:
    rng = default_rng(13)
    more = []
    while len(more) < TABLES:
        book = random_book(rng)
        m = int(rng.integers(len(book.mistakes) - len(MISREAD)))
        values, right = with_mistake(book, m), np.array(book.keys[0].values)
        changed = np.abs(values / right - 1) > 0.05
        if changed.sum() < 3 or (~changed).sum() < 2:
            continue
        other = np.flatnonzero(~changed)[:2]
        values[other] = NOTHING["near"](rng, right)[other]
        found = marked(book, values).explanations
        more.append(any(m not in each.mistakes for each in found))
    assert np.mean(more) <= 0.02
