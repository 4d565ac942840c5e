"""Zeros of functions of the configuration: short dips between two samples, the seam, rest, steep places."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from linkage.loads.acting import scene_of
from linkage.scenes import crank_slider, full_turn, part, slotted, with_input
from tmmcalc import solve_kinematics
from tmmcalc.linkage.chain import Configuration
from tmmcalc.linkage.crossings import crossings
from tmmcalc.linkage.loading import Load, Loading
from tmmcalc.linkage.loadlaws.tabulated import Tabulated
from tmmcalc.linkage.loads.scene import Scene, compile_scene
from tmmcalc.linkage.model import Mechanism

TURN = 2 * np.pi


def scene(mechanism: Mechanism) -> Scene:
    return compile_scene(mechanism, Loading(), solve_kinematics(mechanism))


def zeros(of: Scene, *functions: Any, scale: float = 1.0) -> list[Any]:
    return crossings(of.chain, lambda c: [f(c) for f in functions], [scale] * len(functions), of.survey)


def place(configuration: Configuration) -> Any:
    return configuration.motions[3].r.real


@pytest.mark.parametrize("start", [0.0, 0.0087, 1.0])
@pytest.mark.parametrize("depth", [1e-3, 1e-5, 1e-8, 1e-11])
def test_a_dip_between_two_samples(start: float, depth: float) -> None:
    """Near its outer dead centre the slider is beyond a place for less than a degree of the crank."""
    of = scene(full_turn(crank_slider(0.1, 0.3), start))
    (found,) = zeros(of, lambda c: place(c) - (0.4 - depth))
    # x = l1 cos p + sqrt(l2^2 - l1^2 sin^2 p) = X gives cos p = (X^2 + l1^2 - l2^2)/(2 l1 X)
    x = 0.4 - depth
    half = 2 * np.arcsin(np.sqrt((1 - (x**2 + 0.1**2 - 0.3**2) / (0.2 * x)) / 2))
    there = np.sort(np.mod(found + np.pi, TURN) - np.pi)
    np.testing.assert_allclose(there, [-half, half], atol=1e-15 / half + 1e-14)


def test_a_touch_is_no_crossing() -> None:
    of = scene(full_turn(crank_slider(0.1, 0.3), 0.3))
    (found,) = zeros(of, lambda c: place(c) - 0.4)
    assert found.size == 0


@pytest.mark.parametrize("start", [-2.0, 0.0, 1.3])
@pytest.mark.parametrize("speed", [1.0, -1.0])
def test_wherever_the_turn_begins(start: float, speed: float) -> None:
    of = scene(with_input(full_turn(crank_slider(0.1, 0.3), start), speed=speed))
    velocity, height = zeros(of, lambda c: c.motions[3].v.real, lambda c: c.motions[2].point(0.1).r.imag - 0.02)
    np.testing.assert_allclose(np.sin(velocity), 0.0, atol=1e-15 * 4)
    assert velocity.size == 2
    # y of a point of the rod is l1 sin p (1 - 0.1/0.3)
    np.testing.assert_allclose(np.sin(height), 0.02 / (0.1 * (1 - 0.1 / 0.3)), rtol=1e-13)
    assert height.size == 2
    assert np.all(np.diff(velocity) > 0)


def test_rest_and_rounding_are_no_crossings() -> None:
    of = scene(full_turn(crank_slider(0.1, 0.3), 0.3))
    wild = 1e-17 * np.random.default_rng(1).normal(size=100000)
    noise, nothing, constant = zeros(
        of, lambda c: wild[: np.size(c.motions[3].r)], lambda c: np.zeros(()), lambda c: np.asarray(3.0)
    )
    assert noise.size == nothing.size == constant.size == 0


def test_an_open_range_has_no_seam() -> None:
    of = scene(part(crank_slider(0.1, 0.3), 0.5, 3.5))
    (found,) = zeros(of, lambda c: c.motions[3].v.real)
    np.testing.assert_allclose(found, [np.pi], atol=1e-14)


def test_steep_places() -> None:
    """A slotted link whose pin passes close to its pivot: half a turn within a degree of the crank."""
    mechanism = full_turn(slotted(0.1, 0.0999), 0.2)
    of = scene(mechanism)
    lower, upper = zeros(of, lambda c: c.motions[3].u.real, lambda c: c.motions[3].u.imag - 0.3)
    assert (lower.size, upper.size) == (2, 4)
    np.testing.assert_allclose(np.cos(lower), 0.0, atol=1e-12)  # the slot stands upright where the crank does
    u = of.chain.evaluate(upper).motions[3].u
    np.testing.assert_allclose(u.imag, 0.3, atol=1e-12)


def test_a_table_that_bends_beside_a_dead_centre() -> None:
    load = Load("Q", 3, "force", Tabulated("displacement", (0.0, 0.1, 0.2 - 1e-6), (0.0, 50.0, -70.0)))
    edges = np.array(scene_of(full_turn(crank_slider(0.1, 0.3), 1.0), load).edges())
    outer = np.abs(np.mod(edges + 1.0 + np.pi, TURN) - np.pi)
    assert np.sum(outer < 0.01) == 3  # the dead centre, and the bend on either side of it
