"""The picture of the transient stage: speeds and moments over the time, a sheet a motion, with its events marked."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.records import record
from tmmcalc.machine.pictures.words import end_text, event_text, mass_name
from tmmcalc.machine.transient.results import Event
from tmmcalc.machine.transient.timed import TimedMotion, TimedMotions
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.curves import BELOW, SIDES, suited
from tmmcalc.report.drawing.diagram import ROW, Axis, Diagram, key_rows, room
from tmmcalc.report.drawing.lettering import minus, width
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.page import sheets
from tmmcalc.report.drawing.pens import CURVES, MARK, Pen
from tmmcalc.report.drawing.shapes import Drawing, Words
from tmmcalc.report.language import tr, tr_unit
from tmmcalc.report.numbers import number

LISTED = 8  # events whose names are written out
TAIL = 0.5  # of the time at its end that is magnified
SWING = 0.2  # of the range of the speed: a tail that swings by more needs no magnifying
SMALL = 0.02  # of the height of a panel: a curve that goes no deeper below zero is cut there
EVENT_HIGH, BESIDE = 1.9, 0.7  # height of the numbers of events, and how far they stand from their lines [mm]
ROOM = 0.15  # of the range of a magnified tail, below and above it
EVENT = Pen("EVENTS", 0.2, (1.6, 1.2), MARK.colour)


@record
class Curve:
    """One curve over the time (S,), in SI."""

    label: str
    values: Values
    pen: Pen
    marked: bool = False  # its largest value is named


@record
class Panel:
    """Curves of one quantity over the time."""

    symbol: str
    unit: str
    t: Values
    curves: tuple[Curve, ...]
    tail: bool = False  # the axis shows the end of the first curve alone

    @property
    def named(self) -> list[tuple[str, Pen]]:
        """The names of its curves."""
        return [(curve.label, curve.pen) for curve in self.curves]

    @property
    def ends(self) -> tuple[float, float]:
        """Of the ordinate as it is drawn."""
        factor, _ = self._scale
        if self.tail:
            low, high = _range(self.curves[0].values[self.t >= (1 - TAIL) * self.t[-1]] * factor)
            return low - ROOM * (high - low), high + ROOM * (high - low)
        low, high = room([curve.values * factor for curve in self.curves])
        return (0.0 if low >= -SMALL * high else low), high

    def draw(self, drawing: Drawing, box: Box, *, numbered: bool) -> Diagram:
        """Curves, their names above, the largest values named."""
        factor, unit = self._scale
        span = (float(self.t[0]), float(self.t[-1])) if len(self.t) > 1 else (0.0, 1.0)
        axis = Axis(f"${self.symbol}$, {unit}", *self.ends)
        diagram = Diagram(drawing, box, Axis(f"$t$, {tr_unit('s')}", *span), axis, numbered=numbered)
        for k, curve in enumerate(self.curves):
            diagram.curve(self.t + 1j * curve.values * factor, curve.pen, level=6 - k / 10)
        diagram.key(self.named)
        for curve in self.curves:
            k = int(np.argmax(np.abs(curve.values)))
            if curve.marked and curve.values[k]:
                value = float(curve.values[k]) * factor
                diagram.mark(complex(self.t[k], value), number(value, 4), curve.pen)
        return diagram

    @property
    def _scale(self) -> tuple[float, str]:
        return suited(max(float(np.max(np.abs(curve.values))) for curve in self.curves), self.unit)


def figure(order: Order) -> Drawing:
    """The drawing of the stage."""
    return transient_drawing(order.results["transient"])


def transient_drawing(result: TimedMotions) -> Drawing:
    """One sheet a motion."""
    drawing, boxes = sheets(len(result.motions))
    for box, motion in zip(boxes, result.motions, strict=True):
        _sheet(drawing, box, motion)
    return drawing


def _sheet(drawing: Drawing, box: Box, motion: TimedMotion) -> None:
    """The course under a heading that lists the events."""
    heading = _heading(motion)
    drawing.add(Words(complex(box.middle.real, box.top), heading, 2.6, 1j))
    draw_course(drawing, box.inset(0, 0, 0, 3.0 + 4.6 * (heading.count("\n") + 1)), motion)


def draw_course(drawing: Drawing, box: Box, motion: TimedMotion) -> None:
    """Speeds, the tail of the speed if it is flat, moments; events across them all, by their numbers."""
    panels = [_speeds(motion), *_tail(motion), _moments(motion), *_shafts(motion)]
    larger = drawing.letters
    left, bottom, right, top = (side * larger for side in SIDES)
    free = box.inset(left, BELOW * larger, right, 0)
    heads = [top + ROW * larger * len(key_rows(panel.named, free.width / larger)) for panel in panels]
    height = (free.height - sum(heads) - bottom * len(panels)) / len(panels)
    y, first = free.top, True
    for k, (panel, head) in enumerate(zip(panels, heads, strict=True)):
        frame = Box(free.left, y - head - height, free.right, y - head)
        diagram = panel.draw(drawing, frame, numbered=k + 1 == len(panels))
        for event in motion.events:
            diagram.vertical(event.time, EVENT)
        if first:
            _name_events(diagram, motion.events)
        y, first = frame.bottom - bottom, False


def _heading(motion: TimedMotion) -> str:
    first = tr(
        "{name}: from {start} to {end} rad/s in {time} s; {why}",
        name=motion.name,
        start=_signed(motion.omega[-1, 0]),
        end=_signed(motion.omega[-1, -1]),
        time=number(float(motion.t[-1]), 5),
        why=end_text(motion.end),
    )
    return f"{first}\n{_events(motion.events)}"


def _signed(value: float) -> str:
    return minus(number(float(value), 5))


def _events(events: Sequence[Event]) -> str:
    """What happened, by the numbers that stand at the marks."""
    named = [f"{k}: {event_text(event)}" for k, event in enumerate(events[:LISTED], 1)]
    lines = [";  ".join(named[k : k + 3]) for k in range(0, len(named), 3)]
    return "\n".join(lines) + (" ..." if len(events) > LISTED else "")


def _name_events(diagram: Diagram, events: Sequence[Event]) -> None:
    """Numbers of the events in the uppermost panel; those of one instant stand together.

    On the right of their line, but where the next one is too near.
    """
    together: dict[float, list[str]] = {}
    for k, event in enumerate(events, 1):
        together.setdefault(event.time, []).append(str(k))
    lines = [diagram.place(complex(time, 0)).real for time in together]
    free = np.diff([diagram.box.left, *lines, diagram.box.right])  # on the left of each line, and of the border
    for line, numbers, left, right in zip(lines, together.values(), free[:-1], free[1:], strict=True):
        text = ", ".join(numbers)
        side = 1 if right < width(text, EVENT_HIGH) + 2 * BESIDE and right < left else -1
        at = complex(line - BESIDE * side, diagram.box.top - 0.8)
        words = Words(at, text, EVENT_HIGH, side + 1j, colour=MARK.colour, clear=True)
        diagram.drawing.add(words, level=20)


def _speeds(motion: TimedMotion) -> Panel:
    """Speed of the crank, and of all other masses over their ratios to it."""
    crank = len(motion.masses) - 1
    order = [crank, *range(crank)]
    curves = [
        Curve(_speed_name(motion, k), motion.omega[k] / motion.ratios[k], CURVES[i % len(CURVES)], k == crank)
        for i, k in enumerate(order)
    ]
    return Panel("ω", "rad/s", motion.t, tuple(curves))


def _speed_name(motion: TimedMotion, k: int) -> str:
    ratio = motion.ratios[k]
    name = mass_name(motion.masses[k])
    return name if ratio == 1 else tr("{name}, over {ratio}", name=name, ratio=number(ratio, 5))


def _tail(motion: TimedMotion) -> list[Panel]:
    """The speed of the crank magnified, if it swings little at the end but for more than nothing."""
    speed = motion.omega[-1]
    low, high = _range(speed)
    least, most = _range(speed[motion.t >= (1 - TAIL) * motion.t[-1]])
    if not 0 < most - least < SWING * (high - low):
        return []
    return [Panel("ω", "rad/s", motion.t, (Curve(tr("crank, magnified"), speed, CURVES[0]),), tail=True)]


def _range(values: Values) -> tuple[float, float]:
    return float(np.min(values)), float(np.max(values))


def _moments(motion: TimedMotion) -> Panel:
    """Moments of motor and load on the crank's shaft."""
    motor = motion.motor_moment * motion.ratios[0]
    curves = [Curve(tr("motor $M_d$, reduced to the crank"), motor, CURVES[0], True)] if motor.any() else []
    curves.append(Curve(tr("load $M_c$"), motion.load_moment, CURVES[1], True))
    return Panel("M", "N*m", motion.t, tuple(curves))


def _shafts(motion: TimedMotion) -> list[Panel]:
    """Moments of the shafts, each on its own."""
    curves = [
        Curve(
            tr("$M_{{shaft}}$: {a} to {b}, on its own shaft", shaft=f"{k + 1},{k + 2}", a=mass_name(a), b=mass_name(b)),
            motion.shaft_moment[k],
            CURVES[k % len(CURVES)],
            True,
        )
        for k, (a, b) in enumerate(zip(motion.masses[:-1], motion.masses[1:], strict=True))
    ]
    return [Panel("M", "N*m", motion.t, tuple(curves))] if curves else []
