"""An arm with a turning base as it is seen aslant: its links, their shadow on the ground, obstacles as prisms."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.plane import Plane
from tmmcalc.manipulators.arms import direct
from tmmcalc.manipulators.results import Manipulator
from tmmcalc.manipulators.task import ManipulatorTask, Obstacle
from tmmcalc.report.moving import FRAME, Body, Layer, Mark, Span, Spot, Track, Vector

ASIDE = math.radians(55.0)  # of the middle of the motion: from where it is seen
ABOVE = math.radians(24.0)
SIGHT = 0.02  # of the size of the scene: radius of the gripper
STAND = 0.09  # radius of the foot
AXES = 0.3  # length of the axes
SLEEVE = 0.05  # half the length of a guide
ARC = 48  # corners of the foot
BASE, CARRIER, HAND = "1", "2", "3"


class AslantArm:
    """The arm in parallel projection: what is at a place [m] of space is seen at a place of the plane."""

    def __init__(self, task: ManipulatorTask, result: Manipulator) -> None:
        self.task, self.result, self.arm = task, result, result.arm
        hand = result.gripper
        self.azimuth = float(np.angle(np.mean(np.exp(1j * result.q[0, 0])))) - ASIDE
        self.points = {"hand": hand, "middle": self._middle()}
        ground = hand.copy()
        ground[:, 2] = 0.0
        self.points["ground"] = ground
        self.size = float(np.max(np.abs(hand[0]))) + self.arm.height / 4
        seen = np.concatenate([self.seen(each[0]) for each in (*self.points.values(), *self._standing())])
        margin = 2 * SIGHT * self.size * (1 + 1j)
        low, high = (complex(f(seen.real), f(seen.imag)) for f in (np.min, np.max))
        self.box = (low - margin, high + margin)

    def _middle(self) -> Values:
        """The elbow, or where the rod leaves its guide: the carriage, or the shoulder that the rod runs through."""
        q = self.result.q.copy()
        if self.arm.kind == "angular":
            q[:, 2] = 0.0
            q[0, 2] = self.arm.upper
            return direct(replace(self.arm, kind="spherical"), q)
        q[:, 2] *= 0.0
        return direct(self.arm, q)

    def _standing(self) -> Iterator[Values]:
        """What stands: the column, obstacles, axes; each (1, 3, m)."""
        yield np.array([[0.0, 0.0, 0.0], [0.0, 0.0, self._top()]]).T[None]
        yield (AXES * self.size * np.eye(3))[None]
        for obstacle in self.task.obstacles:
            yield np.concatenate([_level(obstacle, z) for z in (obstacle.low, obstacle.high)], axis=1)[None]

    def _top(self) -> float:
        """How high the column is."""
        return self.arm.height + (float(np.max(self.result.q[0, 1])) if self.arm.kind == "cylindrical" else 0.0)

    def seen(self, places: Values) -> Plane:
        """Where places, or differences of places, (3, ...) are seen."""
        x, y, z = places
        c, s = math.cos(self.azimuth), math.sin(self.azimuth)
        up = z * math.cos(ABOVE) - (x * c + y * s) * math.sin(ABOVE)
        return np.asarray(y * c - x * s + 1j * up)

    def _at(self, *place: float) -> complex:
        return complex(self.seen(np.array(place)))

    def bodies(self) -> Iterator[Body]:
        """The points that links go through, the gripper as a small circle; numbers of links at their middles."""
        still = Track(np.zeros(len(self.result.t)), np.zeros(len(self.result.t)))
        shoulder = np.zeros_like(self.points["hand"])
        shoulder[0, 2] = self.arm.height
        inner = shoulder if self.arm.kind == "angular" else self.points["middle"]
        made = {
            "hand": (self.points["hand"], (Mark("circle", (0j,), SIGHT * self.size),), ""),
            "middle": (self.points["middle"], (), ""),
            "ground": (self.points["ground"], (), ""),
            CARRIER: ((inner + self.points["middle"]) / 2, (), CARRIER),
            HAND: ((self.points["middle"] + self.points["hand"]) / 2, (), HAND),
            **{f"sleeve {k}": (each, (), "") for k, each in enumerate(self._sleeve())},
        }
        for name, (states, marks, number) in made.items():
            place, rate = self.seen(states[0]), self.seen(states[1])
            yield Body(name, Track(place.real, rate.real), Track(place.imag, rate.imag), still, marks, number, (0j,))

    def _sleeve(self) -> Iterator[Values]:
        """The ends of the guide that the rod runs in, about the shoulder or the column."""
        if self.arm.kind != "angular":
            q = self.result.q.copy()
            q[1:, 2] = 0.0
            for along in (-SLEEVE, SLEEVE):
                q[0, 2] = along * self.size
                yield direct(self.arm, q)

    def frame(self) -> Iterator[Mark]:
        """The foot, axes, obstacles from below upwards."""
        around = STAND * self.size * np.exp(2j * np.pi * np.arange(ARC) / ARC)
        foot = self.seen(np.stack((around.real, around.imag, 0 * around.real)))
        yield Mark("outline", tuple(foot.tolist()))
        for axis in np.eye(3):
            yield Mark("line", (0j, self._at(*(AXES * self.size * axis))))
        for obstacle in self.task.obstacles:
            low, high = (self.seen(_level(obstacle, z)) for z in (obstacle.low, obstacle.high))
            yield Mark("zone", tuple(low.tolist()))
            for k in range(len(low)):
                n = (k + 1) % len(low)
                yield Mark("zone", (complex(low[k]), complex(low[n]), complex(high[n]), complex(high[k])))
            yield Mark("zone", tuple(high.tolist()))
        yield Mark("bar", (0j, self._at(0.0, 0.0, self._top())))

    def spans(self) -> Iterator[Span]:
        """The links and their shadow."""
        hand, ground, middle = ("hand", 0j), ("ground", 0j), ("middle", 0j)
        shoulder = (FRAME, self._at(0.0, 0.0, self.arm.height))
        yield Span("shadow", ((FRAME, 0j), ground))
        yield Span("line", (ground, hand))
        yield Span("bar", (shoulder, middle, hand) if self.arm.kind == "angular" else (middle, hand))
        if self.arm.kind != "angular":
            yield Span("tube", (("sleeve 0", 0j), ("sleeve 1", 0j)))

    def spots(self) -> Iterator[Spot]:
        """The gripper and its shadow with their paths, pins, letters of the axes, names of obstacles."""
        yield Spot("P", "hand", 0j, "point", path=True)
        yield Spot("", "ground", 0j, "point", path=True)
        if self.arm.kind == "angular":
            yield Spot("O", FRAME, self._at(0.0, 0.0, self.arm.height), "pin")
            yield Spot("E", "middle", 0j, "pin")
        for name, axis in zip("xyz", np.eye(3), strict=True):
            yield Spot(name, FRAME, self._at(*(1.1 * AXES * self.size * axis)), "word")
        for obstacle in self.task.obstacles:
            top = self.seen(_level(obstacle, obstacle.high))
            yield Spot(obstacle.name, FRAME, complex(top.mean()), "word")

    def layers(self) -> Iterator[Layer]:
        """Velocity and acceleration of the gripper as they are seen."""
        still = np.zeros(len(self.result.t))
        seen = [self.seen(each) for each in self.points["hand"]]
        for name, letter, title, unit, order in (
            ("velocity", "v", "Velocities", "m/s", 1),
            ("acceleration", "a", "Accelerations", "m/s^2", 2),
        ):
            x, y = (Track(part, still) for part in (seen[order].real, seen[order].imag))
            yield Layer(name, title, unit, (), (Vector(f"{letter}_P", "hand", x, y),), hidden=order == 2)


def _level(obstacle: Obstacle, height: float) -> Values:
    """The corners (3, m) of a prism at a height."""
    corners = np.array(obstacle.corners)
    return np.stack((corners.real, corners.imag, np.full(len(corners), height)))
