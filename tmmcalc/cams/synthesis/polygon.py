"""The intersection of half planes Re(p conj(n)) <= c as a polygon: n unit normals, c distances from the origin."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tmmcalc.cams.follower import Complex
from tmmcalc.cams.laws.law import Indices, Values

EDGE = 1e-12  # relative: a corner this near to a line lies on it
CHECK = 1e-9  # relative: corners of lines of nearly one direction are less exact
SAME = 1e-9  # [rad] of two lines that are nearer in direction one counts


def crossings(normal: Complex, bound: Values, one: Indices, other: Indices) -> Complex:
    """Where the lines numbered ``one`` and ``other`` (m,) cross; parallel ones give inf or NaN."""
    a, b = normal[one], normal[other]
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.asarray(1j * (bound[other] * a - bound[one] * b) / (np.conj(a) * b).imag)


def polygon(normal: Complex, bound: Values) -> tuple[Complex, Indices]:
    """Corners (m,) of the intersection, counter-clockwise, and the line that leads from each to the next.

    The normals have to enclose the plane; no corners if the intersection is empty.
    """
    angle = np.angle(normal)
    order = np.argsort(angle, kind="stable")
    fresh = np.concatenate(([True], np.diff(angle[order]) > SAME))
    order = order[np.lexsort((bound[order], np.cumsum(fresh)))][fresh]  # of one direction the tightest
    slack = EDGE * float(np.max(np.abs(bound)))
    lines: list[int] = []
    for k in order.tolist():
        while len(lines) > 1 and _outside(normal, bound, lines[-2], lines[-1], k, slack):
            lines.pop()
        while len(lines) > 1 and _outside(normal, bound, lines[0], lines[1], k, slack):
            lines.pop(0)
        lines.append(k)
    while len(lines) > 2 and _outside(normal, bound, lines[-2], lines[-1], lines[0], slack):
        lines.pop()
    while len(lines) > 2 and _outside(normal, bound, lines[0], lines[1], lines[-1], slack):
        lines.pop(0)
    ring = np.array(lines, dtype=np.intp)
    corners = crossings(normal, bound, np.roll(ring, 1), ring)
    if len(ring) < 3 or not _inside(normal, bound, corners, slack):
        return np.empty(0, complex), np.empty(0, np.intp)
    return corners, ring


def _outside(normal: Complex, bound: Values, i: int, j: int, k: int, slack: float) -> bool:
    """Whether the corner of lines i and j lies outside line k."""
    a, b = complex(normal[i]), complex(normal[j])
    turn = (a.conjugate() * b).imag
    if turn == 0:
        return True
    corner = 1j * (float(bound[j]) * a - float(bound[i]) * b) / turn
    return (corner * complex(normal[k]).conjugate()).real > float(bound[k]) - slack


def _inside(normal: Complex, bound: Values, corners: Complex, slack: float) -> bool:
    over: NDArray[np.floating] = (corners[:, None] * np.conj(normal)).real - bound
    return bool(np.all(np.isfinite(corners)) and np.max(over) <= CHECK * slack / EDGE)
