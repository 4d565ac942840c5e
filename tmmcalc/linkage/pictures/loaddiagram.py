"""The load diagram of a free body: its links to scale, forces as arrows of readable length, couples as arcs.

Arrows are longer for larger forces but not to scale: a weight would not be seen beside a cutting force. A force
slides along its line, so each arrow takes the free side of its point - tail or head there - and keeps clear of bars
and other arrows; where both sides are taken it stands farther off or a little beside its line.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import product

import numpy as np

from tmmcalc.core.plane import Plane
from tmmcalc.linkage.freebody import Acting, Couple, FreeBody
from tmmcalc.linkage.model import FRAME, Joint
from tmmcalc.linkage.pictures.bodies import bodies
from tmmcalc.linkage.pictures.cycle import LinkageMotion
from tmmcalc.linkage.pictures.links import draw_link
from tmmcalc.linkage.pins import Pin, find_pins
from tmmcalc.report.drawing import signs
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.field import Board, needed
from tmmcalc.report.drawing.lettering import point_name, symbol
from tmmcalc.report.drawing.pens import AXIS, FORCES
from tmmcalc.report.drawing.scales import length_scale
from tmmcalc.report.drawing.shapes import Drawing

MARGIN = 15.0  # free border [mm]
SHORTEST, LONGEST = 7.0, 13.0  # arrows [mm]
HEAD = 2.8
GAPS = (0.9, 6.0, 11.0)  # between a point and its arrow [mm]
MEETING = 4.6  # what lies nearer to the point is not counted as covered [mm]
CLEAR = 1.2  # nearer than this to other lines an arrow covers them [mm]
PUSHED = 1.5  # what is said against a head at the point
BESIDE, APART = 2.6, 5.0  # an arrow drawn so far beside its line [mm], and what is said against that
POINT = 0.05  # links that fill less than this part of the mechanism's reach are a point
SAME = 2.0  # points nearer than this are one [mm]
ARC = 3.6  # radius of a couple's arc [mm]
PITCH = math.radians(35)  # half of the arc of a pitch circle that is shown


def draw_load_diagram(
    drawing: Drawing, box: Box, body: FreeBody, motion: LinkageMotion, cycle: LinkageMotion, margin: float = MARGIN
) -> float:
    """Draw in a rectangle with a free border [mm]; returns the scale of the links [m/mm]."""
    diagram = _Diagram(body, motion, cycle)
    diagram.on(drawing, box, margin)
    diagram.links()
    diagram.forces()
    diagram.couples()
    diagram.names()
    return diagram.board.mu


def scale_in(box: Box, body: FreeBody, motion: LinkageMotion, cycle: LinkageMotion, margin: float = MARGIN) -> float:
    """The scale [m/mm] that the links of a body would have in a rectangle."""
    return length_scale(needed(_Diagram(body, motion, cycle).content, box, margin))


class _Diagram:
    """One load diagram while it is drawn."""

    board: Board

    def __init__(self, body: FreeBody, motion: LinkageMotion, cycle: LinkageMotion) -> None:
        self.body, self.motion = body, motion
        self.mechanism = motion.chain.mechanism
        self.pins = find_pins(self.mechanism)
        shapes = bodies(self.mechanism, self.pins, cycle, 0.0)
        self.shapes = [shape for shape in shapes if shape.link in body.links]
        self.content = self._content()
        self.arrows: list[tuple[Acting, complex, complex]] = []  # forces with tail and head
        self.arcs: list[tuple[Couple, Plane]] = []

    def on(self, drawing: Drawing, box: Box, margin: float) -> None:
        """Take a rectangle to draw in."""
        self.board = Board(drawing, box, self.content, margin, scale=length_scale)

    def _content(self) -> Plane:
        """All that must fit [m]."""
        content = [self.place(s.link, p) for s in self.shapes for p in s.corners]
        content += [self.place_of(pin) for pin in self.own_pins()]
        content += [force.at for force in self.body.forces if force.kind == "drive"]
        return np.array([*content, *self._room(content)])

    def _room(self, content: list[complex]) -> list[complex]:
        """Corners around links that all stand in one point, which would give no scale."""
        everything = np.array([self.place_of(pin) for pin in self.pins])
        reach = float(np.max(np.abs(everything - everything[0])))
        if not content or max(abs(p - content[0]) for p in content) > POINT * reach:
            return []
        return [content[0] + POINT * reach * corner for corner in (1 + 1j, -1 - 1j)]

    def place(self, link: int, p: complex) -> complex:
        """Place of a point of a link."""
        return complex(self.motion.place(link, p)[0])

    def place_of(self, pin: Pin) -> complex:
        return self.place(*next(iter(pin.at.items())))

    def own_pins(self) -> Iterator[Pin]:
        """Pins of the body's links."""
        return (pin for pin in self.pins if set(pin.at) & set(self.body.links) and (pin.joints or pin.centre))

    def links(self) -> None:
        """The links, their pins and centres of mass, the lines of the guides that were taken away."""
        for joint in self.mechanism.joints:
            if joint.kind == "prismatic" and len(set(joint.links) & set(self.body.links)) == 1:
                self._guide_line(joint)
        for force in self.body.forces:
            if force.kind == "drive" and self.mechanism.joint(self.mechanism.input.joint).kind == "revolute":
                self._pitch_circle(force.at)
        for shape in self.shapes:
            draw_link(self.board, shape, self.motion)
        for pin in self.own_pins():
            at = self.place_of(pin)
            if pin.joints:
                signs.pin(self.board, at)
            else:
                signs.centre_of_mass(self.board, at)

    def _guide_line(self, joint: Joint) -> None:
        link = joint.links[0]
        at, e = self.place(link, joint.points[0]), complex(self.motion.turn(link)[0]) * joint.directions[0]
        reach = 12 * self.board.mu * e
        self.board.line((at - reach, at + reach), AXIS, weight=0.1, level=1)

    def _pitch_circle(self, at: complex) -> None:
        """A part of the pitch circle of the gear on the crank, around the pitch point."""
        joint = self.mechanism.joint(self.mechanism.input.joint)
        pivot = joint.points[joint.links.index(FRAME)]
        arc = pivot + (at - pivot) * np.exp(1j * np.linspace(-PITCH, PITCH, 30))
        self.board.line(arc, AXIS, weight=0.1, level=1)
        self.board.dot(at, 0.5)

    def forces(self) -> None:
        """All forces, the largest first, for it has the first choice of its side."""
        largest = max((abs(force.value) for force in self.body.forces), default=0.0)
        for force in sorted(self.body.forces, key=lambda f: -abs(f.value)):
            self._force(force, arrow_length(self.board, abs(force.value) / largest))

    def _force(self, force: Acting, size: float) -> None:
        """One arrow where it is nearest to its point and covers least."""
        tail, head = free_arrow(self.board, force.at, force.value / abs(force.value), size)
        self.board.vector(tail, head, FORCES[force.kind], HEAD, level=13)
        self.arrows.append((force, tail, head))

    def couples(self) -> None:
        """Arcs around their points; of several the later ones are wider."""
        drawn: list[complex] = []
        for couple in self.body.couples:
            radius = ARC + 1.6 * sum(abs(couple.at - other) <= SAME * self.board.mu for other in drawn)
            drawn.append(couple.at)
            self._couple(couple, radius)

    def _couple(self, couple: Couple, radius: float) -> None:
        """An open circle of 250 degrees with its head in the sense of the couple."""
        sense, pen = math.copysign(1.0, couple.value), FORCES[couple.kind]
        around = np.exp(1j * sense * np.radians(np.linspace(-35, 215, 40)))
        arc = couple.at + radius * self.board.mu * around
        self.board.line(arc[:-3], pen, weight=0.6, level=13)
        tip = complex(arc[-1])
        direction = 1j * sense * (tip - couple.at) + 0.25 * (couple.at - tip)
        self.board.arrowhead(tip, direction, pen, HEAD * 0.9, level=14)
        self.arcs.append((couple, arc))

    def names(self) -> None:
        """The names of forces, couples and pins when all is drawn, so that none covers an arrow."""
        put, paper = self.board.labels.put, self.board.paper
        for force, tail, head in self.arrows:
            far, near = (tail, head) if abs(tail - force.at) >= abs(head - force.at) else (head, tail)
            name, colour = symbol(force.letter, force.index), FORCES[force.kind].colour
            put(name, paper([far, near]), colour=colour, prefer=far - near, gaps=(0.9, 1.6, 2.6))
        for couple, arc in self.arcs:
            name, colour = symbol(couple.letter, couple.index), FORCES[couple.kind].colour
            put(name, paper([arc[len(arc) // 2], arc[8]]), colour=colour, gaps=(0.8, 1.6, 2.6))
        for pin in self.own_pins():
            if pin.joints:
                put(point_name(pin.name), paper([self.place_of(pin)]), gaps=(1.3, 2.2, 3.2))


def arrow_length(board: Board, part: float) -> float:
    """The length [m] of the arrow of a force that is so large against the largest."""
    return (SHORTEST + (LONGEST - SHORTEST) * math.sqrt(part)) * board.drawing.letters * board.mu


def free_arrow(
    board: Board, at: complex, e: complex, size: float, offsets: tuple[float, ...] = (0.0, -1.0, 1.0)
) -> tuple[complex, complex]:
    """Tail and head of an arrow along the unit vector ``e`` where it is nearest to its point and covers least.

    ``offsets`` are the places beside its line that it may take. Its part next to the point is not counted: the pin
    and the bars that meet there are near it anyway.
    """
    mu, found = board.mu, []
    for side, offset, gap in product((1, -1), offsets, GAPS):
        near = at + side * gap * mu * e + 1j * e * offset * BESIDE * mu
        far = near + side * e * size
        counted = near + side * e * max(0.0, MEETING - gap) * mu
        covered = board.labels.crowded(board.paper((counted, far)).tolist(), CLEAR)
        against = covered + (PUSHED if side < 0 else 0.0) + 0.5 * (gap - GAPS[0]) + APART * abs(offset)
        found.append((against, *((near, far) if side > 0 else (far, near))))
    return min(found, key=lambda each: each[0])[1:]
