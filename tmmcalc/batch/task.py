"""The points of a sweep: a grid over ranges of keys, or the rows of a table; and what is asked of each."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from tmmcalc.core.errors import SpecError, TmmError
from tmmcalc.core.records import record
from tmmcalc.spec.variants import Axis

if TYPE_CHECKING:
    from tmmcalc.project.loader import Variants


@record
class Task:
    """One sweep. It is plain data, so that it can be sent to other processes."""

    text: str  # of the spec
    file: str  # its name in messages
    folder: str  # from which files that it names are read
    fixed: tuple[str, ...]  # overrides of all variants
    axes: tuple[Axis, ...]
    listed: bool = False  # the axes are columns of a table, a row a point; else they span a grid
    targets: tuple[str, ...] = ()  # stages to reach; empty: all that a variant has
    patterns: tuple[str, ...] = ()  # names and wildcards of the quantities; empty: all facts of the targets
    labels: tuple[tuple[str, tuple[str, ...]], ...] = ()  # further columns of the table, header and texts: no keys
    tolerance: float | None = None  # relative error asked of every stage
    solver: str = "tmmcalc.batch.points:solve_points"  # (task, points) -> rows, "module:function"
    block: int = 16  # points that are solved and sent together
    brief: bool = False  # of variants that do not assemble no more than that is asked for: no place, no lengths

    @property
    def count(self) -> int:
        """Number of points."""
        sizes = [len(axis.values) for axis in self.axes]
        return sizes[0] if self.listed else math.prod(sizes)

    def values(self, point: int) -> tuple[float, ...]:
        """Values of the keys at a point, counted from 0; of a grid the last key runs fastest."""
        if self.listed:
            return tuple(axis.values[point] for axis in self.axes)
        found = []
        for axis in reversed(self.axes):
            point, at = divmod(point, len(axis.values))
            found.append(axis.values[at])
        return tuple(reversed(found))

    def assignments(self, point: int) -> list[str]:
        """The overrides that make the variant."""
        return [axis.assignment(value) for axis, value in zip(self.axes, self.values(point), strict=True)]

    def at(self, points: Sequence[Sequence[float]]) -> Task:
        """The same with other points, by the values of the keys."""
        columns = zip(*points, strict=True)
        axes = (replace(axis, values=tuple(map(float, own))) for axis, own in zip(self.axes, columns, strict=True))
        return replace(self, axes=tuple(axes), listed=True, labels=())

    def spread(self) -> list[int]:
        """A few points over the sweep, the first one first."""
        last = self.count - 1
        return list(dict.fromkeys((0, last, last // 2, last // 4, 3 * last // 4)))

    def variants(self) -> Variants:
        """The spec, read once for many variants."""
        from tmmcalc.project.loader import Variants

        return Variants(self.text, self.file, Path(self.folder), self.fixed)


@record
class Row:
    """What became of a point. Names are ``stage.quantity[unit]``; ``status`` is ``ok`` or ``failed`` and a code."""

    point: int
    status: str
    reason: str
    names: tuple[str, ...] = ()
    values: Sequence[float] = ()
    alone: str = ""  # why, although others were solved together

    @property
    def ok(self) -> bool:
        """Whether the variant was solved."""
        return self.status == OK


OK = "ok"
INVALID = "failed 2"  # the variant is no valid spec, or lacks what was asked for
UNSOLVED = "failed 3"  # the variant has no solution
BROKEN = "failed 1"  # a fault of the program, or a process that died


def verdict(error: Exception | None) -> tuple[str, str]:
    """Status and reason, one line each.

    >>> from tmmcalc.core.errors import UsageError
    >>> verdict(None), verdict(UsageError("no such thing", where="forces"))
    (('ok', ''), ('failed 2', 'forces: no such thing'))
    """
    if error is None:
        return OK, ""
    if not isinstance(error, TmmError):
        return BROKEN, _line(f"a fault of the program: {type(error).__name__}: {error}")
    if isinstance(error, SpecError):
        first, *others = error.faults
        more = f" (and {len(others)} more)" if others else ""
        return f"failed {error.exit_code}", _line(f"{first.path}: {first.message}{more}".removeprefix(": "))
    return f"failed {error.exit_code}", _line(f"{error.where}: {error.message}".removeprefix(": "))


def _line(text: str) -> str:
    return " ".join(text.split())
