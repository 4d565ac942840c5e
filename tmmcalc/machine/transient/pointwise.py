"""A profile read at one angle in plain floats: a few microseconds, because a solver asks thousands of times.

Beyond its ends a stretch goes on as a parabola, so that a trial step may look over the edge. The derivative of the
inertia is that of the very polynomial of the inertia: only then is the energy kept.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.numerics.panels import Values
from tmmcalc.machine.transient.profile import Profile, taylor

Indices = NDArray[np.intp]

Load = tuple[float, float, float]  # J [kg*m^2], dJ/dtheta [kg*m^2/rad], moment of the load [N*m]
Reader = Callable[[float, float], Load]
Pairs = tuple[tuple[float, float], ...]


class Stretch(NamedTuple):
    """The P pieces between two breaks at one load factor, as rows of floats."""

    low: float  # [rad]
    high: float
    edges: list[float]  # (P + 1,); row 0 goes on below the first edge, row P + 1 above the last
    middles: list[float]  # (P + 2,) the angles that the polynomials are about
    rows: list[Pairs]  # (P + 2,) coefficients of J and of the moment in pairs, the highest first
    speedy: list[Pairs]  # (P + 2,) the same of the viscous and quadratic part; empty if both are zero
    period: float | None  # of a stretch without ends, which goes on round and round


def stretches(profile: Profile, factor: float) -> tuple[Stretch, ...]:
    """The stretches with the technological load multiplied by ``factor``."""
    moments = profile.idle + factor * profile.load
    functions = np.concatenate((profile.inertia[None], moments))
    half = np.diff(profile.edges)[:, None] / 2
    low, high, middle = _continued(functions, -half), _continued(functions, half), profile.edges[:-1] + half[:, 0]
    period = profile.period if profile.wraps else None
    speedy = bool(np.any(moments[1:]))
    made = []
    for a, b in pairwise(profile.starts):
        edges = profile.edges[a : b + 1].tolist()
        parts = np.concatenate((low[:, a : a + 1], functions[:, a:b], high[:, b - 1 : b]), axis=1)
        middles = [edges[0], *middle[a:b].tolist(), edges[-1]]
        rows, more = _pairs(parts[:2]), _pairs(parts[2:]) if speedy else []
        made.append(Stretch(edges[0], edges[-1], edges, middles, rows, more, period))
    return tuple(made)


def _continued(functions: Values, x: Values) -> Values:
    """Parabolas (F, P, D) that continue every piece beyond its end, x (P, 1) from its middle."""
    parabola = np.zeros_like(functions)
    parabola[..., :3] = taylor(functions, x)
    return parabola


def _pairs(functions: Values) -> list[Pairs]:
    """The coefficients of two functions (2, P, D) side by side, the highest first."""
    rows = functions[:, :, ::-1].transpose(1, 2, 0).tolist()
    return [tuple(map(tuple, row)) for row in rows]


def reader(stretch: Stretch, base: float) -> Reader:
    """The function (theta, omega) -> (J, dJ/dtheta, moment of the load at that speed) of one stretch."""
    low, _, edges, middles, rows, speedy, period = stretch

    def read(theta: float, omega: float) -> Load:
        x = theta - base if period is None else (theta - low) % period + low
        i = bisect_right(edges, x)
        x -= middles[i]
        inertia = slope = moment = 0.0
        for a, b in rows[i]:
            slope = slope * x + inertia
            inertia = inertia * x + a
            moment = moment * x + b
        if speedy:
            viscous = quadratic = 0.0
            for a, b in speedy[i]:
                viscous = viscous * x + a
                quadratic = quadratic * x + b
            moment += (viscous + quadratic * omega) * omega
        return inertia, slope, moment

    return read


class Slopes(NamedTuple):
    """What a Jacobian needs at one angle and speed: inertia, load and their partial derivatives."""

    inertia: float  # J
    d_inertia: float  # dJ/dtheta
    d2_inertia: float
    load: float  # moment of the load
    d_angle: float  # its partial derivative by the angle
    d_speed: float  # and by the speed


def slopes(profile: Profile, index: int, base: float, factor: float, theta: float, omega: float) -> Slopes:
    """Inertia and load with their partial derivatives, read in the stretch ``index``."""
    piece, x = _piece(profile, np.array([theta]), np.array([index]), np.array([base]))
    (j, d, c), m, v, q = taylor(_functions(profile, piece, np.array([factor])), x)[:, 0].tolist()
    load = m[0] + (v[0] + q[0] * omega) * omega
    return Slopes(j, d, 2 * c, load, m[1] + (v[1] + q[1] * omega) * omega, v[0] + 2 * q[0] * omega)


def tabulated(
    profile: Profile, theta: Values, omega: Values, factor: Values, index: Indices, base: Values
) -> tuple[Values, Values, Values]:
    """J, dJ/dtheta and moment of the load (m,) at m angles, each read in its own stretch and at its own load factor."""
    piece, x = _piece(profile, theta, index, base)
    inertia, moment, viscous, quadratic = taylor(_functions(profile, piece, factor), x).transpose(0, 2, 1)
    return inertia[0], inertia[1], moment[0] + (viscous[0] + quadratic[0] * omega) * omega


def _functions(profile: Profile, piece: Indices, factor: Values) -> Values:
    """Coefficients (4, m, D) of J, moment, viscous and quadratic part at m load factors."""
    moments = profile.idle[:, piece] + factor[:, None] * profile.load[:, piece]
    return np.concatenate((profile.inertia[None, piece], moments))


def _piece(profile: Profile, theta: Values, index: Indices, base: Values) -> tuple[Indices, Values]:
    """The pieces (m,) of m angles within their stretches, and the distances (m, 1) from their middles."""
    first, starts = profile.edges[0], np.array(profile.starts)
    x = (theta - first) % profile.period + first if profile.wraps else theta - base
    piece = np.clip(np.searchsorted(profile.edges, x, side="right") - 1, starts[index], starts[index + 1] - 1)
    return piece, (x - (profile.edges[piece] + profile.edges[piece + 1]) / 2)[:, None]
