"""The admissible shifts of a pinion and a ring on a line of constant x1 + x2, which keeps the centre distance."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from tmmcalc.core.records import record
from tmmcalc.gears.involute.internal.margins import InternalMargins, internal_margins
from tmmcalc.gears.involute.internal.pair import Tips
from tmmcalc.gears.involute.internal.ring import Ring, angle_of_shifts
from tmmcalc.gears.involute.profile.rounding import Shape
from tmmcalc.gears.involute.quality.existence import Form, form_over_shifts
from tmmcalc.gears.involute.quality.verdicts import NOISE, QualityLimits
from tmmcalc.gears.involute.wheel import Wheel
from tmmcalc.gears.model import Values

REACH, COUNT = 10.0, 1001  # admissible x1 are sought between -REACH and REACH
ZOOM, ROUNDS = 17, 10  # points of a round that narrows a maximum or a border
INWARD = 5e-11  # the ends of intervals are moved so far inward, beyond their error

Span = tuple[float, float]


@record
class InternalLine:
    """All x1 on a line of constant x1 + x2."""

    pinion: Wheel
    ring: Ring
    total: float
    limits: QualityLimits
    fillet: Shape
    tips: Tips
    form: Form  # where the involute of the pinion ends over x1, to about 1e-11
    cut: float = 0.0  # by which the tip of the pinion is shortened

    def at(self, x1: Values | float, form: Form | None = None) -> InternalMargins:
        """The margins at x1 (n,), exact."""
        one = np.atleast_1d(np.asarray(x1, float))
        both = one, self.total - one
        return internal_margins(self.pinion, self.ring, *both, self.limits, self.fillet, self.tips, form, self.cut)

    def least(self, x1: Values) -> Values:
        """The least margin at x1 (n,), to about 1e-11, rounding forgiven."""
        return self.at(x1, self.form).least + NOISE


def internal_line(
    pinion: Wheel,
    ring: Ring,
    total: float,
    limits: QualityLimits | None = None,
    fillet: Shape = "ellipse",
    tips: Tips = "clear",
    cut: float = 0.0,
) -> InternalLine:
    """The line of a sum of shifts, the tip of the pinion shortened by ``cut``.

    Raises `NoSolutionError` as `angle_of_shifts` does if there is no such pair.
    """
    plain = replace(pinion, shift=0.0)
    angle_of_shifts(plain, replace(ring, shift=total))
    form = form_over_shifts(plain, fillet)
    return InternalLine(plain, ring, total, limits or QualityLimits(), fillet, tips, form, cut)


def intervals(line: InternalLine) -> tuple[Span, ...]:
    """Admissible x1, each from lowest to highest, to 1e-10; empty if there are none.

    >>> found = intervals(internal_line(Wheel(20), Ring(60), 0.0))
    >>> [(round(low, 6), round(high, 6)) for low, high in found]
    [(-0.860128, 1.222348)]
    """
    x1, least = scan(line)
    good = least >= 0
    enters, leaves = np.flatnonzero(~good[:-1] & good[1:]), np.flatnonzero(good[:-1] & ~good[1:])
    outside, inside = np.append(x1[enters], x1[leaves + 1]), np.append(x1[enters + 1], x1[leaves])
    ends = _border(line, outside, inside)
    low, high = ends[: enters.size], ends[enters.size :]
    if good[0]:
        low = np.append(x1[0], low)
    if good[-1]:
        high = np.append(high, x1[-1])
    return tuple((float(a), float(b)) for a, b in zip(low, high, strict=True) if a <= b)


def _border(line: InternalLine, outside: Values, inside: Values) -> Values:
    """The last admissible points (k,) on the way from ``inside`` to ``outside``, INWARD clear of the border."""
    start, every = inside, np.arange(inside.size)
    for _ in range(ROUNDS):
        x = outside[:, None] + np.linspace(0, 1, ZOOM) * (inside - outside)[:, None]
        good = line.least(x.ravel()).reshape(x.shape) >= 0
        good[:, 0], good[:, -1] = False, True
        last = ZOOM - 1 - np.argmin(good[:, ::-1], axis=1)  # the last point that is not
        outside, inside = x[every, last], x[every, last + 1]
    return inside + np.sign(start - inside) * np.minimum(INWARD, abs(start - inside))


def scan(line: InternalLine) -> tuple[Values, Values]:
    """Points x1 and the least margins there, with the maxima between them that may hide a short interval."""
    x1 = np.linspace(-REACH, REACH, COUNT)
    values = line.least(x1)
    inner = values[1:-1]
    peaks = 1 + np.flatnonzero((inner < 0) & (inner >= values[:-2]) & (inner >= values[2:]) & np.isfinite(inner))
    if not peaks.size:
        return x1, values
    extra = np.array([climb(line.least, float(x1[k - 1]), float(x1[k + 1])) for k in peaks])
    hits = extra[line.least(extra) >= 0]
    every = np.sort(np.concatenate((x1, hits)))
    return every, line.least(every)


def climb(f: Callable[[Values], Values], low: float, high: float) -> float:
    """The place of a maximum between two points."""
    for _ in range(ROUNDS):
        x = np.linspace(low, high, ZOOM)
        k = int(np.argmax(f(x)))
        low, high = float(x[max(k - 1, 0)]), float(x[min(k + 1, ZOOM - 1)])
    return (low + high) / 2
