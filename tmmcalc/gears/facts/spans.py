"""The span over teeth of a wheel: the one for the drawing, its limits by both rules, all that either rule admits."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from tmmcalc.core.quantity import keyed, table
from tmmcalc.gears.facts.meshes import millimetres
from tmmcalc.gears.meshing.results import Measures, SpanRow
from tmmcalc.report.document import Fact, View

RING = "a ring has none: plates cannot span its teeth"
LIMITS = (
    "span_most",
    "span_most_exact",
    "span_middle",
    "span_lowest",
    "span_lowest_active",
    "span_tip",
    "span_tip_exact",
    "span_width",
    "span_width_exact",
)


def span_fact(measures: Measures, *, ring: bool, helical: bool) -> Fact:
    """The span for the drawing."""
    row = measures.span
    if row is None:
        return Fact("span", RING if ring else f"none: {_most(measures)}, below 2")
    text = f"W = {millimetres(row.length)} over z_w = {row.teeth} teeth\ntouching at r = {millimetres(row.radius)}"
    if helical:
        text += f", face width needed: {millimetres(row.width)}"
    text += f"\n{_verdict(measures, row)}"
    values = keyed(row, "teeth", "length", "radius", "width", "curvature", "valid", "book")
    return Fact("span", text, values)


def _most(measures: Measures) -> str:
    """z_w,max by the textbook's face width, and by the exact one where that differs."""
    text = f"z_w,max = {measures.span_most}"
    if measures.span_most_exact != measures.span_most:
        text += f" ({measures.span_most_exact} by the exact face width)"
    return text


def _verdict(measures: Measures, row: SpanRow) -> str:
    """Whether a span can be measured, by both rules."""
    text = "valid" if row.valid else f"not valid: {'; '.join(_faults(measures, row))}"
    return f"{text}; {'admitted' if row.book else 'not admitted'} by the textbook's rule"


def limits_fact(measures: Measures) -> Fact:
    """Lower and upper limits of W by both rules."""
    lines = [f"{_most(measures)}; mid-flank: {measures.span_middle}"]
    lines.append(f"W above {millimetres(measures.span_lowest)}: else the plates touch beneath the involute")
    if measures.usable == "active":
        lines.append(f"and above {millimetres(measures.span_lowest_active)}: the lowest active point")
    text = f"tip circle: W* = {millimetres(measures.span_tip)} (4.62)"
    exact = measures.span_tip_exact
    lines.append(text if exact == measures.span_tip else f"{text}, exactly {millimetres(exact)}")
    if measures.span_width is not None and measures.span_width_exact is not None:
        text = f"face width: W** = {millimetres(measures.span_width)} (4.64)"
        lines.append(f"{text}, exactly {millimetres(measures.span_width_exact)}")
    return Fact("its limits", "\n".join(lines), keyed(measures, *LIMITS))


def _faults(measures: Measures, row: SpanRow) -> list[str]:
    """Why the plates do not touch the usable involute."""
    found = []
    if row.length < measures.span_lowest:
        found.append("beneath the involute")
    elif row.length < measures.span_lowest_active:
        found.append("beneath the active flank")
    if row.length > measures.span_tip_exact:
        found.append("beyond the tip")
    if measures.span_width_exact is not None and row.length > measures.span_width_exact:
        found.append("the face is too narrow")
    return found


def spans_view(measures: Measures, *, helical: bool) -> View:
    """Every span that either rule admits."""
    rows = measures.spans
    columns = table(rows, SpanRow, "teeth", "length[mm]", "radius[mm]", *(["width[mm]"] if helical else []))
    columns |= table(rows, SpanRow, "valid", "book")
    columns["remark"] = [_remark(measures, row) for row in rows]
    return View(list(columns), list(columns.values()))


def _remark(measures: Measures, row: SpanRow) -> str:
    return "; ".join([*(["chosen"] if row.teeth == measures.span_teeth else []), *_faults(measures, row)])


def all_spans(shown: Sequence[tuple[str, Measures]]) -> View:
    """The spans of wheels, each with the name of its pair, for programs."""
    rows = [(pair, measures, row) for pair, measures in shown for row in measures.spans]
    columns: dict[str, list[Any]] = {
        "pair": [pair for pair, _, _ in rows],
        "wheel": [measures.wheel for _, measures, _ in rows],
        **table([row for _, _, row in rows], SpanRow, "teeth", "length", "radius", "width", "valid", "book"),
        "chosen": [row.teeth == measures.span_teeth for _, measures, row in rows],
    }
    return View(list(columns), list(columns.values()))
