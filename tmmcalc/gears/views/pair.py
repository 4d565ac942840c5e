"""A pair of gears as a page moves it: teeth near the pitch point roll, contact points go along the line of action.

Wheel 1 turns counter-clockwise by one pitch, from a contact at P to the next one there, so that the end is like the
beginning. It stands at the origin, its mate as in `tmmcalc.gears.pictures.placedpair`; only teeth that come into sight
are drawn. All turns, or goes along, evenly: two places of the input tell it exactly.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from tmmcalc.core.notes import Phrase
from tmmcalc.core.plane import Plane
from tmmcalc.gears.meshing.halftooth import fault_of
from tmmcalc.gears.meshing.members import both
from tmmcalc.gears.meshing.results import MeshPair
from tmmcalc.gears.pictures import placedpair
from tmmcalc.gears.pictures.placedpair import placed_pair
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.moving import (
    FRAME,
    GREEN,
    PURPLE,
    Body,
    Handle,
    Layer,
    Mark,
    Reading,
    Spot,
    Track,
    Vector,
    View,
    track_of,
)

TOLERANCE, POINTS = 2e-3, 13  # of outlines [module]; of a flank
PER = math.pi / 180  # of the input, in degrees
WIDE = 1.45  # of what is shown, to its height
LEAST = 2.2  # half of its width at least, in pitches
DEEP = 0.4  # [module] of the bodies behind the root circles that is shown
BEYOND = 0.25  # of its width that a screen may show on each side more
STEP = 0.01  # [rad] between the points of the back of a ring
ACTION, SLIDING = GREEN, PURPLE  # colours; those of the wheels are their numbers
ASIDE, EDGE = 0.05, 0.04  # where numbers of wheels stand: from the line of centres, from above and below
ARROW = 0.13  # length of the arrows that tell how the wheels turn; all in parts of what is shown
NAMED = ("N1", "A2", "P", "A1", "N2")


def views(order: Order) -> Iterator[View]:
    """All pairs whose wheels have profiles."""
    sound = [found for found in order.results["pair"].pairs if all(fault_of(each) is None for each in both(found))]
    for k, found in enumerate(sound, 1):
        yield Rolling(found).view("pair" if len(sound) == 1 else f"pair_{k}")


class Rolling:
    """A pair while its view is made; lengths in metres, wheel 1 turns by ``turn`` [rad]."""

    def __init__(self, found: MeshPair) -> None:
        self.found, self.line = found, found.line
        self.pair = placed_pair(found, tolerance=TOLERANCE, points=POINTS)
        self.turn = 2 * math.pi / found.task.teeth[0]
        self.low, self.high = self._shown()

    def view(self, name: str) -> View:
        """What moves."""
        contacts = [*self.contacts()]
        return View(
            name=name,
            title=Phrase("Mesh {pair}", pair=self.found.task.title),
            symbol="φ₁",
            unit="deg",
            values=np.array([0.0, self.turn / PER]),
            whole=True,
            column="",
            steps=tuple(self._steps()),
            box=(self.low, self.high),
            bodies=(
                *map(self._wheel, self.pair.bodies),
                *self._numbers(),
                self._action(),
                *map(self._contact, contacts),
            ),
            frame=tuple(self._circles()),
            spots=(*self._spots(), *(Spot("K", f"K{j}", 0j, "point") for j, _ in contacts)),
            handle=Handle("1", pivot=0j),
            layers=(
                Layer(
                    "sliding",
                    "Sliding velocities, that of the pitch point is 1",
                    "",
                    (),
                    self._sliding(contacts),
                    SLIDING,
                ),
            ),
            readings=tuple(self._readings(contacts)),
        )

    def contacts(self) -> Iterator[tuple[int, tuple[float, float]]]:
        """Pairs of teeth that touch, by the pitches that they are ahead, and between which angles of wheel 1 [rad]."""
        line, base, pitch = self.line, self.found.sizes[0].base, self.pair.pitch
        for j in range(math.floor((line.begins - line.pitch) / pitch), math.ceil((line.ends - line.pitch) / pitch) + 1):
            from_, to = ((rho - line.pitch - j * pitch) / base for rho in (line.begins, line.ends))
            from_, to = max(from_, 0.0), min(to, self.turn)
            if from_ < to - 1e-9 * self.turn:
                yield j, (from_, to)

    def contact(self, j: int, angle: float) -> complex:
        """Where the contact of a pair of teeth is when wheel 1 has turned by an angle [rad]."""
        rho = self.line.pitch + self.found.sizes[0].base * angle + j * self.pair.pitch
        return complex(self.pair.on_line(rho))

    def sliding(self, at: complex) -> complex:
        """The velocity of wheel 1 against its mate at a contact, in parts of the speed of the pitch point."""
        return 1j * (1 + self._rate(2)) * (at - self.pair.pitch_point) / self.pair.pitch_point.imag

    def _rate(self, number: int) -> float:
        """The turn of wheel 1, or of its mate against it, to that of wheel 1; of the mate with the sign reversed."""
        if number == 1:
            return 1.0
        kind, (first, second) = self.found.task.kind, self.found.task.teeth
        return 0.0 if kind == "rack" else -first / second if kind == "internal" else first / second

    def _shown(self) -> tuple[complex, complex]:
        """Corners of what is shown: the contact, and teeth to both sides of it."""
        module, ends = self.found.task.module, self.pair.on_line(np.array([self.line.begins, self.line.ends]))
        depths = [depth for body in self.pair.bodies for depth in body.depths]
        low, high = min(depths) - DEEP * module, max(depths) + DEEP * module
        middle = float(np.mean(ends.real))
        half = max(LEAST * self.found.task.transverse_pitch, 0.75 * float(np.ptp(ends.real)), WIDE * (high - low) / 2)
        over = 2 * half / WIDE - (high - low)
        above = 0.5 if self.found.task.kind == "external" else 0.1  # nothing is behind a ring or a rack
        return complex(middle - half, low - (1 - above) * over), complex(middle + half, high + above * over)

    def _wheel(self, body: placedpair.Body) -> Body:
        """A wheel or rack: the teeth that come into sight, the flanks that work."""
        count = len(body.flanks)
        one, flank = body.edge[: len(body.edge) // count], body.flanks[0]
        if body.sizes is None:
            gear, flanks = self._rack(body, one, flank)
            travel = -self.pair.pitch_point.imag * self.turn
            x, angle = self._even(body.centre.real, travel), self._even(0.0, 0.0)
        else:
            gear, flanks = self._toothed(body, one - body.centre, flank - body.centre)
            turn = self.turn if body.number == 1 else -self._rate(2) * self.turn
            x, angle = self._even(body.centre.real, 0.0), self._even(0.0, turn)
        marks = [Mark("gear", tuple(gear.tolist()), tone=body.number)]
        marks += [Mark("flank", tuple(each.tolist()), tone=body.number) for each in flanks]
        return Body(str(body.number), x, self._even(body.centre.imag, 0.0), angle, tuple(marks))

    def _toothed(self, body: placedpair.Body, one: Plane, flank: Plane) -> tuple[Plane, list[Plane]]:
        """The outline with what is behind it, and the flanks, about the centre; both given of one tooth."""
        assert body.sizes is not None
        teeth = body.sizes.teeth
        step, towards = 2 * math.pi / teeth, self.pair.pitch_point - body.centre
        turned = self.turn * (1.0 if body.number == 1 else -self._rate(2))
        grown = BEYOND * (self.high - self.low).real * (1 + 1j)
        low, high = self.low - grown - body.centre, self.high + grown - body.centre
        corners = np.array([low, complex(high.real, low.imag), high, complex(low.real, high.imag)])
        seen, start = np.angle(corners / towards), float(np.angle(one[0] / towards))
        first = math.floor((seen.min() - max(turned, 0.0) - start) / step)
        last = math.ceil((seen.max() - min(turned, 0.0) - start) / step)
        around = low.real < 0 < high.real and low.imag < 0 < high.imag
        whole = around or last - first >= teeth
        places = range(teeth) if whole else range(first, last)
        turns = [np.exp(1j * step * k) for k in places]
        edge, flanks = np.concatenate([one * each for each in turns]), [flank * each for each in turns]
        if body.kind == "external":
            return (edge if whole else np.append(edge, 0j)), flanks
        ends = np.angle(one[0]) + step * np.array([places[0], places[-1] + 1])
        arc = np.exp(1j * np.linspace(ends[1], ends[0], 2 + int((ends[1] - ends[0]) / STEP)))
        return np.concatenate([edge, abs(body.back[0] - body.centre) * arc]), flanks

    def _rack(self, body: placedpair.Body, one: Plane, flank: Plane) -> tuple[Plane, list[Plane]]:
        """The outline of a rack with its back, and the flanks, about the point of its datum line."""
        pitch = self.found.task.transverse_pitch
        over = BEYOND * (self.high - self.low).real
        first = math.floor((self.low.real - over - one[0].real) / pitch)
        last = math.ceil((self.high.real + over + self.pair.pitch_point.imag * self.turn - one[0].real) / pitch)
        places = [k * pitch - body.centre for k in range(first, last)]
        edge = np.concatenate([one + place for place in places])
        back = float(body.back.imag.max()) - body.centre.imag
        return np.append(edge, [complex(z.real, back) for z in (edge[-1], edge[0])]), [flank + z for z in places]

    def _even(self, value: float, change: float) -> Track:
        """A track that changes evenly over the travel."""
        return track_of(np.array([value, value + change]), np.array(change / (self.turn / PER)), 2)

    def _standing(
        self, name: str, at: complex = 0j, marks: tuple[Mark, ...] = (), number: str = "", beside: complex = 0j
    ) -> Body:
        still = self._even(0.0, 0.0)
        return Body(name, self._even(at.real, 0.0), self._even(at.imag, 0.0), still, marks, number, (beside,))

    def _numbers(self) -> Iterator[Body]:
        """Numbers of the wheels beside the line of centres, with arrows in their sense: teeth come round, they not."""
        size = self.high - self.low
        for name, body in zip(self.found.task.wheels, self.pair.bodies, strict=True):
            y = self._beside(body, EDGE * size.imag)
            centre = complex(0, y - 1e3 * size.real) if body.sizes is None else body.centre
            radius = abs(y - centre.imag)
            rate = 1.0 if body.number == 1 else self._rate(2)
            sense = 1.0 if body.number == 1 or body.sizes is None or rate < 0 else -1.0
            above = math.copysign(1.0, y - centre.imag)
            near, far = ASIDE * size.real / radius, (ASIDE + ARROW) * size.real / radius
            start = centre + above * 1j * radius * complex(math.cos(near), sense * math.sin(near))
            mark = Mark("sense", (centre, start), sense * (far - near), body.number)
            yield self._standing(f"wheel {name}", 0j, (mark,), name, complex(above * ASIDE / 2 * sense * size.real, y))

    def _beside(self, body: placedpair.Body, edge: float) -> float:
        """The height at which the number of a wheel stands: within it, and in sight."""
        root = body.depths[1]
        if body.kind != "external":
            return (root + float(body.back.imag.max())) / 2
        middle = (body.centre.imag + root) / 2
        return max(self.low.imag + edge, middle) if body.number == 1 else min(self.high.imag - edge, middle)

    def _action(self) -> Body:
        """The line of action, thick where flanks touch."""
        line = self.line
        far = [complex(z) for z in self.pair.on_line(np.array([-2.0, 2.0]) * (abs(line.length) + line.ends))]
        ends = [complex(z) for z in self.pair.on_line(np.array([line.begins, line.ends]))]
        return self._standing(
            "action", 0j, (Mark("line", tuple(far), tone=ACTION), Mark("bar", tuple(ends), tone=ACTION))
        )

    def _contact(self, contact: tuple[int, tuple[float, float]]) -> Body:
        j, (from_, to) = contact
        start = self.contact(j, 0.0)
        way = self.contact(j, self.turn) - start
        x, y = self._even(start.real, way.real), self._even(start.imag, way.imag)
        there = (from_ / PER, to / PER)
        return Body(f"K{j}", x, y, self._even(0.0, 0.0), (Mark("dot", (0j,), tone=ACTION),), there=there)

    def _sliding(self, contacts: list[tuple[int, tuple[float, float]]]) -> tuple[Vector, ...]:
        found = []
        for j, _ in contacts:
            start, end = (self.sliding(self.contact(j, angle)) for angle in (0.0, self.turn))
            way = end - start
            found.append(Vector("v_s", f"K{j}", self._even(start.real, way.real), self._even(start.imag, way.imag)))
        return tuple(found)

    def _readings(self, contacts: list[tuple[int, tuple[float, float]]]) -> Iterator[Reading]:
        """Of every contact its distance from the pitch point, and how the flanks slide there."""
        sides = [j >= 0 for j, _ in contacts]
        for number, (j, (from_, to)) in enumerate(reversed(contacts), 1):
            start, end = (self.contact(j, angle) - self.pair.pitch_point for angle in (0.0, self.turn))
            away, there = [abs(start), abs(end)], (from_ / PER, to / PER)
            where = "contact after the pitch point" if j >= 0 else "contact before the pitch point"
            told = [f"{where}: its distance", f"{where}: sliding, in parts of the speed of the pitch point"]
            if sides.count(j >= 0) > 1:
                told = [Phrase("pair of teeth {number}: {what}", number=str(number), what=each) for each in told]
            yield Reading(told[0], "PK", "mm", self._even(1e3 * away[0], 1e3 * (away[1] - away[0])), there)
            speeds = [abs(self.sliding(self.contact(j, angle))) for angle in (0.0, self.turn)]
            yield Reading(told[1], "v_s", "", self._even(speeds[0], speeds[1] - speeds[0]), there)

    def _circles(self) -> Iterator[Mark]:
        """Pitch and base circles, the pitch line of a rack, the line of centres."""
        for body in self.pair.bodies:
            if body.sizes is None:
                y = self.pair.pitch_point.imag
                far = 2 * (self.high - self.low).real
                yield Mark("axis", (complex(-far, y), complex(far, y)), tone=body.number)
            else:
                yield Mark("pitch", (body.centre,), body.sizes.operating, body.number)
                yield Mark("base", (body.centre,), body.sizes.base, body.number)
        far = 2 * (self.high - self.low).imag
        yield Mark("axis", (complex(0, self.low.imag - far), complex(0, self.high.imag + far)))

    def _spots(self) -> Iterator[Spot]:
        """Points of the line of action and centres that are in sight."""
        for mark in self.pair.marks:
            if mark.name in NAMED and self._seen(mark.at):
                yield Spot(mark.name, FRAME, mark.at, "point")
        for body in self.pair.bodies:
            if body.sizes is not None and self._seen(body.centre):
                yield Spot(f"O{body.number}", FRAME, body.centre, "pin")

    def _seen(self, at: complex) -> bool:
        return self.low.real < at.real < self.high.real and self.low.imag < at.imag < self.high.imag

    def _steps(self) -> Iterator[tuple[str, float]]:
        """Where a contact is at P, at the end, at the beginning of the line of action."""
        base, pitch = self.found.sizes[0].base, self.pair.pitch
        places = [("K = P", 0.0), ("K = P", self.turn / PER)]
        for name, rho in (("K = A1", self.line.ends), ("K = A2", self.line.begins)):
            places.append((name, ((rho - self.line.pitch) % pitch) / base / PER))
        yield from sorted(places, key=lambda step: step[1])
