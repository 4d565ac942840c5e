"""Diagrams over one step: motion of the wheel, pressure angles, polar angles of the lobe, efficiency."""

from __future__ import annotations

from collections.abc import Sequence
from math import degrees

import numpy as np

from tmmcalc.cams.indexing.efficiency import against, aiding
from tmmcalc.cams.indexing.flanks import Drive, Flank
from tmmcalc.cams.indexing.results import Cam, Indexing
from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.pictures.zone import LIMIT
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.curves import stacked
from tmmcalc.report.drawing.diagram import Axis, Diagram, room
from tmmcalc.report.drawing.pens import CURVES, MARK, Pen
from tmmcalc.report.drawing.shapes import Drawing
from tmmcalc.report.language import tr
from tmmcalc.report.numbers import number

DENSE = 401
PLACE = Pen("PLACES", 0.2, (4.0, 1.0, 1.0, 1.0), "#6b6b6b")
FAINT = 0.15  # width of what the other flank takes over [mm]
K = np.linspace(0.0, 1.0, DENSE)
Named = tuple[str, Values, Pen]


def draw_step(drawing: Drawing, box: Box, drive: Drive, result: Indexing, cam: Cam) -> None:
    """Four diagrams with the place of the tip of the lobe in each."""
    left, right = box.split(1, 1, gap=6, across=True)
    boxes = [frame for half in (left, right) for frame in half.split(1, 1, gap=4)]
    front, groove = Flank(drive, "A"), Flank(drive, "B")
    _diagram(drawing, boxes[0], cam, tr("motion of the wheel"), _motion(front))
    _efficiency(drawing, boxes[1], cam, result, front, groove)
    _pressure(drawing, boxes[2], cam, result, front, groove)
    _polar(drawing, boxes[3], cam, front)


def _diagram(
    drawing: Drawing, box: Box, cam: Cam, name: str, curves: Sequence[Named], ends: tuple[float, float] | None = None
) -> Diagram:
    """A frame over k with its curves, a key above it and the place of the tip."""
    (frame,) = stacked(box, [1])
    low, high = room([values[np.isfinite(values)] for _, values, _ in curves]) if ends is None else ends
    diagram = Diagram(drawing, frame, Axis("$k = φ$/$φ_p$", 0.0, 1.0), Axis(name, low, high))
    diagram.vertical(cam.handover.part, PLACE)
    for _, values, pen in curves:
        diagram.curve(K + 1j * values, pen)
    diagram.key([(name, pen) for name, _, pen in curves if name])
    return diagram


def _motion(flank: Flank) -> list[Named]:
    y, y1, y2, _ = flank.motion(K)
    turn = np.degrees(y) / degrees(2 * flank.drive.half)
    return [("$β$/$β_m$", turn, CURVES[0]), ("$β'$", y1, CURVES[1]), ("$β''$", y2, CURVES[2])]


def _pressure(drawing: Drawing, box: Box, cam: Cam, result: Indexing, front: Flank, groove: Flank) -> None:
    """Of each flank where it works, and thin where the other one does; the limits, the start and the tip."""
    end, curves = cam.handover.part, list[Named]()
    for flank, own, name, pen in (
        (front, end >= K, tr("$ϑ_1$ on A"), CURVES[0]),
        (groove, end <= K, tr("$ϑ_2$ on B"), CURVES[1]),
    ):
        values = np.degrees(flank.pressure(K))
        whole = values if flank is front else np.where(np.abs(K - 0.5) < 1e-9, np.nan, values)
        faint = pen._replace(layer=f"{pen.layer}_THIN", width=FAINT)
        curves += [("", whole, faint), (name, np.where(own, values, np.nan), pen)]
    diagram = _diagram(drawing, box, cam, tr("pressure angle, °"), curves, (-95.0, 95.0))
    for sign in (1, -1):
        diagram.level(sign * degrees(result.limit), LIMIT)
    for at in (complex(cam.handover.part, degrees(cam.handover.angle)), complex(0.0, degrees(result.start_pressure))):
        diagram.mark(at, f"{number(at.imag, 4)}°", MARK)
    diagram.name_level(degrees(result.limit), "±$θ_d$", MARK.colour)


def _polar(drawing: Drawing, box: Box, cam: Cam, front: Flank) -> None:
    """The polar angle of A at k and of the back of the lobe at 1 - k: equal radii, whose angles meet at the tip."""
    back, step = Flank(front.drive, "back"), front.drive.step
    ahead = np.degrees(front.polar(K) - step * K)
    behind = np.degrees(back.polar(1 - K) - step * (1 - K))
    curves = [("$δ_1(k)$", ahead, CURVES[0]), ("$δ_3(1 − k)$", behind, CURVES[2])]
    diagram = _diagram(drawing, box, cam, tr("polar angle of the lobe, °"), curves)
    tip = diagram.point(complex(cam.handover.part, -degrees(step) / 2), MARK)
    diagram.labels.put(f"$k_m$ = {number(cam.handover.part, 4)}", [tip], prefer=1 + 1j, gaps=(0.9, 2.0, 4.0, 6.0, 8.0))


def _efficiency(drawing: Drawing, box: Box, cam: Cam, result: Indexing, front: Flank, groove: Flank) -> None:
    first = cam.handover.part >= K
    angle = np.where(first, front.pressure(K), groove.pressure(K))
    sigma = np.where(first, front.rise_angle(K), groove.rise_angle(K))
    curves = [
        (name, formula(angle, sigma, *result.frictions)[0], pen)
        for formula, name, pen in (
            (against, tr("load against the motion"), CURVES[0]),
            (aiding, tr("load along the motion"), CURVES[1]),
        )
    ]
    _diagram(drawing, box, cam, tr("efficiency $η$"), curves, (0.0, 1.05))
