"""What the names of results stand for: values with unit and meaning, found in the results of stages.

Every quantity says how its value was found. Extremes, means and where they are go by the rows of the table as they
stand, each counting once. An integral is that of the cubic through the four nearest rows, over what the rows run over
(angles in rad), which on equal steps around a whole turn is the trapezoid rule with its full accuracy; no cubic reaches
over a jump, where two rows have one place, and around a turn that closes it goes on from the first row. A value between
two rows is computed there where the stage can do that (`placed` of a stage, as kinematics and forces can), so it is as
exact as its rows; else it is that of the same cubic, with its distance from the polynomial through six rows.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.errors import UsageError
from tmmcalc.core.facts import labelled, named
from tmmcalc.core.numerics.through import between, integral
from tmmcalc.core.records import record
from tmmcalc.core.stage import STAGES, arguments
from tmmcalc.spec.meanings import described
from tmmcalc.spec.naming import ROWS, Name, Place, like, near
from tmmcalc.spec.units import UnitError, dimension_of
from tmmcalc.spec.units import parse as in_si

Values = NDArray[np.floating[Any]]

REDUCED: Mapping[str, Callable[[Values], Any]] = {  # what is asked of columns (..., n) by themselves
    "max": lambda values: np.max(values, axis=-1),
    "min": lambda values: np.min(values, axis=-1),
    "range": lambda values: np.ptp(values, axis=-1),
    "mean": lambda values: np.mean(values, axis=-1),
    "rms": lambda values: np.sqrt(np.mean(values**2, axis=-1)),
    "size": lambda values: np.max(np.abs(values), axis=-1),
    "first": lambda values: values[..., 0],
    "last": lambda values: values[..., -1],
}
WHERE: Mapping[str, Callable[[Values], Any]] = {
    "at_max": np.argmax,
    "at_min": np.argmin,
    "at_size": lambda values: np.argmax(np.abs(values)),
}
MEANT = {"at_max": "where it is largest", "at_min": "where it is smallest", "at_size": "where its magnitude is largest"}
PLACED = "phi"  # the column whose values are places that `placed` of a stage takes
SAME = 1e-9  # of what the rows run over: a row nearer than this is at the place
CLOSED = 1e-9  # of the largest value: the ends of a turn that closes differ by less


@record
class Told:
    """One quantity of a stage."""

    stage: str
    quantity: str  # its name without stage and unit
    value: float
    unit: str
    how: str  # the value was found; empty: it stands in the result
    meaning: str = ""
    symbol: str = ""

    @property
    def key(self) -> str:
        """``stage.quantity[unit]``."""
        return f"{self.stage}.{self.quantity}{f'[{self.unit}]' if self.unit else ''}"


@record
class Extent:
    """One column of a stage's table."""

    stage: str
    quantity: str  # its name without stage and unit
    unit: str
    least: float
    greatest: float
    rows: int
    meaning: str = ""
    symbol: str = ""


@record
class Again:
    """What stages read of the scene with one row more at a place, in their order: plain values."""

    place: Place
    inputs: tuple[tuple[str, Any], ...]


class Anew:
    """The tables of stages solved anew, each once, with a row at a place; ``results`` are those of the scene."""

    def __init__(self, again: Sequence[Again], results: Mapping[str, Any]) -> None:
        self._inputs = {each.place: each.inputs for each in again}
        self._results = results
        self._found: dict[Place, dict[str, Any]] = {}

    def table(self, stage: str, place: Place) -> Table | None:
        """The table with the row at a place; None where the stage has no such rows."""
        inputs = self._inputs.get(place, ())
        if stage not in dict(inputs):
            return None
        found = self._found.setdefault(place, {})
        for name, given in inputs:
            if name not in found:
                own = STAGES[name]
                read = own.given({**self._results, **found})
                found[name] = own.solve(*arguments(given), **read, **own.settings)
            if name == stage:
                break
        return table_of(stage, found[stage])


class Table(NamedTuple):
    """A table of a result: what every row is, and its columns of numbers."""

    first: Any  # (n,) what the rows are called
    headers: list[str]
    make: Callable[[int], Any]  # the column (n,) of a header by its number

    @property
    def labels(self) -> list[str]:
        """What the rows are called, in the words of a place."""
        return [f"{label:g}" if isinstance(label, float) else str(label) for label in self.first.tolist()]

    def column(self, header: str) -> Values:
        """The values under a header."""
        return np.asarray(self.make(self.headers.index(header)), float)


def told(stage: str, result: Any, names: Sequence[Name], anew: Anew | None = None) -> Iterator[Told]:
    """What a stage tells under these names, all its facts without names; each once.

    Raises `UsageError` for a place that the rows do not have.
    """
    met: dict[str, Told] = {}
    asked = [name for name in names if name.fact and name.may_be_of(stage)]
    if asked or not names:
        for each in _facts(stage, result):
            own = Name(stage, "", each.quantity, unit=each.unit)
            if not names or any(name.fits(own) for name in asked):
                met.setdefault(each.key, each)
    rows = [name for name in names if not name.fact and name.may_be_of(stage)]
    if rows and (table := table_of(stage, result)) is not None:
        for name in rows:
            for each in _of_table(stage, result, table, name, anew):
                met.setdefault(each.key, each)
    yield from met.values()


def one(name: Name, results: Mapping[str, Any], anew: Anew | None = None) -> Told:
    """The one quantity of a name among the results by stage.

    Raises `UsageError` with the nearest names if none has it, with the stages if several have it.
    """
    if name.stage and not name.wild and name.stage not in results:
        raise UsageError(f"this scene has no {name.stage}", remedy="tmmcalc plan says why a stage is left out")
    if name.wild:
        raise UsageError(f"{name.text} may name several quantities", remedy="write one name, without * and ?")
    stages = [name.stage] if name.stage else [*results]
    found = [each for stage in stages for each in told(stage, results[stage], [name], anew)]
    if not found:
        raise unknown(name, {stage: results[stage] for stage in stages})
    if len(found) > 1:
        several = ", ".join(each.stage for each in found)
        raise UsageError(
            f"{name.text} is told by several stages: {several}",
            remedy=f"name one: {', '.join(f'{each.stage}.{each.quantity}' for each in found)}",
        )
    return found[0]


def unknown(name: Name, results: Mapping[str, Any]) -> UsageError:
    """The error of a name that names nothing in these results, with the nearest of what there is."""
    alone = name.stage if name.stage in results else ""
    columns = [header for stage, result in results.items() for header in columns_of(stage, result)]
    if name.fact:
        every = [f"{stage}.{each.quantity}" for stage, result in results.items() for each in _facts(stage, result)]
        if any(column.partition(".")[2] == name.what for column in columns):
            return UsageError(
                f"{name.text} is a column: it has a value at every row",
                remedy=f"say what is asked of it, such as max({name.what}), or where, such as {name.what}@0",
            )
    else:
        every = columns
    kind = "facts" if name.fact else "columns"
    if alone:
        remedy = near(name.what, (each.partition(".")[2] for each in every), f"its {kind} are")
        return UsageError(f"{alone} tells no {name.what!r}", remedy=remedy)
    return UsageError(f"no quantity is called {name.text!r}", remedy=near(name.what, every, kind))


def columns_of(stage: str, result: Any) -> list[str]:
    """The columns of numbers of a stage by name, with the stage and without unit."""
    table = table_of(stage, result)
    return [f"{stage}.{named(header)[0]}" for header in table.headers] if table else []


def again_of(spec: Any, names: Iterable[Name]) -> tuple[Again, ...]:
    """What is read anew for names of places between the rows: of stages whose rows are places of the scene."""
    found: dict[Place, Again] = {}
    for name in names:
        for place in _single(name.place):
            if place not in found and (inputs := _inputs(spec, place)):
                found[place] = Again(place, inputs)
    return tuple(found.values())


def _single(place: Place | None) -> Iterator[Place]:
    """The places, one by one, of one that goes by the values of a column."""
    if place is not None and place.column:
        yield place._replace(last="")
        if place.last:
            yield Place(place.column, place.last)


def _inputs(spec: Any, place: Place) -> tuple[tuple[str, Any], ...]:
    """What every stage reads that has rows at places, if the scene has it and this is the column that they run over."""
    found, placed = [], dict[Any, Any]()
    for name, stage in STAGES.items():
        put = stage.part("placed") if stage.unwanted(spec) is None and place.column == PLACED else None
        if put is not None:
            try:
                if put not in placed:
                    placed[put] = put(spec, place.first)
            except (UnitError, UsageError):
                continue  # told where the rows are known; or there is no mechanism
            found.append((name, stage.inputs(placed[put])))
    return tuple(found)


MEANT = {"at_max": "where it is largest", "at_min": "where it is smallest", "at_size": "where its magnitude is largest"}
PLACED = "phi"  # what the rows run over that can be asked for anywhere


def table_of(stage: str, result: Any) -> Table | None:
    """The columns of numbers of a result; None if it has no rows."""
    made = STAGES[stage].table(result)
    if made is None or not made.rows:
        return None
    first = np.asarray(made.columns[0])
    numbers = [k for k in range(len(made.header)) if k or first.dtype.kind in "fi"]

    def make(at: int) -> Any:
        return made.columns[numbers[at]]

    return Table(first, [made.header[k] for k in numbers], make)


def listed(stage: str, result: Any) -> Iterator[Told | Extent]:
    """All that a stage tells: its facts, then its columns."""
    yield from _facts(stage, result)
    table, known = table_of(stage, result), described(stage, column=True)
    made = STAGES[stage].part("columns")
    own = made(result) if made else ()
    declared = {} if isinstance(own, Mapping) else {each.name: (each.meaning, each.symbol) for each in own}
    for at, header in enumerate(table.headers if table else ()):
        if table is not None and np.asarray(table.make(at)).dtype.kind in "fi":
            (column, unit), values = named(header), table.column(header)
            meant = declared.get(column) or known(column, unit)
            least, greatest = float(np.min(values)), float(np.max(values))
            yield Extent(stage, column, unit, least, greatest, len(values), *meant)


def _facts(stage: str, result: Any) -> Iterator[Told]:
    """Its facts, each once: of a name that stands in several parts of the summary the last."""
    known, found = described(stage, column=False), dict[str, Told]()
    for name, (value, unit), label in labelled(stage, result):
        meaning, symbol = known(name.rpartition(".")[2], unit)
        found[f"{name}[{unit}]"] = Told(stage, name, value, unit, "", meaning or label, symbol)
    yield from found.values()


def _of_table(stage: str, result: Any, table: Table, name: Name, anew: Anew | None) -> Iterator[Told]:
    """What is asked of every column of numbers that the name may mean."""
    known = described(stage, column=True)
    for at, header in enumerate(table.headers):
        column, unit = named(header)
        if not like(column, name.what) or np.asarray(table.make(at)).dtype.kind not in "fi":
            continue
        own = name._replace(stage=stage, what=column)
        value, told_in, how = _asked(own, result, table, header, anew)
        meaning, symbol = known(column, unit)
        meant = MEANT.get(name.of, name.of)
        meaning = f"{meaning}: {meant}" if meaning and meant else meaning
        if name.unit in (None, told_in):
            yield Told(stage, own.quantity, value, told_in, how, meaning, symbol)


def _asked(name: Name, result: Any, table: Table, header: str, anew: Anew | None) -> tuple[float, str, str]:
    """Value, unit, and how it was found."""
    unit, place = named(header)[1], name.place
    values = table.column(header)
    if name.of == "chosen":
        if name.stage not in ROWS or place is not None:
            rule = "has no rows to choose from" if place is None else "the chosen row is one already"
            raise _misplaced(name, rule, f"chosen() is asked of {' and '.join(ROWS)}, without a place")
        return float(values[result.winner.place if name.stage == "criteria" else 0]), unit, "the chosen row"
    if place is None:
        return _of_rows(name, table, values, unit, _run_of(table))
    if not place.column:
        some = _labelled(name, table.labels, place)
        if not place.last:
            return _of_one(name, float(values[some[0]]), unit, f"row {table.labels[some[0]]}")
        return _of_rows(name, table, values, unit, _run_of(table), some)
    unit_over, x = _over(name, table, place.column)
    low = _inside(name, place.column, place.first, unit_over, x)
    first, how = _at(name, place._replace(last=""), low, table, header, (unit_over, x), anew)
    if not place.last:
        return _of_one(name, first, unit, how)
    high = _inside(name, place.column, place.last, unit_over, x)
    if high <= low:
        rule = f"ends at {high:g} {unit_over}, and begins at {low:g}".replace(" ,", ",")
        raise _misplaced(name, rule, "write the smaller value first; over the end of the rows two names are needed")
    last, _ = _at(name, Place(place.column, place.last), high, table, header, (unit_over, x), anew)
    sense = slice(None) if x[-1] > x[0] else slice(None, None, -1)
    inside = (x > low) & (x < high)
    rows = np.concatenate(([low], x[inside][sense], [high]))
    ends = np.concatenate(([first], values[inside][sense], [last]))
    return _of_rows(name, table, ends, unit, (unit_over, rows))


def _of_one(name: Name, value: float, unit: str, how: str) -> tuple[float, str, str]:
    """What is asked of one row: its value, or nothing else."""
    if name.of in ("", "max", "min", "mean", "first", "last"):
        return value, unit, how
    if name.of in ("size", "rms"):
        return abs(value), unit, how
    raise _misplaced(name, "is asked of one row", "name the rows from one to another, @2..12, or leave the place out")


def _of_rows(
    name: Name, table: Table, values: Values, unit: str, over: tuple[str, Values] | None, some: Any = slice(None)
) -> tuple[float, str, str]:
    """What is asked of rows, and of what they run over (its unit and its values)."""
    own = values[some]
    if name.of in REDUCED:
        return float(REDUCED[name.of](own)), unit, f"of {len(own)} rows"
    if over is None:
        raise _misplaced(name, "has rows that run over nothing", f"{name.of}() needs a column that grows or falls")
    per, x = over[0], over[1][some]
    if name.of == "integral":
        found = integral(np.deg2rad(x) if per == "deg" else x, own, _closes(per, x, own))
        per = "rad" if per == "deg" else per
        return found, per if unit in ("", "-") else f"{unit}*{per}", "cubics through the rows"
    return float(x[int(WHERE[name.of](own))]), per, f"among {len(own)} rows"


def _run_of(table: Table) -> tuple[str, Values] | None:
    """What the rows run over, its unit and values: the first column after the numbers of the rows that runs one way."""
    for header in table.headers:
        if named(header)[0] != "i" and _one_way(values := table.column(header)):
            return named(header)[1], values
    return None


def _one_way(x: Values) -> bool:
    steps = np.diff(x)
    return bool(x[0] != x[-1] and (np.all(steps >= 0) or np.all(steps <= 0)))


def _labelled(name: Name, labels: Sequence[str], place: Place) -> Any:
    """The rows of a label, or from one to another."""
    ends = []
    for label in (place.first, place.last or place.first):
        if label not in labels:
            known = labels if len(labels) <= 12 else [*labels[:6], "...", labels[-1]]
            raise _misplaced(name, f"has no row {label!r}", near(label, known, "its rows are"))
        ends.append(labels.index(label))
    if ends[1] < ends[0]:
        raise _misplaced(name, f"has row {place.last} before row {place.first}", "write the earlier row first")
    return range(ends[0], ends[0] + 1) if not place.last else slice(ends[0], ends[1] + 1)


def _over(name: Name, table: Table, column: str) -> tuple[str, Values]:
    """The column of a place, its unit and values, which has to run one way."""
    found = {named(header)[0]: header for header in table.headers}
    if column not in found:
        raise _misplaced(name, f"stands in no table with a column {column!r}", near(column, found, "columns"))
    values = table.column(found[column])
    if not _one_way(values):
        rule = f"has several places, or none, for a value of {column}: it does not run one way"
        raise _misplaced(name, rule, "name a row, @6, or the value of phi or t")
    return named(found[column])[1], values


def _value(name: Name, written: str, unit: str) -> float:
    """A value in the unit of its column."""
    try:
        return in_unit(written, unit)
    except UnitError as error:
        raise _misplaced(name, f"cannot be found: {error.message}", f"write a number in {unit}") from None


def in_unit(value: float | str, unit: str) -> float:
    """A number, or a text with a unit, in the unit of what it is compared with.

    Raises `UnitError` for a unit of another kind, and for what is no number.

    >>> in_unit("30 mm", "m"), in_unit("45", "deg"), in_unit(2.0, "N")
    (0.03, 45.0, 2.0)
    """
    if not isinstance(value, str):
        return float(value)
    dimension = dimension_of(value)
    if dimension is None:
        try:
            return float(value)
        except ValueError:
            raise UnitError(f"{value!r} is no quantity") from None
    try:
        return in_si(value, dimension) / in_si(f"1 {unit}", dimension)
    except UnitError:
        raise UnitError(f"{value!r} is no number in {unit or 'no unit'}") from None


def _inside(name: Name, column: str, written: str, unit: str, x: Values) -> float:
    """A value of the column that rows run over, within these; of a turn it may be given in another one."""
    at, span = _value(name, written, unit), float(np.ptp(x))
    low, high = float(np.min(x)), float(np.max(x))
    if _turn(unit, x) and not low <= at <= high:
        at = low + (at - low) % 360
    if not low - SAME * span <= at <= high + SAME * span:
        rule = f"has no row about {column} = {written}"
        raise _misplaced(name, rule, f"its rows are from {low:g} to {high:g} {unit}".rstrip())
    return at


def _at(
    name: Name, place: Place, at: float, table: Table, header: str, over: tuple[str, Values], anew: Anew | None
) -> tuple[float, str]:
    """The value of a column at a place, in the unit of the column that rows run over, and how it was found."""
    unit, x = over
    values = table.column(header)
    nearest = np.flatnonzero(np.abs(x - at) <= SAME * np.ptp(x))
    if nearest.size:
        side = ", after the jump" if nearest.size > 1 else ""
        return float(values[nearest[-1]]), f"row {table.labels[nearest[-1]]}{side}"
    there = anew.table(name.stage, place) if anew else None
    if there is not None:
        own = there.column(next(each for each in there.headers if named(each)[0] == place.column))
        return float(there.column(header)[int(np.argmin(np.abs(own - at)))]), "computed there"
    value, off = between(x, values, at, _closes(unit, x, values))
    return value, f"cubic through the rows, off by about {off:.1e}"


def _closes(unit: str, x: Values, values: Values) -> bool:
    """Whether rows go around a turn that closes."""
    ends = abs(values[-1] - values[0]) <= CLOSED * float(np.max(np.abs(values)))
    return bool(ends and _turn(unit, x))


def _turn(unit: str, x: Values) -> bool:
    """Whether rows go around one turn."""
    return unit == "deg" and abs(float(np.ptp(x)) - 360) <= SAME * 360


def _misplaced(name: Name, rule: str, remedy: str) -> UsageError:
    return UsageError(f"{name.text} {rule}", remedy=remedy)
