"""The page: sheets of A4 landscape, one under another, so that scales hold on paper."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from io import BytesIO
from pathlib import Path
from typing import Any

import matplotlib
import numpy as np
from matplotlib.figure import Figure, SubFigure
from matplotlib.layout_engine import ConstrainedLayoutEngine

from tmmcalc.core.atomic import replace_file
from tmmcalc.report.drawing.style import RC, SHEET

PLACES = 9  # decimals of places on the figure, in parts of it
UNDATED: dict[str, dict[str, Any]] = {
    "svg": {"Date": None},
    "pdf": {"CreationDate": None, "ModDate": None},
    "png": {},
}


def write(file: Path, form: str, make: Callable[[], Figure]) -> None:
    """Write the figure in this format, in one step; a file that has these bytes already is left alone."""
    replace_file(file, picture(form, make))


def picture(form: str, make: Callable[[], Figure], others: Mapping[str, Any] | None = None) -> bytes:
    """The bytes of the figure that ``make`` draws; they depend on it and the versions of the programs alone.

    ``others`` are settings of matplotlib beside those of the program.
    """
    settings: Any = {k: v for k, v in matplotlib.rcParamsDefault.items() if not k.startswith("backend")}
    settings.update(RC | dict(others or {}))
    with matplotlib.rc_context(settings):
        buffer = BytesIO()
        make().savefig(buffer, format=form, metadata=UNDATED[form])
    return buffer.getvalue()


def blank(sheets: int) -> tuple[Figure, list[SubFigure]]:
    """An empty figure of so many sheets."""
    width, height = SHEET
    figure = Figure(figsize=(width, sheets * height), layout=ConstrainedLayoutEngine(w_pad=0.1, h_pad=0.1))
    return figure, list(figure.subfigures(sheets, 1, squeeze=False)[:, 0])


def settle(figure: Figure) -> None:
    """Let the constrained layout place the axes once; what follows is drawn in mm of paper."""
    layout = figure.get_layout_engine()
    if layout is not None:
        layout.execute(figure)
    figure.set_layout_engine("none")
    _round(figure)


def _round(figure: Figure | SubFigure) -> None:
    """Round all places: the layout's solver leaves last digits that differ from run to run."""
    for part in figure.subfigs:
        box = part.bbox_relative
        box.p0, box.p1 = np.round(box.p0, PLACES), np.round(box.p1, PLACES)
        _round(part)
    if isinstance(figure, Figure):
        for axes in figure.axes:
            axes.set_position(np.round(axes.get_position().bounds, PLACES).tolist())
