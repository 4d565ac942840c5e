"""The error estimate of an unsteady motion against its true error in random linkages, near dead points too.

The truth: the law written out once more and the transfer functions, both in extended precision.
"""

from __future__ import annotations

from collections import defaultdict
from typing import Any

import numpy as np
import pytest
from bounding import assert_bounds, part
from machine.reduction.drawn import drawn

from tmmcalc import Kinematics, TmmError, Unsteady, solve_kinematics
from tmmcalc.core.numerics.extended import WIDER
from tmmcalc.linkage.chain import Chain, chain_of
from tmmcalc.linkage.trace import trace
from tmmcalc.linkage.unsteady.solve import solve_unsteady
from tmmcalc.linkage.unsteady.task import UnsteadyTask

pytestmark = pytest.mark.skipif(not WIDER, reason="no wider float here: the estimate has no reference")

Array = np.ndarray[Any, Any]
Pairs = dict[str, list[tuple[float, float]]]
KINDS = ("position", "velocity", "acceleration")
INSTANTS = 400  # of a motion at which extremes are looked for


def solved(seed: int) -> tuple[Unsteady, Chain] | None:
    """A drawn mechanism whose input goes a part of its way at drawn limits; None if it is refused."""
    rng = np.random.default_rng(seed)
    try:
        kinematics: Kinematics = solve_kinematics(drawn(seed)[0])
        way = float((kinematics.x[-1] - kinematics.x[0]) * rng.uniform(0.1, 0.9))
        limit = float(10 ** rng.uniform(-2, 3))
        speed = float(np.sqrt(limit * abs(way)) * 10 ** rng.uniform(-1, 1))
        task = UnsteadyTask(acceleration=limit, speed=speed, travel=way)
        return solve_unsteady(drawn(seed)[0], task, kinematics), chain_of(drawn(seed)[0], kinematics)
    except TmmError:
        return None


def law(result: Unsteady, t: Array, side: Array) -> tuple[Array, Array, Array]:
    """Coordinate, speed and acceleration at t (n,), each from its side, in extended precision."""
    given, wide = result.law, np.longdouble
    way, limit = abs(wide(given.travel)), wide(given.acceleration)
    peak = min(wide(given.speed), np.sqrt(limit * way))
    ramp = peak / limit
    whole = way / peak + ramp
    early, middle = np.minimum(t, whole - t), np.abs(t - whole / 2) <= 1e-12 * whole
    late = np.where(middle, side > 0, t > whole / 2)
    outer = (early < ramp * (1 - 1e-12)) | ((np.abs(early - ramp) <= 1e-12 * ramp) & ((side < 0) != late))
    s = np.where(early < ramp, limit * early**2 / 2, peak * (early - ramp / 2))
    v = np.where(early < ramp, limit * early, peak)
    a = np.where(outer, np.where(late, -limit, limit), 0)
    sense = np.sign(wide(given.travel))
    return wide(result.start) + sense * np.where(late, way - s, s), sense * v, sense * a


def largest(values: Array) -> float:
    return float(np.max(np.abs(values), initial=0.0))


def compared(result: Unsteady, chain: Chain) -> Pairs:
    """Estimates and true errors of the columns and the extremes of a motion, by key."""
    x, v, a = law(result, result.t.astype(np.longdouble), result.side)
    at, told = trace(chain, x), result.trace
    turns = at.ddangle * v**2 + at.dangle * a
    columns = {
        "position": [(result.drive[0], x), (told.r, at.r), (told.s, at.s)],
        "velocity": [(result.drive[1], v), (told.dr, at.dr * v), (told.dangle, at.dangle * v), (told.ds, at.ds * v)],
        "acceleration": [
            (result.drive[2], a),
            (told.ddr, at.ddr * v**2 + at.dr * a),
            (told.ddangle, turns),
            (told.dds, at.dds * v**2 + at.ds * a),
        ],
    }
    pairs: Pairs = {}
    for kind, values in columns.items():
        errors = [largest(f - e) / largest(e) for f, e in values if largest(e) > 0]
        errors += [extremes(result, chain)] if kind == "velocity" else []
        pairs[kind] = [(getattr(result.error, kind), max(errors))]
    return pairs


def extremes(result: Unsteady, chain: Chain) -> float:
    """By how much speeds of points go beyond the extremes that are told."""
    t = np.linspace(0, result.law.duration, INSTANTS)[1:-1].astype(np.longdouble)
    x, v, _ = law(result, t, np.ones(len(t)))
    speeds = np.abs(trace(chain, x).dr * v)
    told = [e for e in result.extremes if e.name.startswith("speed_")]
    assert len(told) == len(speeds)
    beyond = [
        max(float(np.max(row)) - e.largest, e.least - float(np.min(row))) for row, e in zip(speeds, told, strict=True)
    ]
    return max(*beyond, 0.0) / largest(speeds)


def check(seeds: range, scenes: int) -> None:
    pairs: Pairs = defaultdict(list)
    for seed in seeds:
        found = solved(seed)
        if found is None:
            continue
        for kind, values in compared(*found).items():
            pairs[kind] += values
    assert {*pairs} == {*KINDS}
    for kind, values in pairs.items():
        assert_bounds(values, kind, scenes=scenes)


def test_estimates_of_some_motions() -> None:
    check(range(500, 516), 8)


@pytest.mark.slow
def test_estimates_of_many_motions() -> None:
    check(range(part(280, 3)), part(200, 3))
