"""Results by name as a function of numbers of the spec, at any number of places at once, by the batch engine."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from tmmcalc.batch.choice import cluster, heavy, local
from tmmcalc.batch.executors import Solve, solve_here
from tmmcalc.batch.local import available, cores
from tmmcalc.batch.places import ALIKE, SOLVER, Place
from tmmcalc.batch.points import run_of
from tmmcalc.batch.preparing import prepared
from tmmcalc.batch.quantities import offered_like, others, told, unknown, unmatched
from tmmcalc.batch.task import BROKEN, Row, Task
from tmmcalc.core.records import record
from tmmcalc.naming.scene import Scene

if TYPE_CHECKING:
    from tmmcalc.pipeline.outcome import RunResult

Values = NDArray[np.floating[Any]]
Told = Callable[[int], None]  # places that are done
Where = Callable[[str], str]  # where a name of a result is asked for, for messages

BLOCK = 256  # places at most that are solved and sent together
LEAST = 32  # and at least, where they are solved together; blocks at most of others
PARTS = 4  # blocks of a few places that are solved together
FEW = 64  # places that are not worth a process


@record
class Answers:
    """Values (n, m) of m results at n places, NaN where one has none; why (n,), empty where all is solved."""

    values: Values
    reasons: tuple[str, ...]

    @property
    def solved(self) -> NDArray[np.bool_]:
        """Places (n,) with all results."""
        return np.asarray(np.isfinite(self.values).all(axis=1))


class Model:
    """Named results of a scene over the axes of a frame (`batch.reading.frame_of`).

    ``names`` are those that its patterns stand for at the spec as it is, ``nominal`` (k,) the values of its keys there,
    ``found`` (m,) those of the results; ``brief``: see `Task`. Raises the error of the spec as it is, and UsageError
    for a pattern that names nothing.
    """

    def __init__(
        self, frame: Task, solver: Solve = solve_here, brief: bool = False, *, where: Where = lambda name: "--of"
    ) -> None:
        self.run: RunResult = run_of(frame, frame.variants().spec())
        error = next(iter(self.run.failures.values()), None)
        scene = Scene(self.run.spec, self.run.results)
        values = dict(told(self.run.results, frame.patterns, scene, [*self.run.outcomes]))
        missed = unmatched(values, frame.patterns)
        if missed is not None:
            if error is not None:
                raise error
            known = [name for name, _ in told(self.run.results, others(missed))]
            raise unknown(missed, [*known, *offered_like(missed, self.run.results, self.run.spec)], where(missed))
        self.names = tuple(values)
        self.found = np.array([*values.values()])
        self.nominal = np.array(frame.values(0))
        self.keys = tuple(axis.name for axis in frame.axes)
        self._frame = replace(frame, patterns=self.names, solver=SOLVER, brief=brief)
        self._solve = solver

    def over(self, some: Sequence[int], low: Values, high: Values, about: Sequence[float] | None = None) -> Model:
        """The same as a function of some of the keys, made ready for places between ``low`` and ``high`` (len(some),).

        Beyond these it may be slow. ``about`` (len(some),) is another place within than that of the spec.
        """
        other = object.__new__(Model)
        vars(other).update(vars(self))
        other.nominal, other.keys = self.nominal[[*some]], tuple(self.keys[k] for k in some)
        axes = tuple(self._frame.axes[k] for k in some)
        middle = other.nominal.tolist() if about is None else [*about]
        other._frame = replace(self._frame, axes=axes).at([middle, low.tolist(), high.tolist()])
        return other

    def by(self, solver: Solve) -> Model:
        """The same, of which places are solved so."""
        other = object.__new__(Model)
        vars(other).update(vars(self), _solve=solver)
        return other

    @property
    def together(self) -> bool:
        """Whether places are solved together."""
        return not isinstance(prepared(self._frame), str)

    def __call__(self, places: Values, told: Told = lambda done: None) -> Answers:
        """The results at places (n, k)."""
        rows: list[Row] = []
        for some in self.rows(enumerate(places.tolist())):
            rows += some
            told(len(rows))
        return self.answers(rows)

    def rows(self, places: Iterator[tuple[int, Sequence[float]]], *, alike: bool = False) -> Iterator[list[Row]]:
        """Rows of numbered places as they come, in any order; ``alike``: of those alone that are solved together."""
        every = [Place(number, tuple(values)) for number, values in places]
        # blocks depend on nothing but the number of places, so that values are the same at any number of processes
        size = min(BLOCK, max(LEAST, -(-len(every) // PARTS))) if self.together else max(1, len(every) // LEAST)
        frame = replace(self._frame, solver=ALIKE) if alike else self._frame
        yield from self._solve(frame, [every[at : at + size] for at in range(0, len(every), size)])

    def answers(self, rows: Sequence[Row]) -> Answers:
        """The results that rows hold, in the order of their numbers; raises a fault of the program."""
        ordered = sorted(rows, key=lambda row: row.point)
        values = np.full((len(ordered), len(self.names)), np.nan)
        place = {name: at for at, name in enumerate(self.names)}
        for at, row in enumerate(ordered):
            if row.status == BROKEN:
                raise RuntimeError(row.reason)
            for name, value in zip(row.names, row.values, strict=True):
                if name in place:
                    values[at, place[name]] = value
        return Answers(values, tuple(row.reason for row in ordered))


def solver_of(task: Task, count: int, jobs: int | None, scheduler: str | None, tell: Callable[[str], None]) -> Solve:
    """Who solves ``count`` places: this process, as many as pay (``jobs`` None) or are asked for, or a cluster.

    Raises UsageError for ``jobs`` beside a ``scheduler``, and where joblib or distributed is not installed.
    """
    if scheduler is not None:
        return cluster(scheduler, jobs, tell, kept=True)
    if jobs is None:
        many = count > FEW * BLOCK or (heavy(task) and count > FEW)
        jobs = cores() if many and available() else 1
    return local(jobs, tell, kept=True)
