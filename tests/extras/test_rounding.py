"""Estimated errors of the small calculators against 50 digits, of the contact against Hertz."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator
from typing import Any

import mpmath as mp
import numpy as np
import pytest
from bounding import assert_bounds

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.extras.bearing import BearingTask, solve_bearing
from tmmcalc.extras.contact import ContactTask, solve_contact
from tmmcalc.extras.reliability import LifeTest, ReliabilityTask, solve_reliability
from tmmcalc.extras.tie_down import Support, Thread, TieDownTask, solve_tie_down
from tmmcalc.feasibility.judge import Constraint, FeasibilityTask, judge

SCENES = 200
Scene = tuple[str, float, Any]  # quantity, estimate, true relative error


def _far(told: Any, exact: Any) -> float:
    told, exact = np.atleast_1d(told), list(np.atleast_1d(exact))
    largest = max(abs(each) for each in exact)
    return float(max(abs(float(one) - each) for one, each in zip(told, exact, strict=True)) / largest)


def _bearings() -> Iterator[Scene]:
    rng = np.random.default_rng(1)
    for _ in range(SCENES):
        inner = rng.uniform(0.01, 0.3)
        outer = inner * rng.uniform(1.3, 2.5)
        mean = (inner + outer) / 2
        task = BearingTask(
            float(rng.uniform(1, 900)), float(inner), float(outer), float(mean * rng.uniform(0.1, 0.9)),
            int(rng.integers(6, 20)), float(rng.choice([0.0, rng.uniform(0, 0.7)])),
        )  # fmt: skip
        found = solve_bearing(task)
        n, dm = mp.mpf(task.omega) / (2 * mp.pi), (mp.mpf(task.inner) + mp.mpf(task.outer)) / 2
        part = task.roller / dm * mp.cos(mp.mpf(task.angle))
        told = found.cage, found.outer_race, found.inner_race, found.roller
        exact = (
            n / 2 * (1 - part), task.count * n / 2 * (1 - part), task.count * n / 2 * (1 + part),
            n * dm / (2 * mp.mpf(task.roller)) * (1 - part**2),
        )  # fmt: skip
        yield "frequencies", found.error, max(_far(one, other) for one, other in zip(told, exact, strict=True))


def _ties() -> Iterator[Scene]:
    rng = np.random.default_rng(2)
    for _ in range(SCENES):
        support = Support(2e3, 0.1, 4.0, 1.5, 2.5, 0.8) if rng.random() < 0.5 else None
        thread = Thread(30.0, 0.0147, 0.0433, 0.2049) if rng.random() < 0.5 else None
        task = TieDownTask(
            float(rng.uniform(2e4, 2e5)), float(rng.uniform(0.2, 1.0)), float(rng.uniform(0.2, 1.2)),
            float(rng.uniform(0.0, 1.2)), float(rng.uniform(0.0, 0.5)), float(rng.uniform(0, 9e3)), thread, support,
        )  # fmt: skip
        found = solve_tie_down(task)
        g, k, mu = mp.mpf(task.weight), mp.mpf(task.factor), mp.mpf(task.friction)
        alpha, beta = mp.mpf(task.elevation), mp.mpf(task.plan)
        start = mp.mpf(task.preload)
        if thread is not None:
            start = mp.mpf(thread.moment) / (
                mp.mpf(thread.diameter) * mp.tan(mp.mpf(thread.lead) + mp.mpf(thread.friction_angle))
            )
        push, own = k * g, g
        if support is not None:
            tipped = k * g * mp.mpf(support.diameter) / (2 * mp.mpf(support.base))
            push -= mp.mpf(support.friction) * (support.weight + g * mp.mpf(support.arm) / support.base + tipped)
            own = g * mp.mpf(support.cradle_arm) / support.base - tipped
        press = own + 4 * start * mp.sin(alpha)
        pull = 2 * (mu * mp.sin(alpha) + mp.cos(alpha) * mp.cos(beta))
        force = max((push - mu * press) / pull, start)
        told = found.push, found.press, found.preload, found.force, found.change, found.vertical
        exact = push, press, start, force, force - start, 4 * start * mp.sin(alpha)
        yield "forces", found.error, _far(told, exact)
        rise, own_fall = g, mp.mpf(0)
        if support is not None:
            own_fall = g * mp.mpf(support.diameter) / (2 * mp.mpf(support.base))
            rise = g - mp.mpf(support.friction) * own_fall
        still = k - (push - mu * press) / (rise + mu * own_fall)
        yield "slip", found.error, _far(found.thresholds.slip, still)


def _lives() -> Iterator[Scene]:
    rng = np.random.default_rng(3)
    for _ in range(SCENES):
        low, high = float(rng.choice([0.0, rng.uniform(0.1, 0.8)])), float(rng.uniform(1.0, 2.0))
        task = ReliabilityTask(
            low, high, float(rng.uniform(0.05, 3.0)), strength=float(high * rng.uniform(0.9, 2.5)),
            decay=float(10 ** rng.uniform(-2, 0)), rows=40,
        )  # fmt: skip
        found = solve_reliability(task)
        a, b, h, r, beta = (mp.mpf(x) for x in (low, high, task.rate, task.strength, task.decay))
        start = max(mp.log(r / b) / beta, mp.mpf(0))
        floor = max(mp.log(r / a) / beta, mp.mpf(0)) if low else mp.inf

        def hazard(t: Any, a: Any = a, b: Any = b, h: Any = h, r: Any = r, beta: Any = beta,
                   start: Any = start, floor: Any = floor, low: float = low) -> Any:  # fmt: skip
            end = max(min(t, floor), start)
            fallen = r * (mp.exp(-beta * start) - mp.exp(-beta * end)) / beta
            return h / (b - a) * (b * (end - start) - fallen) + (h * max(t - floor, 0) if low else 0)

        assert found.error is not None
        exact = [mp.exp(-hazard(mp.mpf(float(t)))) for t in found.t]
        yield "reliability", found.error.reliability, _far(found.kept, exact)
        lives = [
            mp.findroot(lambda t, part=part: hazard(t) + mp.log(mp.mpf(part)), life, tol=1e-60)
            for part, life in found.lives
        ]
        told = [life for _, life in found.lives]
        yield "lives", found.error.lives, max(_far(one, other) for one, other in zip(told, lives, strict=True))
        last = float(lives[-1]) - float(start)
        marks = [float(start) + part * last for part in (0, 0.25, 1, 2.5, 6, 15, 50)]
        ends = [mp.mpf(mark) for mark in marks if mark < floor] + ([floor] if low else [])
        mean = start + mp.quad(lambda t: mp.exp(-hazard(t)), ends, maxdegree=6)
        mean += mp.exp(-hazard(floor)) / h if low else 0
        yield "mean", found.error.mean, _far(found.mean, mean)


def _decays() -> Iterator[Scene]:
    """From tests of items: the decay at which the mean life is that of the test, its shortest life the likeliest."""
    rng, done = np.random.default_rng(6), 0
    while done < SCENES:
        low, high = float(rng.choice([0.0, rng.uniform(0.1, 0.8)])), float(rng.uniform(1.0, 2.0))
        least = float(10 ** rng.uniform(-1, 1))
        test = LifeTest(int(rng.integers(5, 60)), least, least * float(rng.uniform(1.2, 6)))
        task = ReliabilityTask(low, high, float(rng.uniform(0.05, 3.0) / least), test=test, rows=4)
        try:
            found = solve_reliability(task)
        except NoSolutionError:
            continue
        done += 1

        def mean(beta: Any, task: ReliabilityTask = task, test: LifeTest = test) -> Any:
            a, b, h = mp.mpf(task.low), mp.mpf(task.high), mp.mpf(task.rate)
            half = beta * (b - a) / (2 * h * test.items)
            r = mp.exp(beta * mp.mpf(test.least)) * (b + half - mp.sqrt(half * (2 * b + half)))
            start = max(mp.log(r / b) / beta, mp.mpf(0))
            floor = mp.log(r / a) / beta if a else mp.inf

            def kept(t: Any) -> Any:
                fallen = r * (mp.exp(-beta * start) - mp.exp(-beta * t)) / beta
                return mp.exp(-h / (b - a) * (b * (t - start) - fallen))

            marks = [start + part / mp.sqrt(h * beta) for part in (0, 1, 3, 8)] + [start + 100 / h + 8 / beta]
            ends = [mark for mark in marks if mark < floor] + ([floor] if a else [mp.inf])
            return start + mp.quad(kept, ends) + (kept(floor) / h if a else 0)

        assert found.error is not None
        told = mp.mpf(found.decay)
        with mp.workdps(25):
            wanted = mp.mpf(test.mean)
            beside = told * (1 + mp.mpf(10) ** -8)
            exact = mp.findroot(lambda beta, mean=mean, wanted=wanted: mean(beta) - wanted, (told, beside), tol=1e-30)
        yield "decay", found.error.decay, float(abs(told / exact - 1))


def _contacts() -> Iterator[Scene]:
    rng = np.random.default_rng(4)
    for _ in range(SCENES):
        one = float(rng.uniform(0.01, 0.2))
        radii = (one, one * float(rng.uniform(1.0, 4.0)))
        task = ContactTask(
            float(rng.uniform(10, 500)), 1.1e11, radii, cells=int(rng.choice([8, 10, 12])),
        )  # fmt: skip
        found = solve_contact(task)
        assert found.hertz is not None
        yield "peak", found.error.peak, abs(found.peak / found.hertz.peak - 1)
        yield "approach", found.error.approach, abs(found.approach / found.hertz.approach - 1)


def _margins() -> Iterator[Scene]:
    rng = np.random.default_rng(5)
    for _ in range(SCENES):
        limits = [float(x) for x in np.sort(rng.uniform(-50, 50, 2))]
        value = float(rng.choice([limits[0] * (1 + rng.uniform(0, 1e-3)), rng.uniform(-100, 100)]))
        task = FeasibilityTask((Constraint("a", "s", value="v"),))
        found = judge(task, {"a": (value, "m", limits[0], limits[1])})
        low, high = (mp.mpf(limit) for limit in limits)
        exact = min((mp.mpf(value) - low) / abs(low), (high - mp.mpf(value)) / abs(high))
        yield "margins", found.error, _far(found.verdicts[0].margin, exact)


@pytest.mark.slow
@pytest.mark.parametrize("scenes", [_bearings, _ties, _lives, _decays, _contacts, _margins])
def test_estimates_bound_their_errors(scenes: Any) -> None:
    pairs: dict[str, list[tuple[float, float]]] = defaultdict(list)
    with mp.workdps(50):
        for name, estimate, error in scenes():
            pairs[name].append((estimate, error))
    for name, each in pairs.items():
        assert_bounds(each, name)
