"""Pictures of results, for people. matplotlib is needed only here, and only when a picture is drawn.

The format follows the suffix of the file: svg, png or pdf. Equal inputs give equal bytes; the file is written in one
step, and left alone if it has these bytes already.
"""

from __future__ import annotations

from collections.abc import Callable
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING

from tmmcalc.core.errors import UsageError

if TYPE_CHECKING:
    from matplotlib.figure import Figure

FORMATS = ("svg", "png", "pdf")


def draw(file: Path, figure: Callable[[], Figure]) -> None:
    """Write the figure that ``figure()`` makes.

    Raises `UsageError` for another suffix, a missing matplotlib, or a file that cannot be written.
    """
    form = form_of(file)
    check_matplotlib()
    from tmmcalc.report.drawing.page import write

    write(file, form, figure)


def form_of(file: Path) -> str:
    """The format that the suffix names."""
    form = file.suffix.lower().removeprefix(".")
    if form not in FORMATS:
        raise UsageError(
            f"no picture format for the suffix {file.suffix!r} of {file.name}",
            where="plot",
            remedy=f"formats: {', '.join(FORMATS)}",
        )
    return form


def check_matplotlib() -> None:
    """Raise `UsageError` where matplotlib is not installed."""
    if find_spec("matplotlib") is None:
        from tmmcalc.core.installation import install

        raise UsageError("pictures need matplotlib, which is not installed", where="plot", remedy=install("plot"))
