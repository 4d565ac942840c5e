"""The graphical integration of a law, as it is done by hand: from the ordinates of y'' to y', and from these to y.

On every interval of the abscissa the curve stands for its mean ordinate, that of the middle, which is carried over to
the axis of ordinates. The ray to it from a pole at a distance H in front of the axis has the slope of the integral on
this interval, whose chord is drawn parallel to it. Of lengths on paper the slope is ordinate/H, whence

    mu_y' = mu_y'' mu_phi H1,   mu_y = mu_y' mu_phi H2      (mu_phi in rad/mm, H in mm)

The mean ordinates are those of the midpoint rule, so that the error falls with the square of the interval. Every
moving phase begins from rest; a dwell keeps the displacement that the construction has reached.
"""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.program import SAME, Program
from tmmcalc.core.records import record


@record
class Strip:
    """The construction over one phase: n intervals between n + 1 numbered ordinates."""

    first: int  # number of its first ordinate
    phi: Values  # (n + 1,) [rad]
    bend: Values  # (n,) y'' in the middle of every interval
    slope: Values  # (n + 1,) y' as constructed
    place: Values  # (n + 1,) y as constructed

    @property
    def mean(self) -> Values:
        """Ordinates (n,) of the constructed y' in the middle of every interval."""
        return (self.slope[:-1] + self.slope[1:]) / 2


@record
class Construction:
    """What the construction gives, and how far it is from the exact law at its ordinates."""

    strips: tuple[Strip, ...]  # of all phases but a last dwell
    slope_error: float  # largest deviation of y', in parts of the largest exact y'
    place_error: float  # largest deviation of y, in parts of the stroke


def constructed(program: Program, count: int) -> Construction:
    """Integrate y'' twice by chords: ``count`` equal intervals of every moving phase, more where y'' jumps inside one.

    A dwell is one interval.
    """
    strips: list[Strip] = []
    errors = np.zeros(2)
    phases, place, number = program.phases, 0.0, 0
    last = max(k for k, phase in enumerate(phases) if phase.moves)
    for phase, (begin, end) in zip(phases[: last + 1], pairwise(program.starts.tolist()), strict=False):
        phi = _ordinates(program, begin, end, count) if phase.moves else np.array([begin, end])
        width = np.diff(phi)
        bend = program.at((phi[:-1] + phi[1:]) / 2)[2]
        slope = np.concatenate(([0.0], np.cumsum(bend * width)))
        steps = (slope[:-1] + slope[1:]) / 2 * width
        strip = Strip(number, phi, bend, slope, place + np.concatenate(([0.0], np.cumsum(steps))))
        strips.append(strip)
        if phase.moves:
            exact = program.at(phi)
            errors = np.maximum(errors, [np.max(np.abs(made - own)) for made, own in
                                         ((slope, exact[1]), (strip.place, exact[0]))])  # fmt: skip
        place, number = float(strip.place[-1]), number + len(width)
    peak = float(np.max(np.abs(program.panels.turning(program.sampled[1])[1])))
    return Construction(tuple(strips), float(errors[0]) / peak, float(errors[1]) / program.stroke)


def _ordinates(program: Program, begin: float, end: float, count: int) -> Values:
    """Angles of the ordinates of a phase: equal intervals, and the places inside at which y'' jumps."""
    jumps = program.edges[:-1][program.jumps[2] != 0]
    every = np.sort(np.concatenate((np.linspace(begin, end, count + 1), jumps[(jumps > begin) & (jumps < end)])))
    return every[np.concatenate(([True], np.diff(every) > SAME * float(program.starts[-1])))]
