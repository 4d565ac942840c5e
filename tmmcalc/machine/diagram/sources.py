"""A torque diagram from a formula, from harmonics, from straight pieces or from a table."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping, Sequence

import numpy as np

from tmmcalc.core.errors import AccuracyError, UsageError
from tmmcalc.core.expression import parse
from tmmcalc.core.numerics.panels import MOST, Panels, UnresolvedError, Values, panels, resolved
from tmmcalc.machine.cycle import Cycle

TURN = 2 * math.pi
UNRESOLVED = 1e-6  # share of the work of the cycle that one panel may leave in doubt
MARGIN = 4  # nodes of a periodic table repeated at either end, more than its interpolation looks


def from_formula(
    expression: str, speed: float, *, period: float = TURN, constants: Mapping[str, float] | None = None
) -> Cycle:
    """Diagram by a formula of ``theta`` [rad] on [0, period], at the mean speed ``speed`` [rad/s].

    The formula need not be periodic: the moment may jump from the end of the cycle to its beginning. What it may hold
    says `expression.parse`. Raises `UsageError` for a formula that cannot be read or has no finite value somewhere,
    and `AccuracyError` for one with a pole, or that changes too fast to be followed.

    >>> cycle = from_formula("100*abs(sin(theta))", speed=10)
    >>> round(float(cycle.panels.total(cycle.moment)), 9)
    400.0
    """
    _check(speed, period)
    formula = parse(expression, constants)
    breaks = formula.breaks(0.0, period)
    if len(breaks) > MOST:
        raise _too_fast(len(breaks), float(breaks[0]), period)
    return _resolved(lambda x: formula(x)[None], panels(0.0, period, breaks), speed)


def from_harmonics(
    constant: float, terms: Iterable[tuple[float, float, float]], speed: float, *, period: float = TURN
) -> Cycle:
    """Diagram M = constant + sum of a cos(k theta) + b sin(k theta) over the ``terms`` (k, a, b) [-, N*m, N*m].

    The order k must close in the period: a whole number, in a cycle of 4 pi also its halves. Raises `UsageError` if
    it does not.

    >>> cycle = from_harmonics(20e3, [(2, -5700, 9500)], speed=6 * math.pi)
    >>> cycle.panels.extremes(cycle.moment)[1][0] - 20e3 - math.hypot(5700, 9500) < 1e-8
    True
    """
    _check(speed, period)
    table = np.array(list(terms), float).reshape(-1, 3)
    k = table[:, 0]
    turns = k * period / TURN
    if np.any(np.abs(turns - np.round(turns)) > 1e-9 * np.maximum(1.0, np.abs(turns))):
        odd = float(k[np.argmax(np.abs(turns - np.round(turns)))])
        raise UsageError(
            f"the harmonic of order {odd:g} does not close in a cycle of {period:.6g} rad",
            where="torque diagram",
            value=odd,
            remedy="give whole orders, in the 4 pi cycle of a four-stroke engine multiples of 1/2",
        )

    def moment(x: Values) -> Values:
        found = np.full(x.shape, constant, float)
        for order, cosine, sine in table.tolist():  # one by one: all at once would take their number times the memory
            found += cosine * np.cos(order * x) + sine * np.sin(order * x)
        return found[None]

    return _resolved(moment, panels(0.0, period), speed)


def from_pieces(points: Sequence[tuple[float, float]], speed: float, *, period: float = TURN) -> Cycle:
    """Diagram of straight pieces through ``points`` (theta [rad], moment [N*m]) in ascending order.

    Two points at the same angle are a jump. The diagram is periodic: the last point and the first one of the next
    cycle are joined by a straight piece too. Raises `UsageError` for points out of order or outside [0, period].

    >>> cycle = from_pieces([(0, 300), (math.pi, 300), (math.pi, -100), (2 * math.pi, -100)], speed=10)
    >>> round(float(cycle.panels.total(cycle.moment)) / math.pi, 9)
    200.0
    """
    _check(speed, period)
    theta, moment = _columns(points, period)
    theta, moment = _closed(theta, moment, period)
    on = panels(0.0, period, theta)
    x = on.x.ravel()
    # Gauss points keep off the jumps, so the piece of a point is the one that begins at the last node before it
    k = np.clip(np.searchsorted(theta, x, side="right") - 1, 0, len(theta) - 2)
    share = (x - theta[k]) / (theta[k + 1] - theta[k])
    return _cycle(on, (moment[k] + share * (moment[k + 1] - moment[k])).reshape(on.x.shape), speed)


def from_table(
    theta: Sequence[float] | Values,
    moment: Sequence[float] | Values,
    speed: float,
    *,
    period: float = TURN,
    kind: str = "linear",
) -> Cycle:
    """Diagram through a periodic table: ``theta`` [rad] ascending in [0, period], ``moment`` [N*m], both (n,).

    ``kind`` "linear" joins the points by straight pieces (two points at one angle are a jump), "pchip" by monotone
    cubics (scipy's), periodic over the seam. Raises `UsageError` for an unfit table or an unknown kind.
    """
    if kind == "linear":
        return from_pieces(list(zip(theta, moment, strict=True)), speed, period=period)
    if kind != "pchip":
        raise UsageError(f"there is no interpolation {kind!r}", where="torque diagram", remedy="kinds: linear, pchip")
    _check(speed, period)
    x, y = _columns(list(zip(theta, moment, strict=True)), period)
    if len(x) > 1 and x[-1] - x[0] > period * (1 - 1e-12):
        x, y = _without_seam(x, y)
    if len(x) < 2 or np.any(np.diff(x) <= 0):
        raise UsageError(
            "the monotone cubic needs two points or more, each at its own angle",
            where="torque diagram",
            remedy='join points with jumps by kind="linear"',
        )
    from scipy.interpolate import PchipInterpolator

    copies = math.ceil(MARGIN / len(x))
    shifts = np.arange(-copies, copies + 1) * period
    curve = PchipInterpolator(np.add.outer(shifts, x).ravel(), np.tile(y, len(shifts)))
    on = panels(0.0, period, x)
    return _cycle(on, np.asarray(curve(on.x)), speed)


def _without_seam(x: Values, y: Values) -> tuple[Values, Values]:
    if abs(y[-1] - y[0]) > 1e-9 * float(np.max(np.abs(y))):
        raise UsageError(
            f"the table ends with {y[-1]:g} N*m and begins with {y[0]:g} N*m at the same position of the shaft",
            where="torque diagram",
            remedy='make the two equal, or keep the jump with kind="linear"',
        )
    return x[:-1], y[:-1]


def _columns(points: Sequence[tuple[float, float]], period: float) -> tuple[Values, Values]:
    table = np.array(points, float).reshape(-1, 2)
    theta, moment = table.T
    slack = 1e-12 * period
    if not len(theta) or not np.all(np.isfinite(table)):
        raise UsageError("a diagram needs finite points", where="torque diagram", remedy="give theta and moment pairs")
    if np.any(np.diff(theta) < 0) or theta[0] < -slack or theta[-1] > period + slack:
        raise UsageError(
            f"the angles must ascend from 0 to the period {period:.6g} rad; given {theta[0]:g} to {theta[-1]:g}",
            where="torque diagram",
            remedy="sort the points, give angles in radians, or set the period",
        )
    return np.clip(theta, 0.0, period), moment


def _closed(theta: Values, moment: Values, period: float) -> tuple[Values, Values]:
    """The points with both ends of the cycle among them, joined over the seam."""
    gap = theta[0] + period - theta[-1]
    seam = moment[-1] + (moment[0] - moment[-1]) * (period - theta[-1]) / gap if gap else moment[0]
    if theta[0] > 0:
        theta, moment = np.append(0.0, theta), np.append(seam, moment)
    if theta[-1] < period:
        theta, moment = np.append(theta, period), np.append(moment, seam)
    return theta, moment


def _check(speed: float, period: float) -> None:
    for name, value in (("mean speed", speed), ("period", period)):
        if not (math.isfinite(value) and value > 0):
            raise UsageError(
                f"the {name} is {value:g}, it must be above zero", where="torque diagram", value=value, limit=0.0
            )


def _resolved(f: Callable[[Values], Values], first: Panels, speed: float) -> Cycle:
    try:
        on, values, error = resolved(f, first)
    except UnresolvedError as fault:
        raise _too_fast(fault.turns, fault.at, float(first.edges[-1] - first.edges[0])) from None
    doubtful = on.tail(values[0]) * on.width
    work = float(on.total(np.abs(values[0])))
    if np.max(doubtful) > UNRESOLVED * work:
        at = float(on.edges[np.argmax(doubtful)])
        raise AccuracyError(
            f"the moment is not smooth enough to be integrated near theta = {at:.6g} rad ({math.degrees(at):.4g} deg)",
            where="torque diagram",
            value=float(np.max(doubtful)) / work,
            limit=UNRESOLVED,
            remedy="a torque diagram has no poles; limit the moment there",
        )
    return _cycle(on, values[0], speed, error)


def _too_fast(turns: int, at: float, period: float) -> AccuracyError:
    """The fault of a moment that turns more often than a cycle can be followed."""
    return AccuracyError(
        f"the moment changes its sense {turns} times or more in the cycle of {math.degrees(period):.6g} deg, most "
        f"densely near theta = {at:.6g} rad ({math.degrees(at):.4g} deg); {MOST} panels do not resolve it",
        where="torque diagram",
        value=turns,
        limit=MOST,
        remedy="lower the factors of theta: what changes so fast is no moment of a machine, its mean value serves",
    )


def _cycle(on: Panels, moment: Values, speed: float, error: float = 0.0) -> Cycle:
    nothing = np.zeros_like(moment)
    return Cycle(on, nothing, nothing, moment, nothing, nothing, speed, error)
