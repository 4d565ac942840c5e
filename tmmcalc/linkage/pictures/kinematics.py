"""The picture of the kinematics stage: scheme and diagrams; the plans of positions on further sheets below."""

from __future__ import annotations

from collections.abc import Sequence

from tmmcalc.linkage.chain import chain_of
from tmmcalc.linkage.model import Mechanism
from tmmcalc.linkage.pictures.choice import check_positions, chosen
from tmmcalc.linkage.pictures.cycle import whole_cycle
from tmmcalc.linkage.pictures.diagrams import columns_of, draw_diagrams
from tmmcalc.linkage.pictures.plans import draw_plan_sheets, plans_of
from tmmcalc.linkage.pictures.scheme import draw_scheme
from tmmcalc.linkage.results import Kinematics
from tmmcalc.report.drawing.order import POLYGONS, POSITIONS, Order
from tmmcalc.report.drawing.page import sheets
from tmmcalc.report.drawing.shapes import Drawing


def figure(order: Order) -> Drawing:
    """The drawing of the stage: scheme and diagrams, and the plans of positions that are asked for."""
    from tmmcalc.linkage.tables.tasks.mechanism import to_linkage

    result = order.results["kinematics"]
    rows, marked = order.rows(POSITIONS, result.labels), order.rows(POLYGONS, result.labels)
    return kinematics_drawing(to_linkage(order.spec.linkage), result, rows, marked)


def kinematics_drawing(
    mechanism: Mechanism, result: Kinematics, positions: Sequence[int] | None, marked: Sequence[int] | None
) -> Drawing:
    """One sheet, and one for the plans of each position ``marked``; raises `UsageError` for one that is not there."""
    marked = list(dict.fromkeys(marked or ()))
    check_positions(len(result.x), [*(positions or ()), *marked])
    drawing, boxes = sheets(1 + len(marked))
    cycle = whole_cycle(chain_of(mechanism, result), result)
    columns = columns_of(result, cycle)
    widths = (1.35 if len(columns) < 2 else 1.5, *(1.0 for _ in columns))
    scheme, *others = boxes[0].split(*widths, gap=3.0, across=True)
    for box, curves in zip(others, columns, strict=True):
        draw_diagrams(drawing, box, result, cycle, curves)
    draw_scheme(drawing, scheme, result, cycle, chosen(cycle, result, positions, marked))
    if marked:
        draw_plan_sheets(drawing, boxes[1:], result, plans_of(mechanism, result, marked))
    return drawing
