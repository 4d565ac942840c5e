"""The pendulum-rotor as it swings from its carrier, seen aslant, with displacements enlarged."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.plane import Plane
from tmmcalc.core.quantity import quantity_of
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.moving import Body, Mark, Span, Spot, Track, View, seconds_of, track_of
from tmmcalc.vibration.pendulum.results import PendulumResult
from tmmcalc.vibration.pendulum.swing import SwingCourse
from tmmcalc.vibration.views.enlarged import factor_of, told

PIECES = 6  # of the rod as it is drawn
DISC = 0.09  # of the rod's length: radius of the disc
DEPTH = 0.5 * np.exp(1j * np.pi / 5)  # how y is seen
RIM = 16  # corners of the disc


def views(order: Order) -> Iterator[View]:
    """The motion in time; none without one."""
    result: PendulumResult = order.results["pendulum"]
    if result.swing is not None:
        yield _Pendulum(result.swing, float(np.max(result.place))).view()


class _Pendulum:
    """The rod from its joint to the lower end, which is known with its slope: a parabola between them."""

    def __init__(self, swing: SwingCourse, length: float) -> None:
        self.swing, self.length = swing, length
        self.tip = swing.v + 1j * swing.w
        self.slope = swing.slope_v + 1j * swing.slope_w
        self.carrier = swing.carrier_x + 1j * swing.carrier_y
        self.factor = factor_of(length, float(np.max(np.abs(self.tip))))

    def across(self, part: float) -> Plane:
        """Displacements (n,) x + iy of a place of the rod, in parts of its length from the joint."""
        bend = self.slope * self.length - self.tip
        return np.asarray(self.tip * part + bend * part * (part - 1), complex)

    def view(self) -> View:
        """The view."""
        bodies = tuple(self._bodies())
        seen = np.concatenate([body.x.values + 1j * body.y.values for body in bodies])
        margin = DISC * self.length * (1 + 1j)
        low, high = (complex(f(seen.real), f(seen.imag)) for f in (np.min, np.max))
        return View(
            name="pendulum",
            title="Pendulum-rotor",
            symbol="t",
            unit="s",
            values=self.swing.t,
            whole=False,
            column=quantity_of(SwingCourse, "t").key,
            steps=(),
            box=(low - margin, high + margin),
            bodies=bodies,
            frame=tuple(self._frame()),
            spots=(Spot("O", "carrier", 0j, "pin"), Spot("C", "end", 0j, "point", path=True)),
            spans=tuple(self._spans()),
            note=told(self.factor),
            seconds=seconds_of(float(self.swing.t[-1])),
        )

    def _bodies(self) -> Iterator[Body]:
        """The carrier, places of the rod, the rim of the disc square to its end."""
        moves = bool(np.ptp(np.abs(self.carrier)) > 0)
        block = (Mark("block", (0j, 1 + 0j)),) if moves else ()
        yield self._point("carrier", self.carrier, 0.0, block)
        yield self._point("below", self.carrier, self.length)
        for k in range(1, PIECES + 1):
            name = "end" if k == PIECES else f"rod {k}"
            at = self.carrier + self.factor * self.across(k / PIECES)
            yield self._point(name, at, self.length * k / PIECES)
        radius, slope = DISC * self.length, self.factor * self.slope
        for k in range(RIM):
            way = np.exp(2j * np.pi * k / RIM)
            lift = radius * (way.real * slope.real + way.imag * slope.imag)  # of the rim above the end
            at = self.carrier + self.factor * self.tip + radius * way
            yield self._point(f"rim {k}", at, self.length - lift)

    def _point(self, name: str, at: Plane, depth: float | Values, marks: tuple[Mark, ...] = ()) -> Body:
        """A point at x + iy and a depth below the joint [m], as it is seen."""
        seen = at.real + at.imag * DEPTH - 1j * np.asarray(depth)
        rate = np.gradient(seen, self.swing.t)
        x, y = Track(seen.real, rate.real), Track(seen.imag, rate.imag)
        return Body(name, x, y, track_of(0.0, 0.0, len(seen)), marks)

    def _frame(self) -> Iterator[Mark]:
        """The guide of the carrier, or the support of a joint that stands."""
        seen = self.carrier.real + self.carrier.imag * DEPTH
        ends = complex(seen[np.argmin(seen.real)]), complex(seen[np.argmax(seen.real)])
        if ends[0] == ends[1]:
            yield Mark("pivot", (ends[0], 1j))
        else:
            way = (ends[1] - ends[0]) / abs(ends[1] - ends[0])
            yield Mark("guide", (*ends, 1j * way))

    def _spans(self) -> Iterator[Span]:
        """The plumb line, the rod, the disc."""
        yield Span("shadow", (("carrier", 0j), ("below", 0j)))
        names = ["carrier", *(f"rod {k}" for k in range(1, PIECES)), "end"]
        yield Span("bar", tuple((name, 0j) for name in names))
        yield Span("bar", tuple((f"rim {k % RIM}", 0j) for k in range(RIM + 1)))
