"""The pictures of an indexing drive: its scheme, diagrams over the step, and what lambda and the step angle decide."""

from __future__ import annotations

from matplotlib.figure import Figure

from tmmcalc.cams.indexing.results import Indexing
from tmmcalc.cams.indexing.solve import drive_of
from tmmcalc.cams.indexing.task import IndexingTask
from tmmcalc.cams.pictures.indexingscheme import content_of, draw_scheme, parts_of
from tmmcalc.cams.pictures.indexingstep import draw_step, name_step
from tmmcalc.cams.pictures.indexingstudy import draw_study, name_study
from tmmcalc.core.errors import UsageError
from tmmcalc.report.drawing.board import Board
from tmmcalc.report.drawing.key import write_key
from tmmcalc.report.drawing.order import PHASE, Order
from tmmcalc.report.drawing.page import blank, settle
from tmmcalc.report.numbers import number

MARGIN = 8.0  # [mm]


def figure(order: Order) -> Figure:
    """The figure of the stage, its scheme where the cams have turned by a phase."""
    from tmmcalc.cams.tables.tasks.indexing import to_indexing

    return indexing_figure(to_indexing(order.spec), order.results["indexing"], order.angle(PHASE))


def indexing_figure(task: IndexingTask, result: Indexing, phase: float = 0.0) -> Figure:
    """Three sheets; ``phase`` [rad] is how far the cams have turned from the start of a step in the scheme.

    Raises `UsageError` for a law that is known by its B alone.
    """
    drive = drive_of(task, result.ratio)
    if drive is None or result.cam is None:
        raise UsageError(
            "a law that is known by its B alone gives no picture", where="plot", remedy="name a law of the catalogue"
        )
    figure, (first, second, third) = blank(3)
    first.suptitle(_heading(result), fontsize=10)
    left, right = first.subfigures(1, 2, squeeze=False, width_ratios=[2.2, 1.0])[0]
    scheme, key = left.subplots(), right.subplots()
    for axes in (scheme, key):
        axes.set_axis_off()
    second.suptitle("One step of the wheel", fontsize=10)
    step = second.subplots(2, 2, squeeze=False).ravel().tolist()
    draw_step(step, drive, result, result.cam)
    third.suptitle("What the ratio $\\lambda$ and the step $\\varphi_\\mathrm{p}$ decide", fontsize=10)
    beside, over = third.subfigures(1, 2, squeeze=False, width_ratios=[1.0, 1.1])[0]
    study = [beside.subplots(), *over.subplots(2, 1).tolist()]
    draw_study(study, task, result, drive)
    settle(figure)
    board = Board(scheme, content_of(drive, result), MARGIN)
    draw_scheme(board, task, result, result.cam, phase)
    write_key(key, parts_of(result, result.cam, board.mu))
    name_step(step, drive, result, result.cam)
    name_study(study, task)
    return figure


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
