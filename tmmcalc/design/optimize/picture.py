"""Picture of a front: every design by its objectives, two at a time."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from tmmcalc.design.optimize.document import header
from tmmcalc.design.optimize.scene import Optimum
from tmmcalc.report.drawing.diagram import Axis, Diagram, named
from tmmcalc.report.drawing.lettering import plain
from tmmcalc.report.drawing.page import headed, sheets
from tmmcalc.report.drawing.pens import CURVES
from tmmcalc.report.drawing.shapes import Drawing
from tmmcalc.report.language import tr

AIR = 0.06  # beside the outermost design, of the span


def front_drawing(result: Optimum, name: str) -> Drawing:
    """A sheet for every objective with the next; ``name`` is that of the spec."""
    pairs = [*pairwise(range(len(result.objectives)))]
    drawing, boxes = sheets(len(pairs))
    values = np.array([design.objectives for design in result.designs])
    for box, (one, two) in zip(boxes, pairs, strict=True):
        inner = headed(drawing, box, tr("{name}: optimum", name=plain(name))).inset(24, 16, 6, 8)
        axes = []
        for at in (one, two):
            low, high = float(values[:, at].min()), float(values[:, at].max())
            air = AIR * (high - low) or abs(low) * 1e-3 or 1.0
            objective = result.objectives[at]
            axes.append(Axis(named(header(objective.name, objective.unit)), low - air, high + air))
        field = Diagram(drawing, inner, *axes)
        order = np.argsort(values[:, one])
        points = values[order, one] + 1j * values[order, two]
        field.curve(points, CURVES[0])
        for point in points.tolist():
            field.point(point, CURVES[0])
    return drawing
