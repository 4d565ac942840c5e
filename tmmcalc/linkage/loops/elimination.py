"""All assemblies of a group of one or two loops, by elimination: none can be missed.

Two unknowns are private, each to one loop, after the loops are combined: coordinates of prismatic joints first, else
angles. The loops then read U_r = -V_r, or s_r e_r = -V_r, with V_r = v_r + b_r w, and say of the two others, X and w,

    |V_r| = 1                  where an angle was eliminated
    Im(conj(e_r) V_r) = 0      where a coordinate was; e_r is known, or turns with X, w, or the other private angle

If w is a unit vector, either is Re(conj(Q_r) w) = c_r, and both have a common solution where

    h = |c_1 Q_2 - c_2 Q_1|^2 - Im(conj(Q_1) Q_2)^2 = 0

If w is a third coordinate, either is Q_r w = c_r with real Q_r, and h = c_1 Q_2 - c_2 Q_1. Q and c are of degree one in
X = exp(i theta), so h is a trigonometric polynomial of degree four at most (with four revolute links: three, hence six
assemblies at most), known from its values at equal steps. Four angles and coordinates always leave such an X, for no
group holds four prismatic joints. With one loop there is no X, and its one equation gives w. So it is where some
combination of two loops is free of two coordinates: it gives both angles. Once all angles are there, the coordinates
follow from linear equations.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import combinations, permutations
from typing import NamedTuple

import numpy as np

from tmmcalc.core.plane import Plane, Real
from tmmcalc.linkage.loops.closure import Loops

SAMPLES = 16  # of h over a turn
DEGREE = 4  # of h, at most
NOTHING = 1e-13  # of the largest coefficient: rounding of one that is zero
CIRCLE = 1e-3  # distance of a root from the unit circle that may be rounding: two assemblies that nearly coincide
SINGULAR = 1e-9  # determinant of two columns of length one that eliminate nothing


class _Line(NamedTuple):
    """The direction of a prismatic joint: ``turn`` times the vector of a class, or known (``of`` is None)."""

    of: int | None
    turn: complex


class _Order(NamedTuple):
    """Which unknowns are private, which one is X (None with one loop), which one w, by number: angles come first."""

    private: tuple[int, ...]
    x: int | None
    w: int


class _Reduced(NamedTuple):
    """The L loops after elimination: V = k + a X + b w, where b turns with X if w is a coordinate whose line does."""

    order: _Order
    k: Plane  # (L,)
    a: Plane  # (L,)
    b: Plane  # (L,)
    own: tuple[_Line | None, ...]  # lines of the private unknowns that are coordinates
    along: _Line | None  # line of w, if it is one

    def parts(self, x: Plane) -> tuple[Plane, Plane]:
        """v and b, each (L, n), at X (n,)."""
        b = np.ones_like(x) if self.along is None else _direction(self.along, x)
        return self.k[:, None] + self.a[:, None] * x, self.b[:, None] * b


def near(loops: Loops) -> Real:
    """Unknowns (N, m) near every assembly of a group of one or two loops; some of them may be near none.

    ``loops`` hold one position.
    """
    eq = loops.equations
    reduced = _reduced(loops)
    angles = [_angles(reduced, x, w) for x in _firsts(reduced) for w in _seconds(reduced, x)]
    start = np.zeros((eq.unknowns, len(angles)))
    count = eq.classes.shape[1]
    start[:count] = np.array(angles).reshape(len(angles), count).T
    placed = loops.place(start)
    for m in range(len(angles) if eq.free else 0):
        start[count:, m] = np.linalg.lstsq(placed.jacobian[:, count:, m], -_real(placed.residual[:, m]))[0]
    return start


def _real(values: Plane) -> Real:
    return np.concatenate((values.real, values.imag))


def _reduced(loops: Loops) -> _Reduced:
    """The loops with the private unknowns that are eliminated best."""
    eq = loops.equations
    count = eq.classes.shape[1]
    lines = [_line(loops, j) for j in range(len(eq.rails))]
    given, classes = loops.given[0][:, 0].copy(), eq.classes.copy()
    for line, rail, column in zip(lines, eq.rails, eq.slides.T, strict=True):
        if rail.driven:
            held = column * line.turn * loops.drive[0]
            (given if line.of is None else classes[:, line.of])[:] += held
    slides = eq.slides[:, eq.free]
    columns = np.concatenate((classes, slides), axis=1)
    if slides.shape[1] == len(slides) == 2 and np.linalg.det(slides) == 0:
        free_of = np.array([slides[1, 0], -slides[0, 0]]) if slides[:, 0].any() else slides[::-1, 1] * [1, -1]
        given, columns = (free_of @ given)[None], (free_of @ classes)[None]
    order = max(_orders(columns, count), key=lambda order: _worth(columns, order))
    solved = np.linalg.solve(columns[:, order.private], np.column_stack((given, columns)))
    k, a, b = solved[:, 0], solved[:, 1 + (order.x or 0)], solved[:, 1 + order.w]
    free = [None] * count + [lines[j] for j in eq.free]
    own = tuple(free[m] for m in order.private)
    return _Reduced(order, k, a if order.x is not None else 0 * a, b, own, free[order.w])


def _line(loops: Loops, j: int) -> _Line:
    along = loops.equations.rails[j].along
    if not along.known:
        return _Line(along.of, along.turn)
    return _Line(None, complex(along.turn * np.ravel(loops.motions[along.of].u)[0]))


def _orders(columns: Plane, count: int) -> Iterator[_Order]:
    """All orders in which as many coordinates as can be are private, and X is an angle."""
    loop_count, unknowns = columns.shape
    most = min(loop_count, unknowns - count)
    for private in combinations(range(unknowns), loop_count):
        if sum(m >= count for m in private) == most:
            for *x, w in permutations(sorted({*range(unknowns)} - {*private})):
                if not x or x[0] < count:
                    yield _Order(private, x[0] if x else None, w)


def _worth(columns: Plane, order: _Order) -> float:
    """How well the private unknowns are eliminated, and how much w stands in every equation."""
    sizes = np.max(np.abs(columns), axis=0)
    pair = columns[:, order.private] / sizes[list(order.private)]
    determinant = float(abs(np.linalg.det(pair)))
    if determinant < SINGULAR:
        return -1.0
    return determinant * float(np.min(np.abs(np.linalg.solve(pair, columns[:, order.w]))))


def _direction(line: _Line, x: Plane) -> Plane:
    """A line (n,) that is known or turns with X."""
    return np.full_like(x, line.turn) if line.of is None else line.turn * x


def _equations(reduced: _Reduced, x: Plane) -> tuple[Plane, Real]:
    """Q and c, each (L, n), at X (n,)."""
    v, b = reduced.parts(x)
    both = [_equation(reduced, m, x, v, b) for m in range(len(v))]
    return np.array([q for q, _ in both]), np.array([c for _, c in both])


def _equation(reduced: _Reduced, m: int, x: Plane, v: Plane, b: Plane) -> tuple[Plane, Real]:
    """Q (n,) and c (n,) of one loop."""
    line, order = reduced.own[m], reduced.order
    if line is None:
        return v[m] * np.conj(b[m]), (1 - np.abs(v[m]) ** 2 - np.abs(b[m]) ** 2) / 2
    if reduced.along is not None:
        e = _direction(line, x)
        return (np.conj(e) * b[m]).imag + 0j, -(np.conj(e) * v[m]).imag
    if line.of == order.w:
        return -1j * np.conj(line.turn) * v[m], -(np.conj(line.turn) * b[m]).imag
    if line.of in order.private:
        o = order.private.index(line.of)
        q = 1j * line.turn * v[o] * np.conj(b[m]) - 1j * np.conj(line.turn) * np.conj(b[o]) * v[m]
        return q, -(np.conj(line.turn) * (np.conj(v[o]) * v[m] + np.conj(b[o]) * b[m])).imag
    e = _direction(line, x)
    return 1j * e * np.conj(b[m]), -(np.conj(e) * v[m]).imag


def _firsts(reduced: _Reduced) -> list[complex]:
    """X wherever h vanishes; with one loop there is none, and one stands for it."""
    if reduced.order.x is None:
        return [1 + 0j]
    turn = np.exp(2j * np.pi * np.arange(SAMPLES) / SAMPLES)
    (q1, q2), (c1, c2) = _equations(reduced, turn)
    across = c1 * q2 - c2 * q1
    h = across.real if reduced.along is not None else np.abs(across) ** 2 - (np.conj(q1) * q2).imag ** 2
    spectrum = np.fft.fft(h)
    largest = float(np.max(np.abs(spectrum)))
    degree = next((n for n in range(DEGREE, 0, -1) if abs(spectrum[n]) > NOTHING * largest), 0)
    roots = np.roots([spectrum[n] for n in range(degree, -degree - 1, -1)])
    unit = roots[np.abs(np.abs(roots) - 1) < CIRCLE]
    return [complex(root) for root in unit / np.abs(unit)]


def _seconds(reduced: _Reduced, x: complex) -> list[complex]:
    """What w may be with X: from both equations, and from each alone, where the two say the same."""
    q, c = (part[:, 0] for part in _equations(reduced, np.array([x])))
    if reduced.along is not None:
        best = int(np.argmax(np.abs(q)))
        return [complex(c[best] / q[best])] if q[best] != 0 else []
    found = []
    determinant = (np.conj(q[0]) * q[-1]).imag
    if determinant != 0:
        found.append(-1j * (c[0] * q[-1] - c[-1] * q[0]) / determinant)
    for own, value in zip(q, c, strict=True):
        if own != 0:
            side = math.sqrt(max(abs(own) ** 2 - value**2, 0.0))
            found += [own * (value + sign * 1j * side) / abs(own) ** 2 for sign in (1, -1)]
    return [complex(w / abs(w)) for w in found if w != 0]


def _angles(reduced: _Reduced, x: complex, w: complex) -> list[float]:
    """Angles (C,) of all classes at X and w: private ones follow from their loops."""
    order = reduced.order
    v, b = reduced.parts(np.array([x]))
    left = -(v + b * w)[:, 0]
    vectors = {m: left[n] for n, m in enumerate(order.private) if reduced.own[n] is None}
    vectors |= {order.w: w} if reduced.along is None else {}
    vectors |= {} if order.x is None else {order.x: x}
    return [float(np.angle(vectors[m])) for m in sorted(vectors)]
