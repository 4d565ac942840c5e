"""Diagrams over a plain variable: grid, zero line, curves with a legend above, marked places along x."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np
from matplotlib.axes import Axes

from tmmcalc.core.numerics.panels import Values
from tmmcalc.report.drawing.style import CURVES, THIN

Lines = Sequence[tuple[str, Values]]


def diagram(axes: Axes, x: Values, lines: Lines, label: str, *, first: int = 0, logarithmic: bool = False) -> None:
    """Curves over x with their names above; ``first`` is the number of the first style."""
    for k, (name, values) in enumerate(lines):
        style = CURVES[(first + k) % len(CURVES)]
        (axes.semilogy if logarithmic else axes.plot)(x, values, linewidth=1.1, label=name, zorder=4, **style)
    if not logarithmic:
        axes.axhline(0, color="#333333", linewidth=0.8, zorder=1.5)
    axes.grid(True, linewidth=0.35, color="#d0d0d0", zorder=0)
    axes.set_xlim(float(x[0]), float(x[-1]))
    axes.set_ylabel(label)
    axes.tick_params(length=2.5)
    axes.legend(loc="lower left", bbox_to_anchor=(0.0, 1.0), ncols=6, handlelength=3, borderaxespad=0.3)


def marked(axes: Axes, places: Iterable[float]) -> None:
    """Thin lines at places along x that lie within."""
    low, high = axes.get_xlim()
    for place in places:
        if low < place < high:
            axes.axvline(place, color=THIN, linewidth=0.7, linestyle=(0, (4, 3)), zorder=1)


def levels(axes: Axes, places: Iterable[float], names: Iterable[str]) -> None:
    """Thin lines at heights, with their names at the right."""
    for place, name in zip(places, names, strict=True):
        axes.axhline(place, color=THIN, linewidth=0.7, linestyle=(0, (4, 3)), zorder=1)
        axes.annotate(
            name,
            (1.0, place),
            xycoords=("axes fraction", "data"),
            xytext=(-3, 1.5),
            textcoords="offset points",
            ha="right",
            fontsize=6.5,
        )


def spread(size: float) -> float:
    """A size that is drawn, never zero."""
    return size if size > 0 else 1.0


def thinned(values: Values, most: int = 6000) -> slice:
    """Every how manieth value is drawn."""
    return slice(None, None, max(1, int(np.ceil(len(values) / most))))
