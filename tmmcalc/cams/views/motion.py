"""The cam as a page moves it: it turns under its follower, with the pressure angle, the velocity, the forces.

Axes of the page are those of the profile at phi = 0: O at 0, x to the right, y along the lift; of a rocker x leads to
its pivot. The cam turns, the follower stands on it as the law says.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import pairwise

import numpy as np

from tmmcalc.cams.follower import Complex, along
from tmmcalc.cams.forces.results import CamForces
from tmmcalc.cams.lawresult import DERIVATIVE, DISPLACEMENT
from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.pictures.ordered import cam_of
from tmmcalc.cams.pressure.solve import Pressure
from tmmcalc.cams.profile.offsets import Rim
from tmmcalc.cams.profile.outline import outline
from tmmcalc.cams.profile.results import Profile
from tmmcalc.core.facts import named
from tmmcalc.core.notes import Phrase
from tmmcalc.core.plane import Plane
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.moving import (
    FRAME,
    Angle,
    Arrow,
    Body,
    Driver,
    Handle,
    Layer,
    Mark,
    Spot,
    Stop,
    Track,
    Vector,
    View,
)
from tmmcalc.report.moving import track_of as track

CHORD = 4e-6  # of the size: how far the drawn curves may be from the true ones
AROUND = 240  # points of a circle
RIM = 0.14  # of its radius: what a disc with a groove has beyond it
STEM = 0.045  # of the size: half its width, where it is not given
GAP = 0.05  # of the size: between the cam and a guide that is not given
GUIDE = 0.22  # of the size: its length then
OVER = 0.06  # of the size: how far the stem looks out of its guide at its lowest
PER = math.pi / 180  # rates are by degrees


class CamInMotion:
    """The cam and its follower while their view is made; all places (n,) [m] are those at the rows of the profile."""

    def __init__(self, order: Order) -> None:
        results = order.results
        self.profile: Profile = results["cam_profile"]
        self.pressure: Pressure | None = results.get("cam_pressure")
        self.forces: CamForces | None = results.get("cam_forces")
        self.task = cam_of(order)
        self.crank = order.results.get("kinematics") if order.spec.cam.speed is None else None  # that it turns with
        self.follower = self.profile.follower
        self.rocks = self.follower.kind == "oscillating"
        rows = self.profile.positions
        self.phi = rows.phi
        self.motion = self.task.program.at(rows.phi, rows.piece)
        self.turned = -self.follower.sense * self.phi  # angle of the cam
        self.normal: Complex = self.profile.normal * np.exp(1j * self.turned)  # out of the cam
        self.pivot = complex(self.follower.centres)
        self.arm = math.pi - self._side * (self.follower.start + self.motion[0])  # angle of a rocker
        self.seat, self.rate, self.second = self._seat()
        self.rim = Rim(self.follower, self.task.program)
        self.reach = max(float(np.abs(points).max()) for points in self._curves())
        self.size = 2 * self.reach

    @property
    def _side(self) -> int:
        """+1: the rocker turns clockwise on its rise."""
        return self.follower.assembly * self.follower.sense

    def _seat(self) -> tuple[Complex, Complex, Complex]:
        """Where the roller's centre stands (of a flat face its foot), with two derivatives by phi."""
        y, y1, y2, _ = self.motion
        if not self.rocks:
            return self.follower.offset * self.follower.sense + 1j * (self.follower.start + y), 1j * y1, 1j * y2
        way, turn, faster = self.follower.rocker * np.exp(1j * self.arm), -self._side * y1, -self._side * y2
        return self.pivot + way, 1j * turn * way, (1j * faster - turn**2) * way

    @property
    def upward(self) -> Complex:
        """Directions (n,) in which the follower goes on its rise."""
        return -1j * self._side * np.exp(1j * self.arm) if self.rocks else np.full(len(self.phi), 1j)

    def view(self) -> View:
        """All of it."""
        bodies = [self._cam(), self._moved(), self._touching(), *self._standing()]
        content = np.array([point for body in bodies for point in self._swept(body)])
        content = np.append(content, [self.pivot, *([] if self.rocks else [1j * height for height in self._guide()])])
        return View(
            name="cam_profile",
            title="Cam mechanism",
            symbol="φ",
            unit="deg",
            values=self.profile.positions.degrees,
            whole=True,
            column="phi[deg]",
            steps=(),
            box=(
                complex(content.real.min(), content.imag.min()),
                complex(content.real.max(), content.imag.max()),
            ),
            bodies=tuple(bodies),
            frame=(),
            spots=tuple(self._spots()),
            handle=Handle("cam", pivot=0j),
            layers=tuple(self._layers()),
            stops=tuple(self.stops()),
            shown=tuple(self._shown()),
            driver=self._driver(),
            front=tuple(self._front()),
        )

    def _driver(self) -> Driver | None:
        """The crank, where the cam turns with it."""
        if self.crank is None or not self.crank.turns:
            return None
        return Driver("kinematics", self.task.ratio, math.degrees(self.task.begin))

    def _curves(self) -> Iterator[Plane]:
        """The walls of the cam, of a flat face the profile; the pitch curve."""
        for wall in (self.profile.working, self.profile.outer):
            if wall is not None:
                yield wall.points
        if self.profile.pitch is not None:
            yield self.profile.pitch

    def _swept(self, body: Body) -> Iterator[complex]:
        """Where the marks of a body come to."""
        if body.name == "cam":
            yield from self._disc * np.array([1, 1j, -1, -1j])
            return
        pose = np.exp(1j * body.angle.values)
        at = body.x.values + 1j * body.y.values
        for mark in body.marks:
            for point in mark.points:
                yield from (at + pose * point)[:: max(1, len(at) // 60)].tolist()

    @property
    def _disc(self) -> float:
        """Radius of what turns."""
        return self.reach * (1 + RIM) if self.profile.outer is not None else self.reach

    def _drawn(self, distance: float) -> tuple[complex, ...]:
        """An offset of the pitch curve as a polygon."""
        return tuple(outline(self.rim, "", distance, CHORD * self.size).polygon.tolist())

    def _cam(self) -> Body:
        """The profile, of a groove both walls in a disc; pitch curve, base circle, ends of the phases."""
        marks = []
        if self.profile.outer is not None:
            around = self._disc * np.exp(2j * np.pi * np.arange(AROUND) / AROUND)
            marks = [Mark("plate", tuple(around.tolist())), Mark("hole", self._drawn(self.profile.outer.distance))]
        marks.append(Mark("plate", self._drawn(self.profile.working.distance)))
        marks.append(Mark("pitch", (0j,), self.follower.base))
        if self.task.limits.shaft:
            marks.append(Mark("circle", (0j,), self.task.limits.shaft))
        if self.profile.pitch is not None and self.follower.roller:
            pitch = self._drawn(0.0)
            marks.append(Mark("line", (*pitch, pitch[0])))
        starts = self.task.program.starts[:-1]
        for end in self.follower.placed(self.rim.at(starts).offset(self.profile.working.distance)).tolist():
            marks.append(Mark("line", (0j, end)))
        still, beside = (
            self.still(0.0),
            0.5 * self.profile.nearest.value * np.exp(1j * np.array([-0.8, -2.4, 2.4, 0.8])),
        )
        return Body("cam", still, still, self._turning(self.turned), tuple(marks), "1", tuple(beside.tolist()))

    def still(self, value: float) -> Track:
        """A track of what does not move."""
        return track(np.array(value), np.array(0.0), len(self.phi))

    def _turning(self, angle: Values) -> Track:
        """A track of an angle that is linear in phi."""
        return track(angle, np.array(-self.follower.sense * PER), len(self.phi))

    def _moved(self) -> Body:
        """The follower: a stem with roller, edge or face, or a rocker with roller or edge."""
        roller, number = self.follower.roller, "2"
        ring = [Mark("roller", (complex(self.follower.rocker if self.rocks else 0.0),), roller)] if roller else []
        if self.rocks:
            marks = (Mark("bar", (0j, complex(self.follower.rocker))), *ring)
            x, y, angle = (self.still(value) for value in (self.pivot.real, self.pivot.imag, 0.0))
            angle = track(self.arm, -self._side * self.motion[1] * PER, len(self.phi))
            return Body("follower", x, y, angle, marks, number, (0.5 * self.follower.rocker + 0j,))
        lower, upper = self._guide()
        foot = self.seat.imag.min()
        top, half = upper + OVER * self.size - foot, self._stem()
        corners = [complex(half, top), complex(-half, top)]
        face = self.profile.face
        if face is not None:
            ends = complex(-face.left - face.margin), complex(face.right + face.margin)
            marks = (Mark("plate", (*corners, complex(-half), complex(half))), Mark("bar", ends))
        elif roller:
            marks = (Mark("plate", (*corners, complex(-half), complex(half))), *ring)
        else:
            marks = (Mark("plate", (*corners, complex(-half, 2 * half), 0j, complex(half, 2 * half))),)
        beside = (1j * (roller + 0.45 * (lower - self.seat.imag.max() - roller)), 1j * (top - OVER * self.size / 2))
        body = (
            track(self.seat.real, self.rate.real * PER, len(self.phi)),
            track(self.seat.imag, self.rate.imag * PER, len(self.phi)),
        )
        return Body("follower", *body, self.still(0.0), marks, number, (beside[1], beside[0]))

    def _touching(self) -> Body:
        """Where the follower touches the cam."""
        at = self.profile.working.points * np.exp(1j * self.turned)
        return Body("contact", self.traced(at.real), self.traced(at.imag), self.still(0.0), ())

    def _standing(self) -> Iterator[Body]:
        """The centre of a roller or the edge of a knife, which does not turn; the edges of the guide."""
        x, y = (track(part(self.seat), part(self.rate) * PER, len(self.phi)) for part in (np.real, np.imag))
        yield Body("centre", x, y, self.still(0.0), ())
        if self.forces is not None and self.forces.guide is not None:
            for name, height in zip(("lower edge", "upper edge"), self._guide(), strict=True):
                yield Body(name, self.still(float(self.seat[0].real)), self.still(height), self.still(0.0), ())

    def shown_alone(self) -> Iterator[Body]:
        """The centre of the roller; the rocker that bears it, or the line of the stem."""
        yield next(self._standing())
        if self.rocks:
            moved = self._moved()
            yield moved._replace(marks=moved.marks[:1])
            return
        at, ends = float(self.seat[0].real), (self.seat.imag.min(), self.seat.imag.max())
        over = 0.1 * self.size
        line = Mark("line", (complex(at, ends[0] - over), complex(at, ends[1] + over)))
        yield Body("stem", self.still(0.0), self.still(0.0), self.still(0.0), (line,))

    def _guide(self) -> tuple[float, float]:
        """Heights of the edges of the guide; where it is not given it stands clear of the cam."""
        if self.forces is not None and self.forces.guide is not None:
            return self.forces.guide.lower, self.forces.guide.top
        roller = 0.0 if self.profile.flat else self.follower.roller
        clear = max(float(self.seat.imag.max()) + roller, self._disc)
        return clear + GAP * self.size, clear + (GAP + GUIDE) * self.size

    def _stem(self) -> float:
        """Half the width of the stem."""
        return self.task.guide.stem or STEM * self.size / 2

    def _front(self) -> Iterator[Mark]:
        """The pivots of cam and rocker, the guide of a stem on both sides of it; how the cam turns."""
        yield Mark("pivot", (0j, -1j))
        radius, sense = (
            max(0.45 * self.profile.nearest.value, 0.25 * self.follower.base, 1.3 * self.task.limits.shaft),
            self.follower.sense,
        )
        yield Mark("sense", (0j, radius * np.exp(1j * math.pi * (0.5 + 0.35 * sense))), -0.7 * math.pi * sense)
        if self.rocks:
            yield Mark("pivot", (self.pivot, -1j))
            return
        at = float(self.seat[0].real)
        for way in (-1, 1):
            ends = (complex(at + way * self._stem(), height) for height in self._guide())
            yield Mark("wall", (*ends, complex(way)))

    def _spots(self) -> Iterator[Spot]:
        """O, the pivot of a rocker, the centre of the roller, the contact."""
        yield Spot("O", FRAME, 0j, "pin")
        if self.rocks:
            yield Spot("A", FRAME, self.pivot, "pin")
        if not self.profile.flat:
            yield Spot("C", "centre", 0j, "pin" if self.follower.roller else "point", path=self.rocks)
        if self.profile.flat or (self.follower.roller and self.profile.outer is None):
            yield Spot("K", "contact", 0j, "point")

    def _layers(self) -> Iterator[Layer]:
        if self.pressure is not None and not self.profile.flat:
            theta = np.unwrap(np.angle(self.normal / self.upward))
            start = np.unwrap(np.angle(self.upward))
            angle = Angle("theta", "centre", self.traced(start), self.traced(start + theta), "cam_pressure.theta")
            yield Layer("pressure", "Pressure angle", "deg", (), angles=(angle,))
        speed = None if self.task.loads is None else self.task.loads.speed
        if speed is not None:
            x, y = (
                track(part(self.rate) * speed, part(self.second) * speed * PER, len(self.phi))
                for part in (np.real, np.imag)
            )
            sign = "v" if self.profile.flat else "v_C"
            yield Layer("velocity", "Velocities", "m/s", (), (Vector(sign, "centre", x, y),))
        if self.forces is not None:
            arrows, vectors = tuple(self._arrows()), tuple(self._vectors(self.forces))
            yield Layer("force", "Forces on the follower", "N", arrows, vectors, hidden=True)

    def _arrows(self) -> Iterator[Arrow]:
        """The force of the frame on a rocker."""
        if self.rocks:
            yield Arrow("R_A", "A", "cam_forces.R_A_x", "cam_forces.R_A_y")

    def _vectors(self, forces: CamForces) -> Iterator[Vector]:
        """The force of the cam with its parts along the motion and across it, those of the edges of the guide."""
        body = "contact" if self.profile.flat else "centre"
        force = forces.contact * self.normal
        useful = (force * np.conj(self.upward)).real * self.upward
        yield self._vector("R", body, force)
        if not self.profile.flat:
            yield self._vector("R cos θ", body, useful)
            yield self._vector("R sin θ", body, force - useful)
        if forces.lower is not None and forces.upper is not None:
            yield self._vector("N_1", "lower edge", forces.lower + 0j)
            yield self._vector("N_2", "upper edge", forces.upper + 0j)

    def _vector(self, sign: str, body: str, values: Plane) -> Vector:
        return Vector(sign, body, self.traced(values.real), self.traced(values.imag))

    def traced(self, values: Values) -> Track:
        """A track whose rates are differences of its values, on either side of what jumps."""
        return Track(values, rates(self.profile.positions.degrees, values))

    def stops(self) -> Iterator[Stop]:
        """The beginnings of the phases, the largest pressure angles."""
        program = self.task.program
        for begin, phase in zip(program.starts.tolist(), program.phases, strict=False):
            yield Stop(Phrase("beginning: {phase}", phase=phase.kind), math.degrees(begin))
        if self.pressure is not None and not self.profile.flat:
            for kind, on in (("rise", self.pressure.rise), ("return", self.pressure.back)):
                yield Stop(Phrase("largest pressure angle: {phase}", phase=kind), math.degrees(on.worst.phi))

    def _shown(self) -> Iterator[str]:
        """The law with two derivatives, the pressure angle, the force of the cam and its torque."""
        told = [DISPLACEMENT.of(**along(self.rocks)), *(DERIVATIVE[self.rocks].of(order=order) for order in (1, 2))]
        yield from (f"cam_law.{named(each.key)[0]}" for each in told)
        if self.pressure is not None and not self.profile.flat:
            yield "cam_pressure.theta"
        if self.forces is not None:
            yield from ("cam_forces.R", "cam_forces.M_drive")


def rates(at: Values, values: Values) -> Values:
    """Derivatives (n,) of values by differences; where two rows stand at one place each has its own side.

    >>> rates(np.array([0.0, 1.0, 2.0, 2.0, 3.0]), np.array([0.0, 2.0, 4.0, 7.0, 7.0]))
    array([2., 2., 2., 0., 0.])
    """
    ends = [0, *(np.flatnonzero(np.diff(at) == 0) + 1).tolist(), len(at)]
    found = np.zeros(len(at))
    for begin, end in pairwise(ends):
        if end - begin > 1:
            found[begin:end] = np.gradient(values[begin:end], at[begin:end], edge_order=2 if end - begin > 2 else 1)
    return found
