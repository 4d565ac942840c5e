"""What a page tells of a run: its stages with facts and columns, warnings and errors, and the given data."""

from __future__ import annotations

import math
import re
from collections.abc import Container, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.errors import TmmError
from tmmcalc.core.facts import Labelled, labelled, named
from tmmcalc.core.notes import Phrase, graded
from tmmcalc.core.stage import STAGES
from tmmcalc.naming.meanings import described
from tmmcalc.naming.table import Values, table_of
from tmmcalc.naming.told import Extent, listed, meant
from tmmcalc.note.assembled import inline
from tmmcalc.note.tree import plain_text
from tmmcalc.page.lists import ENGLISH, tables, worded
from tmmcalc.page.packing import Block, Content
from tmmcalc.page.said import alike, each_said, name_of, unit_of
from tmmcalc.page.stacked import courses
from tmmcalc.pipeline.chapters import given_in, warnings_of
from tmmcalc.report.manuscript import Datum

if TYPE_CHECKING:
    from tmmcalc.pipeline.outcome import RunResult

WITHIN = re.compile(r"\[([^\]]+)\]\.")  # a unit of several values, which stands in the names of all
ROWS = 1001  # of a longer table so many are shown, and those of extremes

Indices = NDArray[np.intp]


def stages_told(
    name: str,
    run: RunResult,
    given: Container[str],
    dense: Mapping[str, Any],
    inputs: Container[tuple[str, str]],
    block: Block,
) -> Iterator[Content]:
    """A stage: facts of the run, columns over many positions where it has them, warnings, errors; then its courses.

    Its rows go along one of the ``inputs`` of views, each a room and a column, where they have it; ``given`` are the
    texts of the spec.
    """
    stage, result = STAGES[name], run.results[name]
    facts = {f"{each.name}[{each.unit}]": _fact(name, each) for each in labelled(name, result) if _told(each, given)}
    errors = {key: each for key, each in run.outcomes[name].record.error.items() if isinstance(each, float) and each}
    yield {
        **_nothing(name, stage.title),
        "facts": [*facts.values()],
        "tables": [*tables(stage.summary(result, ""), given)],
        **_table(name, dense.get(name, result), inputs, block),
        "warnings": [name_of(graded(each)[1]) for each in warnings_of(run, [name])],
        "errors": [[worded(name_of(key)), float(f"{each:.3g}")] for key, each in errors.items()],
    }
    yield from _courses(name, dense.get(name, result), inputs, block)


def failure_told(name: str, error: TmmError) -> Content:
    """A stage that has no result: why, as commands say it, for its keys and values are typed into the spec."""
    return {**_nothing(name, STAGES[name].title), "warnings": [str(error)]}


def _nothing(name: str, title: str) -> Content:
    """A stage of which nothing is told."""
    told: Content = {"name": name, "room": STAGES[name.partition("/")[0]].room, "title": name_of(title)}
    return {**told, "facts": [], "tables": [], "rows": None, "columns": [], "warnings": [], "errors": []}


def _told(fact: Labelled, given: Container[str]) -> bool:
    """Whether a page tells it: a number; a word that is said in all languages, or that the spec gives."""
    if not isinstance(fact.value, str):
        return math.isfinite(fact.value)
    said = name_of(fact.value)
    return bool(fact.value) and (isinstance(said, list) or not ENGLISH.search(fact.value) or fact.value in given)


def _fact(stage: str, fact: Labelled) -> Content:
    """A fact; a truth value stays one, a word is said in all languages."""
    meaning, _ = meant(stage, fact)
    if fact.part:
        meaning = Phrase("{quantity}: {word}", quantity=fact.part, word=meaning)
    return {
        "name": fact.name,
        "meaning": name_of(meaning),
        "value": name_of(fact.value) if isinstance(fact.value, str) else fact.value,
        "unit": unit_of(fact.unit or (WITHIN.findall(fact.name) or [""])[0]),
    }


def _table(name: str, result: Any, inputs: Container[tuple[str, str]], block: Block) -> Content:
    """The columns of numbers, and the first of them that its rows go along; without one they are counted."""
    table = None if courses(name, result) else table_of(name, result)
    known = {each.quantity: each for each in listed(name, result) if isinstance(each, Extent)}
    headers = [header for header in table.headers if named(header)[0] in known] if table is not None else []
    if table is None or not headers or len(table.first) < 2:
        return {"rows": None, "columns": []}
    along = next((header for header in headers if (STAGES[name].room, header) in inputs), headers[0])
    others = [header for header in headers if header != along]
    values = table.column(along)
    if not _ordered(values):
        along, others, values = "", headers, np.arange(1.0, len(table.first) + 1)
    columns = {header: table.column(header) for header in others}
    meanings = {header: known[named(header)[0]].meaning for header in others}
    return _laid(along, values, columns, meanings, block, moved=(STAGES[name].room, along) in inputs)


def _courses(name: str, result: Any, inputs: Container[tuple[str, str]], block: Block) -> Iterator[Content]:
    """Courses that stand below one another in the table of a stage, each as a stage of its own without facts.

    Each is called by its label, so that one is never taken for another that stands in its place in a variant. They go
    along the input of a view, along what the stage says, or along the time or the first column that goes one way.
    """
    stage, meaning = STAGES[name], described(name, column=True)
    for course in courses(name, result):
        ordered = [header for header, each in course.columns.items() if _ordered(each)]
        first = [
            header for header in ordered if (stage.room, header) in inputs or named(header)[0] == (course.along or "t")
        ]
        along = next(iter([*first, *(() if course.along else ordered)]), "")
        columns = {header: each for header, each in course.columns.items() if header != along}
        values = course.columns.get(along, np.arange(1.0, len(next(iter(course.columns.values()), ())) + 1))
        meanings = {header: _of_course(course.meaning, meaning(*named(header))[0]) for header in columns}
        told = _nothing(f"{name}/{course.label}", _of_course(stage.title, course.meaning))
        moved = (stage.room, along) in inputs
        yield {**told, **_laid(along, values, columns, meanings, block, moved=moved)}


def _of_course(what: str, word: str) -> str:
    return Phrase("{quantity}: {word}", quantity=what, word=word) if word else what


def _laid(
    along: str, values: Values, columns: Mapping[str, Values], meanings: Mapping[str, str], block: Block, *, moved: bool
) -> Content:
    """Columns by their headers over the values of another one, or over the numbers of the rows.

    Where a view has ``moved`` along them all rows are shown: its arrows stand beside their values.
    """
    row, unit = named(along) if along else ("", "")
    kept = np.arange(len(values)) if moved else _kept(values, [*columns.values()], along != "")
    rows = {"header": along, "name": row, "unit": unit_of(unit), "values": block.put(values[kept])}
    return {
        "rows": {**rows, "kept": len(kept), "of": len(values)},
        "columns": [_column(header, meanings[header], each[kept], block) for header, each in columns.items()],
    }


def _kept(values: Values, columns: Sequence[Values], ordered: bool) -> Indices:
    """Of many rows those that are shown: of a list the first, along a column equal steps with ends and extremes."""
    count = len(values)
    if count <= ROWS:
        return np.arange(count)
    if not ordered:
        return np.arange(ROWS)
    peaks = [k for each in columns if np.isfinite(each).any() for k in (np.nanargmin(each), np.nanargmax(each))]
    return np.unique([*np.linspace(0, count - 1, ROWS).round().astype(int), *peaks])


def _ordered(values: Values) -> bool:
    """Whether rows go along a column, one way."""
    steps = np.diff(values)
    return bool(values[0] != values[-1] and ((steps >= 0).all() or (steps <= 0).all()))


def _column(header: str, meaning: str, values: Values, block: Block) -> Content:
    name, unit = named(header)
    return {"name": name, "unit": unit_of(unit), "meaning": name_of(meaning), "values": block.put(values)}


def given_told(run: RunResult) -> list[Content]:
    """The given data, in the words of the note."""
    spoken = each_said(lambda: [block for block in given_in(run.spec, run.results) if isinstance(block, Datum)])
    return [
        {
            "what": alike([plain_text(inline(each.what)) for each in same]),
            "keys": same[0].keys,
            "values": same[0].values,
            "unit": unit_of(same[0].unit),
            "text": alike([plain_text(inline(each.text)) for each in same]),
        }
        for same in zip(*spoken, strict=True)
    ]
