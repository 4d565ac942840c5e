"""A route in time: each of its legs from rest to rest by the time-optimal law, under limits on its arcs."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.numerics.roots import Indices
from tmmcalc.core.timelaw import TimeLaw, by_travel, by_travel_and_duration, motion, phase_of, time_at
from tmmcalc.manipulators.courses import SAME, WHERE, Course, distinct
from tmmcalc.manipulators.routes import Leg
from tmmcalc.manipulators.task import Drive


class Timed(NamedTuple):
    """Legs of a route with their laws and the times at which they begin [s]."""

    legs: tuple[Leg, ...]
    laws: tuple[TimeLaw, ...]
    begins: tuple[float, ...]

    @property
    def duration(self) -> float:
        """T [s]."""
        return self.begins[-1] + self.laws[-1].duration

    @property
    def length(self) -> float:
        """S [m]."""
        return sum((law.travel for law in self.laws), 0.0)

    def leg_of(self, t: Values, side: Indices | int) -> Indices:
        """Numbers (n,) of the legs; between two of them ``side`` decides, 0 as +1."""
        begins, near = np.array(self.begins), SAME * self.duration
        before = np.searchsorted(begins, t - near, side="left") - 1
        after = np.searchsorted(begins, t + near, side="right") - 1
        return np.clip(np.where(np.asarray(side) < 0, before, after), 0, len(self.legs) - 1)

    def way(self, t: Values, side: Indices | int) -> Values:
        """s from the start of the route, v, a: (3, n)."""
        return self._by_leg(t, side, lambda k, at, which: self._way(k, at, which), 3)

    def phase(self, t: Values, side: Indices | int) -> Indices:
        """Phase (n,) of the leg's law: 1 acceleration, 2 uniform motion, 3 deceleration."""

        def of_leg(k: int, at: Values, which: Indices) -> Values:
            return phase_of(self.laws[k], at, which)[None].astype(float)

        return np.rint(self._by_leg(t, side, of_leg, 1)[0]).astype(np.intp)

    def gripper(self, t: Values, side: Indices | int) -> Values:
        """States (3, D, n) of the gripper: v and a by the tangent and the curvature ((2.96) to (2.99))."""
        dimensions = len(self.legs[0][0].start)
        flat = self._by_leg(t, side, lambda k, at, which: self._states(k, at, which), 3 * dimensions)
        return flat.reshape(3, dimensions, -1)

    def _by_leg(self, t: Values, side: Indices | int, f: Callable[[int, Values, Indices], Values], rows: int) -> Values:
        which = self.leg_of(t, side)
        sides = np.broadcast_to(np.asarray(side), t.shape)
        found = np.empty((rows, len(t)), t.dtype)
        for k, begin in enumerate(self.begins):
            own = np.flatnonzero(which == k)
            if own.size:
                found[:, own] = f(k, t[own] - begin, sides[own]).reshape(rows, -1)
        return found

    def _way(self, k: int, t: Values, side: Indices) -> Values:
        rows = motion(self.laws[k], t, side)
        rows[0] += sum((law.travel for law in self.laws[:k]), 0.0)
        return rows

    def _states(self, k: int, t: Values, side: Indices) -> Values:
        """States (3, D, n) on leg k at its own times; at the joint of two pieces ``side`` decides."""
        s, v, a = motion(self.laws[k], t, side)
        leg = self.legs[k]
        number, starts = self._piece(k, s, side)
        found = np.empty((3, len(leg[0].start), len(t)), s.dtype)
        for j, piece in enumerate(leg):
            own = np.flatnonzero(number == j)
            place, along, bend = piece.at(s[own] - starts[j])
            found[:, :, own] = place, along * v[own], along * a[own] + bend * v[own] ** 2
        return found

    def normal(self, t: Values, side: Indices | int) -> Values:
        """Normal acceleration v^2/R (n,) [m/s^2]."""

        def of_leg(k: int, at: Values, which: Indices) -> Values:
            s, v, _ = motion(self.laws[k], at, which)
            bend = np.array([1 / piece.radius if piece.radius else 0.0 for piece in self.legs[k]])
            return np.asarray(bend[self._piece(k, s, which)[0]] * v * v)

        return self._by_leg(t, side, of_leg, 1)[0]

    def _piece(self, k: int, s: Values, side: Indices) -> tuple[Indices, Values]:
        """Numbers (n,) of the pieces of leg k that hold the ways s (n,), and the ways at which the pieces begin."""
        starts = np.concatenate(([0.0], np.cumsum([piece.length for piece in self.legs[k]])))
        near = SAME * starts[-1]
        before = np.searchsorted(starts[:-1], s - near, side="left") - 1
        after = np.searchsorted(starts[:-1], s + near, side="right") - 1
        return np.clip(np.where(side < 0, before, after), 0, len(self.legs[k]) - 1), starts

    @property
    def jumps(self) -> tuple[float, ...]:
        """Where the acceleration jumps: phases of the laws, joints of pieces [s]."""
        found = [0.0, self.duration]
        for begin, law, leg in zip(self.begins, self.laws, self.legs, strict=True):
            joints = np.cumsum([piece.length for piece in leg])[:-1].tolist()
            found += [begin + t for t in (*law.instants, *(time_at(law, s) for s in joints))]
        return distinct(found, self.duration)

    def time(self, leg: int, s: float) -> float:
        """The time [s] at which the way on a leg is s [m]."""
        return self.begins[leg] + time_at(self.laws[leg], s)

    @property
    def course(self) -> Course:
        """The gripper over the time."""
        return Course(self.duration, self.jumps, self.gripper)


def timed(legs: tuple[Leg, ...], drive: Drive) -> Timed:
    """The legs with their laws: each from rest to rest, no quicker than the limits of its curvature allow.

    Raises `NoSolutionError` for limits or a duration that cannot be kept.
    """
    laws, begins, begin = [], [], 0.0
    for leg in legs:
        law = _law(leg, drive, len(legs))
        laws.append(law)
        begins.append(begin)
        begin += law.duration
    return Timed(legs, tuple(laws), tuple(begins))


def _law(leg: Leg, drive: Drive, count: int) -> TimeLaw:
    length = sum((piece.length for piece in leg), 0.0)
    limits = [limit for limit in (drive.speed, speed_limit(leg, drive)) if limit is not None]
    speed = min(limits) if limits else None
    if drive.duration is not None:
        if count > 1:
            raise UsageError(
                f"the path has {count - 1} stops, and one duration does not divide itself between {count} legs",
                where=f"{WHERE}, duration",
                remedy="round the corners with corner_radius, or give speed in place of duration",
            )
        return by_travel_and_duration(length, drive.duration, drive.acceleration, speed)
    if speed is None:
        raise UsageError("neither a speed nor a duration is given", where=WHERE, remedy="give speed")
    return by_travel(length, speed, drive.acceleration)


def speed_limit(leg: Leg, drive: Drive) -> float | None:
    """The largest speed [m/s] that keeps the limits of normal and total acceleration on the sharpest arc.

    v^2/R <= a_n, and at the end of the acceleration a_m^2 + (v^2/R)^2 <= a^2. Raises `NoSolutionError` where a_m alone
    is beyond the total.
    """
    radii = [piece.radius for piece in leg if piece.radius is not None]
    found = []
    if drive.total is not None and (drive.total < drive.acceleration or (radii and drive.total == drive.acceleration)):
        raise NoSolutionError(
            f"the tangential acceleration {drive.acceleration:.9g} m/s^2 alone takes up the total acceleration of "
            f"{drive.total:.9g} m/s^2",
            where=f"{WHERE}, total_acceleration",
            value=drive.acceleration,
            limit=drive.total,
            remedy="write a smaller acceleration",
        )
    if radii and drive.normal is not None:
        found.append(np.sqrt(drive.normal * min(radii)).item())
    if radii and drive.total is not None:
        normal = np.sqrt((drive.total - drive.acceleration) * (drive.total + drive.acceleration))
        found.append(np.sqrt(normal * min(radii)).item())
    return min(found) if found else None
