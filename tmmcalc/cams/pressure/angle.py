"""The pressure angle: between the velocity of the follower on its rise and the normal at the contact.

    RT   tan(theta) = (S' + e)/(S0 + dS)                                               (5.42)
    RK   tan(theta) = (l2 (1 - delta psi') - l0 cos psi)/(l0 sin psi)                   (5.48)
    PT   theta = 0

Translating: theta is positive where the normal is turned from the velocity as the cam turns. Oscillating: where the
force on the roller pulls the rocker, from its pivot outwards. Limits hold for |theta|; the transmission angle is
what |theta| leaves of a right angle.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import degrees, pi

import numpy as np

from tmmcalc.cams.follower import Follower
from tmmcalc.cams.laws.law import Indices, Number, Values
from tmmcalc.cams.program import Program
from tmmcalc.cams.task import CamTask
from tmmcalc.core.errors import SingularityError
from tmmcalc.core.notes import Phrase, Said, held
from tmmcalc.core.numerics.panels import Panels, resolved
from tmmcalc.core.numerics.roots import bracketed
from tmmcalc.core.quantity import derived, quantity
from tmmcalc.core.records import record

TOUCH = 1e-9  # [rad] a limit is reached, not exceeded, within it


@record
class Extreme:
    """An extreme value and where the cam stands then [rad]."""

    value: float
    phi: float


@record
class Reached:
    """The pressure angle on the rise or on the return, both ends included [rad]."""

    limit: float | None = quantity(  # None: not limited
        "theta_{phase}_limit[rad]", "limit of the pressure angle on the {phase}", symbol="[theta]"
    )
    least: Extreme  # signed
    largest: Extreme  # signed
    exceeded: tuple[tuple[float, float], ...] = quantity(
        "exceeded_{phase}[rad]", "angles of the cam between which |theta| is beyond its limit", default=()
    )

    @derived("theta_{phase}_min[rad]", "least pressure angle on the {phase}, with its sign")
    def theta_min(self) -> float:
        """Of the least."""
        return self.least.value

    @derived("theta_{phase}_min_at_phi[rad]", "angle of the cam at the least pressure angle on the {phase}")
    def theta_min_phi(self) -> float:
        """Of the least."""
        return self.least.phi

    @derived("theta_{phase}_max[rad]", "largest pressure angle on the {phase}, with its sign")
    def theta_max(self) -> float:
        """Of the largest."""
        return self.largest.value

    @derived("theta_{phase}_max_at_phi[rad]", "angle of the cam at the largest pressure angle on the {phase}")
    def theta_max_phi(self) -> float:
        """Of the largest."""
        return self.largest.phi

    @derived("gamma_{phase}_min[deg]", "least transmission angle on the {phase}")
    def gamma_min(self) -> float:
        """What the worst pressure angle leaves of a right angle."""
        return 90 - degrees(abs(self.worst.value))

    @property
    def worst(self) -> Extreme:
        """The extreme of larger size."""
        return self.largest if self.largest.value >= -self.least.value else self.least

    @property
    def excess(self) -> float:
        """By how much |theta| is beyond the limit, negative if it is within; 0 without a limit."""
        return 0.0 if self.limit is None else abs(self.worst.value) - self.limit


def tangent_terms(follower: Follower, motion: Values, start: Number, offset: Number) -> tuple[Values, Values]:
    """Numerator and denominator of tan(theta) as in the head of the module; a flat face has 0 and 1."""
    y, y1 = motion[0], motion[1]
    if follower.kind == "flat":
        return np.zeros_like(y), np.ones_like(y)
    if follower.kind == "translating":
        return y1 + offset, start + y
    psi = start + y
    lean = follower.rocker * (1 - follower.assembly * y1) - follower.centres * np.cos(psi)
    return lean, follower.centres * np.sin(psi)


def pressure_angle(
    follower: Follower,
    phi: Values,
    motion: Values,
    *,
    start: Values | float | None = None,
    offset: Values | float | None = None,
) -> Values:
    """Pressure angle (n,) [rad] at phi (n,) with the motion (4, n) there (5.42, 5.48).

    ``start`` and ``offset`` take the place of the follower's S0 (or psi0) and e; arrays of them are broadcast
    against the motion. Meaningful where the roller stays off the level of O, which `check_reach` tells.

    >>> pressure_angle(Follower("translating", 0.05), np.zeros(1), np.array([[0.0], [0.05], [0.0], [0.0]]))
    array([0.78539816])
    """
    e = follower.offset if offset is None else offset
    return np.arctan2(*tangent_terms(follower, motion, follower.start if start is None else start, e)) + 0 * phi


def check_reach(program: Program, follower: Follower) -> None:
    """Refuse a follower whose roller or face comes to the level of the cam's axis, or a rocker to the line of centres.

    What counts is the true range of y, which a law of one's own may leave 0 to h for. Raises `SingularityError`: there
    the pressure angle is 90 deg or undefined.
    """
    (y, phi), (y_high, phi_high) = program.span
    low, high = float(follower.start) + y, float(follower.start) + y_high
    if follower.kind != "oscillating":
        if low > 0:
            return
        own = f" with S0 = {1e3 * follower.start:.6g} mm" if y < 0 else ""
        raise SingularityError(
            f"S = {1e3 * low:.6g} mm at phi = {np.degrees(phi):.6g} deg{own}: the follower is at or below the level of "
            "the cam's axis",
            where="cam_pressure",
            value=low,
            limit=0.0,
            remedy="a larger start_distance or base_radius" + (", or a law that does not overshoot" if y < 0 else ""),
        )
    if low > 0 and high < pi:
        return
    raise SingularityError(
        f"psi goes from {np.degrees(low):g} deg at phi = {np.degrees(phi):.6g} deg to {np.degrees(high):g} deg at "
        f"phi = {np.degrees(phi_high):.6g} deg: the rocker comes to the line of centres",
        where="cam_pressure",
        value=low if low <= 0 else high,
        limit=0.0 if low <= 0 else pi,
        remedy="keep psi between 0 and 180 deg: change start_angle, centre_distance, the stroke or the law",
    )


def reached(task: CamTask, follower: Follower, intervals: bool = True) -> tuple[Reached, Reached]:
    """The pressure angle on the rise and on the return; without the ``intervals`` that are beyond a limit, if so asked.

    Raises `SingularityError` for a follower that comes to the cam's axis.
    """
    program = task.program
    check_reach(program, follower)

    def theta(phi: Values) -> Values:
        return pressure_angle(follower, phi, program.at(phi))

    dense, values, _ = resolved(lambda phi: theta(phi)[None], program.panels.halved())
    ends = []
    for kind, limit in (("rise", task.limits.rise), ("return", task.limits.back)):
        part, own = on_phase(program, dense, values, kind)
        (least, least_at), (largest, largest_at) = part.extremes(own[0])
        exceeded = () if limit is None or not intervals else _exceeded(program, follower, part, own[0], limit)
        ends.append(Reached(limit, Extreme(least, least_at), Extreme(largest, largest_at), exceeded))
    return ends[0], ends[1]


def on_phase(program: Program, dense: Panels, values: Values, kind: str) -> tuple[Panels, Values]:
    """The panels of one kind of phase, with their values (..., K', N)."""
    middle = (dense.edges[:-1] + dense.edges[1:]) / 2
    number = np.clip(np.searchsorted(program.starts, middle) - 1, 0, len(program.phases) - 1)
    own = np.flatnonzero(np.array([phase.kind == kind for phase in program.phases])[number])
    return Panels(dense.edges[own[0] : own[-1] + 2], dense.order), values[..., own, :]


def limited_phases(task: CamTask) -> Iterator[tuple[str, float, Panels, Values]]:
    """The phases whose pressure angle is limited: kind, limit [rad], panels, and y and y' on them (2, K, N)."""
    program, limits = task.program, task.limits
    dense = program.panels.halved()
    motion = program.at(dense.x.ravel())[:2].reshape(2, *dense.x.shape)
    for kind, limit in (("rise", limits.rise), ("return", limits.back)):
        if limit is not None:
            yield kind, limit, *on_phase(program, dense, motion, kind)


def _exceeded(
    program: Program, follower: Follower, part: Panels, theta: Values, limit: float
) -> tuple[tuple[float, float], ...]:
    """Intervals of phi where |theta| is beyond the limit, to rounding; between stationary values theta is monotone."""
    at, value = part.turning(theta)
    order = np.argsort(at, kind="stable")
    at, value = at[order], value[order]
    found = []
    for side in (1, -1):
        excess = side * value - limit
        if excess.max() <= TOUCH:
            continue
        beyond = excess > 0

        def over(phi: Values, which: Indices, side: int = side) -> Values:
            return side * pressure_angle(follower, phi, program.at(phi)) - limit

        change = np.flatnonzero(beyond[1:] != beyond[:-1])
        places = bracketed(over, at[change], at[change + 1])
        bounds = np.concatenate((at[:1][beyond[:1]], places, at[-1:][beyond[-1:]])).reshape(-1, 2)
        for low, high in bounds.tolist():
            if excess[(at >= low) & (at <= high)].max(initial=0.0) > TOUCH:
                found.append((low, high))
    return tuple(sorted(found))


def remarks(phase: str, on: Reached) -> list[Said]:
    """A warning where the limit of this phase is exceeded."""
    if not on.exceeded or on.limit is None:
        return []
    where = [
        Phrase("{low:.6g} to {high:.6g} deg", low=np.degrees(low), high=np.degrees(high)) for low, high in on.exceeded
    ]
    text = "on the {phase} |theta| reaches {value:.6g} deg, beyond the limit of {limit:.6g} deg, for phi from {where}"
    numbers = np.degrees(abs(on.worst.value)), np.degrees(on.limit), "deg"
    return [held("warning", text, *numbers, name="theta", phase=phase, where=where)]
