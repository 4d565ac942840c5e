"""The picture of the blocking stage: the contour of every external pair in the plane of its shifts, with its key.

Both shifts have one scale. The strict contour is filled; what undercut tolerated adds to it is hatched; pieces beyond
a pinch point are pale. Numbers in circles are those of the textbook's figures 4.19 and 4.20.
"""

from __future__ import annotations

from math import degrees

from tmmcalc.core.errors import UsageError
from tmmcalc.gears.meshing.contours import Blocking, PairContour
from tmmcalc.gears.pictures.contourkey import write_key
from tmmcalc.gears.pictures.contourplane import draw_plane
from tmmcalc.gears.pictures.words import pair_name
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.lettering import minus, plain
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.page import sheets
from tmmcalc.report.drawing.shapes import Drawing, Words
from tmmcalc.report.language import tr, tr_unit
from tmmcalc.report.numbers import number
from tmmcalc.report.rows import check_choice

LEAST = "\N{GREATER-THAN OR EQUAL TO}"
HEADING, TITLE = 14.0, 3.0  # room of the heading and the height of its letters [mm]
KEY, GAP = 106.0, 6.0  # width of the key and its distance from the plane


def figure(order: Order) -> Drawing:
    """The drawing of the stage, of the pair that is chosen."""
    return blocking_drawing(order.results["blocking"], choose=order.choice)


def blocking_drawing(result: Blocking, *, choose: int | None = None) -> Drawing:
    """A sheet for every pair, or for pair ``choose`` alone, from 1.

    Raises `UsageError` for a pair that there is not, and if no pair has a contour.
    """
    count = len(result.pairs)
    if not count:
        raise UsageError("no pair has a blocking contour", where="plot", remedy="; ".join(result.remarks))
    if choose is not None:
        check_choice(choose, count, "pair")
    shown = result.pairs if choose is None else result.pairs[choose - 1 : choose]
    drawing, boxes = sheets(len(shown), tr("Blocking contours"))
    for box, pair in zip(boxes, shown, strict=True):
        drawing.add(Words(complex(box.middle.real, box.top), _heading(pair), TITLE, 1j))
        free = box.inset(0, 0, 0, HEADING)
        plane = Box(free.left, free.bottom, free.right - KEY - GAP, free.top)
        seen = draw_plane(drawing, plane, pair)
        write_key(drawing, Box(free.right - KEY, free.bottom, free.right, free.top), pair, seen)
    return drawing


def _heading(pair: PairContour) -> str:
    """The pair and the limits that its contour keeps."""
    teeth = f"{pair.teeth[0]}/{pair.teeth[1]}"
    called = plain(pair_name(pair.name))
    name = called if teeth in called else f"{called}: $z$ = {teeth}" if called else f"$z$ = {teeth}"
    tips = f"{minus(number(pair.thickness, 4))} $m$" if pair.thickness else "0"
    limits = f"$ε_α$ {LEAST} {minus(number(pair.contact_ratio, 4))}, $s_a$ {LEAST} {tips}"
    rack = f"$α$ = {number(degrees(pair.rack.angle), 4)}°, $h_a^*$ = {number(pair.rack.addendum, 4)}"
    helix = f", $β$ = {number(degrees(abs(pair.helix)), 4)}°" if pair.helix else ""
    made = f"$m$ = {number(1e3 * pair.module, 4)} {tr_unit('mm')}, {rack}{helix}"
    head, kept = tr("Blocking contour, {pair}", pair=name), tr("{sizes}; limits: {limits}", sizes=made, limits=limits)
    return f"{head}\n{kept}"
