"""The key beside a drawing: headed lists of names and values, and samples of what lines mean."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from matplotlib.axes import Axes

from tmmcalc.core.records import record
from tmmcalc.report.drawing.labels import MM

LINE, GAP = 4.6, 2.4  # mm of paper


@record
class Sample:
    """A short piece of a line, or a patch where ``fill``, with its meaning."""

    text: str
    style: dict[str, Any]
    fill: bool = False


@record
class Part:
    """A headed list."""

    heading: str
    rows: Sequence[tuple[str, str]] = ()
    samples: Sequence[Sample] = ()


def write_key(axes: Axes, parts: Sequence[Part]) -> None:
    """Write the lists one under another; the layout must be settled."""
    box = axes.get_window_extent()
    width, height = (v * MM / axes.figure.dpi for v in (box.width, box.height))
    axes.set_xlim(0, width)
    axes.set_ylim(-height, 0)
    axes.set_axis_off()
    y = -LINE
    for part in parts:
        axes.text(0, y, part.heading, fontsize=8.5, fontweight="bold", va="center")
        y -= 1.15 * LINE
        for name, value in part.rows:
            axes.text(2, y, name, fontsize=8, va="center")
            axes.text(width, y, value, fontsize=8, va="center", ha="right")
            y -= LINE
        for sample in part.samples:
            _sample(axes, sample, y)
            y -= LINE
        y -= GAP


def _sample(axes: Axes, sample: Sample, y: float) -> None:
    if sample.fill:
        axes.fill_between([2, 12], [y - 1.3] * 2, [y + 1.3] * 2, **sample.style)
    else:
        axes.plot([2, 12], [y, y], **sample.style)
    axes.text(15, y, sample.text, fontsize=8, va="center")
