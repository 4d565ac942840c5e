"""A pair as it stands in the drawing: teeth near the pitch point, circles, the line of action; lengths in metres.

External pairs stand as in the textbook: line of centres = Y, first wheel at the origin, the second above it, the first
wheel's tooth right of the pitch point P = (0, r_w1). The line of action then runs from N1 at the right up to the left:

    N2 --- L2 --- A1 ======== P ======== A2 --- L1 --- N1        K = N1 + rho1 e,  e = exp(i (pi - alpha_tw))

The centre of a ring lies below that of its pinion; a rack lies above its pinion.
"""

from __future__ import annotations

from math import cos, pi, sin, sqrt, tan
from typing import Literal

import numpy as np

from tmmcalc.core.plane import Plane, Real
from tmmcalc.core.records import record
from tmmcalc.gears.involute.function import involute
from tmmcalc.gears.involute.profile.mesh import Placing, placings, ring_placings
from tmmcalc.gears.involute.profile.outline import Element, element_outline, mirrored
from tmmcalc.gears.meshing.geometry import external_pair, internal_pair
from tmmcalc.gears.meshing.halftooth import Half, half_tooth
from tmmcalc.gears.meshing.members import Member, both
from tmmcalc.gears.meshing.results import MeshPair, WheelSizes

TEETH = 3  # of each wheel
RIM = 0.9  # [module] of the body that is shown behind the root circle
POINTS = 61  # of an active flank
FINE, COARSE = 5e-5, 2e-3  # chord tolerance of the teeth and of whole wheels [module]
ALIKE = 1e-9  # [module] points that are one

Circle = Literal["tip", "operating", "reference", "base", "root"]
CIRCLES: tuple[Circle, ...] = ("tip", "operating", "reference", "base", "root")
SIGNS = {"tip": "a", "operating": "w", "reference": "", "base": "b", "root": "f"}


@record
class Body:
    """One wheel or rack in its place."""

    number: int  # 1 or 2
    kind: Literal["external", "ring", "rack"]
    centre: complex  # of a rack the point of its datum line on the line of centres
    edge: Plane  # the outline of the teeth that are shown, in one piece
    back: Plane  # the edge of the body behind them, in the same direction
    flanks: tuple[Plane, ...]  # the flanks that touch the mate, on the part of the involute that does
    whole: Plane  # the whole wheel; of a rack the teeth that are shown
    sizes: WheelSizes | None  # None: rack

    @property
    def depths(self) -> tuple[float, float]:
        """Where tip and root lie on the line of centres."""
        if self.sizes is None:
            return float(self.edge.imag.min()), float(self.edge.imag.max())
        sense = -1 if self.number == 2 and self.kind == "external" else 1
        return self.centre.imag + sense * self.sizes.tip, self.centre.imag + sense * self.sizes.root


@record
class Mark:
    """A named point of the line of action."""

    name: str  # N1, L1, A2, P, A1, L2, N2; F where undercut or a ring ends the involute
    rho: float  # distance from N1
    at: complex


@record
class PlacedPair:
    """Both wheels in mesh."""

    found: MeshPair
    bodies: tuple[Body, Body]
    pitch_point: complex
    base_point: complex  # N1
    direction: complex  # e, from N1 along the line of action
    marks: tuple[Mark, ...]  # in their order along the line of action
    phase: float  # by which the first wheel has turned clockwise since the contact at P [rad]

    def on_line(self, rho: Real | float) -> Plane:
        """Points of the line of action at distances from N1."""
        return self.base_point + np.asarray(rho) * self.direction

    def mark(self, name: str) -> Mark:
        """The mark of this name."""
        return next(mark for mark in self.marks if mark.name == name)

    @property
    def gamma(self) -> float:
        """Angle P0-O-D [rad] from the line of centres to the flank's point on the reference circle (4.73)."""
        return float(involute(self.found.angle_w)) - float(involute(self.found.angle_t))

    @property
    def pitch(self) -> float:
        """Transverse base pitch, the distance of neighbouring contacts."""
        task = self.found.task
        return pi * task.module / cos(task.helix) * cos(self.found.angle_t)

    def contacts(self) -> Real:
        """rho1 of all points where flanks touch at this phase."""
        line, base = self.found.line, self.found.sizes[0].base
        first = line.pitch - self.phase * base
        steps = np.arange(np.ceil((line.begins - first) / self.pitch), np.floor((line.ends - first) / self.pitch) + 1)
        return np.asarray(first + steps * self.pitch)


def point_sign(name: str) -> str:
    """The sign of a point of the line of action.

    >>> point_sign("A2"), point_sign("P")
    ('$A_2$', '$P$')
    """
    return f"${name[0]}_{name[1]}$" if len(name) > 1 else f"${name}$"


def placed_pair(found: MeshPair, phase: float = 0.0, *, tolerance: float = FINE, points: int = POINTS) -> PlacedPair:
    """Put a pair on the drawing; the first wheel has turned clockwise by ``phase`` [rad] since the contact at P.

    Chords keep within ``tolerance`` [module] of the teeth; curves of flanks, and of a rack all, have so many points.
    """
    first, second = both(found)
    one, other = placings_of(found, phase)
    line = found.line
    rolled = np.array([line.begins, line.ends])
    if found.sizes[1:]:
        mate = _wheel(second, other, np.abs(line.length - rolled), tolerance, points)
    else:
        mate = _rack(second, other, rolled, points)
    bodies = _wheel(first, one, rolled, tolerance, points), mate
    e = complex(np.exp(1j * (pi - found.angle_w)))
    base_point = -1j * found.sizes[0].base * e
    marks = _marks(found)
    placed = tuple(Mark(name, rho, base_point + rho * e) for name, rho in marks)
    return PlacedPair(found, bodies, 1j * found.sizes[0].operating, base_point, e, placed, phase)


def _marks(found: MeshPair) -> list[tuple[str, float]]:
    line, (first, *others) = found.line, found.sizes
    marks = [("N1", 0.0), ("A2", line.start), ("P", line.pitch), ("A1", line.end)]
    under = first.limit is None or first.limit < 0
    marks.append(("F1", _rho(first, first.form)) if under or first.limit is None else ("L1", first.limit))
    if others:
        second = others[0]
        marks.append(("N2", line.length))
        if second.kind == "ring":
            marks.append(("F2", line.length + _rho(second, second.form)))
        elif second.limit is None or second.limit < 0:
            marks.append(("F2", line.length - _rho(second, second.form)))
        else:
            marks.append(("L2", line.length - second.limit))
    order = ("N2", "F2", "N1", "L1", "F1", "A2", "P", "A1", "L2") if line.length < 0 else ()
    return sorted(marks, key=lambda mark: (mark[1], order.index(mark[0]) if order else 0))


def _rho(sizes: WheelSizes, radius: float) -> float:
    """Radius of curvature of the involute at a radius."""
    return sqrt(max(radius**2 - sizes.base**2, 0.0))


def placings_of(found: MeshPair, phase: float) -> tuple[Placing, Placing]:
    """Where both wheels stand, in modules; a rack comes with a tooth on +Y of its datum line."""
    first, second = both(found)
    if found.task.kind == "external":
        return placings(external_pair(found), phase)
    if found.task.kind == "internal":
        pair = internal_pair(found)
        return ring_placings(first.wheel, second.wheel, pair.angle, pair.distance, phase)
    pinion = first.wheel
    shift, section = float(pinion.shift), pinion.section
    # the tooth left of P: its right-hand flank crosses the rolling line in P
    axis = shift * tan(section.angle) - pi / 4 * section.module + pinion.reference * phase
    return Placing(-float(pinion.half_angle) - phase, 0j), Placing(pi, axis + 1j * (pinion.reference + shift))


def _wheel(member: Member, placing: Placing, active: Real, tolerance: float, points: int) -> Body:
    """A wheel with the teeth (of a ring: spaces) nearest to the pitch point; rho at the ends of the contact."""
    module, sizes, element = member.module, member.found.sizes[member.place], member.element
    ring = member.shape == "ring"
    step, axis = 2 * pi / element.teeth, placing.turn + pi / 2
    towards = -pi / 2 if member.place and not ring else pi / 2
    count = min(TEETH, element.teeth)
    first = int(np.ceil(_turned(towards - axis) / step - count / 2 - 1e-9))
    numbers = range(first, first + count)
    one, whole = module * from_gap_to_gap(element, tolerance), module * element_outline(element, tolerance=COARSE)
    centre = module * placing.centre

    def put(points: Plane, k: float = 0.0) -> Plane:
        return centre + points * np.exp(1j * (placing.turn + k * step))

    behind = max(sizes.root + (RIM if ring else -RIM) * module, 0.2 * module)
    turn = axis + (first + np.linspace(-0.5, count - 0.5, 40 * count + 1)) * step
    flank = active_flank(half_tooth(member), active / module, points)
    # of a ring the left flank of a tooth, mirrored into the left one of the space beside it
    flank = module * (-np.conj(np.exp(-0.5j * step) * flank) if ring else flank)
    return Body(
        member.place + 1,
        sizes.kind,
        centre,
        np.concatenate([put(one, k) for k in numbers]),
        centre + behind * np.exp(1j * turn),
        tuple(put(flank, k) for k in numbers),
        np.concatenate([put(whole, k) for k in range(element.teeth)]),
        sizes,
    )


def active_flank(half: Half, rho: Real, points: int = POINTS) -> Plane:
    """The part of the involute of half a tooth between two radii of curvature, in modules."""
    curve = half.flank.curve
    low, high = sorted((curve.start, curve.end))
    start, end = np.clip(np.sort(rho) / half.base, low, high).tolist()
    return curve.point(np.linspace(start, end, points))


def _turned(angle: float) -> float:
    """An angle between -pi and pi."""
    return float(np.angle(np.exp(1j * angle)))


def from_gap_to_gap(element: Element, tolerance: float = FINE) -> Plane:
    """One element counter-clockwise, from the middle of the gap before it to that of the gap behind it."""
    one = element_outline(element, tolerance=tolerance)
    step = 2 * pi / element.teeth
    behind = np.angle(one * np.exp(-1j * pi / 2)) > step / 2
    ends = element.gap * np.exp(1j * (pi / 2 + np.array([-step / 2, step / 2])))
    return np.concatenate([ends[:1], one[behind] * np.exp(-1j * step), one[~behind], ends[1:]])


def rack_tooth(member: Member, points: int = POINTS) -> Plane:
    """One tooth of a rack, in modules, in the direction of -X from the middle of a space to the next."""
    parts = half_tooth(member).parts
    left = np.concatenate([part.curve.point(np.linspace(part.curve.start, part.curve.end, points)) for part in parts])
    return np.concatenate([left, mirrored(left)])[::-1]


def _rack(member: Member, placing: Placing, active: Real, points: int) -> Body:
    """The teeth of a rack that are nearest to the pitch point; rho1 at the ends of the contact."""
    module, found = member.module, member.found
    pitch, axis = 2 * member.half_pitch, placing.centre.real
    first = int(np.ceil(-axis / pitch - TEETH / 2 - 1e-9))
    one = module * rack_tooth(member, points) * np.exp(1j * placing.turn)
    places = module * (placing.centre + pitch * np.arange(first, first + TEETH))
    edge = np.concatenate([place + one for place in places])
    # heights of the contact over the datum line, towards the pinion
    height = module * placing.centre.imag - found.sizes[0].operating - (active - found.line.pitch) * sin(found.angle_w)
    slope = tan(found.angle_t)
    flank = -(-module * pitch / 4 + height * complex(slope, 1))
    back = edge[[0, -1]].real + 1j * (float(edge.imag.max()) + RIM * module)
    datum = 1j * module * placing.centre.imag
    return Body(2, "rack", datum, edge, back, tuple(place + flank for place in places), edge, None)
