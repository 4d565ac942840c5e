"""The error estimate against the true error: every position computed again in extended precision."""

from __future__ import annotations

import math
from functools import cache, partial

import numpy as np
import pytest
from random_mechanisms import build

from linkage.scenes import crank_slider, four_bar, full_turn, shaper, slotted, with_grid
from tmmcalc import Kinematics, Method, TmmError, solve_kinematics
from tmmcalc.core.numerics.extended import WIDER
from tmmcalc.linkage import errors
from tmmcalc.linkage.chain import compile_chain
from tmmcalc.linkage.lastdigit import in_full
from tmmcalc.linkage.model import Mechanism
from tmmcalc.linkage.results import Trace
from tmmcalc.linkage.trace import trace

pytestmark = pytest.mark.skipif(not WIDER, reason="no wider float here: the estimate has no reference")
KINDS = ("position", "velocity", "acceleration")


def true_errors(mechanism: Mechanism, result: Kinematics) -> tuple[float, ...]:
    """Largest error of points over all positions, relative to the largest value of each kind."""
    chain = in_full(compile_chain(mechanism, result.structure, result.variants))
    exact, t = trace(chain, result.x.astype(np.longdouble)), result.trace
    pairs = ((t.r, exact.r), (t.dr, exact.dr), (t.ddr, exact.ddr))
    return tuple(float(np.max(np.abs(a - b)) / (np.max(np.abs(b)) or 1)) for a, b in pairs)


@cache
def ratios(scenes: int) -> np.ndarray:
    """Estimate over true error of random scenes of 200 positions, by kind (m, 3)."""
    rows = []
    for seed in range(scenes):
        scene = build(np.random.default_rng(seed), positions=200, span=math.radians(12))
        try:
            result = solve_kinematics(scene.mechanism)
        except TmmError:
            continue
        errors = true_errors(scene.mechanism, result)
        rows.append([getattr(result.error, kind) / max(e, 1e-17) for kind, e in zip(KINDS, errors, strict=True)])
    assert len(rows) > scenes / 1.2
    return np.array(rows)


SCENES = pytest.mark.parametrize("scenes", [30, pytest.param(240, marks=pytest.mark.slow)])


@SCENES
def test_the_estimate_bounds_the_true_error_in_99_of_100_scenes(scenes: int) -> None:
    assert np.mean(ratios(scenes) >= 1, axis=0).min() >= 0.99


@SCENES
def test_the_estimate_is_not_far_above_the_true_error(scenes: int) -> None:
    assert np.median(ratios(scenes), axis=0).max() < 30


@pytest.mark.parametrize("positions", [4, 24, 2000])
@pytest.mark.parametrize(
    "mechanism",
    [
        four_bar(1, 6, 3, 7),
        crank_slider(0.1, 0.3, 0.05),
        crank_slider(0.1, 0.15, 0.05 * (1 - 1e-4)),
        crank_slider(0.1, 0.15, 0.05 * (1 - 1e-8)),
        slotted(0.1, 0.1 * (1 + 1e-4)),
        shaper(),
    ],
)
def test_over_full_turns_and_near_dead_points(mechanism: Mechanism, positions: int) -> None:
    mechanism = full_turn(mechanism, 0.1, positions)
    result = solve_kinematics(mechanism)
    for kind, error in zip(KINDS, true_errors(mechanism, result), strict=True):
        assert getattr(result.error, kind) >= error


def test_differences_are_compared_with_the_exact_derivatives() -> None:
    mechanism = shaper(positions=200)
    for degrees in (0.1, 1.5, 5.0):
        result = solve_kinematics(mechanism, Method("differences", step=math.radians(degrees)))
        errors = true_errors(mechanism, result)
        assert result.error.velocity >= errors[1]
        assert result.error.acceleration >= errors[2]
        assert result.error.velocity <= 10 * errors[1]
    rounded = solve_kinematics(mechanism, Method("differences", step=math.radians(0.1), decimals=6))
    assert rounded.error.acceleration > 0.01


def test_without_a_wider_float_the_amplification_speaks(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(errors, "WIDER", False)
    mechanism = full_turn(crank_slider(0.1, 0.15, 0.05 * (1 - 1e-4)), 0.1, 500)
    result = solve_kinematics(mechanism)
    assert result.error.reference == "amplification of the rounding unit"
    for kind, error in zip(KINDS, true_errors(mechanism, result), strict=True):
        assert getattr(result.error, kind) >= error


def test_the_estimate_of_a_bad_method_is_bad() -> None:
    """It measures whatever computes the trace, it does not trust it."""
    mechanism = full_turn(four_bar(1, 6, 3, 7))
    result = solve_kinematics(mechanism)
    chain = compile_chain(mechanism, result.structure, result.variants)

    def wrong(x: np.ndarray, by: float) -> Trace:
        t = trace(chain, x)
        t.dr[:] *= 1 + by
        return t

    found = errors.estimate(chain, result.x, partial(wrong, by=1e-6))
    assert found.velocity == pytest.approx(4e-6, rel=1e-3)
    assert found.position < 1e-14


@pytest.mark.parametrize("size", [4, 25, 100_000])
def test_few_positions_are_computed_again(size: int) -> None:
    mechanism = with_grid(full_turn(four_bar(1, 6, 3, 7)), positions=size)
    result = solve_kinematics(mechanism)
    assert 1e-16 < result.error.position < 1e-14
    assert 1e-16 < result.error.acceleration < 1e-12
