"""The blocking contour on a page: its point of shifts is moved; sizes, figures and teeth follow by formulas.

They are those of the note for two wheels cut by a rack. What an undercut leaves of the contact is told by the fillets
(`tmmcalc.gears.views.teeth`), which stand between the sizes and the contact that there is.
"""

from __future__ import annotations

import math
from collections.abc import Container, Iterator

import numpy as np

from tmmcalc.core.plane import Plane
from tmmcalc.gears.meshing.contours import Area, Outline, PairContour
from tmmcalc.gears.meshing.results import MeshPair
from tmmcalc.gears.notes.pair import BY_SHIFTS, MODIFIED, OPERATING, REFERENCE, SHORTENED, TOTAL
from tmmcalc.gears.notes.pairs import contact, sizes
from tmmcalc.gears.notes.pairs.lexicon import PLUS, SHORT, Told, indexed, of_index, told_of, words_of
from tmmcalc.gears.pictures.contourplane import content_of
from tmmcalc.gears.views.teeth import Tooth, axes_of_rounding, conditions_of, sketch_of
from tmmcalc.report.drawing.lettering import plain
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.exploring import Curve, Kind, Point, Region, Shown, Trial
from tmmcalc.report.formula.carried import needed, step_of
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.formula.symbols import canonical
from tmmcalc.report.formula.syntax import read
from tmmcalc.report.language import tr, tr_name
from tmmcalc.report.telling import filled

EDGE = 0.06  # about what is shown, in its parts
OF_PAIR = (
    *("a_w", "alpha_tw", "Deltay", "eps_alpha", "eps'_alpha", "eps_gamma"),
    *("theta_1", "theta_2", "lambda_P", "c_1"),
)
LEFT = dict.fromkeys(("theta_1", "theta_2", "lambda_P"), "eps'_alpha")  # flanks that do not touch have none
OF_WHEEL = "<sna>", "r_a<i>", "r_f<i>", "r_w<i>", "h<_i>"


def trials(order: Order) -> Iterator[Trial]:
    """The contours of all external pairs."""
    external = [found for found in order.results["pair"].pairs if found.task.kind == "external"]
    for k, (found, contour) in enumerate(zip(external, order.results["blocking"].pairs, strict=True), 1):
        yield trial_of(found, contour, f"blocking_{k}")


def trial_of(found: MeshPair, contour: PairContour, name: str) -> Trial:
    """The plane of a pair with its contours, the chosen shifts as its point."""
    told, teeth = told_of(found), (Tooth(found, 1), Tooth(found, 2))
    sized, touching = ([step_of(read(text)) for text in texts(told)] for texts in (sizes_of, contact_of))
    steps = [*sized, *teeth[0].steps(), *teeth[1].steps(), *touching]
    inputs, rounded = ("x_1", "x_2"), axes_of_rounding(found)
    asked = [key for key in needed(steps) if key not in (*inputs, *rounded)]
    low, high = content_of(contour).tolist()
    over = EDGE * max((high - low).real, (high - low).imag) * (1 + 1j)
    return Trial(
        name,
        tr("Blocking contour {pair}", pair=plain(tr_name(found.task.title))),
        inputs,
        complex(*found.shifts),
        (low - over, high + over),
        tuple(_regions(contour)),
        tuple(Curve(line.number, tr_name(line.title), line.value, line.x1 + 1j * line.x2) for line in contour.lines),
        tuple(Point(tr_name(each.name), tr_name(each.title), complex(each.x1, each.x2)) for each in contour.points),
        {**rounded, **{key: _inner(told.lexicon[key]) for key in asked}},
        tuple(steps),
        tuple(_shown(told, contour, {step.name for step in steps})),
        tuple(conditions_of(found, teeth)),
        sketch_of(found, teeth),
    )


def sizes_of(told: Told) -> Iterator[str]:
    """The formulas of an external pair from its shifts to the circles of its wheels and the contact of whole flanks."""
    task = told.found.task
    helical = bool(task.helix)
    wheels = [{**told.words, **of_index(str(k), words_of(task)), **PLUS} for k in (1, 2)]

    def of_pair(*own: str) -> Iterator[str]:
        yield from (filled(text, told.words) for text in own)

    def of_wheels(*own: str) -> Iterator[str]:
        yield from (filled(text, each) for each in wheels for text in own)

    yield from of_pair(*sizes.SECTION * helical, REFERENCE, TOTAL, BY_SHIFTS, OPERATING, MODIFIED, SHORTENED)
    yield from of_wheels(*sizes.CIRCLES, sizes.PITCH, sizes.ROOT, *sizes.LIMIT)
    yield from (filled(sizes.SHORTENED_TIP, each) for each, tip in zip(wheels, task.tips, strict=True) if tip is None)
    yield from of_wheels(sizes.HEIGHT, sizes.THICKNESS, *(sizes.TRANSVERSE,) * helical)
    yield from of_wheels(sizes.TIP_ANGLE, sizes.TIP_ARC, *sizes.TIP_NORMAL * helical, contact.TIP, contact.PITCH_POINT)
    yield from of_pair(sizes.BETWEEN, contact.TEETH, contact.BASE_PITCH, *contact.ENDS["external"], contact.RATIO)
    yield from of_pair(*contact.OVERLAP * bool(told.found.overlap), *contact.CLEARANCES["external"])


def contact_of(told: Told) -> Iterator[str]:
    """The formulas of the contact that undercut and fillets leave, by where the involutes end."""
    words = {**told.words, **SHORT, "end1": "rho_F1", "end2": "rho_F2"}
    for text in (*contact.LEFT["external"], contact.LEFT_RATIO, *contact.SLIDING, *contact.PRESSURE):
        yield filled(text, words)


def _inner(given: Given) -> float:
    """A value as formulas take it."""
    assert isinstance(given.value, float | int)
    return math.radians(given.value) if given.unit == "deg" else float(given.value)


def _regions(contour: PairContour) -> Iterator[Region]:
    """The tolerated contour beneath the strict one, of both the parts that lie apart first."""
    kinds: tuple[tuple[Area, Kind], ...] = (contour.tolerated, "tolerated"), (contour.strict, "strict")
    for area, kind in kinds:
        yield from (Region(kind, _closed(piece), apart=True) for piece in area.pieces)
        if area.main is not None:
            yield Region(kind, _closed(area.main))


def _closed(outline: Outline) -> Plane:
    return np.asarray(outline.x1 + 1j * outline.x2)


def _shown(told: Told, contour: PairContour, known: Container[str]) -> Iterator[Shown]:
    """Shifts, sizes and figures with their limits, of what is known."""
    task = told.found.task
    style = words_of(task)
    own = [indexed(quantities, str(k), style) for k, quantities in enumerate(told.own, 1)]
    for k, quantities in enumerate(own, 1):
        words = {**style, **of_index(str(k), style)}
        yield Shown(f"x_{k}", quantities[f"x_{k}"].meaning, "", canonical(filled("<xmin>", words)))
    least = {"eps_alpha": contour.contact_ratio, "eps'_alpha": contour.contact_ratio, "c_1": 0.0}
    for key in OF_PAIR:
        if key in known and key in told.lexicon:
            given = told.lexicon[key]
            yield Shown(key, given.meaning, given.unit, least.get(key), LEFT.get(key, ""))
    for template in OF_WHEEL:
        for k, quantities in enumerate(own, 1):
            key = filled(template, {**style, **of_index(str(k), style)})
            given = quantities[key]
            thick = 1e3 * task.module * contour.thickness if template == "<sna>" else None
            yield Shown(canonical(key), given.meaning, given.unit, thick)
