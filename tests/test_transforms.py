"""The changes of ``transforms`` do to the motion what they say, by the reference solver."""

from __future__ import annotations

import numpy as np
import pytest
from assemblies import initial_guess_from
from numpy.testing import assert_allclose
from random_mechanisms import build
from reference import Reference, solve
from transforms import moved, renumbered, scaled, swapped, with_axes

from tmmcalc.linkage.model import Mechanism

SEEDS = range(6)


def run(mechanism: Mechanism) -> Reference:
    start, span = mechanism.input.start, mechanism.grid.span
    assert start is not None
    assert span is not None
    guess = initial_guess_from(mechanism, start, mechanism.assembly.sketch)
    return solve(mechanism, guess, start + span * np.linspace(0, 1, 4))


@pytest.mark.parametrize("seed", SEEDS)
def test_moving_turns_points_and_their_derivatives(seed: int) -> None:
    mechanism = build(np.random.default_rng(seed)).mechanism
    one, two = run(mechanism), run(moved(mechanism, 0.7, 3 - 2j))
    for name in mechanism.assembly.sketch:
        assert_allclose(two.point(name).value, one.point(name).value * np.exp(0.7j) + 3 - 2j, atol=1e-12)
        assert_allclose(two.point(name).second, one.point(name).second * np.exp(0.7j), rtol=1e-10, atol=1e-10)


@pytest.mark.parametrize("seed", SEEDS)
def test_scaling_scales_points_and_slides(seed: int) -> None:
    mechanism = build(np.random.default_rng(seed), prismatic_input=bool(seed % 2)).mechanism
    one, two = run(mechanism), run(scaled(mechanism, 1000.0))
    for name in mechanism.assembly.sketch:
        assert_allclose(two.point(name).value, 1000 * one.point(name).value, rtol=1e-12, atol=1e-9)
    for name, slide in one.slides.items():
        assert_allclose(two.slides[name].value, 1000 * slide.value, rtol=1e-12, atol=1e-9)


@pytest.mark.parametrize("seed", SEEDS)
def test_numbers_axes_and_order_do_not_move_points(seed: int) -> None:
    mechanism, rng = build(np.random.default_rng(seed)).mechanism, np.random.default_rng(seed)
    other = with_axes(mechanism, 1, 0.3 - 0.2j, 1.1)
    other = with_axes(other, len(mechanism.links), 1 + 1j, -2.0)
    for joint in mechanism.joints:
        other = swapped(other, joint.name)
    other = renumbered(other, {link.id: 3 * link.id + 4 for link in mechanism.links}, rng=rng)
    one, two = run(mechanism), run(other)
    for name in mechanism.assembly.sketch:
        assert_allclose(two.point(name).value, one.point(name).value, atol=1e-12)
        assert_allclose(two.point(name).second, one.point(name).second, rtol=1e-10, atol=1e-10)
    for name, slide in one.slides.items():
        assert_allclose(two.slides[name].value, slide.value, atol=1e-12)
