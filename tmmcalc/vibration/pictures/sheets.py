"""A figure of sheets under one another, each with its title."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from matplotlib.figure import Figure, SubFigure

from tmmcalc.report.drawing.page import blank, settle

Sheet = tuple[str, Callable[[SubFigure], None]]  # title, and what draws it


def sheets_of(sheets: Sequence[Sheet]) -> Figure:
    """The sheets, drawn."""
    figure, places = blank(len(sheets))
    for place, (title, draw) in zip(places, sheets, strict=True):
        place.suptitle(title, fontsize=10)
        draw(place)
    settle(figure)
    return figure
