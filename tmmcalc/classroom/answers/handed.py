"""What has been handed in: the answers of each student, and the files that tell none."""

from __future__ import annotations

import math
from collections.abc import Sequence

from tmmcalc.classroom.answers.figures import NoNumberError, read_number
from tmmcalc.classroom.answers.layouts import Entry
from tmmcalc.classroom.answers.measures import UnitOfAnswerError, factor_to, in_unit
from tmmcalc.classroom.model import Item
from tmmcalc.core.notes import Phrase
from tmmcalc.core.records import record


@record
class Answer:
    """An answer to an item."""

    text: str  # as it stands, with its unit; empty: nothing
    value: float  # in the unit of the item; NaN: no number
    step: float  # one of its last figure, likewise
    figures: int  # significant ones
    fault: str = ""  # why it is no number


NOTHING = Answer("", math.nan, math.nan, 0)


@record
class HandIn:
    """What a student handed in at one time."""

    number: int  # of the variant
    source: str  # the file, as the folder of answers names it
    answers: tuple[Answer, ...]  # (I,)
    remarks: tuple[str, ...] = ()


@record
class Refused:
    """A file, or a part of it, that is marked for nobody."""

    source: str
    message: str
    remedy: str = ""


@record
class Pile:
    """All that was handed in, in the order of time: of several of a student the last counts."""

    hand_ins: tuple[HandIn, ...]
    refused: tuple[Refused, ...]
    empty: tuple[str, ...] = ()  # files that ask for results and answer none, as tables do that were given out


def hand_in(number: int, source: str, entries: Sequence[Entry], items: Sequence[Item]) -> HandIn:
    """The answers of one student out of one file; of an item that stands there twice the last counts, with a remark."""
    answers = [NOTHING] * len(items)
    remarks = []
    for entry in entries:
        answer = answer_of(entry, items[entry.item])
        before = answers[entry.item]
        if before.text and answer.text and before.text != answer.text:
            remarks.append(
                Phrase(
                    "{item} stands there twice, the second time in {where} with another value, which counts",
                    item=items[entry.item].name,
                    where=entry.where,
                )
            )
        if answer.text:
            answers[entry.item] = answer
    return HandIn(number, source, tuple(answers), tuple(remarks))


def answer_of(entry: Entry, item: Item) -> Answer:
    """The number of an answer in the unit of its item, or why there is none."""
    if not entry.value or entry.value in ("-", "–", "—"):
        return NOTHING
    text = f"{entry.value} {entry.unit}".strip()
    try:
        written = read_number(entry.value)
        factor = factor_to(written.unit or entry.unit, item.unit)
    except (NoNumberError, UnitOfAnswerError) as fault:
        return Answer(text, math.nan, math.nan, 0, fault.args[0])
    return Answer(text, in_unit(written.value, factor), in_unit(written.step, factor), written.figures)
