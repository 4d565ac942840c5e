"""Times, angles and mean speeds of the working and the idle stroke, from the time ratio K and the crank's speed.

K = alpha_p/alpha_x = t_p/t_x = v_x/v_p, with alpha_p = 180 + psi and alpha_x = 180 - psi.
"""

from __future__ import annotations

import math

from tmmcalc.linkage.synthesis.results import StrokeTimes

TURN = 2 * math.pi


def overlap(time_ratio: float) -> float:
    """Overlap angle psi [rad] of a time ratio K.

    >>> round(math.degrees(overlap(1.4)), 9)
    30.0
    """
    return math.pi * (time_ratio - 1) / (time_ratio + 1)


def time_ratio(psi: float) -> float:
    """Time ratio K of an overlap angle [rad]."""
    return (math.pi + psi) / (math.pi - psi)


def crank_speed(stroke: float, ratio: float, working_speed: float) -> float:
    """Speed of the crank [rad/s] for the mean speed v_p of the working stroke, n = v_p/(S (1 + 1/K))."""
    return TURN * working_speed / (stroke * (1 + 1 / ratio))


def stroke_times(stroke: float, ratio: float, speed: float, unit: str = "m") -> StrokeTimes:
    """Times [s], angles [rad] and mean speeds of both strokes, in ``unit``, at the crank's ``speed`` [rad/s].

    >>> times = stroke_times(0.28, 1.4, 150 * math.pi / 30)
    >>> round(times.working_speed, 9), round(times.idle_speed, 9), round(times.mean_speed, 9)
    (1.2, 1.68, 1.4)
    """
    period = TURN / speed
    working, idle = period * ratio / (ratio + 1), period / (ratio + 1)
    return StrokeTimes(
        crank_speed=speed,
        time_ratio=ratio,
        stroke=stroke,
        unit=unit,
        period=period,
        working_time=working,
        idle_time=idle,
        working_speed=stroke / working,
        idle_speed=stroke / idle,
        mean_speed=2 * stroke / period,
        working_angle=TURN * ratio / (ratio + 1),
        idle_angle=TURN / (ratio + 1),
        overlap=overlap(ratio),
    )
