"""What moves on a page, packed: the views that rooms offer, with their bodies, layers and plans of vectors."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from tmmcalc.core.stage import STAGES
from tmmcalc.naming.table import table_of
from tmmcalc.page.packing import Block, Content, pair
from tmmcalc.page.said import name_of, unit_of
from tmmcalc.page.stacked import courses
from tmmcalc.pipeline.picturing import offered, order_of
from tmmcalc.report.moving import Body, Layer, Mark, Plan, Track, View

if TYPE_CHECKING:
    from tmmcalc.pipeline.outcome import RunResult


def views_packed(run: RunResult, dense: Mapping[str, Any], block: Block, *, planned: bool) -> Iterator[Content]:
    """What moves, by the rooms; ``dense`` are results over many places in place of those of the run."""
    order = order_of(run.spec, {**run.results, **dense})
    for name in run.outcomes:
        for view in offered(name, "views", order):
            plans = view.plans() if planned else ()
            yield {
                "room": STAGES[name].room,
                **_view(view, _steps(run, name, view.column) or [list(step) for step in view.steps], block),
                "plans": [_plan(each, block) for each in plans],
            }


def _steps(run: RunResult, stage: str, column: str) -> list[list[Any]]:
    """The positions of the spec: labels, and where the input stands there."""
    table = table_of(stage, run.results[stage])
    if table is None or column not in table.headers or courses(stage, run.results[stage]):
        return []
    return [[label, float(at)] for label, at in zip(table.labels, table.column(column), strict=True)]


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
        "box": [*pair(view.box[0]), *pair(view.box[1])],
        "bodies": [_body(body, block) for body in view.bodies],
        "frame": [_mark(mark) for mark in view.frame],
        "front": [_mark(mark) for mark in view.front],
        "spots": [{**spot._asdict(), "at": pair(spot.at)} for spot in view.spots],
        "spans": [[span.kind, [[body, *pair(at)] for body, at in span.points]] for span in view.spans],
        "handle": None
        if handle is None
        else {"body": handle.body, "pivot": None if handle.pivot is None else pair(handle.pivot)},
        "layers": [_layer(layer, block) for layer in view.layers],
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


def _body(body: Body, block: Block) -> Content:
    return {
        "name": body.name,
        "x": _track(body.x, block),
        "y": _track(body.y, block),
        "angle": _track(body.angle, block),
        "marks": [_mark(mark) for mark in body.marks],
        "number": body.number,
        "beside": [pair(each) for each in body.beside],
        "on": body.on,
        "there": body.there,
    }


def _layer(layer: Layer, block: Block) -> Content:
    return {
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


def _track(track: Track, block: Block) -> Any:
    """A track, or a single number of what does not move."""
    if not np.any(track.rates) and np.ptp(track.values) == 0:
        return float(track.values[0])
    return [block.put(track.values), block.put(track.rates)]


def _mark(mark: Mark) -> list[Any]:
    points = [part for point in mark.points for part in pair(point)]
    return [mark.kind, points, *([mark.size, *([mark.tone] if mark.tone else [])] if mark.size or mark.tone else [])]


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
