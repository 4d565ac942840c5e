"""What is measured on one wheel: span, size over or between balls, chords; modules in, metres out.

The usable involute reaches from the form circle to the tip circle, whatever part of it the mate uses.
"""

from __future__ import annotations

from math import cos, isfinite, sin

import numpy as np

from tmmcalc.errors import NoSolutionError
from tmmcalc.gears.involute.measure.balls import over_balls, usual_diameter
from tmmcalc.gears.involute.measure.chords import base_pitch_normal, constant_chord, thickness
from tmmcalc.gears.involute.measure.span import Spans, span_length, spans
from tmmcalc.gears.meshing.refusal import millimetres
from tmmcalc.gears.meshing.results import BallsRow, ChordRow, Measures, SpanRow
from tmmcalc.gears.meshing.sizes import Gear
from tmmcalc.gears.meshing.task import PairTask
from tmmcalc.records import record

LEAST_BALLS = 1e-3  # [module] balls smaller than that are none


def measures(task: PairTask, number: int, gear: Gear) -> Measures:
    """The measures of wheel 1 or 2 of a pair."""
    wheel, m = gear.wheel, task.module
    ring = wheel.teeth < 0
    span = _NO_SPAN if ring else _measured(task, number, gear)
    balls, told = _balls(task, number, gear)
    chord = constant_chord(wheel, -gear.tip if ring else gear.tip, 0.0)
    ends = sorted((_curvature(gear, gear.tip), gear.form))
    return Measures(
        task.wheels[number - 1],
        m * base_pitch_normal(wheel),
        m * span_length(wheel, 1),
        span.rows,
        span.teeth,
        m * span.lowest,
        m * span.tip,
        m * span.tip_exact,
        None if span.width is None else m * span.width,
        None if span.width_exact is None else m * span.width_exact,
        balls,
        m * float(chord.chord),
        m * float(chord.height),
        bool(ends[0] <= abs(float(chord.curvature)) <= ends[1]),
        _chords(task, gear),
        (*span.remarks, *told),
    )


def _curvature(gear: Gear, radius: float) -> float:
    """rho of the flank on a circle, 0 within the base circle."""
    return float(gear.wheel.curvature_at(max(radius, gear.base)))


@record
class _Measured:
    """The spans of a wheel; limits in modules."""

    rows: tuple[SpanRow, ...]
    teeth: int | None
    lowest: float
    tip: float
    tip_exact: float
    width: float | None
    width_exact: float | None
    remarks: tuple[str, ...]


_NO_SPAN = _Measured((), None, 0.0, 0.0, 0.0, None, None, ())


def _measured(task: PairTask, number: int, gear: Gear) -> _Measured:
    asked = task.measuring.span_teeth[number - 1]
    found = spans(gear.wheel, gear.tip, gear.form, None if task.face_width is None else task.width)
    rows = [
        SpanRow(s.teeth, task.module * s.length, task.module * s.radius, task.module * s.width, s.valid, s.book)
        for s in found.table
    ]
    if asked is not None and found.over(asked) is None:
        rows = sorted([*rows, _beyond(task, gear, asked, found.book_teeth)], key=lambda row: row.teeth)
    chosen = _chosen(task, found) if asked is None else asked
    limits = found.limits
    remarks = _span_remarks(task, gear, next((row for row in rows if row.teeth == chosen), None), found)
    return _Measured(
        tuple(rows),
        chosen,
        limits.lowest,
        limits.tip,
        limits.tip_exact,
        limits.width,
        limits.width_exact,
        remarks,
    )


def _chosen(task: PairTask, found: Spans) -> int | None:
    """z_w: the largest that the rule admits."""
    admitted = [s.teeth for s in found.table if (s.book if task.measuring.rule == "book" else s.valid)]
    return max(admitted, default=None)


def _beyond(task: PairTask, gear: Gear, teeth: int, book: int) -> SpanRow:
    """The span over a number of teeth that neither rule admits."""
    length, helix = span_length(gear.wheel, teeth), gear.wheel.section.base_helix
    radius = float(np.hypot(gear.base, length * cos(helix) / 2))
    m = task.module
    return SpanRow(teeth, m * length, m * radius, m * length * sin(helix), False, teeth <= book)


def _span_remarks(task: PairTask, gear: Gear, row: SpanRow | None, found: Spans) -> tuple[str, ...]:
    """What is wrong with the chosen span, and which would do."""
    better = "" if found.recommended is None else f"; over {found.recommended} they touch near the middle of the flank"
    if row is None:
        return (f"no span is admitted by the rule {task.measuring.rule!r}{better}",)
    if row.valid:
        return ()
    limits, length = found.limits, row.length / task.module
    if length < limits.lowest:
        why = "the plates touch beneath the usable involute"
    elif length > limits.tip_exact:
        why = "the plates reach beyond the tip circle"
    else:
        why = f"the face width is less than the {millimetres(row.width)} that it needs"
    return (f"span over {row.teeth} teeth: {why}{better}",)


def _balls(task: PairTask, number: int, gear: Gear) -> tuple[BallsRow | None, tuple[str, ...]]:
    asked, m = task.measuring.balls[number - 1], task.module
    body = task.measuring.body
    try:
        diameter = usual_diameter(gear.wheel) if asked is None else asked / m
        if not diameter > LEAST_BALLS:
            return None, (f"no {body} stand in the space",)
        found = over_balls(gear.wheel, diameter, gear.tip, gear.form, gear.root, body)
    except NoSolutionError as error:
        side = "smaller" if gear.wheel.teeth < 0 else "larger"
        limit = millimetres(m * (error.limit or 0.0))
        return None, (
            f"{body} of {millimetres(asked or 0.0)} do not stand in the space: they have to be {side} than {limit}",
        )
    if not (isfinite(found.size) and isfinite(found.curvature)):
        return None, (f"no {body} stand in the space",)
    remarks = []
    if not found.on_flank:
        remarks.append(f"{body} of {millimetres(m * diameter)} do not touch the usable involute")
    if not found.clear:
        remarks.append(f"{body} of {millimetres(m * diameter)} do not stand proud of the tip or meet the root circle")
    row = BallsRow(m * diameter, m * found.size, m * found.radius, found.on_flank, found.clear)
    return row, tuple(remarks)


def _chords(task: PairTask, gear: Gear) -> tuple[ChordRow, ...]:
    """The circles that there are on the tooth, and on which it has a thickness."""
    wheel, m = gear.wheel, task.module
    side = -1.0 if wheel.teeth < 0 else 1.0
    named = {"reference": abs(wheel.reference), "operating": gear.operating, "tip": gear.tip}
    radii = np.array(list(named.values()))
    at = thickness(wheel, side * np.maximum(radii, gear.base), side * gear.tip)
    on_tooth = (radii >= gear.base) & (side * (radii - gear.tip) <= 1e-12 * gear.tip) & (at.normal >= 0)
    columns = (at.pressure_angle, at.helix, at.normal, at.chord, at.height, at.space)
    rows = zip(named.items(), on_tooth.tolist(), *(column.tolist() for column in columns), strict=True)
    return tuple(
        ChordRow(name, m * radius, angle, helix, m * arc, m * chord, m * height, m * space)
        for (name, radius), good, angle, helix, arc, chord, height, space in rows
        if good
    )
