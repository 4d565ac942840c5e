"""Derivatives of the smallest transmission angles of dyads."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from tmmcalc.core.derivatives import Derivative
from tmmcalc.core.plane import Plane, Real
from tmmcalc.linkage.chain import Step
from tmmcalc.linkage.derivatives.closure import EPS, Moved
from tmmcalc.linkage.derivatives.rates import MARGIN
from tmmcalc.linkage.derivatives.rows import Directions, Placing, ends_of

RIGHT = 1e-9  # a squared sine nearer than this to 1 is that of a right angle, which no change makes larger


def transmissions_of(directions: Directions, placed: Placing) -> Iterator[tuple[str, Derivative | None]]:
    """Of the smallest transmission angle of every dyad."""
    ends = ends_of(directions, placed)
    for step, quality in zip(directions.chain.steps, directions.kinematics.qualities, strict=True):
        if quality.transmission is None or not isinstance(step, Step):
            continue
        at = directions.start if quality.transmission_at is None else quality.transmission_at
        moved, along = directions.at(np.array([at]))
        (sine2, change), rate = _squared_sine(moved, step), _squared_sine(along, step)[1]
        if 1 - sine2 < RIGHT:
            yield quality.group, None
            continue
        for x, dx in ends:
            if quality.transmission_at is not None and abs(at - x) <= 1e-9 * max(1.0, abs(x)):
                change = change + rate * dx
        factor = 1 / (2 * math.sqrt(sine2 * (1 - sine2)))
        error = MARGIN * EPS * np.max(moved.condition) * moved.largest()[0] / moved.reach
        yield quality.group, Derivative(factor * change, factor * error)


def _squared_sine(moved: Moved, step: Step) -> tuple[float, Real]:
    """Squared sine of the transmission angle at one place, and its change (K,).

    Between the two links (RRR), between a rod, or the line of the pivots, and a guide it is that from the guide's
    normal (RRP, RPR), between two guides (PRP, RPP).
    """
    mechanism, kind = moved.chain.mechanism, step.group.kind
    outer = [mechanism.joint(name) for name in step.group.outer]
    inner = mechanism.joint(step.group.inner[0])

    def place(name: int) -> tuple[complex, Plane]:
        joint = (*outer, inner)[name]
        r, dr = moved.pin(joint, 0)
        return complex(r[0, 0, 0]), dr[0, :, 0]

    def line(name: int) -> tuple[complex, Plane]:
        e, de = moved.line((*outer, inner)[name])
        return complex(e[0, 0, 0]), de[0, :, 0]

    def between(one: int, other: int) -> tuple[complex, Plane]:
        (a, da), (b, db) = place(one), place(other)
        return b - a, db - da

    one, other = {
        "RRR": lambda: (between(0, 2), between(1, 2)),
        "RRP": lambda: (between(0, 2), line(1)),
        "RPR": lambda: (between(0, 1), line(2)),
        "PRP": lambda: (line(0), line(1)),
        "RPP": lambda: (line(2), line(1)),
    }[kind]()
    ratio = one[0] / other[0]
    turning = (one[1] / one[0] - other[1] / other[0]).imag
    angle = math.atan2(ratio.imag, ratio.real)
    if kind in ("RRP", "RPR"):
        return math.cos(angle) ** 2, -math.sin(2 * angle) * turning
    return math.sin(angle) ** 2, math.sin(2 * angle) * turning
