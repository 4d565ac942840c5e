"""The train 2A-(AA with bar) in real numbers: its teeth for the ratio asked, and between which ratios it exists."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.notes import Note, Phrase
from tmmcalc.core.quantity import keyed
from tmmcalc.gears.radial import (
    WITHIN,
    RadialShape,
    RatioLimits,
    denominator,
    ratio_limits,
    real_teeth,
    usual_assembly,
)
from tmmcalc.gears.trains import Request
from tmmcalc.report.document import Document, Fact, View
from tmmcalc.report.numbers import number

SHAPES = (0.5, 1.0, 1.5, 2.0, 3.0)  # y = Z3/Z2 of the table of limits
PAIRS = ((1.0, 1.0), (0.8, 1.0), (1.2, 1.0), (1.0, 0.8), (1.0, 1.2), (0.8, 1.2), (1.2, 0.8))  # its (t1, t2)


def radial_document(request: Request, everything: bool = False) -> Document:
    """Real-valued teeth and limits of i_1H with the train's own parameters, then the limits over y and (t1, t2)."""
    shape, planets = request.radial or RadialShape(), request.task.planets
    ratio = 1 + float(request.task.nominal)
    facts = [_shape_fact(shape)]
    notes = list(_shape_notes(shape))
    try:
        facts += _teeth_facts(ratio, planets, shape, request.task.limits.least)
        notes += _ratio_notes(ratio, ratio_limits(planets, y=shape.y, t1=shape.t1, t2=shape.t2))
    except NoSolutionError as fault:
        notes.append(
            Phrase("warning: {message}; what would help: {remedy}", message=fault.message, remedy=fault.remedy)
        )
    facts.append(Fact("in the table", "i_1H lies above i_min and below i_max, 2/Z1 neglected (7), (8)"))
    view = _limits_view(planets, shape, everything)
    return Document(f"{request.title}: real-valued teeth, limits of the ratio", tuple(facts), tuple(notes), view)


def _shape_fact(shape: RadialShape) -> Fact:
    text = f"y = Z3/Z2 = {number(shape.y)}, t1 = {number(shape.t1)}, t2 = {number(shape.t2)}"
    values = keyed(shape, "y", "t1", "t2")
    if shape.angles is not None:
        text += f"\nof the mesh angles {', '.join(number(angle) for angle in shape.degrees)} deg of 1-2, 2-3, 3-4"
        values |= keyed(shape, "degrees")
    return Fact("parameters", text, values)


def _shape_notes(shape: RadialShape) -> Iterator[str]:
    for name, value in (("t1", shape.t1), ("t2", shape.t2)):
        if not WITHIN[0] <= value <= WITHIN[1]:
            text = Phrase(
                "{name} = {value} is outside {low:g} to {high:g}, which is usual",
                name=name,
                value=number(value),
                low=WITHIN[0],
                high=WITHIN[1],
            )
            yield Note("warning", text, value=value, limit=WITHIN[value > WITHIN[1]], name=name)


def _teeth_facts(ratio: float, planets: int, shape: RadialShape, least: int) -> Iterator[Fact]:
    """Denominator, limits and teeth, in this order: the later ones may not exist."""
    below = denominator(shape.y, shape.t1, shape.t2)
    yield Fact("denominator", f"D = 1 + t1 (1 + y) - y t2 = {number(below)}", {"denominator": below})
    limits = ratio_limits(planets, y=shape.y, t1=shape.t1, t2=shape.t2)
    yield _limits_fact(limits)
    assembly = shape.assembly or usual_assembly(ratio, planets, least)
    chosen = "" if shape.assembly else f", the least with {least} teeth of sun 1 or more"
    text = f"i_1H = {number(ratio, 10)}, k = {planets}, N = (Z1 + Z4)/k = {assembly}{chosen}"
    yield Fact("asked for", text, {"i_1H": ratio, "k": planets, "N": assembly})
    teeth = real_teeth(ratio, planets, assembly, y=shape.y, t1=shape.t1, t2=shape.t2)
    found = keyed(teeth, "z1", "z2", "z3", "z4")
    text = ", ".join(f"{name} = {number(value)}" for name, value in found.items())
    yield Fact("real-valued teeth", text, found | keyed(teeth, "residual"))


def _limits_fact(limits: RatioLimits) -> Fact:
    lines = [f"above {number(limits.coaxial)}: planet 2 has teeth (7)"]
    if limits.first is not None:
        lines.append(f"below {number(limits.first)}: neighbouring planets 2 clear each other (8)")
        if limits.second is None:
            lines.append("neighbouring planets 3 set no limit: B = 0")
        else:
            side = "below" if limits.second_is_upper else "above"
            lines.append(f"{side} {number(limits.second)}: neighbouring planets 3 do, B = {number(limits.bracket)} (8)")
    else:
        lines.append("no limit by neighbours: there are fewer than three pairs")
    values = keyed(limits, "coaxial", "first", "bracket", "second", "second_is_upper")
    if limits.first is None:
        values |= dict.fromkeys(keyed(limits, "bracket"))
    if limits.second is None:
        values |= dict.fromkeys(keyed(limits, "second_is_upper"))
    ends = [limits.low] if limits.high is None else [limits.low, limits.high]
    return Fact("limits of i_1H", "\n".join(lines), values | {"i_range": ends})


def _ratio_notes(ratio: float, limits: RatioLimits) -> Iterator[str]:
    if limits.high is not None and ratio >= limits.high:
        which = 2 if limits.high == limits.first else 3
        text = Phrase(
            "i_1H = {ratio} is not below {high}: neighbouring planets {which} overlap; fewer pairs, or another y, t1, "
            "t2 would help",
            ratio=number(ratio),
            high=number(limits.high),
            which=which,
        )
        yield Note("warning", text, value=ratio, limit=limits.high, name="i_1H")


def _limits_view(planets: int, shape: RadialShape, everything: bool) -> View:
    """Limits for every y and pair (t1, t2), those of the train itself first."""
    rows = list(dict.fromkeys([(shape.y, shape.t1, shape.t2), *((y, *pair) for pair in PAIRS for y in SHAPES)]))
    columns: dict[str, list[Any]] = {name: [] for name in ("y", "t1", "t2", "D", "i_min", "i_max", "i_max by")}
    for row in rows:
        for name, cell in zip(columns, (*row, *_limits_cells(planets, *row)), strict=True):
            shown = cell if everything or isinstance(cell, str) else number(cell)
            columns[name].append(shown)
    return View(list(columns), list(columns.values()))


def _limits_cells(planets: int, y: float, t1: float, t2: float) -> tuple[float | str, ...]:
    """D, i_min, i_max and its reason; words where the train does not close."""
    try:
        below, limits = denominator(y, t1, t2), ratio_limits(planets, y=y, t1=t1, t2=t2)
    except NoSolutionError:
        return 1 + t1 * (1 + y) - y * t2, "", "", "D <= 0: does not close"
    if limits.high is None:
        return below, limits.low, "", "no limit"
    return below, limits.low, limits.high, "planets 2" if limits.high == limits.first else "planets 3"
