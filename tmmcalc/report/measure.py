"""What is measured on the wheels of the pairs: spans over teeth, sizes over balls, chords, each with its limits."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

from tmmcalc.gears.meshing.results import Measures, MeshPair, Pairs, SpanRow, WheelSizes
from tmmcalc.records import record
from tmmcalc.report.document import Document, Fact, View
from tmmcalc.report.meshes import known, millimetres, places, titles
from tmmcalc.report.numbers import angle, number

CHORDS = ("arc", "chord", "height", "space")
RING = "a ring has none: plates cannot span its teeth"


@record
class Measured:
    """One wheel of one pair."""

    title: str
    pair: MeshPair
    size: WheelSizes
    measures: Measures


def measure_document(result: Pairs, title: str, *, wheel: str | None = None, everything: bool = False) -> Document:
    """Every wheel, or the one of a name; with ``everything`` the spans of all in one table.

    Raises `UsageError` if no wheel is called so.
    """
    measured = list(_wheels(result))
    shown = [measured[k] for k in places([each.measures.wheel for each in measured], wheel, "wheel")]
    parts = tuple(_wheel_document(each, everything) for each in shown)
    notes = tuple(f"note: {remark}" for remark in result.remarks)
    return Document(title, (), notes, _all_spans(shown) if everything else None, parts=parts)


def _wheels(result: Pairs) -> Iterator[Measured]:
    for found, heading in zip(result.pairs, titles(result), strict=True):
        for size, measures in zip(found.sizes, found.measures, strict=True):
            name = f"wheel {measures.wheel}"
            yield Measured(name if len(result.pairs) == 1 else f"{heading}, {name}", found, size, measures)


def _wheel_document(each: Measured, everything: bool) -> Document:
    facts = [_wheel_fact(each), _base_fact(each.measures), _span_fact(each)]
    if each.size.kind != "ring":
        facts.append(_limits_fact(each.measures))
    facts += [_balls_fact(each), _constant_chord_fact(each.measures)]
    notes = tuple(f"warning: {remark}" for remark in each.measures.remarks)
    if everything:
        facts.append(Fact("chords", "", {"chords": _chord_values(each.measures)}))
        return Document(each.title, tuple(facts), notes)
    view = _spans_view(each) if each.measures.spans else None
    return Document(each.title, tuple(facts), notes, view, parts=(_chords_document(each),))


def _wheel_fact(each: Measured) -> Fact:
    size, task = each.size, each.pair.task
    form = "ring" if size.kind == "ring" else "external"
    text = f"{form}, z = {size.teeth}, x = {number(size.shift)}, m = {millimetres(task.module)}"
    if task.helix:
        text += f", beta = {angle(math.degrees(task.helix))} deg"
    text += f"\nr_a = {millimetres(size.tip)}, the involute ends at r_F = {millimetres(size.form)}"
    usable = each.measures.usable
    if usable == "active":
        text += f"\nusable to r = {millimetres(size.active_left)}, the lowest active point"
    values = {"wheel": size.name, "kind": size.kind, "z": size.teeth, "x": size.shift, "m[m]": task.module}
    values |= {"beta[rad]": task.helix, "r_a[m]": size.tip, "r_F[m]": size.form}
    return Fact("wheel", text, values | {"r_usable[m]": size.active_left, "usable_to": usable})


def _base_fact(measures: Measures) -> Fact:
    text = (
        f"p_bn = {millimetres(measures.base_pitch)}, s_bn = {millimetres(measures.base_thickness)} on the base circle"
    )
    return Fact("base pitch", text, {"p_bn[m]": measures.base_pitch, "s_bn[m]": measures.base_thickness})


def _span_fact(each: Measured) -> Fact:
    """The span for the drawing."""
    row = each.measures.span
    if row is None:
        return Fact("span", RING if each.size.kind == "ring" else f"none: {_most(each.measures)}, below 2")
    text = f"W = {millimetres(row.length)} over z_w = {row.teeth} teeth\ntouching at r = {millimetres(row.radius)}"
    if each.pair.task.helix:
        text += f", face width needed: {millimetres(row.width)}"
    text += f"\n{_verdict(each.measures, row)}"
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


def _limits_fact(measures: Measures) -> Fact:
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


def _balls_fact(each: Measured) -> Fact:
    """The size over balls or pins, of a ring between them."""
    row = each.measures.balls
    label = f"{'between' if each.size.kind == 'ring' else 'over'} two {each.pair.task.measuring.body}"
    if row is None:
        return Fact(label, "none can be measured")
    text = f"M = {millimetres(row.size)} with D = {millimetres(row.diameter)}\n"
    text += f"touching at r = {millimetres(row.radius)}"
    if not row.on_flank:
        text += "\nnot valid: they do not touch the usable involute"
    if not row.clear:
        text += "\nnot valid: they do not stand proud of the tips, or reach the root"
    values = {"D[m]": row.diameter, "M[m]": row.size, "M_radius[m]": row.radius, "rho_M[m]": row.curvature}
    values |= {"alpha_D[rad]": row.angle, "d_D[m]": row.centres}
    return Fact(label, text, values | {"M_on_flank": row.on_flank, "M_clear": row.clear})


def _constant_chord_fact(measures: Measures) -> Fact:
    text = f"s_c = {millimetres(measures.constant_chord)}, h_c = {millimetres(measures.constant_chord_height)} "
    text += "from the tip"
    if not measures.constant_chord_valid:
        text += "\nnot to be measured: it does not end on the usable involute"
    values = {
        "s_c[m]": measures.constant_chord,
        "h_c[m]": measures.constant_chord_height,
        "rho_s[m]": measures.constant_chord_curvature,
        "s_c_valid": measures.constant_chord_valid,
    }
    return Fact("constant chord", text, values)


def _spans_view(each: Measured) -> View:
    """Every span that either rule admits."""
    rows = each.measures.spans
    columns: dict[str, list[Any]] = {
        "z_w": [row.teeth for row in rows],
        "W[mm]": [1e3 * row.length for row in rows],
        "r[mm]": [1e3 * row.radius for row in rows],
    }
    if each.pair.task.helix:
        columns["b_min[mm]"] = [1e3 * row.width for row in rows]
    columns["exact"] = [row.valid for row in rows]
    columns["textbook"] = [row.book for row in rows]
    columns["remark"] = [_remark(each.measures, row) for row in rows]
    return View(list(columns), list(columns.values()))


def _remark(measures: Measures, row: SpanRow) -> str:
    return "; ".join([*(["chosen"] if row.teeth == measures.span_teeth else []), *_faults(measures, row)])


def _all_spans(shown: list[Measured]) -> View:
    """The spans of all wheels for programs."""
    rows = [(each, row) for each in shown for row in each.measures.spans]
    columns: dict[str, list[Any]] = {
        "pair": [each.pair.task.name for each, _ in rows],
        "wheel": [each.measures.wheel for each, _ in rows],
        "z_w": [row.teeth for _, row in rows],
        "W[m]": [row.length for _, row in rows],
        "r[m]": [row.radius for _, row in rows],
        "b_min[m]": [row.width for _, row in rows],
        "exact": [row.valid for _, row in rows],
        "textbook": [row.book for _, row in rows],
        "chosen": [row.teeth == each.measures.span_teeth for each, row in rows],
    }
    return View(list(columns), list(columns.values()))


def _chords_document(each: Measured) -> Document:
    helical = bool(each.pair.task.helix)
    legend = "tooth on circles: half angle theta, normal arc and chord, height of the tip above the chord, "
    legend += "arc of the space" + ("; s_t: transverse arc" if helical else "")
    rows = each.measures.chords
    columns: dict[str, list[Any]] = {
        "circle": [row.name for row in rows],
        "r[mm]": [1e3 * row.radius for row in rows],
        "theta[deg]": [round(math.degrees(row.half_angle), 4) for row in rows],
    }
    columns |= {f"{name}[mm]": [1e3 * getattr(row, name) for row in rows] for name in CHORDS}
    if helical:
        columns["s_t[mm]"] = [1e3 * row.transverse for row in rows]
    columns["alpha_y[deg]"] = [round(math.degrees(row.angle), 4) for row in rows]
    if helical:
        columns["beta_y[deg]"] = [round(math.degrees(row.helix), 4) for row in rows]
    view = View(list(columns), list(columns.values()))
    return Document("chords", (Fact("in the table", legend),), (), view, wide=True, more="--format json has them")


def _chord_values(measures: Measures) -> list[dict[str, Any]]:
    return [
        known(
            {
                "circle": row.name,
                "r[m]": row.radius,
                "theta[rad]": row.half_angle,
                "alpha_y[rad]": row.angle,
                "beta_y[rad]": row.helix,
                "s_t[m]": row.transverse,
                **{f"{name}[m]": getattr(row, name) for name in CHORDS},
            }
        )
        for row in measures.chords
    ]
