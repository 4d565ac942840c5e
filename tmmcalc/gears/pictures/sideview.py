"""The side view of a train, its kinematic scheme: wheels as bars on their shafts, carrier, bearings, what is fixed.

Planetary and coaxial trains are seen with the main axis across, input on the left, the first planet above; the planet
opposite to it is drawn where there is one, the others are left out. Shafts in a row are seen from above, input away.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import NamedTuple

from tmmcalc.gears.pictures.endview import COLOURS, RIM, plane_of
from tmmcalc.gears.pictures.lengthwise import Frame, carrier_at, frame_of, free_places, shown, sleeve_end, span_of
from tmmcalc.gears.pictures.placed import PlacedTrain, Wheel
from tmmcalc.report.drawing.field import Board
from tmmcalc.report.drawing.pens import WHITE, Pen
from tmmcalc.report.drawing.signs import hatched
from tmmcalc.report.language import tr

# On paper [mm].
SLEEVE = 1.3  # half height of a sleeve around a shaft
BEARING = (4.6, 0.9)  # length, and distance from the shaft
BESIDE = 4.5  # from the end of a shaft to its name over or under its bearing [mm]
BEYOND = 3.0  # from the end of a shaft to that of its centre line
NAME = 2.5  # height of names
FACE = ("#dbe9f4", "#f9e0d0", "#d3ece4")  # of wheels by plane

WHEELS = tuple(Pen(f"WHEELS_{k}", 0.35, (), colour) for k, colour in enumerate(COLOURS, 1))
SHAFT = Pen("SHAFTS", 0.7)
HELD = Pen("SHAFTS_HELD", 1.1)
AXLE = Pen("AXLES", 0.5)
SLEEVES = Pen("SLEEVES", 0.35)
CARRIER = Pen("CARRIER", 0.9)
ON_SHAFT, ON_WHEEL, ON_CARRIER, ON_AXLE = 4, 5, 6, 7  # levels, those drawn last above
To = Callable[[float, float], complex]  # place along the axis and across it -> board


def draw_side_view(board: Board, train: PlacedTrain, to: To) -> None:
    """Wheels, shafts, bearings, carrier; ``to`` places what has a place along the axis and one across it."""
    view = _View(board, train, to, frame_of(train))
    for wheel in train.wheels:
        view.wheel(wheel)
    if not train.scheme.branched:
        view.shafts_in_a_row()
        return
    view.input()
    view.planets()
    if train.scheme.planetary:
        view.carrier()
        view.held()
    if train.output != "H":
        view.output()


def label_side_view(board: Board, train: PlacedTrain, to: To, part: float = 1.0) -> None:
    """Numbers of teeth at the wheels, names of the shafts; ``part`` is that of their usual height."""
    height = part * NAME
    frame = frame_of(train)
    ends = [to(frame.left, 0.0), to(frame.right, 0.0)]
    for wheel in train.wheels:
        text = f"$z_{{{wheel.name}}}$ = {wheel.teeth}"
        anchors = board.paper([to(s, r) for s, r in free_places(train, wheel)])
        board.labels.put(text, anchors, height=height, gaps=(1.2, 2.0, 3.2, 4.6), colour=COLOURS[plane_of(wheel)])
    if train.scheme.planetary:
        middle = abs(train.wheel("2").axes[0]) / 2
        board.labels.put("H", board.paper([to(carrier_at(train), middle)]), height=height, gaps=(1.2, 2.0), ring=True)
    if not train.scheme.branched:
        ends[1] = to(frame.right, train.wheels[-1].axes[0].real)
    elif train.output == "H" and train.scheme.carrier == "left":
        ends[1] = to(sleeve_end(train), SLEEVE * board.mu)
    names = (tr("input"), tr("output")) if train.driver == "1" else (tr("output"), tr("input"))
    for name, end, other in zip(names, ends, reversed(ends), strict=True):
        side = (end - other) / abs(end - other)
        away = BESIDE * board.mu * side  # over and under the bearing too, where there is no room beyond the shaft
        places = board.paper([end + BEYOND * board.mu * side, end, end - away + 1j * away, end - away - 1j * away])
        board.labels.put(name, places, height=height, gaps=(1.5, 2.5, 4.0, 6.0), prefer=side)


class _View(NamedTuple):
    """The board, the train, how places are put on the board, and places along the axis."""

    board: Board
    train: PlacedTrain
    to: To
    frame: Frame

    def line(self, pen: Pen, *places: tuple[float, float], level: float = ON_SHAFT) -> None:
        self.board.line([self.to(s, r) for s, r in places], pen, level=level)

    def area(self, s: tuple[float, float], r: tuple[float, float], pen: Pen, fill: str, level: float) -> None:
        corners = [self.to(s[0], r[0]), self.to(s[1], r[0]), self.to(s[1], r[1]), self.to(s[0], r[1])]
        self.board.area(corners, pen, fill=fill, level=level)

    def wheel(self, wheel: Wheel) -> None:
        """A bar to the pitch circle; of a ring its rim on both sides."""
        span = span_of(self.frame, wheel)
        pen, fill = WHEELS[plane_of(wheel)], FACE[plane_of(wheel)]
        for axis in shown(self.train, wheel):
            if not wheel.internal:
                self.area(span, (axis - wheel.rolling, axis + wheel.rolling), pen, fill, ON_WHEEL)
                continue
            rim = RIM * wheel.module
            for sign in (1, -1):
                self.area(span, (sign * wheel.reference, sign * (wheel.reference + rim)), pen, fill, ON_WHEEL)
                if wheel.fixed:
                    edge = sign * (wheel.reference + rim)
                    ends = self.to(span[0], edge), self.to(span[1], edge)
                    hatched(self.board, *ends, (self.to(0.0, sign * 1.0) - self.to(0.0, 0.0)))

    def input(self) -> None:
        """The shaft of wheel 1 from the left, with the web of a ring."""
        wheel = self.train.wheel("1")
        start, end = span_of(self.frame, wheel)
        if wheel.internal:
            self._web(wheel, start - 0.5 * self.frame.clear, start)
            end = start - 0.5 * self.frame.clear
        self.line(SHAFT, (self.frame.left, 0.0), (end, 0.0))
        part = 0.2 if self.train.scheme.carrier == "left" else 0.35
        self.bearing(self.frame.left + part * (start - self.frame.left), 0.0)

    def output(self) -> None:
        """The shaft of the last wheel to the right, with the web of a ring."""
        wheel = self.train.wheel(self.train.output)
        start, end = span_of(self.frame, wheel)
        if wheel.internal:
            start = end + 0.5 * self.frame.clear
            self._web(wheel, start, end)
        self.line(SHAFT, (start, 0.0), (self.frame.right, 0.0))
        self.bearing(self.frame.right - 0.35 * (self.frame.right - end), 0.0)

    def _web(self, ring: Wheel, at: float, edge: float) -> None:
        rim = ring.reference + 0.5 * RIM * ring.module
        self.line(SHAFT, (edge, rim), (at, rim), (at, -rim), (edge, -rim))

    def planets(self) -> None:
        """The axle of every planet or the layshaft, and the sleeve of a block."""
        frame, scheme = self.frame, self.train.scheme
        members = {wheel.rstrip("'") for wheel in scheme.planets}
        for member in sorted(members):
            block = [w for w in self.train.wheels if w.planet and w.name.rstrip("'") == member]
            start, end = span_of(frame, block[0])[0], span_of(frame, block[-1])[1]
            for axis in shown(self.train, block[0]):
                if len(block) > 1:
                    gap = span_of(frame, block[0])[1], span_of(frame, block[-1])[0]
                    half = SLEEVE * self.board.mu
                    self.area(gap, (axis - half, axis + half), SLEEVES, WHITE, ON_SHAFT)
                if scheme.planetary:
                    self.line(AXLE, *self._axle(axis, start, end), level=ON_AXLE)
                else:
                    over = 0.8 * frame.clear + BEARING[0] * self.board.mu
                    self.line(SHAFT, (start - over, axis), (end + over, axis))
                    for place in (start - 0.6 * over, end + 0.6 * over):
                        self.bearing(place, axis)

    def _axle(self, axis: float, start: float, end: float) -> Iterable[tuple[float, float]]:
        """From the carrier through the planets, a little farther."""
        over = 0.25 * self.frame.clear
        if self.train.scheme.carrier == "right":
            return (start - over, axis), (carrier_at(self.train), axis)
        return (carrier_at(self.train), axis), (end + over, axis)

    def carrier(self) -> None:
        """Arms from the axles to the output shaft, or to a sleeve around the input shaft."""
        at, frame, half = carrier_at(self.train), self.frame, SLEEVE * self.board.mu
        axes = [axis for wheel in self.train.wheels if wheel.planet for axis in shown(self.train, wheel)]
        if self.train.scheme.carrier == "right":
            self.line(CARRIER, (at, max(axes)), (at, min(0.0, *axes)), level=ON_CARRIER)
            self.line(SHAFT, (at, 0.0), (frame.right, 0.0))
            self.bearing(frame.right - 0.35 * (frame.right - at), 0.0)
            return
        end = sleeve_end(self.train) if self.train.output == "H" else at - 2.5 * half
        for sign in (1, -1):
            reached = [axis for axis in axes if sign * axis > 0]
            self.line(AXLE, (at, sign * half), (end, sign * half), level=ON_CARRIER)
            arm = (at, sign * half), (at, sign * max(map(abs, reached), default=half))
            self.line(CARRIER, *arm, level=ON_CARRIER)
        if self.train.output == "H":
            self.bearing((end + at) / 2, 0.0, half)

    def held(self) -> None:
        """The stub that holds a central wheel without a rim to hold it by."""
        wheel = next(wheel for wheel in self.train.wheels if wheel.fixed)
        if wheel.internal:
            return
        end = span_of(self.frame, wheel)[1]
        wall = end + 0.6 * (self.frame.right - end)
        self.line(HELD, (end, 0.0), (wall, 0.0))
        half = 3.2 * self.board.mu
        away = self.to(1.0, 0.0) - self.to(0.0, 0.0)
        hatched(self.board, self.to(wall, -half), self.to(wall, half), away)

    def shafts_in_a_row(self) -> None:
        """Every shaft with its two bearings; the first comes in, the last goes out."""
        frame, over = self.frame, 0.5 * (self.frame.planes[0][0] - self.frame.left)
        first, last = self.train.wheels[0].axes[0].real, self.train.wheels[-1].axes[0].real
        inside = frame.planes[0][0] - over, frame.planes[-1][1] + over
        for axis in sorted({wheel.axes[0].real for wheel in self.train.wheels}):
            ends = frame.left if axis == first else inside[0], frame.right if axis == last else inside[1]
            self.line(SHAFT, (ends[0], axis), (ends[1], axis))
            for place in (inside[0] + 0.3 * over, inside[1] - 0.3 * over):
                self.bearing(place, axis)

    def bearing(self, at: float, axis: float, around: float = 0.0) -> None:
        """A bearing in the frame: hatched lines on both sides of a shaft of this radius."""
        length, away = BEARING[0] * self.board.mu / 2, around + BEARING[1] * self.board.mu
        outward = self.to(0.0, 1.0) - self.to(0.0, 0.0)
        for sign in (1, -1):
            start, end = (self.to(at + side * length, axis + sign * away) for side in (-1, 1))
            hatched(self.board, start, end, sign * outward)
