"""Sheets of a spec as drawings, and what is wrong with them: words over words, on lines, pieces beyond their room."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cache
from itertools import combinations, pairwise
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.errors import TmmError
from tmmcalc.core.plane import Plane
from tmmcalc.pipeline.outcome import RunResult
from tmmcalc.pipeline.picturing import pieces_of
from tmmcalc.pipeline.runner import run
from tmmcalc.project import load_spec
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.pens import GRID, HATCH, OTHER, WHITE, Pen
from tmmcalc.report.drawing.shapes import Arc, Area, Dimension, Drawing, Shape, Stroke, Words
from tmmcalc.report.drawing.wording import corners
from tmmcalc.report.language import speaking
from tmmcalc.report.sheets.layout import GAP
from tmmcalc.report.sheets.piece import Piece
from tmmcalc.report.sheets.sheet import Sheet, Style, draw_within, drawn, planned
from tmmcalc.report.tables.sheets import SheetsTable
from tmmcalc.rooms import STAGES

CONFIGS = Path(__file__).parents[1] / "configs"
OVER = 0.25  # words that meet by less only touch [mm]
BEYOND = GAP / 2  # that a piece may reach over its room: the middle between it and the next [mm]
STEP = 0.4  # of the points that stand for a line [mm]
BENEATH = (GRID.layer, HATCH.layer, OTHER.layer)  # lines that words may stand on
LATIN = re.compile(r"[A-Za-z]{3,}")
KINDS = re.compile(r"[RPIVX]+")  # of dyads and classes, as they are written in every language


class Made(NamedTuple):
    """A sheet with its drawing."""

    sheet: Sheet
    drawing: Drawing


@cache
def result_of(name: str) -> RunResult:
    """The run of a ready spec, of the stages that have something to show on a sheet."""
    stages = [stage.name for stage in STAGES.values() if stage.picture is not None and stage.picture.pieces]
    return run(load_spec(CONFIGS / f"{name}.toml"), target=stages, keep_going=True)


def sheets_of(name: str, language: str, size: str = "a1", frame: str = "gost") -> tuple[list[Made], Style]:
    """All sheets of a ready spec, none if it has no pieces."""
    result = result_of(name)
    said = result.spec.sheets or SheetsTable()
    style = Style(size, frame, language, result.spec.project.title, said.who)
    with speaking(language):
        offered = [piece for stage in result.outcomes for piece in pieces_of(stage, result.spec, result.results)]
        found, warnings = planned(offered, style)
        assert not warnings
        return [Made(sheet, drawn(sheet, style, _failed)) for sheet in found], style


def _failed(piece: Piece, error: TmmError) -> None:
    raise error


def alone(made: Made, language: str) -> Iterator[tuple[Piece, Box, Drawing]]:
    """Every piece of a sheet drawn by itself, with its room."""
    for place in made.sheet.layout.places:
        drawing = Drawing(made.drawing.width, made.drawing.height)
        with speaking(language):
            draw_within(drawing, place)
        yield place.piece, place.box, drawing


def beyond(drawing: Drawing, box: Box) -> list[str]:
    """Shapes that reach over a rectangle."""
    found = []
    for shape in drawing.shapes:
        z = reach(shape)
        out = max(box.left - z.real.min(), z.real.max() - box.right, box.bottom - z.imag.min(), z.imag.max() - box.top)
        if out > BEYOND:
            what = shape.text if isinstance(shape, Words | Dimension) else type(shape).__name__
            found.append(f"{what} by {out:.1f}")
    return found


def reach(shape: Shape) -> Plane:
    """Points on the border of a shape."""
    match shape:
        case Words():
            return corners(shape)
        case Dimension():
            return np.concatenate([reach(part) for part in shape.parts()])
        case Arc():
            return outline(shape)
        case _:
            return shape.points


def outline(shape: Arc) -> Plane:
    """Points along an arc."""
    count = max(3, int(shape.radius * (shape.end - shape.start) / STEP))
    return np.asarray(shape.centre + shape.radius * np.exp(1j * np.linspace(shape.start, shape.end, count + 1)))


def words_of(drawing: Drawing) -> list[Words]:
    """All words, those of dimensions too."""
    found: list[Words] = []
    for shape in drawing.shapes:
        if isinstance(shape, Dimension):
            found += [part for part in shape.parts() if isinstance(part, Words) and part.text.strip()]
        elif isinstance(shape, Words) and shape.text.strip():
            found.append(shape)
    return found


class Ink(NamedTuple):
    """Points along all lines that words keep clear of, from left to right, and the number of the shape of each."""

    at: NDArray[np.complex128]
    shape: NDArray[np.intp]


def inked(drawing: Drawing) -> Ink:
    """The lines of a drawing."""
    found: list[Plane] = []
    numbers: list[NDArray[np.intp]] = []
    for k, shape in enumerate(drawing.shapes):
        for part in shape.parts() if isinstance(shape, Dimension) else [shape]:
            if isinstance(part, Stroke | Arc) and part.pen.layer not in BENEATH:
                z = outline(part) if isinstance(part, Arc) else along(part.points, part.closed)
                found.append(z)
                numbers.append(np.full(len(z), k))
    at, shape = np.concatenate([*found, []]), np.concatenate([*numbers, []]).astype(int)
    order = np.argsort(at.real, kind="stable")
    return Ink(at[order], shape[order])


def hidden(drawing: Drawing, at: complex) -> int:
    """The number of the last shape that covers all beneath it at a place; -1: none."""
    found = -1
    for k, shape in enumerate(drawing.shapes):
        if isinstance(shape, Arc) and shape.fill:
            found = k if abs(at - shape.centre) < shape.radius else found
        elif isinstance(shape, Area) and shape.fill == WHITE:
            z = shape.points
            wide = z.real.min() < at.real < z.real.max()
            found = k if wide and z.imag.min() < at.imag < z.imag.max() else found
    return found


def along(z: Plane, closed: bool) -> Plane:
    """Points along a polyline."""
    ends = np.append(z, z[:1]) if closed else z
    steps = [np.linspace(a, b, max(2, int(abs(b - a) / STEP))) for a, b in pairwise(ends)]
    return np.concatenate(steps) if steps else ends


def boxes(words: list[Words]) -> NDArray[np.float64]:
    """Left, right, bottom and top of words (n, 4), less what only touches; of slanting ones a small square inside."""
    found = []
    for each in words:
        z = corners(each)
        if abs(np.sin(2 * each.turn)) > 1e-6:
            middle, half = z.mean(), each.height / 3
            z = middle + half * np.array([-1 - 1j, 1 + 1j])
        found.append([z.real.min() + OVER, z.real.max() - OVER, z.imag.min() + OVER, z.imag.max() - OVER])
    return np.array(found).reshape(-1, 4)


def over_words(drawing: Drawing) -> list[tuple[str, str]]:
    """Words that cover other words."""
    words = words_of(drawing)
    left, right, bottom, top = boxes(words).T
    found = []
    for k in range(len(words)):
        meet = (left[k + 1 :] < right[k]) & (right[k + 1 :] > left[k])
        meet &= (bottom[k + 1 :] < top[k]) & (top[k + 1 :] > bottom[k])
        found += [(words[k].text, words[k + 1 + j].text) for j in np.flatnonzero(meet)]
    return found


def on_lines(drawing: Drawing) -> list[str]:
    """Words that lie on a line that is seen; a line is interrupted, as the standards allow, at words with a rim."""
    words, ink = [each for each in words_of(drawing) if not each.clear], inked(drawing)
    found = []
    for each, (left, right, bottom, top) in zip(words, boxes(words), strict=True):
        near = slice(*np.searchsorted(ink.at.real, [left, right]))
        y = ink.at.imag[near]
        struck = ink.shape[near][(y > bottom) & (y < top)]
        if len(struck) and struck.max() > hidden(drawing, complex(left + right, bottom + top) / 2):
            found.append(each.text)
    return found


def told(drawing: Drawing) -> list[str]:
    """Names that the drawing itself knows to have no free place."""
    return [fault.text for field in drawing.fields for fault in field.labels.faults]


def strange(drawing: Drawing, names: set[str]) -> list[str]:
    """Words of three or more Latin letters that are no formula and no ``names`` that a user gave."""
    found = []
    for each in words_of(drawing):
        for row in each.text.split("\n"):
            plain = " ".join(part for k, part in enumerate(row.replace("\\$", "").split("$")) if k % 2 == 0)
            found += [word for word in LATIN.findall(plain) if word not in names and not KINDS.fullmatch(word)]
    return found


def names_in(document: Any) -> set[str]:
    """All words of the texts and keys that a spec holds."""
    match document:
        case str():
            return {*LATIN.findall(document)}
        case dict():
            return set().union(*(names_in(value) for value in document.values()), *map(names_in, document))
        case list():
            return set().union(*map(names_in, document))
        case _:
            return set()


def only_by_colour(drawing: Drawing) -> list[str]:
    """Curves of one diagram that differ in nothing but their colour."""
    from tmmcalc.report.drawing.diagram import Diagram

    found = []
    for field in drawing.fields:
        if not isinstance(field, Diagram):
            continue
        pens = {
            shape.pen
            for shape in drawing.shapes
            if isinstance(shape, Stroke) and len(shape.points) > 12 and _inside(shape, field.box)
        }
        found += [f"{a.layer} {b.layer}" for a, b in combinations(sorted(pens), 2) if _alike(a, b)]
    return found


def _inside(shape: Stroke, box: Box) -> bool:
    z = shape.points
    return bool(
        z.real.min() > box.left - 1
        and z.real.max() < box.right + 1
        and z.imag.min() > box.bottom - 1
        and z.imag.max() < box.top + 1
    )


def _alike(one: Pen, other: Pen) -> bool:
    return one.dashes == other.dashes and abs(one.width - other.width) < 0.15 and one.colour != other.colour
