"""The picture of a synthesis: the linkage in its two extreme positions with dimensions, or at the points it generates.

Of a path the wanted points stand beside the coupler curve, of a motion the poses as short lines, of a function the
output over the crank's angle and its error.
"""

from __future__ import annotations

import math

import numpy as np

from tmmcalc.linkage.chain import chain_of
from tmmcalc.linkage.kinematics import solve_kinematics
from tmmcalc.linkage.model import Mechanism
from tmmcalc.linkage.pictures.cycle import whole_cycle
from tmmcalc.linkage.pictures.paths import draw_wanted
from tmmcalc.linkage.pictures.scheme import draw_scheme
from tmmcalc.linkage.results import Kinematics
from tmmcalc.linkage.synthesis.results import Design, Precision, Synthesis
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.diagram import Axis, Diagram, room
from tmmcalc.report.drawing.field import Board
from tmmcalc.report.drawing.key import Part, write_key
from tmmcalc.report.drawing.lettering import minus
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.page import sheets
from tmmcalc.report.drawing.pens import CURVES, MARK, Pen
from tmmcalc.report.drawing.shapes import Dimension, Drawing, Words
from tmmcalc.report.language import tr, tr_name, tr_unit
from tmmcalc.report.numbers import number
from tmmcalc.report.rows import check_choice

# Links that are dimensioned, by kind: symbol and the two points.
LENGTHS = {
    "slider_crank": (("r", "A", "B"), ("l", "B", "C")),
    "slotted_link": (("r", "A", "B"), ("L", "C", "A"), ("R", "C", "D"), ("l", "D", "E")),
    "rotating_slotted_link": (("r", "A", "B"), ("L", "C", "A"), ("R", "C", "D"), ("l", "D", "E")),
    "crank_rocker": (("r", "A", "B"), ("l", "B", "C"), ("R", "D", "C"), ("L", "A", "D")),
    "trailing_rod": (("r", "O", "A"), ("l", "A", "B"), ("l_C", "A", "C"), ("l_4", "C", "D")),
}
STROKES = {  # slider whose stroke is dimensioned, and the side of its guide on which there is room
    "slider_crank": ("C", 1j),
    "slotted_link": ("E", 1j),
    "rotating_slotted_link": ("E", 1j),
    "trailing_rod": ("B", -1j),
}
SYMBOLS = {"lambda": "λ", "alpha": "α", "beta": "β", "eps": "ε", "psi": "ψ", "gamma": "γ", "two_phi": "2φ"}
MEASURE = Pen("DIMENSIONS", 0.2, colour=MARK.colour)
BESIDE = 6.5  # of a dimension line from what it measures [mm of paper]
DEGREE = math.degrees(1.0)


def figure(order: Order) -> Drawing:
    """The drawing of the stage: the solution that is chosen, by default the one that ``tmmcalc synth`` chooses."""
    from tmmcalc.linkage.pictures.dwell import dwell_drawing
    from tmmcalc.linkage.tables.tasks.mechanism import to_linkage

    result: Synthesis = order.results["synthesis"]
    choose = order.choice or (order.solved("feasibility").chosen if order.spec.constraints else 1)
    check_choice(choose, len(result.designs), "solution")
    design = result.designs[choose - 1]
    mechanism = to_linkage(order.read(design.spec).linkage)
    if design.dwell is not None:
        return dwell_drawing(mechanism, design, design.dwell)
    return synthesis_drawing(mechanism, result, choose)


def synthesis_drawing(mechanism: Mechanism, result: Synthesis, choose: int = 1) -> Drawing:
    """One sheet: the scheme to scale, beside it sizes and figures of merit, or the function."""
    design = result.designs[choose - 1]
    drawing, (box,) = sheets(1)
    title = tr("Synthesis: {name}", name=tr_name(design.name))
    drawing.add(Words(complex(box.middle.real, box.top), title, 3.5, 1j))
    scheme, beside = box.inset(0, 0, 0, 7).split(2.1, 1.0, gap=5, across=True)
    precision = design.precision
    if precision is not None and not len(precision.points):
        beside, diagrams = beside.split(1.0, 1.0, gap=2)
        draw_function(drawing, diagrams, precision)
    draw_solution(drawing, scheme, mechanism, result.kind, design)
    write_key(drawing, beside, _parts(design))
    return drawing


def proportion(mechanism: Mechanism) -> float:
    """Height over width of what a linkage reaches."""
    motion = solve_kinematics(mechanism)
    reached = np.concatenate((motion.trace.r.ravel(), [*mechanism.frame.points.values()]))
    return float(np.ptp(reached.imag) / (np.ptp(reached.real) or 1.0))


def draw_solution(drawing: Drawing, box: Box, mechanism: Mechanism, kind: str, design: Design) -> None:
    """The scheme of a linkage to scale, with its dimensions or the wanted points."""
    motion, precision = solve_kinematics(mechanism), design.precision
    cycle = whole_cycle(chain_of(mechanism, motion), motion)
    board = draw_scheme(drawing, box, motion, cycle, _positions(motion, precision))
    if precision is None:
        _dimensions(board, mechanism, motion, kind, design)
    elif len(precision.points):
        draw_wanted(board, precision.points)


def _positions(motion: Kinematics, precision: Precision | None) -> list[int]:
    """Rows of the two dead centres of the first output, or of the generated points."""
    if precision is not None:
        places = precision.crank
    else:
        places = np.array([centre.x for centre in motion.summaries[0].dead_centres])
    rows = [int(np.argmin(np.abs(np.angle(np.exp(1j * (motion.x - x)))))) for x in places]
    return list(dict.fromkeys(rows))


def _place(mechanism: Mechanism, motion: Kinematics, name: str, row: int) -> complex:
    """Place of a named point."""
    if name in mechanism.frame.points:
        return mechanism.frame.points[name]
    return complex(motion.trace.r[motion.trace.point_names.index(name), row])


def _dimensions(board: Board, mechanism: Mechanism, motion: Kinematics, kind: str, design: Design) -> None:
    """Lengths along the links of the first position, the stroke between both, the offset of the guide."""
    rows = _positions(motion, None)
    for symbol, one, two in LENGTHS.get(kind, ()):
        a, b = (_place(mechanism, motion, name, rows[0]) for name in (one, two))
        text = f"${_symbol(symbol)}$ = {number(1e3 * design.size(symbol), 5)}"
        anchors = board.paper([a + t * (b - a) for t in (0.5, 0.35, 0.65)])
        board.labels.put(text, anchors, height=2.2, colour=MARK.colour)
    if kind in STROKES and len(rows) > 1:
        slider, side = STROKES[kind]
        ends = [_place(mechanism, motion, slider, row) for row in rows[:2]]
        stroke = design.check("S").achieved
        _dimension_line(board, ends[0], ends[1], f"$S$ = {number(1e3 * stroke, 5)}", side)
        fixed = mechanism.frame.points
        pivot = fixed.get("A" if kind == "slider_crank" else "C", 0j)
        guide = fixed.get("G", pivot)  # the guides of a V-engine pass the axis of its crank
        off = guide.imag - pivot.imag
        if abs(off) > 3 * board.mu:
            foot = complex(pivot.real, guide.imag)
            _dimension_line(board, pivot, foot, f"$e$ = {minus(number(1e3 * off, 5))}", -1.0)


def _dimension_line(board: Board, a: complex, b: complex, text: str, side: complex) -> None:
    """A dimension at ``side`` of what it measures."""
    ends = board.paper([a, b])
    first, second = ends.tolist()
    made = Dimension(first, second, first + side * BESIDE, text, 2.2, pen=MEASURE)
    board.drawing.add(made, level=14)
    board.labels.avoid(ends + side * BESIDE, 2.0)


def draw_function(drawing: Drawing, box: Box, found: Precision) -> None:
    """The output at the points over the crank's angle, and its error over the range."""
    unit, factor = ("mm", 1e3) if found.unit == "m" else ("°", DEGREE)
    x, fine = DEGREE * found.crank, DEGREE * found.fine
    low, high = float(min(x.min(), fine.min())), float(max(x.max(), fine.max()))
    across = Axis("$φ$, °", low - 0.03 * (high - low), high + 0.03 * (high - low), True)
    upper, lower = box.inset(16, 9, 2, 5).split(1, 1, gap=9)
    wanted, reached = factor * found.wanted, factor * found.found
    both = np.concatenate((wanted, reached))
    air = 0.08 * float(np.ptp(both)) or 1.0
    ends = Axis(f"{tr('output coordinate')}, {tr_unit(unit)}", float(both.min()) - air, float(both.max()) + air)
    above = Diagram(drawing, upper, across, ends, numbered=False)
    above.dots(x, wanted, CURVES[0], 0.9)
    above.dots(x, reached, CURVES[1], 0.45)
    above.key([(tr("wanted"), CURVES[0]), (tr("simulated"), CURVES[1])])
    error, missed = factor * found.error, factor * (found.found - found.wanted)
    below = Diagram(drawing, lower, across, Axis(f"{tr('error')}, {tr_unit(unit)}", *room([error, missed])))
    below.curve(fine + 1j * error, CURVES[0])
    below.dots(x, missed, CURVES[1], 0.6)


def _parts(design: Design) -> list[Part]:
    sizes = [
        (f"${_symbol(size.symbol)}$, {tr_name(size.meaning)}", _shown(size.value, size.unit)) for size in design.sizes
    ]
    merits = []
    for name, value in design.merits.items():
        label, unit = name.rstrip("]").partition("[")[::2]
        shown, unit = (1e3 * value, "mm") if unit == "m" else (value, unit.replace("deg", "°"))
        merits.append((tr_name(label.replace("_", " ")), f"{minus(number(shown, 5))} {tr_unit(unit)}".strip()))
    checks = [
        (tr_name(check.name), f"{_shown(check.achieved, check.unit)}" + ("" if check.target is None else "  ✓"))
        for check in design.checks
    ]
    parts = [Part(tr("Sizes"), sizes), Part(tr("By simulation"), checks), Part(tr("Figures of merit"), merits)]
    return [
        *parts,
        *(
            [Part(tr("Defects"), [(tr_name(words.split(":")[0]), "") for words in design.defects])]
            if design.defects
            else []
        ),
    ]


def _symbol(name: str) -> str:
    """The sign of a size as a formula."""
    letter, _, index = name.partition("_")
    if name in SYMBOLS:
        return SYMBOLS[name]
    letter = {"phi": "φ", "psi": "ψ", "eps": "ε"}.get(letter, letter)
    return f"{letter}_{{{index}}}" if index else letter


def _shown(value: float, unit: str) -> str:
    if unit == "rad":
        return f"{minus(number(DEGREE * value, 6))}°"
    return f"{minus(number(1e3 * value, 6))} {tr_unit('mm')}" if unit == "m" else minus(number(value, 6))
