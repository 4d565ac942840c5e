"""A dyad with given states of its outer joints, told whole: links, sliding coordinates, points, both assemblies.

The motion is that of `tmmcalc.linkage.dyad.solve_dyad` at one position, with the derivatives by the time.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import numpy as np

from tmmcalc.core.errors import AccuracyError
from tmmcalc.core.notes import Note, Phrase, held
from tmmcalc.core.numerics.extended import CHAIN, EPS, WIDER, widened
from tmmcalc.core.plane import Guide, Point
from tmmcalc.core.quantity import derived, keyed, quantity
from tmmcalc.core.records import record
from tmmcalc.linkage.dyad import DyadMotion, solve_dyad
from tmmcalc.linkage.dyads import ONE_ASSEMBLY, PRP, RPP, RPR, RRP, RRR, Dyad
from tmmcalc.linkage.quality import MODEST, NEARLY_SINGULAR, POOR
from tmmcalc.linkage.results import ErrorEstimate

JOINTS = ("first", "inner", "second")  # in the order of the letters of a kind
MARGIN = 4.0  # of the measured differences: the estimate is of one position


@record
class Port:
    """The state of an outer joint; of a pin ``angle``, ``omega`` and ``eps`` say nothing."""

    point: tuple[float, ...]  # x, y [m]
    velocity: tuple[float, ...] = (0.0, 0.0)  # [m/s]
    acceleration: tuple[float, ...] = (0.0, 0.0)  # [m/s^2]
    angle: float = 0.0  # of the guide [rad]
    omega: float = 0.0  # [rad/s]
    eps: float = 0.0  # [rad/s^2]


@record
class LinkPoint:
    """A point of a link in the axes of the link."""

    name: str
    link: str  # "a" or "b"
    x: float  # [m]
    y: float  # [m]


@record
class DyadTask:
    """A dyad by its kind and the metric of this kind, its outer joints, the points that are asked for."""

    kind: str
    first: Port  # outer joint of a
    second: Port  # outer joint of b
    length_a: float | None = None  # [m], of RRR and RRP
    length_b: float | None = None  # [m], of RRR
    offset_a: float = 0.0  # [m], of RPR, PRP, RPP
    offset_b: float = 0.0  # [m], of RRP, PRP, RPP
    turn: float = math.pi / 2  # [rad], of RPP
    variant: int = 1
    points: tuple[LinkPoint, ...] = ()


@record
class LinkState:
    """How a link stands and turns."""

    link: str
    angle: float = quantity("angle_{link}[rad]", "angle of link {link}, of the x axis of its own axes")
    omega: float = quantity("omega_{link}[rad/s]", "angular velocity of link {link}")
    eps: float = quantity("eps_{link}[rad/s^2]", "angular acceleration of link {link}")


@record
class SlideState:
    """The coordinate of a prismatic joint and its derivatives."""

    joint: str
    s: float = quantity("s_{joint}[m]", "coordinate of the prismatic joint {joint}")
    v: float = quantity("v_{joint}[m/s]", "velocity in the prismatic joint {joint}")
    a: float = quantity("a_{joint}[m/s^2]", "acceleration in the prismatic joint {joint}")


@record
class PointState:
    """The motion of a point."""

    point: str
    x: float = quantity("x_{point}[m]", "x of point {point}")
    y: float = quantity("y_{point}[m]", "y of point {point}")
    vx: float = quantity("vx_{point}[m/s]", "velocity of point {point} along x")
    vy: float = quantity("vy_{point}[m/s]", "velocity of point {point} along y")
    ax: float = quantity("ax_{point}[m/s^2]", "acceleration of point {point} along x")
    ay: float = quantity("ay_{point}[m/s^2]", "acceleration of point {point} along y")


@record
class DyadAssembly:
    """One of the two ways in which the links meet."""

    variant: int = quantity("variant", "variant of the assembly")
    taken: bool = quantity("taken", "whether it is the one whose motion is told")
    angle_a: float = quantity("angle_a[rad]", "angle of link a")
    angle_b: float = quantity("angle_b[rad]", "angle of link b")
    x: float | None = quantity("x_inner[m]", "x of the inner pin")  # None: the inner joint is prismatic
    y: float | None = quantity("y_inner[m]", "y of the inner pin")


@record
class DyadState:
    """The motion of a dyad at one position."""

    kind: str = quantity("kind", "kind of the dyad")
    variant: int | None = quantity("variant", "variant of the assembly; none where there is one alone")
    links: tuple[LinkState, ...]
    slides: tuple[SlideState, ...]  # in the order of the letters
    points: tuple[PointState, ...]  # the inner pin, if there is one, as "inner"; then those that are asked for
    transmission: float = quantity("transmission[rad]", "transmission angle")
    assemblies: tuple[DyadAssembly, ...]  # none where there is one alone
    error: ErrorEstimate

    @derived("pressure[rad]", "pressure angle, the complement of the transmission angle")
    def pressure(self) -> float:
        """Pressure angle [rad]."""
        return math.pi / 2 - self.transmission

    @derived("regularity", "sine of the transmission angle, by which velocities are divided; 0 at a dead point")
    def regularity(self) -> float:
        """Distance from a dead point, 1 the best [-]."""
        return math.sin(self.transmission)

    @property
    def notes(self) -> tuple[Note, ...]:
        """What is to be said of a weak transmission."""
        found = []
        if self.regularity < NEARLY_SINGULAR:
            text = Phrase(
                "nearly singular: errors and velocities are amplified {regularity:.4g} times",
                regularity=1 / self.regularity,
            )
            place = Phrase("dyad {kind}", kind=self.kind)
            amplified, most = 1 / self.regularity, 1 / NEARLY_SINGULAR
            found.append(Note("warning", text, place, amplified, most, name="amplification"))
        if self.transmission < MODEST:
            severity, limit = ("warning", 20) if self.transmission < POOR else ("note", 30)
            weak = "transmission angle {value:.4g} deg, below {limit:g} deg"
            numbers, place = (math.degrees(self.transmission), limit, "deg"), Phrase("dyad {kind}", kind=self.kind)
            found.append(held(severity, weak, *numbers, name="transmission", place=place))
        return tuple(found)


def motion_of(task: DyadTask) -> DyadMotion:
    """The motion of the links in the numbers of the task; raises what `solve_dyad` does."""
    with np.errstate(all="ignore"):  # what overflows is refused
        return solve_dyad(dyad_of(task), *ports_of(task))


def dyad_of(task: DyadTask) -> Dyad:
    """The kind with its metric; numbers of numpy, which overflow without an exception."""
    given = (task.length_a, task.length_b, task.offset_a, task.offset_b, task.turn)
    numbers: list[Any] = [np.asarray(value or 0.0)[()] for value in given]
    l_a, l_b, h_a, h_b, turn = numbers
    kinds: dict[str, Dyad] = {
        "RRR": RRR(l_a, l_b, task.variant),
        "RRP": RRP(l_a, h_b, task.variant),
        "RPR": RPR(h_a, task.variant),
        "PRP": PRP(h_a, h_b),
        "RPP": RPP(np.cos(turn) + 1j * np.sin(turn), h_b, h_a),
    }
    return kinds[task.kind]


def ports_of(task: DyadTask) -> Iterator[Point | Guide]:
    """The states of both outer joints."""
    for port, letter in ((task.first, task.kind[0]), (task.second, task.kind[2])):
        point = Point(*(np.asarray(x + 1j * y) for x, y in (port.point, port.velocity, port.acceleration)))
        yield point if letter == "R" else Guide.along(point, port.angle, port.omega, port.eps)


def solve_dyad_task(task: DyadTask) -> DyadState:
    """Links, sliding coordinates, points and quality of a dyad (textbook 2.5, 2.8) with an estimate of the errors.

    Raises `AssemblyError` where the links do not reach, `SingularityError` at a dead point, `AccuracyError` where the
    numbers leave the range of double precision.
    """
    found = motion_of(task)
    points = tuple(_point(name, at) for name, at in _points(task, found))
    slides = zip(_prismatic(task.kind), found.slides, strict=True)
    state = DyadState(
        kind=task.kind,
        variant=None if task.kind in ONE_ASSEMBLY else task.variant,
        links=tuple(
            LinkState(name, float(np.angle(motion.u)), float(motion.omega), float(motion.eps))
            for name, motion in (("a", found.a), ("b", found.b))
        ),
        slides=tuple(SlideState(joint, *map(float, slide)) for joint, slide in slides),
        points=points,
        transmission=_transmission(task, found),
        assemblies=() if task.kind in ONE_ASSEMBLY else tuple(_assemblies(task)),
        error=_estimate(task, found),
    )
    _check_finite(state)
    return state


def _prismatic(kind: str) -> list[str]:
    return [joint for joint, letter in zip(JOINTS, kind, strict=True) if letter == "P"]


def _points(task: DyadTask, found: DyadMotion) -> Iterator[tuple[str, Point]]:
    if found.inner is not None:
        yield "inner", found.inner
    for each in task.points:
        yield each.name, (found.a if each.link == "a" else found.b).point(each.x + 1j * each.y)


def _point(name: str, at: Point) -> PointState:
    return PointState(name, *(float(part) for vector in at for part in (vector.real, vector.imag)))


def _transmission(task: DyadTask, found: DyadMotion) -> float:
    """The transmission angle [rad]: between the lines of the links; RRP and RPR as `tmmcalc.linkage.quality` has it."""
    across = complex(*task.first.point) - complex(*task.second.point) if task.kind == "RPR" else complex(found.b.u)
    turned = across * complex(found.a.u).conjugate()
    between = math.atan2(abs(turned.imag), abs(turned.real))
    return math.pi / 2 - between if task.kind in ("RRP", "RPR") else between


def _assemblies(task: DyadTask) -> Iterator[DyadAssembly]:
    for variant in (1, -1):
        found = motion_of(replace(task, variant=variant))
        at = None if found.inner is None else complex(found.inner.r)
        yield DyadAssembly(
            variant,
            variant == task.variant,
            float(np.angle(found.a.u)),
            float(np.angle(found.b.u)),
            None if at is None else at.real,
            None if at is None else at.imag,
        )


def _estimate(task: DyadTask, found: DyadMotion) -> ErrorEstimate:
    """Differences from extended precision, each against what its kind of quantity is made from.

    That is the reach of the dyad, and what the outer joints and the links give points of this reach.
    """
    if not WIDER:
        k = 1 / math.sin(_transmission(task, found))
        return ErrorEstimate(CHAIN * k, CHAIN * k**2, CHAIN * k**3, "amplification of the rounding unit")
    sizes = _sizes(task, found)
    exact = _told(task, motion_of(widened(task)), sizes[0])
    position, velocity, acceleration = (
        max(MARGIN * float(np.max(np.abs(np.array(one) - np.array(other)))) / size, EPS) if size else EPS
        for one, other, size in zip(_told(task, found, sizes[0]), exact, sizes, strict=True)
    )
    return ErrorEstimate(position, velocity, acceleration, "extended precision (64-bit mantissa)")


def _told(task: DyadTask, found: DyadMotion, reach: float) -> tuple[list[Any], list[Any], list[Any]]:
    """All positions, velocities, accelerations; those of turning at the reach."""
    turning = [(motion.u, motion.omega, motion.eps) for motion in (found.a, found.b)]
    turned = [tuple(reach * part for part in each) for each in turning]
    points = [at for _, at in _points(task, found)]
    rows = [*turned, *found.slides, *points]
    return [row[0] for row in rows], [row[1] for row in rows], [row[2] for row in rows]


def _sizes(task: DyadTask, found: DyadMotion) -> tuple[float, float, float]:
    """The largest magnitudes of positions, velocities, accelerations, of the outer joints too."""
    ports = [task.first, task.second]
    lengths = [task.length_a or 0.0, task.length_b or 0.0, abs(task.offset_a), abs(task.offset_b)]
    lengths += [math.hypot(*port.point) for port in ports] + [math.hypot(each.x, each.y) for each in task.points]
    lengths += [abs(float(slide.s)) for slide in found.slides]
    reach = max(lengths)
    _, speeds, accelerations = _told(task, found, reach)
    speed = max(
        *(float(abs(each)) for each in speeds),
        *(math.hypot(*port.velocity) + abs(port.omega) * reach for port in ports),
    )
    acceleration = max(
        *(float(abs(each)) for each in accelerations),
        *(math.hypot(*port.acceleration) + (abs(port.eps) + port.omega**2) * reach for port in ports),
    )
    return reach, speed, acceleration


def _check_finite(state: DyadState) -> None:
    numbers = [value for row in (*state.links, *state.slides, *state.points) for value in keyed(row).values()]
    if not all(map(math.isfinite, (*numbers, state.error.position, state.error.velocity, state.error.acceleration))):
        raise AccuracyError(
            "the numbers leave the range of double precision",
            where=f"dyad {state.kind}",
            remedy="write lengths, velocities and accelerations of ordinary size",
        )
