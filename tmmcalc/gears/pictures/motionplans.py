"""A train in motion: its kinematic scheme to scale, beside it the plan of velocities, then that of speeds.

The line of centres stands upright in both the scheme and the plan of velocities, to one scale, so every axis and every
pitch point lies at its own height. A member's line goes through the ends of the velocities of its points; a ray from
the pole, parallel to it, cuts off the speed of the member on the line of speeds (see `tmmcalc.gears.network.plans`).
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import cycle
from typing import NamedTuple

import numpy as np

from tmmcalc.core.plane import Plane
from tmmcalc.gears.chosen.motion import Moving, plans_of
from tmmcalc.gears.gearingtask import ends
from tmmcalc.gears.network.model import Network
from tmmcalc.gears.network.plans import PlanLine, PlanPoint, Plans
from tmmcalc.gears.pictures.memberscheme import view_of
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.field import Board, Field
from tmmcalc.report.drawing.lettering import minus, plain, width
from tmmcalc.report.drawing.pens import AXIS, CURVES, INK, THIN, VECTORS, Pen
from tmmcalc.report.drawing.scales import factor_text, length_scale, scale_text, standard_scale
from tmmcalc.report.drawing.shapes import Arc, Drawing, Words
from tmmcalc.report.drawing.tables import draw_table
from tmmcalc.report.language import tr, tr_unit
from tmmcalc.report.numbers import number

MARGIN, GAP = 4.0, 8.0  # free border of the scheme, and between the parts [mm]
SCHEME, ALONE = 0.46, 0.6  # part of the width that the scheme takes at most; where speeds stand below
NARROW = 220.0  # width [mm] below which the plan of speeds stands under the others, not beside them
LOWER = 52.0  # height of its room there [mm]
ASIDE = 16.0  # room of names at both sides of the plan of velocities [mm]
FOOT = 6.0  # room of the scale factors under a plan [mm]
HEAD = 7.0  # room of the headings of the plans [mm]
POLES = (50.0, 40.0, 30.0, 25.0, 20.0, 15.0, 12.0, 10.0, 8.0, 6.0, 5.0, 4.0, 3.0, 2.0, 1.0)  # h [mm], as there is room
OVER = 8.0  # of the upright lines beyond what lies on them [mm]
FASTER = 4.0  # a member so many times faster than all others runs out of the plan of speeds,
RUNS_OUT = 22.0  # so far [mm]
STILL = 1e-9  # of the largest: what is at rest
TITLE, NAME, NOTE, RING = 3.0, 2.6, 2.5, 2.3  # heights of headings, names, of what is told, of members [mm]
USUAL, LARGEST = 300.0, 1.5  # width from which letters grow with the rectangle [mm], and how far: below a heading of A1
GUIDE = Pen("PLACES", 0.18, (1.6, 1.2), "#8a8a8a")
MEMBERS = tuple(Pen(f"MEMBERS_{k}", 0.55, pen.dashes, pen.colour) for k, pen in enumerate(CURVES, 1))


class Drawn(NamedTuple):
    """The three parts of the picture."""

    scheme: Board
    velocities: Field  # v [m/s] + i x [m]
    speeds: Field  # omega [rad/s] + i distance from the pole [mm]
    pole: float  # h [mm]


def draw_motion(drawing: Drawing, box: Box, found: Moving) -> Drawn:
    """Scheme, plan of velocities, plan of speeds with a table side by side; in a narrow box speeds stand below."""
    told, view = plans_of(found), view_of(found)
    part = min(LARGEST, max(1.0, box.width / USUAL))  # of letters
    narrow = box.width < NARROW
    room = box.inset(0, part * FOOT + (LOWER + HEAD) * narrow, 0, part * HEAD)
    share = ALONE if narrow else SCHEME
    size = complex(float(np.ptp(view.content.real)), float(np.ptp(view.content.imag)))
    reach = _heights(told)
    high = max(size.imag, float(np.ptp([*reach, *view.content.imag])))
    mu = length_scale(max(high / (room.height - 2 * MARGIN), size.real / (share * box.width - 2 * MARGIN)))
    wide = size.real / mu + 2 * MARGIN
    board = Board(drawing, Box(box.left, room.bottom, box.left + wide, room.top), view.content, MARGIN, mu)
    view.draw(board, part)
    second, third = Box(board.box.right, room.bottom, box.right, room.top).split(1.0, 1.0, gap=GAP, across=True)
    if narrow:
        second = Box(board.box.right, room.bottom, box.right, room.top)
        third = Box(box.left, box.bottom + part * FOOT, box.right, box.bottom + part * FOOT + LOWER)
    velocities = _Velocities(drawing, second, board, told, found.task.network, part)
    velocities.draw(float(view.content.real.max()))
    speeds, pole = _draw_speeds(drawing, third, told, mu, velocities.mu_v, found, part)
    for text, place in (
        (tr("Kinematic scheme"), board.box),
        (tr("Plan of linear velocities"), second),
        (tr("Plan of angular velocities"), third),
    ):
        drawing.add(Words(complex(place.left, place.top + part * HEAD), text, part * TITLE, -1 + 1j))
    said = f"{scale_text(mu)}, {factor_text('μ_v', velocities.mu_v, '(m/s)/mm')}"
    if told.assumed is not None:
        unknown = tr("no module is known: $m_1$ is {module} mm", module=number(1e3 * told.assumed))
        said = f"{said}; {unknown}"
    driver, _ = ends(found.task)
    if found.remarks and driver is not None:
        speed = tr("no speed is given: {member} turns at 1 rad/s", member=plain(driver))
        said = f"{said}; {speed}"
    _tell(drawing, complex(box.left, box.bottom), said, part * NOTE, second.right - box.left, -1j)
    return Drawn(board, velocities, speeds, pole)


def point_text(point: PlanPoint) -> str:
    """The name of a point: P with its wheels, O with its member."""
    letter, _, rest = point.name.partition("_")
    names = rest.split("-") if letter == "P" else [rest]
    return f"${letter}_{{{_joined(names)}}}$"


def _joined(names: Sequence[str]) -> str:
    """Names as an index, with a stroke between long ones."""
    return ("" if all(len(name.rstrip("'")) == 1 for name in names) else "–").join(names)


def _heights(told: Plans) -> list[float]:
    return [point.x for point in told.points]


def member_points(network: Network, told: Plans, member: str) -> Plane:
    """The points v + i x of a member (n,): its axis, its pitch points, the axes that it bears."""
    own = [point for point in told.points if member in point.members]
    borne = [
        point
        for point in told.points
        if point.kind == "axis" and any(network.bearer(name) == member for name in point.members)
    ]
    return np.array([complex(point.velocity, point.x) for point in (*own, *borne)])


def member_pens(told: Plans) -> dict[str, Pen]:
    """The pens of the members, by their order."""
    return {line.member: pen for line, pen in zip(told.lines, cycle(MEMBERS), strict=False)}


class _Velocities(Field):
    """The plan of velocities, at the heights of the scheme."""

    def __init__(self, drawing: Drawing, box: Box, scheme: Board, told: Plans, network: Network, part: float) -> None:
        self.told, self.network, self.part = told, network, part
        found = [point.velocity for point in told.points]
        low, high = min(0.0, *found), max(0.0, *found)
        self.mu_v = standard_scale((high - low) / (box.width - 2 * part * ASIDE))
        floor = scheme.data(complex(scheme.box.left, scheme.box.bottom)).imag
        left = (low + high) / 2 - self.mu_v * box.width / 2
        super().__init__(drawing, box, complex(left, floor), (1 / self.mu_v, 1 / scheme.mu))
        self.scheme = scheme

    def draw(self, right: float) -> None:
        """Lines of all members, velocities of all points; ``right`` is where the scheme ends [m]."""
        told, fastest = self.told, max(abs(point.velocity) for point in self.told.points)
        over = OVER * self.scheme.mu
        heights = _heights(told)
        zero = [complex(0, min(heights) - over), complex(0, max(heights) + over)]
        self.curve(np.array(zero), AXIS, weight=0.5, level=1)
        seen: set[tuple[float, float]] = set()
        for point in told.points:
            at, tip = self.place(complex(0, point.x)), self.place(complex(point.velocity, point.x))
            start = complex(self.scheme.place(complex(right, point.x)).real, at.imag)
            far = max(at.real, tip.real)
            self.drawing.line([start, complex(far, at.imag)], GUIDE, level=0)
            self.labels.avoid([complex(max(start.real, self.box.left), at.imag), complex(far, at.imag)], 0.4)
            if abs(point.velocity) > STILL * fastest and (tip.real, tip.imag) not in seen:
                self.drawing.vector(at, tip, VECTORS["absolute"], level=6)
                self.labels.avoid([at, tip], 0.8)
            seen.add((tip.real, tip.imag))
        for member, pen in member_pens(told).items():
            line = _ends(member_points(self.network, told, member))
            self.curve(line, pen, weight=1.0, level=5)
        for at in {self.place(complex(0, x)) for x in heights}:
            self.drawing.add(Arc(at, 0.7, THIN, fill="#ffffff"), level=8)
            self.labels.avoid([at], 3.0)
        self._names()

    def _names(self) -> None:
        merged: dict[float, list[PlanPoint]] = {}
        for point in self.told.points:
            merged.setdefault(round(self.place(complex(0, point.x)).imag, 1), []).append(point)
        for points in merged.values():
            text = ", ".join(dict.fromkeys(point_text(point) for point in points))
            self.name(text, [complex(0, points[0].x)], height=self.part * NAME, prefer=-1 + 0.4j)
        for member, pen in member_pens(self.told).items():
            line = _ends(member_points(self.network, self.told, member))
            along = [line[0] + part * (line[-1] - line[0]) for part in (0.5, 0.35, 0.65, 0.2, 0.8, 0.95)]
            own = self.paper(line).tolist()
            anchors = self.paper(along)
            self.labels.put(
                plain(member),
                anchors,
                height=self.part * RING,
                gaps=(1.0, 1.8, 3.0, 5.0, 8.0),
                ring=len(member) < 3,
                colour=pen.colour,
                own=own,
            )


def _ends(points: Plane) -> Plane:
    """The points between which the line of a member goes."""
    order = np.argsort(points.imag + 1e-9 * points.real / (1.0 + np.max(np.abs(points.real))))
    return points[order[[0, -1]]]


def _draw_speeds(
    drawing: Drawing, box: Box, told: Plans, mu_l: float, mu_v: float, found: Moving, part: float
) -> tuple[Field, float]:
    """The plan of speeds with its scale, under it the table of members and the ratio that the plan gives.

    The ray of a member that is far faster than all others runs out of the plan, which else would be too flat to read.
    """
    fast = _far_faster(told)
    omegas = [line.speed for line in told.lines if line is not fast]
    low, high = min(0.0, *omegas), max(0.0, *omegas)
    beside = box.width > 2 * box.height  # the table
    left, right = box.split(1.25, 1.0, gap=GAP, across=True) if beside else (box, box)
    room = box.height if beside else 0.45 * box.height
    beyond = 0.0 if fast is None else RUNS_OUT * part
    across = left.width - 2 * OVER - beyond
    fitting = [h for h in POLES if h < room - 2 * OVER and (high - low) * mu_l * h / mu_v <= across] or [POLES[-1]]
    standard = (h for h in fitting if math.isclose(standard_scale(mu_v / (mu_l * h)), mu_v / (mu_l * h)))
    pole = next(standard, fitting[0])  # under a scale such as 1:15 no factor of speeds is round
    mu = mu_v / (mu_l * pole)
    tall = pole + 2 * OVER + 6.0
    frame = Box(left.left, left.top - tall, left.right, left.top)
    below = right if beside else Box(box.left, box.bottom, box.right, frame.bottom - part * 6.0)
    aside = 0.0 if fast is None else math.copysign(beyond / 2, fast.speed)
    origin = complex((low + high) / 2 + mu * (aside - frame.width / 2), -OVER)
    field = Field(drawing, frame, origin, (1 / mu, 1.0))
    over = 0.6 * OVER * mu
    field.curve(np.array([low - over, high + over]) + 1j * pole, THIN, weight=0.8, level=2)
    field.curve(np.array([0j, 1j * pole]), AXIS, weight=0.5, level=1)
    pens = member_pens(told)
    for line in told.lines:
        end = complex(line.speed, pole)
        if line is fast:
            _run_out(field, line, end, high if line.speed > 0 else low, mu * beyond, pens[line.member], part)
            continue
        field.curve(np.array([0j, end]), pens[line.member], weight=1.0, level=5)
        field.drawing.add(Arc(field.place(end), 0.6, THIN, fill=INK), level=8)
    field.drawing.add(Arc(field.place(0j), 0.7, THIN, fill="#ffffff"), level=8)
    field.labels.put("$p$", [field.place(0j)], height=part * NAME, prefer=-1j)
    for text, at in _merged([line for line in told.lines if line is not fast], mu):
        field.name(text, [complex(at, pole)], height=part * RING, prefer=0.2 + 1j)
    said = f"{factor_text('μ_ω', mu, '(rad/s)/mm')}, $h$ = {number(pole)} {tr_unit('mm')}"
    _tell(drawing, complex(frame.left, frame.bottom), said, part * NOTE, frame.width, 1j)
    _tabulate(drawing, below, told, mu, found, part)
    return field, pole


def _far_faster(told: Plans) -> PlanLine | None:
    """The member beside whose speed all others are small, if there is one and another one turns."""
    first, second = sorted(told.lines, key=lambda line: -abs(line.speed))[:2] if told.lines[1:] else (None, None)
    if first is None or second is None or not 0.0 < FASTER * abs(second.speed) < abs(first.speed):
        return None
    return first


def _run_out(
    field: Field, line: PlanLine, end: complex, outermost: float, beyond: float, pen: Pen, part: float
) -> None:
    """The ray of a member that ends outside: so far ``beyond`` the outermost of the others, with its speed."""
    reach = outermost + math.copysign(beyond, line.speed)
    tip = end * (reach / line.speed)
    field.drawing.vector(field.place(0j), field.place(tip), pen, level=5)
    field.labels.avoid([field.place(0j), field.place(tip)], 1.0)
    text = f"{plain(line.member)}: {_told(line.speed)} {tr_unit('rad/s')}"
    field.name(text, [tip, 0.7 * tip], height=part * RING, prefer=math.copysign(1.0, line.speed) - 1j)


def _merged(lines: Sequence[PlanLine], mu: float) -> Iterator[tuple[str, float]]:
    """Names of the ends of the rays; of ends that fall together in one text."""
    groups: list[tuple[float, list[str]]] = []
    for line in sorted(lines, key=lambda each: each.speed):
        if groups and abs(line.speed - groups[-1][0]) < 2.5 * mu:
            groups[-1][1].append(plain(line.member))
        else:
            groups.append((line.speed, [plain(line.member)]))
    for speed, names in groups:
        yield ", ".join(names), speed


def _tabulate(drawing: Drawing, box: Box, told: Plans, mu: float, found: Moving, part: float) -> None:
    """Speeds of the members with the segments that stand for them, and the ratio of two segments."""
    head = (tr("member"), f"$ω$, {tr_unit('rad/s')}", f"$n$, {tr_unit('rpm')}", tr("segment, mm"))
    rows = [
        (plain(line.member), _told(line.speed), _told(line.turns), _told(line.speed / mu, 4)) for line in told.lines
    ]
    below = box.top - draw_table(drawing, box.inset(0, part * 6.0, 0, 0), head, rows, part * NAME)
    driver, outputs = ends(found.task)
    segments = {line.member: line.speed / mu for line in told.lines}
    shown = [name for name in outputs if segments.get(name)]
    if driver is None or not shown or driver in shown:
        return
    first, last = segments[driver], segments[shown[0]]
    said = tr(
        "From the plan: {ratio} = {first} : {last} = {value}",
        ratio=f"$i_{{{_joined((driver, shown[0]))}}}$",
        first=_told(first, 4),
        last=_told(last, 4),
        value=_told(first / last, 5),
    )
    _tell(drawing, complex(box.left, below - 2.0), said, part * NOTE, box.width, 1j)


def _tell(drawing: Drawing, at: complex, text: str, height: float, wide: float, align: complex) -> None:
    """A line of words, smaller where it is wider than its room."""
    drawing.add(Words(at, text, height * min(1.0, wide / width(text, height)), -1 + align))


def _told(value: float, digits: int = 6) -> str:
    return minus(number(value, digits))
