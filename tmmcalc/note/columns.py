"""How wide the columns of a table are: as their texts ask where there is room, else no less than words in them ask."""

from __future__ import annotations

from collections.abc import Iterable
from functools import lru_cache
from typing import NamedTuple

from tmmcalc.note.tree import Grid, Text, part_width, tied

LOOSE = 1.02  # a text of several words may be so much wider than its letters, for pairs of them that stand apart
HALVINGS = 24  # of the widest column: to less than a thousandth of a point


class Asked(NamedTuple):
    """What a text or the columns of a table ask for, in em of their letters."""

    least: float  # for what cannot be broken: a word, or a formula with what is written to it
    whole: float  # for all of it on one line


def asked(cell: Text) -> Asked:
    """The room that a text asks for."""
    least, whole, here = 0.0, 0.0, 0.0
    for part in cell.parts:
        words = tied(part).split(" ") if isinstance(part, str) and " " in part else [part]
        for k, word in enumerate(words):
            here = part_width(word) + (0.0 if k else here)
            least = max(least, here)
        whole += part_width(part)
    return Asked(least, LOOSE * whole if whole > least else least)


def most(texts: Iterable[Asked]) -> Asked:
    """The room in which each of several texts has its own."""
    least, whole = zip(*texts, strict=True)
    return Asked(max(least), max(whole))


@lru_cache(maxsize=1024)
def measured(grid: Grid) -> tuple[tuple[Asked, ...], ...]:
    """The room that each text of a table asks for, by rows, of which the head is the first."""
    return tuple(tuple(map(asked, row)) for row in (grid.head, *grid.rows))


@lru_cache(maxsize=1024)
def asked_by(grid: Grid) -> tuple[Asked, ...]:
    """The room that each column of a table asks for."""
    return tuple(map(most, zip(*measured(grid), strict=True)))


def least_width(grid: Grid, em: float, beside: float) -> float:
    """How wide a table is at least: with an em so wide, and so much beside the letters of each column [mm]."""
    return sum(column.least * em + beside for column in asked_by(grid))


def widths_of(grid: Grid, em: float, beside: float, room: float) -> list[float]:
    """How wide its columns are [mm]: as their longest texts ask, as far as there is room for them.

    Where there is not, the widest give way first, each no further than to its longest word; if that is too much they
    fill the room all the same.
    """
    columns = asked_by(grid)
    least = [column.least * em + beside for column in columns]
    wished = [column.whole * em + beside for column in columns]

    if sum(least) >= room:
        return [room * need / sum(least) for need in least]
    if sum(wished) <= room:
        return wished

    def given(limit: float) -> list[float]:
        return [min(wish, max(need, limit)) for wish, need in zip(wished, least, strict=True)]

    low, high = 0.0, max(wished)
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        low, high = (middle, high) if sum(given(middle)) <= room else (low, middle)
    return given(low)
