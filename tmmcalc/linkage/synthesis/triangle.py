"""The slider-crank without its scale: the plane of lambda = r/l and kappa = e/l, in which every demand is a curve.

It turns fully where |kappa| < 1 - lambda. Most demands are straight lines there; the time ratio is a curve that is
known explicitly, for the triangle of the crank's pivot and the two ends of the stroke has the sides 1 + lambda and
1 - lambda, with psi between them; what involves the stroke is neither, and is sought along the other.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from tmmcalc.core.errors import UsageError
from tmmcalc.core.numerics.roots import bracketed
from tmmcalc.core.plane import Real
from tmmcalc.core.records import record

Residual = Callable[[Real, Real], Real]
SAMPLES = 4000  # of a curve, between which roots are sought
PARALLEL = 1e-14  # two lines whose determinant is smaller have no crossing
SAME = 1e-13  # a demand that holds so well all along another one says the same
EDGE = 1e-12  # a crossing this near to the border of the triangle does not turn


@record
class StraightLine:
    """a lambda + b kappa = c."""

    a: float
    b: float
    c: float

    def residual(self, lam: Real, kappa: Real) -> Real:
        """Zero on the line."""
        return self.a * lam + self.b * kappa - self.c


@record
class Overlap:
    """The time ratio, by its overlap angle psi [rad]."""

    psi: float

    def residual(self, lam: Real, kappa: Real) -> Real:
        """Zero where the strokes overlap by psi."""
        return overlap_of(lam, kappa) - self.psi

    def curve(self, count: int) -> Real:
        """Values of lambda (count,) along the curve: the near end of the stroke is short of the foot of the pivot."""
        least = np.tan(abs(self.psi) / 2) ** 2
        u = (1 - np.cos(np.linspace(0, np.pi, count + 2)[1:-1])) / 2
        return np.asarray(least + (1 - least) * u)

    def kappa(self, lam: Real) -> Real:
        """The offset of the guide: the height of the triangle over the stroke."""
        base = 2 * np.hypot(np.sin(self.psi / 2), lam * np.cos(self.psi / 2))
        return (1 - lam) * (1 + lam) * np.sin(self.psi) / base


@record
class Scaled:
    """A demand on the stroke: left(lambda, kappa) = factor times the stroke in rods."""

    left: Callable[[Real, Real], Real]
    factor: float

    def residual(self, lam: Real, kappa: Real) -> Real:
        """Zero where it holds."""
        return self.left(lam, kappa) - self.factor * stroke_of(lam, kappa)


Demand = StraightLine | Overlap | Scaled


def stroke_of(lam: Real | float, kappa: Real | float) -> Real:
    """Stroke over the length of the rod, without cancellation."""
    far = np.sqrt(np.maximum((1 + lam - kappa) * (1 + lam + kappa), 0))
    near = np.sqrt(np.maximum((1 - lam - kappa) * (1 - lam + kappa), 0))
    return np.asarray(4 * lam / (far + near))


def overlap_of(lam: Real | float, kappa: Real | float) -> Real:
    """Overlap angle psi [rad]: the crank's angle over the half turn on the working stroke."""
    return np.asarray(np.arcsin(np.clip(kappa / (1 - lam), -1, 1)) - np.arcsin(kappa / (1 + lam)))


def crossings(first: Demand, second: Demand) -> list[tuple[float, float]]:
    """All (lambda, kappa) inside the triangle where both demands hold; raises `UsageError` where they are one."""
    lines = [demand for demand in (first, second) if isinstance(demand, StraightLine)]
    if len(lines) == 2:
        return _crossing(*lines)
    if lines:
        other = second if lines[0] is first else first
        return _on_line(lines[0], other)
    overlaps = [demand for demand in (first, second) if isinstance(demand, Overlap)]
    if not overlaps:
        raise _one()
    other = second if overlaps[0] is first else first
    curve = overlaps[0]
    return _roots(curve.curve(SAMPLES), lambda t: (t, curve.kappa(t)), other)


def _crossing(one: StraightLine, two: StraightLine) -> list[tuple[float, float]]:
    determinant = one.a * two.b - one.b * two.a
    if abs(determinant) < PARALLEL:
        if abs(one.a * two.c - one.c * two.a) + abs(one.b * two.c - one.c * two.b) < PARALLEL:
            raise _one()
        return []
    lam = (one.c * two.b - one.b * two.c) / determinant
    kappa = (one.a * two.c - one.c * two.a) / determinant
    return [(lam, kappa)] if lam > 0 and abs(kappa) < 1 - lam - EDGE else []


def _on_line(line: StraightLine, other: Demand) -> list[tuple[float, float]]:
    """Roots along the part of a line inside the triangle."""
    norm = line.a**2 + line.b**2
    foot, along = np.array([line.a, line.b]) * line.c / norm, np.array([-line.b, line.a])
    low, high = -np.inf, np.inf
    for normal, limit in (((-1, 0), 0.0), ((1, 1), 1.0), ((1, -1), 1.0)):  # the three sides: normal . point < limit
        slope, room = float(np.dot(normal, along)), limit - float(np.dot(normal, foot))
        if slope > 0:
            high = min(high, room / slope)
        elif slope < 0:
            low = max(low, room / slope)
        elif room <= 0:
            return []
    if not low < high:
        return []
    u = (1 - np.cos(np.linspace(0, np.pi, SAMPLES + 2)[1:-1])) / 2

    def place(t: Real) -> tuple[Real, Real]:
        return foot[0] + t * along[0], foot[1] + t * along[1]

    return _roots(low + (high - low) * u, place, other)


def _roots(t: Real, place: Callable[[Real], tuple[Real, Real]], demand: Demand) -> list[tuple[float, float]]:
    values = demand.residual(*place(t))
    if np.max(np.abs(values)) < SAME:
        raise _one()
    change = np.flatnonzero(np.signbit(values[1:]) != np.signbit(values[:-1]))
    roots = bracketed(lambda at, which: demand.residual(*place(at)), t[change], t[change + 1])
    lam, kappa = place(roots)
    return [(float(a), float(b)) for a, b in zip(lam, kappa, strict=True)]


def _one() -> UsageError:
    return UsageError(
        "two of the sizes given say the same: the slider-crank is not settled by them",
        where="synthesis.slider_crank",
        remedy="replace one of them; K = 1, e = 0 and S = 2 r are one demand, for example",
    )
