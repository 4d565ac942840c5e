"""The span over teeth of a wheel: the one for the drawing, its limits by both rules, all that either rule admits."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from tmmcalc.gears.facts.meshes import millimetres
from tmmcalc.gears.meshing.results import Measures, SpanRow
from tmmcalc.report.document import Fact, View

RING = "a ring has none: plates cannot span its teeth"


def span_fact(measures: Measures, *, ring: bool, helical: bool) -> Fact:
    """The span for the drawing."""
    row = measures.span
    if row is None:
        return Fact("span", RING if ring else f"none: {_most(measures)}, below 2")
    text = f"W = {millimetres(row.length)} over z_w = {row.teeth} teeth\ntouching at r = {millimetres(row.radius)}"
    if helical:
        text += f", face width needed: {millimetres(row.width)}"
    text += f"\n{_verdict(measures, row)}"
    values: dict[str, Any] = {"z_w": row.teeth, "W[m]": row.length, "W_radius[m]": row.radius, "b_min[m]": row.width}
    values |= {"W_rho[m]": row.curvature}
    return Fact("span", text, {**values, "W_exact": row.valid, "W_textbook": row.book})


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
    values = {
        "z_w_max": measures.span_most,
        "z_w_max_exact_width": measures.span_most_exact,
        "z_w_middle": measures.span_middle,
        "W_lowest[m]": measures.span_lowest,
        "W_lowest_active[m]": measures.span_lowest_active,
        "W_star[m]": measures.span_tip,
        "W_star_exact[m]": exact,
        "W_starstar[m]": measures.span_width,
        "W_starstar_exact[m]": measures.span_width_exact,
    }
    return Fact("its limits", "\n".join(lines), values)


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
    columns: dict[str, list[Any]] = {
        "z_w": [row.teeth for row in rows],
        "W[mm]": [1e3 * row.length for row in rows],
        "r[mm]": [1e3 * row.radius for row in rows],
    }
    if helical:
        columns["b_min[mm]"] = [1e3 * row.width for row in rows]
    columns["exact"] = [row.valid for row in rows]
    columns["textbook"] = [row.book for row in rows]
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
        "z_w": [row.teeth for _, _, row in rows],
        "W[m]": [row.length for _, _, row in rows],
        "r[m]": [row.radius for _, _, row in rows],
        "b_min[m]": [row.width for _, _, row in rows],
        "exact": [row.valid for _, _, row in rows],
        "textbook": [row.book for _, _, row in rows],
        "chosen": [row.teeth == measures.span_teeth for _, measures, row in rows],
    }
    return View(list(columns), list(columns.values()))
