"""Influence coefficients of a pressure that is linear between the nodes of a grid of equilateral triangles.

A node carries a hexagonal pyramid of pressure, 1 at the node and 0 at its six neighbours. Its settlement of an
elastic half-space is the integral of pressure/distance. Lengths are in steps of the grid, oblique axes i and j are
60 deg apart.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.numerics.roots import Indices

HEIGHT = 3**0.5 / 2  # of a triangle; the volume of a pyramid as well


def influence(i: Indices, j: Indices) -> Values:
    """w (n,): settlement at the node (i, j) (n,) by the unit pyramid at (0, 0), over c/(pi E*).

    Integrals over each triangle are exact sums over its edges; an edge whose line holds the point adds nothing.

    >>> influence(np.array([0, 1]), np.array([0, 0])).round(6).tolist()
    [2.854278, 0.951426]
    """
    at = np.stack((i + j / 2, HEIGHT * j), axis=-1)
    found = np.zeros(len(at))
    turn = np.radians(60.0 * np.arange(7))
    corners = np.stack((np.cos(turn), np.sin(turn)), axis=-1)
    for k in range(6):
        outwards = (corners[k] + corners[k + 1]) / (2 * HEIGHT)
        mass, moment = _potentials(at, np.array([[0.0, 0.0], corners[k], corners[k + 1]]))
        found += (1 - at @ outwards / HEIGHT) * mass - moment @ outwards / HEIGHT
    return found


def _potentials(at: Values, triangle: Values) -> tuple[Values, Values]:
    """Integrals of 1/rho (n,) and of the vector from the point over rho (n, 2) over a triangle, counter-clockwise."""
    mass, moment = np.zeros(len(at)), np.zeros((len(at), 2))
    for a, b in zip(triangle, np.roll(triangle, -1, axis=0), strict=True):
        along = (b - a) / np.hypot(*(b - a))
        normal = np.array([along[1], -along[0]])
        h, first, last = (a - at) @ normal, (a - at) @ along, (b - at) @ along
        size = np.where(h == 0, 1.0, np.abs(h))
        width = np.where(h == 0, 0.0, np.arcsinh(last / size) - np.arcsinh(first / size))
        stretch = np.hypot(h, last) - np.hypot(h, first)
        mass += h * width
        moment += (h / 2)[:, None] * ((h * width)[:, None] * normal + stretch[:, None] * along)
    return mass, moment


def settlement(i: Indices, j: Indices) -> Callable[[Values], Values]:
    """W as a function: from pyramids q (n,) at the nodes to their settlement (n,) over c/(pi E*), by a convolution."""
    reach = int(max(np.ptp(i), np.ptp(j)))
    side = np.arange(-reach, reach + 1)
    rows, columns = np.meshgrid(side, side, indexing="ij")
    length = min(factor * 2 ** int(np.ceil(np.log2(len(side) / factor))) for factor in (1, 3, 5))  # fast to transform
    table = np.zeros((length, length))
    table[rows, columns] = influence(rows.ravel(), columns.ravel()).reshape(rows.shape)
    kernel = np.fft.rfft2(table)
    places = i - i.min(), j - j.min()

    def settle(q: Values) -> Values:
        grid = np.zeros(table.shape)
        grid[places] = q
        return np.asarray(np.fft.irfft2(kernel * np.fft.rfft2(grid), table.shape)[places])

    return settle


def hexagon(cells: int) -> tuple[Indices, Indices]:
    """Oblique indices of the 3 N (N + 1) + 1 nodes of a hexagon of ``cells`` steps from the middle to a corner.

    >>> len(hexagon(6)[0])
    127
    """
    side = np.arange(-cells, cells + 1)
    i, j = (each.ravel() for each in np.meshgrid(side, side, indexing="ij"))
    inside = np.abs(i + j) <= cells
    return i[inside], j[inside]
