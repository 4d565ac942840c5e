"""The drawings of one wheel: the generation of a space, and half a tooth enlarged with what cuts it.

The half tooth has its axis along +Y. L is where the end of the rack's straight flank cuts, D where its rounding reaches
the root circle, A the tip, F the beginning of the involute where that is not L, P0 the point on the reference circle.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from matplotlib.axes import Axes

from tmmcalc.core.plane import Plane
from tmmcalc.gears.involute.profile.generation import in_wheel, path_of_centre, rack_outline
from tmmcalc.gears.meshing.halftooth import Half, ProfilePart
from tmmcalc.gears.meshing.members import Member, Toothed
from tmmcalc.gears.pictures.generation import Generation
from tmmcalc.gears.pictures.placedpair import CIRCLES, SIGNS, Circle, active_flank
from tmmcalc.gears.pictures.sketch import FACES, STYLES, spread
from tmmcalc.report.drawing.board import Board
from tmmcalc.report.drawing.style import INK, MARK, PATH

DEEP = 0.7  # [module] of the body behind the root circle of a space
SHALLOW = 0.3  # the same of the enlarged tooth
POINTS = 81
OVER = 12.0  # of the axis beyond what is drawn [mm]
LINE_PITCH = 4.4  # of the names of circles [mm]
TOOL: dict[str, Any] = {"linewidth": 0.55, "color": "#5b87a6", "zorder": 4}
UPRIGHT: dict[str, Any] = {"linewidth": 1.2, "color": PATH, "zorder": 6}
OUTLINE: dict[str, Any] = {"linewidth": 1.8, "zorder": 8}
ACTIVE: dict[str, Any] = {"linewidth": 3.4, "color": "#009e73", "zorder": 9}
CENTRE_PATH: dict[str, Any] = {"linewidth": 0.9, "color": MARK, "linestyle": (0, (4, 1.5)), "zorder": 7}
AXIS: dict[str, Any] = {"linewidth": 0.6, "linestyle": (0, (14, 2, 2, 2)), "zorder": 5}
THIN: dict[str, Any] = {"linewidth": 0.5, "zorder": 6}
CIRCLE_COLOUR = "#555555"
MOMENTS: tuple[tuple[str, str, Any], ...] = (
    ("L", "#0072b2", "-"),
    ("D", "#cc79a7", (0, (5, 1.5))),
    ("A", "#e69f00", (0, (8, 1.5, 2, 1.5))),
)


def _radii(member: Toothed, half: Half) -> list[tuple[str, Circle, float]]:
    """Circles of a wheel, of a rack the heights of its lines over the datum line [m]."""
    if member.shape == "rack":
        m = member.module
        return [("tip", "tip", m * half.tip), ("datum", "reference", 0.0), ("root", "root", m * half.root)]
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


class _Drawing:
    """A board with circles about the centre of a wheel, or lines along a rack."""

    def __init__(self, axes: Axes, member: Toothed, content: Plane, margin: float) -> None:
        self.member, self.board = member, Board(axes, content, margin)
        axes.set_axis_off()
        self.mm = self.board.mu
        (self.x0, self.x1), (self.y0, self.y1) = axes.get_xlim(), axes.get_ylim()
        self.straight = member.shape == "rack"
        self.face = FACES[member.place if isinstance(member, Member) else 0]

    def circle(self, radius: float) -> Plane:
        """The circle or line within the frame, from the left to the right."""
        x = np.linspace(self.x0 + self.mm, self.x1 - self.mm, 401)
        if self.straight:
            return x + 1j * radius
        x = x[np.abs(x) < radius]
        points = x + 1j * np.sqrt(radius**2 - x**2)
        return points[(points.imag > self.y0 + self.mm) & (points.imag < self.y1 - self.mm)]

    def circles(self, half: Half, room: float) -> None:
        """All circles with their names at the right, ``room`` mm from the edge."""
        named = []
        for text, circle, radius in _radii(self.member, half):
            arc = self.circle(radius)
            arc = arc[arc.real < self.x1 - room * self.mm]
            if len(arc) > 1:
                self.board.line(arc, color=CIRCLE_COLOUR, weight=0.3, **STYLES[circle])
                named.append((text, complex(arc[-1])))
        named.sort(key=lambda item: -item[1].imag)
        step, heights = LINE_PITCH * self.mm, [end.imag for _, end in named]
        heights = spread(heights, step, self.y0 + step, self.y1 - step)
        for (text, end), y in zip(named, heights, strict=True):
            foot = complex(end.real + 3 * self.mm, y)
            self.board.line([end, foot], weight=0.3, **THIN)
            self.board.axes.text(foot.real + self.mm, y, text, size=8, va="center", zorder=20)
            self.board.labels.avoid([foot, foot + 6 * self.mm], 3.0)

    def axis(self, content: Plane) -> None:
        """The axis of the tooth or space, through all that is drawn."""
        low, high = float(content.imag.min()) - OVER * self.mm, float(content.imag.max()) + OVER * self.mm
        ends = max(low, self.y0 + self.mm), min(high, self.y1 - self.mm)
        self.board.line([complex(0, y) for y in ends], weight=0.3, **AXIS)


class SpaceDrawing(_Drawing):
    """The generation of one space."""

    def __init__(self, axes: Axes, member: Toothed, half: Half, generation: Generation) -> None:
        outline = generation.outline
        super().__init__(axes, member, outline, 12.0)
        self._body(outline, half)
        self.circles(half, 14.0)
        for k, tool in enumerate(generation.positions):
            middle = k == len(generation.positions) // 2
            self.board.line(tool, weight=0.05, **(UPRIGHT if middle else TOOL))
        self.board.line(outline, weight=1.0, **OUTLINE)
        if generation.path is not None:
            self.board.line(generation.path, weight=0.4, **CENTRE_PATH)
        self.axis(np.concatenate([outline, *generation.positions]))
        if generation.path is not None:
            middle = generation.path[len(generation.path) // 2]
            self.board.labels.put("$S$", [complex(middle)], size=9, color=MARK)

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
        look: dict[str, Any] = {"facecolor": self.face, "edgecolor": "none", "zorder": 1, "weight": 0.0}
        self.board.area(np.concatenate([outline, behind[::-1]]), **look)


class ToothDrawing(_Drawing):
    """Half a tooth, enlarged."""

    def __init__(self, axes: Axes, member: Toothed, half: Half) -> None:
        m = member.module
        self.half, self.runs = half, {part.name: m * _sampled(part) for part in half.parts}
        outline = np.concatenate(list(self.runs.values()))
        super().__init__(axes, member, np.concatenate([outline, [1j * outline.imag.min()]]), 13.0)
        self._body(outline)
        self.circles(half, 12.0)
        if member.shape == "external":
            self._tool()
        self.board.line(outline, weight=1.0, **OUTLINE)
        active = self._active()
        if active.size:
            self.board.line(active, weight=0.5, **ACTIVE)
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
        look: dict[str, Any] = {"facecolor": self.face, "edgecolor": "none", "zorder": 1, "weight": 0.0}
        self.board.area(np.concatenate([outline, behind[::-1]]), **look)

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
        self.board.line(self._inside(m * path_of_centre(flank, wide)), weight=0.5, **CENTRE_PATH)
        around = np.exp(2j * np.pi * np.linspace(0, 1, 121))
        rounding = complex(float(tool.x), float(tool.y)) + tool.width * around.real + 1j * tool.height * around.imag
        for name, color, dashes in MOMENTS:
            roll = np.array([at[name]])
            style = {"color": color, "linestyle": dashes, "zorder": 5}
            self.board.line(m * in_wheel(flank, rack_outline(flank), roll)[0], weight=0.15, linewidth=1.0, **style)
            if name != "A":
                circle = m * in_wheel(flank, rounding, roll)[0]
                self.board.line(circle, weight=0.15, linewidth=0.6, **style)
            centre = complex(m * path_of_centre(flank, roll)[0])
            if self._inside(np.array([centre])).size:
                self.board.circle(centre, 0.55, facecolor=color, edgecolor=color, zorder=12)
                self.board.labels.put(f"$S_{name}$", [centre], size=8, color=color, gaps=(1.4, 2.2, 3.4))

    def _inside(self, z: Plane) -> Plane:
        return z[(z.real > self.x0) & (z.real < self.x1) & (z.imag > self.y0) & (z.imag < self.y1)]

    def _points(self, active: Plane) -> None:
        """Names of the points of the profile."""
        for name, at in _named(self.member, self.half):
            self.board.circle(at, 0.7, facecolor=INK, zorder=12)
            self.board.labels.put(f"${name}$", [at], size=9, prefer=-1 + 0j, gaps=(1.6, 2.4, 3.4, 4.8))
        if not self.straight and active.size:
            radii = np.abs(active)
            last = active[np.argmax(radii) if self.member.shape == "ring" else np.argmin(radii)]
            self.board.labels.put(
                "$r_p$", [complex(last)], size=8, prefer=1 + 0j, gaps=(2.2, 3.2, 4.6), color="#00664b"
            )


def _sampled(part: ProfilePart) -> Plane:
    return part.curve.point(np.linspace(part.curve.start, part.curve.end, POINTS))


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
