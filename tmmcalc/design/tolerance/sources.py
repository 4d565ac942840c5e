"""What varies: dimensions within their deviations, and clearances of pairs as massless links of constant length.

A clearance of a pin moves it by half of the clearance in any direction, all of them alike, or towards one that is told:
the pin rests on its bearing (a massless link of that length, as is usual; contact is never lost). One of a slider moves
its guide by half of it to one side or the other, each as often, or to one that is told. A clearance itself may lie
between two ends, as that of a fit does. A source has one number of its own, and dimensions of one group share a second
one: their normal scores correlate by the product of the roots of their coefficients, made alike entirely where these
are 1.
"""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.records import record

Values = NDArray[np.floating[Any]]
Kind = Literal["normal", "uniform", "triangular", "measured"]
KINDS: tuple[Kind, ...] = ("normal", "uniform", "triangular", "measured")
SIGMAS = 3.0  # of a normal distribution in half a tolerance
NODES = 96  # of the quadrature over normal scores


@record
class Dimension:
    """A key that varies by ``low`` to ``high`` about its nominal value, both in the unit of the key.

    A tolerance of a size is that of its magnitude: with a ``sense`` of -1 the value is negative, so that it becomes
    larger by ``low``, and dimensions made alike become larger together.
    """

    name: str
    key: int  # its column among the keys
    low: float
    high: float
    kind: Kind = "normal"
    measured: tuple[float, ...] = ()  # deviations that were measured, in the unit of the key
    group: str = ""  # made alike with the others of it
    correlation: float = 1.0  # of normal scores within the group
    sense: float = 1.0  # 1 or -1: which way a larger score goes

    @property
    def alike(self) -> bool:
        """Whether it is wholly told by its group."""
        return bool(self.group) and self.correlation == 1.0

    def deviation(self, score: Values) -> Values:
        """Deviations at normal scores (n,), so that scores of N(0, 1) give its distribution."""
        middle, half = (self.low + self.high) / 2, (self.high - self.low) / 2
        score = self.sense * score
        if self.kind == "normal":
            return middle + half / SIGMAS * score
        from scipy.special import ndtr

        part = ndtr(score)
        if self.kind == "uniform":
            return np.asarray(middle + half * (2 * part - 1))
        if self.kind == "triangular":
            tail = np.where(part < 0.5, part, ndtr(-score))  # no digits of the upper tail are lost
            return np.asarray(middle - np.sign(0.5 - part) * half * (1 - np.sqrt(2 * tail)))
        ordered = np.sort(np.array(self.measured))
        return np.asarray(ordered[np.minimum((part * len(ordered)).astype(int), len(ordered) - 1)])

    @property
    def ends(self) -> tuple[float, float]:
        """The deviations at the least and at the largest score."""
        return (self.low, self.high) if self.sense > 0 else (self.high, self.low)

    def scaled(self, factor: float) -> Dimension:
        """The same with deviations that are so many times as large."""
        measured = tuple(factor * each for each in self.measured)
        return replace(self, low=factor * self.low, high=factor * self.high, measured=measured)

    @property
    def mean(self) -> float:
        """Mean deviation."""
        return float(np.mean(self.measured)) if self.kind == "measured" else (self.low + self.high) / 2

    @property
    def sigma(self) -> float:
        """Its standard deviation; of measured ones that of the list as the whole population."""
        half = (self.high - self.low) / 2
        if self.kind == "measured":
            return float(np.std(self.measured))
        return half / {"normal": SIGMAS, "uniform": math.sqrt(3), "triangular": math.sqrt(6)}[self.kind]


@record
class Clearance:
    """A pair that has play: two coordinates x and y of a pin or of a guide, which move by its ``radius``.

    A pin without a direction ``along`` moves on a circle; one with it, or a guide, whose normal it is, moves along it:
    to either of the two ``sides``, or to that of the direction.
    """

    name: str
    keys: tuple[int, int]  # columns of x and y among the keys
    radius: Dimension  # half of the clearance, as a deviation from none; its key is that of x
    along: tuple[float, float] | None = None
    sides: bool = False
    scale: tuple[float, float] = (1.0, 1.0)  # units of x and y in one of the radius

    @property
    def pin(self) -> bool:
        """Whether it may go in any direction of the plane."""
        return self.along is None

    @property
    def drawn(self) -> bool:
        """Whether its direction is drawn."""
        return self.pin or self.sides

    @property
    def varies(self) -> bool:
        """Whether the clearance itself does."""
        return self.radius.high > self.radius.low

    @property
    def largest(self) -> float:
        """Half of the largest clearance."""
        return self.radius.high

    def shift(self, part: Values, radius: Values) -> Values:
        """Shifts (n, 2) of these radii at numbers (n,) from 0 to 1: parts of a turn, or below and from 0.5 the side."""
        if self.along is None:
            angle = 2 * np.pi * part
            return radius[:, None] * np.column_stack([np.cos(angle), np.sin(angle)]) * self.scale
        side = np.where(part < 0.5, -1.0, 1.0) if self.sides else np.ones(len(part))
        return np.asarray((radius * side)[:, None] * np.multiply(self.along, self.scale))

    @property
    def mean(self) -> Values:
        """Mean shift (2,)."""
        if self.along is None or self.sides:
            return np.zeros(2)
        return self.radius.mean * np.multiply(self.along, self.scale)

    @property
    def covariance(self) -> Values:
        """Covariance of the shifts (2, 2)."""
        square = self.radius.sigma**2
        if self.drawn:
            square += self.radius.mean**2
        own = 0.5 * np.eye(2) if self.along is None else np.outer(self.along, self.along)
        return np.asarray(square * own * np.outer(self.scale, self.scale))


@record
class Sources:
    """All that varies of a scene with ``keys`` numbers."""

    keys: int
    dimensions: tuple[Dimension, ...] = ()
    clearances: tuple[Clearance, ...] = ()

    @property
    def groups(self) -> tuple[str, ...]:
        """The groups, in their order."""
        return tuple(dict.fromkeys(each.group for each in self.dimensions if each.group))

    @property
    def names(self) -> tuple[str, ...]:
        """The independent parts: groups and single dimensions in their order, then clearances."""
        return tuple(dict.fromkeys(each.group or each.name for each in self.dimensions)) + tuple(
            each.name for each in self.clearances
        )

    @property
    def count(self) -> int:
        """Numbers of a sample: of each dimension that is not wholly its group's, each group, what of each clearance."""
        of_clearances = sum(pair.drawn + pair.varies for pair in self.clearances)
        return sum(not each.alike for each in self.dimensions) + len(self.groups) + of_clearances

    def scaled(self, factors: Values) -> Sources:
        """The same with deviations and clearances that are ``factors`` (parts,) times as large."""
        by_part = dict(zip(self.names, map(float, factors), strict=True))
        return Sources(
            self.keys,
            tuple(each.scaled(by_part[each.group or each.name]) for each in self.dimensions),
            tuple(replace(each, radius=each.radius.scaled(by_part[each.name])) for each in self.clearances),
        )

    def part_of(self, dimension: Dimension) -> int:
        """The independent part that a dimension belongs to."""
        return self.names.index(dimension.group or dimension.name)

    def parts(self, uniform: Values) -> Values:
        """Changes (n, parts, keys) of the keys by every part, at points (n, count) of the unit cube."""
        from scipy.special import ndtri

        edge = 2.0**-53
        drawn = np.clip(uniform, edge, 1 - edge)
        found = np.zeros((len(uniform), len(self.names), self.keys))
        shared = {group: ndtri(drawn[:, at]) for at, group in enumerate(self.groups)}
        at = len(shared)
        for each in self.dimensions:
            score = np.zeros(len(uniform))
            if not each.alike:
                score, at = ndtri(drawn[:, at]), at + 1
            if each.group:
                share = each.correlation
                score = math.sqrt(share) * shared[each.group] + math.sqrt(1 - share) * score
            found[:, self.part_of(each), each.key] += each.deviation(score)
        for number, pair in enumerate(self.clearances, len(self.names) - len(self.clearances)):
            part = uniform[:, at] if pair.drawn else np.zeros(len(uniform))
            at += pair.drawn
            radius = pair.radius.deviation(ndtri(drawn[:, at]) if pair.varies else np.zeros(len(uniform)))
            at += pair.varies
            found[:, number, list(pair.keys)] += pair.shift(part, radius)
        return found

    def mean(self) -> Values:
        """Mean change of every key (keys,)."""
        found = np.zeros(self.keys)
        for each in self.dimensions:
            found[each.key] += each.mean
        for pair in self.clearances:
            found[list(pair.keys)] += pair.mean
        return found

    def covariances(self) -> Values:
        """Covariance of the changes by every part, (parts, keys, keys)."""
        found = np.zeros((len(self.names), self.keys, self.keys))
        for each in self.dimensions:
            for other in self.dimensions:
                if each is other or (each.group and each.group == other.group):
                    found[self.part_of(each), each.key, other.key] += covariance(each, other)
        for number, pair in enumerate(self.clearances, len(self.names) - len(self.clearances)):
            found[number][np.ix_(pair.keys, pair.keys)] += pair.covariance
        return found


def covariance(one: Dimension, other: Dimension) -> float:
    """Of two dimensions of a group, or of one with itself.

    Gauss and Hermite over both normal scores; of two normal ones the product of their sigmas and the correlation.
    """
    if one is other:
        return one.sigma**2
    both = math.sqrt(one.correlation * other.correlation)
    if one.kind == other.kind == "normal":
        return both * one.sense * other.sense * one.sigma * other.sigma
    if one.correlation == other.correlation == 1.0:
        part = (np.arange(2**16) + 0.5) / 2**16  # of one score alone, steps of measured ones too
        from scipy.special import ndtri

        score = ndtri(part)
        return float(np.mean((one.deviation(score) - one.mean) * (other.deviation(score) - other.mean)))
    score, weight = np.polynomial.hermite_e.hermegauss(NODES)
    weight = weight / weight.sum()
    second = both * score[:, None] + math.sqrt(1 - both**2) * score
    inner = (other.deviation(second.ravel()).reshape(second.shape) - other.mean) @ weight
    return float(weight @ ((one.deviation(score) - one.mean) * inner))
