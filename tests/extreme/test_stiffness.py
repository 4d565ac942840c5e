"""Ladders of stiffness against closed solutions: shafts of 1e3 to 1e9 N*m/rad, motors that lag by 1 s to 1e-7 s.

What an implicit choice costs stays the same from the softest to the stiffest, and its error stays within what it tells;
the textbook's fixed step has a limit of stability that falls with the fast part, and its cost explodes.
"""

from __future__ import annotations

import math

import numpy as np
import pytest
from machine.transient.scenes import constant, cycle, line, run
from sparing import sparing

from tmmcalc.core.errors import AccuracyError
from tmmcalc.machine.transient.model import Drive, Mass, Shaft
from tmmcalc.machine.transient.results import Transient
from tmmcalc.machine.transient.scenario import Scenario

ROTOR, CRANK, DRIVING, LOAD, BEGIN = 0.5, 1.5, 50.0, 30.0, 10.0
MOBILITY = 1 / ROTOR + 1 / CRANK
RATIO = 0.2  # damping over the critical one
DURATION = 0.5
STIFFNESSES = [10.0**k for k in range(3, 10)]
LAGS = [10.0**-k for k in range(8)]
TEXTBOOK = 0.01  # step [s]
PROMISED = 1e-8


def shafted(stiffness: float) -> Drive:
    damping = 2 * RATIO * math.sqrt(stiffness / MOBILITY)
    return Drive((Mass(ROTOR), Mass(CRANK)), (Shaft(stiffness, damping),), constant(DRIVING), cycle(-LOAD, 0.0))


def swinging(stiffness: float, t: np.ndarray) -> np.ndarray:
    """Speeds (2, S) from a common one with the shaft slack: damped swing about the steady acceleration."""
    rate = math.sqrt(stiffness * MOBILITY)
    decay, swing = RATIO * rate, rate * math.sqrt(1 - RATIO**2)
    slide = (DRIVING / ROTOR + LOAD / CRANK) * np.exp(-decay * t) * np.sin(swing * t) / swing
    momentum = (ROTOR + CRANK) * BEGIN + (DRIVING - LOAD) * t
    return np.stack((momentum + CRANK * slide, momentum - ROTOR * slide)) / (ROTOR + CRANK)


INERTIA, STEEPNESS, IDLE = 2.0, 40.0, 15.0


def lagging(lag: float) -> Drive:
    return Drive((Mass(INERTIA),), (), line(STEEPNESS, IDLE), cycle(-LOAD, 0.0), None, lag)


def run_up(lag: float, t: np.ndarray) -> np.ndarray:
    """Speed (1, S) from rest of J w' = M - L, lag M' = k (w0 - w) - M, by the eigenvalues; the motor starts at 0."""
    matrix = np.array([[0.0, 1 / INERTIA], [-STEEPNESS / lag, -1 / lag]])
    steady = np.array([IDLE - LOAD / STEEPNESS, LOAD])
    values, vectors = np.linalg.eig(matrix.astype(complex))
    parts = np.linalg.solve(vectors, BEGIN_LAGGING - steady)
    return (steady[0] + (vectors[0] * parts) @ np.exp(np.outer(values, t))).real[None]


BEGIN_LAGGING = np.array([BEGIN, 0.0])
STEADY_STEP = Scenario("step", DURATION, speed=BEGIN)


def missed(found: Transient, true: np.ndarray) -> float:
    return float(np.max(np.abs(found.omega - true)) / np.max(np.abs(true)))


@pytest.mark.slow
def test_stiff_shafts_cost_no_more_than_soft_ones() -> None:
    counts = []
    for stiffness in STIFFNESSES:
        found = run(shafted(stiffness), STEADY_STEP)
        assert found.rigid == ()
        assert missed(found, swinging(stiffness, found.t)) <= min(found.error, PROMISED)
        counts.append(found.counters["evaluations"])
    assert max(counts) < 3 * min(counts), counts


@pytest.mark.slow
def test_lags_of_all_sizes_cost_the_same() -> None:
    counts = []
    for lag in LAGS:
        found = run(lagging(lag), STEADY_STEP)
        assert missed(found, run_up(lag, found.t)) <= min(found.error, PROMISED)
        counts.append(found.counters["evaluations"])
    assert max(counts) < 4000, counts
    stiff = counts[-4:]
    assert max(stiff) < 1.5 * min(stiff), counts


def limit(drive: Drive) -> float:
    with pytest.raises(AccuracyError, match="unstable") as caught:
        run(drive, STEADY_STEP, "merson", step=10.0)
    assert isinstance(caught.value.limit, float)
    return caught.value.limit


def test_the_limit_of_the_textbook_falls_with_the_root_of_the_stiffness() -> None:
    """A swing of the rate w damped by 0.2: the bound on its ray, found here by the polynomial itself, over w."""
    way = -RATIO + 1j * math.sqrt(1 - RATIO**2)
    bound = next(
        r for r in np.arange(2, 5, 1e-4) if abs(np.polyval([1 / 144, 1 / 24, 1 / 6, 1 / 2, 1, 1], r * way)) > 1
    )
    for stiffness in STIFFNESSES[3:]:
        rate = math.sqrt(stiffness * MOBILITY)
        assert limit(shafted(stiffness)) == pytest.approx(bound / rate, rel=3e-3)
    for lag in LAGS[3:]:
        fastest = np.abs(np.linalg.eigvals([[0.0, 1 / INERTIA], [-STEEPNESS / lag, -1 / lag]])).max()
        assert limit(lagging(lag)) == pytest.approx(3.548 / fastest, rel=5e-3)


@pytest.mark.parametrize("stiffness", STIFFNESSES[2:])
def test_the_step_of_the_textbook_is_refused_on_stiff_shafts(stiffness: float) -> None:
    for method in ("merson", "rk4"):
        with pytest.raises(AccuracyError, match=r"steps of 0\.01 s are unstable: a swing of .* grows .* in every step"):
            run(shafted(stiffness), STEADY_STEP, method, step=TEXTBOOK)


@sparing("method", ["merson", "rk4"], every=2)
def test_below_its_limit_a_fixed_step_stays_bounded_and_its_steps_explode(method: str) -> None:
    counts = []
    for stiffness in (1e4, 1e6):
        with pytest.raises(AccuracyError) as caught:
            run(shafted(stiffness), STEADY_STEP, method, step=10.0)
        assert caught.value.remedy is not None
        told = float(caught.value.remedy.split("at most ")[1].split(" s")[0])
        found = run(shafted(stiffness), STEADY_STEP, method, step=told)
        assert missed(found, swinging(stiffness, found.t)) <= found.error < 1
        counts.append(found.counters["steps"])
    assert counts[1] == pytest.approx(10 * counts[0], rel=0.05)


def test_what_grows_unforeseen_is_no_result() -> None:
    """A damper that acts at speeds which no one knew of: the fixed step drowns in it, and is refused by its error."""
    steep = cycle(0.0, 0.0, quadratic=-5.0)
    drive = Drive((Mass(0.5),), characteristic=constant(4e4), cycle=steep)
    with pytest.raises(AccuracyError, match=r"fixed steps are too long|grew beyond all bounds"):
        run(drive, Scenario("start", 1.0), "rk4", step=0.01)


@pytest.mark.slow
def test_the_error_of_fixed_steps_is_told() -> None:
    """By the classical method, which knows none; against the closed solution."""
    for method in ("merson", "rk4"):
        for step in (2e-4, 1e-3, 5e-3):
            found = run(shafted(1e4), STEADY_STEP, method, step=step)
            true = missed(found, swinging(1e4, found.t))
            assert true <= found.error <= 3 * true + 2e-9
