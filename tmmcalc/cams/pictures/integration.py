"""The graphical integration of a law, drawn: S'' with its rays from the pole, the chords of S' and S under it.

Ordinates are numbered as positions are: each moving phase has equal intervals, a dwell is one. The given curve and the
exact law are thin and coloured, what is constructed is black.
"""

from __future__ import annotations

from math import ceil, degrees, radians
from typing import NamedTuple

import numpy as np

from tmmcalc.cams.lawresult import LawResult
from tmmcalc.cams.laws.graphical import Construction
from tmmcalc.cams.pictures.lawdiagrams import Pieces, pieces_of, shown_scale, symbol, unit_of
from tmmcalc.cams.pictures.toscale import factor, turn_factor
from tmmcalc.cams.program import Program
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.field import Field
from tmmcalc.report.drawing.key import samples_in_rows
from tmmcalc.report.drawing.lettering import width
from tmmcalc.report.drawing.pens import CURVES, INK, MIDDLE, THIN, WHITE, Pen
from tmmcalc.report.drawing.scales import standard_scale
from tmmcalc.report.drawing.shapes import Arc, Dimension, Drawing, Words
from tmmcalc.report.language import tr, tr_unit
from tmmcalc.report.numbers import number

INTERVALS = 12  # of a moving phase: the textbook draws 8 to 12
ORDINATE = Pen("ORDINATES", 0.13, colour="#b8b8b8")
CARRIED = Pen("CARRIED_OVER", 0.13, (1.6, 0.8), "#6b6b6b")
RAY = Pen("RAYS", 0.18, colour=INK)
CHORD = Pen("CONSTRUCTION", 0.6)
SHARES = (1.2, 1.5, 1.8, 2.1)  # that the height of the diagram of S'' may have of the others
AIR = 5.0  # above and below the values of a diagram [mm]
RIGHT = 8.0  # beyond the last ordinate, for the name of the abscissa [mm]
BEFORE = 7.0  # beyond the pole, for its name [mm]
BESIDE = 2.5  # between the axis of the rays and the diagram, beside the numbers [mm]
POLE_LEAST, POLE_STEP = 15.0, 5.0  # pole distances are whole multiples of the second [mm]
WORDS = (9.5, 13.0)  # room of the line above, and of those below [mm]
GAP = 4.0  # between diagrams [mm]
APART = 3.2  # of two numbers [mm]
NUMBER, NAME = 1.8, 2.8  # heights of numbers and names [mm]
SAME = 1e-9  # of the largest: mean ordinates that are one point of the axis


class Layout(NamedTuple):
    """Lengths on paper [mm], and what a mm stands for."""

    heights: tuple[float, float, float]  # of the diagrams of S'', S', S
    along: float  # [deg]
    up: tuple[float, float, float]  # of S'', S', S, as they are shown
    poles: tuple[float, float]
    beside: float  # from the axis of the rays to the diagram

    @property
    def left(self) -> float:
        """From the left side to the diagram."""
        return max(self.poles) + BEFORE + self.beside


def integration_heading(result: LawResult) -> str:
    """What the picture is called."""
    places = {"bend": symbol(result, 2), "slope": symbol(result, 1), "place": symbol(result, 0)}
    return tr("Graphical integration of the law of motion: from ${bend}$ to ${slope}$ and ${place}$", **places)


def draw_integration(
    drawing: Drawing, box: Box, program: Program, result: LawResult, made: Construction
) -> list[Field]:
    """The construction in a rectangle; the diagrams of S'', S', S."""
    exact = [(phi, shown_scale(result, 1) * motion) for phi, motion in pieces_of(program) if phi[0] < _end(made)]
    inner = box.inset(0, WORDS[1], 0, WORDS[0])
    layout = _layout(inner, exact, made)
    frames = inner.split(*layout.heights, gap=GAP)
    spare = (box.width - layout.left - degrees(_end(made)) / layout.along - RIGHT) / 2
    fields = []
    for frame, order, step in zip(frames, (2, 1, 0), layout.up, strict=True):
        low, high = _range(exact, order)
        middle, half = (low + high) / 2, step * frame.height / 2
        origin = complex(-(spare + layout.left) * layout.along, middle - half)
        fields.append(Field(drawing, frame, origin, (1 / layout.along, 1 / step)))
    _draw_ordinates(fields, made)
    for field, order in zip(fields, (2, 1, 0), strict=True):
        _draw_axes(field, degrees(_end(made)), f"${symbol(result, order)}$")
        for phi, motion in exact:
            field.curve(np.degrees(phi) + 1j * motion[order], _pen(order), level=7)
    scale = shown_scale(result, 1)
    for k in (0, 1):
        _draw_rays(fields[k], scale, made, layout, k)
    for field, order in zip(fields[1:], (1, 0), strict=True):
        for strip in made.strips:
            heights = scale * (strip.slope if order else strip.place)
            field.curve(np.degrees(strip.phi) + 1j * heights, CHORD, weight=1.0, level=6)
    _write(drawing, box, result, made, layout)
    return fields


def _pen(order: int) -> Pen:
    """Of the exact curve."""
    return CURVES[order]._replace(dashes=(), width=0.3)


def _end(made: Construction) -> float:
    return float(made.strips[-1].phi[-1])


def _range(exact: Pieces, order: int) -> tuple[float, float]:
    values = np.concatenate([motion[order] for _, motion in exact])
    return min(float(values.min()), 0.0), max(float(values.max()), 0.0)


def _layout(box: Box, exact: Pieces, made: Construction) -> Layout:
    """S'' as high as a standard scale makes it; the largest scale of the abscissa beside which the poles have room."""
    spans = [high - low for low, high in (_range(exact, order) for order in (2, 1, 0))]
    found = []
    for share in SHARES:
        heights = [part.height for part in box.split(share, 1.0, 1.0, gap=GAP)]
        bend = standard_scale(spans[0] / (heights[0] - 2 * AIR))
        found.append((bend, heights))
    bend, heights = min(found, key=lambda each: each[0])
    labels = [", ".join(names) for order in (0, 1) for _, names in _grouped(made, order)]
    beside = max(width(label, NUMBER) for label in labels) + BESIDE
    span = degrees(_end(made))
    along = standard_scale(span / box.width)
    while True:
        for coarser in (1.0, 2.0):  # a lower diagram of S'' has a nearer pole: better than a short abscissa
            up, poles = _stepped(spans, heights, radians(along), standard_scale(coarser * bend))
            layout = Layout((heights[0], heights[1], heights[2]), along, up, poles, beside)
            if layout.left + span / along + RIGHT <= box.width:
                return layout
        along = standard_scale(1.01 * along)


def _stepped(
    spans: list[float], heights: list[float], along: float, bend: float
) -> tuple[tuple[float, float, float], tuple[float, float]]:
    """What a mm stands for in the diagrams of S'', S', S, and the pole distances with which the last two fit.

    ``along`` radians and ``bend`` of S'' to a mm.
    """
    ups, poles = [bend], []
    for size, height in zip(spans[1:], heights[1:], strict=True):
        unit = ups[-1] * along  # of the integral to a mm, for a pole distance of 1 mm
        poles.append(max(POLE_LEAST, POLE_STEP * ceil(size / (height - 2 * AIR) / unit / POLE_STEP - 1e-9)))
        ups.append(unit * poles[-1])
    return (ups[0], ups[1], ups[2]), (poles[0], poles[1])


def _grouped(made: Construction, order: int) -> list[tuple[float, list[str]]]:
    """Mean ordinates [SI] of y'' (order 0) or of the constructed y', each with the numbers of all its intervals."""
    found: list[tuple[float, list[str]]] = []
    every = [(strip, strip.mean if order else strip.bend) for strip in made.strips]
    peak = max(float(np.max(np.abs(values))) for _, values in every)
    for strip, values in every:
        for k, value in enumerate(values.tolist()):
            label = str(strip.first + k + 1)  # that of its last ordinate
            same = next((names for other, names in found if abs(other - value) < SAME * peak), None)
            if same is None:
                found.append((value, [label]))
            else:
                same.append(label)
    return found


def _draw_ordinates(fields: list[Field], made: Construction) -> None:
    """Thin lines through all diagrams, numbered above and below."""
    top, bottom = fields[0].box.top, fields[-1].box.bottom
    places = {strip.first + k: phi for strip in made.strips for k, phi in enumerate(strip.phi.tolist())}
    before = -np.inf
    for label, phi in places.items():
        at = fields[0].place(complex(degrees(phi))).real
        fields[0].drawing.line([complex(at, top), complex(at, bottom)], ORDINATE, level=-2)
        if at - before >= APART:
            before = at
            for y, side in ((top, -1j), (bottom, 1j)):
                fields[0].drawing.add(Words(complex(at, y) - 0.6 * side, str(label), NUMBER, side))


def _draw_axes(field: Field, end: float, name: str) -> None:
    """Both axes with their names and arrows."""
    zero, right = field.place(0j), field.place(complex(end)) + RIGHT - 3.0
    low, high = complex(zero.real, field.box.bottom), complex(zero.real, field.box.top)
    field.drawing.vector(zero, right, MIDDLE, level=3)
    field.drawing.vector(low, high, MIDDLE, level=3)
    field.labels.avoid([zero, right], 1.0)
    field.labels.avoid([low, high], 1.0)
    field.drawing.add(Words(right + 0.8 + 0.8j, "$φ$", NAME, -1 - 1j))
    field.drawing.add(Words(high + 1.5 - 0.5j, name, NAME, -1 + 1j, clear=True))


def _draw_rays(field: Field, scale: float, made: Construction, layout: Layout, order: int) -> None:
    """Mean ordinates carried over to the axis of the rays, these from their pole, numbered by their intervals."""
    draw, foot, pole = field.drawing, field.place(0j) - layout.beside, layout.poles[order]
    at = foot - pole
    for strip in made.strips:
        middles = np.degrees((strip.phi[:-1] + strip.phi[1:]) / 2)
        for here in field.paper(middles + 1j * scale * (strip.mean if order else strip.bend)).tolist():
            draw.line([complex(foot.real, here.imag), here], CARRIED, level=2)
            draw.add(Arc(here, 0.35, THIN, fill=INK), level=8)
    tips = [(field.place(1j * scale * value) - layout.beside, names) for value, names in _grouped(made, order)]
    for tip, _ in tips:
        draw.line([at, tip], RAY, level=2)
        field.labels.avoid([at, tip], 0.4)
    highest, lowest = (pick(tip.imag for tip, _ in tips) for pick in (max, min))
    draw.line([complex(foot.real, lowest), complex(foot.real, highest)], MIDDLE, level=3)
    draw.line([at, field.place(0j)], MIDDLE, level=3)
    draw.add(Arc(at, 0.7, MIDDLE, fill=WHITE), level=8)
    field.labels.avoid([at - 0.7, at + 0.7], 2.0)
    field.labels.put(f"$P_{order + 1}$", [at], height=NAME, prefer=-1 + 1j)
    _number_rays(field, tips)
    line = complex(at.real, field.box.bottom + 2.0)
    draw.add(Dimension(at, foot, line, f"$H_{order + 1}$ = {number(pole)}", 2.3, 0.0), level=3)


def _number_rays(field: Field, tips: list[tuple[complex, list[str]]]) -> None:
    """The intervals of the rays beside their axis, on the line carried over, where the next one is not too near."""
    heights = [tip.imag for tip, _ in tips]
    for tip, names in tips:
        if not any(0 < height - tip.imag < 1.25 * NUMBER for height in heights):
            field.drawing.add(Words(tip + 0.8 + 0.25j, ", ".join(names), NUMBER, -1 - 1j), level=9)


def _write(drawing: Drawing, box: Box, result: LawResult, made: Construction, layout: Layout) -> None:
    """Scale factors above, below the errors and what the lines are."""
    units = [unit_of(result, 2), unit_of(result, 1), tr_unit("rad") if result.turns else unit_of(result, 0)]
    factors = [factor(symbol(result, order), mu, unit)
               for order, mu, unit in zip((2, 1, 0), layout.up, units, strict=True)]  # fmt: skip
    for k in (1, 2):
        signs = [f"μ_{{{symbol(result, order).removeprefix('Δ')}}}" for order in (2 - k, 3 - k)]
        value = factors[k].rpartition(" = ")[2]
        factors[k] = f"${signs[0]}$ = ${signs[1]}$ $μ_φ$ $H_{k}$ = {value}"
    text = ";   ".join([turn_factor(layout.along), *factors])
    drawing.add(Words(complex(box.middle.real, box.top), text, min(2.6, box.width / width(text)), 1j))
    said = tr(
        "Error of the construction with {count} intervals a phase: {slope} % of the largest ${sign}$, {place} % of "
        "the stroke",
        count=INTERVALS,
        slope=number(100 * made.slope_error, 3, 1.0),
        place=number(100 * made.place_error, 3, 1.0),
        sign=symbol(result, 1),
    )
    foot = complex(box.middle.real, box.bottom + WORDS[1] - 5.0)
    drawing.add(Words(foot, said, min(2.4, box.width / width(said)), 1j))
    lines = Box(box.left, box.bottom, box.right, box.bottom + 3.0)
    samples = [(tr("exact ${sign}$", sign=symbol(result, order)), _pen(order)) for order in (2, 1, 0)]
    samples_in_rows(drawing, lines, [*samples, (tr("chords of the construction"), CHORD)], 2.0)
