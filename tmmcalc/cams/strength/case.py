"""What the requirements are judged by, over the turn: curvature, squares of stress and moment, slip, each exact.

Squares are taken where a root would not be smooth: sigma_H^2 and M_E^2 go smoothly through R = 0.
"""

from __future__ import annotations

import numpy as np

from tmmcalc.cams.follower import Follower
from tmmcalc.cams.forces.state import state
from tmmcalc.cams.forces.turn import Points, at_angles
from tmmcalc.cams.forces.turnforces import TurnForces
from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.pressure.angle import tangent_terms
from tmmcalc.cams.program import levelled
from tmmcalc.cams.strength.formulas import contact_square, flat_radius, rolling
from tmmcalc.cams.task import CamTask, Loads
from tmmcalc.core.numerics.panels import Panels, resolved
from tmmcalc.core.records import record

TOLERANCE = 1e-11  # of the panels


@record
class TurnExtremes:
    """Least and largest of a quantity over the turn."""

    least: float
    least_phi: float
    largest: float
    largest_phi: float

    @property
    def size(self) -> float:
        """Largest magnitude."""
        return max(-self.least, self.largest)

    @property
    def place(self) -> float:
        """Where it stands."""
        return self.largest_phi if self.largest >= -self.least else self.least_phi


def contact_curvature(follower: Follower, motion: Values) -> Values:
    """kappa [1/m] of the pitch curve; under a flat face 1/rho of the profile, 0 where it has no radius."""
    if follower.kind != "flat":
        return rolling(follower, motion)[0]
    radius = flat_radius(motion, follower.start)
    none = radius == 0
    return np.where(none, 0.0, 1 / np.where(none, 1.0, radius))


def roller_acceleration(task: CamTask, loads: Loads, follower: Follower, at: Points, contact: Values) -> Values:
    """A [m] (m,) of the roller, by which its speed grows; 0 under a flat face.

    On the inner wall it turns at omega (v/r2 - 1), on the outer one at omega (v/r2 + 1), v that of the pitch curve.
    Where omega varies, A is what that asks for over the mean speed squared: (omega^2 A + eps (v -+ r2))/omega_m^2.
    """
    if follower.kind == "flat":
        return np.zeros_like(at.phi)
    _, run = rolling(follower, at.motion)
    if task.turning is None:
        return run
    omega, eps = task.turning.at(at.phi)
    speed = np.hypot(*tangent_terms(follower, at.motion, follower.start, follower.offset))
    found: Values = (omega**2 * run + eps * (speed - np.sign(contact) * follower.roller)) / loads.speed**2
    return found


def extremes_of(on: Panels, values: Values) -> TurnExtremes:
    """Extremes of values (K, N) with both one-sided limits."""
    (least, least_at), (largest, largest_at) = on.extremes(levelled(values))
    return TurnExtremes(least + 0.0, least_at, largest + 0.0, largest_at)


def curvature_extremes(follower: Follower, course: TurnForces) -> TurnExtremes:
    """kappa of the pitch curve over the turn; under a flat face its radius rho."""
    motion = course.points.motion
    values = flat_radius(motion, follower.start) if follower.kind == "flat" else contact_curvature(follower, motion)
    return extremes_of(course.on, course.shaped(values))


@record
class Case:
    """A cam to judge: what is asked, and its forces and curvature over the turn."""

    task: CamTask
    loads: Loads
    follower: Follower
    course: TurnForces
    bend: TurnExtremes  # kappa [1/m] of the pitch curve; of a flat face rho [m]
    run: Values  # (K N,) A [m] of the roller
    pressing: TurnExtremes  # R [N]
    touches: bool  # a force presses the follower on the cam all over the turn, or walls hold it

    @property
    def flat(self) -> bool:
        """No roller, but a face."""
        return self.follower.kind == "flat"

    @property
    def cusped(self) -> bool:
        """The roller is too large for the profile, or the profile under a face is not convex."""
        if self.flat:
            return self.bend.least <= 0
        inner = self.bend.largest * self.follower.roller >= 1
        return inner or (self.grooved and -self.bend.least * self.follower.roller >= 1)

    @property
    def grooved(self) -> bool:
        """Closed by two walls."""
        return self.task.asked.closure == "groove"

    @property
    def passes_zero(self) -> bool:
        """Nothing presses the roller somewhere in the turn."""
        return self.pressing.least <= 0 <= self.pressing.largest or not np.all(self.course.state.contact)

    @property
    def stress_square(self) -> Values:
        """(K N,) what sigma_H^2 grows with over the turn: R (1/(rho - r2) + 1/r2), under a face R/rho (5.90)."""
        contact = self.course.state.contact
        kappa = contact_curvature(self.follower, self.course.points.motion)
        return np.abs(contact) * kappa if self.flat else contact_square(contact, kappa, self.follower.roller)[0]

    def over(self, values: Values) -> TurnExtremes:
        """Extremes of values (K N,) over the turn."""
        return extremes_of(self.course.on, self.course.shaped(values))


def case_of(task: CamTask, follower: Follower, loads: Loads, first: TurnForces) -> Case:
    """Forces and curvature over the turn on panels that resolve the stress of the contact as well."""
    course = _refined(task, loads, first)
    now = course.state
    pressing = extremes_of(course.on, course.shaped(now.contact))
    touches = task.asked.closure == "groove" or pressing.least > 0
    run = roller_acceleration(task, loads, follower, course.points, now.contact)
    return Case(task, loads, follower, course, curvature_extremes(follower, course), run, pressing, touches)


def _refined(task: CamTask, loads: Loads, course: TurnForces) -> TurnForces:
    of, roller = course.carried, course.carried.follower.roller
    flat = of.follower.kind == "flat" and curvature_extremes(of.follower, course).least > 0

    def rows(phi: Values) -> Values:
        at = at_angles(task, loads, phi)
        now = state(of, at)
        kappa = contact_curvature(of.follower, at.motion)
        gap = 1 / kappa if flat else 1 - np.sign(now.contact) * kappa * roller
        run = roller_acceleration(task, loads, of.follower, at, now.contact)
        return np.stack((now.contact / np.where(gap > 0, gap, 1.0), run))

    scale = np.max(np.abs(rows(course.on.x.ravel())), axis=1) + 1e-300
    on, _, _ = resolved(rows, course.on, TOLERANCE, scale)
    if on.count == course.on.count:
        return course
    points = at_angles(task, loads, on.x.ravel())
    return TurnForces(of, on, points, state(of, points))
