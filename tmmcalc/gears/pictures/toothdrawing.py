"""The drawings of one wheel: the generation of a space, and half a tooth enlarged with what cuts it.

The half tooth has its axis along +Y. L is where the end of the rack's straight flank cuts, D where its rounding reaches
the root circle, A the tip, F the beginning of the involute where that is not L, P0 the point on the reference circle.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from tmmcalc.core.plane import Plane
from tmmcalc.gears.involute.profile.generation import in_wheel, path_of_centre, rack_outline
from tmmcalc.gears.meshing.halftooth import Half, ProfilePart
from tmmcalc.gears.meshing.members import Member, Toothed
from tmmcalc.gears.pictures.generation import Generation
from tmmcalc.gears.pictures.placedpair import CIRCLES, SIGNS, Circle, active_flank
from tmmcalc.gears.pictures.sketch import FACES, POINT, circle_pen, spread
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.field import Board
from tmmcalc.report.drawing.lettering import width
from tmmcalc.report.drawing.pens import AXIS, INK, MARK, PATH, THIN, Pen
from tmmcalc.report.drawing.scales import fitting_scale
from tmmcalc.report.drawing.shapes import Drawing, Words
from tmmcalc.report.language import tr

DEEP = 0.7  # [module] of the body behind the root circle of a space
SHALLOW = 0.3  # the same of the enlarged tooth
POINTS = 81
OVER = 12.0  # of the axis beyond what is drawn [mm]
LINE_PITCH = 4.4  # of the names of circles [mm]
NAME, LEADER = 2.5, 3.0  # height of these names and length of their leaders
ROOM = 15.0  # of names and leaders at the right of the frame at most
TOOL = Pen("TOOL_POSITIONS", 0.18, (), "#5b87a6")
UPRIGHT = Pen("TOOL_UPRIGHT", 0.4, (), PATH.colour)
OUTLINE = Pen("PROFILES", 0.6)
ACTIVE = Pen("ACTIVE_FLANKS", 1.1, (), "#009e73")
CENTRE_PATH = Pen("PATH_OF_CENTRE", 0.3, (1.6, 0.8), MARK.colour)
CIRCLE_COLOUR = "#555555"
MOMENTS = (
    ("L", Pen("TOOL_AT_L", 0.35, (), "#0072b2")),
    ("D", Pen("TOOL_AT_D", 0.35, (2.4, 0.8), "#cc79a7")),
    ("A", Pen("TOOL_AT_A", 0.35, (3.6, 0.8, 1.0, 0.8), "#e69f00")),
)


def _radii(member: Toothed, half: Half) -> list[tuple[str, Circle, float]]:
    """Circles of a wheel, of a rack the heights of its lines over the datum line [m]."""
    if member.shape == "rack":
        m = member.module
        return [
            (tr("tip line"), "tip", m * half.tip),
            (tr("datum line"), "reference", 0.0),
            (tr("root line"), "root", m * half.root),
        ]
    m = member.module
    own = {"tip": m * half.tip, "reference": m * abs(member.wheel.reference), "base": m * half.base}
    sizes = own | {"root": m * half.root}
    if isinstance(member, Member):
        told = member.found.sizes[member.place]
        sizes = {circle: float(getattr(told, circle)) for circle in CIRCLES}
    found: list[tuple[str, Circle, float]] = []
    for circle in CIRCLES:
        if circle not in sizes:
            continue
        radius = sizes[circle]
        name = f"$r_{SIGNS[circle]}$" if SIGNS[circle] else "$r$"
        same = [k for k, (_, _, other) in enumerate(found) if abs(other - radius) < 1e-9 * member.module]
        if same:
            found[same[0]] = (f"{found[same[0]][0]} = {name}", found[same[0]][1], radius)
        else:
            found.append((name, circle, radius))
    return found


class WheelDrawing:
    """A board with circles about the centre of a wheel, or lines along a rack."""

    def __init__(self, drawing: Drawing, box: Box, member: Toothed, content: Plane, margin: float) -> None:
        frame = box.inset(0, 0, ROOM, 0)
        self.member = member
        self.board = Board(drawing, frame, content, margin, fitting_scale(content, frame, margin))
        self.mm = self.board.mu
        self.low = self.board.data(complex(frame.left, frame.bottom))
        self.high = self.board.data(complex(frame.right, frame.top))
        self.straight = member.shape == "rack"
        self.face = FACES[member.place if isinstance(member, Member) else 0]

    def circles(self, half: Half) -> None:
        """All circles, or lines, that are in the frame, with their names at its right."""
        named, frame, drawing = list[tuple[str, complex]](), self.board.box, self.board.drawing
        for text, circle, radius in _radii(self.member, half):
            pen, places = circle_pen(circle, CIRCLE_COLOUR), list[complex]()
            if self.straight:
                ends = [complex(self.low.real, radius), complex(self.high.real, radius)]
                self.board.line(ends, pen, weight=0.3, level=2)
                if self.low.imag < radius < self.high.imag:
                    places = self.board.paper(ends).tolist()
            else:
                arcs = self.board.arc(0j, radius, pen, end=math.pi, weight=0.3, level=2)
                places = [complex(z) for arc in arcs for z in arc.points]
            if places:
                named.append((text, complex(max(places, key=lambda z: z.real))))
        named.sort(key=lambda item: -item[1].imag)
        heights = spread(
            [end.imag for _, end in named], LINE_PITCH, frame.bottom + LINE_PITCH / 2, frame.top - LINE_PITCH / 2
        )
        for (text, end), y in zip(named, heights, strict=True):
            foot = complex(frame.right + LEADER, y)
            drawing.line([end, foot], THIN, level=4)
            size = NAME * min(1.0, (ROOM - LEADER - 0.8) / width(text, NAME))
            drawing.add(Words(foot + 0.8, text, size, -1), level=20)

    def axis(self, content: Plane) -> None:
        """The axis of the tooth or space, through all that is drawn."""
        low, high = float(content.imag.min()) - OVER * self.mm, float(content.imag.max()) + OVER * self.mm
        ends = max(low, self.low.imag + self.mm), min(high, self.high.imag - self.mm)
        self.board.line([complex(0, y) for y in ends], AXIS, weight=0.3, level=5)


class SpaceDrawing(WheelDrawing):
    """The generation of one space."""

    def __init__(self, drawing: Drawing, box: Box, member: Toothed, half: Half, generation: Generation) -> None:
        outline = generation.outline
        super().__init__(drawing, box, member, outline, 2.5)
        self._body(outline, half)
        self.circles(half)
        for k, tool in enumerate(generation.positions):
            middle = k == len(generation.positions) // 2
            self.board.line(tool, UPRIGHT if middle else TOOL, weight=0.05, level=6 if middle else 4)
        self.board.line(outline, OUTLINE, level=8)
        if generation.path is not None:
            self.board.line(generation.path, CENTRE_PATH, weight=0.4, level=7)
        self.axis(np.concatenate([outline, *generation.positions]))
        if generation.path is not None:
            middle = generation.path[len(generation.path) // 2]
            self.board.labels.put("$S$", self.board.paper([complex(middle)]), height=2.8, colour=MARK.colour)

    def _body(self, outline: Plane, half: Half) -> None:
        m, member = self.member.module, self.member
        depth = -DEEP * m if member.shape != "ring" else DEEP * m
        back = m * half.root + depth
        if self.straight:
            behind = outline.real + 1j * back
        else:
            behind = back * np.exp(1j * np.angle(outline[[0, -1]]))
            turn = np.angle(behind * -1j)
            behind = back * 1j * np.exp(1j * np.linspace(turn[0], turn[1], 61))
        self.board.face(np.concatenate([outline, behind[::-1]]), self.face, level=1)


class ToothDrawing(WheelDrawing):
    """Half a tooth, enlarged."""

    def __init__(self, drawing: Drawing, box: Box, member: Toothed, half: Half) -> None:
        self.half = half
        outline = np.concatenate([*runs_of(member, half).values()])
        super().__init__(drawing, box, member, np.concatenate([outline, [1j * outline.imag.min()]]), 5.0)
        self._body(outline)
        self.circles(half)
        if member.shape == "external":
            self._tool()
        self.board.line(outline, OUTLINE, level=8)
        active = self._active()
        if active.size:
            self.board.line(active, ACTIVE, weight=0.5, level=9)
        self.axis(outline)
        self._points(active)

    def _body(self, outline: Plane) -> None:
        m = self.member.module
        back = m * self.half.root + (SHALLOW if self.member.shape == "ring" else -SHALLOW) * m
        first = outline[0]
        foot = complex(first.real, back) if self.straight else back * first / abs(first)
        arc = np.linspace(0.0, 1.0, 31)
        behind = foot * (1 - arc) + 1j * back * arc
        if not self.straight:
            behind = behind / np.abs(behind) * abs(back)
        self.board.face(np.concatenate([outline, behind[::-1]]), self.face, level=1)

    def _active(self) -> Plane:
        """The part of the flank that touches the mate; empty without one."""
        member, m, part = self.member, self.member.module, self.half.flank
        if not isinstance(member, Member):
            return np.zeros(0, complex)
        line = member.found.line
        if member.shape == "rack":
            found = member.found
            heights = (np.array([line.begins, line.ends]) - line.pitch) * math.sin(found.angle_w)
            low, high = sorted(m * member.wheel.shift - heights)
            run = m * part.curve.point(np.linspace(0.0, 1.0, POINTS))
            return run[(run.imag >= low - 1e-9 * m) & (run.imag <= high + 1e-9 * m)]
        rho = np.array([line.begins, line.ends])
        rho = rho if member.place == 0 else np.abs(line.length - rho)
        return m * active_flank(self.half, rho / m)

    def _tool(self) -> None:
        """The rack at the moments L, D and A, the path of S and the rounding about it."""
        flank, m = self.member.flank, self.member.module
        rolls, tool = flank.rolls, flank.rounding
        at = {"L": rolls.limit, "D": rolls.root, "A": rolls.tip}
        span = max(rolls.tip - min(rolls.limit, rolls.root), 1e-6)
        wide = np.linspace(min(rolls.limit, rolls.root) - 0.6 * span, rolls.tip + 0.2 * span, 401)
        self.board.line(m * path_of_centre(flank, wide), CENTRE_PATH, weight=0.5, level=7)
        around = np.exp(2j * np.pi * np.linspace(0, 1, 121))
        rounding = complex(float(tool.x), float(tool.y)) + tool.width * around.real + 1j * tool.height * around.imag
        for name, pen in MOMENTS:
            roll = np.array([at[name]])
            self.board.line(m * in_wheel(flank, rack_outline(flank), roll)[0], pen, weight=0.15, level=5)
            if name != "A":
                circle = m * in_wheel(flank, rounding, roll)[0]
                self.board.line(circle, pen._replace(width=0.2), weight=0.15, level=5)
            centre = complex(m * path_of_centre(flank, roll)[0])
            if self.low.real < centre.real < self.high.real and self.low.imag < centre.imag < self.high.imag:
                self.board.dot(centre, colour=pen.colour, level=12)
                self._name(f"$S_{name}$", centre, height=2.5, colour=pen.colour)

    def _name(self, text: str, at: complex, **style: Any) -> None:
        self.board.labels.put(text, self.board.paper([at]), **{"gaps": (1.2, 2.0, 3.0, 4.4, 6.0), **style})

    def _points(self, active: Plane) -> None:
        """Names of the points of the profile."""
        for name, at in _named(self.member, self.half):
            self.board.circle(at, 0.7, POINT, fill=INK, level=12)
            self._name(f"${name}$", at, height=2.8, prefer=-1 + 0j)
        if not self.straight and active.size:
            radii = np.abs(active)
            last = active[np.argmax(radii) if self.member.shape == "ring" else np.argmin(radii)]
            self._name("$r_p$", complex(last), height=2.5, prefer=1 + 0j, colour="#00664b")


def runs_of(member: Toothed, half: Half) -> dict[str, Plane]:
    """Points (n,) of every part of half a tooth [m], by its name, from the root to the tip."""

    def sampled(part: ProfilePart) -> Plane:
        return member.module * part.curve.point(np.linspace(part.curve.start, part.curve.end, POINTS))

    return {part.name: sampled(part) for part in half.parts}


def _named(member: Toothed, half: Half) -> list[tuple[str, complex]]:
    """Points of the profile with their names [m]."""
    m, fillet, flank = member.module, half.fillet, half.flank
    ends = [("D", fillet.curve, fillet.curve.start), ("A", flank.curve, flank.curve.end)]
    ends.insert(1, (joint_of(member, half), flank.curve, flank.curve.start))
    found = [(name, complex(m * curve.point(np.array([at]))[0])) for name, curve, at in ends]
    if member.shape != "rack":
        xi = math.sqrt(max((abs(member.wheel.reference) / half.base) ** 2 - 1, 0.0))
        low, high = sorted((flank.curve.start, flank.curve.end))
        if low < xi < high:
            found.append(("P_0", complex(m * flank.curve.point(np.array([xi]))[0])))
    return found


def joint_of(member: Toothed, half: Half) -> str:
    """The name of the point where fillet and flank meet."""
    return "F" if half.undercut or member.shape != "external" else "L"
