"""Reliability of a rotating product whose strength x(t) = r e^(-beta t) falls while shock loads strike it.

Loads are uniform on [a, b], shocks come at a constant rate h. A shock stronger than x is a failure: its intensity is 0
while x > b, h (b - x)/(b - a) on [a, b], h below a. Times are in any unit, rates in one over it; loads in any unit too.
"""

from __future__ import annotations

from collections.abc import Callable
from math import exp, lgamma, log, pi, sqrt

import numpy as np

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.notes import Said, held
from tmmcalc.core.numerics.extended import EPS, MARGIN, apart, spread, widened
from tmmcalc.core.numerics.panels import Values, panels, resolved
from tmmcalc.core.quantity import quantity
from tmmcalc.core.records import record

LOOKED = 24  # times at which the reliability is computed again
FORGOTTEN = 1e-17  # reliability behind which nothing adds to the mean life
RESOLVED = 1e-13
HALVED = 12  # times that the first panel of the integral over it is halved
STIRLING = 50.0  # from here the gamma function is that of Stirling's series
STEP = 1e-5  # of ln(beta), for the slope of the mean life
SLOWEST, SCAN = 1e-12, 400  # of the search for beta: its lowest value over the highest, its steps
LARGEST = 700.0  # exponent of a number
LEFT = 1e-3  # reliability at the end of the table
PARTS = (0.9, 0.5, 0.1)  # reliabilities whose lives are told


@record
class LifeTest:
    """What a test of items tells: from it beta and r are estimated."""

    items: int  # m
    least: float  # t_(1), shortest life
    mean: float  # mean life


@record
class ReliabilityTask:
    """Loads, shocks, and the strength or the test that it is estimated from."""

    low: float  # a
    high: float  # b
    rate: float  # h
    strength: float | None = None  # r
    decay: float | None = None  # beta
    test: LifeTest | None = None
    times: tuple[float, ...] = ()  # at which the reliability is asked for
    until: float | None = None  # end of the table
    rows: int = 100


@record
class LifeError:
    """Relative errors: of reliability and lives for the strength and decay as they are."""

    reliability: float
    lives: float
    mean: float
    decay: float  # 0 if it is given


@record
class Reliability:
    """Reliability over the time."""

    strength: float = quantity("r", "strength at the beginning")
    decay: float = quantity("beta", "decay of the strength")
    low: float = quantity("a", "least load")
    high: float = quantity("b", "largest load")
    threshold: float = quantity(  # 0 if the strength begins below b
        "t0", "time ln(r/b)/beta up to which nothing fails", symbol="t_0"
    )
    floor: float | None = quantity("t_a", "time from which every shock is a failure")  # None: never
    mean: float = quantity("mean_life", "mean life")
    lives: tuple[tuple[float, float], ...]  # reliability, life that it is kept for
    asked: tuple[tuple[float, float], ...]  # time, reliability
    labels: tuple[str, ...]
    t: Values = quantity("t[-]", "time in the unit of the spec")  # (n,)
    kept: Values = quantity("R[-]", "reliability")  # (n,)
    density: Values = quantity("f[-]", "density of the life")  # (n,)
    intensity: Values = quantity("intensity[-]", "intensity of failures")  # (n,)
    x: Values = quantity("x[-]", "strength")  # (n,)
    notes: tuple[Said, ...] = ()
    error: LifeError | None = None  # None: not estimated


def load_range(readings: tuple[float, ...]) -> tuple[float, float]:
    """Estimates a* and b* of a uniform load from n readings.

    >>> load_range((2.0, 3.0, 2.5))
    (1.5, 3.5)
    """
    n, least, largest = len(readings), min(readings), max(readings)
    return (n * least - largest) / (n - 1), (n * largest - least) / (n - 1)


def solve_reliability(task: ReliabilityTask) -> Reliability:
    """Strength and decay, the reliability over the time, mean life and lives at given reliabilities.

    Raises `NoSolutionError` if no decay gives the mean life of the test.
    """
    r, beta, missed = _estimated(task)
    law = Law(task.low, task.high, task.rate, r, beta)
    lives = tuple((part, life_at(law, part)) for part in PARTS)
    end = task.until if task.until is not None else life_at(law, LEFT)
    t = end * np.arange(task.rows + 1) / task.rows
    kept, intensity = np.exp(-hazard(law, t)), failure_rate(law, t)
    start, floor = span(law)
    mean = mean_life(law)
    return Reliability(
        strength=r,
        decay=beta,
        low=task.low,
        high=task.high,
        threshold=float(start),
        floor=None if floor is None else float(floor),
        mean=mean,
        lives=lives,
        asked=tuple((each, float(np.exp(-hazard(law, np.array([each]))[0]))) for each in task.times),
        labels=tuple(map(str, range(len(t)))),
        t=t,
        kept=kept,
        density=kept * intensity,
        intensity=intensity,
        x=strength_at(law, t),
        notes=_notes(task, r),
        error=LifeError(
            reliability=_of_reliability(law, t, kept),
            lives=max(_of_life(law, *life) for life in lives),
            mean=_of_mean(law, mean),
            decay=missed,
        ),
    )


@record
class Law:
    """What the reliability follows from: a, b, h, r, beta."""

    low: float
    high: float
    rate: float
    strength: float
    decay: float


def span(law: Law) -> tuple[float, float | None]:
    """Times at which the strength reaches b and a, at least 0; None: it never reaches a."""
    start = max(np.log(law.strength / law.high) / law.decay, 0.0)
    return start, max(np.log(law.strength / law.low) / law.decay, 0.0) if law.low > 0 else None


def strength_at(law: Law, t: Values) -> Values:
    """x (n,) at the times (n,)."""
    return np.asarray(law.strength * np.exp(-law.decay * t))


def failure_rate(law: Law, t: Values) -> Values:
    """Intensity of failures (n,) at the times (n,)."""
    x = strength_at(law, t)
    return np.asarray(law.rate * np.clip((law.high - x) / (law.high - law.low), 0.0, 1.0))


def hazard(law: Law, t: Values) -> Values:
    """-ln R (n,) at the times (n,): the integral of the intensity from 0, (5) with both ends of the load."""
    start, floor = span(law)
    inside = np.maximum(t if floor is None else np.minimum(t, floor), start)
    beyond = np.zeros_like(t) if floor is None else law.rate * np.maximum(t - floor, 0.0)
    x = law.strength * np.exp(-law.decay * start)
    tau = inside - start
    fallen = x * (law.decay * tau + np.expm1(-law.decay * tau)) / law.decay
    return np.asarray(law.rate / (law.high - law.low) * ((law.high - x) * tau + fallen) + beyond)


def mean_life(law: Law) -> float:
    """The mean life (8) in closed form: t0 + I/beta + R(ta)/h, the last term if the strength falls below a."""
    start, floor = span(law)
    after = 0.0 if floor is None else float(np.exp(-hazard(law, np.array([floor]))[0])) / law.rate
    return start + falling_part(law) / law.decay + after


def falling_part(law: Law) -> float:
    """I, the integral of the reliability over beta t from t0 to ta, with lower incomplete gamma functions.

    With c = h b/((b - a) beta) and u = x/b: e^(c u0) (c u0)^-c [gamma(c, c u0) - gamma(c, c ua)].
    """
    from scipy.special import gammainc

    c = law.rate * law.high / ((law.high - law.low) * law.decay)
    begun = min(law.strength / law.high, 1.0)
    if begun <= law.low / law.high:
        return 0.0
    shift = c * (begun - 1 - log(begun))  # -ln R from x = b to the beginning
    return float(gammainc(c, c * begun) - gammainc(c, c * law.low / law.high)) * exp(_gamma_exponent(c) + shift)


def _gamma_exponent(c: float) -> float:
    """ln of e^c c^-c Gamma(c), without the cancellation of large terms.

    >>> abs(_gamma_exponent(STIRLING) - (STIRLING + lgamma(STIRLING) - STIRLING * log(STIRLING))) < 1e-13
    True
    """
    if c < STIRLING:
        return c + lgamma(c) - c * log(c)
    part = 1 / c
    return 0.5 * log(2 * pi * part) + part / 12 - part**3 / 360 + part**5 / 1260


def life_at(law: Law, part: float) -> float:
    """The time at which the reliability is ``part``."""
    wanted = -log(part)
    return _root(lambda t: float(hazard(law, np.array([t]))[0]) - wanted, *_around(law, wanted))


def _of_reliability(law: Law, t: Values, kept: Values) -> float:
    """Error of the reliability at some of the times again in extended precision, twice that for the others."""
    rows = spread(len(t), LOOKED)
    return 2 * apart(kept[rows], np.exp(-hazard(widened(law), t[rows].astype(np.longdouble))))


def _of_life(law: Law, part: float, life: float) -> float:
    """Residual over slope, both in extended precision."""
    wide, at = widened(law), np.array([life], np.longdouble)
    missed = hazard(wide, at) + np.log(np.longdouble(part))
    slope = failure_rate(wide, at)
    return MARGIN * float(np.max(np.abs(missed) / (slope * at), initial=0.0)) + EPS if slope[0] > 0 else EPS


def _of_mean(law: Law, mean: float) -> float:
    """Against the integral of the reliability by Gauss's rule on panels, which has the error of the reliability."""
    start, floor = span(law)
    end = life_at(law, FORGOTTEN)
    edges = [edge for edge in (start, floor) if edge is not None and 0 < edge < end]
    edges += [start + (end - start) / 2**k for k in range(1, HALVED)]
    on, values, _ = resolved(
        lambda t: np.exp(-hazard(law, t))[None], panels(0.0, end, sorted(edges), end / 8), RESOLVED
    )
    missed = abs(float(on.total(values)[0]) - mean) / mean
    own = _of_reliability(law, on.x.ravel(), values[0].ravel())
    return MARGIN * (missed + own) + FORGOTTEN


def _around(law: Law, wanted: float) -> tuple[float, float]:
    start, _ = span(law)
    step = max(wanted / law.rate, 4 * float(np.spacing(start)))  # a shorter one would not move
    while hazard(law, np.array([start + step]))[0] < wanted:
        step *= 2
    return start, start + step


def _estimated(task: ReliabilityTask) -> tuple[float, float, float]:
    """r, beta and its relative error, given or from the test.

    The shortest life of a test is the mode of its distribution (10), the mean is (8).
    """
    if task.test is None:
        assert task.strength is not None
        assert task.decay is not None
        return task.strength, task.decay, 0.0
    test, width = task.test, task.high - task.low

    def strength(beta: float) -> float:
        half = load_margin(task, test, beta)
        root = sqrt(half * (2 * task.high + half))
        return exp(beta * test.least) * (task.high - 2 * task.high * half / (half + root))  # b + half - root

    def excess(log_beta: float) -> float:
        beta = exp(log_beta)
        return mean_life(Law(task.low, task.high, task.rate, strength(beta), beta)) - test.mean

    # beyond it the strength at the beginning, or its quotient with a load, would overflow
    wide = max(log(task.high), log(task.high / task.low) if task.low > 0 else 0.0, 0.0)
    fastest = min((LARGEST - wide) / test.least, task.rate * test.items * width / task.low if task.low > 0 else np.inf)
    grid = np.linspace(log(SLOWEST * fastest), log(fastest), SCAN + 1)
    found = np.array([excess(float(each)) for each in grid])
    change = np.flatnonzero(np.signbit(found[1:]) != np.signbit(found[:-1]))
    if not len(change):
        raise NoSolutionError(
            f"no decay of the strength gives a mean life of {test.mean:.6g}: with a shortest life of {test.least:.6g} "
            f"it is between {test.mean + found.min():.6g} and {test.mean + found.max():.6g}",
            where="reliability",
            value=test.mean,
            limit=float(test.mean + found.min()),
            remedy="look at the lives, at their unit of time and at that of the rate",
        )
    k = int(change[-1])
    root = _root(excess, float(grid[k]), float(grid[k + 1]))
    beta = exp(root)
    slope = (excess(root + STEP) - excess(root - STEP)) / (2 * STEP)
    law = Law(task.low, task.high, task.rate, strength(beta), beta)
    missed = (abs(excess(root)) + _of_mean(law, test.mean + excess(root)) * test.mean) / abs(slope)
    return law.strength, beta, missed + EPS * abs(root)


def load_margin(task: ReliabilityTask, test: LifeTest, decay: float) -> float:
    """w = beta (b - a)/(2 h m), by which the most probable strength at the shortest life is below b."""
    return decay * (task.high - task.low) / (2 * task.rate * test.items)


def _root(f: Callable[[float], float], low: float, high: float) -> float:
    from scipy.optimize import brentq

    return float(brentq(f, low, high, xtol=1e-300, rtol=4 * np.finfo(float).eps))


def _notes(task: ReliabilityTask, r: float) -> tuple[Said, ...]:
    if r < task.high:
        text = "the strength begins at {value:.6g}, below the largest load {limit:.6g}: no life is certain"
        return (held("warning", text, r, task.high, name="r"),)
    return ()
