"""Work-precision diagrams: error over run time, one panel a study, one curve a method; ladders of stiffness.

A study of one setting, or whose settings are all exact, has nothing to compare and is left out.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from tmmcalc.core.studies.study import Accuracy, Ladder, Series, Study
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.logplots import MARKS, Dots, framed, pages
from tmmcalc.report.drawing.pens import CURVES, INK, Pen
from tmmcalc.report.drawing.shapes import Drawing
from tmmcalc.report.language import tr, tr_unit
from tmmcalc.report.numbers import number

LEAST_TIMES, LEAST_ERRORS = 1.6, 3.0  # decades that an axis spans at least, so that the scatter of a clock stays small
ROOM = 0.08  # beyond the outermost points, of the span
ROUNDING = 1e-12  # an error that is none
ASKED = Pen("TOLERANCE", 0.25, (2.5, 1.3), INK)


def accuracy_drawing(result: Accuracy, heading: str, tolerance: float | None = None) -> Drawing:
    """As many sheets of six panels as the studies and ladders need; ``tolerance`` is drawn across them."""
    studies = [study for study in result.studies if _compares(study)]
    drawing, places = pages(len(studies) + len(result.ladders), heading)
    for box, study in zip(places, studies, strict=False):
        _study(drawing, box, study, tolerance)
    for box, ladder in zip(places[len(studies) :], result.ladders, strict=True):
        _ladder(drawing, box, ladder)
    return drawing


def _compares(study: Study) -> bool:
    """Whether there are several settings, and not all of them exact."""
    points = [point for series in study.series for point in series.points]
    return len(points) > 1 and any(point.error is None or point.error > ROUNDING for point in points)


def _study(drawing: Drawing, box: Box, study: Study, tolerance: float | None) -> None:
    curves = [_curve(series, k) for k, series in enumerate(study.series)]
    told = [p for series in study.series for p in series.points if p.error is not None]
    x = _span([(p.seconds or 0.0) * 1e3 for p in told], LEAST_TIMES)
    y = _span([p.error or 0.0 for p in told], LEAST_ERRORS)
    names = f"{study.stage}: {study.quantity}", tr("run time, ms"), tr("largest relative error")
    levels = [] if tolerance is None else [(tolerance, ASKED)]
    key = [] if tolerance is None else [(tr("tolerance asked for"), ASKED)]
    framed(drawing, box, names, curves, levels, ends=(x, y), key=key)


def _ladder(drawing: Drawing, box: Box, ladder: Ladder) -> None:
    """Evaluations of the textbook's step and of the program's choice along the ladder."""
    values = tuple(rung.value for rung in ladder.rungs)
    steps = tuple(float(rung.textbook_evaluations) for rung in ladder.rungs)
    chosen = tuple(float(rung.evaluations) for rung in ladder.rungs)
    curves = [
        Dots(tr("fixed steps at the limit of stability"), values, steps, CURVES[0], MARKS[0]),
        Dots(tr("choice of the program"), values, chosen, CURVES[1], MARKS[1]),
    ]
    names = f"{ladder.stage}: {ladder.quantity}", tr("value, {unit}", unit=tr_unit(ladder.unit)), tr("evaluations")
    ends = _span(values, LEAST_TIMES), _span(steps + chosen, LEAST_ERRORS)
    framed(drawing, box, names, curves, [], ends=ends)


def _span(values: Sequence[float], least: float) -> tuple[float, float]:
    """Limits of a logarithmic axis that holds the values and spans ``least`` decades."""
    decades = np.log10([value for value in values if value > 0] or [1.0])
    low, high = float(np.min(decades)), float(np.max(decades))
    half = max((high - low) * (1 + 2 * ROOM), least) / 2
    middle = (low + high) / 2
    return float(10 ** (middle - half)), float(10 ** (middle + half))


def _curve(series: Series, k: int) -> Dots:
    told = [p for p in series.points if p.error is not None and p.seconds is not None]
    name = series.method
    if not told:
        name = tr("{method} (no result)", method=name)
    elif series.order is not None:
        name = tr("{method} (order {order})", method=name, order=number(series.order, 2))
    times = tuple((p.seconds or 0.0) * 1e3 for p in told)
    errors = tuple(p.error or 0.0 for p in told)
    return Dots(name, times, errors, CURVES[k % len(CURVES)], MARKS[k % len(MARKS)])
