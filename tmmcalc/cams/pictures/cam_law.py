"""The picture of the law of motion: displacement and its derivatives over the turn, and the phase portrait S'(S)."""

from __future__ import annotations

from collections.abc import Sequence
from math import degrees
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, MaxNLocator

from tmmcalc.cams.lawresult import POINTS, LawResult
from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.pictures.ordered import cam_of
from tmmcalc.cams.program import Program
from tmmcalc.cams.task import CamTask
from tmmcalc.report.drawing.curves import bottom, frame, mark
from tmmcalc.report.drawing.labels import MM, Labels, half_size, signed
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.page import blank, settle
from tmmcalc.report.drawing.style import CURVES, INK, MARK
from tmmcalc.report.numbers import number

DENSE = 120  # points of a piece of the motion
DOTTED = 72  # more positions than this are not marked one by one
JUMP: dict[str, Any] = {"color": "#6b6b6b", "linewidth": 0.8, "linestyle": (0, (2, 2)), "zorder": 3}
JUMP_ON_FRAME = {**JUMP, "color": "white", "linewidth": 1.2, "zorder": 6, "clip_on": False}  # gaps in the frame's line
ARROW: dict[str, Any] = {"arrowstyle": "<->", "linewidth": 0.7, "color": MARK, "shrinkA": 0, "shrinkB": 0}
HEADROOM = 1.55  # of the stroke, for the names of the phases
NAME_SIZE, BETWEEN = 7.0, 2.5  # of the names of the phases; least between two of them [mm]
STEPS: dict[str, Any] = {"color": "#b8b8b8", "linewidth": 0.6, "zorder": 1}


def figure(order: Order) -> Figure:
    """The figure of the stage."""
    return law_figure(cam_of(order), order.results["cam_law"])


def law_figure(task: CamTask, result: LawResult) -> Figure:
    """One sheet."""
    figure, (sheet,) = blank(1)
    sheet.suptitle(_heading(result), fontsize=10)
    left, right = sheet.subfigures(1, 2, width_ratios=[1.55, 1.0], squeeze=False)[0]
    panels = left.subplots(4, 1, height_ratios=[1.2, 1, 1, 0.9]).tolist()
    portrait = right.subplots()
    pieces = _pieces(task.program)
    name, unit, factor = _units(result)
    for order, axes in enumerate(panels):
        _draw(axes, order, pieces, result, f"${_symbol(name, order)}${unit if order == 0 else _derived(result, order)}")
    bottom(panels, True)
    _draw_portrait(portrait, pieces, result, name)
    settle(figure)
    for order, axes in enumerate(panels):
        _name(axes, order, pieces, result, factor)
    _name_phases(panels[0], result)
    _name_portrait(portrait, result)
    return figure


def _heading(result: LawResult) -> str:
    laws = [f"{each.kind}: {each.constants.name}" for each in result.phases if each.constants is not None]
    speed = "" if result.speed is None else f", {number(result.speed * 30 / np.pi, 5)} rpm"
    size = f"{number(degrees(result.stroke), 5)}°" if result.turns else f"{number(1e3 * result.stroke, 5)} mm"
    symbol = r"\psi_\mathrm{m}" if result.turns else "h"
    return f"Law of motion of the follower, ${symbol}$ = {size}{speed}; {', '.join(laws)}"


def _units(result: LawResult) -> tuple[str, str, float]:
    return (r"\psi", ", °", 180 / np.pi) if result.turns else ("S", ", mm", 1e3)


def _derived(result: LawResult, order: int) -> str:
    """The unit after a derivative by the angle of the cam; that of an angle by an angle has none."""
    if not result.turns:
        return ", mm"
    return "" if order == 1 else ", 1/rad" if order == 2 else ", 1/rad²"


def _symbol(name: str, order: int) -> str:
    return rf"\Delta {name}" if order == 0 else name + "'" * order


def _pieces(program: Program) -> list[tuple[Values, Values]]:
    """Angles (m,) and the motion (4, m) of every piece, up to both its ends."""
    found = []
    for number_of, (low, high) in enumerate(zip(program.edges[:-1], program.edges[1:], strict=True)):
        phi = np.linspace(low, high, DENSE)
        found.append((phi, program.at(phi, np.full(DENSE, number_of))))
    return found


def _scale(result: LawResult, order: int) -> float:
    return _units(result)[2] if order == 0 else 1.0 if result.turns else 1e3


def _draw(axes: Axes, order: int, pieces: list[tuple[Values, Values]], result: LawResult, label: str) -> None:
    factor, style = _scale(result, order), CURVES[order]
    largest = max(float(np.max(np.abs(motion[order]))) for _, motion in pieces)
    for phi, motion in pieces:
        axes.plot(np.degrees(phi), factor * motion[order], linewidth=1.3, zorder=4, color=style["color"])
    for (_, before), (phi, after) in zip(pieces, [*pieces[1:], pieces[0]], strict=True):
        ends = factor * np.array([before[order, -1], after[order, 0]])
        place = degrees(phi[0]) if phi[0] else degrees(pieces[-1][0][-1])
        if order and abs(ends[1] - ends[0]) > 1e-9 * largest * factor:
            for at in (place,) if phi[0] else (0.0, place):
                axes.plot([at, at], ends, **(JUMP if phi[0] else JUMP_ON_FRAME))
    rows = result.positions
    if len(rows.phi) <= DOTTED:
        dots = {"markersize": 2.2, "color": style["color"], "zorder": 5, "linestyle": ""}
        axes.plot(np.degrees(rows.phi), factor * result.motion[order], "o", **dots)
    for phase in result.phases:
        axes.axvline(degrees(phase.begin), **STEPS)
    whole = np.degrees([0.0, pieces[-1][0][-1]])
    frame(axes, label, whole, True, 25)
    if order == 0:
        axes.set_ylim(-0.25 * factor * result.stroke, HEADROOM * factor * result.stroke)


def _name(axes: Axes, order: int, pieces: list[tuple[Values, Values]], result: LawResult, factor: float) -> None:
    """The extremes and, above the first diagram, the points a, b, c, d with the angles of the phases."""
    labels, scale = Labels(axes), _scale(result, order)
    for phi, motion in pieces:
        labels.avoid(np.degrees(phi) + 1j * scale * motion[order], 0.7)
    if order:
        for each in result.extremes:
            if each.order == order:
                mark(axes, labels, complex(degrees(each.phi), scale * each.value), CURVES[order])
        return
    names = _points(result)
    for phase in result.phases:
        at = complex(degrees(phase.begin), factor * phase.low)
        axes.plot(at.real, at.imag, "o", markersize=4, markerfacecolor="white", color=INK, zorder=7, clip_on=False)
        labels.put(names[phase.kind], [at], size=9, prefer=1 + 1j if phase.low else -1 - 1j, style="italic")
    top, place = factor * result.stroke, degrees(result.phases[0].end)
    axes.annotate("", (place, top), (place, 0.0), arrowprops=ARROW)
    symbol = r"$\psi_\mathrm{m}$" if result.turns else "$h$"
    labels.put(symbol, [complex(place, 0.35 * top)], prefer=1 + 0j, color=MARK)


def _name_phases(axes: Axes, result: LawResult) -> None:
    """The names of the phases with their angles in a row above the first diagram."""
    texts = [(phase.kind, f"{number(degrees(phase.end - phase.begin), 5)}°") for phase in result.phases]
    halves = [max(half_size(line, NAME_SIZE)[0] for line in lines) for lines in texts]
    low, high = axes.get_xlim()
    to_mm = axes.get_window_extent().width * MM / axes.figure.dpi / (high - low)
    middles = [(degrees(phase.begin + phase.end) / 2 - low) * to_mm for phase in result.phases]
    for lines, at in zip(texts, spread(middles, halves, (high - low) * to_mm), strict=True):
        style: dict[str, Any] = {"ha": "center", "va": "top", "transform": axes.get_xaxis_transform()}
        axes.text(low + at / to_mm, 0.97, "\n".join(lines), size=NAME_SIZE, **style)


def spread(middles: Sequence[float], halves: Sequence[float], end: float) -> list[float]:
    """Middles of texts in a row from 0 to ``end`` [mm], moved as little to the sides as keeps them apart.

    >>> spread([2.0, 3.0, 50.0], [4.0, 4.0, 10.0], 60.0)
    [4.0, 14.5, 50.0]
    """
    found, free = [], 0.0
    for middle, half in zip(middles, halves, strict=True):
        found.append(max(middle, free + half))
        free = found[-1] + half + BETWEEN
    free = end
    for k in reversed(range(len(found))):
        found[k] = min(found[k], free - halves[k])
        free = found[k] - halves[k] - BETWEEN
    return found


def _points(result: LawResult) -> dict[str, str]:
    """The names of the points at which the phases begin; two names where a dwell takes no angle."""
    kinds = [phase.kind for phase in result.phases]
    names: dict[str, str] = dict(POINTS)
    if "high dwell" not in kinds:
        names["return"] = "b, c"
    if "low dwell" not in kinds:
        names["rise"] = "a, d"
    return names


def _draw_portrait(axes: Axes, pieces: list[tuple[Values, Values]], result: LawResult, name: str) -> None:
    """S' against S in one unit, of a rocker radians: rise above, return below."""
    scale = _scale(result, 1)
    for phi, motion in pieces:
        rising = motion[1, len(phi) // 2] >= 0
        axes.plot(scale * motion[0], scale * motion[1], **{**CURVES[0 if rising else 1], "linewidth": 1.4, "zorder": 4})
    if len(result.positions.phi) <= DOTTED:
        axes.plot(scale * result.motion[0], scale * result.motion[1], "o", markersize=2.4, color=INK, zorder=5)
    axes.axhline(0, color="#333333", linewidth=0.8, zorder=1.5)
    axes.axvline(0, color="#333333", linewidth=0.8, zorder=1.5)
    axes.grid(True, linewidth=0.35, color="#d0d0d0", zorder=0)
    axes.set_axisbelow(True)
    axes.margins(0.12)
    if not result.turns:
        axes.set_aspect("equal", adjustable="datalim")  # an angle of a ray is a pressure angle then
    axes.set_xlabel(f"${_symbol(name, 0)}$, {'rad' if result.turns else 'mm'}")
    axes.set_ylabel(f"${_symbol(name, 1)}${_derived(result, 1)}")
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_locator(MaxNLocator(8))
        axis.set_major_formatter(FuncFormatter(lambda v, _: signed(v, 6)))
    axes.set_title(f"Phase portrait ${_symbol(name, 1)}({_symbol(name, 0)})$")


def _name_portrait(axes: Axes, result: LawResult) -> None:
    labels = Labels(axes)
    scale = _scale(result, 1)
    for each in result.extremes:
        if each.order == 1:
            row = int(np.argmin(np.abs(result.positions.phi - each.phi)))
            at = scale * complex(result.motion[0, row], each.value)
            labels.put(signed(scale * each.value, 4), [at], size=7, prefer=1j * each.value)
    for name, end in (("a, d", 0.0), ("b, c", scale * result.stroke)):
        axes.plot(end, 0.0, "o", markersize=4, markerfacecolor="white", color=INK, zorder=7)
        labels.put(name, [complex(end, 0.0)], size=9, prefer=1 + 1j if end else -1 - 1j, style="italic")
