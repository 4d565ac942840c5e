"""The pictures of an indexing drive: its scheme, diagrams over the step, and what lambda and the step angle decide."""

from __future__ import annotations

from tmmcalc.cams.indexing.results import Indexing
from tmmcalc.cams.indexing.solve import drive_of
from tmmcalc.cams.indexing.task import IndexingTask
from tmmcalc.cams.pictures.indexingscheme import content_of, draw_scheme, parts_of
from tmmcalc.cams.pictures.indexingstep import draw_step
from tmmcalc.cams.pictures.indexingstudy import draw_study
from tmmcalc.cams.pictures.toscale import lengths_text
from tmmcalc.cams.pictures.wording import mm
from tmmcalc.core.errors import UsageError
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.field import Board
from tmmcalc.report.drawing.key import write_key
from tmmcalc.report.drawing.order import PHASE, Order
from tmmcalc.report.drawing.page import sheets
from tmmcalc.report.drawing.scales import length_scale
from tmmcalc.report.drawing.shapes import Drawing, Words
from tmmcalc.report.language import tr, tr_name, tr_unit
from tmmcalc.report.numbers import round_scale

MARGIN = 8.0  # [mm]
KEY = 88.0  # width of the key beside the scheme [mm]


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
    headings = (_heading(result), tr("One step of the wheel"), tr("What the ratio $λ$ and the step $φ_p$ decide"))
    for box, heading in zip(boxes, headings, strict=True):
        drawing.add(Words(complex(box.middle.real, box.top), heading, 3.2, 1j))
    first, second, third = (box.inset(0, 0, 0, 7) for box in boxes)
    draw_drive(drawing, first, task, result, phase)
    draw_step(drawing, second, drive, result, result.cam)
    draw_study(drawing, third, task, result, drive)
    return drawing


def draw_drive(
    drawing: Drawing, box: Box, task: IndexingTask, result: Indexing, phase: float, *, to_scale: bool = False
) -> None:
    """The drive in a rectangle, with its sizes beside it; ``to_scale``: at a standard scale of lengths."""
    drive = drive_of(task, result.ratio)
    assert drive is not None
    assert result.cam is not None
    beside = min(KEY, box.width / 3.2)
    scheme, key = box.split(box.width - beside - 5.0, beside, gap=5.0, across=True)
    scale = length_scale if to_scale else round_scale
    board = Board(drawing, scheme, content_of(drive, result), MARGIN, scale=scale)
    draw_scheme(board, task, result, result.cam, phase)
    said = lengths_text(board.mu, to_scale)
    write_key(drawing, key, parts_of(result, result.cam, said))


def _radii(result: Indexing) -> list[float]:
    """Radii of the rollers [m]: of both rows where they differ."""
    first, second = result.roller or 0.0, result.second
    return [first] if second is None or second.turned_over else [first, second.roller]


def _heading(result: Indexing) -> str:
    sizes = (
        f"$z_2$ = {result.rollers}",
        f"$a$ = {mm(result.centres)} {tr_unit('mm')}",
        f"$l_k$ = {mm(result.wheel)} {tr_unit('mm')}",
        f"$r_r$ = {'; '.join(map(mm, _radii(result)))} {tr_unit('mm')}",
    )
    return tr("Indexing drive: {sizes}, law {law}", sizes=", ".join(sizes), law=tr_name(result.law))
