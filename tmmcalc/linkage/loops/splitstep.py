"""A higher group solved by its splitting: the tried angle by bracketing, rates by trial rates.

Of all angles that close the group, the one on the followed branch is meant. It is sought beside the branch with every
combination of the signs of the dyads; a bracket that a dyad reaches over in part only ends at its dead point. The first
derivative of |DE|^2 is affine in the tried angular velocity, the second one in the angular acceleration: two
evaluations of the dyads give either exactly.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any, NamedTuple, cast

import numpy as np

from tmmcalc.core.errors import AccuracyError, UsageError
from tmmcalc.core.numerics.roots import bracketed
from tmmcalc.core.plane import LinkMotion, Point, Real, rotated
from tmmcalc.linkage import solvers
from tmmcalc.linkage.chain import Chain
from tmmcalc.linkage.dyads.base import Motions, Slide, Slides
from tmmcalc.linkage.loops.branch import guess
from tmmcalc.linkage.loops.splitting import Split, split_of
from tmmcalc.linkage.loops.step import LoopStep
from tmmcalc.linkage.structure import Group

DISTANCES = 0.3 * 4.0 ** -np.arange(14.0)  # from the branch, at which the angle is tried first [rad]
HALVINGS = 60  # that find a dead point of a dyad
CLOSED = 1e-10  # part of the removed link's length that may be missing
NEARLY = 1e-6  # and at the dead point of a dyad, where no angle is fine enough, if the signs alone count
BEHIND = 1e-6  # so much farther [rad] a root must be before such a dead point is taken
ASTRAY = 0.05  # distance of unit vectors from the branch, above which it is another assembly

Residual = Callable[[Real, np.ndarray], Real]  # g at tried angles of the positions of these numbers


class Tried(NamedTuple):
    """The group at tried angles: motions and slides of all, and the pins of the removed link."""

    motions: Motions
    slides: Slides
    pins: tuple[Point, Point]

    @property
    def apart(self) -> Point:
        """From the first pin to the second one, with derivatives."""
        return Point(*(b - a for a, b in zip(*self.pins, strict=True)))


class SplitStep(NamedTuple):
    """A group that its splitting solves; in the chain it stands for its loops."""

    group: Group
    variant: int
    loops: LoopStep
    split: Split

    def advance(
        self, motions: Motions, slides: Slides, x: Real, order: int, method: solvers.Method
    ) -> tuple[Split, np.ndarray]:
        """Place the group and add the motions of its links; its split, and the variant (n,) of its dyads there."""
        theta, variant = self._angles(motions, x, order)
        variants = sorted({*variant.tolist()})
        moved = [_moved(self.split, k, motions, theta, order) for k in variants]
        for link in self.group.links:
            states = _chosen([one.motions[link][1:] for one in moved], variant, variants)
            motions[link] = LinkMotion(moved[0].motions[link].base, *states)
        for joint in moved[0].slides:
            slides[joint] = Slide(*_chosen([one.slides[joint] for one in moved], variant, variants))
        return self.split, variant

    def _angles(self, motions: Motions, x: Real, order: int) -> tuple[Real, np.ndarray]:
        """The tried angle (n,) that closes the group on its branch, and the variant (n,) that does."""
        q, turnings = guess(self.loops.branch, x), self.loops.equations.turnings
        told = {k: turnings[k].turn * np.exp(1j * q[turnings[k].of]) for k in self.group.links if not turnings[k].known}
        middle = np.angle(told[self.split.trial])
        count = len(self.split.variants)
        found, astray = np.empty((count, len(x))), np.full((count, len(x)), np.inf)
        for variant in range(count):
            found[variant] = _root(_residual(self.split, variant, motions, len(x)), middle)
            tried = _tried(self.split, variant, motions, found[variant], 0)
            gaps = [np.abs(tried.motions[k].u - told[k]) for k in told if k != self.split.removed]
            closed = (
                np.abs(np.abs(tried.apart.r) - self.split.length) < (CLOSED if order else NEARLY) * self.split.length
            )
            astray[variant] = np.where(closed, np.max(np.broadcast_arrays(*gaps), axis=0), np.inf)
        variant = np.argmin(astray, axis=0)
        lost = ~(np.take_along_axis(astray, variant[None], axis=0)[0] < ASTRAY)
        if lost.any():
            raise AccuracyError(
                f"at the input coordinate {float(x[lost][0]):.9g} no angle of link {self.split.trial} closes the group "
                "with either sign of its dyads: a dyad is too near its dead point there",
                where=f"kinematics, splitting of {self.group.name}",
                remedy="leave --method splitting out: the equations of all loops at once have no such places",
            )
        return np.take_along_axis(found, variant[None], axis=0)[0], variant


def split_chain(chain: Chain) -> Chain:
    """The chain with every higher group split into dyads; raises `UsageError` if it has none, or one that cannot be."""
    if all(step.group.kind for step in chain.steps):
        raise UsageError(
            "all groups are dyads: there is nothing to split",
            where="--method splitting",
            remedy="leave --method out",
        )
    steps = [step if step.group.kind else _split_step(chain, cast(LoopStep, step)) for step in chain.steps]
    return replace(chain, steps=cast(Any, tuple(steps)))


def _split_step(chain: Chain, step: LoopStep) -> SplitStep:
    return SplitStep(step.group, step.variant, step, split_of(chain.mechanism, step.group))


def _tried(
    split: Split,
    variant: int,
    motions: Motions,
    theta: Real,
    order: int,
    omega: Real | float = 0.0,
    eps: Real | float = 0.0,
) -> Tried:
    """The dyads behind the trial link at the angles theta (n,), turning with omega, eps."""
    own, source = split.pivot
    moved, slides = dict(motions), Slides()
    at, u = motions[source.link].point(source.point), np.exp(1j * theta)
    moved[split.trial] = rotated(own.point, at, u, *(np.broadcast_to(rate, theta.shape) for rate in (omega, eps)))
    with np.errstate(divide="ignore", invalid="ignore"):
        for step in split.variants[variant]:
            step.advance(moved, slides, theta, order, solvers.closed)
        one, other = (moved[pin.link].point(pin.point) for pin in split.freed)
    return Tried(moved, slides, (one, other))


def _moved(split: Split, variant: int, motions: Motions, theta: Real, order: int) -> Tried:
    """The group at the angles (n,) that close it, with its rates, and the removed link."""
    tried = _rated(split, variant, motions, theta) if order else _tried(split, variant, motions, theta, 0)
    d, own = tried.apart, split.pins[1] - split.pins[0]
    turning, growing = ((np.conj(d.r) * rate).imag / np.abs(d.r) ** 2 for rate in (d.v, d.a))
    tried.motions[split.removed] = rotated(split.pins[0], tried.pins[0], d.r / own, turning, growing)
    return tried


def _rated(split: Split, variant: int, motions: Motions, theta: Real) -> Tried:
    """The group with the rates of the tried angle that keep the length of the removed link."""
    rates = [_half_square(_tried(split, variant, motions, theta, 2, omega))[0] for omega in (0.0, 1.0)]
    omega = -rates[0] / (rates[1] - rates[0])
    seconds = [_half_square(_tried(split, variant, motions, theta, 2, omega, eps))[1] for eps in (0.0, 1.0)]
    return _tried(split, variant, motions, theta, 2, omega, -seconds[0] / (seconds[1] - seconds[0]))


def _half_square(tried: Tried) -> tuple[Real, Real]:
    """First and second derivative (n,) of |DE|^2 / 2."""
    d = tried.apart
    return (np.conj(d.r) * d.v).real, (np.conj(d.r) * d.a).real + np.abs(d.v) ** 2


def _chosen(states: list[Any], variant: np.ndarray, variants: list[int]) -> list[Any]:
    """Of arrays by variant, those of the one (n,) that each position has."""
    return [np.select([variant == k for k in variants], list(parts)) for parts in zip(*states, strict=True)]


def _residual(split: Split, variant: int, motions: Motions, n: int) -> Residual:
    """g = |DE| / l - 1, NaN where a dyad does not reach."""
    needed = {seat.link for step in split.variants[variant] for seat in (step.port1, step.port2)} | {
        split.pivot[1].link
    }
    needed = (needed | {pin.link for pin in split.freed}) & set(motions)

    def g(theta: Real, which: np.ndarray) -> Real:
        own = {k: LinkMotion(*(_of(part, n, which) for part in motions[k])) for k in needed}
        return np.asarray(np.abs(_tried(split, variant, own, theta, 0).apart.r) / split.length - 1)

    return g


def _of(part: Any, n: int, which: np.ndarray) -> Any:
    """These positions of a state that may stand for all."""
    return part[which] if np.shape(part) == (n,) else part


def _root(g: Residual, middle: Real) -> Real:
    """The root (n,) of g that is nearest to ``middle`` (n,), or a dead point that nearly is one; NaN without."""
    offsets = np.concatenate((-DISTANCES, [0.0], DISTANCES[::-1]))
    angles = middle + offsets[:, None]
    every = np.broadcast_to(np.arange(len(middle)), angles.shape)
    values = g(angles.ravel(), every.ravel()).reshape(angles.shape)
    low, high, f_low, f_high = angles[:-1].copy(), angles[1:].copy(), values[:-1].copy(), values[1:].copy()
    dead = _to_dead_points(g, (low, f_low), (high, f_high), every[1:])
    dead |= _to_dead_points(g, (high, f_high), (low, f_low), every[1:])
    with np.errstate(invalid="ignore"):
        brackets = np.signbit(f_low) != np.signbit(f_high)
    brackets &= np.isfinite(f_low) & np.isfinite(f_high)
    dead &= np.minimum(np.abs(f_low), np.abs(f_high)) < NEARLY
    distance = np.minimum(np.abs(low - middle), np.abs(high - middle))
    distance = np.where(brackets, distance, np.where(dead, distance + BEHIND, np.inf))
    best = np.argmin(distance, axis=0)
    root = np.full(len(middle), np.nan)
    which = np.flatnonzero(np.isfinite(np.min(distance, axis=0)))
    ends = (end[best[which], which] for end in (low, high))
    root[which] = bracketed(lambda theta, rows: g(theta, which[rows]), *ends)
    return root


def _to_dead_points(g: Residual, inside: tuple[Real, Real], outside: tuple[Real, Real], rows: np.ndarray) -> np.ndarray:
    """Where g exists at one end of a bracket only, put the other end to the dead point between them; which it were."""
    part = np.isfinite(inside[1]) & ~np.isfinite(outside[1])
    a, b, which = inside[0][part], outside[0][part], rows[part]
    for _ in range(HALVINGS if len(a) else 0):
        middle = (a + b) / 2
        there = np.isfinite(g(middle, which))
        a, b = np.where(there, middle, a), np.where(there, b, middle)
    outside[0][part], outside[1][part] = a, g(a, which) if len(a) else a
    return part
