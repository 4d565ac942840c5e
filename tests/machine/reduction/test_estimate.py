"""The error estimate of a reduction against its true error in random scenes.

The truth is everything again with a mantissa of 64 bits, and works by Gauss's rule on panels that are halved until
they tell what they should; a crank-slider and a four-bar written out by hand in 40 digits confirm it.
"""

from __future__ import annotations

import math
from collections import defaultdict
from typing import Any

import mpmath as mp
import numpy as np
import pytest
from bounding import assert_bounds, part
from linkage.scenes import crank_slider, four_bar, full_turn, with_input

from machine.reduction.drawn import drawn, integrals, solved, wide
from tmmcalc import solve_kinematics
from tmmcalc.core.numerics.extended import WIDER
from tmmcalc.core.numerics.panels import Panels
from tmmcalc.core.numerics.simpson import simpson
from tmmcalc.core.plane import Real
from tmmcalc.linkage.loading import Body, Load, Loading, Spring
from tmmcalc.linkage.loadlaws.constant import Constant
from tmmcalc.linkage.loadlaws.quadratic import Quadratic
from tmmcalc.linkage.loadlaws.viscous import Viscous
from tmmcalc.machine.reduction.causes import Causes
from tmmcalc.machine.reduction.inertia import slope_size
from tmmcalc.machine.reduction.panels import SLIGHT
from tmmcalc.machine.reduction.results import Reduction
from tmmcalc.machine.reduction.solve import solve_reduction

pytestmark = pytest.mark.skipif(not WIDER, reason="no wider float here: the estimate has no reference")

Pairs = dict[str, list[tuple[float, float]]]
BETWEEN = 12  # random places of a panel: narrow ones hold the largest values and errors


def largest(values: Any) -> float:
    return float(np.max(np.abs(values), initial=0.0))


def compared(found: Reduction, causes: Causes, seed: int) -> dict[str, list[tuple[float, float]]]:
    """Estimate and true error of every column and scalar of a reduction, by the key that covers them."""
    travel, on = causes.scene.travel, found.cycle.panels
    rows = travel.rows(solve_kinematics(drawn(seed)[0]))[0]
    inner = (on.edges[:-1, None] + on.width[:, None] * np.random.default_rng(seed).random((on.count, BETWEEN))).ravel()
    at, between = wide(causes, rows, travel.sides(rows)), wide(causes, inner)
    powers = (abs(np.longdouble(travel.speed)) ** causes.orders)[:, None]
    exact, over = travel.sense * at.moments * powers, between.moments * powers
    steep = [slope_size(causes.scene.loading.heavy, causes.scene.place(x).configuration, len(x)) for x in (rows, inner)]
    inertia = max(largest(found.cycle.inertia), largest(at.inertia)) or 1.0
    slope = max(map(largest, steep)) or 1.0
    moment = (
        max(largest(found.parts), largest(exact), SLIGHT * float(np.max(causes.possible(rows), initial=0.0))) or 1.0
    )
    functions = [
        np.abs(on.at(found.cycle.inertia, inner) - between.inertia) / inertia,
        np.abs(on.at(found.cycle.slope, inner) - between.slope) / slope,
        *np.abs(on.at(found.parts, inner) - over) / moment,
    ]
    return {
        "inertia": [(found.error.inertia, largest(found.inertia - at.inertia) / inertia)],
        "slope": [(found.error.slope, largest(found.slope - travel.sense * at.slope) / slope)],
        "moment": [
            (found.error.moment, largest(found.moment - exact) / moment),
            (found.error.moment, by_simpson(found, causes, rows, exact) / moment),
            (found.error.moment, largest(found.total - exact.sum(axis=0)) / (moment * max(1, len(exact)))),
        ],
        "functions": [(found.error.functions, max(mean(each, on) for each in functions))],
        "between": [(found.error.between, max(largest(functions), *extremes(found, over, between.inertia, moment)))],
        "work": [(found.error.work, works(found, causes, powers))],
    }


def mean(values: Any, on: Panels) -> float:
    """Mean over the cycle of values at random places of every panel."""
    return float(np.mean(values.reshape(on.count, BETWEEN), axis=1) @ on.width / np.sum(on.width))


def extremes(found: Reduction, moments: Real, inertias: Real, moment: float) -> list[float]:
    """By how much values between the positions go beyond the extremes that are told."""
    low, high = found.inertia_range
    sense = math.copysign(1.0, found.speed)
    ranges = [(c.least.value, c.largest.value) for c in found.contributions]
    beyond = [
        max(float(np.max(sense * row)) - most, least - float(np.min(sense * row)))
        for row, (least, most) in zip(moments, ranges, strict=True)
    ]
    inertia = max(float(np.max(inertias)) - high.value, low.value - float(np.min(inertias)))
    return [*(max(each, 0.0) / moment for each in beyond), max(inertia, 0.0) / (high.value or 1.0)]


def works(found: Reduction, causes: Causes, powers: Real) -> float:
    """Largest error of a work against the largest of a magnitude."""
    if not found.contributions:
        return 0.0
    total, size = integrals(lambda x: wide(causes, x).moments * powers, found.cycle.panels.edges)
    return largest([c.work for c in found.contributions] - total) / (float(np.max(size)) or 1.0)


def by_simpson(found: Reduction, causes: Causes, rows: Real, exact: Real) -> float:
    """Largest error of a work by Simpson's rule over the rows, of a unit of theta."""
    errors = [0.0]
    for contribution, row in zip(found.contributions, exact * causes.scene.travel.sense, strict=True):
        if contribution.simpson is not None:
            truth = simpson(rows.astype(np.longdouble), row)
            assert truth is not None
            errors.append(abs(contribution.simpson - float(truth)) / float(rows[-1] - rows[0]))
    return max(errors)


def pairs(seeds: range) -> tuple[Pairs, int]:
    """Estimates and true errors by key, and how many scenes were refused."""
    found: Pairs = defaultdict(list)
    refused = 0
    for seed in seeds:
        scene = solved(seed)
        if scene is None:
            refused += 1
            continue
        for key, values in compared(*scene, seed).items():
            found[key] += values
    return found, refused


def check(seeds: range, scenes: int) -> None:
    found, refused = pairs(seeds)
    assert refused < 0.3 * len(seeds)
    for key, values in found.items():
        assert_bounds(values, key, scenes=scenes)


def test_estimates_of_some_reductions() -> None:
    check(range(1000, 1005), 3)


@pytest.mark.parametrize("seed", [17, 302, 397])
def test_kinks_that_lie_nearly_at_one_place(seed: int) -> None:
    scene = solved(seed)
    assert scene is not None
    for key, values in compared(*scene, seed).items():
        assert all(error <= estimate for estimate, error in values), key


@pytest.mark.slow
def test_estimates_of_many_reductions() -> None:
    check(range(part(300, 4)), part(200, 4))


LOADS = (
    Load("push", 3, "force", Constant(30.0), 0j, 1 + 0j),
    Load("drag", 3, "force", Viscous(12.0), 0j, 1 + 0j),
    Load("air", 2, "moment", Quadratic(0.03)),
)


def motion(kind: str, x: Any) -> tuple[Any, Any, Any]:
    """Angle of the coupler, place of its centre of mass, of the point that the loads push, in mpmath."""
    l1, l2, l3, e = (mp.mpf(v) for v in (0.1, 0.23, 0.2, 0.017))
    a = l1 * mp.expj(x)
    q = mp.asin((e - a.imag) / l2)
    if kind == "four-bar":
        d = mp.mpf(0.25) - a
        q = mp.arg(d) + mp.acos((abs(d) ** 2 + l2**2 - l3**2) / (2 * l2 * abs(d)))
    return q, a + mp.mpc(0.07, 0.02) * mp.expj(q), a + l2 * mp.expj(q)


def by_hand(kind: str, x: Any, speed: Any) -> tuple[Any, Any, list[Any]]:
    """J, dJ and the moments of weights, loads and spring of a linkage at the crank angle x, in mpmath."""
    slides = kind == "slider"

    def rates(t: Any) -> list[Any]:
        return [mp.diff(lambda u, k=k: motion(kind, u)[k], t) for k in range(3)]

    def inertia(t: Any) -> Any:
        dq, ds, db = rates(t)
        return 2 * abs(ds) ** 2 + mp.mpf(0.01) * dq**2 + (3 * abs(db) ** 2 if slides else 0)

    dq, ds, db = rates(x)
    away = mp.mpc(0.4, 0.5) - motion(kind, x)[2]
    pull = 90 * (abs(away) - mp.mpf(0.3)) * (mp.conj(away) * db).real / abs(away)
    weight = -mp.mpf(9.81) * (2 * ds.imag + (3 * db.imag if slides else 0))
    moments = [weight, 30 * db.real, -12 * db.real**2 * speed, -mp.mpf(0.03) * abs(dq) ** 3 * speed**2, pull]
    return inertia(x), mp.diff(inertia, x), moments


@pytest.mark.parametrize("kind", ["slider", pytest.param("four-bar", marks=pytest.mark.slow)])
def test_estimates_against_formulas_by_hand(kind: str) -> None:
    base = crank_slider(0.1, 0.23, 0.017) if kind == "slider" else four_bar(0.1, 0.23, 0.2, 0.25)
    mechanism = with_input(full_turn(base, 0.3, 6), speed=4.0, acceleration=0.0)
    heavy = (Body(2, 2.0, 0.01, 0.07 + 0.02j), *((Body(3, 3.0, 0.0, 0j),) if kind == "slider" else ()))
    at = 0j if kind == "slider" else 0.2 + 0j
    loads = tuple(Load(q.name, q.link, q.kind, q.law, at if q.link == 3 else 0j) for q in LOADS)
    spring = Spring("spring", "linear", (3, 0), (at, 0.4 + 0.5j), 90.0, 0.3)
    found = solve_reduction(mechanism, Loading(heavy, -9.81j, loads, (spring,)), solve_kinematics(mechanism))
    with mp.workdps(40):
        exact = [by_hand(kind, mp.mpf(0.3) + mp.mpf(float(phi)), mp.mpf(4)) for phi in found.phi]
        inertia, slope, moments = (np.array([row[k] for row in exact]) for k in range(3))
        square = mp.quad(lambda t: mp.diff(lambda u: motion(kind, u)[2], t).real ** 2, mp.linspace(0, 2 * mp.pi, 5))
    columns = ((found.inertia, inertia, found.error.inertia), (found.slope, slope, found.error.slope))
    for told, truth, error in (*columns, (found.moment, moments.T, found.error.moment)):
        assert largest((told - truth).astype(float)) <= error * largest(truth.astype(float))
    assert abs(found.contributions[2].work / (-48 * square) - 1) <= found.error.work
