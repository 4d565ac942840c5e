"""The picture of a dyad by itself: its links and joints to scale, with velocities, and with accelerations."""

from __future__ import annotations

import cmath
from collections.abc import Mapping
from typing import NamedTuple

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from tmmcalc.linkage.dyadstate import DyadState, DyadTask, Port
from tmmcalc.report.drawing import symbols
from tmmcalc.report.drawing.board import Board
from tmmcalc.report.drawing.labels import signed
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.page import blank, settle
from tmmcalc.report.drawing.style import INK, MARGIN, MARK, PATH, THIN
from tmmcalc.report.numbers import number, round_scale

LONGEST = 0.35  # of the size of the dyad: the longest vector
SHORT = 1e-9  # a vector shorter than this, against the longest, is not drawn
BEYOND = 0.12  # of the size: how far a line is drawn beyond its slider
HEAD = 2.6  # length of an arrowhead [mm]
KINDS = (("Velocities", "v", "m/s", PATH), ("Accelerations", "a", "m/s²", MARK))
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


def figure(order: Order) -> Figure:
    """The figure of the stage."""
    from tmmcalc.linkage.tables.tasks.dyad import to_dyad

    return dyad_figure(to_dyad(order.spec), order.results["dyad"])


def dyad_figure(task: DyadTask, result: DyadState) -> Figure:
    """One sheet: velocities on the left, accelerations on the right, angular ones below."""
    figure, (sheet,) = blank(1)
    variant = "" if result.variant is None else f", variant {result.variant:+d}".replace("-", "\N{MINUS SIGN}")
    sheet.suptitle(f"Dyad {result.kind}{variant}", fontsize=10)
    panels = sheet.subplots(1, 2).tolist()
    for axes, (title, *_) in zip(panels, KINDS, strict=True):
        axes.set_title(f"{title}\nscale")
        axes.set_xlabel("omega")
    settle(figure)
    for order, axes in enumerate(panels):
        _draw(axes, task, result, order)
    return figure


def _draw(axes: Axes, task: DyadTask, result: DyadState, order: int) -> None:
    title, letter, unit, colour = KINDS[order]
    parts, moving = _parts(task, result), _moving(task, result)
    content = np.array([*(end for bars in parts.bars.values() for bar in bars for end in bar), *(p.at for p in moving)])
    size = float(max(np.ptp(content.real), np.ptp(content.imag)))
    longest = max(abs(point.vectors[order]) for point in moving)
    scale = round_scale(longest / (LONGEST * size))  # of the vectors, their unit to a metre
    lines = [(q - BEYOND * size * e, q + (max(s, 0.0) + BEYOND * size) * e) for q, e, s in parts.lines]
    lines = [(q + (min(s, 0.0) * e), end) for (q, end), (_, e, s) in zip(lines, parts.lines, strict=True)]
    tips = [point.at + point.vectors[order] / scale for point in moving]
    board = Board(axes, np.array([*content, *tips, *(end for line in lines for end in line)]), MARGIN)
    for line in lines:
        board.line(line, color=THIN, linewidth=0.9, linestyle=(0, (8, 2, 1, 2)), zorder=symbols.Z_GUIDE)
    for at, e in parts.blocks:
        symbols.block(board, at, e)
    for mark in task.points:
        at = next(point.at for point in moving if point.name == mark.name)
        start, end = max(parts.bars[mark.link], key=lambda bar: abs(bar[1] - bar[0]))
        board.line((start, at, end), color=THIN, linewidth=0.7, zorder=symbols.Z_GUIDE)
    for bars in parts.bars.values():
        for bar in bars:
            board.line(bar, linewidth=2.0, zorder=symbols.Z_LINK)
    for at in parts.pins:
        symbols.pin(board, at)
    for point, tip in zip(moving, tips, strict=True):
        if abs(point.vectors[order]) > SHORT * longest:
            along = (tip - point.at) / abs(tip - point.at)
            head = min(HEAD, 0.45 * abs(tip - point.at) / board.mu)
            board.line((point.at, tip - 0.8 * head * board.mu * along), color=colour, linewidth=1.4, zorder=13)
            board.arrowhead(tip, along, head, facecolor=colour, zorder=14)
        if not any(abs(point.at - pin) < SHORT * size for pin in parts.pins):
            board.circle(point.at, 0.55, facecolor=INK, zorder=symbols.Z_PIN)
    for point in moving:
        board.labels.put(point.name, [point.at], size=8.0, style="italic", gaps=(1.8, 2.7, 3.8, 5.0))
    for link, bars in parts.bars.items():
        if bars:
            start, end = max(bars, key=lambda bar: abs(bar[1] - bar[0]))
            middle = [start + t * (end - start) for t in (0.5, 0.4, 0.6, 0.3, 0.7)]
            board.labels.put(link, middle, size=7.0, ring=True, gaps=(0.8, 1.6, 2.6, 3.8))
    axes.set_xticks([])
    axes.set_yticks([])
    named = f"$\\mu_{letter}$ = {number(scale * board.mu, 4)} ({unit})/mm" if longest else "none"
    axes.set_title(f"{title}, {named},  $\\mu_l$ = {number(board.mu, 4)} m/mm")
    axes.set_xlabel(_turning(result, order))


def _turning(result: DyadState, order: int) -> str:
    """Angular velocities or accelerations of both links, in words."""
    sign, unit = (("\\omega", "rad/s"), ("\\varepsilon", "rad/s²"))[order]
    values = [(link.link, (link.omega, link.eps)[order]) for link in result.links]
    return ",   ".join(f"${sign}_{name}$ = {signed(value, 6)} {unit}" for name, value in values)


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
