"""The sheet of curves by which a train is chosen, with the points of the task on them.

Module ratio of equal strength (figures 4.4, 4.11), ratio and efficiency of planetary trains (4.8 to 4.10), limits of
the ratio by the number of planets (table 4.7).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from math import prod
from typing import NamedTuple

import numpy as np

from tmmcalc.core.plane import Plane
from tmmcalc.gears.bounds import single_planet_limits
from tmmcalc.gears.criteria.efficiency import MeshEfficiency
from tmmcalc.gears.kinds import from_tooth_ratio
from tmmcalc.gears.network.curves import Curve, efficiency_over_ratio, efficiency_over_reduction, ratio_over_inverted
from tmmcalc.gears.network.types import efficiency
from tmmcalc.gears.pictures.cloud import Mark, draw_marks, write_key
from tmmcalc.gears.pictures.words import layout_word
from tmmcalc.gears.proportion import RANGE, RANGE_INTERNAL, curve, equal_strength
from tmmcalc.gears.radial import ratio_limits
from tmmcalc.gears.scheme import Layout
from tmmcalc.gears.trains import Request, Variant
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.diagram import Axis, Diagram
from tmmcalc.report.drawing.lettering import minus
from tmmcalc.report.drawing.pens import CURVES, WHITE, Pen
from tmmcalc.report.drawing.shapes import Area, Drawing, Words
from tmmcalc.report.language import tr, tr_name
from tmmcalc.report.numbers import number

PLANETS = range(3, 9)
TEXTBOOK = 0.9  # efficiency of the inverted train in the textbook's figures
LOWEST = -1.0  # efficiency that is shown
RATIO, REDUCTION, INVERTED, LARGEST = 20.0, 100.0, 8.0, 10.0  # limits of the figures
SAMPLES = 1600  # of a curve with a pole
ROOM = 1.15
TITLE, LEFT, BELOW = 2.8, 16.0, 10.0  # height of a title, room at the left of a frame and under it [mm]
PALER = Pen("CURVES_OF_TEXTBOOK_1", 0.3, CURVES[0].dashes, "#8a8a8a")
PALER_TOO = Pen("CURVES_OF_TEXTBOOK_2", 0.3, CURVES[1].dashes, "#8a8a8a")
POINT = Mark("o", Pen("POINTS_OF_THE_TASK", 0.25), 1.5, WHITE)
TASK = Pen("TASK", 0.35, (5.0, 1.2, 1.0, 1.2))
LOCKED = "#fbeee6"  # where efficiency is below zero
PERMITTED, SURE, BAR = "#dfe6ec", "#a9cbe2", Pen("BARS", 0.0)
BROAD = 0.6  # of a bar

Panel = Callable[[Drawing, Box], Diagram]
Named = list[tuple[str, Mark | Pen]]
Task = tuple[complex, str, str]  # a point of the task, its layout, its value in words


class Point(NamedTuple):
    """What the task asks of one layout."""

    layout: Layout
    u: float  # tooth ratio
    i_1h: float | None  # None: not planetary, or wheel 1 stands still


def graphs_of(variants: Sequence[Variant]) -> list[Panel]:
    """The curves that these variants ask for; none for trains with fixed axes in a row and AII."""
    requests = {variant.request.task.layout: variant.request for variant in variants}
    points = [_point(request) for request in requests.values()]
    moving = [point for point in points if point.layout.planetary and point.layout.sign]
    panels: list[Panel] = []
    if any(point.layout.stepped and point.u > 1 for point in points):
        panels.append(partial(_modules, points=points))
    if moving:
        eta0 = _inverted_efficiency(moving[0].layout)
        panels.append(partial(_ratios, points=moving))
        panels += [partial(draw, points=moving, eta0=eta0) for draw in (_by_wheel, _by_carrier)]
    limited = [each for each in requests.values() if each.scheme.branched and each.scheme.stages == 1]
    panels += [partial(_limits, request=each) for each in sorted(limited, key=lambda each: each.scheme.paired)]
    return panels


def _point(request: Request) -> Point:
    layout, u = request.scheme, request.task.nominal
    speed = from_tooth_ratio(layout, "i_1H", u) if layout.planetary and layout.sign else None
    return Point(layout, float(u), float(speed) if speed else None)


def _inverted_efficiency(layout: Layout) -> float:
    """eta_0 of general values for the meshes."""
    meshes = MeshEfficiency()
    return prod(meshes.internal if mesh.internal else meshes.external for mesh in layout.meshes)


def _modules(drawing: Drawing, box: Box, points: Sequence[Point]) -> Diagram:
    """mu* over U for an external and an internal second mesh."""
    tied = [point for point in points if point.layout.stepped and point.u > 1]
    found: list[Task] = []
    lines: list[tuple[Plane, Pen]] = []
    names: Named = []
    for k, (internal, ends, name) in enumerate(((False, RANGE, tr("AA, coaxial")), (True, RANGE_INTERNAL, "AI"))):
        own = [point for point in tied if bool(point.layout.rings) is internal]
        low = min([ends[0], *(point.u for point in own)])
        high = max([ends[1], *(ROOM * point.u for point in own)])
        drawn = curve(internal=internal, low=low, high=high)
        lines.append((drawn.ratio + 1j * drawn.modules, CURVES[k]))
        names.append((name, CURVES[k]))
        for point in own:
            value = float(equal_strength(point.u, internal=internal).modules[0])
            found.append((complex(point.u, value), point.layout.key, f"$μ^*$ = {number(value, 4)}"))
    every = np.concatenate([z for z, _ in lines])
    across = Axis(tr("tooth ratio $U$"), float(every.real.min()), float(every.real.max()))
    up = Axis("$μ^* = m_2/m_1$", 0.0, ROOM * float(every.imag.max()))
    return _graph(drawing, box, tr("Module ratio of equal strength"), across, up, names, lines, found)


def _ratios(drawing: Drawing, box: Box, points: Sequence[Point]) -> Diagram:
    """i_1H over i_13^H, and the reduction of a carrier that drives."""
    values = [1 - point.i_1h for point in points if point.i_1h is not None]
    low, high = min([-INVERTED, *(ROOM * v for v in values)]), max([INVERTED, *(ROOM * v for v in values)])
    bottom, top = min(-INVERTED, 1 - high), max(LARGEST, 1 - low)
    curves = ratio_over_inverted(low, high, top, points=SAMPLES)
    lines = [(each.x + 1j * each.y, CURVES[min(k, 1)]) for k, each in enumerate(curves)]
    across = Axis(tr("ratio of the inverted train $i_{13}^H$"), low, high)
    up = Axis("$i_{1H}$, $|1/i_{1H}|$", bottom, top)
    names: Named = [("$i_{1H}$", CURVES[0]), ("$|1/i_{1H}|$", CURVES[1])]
    found = [
        (complex(1 - point.i_1h, point.i_1h), point.layout.key, f"$i_{{1H}}$ = {minus(number(point.i_1h, 5))}")
        for point in points
        if point.i_1h is not None
    ]
    return _graph(drawing, box, tr("Ratio"), across, up, names, lines, found)


def _by_wheel(drawing: Drawing, box: Box, points: Sequence[Point], eta0: float) -> Diagram:
    """Efficiency over i_1H with wheel 1 driving."""
    values = [point.i_1h for point in points if point.i_1h is not None]
    low, high = min([-RATIO, *(ROOM * v for v in values)]), max([RATIO, *(ROOM * v for v in values)])
    lines, names = _pairs(lambda eta: efficiency_over_ratio(eta, low, high, LOWEST), eta0)
    across, up = Axis("$i_{1H}$", low, high), Axis("$η$", LOWEST, 1.2)
    found = []
    for point in points:
        if point.i_1h is not None and (value := float(efficiency(point.i_1h, eta0))) >= LOWEST:
            found.append((complex(point.i_1h, value), point.layout.key, f"$η$ = {minus(number(value, 3))}"))
    field = _graph(drawing, box, tr("Wheel 1 drives"), across, up, names, lines, found)
    drawing.add(Area(field.paper(Box(low, LOWEST, high, 0.0).corners), LOCKED), level=-3)
    corner = complex(field.box.right - 1.5, field.box.bottom + 1.5)
    drawing.add(Words(corner, tr("self-locking"), 2.4, 1 - 1j, colour="#b34700"))
    return field


def _by_carrier(drawing: Drawing, box: Box, points: Sequence[Point], eta0: float) -> Diagram:
    """Efficiency over the reduction |1/i_1H| with the carrier driving."""
    reducing = [point for point in points if point.i_1h is not None and abs(point.i_1h) < 1]
    largest = max([REDUCTION, *(2 / abs(point.i_1h) for point in reducing if point.i_1h)])
    lines, names = _pairs(lambda eta: efficiency_over_reduction(eta, largest), eta0, each=True)
    across, up = Axis("$|1/i_{1H}|$", 1.0, largest, log=True), Axis("$η$", 0.0, 1.05)
    found = []
    for point in reducing:
        if point.i_1h is not None:
            value = float(efficiency(point.i_1h, eta0, "H"))
            found.append((complex(1 / abs(point.i_1h), value), point.layout.key, f"$η$ = {number(value, 3)}"))
    return _graph(drawing, box, tr("The carrier drives, $|i_{1H}| < 1$"), across, up, names, lines, found)


def _pairs(
    curves: Callable[[float], tuple[Curve, ...]], eta0: float, *, each: bool = False
) -> tuple[list[tuple[Plane, Pen]], Named]:
    """The curves for the train's own inverted efficiency and for the textbook's; ``each`` branch with its name."""
    lines: list[tuple[Plane, Pen]] = []
    names: Named = []
    for eta, pens in ((eta0, CURVES), (TEXTBOOK, (PALER, PALER_TOO))):
        for k, found in enumerate(curves(eta)):
            pen = pens[k if each else 0]
            name = f"$η_0$ = {number(eta, 4)}"
            if each or k == 0:
                names.append((f"{_written(found.label)}, {name}" if each else name, pen))
            lines.append((found.x + 1j * found.y, pen))
    return lines, names


def _written(label: str) -> str:
    """A range of i_1H with true signs."""
    return minus(label.replace("i_1H", "$i_{1H}$"))


def _limits(drawing: Drawing, box: Box, request: Request) -> Diagram:
    """How large the ratio may be with each number of planets; the ratio of the task across."""
    task, known = request.task, list(PLANETS)
    bars: list[tuple[list[float], list[float], str]]  # from, to, colour
    if task.scheme.paired:
        bounds = [ratio_limits(k) for k in known]
        tops = [bound.high or 0.0 for bound in bounds]
        bars = [([bound.low for bound in bounds], tops, SURE)]
        names = [(tr("permissible"), SURE)]
        value, symbol = 1 + float(task.nominal), "i_{1H}"
    else:
        gap = 2 * task.addendum + (task.demands.gap or 0)
        found = [single_planet_limits(k, sun=task.limits.least, tips=float(gap)) for k in known]
        tops = [limit.permissible or 0.0 for limit in found]
        zero = [0.0 for _ in known]
        bars = [(zero, tops, PERMITTED), (zero, [max(limit.rational or 0.0, 0.0) for limit in found], SURE)]
        names = [
            (tr("permissible, some sun"), PERMITTED),
            (tr("least sun, $z_1$ = {teeth}", teeth=task.limits.least), SURE),
        ]
        value, symbol = float(task.nominal), "U"
    key: Named = [(name, Mark("s", BAR, 2.6, colour)) for name, colour in names]
    key.append((tr("task: {ratio}", ratio=f"${symbol}$ = {number(value, 5)}"), TASK))
    across = Axis(tr("number of planets $K$"), known[0] - 0.7, known[-1] + 0.7, whole=True)
    up = Axis(f"${symbol}$", 0.0, ROOM * max(*tops, value))
    field = _graph(
        drawing, box, tr("{layout}: neighbours clear each other", layout=layout_word(task.layout)), across, up, key
    )
    half = BROAD / 2
    for starts, ends, colour in bars:
        for k, low, high in zip(known, starts, ends, strict=True):
            if high > low:
                bar = Box(k - half, low, k + half, high)
                drawing.add(Area(field.paper(bar.corners), colour, BAR), level=1)
    field.level(value, TASK)
    for k, top in zip(known, tops, strict=True):
        at = field.place(complex(k, top))
        near = abs(at.imag - field.place(complex(k, value)).imag + 1.8) < 2.4  # the line of the task would strike it
        drawing.add(Words(at + (4.2j if near else 0.7j), number(top, 3), 2.2, -1j), level=6)
    return field


def _graph(
    drawing: Drawing,
    box: Box,
    title: str,
    x: Axis,
    y: Axis,
    names: Named,
    lines: Sequence[tuple[Plane, Pen]] = (),
    tasks: Sequence[Task] = (),
) -> Diagram:
    """Curves, and the points of the task with their names, in a frame under its title and the names of the curves."""
    drawing.add(Words(complex(box.left, box.top), title, TITLE, -1 + 1j))
    key = [*names, *([(tr("task"), POINT)] if tasks else [])]
    top = write_key(drawing, box.inset(0, 0, 0, 1.9 * TITLE), key)
    field = Diagram(drawing, Box(box.left + LEFT, box.bottom + BELOW, box.right - 2, top - 2), x, y)
    field.labels.avoid(field.paper([complex(x.low), complex(x.high)]))
    for z, pen in lines:
        field.curve(z, pen)
    draw_marks(field, np.array([at for at, *_ in tasks]), POINT, 2.0)
    # layouts of one ratio share their point
    for at, said in dict.fromkeys((at, said) for at, _, said in tasks):
        keys = ", ".join(tr_name(key) for other, key, same in tasks if (other, same) == (at, said))
        field.labels.put(f"{keys}: {said}", [field.place(at)], height=2.3, gaps=(1.9, 2.8, 4.0, 5.5))
    return field
