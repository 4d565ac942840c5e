"""The picture of the feasibility stage: the margin of every constraint as a bar, the region where it holds, the rule.

Margins are parts of the limits; a bar beyond the scale ends in an arrow. A constraint that fails without harm to the
rule is grey.
"""

from __future__ import annotations

import textwrap

import numpy as np

from tmmcalc.feasibility.facts.feasibility import TRUTH
from tmmcalc.feasibility.judge import Feasibility, Verdict
from tmmcalc.report.drawing.diagram import Axis, Diagram
from tmmcalc.report.drawing.lettering import minus, width
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.page import titled
from tmmcalc.report.drawing.pens import INK, MIDDLE, WHITE, Pen
from tmmcalc.report.drawing.shapes import Area, Drawing, Hatching, Words
from tmmcalc.report.language import tr, tr_name, tr_number, tr_unit
from tmmcalc.report.numbers import number

HOLDS, FAILS, IDLE = "#009e73", "#d55e00", "#9a9a9a"
REGION = "#e3f2ec"
LEAST, MOST = 10.0, 100.0  # [%] half the scale, at least and at most
LEAST_ROWS = 5  # that a sheet is divided into
TWO_LINES = 20  # rows up to which a quantity and its limits stand in two lines
INSIDE = 0.75  # part of the scale beyond which the figure of a bar stands in it
HEIGHT = 2.3  # of words [mm]
FAILED = Pen("HATCH_FAILS", 0.25, colour=WHITE)
WRAP = 110  # characters of a line of the rule


def figure(order: Order) -> Drawing:
    """The drawing of the stage."""
    return feasibility_drawing(order.results["feasibility"])


def feasibility_drawing(result: Feasibility) -> Drawing:
    """One sheet: a bar a constraint in the order of the spec, the rule above."""
    title = "\n".join([_heading(result), *textwrap.wrap(tr("rule: {rule}", rule=result.rule), WRAP)])
    drawing, box = titled(title, 3.0)
    margins = [100 * verdict.margin for verdict in result.verdicts]
    scale = min(max(LEAST, *(1.1 * abs(margin) for margin in margins)), MOST)
    rows = max(len(result.verdicts), LEAST_ROWS)
    between = "\n" if len(result.verdicts) <= TWO_LINES else "; "
    words = [between.join([_measured(each), *_limits(each)]) for each in result.verdicts]
    height = min(HEIGHT, 0.35 * (box.height - 14) / rows)
    left = max(width(each.name, height) for each in result.verdicts) + 3
    right = max(width(each, height) for each in words) + 3
    frame = box.inset(left, 12, right, 2)
    across = Axis(tr("margin to the nearer limit, % of it"), -scale, scale)
    field = Diagram(drawing, frame, across, Axis("", 0.0, 1.0), lettered=False)
    field.band(0.0, scale, REGION)
    field.vertical(0.0, MIDDLE)
    pitch = frame.height / rows
    for row, (verdict, said) in enumerate(zip(result.verdicts, words, strict=True)):
        y = frame.top - (row + 0.5) * pitch
        drawing.add(Words(complex(frame.left - 1.5, y), verdict.name, height, 1))
        drawing.add(Words(complex(frame.right + 1.5, y), said, height, -1))
        _bar(field, y, pitch, verdict, scale, verdict.name in result.failing)
    for side, name, colour in ((1, tr("holds"), HOLDS), (-1, tr("fails"), FAILS)):
        at = complex(frame.right - 1.5 if side > 0 else frame.left + 1.5, frame.bottom + 1.5)
        drawing.add(Words(at, name, HEIGHT, side - 1j, colour=colour))
    return drawing


def _heading(result: Feasibility) -> str:
    """Whether all is kept, of what solution, and what is not."""
    values = {"n": result.chosen, "count": len(result.candidates), "failing": ", ".join(result.failing)}
    if result.candidates:
        if result.feasible:
            return tr("Constraints of solution {n} of {count}: feasible", **values)
        return tr("Constraints of solution {n} of {count}: not feasible: {failing}", **values)
    return tr("Constraints: feasible") if result.feasible else tr("Constraints: not feasible: {failing}", **values)


def _measured(verdict: Verdict) -> str:
    """The quantity with its value."""
    if verdict.quantity == TRUTH:
        return tr("given as true") if verdict.value > 0 else tr("given as false")
    return f"{tr_name(verdict.quantity)} = {_told(verdict.value, verdict)}"


def _told(value: float, verdict: Verdict) -> str:
    return f"{minus(number(value))} {tr_unit(verdict.unit)}".rstrip()


def _limits(verdict: Verdict) -> list[str]:
    """The limits that there are, in one text."""
    if verdict.quantity == TRUTH:
        return []
    low, high = (None if limit is None else _told(limit, verdict) for limit in (verdict.at_least, verdict.at_most))
    if low is not None and high is not None:
        return [tr("at least {low} and at most {high}", low=low, high=high)]
    return [tr("at least {low}", low=low) if low is not None else tr("at most {high}", high=high)]


def _bar(field: Diagram, y: float, pitch: float, verdict: Verdict, scale: float, at_fault: bool) -> None:
    """The margin, its figure at the end; what fails is hatched, so that a grey print tells it too."""
    margin, draw = 100 * verdict.margin, field.drawing
    end = min(max(margin, -scale), scale)
    colour = FAILS if at_fault else HOLDS if verdict.holds else IDLE
    zero, tip = (field.place(complex(value, 0)).real for value in (0.0, end))
    half = 0.21 * pitch
    corners = np.array([complex(x, y + h) for x, h in ((zero, -half), (tip, -half), (tip, half), (zero, half))])
    draw.add(Area(corners, colour), level=3)
    if not verdict.holds:
        draw.add(Hatching((corners,), pitch=2.0, pen=FAILED), level=3)
    if end != margin:
        side = 1 if end > 0 else -1
        head = complex(tip - 1.0 * side, y)
        draw.add(Area(head + side * np.array([2.2, 1.2j, -1.2j]), INK), level=5)
    side = 1 if verdict.margin >= 0 else -1
    inwards = -side if abs(end) > INSIDE * scale else side
    text = tr_number(minus(f"{margin:+.3g} %" if abs(margin) < 100 else f"{margin:+.0f} %"))
    at = complex(tip + (4 if inwards != side else 2) * inwards, y)
    draw.add(Words(at, text, HEIGHT, -inwards, clear=True), level=6)
