"""The sheet of a synthesis: all tooth sets by size and error of the ratio, and what each constraint removed."""

from __future__ import annotations

import numpy as np

from tmmcalc.core.plane import Plane
from tmmcalc.gears.advice import called, removals
from tmmcalc.gears.columns import ratios
from tmmcalc.gears.pictures.cloud import Mark, draw_marks, evenly, fitted, write_key
from tmmcalc.gears.pictures.words import KINDS, layout_name, of_many, teeth_text
from tmmcalc.gears.search.measures import coprime_meshes
from tmmcalc.gears.trains import Request, Variant
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.diagram import Axis, Diagram
from tmmcalc.report.drawing.lettering import minus, width
from tmmcalc.report.drawing.page import headed
from tmmcalc.report.drawing.pens import Pen
from tmmcalc.report.drawing.shapes import Area, Drawing, Words
from tmmcalc.report.language import tr, tr_name

COPRIME = Mark("o", Pen("SETS_COPRIME", 0.13, (), "#0072b2"), 1.2, "#0072b2")
OTHER = Mark("^", Pen("SETS_NOT_COPRIME", 0.2, (), "#d55e00"), 1.3)
DRAWN = Mark("s", Pen("SET_DRAWN", 0.4), 3.4)
LEAST = Mark("D", Pen("SET_LEAST_ERROR", 0.3), 2.4)
LIMIT = Pen("LIMITS", 0.3, (5.0, 1.2, 1.0, 1.2), "#d55e00")
BARS = {"candidates": "#c9c9c9", "removed": "#a9cbe2", "left": "#009e73"}
BAR = Pen("BARS", 0.0)
THICKNESS, BROAD = 0.62, 11.0  # of a bar, in parts of its row, and at most [mm]
LEFT = 0.7  # end of the logarithmic axis, a little below one
NAME = 2.5  # height of what is written at the bars [mm]
SIDE = 17.0  # room for numbers and name at the left of a frame [mm]
BELOW = 10.0  # and under it


def solutions_panel(drawing: Drawing, box: Box, variant: Variant, row: int | None) -> None:
    """Fill a rectangle with the sets of a variant and what was removed; ``row`` is the set that is drawn elsewhere."""
    request, synthesis = variant.request, variant.synthesis
    name, count, held = layout_name(request.scheme, request.task.planets), synthesis.count, len(variant.sets)
    said = tr("{layout}: {count} tooth sets", layout=name, count=count)
    if not count:
        said = tr("{layout}: no tooth set", layout=name)
    elif not synthesis.complete:
        said = tr(
            "{layout}: {count} tooth sets, the {held} smallest are held and shown", layout=name, count=count, held=held
        )
    free = headed(drawing, box, said, 3.0)
    if len(variant.sets):
        left, free = free.split(1.35, 1.0, gap=6, across=True)
        _draw_sets(drawing, left, variant, row)
    _draw_removals(drawing, free, variant)


def _sums(variant: Variant) -> np.ndarray:
    """Z1 + Z2, the size of the first stage, which the list is ordered by."""
    return np.asarray(variant.sets.teeth[:, 0] + variant.sets.teeth[:, 1])


def _draw_sets(drawing: Drawing, box: Box, variant: Variant, row: int | None) -> None:
    """Every set by the size of its first stage and its error, by whether its meshes are coprime."""
    z = _sums(variant) + 100j * ratios(variant.request, variant.sets)[1]
    good, best = coprime_meshes(variant.sets), int(np.argmin(np.abs(z.imag)))
    special = {} if row is None else {row: DRAWN}
    if row is None or abs(z[best].imag) < abs(z[row].imag):
        special[best] = LEAST
    # sets of one place have one sign
    apart = np.sort(np.unique(np.stack((z.real, z.imag, good)), axis=1, return_index=True)[1])
    drawn = np.union1d(apart[evenly(len(apart))], np.array([*special], int))
    clouds, names = list[tuple[Plane, Mark]](), list[tuple[str, Mark | Pen]]()
    for label, mask, mark in ((tr("not coprime"), ~good, OTHER), (tr("all meshes coprime"), good, COPRIME)):
        clouds.append((z[drawn[mask[drawn]]], mark))
        names.append((of_many(f"{label}: {np.count_nonzero(mask)}", len(clouds[-1][0]), len(drawn) < len(apart)), mark))
    names.append((tr("tolerance"), LIMIT))
    for k, mark in special.items():
        said = {"number": k + 1, "teeth": teeth_text(variant.sets.teeth[k].tolist())}
        told = tr("set {number}, drawn: {teeth}", **said)
        names.append((told if mark is DRAWN else tr("set {number}, least error: {teeth}", **said), mark))
    top = write_key(drawing, box, names)
    edges = _tolerance(variant.request)
    across = fitted("$z_1 + z_2$", z.real)._replace(whole=True)
    up = fitted(
        tr("error of {ratio}, %", ratio=f"${KINDS[variant.request.kind]}$"), np.array([0.0, *edges, *z.imag.tolist()])
    )
    field = Diagram(drawing, Box(box.left + SIDE, box.bottom + BELOW, box.right, top - 2), across, up)
    for edge in edges:
        field.level(edge, LIMIT)
    for points, mark in clouds:
        draw_marks(field, points, mark)
    for k, mark in special.items():
        draw_marks(field, z[[k]], mark)


def _tolerance(request: Request) -> tuple[float, float]:
    """Ends of the admitted ratios as errors [%]."""
    low, high = (
        float((end - request.nominal) / request.nominal) for end in (request.admitted.low, request.admitted.high)
    )
    return 100 * min(low, high), 100 * max(low, high)


def _draw_removals(drawing: Drawing, box: Box, variant: Variant) -> None:
    """Candidates, what each constraint removed of them, what is left."""
    synthesis = variant.synthesis
    rows = [(tr("candidates"), synthesis.candidates, "candidates")]
    rows += [(tr_name(called(name)), removed, "removed") for name, removed, _ in removals(variant)]
    rows.append((tr("tooth sets"), synthesis.count, "left"))
    numbers = [_counted(count, kind) for _, count, kind in rows]
    drawing.add(Words(complex(box.left, box.top), tr("What the constraints removed, in their order"), 2.6, -1 + 1j))
    frame = box.inset(3 + max(width(name, NAME) for name, *_ in rows), BELOW, 1, 5.5)
    # the longest bar ends where its number still has room
    part = 1 - (width(max(numbers, key=width), NAME) + 4) / frame.width
    largest = max(2, *(count for _, count, _ in rows))
    across = Axis(tr("combinations of wheels"), LEFT, LEFT * (largest / LEFT) ** (1 / part), log=True)
    field = Diagram(drawing, frame, across, Axis("", 0.0, float(len(rows))), lettered=False)
    half = min(THICKNESS, BROAD * len(rows) / frame.height) / 2
    for k, ((name, count, kind), said) in enumerate(zip(rows, numbers, strict=True)):
        y = len(rows) - k - 0.5
        end = max(float(count), LEFT)
        if count > 0:
            drawing.add(Area(field.paper(Box(LEFT, y - half, end, y + half).corners), BARS[kind], BAR), level=2)
        drawing.add(Words(field.place(complex(end, y)) + 1.5, said, NAME, -1, clear=True), level=8)
        drawing.add(Words(field.place(complex(LEFT, y)) - 2, name, NAME, 1))


def _counted(count: int, kind: str) -> str:
    """A number with its thousands apart; what was removed is negative."""
    text = f"{count:,}".replace(",", "\N{NO-BREAK SPACE}")
    return minus(f"-{text}") if kind == "removed" else text
