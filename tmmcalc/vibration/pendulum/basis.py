"""The Ritz functions of the rod: a straight tilt, and bends whose curvature is a Legendre polynomial on one element.

    f_0 = s,   f'' = P_k(t) on an element, 0 elsewhere, f(0) = f'(0) = 0        s = a/l from 0 to 1, -1 <= t <= 1

With P_0 and P_1 alone they span the Hermite cubics of the elements. The bending energy of the tilt is exactly zero, so
a rod of any stiffness loses no digits of its rigid motion; a clamped rod leaves the tilt out. On elements of very
different size, which only soft rods need, tilt, P_0 and P_1 give way to the Hermite cubics of the nodes: they are the
same space, and there they are far better conditioned.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tmmcalc.core.numerics.gauss import legendre, rule, wide_rule
from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.records import record

GRADING = 0.2  # ratio of neighbouring elements towards a layer


@record
class Basis:
    """Edges of the elements from 0 to 1, highest degree of the displacement in each, whether the rod may tilt."""

    edges: tuple[float, ...]
    degree: int
    tilts: bool
    nodal: bool = False  # whether Hermite cubics of the nodes stand for tilt, P_0 and P_1

    @property
    def count(self) -> int:
        """Number of functions."""
        return (len(self.edges) - 1) * (self.degree - 1) + self.tilts


class Samples(NamedTuple):
    """The functions at points: values and derivatives by s, (n, m)."""

    value: Values
    slope: Values
    curvature: Values


def sample(basis: Basis, s: Values) -> Samples:
    """All functions at places s (m,) in 0 .. 1; on an edge the curvature is that below it."""
    zero = np.zeros_like(s)
    rows = [(s, np.ones_like(s), zero)] if basis.tilts and not basis.nodal else []
    if basis.nodal:
        rows += _hermite(basis, s)
    for low, high in zip(basis.edges, basis.edges[1:], strict=False):
        rows += _bends(low, high, basis.degree - 1, s)[2 * basis.nodal :]
    value, slope, curvature = (np.array(part) for part in zip(*rows, strict=True))
    return Samples(value, slope, curvature)


def _bends(low: float, high: float, many: int, s: Values) -> list[tuple[Values, Values, Values]]:
    """The functions with curvature on one element: 0 before it, straight behind it."""
    half = (high - low) / 2
    t = np.clip((s - low) / half - 1, -1.0, 1.0)
    inside = (s >= low) & (s <= high)
    p = legendre(t, many + 2)
    k = np.arange(1, many + 2)[:, None]
    first = np.vstack(((t + 1)[None], (p[2 : many + 3] - p[: many + 1]) / (2 * k + 1)))
    k = np.arange(1, many)[:, None]
    second = np.vstack(((t + 1)[None] ** 2 / 2, (first[2 : many + 1] - first[: many - 1]) / (2 * k + 1)))
    beyond = np.maximum(s - high, 0.0)
    return [
        (half**2 * second[i] + (2 * half * beyond if i == 0 else 0.0), half * first[i], np.where(inside, p[i], 0.0))
        for i in range(many)
    ]


def _hermite(basis: Basis, s: Values) -> list[tuple[Values, Values, Values]]:
    """Unit displacement and unit turn of every node but the displacement of the first one, and its turn if clamped."""
    edges = basis.edges
    listed = []
    for node, at in enumerate(edges):
        parts = np.zeros((2, 3, len(s)), np.result_type(s, type(at)))
        for other in (node - 1, node + 1):
            if 0 <= other < len(edges):
                h = edges[other] - at  # negative below the node: the cubic is the same, mirrored
                last = node == len(edges) - 1
                inside = (s > edges[other]) & ((s < at) | last) if h < 0 else (s >= at) & (s <= edges[other])
                x = np.where(inside, (s - at) / h, 0.0)
                whole = np.stack(((1 + 2 * x) * (1 - x) ** 2, 6 * x * (x - 1) / h, (12 * x - 6) / h**2))
                turned = np.stack((x * (1 - x) ** 2 * h, (1 - x) * (1 - 3 * x), (6 * x - 4) / h))
                parts += np.where(inside, np.stack((whole, turned)), 0.0)
        first = 0 if node else 1 if basis.tilts else 2
        listed += [(part[0], part[1], part[2]) for part in parts[first:]]
    return listed


def gauss(basis: Basis) -> tuple[Values, Values]:
    """Points (m,) and weights (m,) that integrate products of two functions and of the tension exactly."""
    edges = np.array(basis.edges)
    wide = edges.dtype != float
    points, weights = wide_rule(basis.degree + 2) if wide else rule(basis.degree + 2)[:2]
    width = np.diff(edges)
    return (edges[:-1, None] + width[:, None] * points).ravel(), (width[:, None] * weights).ravel()


def graded(top: float, bottom: float) -> tuple[float, ...]:
    """Edges that close in on both ends of the rod, as far as layers of these thicknesses (parts of its length) ask.

    >>> graded(1.0, 1.0), graded(0.01, 1.0)
    ((0.0, 1.0), (0.0, 0.02, 0.1, 0.5, 1.0))
    """
    upper = _towards(top)
    lower = [1 - edge for edge in _towards(bottom)]
    return tuple(sorted({0.0, 1.0, *upper, *lower}))


def _towards(thickness: float) -> list[float]:
    edges = []
    edge = 0.5
    while edge > 1.5 * thickness and thickness < 0.1:
        edges.append(round(edge, 15))
        edge *= GRADING
    return edges
