"""A torque diagram from a formula, from harmonics, from straight pieces or from a table; an inertia from a table."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping, Sequence

import numpy as np

from tmmcalc.core.errors import AccuracyError, UsageError
from tmmcalc.core.expression import parse
from tmmcalc.core.numerics.panels import MOST, Panels, UnresolvedError, Values, panels, resolved
from tmmcalc.machine.cycle import Cycle
from tmmcalc.machine.diagram.curves import WHERE, curve

TURN = 2 * math.pi
UNRESOLVED = 1e-6  # share of the work of the cycle that one panel may leave in doubt
SAME = 1e-9  # part of the largest inertia by which both sides of an angle may differ
ROUNDED = 1e-12  # part of the largest inertia below zero that is rounding


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
            where=WHERE,
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
    theta, moment = np.array(points, float).reshape(-1, 2).T
    on, values, _ = curve(theta, moment, period, "linear", "N*m")
    return _cycle(on, values, speed)


def from_table(
    theta: Sequence[float] | Values,
    moment: Sequence[float] | Values,
    speed: float,
    *,
    period: float = TURN,
    kind: str = "linear",
) -> Cycle:
    """Diagram through a periodic table: ``theta`` [rad] ascending in [0, period], ``moment`` [N*m], both (n,).

    What joins the points, ``kind``, tells `curves.curve`. Raises `UsageError` for an unfit table or an unknown kind.
    """
    _check(speed, period)
    on, values, _ = curve(np.asarray(theta, float), np.asarray(moment, float), period, kind, "N*m")
    return _cycle(on, values, speed)


def from_inertia(
    theta: Sequence[float] | Values,
    inertia: Sequence[float] | Values,
    speed: float,
    *,
    period: float = TURN,
    kind: str = "spline",
) -> Cycle:
    """Shaft without a moment whose reduced inertia is a periodic table: J [kg*m^2] at ``theta`` [rad], both (n,).

    Its slope dJ/dtheta is that of the same curve, so that kinetic energy is kept. Raises `UsageError` for an unfit
    table, such as one with jumps, and where the curve between the points falls below zero.

    >>> at = np.arange(24) * TURN / 24
    >>> cycle = from_inertia(at, 2 + np.cos(at), speed=10)
    >>> float(round(cycle.panels.extremes(cycle.slope)[1][0], 3))
    1.0
    """
    _check(speed, period)
    on, values, slope = curve(np.asarray(theta, float), np.asarray(inertia, float), period, kind, "kg*m^2")
    low, high = on.ends(values)
    jump = np.abs(np.append(low[1:], low[0]) - high)
    (least, at), (largest, _) = on.extremes(values)
    if np.max(jump) > SAME * largest:
        at = float(on.edges[1 + np.argmax(jump)])
        raise UsageError(
            f"the reduced inertia jumps by {np.max(jump):.4g} kg*m^2 at {math.degrees(at):.4g} deg",
            where=WHERE,
            value=float(np.max(jump)),
            remedy="give one inertia at each angle, and the same at both ends of the period",
        )
    if least < -ROUNDED * largest:
        raise UsageError(
            f"the reduced inertia falls to {least:.4g} kg*m^2 at {math.degrees(at):.4g} deg, between its points",
            where=WHERE,
            value=least,
            limit=0.0,
            remedy='give more points there, or interpolation = "linear" or "pchip", which stay between the points',
        )
    nothing = np.zeros_like(values)
    return Cycle(on, np.maximum(values, 0.0), slope, nothing, nothing, nothing, speed)


def _check(speed: float, period: float) -> None:
    for name, value in (("mean speed", speed), ("period", period)):
        if not (math.isfinite(value) and value > 0):
            raise UsageError(f"the {name} is {value:g}, it must be above zero", where=WHERE, value=value, limit=0.0)


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
            where=WHERE,
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
        where=WHERE,
        value=turns,
        limit=MOST,
        remedy="lower the factors of theta: what changes so fast is no moment of a machine, its mean value serves",
    )


def _cycle(on: Panels, moment: Values, speed: float, error: float = 0.0) -> Cycle:
    nothing = np.zeros_like(moment)
    return Cycle(on, nothing, nothing, moment, nothing, nothing, speed, error)
