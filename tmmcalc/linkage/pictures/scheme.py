"""The kinematic scheme to scale: one position with main lines, others thin, paths of the points, names."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.ticker import FuncFormatter, MaxNLocator

from tmmcalc.core.plane import Plane
from tmmcalc.linkage.model import FRAME, Joint
from tmmcalc.linkage.pictures.bodies import LinkOutline, bodies, centre_of_block, travel
from tmmcalc.linkage.pictures.cycle import LinkageMotion, motion_at
from tmmcalc.linkage.pictures.links import draw_link
from tmmcalc.linkage.pins import Pin, find_pins
from tmmcalc.linkage.results import Kinematics
from tmmcalc.report.drawing import symbols
from tmmcalc.report.drawing.board import Board
from tmmcalc.report.drawing.labels import signed
from tmmcalc.report.drawing.style import BLOCK, INK, MARGIN, MARK, PATH, THIN
from tmmcalc.report.numbers import number

Z_PATH, Z_OTHERS = 1, 2
LARGE = 3.0  # a mechanism larger than this is dimensioned in m, a smaller one in mm


def prepare(axes: Axes, cycle: LinkageMotion) -> None:
    """Title, names of the axes and wide limits, so that the layout reserves the room that the scheme will need."""
    content = _content(cycle)
    middle, reach = complex(content.real.mean(), content.imag.mean()), _size(content)
    axes.set_xlim(middle.real - reach, middle.real + reach)
    axes.set_ylim(middle.imag - reach, middle.imag + reach)
    axes.set_title("formula\nposition")
    _dimension(axes, reach)


def draw_scheme(axes: Axes, result: Kinematics, cycle: LinkageMotion, positions: Sequence[int]) -> Board:
    """Draw on an axes whose place is settled; the first of ``positions`` has main lines. Returns the board."""
    scheme = _Scheme(axes, result, cycle, positions)
    scheme.paths()
    scheme.others()
    scheme.frame()
    scheme.links()
    scheme.joints()
    scheme.drive()
    scheme.names()
    axes.set_title(_title(result, positions[0], scheme.board.mu))
    return scheme.board


class _Scheme:
    """One scheme while it is drawn."""

    def __init__(self, axes: Axes, result: Kinematics, cycle: LinkageMotion, positions: Sequence[int]) -> None:
        self.result, self.cycle, self.positions = result, cycle, positions
        self.mechanism = cycle.chain.mechanism
        self.pins = find_pins(self.mechanism)
        self.motion = motion_at(cycle.chain, result.x[list(positions)])
        self.rough = bodies(self.mechanism, self.pins, cycle, 0.0)
        content = np.concatenate([_content(cycle), _content(self.motion, cycle)])
        self.size = _size(content)
        self.board = Board(axes, content, MARGIN)
        self.bodies = bodies(self.mechanism, self.pins, cycle, (BLOCK[0] / 2 + 2) * self.board.mu)
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
                style = {"linewidth": 0.7, "linestyle": (0, (6, 1.5, 1, 1.5)), "color": PATH, "zorder": Z_PATH}
                self.board.line(path, weight=0.08, **style)

    def others(self) -> None:
        """The other positions thin, numbered along the circle of the crank pin."""
        segments = [
            self.placed(body.link, segment, k)
            for k in range(1, len(self.positions))
            for body in self.rough
            for segment in body.segments
        ]
        self.board.lines(segments, weight=0.02, colors=THIN, linewidths=0.35, zorder=Z_OTHERS)
        if self.result.turns and len(self.positions) > 1:
            self._number_positions()

    def _number_positions(self) -> None:
        pivot, pin = self._crank()
        if pin is None:
            return
        last: list[complex] = []
        order = sorted(range(len(self.positions)), key=lambda k: self.positions[k])
        for k in order:
            at = self.place(self.result.structure.input_link, pin, k)
            text = at + (at - pivot) / abs(at - pivot) * 2.3 * self.board.mu
            if all(abs(text - other) > 2.6 * self.board.mu for other in last):
                last.append(text)
                label = self.result.labels[self.positions[k]]
                style: dict[str, Any] = {
                    "fontsize": 5,
                    "ha": "center",
                    "va": "center",
                    "color": "#555555",
                    "zorder": Z_PATH,
                }
                self.board.axes.text(text.real, text.imag, label, **style)
                self.board.labels.avoid([text - 0.8 * self.board.mu, text + 0.8 * self.board.mu], 0.8)

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
                symbols.pivot(self.board, pin.at[FRAME], self._free_side(pin))
            elif pin.fixed and not self._on_guide(pin):
                at = pin.at[FRAME]
                self.board.axes.plot(at.real, at.imag, "+", color=INK, markersize=5, markeredgewidth=0.7)
        for joint in self.mechanism.joints:
            if joint.kind == "prismatic" and joint.links[1] == FRAME:
                self._guide(joint)
            elif joint.kind == "prismatic" and joint.links[0] == FRAME:
                link = joint.links[1]
                direction = joint.directions[1] * complex(self.motion.turn(link)[0])
                at = centre_of_block(joint, self.pins)
                symbols.sleeve(self.board, at, direction, self._outward(at, direction))

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
        symbols.guide(self.board, ends, self._outward(sum(ends) / 2, e))

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
                symbols.pin(self.board, at)
            elif pin.centre:
                symbols.centre_of_mass(self.board, at)
            elif not self._at_block(pin):
                self.board.circle(at, 0.55, facecolor=INK, zorder=symbols.Z_PIN)

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
            at = symbols.sense_arrow(self.board, pivot, arm, radius, sense)
            self.board.labels.put(f"$\\omega_{{{link}}}$", [at], color=MARK, prefer=at - pivot)
            return
        side = joint.links.index(link)
        e = joint.directions[side] * complex(self.motion.turn(link)[0])
        forward = e * sense * (1 if side == 0 else -1)
        at = self.place(link, joint.points[side])
        beside = forward * BLOCK[0] / 2 - self._outward(at, e) * BLOCK[1]
        name = symbols.straight_arrow(self.board, at + beside * self.board.mu, forward)
        self.board.labels.put(f"$v_{{{link}}}$", [name], color=MARK)

    def names(self) -> None:
        """Names of points, then numbers of links, each where it covers least."""
        labels = self.board.labels
        for pin in sorted(self.pins, key=lambda pin: pin.centre):
            at = pin.at[FRAME] if pin.fixed else self._place_of(pin)
            size = 6.5 if pin.centre else 8.5
            labels.put(pin.name, [at], size=size, style="italic", gaps=(1.8, 2.7, 3.8, 5.0))
        for body in self.bodies:
            labels.put(str(body.link), list(self._beside(body)), size=6.5, ring=True, gaps=(0.8, 1.6, 2.6, 3.8, 5.5))

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


def _dimension(axes: Axes, size: float) -> None:
    """Axes in mm or m."""
    unit, factor = ("m", 1.0) if size > LARGE else ("mm", 1000.0)
    for axis, name in ((axes.xaxis, "x"), (axes.yaxis, "y")):
        axis.set_major_locator(MaxNLocator(7, steps=[1, 2, 2.5, 5, 10]))
        axis.set_major_formatter(FuncFormatter(lambda v, _: signed(round(v * factor, 9))))
        axis.set_label_text(f"{name}, {unit}")
    axes.tick_params(length=2.5)


def _title(result: Kinematics, position: int, mu: float) -> str:
    """Which position the main lines show, and the scale on paper."""
    along = result.phi[position]
    where = f"$\\varphi$ = {signed(math.degrees(along), 5)}°" if result.turns else f"$s - s_0$ = {signed(along, 5)} m"
    formula = result.structure.formula.replace("->", "→")
    return f"{formula}\nPosition {result.labels[position]}, {where},  $\\mu_l$ = {number(mu, 4)} m/mm"
