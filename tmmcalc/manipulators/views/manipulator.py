"""The arm as a page moves it over the time: its links with the gripper, the path, obstacles, what joints may reach."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tmmcalc.core.notes import Phrase
from tmmcalc.core.plane import Plane
from tmmcalc.manipulators.columns import manipulator_columns
from tmmcalc.manipulators.results import Manipulator
from tmmcalc.manipulators.task import ManipulatorTask
from tmmcalc.manipulators.views.space import AslantArm
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.moving import FRAME, Arrow, Body, Layer, Mark, Span, Spot, Stop, Track, View, seconds_of

HAND = "3"  # the link that carries the gripper, and the one that carries it
ARM = "2"
GRIP = 0.035  # of the size of the scene: length of the jaws
GUIDE = 0.45  # of the shortest reach: where the block stands that the rod of the gripper runs in
OVERLAP = 0.06  # of the size: how far the rod stands out of its block at the longest reach
ARC = 32  # steps of a circle


def views(order: Order) -> Iterator[View]:
    """The arm in its vertical plane, or aslant where its base turns."""
    from tmmcalc.manipulators.tables.tasks.manipulator import to_manipulator

    task, result = to_manipulator(order.spec), order.results["manipulator"]
    if len(result.t) > 1:
        arm = AslantArm(task, result) if result.arm.spatial else _PlaneArm(task, result)
        yield View(
            name="manipulator",
            title="Manipulator",
            symbol="t",
            unit="s",
            values=result.t,
            whole=False,
            column=manipulator_columns(result)[0].header,
            steps=(),
            box=arm.box,
            bodies=tuple(arm.bodies()),
            frame=tuple(arm.frame()),
            spots=tuple(arm.spots()),
            spans=tuple(arm.spans()),
            layers=tuple(arm.layers()),
            stops=tuple(_stops(result)),
            shown=tuple(_shown(result)),
            stages=("manipulator",),
            seconds=seconds_of(result.duration),
        )


def _stops(result: Manipulator) -> Iterator[Stop]:
    """Where path or arm come to an obstacle, and where a joint passes its limit."""
    for contact in result.contacts:
        if contact.what != "straight line":
            for begin, _ in contact.intervals:
                yield Stop(Phrase("obstacle {obstacle}", obstacle=contact.obstacle), begin)
    for excess in result.excesses:
        yield Stop(Phrase("joint {joint}", joint=excess.joint), excess.first)


def _shown(result: Manipulator) -> Iterator[str]:
    """The joints' speeds; that of the gripper along its path."""
    if result.inverse:
        yield "manipulator.v"
    yield from (f"manipulator.{joint.rate}" for joint in result.arm.joints)


class _PlaneArm:
    """The arm in its vertical plane, x along, y upwards."""

    def __init__(self, task: ManipulatorTask, result: Manipulator) -> None:
        self.task, self.result, self.arm = task, result, result.arm
        self.hand = result.gripper[0, 0] + 1j * result.gripper[0, 1]
        self.shoulder = 1j * result.arm.height
        content = [self.hand, [0j, self.shoulder], *(each.corners for each in task.obstacles)]
        if result.elbow is not None:
            content.append(result.elbow[0] + 1j * result.elbow[1])
        places: Plane = np.concatenate([np.asarray(each, complex) for each in content])
        self.size = float(max(np.ptp(places.real), np.ptp(places.imag)))
        self.grip = GRIP * self.size
        back = self._back(places)
        low, high = (complex(f(back.real), f(back.imag)) for f in (np.min, np.max))
        self.box = (low - (1 + 1j) * self.grip, high + (1 + 1j) * self.grip)

    def _back(self, places: Plane) -> Plane:
        """All places, with the ends of a rod that stands out of its guide."""
        if self.arm.kind == "angular":
            return places
        return np.concatenate((places, self.hand - self._rod() * self._way()))

    def _way(self) -> Plane:
        """Unit vectors (n,) along the rod of the gripper."""
        if self.arm.kind == "spherical":
            return np.asarray(np.exp(1j * self.result.q[0, 0]))
        return np.full(len(self.hand), self._side() + 0j)

    def _side(self) -> float:
        """Of a carriage: +1 where its rod points along x, -1 against."""
        return 1.0 if np.mean(self.result.q[0, 1]) >= 0 else -1.0

    def _reach(self) -> tuple[float, float]:
        """The shortest and the longest reach along the rod; nothing where it comes to the other side."""
        reach = self.result.q[0, 1] * (self._side() if self.arm.kind == "cylindrical" else 1.0)
        return max(0.0, float(np.min(reach))), float(np.max(reach))

    def _guide(self) -> float:
        """Where the block of the rod stands from the shoulder or the column."""
        return GUIDE * self._reach()[0]

    def _rod(self) -> float:
        """How long the rod of the gripper is."""
        return self._reach()[1] - self._guide() + OVERLAP * self.size

    def bodies(self) -> Iterator[Body]:
        """Both links, that of the gripper beneath."""
        q, still = self.result.q, np.zeros(len(self.result.t))
        angle = Track(still, still) if self.arm.kind == "cylindrical" else Track(q[0, 0], q[1, 0])
        shoulder = Track(still, still), Track(still + self.arm.height, still)
        if self.arm.kind == "angular":
            elbow = self._elbow()
            bar = Mark("bar", (0j, complex(self.arm.upper)))
            yield Body(ARM, *shoulder, angle, (bar,), ARM, (self.arm.upper / 2 + 0j,))
            held = (Mark("bar", (0j, self.arm.forearm - self.grip + 0j)), *_jaws(self.arm.forearm, 1, self.grip))
            yield Body(HAND, *elbow, Track(q[0, 1], q[1, 1]), held, HAND, (self.arm.forearm / 2 + 0j,))
            return
        side, rod, at = self._side() if self.arm.kind == "cylindrical" else 1.0, self._rod(), self._guide()
        marks = (Mark("bar", (-side * rod + 0j, -side * self.grip + 0j)), *_jaws(0.0, side, self.grip))
        x, y = (Track(self.result.gripper[0, k], self.result.gripper[1, k]) for k in (0, 1))
        yield Body(HAND, x, y, angle, marks, HAND, (-side * (self._reach()[0] - at) / 2 + 0j,))
        block = Mark("block", (side * at + 0j, 1 + 0j))
        bar = Mark("bar", (0j, side * at + 0j))
        if self.arm.kind == "spherical":
            yield Body(ARM, *shoulder, angle, (bar, block), ARM, (side * at / 2 + 0j,))
        else:
            carriage = Track(still, still), Track(q[0, 0] + self.arm.height, q[1, 0])
            marks = (bar, Mark("block", (0j, 1j)), block)
            yield Body(ARM, *carriage, angle, marks, ARM, (side * at / 2 + 0j,))

    def _elbow(self) -> tuple[Track, Track]:
        """The elbow on its circle."""
        phi, omega = self.result.q[:2, 0]
        length, height = self.arm.upper, self.arm.height
        return (
            Track(length * np.cos(phi), -length * omega * np.sin(phi)),
            Track(height + length * np.sin(phi), length * omega * np.cos(phi)),
        )

    def frame(self) -> Iterator[Mark]:
        """Obstacles, what the joints may reach, the stand."""
        yield from (Mark("zone", obstacle.corners) for obstacle in self.task.obstacles)
        if area := self._range():
            yield Mark("range", area)
        if self.arm.kind == "cylindrical":
            h = self.result.q[0, 0]
            ends = (1j * (self.arm.height + float(f(h))) for f in (np.min, np.max))
            yield Mark("guide", (*ends, complex(-self._side())))
            return
        if self.shoulder:
            yield Mark("bar", (0j, self.shoulder))
        yield Mark("pivot", (0j, -1j))

    def _range(self) -> tuple[complex, ...]:
        """The border of what a rod reaches within the limits of its joints, where both have two."""
        limits = {each.name: (each.low, each.high) for each in self.task.limits}
        (a, b), (low, high) = (limits.get(joint.name, (None, None)) for joint in self.arm.joints)
        if self.arm.kind == "angular" or a is None or b is None or low is None or high is None:
            return ()
        if self.arm.kind == "cylindrical":
            return tuple(self.shoulder + r + 1j * h for r, h in ((low, a), (high, a), (high, b), (low, b)))
        turn = np.exp(1j * np.linspace(a, b, ARC + 1))
        return tuple(complex(z) for z in self.shoulder + np.concatenate((high * turn, low * turn[::-1])))

    def spots(self) -> Iterator[Spot]:
        """The gripper with its path, the pins, names of obstacles."""
        end = self.arm.forearm if self.arm.kind == "angular" else 0.0
        yield Spot("P", HAND, complex(end), "point", path=True)
        if self.arm.kind != "cylindrical":
            yield Spot("O", FRAME, self.shoulder, "pin")
        if self.arm.kind == "angular":
            yield Spot("E", HAND, 0j, "pin", path=True)
        for obstacle in self.task.obstacles:
            yield Spot(obstacle.name, FRAME, sum(obstacle.corners) / len(obstacle.corners), "word")

    def spans(self) -> Iterator[Span]:
        """None: links are rigid here."""
        yield from ()

    def layers(self) -> Iterator[Layer]:
        """Velocity and acceleration of the gripper."""
        for name, letter, title, unit in (
            ("velocity", "v", "Velocities", "m/s"),
            ("acceleration", "a", "Accelerations", "m/s^2"),
        ):
            arrow = Arrow(f"{letter}_P", "P", f"manipulator.{letter}x", f"manipulator.{letter}y")
            yield Layer(name, title, unit, (arrow,), hidden=name == "acceleration")


def _jaws(at: float, side: float, size: float) -> Iterator[Mark]:
    """The jaws about the gripper's point, at a place along the rod."""
    points = [at + side * size * z for z in (0.4 + 0.6j, -1 + 0.6j, -1 - 0.6j, 0.4 - 0.6j)]
    yield Mark("bar", tuple(points))
