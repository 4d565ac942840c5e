"""What lambda and the step angle decide: the groove near lambda_min, pressure angles and k_m over both."""

from __future__ import annotations

from dataclasses import replace
from math import degrees, pi

import numpy as np

from tmmcalc.cams.indexing.bounds import start_pressure
from tmmcalc.cams.indexing.flanks import Drive, Flank
from tmmcalc.cams.indexing.handover import handover
from tmmcalc.cams.indexing.results import Indexing
from tmmcalc.cams.indexing.solve import drive_of
from tmmcalc.cams.indexing.task import IndexingTask
from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.pictures.indexingstep import PLACE
from tmmcalc.cams.pictures.zone import LIMIT
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.curves import SIDES, stacked
from tmmcalc.report.drawing.diagram import ROW, Axis, Diagram, key_above, one_scale
from tmmcalc.report.drawing.pens import CURVES
from tmmcalc.report.drawing.shapes import Drawing
from tmmcalc.report.language import tr
from tmmcalc.report.numbers import number

POINTS = 33
BELOW = 0.88  # of lambda_min: a groove that crosses itself
DENSE = 601
LARGEST_STEP = 0.98 * pi


def draw_study(drawing: Drawing, box: Box, task: IndexingTask, result: Indexing, drive: Drive) -> None:
    """The groove at three lambda; theta_1m, theta_2 and k_m over lambda and over the step."""
    left, right = box.split(1.0, 1.1, gap=6, across=True)
    _grooves(drawing, left, result, drive)
    upper, lower = right.split(1, 1, gap=4)
    limits = result.bounds
    high = max(limits.ratio_max or 0.0, 1.05 * result.ratio, 1.2 * limits.ratio_min)
    ratios = np.linspace(limits.ratio_min, high, POINTS)
    across = Axis("$λ = a$/$l_k$", float(ratios[0]), float(ratios[-1]))
    both = _curves(drawing, upper, across, ratios, [drive_of(task, ratio) for ratio in ratios.tolist()], task)
    for diagram in both:
        if limits.ratio_max is not None:
            diagram.vertical(limits.ratio_max, LIMIT)
        diagram.vertical(result.ratio, PLACE)
    low = limits.step_min or 0.0
    steps = np.linspace(low, max(min(limits.step_max or pi, LARGEST_STEP), 1.05 * low, 1.02 * result.step), POINTS)
    drives = [drive_of(replace(task, step=step), result.ratio) for step in steps.tolist()]
    x = np.degrees(steps)
    across = Axis(tr("$φ_p$, °, at $λ$ = {ratio}", ratio=number(result.ratio, 5)), float(x[0]), float(x[-1]), True)
    for diagram in _curves(drawing, lower, across, x, drives, task):
        diagram.vertical(degrees(result.step), PLACE)


def _grooves(drawing: Drawing, box: Box, result: Indexing, drive: Drive) -> None:
    """Pitch curves of the groove below lambda_min, at it, and of the drive, each turned upright."""
    k = np.linspace(0.0, 1.0, DENSE)
    curves = []
    for ratio, name, pen in (
        (BELOW * result.bounds.ratio_min, tr("{part} $λ_{min}$, a loop", part=number(BELOW)), CURVES[1]),
        (result.bounds.ratio_min, tr("$λ_{min}$, a point"), CURVES[2]),
        (result.ratio, f"$λ$ = {number(result.ratio, 5)}", CURVES[0]),
    ):
        flank = Flank(replace(drive, centres=ratio * drive.wheel), "B")
        points = 1e3j * flank.roller(k) * np.exp(-1j * drive.step * (k - 0.5))
        curves.append((name, points, pen))
    every = np.concatenate([points for _, points, _ in curves])
    air = 0.05 * max(float(np.ptp(every.real)), float(np.ptp(every.imag)))
    frame = box.inset(SIDES[0] - 3.0, 10, 2, 2 * ROW + 2)
    x = Axis(tr("pitch curve of the groove, mm"), float(every.real.min()) - air, float(every.real.max()) + air)
    y = Axis("", float(every.imag.min()) - air, float(every.imag.max()) + air)
    high = min(frame.height, frame.width * (y.high - y.low) / (x.high - x.low))
    frame = frame.inset(0, frame.height - high, 0, 0)
    diagram = Diagram(drawing, frame, *one_scale(frame, x, y))
    for _, points, pen in curves:
        diagram.curve(points, pen)
    key_above(drawing, frame, [(name, pen) for name, _, pen in curves])


def _curves(
    drawing: Drawing, box: Box, across: Axis, x: Values, drives: list[Drive | None], task: IndexingTask
) -> list[Diagram]:
    """The pressure angles with their limit above, k_m below."""
    found = [None if drive is None else handover(drive) for drive in drives]
    start = [0.0 if drive is None else degrees(start_pressure(drive.rollers, drive.ratio)) for drive in drives]
    angle = [np.nan if tip is None else degrees(tip.angle) for tip in found]
    part = [np.nan if tip is None else tip.part for tip in found]
    upper, lower = stacked(box, [1, 0], [1.7, 1.0])
    above = Diagram(drawing, upper, across, Axis(tr("pressure angle, °"), 0.0, 90.0), numbered=False)
    above.level(degrees(task.limit), LIMIT)
    named = [("$ϑ_{1m}$", start, CURVES[0]), ("$ϑ_2(k_m)$", angle, CURVES[1])]
    for _, values, pen in named:
        above.curve(x + 1j * np.array(values), pen)
    above.key([(name, pen) for name, _, pen in named])
    above.name_level(degrees(task.limit), "$θ_d$", LIMIT.colour)
    below = Diagram(drawing, lower, across, Axis("$k_m$", 0.5, 1.0))
    below.curve(x + 1j * np.array(part), CURVES[2])
    return [above, below]
