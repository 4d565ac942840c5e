"""The blocking contour on a page: its point of shifts is moved, sizes and figures follow by the note's formulas.

They are those of whole flanks of two wheels cut by a rack; an undercut takes from the contact what they do not know.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from tmmcalc.core.plane import Plane
from tmmcalc.gears.meshing.contours import Outline, PairContour
from tmmcalc.gears.meshing.results import MeshPair
from tmmcalc.gears.notes.pair import BY_SHIFTS, MODIFIED, OPERATING, REFERENCE, SHORTENED, TOTAL
from tmmcalc.gears.notes.pairs import contact, sizes
from tmmcalc.gears.notes.pairs.lexicon import PLUS, WHOLE, Told, indexed, of_index, told_of, words_of
from tmmcalc.gears.pictures.contourplane import content_of
from tmmcalc.report.drawing.lettering import plain
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.exploring import Curve, Point, Region, Shown, Trial
from tmmcalc.report.formula.carried import Step, step_of
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.formula.symbols import canonical
from tmmcalc.report.formula.syntax import read
from tmmcalc.report.formula.tree import names
from tmmcalc.report.language import tr, tr_name
from tmmcalc.report.telling import filled

EDGE = 0.06  # about what is shown, in its parts
OF_PAIR = "a_w", "alpha_tw", "Deltay", "eps_alpha", "eps_gamma", "theta_1", "theta_2", "lambda_P", "c_1"
BEGINS = {"theta_1": "rho_p1", "theta_2": "rho_p2"}  # within the base circle there is no flank to slide
OF_WHEEL = "<sna>", "r_a<i>", "r_f<i>", "r_w<i>", "h<_i>"


def trials(order: Order) -> Iterator[Trial]:
    """The contours of all pairs that have one."""
    pairs = {found.task.name or found.task.title: found for found in order.results["pair"].pairs}
    for k, contour in enumerate(order.results["blocking"].pairs, 1):
        found = pairs.get(contour.name)
        if found is not None and found.task.kind == "external":
            yield trial_of(found, contour, f"blocking_{k}")


def trial_of(found: MeshPair, contour: PairContour, name: str) -> Trial:
    """The plane of a pair with its contours, the chosen shifts as its point."""
    told = told_of(found)
    formulas = [read(text) for text in texts(told)]
    steps = [step_of(formula) for formula in formulas]
    inputs, known = ("x_1", "x_2"), {step.name for step in steps}
    needed = dict.fromkeys(key for formula in formulas for key in names(formula) if key not in known)
    low, high = content_of(contour).tolist()
    over = EDGE * max((high - low).real, (high - low).imag) * (1 + 1j)
    return Trial(
        name,
        tr("Blocking contour {pair}", pair=plain(tr_name(contour.name))),
        inputs,
        complex(*found.shifts),
        (low - over, high + over),
        tuple(_regions(contour)),
        tuple(Curve(line.number, tr_name(line.title), line.value, line.x1 + 1j * line.x2) for line in contour.lines),
        tuple(Point(tr_name(each.name), tr_name(each.title), complex(each.x1, each.x2)) for each in contour.points),
        {key: _inner(told.lexicon[key]) for key in needed if key not in inputs},
        tuple(steps),
        tuple(_shown(told, contour, steps)),
    )


def texts(told: Told) -> Iterator[str]:
    """The formulas of an external pair with given shifts, from these to all that is told, by wheel."""
    task = told.found.task
    helical, wide = bool(task.helix), bool(told.found.overlap)
    words = {**told.words, **WHOLE}
    wheels = [{**words, **of_index(str(k), words_of(task)), **PLUS} for k in (1, 2)]
    given = [tip is not None for tip in task.tips]

    def of_pair(*own: str) -> Iterator[str]:
        yield from (filled(text, words) for text in own)

    def of_wheels(*own: str) -> Iterator[str]:
        yield from (filled(text, each) for each in wheels for text in own)

    yield from of_pair(*sizes.SECTION * helical, REFERENCE, TOTAL, BY_SHIFTS, OPERATING, MODIFIED, SHORTENED)
    yield from of_wheels(*sizes.CIRCLES, sizes.PITCH, sizes.ROOT, *sizes.LIMIT)
    yield from (filled(sizes.SHORTENED_TIP, each) for each, kept in zip(wheels, given, strict=True) if not kept)
    yield from of_wheels(sizes.HEIGHT, sizes.THICKNESS, *(sizes.TRANSVERSE,) * helical)
    yield from of_wheels(sizes.TIP_ANGLE, sizes.TIP_ARC, *sizes.TIP_NORMAL * helical, contact.TIP, contact.PITCH_POINT)
    yield from of_pair(sizes.BETWEEN, contact.TEETH, contact.BASE_PITCH, *contact.ENDS["external"], contact.RATIO)
    yield from of_pair(*contact.OVERLAP * wide, *contact.SLIDING, *contact.PRESSURE, *contact.CLEARANCES["external"])


def _inner(given: Given) -> float:
    """A value as formulas take it."""
    assert isinstance(given.value, float | int)
    return math.radians(given.value) if given.unit == "deg" else float(given.value)


def _regions(contour: PairContour) -> Iterator[Region]:
    """The tolerated contour beneath the strict one, pieces that lie apart."""
    for area, kind in ((contour.tolerated, "tolerated"), (contour.strict, "strict")):
        yield from (Region("piece", _closed(piece)) for piece in area.pieces)
        if area.main is not None:
            yield Region("strict" if kind == "strict" else "tolerated", _closed(area.main))


def _closed(outline: Outline) -> Plane:
    return np.asarray(outline.x1 + 1j * outline.x2)


def _shown(told: Told, contour: PairContour, steps: list[Step]) -> Iterator[Shown]:
    """Shifts, sizes and figures with their limits."""
    task, known = told.found.task, {step.name for step in steps}
    style = words_of(task)
    own = [indexed(quantities, str(k), style) for k, quantities in enumerate(told.own, 1)]
    for k, quantities in enumerate(own, 1):
        words = {**style, **of_index(str(k), style)}
        yield Shown(f"x_{k}", quantities[f"x_{k}"].meaning, "", canonical(filled("<xmin>", words)))
    least = {"eps_alpha": contour.contact_ratio}
    for key in OF_PAIR:
        if key in known:
            given = told.lexicon[key]
            yield Shown(key, given.meaning, given.unit, least.get(key), BEGINS.get(key, ""))
    for template in OF_WHEEL:
        for k, quantities in enumerate(own, 1):
            key = filled(template, {**style, **of_index(str(k), style)})
            given = quantities[key]
            thick = 1e3 * task.module * contour.thickness if template == "<sna>" else None
            yield Shown(canonical(key), given.meaning, given.unit, thick)
