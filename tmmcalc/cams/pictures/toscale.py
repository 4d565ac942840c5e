"""Pictures at standard scales, as they stand on a sheet: frames and axes that have them, how they are written."""

from __future__ import annotations

from collections.abc import Sequence
from math import radians

import numpy as np

from tmmcalc.core.plane import Plane
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.curves import scale_factor
from tmmcalc.report.drawing.diagram import Diagram
from tmmcalc.report.drawing.field import needed
from tmmcalc.report.drawing.lettering import width
from tmmcalc.report.drawing.scales import factor_text, length_scale, scale_text, standard_scale
from tmmcalc.report.drawing.shapes import Drawing, Words
from tmmcalc.report.language import tr_unit
from tmmcalc.report.numbers import number

FACTORS = 6.0  # room of the line of scale factors above diagrams [mm]
HEIGHT = 2.8  # of their letters [mm]


def scale_of_mm(least: float) -> float:
    """The next standard scale of lengths for data in mm."""
    return 1e3 * length_scale(1e-3 * least)


def closed_up(box: Box, content: Plane, margin: float, *, unit: float = 1.0) -> Box:
    """As much of the height of a rectangle as its content takes at a standard scale; ``unit`` [m] is that of data."""
    mu = length_scale(unit * needed(content, box, margin)) / unit
    return box.inset(0, max(box.height - float(np.ptp(content.imag)) / mu - 2 * margin, 0.0), 0, 0)


def turn_to_scale(frame: Box) -> Box:
    """As much of a frame as a turn of the cam takes at a standard scale."""
    return frame._replace(right=frame.left + 360.0 / standard_scale(360.0 / frame.width))


def ends_to_scale(ends: tuple[float, float], height: float) -> tuple[float, float]:
    """The ends of an ordinate, moved apart until its scale is a standard one."""
    low, high = ends
    more = (standard_scale((high - low) / height) * height - high + low) / 2
    return low - more, high + more


def heights_to_scale(spans: Sequence[float], free: float) -> list[float]:
    """Heights of frames that share a room [mm] so that the scales of their ordinates are as large as standard ones go.

    >>> heights_to_scale([10.0, 30.0], 100.0)
    [60.0, 40.0]
    """
    steps = [standard_scale(span * len(spans) / free) for span in spans]
    for k in sorted(range(len(spans)), key=lambda k: spans[k] / steps[k]):
        finer = [standard_scale(step / 2) if i == k else step for i, step in enumerate(steps)]
        if sum(span / step for span, step in zip(spans, finer, strict=True)) <= free:
            steps = finer
    needs = [span / step for span, step in zip(spans, steps, strict=True)]
    return [need + (free - sum(needs)) / len(needs) for need in needs]


def factor(sign: str, value: float, unit: str) -> str:
    """A scale factor with its unit."""
    return scale_factor(sign.removeprefix("Δ"), value, unit or "1")


def lengths_text(mu: float, to_scale: bool) -> str:
    """The scale of lengths [m/mm] of a picture, with its ratio where it is a standard one.

    >>> lengths_text(0.0005, True), lengths_text(0.0006, False)
    ('$μ_l$ = 0.0005 m/mm (2:1)', '$μ_l$ = 0.6 mm/mm')
    """
    return scale_text(mu) if to_scale else factor_text("μ_l", 1e3 * mu, "mm/mm")


def turn_factor(step: float) -> str:
    """The scale factor of the angle of the cam, ``step`` degrees to a mm."""
    return f"{factor('φ', step, '°')} = {number(radians(step), 4)} {tr_unit('rad/mm')}"


def write_factors(drawing: Drawing, box: Box, diagrams: Sequence[Diagram], names: Sequence[tuple[str, str]]) -> None:
    """The scale factors of diagrams over the turn on top of a rectangle; ``names`` are sign and unit of ordinates."""
    texts = [turn_factor(diagrams[0].x.high / diagrams[0].box.width)]
    for diagram, (sign, unit) in zip(diagrams, names, strict=True):
        texts.append(factor(sign, (diagram.y.high - diagram.y.low) / diagram.box.height, unit))
    text = ",   ".join(texts)
    at = complex(diagrams[0].box.left, box.top)
    drawing.add(Words(at, text, min(HEIGHT, (box.right - at.real) / width(text)), -1 + 1j))
