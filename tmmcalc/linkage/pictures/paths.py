"""The picture of wanted paths: the linkage with the paths and the wanted points, and how far each of these is off."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from tmmcalc.core.plane import Plane
from tmmcalc.linkage.chain import chain_of
from tmmcalc.linkage.paths.results import PathDeviation, Paths
from tmmcalc.linkage.pictures.cycle import LinkageMotion, whole_cycle
from tmmcalc.linkage.pictures.scheme import draw_scheme
from tmmcalc.linkage.results import Kinematics
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.diagram import Axis, Diagram, room
from tmmcalc.report.drawing.field import Board
from tmmcalc.report.drawing.lettering import point_name
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.page import sheets
from tmmcalc.report.drawing.pens import CURVES, MARK, Pen
from tmmcalc.report.drawing.shapes import Drawing, Words
from tmmcalc.report.language import tr, tr_unit
from tmmcalc.report.numbers import number
from tmmcalc.report.sheets.piece import Piece

OFF = Pen("DEVIATIONS", 0.35, colour=MARK.colour)
MANY = 24  # points that all have numbers


def figure(order: Order) -> Drawing:
    """The drawing of the stage: the scheme on the left, the distances of every path on the right."""
    result, kinematics, cycle = _drawn(order)
    drawing, (box,) = sheets(1)
    drawing.add(Words(complex(box.middle.real, box.top), tr("Paths and wanted points"), 3.5, 1j))
    scheme, beside = box.inset(0, 0, 0, 7).split(1.6, 1.0, gap=5, across=True)
    _draw_paths(drawing, scheme, result, kinematics, cycle)
    draw_distances(drawing, beside, result)
    return drawing


def piece_of(order: Order) -> Piece:
    """The linkage with its paths and the wanted points."""
    result, kinematics, cycle = _drawn(order)

    def draw(drawing: Drawing, box: Box) -> None:
        _draw_paths(drawing, box, result, kinematics, cycle)

    return Piece("linkage", tr("Paths and wanted points"), draw, (110.0, 100.0), (160.0, 130.0))


def _drawn(order: Order) -> tuple[Paths, Kinematics, LinkageMotion]:
    from tmmcalc.linkage.tables.tasks.mechanism import to_linkage

    kinematics = order.results["kinematics"]
    cycle = whole_cycle(chain_of(to_linkage(order.spec.linkage), kinematics), kinematics)
    return order.results["paths"], kinematics, cycle


def _draw_paths(drawing: Drawing, box: Box, result: Paths, kinematics: Kinematics, cycle: LinkageMotion) -> None:
    """The scheme to scale, the wanted points, and the way from each to its place of the path."""
    board = draw_scheme(drawing, box, kinematics, cycle, [0], beside=result.wanted)
    for wanted, place in zip(result.wanted.tolist(), result.reached.tolist(), strict=True):
        board.line([wanted, place], OFF, weight=0.3, level=14)
        board.dot(place, 0.4, colour=MARK.colour, level=14)
    for path, rows in parts(result):
        before = f"{point_name(path.name)}: " if len(result.paths) > 1 else ""
        draw_wanted(board, result.wanted[rows], before)


def parts(result: Paths) -> Iterator[tuple[PathDeviation, slice]]:
    """Every path with its rows."""
    at = 0
    for path in result.paths:
        yield path, slice(at, at + path.count)
        at += path.count


def draw_wanted(board: Board, points: Plane, before: str = "") -> None:
    """Wanted points as numbered crosses; ``before`` stands before the numbers."""
    for k, at in enumerate(points.tolist()):
        size = 1.1 * board.mu
        for way in (1 + 1j, 1 - 1j):
            board.line([at - size * way, at + size * way], MARK, level=15)
        if len(points) <= MANY:
            board.labels.put(f"{before}{k + 1}", board.paper([at]), height=1.9, colour=MARK.colour)


def draw_distances(drawing: Drawing, box: Box, result: Paths) -> None:
    """The distance of every point from its path, path under path."""
    distance = 1e3 * np.abs(result.reached - result.wanted)
    frames: Sequence[Box] = box.inset(16, 0, 2, 4).split(*(1.0 for _ in result.paths), gap=4)
    for (path, rows), frame in zip(parts(result), frames, strict=True):
        values, numbers = distance[rows], np.arange(1.0, path.count + 1)
        across = Axis(tr("point"), 0.5, path.count + 0.5, whole=True)
        top = room([values, np.zeros(1)])[1]
        up = Axis(f"{tr('distance from the path')}, {tr_unit('mm')}", 0.0, top)
        diagram = Diagram(drawing, frame.inset(0, 9, 0, 7), across, up)
        for k, value in zip(numbers.tolist(), values.tolist(), strict=True):
            diagram.curve(np.array([complex(k, 0), complex(k, value)]), CURVES[0])
        diagram.dots(numbers, values, CURVES[0], 0.9)
        told = tr("path {name}, rms {value} mm", name=point_name(path.name), value=number(1e3 * path.rms, 4))
        drawing.add(Words(complex(frame.middle.real, frame.top), told, 2.5, 1j))
