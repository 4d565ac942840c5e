"""The picture of a synthesis: the linkage in its two extreme positions with dimensions, or at the points it generates.

Of a path the wanted points stand beside the coupler curve, of a motion the poses as short lines, of a function the
output over the crank's angle and its error.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from tmmcalc.core.errors import UsageError
from tmmcalc.linkage.chain import chain_of
from tmmcalc.linkage.kinematics import solve_kinematics
from tmmcalc.linkage.model import Mechanism
from tmmcalc.linkage.pictures.cycle import whole_cycle
from tmmcalc.linkage.pictures.scheme import draw_scheme, prepare
from tmmcalc.linkage.results import Kinematics
from tmmcalc.linkage.synthesis.results import Design, Precision, Synthesis
from tmmcalc.report.drawing.board import Board
from tmmcalc.report.drawing.key import Part, write_key
from tmmcalc.report.drawing.labels import signed
from tmmcalc.report.drawing.order import CHOOSE, Order
from tmmcalc.report.drawing.page import blank, settle
from tmmcalc.report.drawing.style import CURVES, MARK, PATH
from tmmcalc.report.numbers import number

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
SYMBOLS = {
    "lambda": "\\lambda",
    "alpha": "\\alpha",
    "beta": "\\beta",
    "eps": "\\varepsilon",
    "psi": "\\psi",
    "gamma": "\\gamma",
    "two_phi": "2\\varphi",
}
BESIDE = 6.5  # of a dimension line from what it measures [mm of paper]
DEGREE = math.degrees(1.0)


def figure(order: Order) -> Figure:
    """The figure of the stage: the solution that is chosen, by default the one that ``tmmcalc synth`` chooses."""
    from tmmcalc.linkage.pictures.dwell import dwell_figure
    from tmmcalc.linkage.tables.tasks.mechanism import to_linkage

    result: Synthesis = order.results["synthesis"]
    choose = order.choice or (order.solved("feasibility").chosen if order.spec.constraints else 1)
    if choose > len(result.designs):
        raise UsageError(f"there is no solution {choose}", where=CHOOSE, remedy=f"write 1 to {len(result.designs)}")
    design = result.designs[choose - 1]
    mechanism = to_linkage(order.read(design.spec).linkage)
    if design.dwell is not None:
        return dwell_figure(mechanism, design, design.dwell)
    return synthesis_figure(mechanism, result, choose)


def synthesis_figure(mechanism: Mechanism, result: Synthesis, choose: int = 1) -> Figure:
    """One sheet: the scheme to scale, beside it sizes and figures of merit, or the function."""
    design, motion = result.designs[choose - 1], solve_kinematics(mechanism)
    figure, (sheet,) = blank(1)
    sheet.suptitle(f"{result.kind.replace('_', ' ').capitalize()} synthesis: {design.name}", fontsize=10)
    precision = design.precision
    grid = sheet.add_gridspec(3, 2, width_ratios=[2.1, 1.0], height_ratios=[2.4, 1.0, 1.0])
    scheme = sheet.add_subplot(grid[:, 0])
    cycle = whole_cycle(chain_of(mechanism, motion), motion)
    prepare(scheme, cycle)
    functional = precision is not None and not len(precision.points)
    key = sheet.add_subplot(grid[0 if functional else slice(None), 1])
    key.set_axis_off()
    if precision is not None and functional:
        _function(sheet.add_subplot(grid[1, 1]), sheet.add_subplot(grid[2, 1]), precision)
    settle(figure)
    board = draw_scheme(scheme, motion, cycle, _positions(motion, precision))
    if precision is None:
        _dimensions(board, mechanism, motion, result.kind, design)
    elif len(precision.points):
        _wanted(board, precision)
    write_key(key, _parts(design))
    return figure


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
        board.labels.put(text, [a + t * (b - a) for t in (0.5, 0.35, 0.65)], size=7.5, color=MARK)
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
            _dimension_line(board, pivot, foot, f"$e$ = {number(1e3 * off, 5)}", -1.0)


def _dimension_line(board: Board, a: complex, b: complex, text: str, side: complex) -> None:
    """A line with arrowheads at ``side`` of what it measures, with thin lines to its ends."""
    shift = side * BESIDE * board.mu
    style: dict[str, Any] = {"color": MARK, "linewidth": 0.6, "zorder": 14}
    for end in (a, b):
        board.line([end, end + 1.15 * shift], **style)
    one, two = a + shift, b + shift
    board.line([one, two], **style)
    board.arrowhead(one, one - two, facecolor=MARK)
    board.arrowhead(two, two - one, facecolor=MARK)
    board.labels.put(text, [(one + two) / 2, one + 0.3 * (two - one)], size=7.5, color=MARK, prefer=side)


def _wanted(board: Board, found: Precision) -> None:
    """The wanted points as numbered crosses; of poses short lines in the direction of the body."""
    for k, at in enumerate(found.points.tolist()):
        size = 1.6 * board.mu
        for way in (1 + 1j, 1 - 1j):
            board.line([at - size * way, at + size * way], color=MARK, linewidth=1.2, zorder=15)
        if len(found.points) <= 24:
            board.labels.put(str(k + 1), [at], size=6.5, color=MARK)


def _function(above: Axes, below: Axes, found: Precision) -> None:
    """The output at the points over the crank's angle, and its error over the range."""
    unit, factor = ("mm", 1e3) if found.unit == "m" else ("°", DEGREE)
    x = DEGREE * found.crank
    above.plot(x, factor * found.wanted, "o", color=MARK, markersize=4, label="wanted")
    above.plot(x, factor * found.found, "x", color=PATH, markersize=5, label="simulated")
    above.set_ylabel(f"output, {unit}")
    above.legend()
    below.plot(DEGREE * found.fine, factor * found.error, linewidth=1.2, **CURVES[0])
    below.plot(x, factor * (found.found - found.wanted), "o", color=MARK, markersize=4)
    below.axhline(0.0, color="#555555", linewidth=0.5)
    below.set_ylabel(f"error, {unit}")
    below.set_xlabel("$\\varphi$, °")


def _parts(design: Design) -> list[Part]:
    sizes = [(f"${_symbol(size.symbol)}$, {size.meaning}", _shown(size.value, size.unit)) for size in design.sizes]
    merits = []
    for name, value in design.merits.items():
        label, unit = name.rstrip("]").replace("_", " ").partition("[")[::2]
        shown, unit = (1e3 * value, "mm") if unit == "m" else (value, unit.replace("deg", "°"))
        merits.append((label, f"{signed(shown, 5)} {unit}".strip()))
    checks = [
        (check.name, f"{_shown(check.achieved, check.unit)}" + ("" if check.target is None else "  ✓"))
        for check in design.checks
    ]
    parts = [Part("Sizes", sizes), Part("By simulation", checks), Part("Figures of merit", merits)]
    return [
        *parts,
        *([Part("Defects", [(words.split(":")[0], "") for words in design.defects])] if design.defects else []),
    ]


def _symbol(name: str) -> str:
    """The sign of a size as a formula."""
    letter, _, index = name.partition("_")
    if name in SYMBOLS:
        return SYMBOLS[name]
    letter = {"phi": "\\varphi", "psi": "\\psi", "eps": "\\varepsilon"}.get(letter, letter)
    return f"{letter}_{{\\mathrm{{{index}}}}}" if index else (letter if len(letter) == 1 else f"\\mathrm{{{letter}}}")


def _shown(value: float, unit: str) -> str:
    if unit == "rad":
        return f"{signed(DEGREE * value, 6)}°"
    return f"{signed(1e3 * value, 6)} mm" if unit == "m" else signed(value, 6)
