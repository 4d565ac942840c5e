"""The documents of a wheel without a mate: sizes for a drawing, limits of its shift, conditions, measures."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

from tmmcalc.core.notes import Phrase
from tmmcalc.core.quantity import keyed, quantities
from tmmcalc.gears.facts.measure import MeasuredWheel, measured_document, wheel_text
from tmmcalc.gears.facts.meshes import known, millimetres, reworded, written
from tmmcalc.gears.facts.pair import length_cell
from tmmcalc.gears.facts.pair_checks import check_note, judged_document, judged_values, verdict_fact
from tmmcalc.gears.meshing.profiles import Profiles
from tmmcalc.gears.single.results import SingleWheel
from tmmcalc.report.document import Document, Fact, View
from tmmcalc.report.numbers import angle, number

SIZES = ("reference", "tip", "root", "base", "form", "pointing", "thickness", "tip_thickness", "limit")
MORE = ("arc", "tip_arc", "half_angle")  # for programs
SHORT = ("wheel", "diameters", "undercut", "pointed", "measured", "verdict")  # of a summary


def summary(result: SingleWheel, title: str) -> Document:
    """What it is, its diameters, what is measured, the verdict."""
    facts = tuple(fact for fact in _facts(result) if fact.label in SHORT)
    return Document(title, facts, tuple(_notes(result)))


def document(result: SingleWheel, title: str, *, everything: bool = False) -> Document:
    """All of the wheel; with ``everything`` every digit, and the points of its profile as the table."""
    facts, notes = tuple(_facts(result)), tuple(_notes(result))
    if not everything:
        parts = (judged_document(result.checks, result.task.module, lambda _: result.task.measuring.name),)
        return Document(title, facts, notes, _sizes_view(result), parts=parts)
    from tmmcalc.gears.single.columns import wheel_columns
    from tmmcalc.report.sizes import plain

    values = known(keyed(result, *SIZES, *MORE)) | (keyed(result.strength) if result.strength else {})
    values |= {"checks": judged_values(result.checks, lambda _: result.task.measuring.name, _said)}
    table = plain(wheel_columns(result)) if result.profile is not None else None
    return Document(title, (*facts, Fact("sizes and checks", "", values)), notes, table)


def measures_of(result: SingleWheel, title: str, *, everything: bool = False) -> Document:
    """What is measured on it, with the limits of each."""
    task, ring = result.task, result.task.kind == "internal"
    text = wheel_text(ring, task.teeth, task.shift, task.module, task.helix)
    text += f"\nr_a = {millimetres(result.tip)}, the involute ends at r_F = {millimetres(result.form)}"
    values = {"kind": task.kind} | keyed(task, "teeth", "shift", "module", "helix") | keyed(result, "tip", "form")
    fact = Fact("wheel", text, values)
    heading, body = f"wheel {task.measuring.name}", task.measuring.body
    measured = MeasuredWheel(heading, "", fact, ring, bool(task.helix), body, result.measures)
    return measured_document([measured], title, everything=everything)


def profiles_of(result: SingleWheel) -> Profiles:
    """Its profile as those of pairs are told; none if it has none."""
    return Profiles(() if result.profile is None else (result.profile,), result.remarks)


def _facts(result: SingleWheel) -> Iterator[Fact]:
    task, ring = result.task, result.task.kind == "internal"
    form = f"{'helical' if task.helix else 'spur'} {'ring' if ring else 'external'}"
    text = f"z = {task.teeth}, x = {number(task.shift)}, {form}, without a mate"
    if ring:
        text += "\nsign of ISO 21771: x > 0 makes the teeth of the ring thicker"
    yield Fact("wheel", text, {"wheel": task.measuring.name, "kind": task.kind} | keyed(task, "teeth", "shift"))
    text = f"m = {millimetres(task.module)}, pitch p = {millimetres(task.pitch)}"
    text += f", transverse p_t = {millimetres(task.transverse_pitch)}" if task.helix else ""
    yield Fact("normal module", text, keyed(task, "module", "pitch", "transverse_pitch"))
    text = f"beta = {angle(math.degrees(task.helix))} deg"
    values = keyed(task, "helix") | keyed(result, "base_helix") | known(keyed(result, "lead"))
    if result.lead is not None:
        text += f", beta_b = {angle(math.degrees(result.base_helix))} deg, lead p_z = {millimetres(result.lead)}"
    yield Fact("helix angle", text, values)
    rack = task.rack
    text = f"alpha = {angle(math.degrees(rack.angle))} deg, h_a* = {number(rack.addendum)}, "
    text += f"c* = {number(rack.clearance)}, rho* = {number(rack.radius, 5)}"
    yield Fact("basic rack", text, keyed(rack))
    if task.cutter is not None:
        yield Fact(
            "cutter", f"z_0 = {task.cutter.teeth}, x_0 = {number(task.cutter.shift)}", {"z_0": task.cutter.teeth}
        )
    if task.face_width is not None:
        yield Fact("face width", f"b = {millimetres(task.face_width)}", keyed(task, "face_width"))
    yield Fact("transverse angle", f"alpha_t = {written(result.angle_t)}", keyed(result, "angle_t"))
    rows = (("d", result.reference), ("d_a", result.tip), ("d_f", result.root), ("d_b", result.base))
    lines = [f"{symbol} = {millimetres(2 * radius)}" for symbol, radius in rows]
    yield Fact("diameters", ", ".join(lines[:2]) + "\n" + ", ".join(lines[2:]))
    yield from _limit_facts(result)
    if result.strength is not None:
        text = f"Y_F = {number(result.strength.factor, 5)} with the load at the tip"
        yield Fact("tooth form", text, keyed(result.strength))
    yield Fact("measured", "\n".join(_measured(result)), _measured_values(result))
    yield verdict_fact(result.checks)


def _measured(result: SingleWheel) -> Iterator[str]:
    """What a working drawing states."""
    measures = result.measures
    if measures.span is not None:
        yield f"W = {millimetres(measures.span.length)} over {measures.span.teeth} teeth"
    if measures.balls is not None:
        body, row = result.task.measuring.body, measures.balls
        yield f"M = {millimetres(row.size)} with {body} of {millimetres(row.diameter)}"
    yield f"s_c = {millimetres(measures.constant_chord)}, h_c = {millimetres(measures.constant_chord_height)}"


def _measured_values(result: SingleWheel) -> dict[str, Any]:
    measures = result.measures
    values = keyed(measures, "base_pitch", "constant_chord", "constant_chord_height")
    if measures.span is not None:
        values |= keyed(measures.span, "teeth", "length")
    if measures.balls is not None:
        values |= keyed(measures.balls, "diameter", "size")
    return values


def _limit_facts(result: SingleWheel) -> Iterator[Fact]:
    """Shifts between which whole teeth are neither undercut nor pointed."""
    if result.least_shift is not None and result.least_teeth is not None:
        text = f"none from x_min = {number(result.least_shift)}; at this shift from z_min = "
        text += number(result.least_teeth, 5, 1.0)
        yield Fact("undercut", text, keyed(result, "least_shift", "least_teeth"))
    lines = []
    if result.task.kind == "internal" and result.pointed_shift is not None:
        lines.append(f"the tip circle of whole teeth reaches the base circle at x_max = {number(result.pointed_shift)}")
    elif result.pointed_shift is not None:
        lines.append(f"whole teeth at x_max = {number(result.pointed_shift)}")
    if result.thin_shift is not None:
        wanted = number(result.task.tip_thickness_wanted)
        lines.append(f"their tips have {wanted} m at x = {number(result.thin_shift)}")
    if result.pointing is not None:
        lines.append(f"the flanks of this one meet at r_s = {millimetres(result.pointing)}")
    values = known(keyed(result, "pointed_shift", "thin_shift"))
    yield Fact("limit of the tip" if result.task.kind == "internal" else "pointed", "\n".join(lines), values)


def _sizes_view(result: SingleWheel) -> View:
    """Sizes down the page."""
    told = quantities(SingleWheel)
    rows = [(told[name], getattr(result, name)) for name in SIZES]
    rows = [row for row in rows if row[1] is not None]
    columns: list[list[Any]] = [[size.meaning for size, _ in rows], [size.name for size, _ in rows]]
    columns.append([length_cell(value) for _, value in rows])
    return View(["size", "symbol", "value[mm]"], columns)


def _said(text: str) -> str:
    """A condition in words, of the only wheel that there is."""
    return reworded(text, lambda number, place: ("the ring", {}))


def _notes(result: SingleWheel) -> Iterator[str]:
    for check in sorted(result.checks, key=lambda check: check.verdict != "fail"):
        if check.verdict != "ok":
            yield check_note(check, _said(check.text))
    for remark in result.remarks:
        yield Phrase("warning: {remark}", remark=remark)
    yield from result.measures.remarks
