"""The key of a variant: what is right of each asked result, and what comes out with each known mistake."""

from __future__ import annotations

import math
from collections.abc import Container, Iterator, Mapping, Sequence
from functools import partial
from typing import Any

from tmmcalc.classroom.bench import Bench
from tmmcalc.classroom.known import known
from tmmcalc.classroom.model import Item, Key, Told, Values
from tmmcalc.classroom.rounding import Floors, settled
from tmmcalc.classroom.verdicts import is_within
from tmmcalc.core.errors import TmmError, UsageError
from tmmcalc.core.mistake import SELDOM, Asked, Mistake
from tmmcalc.core.notes import Phrase
from tmmcalc.core.plan import plan
from tmmcalc.naming.language import Name, parse
from tmmcalc.naming.scene import Scene
from tmmcalc.naming.told import one, told
from tmmcalc.pipeline.settling import outlook
from tmmcalc.project import Spec
from tmmcalc.project.loader import with_tables
from tmmcalc.rooms import STAGES
from tmmcalc.spec.units import conversion

SAME = 1e-9  # relative difference below which nothing has changed
NOTHING = 1e-13  # value that stands for zero in the units of results
BETWEEN = ":"  # name of a mistake and of the part in which it is made


def mistakes_of(spec: Spec) -> tuple[Told, ...]:
    """The mistakes that can be made in a scene, the commoner ones first."""
    running = plan(outlook(spec, None, STAGES), None, STAGES).running
    return tuple(
        told_of(f"{name}{BETWEEN}{part}" if part else name)
        for name, mistake in known().items()
        for part in _parts(mistake, spec, running)
    )


def told_of(name: str) -> Told:
    """How a mistake of this name is told; raises `UsageError` if there is none."""
    mistake, part = _named(name)
    title = Phrase("{mistake}: {part}", mistake=mistake.title, part=part) if part else mistake.title
    return Told(name, title, mistake.hint, mistake.single, 2.0 ** (SELDOM - mistake.common))


def key_of(number: int, student: str, spec: Spec, items: Sequence[Item], mistakes: Sequence[Told]) -> Key:
    """The key of a variant; values of mistakes are NaN where nothing changes or nothing comes out.

    Raises what a stage of the right solution raises, `UsageError` for an item that the scene does not tell.
    """
    desk = Desk(spec, items)
    return Key(number, student, desk.values, tuple(desk.mistaken(each.name) for each in mistakes))


class Desk:
    """A variant on which mistakes are made one after the other.

    Raises what a stage of the right solution raises, `UsageError` for an item that the scene does not tell.
    """

    def __init__(self, spec: Spec, items: Sequence[Item]) -> None:
        self._items = items
        self._names = [parse(item.result) for item in items]
        self._bench = Bench(spec, tuple(dict.fromkeys(name.stage for name in self._names)))
        self._scene = self._bench.scene()
        right = [one(name, self._scene.results, self._scene) for name in self._names]
        self._told_alone = {name for name in self._names if _is_told_alone(name, self._scene.results)}
        self._meanings = [each.meaning for each in right]
        self._factors = [_factor(each.unit, item) for each, item in zip(right, items, strict=True)]
        floors = Floors(self._scene.results)
        pairs = [*zip(right, self._factors, strict=True)]
        self.values: Values = tuple(factor * floors.settled(each) for each, factor in pairs)
        self._floors = [abs(factor) * floors.of(each) for each, factor in pairs]

    def mistaken(self, name: str, wanted: Container[int] | None = None) -> Values:
        """What of the items comes out with a mistake (I,), NaN of those whose places are not ``wanted`` (None: all)."""
        mistake, part = _named(name)
        places = [at for at in range(len(self._items)) if wanted is None or at in wanted]
        values = [math.nan] * len(self._items)
        if not places:
            return tuple(values)
        found = self._read(mistake) if mistake.reads is not None else self._solved(mistake, part, places)
        for at in places:
            wrong = settled(found[at], self._floors[at])
            if math.isfinite(wrong) and not _same(wrong, self.values[at], self._items[at]):
                values[at] = wrong
        return tuple(values)

    def hidden(self, values: Values) -> tuple[int, ...]:
        """The places of items that are wrong with a mistake but within tolerance of the right ones."""
        return _hidden(values, self.values, self._items)

    def _solved(self, mistake: Mistake, part: str, places: Sequence[int]) -> Values:
        """The values of the items at some places; of what they do not need nothing is solved."""
        none = (math.nan,) * len(self._items)
        names = [self._names[at] for at in places]
        try:
            spec, amiss = self._bench.spec, mistake.stages
            if mistake.tables is not None:
                tables = mistake.tables(_document(spec), part)
                if not tables:
                    return none
                spec = with_tables(spec, tables)
            else:
                if not mistake.applies(spec):
                    return none
                amiss = {stage: partial(wrong, part=part) for stage, wrong in amiss.items()} if part else amiss
            scene = self._bench.scene(spec, amiss, tuple(dict.fromkeys(name.stage for name in names)))
        except TmmError:
            return none
        if self._bench.unchanged(scene):
            return none
        found = self._told(scene, names)
        return tuple(by * found.get(name.text, math.nan) for name, by in zip(self._names, self._factors, strict=True))

    def _read(self, mistake: Mistake) -> Values:
        every = zip(self._items, self._meanings, self.values, self._factors, strict=True)
        return tuple(_read(mistake, self._asked(item, meaning, value, by)) for item, meaning, value, by in every)

    def _asked(self, item: Item, meaning: str, value: float, factor: float) -> Asked:
        another = partial(self._another, factor)
        return Asked(item.result, item.unit, meaning, value, factor, another, self._bench.spec)

    def _another(self, factor: float, name: str) -> float:
        try:
            return factor * one(parse(name), self._scene.results, self._scene).value
        except TmmError:
            return math.nan

    def _told(self, scene: Scene, wanted: Sequence[Name]) -> dict[str, float]:
        """Values of the items that a scene tells, in the units of results, by their names.

        Those are left out that a stage tells alone whose result is the right one.
        """
        right = self._scene.results
        names = [
            name
            for name in wanted
            if name.stage in scene.results
            and not (name in self._told_alone and scene.results[name.stage] is right[name.stage])
        ]
        stages = tuple(dict.fromkeys(name.stage for name in names))
        try:
            return {f"{each.stage}.{each.quantity}": each.value for each in told(scene.results, names, scene, stages)}
        except Exception:  # one by one those are found that a mistake has not broken
            return {name.text: value for name in names if (value := _one(name, scene)) is not None}


def classes_of(key: Key, items: Sequence[Item], mistakes: Sequence[Told]) -> tuple[tuple[int, ...], ...]:
    """Mistakes by place that no answer can tell apart: their values agree within tolerance in all items.

    Those of a class stand in the order of the key, the commoner ones first; one that changes nothing is in none. A
    mistake in one answer looks like another one, never like one in a whole solution.
    """
    found: list[list[int]] = []
    for at, values in enumerate(key.mistaken):
        if not any(map(math.isfinite, values)):
            continue
        for other in found:
            alike = mistakes[at].single == mistakes[other[0]].single
            if alike and _agree(values, key.mistaken[other[0]], key, items):
                other.append(at)
                break
        else:
            found.append([at])
    return tuple(map(tuple, found))


def clashes(key: Key, items: Sequence[Item]) -> tuple[tuple[int, int], ...]:
    """Mistakes and items by place, where a mistake changes the value but stays within tolerance of the right one."""
    return tuple((at, k) for at, values in enumerate(key.mistaken) for k in _hidden(values, key.values, items))


def _hidden(values: Values, right: Values, items: Sequence[Item]) -> tuple[int, ...]:
    """Places where a mistake changes the value but stays within tolerance of the right one."""
    every = enumerate(zip(values, right, items, strict=True))
    return tuple(
        at for at, (wrong, own, item) in every if math.isfinite(wrong) and is_within(wrong, own, item, item.tolerance)
    )


def _agree(one: Values, other: Values, key: Key, items: Sequence[Item]) -> bool:
    """Whether two mistakes give the same answers; what one does not change is right."""
    for a, b, right, item in zip(one, other, key.values, items, strict=True):
        first, second = (right if math.isnan(each) else each for each in (a, b))
        if abs(first - second) > max(item.tolerance * max(abs(first), abs(second)), item.within):
            return False
    return True


def _parts(mistake: Mistake, spec: Spec, running: Sequence[str]) -> Iterator[str]:
    """In what of a scene a mistake can be made: the empty word stands for the whole; nothing where it cannot."""
    if mistake.reads is not None:
        yield ""
        return
    if mistake.stages and (mistake.stages.keys().isdisjoint(running) or not mistake.applies(spec)):
        return
    for part in mistake.parts(spec):
        if mistake.tables is None or mistake.tables(_document(spec), part):
            yield part


def _named(name: str) -> tuple[Mistake, str]:
    own, _, part = name.partition(BETWEEN)
    if own not in known():
        raise UsageError(f"no mistake is called {own!r}", remedy="make the keys again with this version")
    return known()[own], part


def _document(spec: Spec) -> Mapping[str, Any]:
    written = spec._written
    if written is None:
        raise UsageError("the spec was not read from a text", remedy="take load_spec or parse_spec")
    return written.document


def _read(mistake: Mistake, asked: Asked) -> float:
    assert mistake.reads is not None
    try:
        return mistake.reads(asked)
    except (ArithmeticError, TmmError):
        return math.nan


def _is_told_alone(name: Name, results: Mapping[str, Any]) -> bool:
    """Whether a result tells what is asked for by itself: it stands in no column by choice, and at no place of one."""
    if name.place is not None and name.place.column:
        return False
    try:
        return any(told(results, [name], None, [name.stage]))
    except TmmError:
        return False


def _one(name: Name, scene: Scene) -> float | None:
    try:
        return one(name, scene.results, scene).value
    except Exception:  # a column by choice may stand on what the mistake has broken
        return None


def _factor(unit: str, item: Item) -> float:
    """What a value in the unit of the result is multiplied by for that of the item."""
    if unit == item.unit:
        return 1.0
    try:
        return conversion(unit, item.unit)
    except (KeyError, ValueError):
        raise UsageError(
            f"{item.result} is in {unit or 'no unit'} and cannot be asked in {item.unit or 'none'}",
            where=f"[[class.asked]] {item.name}",
            remedy="ask in a unit of the same kind",
        ) from None


def _same(wrong: float, right: float, item: Item) -> bool:
    allowed = max(SAME * max(abs(wrong), abs(right)), NOTHING)
    return abs(wrong - right) <= allowed or (item.either_sense and abs(wrong + right) <= allowed)
