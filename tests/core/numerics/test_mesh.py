"""Panels of several variants are those that each has alone."""

from __future__ import annotations

import numpy as np

from tmmcalc.core.numerics.mesh import laid
from tmmcalc.core.numerics.panels import panels

PERIOD = 2 * np.pi
BREAKS = np.array([[1.0, 4.0, 2.0], [0.0, PERIOD, 3.0], [2.0, 2.0 + 1e-9, 5.0], [1e-8, PERIOD - 1e-8, 6.0]])


def test_first_panels() -> None:
    every = laid(PERIOD, BREAKS, 0.4)
    for k, breaks in enumerate(BREAKS):
        own, alone = every.at(every.owner == k), panels(0.0, PERIOD, breaks, 0.4)
        assert np.allclose(own.low, alone.edges[:-1], rtol=0, atol=1e-14)
        assert np.allclose(own.high, alone.edges[1:], rtol=0, atol=1e-14)
        assert np.allclose(own.x, alone.x, rtol=0, atol=1e-14)


def test_cut_panels() -> None:
    every = laid(PERIOD, np.zeros((3, 0)), PERIOD)
    assert every.owner.tolist() == [0, 1, 2]
    places = {0: [], 1: [3.0, 1.0, 1.0 + 1e-9], 2: [2.5, 1e-9]}
    panel = np.array([k for k, found in places.items() for _ in found])
    place = np.array([at for found in places.values() for at in found])
    finer = every.cut(panel, place, PERIOD)
    for k, found in places.items():
        alone = laid(PERIOD, np.zeros((1, 0)), PERIOD).cut_or_moved(np.array(found), PERIOD, ())
        own = finer.mesh.owner == k
        assert finer.mesh.low[own].tolist() == alone.mesh.low.tolist()
        assert finer.mesh.high[own].tolist() == alone.mesh.high.tolist()
        assert finer.fresh[own].tolist() == alone.fresh.tolist()


def test_values_follow_their_panels() -> None:
    every = laid(PERIOD, np.array([[3.0], [4.0]]), PERIOD)
    finer = every.cut(np.array([1, 2]), np.array([5.0, 1.0]), PERIOD)
    values = np.sin(every.x)[None]
    merged = finer.merged(values, np.sin(finer.mesh.x[finer.fresh])[None])
    assert np.array_equal(merged[0], np.sin(finer.mesh.x))
