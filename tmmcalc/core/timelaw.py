"""The time-optimal law: rest to rest over a travel under limits of speed and acceleration (textbook 2.10.1).

    |v| <= v_m, |a| <= a_m; v_p is the peak speed, which a short travel leaves below v_m

          a  ┌──┐                        t_1 = v_p/a_m                (2.65)
             │  │                        t_2 = (S_m - 2 S_1)/v_p      (2.66), (2.67)
          ───┘  └──────┐  ┌──── t        T = 2 t_1 + t_2              (2.68), (2.70)
             t_1  t_2  │  │
                       └──┘ t_1

The acceleration jumps at 0, t_1, T - t_1 and T. A travel below zero is the mirror image: s, v and a change their
signs. The coordinate may be a length [m] or an angle [rad]; the units below are those of a length.
"""

from __future__ import annotations

import math

import numpy as np

from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.numerics.roots import Indices
from tmmcalc.core.quantity import derived, quantity
from tmmcalc.core.records import record

SAME = 1e-12  # of the duration: instants nearer than this are one
ENDS = 2e-15  # of T^2/t_2: some roundings of the ends of a short uniform phase
WHERE = "time-optimal law"


@record
class TimeLaw:
    """A motion from rest to rest in three phases: acceleration, uniform motion, deceleration."""

    travel: float = quantity("{prefix}S_m[{unit}]", "travel, with its sign")
    speed: float = quantity("{prefix}v_peak[{unit}/s]", "largest speed that is reached, at least 0", symbol="v_p")
    acceleration: float = quantity("{prefix}a[{unit}/s^2]", "largest acceleration, above 0", symbol="a_m")
    ramp: float = quantity("{prefix}t_1[s]", "time of each of the outer phases", source="(2.65)")
    uniform: float = quantity("{prefix}t_2[s]", "time of the uniform phase", source="(2.66)")

    @derived("{prefix}T[s]", "time of the whole motion", source="(2.68)")
    def duration(self) -> float:
        """T [s]."""
        return 2 * self.ramp + self.uniform

    @property
    def sense(self) -> float:
        """Sign of the travel."""
        return math.copysign(1.0, self.travel)

    @derived("{prefix}S_1[{unit}]", "way of each of the outer phases")
    def ramp_travel(self) -> float:
        """S_1: the way of each of the outer phases, at least 0 [m]."""
        return self.acceleration * self.ramp**2 / 2

    @derived("{prefix}S_2[{unit}]", "way of the uniform phase")
    def uniform_travel(self) -> float:
        """S_2: the way of the uniform phase, at least 0 [m]."""
        return self.speed * self.uniform

    @derived("{prefix}jumps[s]", "instants where the acceleration jumps")
    def instants(self) -> tuple[float, ...]:
        """Where the acceleration jumps: 0, t_1, T - t_1, T [s], each once; none without motion."""
        if not self.speed:
            return ()
        inner = (self.ramp,) if self.uniform <= SAME * self.duration else (self.ramp, self.ramp + self.uniform)
        return (0.0, *inner, self.duration)


def phase_times(travel: Values, speed: Values, acceleration: Values) -> tuple[Values, Values, Values]:
    """t_1, t_2 [s] and v_p [m/s] for travels S_m of any sign under v_m and a_m > 0; all broadcast ((2.65) to (2.71)).

    >>> [part.tolist() for part in phase_times(np.array([1.3, -0.1, 0.0]), np.array(0.4), np.array(0.8))]
    [[0.5, 0.3535533905932738, 0.0], [2.75, 0.0, 0.0], [0.4, 0.28284271247461906, 0.0]]
    """
    way = np.abs(travel)
    long = way * acceleration >= speed * speed
    peak = np.where(long, speed, np.sqrt(way * acceleration))
    ramp = peak / acceleration
    uniform = np.where(long, np.maximum(way / speed - speed / acceleration, 0.0), 0.0)
    return ramp, uniform, peak


def by_travel(travel: float, speed: float, acceleration: float) -> TimeLaw:
    """The quickest motion over the travel S_m [m] under v_m and a_m ((2.65) to (2.71)).

    Raises `UsageError` for limits that are not above zero.

    >>> law = by_travel(1.3, 0.4, 0.8)
    >>> law.ramp, law.uniform, law.duration
    (0.5, 2.75, 3.75)
    """
    _check(speed=speed, acceleration=acceleration)
    _check_finite(travel=travel)
    ramp, uniform, peak = (part.item() for part in phase_times(*map(np.asarray, (travel, speed, acceleration))))
    return TimeLaw(travel, peak, acceleration, ramp, uniform)


def by_duration(duration: float, speed: float, acceleration: float, sense: int = 1) -> TimeLaw:
    """The longest travel that fits into the duration T [s] under v_m and a_m, to the side of ``sense`` (2.10.2.4).

    S_m = v_m (T - t_1) if T >= 2 t_1, else a_m T^2/4. Raises `UsageError` for what is not above zero.

    >>> by_duration(12.0, 0.2, 0.05).travel
    1.6
    """
    _check(duration=duration, speed=speed, acceleration=acceleration)
    ramp = min(speed / acceleration, duration / 2)
    peak = speed if ramp < duration / 2 else acceleration * ramp
    uniform = duration - 2 * ramp
    return TimeLaw(math.copysign(peak * (ramp + uniform), sense), peak, acceleration, ramp, uniform)


def by_travel_and_duration(travel: float, duration: float, acceleration: float, speed: float | None = None) -> TimeLaw:
    """The motion over S_m [m] that takes exactly T [s] with a_m, at the least peak speed that does it.

    v_p = a_m (T - sqrt(T^2 - 4 S_m/a_m))/2. Raises `NoSolutionError` if T is too short for a_m, or if the peak speed
    is above the limit ``speed``; `UsageError` for what is not above zero.

    >>> round(by_travel_and_duration(1.6, 12.0, 0.05).speed, 15)
    0.2
    """
    _check(duration=duration, acceleration=acceleration, **({} if speed is None else {"speed": speed}))
    _check_finite(travel=travel)
    way = abs(travel)
    square = duration * duration - 4 * way / acceleration
    if square < -SAME * duration * duration:
        least = 2 * math.sqrt(way / acceleration)
        raise NoSolutionError(
            f"the travel {travel:.9g} takes at least {least:.9g} with this acceleration, {duration:.9g} is asked for",
            where=WHERE,
            value=duration,
            limit=least,
            remedy="allow a longer duration or a larger acceleration",
        )
    uniform = np.sqrt(max(square, 0.0)).item()
    peak = 2 * way / (duration + uniform)
    if speed is not None and peak > speed * (1 + SAME):
        raise NoSolutionError(
            f"the travel {travel:.9g} in {duration:.9g} s needs a speed of {peak:.9g}, above the limit {speed:.9g}",
            where=WHERE,
            value=peak,
            limit=speed,
            remedy="allow a longer duration, a larger acceleration or a larger speed",
        )
    return TimeLaw(travel, peak, acceleration, peak / acceleration, uniform)


def motion(law: TimeLaw, t: Values, side: Indices | int = 0) -> Values:
    """s [m], v [m/s] and a [m/s^2] at the times ``t`` (n,): (3, n) ((2.75) to (2.77)).

    Where the acceleration jumps, ``side`` (n,) chooses the limit from before (-1) or from after (+1); 0 is the limit
    from after, but from before at T, so that both ends count as inside of the motion. Beyond them there is rest.

    >>> motion(by_travel(1.3, 0.4, 0.8), np.array([0.0, 0.2, 1.0, 3.75])).round(12).tolist()
    [[0.0, 0.016, 0.3, 1.3], [0.0, 0.16, 0.4, 0.0], [0.8, 0.8, 0.0, -0.8]]
    """
    t = np.asarray(t)
    t = t.astype(np.result_type(t, float), copy=False)
    phase = _phase(law, t, np.broadcast_to(np.asarray(side), t.shape))
    left = law.duration - t
    still = np.zeros_like(t)
    ways = (
        still,
        law.acceleration * t * t / 2,
        law.ramp_travel + law.speed * (t - law.ramp),
        abs(law.travel) - law.acceleration * left * left / 2,
        still + abs(law.travel),
    )
    speeds = (still, law.acceleration * t, still + law.speed, law.acceleration * left, still)
    which = [phase == k for k in range(5)]
    s, v = np.select(which, ways), np.select(which, speeds)
    a = np.array([0.0, law.acceleration, 0.0, -law.acceleration, 0.0])[phase]
    return law.sense * np.stack((s, v, a))


def phase_of(law: TimeLaw, t: Values, side: Indices | int = 0) -> Indices:
    """Number (n,) of the phase: 0 rest before, 1 acceleration, 2 uniform motion, 3 deceleration, 4 rest after."""
    t = np.asarray(t, float)
    return _phase(law, t, np.broadcast_to(np.asarray(side), t.shape))


def time_at(law: TimeLaw, way: float) -> float:
    """The time [s] at which a law has gone a way [m] from 0 to |S_m|: `motion` read the other way.

    >>> time_at(by_travel(1.3, 0.4, 0.8), 0.3)
    1.0
    """
    left = abs(law.travel) - way
    if min(way, left) <= law.ramp_travel:
        ramp = math.sqrt(2 * max(min(way, left), 0.0) / law.acceleration)
        return ramp if way < left else law.duration - ramp
    return law.ramp + (way - law.ramp_travel) / law.speed


def _phase(law: TimeLaw, t: Values, side: Indices) -> Indices:
    """As `phase_of`; times within rounding of a boundary count as the boundary."""
    if not law.speed:
        return np.where(t < 0, 0, np.where(t > law.duration, 4, 2))
    near = min(SAME * law.duration, law.ramp / 8)
    if law.uniform:  # a short uniform phase is the root of a difference: its ends are known the less, the shorter it is
        near = max(near, min(ENDS * law.duration**2 / law.uniform, law.uniform / 8))
    ends = np.array([0.0, law.ramp, law.ramp + law.uniform, law.duration])[:, None]
    after = np.count_nonzero(t.ravel() >= ends - near, axis=0).reshape(t.shape)
    before = np.count_nonzero(t.ravel() > ends + near, axis=0).reshape(t.shape)
    inside = np.where(np.abs(t - law.duration) <= near, 3, after)
    return np.where(side < 0, before, np.where(side > 0, after, inside))


def _check(**given: float) -> None:
    """Refuse limits and durations that are not above zero."""
    for name, value in given.items():
        if not 0 < value < math.inf:
            raise UsageError(
                f"the {name} is {value:g}", where=WHERE, value=value, limit=0.0, remedy="give a number above zero"
            )


def _check_finite(**given: float) -> None:
    for name, value in given.items():
        if not math.isfinite(value):
            raise UsageError(f"the {name} is {value:g}", where=WHERE, value=value, remedy="give a finite number")
