"""What the sizes of closed forms have to keep, as equations in any kind of numbers; lengths in units of the longest."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from tmmcalc.core.numerics.extended import PI
from tmmcalc.core.plane import Real
from tmmcalc.linkage.synthesis.errors import Conditions
from tmmcalc.linkage.synthesis.results import Design
from tmmcalc.linkage.synthesis.rocker import LENGTHS
from tmmcalc.linkage.synthesis.rockerfamily import family, slopes
from tmmcalc.linkage.synthesis.rotating import crank_angle
from tmmcalc.linkage.synthesis.task import (
    CrankRockerTask,
    RotatingTask,
    SliderCrankTask,
    SlottedTask,
    SynthesisTask,
    TrailingRodTask,
)
from tmmcalc.linkage.synthesis.triangle import overlap_of, stroke_of

NEAR = 1e-6  # of a condition of the best transmission: it is the one that holds


def _overlap(ratio: float) -> Any:
    """Overlap angle in extended precision."""
    k = np.longdouble(ratio)
    return PI * (k - 1) / (k + 1)


def _lengths(design: Design, symbols: str) -> tuple[float, list[np.longdouble]]:
    """The longest and all lengths of these symbols, in its unit."""
    told = [design.size(symbol) for symbol in symbols]
    unit = max(map(abs, told))
    return unit, [np.longdouble(each) / unit for each in told]


def slider_crank(task: SynthesisTask, design: Design) -> Conditions:
    """r, l and e."""
    asked: SliderCrankTask = task.asked
    unit, found = _lengths(design, "rle")

    def missed(x: Real) -> Iterator[Any]:
        r, l, e = x
        stroke = l * stroke_of(r / l, e / l)
        lengths = ((asked.stroke, stroke), (asked.crank, r), (asked.rod, l), (asked.offset, e))
        yield from (value - np.longdouble(wanted) / unit for wanted, value in lengths if wanted is not None)
        ratios = ((asked.crank_ratio, r, l), (asked.offset_ratio, e, r), (asked.offset_part, e, stroke))
        yield from (value - wanted * of for wanted, value, of in ratios if wanted is not None)
        angles = ((asked.pressure_working, r - e), (asked.pressure_idle, r + e))
        yield from (value - l * np.sin(np.longdouble(wanted)) for wanted, value in angles if wanted is not None)
        if asked.time_ratio is not None:
            yield overlap_of(r / l, e / l) - _overlap(asked.time_ratio)

    return Conditions(lambda x: np.array([*missed(x)], x.dtype), found, 3)


def slotted_link(task: SynthesisTask, design: Design) -> Conditions:
    """r, L, R, l and e."""
    asked: SlottedTask = task.asked
    unit, found = _lengths(design, "rLRle")
    phi = _overlap(asked.time_ratio) / 2
    sine, cosine = np.sin(phi), np.cos(phi)

    def missed(x: Real) -> Iterator[Any]:
        r, centres, arm, rod, e = x
        yield 2 * arm * sine - np.longdouble(asked.stroke) / unit
        yield r - centres * sine
        given = ((asked.crank, r), (asked.centres, centres), (asked.guide, e), (asked.rod, rod))
        yield from (value - np.longdouble(wanted) / unit for wanted, value in given if wanted is not None)
        if asked.guide is None or (asked.crank is None and asked.centres is None):
            yield e - centres - np.longdouble(asked.clearance) * r
        if asked.rod is None and asked.pressure is not None:
            yield rod * np.sin(np.longdouble(asked.pressure)) - max(abs(e - arm), abs(e - arm * cosine))

    return Conditions(lambda x: np.array([*missed(x)], x.dtype), found, 5)


def rotating_slotted_link(task: SynthesisTask, design: Design) -> Conditions:
    """r, L, R and l; the offset of the guide is given."""
    asked: RotatingTask = task.asked
    unit, found = _lengths(design, "rLRl")
    e = np.longdouble(asked.guide) / unit

    def missed(x: Real) -> Iterator[Any]:
        r, centres, arm, rod = x
        far, near = (rod + arm - e) * (rod + arm + e), (rod - arm - e) * (rod - arm + e)
        yield 4 * rod * arm / (np.sqrt(far) + np.sqrt(near)) - np.longdouble(asked.stroke) / unit
        ends = np.arcsin(e / (rod + arm)), PI + np.arcsin(e / (rod - arm))
        first, last = (crank_angle(end, centres / r) for end in ends)
        yield last - first - PI - _overlap(asked.time_ratio)
        given = ((asked.crank, r), (asked.centres, centres), (asked.rod, rod))
        yield from (value - np.longdouble(wanted) / unit for wanted, value in given if wanted is not None)
        if asked.rod is None and asked.pressure is not None:
            yield rod * np.sin(np.longdouble(asked.pressure)) - arm - abs(e)

    return Conditions(lambda x: np.array([*missed(x)], x.dtype), found, 4)


def crank_rocker(task: SynthesisTask, design: Design) -> Conditions:
    """r, l, R and L; where the transmission is to be best, it does not change along the family, or has a kink there."""
    asked: CrankRockerTask = task.asked
    unit, found = _lengths(design, "rlRL")
    half, psi = np.longdouble(asked.swing) / 2, _overlap(asked.time_ratio)
    given = [name for name in LENGTHS if getattr(asked, name) is not None]

    def pivot(x: Real, side: int) -> Any:
        r, l, rocker, frame = x
        chord = 2 * rocker * np.sin(half)
        along, off = 2 * l * r / chord, (l - r) * (l + r) * np.sin(psi) / chord
        return np.hypot(along, rocker * np.cos(half) + side * off) - frame

    side = min((1, -1), key=lambda way: abs(pivot(np.array(found), way)))
    best = None
    if len(given) == 1 and asked.transmission is None:
        best = _best(asked, np.array(found), half, psi, side)

    def missed(x: Real) -> Iterator[Any]:
        r, l, rocker, _ = x
        yield np.hypot(l * np.sin(psi / 2), r * np.cos(psi / 2)) - rocker * np.sin(half)
        yield pivot(x, side)
        named = dict(zip(LENGTHS, x, strict=True))
        yield from (named[name] - np.longdouble(getattr(asked, name)) / unit for name in given)
        if asked.transmission is not None:
            yield max(map(abs, _cosines(x))) - np.cos(np.longdouble(asked.transmission))
        elif best is not None:
            yield best(x)

    return Conditions(lambda x: np.array([*missed(x)], x.dtype), found, 4)


def trailing_rod(task: SynthesisTask, design: Design) -> Conditions:
    """l_4 and alpha: with the crank on the left cylinder's axis lug and trailing rod lie on it, as far out as l."""
    asked: TrailingRodTask = task.asked
    unit, (length,) = asked.rod, [np.longdouble(design.size("l_4")) / asked.rod]
    r, lug, beta = np.longdouble(asked.crank) / unit, np.longdouble(asked.lug) / unit, np.longdouble(asked.v_angle)

    def missed(x: Real) -> Iterator[Any]:
        length, alpha = x
        if asked.length is None:
            yield length + lug - 1
        else:
            yield length - np.longdouble(asked.length) / unit
        if asked.lug_angle is None:
            yield np.sin(alpha - beta) - r * np.sin(beta)
        else:
            yield alpha - np.longdouble(asked.lug_angle)

    return Conditions(lambda x: np.array([*missed(x)], x.dtype), [length, np.longdouble(design.size("alpha"))], 2)


def _cosines(x: Real) -> list[Any]:
    """Of the transmission angle where the crank is in line with the frame."""
    r, l, rocker, frame = x
    return [(l**2 + rocker**2 - (frame + sign * r) ** 2) / (2 * l * rocker) for sign in (1, -1)]


def _best(asked: CrankRockerTask, found: Real, half: Any, psi: Any, side: int) -> Any:
    """The condition that the best transmission keeps: both extremes alike, the largest ratio, or no slope."""

    def alike(x: Real) -> Any:
        one, two = map(abs, _cosines(x))
        return one - two

    def longest(x: Real) -> Any:
        return max(x[1:]) - asked.largest_ratio * x[0]

    which = int(np.argmax(np.abs(_cosines(found))))

    def level(x: Real) -> Any:
        at = np.array([x[2] * np.sin(half) / x[1]])
        return slopes(at, family(at, half, psi, side), half, psi, side).cosines[which, 0]

    for condition in (longest, alike):
        if abs(condition(found)) < NEAR:
            return condition
    return level
