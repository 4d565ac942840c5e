"""How well the mechanism transmits: transmission and pressure angles, dead points, and their grades.

The transmission angle of a dyad is the angle between its two links (RRR), between the rod and the normal of the
guide (RRP), between the slot and the pin's circle (RPR), between the two guides (PRP, RPP); 90 degrees is
best, and the pressure angle is its complement. The regularity is the sine that divides every velocity of the
dyad: its inverse is the amplification of any error. Both are minimised over the whole range, not read
off the grid.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from tmmcalc.core.errors import SingularityError
from tmmcalc.core.numerics.extrema import around, refine, turning
from tmmcalc.core.plane import Real, square
from tmmcalc.linkage.assembly import coordinate
from tmmcalc.linkage.chain import Chain, Configuration
from tmmcalc.linkage.results import Extreme, Grade, GroupQuality
from tmmcalc.linkage.steps import Step
from tmmcalc.linkage.survey import Survey, along_motion

SINGULAR = 1e-6  # regularity of a dead point: below it velocities have no trustworthy digits
NEARLY_SINGULAR = 0.05  # amplification above 20
POOR = math.radians(20)  # transmission angle: a warning below
MODEST = math.radians(30)  # a note below
CONSTANT = 1e-14  # a squared sine that varies less has no minimum to refine


class Measure(NamedTuple):
    """One squared sine to minimise: of the transmission angle, or of the regularity, of group ``k``.

    The margin of a dyad is the squared sine of its transmission angle, smooth through the change points too. A higher
    group has no transmission angle: of it the square of the smallest singular value of its equations is taken.
    """

    k: int
    regularity: bool
    reach: float  # largest distance of the pivots of an RPR dyad [m]

    def __call__(self, chain: Chain, configuration: Configuration, x: Real) -> Real:
        """The squared sine (n,) of a configuration at the input coordinates x (n,)."""
        step, ports = chain.steps[self.k], configuration.ports[self.k]
        if not isinstance(step, Step):
            return np.broadcast_to(step.regularity(configuration.placed[self.k]) ** 2, x.shape)
        sine2 = step.dyad.margin(*ports)
        if self.regularity:
            sine2 = sine2 * square(ports[0].r - ports[1].r) / self.reach**2
        return np.broadcast_to(sine2, x.shape)


def measures_of(chain: Chain, configuration: Configuration) -> list[Measure]:
    """Transmission of every dyad; its regularity is the same number but for RPR."""
    measures = []
    for k, (step, placed) in enumerate(zip(chain.steps, configuration.placed, strict=True)):
        measures.append(Measure(k, not step.group.kind, 0.0))
        if step.group.kind == "RPR":
            measures.append(Measure(k, True, float(np.max(np.abs(placed.q)))))
    return measures


def assess(chain: Chain, dense: Survey, start: float) -> tuple[GroupQuality, ...]:
    """Transmission and regularity of every dyad over the surveyed range, which begins at ``start``."""
    measures = measures_of(chain, dense.configuration)
    squares = np.array([measure(chain, dense.configuration, dense.x) for measure in measures])
    minima = _minima(chain, dense, measures, squares, start)
    return tuple(quality_of(chain, k, measures, squares, minima) for k in range(len(chain.steps)))


def _minima(
    chain: Chain, dense: Survey, measures: list[Measure], squares: Real, start: float
) -> list[list[tuple[float, float]]]:
    """All local minima (squared sine, place) of every measure, the least first; the ends of a range among them."""
    guesses = [
        (m, int(j))
        for m, row in enumerate(squares)
        if np.ptp(row) > CONSTANT
        for j in turning(row[:-1] if dense.full else row, -1, dense.full)
    ]
    found: list[list[tuple[float, float]]] = [[] for _ in measures]
    if not guesses:
        return found
    owner, row = np.array(guesses).T

    def f(at: Real, which: np.ndarray) -> Real:
        configuration = chain.evaluate(at, order=0)
        rows = np.array([measure(chain, configuration, at) for measure in measures])
        return rows[owner[which], np.arange(len(at))]

    at, sine2 = refine(f, *around(dense.x, row, dense.full))
    better = squares[owner, row] < sine2
    at, sine2 = np.where(better, dense.x[row], at), np.where(better, squares[owner, row], sine2)
    if dense.full:
        at = along_motion(chain, at, start)
    for m, place, value in zip(owner, at, sine2, strict=True):
        found[m].append((max(float(value), 0.0) + 0.0, float(place)))
    return [least_first(minima) for minima in found]


def least_first(minima: list[tuple[float, float]]) -> list[tuple[float, float]]:
    """Minima (squared sine, place), the least first; of those that rounding alone tells apart the first in place."""
    return sorted(minima, key=lambda minimum: (round(minimum[0], 12), minimum[1]))


def quality_of(
    chain: Chain, k: int, measures: list[Measure], squares: Real, minima: list[list[tuple[float, float]]]
) -> GroupQuality:
    """The quality of group ``k`` from the ``minima`` of all measures; of those without ``squares`` (M, m) tell it."""
    rows = [m for m, measure in enumerate(measures) if measure.k == k]
    angles = [Extreme(_angle(sine2), x) for sine2, x in minima[rows[0]]]
    sines = [Extreme(math.sqrt(sine2), x) for sine2, x in minima[rows[-1]]]
    constant_angle, constant_sine = (max(float(squares[m, 0]), 0.0) for m in (rows[0], rows[-1]))
    group = chain.steps[k].group
    if not group.kind:
        angles, constant_angle = [], 1.0
    return GroupQuality(
        group.name,
        (angles[0].value if angles else _angle(constant_angle)) if group.kind else None,
        angles[0].x if angles else None,
        sines[0].value if sines else math.sqrt(constant_sine),
        sines[0].x if sines else None,
        tuple(sorted((e for e in angles if e.value < MODEST), key=lambda e: e.x)),
        tuple(sorted((e for e in sines if e.value < NEARLY_SINGULAR), key=lambda e: e.x)),
    )


def _angle(sine2: float) -> float:
    """The angle [rad] of a squared sine; exactly 90 degrees where rounding alone keeps it from there."""
    return math.pi / 2 if 1 - sine2 < CONSTANT else math.asin(math.sqrt(sine2))


def check_regular(chain: Chain, qualities: tuple[GroupQuality, ...]) -> None:
    """Raise `SingularityError` if the range passes through a dead point, with all its places."""
    for step, quality in zip(chain.steps, qualities, strict=True):
        if quality.regularity >= SINGULAR:
            continue
        dead = [e.x for e in quality.singular if e.value < SINGULAR]
        places = f"at {coordinate(chain, *dead)}" if dead else "at every position"
        what = "dead point" if step.group.kind else "singular position"
        raise SingularityError(
            f"{what} {places}: {_CAUSES[step.group.kind]}; velocities are not defined "
            f"(regularity {quality.regularity:.3g}, limit {SINGULAR:g})",
            where=f"kinematics, group {quality.group}",
            value=quality.regularity,
            limit=SINGULAR,
            remedy="change a length, or analyse a range that keeps clear of it: input.start and grid.span",
        )


_CAUSES = {
    "": "the links of the group come to a limit position, or can go on in two ways",
    "RRR": "both links stand in line, a change point from which the motion can go on in two ways",
    "RRP": "the rod stands across the guide, a change point from which the motion can go on in two ways",
    "RPR": "the pivots come as near as the guide's offset allows, which leaves its direction open",
    "PRP": "the two guides are parallel",
    "RPP": "the two lines of the slider are parallel",
}


def grade(chain: Chain, qualities: tuple[GroupQuality, ...]) -> tuple[Grade, ...]:
    """Notes and warnings on every weak transmission and nearly singular place, with its angle and number."""
    grades = []
    for quality in qualities:
        where = f"group {quality.group}"
        for near in quality.singular:
            at = coordinate(chain, near.x)
            text = f"nearly singular at {at}: errors and velocities are amplified {1 / near.value:.4g} times"
            grades.append(Grade("warning", where, text))
        for weak in quality.weak:
            limit = 20 if weak.value < POOR else 30
            at = coordinate(chain, weak.x)
            text = f"transmission angle {math.degrees(weak.value):.4g} deg at {at}, below {limit} deg"
            grades.append(Grade("warning" if weak.value < POOR else "note", where, text))
        if quality.transmission is not None and quality.transmission_at is None and quality.transmission < MODEST:
            text = f"transmission angle {math.degrees(quality.transmission):.4g} deg at every position, below 30 deg"
            grades.append(Grade("warning" if quality.transmission < POOR else "note", where, text))
    return tuple(grades)
