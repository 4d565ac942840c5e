"""A law of motion: the dimensionless displacement s of a follower over the part k of its phase, with exact derivatives.

    s(0) = 0,  s(1) = 1,  s'(0) = s'(1) = 0            k = phi/phi_phase in [0, 1]

A law is made of pieces, each smooth: a polynomial of t = k - (start of the piece) and a harmonic of the same t,

    s = c0 + c1 t + c2 t^2 + ... + A sin(w t + p)

so that derivatives are exact, and a jump of a derivative can only stand between two pieces, where either side is
known by the number of its piece.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.records import record

Values = NDArray[np.floating[Any]]
Number = Values | np.floating[Any] | float
Indices = NDArray[np.intp]
ORDERS = 4  # s and its first three derivatives


@record
class Law:
    """P pieces of a law; breaks ascend from 0 to 1."""

    name: str
    breaks: Values  # (P + 1,)
    coefficients: Values  # (P, D + 1), of the powers of t, ascending
    amplitude: Values  # (P,)
    frequency: Values  # (P,)
    phase: Values  # (P,) [rad]

    @property
    def count(self) -> int:
        """Number of pieces."""
        return len(self.breaks) - 1

    def piece(self, k: Values) -> Indices:
        """Numbers of the pieces that hold k; between two pieces the earlier one."""
        return np.searchsorted(self.breaks[1:-1], k, side="left")

    def at(self, k: Values, piece: Indices | None = None) -> Values:
        """s, s', s'', s''' at k (n,) in [0, 1], (4, n); ``piece`` (n,) says which side of a break is meant.

        >>> from tmmcalc.cams.laws.catalogue import LAWS
        >>> LAWS["cosine"].at(np.array([0.5])).round(9).ravel().tolist()
        [0.5, 1.570796327, 0.0, -15.50313834]
        """
        i = self.piece(k) if piece is None else piece
        t = k - self.breaks[i]
        values = np.empty((ORDERS, len(t)), t.dtype)
        for order, rows in enumerate(self._derivatives):
            c = rows[i] if self.count > 1 else rows  # a single row serves all k
            value = np.zeros(len(t)) + c[:, -1]
            for power in range(c.shape[1] - 2, -1, -1):
                value = value * t + c[:, power]
            values[order] = value
        if np.any(self.amplitude):
            a, w, p = self.amplitude[i], self.frequency[i], self.phase[i]
            sine, cosine = a * np.sin(w * t + p), a * np.cos(w * t + p)
            values += np.stack((sine, w * cosine, -w * w * sine, -(w**3) * cosine))
        return values

    @cached_property
    def wider(self) -> Law:
        """The same in extended precision, for the estimates of errors: made once for a law of the catalogue."""
        held = (self.breaks, self.coefficients, self.amplitude, self.frequency, self.phase)
        return Law(self.name, *(each.astype(np.longdouble) for each in held))

    @cached_property
    def _derivatives(self) -> tuple[Values, ...]:
        """Coefficients of the polynomial and of its derivatives."""
        found = [self.coefficients]
        for _ in range(ORDERS - 1):
            c = found[-1]
            found.append(c[:, 1:] * np.arange(1, c.shape[1]) if c.shape[1] > 1 else np.zeros((self.count, 1)))
        return tuple(found)


def polynomial(name: str, *pieces: tuple[float, Sequence[float]]) -> Law:
    """A law of polynomials: each piece by its start and the coefficients of the powers of k - start, ascending.

    >>> polynomial("linear", (0.0, [0, 0, 3, -2])).at(np.array([0.5]))[:2].ravel().tolist()
    [0.5, 1.5]
    """
    size = max(len(c) for _, c in pieces)
    rows = np.array([[*c, *[0.0] * (size - len(c))] for _, c in pieces], dtype=float)
    still = np.zeros(len(pieces))
    return Law(name, np.array([*(start for start, _ in pieces), 1.0]), rows, still, still, still)


def harmonic(name: str, coefficients: Sequence[float], amplitude: float, frequency: float, phase: float) -> Law:
    """A law of one piece: a polynomial of k and A sin(w k + p).

    >>> harmonic("cosine", [0.5], -0.5, np.pi, np.pi / 2).at(np.array([0.5]))[0].round(9).tolist()
    [0.5]
    """
    wave = (np.array([value]) for value in (amplitude, frequency, phase))
    return Law(name, np.array([0.0, 1.0]), np.array([coefficients]), *wave)


@record
class Acceleration:
    """A piece of s'': polynomial of t and a harmonic A sin(w t + p)."""

    start: float
    coefficients: tuple[float, ...] = (0.0,)
    amplitude: float = 0.0
    frequency: float = 0.0
    phase: float = 0.0


def of_acceleration(name: str, *pieces: Acceleration) -> Law:
    """The law that has this acceleration, to scale: integrated exactly, then s(1) = 1 (5.6 to 5.8).

    The areas above and below zero have to be equal: else s'(1) is not 0, which is left for the caller to judge.
    Summed up in extended precision, so that the coefficients are rounded but once.
    """
    breaks = np.array([*(piece.start for piece in pieces), 1.0], np.longdouble)
    size = max(len(piece.coefficients) for piece in pieces)
    rows = np.zeros((len(pieces), size + 2), np.longdouble)
    wave = np.zeros((3, len(pieces)), np.longdouble)
    slope = place = np.longdouble(0.0)
    for i, (piece, width) in enumerate(zip(pieces, np.diff(breaks), strict=True)):
        powers = np.arange(len(piece.coefficients))
        rows[i, 2 : 2 + len(powers)] = np.array(piece.coefficients, np.longdouble) / ((powers + 1) * (powers + 2))
        if piece.amplitude:
            w = np.longdouble(piece.frequency)
            wave[:, i] = -piece.amplitude / w**2, w, piece.phase
        a, w, p = wave[:, i]
        rows[i, :2] = place - a * np.sin(p), slope - a * w * np.cos(p)
        t = width ** np.arange(size + 2)
        place = rows[i] @ t + a * np.sin(w * width + p)
        slope = rows[i, 1:] * np.arange(1, size + 2) @ t[:-1] + a * w * np.cos(w * width + p)
    held = breaks, rows / place, wave[0] / place, wave[1], wave[2]
    return Law(name, *(each.astype(float) for each in held))
