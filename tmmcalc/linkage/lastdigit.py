"""What the last digit of the data does: a chain with its metric in all digits, or with one number changed by a unit.

A result may be right to rounding and yet stand on data that are not: 100 mm are 0.1 m, which no double holds.
Near a dead point the difference is amplified like any other error of a length. It is found by solving again with every
number of the metric, and the input coordinate, changed by a unit in its last place; the changes are summed, so that
whichever signs they have, the result moves by no more. They are differences of the same formulas in extended precision,
so that rounding is no part of them. A position 0 that is a dead centre goes along with the metric that it is found of.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from tmmcalc.core.numerics.extended import EPS
from tmmcalc.core.plane import Real
from tmmcalc.linkage.chain import Chain, compile_chain
from tmmcalc.linkage.model import Joint
from tmmcalc.linkage.outputs import coordinate_of, default_outputs

SENSITIVE = 0.35  # regularity of a transmission angle of 20 deg: above it the last digit is worth no more than rounding
LOST = 1.0  # where a unit in the last place keeps the links from meeting, no digit is left

FOUND = 2.0  # a dead centre is found from rates that are rounded by as much again

Functions = Callable[[Chain, Real], Sequence[Any]]  # arrays (..., n) of a chain at input coordinates (n,)


def in_full(chain: Chain) -> Chain:
    """The chain of the same metric in extended precision: lengths are formed from the given points there."""
    return _with_joints(chain, [_widened(joint) for joint in chain.mechanism.joints])


def effects(chain: Chain, x: Real, functions: Functions, centre: float | None = None) -> list[Real]:
    """By how much functions (..., n) change at x (n,) if all numbers change by a unit in the last place, at most.

    ``centre`` is the input coordinate of position 0 where that is a dead centre, from which x is counted.
    """
    exact, at = in_full(chain), x.astype(np.longdouble)
    base = functions(exact, at)
    total = [np.abs(values - moved) for values, moved in zip(base, functions(exact, at * (1 + EPS)), strict=True)]
    for nudged in _nudged(exact):
        moved = functions(nudged, at if centre is None else at + FOUND * _shift(exact, nudged, centre))
        total = [sum_ + np.abs(values - other) for sum_, values, other in zip(total, base, moved, strict=True)]
    return [each.astype(float) for each in total]


def against(effect: Real, scale: float) -> float:
    """The largest of the effects against a scale; `LOST` where they are larger than it, or not finite."""
    if not np.all(np.isfinite(effect)):
        return LOST
    return min(float(np.max(effect, initial=0.0)) / (scale or 1.0), LOST)


def _shift(exact: Chain, nudged: Chain, centre: float) -> Real:
    """How far (1,) a dead centre of the first output goes with the metric: there its rate is 0, dx = -d rate/slope."""
    output, at = default_outputs(exact)[0], np.array([centre], np.longdouble)
    (_, rate, slope), (_, other, _) = (coordinate_of(of, output, of.evaluate(at)) for of in (exact, nudged))
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.asarray((rate - other) / slope)


def _nudged(chain: Chain) -> Iterator[Chain]:
    """The chain with one number of its metric changed by a unit in the last place, number by number."""
    joints = chain.mechanism.joints
    for k, joint in enumerate(joints):
        for other in _variants(joint):
            yield _with_joints(chain, [*joints[:k], other, *joints[k + 1 :]])


def _variants(joint: Joint) -> Iterator[Joint]:
    """Both coordinates of its points, and of a prismatic joint the angles of its directions; a zero has no digits."""
    for side in (0, 1):
        point = joint.points[side]
        for part in (point.real, 1j * point.imag):
            if part != 0:
                yield replace(joint, points=_put(joint.points, side, point + EPS * part))
        direction = joint.directions[side]
        if joint.kind == "prismatic" and direction.imag != 0:
            turned = direction * (1 + 1j * EPS * np.angle(direction))
            yield replace(joint, directions=_put(joint.directions, side, turned))


def _put(pair: tuple[complex, complex], side: int, value: complex) -> tuple[complex, complex]:
    return (value, pair[1]) if side == 0 else (pair[0], value)


def _with_joints(chain: Chain, joints: Sequence[Joint]) -> Chain:
    mechanism = replace(chain.mechanism, joints=tuple(joints))
    signs = {step.group.name: step.variant for step in chain.steps}
    return compile_chain(mechanism, chain.structure, signs, chain.branches)


def _widened(joint: Joint) -> Joint:
    """The joint with its constants, those of one linkage or of several, in extended precision."""
    points, directions = (tuple(map(_wide, pair)) for pair in (joint.points, joint.directions))
    return replace(joint, points=points, directions=directions)


def _wide(value: Any) -> Any:
    return np.asanyarray(value).astype(np.clongdouble)[()]
