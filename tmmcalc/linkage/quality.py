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

from tmmcalc.errors import SingularityError
from tmmcalc.linkage.assembly import coordinate
from tmmcalc.linkage.chain import Chain, Configuration
from tmmcalc.linkage.plane import Real, square
from tmmcalc.linkage.results import Grade, GroupQuality
from tmmcalc.linkage.survey import Survey
from tmmcalc.numerics.extrema import around, refine, turning

SINGULAR = 1e-6  # regularity of a dead point: below it velocities have no trustworthy digits
NEARLY_SINGULAR = 0.05  # amplification above 20
POOR = math.sin(math.radians(20))  # transmission angle below 20 degrees: warning
MODEST = math.sin(math.radians(30))  # below 30 degrees: note
CONSTANT = 1e-14  # a squared sine that varies less has no minimum to refine
CANDIDATES = 2  # local minima refined in the search for the global one


class _Measure(NamedTuple):
    """One squared sine to minimise: of the transmission angle, or of the regularity, of dyad ``k``.

    The margin of a dyad is the squared sine of its transmission angle, smooth through the change points too.
    """

    k: int
    regularity: bool
    reach: float  # largest distance of the pivots of an RPR dyad [m]

    def __call__(self, chain: Chain, configuration: Configuration, x: Real) -> Real:
        dyad, ports = chain.steps[self.k].dyad, configuration.ports[self.k]
        sine2 = dyad.margin(*ports)
        if self.regularity:
            sine2 = sine2 * square(ports[0].r - ports[1].r) / self.reach**2
        return np.broadcast_to(sine2, x.shape)


def _measures(chain: Chain, configuration: Configuration) -> list[_Measure]:
    """Transmission of every dyad; its regularity is the same number but for RPR."""
    measures = []
    for k, (step, placed) in enumerate(zip(chain.steps, configuration.placed, strict=True)):
        measures.append(_Measure(k, False, 0.0))
        if step.group.kind == "RPR":
            measures.append(_Measure(k, True, float(np.max(np.abs(placed.q)))))
    return measures


def assess(chain: Chain, dense: Survey) -> tuple[GroupQuality, ...]:
    """Worst transmission and regularity of every dyad over the surveyed range."""
    measures = _measures(chain, dense.configuration)
    worst, guesses = [], []
    for m, measure in enumerate(measures):
        squares = measure(chain, dense.configuration, dense.x)
        i = int(np.argmin(squares))
        worst.append((max(float(squares[i]), 0.0), float(dense.x[i])))
        if np.ptp(squares) > CONSTANT:
            low = turning(squares[:-1] if dense.full else squares, -1, dense.full)
            guesses += [(m, int(j)) for j in low[np.argsort(squares[low])][:CANDIDATES]]
    if guesses:
        owner, row = np.array(guesses).T

        def f(at: Real, which: np.ndarray) -> Real:
            configuration = chain.evaluate(at, order=0)
            rows = np.array([measure(chain, configuration, at) for measure in measures])
            return rows[owner[which], np.arange(len(at))]

        for m, at, sine2 in zip(owner, *refine(f, *around(dense.x, row, dense.full)), strict=True):
            worst[m] = min(worst[m], (max(float(sine2), 0.0), float(at)))
    return tuple(_quality(chain, k, measures, worst) for k in range(len(chain.steps)))


def _quality(chain: Chain, k: int, measures: list[_Measure], worst: list[tuple[float, float]]) -> GroupQuality:
    own = [w for measure, w in zip(measures, worst, strict=True) if measure.k == k]
    transmission, regularity = own[0], own[-1]
    return GroupQuality(
        chain.steps[k].group.name,
        math.pi / 2 if 1 - transmission[0] < CONSTANT else math.asin(math.sqrt(transmission[0])),
        transmission[1],
        math.sqrt(regularity[0]),
        regularity[1],
    )


def check_regular(chain: Chain, qualities: tuple[GroupQuality, ...]) -> None:
    """Raise `SingularityError` if the range passes through a dead point."""
    for quality in qualities:
        if not quality.regularity >= SINGULAR:
            raise SingularityError(
                f"dead point at {coordinate(chain, quality.regularity_at)}: regularity "
                f"{quality.regularity:.3g} is below {SINGULAR:g}; velocities are not defined there and the assembly "
                "variant beyond it is not determined",
                where=f"kinematics, group {quality.group}",
                value=quality.regularity,
                limit=SINGULAR,
                remedy="change a length, or analyse a range that keeps clear of it: input.start and grid.span",
            )


def grade(chain: Chain, qualities: tuple[GroupQuality, ...]) -> tuple[Grade, ...]:
    """Notes and warnings on weak transmission and nearly singular places, with their angle and number."""
    grades = []
    for quality in qualities:
        where = f"group {quality.group}"
        if quality.regularity < NEARLY_SINGULAR:
            at = coordinate(chain, quality.regularity_at)
            text = f"nearly singular at {at}: errors and velocities are amplified {quality.amplification:.4g} times"
            grades.append(Grade("warning", where, text))
        sine = math.sin(quality.transmission)
        if sine < MODEST:
            limit = 20 if sine < POOR else 30
            text = (
                f"smallest transmission angle {math.degrees(quality.transmission):.4g} deg at "
                f"{coordinate(chain, quality.transmission_at)}, below {limit} deg"
            )
            grades.append(Grade("warning" if sine < POOR else "note", where, text))
    return tuple(grades)
