"""What is measured on the wheels of the pairs: spans over teeth, sizes over balls, chords, each with its limits."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from tmmcalc.core.notes import Phrase
from tmmcalc.core.quantity import keyed, table
from tmmcalc.core.records import record
from tmmcalc.gears.facts.meshes import known, millimetres, places, titles
from tmmcalc.gears.facts.spans import all_spans, limits_fact, span_fact, spans_view
from tmmcalc.gears.meshing.results import ChordRow, Measures, Pairs, WheelSizes
from tmmcalc.gears.meshing.task import PairTask
from tmmcalc.report.document import Document, Fact, View
from tmmcalc.report.numbers import angle, number


@record
class MeasuredWheel:
    """One wheel, and what is told of it."""

    title: str
    pair: str  # name of its pair
    wheel: Fact  # what it is
    ring: bool
    helical: bool
    body: str  # balls or pins
    measures: Measures


def measure_document(result: Pairs, title: str, *, wheel: str | None = None, everything: bool = False) -> Document:
    """Every wheel, or the one of a name; with ``everything`` the spans of all in one table.

    Raises `UsageError` if no wheel is called so.
    """
    measured = list(_wheels(result))
    shown = [measured[k] for k in places([each.measures.wheel for each in measured], wheel, "wheel")]
    notes = tuple(Phrase("note: {remark}", remark=remark) for remark in result.remarks)
    return measured_document(shown, title, notes, everything=everything)


def measured_document(
    shown: Sequence[MeasuredWheel], title: str, notes: tuple[str, ...] = (), *, everything: bool = False
) -> Document:
    """The document of these wheels."""
    parts = tuple(_wheel_document(each, everything) for each in shown)
    spans = all_spans([(each.pair, each.measures) for each in shown]) if everything else None
    return Document(title, (), notes, spans, parts=parts)


def _wheels(result: Pairs) -> Iterator[MeasuredWheel]:
    for found, heading in zip(result.pairs, titles(result), strict=True):
        for size, measures in zip(found.sizes, found.measures, strict=True):
            name = f"wheel {measures.wheel}"
            task = found.task
            yield MeasuredWheel(
                name if len(result.pairs) == 1 else f"{heading}, {name}",
                task.name,
                _wheel_fact(size, task, measures),
                size.kind == "ring",
                bool(task.helix),
                task.measuring.body,
                measures,
            )


def _wheel_document(each: MeasuredWheel, everything: bool) -> Document:
    helical = each.helical
    facts = [each.wheel, _base_fact(each.measures), span_fact(each.measures, ring=each.ring, helical=helical)]
    if not each.ring:
        facts.append(limits_fact(each.measures))
    facts += [_balls_fact(each), _constant_chord_fact(each.measures)]
    notes = each.measures.remarks
    if everything:
        facts.append(Fact("chords", "", {"chords": [known(keyed(row)) for row in each.measures.chords]}))
        return Document(each.title, tuple(facts), notes)
    view = spans_view(each.measures, helical=helical) if each.measures.spans else None
    return Document(each.title, tuple(facts), notes, view, parts=(_chords_document(each),))


def wheel_text(ring: bool, teeth: int, shift: float, module: float, helix: float) -> str:
    """A wheel by its numbers."""
    text = f"{'ring' if ring else 'external'}, z = {teeth}, x = {number(shift)}, m = {millimetres(module)}"
    return text + (f", beta = {angle(math.degrees(helix))} deg" if helix else "")


def _wheel_fact(size: WheelSizes, task: PairTask, measures: Measures) -> Fact:
    text = wheel_text(size.kind == "ring", size.teeth, size.shift, task.module, task.helix)
    text += f"\nr_a = {millimetres(size.tip)}, the involute ends at r_F = {millimetres(size.form)}"
    if measures.usable == "active":
        text += f"\nusable to r = {millimetres(size.active_left)}, the lowest active point"
    values = keyed(size, "name", "kind", "teeth", "shift") | keyed(task, "module", "helix")
    values |= keyed(size, "tip", "form", "active_left") | keyed(measures, "usable")
    return Fact("wheel", text, values)


def _base_fact(measures: Measures) -> Fact:
    text = (
        f"p_bn = {millimetres(measures.base_pitch)}, s_bn = {millimetres(measures.base_thickness)} on the base circle"
    )
    return Fact("base pitch", text, keyed(measures, "base_pitch", "base_thickness"))


def _balls_fact(each: MeasuredWheel) -> Fact:
    """The size over balls or pins, of a ring between them."""
    row = each.measures.balls
    label = f"{'between' if each.ring else 'over'} two {each.body}"
    if row is None:
        return Fact(label, "none can be measured")
    text = f"M = {millimetres(row.size)} with D = {millimetres(row.diameter)}\n"
    text += f"touching at r = {millimetres(row.radius)}"
    if not row.on_flank:
        text += "\nnot valid: they do not touch the usable involute"
    if not row.clear:
        text += "\nnot valid: they do not stand proud of the tips, or reach the root"
    return Fact(
        label, text, keyed(row, "diameter", "size", "radius", "curvature", "angle", "centres", "on_flank", "clear")
    )


def _constant_chord_fact(measures: Measures) -> Fact:
    text = f"s_c = {millimetres(measures.constant_chord)}, h_c = {millimetres(measures.constant_chord_height)} "
    text += "from the tip"
    if not measures.constant_chord_valid:
        text += "\nnot to be measured: it does not end on the usable involute"
    parts = ("constant_chord", "constant_chord_height", "constant_chord_curvature", "constant_chord_valid")
    return Fact("constant chord", text, keyed(measures, *parts))


def _chords_document(each: MeasuredWheel) -> Document:
    helical = each.helical
    legend = "tooth on circles: half angle theta, normal arc and chord, height of the tip above the chord, "
    legend += "arc of the space" + ("; s_t: transverse arc" if helical else "")
    columns = table(
        each.measures.chords,
        ChordRow,
        *("name", "radius[mm]", "half_angle[deg]", "arc[mm]", "chord[mm]", "height[mm]", "space[mm]"),
        *(("transverse[mm]", "angle[deg]", "helix[deg]") if helical else ("angle[deg]",)),
    )
    columns |= {header: [round(each, 4) for each in columns[header]] for header in columns if header.endswith("[deg]")}
    view = View(list(columns), list(columns.values()))
    return Document("chords", (Fact("in the table", legend),), (), view, wide=True, more="--format json has them")
