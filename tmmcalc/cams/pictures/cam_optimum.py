"""The picture of the optimal design: blocking contours in the plane of S0 and r2, and N1 and sigma_H along r2.

Numbers in circles are those of the textbook's table 5.5; the filled region keeps all constraints at its height H2.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure, SubFigure
from matplotlib.ticker import FuncFormatter, MaxNLocator

from tmmcalc.cams.optimum.margins import NUMBERS
from tmmcalc.cams.optimum.results import NAMES, CamOptimum, Choice, Contour, FlatChart, Section
from tmmcalc.cams.pictures.ordered import cam_of
from tmmcalc.cams.task import CamTask
from tmmcalc.report.drawing.key import Part, Sample, write_key
from tmmcalc.report.drawing.labels import Labels, signed
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.page import blank, settle
from tmmcalc.report.drawing.style import CURVES, INK, MARK
from tmmcalc.report.numbers import number

STYLES: dict[int, dict[str, Any]] = dict(zip(NUMBERS, CURVES, strict=True))
STYLES |= {10: STYLES[7], 11: STYLES[8]}  # of a rocker, which has neither stem nor guide
REGION: dict[str, Any] = {"facecolor": "#dfeaf4"}
BORDER: dict[str, Any] = {"color": INK, "linewidth": 2.0, "zorder": 6}
CHOSEN: dict[str, Any] = {"color": MARK, "marker": "o", "markersize": 6.5, "markeredgecolor": INK, "linestyle": ""}
LEAST: dict[str, Any] = {"color": INK, "marker": "D", "markersize": 5.0, "linestyle": ""}
OTHER: dict[str, Any] = {"color": "white", "marker": "o", "markersize": 4.5, "markeredgecolor": INK, "linestyle": ""}
CORNER: dict[str, Any] = {"color": INK, "marker": "o", "markersize": 3.0, "linestyle": ""}
APART = (2.0, 3.0, 4.5)  # of a text from its line [mm]
SAME = 1e-9  # of a limit: a value at it
TRIED = 14  # places of a curve that its number tries


def figure(order: Order) -> Figure:
    """The figure of the stage."""
    return optimum_figure(cam_of(order), order.results["cam_optimum"])


def optimum_figure(task: CamTask, result: CamOptimum) -> Figure:
    """A sheet for every contour, one for the section along r2; of a flat-faced follower the chart of H2 and S0."""
    sheets: list[Callable[[SubFigure], Callable[[], None]]] = []
    if result.flat is not None:
        sheets.append(partial(_chart_sheet, result=result, chart=result.flat))
    sheets += [partial(_contour_sheet, result=result, contour=contour) for contour in result.contours]
    if result.section is not None:
        sheets.append(partial(_section_sheet, result=result, section=result.section))
    figure, blanks = blank(len(sheets))
    finish = [draw(sheet) for draw, sheet in zip(sheets, blanks, strict=True)]
    settle(figure)
    for each in finish:
        each()
    return figure


def _axes(axes: Axes, x: str, y: str) -> None:
    axes.set_xlabel(x)
    axes.set_ylabel(y)
    axes.grid(True, linewidth=0.35, color="#d0d0d0", zorder=0)
    axes.set_axisbelow(True)
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_locator(MaxNLocator(9))
        axis.set_major_formatter(FuncFormatter(lambda v, _: signed(v, 6)))


def _option(result: CamOptimum) -> str:
    """What a heading adds where as asked there is no mechanism."""
    return f"; {', '.join(result.shown)}" if result.shown else ""


def _typeset(result: CamOptimum, name: str) -> str:
    """A size of the kind of follower as it is typeset."""
    size = result.names[name]
    return f"${size[0]}_{size[1:]}$"


def _contour_sheet(sheet: SubFigure, result: CamOptimum, contour: Contour) -> Callable[[], None]:
    height = number(1e3 * contour.height, 6)
    also = f", $e$ = {signed(1e3 * (result.offset or 0.0), 6)} mm"
    if result.kind == "oscillating":
        also = f", $l_2$ = {number(1e3 * result.chosen.length, 6)} mm"
    sheet.suptitle(
        f"Blocking contour at {_typeset(result, 'height')} = {height} mm{also}{_option(result)}", fontsize=10
    )
    left, right = sheet.subfigures(1, 2, squeeze=False, width_ratios=[1.75, 1.0])[0]
    plane, key = left.subplots(), right.subplots()
    key.set_axis_off()
    low, high, bottom, top = (1e3 * v for v in contour.window)
    plane.set_xlim(low, high)
    plane.set_ylim(bottom, top)
    across = "base circle $R_0$, mm" if result.kind == "oscillating" else "start distance $S_0$, mm"
    _axes(plane, across, "roller radius $r_2$, mm")
    lowest = abs(contour.height - result.chosen.height) < 1e-9

    def finish() -> None:
        seen = _draw_plane(plane, result, contour, lowest)
        write_key(key, list(_contour_key(result, contour, seen, lowest)))

    return finish


def _draw_plane(axes: Axes, result: CamOptimum, contour: Contour, lowest: bool) -> list[int]:
    """Region, curves with their numbers, points; the constraints that are seen."""
    labels = Labels(axes)
    for outline in contour.outlines:
        face = REGION if outline.area > 0 else {"facecolor": "white"}
        axes.fill(1e3 * outline.start, 1e3 * outline.roller, zorder=1, **face)
        axes.plot(1e3 * outline.start, 1e3 * outline.roller, **BORDER)
        labels.avoid(1e3 * (outline.start + 1j * outline.roller), 1.0)
        for corner in outline.corners:
            axes.plot(1e3 * corner.start, 1e3 * corner.roller, zorder=7, **CORNER)
    for curve in contour.curves:
        z = 1e3 * (curve.start + 1j * curve.roller)
        axes.plot(z.real, z.imag, linewidth=1.2, zorder=4, **STYLES[curve.number])
        labels.avoid(z, 1.0)
    _points(axes, labels, result, lowest)
    seen = sorted({curve.number for curve in contour.curves})
    for key in seen:
        longest = max(
            (c for c in contour.curves if c.number == key), key=lambda c: float(np.ptp(c.start) + np.ptp(c.roller))
        )
        places = 1e3 * (longest.start + 1j * longest.roller)
        tried = places[np.linspace(0, len(places) - 1, TRIED + 2).astype(int)[1:-1]]
        labels.put(str(key), tried, size=7.5, ring=True, gaps=(1.6, 2.4, 3.4), color=STYLES[key]["color"])
    return seen


def _points(axes: Axes, labels: Labels, result: CamOptimum, lowest: bool) -> None:
    chosen = complex(result.chosen.start, result.chosen.roller) * 1e3
    if lowest:
        rows = np.flatnonzero(_beside(result))[1:]
        for start, roller in zip(1e3 * result.start[rows], 1e3 * result.roller[rows], strict=True):
            axes.plot(start, roller, zorder=9, **OTHER)
            labels.avoid([complex(start, roller)], 3.0)
    axes.plot(chosen.real, chosen.imag, zorder=11, **CHOSEN)
    labels.avoid([chosen], 3.0)
    if result.kind != "oscillating":
        least = complex(result.least.start, result.least.roller) * 1e3
        axes.plot(least.real, least.imag, zorder=10, **LEAST)
        labels.avoid([least], 3.0)
    text = f"({number(chosen.real, 6)}; {number(chosen.imag, 6)})"
    labels.put(text, [chosen], size=7.5, gaps=(1.8, 2.8, 4.0))


def _beside(result: CamOptimum) -> np.ndarray[Any, np.dtype[np.bool_]]:
    """Which step points (n,) stand in the plane of the contour: those with the rocker of the best one."""
    if result.length is None:
        return np.ones(len(result.start), bool)
    found: np.ndarray[Any, np.dtype[np.bool_]] = result.length == result.length[0]
    return found


def _contour_key(result: CamOptimum, contour: Contour, seen: list[int], lowest: bool) -> Iterator[Part]:
    curves = [Sample(f"{key}  {NAMES[key]}", {"linewidth": 1.4, **STYLES[key]}) for key in seen]
    yield Part("Curves", samples=[*curves, Sample("all constraints are kept", dict(REGION), fill=True)])
    corners = [corner for outline in contour.outlines for corner in outline.corners]
    if corners:
        rows = [
            (" and ".join(map(str, corner.numbers)), f"({1e3 * corner.start:.4f}; {1e3 * corner.roller:.4f})")
            for corner in corners
        ]
        yield Part(f"Corners ({_typeset(result, 'start')}; $r_2$), mm", rows)
    chosen, size = result.chosen, _typeset(result, "height")
    best, mark = ("smallest", "") if result.kind == "oscillating" else ("lowest", "diamond: ")
    sizes = [
        (f"circle: {best} in whole steps", f"{size} = {number(1e3 * chosen.height, 6)} mm"),
        (f"{mark}{best} of any sizes", f"{size} = {number(1e3 * result.least.height, 7)} mm"),
    ]
    others = int(np.count_nonzero(_beside(result))) - 1
    if lowest and others:
        sizes.append(("small circles: other feasible steps", str(others)))
    yield Part("Points", sizes)
    where = "" if result.kind == "oscillating" else " at its height"
    yield Part(f"Margins of the circle{where}", list(_margins(chosen)))


def _margins(chosen: Choice) -> Iterator[tuple[str, str]]:
    for each in chosen.checks:
        text = f"{100 * each.margin:.1f} %" if each.judged else "not judged"
        yield f"{each.number}  {each.name}", text.replace("-", "\N{MINUS SIGN}")


def _section_sheet(sheet: SubFigure, result: CamOptimum, section: Section) -> Callable[[], None]:
    start, height = number(1e3 * section.start, 6), number(1e3 * section.height, 6)
    sheet.suptitle(f"Along the roller radius at $S_0$ = {start} mm, $H_2$ = {height} mm{_option(result)}", fontsize=10)
    upper, lower = sheet.subplots(2, 1, sharex=True)
    roller, chosen = 1e3 * section.roller, result.chosen.roller
    upper.set_xlim(0.0, float(roller[-1]) if len(roller) else 1.0)
    courses = (
        (upper, section.edge, section.edge_limit, 1.0, "largest $|N_1|$, N", 8, "$[N_1]$ = {} N"),
        (lower, section.stress, section.stress_limit, 1e-6, "largest $\\sigma_H$, MPa", 9, "$[\\sigma_H]$ = {} MPa"),
    )
    for axes, values, limit, factor, name, key, _ in courses:
        _axes(axes, "", name)
        axes.plot(roller, factor * values, linewidth=1.5, zorder=4, **{**STYLES[key], "linestyle": "-"})
        top = factor * max(limit or 0.0, float(np.interp(chosen, section.roller, values)))
        axes.set_ylim(0.0, 2.0 * top if top > 0 else None)
        axes.axvline(1e3 * chosen, color=MARK, linewidth=0.9, linestyle=(0, (6, 2)), zorder=3)
        if limit is not None:
            axes.axhline(factor * limit, color=INK, linewidth=1.1, linestyle=(0, (6, 2)), zorder=3)
            good = values <= limit * (1 + SAME)  # the radii at which it is passed are among the points
            axes.fill_between(roller, 0, factor * values, where=good.tolist(), color=REGION["facecolor"], zorder=1)
    lower.set_xlabel("roller radius $r_2$, mm")

    def finish() -> None:
        for axes, values, limit, factor, _, _, said in courses:
            labels = Labels(axes)
            labels.avoid(roller + 1j * factor * values, 1.0)
            labels.avoid([complex(1e3 * chosen, y) for y in axes.get_ylim()], 1.0)
            at = complex(1e3 * chosen, factor * float(np.interp(chosen, section.roller, values)))
            axes.plot(at.real, at.imag, zorder=8, **CHOSEN)
            labels.put(number(at.imag, 5), [at], size=7.5, gaps=(1.8, 2.8, 4.0), color=MARK)
            if limit is not None:
                end = complex(0.93 * axes.get_xlim()[1], factor * limit)
                labels.put(said.format(number(factor * limit, 5)), [end], size=7.5, prefer=1j)
                for x in _crossings(section.roller, values - limit):
                    axes.plot(1e3 * x, factor * limit, zorder=8, **CORNER)
                    text = f"$r_2$ = {number(1e3 * x, 4)}"
                    labels.put(text, [complex(1e3 * x, factor * limit)], size=7.5, gaps=(1.6, 2.6, 3.8))

    return finish


def _crossings(x: Any, excess: Any) -> list[float]:
    """Where a sampled function passes 0, to what a picture shows."""
    rows = np.flatnonzero(np.signbit(excess[1:]) != np.signbit(excess[:-1]))
    part = excess[rows] / (excess[rows] - excess[rows + 1])
    return [float(v) for v in x[rows] + part * (x[rows + 1] - x[rows])]


def _chart_sheet(sheet: SubFigure, result: CamOptimum, chart: FlatChart) -> Callable[[], None]:
    sheet.suptitle(f"Flat face: admissible start distances by the height (fig. 5.37){_option(result)}", fontsize=10)
    left, right = sheet.subfigures(1, 2, squeeze=False, width_ratios=[1.75, 1.0])[0]
    plane, key = left.subplots(), right.subplots()
    key.set_axis_off()
    low, base = 1e3 * chart.least_height, 1e3 * (chart.stroke + chart.gap + chart.least_length)
    start, span = 1e3 * chart.least_start, 0.35 * 1e3 * chart.least_height
    ends = np.array([low - span, low + span])
    plane.set_xlim(*ends)
    plane.set_ylim(max(start - span, 0.0), start + span)
    _axes(plane, "height $H_2$, mm", "start distance $S_0$, mm")
    plane.fill([low, ends[1], ends[1]], [start, start, ends[1] - base], zorder=1, **REGION)
    plane.axhline(start, linewidth=1.5, zorder=4, **CURVES[1])
    plane.plot(ends, ends - base, linewidth=1.5, zorder=4, **CURVES[0])

    def finish() -> None:
        labels = Labels(plane)
        labels.avoid(ends + 1j * (ends - base), 1.0)
        labels.avoid(ends + 1j * start, 1.0)
        chosen = complex(result.chosen.height, result.chosen.start) * 1e3
        plane.plot(chosen.real, chosen.imag, zorder=11, **CHOSEN)
        plane.plot(low, start, zorder=10, **LEAST)
        labels.put(f"$S_0$ = {number(start, 6)}", [complex(low - 0.7 * span, start)], prefer=1j, gaps=APART)
        labels.put(
            "$S_0 = H_2 - h - l^*$", [complex(low + 0.6 * span, low + 0.6 * span - base)], prefer=-1 + 1j, gaps=APART
        )
        labels.put(f"$H_2$ = {number(low, 6)}", [complex(low, start)], prefer=1 - 1j, gaps=APART)
        write_key(key, list(_chart_key(result, chart)))

    return finish


def _chart_key(result: CamOptimum, chart: FlatChart) -> Iterator[Part]:
    samples = [
        Sample("convex profile: $S_0 = r_m - F_{min}$", {"linewidth": 1.5, **CURVES[1]}),
        Sample("pressure in the guide: $l = l^*$", {"linewidth": 1.5, **CURVES[0]}),
        Sample("both are kept", dict(REGION), fill=True),
    ]
    yield Part("Lines", samples=samples)
    rows = [
        ("$F_{min}$", f"{signed(1e3 * chart.convexity, 6)} mm"),
        ("$S_{0\\,min}$", f"{number(1e3 * chart.least_start, 6)} mm"),
        ("$l^*$", f"{number(1e3 * chart.least_length, 6)} mm"),
        ("$H_{2\\,min} = S_{0\\,min} + h + l^*$", f"{number(1e3 * chart.least_height, 6)} mm"),
        ("lowest with all constraints (diamond)", f"{number(1e3 * result.least.height, 6)} mm"),
        ("lowest in whole steps (circle)", f"{number(1e3 * result.chosen.height, 6)} mm"),
    ]
    yield Part("Sizes", rows)
    yield Part("Margins of the circle", list(_margins(result.chosen)))
