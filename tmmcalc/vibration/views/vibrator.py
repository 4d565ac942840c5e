"""The vibratory device in its steady motion over a turn of the rotor, seen aslant, with displacements enlarged."""

from __future__ import annotations

from collections.abc import Iterator
from math import cos, sin

import numpy as np

from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.plane import Plane
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.moving import FRAME, Body, Mark, Span, Spot, Track, View, track_of
from tmmcalc.vibration.pictures.vibrator import ASLANT
from tmmcalc.vibration.tables.tasks.vibration import to_vibrator
from tmmcalc.vibration.vibrator.energies import (
    BISECTOR,
    COUNT,
    PHI,
    TO_COSINE,
    TO_SINE,
    UP,
    X,
    Y,
    exciter_jacobian,
    gripper_jacobian,
)
from tmmcalc.vibration.vibrator.forced import Steady
from tmmcalc.vibration.vibrator.results import VibratorResult
from tmmcalc.vibration.vibrator.task import VibratorTask
from tmmcalc.vibration.views.enlarged import factor_of, told

STEPS = 120  # of a turn
RIM = 36  # corners of the ring
ROTOR = 0.45  # of the ring's radius: how long the arm of the unbalance is drawn
HIGH = 1.1  # of the ring's radius: length of rods that have none


def views(order: Order) -> Iterator[View]:
    """The steady motion; none without one."""
    result: VibratorResult = order.results["vibrator"]
    if result.steady is not None:
        yield _Device(to_vibrator(order.spec), result.steady).view()


class _Device:
    """Points of the device with their displacements over the coordinates (3, 7), which turn with the rotor."""

    def __init__(self, task: VibratorTask, steady: Steady) -> None:
        self.task, self.steady = task, steady
        self.points: dict[str, tuple[Values, Values]] = dict(self._points())
        self.size = 2 * task.rods.radius
        largest = max(self._largest(jacobian) for _, jacobian in self.points.values())
        self.factor = factor_of(self.size, largest)

    def _points(self) -> Iterator[tuple[str, tuple[Values, Values]]]:
        """Names, places at rest (3,) and Jacobians: ring, gripper with its part, exciter with its rotor."""
        task, still = self.task, np.zeros((3, COUNT))
        radius = task.rods.radius
        for k in range(RIM):
            at = radius * np.array([cos(2 * np.pi * k / RIM), sin(2 * np.pi * k / RIM), 0.0])
            yield f"ring {k}", (at, _of_ring(at))
        inner = task.flats.offset or radius / 4
        for k in range(4):
            at = inner * np.array([(1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (-1.0, 0.0, 0.0), (0.0, -1.0, 0.0)][k])
            yield f"spring {k}", (at, gripper_jacobian(at[None])[0])
        part = ((f"part {name}", at) for name, at in task.points)
        for name, place in (("O", (0.0, 0.0, 0.0)), ("S", (0.0, 0.0, -task.gripper.drop)), *part):
            at = np.array(place)
            yield name, (at, gripper_jacobian(at[None])[0])
        own = task.exciter
        hinge = (own.radius - own.arm * cos(own.arm_angle)) * BISECTOR
        yield "hinge", (hinge, _of_ring(hinge))
        centre = own.radius * BISECTOR + own.arm * sin(own.arm_angle) * UP
        yield "exciter", (centre, exciter_jacobian(own.radius, own.arm, own.arm_angle))
        for k in range(4):
            at = radius * np.array([(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)][k] + (0.0,))
            yield f"arm {k}", (at + (task.rods.length or HIGH * radius) * UP, still)

    def _largest(self, jacobian: Values) -> float:
        whole = jacobian @ (self.steady.cosine - 1j * self.steady.sine)
        return float(np.sqrt((np.vdot(whole, whole).real + abs(whole @ whole)) / 2))

    def view(self) -> View:
        """The view."""
        psi = np.linspace(0.0, 360.0, STEPS + 1)
        bodies = tuple(self._bodies(np.radians(psi)))
        seen = np.concatenate([body.x.values + 1j * body.y.values for body in bodies])
        low, high = (complex(f(seen.real), f(seen.imag)) for f in (np.min, np.max))
        return View(
            name="vibrator",
            title="Steady vibration",
            symbol="ψ",
            unit="deg",
            values=psi,
            whole=True,
            column="",
            steps=(),
            box=(low, high),
            bodies=bodies,
            frame=(Mark("plate", tuple(complex(ASLANT @ self.points[f"arm {k}"][0]) for k in range(4))),),
            spots=tuple(self._spots()),
            spans=tuple(self._spans()),
            note=told(self.factor),
        )

    def _bodies(self, psi: Values) -> Iterator[Body]:
        """Every point by itself, as it is seen; the unbalance on its circle about the exciter."""
        c, s = np.cos(psi), np.sin(psi)
        for name, (at, jacobian) in self.points.items():
            along, across = (complex(ASLANT @ jacobian @ part) for part in (self.steady.cosine, self.steady.sine))
            place = complex(ASLANT @ at) + self.factor * (along * c + across * s)
            rate = self.factor * (across * c - along * s)
            yield _point(name, place, rate)
            if name == "exciter":
                long = ROTOR * self.task.rods.radius
                one, two = (long * complex(ASLANT @ each) for each in (TO_COSINE, TO_SINE))
                turned = _point("unbalance", place + one * c + two * s, rate + two * c - one * s)
                yield turned._replace(marks=(Mark("circle", (0j,), self.size / 40),))

    def _spans(self) -> Iterator[Span]:
        """Rods to the robot's arm, the ring, the flat springs, the gripper with its part, the exciter."""
        quarter = RIM // 4
        for k in range(4):
            yield Span("line", ((f"arm {k}", 0j), (f"ring {k * quarter}", 0j)))
        yield Span("bar", tuple((f"ring {k % RIM}", 0j) for k in range(RIM + 1)))
        for k in range(4):
            yield Span("spring", ((f"ring {k * quarter}", 0j), (f"spring {k}", 0j)))
            yield Span("bar", ((f"spring {k}", 0j), ("O", 0j)))
        yield Span("bar", (("O", 0j), ("S", 0j)))
        names = [f"part {name}" for name, _ in self.task.points]
        for name in names:
            yield Span("line", (("S", 0j), (name, 0j)))
        if len(names) > 1:
            yield Span("bar", tuple((name, 0j) for name in (*names, names[0])))
        yield Span("bar", (("hinge", 0j), ("exciter", 0j)))
        yield Span("line", (("exciter", 0j), ("unbalance", 0j)))

    def _spots(self) -> Iterator[Spot]:
        """The centre of the gripper, the hinge, points of the part with their paths."""
        yield Spot("S", "S", 0j, "mass", path=True)
        yield Spot("", "hinge", 0j, "pin")
        for name, _ in self.task.points:
            yield Spot(name, f"part {name}", 0j, "point", path=True)
        for k in range(4):
            yield Spot("", FRAME, complex(ASLANT @ self.points[f"arm {k}"][0]), "point")


def _of_ring(at: Values) -> Values:
    """Displacement (3, 7) of a point of the ring, which keeps in its plane."""
    kept = [X, Y, PHI]
    found = np.zeros((3, COUNT))
    found[:, kept] = gripper_jacobian(at[None])[0][:, kept]
    return found


def _point(name: str, place: Plane, rate: Plane) -> Body:
    """A point that moves, with rates by the angle [deg]."""
    per = np.pi / 180
    x, y = Track(place.real, per * rate.real), Track(place.imag, per * rate.imag)
    return Body(name, x, y, track_of(0.0, 0.0, len(place)), ())
