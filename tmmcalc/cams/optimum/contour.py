"""The blocking contour: the closed region of S0 and r2 in which all constraints hold at one height H2.

A grid finds how the region lies; ``border`` traces its border to rounding, ``curves`` the single constraints around it.
"""

from __future__ import annotations

import numpy as np

from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.optimum.border import outlines_of
from tmmcalc.cams.optimum.curves import curves
from tmmcalc.cams.optimum.plane import Plane
from tmmcalc.cams.optimum.results import Contour
from tmmcalc.cams.optimum.scene import Scene

FINE = 27  # nodes a side that show its border
WINDOW = 0.45  # of the region's size that the picture shows beyond it


def contour(scene: Scene, height: float, seeds: tuple[Values, Values]) -> Contour:
    """The contour at H2 around points S0, r2 (n,) that are known to be feasible."""
    plane = Plane(scene, height)
    box = plane.box_of(np.stack(seeds))
    box = plane.limited(box + WINDOW * np.diff(box, axis=1) * np.array([-1.0, 1.0]))
    x, y = np.linspace(box[:, 0], box[:, 1], FINE).T
    held = plane.grid(x, y)
    single = tuple(curves(plane, x, y, held))
    (left, right), (low, high) = box.tolist()
    return Contour(height, tuple(outlines_of(plane, x, y, held.min(axis=0))), single, (left, right, low, high))
