"""The way of the input: the angle counted along the motion, and its period.

    theta = (x - start) sense,  0 where the motion begins, never negative along it

``x`` is the input coordinate, ``sense`` the sign of its speed. The motion begins at position 0; only a plain
`Mechanism` may name positions before that, and then it begins at the first of them. For a driven slider theta is a
length.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from typing import NamedTuple

import numpy as np

from tmmcalc.core.notes import Phrase
from tmmcalc.core.plane import Real
from tmmcalc.linkage.assembly import TURN
from tmmcalc.linkage.chain import Chain
from tmmcalc.linkage.loading import Load
from tmmcalc.linkage.results import Kinematics
from tmmcalc.linkage.survey import Survey, survey

EDGE = 1e-9  # [rad or m] an angle so near to the end of a window belongs to it


class Travel(NamedTuple):
    """How the input goes: from ``start`` at ``speed``, one turn or a part of it, over and over or once."""

    start: float  # input coordinate at theta = 0 [rad or m]
    first: float  # the same counted from position 0: nothing but in a range that begins before it
    speed: float  # [rad/s or m/s]
    acceleration: float
    turns: bool  # a crank, and not a driven slider
    whole: bool  # the crank turns fully and the motion repeats
    period: float  # of all loads together: whole turns; of an open range its length
    names: tuple[str, ...]  # labels of the positions
    along: Real  # and their theta

    @property
    def labels(self) -> dict[str, float]:
        """theta of every position by its label; in later turns of a longer cycle the labels go on counting."""
        own = zip(self.names, self.along.tolist(), strict=True)
        if not self.whole:
            return dict(own)
        later = range(round(self.period / TURN))
        return {_later(name, k, self.names[-1]): at + TURN * k for name, at in own for k in later}

    @property
    def sense(self) -> float:
        """Sign of the speed."""
        return 1.0 if self.speed > 0 else -1.0

    def x(self, theta: Real) -> Real:
        """Input coordinate at theta."""
        return self.start + self.sense * theta

    def phi(self, theta: Real) -> Real:
        """Input coordinate counted from position 0."""
        return self.first + self.sense * theta + 0.0  # no -0.0

    def theta(self, x: Real) -> Real:
        """Angle along the motion, of a whole turn reduced to [0, 2 pi) but for rounding."""
        theta = (x - self.start) * self.sense
        return np.mod(theta + EDGE, TURN) - EDGE if self.whole else theta

    def ends(self, theta: Real) -> np.ndarray:
        """Whether theta is the very end of the motion, where what holds just before counts."""
        return theta >= self.period - EDGE

    def since(self, origin: float, theta: Real, period: float) -> Real:
        """Angle along the motion from the last ``origin`` on, which comes back after ``period``; never negative.

        At the very end of the motion it is the angle to that end.
        """
        d = theta - origin
        if not self.whole:
            return np.maximum(d, 0.0)
        d = np.maximum(np.mod(d + EDGE, period) - EDGE, 0.0)
        return np.where((d < EDGE) & self.ends(theta), period, d)

    def repeated(self, theta: Iterable[float], period: float = TURN) -> list[float]:
        """The same angles over the whole cycle, where they come back after ``period``."""
        if not self.whole:
            return list(theta)
        times = round(self.period / period)
        return [(t + period * k) % self.period for t in theta for k in range(times)]

    def rows(self, kinematics: Kinematics) -> tuple[Real, tuple[str, ...]]:
        """theta (n,) of the positions in every turn of the period, and their labels, which go on counting."""
        along = self.along
        turns = round(self.period / TURN) if self.whole else 1
        theta = np.concatenate([along if k == 0 else along[1:] + TURN * k for k in range(turns)])
        labels = kinematics.labels
        for k in range(1, turns):
            labels = (*labels, *(_later(name, k, kinematics.labels[-1]) for name in kinematics.labels[1:]))
        return theta, labels

    def sides(self, theta: Real) -> Real:
        """From which side each theta (n,) is taken: +1, just after; -1 at the very end, just before."""
        return np.where(self.ends(theta), -1.0, 1.0)

    def named(self, theta: Real) -> list[str]:
        """Angles (m,) in words."""
        return [
            Phrase("{t:.5g} deg", t=math.degrees(t)) if self.turns else Phrase("{t:.5g} mm", t=1e3 * t) for t in theta
        ]


def travel_of(chain: Chain, kinematics: Kinematics, loads: Sequence[Load], turns: int = 1) -> Travel:
    """The travel of a solved mechanism; four-stroke indicators and longer tables make its period longer.

    So does what else repeats after these ``turns`` of the crank.
    """
    along = kinematics.phi * math.copysign(1.0, kinematics.speed)
    begin = int(np.argmin(along))
    along = along - along[begin]
    whole = chain.turns and abs(float(np.max(along)) - TURN) < EDGE
    return Travel(
        start=float(kinematics.x[begin]),
        first=float(kinematics.phi[begin]),
        speed=kinematics.speed,
        acceleration=kinematics.acceleration,
        turns=chain.turns,
        whole=whole,
        period=TURN * math.lcm(turns, *(load.turns for load in loads)) if whole else float(np.max(along)),
        names=kinematics.labels,
        along=along,
    )


def surveyed(chain: Chain, travel: Travel) -> Survey:
    """The survey of one turn, or of the open range."""
    if travel.whole:
        return survey(chain, travel.start - math.pi, travel.start + math.pi)
    return survey(chain, *sorted((travel.start, travel.start + travel.sense * travel.period)))


def _later(label: str, turn: int, last: str) -> str:
    """The label of the same position in a later turn."""
    number = label.rstrip("'")
    return f"{int(number) + turn * int(last)}{label[len(number) :]}"
