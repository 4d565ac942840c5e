"""The estimated errors of speeds and largest moments bound the true ones in random drives, and are not far from them.

The truth is DOP853 on equations of its own, some hundred times finer; drives for which it is too dear, mostly stiff
ones, and those whose crank comes to rest are left out: about half. In the others the program's finest collocation, that
closed solutions confirm elsewhere, agrees with it to twelve digits.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import pytest
from bounding import RATE, USEFUL, accepted, part

from machine.transient.drives import drawn, made
from machine.transient.exact import BUDGET, exact_motion
from machine.transient.scenes import at, run

SEEN = 1e-12  # to which the truth is known: less cannot be told from it
INSTANTS = 60


class Judged(NamedTuple):
    """Estimates and true errors."""

    speeds: tuple[float, float]
    moments: tuple[float, float]


def judged(rng: np.random.Generator, method: str = "auto", budget: int = BUDGET, **more: object) -> Judged | None:
    """Of a random drive; None: its truth is not known, or a shaft is taken as rigid."""
    numbers = drawn(rng)
    exact = exact_motion(numbers, budget=budget)
    if exact is None:
        return None
    chosen = np.unique(np.linspace(0, len(exact.t) - 1, INSTANTS).astype(int))[1:-1]
    found = run(*made(numbers), method, exact.t[chosen].tolist(), **more)
    if found.rigid:
        return None
    own = np.abs(found.largest_moment[0])
    rows = np.vstack((found.shaft_moment, found.motor_moment))
    assert np.all(np.abs(rows).max(axis=1) <= own)
    speeds = found.omega[:, at(found, exact.t[chosen])] - exact.omega[:, chosen]
    return Judged(
        (found.error, float(np.abs(speeds).max(initial=0.0) / np.abs(exact.omega).max())),
        (found.extremes_error, float(np.abs(own / exact.largest - 1).max())),
    )


def test_estimates_of_some_drives() -> None:
    rng = np.random.default_rng(5)
    for each in accepted(lambda: judged(rng, budget=8_000), 1):
        assert each.speeds[0] >= each.speeds[1]
        assert each.moments[0] >= each.moments[1]


@pytest.mark.slow
def test_the_finest_collocation() -> None:
    rng = np.random.default_rng(3)
    finest = accepted(lambda: judged(rng, "collocation", tolerance=1e-11, compared=False), 4)
    assert all(max(each.speeds[1], each.moments[1]) < SEEN for each in finest)


@pytest.mark.slow
def test_estimates_of_many_drives() -> None:
    rng = np.random.default_rng(17)
    found = [*accepted(lambda: judged(rng), part(200, 5))]
    for what, pairs in (("speeds", [each.speeds for each in found]), ("moments", [each.moments for each in found])):
        estimates, errors = np.maximum(np.array(pairs), SEEN).T
        rate, seen = float(np.mean(estimates >= errors)), errors > SEEN
        median = float(np.median(estimates[seen] / errors[seen]))
        assert rate >= RATE, (what, rate, median)
        assert median < USEFUL, (what, rate, median)
