"""What stands on a page: stages with their facts and columns, given data, what moves; as plain values for JSON."""

from __future__ import annotations

import math
import re
import tomllib
from collections.abc import Callable, Container, Iterable, Iterator, Mapping, Sequence
from importlib import import_module
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.errors import TmmError, UsageError
from tmmcalc.core.facts import Labelled, labelled, named
from tmmcalc.core.notes import Phrase, graded
from tmmcalc.core.stage import STAGES, arguments, of_scene
from tmmcalc.naming.meanings import described
from tmmcalc.naming.table import Values, table_of
from tmmcalc.naming.told import Extent, listed, meant
from tmmcalc.note.assembled import inline
from tmmcalc.note.tree import plain_text
from tmmcalc.page.lists import ENGLISH, tables, worded
from tmmcalc.page.packing import ERROR, Block
from tmmcalc.page.said import Said, alike, name_of, unit_of, words
from tmmcalc.page.stacked import courses
from tmmcalc.pipeline.chapters import task_of, warnings_of
from tmmcalc.pipeline.picturing import order_of
from tmmcalc.report.exploring import Trial
from tmmcalc.report.formula.symbols import GREEK
from tmmcalc.report.language import LANGUAGES, speaking
from tmmcalc.report.manuscript import Datum
from tmmcalc.report.moving import Body, Mark, Plan, Track, View

if TYPE_CHECKING:
    from tmmcalc.pipeline.outcome import RunResult
    from tmmcalc.report.drawing.order import Order

POSITIONS = 360  # that a page solves of its own
WITHIN = re.compile(r"\[([^\]]+)\]\.")  # a unit of several values, which stands in the names of all
PLANNED = 3  # variants at most, that have plans of vectors: a page of more would be too large
ROWS = 1001  # of a longer table so many are shown, and those of extremes

Indices = NDArray[np.intp]
Content = dict[str, Any]


class Variant(NamedTuple):
    """A run, what tells it from the others on the page, and the text of its spec."""

    name: Said
    run: RunResult
    source: str


def content(variants: Sequence[Variant], title: str, key: str, language: str, positions: int = POSITIONS) -> Content:
    """All that a page holds; ``key`` is what the variants differ in. Of many plans of vectors are left out."""
    block = Block()
    scenes = [_scene(each, block, positions, planned=len(variants) <= PLANNED) for each in variants]
    found = {
        "title": title,
        "key": key,
        "languages": dict(LANGUAGES),
        "language": language,
        "words": words(),
        "letters": GREEK,
        "error": ERROR,
        "scenes": scenes,
    }
    return {**found, "block": block.text()}


def _scene(variant: Variant, block: Block, positions: int, *, planned: bool) -> Content:
    run, given = variant.run, {*_strings(tomllib.loads(variant.source))}
    dense = _dense(run, positions)
    views = [*_views(run, dense, block, planned=planned)]
    inputs = {(view["room"], view["column"]) for view in views}
    return {
        "name": variant.name,
        "stages": [
            each
            for stage in run.outcomes
            for each in (
                _stage(stage, run, given, dense, inputs, block),
                *_courses(stage, dense.get(stage, run.results[stage]), inputs, block),
            )
        ]
        + [_failed(stage, error) for stage, error in run.failures.items()],
        "given": _given(run),
        "source": variant.source,
        "views": views,
        "trials": [*_trials(run, block)],
    }


def _dense(run: RunResult, positions: int) -> Content:
    """Results over many equal steps, of the stages whose rows are places that can be asked for."""
    results: dict[str, Any] = dict(run.results)
    found: dict[str, Any] = {}
    for name, own in of_scene({name: STAGES[name] for name in run.outcomes}, run.spec).items():
        make = own.part("dense")
        if make is None or own.unwanted(run.spec) is not None:
            continue
        try:
            spec = make(run.spec, positions)
        except UsageError:
            continue  # there is no mechanism: a diagram stands in its place
        results[name] = found[name] = own.solve(*arguments(own.inputs(spec)), **own.given(results), **own.settings)
    return found


def _stage(
    name: str,
    run: RunResult,
    given: Container[str],
    dense: Mapping[str, Any],
    inputs: Container[tuple[str, str]],
    block: Block,
) -> Content:
    """A stage: facts of the run, columns over many positions where it has them, warnings, errors.

    Its rows go along one of the ``inputs`` of views, each a room and a column, where they have it; ``given`` are the
    texts of the spec.
    """
    stage, result = STAGES[name], run.results[name]
    facts = {f"{each.name}[{each.unit}]": _fact(name, each) for each in labelled(name, result) if _told(each, given)}
    errors = {key: each for key, each in run.outcomes[name].record.error.items() if isinstance(each, float) and each}
    return {
        "name": name,
        "room": _room(name),
        "title": name_of(stage.title),
        "facts": [*facts.values()],
        "tables": [*tables(stage.summary(result, ""), given)],
        **_table(name, dense.get(name, result), inputs, block),
        "warnings": [name_of(graded(each)[1]) for each in warnings_of(run, [name])],
        "errors": [[worded(name_of(key)), float(f"{each:.3g}")] for key, each in errors.items()],
    }


def _failed(name: str, error: TmmError) -> Content:
    """A stage that has no result: why."""
    return {
        "name": name,
        "room": _room(name),
        "title": name_of(STAGES[name].title),
        "facts": [],
        "tables": [],
        "rows": None,
        "columns": [],
        "warnings": [name_of(str(error))],
        "errors": [],
    }


def _room(name: str) -> str:
    """The room of a stage, whose tables go along the inputs of its views first."""
    return STAGES[name].home.split(".")[1]


def _strings(value: Any) -> Iterator[str]:
    """The texts that stand in a spec, at whatever depth."""
    if isinstance(value, str):
        yield value
    elif isinstance(value, dict | list):
        for each in value.values() if isinstance(value, dict) else value:
            yield from _strings(each)


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
    along = next((header for header in headers if (_room(name), header) in inputs), headers[0])
    others = [header for header in headers if header != along]
    values = table.column(along)
    if not _ordered(values):
        along, others, values = "", headers, np.arange(1.0, len(table.first) + 1)
    columns = {header: table.column(header) for header in others}
    return _laid(along, values, columns, {header: known[named(header)[0]].meaning for header in others}, block)


def _courses(name: str, result: Any, inputs: Container[tuple[str, str]], block: Block) -> Iterator[Content]:
    """Courses that stand below one another in the table of a stage, each as a stage of its own without facts.

    They go along the input of a view, along the time, or along the first column that goes one way.
    """
    meaning = described(name, column=True)
    for k, course in enumerate(courses(name, result), 1):
        ordered = [header for header, each in course.columns.items() if _ordered(each)]
        first = [header for header in ordered if (_room(name), header) in inputs or named(header)[0] == "t"]
        along = next(iter([*first, *ordered]), "")
        columns = {header: each for header, each in course.columns.items() if header != along}
        values = course.columns.get(along, np.arange(1.0, len(next(iter(course.columns.values()), ())) + 1))
        said = {header: _of_course(course.label, meaning(*named(header))[0]) for header in columns}
        yield {
            "name": f"{name}/{k}",
            "room": _room(name),
            "title": name_of(_of_course(STAGES[name].title, course.label)),
            "facts": [],
            "tables": [],
            **_laid(along, values, columns, said, block),
            "warnings": [],
            "errors": [],
        }


def _of_course(what: str, word: str) -> str:
    return Phrase("{quantity}: {word}", quantity=what, word=word) if word else what


def _laid(
    along: str, values: Values, columns: Mapping[str, Values], meanings: Mapping[str, str], block: Block
) -> Content:
    """Columns by their headers over the values of another one, or over the numbers of the rows."""
    row, unit = named(along) if along else ("", "")
    kept = _kept(values, [*columns.values()], along != "")
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


def _given(run: RunResult) -> list[Content]:
    """The given data, as the note lists them."""
    spoken = []
    for language in LANGUAGES:
        with speaking(language):
            spoken.append([block for block in task_of(run.spec, run.results) if isinstance(block, Datum)])
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


def _views(run: RunResult, dense: Mapping[str, Any], block: Block, *, planned: bool) -> Iterator[Content]:
    """What moves, by the rooms."""
    order = order_of(run.spec, {**run.results, **dense})
    for name in run.outcomes:
        if STAGES[name].view:
            for view in _offered(name, "views")(order):
                plans = view.plans() if planned else ()
                yield {
                    "room": _room(name),
                    **_view(view, _steps(run, name, view.column) or [list(step) for step in view.steps], block),
                    "plans": [_plan(each, block) for each in plans],
                }


def _offered(stage: str, what: str) -> Callable[[Order], Iterable[Any]]:
    """What the module of a stage offers of views or trials; nothing where it has none."""
    found: Callable[[Order], Iterable[Any]] = getattr(import_module(STAGES[stage].view), what, lambda _: ())
    return found


def _trials(run: RunResult, block: Block) -> Iterator[Content]:
    """What is tried by hand, by the rooms."""
    order = order_of(run.spec, run.results)
    for name in run.outcomes:
        if STAGES[name].view:
            spoken: list[list[Trial]] = []
            for language in LANGUAGES:
                with speaking(language):
                    spoken.append([*_offered(name, "trials")(order)])
            for same in zip(*spoken, strict=True):
                yield _trial(same, block)


def _trial(same: Sequence[Trial], block: Block) -> Content:
    """A plane that was made in all languages."""
    trial = same[0]
    return {
        "name": trial.name,
        "title": alike([each.title for each in same]),
        "inputs": trial.inputs,
        "start": [trial.start.real, trial.start.imag],
        "box": [*_pair(trial.box[0]), *_pair(trial.box[1])],
        "regions": [
            {"kind": each.kind, "apart": each.apart, "x": block.put(each.edge.real), "y": block.put(each.edge.imag)}
            for each in trial.regions
        ],
        "curves": [
            {
                "number": curve.number,
                "title": alike([each.curves[k].title for each in same]),
                "value": curve.value,
                "x": block.put(curve.at.real),
                "y": block.put(curve.at.imag),
            }
            for k, curve in enumerate(trial.curves)
        ],
        "points": [
            {
                "name": alike([each.points[k].name for each in same]),
                "title": alike([each.points[k].title for each in same]),
                "at": [point.at.real, point.at.imag],
            }
            for k, point in enumerate(trial.points)
        ],
        "given": trial.given,
        "steps": trial.steps,
        "shown": [
            {
                "name": shown.name,
                "meaning": alike([each.shown[k].meaning for each in same]),
                "unit": unit_of(shown.unit),
                "least": shown.least,
                "where": shown.where,
            }
            for k, shown in enumerate(trial.shown)
        ],
        "conditions": [
            {**condition._asdict(), "text": alike([each.conditions[k].text for each in same])}
            for k, condition in enumerate(trial.conditions)
        ],
        "sketch": {
            **trial.sketch._asdict(),
            "title": alike([each.sketch.title for each in same]),
            "bodies": [
                {
                    **body._asdict(),
                    "half": [piece._asdict() for piece in body.half],
                    "worked": body.worked._asdict(),
                    "beyond": alike([each.sketch.bodies[k].beyond for each in same]),
                }
                for k, body in enumerate(trial.sketch.bodies)
            ],
            "marks": [mark._asdict() for mark in trial.sketch.marks],
        },
    }


def _view(view: View, steps: list[list[Any]], block: Block) -> Content:
    handle = view.handle
    return {
        "name": view.name,
        "title": name_of(view.title),
        "symbol": view.symbol,
        "unit": unit_of(view.unit),
        "values": block.put(view.values),
        "whole": view.whole,
        "column": view.column,
        "steps": steps,
        "box": [*_pair(view.box[0]), *_pair(view.box[1])],
        "bodies": [_body(body, block) for body in view.bodies],
        "frame": [_mark(mark) for mark in view.frame],
        "front": [_mark(mark) for mark in view.front],
        "spots": [{**spot._asdict(), "at": _pair(spot.at)} for spot in view.spots],
        "spans": [[span.kind, [[body, *_pair(at)] for body, at in span.points]] for span in view.spans],
        "handle": None
        if handle is None
        else {"body": handle.body, "pivot": None if handle.pivot is None else _pair(handle.pivot)},
        "layers": [
            {
                "name": layer.name,
                "title": name_of(layer.title),
                "unit": unit_of(layer.unit),
                "arrows": [each._asdict() for each in layer.arrows],
                "vectors": [
                    {
                        **each._asdict(),
                        "x": _track(each.x, block),
                        "y": _track(each.y, block),
                        "places": None if each.places is None else block.put(each.places),
                    }
                    for each in layer.vectors
                ],
                "tone": layer.tone,
                "hidden": layer.hidden,
                "angles": [
                    {**each._asdict(), "start": _track(each.start, block), "end": _track(each.end, block)}
                    for each in layer.angles
                ],
            }
            for layer in view.layers
        ],
        "centres": [
            {"name": each.name, "x": block.put(each.at.real), "y": block.put(each.at.imag)} for each in view.centres
        ],
        "stops": [{"title": name_of(stop.title), "at": stop.at} for stop in view.stops],
        "shown": view.shown,
        "stages": view.stages,
        "note": name_of(view.note),
        "reach": view.reach,
        "readings": [
            {
                **each._asdict(),
                "name": name_of(each.name),
                "unit": unit_of(each.unit),
                "value": _track(each.value, block),
            }
            for each in view.readings
        ],
        "seconds": view.seconds,
        "driver": None if view.driver is None else view.driver._asdict(),
        "nudge": view.nudge,
    }


def _plan(plan: Plan, block: Block) -> Content:
    return {
        "name": plan.name,
        "title": name_of(plan.title),
        "unit": unit_of(plan.unit),
        "vertices": [[name, block.put(z.real), block.put(z.imag)] for name, z in plan.vertices],
        "edges": [list(edge) for edge in plan.edges],
        "places": None if plan.places is None else block.put(plan.places),
        "note": name_of(plan.note),
    }


def _steps(run: RunResult, stage: str, column: str) -> list[list[Any]]:
    """The positions of the spec: labels, and where the input stands there."""
    table = table_of(stage, run.results[stage])
    if table is None or column not in table.headers or courses(stage, run.results[stage]):
        return []
    return [[label, float(at)] for label, at in zip(table.labels, table.column(column), strict=True)]


def _body(body: Body, block: Block) -> Content:
    return {
        "name": body.name,
        "x": _track(body.x, block),
        "y": _track(body.y, block),
        "angle": _track(body.angle, block),
        "marks": [_mark(mark) for mark in body.marks],
        "number": body.number,
        "beside": [_pair(each) for each in body.beside],
        "on": body.on,
        "there": body.there,
    }


def _track(track: Track, block: Block) -> Any:
    """A track, or a single number of what does not move."""
    if not np.any(track.rates) and np.ptp(track.values) == 0:
        return float(track.values[0])
    return [block.put(track.values), block.put(track.rates)]


def _mark(mark: Mark) -> list[Any]:
    points = [part for point in mark.points for part in _pair(point)]
    return [mark.kind, points, *([mark.size, *([mark.tone] if mark.tone else [])] if mark.size or mark.tone else [])]


def _pair(z: complex) -> list[float]:
    """Coordinates to a nanometre."""
    return [round(z.real, 9) + 0.0, round(z.imag, 9) + 0.0]
