"""What the place of a rocker's cam axis is chosen for, in the plane of `halfplanes`."""

from __future__ import annotations

from typing import Protocol

import numpy as np

from tmmcalc.cams.follower import Complex
from tmmcalc.cams.laws.law import Values
from tmmcalc.core.records import record


class Objective(Protocol):
    """What is to be least; its level sets are convex."""

    def of(self, points: Complex) -> Values:
        """The value at points (...)."""

    def within(self, normal: Complex, bound: Values) -> Complex:
        """The best point of each half plane (...)."""


@record
class Distance:
    """Distance from a point: 1 for the least base circle, 0 for the least distance of the centres."""

    centre: complex

    def of(self, points: Complex) -> Values:
        """|o - centre|."""
        return np.abs(points - self.centre)

    def within(self, normal: Complex, bound: Values) -> Complex:
        """The centre, or its foot on the line."""
        return self.centre - np.maximum((self.centre * np.conj(normal)).real - bound, 0.0) * normal


@record
class Ratio:
    """R0/l0 = |o - 1|/|o|, least where the distance of the centres is given."""

    def of(self, points: Complex) -> Values:
        """|o - 1|/|o|."""
        return np.abs(points - 1) / np.maximum(np.abs(points), 1e-300)

    def within(self, normal: Complex, bound: Values) -> Complex:
        """1, or the point of the line n (c + i x) where 1 - ratio^2 = (2 Re o - 1)/|o|^2 is largest."""
        a, b = 2 * normal.real * bound - 1, -2 * normal.imag
        root = a + np.sqrt(a * a + b * b * bound * bound)
        x = b * bound * bound / np.where(root == 0, 1e-300, root)
        return np.where(normal.real <= bound, 1.0, normal * (bound + 1j * x))
