"""What stages tell by name: facts, what names ask of the columns of tables; and where none fits, what is by choice."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import cache, lru_cache
from math import isnan, nan
from typing import Any

import numpy as np

from tmmcalc.core.errors import UsageError
from tmmcalc.core.facts import Labelled, labelled, named
from tmmcalc.core.notes import Phrase
from tmmcalc.core.records import record
from tmmcalc.core.stage import STAGES
from tmmcalc.naming.choice import Chosen, chosen_facts, error_meaning, forms_of_details, of_itself
from tmmcalc.naming.language import ANY, Name, Place, like, near
from tmmcalc.naming.meanings import EXTREME, described
from tmmcalc.naming.rows import There, asked_of
from tmmcalc.naming.scene import Scene
from tmmcalc.naming.table import Table, columns_of, table_of

MEANT = {  # what functions of names ask for in words; the others say it themselves
    "at_max": "where it is largest",
    "at_min": "where it is smallest",
    "at_size": "where its magnitude is largest",
    "range": "greatest value less the least",
    "size": "largest magnitude",
    "first": "value at the beginning",
    "last": "value at the end",
    "chosen": "of what is chosen",
}
CHOICE = "by choice"
EXTREMES = {
    "min": "{quantity}: least value",
    "max": "{quantity}: greatest value",
    "rms": "{quantity}: root mean square",
    "start": "{quantity}: value at the beginning",
    "end": "{quantity}: value at the end",
}
PLACES = {"min": "{quantity}: {place} at the least value", "max": "{quantity}: {place} at the greatest value"}


@record
class Told:
    """One quantity of a stage."""

    stage: str
    quantity: str  # its name without stage and unit
    value: float  # NaN where it has none
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
    """One column of a stage's table, or by choice; without rows it was not made, or has no value in any."""

    stage: str
    quantity: str  # its name without stage and unit
    unit: str
    least: float
    greatest: float
    rows: int
    meaning: str = ""
    symbol: str = ""
    choice: bool = False


def told(
    results: Mapping[str, Any],
    names: Sequence[Name],
    scene: Scene | None = None,
    stages: Sequence[str] | None = None,
) -> Iterator[Told]:
    """What stages (None: all) tell under these names, all their facts without names; each once, by stage.

    A name that fits no fact and no column of a table stands for what is by choice; without the ``scene`` for nothing.
    Raises `UsageError` for a place that the rows do not have.
    """
    asked = [*results] if stages is None else [stage for stage in stages if stage in results]
    met: dict[str, dict[str, Told]] = {stage: {} for stage in asked}
    missed = dict.fromkeys(names)
    for stage in asked:
        for name, each in _ordinary(stage, results[stage], names, scene):
            met[stage].setdefault(each.key, each)
            if name is not None:
                missed.pop(name, None)
    if missed and scene is not None:
        for stage in asked:
            for each in _by_choice(stage, [*missed], scene):
                met[stage].setdefault(each.key, each)
    for found in met.values():
        yield from found.values()


def one(name: Name, results: Mapping[str, Any], scene: Scene | None = None) -> Told:
    """The one quantity of a name among the results by stage.

    Raises `UsageError` with the nearest names if none has it, with the stages if several have it, and where it has no
    value.
    """
    if name.stage and not name.wild and name.stage not in results:
        raise _absent(name.stage)
    if name.wild:
        raise UsageError(f"{name.text} may name several quantities", remedy="write one name, without * and ?")
    stages = [name.stage] if name.stage else [*results]
    found = [*told(results, [name], scene, stages)]
    if not found:
        raise unknown(name, {stage: results[stage] for stage in stages}, scene)
    if len(found) > 1:
        several = ", ".join(each.stage for each in found)
        raise UsageError(
            f"{name.text} is told by several stages: {several}",
            remedy=f"name one: {', '.join(f'{each.stage}.{each.quantity}' for each in found)}",
        )
    if isnan(found[0].value):
        raise UsageError(f"{name.text} has no value here: {found[0].how}", remedy="ask for another place or column")
    return found[0]


def unknown(name: Name, results: Mapping[str, Any], scene: Scene | None = None) -> UsageError:
    """The error of a name that names nothing in these results, with the nearest of what there is."""
    if name.stage in STAGES and name.stage not in results:
        return _absent(name.stage)
    alone = name.stage if name.stage in results else ""
    results = {alone: results[alone]} if alone else results
    columns = [header for stage, result in results.items() for header in columns_of(stage, result)]
    if scene is not None:
        columns += [f"{stage}.{each.name}" for stage in results for each in scene.further(stage)]
    if name.fact:
        every = [f"{stage}.{each.quantity}" for stage, result in results.items() for each in _facts(stage, result)]
        if scene is not None:
            every += [f"{stage}.{each.name}" for stage in results for each in chosen_facts(stage, scene)]
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


def _absent(stage: str) -> UsageError:
    return UsageError(f"this scene has no {stage}", remedy="tmmcalc plan says why a stage is left out")


def listed(stage: str, result: Any) -> Iterator[Told | Extent]:
    """All that a stage tells: its facts, then its columns."""
    yield from _facts(stage, result)
    table, known = table_of(stage, result), _of_columns(stage, result, facts=True)
    for at, header in enumerate(table.headers if table else ()):
        if table is not None and np.asarray(table.make(at)).dtype.kind in "fi":
            (column, unit), values = named(header), table.column(header)
            least, greatest = float(np.min(values)), float(np.max(values))
            yield Extent(stage, column, unit, least, greatest, len(values), *known(column, unit))


def _of_columns(stage: str, result: Any, *, facts: bool = False) -> Callable[[str, str], tuple[str, str]]:
    """A function of the name and the unit of a column: meaning and symbol, as the result itself or its stage says.

    With ``facts`` else what the fact of its name means: that of one row, as of a solution the first. Facts are loaded
    for it, which a run that asks for values alone does without.
    """
    known = described(stage, column=True)

    @cache
    def declared() -> Mapping[str, tuple[str, str]]:
        made = STAGES[stage].part("columns")
        own = made(result) if made else ()
        return {} if isinstance(own, Mapping) else {each.name: (each.meaning, each.symbol) for each in own}

    @cache
    def of_facts() -> Mapping[tuple[str, str], tuple[str, str]]:
        return {(each.name, each.unit): meant(stage, each) for each in labelled(stage, result)}

    def found(name: str, unit: str) -> tuple[str, str]:
        own = declared().get(name, ("", ""))
        own = own if own[0] else known(name, unit)
        return own if own[0] or not facts else of_facts().get((name, "" if unit == "-" else unit), ("", ""))

    return found


def offered(stage: str, scene: Scene) -> Iterator[Told | Extent]:
    """All that a stage tells by choice; no detail is computed, no column made."""
    for each in (*forms_of_details(stage, scene), *of_itself(stage, scene.results[stage])):
        yield _chosen(stage, each)
    for column in scene.further(stage):
        yield Extent(stage, column.name, column.unit, nan, nan, 0, column.meaning, column.symbol, choice=True)


def chosen(stage: str, names: Sequence[Name], scene: Scene) -> Iterator[Told | Extent]:
    """Facts and columns by choice under names without a function and a place."""
    named_here = [name for name in names if name.fact and name.may_be_of(stage)]
    for fact in _chosen_facts(stage, named_here, scene):
        yield _chosen(stage, fact)
    for column in scene.further(stage):
        if any(name.fits(Name(stage, "", column.name, unit=column.unit)) for name in named_here):
            values = np.asarray(column.make(), float)
            values = values[~np.isnan(values)]
            ends = (float(np.min(values)), float(np.max(values))) if values.size else (nan, nan)
            yield Extent(
                stage, column.name, column.unit, *ends, len(values), column.meaning, column.symbol, choice=True
            )


def _chosen_facts(stage: str, names: Sequence[Name], scene: Scene) -> Iterator[Chosen]:
    """The facts by choice that names stand for; without names none are computed."""
    for each in chosen_facts(stage, scene) if names else ():
        if any(name.fits(Name(stage, "", each.name, unit=each.unit)) for name in names):
            yield each


def _chosen(stage: str, each: Chosen) -> Told:
    return Told(stage, each.name, each.value, each.unit, CHOICE, each.meaning, each.symbol)


def _facts(stage: str, result: Any, names: tuple[Name, ...] | None = None) -> Iterator[Told]:
    """Its facts under these names (None: all), each once: of one in several parts of the summary the last."""
    found = dict[str, Told]()
    for each in labelled(stage, result):
        if isinstance(each.value, str) or (names is not None and not _fitting(names, stage, each.name, each.unit)):
            continue
        told = meant(stage, each)
        found[f"{each.name}[{each.unit}]"] = Told(stage, each.name, float(each.value), each.unit, "", *told)
    yield from found.values()


@lru_cache(maxsize=4096)  # a sweep has the same names and the same facts at every point
def _fitting(names: tuple[Name, ...], stage: str, fact: str, unit: str) -> tuple[Name, ...]:
    """Those of the names that a fact has."""
    own = Name(stage, "", fact, unit=unit)
    return tuple(name for name in names if name.fits(own))


def meant(stage: str, fact: Labelled) -> tuple[str, str]:
    """Meaning and symbol of a fact: as it is declared, else of what it is an extreme or a place, else by its label."""
    if meaning := error_meaning(fact.name):
        return meaning, ""
    name, unit = fact.own, fact.unit
    known = described(stage, column=False)
    meaning, symbol = known(name, unit)
    if not meaning:
        meaning = _of_place(stage, name) or _of_extreme(stage, name, unit)
    if fact.within and meaning != fact.label:
        label = fact.label
        if fact.apart:
            label = Phrase(
                "{quantity}, {word}", quantity=label, word=fact.within.rpartition(".")[2].removesuffix("_peak")
            )
        return Phrase("{quantity}: {word}", quantity=label, word=meaning or name), symbol
    if not meaning and (found := EXTREME.fullmatch(name)):
        return _extreme(fact.label, found, stage, unit), symbol
    return meaning or fact.label, symbol


def _of_extreme(stage: str, name: str, unit: str) -> str:
    """An extreme of a quantity that is declared, or its place, as R_A_max, R_A_max_at_phi; empty for others."""
    found = EXTREME.fullmatch(name)
    meaning = found and (
        described(stage, column=True)(found[1], ANY)[0] or described(stage, column=False)(found[1], ANY)[0]
    )
    return _extreme(meaning, found, stage, unit) if found and meaning else ""


def _extreme(quantity: str, found: re.Match[str], stage: str, unit: str) -> str:
    if not found[3]:
        return Phrase(EXTREMES[found[2]], quantity=quantity)
    return Phrase(
        PLACES[found[2]], quantity=quantity, place=_place(stage, found[4] or ("phi" if unit == "deg" else "t"))
    )


def _of_place(stage: str, name: str) -> str:
    """Of a place by what stands there: amplification_max_at_phi."""
    of, at, along = name.rpartition("_at_")
    meaning = described(stage, column=False)(of, ANY)[0] if at else ""
    return Phrase("{quantity}: {place} there", quantity=meaning, place=_place(stage, along)) if meaning else ""


def _place(stage: str, along: str) -> str:
    """What a place is counted by in words: the meaning of the column."""
    return described(stage, column=True)(along, ANY)[0] or along


def _ordinary(
    stage: str, result: Any, names: Sequence[Name], scene: Scene | None
) -> Iterator[tuple[Name | None, Told]]:
    """Facts and what is asked of columns of the table, each with the name that it was asked for by."""
    facts = tuple(name for name in names if name.fact and name.may_be_of(stage))
    if not names:
        yield from ((None, each) for each in _facts(stage, result))
    elif facts:
        for each in _facts(stage, result, facts):
            yield from ((name, each) for name in _fitting(facts, stage, each.quantity, each.unit))
    rows = [name for name in names if not name.fact and name.may_be_of(stage)]
    if rows and (table := table_of(stage, result)) is not None:
        known = _of_columns(stage, result)

        def there(place: Place) -> Table | None:
            beside = None if scene is None else scene.beside(stage, place)
            return None if beside is None else table_of(stage, beside.results[stage])

        for name in rows:
            for at, header in enumerate(table.headers):
                if like(named(header)[0], name.what) and np.asarray(table.make(at)).dtype.kind in "fi":
                    for each in _of_column(stage, result, table, header, name, there, known(*named(header))):
                        yield name, each


def _by_choice(stage: str, names: Sequence[Name], scene: Scene) -> Iterator[Told]:
    """Facts by choice, and what is asked of columns by choice."""
    for fact in _chosen_facts(stage, [name for name in names if name.fact and name.may_be_of(stage)], scene):
        yield _chosen(stage, fact)
    rows = [name for name in names if not name.fact and name.may_be_of(stage)]
    further = scene.further(stage) if rows else ()
    wanted = [(name, column) for name in rows for column in further if like(column.name, name.what)]
    table = scene.table(stage) if wanted else None

    def there(place: Place) -> Table | None:
        beside = scene.beside(stage, place)
        return None if beside is None else beside.table(stage)

    for name, column in wanted:
        if table is not None:
            meant = column.meaning, column.symbol
            yield from _of_column(stage, scene.results[stage], table, column.header, name, there, meant)


def _of_column(
    stage: str, result: Any, table: Table, header: str, name: Name, there: There, meant: tuple[str, str]
) -> Iterator[Told]:
    """What a name asks of a column, unless it asks for another unit."""
    own = name._replace(stage=stage, what=named(header)[0])
    value, told_in, how = asked_of(own, result, table, header, there)
    meaning, symbol = meant
    asked = MEANT.get(name.of, name.of)
    meaning = Phrase("{quantity}: {word}", quantity=meaning, word=asked) if meaning and asked else meaning
    if name.unit in (None, told_in):
        yield Told(stage, own.quantity, value, told_in, how, meaning, symbol)
