"""The picture of a dyad by itself: its links and joints to scale, with velocities, and with accelerations."""

from __future__ import annotations

import cmath
from collections.abc import Mapping
from types import MappingProxyType
from typing import NamedTuple

import numpy as np

from tmmcalc.linkage.dyadstate import DyadState, DyadTask, Port
from tmmcalc.linkage.pictures.plans import scale_note
from tmmcalc.report.drawing import signs
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.field import Board
from tmmcalc.report.drawing.lettering import minus, point_name
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.page import sheets
from tmmcalc.report.drawing.pens import AXIS, THICK, THIN, Pen
from tmmcalc.report.drawing.scales import length_scale, scale_text
from tmmcalc.report.drawing.shapes import Drawing, Words
from tmmcalc.report.language import tr, tr_unit
from tmmcalc.report.numbers import number, round_scale

LONGEST = 0.35  # of the size of the dyad: the longest vector
SHORT = 1e-9  # a vector shorter than this, against the longest, is not drawn
BEYOND = 0.12  # of the size: how far a line is drawn beyond its slider
HEAD = 3.0  # length of an arrowhead [mm]
MARGIN = 9.0  # free border [mm]
KINDS = (
    ("v", Pen("VECTORS_VELOCITY", 0.5, (), "#0072b2")),
    ("a", Pen("VECTORS_ACCELERATION", 0.5, (), "#d55e00")),
)
Segment = tuple[complex, complex]


class _Parts(NamedTuple):
    """What is drawn of a dyad [m]."""

    bars: Mapping[str, tuple[Segment, ...]]  # of link a and of link b
    lines: tuple[tuple[complex, complex, float], ...]  # through a point along a direction, to this coordinate
    blocks: tuple[tuple[complex, complex], ...]  # sliders with the directions of their lines
    pins: tuple[complex, ...]


class _Moving(NamedTuple):
    """A point with its velocity and its acceleration."""

    name: str
    at: complex
    vectors: tuple[complex, complex]


def figure(order: Order) -> Drawing:
    """The drawing of the stage."""
    from tmmcalc.linkage.tables.tasks.dyad import to_dyad

    return dyad_drawing(to_dyad(order.spec), order.results["dyad"])


def dyad_drawing(task: DyadTask, result: DyadState) -> Drawing:
    """One sheet: velocities on the left, accelerations on the right, angular ones below."""
    drawing, (box,) = sheets(1)
    title = tr("Dyad {kind}", kind=result.kind)
    if result.variant is not None:
        title = tr("Dyad {kind}, variant {variant}", kind=result.kind, variant=minus(f"{result.variant:+d}"))
    drawing.add(Words(complex(box.middle.real, box.top), title, 3.5, 1j))
    for order, part in enumerate(box.inset(0, 0, 0, 7).split(1, 1, gap=4, across=True)):
        draw_dyad(drawing, part, task, result, order)
    return drawing


def draw_dyad(
    drawing: Drawing,
    box: Box,
    task: DyadTask,
    result: DyadState,
    order: int,
    names: Mapping[str, str] = MappingProxyType({}),
) -> None:
    """The dyad to scale with its velocities (order 0) or its accelerations (order 1).

    ``names`` are other ones of the joints first, inner and second.
    """
    letter, pen = KINDS[order]
    parts, moving = _parts(task, result), _moving(task, result)
    content = np.array([*(end for bars in parts.bars.values() for bar in bars for end in bar), *(p.at for p in moving)])
    size = float(max(np.ptp(content.real), np.ptp(content.imag)))
    longest = max(abs(point.vectors[order]) for point in moving)
    scale = round_scale(longest / (LONGEST * size))  # of the vectors, their unit to a metre
    lines = [(q - BEYOND * size * e, q + (max(s, 0.0) + BEYOND * size) * e) for q, e, s in parts.lines]
    lines = [(q + (min(s, 0.0) * e), end) for (q, end), (_, e, s) in zip(lines, parts.lines, strict=True)]
    tips = [point.at + point.vectors[order] / scale for point in moving]
    content = np.array([*content, *tips, *(end for line in lines for end in line)])
    board = Board(drawing, box.inset(0, 7, 0, 6), content, MARGIN, scale=length_scale)
    for line in lines:
        board.line(line, AXIS, level=signs.GUIDE)
    for at, e in parts.blocks:
        signs.block(board, at, e)
    for mark in task.points:
        at = next(point.at for point in moving if point.name == mark.name)
        start, end = max(parts.bars[mark.link], key=lambda bar: abs(bar[1] - bar[0]))
        board.line((start, at, end), THIN, level=signs.GUIDE)
    for bars in parts.bars.values():
        for bar in bars:
            board.line(bar, THICK, level=signs.LINK)
    for at in parts.pins:
        signs.pin(board, at)
    for point, tip in zip(moving, tips, strict=True):
        if abs(point.vectors[order]) > SHORT * longest:
            board.vector(point.at, tip, pen, HEAD, level=13)
        if not any(abs(point.at - pin) < SHORT * size for pin in parts.pins):
            board.dot(point.at, level=signs.PINS)
    for point in moving:
        board.labels.put(
            point_name(names.get(point.name, point.name)), board.paper([point.at]), gaps=(1.4, 2.2, 3.2, 4.5)
        )
    for link, bars in parts.bars.items():
        if bars:
            start, end = max(bars, key=lambda bar: abs(bar[1] - bar[0]))
            middle = board.paper([start + t * (end - start) for t in (0.5, 0.4, 0.6, 0.3, 0.7)])
            board.labels.put(link, middle, height=1.8, ring=True, gaps=(0.8, 1.6, 2.6, 3.8))
    frame = board.box
    corners = [complex(frame.left, frame.bottom), complex(frame.right, frame.bottom)]
    corners += [complex(frame.right, frame.top), complex(frame.left, frame.top)]
    drawing.line(corners, THIN, closed=True)
    title = tr("Velocities") if letter == "v" else tr("Accelerations")
    named = scale_note(letter, scale * board.mu) if longest else tr("none")
    text = f"{title}, {named},  {scale_text(board.mu)}"
    drawing.add(Words(complex(box.middle.real, box.top), text, 2.8, 1j))
    drawing.add(Words(complex(box.middle.real, box.bottom), _turning(result, order), 2.5, -1j))


def _turning(result: DyadState, order: int) -> str:
    """Angular velocities or accelerations of both links, in words."""
    sign, unit = (("ω", "rad/s"), ("ε", "rad/s²"))[order]
    values = [(link.link, (link.omega, link.eps)[order]) for link in result.links]
    return ",   ".join(f"${sign}_{name}$ = {minus(number(value, 6))} {tr_unit(unit)}" for name, value in values)


def _moving(task: DyadTask, result: DyadState) -> list[_Moving]:
    """The outer joints, the inner pin, the points that are asked for."""
    outer = [_port(name, port) for name, port in (("first", task.first), ("second", task.second))]
    return outer + [
        _Moving(each.point, complex(each.x, each.y), (complex(each.vx, each.vy), complex(each.ax, each.ay)))
        for each in result.points
    ]


def _port(name: str, port: Port) -> _Moving:
    return _Moving(name, complex(*port.point), (complex(*port.velocity), complex(*port.acceleration)))


def _parts(task: DyadTask, result: DyadState) -> _Parts:
    """Bars, lines, blocks and pins of each kind, as the figures of `tmmcalc.linkage.dyads` show them."""
    first, second = complex(*task.first.point), complex(*task.second.point)
    e1, e2 = cmath.rect(1, task.first.angle), cmath.rect(1, task.second.angle)
    inner = next((complex(each.x, each.y) for each in result.points if each.point == "inner"), 0j)
    s = [slide.s for slide in result.slides]
    bars: dict[str, tuple[Segment, ...]]
    if task.kind == "RRR":
        bars = {"a": ((first, inner),), "b": ((second, inner),)}
        parts = _Parts(bars, (), (), (first, second, inner))
    elif task.kind == "RRP":
        foot = second + s[0] * e2
        bars = {"a": ((first, inner),), "b": ((foot, inner),)}
        parts = _Parts(bars, ((second, e2, s[0]),), ((foot, e2),), (first, inner))
    elif task.kind == "RPR":
        along = cmath.rect(1, result.links[1].angle)
        foot = second + s[0] * along
        bars = {"a": ((foot, first),), "b": ((second, foot),)}
        parts = _Parts(bars, ((second, along, s[0]),), ((foot, along),), (first, second))
    elif task.kind == "PRP":
        foot, other = first + s[0] * e1, second + s[1] * e2
        bars = {"a": ((foot, inner),), "b": ((other, inner),)}
        lines = ((first, e1, s[0]), (second, e2, s[1]))
        parts = _Parts(bars, lines, ((foot, e1), (other, e2)), (inner,))
    else:
        along = e2 * cmath.rect(1, task.turn)
        foot = second + s[1] * e2
        start = foot + 1j * task.offset_b * e2
        end = start + s[0] * along
        bars = {"a": ((end, first),), "b": ((foot, start), (start, end))}
        lines = ((second, e2, s[1]), (start, along, s[0]))
        parts = _Parts(bars, lines, ((foot, e2), (end, along)), (first,))
    return parts
