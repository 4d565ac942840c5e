"""Error estimate of a reduction: rounding by extended precision, what panels leave out by their coefficients.

The formulas are exact, so that at a position there is rounding alone. It is measured: some rows, the least regular ones
among them, and points of every panel are computed again with a mantissa of 64 bits. Where the platform has no wider
float the errors of the kinematics stand for it. What the last digit of the metric does near a dead point is found at
the same places.

Work is an integral by Gauss's rule, exact to twice the degree of a panel. The coefficients of a smooth function fall by
as much from one half of that degree to the next; near a kink they do not fall, and the last ones stand for the rest.
A kink that lies beside its edge shows in neither: there the polynomials of both sides miss each other.
"""

from __future__ import annotations

from dataclasses import replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.numerics.extended import EPS, WIDER
from tmmcalc.core.numerics.gauss import ORDER, rule
from tmmcalc.core.numerics.mesh import SLIVER
from tmmcalc.core.numerics.panels import Panels
from tmmcalc.core.plane import Real
from tmmcalc.linkage.chain import Chain
from tmmcalc.linkage.errors import MARGIN, centre_of, chosen_of
from tmmcalc.linkage.lastdigit import against, effects, in_full
from tmmcalc.linkage.loads.sources import Place
from tmmcalc.linkage.results import ErrorEstimate, Kinematics
from tmmcalc.machine.reduction.causes import Causes, Sample
from tmmcalc.machine.reduction.inertia import slope_size
from tmmcalc.machine.reduction.results import ReductionDigit, ReductionError

POINTS = 2  # of a panel that are computed again
FEW = 2.0  # of a mean over so few
SOME = slice(ORDER // 4, ORDER, ORDER // POINTS)
MEAN = (2 * ORDER + 1) ** -0.5  # root mean square of the first Legendre polynomial that is left out, at most
LAST = 3  # coefficients that are taken together: every other one of an even function is nothing
SUMMED = 6 * EPS  # rounding of weights, widths and sums
FALL = 1 / 300  # of coefficients from the half to the last: of a smooth function they fall by more, near a kink not
SCATTER = 3.0  # standard deviations of the sum of roundings that differ from point to point


class Solved(NamedTuple):
    """What the program has found: at the rows, and on the panels."""

    theta: Real  # (n,) of the rows
    side: Real
    nodes: Sample  # at the rows
    dense: Panels
    values: Real  # (3 + S, K, N): J, dJ, moment of idle friction, all moments
    tail: float  # of the panels


class Again(NamedTuple):
    """What is computed again: some rows, and points of every panel after them."""

    rows: NDArray[np.intp]
    theta: Real  # (m,) of the rows and of the points
    side: Real


def unmeasured(tail: float, kinematics: ErrorEstimate) -> ReductionError:
    """The errors where nothing is computed again: those of the kinematics, and the last coefficients of the panels."""
    far = MARGIN * max(kinematics.velocity, kinematics.acceleration)
    return ReductionError(far, far, far, max(tail, far), max(tail, far), max(tail, far))


def estimate(causes: Causes, found: Solved, scale: float, kinematics: Kinematics) -> tuple[ReductionError, Real]:
    """The errors of a reduction, those of moments against ``scale`` [N*m]; those of the works (S,) [J]."""
    # a scale alone: across a change of sign the rule is good enough for it, and far cheaper than `signs.turnovers`
    turnover = found.dense.total(np.abs(found.values[3:])) * causes.powers
    on, count = found.dense, len(found.values) - 3
    again, digit = _again(causes, found), None
    if kinematics.error.last_digit is not None:
        centre = centre_of(causes.scene.chain, kinematics)
        digit = _last_digit(causes, again, scale, (on.width, float(np.max(turnover, initial=0.0))), centre)
    if not WIDER:
        error = replace(unmeasured(found.tail, kinematics.error), last_digit=digit)
        return error, error.work * turnover
    off, steep, inertia = _measured(causes, found, again)
    sizes = np.array([inertia, steep, *[scale] * (1 + count)])
    sizes = np.where(sizes > 0, sizes, 1.0)[:, None]
    worst = np.maximum(MARGIN * np.max(np.abs(off) / sizes, axis=1), EPS)
    inner = off[:, -on.count * POINTS :].reshape(len(off), on.count, POINTS)
    values = found.values * np.concatenate((np.ones(3), causes.powers))[:, None, None]
    missed, turned = on.left_out(values) / sizes, FEW * np.abs(inner).mean(axis=2) / sizes
    gaps, areas = _at_kinks(on, values)
    mean = np.max((turned + MEAN * missed) @ on.width + areas / sizes[:, 0]) / causes.scene.travel.period
    works = SUMMED * turnover + _work(on, values[3:], inner[3:]) + areas[3:]
    error = ReductionError(
        inertia=float(worst[0]),
        slope=float(worst[1]),
        moment=float(np.max(worst[2:])),
        functions=EPS + float(mean),
        between=float(np.max(worst) + max(np.max(missed), np.max(gaps / sizes[:, 0]))),
        work=max(float(np.max(works, initial=0.0) / (np.max(turnover, initial=0.0) or 1.0)), EPS),
        last_digit=digit,
    )
    return error, works


def _last_digit(
    causes: Causes, again: Again, scale: float, cycle: tuple[Real, float], centre: float | None
) -> ReductionDigit:
    """What the last digit of the metric does at the same places, moments against ``scale`` [N*m].

    ``cycle`` are the widths of the panels and the largest turnover [J].
    """
    theta, side = again.theta, again.side

    def functions(of: Chain, x: Real) -> tuple[Real, Real, Real]:
        configuration = of.evaluate(x)
        own = causes.on(of).at(Place(theta, configuration, side), side).rows
        return own[0], own[1], own[2:]

    chain, x = causes.scene.chain, causes.scene.travel.x(theta)
    inertia, slope, moments = effects(chain, x, functions, centre)
    steep = slope_size(causes.scene.loading.heavy, chain.evaluate(x), len(x))
    widths, turnover = cycle
    moments[1:] *= causes.powers[:, None]
    inner = moments[:, -POINTS * len(widths) :].reshape(len(moments), len(widths), POINTS)
    return ReductionDigit(
        against(inertia, float(np.max(functions(chain, x)[0]))),
        against(slope, float(np.max(steep))),
        against(moments, scale),
        against(inner[1:].mean(axis=2) @ widths, turnover),
    )


def _again(causes: Causes, found: Solved) -> Again:
    """The least regular of the rows and an even spread, and points of every panel."""
    rows = chosen_of(causes.scene.chain, causes.scene.travel.x(found.theta), ())
    points = _points(found.dense).ravel()
    theta = np.concatenate((found.theta[rows], points))
    return Again(rows, theta, np.concatenate((found.side[rows], np.ones(len(points)))))


def _measured(causes: Causes, found: Solved, again: Again) -> tuple[Real, float, float]:
    """Rounding of all functions (3 + S, m) at these places, largest parts of dJ, largest J."""
    exact = causes.on(in_full(causes.scene.chain))
    inner = found.values[:, :, SOME].reshape(len(found.values), -1)
    place = exact.scene.place(again.theta, again.side)
    wide = exact.at(place, again.side, lambda at: exact.scene.travel.named(again.theta[at])).rows
    off = np.asarray(np.concatenate((found.nodes.rows[:, again.rows], inner), axis=1) - wide, float)
    off[3:] *= causes.powers[:, None]
    steep = slope_size(causes.scene.loading.heavy, place.configuration, len(again.theta))
    return off, float(np.max(steep)), float(np.max(wide[0]))


def _points(on: Panels) -> Real:
    """Some points of every panel (K, P), to all digits of extended precision: where Gauss's rule means them to be."""
    low, high = on.edges[:-1, None].astype(np.longdouble), on.edges[1:, None]
    return np.asarray(low + (high - low) * rule(on.order).points[SOME])


def _work(on: Panels, parts: Real, off: Real) -> Real:
    """Errors (S,) of the works of moments (S, K, N) with roundings (S, K, P) at points of the panels."""
    each = off * on.width[:, None] / POINTS
    rounding = np.abs(each.sum(axis=(1, 2))) + SCATTER * np.sqrt((each**2).sum(axis=(1, 2)))
    return np.asarray(rounding + _higher_orders(parts) @ on.width)


def _at_kinks(on: Panels, values: Real) -> tuple[Real, Real]:
    """What functions (F, K, N) miss by kinks beside their edges: the largest of a value (F,), the integral (F,).

    The slope changes by D; at d from the edge the polynomials differ by D d, and their triangle is missed. What is
    more than a kink within a sliver is a jump, whose place is known.
    """
    limits, slopes = on.ends(values), on.ends(on.slope(values))
    gap, bend = (np.abs(low[:, 1:] - high[:, :-1]) for low, high in (limits, slopes))
    near = gap <= bend * SLIVER * (on.edges[-1] - on.edges[0])
    gap, bend = np.where(near, gap, 0.0), np.where(near & (bend > 0), bend, 1.0)
    return np.max(gap, axis=1, initial=0.0), np.asarray((gap**2 / (2 * bend)).sum(axis=1))


def _higher_orders(parts: Real) -> Real:
    """What lies beyond twice the degree of every panel (S, K), by the fall of coefficients of functions (S, K, N).

    Gauss's rule misses nothing before that, so that the fall counts twice and nothing is summed: `Panels.left_out` sums
    all from the last coefficient on, for a value.
    """
    c = np.abs(parts @ rule(ORDER).coefficients.T)
    half, last = (np.max(c[..., at - LAST : at], axis=-1) for at in (ORDER // 2, ORDER))
    return np.asarray(last * np.minimum(last / np.where(half > 0, FALL * half, 1.0), 1.0) ** 2)
