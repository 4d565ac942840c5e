"""The picture of the blocking stage: the contour of every external pair in the plane of its shifts, with its key.

Both shifts have one scale. The strict contour is filled; what undercut tolerated adds to it is hatched; pieces beyond
a pinch point are pale. Numbers in circles are those of the textbook's figures 4.19 and 4.20.
"""

from __future__ import annotations

from collections.abc import Callable
from math import degrees

from matplotlib.figure import Figure, SubFigure

from tmmcalc.core.errors import UsageError
from tmmcalc.gears.meshing.contours import Blocking, PairContour
from tmmcalc.gears.pictures.contourkey import write_key
from tmmcalc.gears.pictures.contourplane import content_of, draw_plane
from tmmcalc.report.drawing.labels import signed
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.page import blank, settle

LEAST = "\N{GREATER-THAN OR EQUAL TO}"


def figure(order: Order) -> Figure:
    """The figure of the stage, of the pair that is chosen."""
    return blocking_figure(order.results["blocking"], choose=order.choice)


def blocking_figure(result: Blocking, *, choose: int | None = None) -> Figure:
    """A sheet for every pair, or for pair ``choose`` alone, from 1.

    Raises `UsageError` for a pair that there is not, and if no pair has a contour.
    """
    count = len(result.pairs)
    if not count:
        raise UsageError("no pair has a blocking contour", where="plot", remedy="; ".join(result.remarks))
    if choose is not None and not 1 <= choose <= count:
        raise UsageError(
            f"there is no contour {choose}", where="plot", value=choose, limit=count, remedy=f"1 to {count}"
        )
    shown = result.pairs if choose is None else result.pairs[choose - 1 : choose]
    figure, sheets = blank(len(shown))
    finish = [_sheet(sheet, pair) for sheet, pair in zip(sheets, shown, strict=True)]
    settle(figure)
    for draw in finish:
        draw()
    return figure


def _sheet(sheet: SubFigure, pair: PairContour) -> Callable[[], None]:
    """Lay the sheet out; what is returned draws when the layout is settled."""
    sheet.suptitle(_heading(pair), fontsize=10)
    left, right = sheet.subfigures(1, 2, squeeze=False, width_ratios=[1.62, 1.0])[0]
    plane, key = left.subplots(), right.subplots()
    key.set_axis_off()
    low, high = content_of(pair).tolist()
    plane.set_xlim(low.real, high.real)
    plane.set_ylim(low.imag, high.imag)
    plane.set_xlabel("shift of wheel 1, $x_1$")
    plane.set_ylabel("shift of wheel 2, $x_2$")

    def finish() -> None:
        write_key(key, pair, draw_plane(plane, pair))

    return finish


def _heading(pair: PairContour) -> str:
    """The pair and the limits that its contour keeps."""
    teeth = f"{pair.teeth[0]}/{pair.teeth[1]}"
    name = pair.name if teeth in pair.name else f"{pair.name}: $z$ = {teeth}" if pair.name else f"$z$ = {teeth}"
    tips = f"{signed(pair.thickness, 4)} $m$" if pair.thickness else "0"
    limits = f"$\\varepsilon_\\alpha$ {LEAST} {signed(pair.contact_ratio, 4)}, $s_a$ {LEAST} {tips}"
    rack = (
        f"$\\alpha$ = {signed(degrees(pair.rack.angle), 4)}\N{DEGREE SIGN}, $h_a^*$ = {signed(pair.rack.addendum, 4)}"
    )
    helix = f", $\\beta$ = {signed(degrees(abs(pair.helix)), 4)}\N{DEGREE SIGN}" if pair.helix else ""
    made = f"$m$ = {signed(1e3 * pair.module, 4)} mm, {rack}{helix}"
    return f"Blocking contour, {name}\n{made}; limits: {limits}"
