"""A drawing board: an axes with equal axes whose scale on paper is a round number, and strokes measured in mm."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.patches import Circle, Polygon

from tmmcalc.core.plane import Plane
from tmmcalc.report.drawing.labels import MM, Labels
from tmmcalc.report.drawing.style import INK
from tmmcalc.report.numbers import round_scale


class Board:
    """Strokes on an axes in data coordinates; ``mu`` is the scale, data units to a mm of paper."""

    def __init__(self, axes: Axes, content: Plane, margin: float) -> None:
        """Scale the axes, whose place must be settled, so that the content keeps a margin [mm]."""
        box = axes.get_window_extent()
        width, height = (v * MM / axes.figure.dpi for v in (box.width, box.height))
        low, high = _corners(content)
        need = max((high - low).real / (width - 2 * margin), (high - low).imag / (height - 2 * margin))
        self.axes = axes
        self.mu = round_scale(need)
        middle = (low + high) / 2
        axes.set_xlim(middle.real - width / 2 * self.mu, middle.real + width / 2 * self.mu)
        axes.set_ylim(middle.imag - height / 2 * self.mu, middle.imag + height / 2 * self.mu)
        self.labels = Labels(axes)

    def line(self, points: Iterable[complex], *, weight: float = 1.0, **style: Any) -> None:
        """A polyline; texts keep clear of it by ``weight``."""
        z = np.asarray(list(points))
        style = {"color": INK, "linewidth": 1.6, "solid_capstyle": "round", "solid_joinstyle": "round", **style}
        self.axes.plot(z.real, z.imag, **style)
        if weight:
            self.labels.avoid(z, weight)

    def lines(self, segments: Sequence[Sequence[complex]], *, weight: float = 1.0, **style: Any) -> None:
        """Many polylines of one style."""
        style = {"colors": INK, "linewidths": 0.6, **style}
        self.axes.add_collection(LineCollection([[(z.real, z.imag) for z in s] for s in segments], **style))
        for segment in segments if weight else ():
            self.labels.avoid(segment, weight)

    def area(self, corners: Iterable[complex], *, weight: float = 1.0, **style: Any) -> None:
        """A closed polygon."""
        z = list(corners)
        style = {"facecolor": "white", "edgecolor": INK, "linewidth": 1.1, "joinstyle": "round", **style}
        self.axes.add_patch(Polygon([(p.real, p.imag) for p in z], closed=True, **style))
        if weight:
            self.labels.avoid([*z, z[0]], weight)

    def circle(self, centre: complex, radius: float, **style: Any) -> None:
        """A circle of this radius on paper [mm]."""
        style = {"facecolor": "white", "edgecolor": INK, "linewidth": 1.1, **style}
        self.axes.add_patch(Circle((centre.real, centre.imag), radius * self.mu, **style))
        around = centre + radius * self.mu * np.exp(1j * np.linspace(0, 2 * np.pi, 13))
        self.labels.avoid([*around, centre], 2.0)

    def arrowhead(self, tip: complex, direction: complex, length: float = 2.2, **style: Any) -> None:
        """A filled arrowhead, its length on paper [mm]."""
        e = direction / abs(direction) * length * self.mu
        style = {"facecolor": INK, "edgecolor": "none", "zorder": 12, **style}
        self.area([tip, tip - e + 0.28j * e, tip - e - 0.28j * e], **style)


def _corners(content: Plane) -> tuple[complex, complex]:
    return complex(content.real.min(), content.imag.min()), complex(content.real.max(), content.imag.max())
