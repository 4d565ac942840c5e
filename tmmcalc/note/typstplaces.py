"""Where blocks of the note stand on pages: beside each other, in the text, at the end of a page or of their chapter."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from enum import Enum, auto

from tmmcalc.note.tree import ACROSS, Equation, Grid, Image, Points, Text, Title, Written, part_width
from tmmcalc.note.typsttables import beside, floating, has_room
from tmmcalc.note.typstwords import EM, GAP

HIGH, ROW = 263.0, 5.0  # of the text of a page, and of a row of it at least [mm]
CLOSING = 3  # paragraphs at the end of a chapter which stand over the pictures and tables that it ends with


class Place(Enum):
    """Where a group stands."""

    HERE = auto()  # in the text
    PAGE = auto()  # at the end of this page, or on a later one over the text
    LAST = auto()  # at the end of its chapter, for it would float into the next one, under its title


def placed(blocks: Iterable[Written]) -> Iterator[tuple[Sequence[Written], Place]]:
    """Groups of blocks that stand beside each other, with their places."""
    chapter: list[tuple[Sequence[Written], Place]] = []
    for group, place in _in_order(_grouped(blocks)):
        if _opens(group):
            yield from _closed(chapter)
            chapter = []
        chapter.append((group, place))
    yield from _closed(chapter)


def _opens(group: Sequence[Written]) -> bool:
    """Whether a chapter begins with it."""
    return isinstance(group[0], Title) and group[0].level == 1


def _closed(chapter: Sequence[tuple[Sequence[Written], Place]]) -> Iterator[tuple[Sequence[Written], Place]]:
    """A chapter whose last pictures and tables stand under its last words."""
    end, words = len(chapter), 0
    while end:
        group, place = chapter[end - 1]
        text = isinstance(group[0], Text)
        if not (place is Place.PAGE or (text and words < CLOSING)):
            break
        end, words = end - 1, words + text
    yield from chapter[:end]
    yield from (each for each in chapter[end:] if each[1] is Place.HERE)
    yield from ((group, Place.LAST) for group, place in chapter[end:] if place is Place.PAGE)


def _in_order(groups: Iterable[list[Written]]) -> Iterator[tuple[list[Written], Place]]:
    """The groups and whether they float: pictures, long tables, and every table that follows such a one within a page.

    What floats may wait for the next page, and a table that stood in the text after it would come before it.
    """
    since = math.inf
    for group in groups:
        if _opens(group):
            since = math.inf  # all that floats is set
        table = isinstance(group[0], Grid) and floating(group, waits=since < HIGH)
        since = 0.0 if table else since + sum(map(_least_height, group))
        yield group, Place.PAGE if table or isinstance(group[0], Image) else Place.HERE


def _least_height(block: Written) -> float:
    """About how high a block is at least in the text [mm]; of what floats nothing."""
    match block:
        case Text():
            return ROW * math.ceil(sum(map(part_width, block.parts)) * EM / ACROSS)
        case Points(items):
            return sum(map(_least_height, items))
        case Grid():
            return ROW * len(block.rows)
        case Image():
            return 0.0
    return ROW


def _grouped(blocks: Iterable[Written]) -> Iterator[list[Written]]:
    """What may stand beside each other: a formula and its explanation, its numbers at places, tables and pictures."""
    group: list[Written] = []
    for block in blocks:
        if group and not _joins(group, block):
            yield group
            group = []
        group.append(block)
    if group:
        yield group


def _joins(group: Sequence[Written], block: Written) -> bool:
    """Whether a block stands beside those before it."""
    last = group[-1]
    match block:
        case Text(_, explains):
            return explains and isinstance(last, Equation) and bool(last.number)
        case Equation(_, number):
            return not number and isinstance(last, Equation | Text) and isinstance(group[0], Equation)
        case Image(_, drawing) if isinstance(last, Grid):
            return len(group) == 1 and has_room(last, drawing.width)
        case Image(_, drawing):
            drawings = [each.drawing for each in group if isinstance(each, Image)]
            free = ACROSS - sum(each.width + GAP for each in drawings)
            return len(drawings) == len(group) and drawing.width <= free
        case Grid():
            grids = [each for each in (*group, block) if isinstance(each, Grid)]
            return len(grids) > len(group) and beside(grids)
    return False
