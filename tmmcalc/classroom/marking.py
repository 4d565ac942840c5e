"""The marks of a class: of every hand-in each answer, why it is wrong, and the points."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from tmmcalc.classroom.answers.handed import Answer, HandIn, Pile, Refused
from tmmcalc.classroom.carrying import OFF, carried_values, plausible
from tmmcalc.classroom.explaining import Explanation, explain
from tmmcalc.classroom.model import Item, Key, Keybook, Told, Values
from tmmcalc.classroom.verdicts import Standing, is_within, rounding, standing_of
from tmmcalc.core.notes import Phrase
from tmmcalc.core.records import record


@record
class Rules:
    """What answers that are not simply right or wrong are worth, as a part of their weight."""

    for_plans: float = 0.5
    for_carried: float = 0.8


@record
class Marked:
    """A hand-in with its marks."""

    number: int
    student: str
    source: str
    answers: tuple[Answer, ...]  # (I,)
    standings: tuple[Standing, ...]  # (I,)
    points: Values  # (I,)
    explanations: tuple[Explanation, ...]
    remarks: tuple[str, ...]
    counts: bool  # whether it is the last of the student

    @property
    def total(self) -> float:
        """All points."""
        return math.fsum(self.points)


@record
class Marks:
    """The marks of a class."""

    items: tuple[Item, ...]
    mistakes: tuple[Told, ...]
    keys: tuple[Key, ...]
    marked: tuple[Marked, ...]  # by student, of one student in the order of time
    absent: tuple[Key, ...]  # who handed in nothing
    refused: tuple[Refused, ...]
    empty: tuple[str, ...]  # files without an answer
    most: float  # points that there are

    @property
    def counting(self) -> tuple[Marked, ...]:
        """The last hand-in of each student."""
        return tuple(each for each in self.marked if each.counts)


def mark(book: Keybook, pile: Pile, rules: Rules) -> Marks:
    """Mark all that was handed in; of several hand-ins of a student the last counts, and all are kept."""
    keys = {key.number: key for key in book.keys}
    last = {each.number: k for k, each in enumerate(pile.hand_ins)}
    marked = [
        mark_one(book, keys[each.number], each, rules, counts=last[each.number] == k)
        for k, each in enumerate(pile.hand_ins)
    ]
    return Marks(
        book.items,
        book.mistakes,
        book.keys,
        tuple(sorted(marked, key=lambda each: each.number)),
        tuple(key for key in book.keys if key.number not in last),
        pile.refused,
        pile.empty,
        math.fsum(item.weight for item in book.items),
    )


def mark_one(book: Keybook, key: Key, handed: HandIn, rules: Rules, counts: bool = True) -> Marked:
    """Mark one hand-in against the key of its variant."""
    items, answers = book.items, handed.answers
    standings = [standing_of(*each) for each in zip(answers, items, key.values, strict=True)]
    carried = carried_values(items, key.values, answers, standings)
    values = np.array([each.value for each in answers])
    halves = np.array([each.step / 2 for each in answers])
    explanations = explain(items, book.mistakes, key, (values, halves), standings, np.array(carried))
    explanations = tuple(_with_plans(book, key, answers, standings, each) for each in explanations)
    for k in {k for each in explanations for k in each.items if standings[k] is Standing.plans}:
        standings[k] = Standing.wrong
    for k in _carried_on(items, key, answers, standings, carried, explanations):
        standings[k] = Standing.carried
    points = tuple(_points(item, standing, rules) for item, standing in zip(items, standings, strict=True))
    remarks = handed.remarks + tuple(_few(*each) for each in zip(items, answers, strict=True) if _is_few(*each))
    return Marked(
        key.number, key.student, handed.source, answers, tuple(standings), points, explanations, remarks, counts
    )


def _with_plans(
    book: Keybook, key: Key, answers: Sequence[Answer], standings: Sequence[Standing], found: Explanation
) -> Explanation:
    """With the answers that are right by plans, where a mistake of the whole solution gives just these numbers."""
    mistake = found.mistakes[0]
    if book.mistakes[mistake].single:
        return found
    predicted = key.mistaken[mistake]
    more = [
        k
        for k, (item, answer) in enumerate(zip(book.items, answers, strict=True))
        if standings[k] is Standing.plans and is_within(answer.value, predicted[k], item, item.tolerance)
    ]
    return replace(found, items=tuple(sorted({*found.items, *more})), against=tuple({*found.against} - {*more}))


def _carried_on(
    items: Sequence[Item],
    key: Key,
    answers: Sequence[Answer],
    standings: Sequence[Standing],
    carried: Values,
    explanations: Sequence[Explanation],
) -> list[int]:
    """The wrong answers that are right for a wrong one before them, in the order of the items."""
    explained = {k for each in explanations for k in each.items}
    believed = {
        k
        for k, standing in enumerate(standings)
        if standing in OFF and (k in explained or plausible(answers[k].value, key.values[k], items[k]))
    }
    found = []
    for k, item in enumerate(items):
        before = [j for j in item.after if standings[j] in OFF]
        if standings[k] is not Standing.wrong or not before:
            continue
        together = any(k in each.items and any(j in each.items for j in before) for each in explanations)
        if together or (math.isfinite(carried[k]) and all(j in believed for j in before)):
            found.append(k)
            believed.add(k)
    return found


def _points(item: Item, standing: Standing, rules: Rules) -> float:
    part = {Standing.right: 1.0, Standing.plans: rules.for_plans, Standing.carried: rules.for_carried}
    return item.weight * part.get(standing, 0.0)


def _is_few(item: Item, answer: Answer) -> bool:
    return 0 < answer.figures < item.digits - 1 and 2 * rounding(answer, item) < answer.step


def _few(item: Item, answer: Answer) -> str:
    told, asked = answer.figures, item.digits
    return Phrase("{item}: {told} of the {asked} figures that are asked", item=item.name, told=told, asked=asked)
