"""Observed error over the condition number, one panel a ladder, one curve a stage; what it expects dotted beside it."""

from __future__ import annotations

from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.logplots import MARKS, Dots, framed, pages
from tmmcalc.report.drawing.pens import CURVES, Pen
from tmmcalc.report.drawing.shapes import Drawing
from tmmcalc.report.language import tr
from tmmcalc.stress.results import LIMITS, Ladder, Stress

SAME = 1.001  # ratio of conditions that are one
LIMIT = Pen("LIMITS", 0.2, (2.0, 1.5), "#a0a0a0")
EXPECTED = (0.4, 0.7)


def stress_drawing(result: Stress, heading: str) -> Drawing:
    """As many sheets of six panels as the ladders need."""
    drawing, places = pages(len(result.ladders), heading)
    for box, ladder in zip(places, result.ladders, strict=True):
        _draw(drawing, box, ladder)
    return drawing


def _draw(drawing: Drawing, box: Box, ladder: Ladder) -> None:
    level = _level(ladder)
    curves: list[Dots] = []
    for k, stage in enumerate(ladder.stages()):
        curves += _curves(ladder, stage, CURVES[k % len(CURVES)], MARKS[k % len(MARKS)], level)
    names = ladder.name, tr("what is varied") if level else ladder.condition, tr("largest relative error")
    framed(drawing, box, names, curves, [(limit, LIMIT) for limit in LIMITS], linear=level)


def _level(ladder: Ladder) -> bool:
    """Whether the condition is the same on all rungs: then errors are drawn over what is varied."""
    met = [rung.condition for rung in ladder.rungs if rung.condition is not None]
    return len(met) > 0 and max(met) < SAME * min(met)


def _curves(ladder: Ladder, stage: str, pen: Pen, mark: str, level: bool) -> list[Dots]:
    """The observed errors of a stage, and thin beside them its estimates with what the last digit of the data does."""
    told = [
        (rung.size if level else rung.condition, met.error, met.covered)
        for rung, met in ladder.track(stage)
        if met.error is not None and rung.condition is not None
    ]
    if not told:
        return []
    told.sort(key=lambda row: row[0])
    found = [Dots(stage, tuple(row[0] for row in told), tuple(row[1] for row in told), pen, mark)]
    estimated = [(row[0], row[2]) for row in told if row[2]]
    if estimated:
        thin = Pen("EXPECTED", 0.25, EXPECTED, pen.colour)
        found.append(Dots("", tuple(x for x, _ in estimated), tuple(y for _, y in estimated), thin, ""))
    return found
