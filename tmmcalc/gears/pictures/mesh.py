"""The mesh to scale: teeth in contact, circles with their radii, line of action with its points, angles, distances."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from matplotlib.axes import Axes

from tmmcalc.core.plane import Plane
from tmmcalc.gears.pictures.dimensions import generating_points, pressure_angle
from tmmcalc.gears.pictures.placedpair import ALIKE, CIRCLES, SIGNS, Body, Circle, Mark, PlacedPair
from tmmcalc.gears.pictures.sketch import ACTION, CENTRES, COLOURS, FACES, SIZE, STYLES, THIN, Sketch, spread
from tmmcalc.report.drawing.board import Board
from tmmcalc.report.drawing.labels import MM
from tmmcalc.report.drawing.style import INK
from tmmcalc.report.numbers import number

MARGIN = 7.0  # free border [mm]
COLUMN = 27.0  # width of the columns of radii at the sides [mm]
LINE_PITCH = 4.6  # of the texts in a column [mm]
REACH = 8.0  # points of the line of action farther from P than this are left out [module]
OUT = 8.0  # of the line of centres beyond what it belongs to [mm]
OVER = 4.0  # of the line of action beyond its last points [mm]
SECTOR = math.radians(65)  # of a circle on both sides of the line of centres


def draw_mesh(axes: Axes, pair: PlacedPair) -> Board:
    """Draw on an axes whose place is settled; the board has the scale and the limits."""
    board = Board(axes, _content(axes, pair), MARGIN)
    axes.set_axis_off()
    picture = _Mesh(board, pair)
    for body in pair.bodies:
        picture.body(body)
    picture.circles()
    picture.centres()
    picture.action()
    generating_points(picture)
    pressure_angle(picture)
    picture.names()
    return board


def _content(axes: Axes, pair: PlacedPair) -> Plane:
    """Teeth and the points of the line of action, with room for the columns at the sides."""
    reach, at = REACH * pair.found.task.module, pair.pitch_point
    first, second = (body.edge for body in pair.bodies)
    low, high = float(first.real.min()), float(second.real.max())
    width = axes.get_window_extent().width * MM / axes.figure.dpi - 2 * MARGIN
    room = (high - low) * COLUMN / (width - 2 * COLUMN)
    marks = np.array([mark.at for mark in pair.marks if abs(mark.at - at) < reach])
    return np.concatenate([first, second, marks, [complex(low - room, at.imag), complex(high + room, at.imag)]])


class _Mesh(Sketch):
    """One mesh while it is drawn."""

    def body(self, body: Body) -> None:
        """Teeth, the material behind them, active flanks."""
        face: dict[str, Any] = {"facecolor": FACES[body.number - 1], "edgecolor": "none", "zorder": 1, "weight": 0.0}
        self.board.area(np.concatenate([body.edge, body.back[:: _along(body)]]), **face)
        self.board.line(body.edge, linewidth=1.2, zorder=7, weight=1.0)
        for flank in body.flanks:
            self.board.line(flank, linewidth=2.8, color=COLOURS[body.number - 1], zorder=8, weight=0.5)

    def circles(self) -> None:
        """The circles of both wheels, of a rack its lines, with their radii in the columns at the sides."""
        for body in self.pair.bodies:
            named = []
            for text, style, arc in self._rack_lines(body) if body.sizes is None else self._arcs(body):
                run = _longest(arc, self._between(arc, body))
                if len(run) > 1:
                    self.board.line(run, color=COLOURS[body.number - 1], zorder=5, weight=0.3, **style)
                    named.append((text, _end(run, body.number)))
            self._column(named, body)

    def _between(self, arc: Plane, body: Body) -> np.ndarray:
        """What of an arc is shown: all but the column on the wheel's own side."""
        x0, x1, _, _ = self.frame
        room = (COLUMN - 3.0) * self.mm
        own = arc.real > x0 + room if body.number == 1 else arc.real < x1 - room
        return self.seen(arc) & own

    def _arcs(self, body: Body) -> list[tuple[str, dict[str, Any], Plane]]:
        sizes = body.sizes
        if sizes is None:
            return []
        x0, x1, y0, y1 = self.frame
        diagonal = abs(complex(x1 - x0, y1 - y0))
        found: list[tuple[str, dict[str, Any], Plane]] = []
        named: dict[Circle, list[Circle]] = {}
        for circle in CIRCLES:
            radius = getattr(sizes, circle)
            same = [key for key in named if abs(getattr(sizes, key) - radius) < ALIKE * self.pair.found.task.module]
            if same:
                named[same[0]].append(circle)
            else:
                named[circle] = [circle]
        towards = 0.0 if body.number == 1 or sizes.kind == "ring" else math.pi
        for circle, names in named.items():
            radius = getattr(sizes, circle)
            half = min(SECTOR, 1.3 * diagonal / radius)
            turn = towards + math.pi / 2 + np.linspace(-half, half, 1201)
            said = "{=}".join(f"r_{{{SIGNS[name]}{body.number}}}" for name in names)
            text = f"${said}$ = {number(1e3 * radius, 5)}"
            found.append((text, STYLES[circle], body.centre + radius * np.exp(1j * turn)))
        return found

    def _rack_lines(self, body: Body) -> list[tuple[str, dict[str, Any], Plane]]:
        x0, x1, _, _ = self.frame
        pitch, datum = self.pair.pitch_point.imag, body.centre.imag
        level = {
            "root line": (body.edge.imag.max(), STYLES["root"]),
            "datum line": (datum, STYLES["reference"]),
            "pitch line": (pitch, STYLES["operating"]),
            "tip line": (body.edge.imag.min(), STYLES["tip"]),
        }
        if abs(datum - pitch) < ALIKE * self.pair.found.task.module:
            del level["pitch line"]
            level = {("datum and\npitch line" if k == "datum line" else k): v for k, v in level.items()}
        x = np.linspace(x0, x1, 401)
        return [(text, style, x + 1j * y) for text, (y, style) in level.items()]

    def _column(self, named: list[tuple[str, complex]], body: Body) -> None:
        """Texts one under another beside the ends of their circles, with leaders that do not cross."""
        if not named:
            return
        x0, x1, y0, y1 = self.frame
        left = body.number == 1
        named.sort(key=lambda item: (-item[1].imag, item[1].real if left else -item[1].real))
        step = LINE_PITCH * self.mm
        heights = spread([end.imag for _, end in named], step, y0 + 0.7 * step, y1 - 0.7 * step)
        foot = x0 + (COLUMN - 7.0) * self.mm if left else x1 - (COLUMN - 7.0) * self.mm
        side = foot + (-1.0 if left else 1.0) * self.mm
        for (text, end), y in zip(named, heights, strict=True):
            self.board.line([end, complex(foot, y)], weight=0.3, zorder=4, **THIN)
            style = {"size": 7.5, "color": COLOURS[body.number - 1], "va": "center", "ha": "right" if left else "left"}
            style["bbox"] = {"facecolor": "white", "edgecolor": "none", "pad": 1.0}
            self.board.axes.text(side, y, text, zorder=20, **style)
            edge = x0 if left else x1
            self.board.labels.avoid([complex(side, y), complex(edge, y)], 3.0)

    def centres(self) -> None:
        """The line of centres with the centres that are in the frame, the common tangent at P."""
        _, _, y0, y1 = self.frame
        edge, over = 1.0 * self.mm, OUT * self.mm
        ends = np.concatenate([[body.centre for body in self.pair.bodies], *(body.back for body in self.pair.bodies)])
        low, high = max(y0 + edge, ends.imag.min() - over), min(y1 - edge, ends.imag.max() + over)
        self.board.line([complex(0, low), complex(0, high)], weight=0.4, **CENTRES)
        for body in self.pair.bodies:
            if body.sizes is None:
                continue
            name, at = f"$O_{body.number}$", body.centre
            if self.seen(np.array([at]), 3.0)[0]:
                self.board.circle(at, 0.8, zorder=9)
                self.text(name, at, 1 + 0j, size=SIZE)
            else:
                below = at.imag < self.pair.pitch_point.imag
                if body.number == 1 and self.pair.found.task.kind == "internal":
                    continue  # both centres lie below; one arrow points to them
                if body.kind == "ring" and not self.seen(np.array([self.pair.bodies[0].centre]), 3.0)[0]:
                    name = "$O_1$, $O_2$"
                end = complex(0, y0 + edge if below else y1 - edge)
                self.board.arrowhead(end, -1j if below else 1j, 2.6)
                self.text(f"to {name}", end + (2 if below else -2) * 1j * self.mm, 1 + 0j, size=7.5)

    def action(self) -> None:
        """The line of action with its points, and where flanks touch."""
        pair, line = self.pair, self.pair.found.line
        rho = np.array([mark.rho for mark in pair.marks])
        over = OVER * self.mm
        self.board.line(pair.on_line(np.array([rho.min() - over, rho.max() + over])), linewidth=0.8, zorder=9)
        active = pair.on_line(np.array([line.begins, line.ends]))
        self.board.line(active, linewidth=2.4, color=ACTION, zorder=10)
        for body in pair.bodies:
            if body.sizes is None:
                continue
            foot = pair.base_point if body.number == 1 else pair.mark("N2").at
            self.board.line([foot, body.centre], weight=0.2, zorder=4, **THIN)
        for mark in pair.marks:
            if self.seen(np.array([mark.at]))[0]:
                self.board.circle(mark.at, 0.65, facecolor=INK, zorder=12)
            elif mark.name in ("N1", "N2"):
                self._leaving(mark)
        for rho1 in pair.contacts():
            self.board.circle(complex(pair.on_line(rho1)), 1.3, facecolor="none", edgecolor=ACTION, zorder=13)
        for text, at, anchors in self._merged():
            prefer = pair.direction * (1j if at.real > 0 else -1j)
            self.text(text, anchors, prefer, size=SIZE)

    def _leaving(self, mark: Mark) -> None:
        """Where the line of action leaves the frame towards a point outside."""
        start = self.pair.pitch_point
        line = start + (mark.at - start) * np.linspace(0.0, 1.0, 2001)
        inside = line[self.seen(line, 1.0)]
        onward = (mark.at - start) / abs(mark.at - start)
        self.board.arrowhead(complex(inside[-1]), onward, 2.6)
        self.text(f"to {_name(mark.name)}", inside[-1:] - 4 * self.mm * onward, -1j, size=7.5)

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
            text = ", ".join(_name(marks[k].name) for k in group)
            found.append((text, marks[group[0]].at, np.array([marks[k].at for k in group])))
        return found


def _along(body: Body) -> int:
    """The step that runs along the back of a body against the sense of its edge."""
    first = abs(body.back[0] - body.edge[0]) < abs(body.back[-1] - body.edge[0])
    return -1 if first else 1


def _name(mark: str) -> str:
    return f"${mark[0]}_{mark[1]}$" if len(mark) > 1 else f"${mark}$"


def _longest(arc: Plane, shown: np.ndarray) -> Plane:
    """The longest run of points that are shown."""
    at = np.flatnonzero(np.diff(np.concatenate([[0], shown.astype(int), [0]])))
    runs = list(zip(at[::2].tolist(), at[1::2].tolist(), strict=True))
    if not runs:
        return arc[:0]
    start, end = max(runs, key=lambda run: run[1] - run[0])
    return arc[start:end]


def _end(run: Plane, number: int) -> complex:
    """The end of a circle on the side of the wheel's column: left of the first, right of the second."""
    ends = [complex(run[0]), complex(run[-1])]
    return min(ends, key=lambda z: z.real) if number == 1 else max(ends, key=lambda z: z.real)
