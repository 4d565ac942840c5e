"""The picture of the optimal design: blocking contours in the plane of S0 and r2, and N1 and sigma_H along r2.

Numbers in circles are those of the textbook's table 5.5; the filled region keeps all constraints at its height H2.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from typing import Any

import numpy as np

from tmmcalc.cams.optimum.margins import NUMBERS
from tmmcalc.cams.optimum.results import (
    CamOptimum,
    Choice,
    Contour,
    Curve,
    FlatChart,
    Outline,
    Section,
)
from tmmcalc.cams.pictures.ordered import cam_of
from tmmcalc.cams.pictures.wording import constraint_name, mm
from tmmcalc.cams.task import CamTask
from tmmcalc.core.plane import Plane
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.diagram import Axis, Diagram
from tmmcalc.report.drawing.key import Part, Sample, write_key
from tmmcalc.report.drawing.lettering import minus, width
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.page import sheets
from tmmcalc.report.drawing.pens import CURVES, INK, MARK, WHITE, Pen
from tmmcalc.report.drawing.shapes import Drawing, Words
from tmmcalc.report.language import tr, tr_number, tr_unit
from tmmcalc.report.numbers import number

PENS: dict[int, Pen] = dict(zip(NUMBERS, CURVES, strict=True))
PENS |= {10: PENS[7], 11: PENS[8]}  # of a rocker, which has neither stem nor guide
REGION = "#dfeaf4"
BORDER = Pen("BORDER", 0.6)
CHOSEN = Pen("CHOSEN", 0.25, colour=MARK.colour)
THROUGH = Pen("CHOSEN_RADIUS", 0.3, (2.4, 0.9), MARK.colour)
BOUND = Pen("BOUND", 0.4, (2.4, 0.9))
LEAST = Pen("LEAST", 0.25)
OTHER = Pen("OTHER_STEPS", 0.18)
APART = (2.0, 3.0, 4.5)  # of a text from its line [mm]
KEY, APART_KEY = 70.0, 6.0  # least width of the key beside a diagram, and its distance [mm]
HEADING = 7.0  # room of a heading [mm]
SIDES = (16.0, 10.0, 2.0, 2.0)  # room around a frame: left, bottom, right, top [mm]
SAME = 1e-9  # of a limit: a value at it
TRIED = 14  # places of a curve that its number tries


def figure(order: Order) -> Drawing:
    """The drawing of the stage."""
    return optimum_drawing(cam_of(order), order.results["cam_optimum"])


def optimum_drawing(task: CamTask, result: CamOptimum) -> Drawing:
    """A sheet for every contour, one for the section along r2; of a flat-faced follower the chart of H2 and S0."""
    draws: list[Callable[[Drawing, Box], str]] = []
    if result.flat is not None:
        draws.append(partial(draw_chart, result=result, chart=result.flat))
    draws += [partial(draw_contour, result=result, contour=contour) for contour in result.contours]
    if result.section is not None:
        draws.append(partial(draw_section, result=result, section=result.section))
    drawing, boxes = sheets(max(len(draws), 1))
    for draw, box in zip(draws, boxes, strict=False):
        heading = draw(drawing, box.inset(0, 0, 0, HEADING)) + _option(result)
        height = min(3.2, box.width / width(heading))
        drawing.add(Words(complex(box.middle.real, box.top), heading, height, 1j))
    return drawing


def _option(result: CamOptimum) -> str:
    """What a heading adds where as asked there is no mechanism."""
    return f"; {', '.join(result.shown)}" if result.shown else ""


def _typeset(result: CamOptimum, name: str) -> str:
    """A size of the kind of follower as it is typeset."""
    size = result.names[name]
    return f"${size[0]}_{size[1:]}$"


def draw_contour(drawing: Drawing, box: Box, result: CamOptimum, contour: Contour) -> str:
    """Draw a contour with its key; its heading."""
    plane, key = _with_key(box)
    low, high, bottom, top = (1e3 * v for v in contour.window)
    across = tr("base circle $R_0$, mm") if result.kind == "oscillating" else tr("start distance $S_0$, mm")
    axes = Axis(across, low, high), Axis(tr("roller radius $r_2$, mm"), bottom, top)
    lowest = abs(contour.height - result.chosen.height) < 1e-9
    seen = _draw_plane(Diagram(drawing, plane.inset(*SIDES), *axes), result, contour, lowest)
    write_key(drawing, key, list(_contour_key(result, contour, seen, lowest)))
    return contour_heading(result, contour)


def _with_key(box: Box) -> tuple[Box, Box]:
    """The rectangle of a diagram and that of its key, whose longest rows need some room."""
    beside = max((box.width - APART_KEY) / 2.75, KEY)
    plane, key = box.split(box.width - APART_KEY - beside, beside, gap=APART_KEY, across=True)
    return plane, key


def contour_heading(result: CamOptimum, contour: Contour) -> str:
    """Of what sizes a contour is."""
    sizes = [f"{_typeset(result, 'height')} = {_in_mm(contour.height)}"]
    if result.kind == "oscillating":
        sizes.append(f"$l_2$ = {_in_mm(result.chosen.length)}")
    else:
        sizes.append(f"$e$ = {_in_mm(result.offset or 0.0)}")
    return tr("Blocking contour at {sizes}", sizes=", ".join(sizes))


def _in_mm(value: float, digits: int = 6) -> str:
    return f"{mm(value, digits)} {tr_unit('mm')}"


def _draw_plane(diagram: Diagram, result: CamOptimum, contour: Contour, lowest: bool) -> list[int]:
    """Region, curves with their numbers, points; the constraints that are seen."""
    for outline in contour.outlines:
        border = _places(outline)
        diagram.filled(border, REGION if outline.area > 0 else WHITE)
        diagram.curve(border, BORDER, weight=1.0, level=6)
        for corner in outline.corners:
            diagram.point(1e3 * complex(corner.start, corner.roller), LEAST, 0.4, INK)
    for curve in contour.curves:
        diagram.curve(_places(curve), PENS[curve.number], weight=1.0)
    _points(diagram, result, lowest)
    seen = sorted({curve.number for curve in contour.curves})
    for key in seen:
        longest = max(
            (c for c in contour.curves if c.number == key), key=lambda c: float(np.ptp(c.start) + np.ptp(c.roller))
        )
        places = diagram.paper(_places(longest))
        tried = places[np.linspace(0, len(places) - 1, TRIED + 2).astype(int)[1:-1]]
        gaps = (0.8, 1.6, 2.4, 3.4)
        diagram.labels.put(str(key), tried, height=2.0, ring=True, gaps=gaps, colour=PENS[key].colour)
    return seen


def _places(curve: Curve | Outline) -> Plane:
    """Its points (n,) in the plane of the sizes [mm]."""
    return np.asarray(1e3 * (curve.start + 1j * curve.roller), complex)


def _points(diagram: Diagram, result: CamOptimum, lowest: bool) -> None:
    chosen = complex(result.chosen.start, result.chosen.roller) * 1e3
    if lowest:
        rows = np.flatnonzero(_beside(result))[1:]
        for start, roller in zip(1e3 * result.start[rows], 1e3 * result.roller[rows], strict=True):
            if _inside(diagram, complex(start, roller)):
                diagram.point(complex(start, roller), OTHER, 0.7)
    points = [(chosen, "o", CHOSEN, 2.0)]
    if result.kind != "oscillating":
        points.append((complex(result.least.start, result.least.roller) * 1e3, "D", LEAST, 1.5))
    for at, kind, pen, size in reversed(points):
        if _inside(diagram, at):
            diagram.marker(at, kind, pen, size)
    if _inside(diagram, chosen):
        text = f"({number(chosen.real, 6)}; {number(chosen.imag, 6)})"
        gaps = (1.8, 2.8, 4.0, 5.5)
        diagram.labels.put(text, [diagram.place(chosen)], height=2.1, gaps=gaps)


def _inside(diagram: Diagram, at: complex) -> bool:
    return diagram.x.has(at.real) and diagram.y.has(at.imag)


def _beside(result: CamOptimum) -> np.ndarray[Any, np.dtype[np.bool_]]:
    """Which step points (n,) stand in the plane of the contour: those with the rocker of the best one."""
    if result.length is None:
        return np.ones(len(result.start), bool)
    found: np.ndarray[Any, np.dtype[np.bool_]] = result.length == result.length[0]
    return found


def _contour_key(result: CamOptimum, contour: Contour, seen: list[int], lowest: bool) -> Iterator[Part]:
    curves = [Sample(f"{key}  {constraint_name(key)}", PENS[key]) for key in seen]
    yield Part(tr("Curves"), samples=[*curves, Sample(tr("all constraints are kept"), REGION)])
    corners = [corner for outline in contour.outlines for corner in outline.corners]
    if corners:
        rows = [
            (", ".join(map(str, corner.numbers)), tr_number(f"({1e3 * corner.start:.4f}; {1e3 * corner.roller:.4f})"))
            for corner in corners
        ]
        yield Part(tr("Corners ({start}; $r_2$), mm", start=_typeset(result, "start")), rows)
    chosen, size = result.chosen, _typeset(result, "height")
    names = (tr("circle: lowest in whole steps"), tr("diamond: lowest of any sizes"))
    if result.kind == "oscillating":
        names = (tr("circle: smallest in whole steps"), tr("smallest of any sizes"))
    values = (f"{size} = {_in_mm(chosen.height)}", f"{size} = {_in_mm(result.least.height, 7)}")
    sizes = list(zip(names, values, strict=True))
    others = int(np.count_nonzero(_beside(result))) - 1
    if lowest and others:
        sizes.append((tr("small circles: other feasible steps"), str(others)))
    yield Part(tr("Points"), sizes)
    heading = tr("Margins of the circle at its height")
    if result.kind == "oscillating":
        heading = tr("Margins of the circle")
    yield Part(heading, list(_margins(chosen)))


def _margins(chosen: Choice) -> Iterator[tuple[str, str]]:
    for each in chosen.checks:
        text = tr_number(f"{round(100 * each.margin, 1) + 0.0:.1f} %") if each.judged else tr("not judged")
        yield f"{each.number}  {constraint_name(each.number)}", minus(text)


def draw_section(drawing: Drawing, box: Box, result: CamOptimum, section: Section) -> str:
    """Draw the section; its heading."""
    upper, lower = box.inset(*SIDES).split(1, 1, gap=6)
    far = 1e3 * float(section.roller[-1]) if len(section.roller) else 1.0
    courses = (
        (upper, section.edge, section.edge_limit, 1.0, tr("largest |$N_1$|, N"), 8, ("[$N_1$]", tr_unit("N"))),
        (lower, section.stress, section.stress_limit, 1e-6, tr("largest $σ_H$, MPa"), 9, ("[$σ_H$]", tr_unit("MPa"))),
    )
    for frame, values, limit, factor, name, key, (sign, unit) in courses:
        here = factor * float(np.interp(result.chosen.roller, section.roller, values))
        top = max(factor * (limit or 0.0), here)
        up = Axis(name, 0.0, 2.0 * top if top > 0 else 1.1 * factor * float(np.max(values, initial=1.0)))
        across = Axis(tr("roller radius $r_2$, mm"), 0.0, far)
        diagram = Diagram(drawing, frame, across, up, numbered=frame is lower)
        told = None if limit is None else (factor * limit, f"{sign} = {number(factor * limit, 5)} {unit}")
        chosen = complex(1e3 * result.chosen.roller, here)
        _course(diagram, 1e3 * section.roller, factor * values, told, chosen, PENS[key]._replace(dashes=()))
    return section_heading(section)


def section_heading(section: Section) -> str:
    """Of what sizes a section is."""
    sizes = f"$S_0$ = {_in_mm(section.start)}, $H_2$ = {_in_mm(section.height)}"
    return tr("Along the roller radius at {sizes}", sizes=sizes)


def _course(
    diagram: Diagram, roller: Any, values: Any, limit: tuple[float, str] | None, chosen: complex, pen: Pen
) -> None:
    """One quantity over the radius, filled where it keeps its limit; the radius that is chosen."""
    diagram.vertical(chosen.real, THROUGH)
    diagram.labels.avoid(diagram.paper([complex(chosen.real, y) for y in (diagram.y.low, diagram.y.high)]))
    if limit is not None:
        good = values <= limit[0] * (1 + SAME)  # the radii at which it is passed are among the points
        rows = np.flatnonzero(good)
        for run in np.split(rows, np.flatnonzero(np.diff(rows) > 1) + 1):
            diagram.filled(np.append(roller[run] + 0j, (roller[run] + 1j * values[run])[::-1]), REGION)
        diagram.level(limit[0], BOUND)
    diagram.curve(roller + 1j * values, pen, weight=1.0)
    diagram.marker(chosen, "o", CHOSEN, 2.0)
    at = [diagram.place(chosen)]
    diagram.labels.put(number(chosen.imag, 5), at, height=2.1, gaps=(1.8, 2.8, 4.0), colour=MARK.colour)
    if limit is not None:
        diagram.name_level(*limit, INK)
        for x in _crossings(roller, values - limit[0]):
            here = diagram.point(complex(x, limit[0]), LEAST, 0.5, INK)
            diagram.labels.put(f"$r_2$ = {number(x, 4)}", [here], height=2.1, gaps=(1.6, 2.6, 3.8))


def _crossings(x: Any, excess: Any) -> list[float]:
    """Where a sampled function passes 0, to what a picture shows."""
    rows = np.flatnonzero(np.signbit(excess[1:]) != np.signbit(excess[:-1]))
    part = excess[rows] / (excess[rows] - excess[rows + 1])
    return [float(v) for v in x[rows] + part * (x[rows + 1] - x[rows])]


def draw_chart(drawing: Drawing, box: Box, result: CamOptimum, chart: FlatChart) -> str:
    """Draw the chart of a flat face; its heading."""
    plane, key = _with_key(box)
    low, base = 1e3 * chart.least_height, 1e3 * (chart.stroke + chart.gap + chart.least_length)
    start, span = 1e3 * chart.least_start, 0.35 * 1e3 * chart.least_height
    ends = np.array([low - span, low + span])
    axes = (
        Axis(tr("height $H_2$, mm"), *ends),
        Axis(tr("start distance $S_0$, mm"), max(start - span, 0.0), start + span),
    )
    diagram = Diagram(drawing, plane.inset(*SIDES), *axes)
    diagram.filled(np.array([low + 1j * start, ends[1] + 1j * start, ends[1] + 1j * (ends[1] - base)]), REGION)
    diagram.level(start, CURVES[1])
    diagram.curve(ends + 1j * (ends - base), CURVES[0], weight=1.0)
    diagram.marker(complex(low, start), "D", LEAST, 1.5)
    diagram.marker(complex(result.chosen.height, result.chosen.start) * 1e3, "o", CHOSEN, 2.0)
    named = (
        (f"$S_0$ = {number(start, 6)}", complex(low - 0.7 * span, start), 1j),
        ("$S_0 = H_2 − h − l^*$", complex(low + 0.6 * span, low + 0.6 * span - base), -1 + 1j),
        (f"$H_2$ = {number(low, 6)}", complex(low, start), 1 - 1j),
    )
    for text, at, prefer in named:
        diagram.labels.put(text, [diagram.place(at)], prefer=prefer, gaps=APART)
    write_key(drawing, key, list(_chart_key(result, chart)))
    return tr("Flat face: admissible start distances by the height (fig. {figure})", figure="5.37")


def _chart_key(result: CamOptimum, chart: FlatChart) -> Iterator[Part]:
    samples = [
        Sample(tr("convex profile: $S_0 = r_m − F_{min}$"), CURVES[1]),
        Sample(tr("pressure in the guide: $l = l^*$"), CURVES[0]),
        Sample(tr("both are kept"), REGION),
    ]
    yield Part(tr("Lines"), samples=samples)
    rows = [
        ("$F_{min}$", _in_mm(chart.convexity)),
        ("$S_{0 min}$", _in_mm(chart.least_start)),
        ("$l^*$", _in_mm(chart.least_length)),
        ("$H_{2 min} = S_{0 min} + h + l^*$", _in_mm(chart.least_height)),
        (tr("lowest with all constraints (diamond)"), _in_mm(result.least.height)),
        (tr("lowest in whole steps (circle)"), _in_mm(result.chosen.height)),
    ]
    yield Part(tr("Sizes"), rows)
    yield Part(tr("Margins of the circle"), list(_margins(result.chosen)))
