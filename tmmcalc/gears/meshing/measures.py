"""What is measured on one wheel: span, size over or between balls, chords; modules in, metres out.

The usable involute reaches from the lowest active point, or the form circle if that is nearer to the tip, to the tip
circle.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import cos, isfinite, sin
from typing import Any

import numpy as np

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.notes import Note, Phrase
from tmmcalc.core.records import record
from tmmcalc.gears.involute.measure.balls import over_balls, usual_diameter
from tmmcalc.gears.involute.measure.chords import base_pitch_normal, constant_chord, thickness
from tmmcalc.gears.involute.measure.span import LEAST, Spans, span_length, spans
from tmmcalc.gears.meshing.refusal import millimetres
from tmmcalc.gears.meshing.results import BallsRow, ChordRow, Measures, SpanRow
from tmmcalc.gears.meshing.sizes import Gear
from tmmcalc.gears.meshing.task import WheelMeasuring

LEAST_BALLS = 1e-3  # [module] balls smaller than that are none
NOISE = 1e-9  # [module] by which the active point and the end of the involute may differ


def measures(asked: WheelMeasuring, gear: Gear, radii: Sequence[float] = ()) -> Measures:
    """The measures of a wheel, its chords on the circles of ``radii`` [m] too."""
    wheel, m = gear.wheel, asked.module
    ring = wheel.teeth < 0
    span = _NO_SPAN if ring else _measured(asked, gear)
    balls, told = _balls(asked, gear)
    chord = constant_chord(wheel, -gear.tip if ring else gear.tip, 0.0)
    highest = float(wheel.curvature_at(max(gear.tip, gear.base)))  # 0 where a tip circle lies within the base circle
    ends = sorted((highest, gear.active))
    chords, missing = _chords(m, gear, radii)
    return Measures(
        wheel=asked.name,
        base_pitch=m * base_pitch_normal(wheel),
        base_thickness=m * span_length(wheel, 1),
        spans=span.rows,
        span_teeth=span.teeth,
        span_most=span.most,
        span_most_exact=span.most_exact,
        span_middle=span.middle,
        span_lowest=m * span.lowest,
        span_lowest_active=m * span.lowest_active,
        span_tip=m * span.tip,
        span_tip_exact=m * span.tip_exact,
        span_width=None if span.width is None else m * span.width,
        span_width_exact=None if span.width_exact is None else m * span.width_exact,
        balls=balls,
        constant_chord=m * float(chord.chord),
        constant_chord_height=m * float(chord.height),
        constant_chord_curvature=m * abs(float(chord.curvature)),
        constant_chord_valid=bool(ends[0] <= abs(float(chord.curvature)) <= ends[1]),
        usable="form" if abs(gear.active - gear.form) <= NOISE else "active",
        chords=chords,
        remarks=(*span.remarks, *told, *missing),
    )


@record
class _Measured:
    """The spans of a wheel; limits in modules."""

    rows: tuple[SpanRow, ...]
    teeth: int | None
    most: int
    most_exact: int
    middle: int
    lowest: float
    lowest_active: float
    tip: float
    tip_exact: float
    width: float | None
    width_exact: float | None
    remarks: tuple[Note, ...]


_NO_SPAN = _Measured((), None, 0, 0, 0, 0.0, 0.0, 0.0, 0.0, None, None, ())


def _measured(asked: WheelMeasuring, gear: Gear) -> _Measured:
    teeth, m = asked.span_teeth, asked.module
    found = spans(gear.wheel, gear.tip, gear.active, asked.width)
    rows = [
        SpanRow(s.teeth, m * s.length, m * s.radius, m * s.curvature, m * s.width, s.valid, s.book) for s in found.table
    ]
    if teeth is not None and found.over(teeth) is None:
        rows.append(_not_admitted(m, gear, teeth))
    most = found.most(asked.rule)
    chosen = teeth if teeth is not None else most if most >= LEAST else None
    limits = found.limits
    return _Measured(
        rows=tuple(rows),
        teeth=chosen,
        most=found.book_teeth,
        most_exact=found.exact_teeth,
        middle=found.middle,
        lowest=2 * gear.form / cos(gear.wheel.section.base_helix),
        lowest_active=limits.lowest,
        tip=limits.tip,
        tip_exact=limits.tip_exact,
        width=limits.width,
        width_exact=limits.width_exact,
        remarks=_span_remarks(asked, next((row for row in rows if row.teeth == chosen), None), found),
    )


def _not_admitted(m: float, gear: Gear, teeth: int) -> SpanRow:
    """The span over a number of teeth that no rule admits."""
    length, helix = span_length(gear.wheel, teeth), gear.wheel.section.base_helix
    curvature = length * cos(helix) / 2
    radius = float(np.hypot(gear.base, curvature))
    return SpanRow(teeth, m * length, m * radius, m * curvature, m * length * sin(helix), False, False)


def _span_remarks(asked: WheelMeasuring, row: SpanRow | None, found: Spans) -> tuple[Note, ...]:
    """What is wrong with the chosen span, and which would do."""
    if row is None:
        most = found.most(asked.rule)
        text = Phrase(
            "the rule {rule} admits no span: z_w,max = {most}, below {least}",
            rule=repr(asked.rule),
            most=most,
            least=LEAST,
        )
        return (Note("warning", _better(text, found), value=float(most), limit=float(LEAST), name="z_w,max"),)
    if row.valid:
        return ()
    limits, length = found.limits, row.length / asked.module
    numbers: dict[str, Any] = {}
    if length < limits.lowest:
        why = "the plates touch beneath the usable involute"
    elif length > limits.tip_exact:
        why = "the plates reach beyond the tip circle"
    else:
        why = Phrase("the face width is less than the {width} that it needs", width=millimetres(row.width))
        numbers = {"value": asked.face_width, "limit": row.width, "unit": "m", "name": "b"}
    return (Note("warning", _better(why, found), Phrase("span over {teeth} teeth", teeth=row.teeth), **numbers),)


def _better(text: str, found: Spans) -> str:
    """The text with the span that is better, if there is one."""
    if found.recommended is None:
        return text
    return Phrase(
        "{text}; over {recommended} they touch near the middle of the flank", text=text, recommended=found.recommended
    )


def _bodies(body: str, diameter: str) -> Phrase:
    """Balls or pins with their diameter."""
    return Phrase("balls of {diameter}" if body == "balls" else "pins of {diameter}", diameter=diameter)


def _balls(asked: WheelMeasuring, gear: Gear) -> tuple[BallsRow | None, tuple[Note, ...]]:
    m, body = asked.module, asked.body
    try:
        diameter = usual_diameter(gear.wheel) if asked.ball is None else asked.ball / m
        if not diameter > LEAST_BALLS:
            return None, (
                Note("warning", "no balls stand in the space" if body == "balls" else "no pins stand in the space"),
            )
        found = over_balls(gear.wheel, diameter, gear.tip, gear.active, gear.root, body)
    except NoSolutionError as error:
        limit, told = millimetres(m * (error.limit or 0.0)), millimetres(asked.ball or 0.0)
        text = "{body} do not stand in the space: they have to be larger than {limit}"
        if gear.wheel.teeth < 0:
            text = "{body} do not stand in the space: they have to be smaller than {limit}"
        said = Phrase(text, body=_bodies(body, told), limit=limit)
        numbers = asked.ball, m * (error.limit or 0.0), "m"
        return None, (Note("warning", said, "", *numbers, "D_M"),)
    if not (isfinite(found.size) and isfinite(found.curvature)):
        return None, (
            Note("warning", "no balls stand in the space" if body == "balls" else "no pins stand in the space"),
        )
    remarks: list[str] = []
    if not found.on_flank:
        remarks.append("{body} do not touch the usable involute")
    if not found.clear:
        remarks.append("{body} do not stand proud of the tip or meet the root circle")
    row = BallsRow(
        diameter=m * diameter,
        size=m * found.size,
        radius=m * found.radius,
        angle=found.angle,
        centres=m * found.centres,
        curvature=m * found.curvature,
        on_flank=found.on_flank,
        clear=found.clear,
    )
    told = millimetres(m * diameter)
    return row, tuple(Note("warning", Phrase(remark, body=_bodies(body, told))) for remark in remarks)


def _chords(m: float, gear: Gear, asked: Sequence[float]) -> tuple[tuple[ChordRow, ...], tuple[Note, ...]]:
    """The circles that there are on the tooth, and on which it has a thickness; which of those asked for are not."""
    wheel = gear.wheel
    side = -1.0 if wheel.teeth < 0 else 1.0
    named = [("reference", abs(wheel.reference)), ("operating", gear.operating), ("tip", gear.tip)]
    named += [("asked", radius / m) for radius in asked]
    radii = np.array([radius for _, radius in named])
    at = thickness(wheel, side * np.maximum(radii, gear.base), side * gear.tip)
    on_tooth = (radii >= gear.base) & (side * (radii - gear.tip) <= 1e-12 * gear.tip) & (at.normal >= 0)
    half = side * np.asarray(wheel.half_angle_at(at.radius))
    columns = (half, at.pressure_angle, at.helix, at.transverse, at.normal, at.chord, at.height, at.space)
    rows = zip(named, on_tooth.tolist(), *(column.tolist() for column in columns), strict=True)
    found = tuple(
        ChordRow(name, m * radius, theta, angle, helix, *(m * length for length in lengths))
        for (name, radius), good, theta, angle, helix, *lengths in rows
        if good
    )
    return found, tuple(_chord_remarks(m, gear, radii[3:], on_tooth[3:]))


def _chord_remarks(m: float, gear: Gear, radii: np.ndarray, on_tooth: np.ndarray) -> Iterator[Note]:
    """Circles that were asked for and do not cut the flanks, or cut them where there is a fillet instead."""
    ring = gear.wheel.teeth < 0
    form = float(np.hypot(gear.base, gear.form))
    for radius, good in zip(radii.tolist(), on_tooth.tolist(), strict=True):
        if not good:
            ends = millimetres(m * (gear.tip if ring else gear.base)), millimetres(m * (form if ring else gear.tip))
            text = Phrase(
                "the circle r = {radius} does not cut the flanks, from {low} to {high}",
                radius=millimetres(m * radius),
                low=ends[0],
                high=ends[1],
            )
            yield Note("warning", text)
        elif (radius > form * (1 + NOISE)) if ring else (radius < form * (1 - NOISE)):
            text = Phrase(
                "the circle r = {radius} cuts the fillet, the involute ends at r_F = {form}: its row is of the "
                "involute "
                "continued",
                radius=millimetres(m * radius),
                form=millimetres(m * form),
            )
            yield Note("warning", text, "", m * radius, m * form, "m", "r")
