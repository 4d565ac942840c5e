"""The plans of velocities and accelerations as they are drawn on paper: every vector with its segment to scale.

A plan is drawn to a scale mu [(m/s)/mm] or [(m/s^2)/mm], so that a vector v is a segment of v/mu mm. The scale of the
crank is that at which the velocity of the crank's pin and its normal acceleration are segments of one length, as the
crank itself would be on a scheme: mu_v = omega_1 l_1/l, mu_a = omega_1^2 l_1/l (textbook 2.7).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import atan2, degrees, hypot

from tmmcalc.core.errors import UsageError
from tmmcalc.core.quantity import quantity
from tmmcalc.core.records import record
from tmmcalc.linkage.results import Kinematics
from tmmcalc.linkage.vectors import Kind, Polygon, VectorPolygons

NOISE = 1e-12  # of the longest vector of a plan: less has no direction


@record
class PlanScale:
    """Scale factors of both plans."""

    velocity: float = quantity("mu_v[m/s/mm]", "scale of the plan of velocities", symbol=r"\mu_v")
    acceleration: float = quantity("mu_a[m/s^2/mm]", "scale of the plan of accelerations", symbol=r"\mu_a")


@record
class Segment:
    """A vector of a plan, and how it is drawn."""

    position: str = quantity("i", "number of the position")
    plan: str = quantity("plan", "of velocities or of accelerations: v or a")
    tail: str = quantity("from", "vertex where the vector begins")
    head: str = quantity("to", "vertex where the vector ends")
    kind: Kind = quantity(
        "kind", "what the vector is: absolute, relative, normal, tangential, sliding, coriolis, special"
    )
    link: int = quantity("link", "the link that turns or carries the point, or the slider")
    size: float = quantity("size", "size of the vector, in the unit of its row")
    x: float = quantity("x", "its component along x")
    y: float = quantity("y", "its component along y")
    unit: str = quantity("unit", "unit of the vector")
    direction: float | None = quantity("direction[deg]", "its direction from x")  # None: it is nothing
    length: float = quantity("segment[mm]", "length of its segment at the scale of the plan")


def crank_scale(result: Kinematics, length: float) -> PlanScale:
    """The scale of the crank, whose pin has segments of this length [mm]; raises `UsageError` for a driven slider."""
    if result.crank_length is None:
        raise UsageError(
            "the input link is a slider, so there is no scale of the crank",
            where="--scale",
            remedy="leave it out for round scale factors",
        )
    speed = abs(result.speed)
    return PlanScale(speed * result.crank_length / length, speed**2 * result.crank_length / length)


def longest(plans: Sequence[VectorPolygons]) -> tuple[float, float]:
    """Size of the longest vector of all plans of velocities, and of accelerations.

    Special points, which may lie far away, do not count.
    """
    velocity, acceleration = ([getattr(plan, name) for plan in plans] for name in ("velocity", "acceleration"))
    return _longest(velocity), _longest(acceleration)


def _longest(polygons: Sequence[Polygon]) -> float:
    drawn = ((polygon, vector) for polygon in polygons for vector in polygon.vectors if vector.kind != "special")
    return max((abs(polygon.value(vector)) for polygon, vector in drawn), default=0.0)


def segments(plan: VectorPolygons, position: str, scale: PlanScale) -> Iterator[Segment]:
    """The vectors of both plans of a position, those from the pole first."""
    for letter, unit, polygon, mu in (
        ("v", "m/s", plan.velocity, scale.velocity),
        ("a", "m/s^2", plan.acceleration, scale.acceleration),
    ):
        least = NOISE * _longest([polygon])
        for vector in sorted(polygon.vectors, key=lambda vector: vector.kind != "absolute"):
            value = polygon.value(vector)
            x, y = (part if abs(part) > least else 0.0 for part in (value.real, value.imag))
            size = hypot(x, y)
            direction = degrees(atan2(y, x)) if size else None
            ends = (vector.tail, vector.head, vector.kind, vector.link)
            yield Segment(position, letter, *ends, size, x, y, unit, direction, size / mu)
