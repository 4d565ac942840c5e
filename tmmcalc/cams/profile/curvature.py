"""Curvature over the turn, exactly: its extremes with both sides of a jump, and where an offset runs backwards."""

from __future__ import annotations

from functools import cached_property

import numpy as np

from tmmcalc.cams.laws.law import Indices, Values
from tmmcalc.cams.profile.offsets import Rim
from tmmcalc.cams.profile.results import Place
from tmmcalc.cams.program import TURN, levelled
from tmmcalc.core.numerics.panels import Panels, resolved
from tmmcalc.core.numerics.roots import bracketed
from tmmcalc.core.records import record

LEVEL = 1e-12  # of the largest: values that count as equal
ROUNDING = 1e-11  # of the factor of an offset: not backwards yet
Interval = tuple[float, float]


@record
class Bends:
    """Curvature [1/m] (flat face: rho [m]) on panels that resolve it."""

    rim: Rim
    panels: Panels
    values: Values  # (K, N)

    @cached_property
    def turning(self) -> tuple[Values, Values]:
        """Places and values of all local extremes."""
        return self.panels.turning(levelled(self.values))

    def extreme(self, sign: int) -> Place:
        """The largest (-1: least) value; of equal ones the first."""
        on, (at, found) = self.panels, self.turning
        best = np.max(sign * found)
        level = np.flatnonzero(sign * found >= best - LEVEL * np.max(np.abs(found)))
        first = int(level[np.argmin(at[level])])
        inner = len(at) - 2 * on.count
        side = 0 if first < inner else 1 if first < inner + on.count else -1
        place = float(at[first])
        return Place(float(sign * best), place, side if self._jumps(place) else 0)

    def _jumps(self, phi: float) -> bool:
        """Whether y'' is not continuous at this edge."""
        program = self.rim.program
        near = int(np.argmin(np.abs(program.edges - phi))) % (len(program.edges) - 1)
        return bool(program.jumps[2, near])

    def backwards(self, distance: float) -> tuple[Interval, ...]:
        """Intervals (from, to) of phi where the offset inwards by ``distance`` runs backwards, exact to rounding."""
        phi, panel, factor = self._knots(distance)
        size = max(1e-300, float(np.max(np.abs(factor))))
        back = factor < -ROUNDING * size
        changes = np.flatnonzero(back[1:] != back[:-1])
        if not changes.size:
            return ((0.0, TURN),) if back[0] else ()
        inner = panel[changes] == panel[changes + 1]
        bounds = phi[changes + 1].copy()
        piece = self.rim.pieces(((self.panels.edges[:-1] + self.panels.edges[1:]) / 2)[panel[changes[inner]]])
        bounds[inner] = bracketed(
            lambda x, which: self._factor(x, piece[which], distance), phi[changes[inner]], phi[changes[inner] + 1]
        )
        return _paired(bounds.tolist(), bool(back[0]), bool(back[-1]))

    def _knots(self, distance: float) -> tuple[Values, Indices, Values]:
        """Angles, panels, and the factor of the offset at points, ends and turns of the curvature, in order."""
        on, rim = self.panels, self.rim
        at, found = self.turning
        inner = slice(0, len(at) - 2 * on.count)
        low, high = on.ends(self.values)
        every = np.arange(on.count)
        of_turns = np.clip(np.searchsorted(on.edges, at[inner], side="right") - 1, 0, on.count - 1)
        phi = np.concatenate((on.x.ravel(), at[inner], on.edges[:-1], on.edges[1:]))
        panel = np.concatenate((np.repeat(every, on.order), of_turns, every, every))
        value = np.concatenate((self.values.ravel(), found[inner], low, high))
        order = np.lexsort((phi, panel))
        value = value[order]
        return phi[order], panel[order], value - distance if rim.flat else 1 - value * distance

    def _factor(self, phi: Values, piece: Indices, distance: float) -> Values:
        return self.rim.at(phi, piece).factor(distance, self.rim.flat)


def _paired(bounds: list[float], begins: bool, ends: bool) -> tuple[Interval, ...]:
    """Intervals between alternating bounds; the one that goes on through phi = 0 ends beyond the turn."""
    if begins and ends:
        bounds = [*bounds[1:], bounds[0] + TURN]
    elif begins or ends:
        bounds = [0.0, *bounds] if begins else [*bounds, TURN]
    return tuple(zip(bounds[::2], bounds[1::2], strict=True))


def bends(rim: Rim) -> Bends:
    """The curvature of the pitch curve, or rho of the profile under a flat face."""

    def values(phi: Values) -> Values:
        here = rim.at(phi, rim.pieces(phi))
        return (here.speed if rim.flat else here.bend)[None]

    on, found, _ = resolved(values, rim.program.panels)
    return Bends(rim, on, found[0])
