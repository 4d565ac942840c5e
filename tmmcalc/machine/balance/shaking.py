"""Shaking force and moment: what the inertia of all links does to the foundation over a turn of the crank.

    R = -sum m a_S,        M = -sum [J eps + (S - P) x m a_S]        textbook (3.71)

with a_S = S'' omega^2 + S' eps_1 and eps = theta'' omega^2 + theta' eps_1 from the transfer functions. The angle phi
of the crank runs from the fixed x axis to the crank O->A, counter-clockwise positive whichever way the crank turns;
in the crank frame (x axis along O->A) the force is R exp(-i phi). Both are Fourier series in phi,
R = sum of c_k exp(i k phi), whose resolution does not depend on the positions asked for: c_1 is the mean of the
hodograph in the crank frame, c_-1 the part that turns at the same rate against the crank.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from tmmcalc.core.errors import NoSolutionError, SingularityError, UsageError
from tmmcalc.core.numerics.extended import EPS
from tmmcalc.core.numerics.fourier import FEWEST, TURN, Complex, Magnitude, Series, magnitude, resolved
from tmmcalc.core.plane import Plane, Real, cross
from tmmcalc.core.quantity import derived, quantity
from tmmcalc.core.records import record
from tmmcalc.linkage.loading import Body
from tmmcalc.linkage.model import FRAME

if TYPE_CHECKING:
    from tmmcalc.linkage.chain import Chain

WHERE = "balance"
CHECKED = 12  # angles spread over the turn where the series is compared with extended precision
BESIDE = np.array([-1.5, -1.0, -0.5, 0.0, 0.5, 1.0, 1.5])  # further such angles about the peaks, in their widths
MARGIN = 8.0  # factor for the angles left out


@record
class Shaking:
    """Shaking force and moment of n positions, and over the whole turn as series in phi."""

    x: Real  # input coordinate [rad], (n,)
    phi: Real  # angle of the crank O->A from the fixed x axis [rad], (n,)
    force: Plane  # R in fixed axes [N], (n,)
    turned: Plane  # R in the crank frame [N], (n,)
    moment: Real  # M about ``about`` [N*m], (n,)
    series: Series  # c_k of R [N]
    moment_series: Series  # of M [N*m]
    size: Magnitude  # of R [N]
    moment_size: Magnitude  # of M [N*m]
    scale: float  # largest sum of the moduli of all inertia forces [N]: rounding in R is proportional to it
    pivot: complex  # O in the frame [m]
    about: complex  # point of the frame that the moment is taken about [m]
    speed: float = quantity("speed[rad/s]", "angular velocity of the crank")
    acceleration: float  # of the crank [rad/s^2]
    error: float  # estimated error of R and M over the turn, relative to ``scale`` and its like [-]
    mean_error: float  # the same of R, its root mean square

    @derived("about_x[m]", "x of the point that the moment is taken about")
    def about_x(self) -> float:
        """In the frame."""
        return self.about.real

    @derived("about_y[m]", "y of the point that the moment is taken about")
    def about_y(self) -> float:
        """In the frame."""
        return self.about.imag

    @derived("X0[N]", "mean shaking force along the crank", source="(3.74)")
    def mean_along(self) -> float:
        """Of the hodograph in the crank frame."""
        return self.series.coefficient(1).real

    @derived("Y0[N]", "mean shaking force across the crank", source="(3.74)")
    def mean_across(self) -> float:
        """Of the hodograph in the crank frame."""
        return self.series.coefficient(1).imag


def inertia_loads(
    chain: Chain, bodies: Sequence[Body], x: Real, speed: float, acceleration: float = 0.0, about: complex = 0j
) -> tuple[Plane, Real]:
    """Principal vector [N] and moment about ``about`` [N*m] of all inertia forces, (n,) each, at ``x`` (n,).

    The input may be a crank or a driven slider. Textbook (3.71).
    """
    forces, moments, _ = _terms(chain, bodies, x, speed, acceleration, about)
    return forces.sum(axis=0), moments.sum(axis=0)


def _checked_loads(
    chain: Chain, bodies: Sequence[Body], x: Real, speed: float, acceleration: float, about: complex
) -> tuple[Plane, Real]:
    """The same where the crank can be turned, an error where it cannot."""
    force, moment = inertia_loads(chain, bodies, x, speed, acceleration, about)
    check_sound(chain, force, moment)
    return force, moment


def _terms(
    chain: Chain, bodies: Sequence[Body], x: Real, speed: float, acceleration: float, about: complex
) -> tuple[Plane, Real, Real]:
    """Inertia forces, their moments, and the size of these before cancellation, each (bodies, n)."""
    from tmmcalc.linkage.loads.sources import inertia_load  # a stored result is loaded without it

    motions = chain.evaluate(x).motions
    forces = np.zeros((len(bodies), *x.shape), np.result_type(x.dtype, np.complex64))
    moments, sizes = np.zeros(forces.shape, x.dtype), np.zeros(forces.shape, x.dtype)
    for i, body in enumerate(bodies):
        forces[i], couple, S = inertia_load(body, motions[body.link], speed, acceleration)
        arm = S.r - about
        moments[i] = couple + cross(arm, forces[i])
        sizes[i] = np.abs(couple) + np.abs(arm) * np.abs(forces[i])
    return forces, moments, sizes


def shaking(
    chain: Chain,
    bodies: Sequence[Body],
    x: Real,
    speed: float,
    acceleration: float = 0.0,
    *,
    about: complex | None = None,
) -> Shaking:
    """Shaking force and moment at the crank coordinates ``x`` (n,) [rad] and over the whole turn.

    ``speed`` [rad/s] of either sign and ``acceleration`` [rad/s^2] of the crank are the same at all positions; the
    moment is taken about the point ``about`` of the frame [m], by default the crank's pivot. Raises `NoSolutionError`
    for a driven slider, `AssemblyError` or `SingularityError` if the crank cannot turn fully, `AccuracyError` if the
    harmonics do not die out, `UsageError` for a body of a link that is not there.
    """
    check_balanceable(chain, bodies, speed, acceleration)
    pivot = frame_pivot(chain)
    point = pivot if about is None else about
    lag = crank_angle(chain)

    def loads(phi: Real) -> Complex:
        return np.array(_checked_loads(chain, bodies, phi - lag, speed, acceleration, point))

    scale = _scale(chain, bodies, speed, acceleration, point)
    (series, moments), tail = resolved(loads, scale, where=WHERE)
    force, moment = _checked_loads(chain, bodies, x, speed, acceleration, point)
    phi = x + lag
    size, moment_size = magnitude(series), magnitude(moments)
    peaks = size.at, moment_size.at
    off = _difference(chain, bodies, (series, moments), peaks, (speed, acceleration), point)
    error, mean_error = _relative(off, scale, tail)
    return Shaking(
        x=x,
        phi=phi,
        force=force,
        turned=force * np.exp(-1j * phi),
        moment=moment,
        series=series,
        moment_series=moments,
        size=size,
        moment_size=moment_size,
        scale=float(scale[0]),
        pivot=pivot,
        about=point,
        speed=speed,
        acceleration=acceleration,
        error=error,
        mean_error=mean_error,
    )


def _relative(off: tuple[Real, float], scale: Real, tail: float) -> tuple[float, float]:
    """Errors of everything and of means, from differences against extended precision and the tail of the series."""
    missed, spread = off
    unit = np.where(scale > 0, scale, 1.0)
    return max(MARGIN * float(np.max(missed / unit)), tail, EPS), max(spread / float(unit[0]), EPS)


def _scale(chain: Chain, bodies: Sequence[Body], speed: float, acceleration: float, about: complex) -> Real:
    """Largest sums of moduli of forces [N] and of moments [N*m], (2,)."""
    x = np.arange(FEWEST) * (TURN / FEWEST)
    forces, moments, sizes = _terms(chain, bodies, x, speed, acceleration, about)
    check_sound(chain, forces, moments)
    return np.array([np.max(np.abs(forces).sum(axis=0)), np.max(sizes.sum(axis=0))])


def _difference(
    chain: Chain,
    bodies: Sequence[Body],
    found: tuple[Series, Series],
    peaks: tuple[float, float],
    motion: tuple[float, float],
    about: complex,
) -> tuple[Real, float]:
    """Largest differences of the series of R and M from extended precision, (2,): off every grid, and at the peaks.

    Besides the root mean square of that of R off the grids.
    """
    spread = np.mod(np.arange(1, CHECKED + 1) * (TURN * (5**0.5 - 1) / 2), TURN)
    phi = np.concatenate((spread, *(peak + BESIDE * _width(s) for peak, s in zip(peaks, found, strict=True))))
    wide = phi.astype(np.longdouble) - np.longdouble(crank_angle(chain))
    exact = inertia_loads(chain, bodies, wide, *motion, about)
    off = [np.abs(s.at(phi) - e).astype(float) for s, e in zip(found, exact, strict=True)]
    return np.max(off, axis=1), float(np.sqrt(np.mean(off[0][:CHECKED] ** 2)))


def _width(series: Series) -> float:
    """Angle [rad] over which the function changes by about itself."""
    rate = series.slope().rms
    return series.rms / rate if rate else 1.0


def frame_pivot(chain: Chain) -> complex:
    """The crank's pivot O in the frame [m]."""
    joint = chain.input_joint
    return joint.points[joint.links.index(FRAME)]


def crank_pivot(chain: Chain) -> complex:
    """The crank's pivot O in the crank's own axes [m]."""
    joint = chain.input_joint
    return joint.points[joint.links.index(chain.structure.input_link)]


def crank_angle(chain: Chain) -> float:
    """Angle [rad] of O->A in the crank's own axes: A is its first joint off the pivot; without one, of its x axis."""
    k, pivot = chain.structure.input_link, crank_pivot(chain)
    pins = (joint.points[joint.links.index(k)] for joint in chain.mechanism.joints if k in joint.links)
    return float(np.angle(next((pin - pivot for pin in pins if pin != pivot), 1)))


def check_sound(chain: Chain, *values: Plane | Real) -> None:
    """Raise the reason why the crank cannot turn fully if one of the values is not a number."""
    if all(np.isfinite(v).all() for v in values):
        return
    from tmmcalc.linkage.assembly import check_range, find_domain

    check_range(chain, find_domain(chain, -TURN / 2, TURN / 2), -TURN / 2, TURN / 2)
    raise SingularityError(
        "the turn passes through a dead point, where accelerations are not defined",
        where=WHERE,
        remedy="change a length: shaking forces need a crank that turns fully",
    )


def check_balanceable(chain: Chain, bodies: Sequence[Body], speed: float, acceleration: float) -> None:
    """Raise unless the input is a crank that moves and every body belongs to a link."""
    if not chain.turns:
        raise NoSolutionError(
            "the input is a driven slider, which has no cycle of a full turn",
            where=WHERE,
            remedy="balancing over the cycle needs a crank; the loads at single positions need none",
        )
    if speed == 0 and acceleration == 0:
        raise UsageError("the crank stands still", where=WHERE, value=0.0, remedy="give the speed of the crank")
    known = {FRAME, *(link.id for link in chain.mechanism.links)}
    for body in bodies:
        if body.link not in known:
            raise UsageError(f"there is no link {body.link}", where=WHERE, remedy=f"links: {sorted(known - {FRAME})}")
