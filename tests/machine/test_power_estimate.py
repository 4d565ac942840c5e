"""Error estimates of work, efficiency and power against true errors in random linkages.

The truth: every moment in extended precision, integrated on panels that are halved until they tell what they should,
and the sums of the textbook (3.35)-(3.37) written out once more.
"""

from __future__ import annotations

from collections import defaultdict
from typing import Any

import numpy as np
import pytest
from bounding import assert_bounds, part

from machine.reduction.drawn import integrals, solved, wide
from tmmcalc.core.numerics.extended import WIDER
from tmmcalc.machine.power import Power
from tmmcalc.machine.reduction.causes import Causes
from tmmcalc.machine.reduction.results import Reduction
from tmmcalc.machine.stages.power import solve

pytestmark = pytest.mark.skipif(not WIDER, reason="no wider float here: the estimate has no reference")

Pairs = dict[str, list[tuple[float, float]]]
PLACES = 300  # of a cycle where moments are compared
NOTHING = 1e-12  # what is less of the turnover counts as nothing


class Gears:
    """Gears that lose a part of the power."""

    efficiency, ratio, ratio_of, inertia = 0.9, None, "", 0.0


def power_of(found: Reduction) -> Power:
    from tmmcalc.machine.model import Gears as Given

    return solve(None, Given(efficiency=Gears.efficiency), "", reduction=found)


def compared(found: Reduction, causes: Causes, power: Power, seed: int) -> Pairs:
    """Estimates and true errors of all scalars of a power."""
    powers = (abs(np.longdouble(causes.scene.travel.speed)) ** causes.orders)[:, None]

    def both(x: Any) -> Any:
        moments = wide(causes, x).moments * powers
        return np.concatenate((moments, np.abs(moments)))

    works, turnovers = np.split(integrals(both, found.cycle.panels.edges)[0], 2)
    kinds = np.array([kind for _, kind, _ in causes.names])
    told = np.array([part.turnover for part in power.parts])
    assert np.all(np.abs(told - turnovers) <= 1e-6 * turnovers + 1e-9 * np.max(turnovers))
    turnover, period = float(turnovers.sum()), found.cycle.period
    scale = float(np.max(turnovers))
    loads = np.where((kinds == "load") & (np.abs(works) > NOTHING * scale), works, 0)
    driving, resisting = loads[loads > 0].sum(), loads[loads < 0].sum()
    losses, stored = (works[np.isin(kinds, some)].sum() for some in (("friction", "damper"), ("weight", "spring")))
    total = driving + resisting + losses
    time = period / found.cycle.speed
    off = [
        *(power.parts[k].work - works[k] for k in range(len(works))),
        power.driving - driving,
        power.resisting - resisting,
        power.losses - losses,
        power.stored - stored,
        power.mean_power * time - abs(total),
        power.mean_moment * period + total,
        (power.motor_power * Gears.efficiency * time + total) if power.motor_power is not None else 0.0,
    ]
    pairs = {
        "work": [(power.error.work, float(np.max(np.abs(off))) / turnover)],
        "peak": [(power.error.peak, peaks(found, causes, power, powers, seed))],
    }
    useful, spent = max(total, 0) - resisting, driving + max(-total, 0)
    if power.efficiency is not None and useful > 1e-6 * turnover and spent > 1e-6 * turnover:
        pairs["efficiency"] = [(power.error.efficiency, abs(float(power.efficiency * spent / useful) - 1))]
    return pairs


def peaks(found: Reduction, causes: Causes, power: Power, powers: Any, seed: int) -> float:
    """By how much moments differ at the peak and at the start, and go beyond the extremes elsewhere."""
    inner = np.random.default_rng(seed).uniform(0, found.cycle.period, PLACES)
    highest = found.cycle.panels.extremes(found.parts.sum(axis=0))[1][1]
    at = np.array([power.peak_at, 0.0, highest])
    moments, few = (wide(causes, x).moments * powers for x in (inner, np.nextafter(at, found.cycle.period / 2)))
    scale = float(max(np.max(np.abs(found.parts)), np.max(np.abs(found.parts.sum(axis=0)))))
    total, told = moments.sum(axis=0), few.sum(axis=0)
    least, largest = (p / found.cycle.speed for p in power.peak_power)
    off = [
        power.start_moment - max(-told[1], 0),
        max(least - np.min(total), np.max(total) - largest, 0.0),
        max(-np.min(total) - power.peak_moment, 0.0),
    ]
    inside = np.min(np.abs(found.cycle.panels.edges[:, None] - at), axis=0) > 1e-9  # an edge has a limit on either side
    off += [power.peak_moment - max(-told[0], 0)] if inside[0] else []
    off += [largest - told[2]] if inside[2] else []
    return float(np.max(np.abs(off))) / scale


def check(seeds: range, scenes: int) -> None:
    pairs: Pairs = defaultdict(list)
    for seed in seeds:
        scene = solved(seed)
        if scene is None or not scene[0].parts.any():
            continue
        for key, values in compared(*scene, power_of(scene[0]), seed).items():
            pairs[key] += values
    for key, values in pairs.items():
        assert_bounds(values, key, scenes=scenes // 2 if key == "efficiency" else scenes)


def test_estimates_of_some_powers() -> None:
    check(range(1000, 1010), 6)


@pytest.mark.slow
def test_estimates_of_many_powers() -> None:
    check(range(part(300, 2)), part(200, 2))  # ratios of the peak scatter: the median of fewer does not tell
