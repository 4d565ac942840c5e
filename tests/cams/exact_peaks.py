"""Extremes over the turn at 50 digits: places by a dense grid of plain floats, values by Newton or a golden section.

A function of the turn is f(lib, phi, motion, piece) in the numbers of ``lib``, which is `PLAIN` (arrays) or mp; all it
does is written with the functions that both have.
"""

from __future__ import annotations

from itertools import pairwise
from types import SimpleNamespace

import numpy as np
from mpmath import mp, mpf

from cams.exact import motion_at

PLAIN = SimpleNamespace(
    mpf=float, pi=np.pi, sqrt=np.sqrt, sin=np.sin, cos=np.cos, tan=np.tan, atan2=np.arctan2, hypot=np.hypot,
    expj=lambda x: np.exp(1j * x), conj=np.conj, most=np.maximum,
    sign=np.sign, where=np.where,
)  # fmt: skip
EXACT = SimpleNamespace(
    mpf=mpf, pi=mp.pi, sqrt=mp.sqrt, sin=mp.sin, cos=mp.cos, tan=mp.tan, atan2=mp.atan2, hypot=mp.hypot,
    expj=mp.expj, conj=mp.conj, most=max,
    sign=mp.sign, where=lambda if_, then, other: then if if_ else other,
)  # fmt: skip
GRID = 201  # points of a piece
CLOSE = 1e-3  # of the largest: crests of the grid no further below the best of all are looked at closely
NOISE = 1e-12  # of the largest: what is no crest but rounding
GOLD = (mp.sqrt(5) - 1) / 2


def edges_of(program):
    """Edges of the pieces in 50 digits."""
    found, start = [mpf(0)], mpf(0)
    for phase in program.phases:
        breaks = [mpf(0), mpf(1)] if phase.law is None else list(map(mpf, phase.law.breaks.tolist()))
        if phase.law is not None and phase.end < phase.start:
            breaks = [1 - each for each in reversed(breaks)]
        angle = mpf(phase.angle)
        found += [start + angle * each for each in breaks[1:]]
        start += angle
    return found


def at(program, f, phi, piece):
    """A function in 50 digits."""
    return f(EXACT, phi, motion_at(program, phi, piece), piece)


def extremes(program, f, kinds=None, breaks=()):
    """(value, phi) of the least and of the largest value over the turn, or over phases of some kinds.

    ``breaks`` [rad] are further places where f may have a kink or a jump.
    """
    return tuple(_extreme(program, f, sign, kinds, breaks) for sign in (-1, 1))


def _extreme(program, f, sign, kinds, breaks):
    exact, rows = edges_of(program), []
    for piece, (low, high) in enumerate(zip(program.edges, program.edges[1:], strict=False)):
        if kinds is not None and program.phases[program.places[0][piece]].kind not in kinds:
            continue
        parts = [exact[piece], *(mpf(x) for x in sorted(breaks) if low + 1e-9 < x < high - 1e-9), exact[piece + 1]]
        for begin, end in pairwise(parts):
            x = np.linspace(float(begin), float(end), GRID)
            inside = np.clip(x, low, high)
            inside[[0, -1]] = x[[0, -1]] * (1 - 1e-13) + x[[1, -2]] * 1e-13  # a jump at a break is left to the inside
            values = sign * np.asarray(f(PLAIN, inside, program.at(inside, np.full(GRID, piece)), piece)) + 0 * x
            rows.append((piece, begin, end, x, values))
    best = max(float(np.max(values)) for *_, values in rows)
    size = max(float(np.max(np.abs(values))) for *_, values in rows)
    found = [
        _closer(program, f, sign, *row, k)
        for *row, values in rows
        for k in _crests(values, NOISE * size)
        if values[k] >= best - CLOSE * size
    ]
    value, phi = max(found, key=lambda each: each[0])
    return sign * value, phi


def _crests(values, noise):
    """Where a grid is higher than beside, on both sides or at an end; its highest point is one in any case."""
    rise = np.diff(values)
    up, down = np.append(True, rise > noise), np.append(rise < -noise, True)
    return {int(np.argmax(values)), *np.flatnonzero(up & down).tolist()}


def _closer(program, f, sign, piece, begin, end, x, k):
    """The largest value in 50 digits near a point of a grid."""
    nudge = (end - begin) * mpf(10) ** -40  # on its own side of a break

    def g(phi):
        return sign * at(program, f, min(max(phi, begin + nudge), end - nudge), piece)

    low, high = mpf(x[max(k - 1, 0)]), mpf(x[min(k + 1, GRID - 1)])
    low, high = max(low, begin), min(high, end)
    tried = [(g(each), each) for each in (low, mpf(x[k]), high)]
    if _falls_from(max(tried), g, low, high):
        return max(tried)
    phi, h = mpf(x[k]), (end - begin) * mpf(10) ** -12
    phi = min(max(phi, begin + 2 * h), end - 2 * h)
    for _ in range(6):
        left, here, right = g(phi - h), g(phi), g(phi + h)
        bend = left - 2 * here + right
        if bend >= 0:
            break
        step = h * (right - left) / (2 * bend)
        phi = min(max(phi - step, low), high)
        if abs(step) < mpf(10) ** -16:
            tried.append((g(phi), phi))
            return max(tried, key=lambda each: each[0])
    size = max(abs(each) for each, _ in tried)
    if max(each for each, _ in tried) - min(each for each, _ in tried) > mpf(10) ** -40 * size:
        tried.append(_kink(g, low, high, size) or _golden(g, low, high))
    return max(tried, key=lambda each: each[0])


def _falls_from(best, g, low, high):
    """Whether the highest of the tried places is an end from which the function falls."""
    (value, place), h = best, (high - low) * mpf(10) ** -15
    return (place == low and g(low + h) < value) or (place == high and g(high - h) < value)


def _kink(g, low, high, size):
    """Where the tangents from both sides of a kink meet, again and again; None if they come to no such place."""
    h = (high - low) * mpf(10) ** -15

    def tangent(x, way):
        value = g(x)
        return x, value, (g(x + way * h) - value) / (way * h)

    (a, at_a, up), (b, at_b, down) = tangent(low, 1), tangent(high, -1)
    for _ in range(9):
        if up <= 0 or down >= 0:
            return None
        x = (at_b - at_a + up * a - down * b) / (up - down)
        if not a < x < b:
            return None
        value = g(x)
        if abs(at_a + up * (x - a) - value) < mpf(10) ** -30 * size:
            return value, x
        right = (g(x + h) - value) / h
        if right > 0:
            a, at_a, up = x, value, right
        else:
            b, at_b, down = tangent(x, -1)
    return None


def _golden(g, low, high):
    """The largest value between two places, also at a kink."""
    a, b = high - GOLD * (high - low), low + GOLD * (high - low)
    at_a, at_b = g(a), g(b)
    while high - low > mpf(10) ** -22:
        if at_a > at_b:
            high, b, at_b = b, a, at_a
            a = high - GOLD * (high - low)
            at_a = g(a)
        else:
            low, a, at_a = a, b, at_b
            b = low + GOLD * (high - low)
            at_b = g(b)
    return max((at_a, a), (at_b, b))


def crossing(g, near, width=1e-6):
    """The root in 50 digits of a function near a place."""
    h = mpf(10) ** -15
    x = mpf(near)
    for _ in range(6):
        slope = (g(x + h) - g(x - h)) / (2 * h)
        x -= g(x) / slope
    assert abs(x - mpf(near)) < width
    return x
