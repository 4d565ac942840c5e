"""The forces over the turn on panels within which they are smooth; a follower that jams is refused with its place."""

from __future__ import annotations

from math import atan, degrees, pi

import numpy as np

from tmmcalc.cams.follower import Follower
from tmmcalc.cams.forces.results import ForceExtreme, Reserve, SpringFound
from tmmcalc.cams.forces.state import Carried, State, carried, state
from tmmcalc.cams.forces.turn import Points, at_angles, crossings, divided, smooth_panels, spans
from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.pressure.angle import check_reach, tangent_terms
from tmmcalc.cams.program import levelled
from tmmcalc.cams.task import CamTask, Loads
from tmmcalc.core.errors import SingularityError
from tmmcalc.core.numerics.panels import Panels, resolved
from tmmcalc.core.records import record

TOLERANCE = 1e-12  # of the panels
NOTHING = 1e-12  # of the largest: a force that is none
CLEAR = 0.3  # of cos(theta) - mu at all points: it is then nowhere at zero between them


@record
class TurnForces:
    """The forces over the turn on panels within which they are smooth, so that extremes and integrals are exact."""

    carried: Carried
    on: Panels
    points: Points  # (K N,)
    state: State  # (K N,) each

    def shaped(self, values: Values) -> Values:
        """Values (K N,) as (K, N)."""
        return values.reshape(self.on.count, self.on.order)

    def extreme(self, name: str, unit: str, values: Values) -> ForceExtreme:
        """Extremes of values (K N,) over the turn."""
        (least, least_at), (largest, largest_at) = self.on.extremes(levelled(self.shaped(values)))
        return ForceExtreme(name, unit, least + 0.0, least_at, largest + 0.0, largest_at)


def turn_forces(task: CamTask, follower: Follower, loads: Loads, spring: SpringFound) -> TurnForces:
    """The forces over the turn; raises as `solve_forces` does."""
    check_reach(task.program, follower)
    of = carried(task, follower, loads, spring.stiffness, spring.preload)
    first = smooth_panels(task, loads)
    at = at_angles(task, loads, first.x.ravel())
    now = state(of, at)
    size = np.max(np.abs(now.load))
    still = np.abs(now.load) <= NOTHING * size  # a dwell without load has no sign to change
    roots = [crossings(first, np.where(still, 0.0, now.load).reshape(first.x.shape))]
    if of.friction and follower.kind == "translating":
        across, _ = tangent_terms(follower, at.motion, follower.start, follower.offset)
        roots.append(crossings(first, across.reshape(first.x.shape)))
    parts_on = divided(first, np.concatenate(roots))
    _check_jamming(task, loads, of, parts_on)

    def rows(phi: Values) -> Values:
        there = state(of, at_angles(task, loads, phi))
        return np.stack((there.contact, there.lower, there.driving, there.load))

    scale = np.array([size, size, size * task.program.stroke * pi, size]) + 1e-300
    on, _, _ = resolved(rows, parts_on, TOLERANCE, scale)
    points = at_angles(task, loads, on.x.ravel())
    return TurnForces(of, on, points, state(of, points))


def _useful(now: State, at: Points) -> Values:
    """cos(theta) less what friction takes (5.62, 5.64)."""
    return now.cosine - np.where(now.load > 0, -at.sense, at.sense) * now.ratio


def _check_jamming(task: CamTask, loads: Loads, of: Carried, on: Panels) -> None:
    """Refuse a follower that jams, with the intervals and the worst place."""
    if not of.rubs:
        return

    def useful(phi: Values) -> Values:
        at = at_angles(task, loads, phi)
        return _useful(state(of, at), at)

    values = useful(on.x.ravel()).reshape(on.count, on.order)
    if np.min(values) > CLEAR:
        return
    (least, place), _ = on.extremes(levelled(values))
    if least > 0:
        return
    parts = divided(on, crossings(on, values))
    jammed = spans(parts.edges, useful((parts.edges[:-1] + parts.edges[1:]) / 2) <= 0)
    where = ", ".join(f"{degrees(a):.6g} to {degrees(b):.6g} deg" for a, b in jammed) or f"{degrees(place):.6g} deg"
    at = at_angles(task, loads, np.array([place]))
    now = state(of, at)
    cure = "a thinner pivot" if of.pivot else "a longer guide, a larger start_distance"
    if of.follower.kind == "flat":
        why, cure = f"2 f S'/l = {now.ratio[0]:.6g} at {degrees(place):.6g} deg, and 1 is the limit", "a longer guide"
    else:
        theta, critical = degrees(float(np.arctan2(np.abs(now.sine[0]), now.cosine[0]))), _critical(of, now)
        limit = "" if critical is None else f", beyond the critical {degrees(critical):.6g} deg"
        why = f"|theta| = {theta:.6g} deg at {degrees(place):.6g} deg{limit}"
    raise SingularityError(
        f"the follower jams for phi from {where}: {why}",
        where="cam_forces",
        value=least,
        limit=0.0,
        remedy=f"{cure}, less friction",
    )


def _critical(of: Carried, now: State) -> float | None:
    """|theta| [rad] at which the follower would jam in the first place of a state."""
    if not of.rubs or of.follower.kind == "flat":
        return None
    if of.pivot:
        return float(np.arccos(min(of.pivot, 1.0)))
    guide = of.guide
    return atan(1 / (of.friction * (1 + 2 * float(now.protrusion[0]) / guide.length))) if guide else None


def reserve_of(course: TurnForces) -> Reserve:
    """The place where friction takes the largest part of the useful component."""
    now, at, of = course.state, course.points, course.carried
    values = _useful(now, at) / now.cosine if of.rubs else now.cosine
    (part, place), _ = course.on.extremes(levelled(course.shaped(values)))

    def there(values: Values) -> Values:
        return course.on.at(course.shaped(values), np.array([place]))

    cosine, sine = float(there(now.cosine)[0]), float(there(now.sine)[0])
    local = now._replace(protrusion=there(now.protrusion))
    eaten = max(1 - part, 0.0) if of.rubs else 0.0
    return Reserve((1 - eaten) * cosine, eaten, place, float(np.arctan2(sine, cosine)), _critical(of, local))
