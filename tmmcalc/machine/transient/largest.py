"""The largest moments of a motion, between the steps too: of every shaft and of the motor."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.numerics.panels import Values
from tmmcalc.machine.transient.extremes import Found, Reading, farthest
from tmmcalc.machine.transient.model import Drive, shaft_ratios
from tmmcalc.machine.transient.outcome import Curves
from tmmcalc.machine.transient.run import Row, Run

Flags = NDArray[np.bool_]
HALVINGS = 60
CLOSE = 1e-4  # of the rows of a polynomial: nearer ones would leave rounding of it


def largest_moments(drive: Drive, found: Curves, run: Run) -> list[Found]:
    """Those of the N - 1 shafts, each on its own, and last that of the motor; none is below a row."""
    group, made = run.system.chain.group, []
    for i, u in enumerate(shaft_ratios(drive)):
        if group[i + 1] > group[i]:
            made.append(_on(_elastic(found, run, group[i], i, u), 1 / u))
        else:
            made.append(_rigid(found.t, found.shaft_moment[i], run.rows))
    return [*made, _motor(drive.characteristic, found, run)]


def _on(moment: Found, u: float) -> Found:
    """A moment of the crank's shaft on its own."""
    return moment._replace(value=moment.value * u, gap=moment.gap * abs(u))


def _elastic(found: Curves, run: Run, i: int, shaft: int, u: float) -> Found:
    """Of the elastic shaft i, the given number ``shaft`` of the drive, on the crank's shaft."""
    chain, n = run.system.chain, run.system.layout.groups
    first, second = (chain.group.index(g) for g in (i, i + 1))
    slide, rate = (
        values[first] / chain.ratio[first] - values[second] / chain.ratio[second]
        for values in (found.omega, found.alpha)
    )
    c, k = chain.stiffness[i], chain.damping[i]
    reading = Reading(i + 1, c, k, n + i, n + i + 1)
    return farthest(run, reading, (found.t, found.shaft_moment[shaft] * u, c * slide + k * rate), abs, [])


def _motor(motor: Any, found: Curves, run: Run) -> Found:
    """Of the motor on its own shaft."""
    sampled = _of_rows(found.t, found.motor_moment)
    if motor is None:
        return sampled
    layout, u = run.system.layout, run.system.chain.motor_ratio
    on = np.array([row.regime.motor for row in run.rows])
    if layout.lag:
        static = np.where(on, np.asarray(motor.moment(found.omega[0])), found.motor_moment)
        rate = u * (static - found.motor_moment) / run.system.time_constant
        lost = np.flatnonzero(on[:-1] & ~on[1:]).tolist()
        lagging = farthest(run, Reading(layout.works - 1), (found.t, found.motor_moment * u, rate), abs, lost)
        return _largest([sampled, _on(lagging, 1 / u)])
    course = found.t, found.omega[0] / u, found.alpha[0] / u
    speeds = [farthest(run, Reading(layout.speed), course, key, []) for key in (_upwards, _downwards)]
    return _largest([sampled, *_static(motor, u, speeds, found, on)])


def _upwards(value: float) -> float:
    return value


def _downwards(value: float) -> float:
    return -value


def _largest(moments: list[Found]) -> Found:
    """The largest; its gap reaches what any of them may be."""
    found = max(moments, key=lambda each: abs(each.value))
    return found._replace(gap=max(abs(each.value) + each.gap for each in moments) - abs(found.value))


def _of_rows(t: Values, values: Values) -> Found:
    k = int(np.argmax(np.abs(values)))
    return Found(float(values[k]), float(t[k]))


def _static(motor: Any, u: float, speeds: list[Found], found: Curves, on: Flags) -> list[Found]:
    """The moments of a static characteristic at the ends of the range of its speed, and where it turns back within."""
    made = [
        Found(float(motor.moment(u * w)), at, gap * abs(u * float(motor.slope(u * w))))
        for w, at, gap in speeds
        if on[max(int(np.searchsorted(found.t, at, side="right")) - 1, 0)]
    ]
    w, t = found.omega[0], found.t
    rising = np.broadcast_to(np.asarray(motor.slope(w)) > 0, w.shape)
    for k in np.flatnonzero((rising[1:] != rising[:-1]) & on[:-1]).tolist():
        at = _turning(motor.slope, float(w[k]), float(w[k + 1]))
        part = (at - w[k]) / (w[k + 1] - w[k])
        made.append(Found(float(motor.moment(at)), float(t[k] + part * (t[k + 1] - t[k]))))
    return made


def _turning(slope: Callable[[float], Any], a: float, b: float) -> float:
    """Where a slope changes its sign between two speeds."""
    first = slope(a) > 0
    for _ in range(HALVINGS):
        middle = (a + b) / 2
        a, b = (middle, b) if (slope(middle) > 0) == first else (a, middle)
    return (a + b) / 2


def _rigid(t: Values, values: Values, rows: list[Row]) -> Found:
    """Of a rigid shaft, whose rate is not known: polynomials through the largest row and its neighbours in one regime.

    Told is what that through all of them differs by from that through one less.
    """
    sampled = _of_rows(t, values)
    k = int(np.argmax(np.abs(values)))
    side = next((m for m in (2, 1) if _alike(rows, k - m, k + m)), 0)
    near, h = slice(k - side, k + side + 1), float(t[k + side] - t[k - side]) if side else 0.0
    if not side or np.diff(t[near]).min() < CLOSE * h:
        return sampled
    x, y = (t[near] - t[k]) / h, values[near] - values[k]
    (at, more), (_, less) = _top(x, y), _top(x[:-1], y[:-1]) if side > 1 else (0.0, 0.0)
    gain = more if more * sampled.value > 0 else 0.0
    return Found(sampled.value + gain, sampled.time + (at * h if gain else 0.0), abs(more - less))


def _alike(rows: list[Row], first: int, last: int) -> bool:
    """Whether rows are there and in one regime."""
    return first >= 0 and last < len(rows) and all(row.regime == rows[first].regime for row in rows[first : last + 1])


def _top(x: Values, y: Values) -> tuple[float, float]:
    """Place and value of the turning point near zero of the polynomial through points; zeros where there is none."""
    slope = np.arange(1, len(x)) * np.linalg.solve(np.vander(x, increasing=True), y)[1:]
    roots = np.roots(slope[::-1]) if slope[-1] else np.zeros(0)
    real = roots[(np.abs(roots.imag) == 0) & (roots.real > x[0]) & (roots.real < x[-1])].real
    if not len(real):
        return 0.0, 0.0
    at = float(real[np.argmin(np.abs(real))])
    return at, float(np.polyval(np.append((slope / np.arange(1, len(x)))[::-1], 0.0), at))
