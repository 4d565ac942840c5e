"""The pictures of an indexing drive: its scheme, diagrams over the step, and what lambda and the step angle decide."""

from __future__ import annotations

from tmmcalc.cams.indexing.results import Indexing
from tmmcalc.cams.indexing.solve import drive_of
from tmmcalc.cams.indexing.task import IndexingTask
from tmmcalc.cams.pictures.indexingscheme import content_of, draw_scheme, parts_of
from tmmcalc.cams.pictures.indexingstep import draw_step
from tmmcalc.cams.pictures.indexingstudy import draw_study
from tmmcalc.core.errors import UsageError
from tmmcalc.report.drawing.field import Board
from tmmcalc.report.drawing.key import write_key
from tmmcalc.report.drawing.order import PHASE, Order
from tmmcalc.report.drawing.page import sheets
from tmmcalc.report.drawing.shapes import Drawing, Words
from tmmcalc.report.numbers import number

MARGIN = 8.0  # [mm]


def figure(order: Order) -> Drawing:
    """The drawing of the stage, its scheme where the cams have turned by a phase."""
    from tmmcalc.cams.tables.tasks.indexing import to_indexing

    return indexing_drawing(to_indexing(order.spec), order.results["indexing"], order.angle(PHASE))


def indexing_drawing(task: IndexingTask, result: Indexing, phase: float = 0.0) -> Drawing:
    """Three sheets; ``phase`` [rad] is how far the cams have turned from the start of a step in the scheme.

    Raises `UsageError` for a law that is known by its B alone.
    """
    drive = drive_of(task, result.ratio)
    if drive is None or result.cam is None:
        raise UsageError(
            "a law that is known by its B alone gives no picture", where="plot", remedy="name a law of the catalogue"
        )
    drawing, boxes = sheets(3)
    headings = (_heading(result), "One step of the wheel", "What the ratio $λ$ and the step $φ_p$ decide")
    for box, heading in zip(boxes, headings, strict=True):
        drawing.add(Words(complex(box.middle.real, box.top), heading, 3.2, 1j))
    first, second, third = (box.inset(0, 0, 0, 7) for box in boxes)
    scheme, key = first.split(2.2, 1.0, gap=5, across=True)
    board = Board(drawing, scheme, content_of(drive, result), MARGIN)
    draw_scheme(board, task, result, result.cam, phase)
    write_key(drawing, key, parts_of(result, result.cam, board.mu))
    draw_step(drawing, second, drive, result, result.cam)
    draw_study(drawing, third, task, result, drive)
    return drawing


def _radii(result: Indexing) -> list[float]:
    """Radii of the rollers [m]: of both rows where they differ."""
    first, second = result.roller or 0.0, result.second
    return [first] if second is None or second.turned_over else [first, second.roller]


def _heading(result: Indexing) -> str:
    sizes = (
        f"$z_2$ = {result.rollers}",
        f"$a$ = {number(1e3 * result.centres, 5)} mm",
        f"$l_k$ = {number(1e3 * result.wheel, 5)} mm",
        f"$r_r$ = {' and '.join(number(1e3 * radius, 5) for radius in _radii(result))} mm",
        f"law {result.law}",
    )
    return f"Indexing drive: {', '.join(sizes)}"
