"""The kinematic scheme to scale: one position with main lines, others thin, paths of the points, names."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

import numpy as np

from tmmcalc.core.plane import Plane
from tmmcalc.linkage.model import FRAME, Joint
from tmmcalc.linkage.pictures.bodies import LinkOutline, bodies, centre_of_block, travel
from tmmcalc.linkage.pictures.cycle import LinkageMotion, motion_at
from tmmcalc.linkage.pictures.links import draw_link
from tmmcalc.linkage.pins import Pin, find_pins
from tmmcalc.linkage.results import Kinematics
from tmmcalc.report.drawing import signs
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.field import Board
from tmmcalc.report.drawing.lettering import minus, point_name
from tmmcalc.report.drawing.pens import MARK, OTHER, PATH
from tmmcalc.report.drawing.scales import length_scale, scale_text
from tmmcalc.report.drawing.shapes import Drawing, Words
from tmmcalc.report.drawing.wording import corners
from tmmcalc.report.language import tr
from tmmcalc.report.numbers import number

PATHS, OTHERS = 1, 2  # levels of what lies beneath the links
MARGIN = 9.0  # free border [mm]
HEAD = 9.5  # height of the two lines above [mm]
NUMBER = 1.3  # height of the numbers of positions [mm]
GREY = "#555555"
NOTHING: Plane = np.empty(0, complex)


def draw_scheme(
    drawing: Drawing,
    box: Box,
    result: Kinematics,
    cycle: LinkageMotion,
    positions: Sequence[int],
    beside: Plane = NOTHING,
    *,
    given: bool = False,
) -> Board:
    """Draw in a rectangle; the first of ``positions`` has main lines. Returns the board.

    ``beside`` the linkage places (n,) have room, on which something is drawn after it. As it is ``given`` it shows
    nothing that is to be found: neither its formula nor the paths of its points.
    """
    top, larger = complex(box.left, box.top), drawing.letters
    scheme = _Scheme(drawing, box.inset(0, 0, 0, HEAD * larger), result, cycle, positions, beside)
    if not given:
        scheme.paths()
    scheme.others()
    scheme.frame()
    scheme.links()
    scheme.joints()
    scheme.drive()
    scheme.names()
    title = position_text(result, positions[0]) if given else _title(result, positions[0], scheme.board.mu)
    drawing.add(Words(top, title, 2.5 * larger, -1 + 1j))
    return scheme.board


class _Scheme:
    """One scheme while it is drawn."""

    def __init__(
        self,
        drawing: Drawing,
        box: Box,
        result: Kinematics,
        cycle: LinkageMotion,
        positions: Sequence[int],
        beside: Plane,
    ) -> None:
        self.result, self.cycle, self.positions = result, cycle, positions
        self.mechanism = cycle.chain.mechanism
        self.pins = find_pins(self.mechanism)
        self.motion = motion_at(cycle.chain, result.x[list(positions)])
        self.rough = bodies(self.mechanism, self.pins, cycle, 0.0)
        content = np.concatenate([_content(cycle), _content(self.motion, cycle)])
        self.size = _size(content)
        self.board = Board(drawing, box, np.concatenate([content, beside]), MARGIN, scale=length_scale)
        self.bodies = bodies(self.mechanism, self.pins, cycle, (signs.BLOCK[0] / 2 + 2) * self.board.mu)
        self.middle = complex(np.mean([self.place(b.link, p) for b in self.bodies for p in b.corners]))

    def place(self, link: int, p: complex, k: int = 0) -> complex:
        """Place of a point of a link in the k-th drawn position."""
        return complex(self.motion.place(link, p)[k])

    def placed(self, link: int, points: Sequence[complex], k: int = 0) -> list[complex]:
        """Places of points of a link."""
        return [self.place(link, p, k) for p in points]

    def paths(self) -> None:
        """Paths of the named points over the whole cycle."""
        for pin in self.pins:
            if not pin.fixed and not pin.centre:
                path = self.cycle.place(*next(iter(pin.at.items())))
                self.board.line(path, PATH, weight=0.08, level=PATHS)

    def others(self) -> None:
        """The other positions thin, numbered along the circle of the crank pin."""
        segments = [
            self.placed(body.link, segment, k)
            for k in range(1, len(self.positions))
            for body in self.rough
            for segment in body.segments
        ]
        self.board.lines(segments, OTHER, weight=0.02, level=OTHERS)
        if self.result.turns and len(self.positions) > 1:
            self._number_positions()

    def _number_positions(self) -> None:
        pivot, pin = self._crank()
        if pin is None:
            return
        last: list[complex] = []
        larger = self.board.drawing.letters
        order = sorted(range(len(self.positions)), key=lambda k: self.positions[k])
        for k in order:
            at = self.place(self.result.structure.input_link, pin, k)
            text = at + (at - pivot) / abs(at - pivot) * 1.8 * NUMBER * larger * self.board.mu
            if all(abs(text - other) > 2.0 * NUMBER * larger * self.board.mu for other in last):
                last.append(text)
                label = self.result.labels[self.positions[k]]
                words = Words(self.board.place(text), label, NUMBER * larger, 0j, colour=GREY)
                self.board.drawing.add(words, level=PATHS)
                self.board.labels.keep(corners(words))

    def _crank(self) -> tuple[complex, complex | None]:
        """Place of the crank's pivot, and the crank pin in the axes of the crank."""
        link = self.result.structure.input_link
        drive = self.mechanism.joint(self.result.input_joint)
        pivot = drive.points[drive.links.index(FRAME)]
        own = [pin.at[link] for pin in self.pins if link in pin.at and pin.joints and not pin.fixed]
        return pivot, max(own, key=lambda p: abs(self.place(link, p) - pivot), default=None)

    def frame(self) -> None:
        """Pivots on their supports, guides and sleeves of the frame."""
        for pin in self.pins:
            if pin.fixed and pin.joints:
                signs.pivot(self.board, pin.at[FRAME], self._free_side(pin))
            elif pin.fixed and not self._on_guide(pin):
                at = pin.at[FRAME]
                signs.cross(self.board, at)
        for joint in self.mechanism.joints:
            if joint.kind == "prismatic" and joint.links[1] == FRAME:
                self._guide(joint)
            elif joint.kind == "prismatic" and joint.links[0] == FRAME:
                link = joint.links[1]
                direction = joint.directions[1] * complex(self.motion.turn(link)[0])
                at = centre_of_block(joint, self.pins)
                signs.sleeve(self.board, at, direction, self._outward(at, direction))

    def _on_guide(self, pin: Pin) -> bool:
        """Points of the frame that only carry a guide's line need no sign of their own."""
        return any(
            joint.kind == "prismatic" and joint.links[1] == FRAME and joint.points[1] == pin.at[FRAME]
            for joint in self.mechanism.joints
        )

    def _guide(self, joint: Joint) -> None:
        q, e = joint.points[1], joint.directions[1]
        low, high = travel(joint, self.pins, self.cycle)
        ends = (q + low * e, q + high * e)
        signs.guide(self.board, ends, self._outward(sum(ends) / 2, e))

    def _outward(self, at: complex, direction: complex) -> complex:
        """The side of a guide that looks away from the mechanism; below or right of one through its middle."""
        normal = -1j * direction
        lower = normal if (normal.imag, -normal.real) <= (-normal.imag, normal.real) else -normal
        away = ((at - self.middle) * np.conj(lower)).real
        return lower if away > -0.08 * self.size else -lower

    def _free_side(self, pin: Pin) -> complex:
        """Where the support of a pivot covers no link: below, or else above, left, right."""
        at, rays = pin.at[FRAME], []
        for body in self.bodies:
            for segment in body.segments:
                rays += _rays(at, self.placed(body.link, segment), 4 * self.board.mu)
        sides = (-1j, 1j, -1 + 0j, 1 + 0j)
        blocked = [max(((ray * np.conj(side)).real for ray in rays), default=-1.0) for side in sides]
        return next((side for side, cosine in zip(sides, blocked, strict=True) if cosine < 0.8), -1j)

    def links(self) -> None:
        """The links with main lines."""
        for body in self.bodies:
            draw_link(self.board, body, self.motion)

    def joints(self) -> None:
        """Moving pins, loose points, centres of mass."""
        for pin in self.pins:
            if pin.fixed:
                continue
            at = self._place_of(pin)
            if pin.joints:
                signs.pin(self.board, at)
            elif pin.centre:
                signs.centre_of_mass(self.board, at)
            elif not self._at_block(pin):
                self.board.dot(at, level=signs.PINS)

    def _at_block(self, pin: Pin) -> bool:
        return any(pin.at.get(body.link) == one.centre for body in self.bodies for one in body.blocks)

    def _place_of(self, pin: Pin) -> complex:
        return self.place(*next(iter(pin.at.items())))

    def drive(self) -> None:
        """The arrow of the input."""
        joint, link = self.mechanism.joint(self.result.input_joint), self.result.structure.input_link
        sense = math.copysign(1.0, self.result.speed)
        if self.result.turns:
            pivot, pin = self._crank()
            arm = self.place(link, pin) - pivot if pin is not None else complex(self.motion.turn(link)[0])
            radius = min(max(0.5 * abs(arm), 5 * self.board.mu), 9 * self.board.mu)
            at = signs.sense_arrow(self.board, pivot, arm, radius, sense)
            self.board.labels.put(f"$ω_{link}$", self.board.paper([at]), colour=MARK.colour, prefer=at - pivot)
            return
        side = joint.links.index(link)
        e = joint.directions[side] * complex(self.motion.turn(link)[0])
        forward = e * sense * (1 if side == 0 else -1)
        at = self.place(link, joint.points[side])
        beside = forward * signs.BLOCK[0] / 2 - self._outward(at, e) * signs.BLOCK[1]
        name = signs.straight_arrow(self.board, at + beside * self.board.mu, forward)
        self.board.labels.put(f"$v_{link}$", self.board.paper([name]), colour=MARK.colour)

    def names(self) -> None:
        """Names of points, then numbers of links, each where it covers least."""
        board = self.board
        for pin in sorted(self.pins, key=lambda pin: pin.centre):
            at = pin.at[FRAME] if pin.fixed else self._place_of(pin)
            name, height = point_name(pin.name), 1.8 if pin.centre else 2.5
            board.labels.put(name, board.paper([at]), height=height, gaps=(1.4, 2.2, 3.2, 4.5))
        for body in self.bodies:
            beside = board.paper(list(self._beside(body)))
            board.labels.put(str(body.link), beside, height=1.8, ring=True, gaps=(0.6, 1.4, 2.4, 3.6, 5.2))

    def _beside(self, body: LinkOutline) -> Iterator[complex]:
        """Anchors for the number of a link."""
        if body.plate:
            yield sum(self.placed(body.link, body.plate)) / len(body.plate)
        segments = body.bars or body.slots
        if segments:
            longest = max(segments, key=lambda s: abs(s[1] - s[0]))
            a, b = self.placed(body.link, longest)
            yield from (a + t * (b - a) for t in (0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8))
        elif body.blocks:
            yield self.place(body.link, body.blocks[0].centre)
        elif not body.plate:
            yield self.place(body.link, 0j)


def _content(motion: LinkageMotion, cycle: LinkageMotion | None = None) -> Plane:
    """All that must fit: points and ends of lines in these positions, slots as long as over the whole cycle."""
    mechanism = motion.chain.mechanism
    pins = find_pins(mechanism)
    places = [motion.place(*next(iter(pin.at.items()))) for pin in pins]
    shapes = bodies(mechanism, pins, cycle or motion, 0.0)
    return np.concatenate([*places, *(motion.place(body.link, p) for body in shapes for p in body.corners)])


def _size(content: Plane) -> float:
    return float(max(np.ptp(content.real), np.ptp(content.imag)))


def _rays(at: complex, segment: Sequence[complex], reach: float) -> list[complex]:
    """Unit directions in which a line leaves a point that it passes within ``reach``."""
    a, b = segment
    if a == b:
        return []
    t = float(np.clip(((at - a) / (b - a)).real, 0, 1))
    if abs(a + t * (b - a) - at) > reach:
        return []
    return [(p - at) / abs(p - at) for p in (a, b) if abs(p - at) > reach / 4]


def _title(result: Kinematics, position: int, mu: float) -> str:
    """Which position the main lines show, and the scale on paper."""
    formula = result.structure.formula.replace("->", "→")
    return f"{formula}\n{position_text(result, position)},  {scale_text(mu)}"


def position_text(result: Kinematics, row: int) -> str:
    """The number of a position and where the input stands in it."""
    value, label = float(result.phi[row]), result.labels[row]
    if result.turns:
        return tr("Position {label}, $φ$ = {angle}°", label=label, angle=minus(number(math.degrees(value), 5)))
    return tr("Position {label}, $s − s_0$ = {way} m", label=label, way=minus(number(value, 5)))
