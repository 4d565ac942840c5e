"""What a flag names of several: positions by label and ranges of labels, a row, solution or pair by its number."""

from __future__ import annotations

from collections.abc import Sequence

from tmmcalc.core.errors import UsageError

CHOOSE = "--choose"
LISTED = 2000  # positions of a table for people, as in a CSV that nobody asked for


def rows_of(positions: str | None, labels: Sequence[str], flag: str = "--positions") -> list[int] | None:
    """Indices of the positions that ``'0,6,18'`` or ``'0:24:2'`` name; None for None.

    A range includes both ends, and the extra positions between them unless it has a step: then it counts the
    numbered ones. Raises UsageError for a label that is not there, a range without positions, and no positions at all.
    """
    if positions is None:
        return None
    if not labels:
        raise UsageError("there are no positions to choose from", where=flag, remedy="leave it out")
    rows: list[int] = []
    for part in (p.strip() for p in positions.split(",")):
        rows += _range(part, labels, flag) if ":" in part else [_row(part, part, labels, flag)]
    return rows


def check_choice(number: int, count: int, what: str, where: str = CHOOSE) -> None:
    """Raise UsageError unless there are so many rows, solutions, pairs, counted from 1."""
    if not 1 <= number <= count:
        some = f"write 1 to {count}" if count > 1 else f"there is {'one' if count else 'none'}"
        raise UsageError(f"there is no {what} {number}", where=where, value=number, limit=count, remedy=some)


def listed(count: int, everything: bool) -> range:
    """Positions that a table lists unless some are named: all, for people at most `LISTED` in even steps.

    >>> listed(25, False), listed(10_001, False), listed(10_001, True)
    (range(0, 25), range(0, 10001, 6), range(0, 10001))
    """
    return range(0, count, 1 if everything else max(-(-count // LISTED), 1))


def _row(label: str, part: str, labels: Sequence[str], flag: str) -> int:
    if label in labels:
        return labels.index(label)
    within = f" in {part!r}" if part != label else ""
    raise UsageError(f"no position is called {label!r}{within}", where=flag, remedy=_remedy(labels))


def _range(part: str, labels: Sequence[str], flag: str) -> list[int]:
    start, stop, *rest = (piece.strip() for piece in part.split(":"))
    first = _row(start, part, labels, flag) if start else 0
    last = _row(stop, part, labels, flag) if stop else len(labels) - 1
    if last < first:
        raise UsageError(f"{part!r} runs backwards", where=flag, remedy="write the lower position first")
    rows = range(first, last + 1)
    if not rest:
        return list(rows)
    if len(rest) > 1 or not rest[0].isdecimal() or int(rest[0]) == 0:
        raise UsageError(f"{part!r} is not first:last:step", where=flag, remedy=_remedy(labels))
    return [k for k in rows if labels[k].isdecimal()][:: int(rest[0])]


def _remedy(labels: Sequence[str]) -> str:
    """What can be written, with the extra positions, which nobody knows by heart."""
    extra = [label for label in labels if not label.isdecimal()]
    also = f" and {', '.join(extra[:8])}{', ...' if len(extra) > 8 else ''}" if extra else ""
    numbered = [label for label in labels if label.isdecimal()]
    return f"positions are {numbered[0]} to {numbered[-1]}{also}; write '0,6,12' or a range '0:12:2'"
