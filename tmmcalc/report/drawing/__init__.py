"""Drawings in millimetres of paper: described once, written as SVG, PDF, DXF or PNG.

`shapes` are what a drawing is made of, `pens` the kinds of lines with their meaning, `lettering` measures words, `box`
divides the page. `field` and `diagram` bring data to paper, `labels` finds room for names, `signs` are those of
schemes. The form follows the suffix of the file. Equal drawings give equal bytes; the file is written in one step, and
left alone if it has these bytes already.
"""

from __future__ import annotations

from collections.abc import Callable
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING

from tmmcalc.core.errors import UsageError

if TYPE_CHECKING:
    from tmmcalc.report.drawing.shapes import Drawing

WRITERS = {  # the forms, and the package with its extra that each needs
    "svg": ("", ""),
    "png": ("pypdfium2", "plot"),
    "pdf": ("reportlab", "plot"),
    "dxf": ("ezdxf", "cad"),
}


def draw(file: Path, make: Callable[[], Drawing]) -> None:
    """Write the drawing that ``make()`` gives.

    Raises `UsageError` for another suffix, a missing package, or a file that cannot be written.
    """
    form = form_of(file)
    check_writer(form)
    from tmmcalc.core.atomic import replace_file

    replace_file(file, written(form, make()))


def form_of(file: Path) -> str:
    """The form that the suffix names; raises `UsageError` for another one."""
    form = file.suffix.lower().removeprefix(".")
    if form not in WRITERS:
        raise UsageError(
            f"no picture format for the suffix {file.suffix!r} of {file.name}",
            where="plot",
            remedy=f"formats: {', '.join(WRITERS)}",
        )
    return form


def check_writer(form: str, where: str = "plot") -> None:
    """Raise `UsageError` where the package that writes this form is not installed."""
    package, extra = WRITERS[form]
    if package and find_spec(package) is None:
        from tmmcalc.core.installation import install

        said = f"pictures as {form} need {package}, which is not installed"
        raise UsageError(said, where=where, remedy=f"{install(extra)}; svg needs nothing")


def written(form: str, drawing: Drawing) -> bytes:
    """The bytes of a drawing in a form."""
    if form == "svg":
        from tmmcalc.report.drawing.svg import svg

        return svg(drawing)
    if form == "dxf":
        from tmmcalc.report.drawing.dxf import dxf

        return dxf(drawing)
    from tmmcalc.report.drawing.pdf import pdf, png

    return pdf(drawing) if form == "pdf" else png(drawing)
