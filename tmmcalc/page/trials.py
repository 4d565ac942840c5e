"""What is tried by hand on a page, packed: the planes that rooms offer, each made in all languages."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial
from typing import TYPE_CHECKING

from tmmcalc.page.packing import Block, Content, pair
from tmmcalc.page.said import alike, each_said, unit_of
from tmmcalc.pipeline.picturing import offered, order_of
from tmmcalc.report.exploring import Trial

if TYPE_CHECKING:
    from tmmcalc.pipeline.outcome import RunResult


def trials_packed(run: RunResult, block: Block) -> Iterator[Content]:
    """What is tried by hand, by the rooms."""
    order = order_of(run.spec, run.results)
    for name in run.outcomes:
        for same in zip(*each_said(partial(offered, name, "trials", order)), strict=True):
            yield _trial(same, block)


def _trial(same: Sequence[Trial], block: Block) -> Content:
    """A plane that was made in all languages."""
    trial = same[0]
    return {
        "name": trial.name,
        "title": alike([each.title for each in same]),
        "inputs": trial.inputs,
        "start": [trial.start.real, trial.start.imag],
        "box": [*pair(trial.box[0]), *pair(trial.box[1])],
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
