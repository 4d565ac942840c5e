"""Fall of a ball whose radius decreases as r = r0 e^(-lambda t), with the reaction of the mass that separates.

dv/dt = g - (alpha/r) v|v| + 3 s lambda V, positive downwards; s = 1 accelerates, -1 brakes. V is constant, the relative
speed of the separated mass, or it is v: that mass then has no speed of its own. The speed is in closed form, the way
its integral.
"""

from __future__ import annotations

from collections.abc import Callable
from math import exp

import numpy as np

from tmmcalc.core.notes import Said
from tmmcalc.core.numerics.extended import EPS
from tmmcalc.core.numerics.panels import Panels, Values, panels, resolved
from tmmcalc.core.quantity import quantity
from tmmcalc.core.records import record
from tmmcalc.extras.ballspeed import ROUNDED, Fall, drag_way, falling_speed, speed_error, stop_time

BALANCED = 1e-13  # of gravity and reaction: a smaller difference is none
LONG = 80.0  # lambda t after which nothing moves
PANELS = 8  # of the time to begin with
HALVED = 40  # times that the first panel of the time is halved
SHOWN = 5.0  # lambda t of the table of a ball that does not stop
RESOLVED = 1e-13


@record
class BallTask:
    """A ball and its fall."""

    radius: float  # r0 [m]
    drag: float  # alpha
    decay: float  # lambda [1/s]
    gravity: float = 9.81  # g [m/s^2]
    sign: int = 1  # s: 1 accelerates, -1 brakes
    relative: float | None = 0.0  # V = |v_r| [m/s]; None: V = v
    initial: float = 0.0  # v0 [m/s], downwards
    times: tuple[float, ...] = ()  # [s] at which speed and way are asked for
    duration: float | None = None  # [s] of the table; None: to the stop, or as long as the ball moves fast
    rows: int = 200


@record
class Moment:
    """An instant of the fall."""

    t: float = quantity("t[s]", "time")
    v: float = quantity("v[m/s]", "speed downwards")
    way: float = quantity("S[m]", "way from the beginning, downwards")


@record
class Ball:
    """The fall of the ball."""

    drive: float = quantity("a[m/s^2]", "g + 3 s lambda V with constant V, else g")
    argument: float = quantity("eta0", "argument of the Bessel functions at t = 0", symbol="eta_0")
    fastest: Moment | None  # where the speed is largest, if it has a maximum inside
    stop: Moment | None  # where the ball stops; then it moves upwards
    stop_argument: float | None = quantity("tau*", "argument of the Bessel functions at the stop")
    total: float | None = quantity("S_max[m]", "way that the ball never exceeds, if it does not stop")
    asked: tuple[Moment, ...]
    labels: tuple[str, ...]
    t: Values = quantity("t[s]", "time")  # (n,)
    radius: Values = quantity("r[m]", "radius of the ball")  # (n,)
    v: Values = quantity("v[m/s]", "speed downwards")  # (n,)
    a: Values = quantity("a[m/s^2]", "acceleration downwards")  # (n,)
    way: Values = quantity("S[m]", "way from the beginning, downwards")  # (n,)
    error: dict[str, float]  # of speed and way, relative to their largest values
    notes: tuple[Said, ...] = ()


def solve_falling_ball(task: BallTask) -> Ball:
    """Speed over the time in closed form; its maximum, the stop, the way by quadrature of the speed."""
    own, fall = task.relative is None, fall_of(task)
    stop = stop_time(fall) if fall.drive < 0 else None
    speed = _course(fall, stop)
    end = task.duration if task.duration is not None else stop if stop else SHOWN / task.decay
    fastest = _fastest(fall, speed, 3 * task.sign * task.decay if own else 0.0)
    on, values, tail = _resolved(speed, max(end, *task.times, fastest or 0.0, stop or 0.0), stop)

    def way(t: Values) -> Values:
        return on.primitive_at(values[0], t)

    def moment(t: float) -> Moment:
        at = np.array([t])
        return Moment(t, 0.0 if t == stop else float(speed(at)[0]), float(way(at)[0]))

    t = end * np.arange(task.rows + 1) / task.rows
    v, s = speed(t), way(t)
    return Ball(
        drive=fall.drive,
        argument=float(fall.argument(np.zeros(1))[0]),
        fastest=None if fastest is None else moment(fastest),
        stop=None if stop is None else moment(stop),
        stop_argument=None if stop is None else float(fall.argument(np.array([stop]))[0]),
        total=_total(fall, speed) if stop is None else None,
        asked=tuple(map(moment, task.times)),
        labels=tuple(map(str, range(len(t)))),
        t=t,
        radius=task.radius * np.exp(-task.decay * t),
        v=v,
        a=acceleration(task, t, v),
        way=s,
        error=_errors(fall, stop, t, v, s, _left_out(on, values, tail)),
    )


def fall_of(task: BallTask) -> Fall:
    """The fall up to a stop."""
    own = task.relative is None
    push = 0.0 if task.relative is None else 3 * task.sign * task.decay * task.relative
    drive = task.gravity + push
    if abs(drive) <= BALANCED * max(task.gravity, abs(push)):
        drive = 0.0
    orders = (0, 1) if not own else (3, 4) if task.sign > 0 else (3, 2)
    return Fall(task.radius, task.drag, task.decay, drive, orders, task.initial)


def acceleration(task: BallTask, t: Values, v: Values) -> Values:
    """dv/dt (n,) [m/s^2] at the times (n,) with the speeds (n,)."""
    own = 3 * task.sign * task.decay * v if task.relative is None else 0.0
    radius = task.radius * np.exp(-task.decay * t)
    return np.asarray(fall_of(task).drive - task.drag / radius * v * np.abs(v) + own)


def _left_out(on: Panels, values: Values, tail: float) -> float:
    """What the tail of the speed adds to the way [m]: an integral of a Legendre polynomial of the order of a panel."""
    widest = float(on.edges[-1] - on.edges[0]) / PANELS
    return tail * float(np.max(np.abs(values))) * widest / (2 * on.order + 1)


def _errors(fall: Fall, stop: float | None, t: Values, v: Values, s: Values, left: float) -> dict[str, float]:
    """By the roundings of the speed, which the way adds up; of the way also what its panels leave out."""
    if stop is None:
        missed = speed_error(fall, t)
    else:
        risen = rise_of(fall, stop)
        late = speed_error(fall, np.array([stop])) + ROUNDED * abs(fall.drive) / fall.decay
        rising = late + speed_error(risen, np.maximum(t - stop, 0.0))
        missed = np.where(t < stop, speed_error(fall, np.minimum(t, stop)), rising)
    fastest, farthest = float(np.max(np.abs(v))) or 1.0, float(np.max(np.abs(s))) or 1.0
    added = float(np.sum((missed[1:] + missed[:-1]) / 2 * np.diff(t)))
    return {"speed": float(np.max(missed)) / fastest + EPS, "way": (left + added) / farthest + EPS}


def rise_of(fall: Fall, stop: float) -> Fall:
    """The rise behind a stop, which is a fall of its own with a drive upwards."""
    radius = fall.radius * exp(-fall.decay * stop)
    return Fall(radius, fall.drag, fall.decay, -fall.drive, fall.orders, 0.0)


def _course(fall: Fall, stop: float | None) -> Callable[[Values], Values]:
    """The speed at any time: behind the stop a ball that rises and is driven upwards."""
    if stop is None:
        return lambda t: falling_speed(fall, t)
    risen = rise_of(fall, stop)

    def speed(t: Values) -> Values:
        down = falling_speed(fall, np.minimum(t, stop))
        return np.where(t < stop, down, -falling_speed(risen, np.maximum(t - stop, 0.0)))

    return speed


def _resolved(speed: Callable[[Values], Values], end: float, stop: float | None) -> tuple[Panels, Values, float]:
    """Panels of the time on which the speed is resolved, narrow at the beginning, with an edge at the stop."""
    edges = [end / 2**k for k in range(1, HALVED)] + ([stop] if stop else [])
    return resolved(lambda t: speed(t)[None], panels(0.0, end, sorted(edges), end / PANELS), RESOLVED)


def _fastest(fall: Fall, speed: Callable[[Values], Values], own: float) -> float | None:
    """Where dv/dt = 0; there d2v/dt2 < 0 always, so there is one such place at most."""
    from scipy.optimize import brentq

    def slope(t: float) -> float:
        v = float(speed(np.array([t]))[0])
        return fall.drive + own * v - fall.drag / fall.radius * exp(fall.decay * t) * v * v

    if fall.drive <= 0 or slope(0.0) <= 0:
        return None
    high = 1 / fall.decay
    while slope(high) > 0:
        high *= 2
    return float(brentq(slope, 0.0, high, xtol=1e-14 * high))


def _total(fall: Fall, speed: Callable[[Values], Values]) -> float:
    """The way after a long time; without a drive in closed form."""
    if not fall.drive:
        return drag_way(fall, float("inf"))
    on, values, _ = _resolved(speed, LONG / fall.decay, None)
    return float(on.total(values)[0])
