"""What the stages read of many variants, without reading the spec of each.

Nearly all of it are quantities times a unit, so that every number is an affine function of the swept values. Whether it
is so is seen at the ends of all ranges, at their corners, and at some places between. The checks of a spec ask for one
number whether it lies in a range, and for two of the same table which is larger, or whether they are equal: a variant
of which a table answers these as none did before is read as a whole, as are all where something is not affine. So of
coordinates that are 0 in the spec, and then on this side or that, every combination is read once.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from itertools import product
from typing import TYPE_CHECKING, Any, Generic, NamedTuple, TypeVar

import numpy as np
from numpy.typing import NDArray

from tmmcalc.batch.stacked_acting import Acting
from tmmcalc.batch.task import Task, verdict
from tmmcalc.core.errors import TmmError
from tmmcalc.core.numerics.alike import MixedError, SeveralError, alike, groups, numbers, paths, rebuilt, shape_of

if TYPE_CHECKING:
    from tmmcalc.project import Spec

Numbers = NDArray[np.complexfloating[Any, Any]]
Values = NDArray[np.floating[Any]]
Flags = NDArray[np.bool_]
Indices = NDArray[np.intp]
Signs = NDArray[np.int8]
T = TypeVar("T")

AFFINE = 1e-14  # relative error of a number as an affine function
SAME = 1e-9  # relative difference of two numbers that may be meant to be equal
PROBES = 8  # places between the ends
CORNERS = 16

# What may differ between variants: everything of which the array code takes one number a row.
FREE = re.compile(
    r"0\.(frame|links\.\d+|joints\.\d+)\.points\..+|0\.joints\.\d+\.directions\.\d|"
    r"0\.input\.(speed|acceleration|start)|0\.outputs\.\d+\.direction|"
    r"1\.bodies\.\d+\.(mass|inertia|center)|1\.gravity|1\.loads\.\d+\.(factor|point|direction|law\.(value|coefficient))|"
    r"1\.springs\.\d+\.(stiffness|free|damping|points\.\d)|1\.pairs\.\d+\.(friction|radius|length)|"
    r"2\.0\.motor\.(power|inertia|speed|synchronous|start)|2\.1\.(ratio|efficiency|inertia)|2\.2\.inertia|2\.3\.\w+|"
    r"3\.\d+\.((through|at)\.\d+|turn|shift)"
)
WANTED = "3."  # wanted paths, whose numbers no check compares
ONE_NUMBER = "what they read is asked for one number"
STUCK = "kinematics: the links do not reach throughout a turn of the crank"


class Together(NamedTuple, Generic[T]):
    """Of some variants, by their numbers among all asked for, what is solved together.

    Of others why they have to be solved alone, where a reason is known; ``refused`` are those that surely have no
    solution, with a reason that is shorter than what they say when they are solved alone.
    """

    found: dict[int, T]
    apart: dict[int, str]
    refused: dict[int, str]


def given(spec: Spec, loaded: bool, driven: bool, traced: bool) -> Any:
    """The linkage, what acts on it, the machine, wanted paths, as the stages read them; None for what is not asked."""
    from tmmcalc.linkage.tables.tasks.loading import to_loading
    from tmmcalc.linkage.tables.tasks.mechanism import to_linkage
    from tmmcalc.linkage.tables.tasks.paths import to_paths
    from tmmcalc.machine.tables.tasks.machine import to_flywheel, to_gears, to_motion, to_motor

    machine = (to_motor(spec), to_gears(spec), to_motion(spec), to_flywheel(spec)) if driven else None
    loading, paths = to_loading(spec) if loaded else None, to_paths(spec) if traced else None
    return to_linkage(spec.linkage), loading, machine, paths


class Inputs:
    """The inputs of all variants of a task like the one of the valid point ``first``.

    ``loaded``, ``driven`` and ``traced``: what acts on the linkage, the machine, and wanted paths are among them.
    """

    def __init__(self, task: Task, first: int, *, loaded: bool, driven: bool, traced: bool) -> None:
        self.first = task.values(first)
        self._task, self._variants = task, task.variants()
        self._asked = loaded, driven, traced
        self._origin = np.array(self.first)
        self.tree = given(self._variants.spec(task.assignments(first)), *self._asked)
        self._shape = shape_of(self.tree)
        self._base = np.array(numbers(self.tree), complex)
        self._plain = np.array([isinstance(number, float) for number in numbers(self.tree)])
        self._still = np.array([min(axis.values) == max(axis.values) for axis in task.axes])  # of no known slope
        self._slopes, seen = self._affine()
        self._scale = _scale(seen)
        self._differ = np.any(seen != self._base, axis=0)
        places = list(paths(self.tree))
        self._acting = Acting(places)
        compared = np.array([not place.startswith(WANTED) for place in places])
        self._pairs = _pairs(groups(self.tree), self._differ & compared)
        self._answers = _Answers(_signs(self._base[None], self._pairs)[0], np.array(groups(self.tree))[self._pairs[0]])

    @property
    def fixed(self) -> str | None:
        """What differs between variants although it may not, the first of it; None: nothing."""
        names = zip(paths(self.tree), self._differ, strict=True)
        return next((name for name, differs in names if differs and not FREE.fullmatch(name)), None)

    def numbers(self, values: Values) -> tuple[Numbers, Flags]:
        """The numbers (v, L) of variants with these values (v, axes), and which have inputs like those of the first."""
        there = np.ones(len(values), bool)
        if self._slopes is None:
            found = np.tile(self._base, (len(values), 1))
            for row in range(len(values)):
                there[row] = self._take(values[row], found[row])
        else:
            found = self._base + (values - self._origin) @ self._slopes
            signs = _signs(found, self._pairs)
            still = np.any((values != self._origin) & self._still, axis=1)
            for row in sorted({*self._answers.others(signs), *np.flatnonzero(still).tolist()}):
                if still[row] or not self._answers.known(signs[row]):
                    told = found[row].copy()
                    there[row] = self._take(values[row], found[row])
                    if there[row] and not still[row] and np.all(np.abs(found[row] - told) <= AFFINE * self._scale):
                        self._answers.add(signs[row])
                        found[row] = told  # the same to the last digit, whichever variant is the first
        same = self._acting(found) == self._acting(self._base[None])
        return found, there & np.all(same, axis=1)

    def parts(
        self, values: Values, solve: Callable[[Any, int], T], apart: dict[int, str]
    ) -> Iterator[tuple[Indices, T]]:
        """What ``solve`` makes of the stacked inputs of variants, in parts whose constants answer questions alike.

        With the numbers of the variants of each part among all. A part with a variant in which something has no
        solution is halved, and what then is left is left out. So is a part in which something asks for what one number
        alone can tell, or a fault of the program shows: ``apart`` gets the reason by variant.
        """
        found, there = self.numbers(values)
        waiting = [np.flatnonzero(there)]
        while waiting:
            which = waiting.pop()
            if not which.size:
                continue
            try:
                made = solve(self.stacked(found[which]), len(which))
            except (TmmError, MixedError):
                middle = len(which) // 2
                waiting += [which[middle:], which[:middle]] if middle else []
            except Exception as fault:
                reason = ONE_NUMBER if isinstance(fault, SeveralError) else verdict(fault)[1]
                apart.update((k, reason) for k in which.tolist())
            else:
                yield which, made

    def spec(self, values: Sequence[float] | Values) -> Spec:
        """The spec of a variant with these values of the axes."""
        axes = zip(self._task.axes, values, strict=True)
        return self._variants.spec([axis.assignment(float(value)) for axis, value in axes])

    def stacked(self, found: Numbers) -> Any:
        """The inputs of variants with these numbers (v, L) as one tree."""
        columns = (column.real if plain else column for column, plain in zip(found.T, self._plain, strict=True))
        return rebuilt(self.tree, [alike(np.ascontiguousarray(column)) for column in columns])

    def _take(self, values: Values, found: Numbers) -> bool:
        """Read the numbers (L,) of a variant; whether they are there, and those of the first that may not differ."""
        read = self._read(values)
        if read is not None:
            found[:] = read
        return read is not None and bool(np.all((read == self._base) | self._differ))

    def _read(self, values: Sequence[float] | Values) -> Numbers | None:
        """The numbers (L,) of a variant as its spec gives them; None for one that is none, or has other parts."""
        try:
            tree = given(self.spec(values), *self._asked)
        except Exception:  # solved alone it says why
            return None
        return np.array(numbers(tree), complex) if shape_of(tree) == self._shape else None

    def _affine(self) -> tuple[Numbers | None, Numbers]:
        """Slopes (axes, L) of the numbers, None where they are not affine all over; and the numbers seen (m, L)."""
        axes = self._task.axes
        ends = [(min(axis.values), max(axis.values)) for axis in axes]
        slopes = np.zeros((len(axes), len(self._base)), complex)
        seen: list[Numbers | None] = []
        for k, (low, high) in enumerate(ends):
            pair = []
            for end in (low, high):
                place = self._origin.copy()
                place[k] = end
                pair.append(self._read(place))
            seen += pair
            if pair[0] is not None and pair[1] is not None and low < high:
                slopes[k] = (pair[1] - pair[0]) / (high - low)
        places = _places(ends)
        read = [self._read(place) for place in places]
        whole = [row for row in (*seen, *read) if row is not None]
        known = np.array([self._base, *whole])
        if len(whole) < len(seen) + len(read):
            return None, known
        expected = self._base + (places - self._origin) @ slopes
        close = np.abs(np.array(read) - expected) <= AFFINE * _scale(known)
        return slopes if close.all() else None, known


class _Answers:
    """What the tables of variants answer that are read as the function tells: those of the ``first`` (q,), and others.

    ``owner`` (q/2,) are the tables of the questions, which both coordinates have.
    """

    def __init__(self, first: Signs, owner: Indices) -> None:
        self._first = first
        every = np.tile(owner, 2)
        self._tables = [np.flatnonzero(every == table) for table in np.unique(owner)]
        self._known = [{first[own].tobytes()} for own in self._tables]

    def others(self, signs: Signs) -> list[int]:
        """The variants, of answers (v, q), that do not answer as the first one."""
        found: list[int] = np.flatnonzero(np.any(signs != self._first, axis=1)).tolist()
        return found

    def known(self, signs: Signs) -> bool:
        """Whether every table has answered so before."""
        return all(signs[own].tobytes() in known for own, known in zip(self._tables, self._known, strict=True))

    def add(self, signs: Signs) -> None:
        """Note the answers (q,) of a variant that is read as the function tells."""
        for own, known in zip(self._tables, self._known, strict=True):
            known.add(signs[own].tobytes())


def _scale(seen: Numbers) -> Values:
    """How large the numbers (L,) of variants (m, L) are."""
    return np.asarray(np.maximum(np.max(np.abs(seen), axis=0), 1e-300))


def _places(ends: Sequence[tuple[float, float]]) -> NDArray[np.floating[Any]]:
    """Corners of the ranges, not more than some, and places between."""
    low, high = (np.array(side) for side in zip(*ends, strict=True))
    rng = np.random.default_rng(0)
    corners = list(product((0.0, 1.0), repeat=len(ends))) if 2 ** len(ends) <= CORNERS else []
    parts = np.array([*corners, *rng.integers(0, 2, (CORNERS - len(corners), len(ends)))], float)
    return np.asarray(low + (high - low) * np.concatenate((parts, rng.random((PROBES, len(ends))))))


def _pairs(owner: Sequence[int], differ: Flags) -> Indices:
    """Numbers of two numbers of one table, (2, m), at least one of which differs; one with itself stands for zero."""
    tables = np.array(owner)
    i, j = np.nonzero((tables[:, None] == tables) & differ[:, None])
    return np.stack((i, j))


def _signs(found: Numbers, pairs: Indices) -> Signs:
    """Which of two numbers (v, L) is larger, or whether they are equal: (v, 2 m) for both coordinates."""
    a, b = found[:, pairs[0]], np.where(pairs[0] == pairs[1], 0.0, found[:, pairs[1]])
    parts = [(a.real, b.real), (a.imag, b.imag)]
    return np.concatenate([_sign(one, other) for one, other in parts], axis=1)


def _sign(a: NDArray[np.floating[Any]], b: NDArray[np.floating[Any]]) -> Signs:
    far = np.abs(a - b) > SAME * np.maximum(np.abs(a), np.abs(b))
    return np.where(far, np.sign(a - b), 0.0).astype(np.int8)
