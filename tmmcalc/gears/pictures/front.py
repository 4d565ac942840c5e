"""The sheets of a choice: inertia against mass with the size as colour, all pairs of criteria, front and winner."""

from __future__ import annotations

from collections.abc import Sequence, Sized
from itertools import combinations, pairwise
from math import ceil, comb, sqrt

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.plane import Plane
from tmmcalc.gears.criteria.choice import front
from tmmcalc.gears.criteria.objectives import OBJECTIVES
from tmmcalc.gears.model import Values
from tmmcalc.gears.pictures.cloud import MANY, Mark, draw_marks, evenly, fitted, shares, write_key
from tmmcalc.gears.pictures.words import CRITERIA, axis_name, layout_word, of_many, short_name, teeth_text, variant_word
from tmmcalc.gears.selection.results import Pool, Selection
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.diagram import HEIGHT, Axis, Diagram, ticks, written
from tmmcalc.report.drawing.page import headed
from tmmcalc.report.drawing.pens import THIN, WHITE, Pen
from tmmcalc.report.drawing.shapes import Area, Drawing, Words
from tmmcalc.report.language import tr, tr_unit
from tmmcalc.report.numbers import number

NAMED = 25  # members of the front that are numbered, evenly chosen
BEYOND = 2.0  # times the largest values of the front: heavier trains are left out of the picture
SIGNS = ("o", "^", "s", "D", "v", "P", "X", "<", ">")  # of variants
SIZE = 1.7  # width of the sign of a train [mm]
SHADES = 8  # of the size, about
PALE, DEEP = np.array([0xBF, 0xDD, 0xF0]), np.array([0x06, 0x22, 0x50])  # colours of the least and the largest
BAR, BESIDE = 4.0, 27.0  # width of the scale of shades, and room for it and its numbers at the right [mm]
PAIRS = 6  # diagrams of two criteria on a sheet at most
LEFT, BELOW = 19.0, 10.0  # room for numbers and names of the axes of a frame [mm]
FAR = 3.2  # a number whose middle is farther from its point has a line to it [mm]
GAPS = (1.6, 2.4, 3.6, 5.0, 7.0)
FRONT = Mark("o", Pen("FRONT", 0.35, (), "#d55e00"), 2.8)
WINNER = Mark("*", Pen("TRAIN_DRAWN", 0.35), 3.4)
EDGE = Pen("BORDER_OF_FRONT", 0.3, (2.4, 0.9), "#d55e00")
LEADER = Pen("LEADERS_OF_ROWS", 0.13, (), "#d55e00")
SHADE = Pen("SHADES", 0.0)
CLOUD = Mark("o", Pen("TRAINS", 0.1, (), WHITE), 0.9, "#7d9cb5")


def pareto_sheet(drawing: Drawing, box: Box, result: Selection, place: int, heading: str) -> Diagram:
    """Inertia against mass under a heading, see `draw_pareto`."""
    return draw_pareto(drawing, headed(drawing, box, heading), result, place)


def draw_pareto(drawing: Drawing, free: Box, result: Selection, place: int) -> Diagram:
    """Inertia against mass, the size as a shade; ``place`` is the row that is marked."""
    pool, near = result.pool, np.flatnonzero(_near(result, place))
    clouds = [near[pool.variant[near] == k] for k in range(len(result.variants))]
    shown = [
        np.union1d(each[evenly(len(each), most)], np.intersect1d(each, [*result.front.tolist(), place]))
        for each, most in zip(clouds, shares([*map(len, clouds)]), strict=True)
    ]
    size = CRITERIA["size"][0] * pool.size
    borders = _borders(size[near])
    top = write_key(drawing, free, _names(result, place, clouds, shown))
    if len(near) < len(pool):
        beyond = len(pool) - len(near)
        said = tr("heavier or more inert trains beyond the picture: {count}", count=beyond)
        drawing.add(Words(complex(free.right - BESIDE, top - 0.8), said, HEIGHT, 1 + 1j))
        top -= 0.8 + 1.6 * HEIGHT
    frame = Box(free.left + LEFT, free.bottom + BELOW, free.right - BESIDE, top - 2)
    x, y = pool.mass, pool.inertia
    field = Diagram(drawing, frame, fitted(axis_name("mass"), x[near]), fitted(axis_name("inertia"), y[near]))
    for k, own in enumerate(shown):
        draw_marks(field, x[own] + 1j * y[own], _sign_of(k), 1.0, [_shade(v, borders) for v in size[own].tolist()])
    field.curve(_staircase(pool), EDGE, level=5)
    draw_marks(field, x[result.front] + 1j * y[result.front], FRONT, 0.6)
    draw_marks(field, x[[place]] + 1j * y[[place]], WINNER, 1.0)
    _draw_bar(drawing, Box(frame.right + 4, frame.bottom, frame.right + 4 + BAR, frame.top), borders)
    _label(field, result, place)
    return field


def _near(result: Selection, place: int) -> NDArray[np.bool_]:
    """Trains (n,) that are not far heavier or more inert than the front and the train that is drawn."""
    pool, shown = result.pool, [*result.front.tolist(), place]
    limits = [BEYOND * float(values[shown].max()) for values in (pool.mass, pool.inertia)]
    return np.asarray((pool.mass <= limits[0]) & (pool.inertia <= limits[1]))


def _names(
    result: Selection, place: int, clouds: Sequence[Sized], shown: Sequence[Sized]
) -> list[tuple[str, Mark | Pen]]:
    """What the signs mean; of every variant how many trains it has, and how many are drawn if they are thinned."""
    names: list[tuple[str, Mark | Pen]] = []
    for k, variant in enumerate(result.variants):
        if len(variant.sets):
            mark = _sign_of(k)._replace(fill=_colour(0.5))
            said = f"{variant_word(variant.sets.scheme, variant.sets.planets)}: {len(variant.sets)}"
            names.append((of_many(said, len(shown[k]), len(shown[k]) < len(clouds[k])), mark))
    said = ", ".join(map(short_name, result.objectives))
    names.append((tr("front in {criteria}: {count}, numbered by rows", criteria=said, count=len(result.front)), FRONT))
    names.append((tr("border in mass and inertia"), EDGE))
    pool = result.pool
    sets = result.variants[int(pool.variant[place])].sets
    size = f"$D$ = {number(1e3 * float(pool.size[place]), 4)} {tr_unit('mm')}"
    name = f"{layout_word(sets.layout)} {teeth_text(sets.teeth[int(pool.row[place])].tolist())}, {size}"
    chosen = place == result.winner.place
    row = {"row": place + 1, "name": name}
    names.append((tr("row {row}, chosen: {name}", **row) if chosen else tr("row {row}, drawn: {name}", **row), WINNER))
    return names


def _sign_of(variant: int) -> Mark:
    return Mark(SIGNS[variant % len(SIGNS)], Pen("TRAINS", 0.1, (), WHITE), SIZE)


def _borders(size: Values) -> list[float]:
    """Round sizes [mm] between which the shades change, from below the least to above the largest."""
    low, high = float(size.min()), float(size.max())
    inner = ticks(Axis("", low, high), SHADES) if high > low else [low]
    step = inner[1] - inner[0] if len(inner) > 1 else max(high - low, abs(low), 1.0)
    first = inner[0] if inner[0] <= low else inner[0] - step
    return [first + k * step for k in range(max(1, ceil((high - first) / step - 1e-9)) + 1)]


def _shade(size: float, borders: list[float]) -> str:
    """The colour of a size: that of the step between two borders in which it lies."""
    steps = len(borders) - 1
    step = min(int(np.searchsorted(borders, size, "right")) - 1, steps - 1)
    return _colour(step / (steps - 1) if steps > 1 else 0.5)


def _colour(part: float) -> str:
    return "#" + "".join(f"{round(v):02x}" for v in (PALE + part * (DEEP - PALE)).tolist())


def _draw_bar(drawing: Drawing, box: Box, borders: list[float]) -> None:
    """The shades one above another with the sizes between them."""
    each = box.height / (len(borders) - 1)
    for k, (low, high) in enumerate(pairwise(borders)):
        step = Box(box.left, box.bottom + k * each, box.right, box.bottom + (k + 1) * each)
        drawing.add(Area(step.corners, _shade((low + high) / 2, borders), SHADE))
    for k, value in enumerate(borders):
        y = box.bottom + k * each
        drawing.line([complex(box.right, y), complex(box.right + 0.9, y)], THIN)
        drawing.add(Words(complex(box.right + 1.5, y), written(value, borders), HEIGHT, -1))
    at = complex(box.right + 14, box.middle.imag)
    drawing.add(Words(at, axis_name("size"), HEIGHT + 0.5, 1j, np.pi / 2))


def _staircase(pool: Pool) -> Plane:
    """The border of what is reached in mass and inertia alone."""
    edge = front(pool, ("mass", "inertia"))
    order = edge[np.argsort(pool.mass[edge], kind="stable")]
    x, y = np.repeat(pool.mass[order], 2)[1:], np.repeat(pool.inertia[order], 2)[:-1]
    return np.asarray(x + 1j * y)


def _label(field: Diagram, result: Selection, place: int) -> None:
    """Some members of the front by their rows, from 1, where there is room."""
    pool = result.pool
    others = [row for row in result.front.tolist() if row != place]
    for row in others[:: max(1, -(-len(others) // NAMED))]:
        at = field.place(complex(pool.mass[row], pool.inertia[row]))
        said, colour = str(row + 1), FRONT.pen.colour
        middle = field.labels.put_where_free(said, at, height=1.8, gaps=GAPS, prefer=-1 - 1j, colour=colour)
        if middle is not None and abs(middle - at) > FAR:
            toward = (middle - at) / abs(middle - at)
            field.drawing.line([at + FRONT.size / 2 * toward, middle], LEADER, level=7)


def pairs_of(result: Selection) -> list[Sequence[tuple[str, str]]]:
    """Every objective with every other one, as many pairs as one sheet shows together."""
    pairs = list(combinations(result.objectives, 2))
    each = ceil(len(pairs) / ceil(len(pairs) / PAIRS))
    return [pairs[k : k + each] for k in range(0, len(pairs), each)]


def pairs_sheet(
    drawing: Drawing, box: Box, result: Selection, pairs: Sequence[tuple[str, str]], place: int
) -> list[Diagram]:
    """A diagram for each pair of objectives, in as many columns as rows, or one more."""
    pool = result.pool
    rows = np.union1d(evenly(len(pool), MANY // comb(len(result.objectives), 2)), [*result.front.tolist(), place])
    heading = tr(
        "All pairs of criteria: front of all together in rings, the train drawn as a star; arrows point to the better"
    )
    free = headed(drawing, box, of_many(heading, len(rows), len(rows) < len(pool)), 3.0)
    columns = ceil(sqrt(len(pairs)))
    lines = free.split(*(1.0 for _ in range(ceil(len(pairs) / columns))), gap=3)
    places = [cell for line in lines for cell in line.split(*(1.0 for _ in range(columns)), gap=4, across=True)]
    found = []
    for cell, (first, second) in zip(places, pairs, strict=False):
        x, y = (CRITERIA[key][0] * getattr(pool, key) for key in (first, second))
        across, up = fitted(_short(first), x), fitted(_short(second), y)
        field = Diagram(drawing, cell.inset(LEFT, BELOW, 1, 1), across, up)
        for marked, mark in ((rows, CLOUD), (result.front, FRONT), ([place], WINNER)):
            draw_marks(field, x[marked] + 1j * y[marked], mark._replace(size=mark.size * (1 if mark is CLOUD else 0.7)))
        found.append(field)
    return found


def _short(key: str) -> str:
    """A criterion as it is called on a narrow diagram, with an arrow to what is better."""
    _, unit = CRITERIA[key]
    better = "\N{RIGHTWARDS ARROW}" if OBJECTIVES[key].largest else "\N{LEFTWARDS ARROW}"
    name = short_name(key)
    return f"{name}, {tr_unit(unit)} {better}" if unit else f"{name} {better}"
