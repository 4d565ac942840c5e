"""Labels keep clear of curves, however far these leave the picture."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from tmmcalc.report.drawing.labels import BEYOND, MM, STEP, Labels


def labels() -> Labels:
    axes = Figure(figsize=(100 / MM, 100 / MM), dpi=100).add_axes((0, 0, 1, 1))
    axes.set_xlim(0, 100)
    axes.set_ylim(0, 100)  # a unit is 1 mm
    return Labels(axes)


def test_a_curve_of_kilometres_takes_points_near_the_axes_alone() -> None:
    one = labels()
    one.avoid([-1e9 - 1e9j, 1e9 + 1e9j])
    one.avoid([1e9 + 1j, 1e9 + 2j])
    points = np.concatenate(one._points)
    near = points[1:-2]
    assert len(points) < 2 * (100 + 2 * BEYOND) / STEP
    assert near.real.min() < 0
    assert near.real.max() > 100
    np.testing.assert_allclose(near.real, near.imag, atol=1e-5)


def test_a_curve_within_the_axes_is_taken_whole() -> None:
    one = labels()
    one.avoid([10 + 10j, 90 + 10j, 90 + 20j])
    points = np.concatenate(one._points)
    np.testing.assert_allclose(points.real.max(), 90, rtol=1e-9)
    assert len(points) == 1 + int(80 / STEP) + int(10 / STEP)
    assert one.crowded([10 + 10j, 1e12 + 10j], 1.0) > 60
