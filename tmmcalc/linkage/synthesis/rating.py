"""Defects and merits of many linkages that pass through prescribed positions: order, branch, circuit, transmission.

order: the crank meets the positions one after another, in one sense and within a turn. branch: the dyad keeps its
variant. circuit: between the first and the last position the crank meets no limit, so that it gets from one to the
next without being taken apart.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tmmcalc.core.notes import Phrase
from tmmcalc.core.plane import Plane, Real, cross
from tmmcalc.linkage.synthesis.planar import Bars

WAY = 91  # places between the first and the last position at which margins are taken
TURN = 2 * np.pi
SAME = 1e-9  # angles of the crank nearer than this [rad] are one position
NONE = 1e-15  # of the longest bar: what is shorter has no length


class Asked(NamedTuple):
    """What a linkage without defects keeps."""

    full: bool  # the crank turns fully
    transmission: float  # least transmission angle [rad]
    ratio: float  # largest ratio of the links


class Rating(NamedTuple):
    """What is wrong with m linkages, and how good they are."""

    order: np.ndarray  # (m,) True where the order is kept
    branch: np.ndarray
    circuit: np.ndarray
    turns: np.ndarray  # the crank turns fully
    transmission: Real  # least transmission angle [rad] on the way, of a full turn where the crank turns
    ratio: Real  # longest to shortest link
    phi: Real  # (m, n) angles of the crank, monotone where the order is kept
    sense: Real  # (m,) +1 or -1, of the crank

    def defects(self, k: int, asked: Asked) -> tuple[str, ...]:
        """The defects of linkage k in words."""
        transmission = asked.transmission
        found = (
            ("order: the crank does not meet the positions one after another", self.order[k]),
            ("branch: the positions belong to both variants of the dyad", self.branch[k]),
            ("circuit: the crank meets a limit between the positions", self.circuit[k]),
            ("rotatability: the crank does not turn fully", self.turns[k] or not asked.full),
            (
                Phrase(
                    "transmission: the least angle is {found:.4g} deg, below {limit:.4g} deg",
                    found=np.degrees(self.transmission[k]),
                    limit=np.degrees(transmission),
                ),
                self.transmission[k] >= transmission,
            ),
            (
                Phrase("sizes: the longest link has {ratio:.3g} times the shortest", ratio=self.ratio[k]),
                self.ratio[k] <= asked.ratio,
            ),
        )
        return tuple(words for words, good in found if not good)

    def faults(self, asked: Asked) -> Real:
        """Number of defects (m,)."""
        weak, long = self.transmission < asked.transmission, self.ratio > asked.ratio
        return np.sum([~self.order, ~self.branch, ~self.circuit, weak, long, ~self.turns & asked.full], axis=0)


def crank_angles(crank: Plane) -> tuple[Real, Real, np.ndarray]:
    """Continuous angles (m, n) of cranks (m, n), the sense of each row, and whether it goes one way within a turn."""
    steps = np.angle(crank[:, 1:] / crank[:, :-1])
    best = np.zeros(steps.shape)
    order = np.zeros(len(steps), bool)
    sense = np.where(steps.sum(axis=1) >= 0, 1.0, -1.0)
    for way in (1.0, -1.0):
        forward = np.mod(way * steps, TURN)
        forward[forward > TURN - SAME] = 0.0
        good = (forward.sum(axis=1) <= TURN + SAME) & np.all(forward > SAME, axis=1)
        better = good & (~order | (forward.sum(axis=1) < np.abs(best).sum(axis=1)))
        best[better], sense[better] = way * forward[better], way
        order |= good
    best[~order] = steps[~order]
    first = np.angle(crank[:, :1])
    return np.concatenate((first, first + np.cumsum(best, axis=1)), axis=1), sense, order


def variants(bars: Bars, b: Plane, c: Plane) -> Real:
    """Variant (m, n) of the dyad at the positions of its pins."""
    if bars.slides:
        return np.sign(((c - b) * np.conj(bars.guide)).real)
    return np.sign(cross(bars.end - b, c - b))


def rate(bars: Bars, b: Plane, c: Plane) -> tuple[Bars, Rating]:
    """Rate linkages by the places (m, n) of their pins B and C; they get the variant of their first position."""
    phi, sense, order = crank_angles(b - bars.pivot)
    signs = variants(bars, b, c)
    bars = bars._replace(sign=np.where(signs[:, :1] < 0, -1.0, 1.0))
    branch = np.all(signs == signs[:, :1], axis=1)
    low, high = phi.min(axis=1)[:, None], phi.max(axis=1)[:, None]
    margin = bars.at(low + (high - low) * np.linspace(0, 1, WAY)).margin
    turns = bars.turns()
    whole = bars.at(np.linspace(0, TURN, WAY)[None, :]).margin
    least = np.where(turns, whole.min(axis=1), margin.min(axis=1))
    lengths = bars.lengths()
    longest = lengths.max(axis=0)
    shortest = np.maximum(lengths.min(axis=0), np.maximum(NONE * longest, np.finfo(float).tiny))
    return bars, Rating(
        order,
        branch,
        np.all(margin > 0, axis=1),
        turns,
        np.arcsin(np.sqrt(np.clip(least, 0, 1))),
        longest / shortest,
        phi,
        sense,
    )
