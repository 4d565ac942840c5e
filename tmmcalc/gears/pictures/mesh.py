"""The mesh to scale: teeth in contact, circles with their radii, line of action with its points, angles, distances."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from tmmcalc.core.plane import Plane
from tmmcalc.gears.pictures.dimensions import generating_points, pressure_angle
from tmmcalc.gears.pictures.placedpair import ALIKE, CIRCLES, SIGNS, Body, Circle, Mark, PlacedPair, point_sign
from tmmcalc.gears.pictures.sketch import (
    ACTION,
    ACTIVE,
    COLOURS,
    CONTACT,
    CONTACT_ARC,
    FACES,
    POINT,
    PROFILE,
    SMALLER,
    WORKING,
    Sketch,
    circle_pen,
    up_of,
)
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.field import Board
from tmmcalc.report.drawing.pens import AXIS, GRID, INK, THIN
from tmmcalc.report.drawing.scales import fitting_scale, larger_than
from tmmcalc.report.drawing.shapes import Arc, Drawing
from tmmcalc.report.language import tr
from tmmcalc.report.numbers import number

MARGIN = 4.0  # free border [mm]
REACH = 8.0  # points of the line of action farther from P than this are left out [module]
TALL = 40.0  # height of a tooth on paper that is wished for [mm]
DEEP = 0.3  # [module] of the body behind the root circle that is shown at least
OUT = 8.0  # of the line of centres beyond what it belongs to [mm]
OVER = 4.0  # of the line of action beyond its last points [mm]
SECTOR = math.radians(65)  # of a circle on both sides of the line of centres


def draw_mesh(drawing: Drawing, box: Box, pair: PlacedPair) -> Board:
    """Draw in the rectangle, no higher than it needs, with columns of radii on both sides; the board has the scale."""
    content, margin, mu = _shown(box, pair)
    low, high = float(content.imag.min()), float(content.imag.max())
    away = [abs(y - (low + high) / 2) for y in _crossings(pair)]
    seen = [each for each in away if each <= mu * (box.height / 2 - margin)]  # circles that are in sight stay so
    blank = max(0.0, box.height - 2 * (max((high - low) / 2, *seen, 0.0) / mu + margin + OUT))
    box = box.inset(0, blank / 2, 0, blank / 2)
    board = Board(drawing, box, content, margin, mu)
    corners = [complex(box.left, box.bottom), complex(box.right, box.bottom)]
    drawing.line([*corners, complex(box.right, box.top), complex(box.left, box.top)], GRID, closed=True, level=-1)
    picture = _Mesh(board, pair)
    for body in pair.bodies:
        picture.body(body)
    picture.circles()
    picture.centres()
    picture.action()
    picture.arcs_of_contact()
    generating_points(picture)
    pressure_angle(picture)
    picture.names()
    return board


def _shown(box: Box, pair: PlacedPair) -> tuple[Plane, float, float]:
    """What is shown, its margin and the scale: all, or where teeth would be too low the contact between tall ones."""
    module, at = pair.found.task.module, pair.pitch_point
    marks = np.array([mark.at for mark in pair.marks if abs(mark.at - at) < REACH * module])
    everything = np.concatenate([*(body.edge for body in pair.bodies), marks])
    least, most = everything.imag.min(), everything.imag.max()
    line = pair.on_line(np.array([pair.found.line.begins, pair.found.line.ends]))
    depths = [body.depths for body in pair.bodies]
    heights = np.array([end for depth in depths for end in depth])
    low, high = max(heights.min() - DEEP * module, least), min(heights.max() + DEEP * module, most)
    contact = np.concatenate([line, [at, 1j * low, 1j * high]])
    tooth = min(abs(tip - root) for tip, root in depths)
    widest, needed = (fitting_scale(content, box, MARGIN) for content in (everything, contact))
    mu = max(needed, min(widest, larger_than(tooth / TALL)))
    return (everything if mu >= widest else contact), MARGIN, mu


def _towards(body: Body) -> int:
    """Whether the mesh lies above the centre of a wheel or below."""
    return -1 if body.number == 2 and body.sizes is not None and body.sizes.kind == "external" else 1


def _crossings(pair: PlacedPair) -> Iterator[float]:
    """Where circles of the wheels cross the line of centres at the mesh."""
    for body in pair.bodies:
        if body.sizes is not None:
            yield from (body.centre.imag + _towards(body) * getattr(body.sizes, circle) for circle in CIRCLES)


class _Mesh(Sketch):
    """One mesh while it is drawn."""

    def body(self, body: Body) -> None:
        """Teeth, the material behind them, active flanks."""
        self.board.face(np.concatenate([body.edge, body.back[:: _along(body)]]), FACES[body.number - 1], level=1)
        self.board.line(body.edge, PROFILE, level=7)
        for flank in body.flanks:
            self.board.line(flank, WORKING[body.number - 1], weight=0.5, level=8)

    def circles(self) -> None:
        """The circles of both wheels, of a rack its lines, with their radii in the columns at the sides."""
        for body in self.pair.bodies:
            if body.sizes is None:
                self._rack_lines(body)
            else:
                self._arcs(body)

    def _arcs(self, body: Body) -> None:
        sizes, colour = body.sizes, COLOURS[body.number - 1]
        assert sizes is not None
        named: dict[Circle, list[Circle]] = {}
        for circle in CIRCLES:
            radius = getattr(sizes, circle)
            same = [key for key in named if abs(getattr(sizes, key) - radius) < ALIKE * self.pair.found.task.module]
            if same:
                named[same[0]].append(circle)
            else:
                named[circle] = [circle]
        towards = _towards(body) * math.pi / 2
        for circle, names in named.items():
            radius = getattr(sizes, circle)
            pen, ends = circle_pen(circle, colour, body.number), (towards - SECTOR, towards + SECTOR)
            arcs = self.board.arc(body.centre, radius, pen, start=ends[0], end=ends[1], weight=0.3, level=5)
            said = " = ".join(f"r_{{{SIGNS[name]}{body.number}}}" for name in names)
            self._name_at_side(f"${said}$ = {number(1e3 * radius, 5)}", [z for arc in arcs for z in arc.points], body)

    def _rack_lines(self, body: Body) -> None:
        pitch, datum = self.pair.pitch_point.imag, body.centre.imag
        one = abs(datum - pitch) < ALIKE * self.pair.found.task.module
        level: list[tuple[str, float, Circle]] = [
            (tr("root line"), body.edge.imag.max(), "root"),
            (tr("datum, pitch line") if one else tr("datum line"), datum, "reference"),
            (tr("tip line"), body.edge.imag.min(), "tip"),
        ]
        if not one:
            level.append((tr("pitch line"), pitch, "operating"))
        for text, y, circle in level:
            ends = [complex(self.low.real, y), complex(self.high.real, y)]
            self.board.line(ends, circle_pen(circle, COLOURS[body.number - 1], body.number), weight=0.3, level=5)
            if self.low.imag < y < self.high.imag:
                self._name_at_side(text, self.board.paper(ends).tolist(), body)

    def _name_at_side(self, text: str, ends: list[complex], body: Body) -> None:
        """The text in the column of a wheel, beside the outermost end of its line on paper; none where none is seen."""
        if ends:
            side = 0 if body.number == 1 else 1
            end = (min, max)[side](ends, key=lambda z: z.real)
            self.beside[side].append((text, self.board.data(end), COLOURS[body.number - 1]))

    def centres(self) -> None:
        """The line of centres with the centres that are in the frame, the common tangent at P."""
        edge, over = 1.0 * self.mm, OUT * self.mm
        ends = np.concatenate([[body.centre for body in self.pair.bodies], *(body.back for body in self.pair.bodies)])
        low = max(self.low.imag + edge, ends.imag.min() - over)
        high = min(self.high.imag - edge, ends.imag.max() + over)
        self.board.line([complex(0, low), complex(0, high)], AXIS, weight=0.4, level=6)
        for body in self.pair.bodies:
            if body.sizes is None:
                continue
            name, at = f"$O_{body.number}$", body.centre
            if self.seen(np.array([at]), 3.0)[0]:
                self.board.circle(at, 0.8, level=9)
                self.text(name, at, 1 + 0j)
            else:
                below = at.imag < self.pair.pitch_point.imag
                if body.number == 1 and self.pair.found.task.kind == "internal":
                    continue  # both centres lie below; one arrow points to them
                if body.kind == "ring" and not self.seen(np.array([self.pair.bodies[0].centre]), 3.0)[0]:
                    name = "$O_1$, $O_2$"
                end = complex(0, self.low.imag + edge if below else self.high.imag - edge)
                self.board.arrowhead(end, -1j if below else 1j, AXIS, 2.6)
                self.text(tr("to {name}", name=name), end + (2 if below else -2) * 1j * self.mm, 1 + 0j, height=2.5)

    def action(self) -> None:
        """The line of action with its points, and where flanks touch."""
        pair, line = self.pair, self.pair.found.line
        rho = np.array([mark.rho for mark in pair.marks])
        over = OVER * self.mm
        self.board.line(pair.on_line(np.array([rho.min() - over, rho.max() + over])), ACTION, level=9)
        self.board.line(pair.on_line(np.array([line.begins, line.ends])), ACTIVE, level=10)
        for body in pair.bodies:
            if body.sizes is None:
                continue
            foot = pair.base_point if body.number == 1 else pair.mark("N2").at
            self.board.line([foot, body.centre], THIN, weight=0.2, level=4)
        for mark in pair.marks:
            if self.seen(np.array([mark.at]))[0]:
                self.board.circle(mark.at, 0.65, POINT, fill=INK, level=12)
        ends = [mark for mark in pair.marks if mark.name in ("N1", "N2") and not self.seen(np.array([mark.at]))[0]]
        for left in (True, False):
            if marks := [mark for mark in ends if (mark.at.real < pair.pitch_point.real) is left]:
                self._leaving(marks)
        for at in self.board.paper(pair.on_line(pair.contacts())).tolist():
            self.board.drawing.add(Arc(at, 1.3, CONTACT), level=13)
            self.board.labels.avoid(at + 1.3 * np.exp(2j * np.pi * np.linspace(0, 1, 13)), 2.0)
        for text, at, anchors in self._merged():
            prefer = pair.direction * (1j if at.real > 0 else -1j)
            self.text(text, anchors, prefer)

    def arcs_of_contact(self) -> None:
        """The arcs of the pitch circles that roll on each other while one pair of flanks touches, with their angles."""
        pair, line = self.pair, self.pair.found.line
        before, after = line.pitch - line.begins, line.ends - line.pitch
        for body in pair.bodies:
            if body.sizes is None:
                continue
            up, size = up_of(body), body.sizes
            sense = 1 if body.number == 1 or body.kind == "ring" else -1  # the contact moves to the left
            first, last = -before / size.base * sense, after / size.base * sense
            arc = body.centre + up * size.operating * np.exp(1j * np.linspace(first, last, 61))
            self.board.line(arc, CONTACT_ARC._replace(colour=COLOURS[body.number - 1]), weight=0.3, level=6)
            for end, over in ((arc[0], arc[0] - arc[1]), (arc[-1], arc[-1] - arc[-2])):
                across = 1.6j * self.mm * over / abs(over)
                self.board.line([complex(end - across), complex(end + across)], THIN, weight=0.3, level=9)
            angle = math.degrees(abs(last - first))
            text = f"$φ_{{α{body.number}}}$ = {number(angle, 5)}°"
            colour = COLOURS[body.number - 1]
            self.text(text, arc[[45, 50, 40, 55, 20, 15, 10]], up_of(body) * -1, height=SMALLER, colour=colour)

    def _leaving(self, marks: list[Mark]) -> None:
        """Where the line of action leaves the frame towards points outside."""
        start = self.pair.pitch_point
        line = start + (marks[0].at - start) * np.linspace(0.0, 1.0, 2001)
        inside = line[self.seen(line, 1.0)]
        onward = (marks[0].at - start) / abs(marks[0].at - start)
        self.board.arrowhead(complex(inside[-1]), onward, ACTION, 2.6)
        text = tr("to {name}", name=", ".join(point_sign(mark.name) for mark in marks))
        self.text(text, inside[-1] - np.array([4, 8, 12]) * self.mm * onward, -1j, height=2.5)

    def _merged(self) -> list[tuple[str, complex, Plane]]:
        """Names of the points in the frame; points that fall together have one text."""
        groups: list[list[int]] = []
        marks = [mark for mark in self.pair.marks if self.seen(np.array([mark.at]))[0]]
        for k, mark in enumerate(marks):
            if groups and abs(mark.at - marks[groups[-1][-1]].at) < 0.5 * self.mm:
                groups[-1].append(k)
            else:
                groups.append([k])
        found = []
        for group in groups:
            text = ", ".join(point_sign(marks[k].name) for k in group)
            found.append((text, marks[group[0]].at, np.array([marks[k].at for k in group])))
        return found


def _along(body: Body) -> int:
    """The step that runs along the back of a body against the sense of its edge."""
    first = abs(body.back[0] - body.edge[0]) < abs(body.back[-1] - body.edge[0])
    return -1 if first else 1
