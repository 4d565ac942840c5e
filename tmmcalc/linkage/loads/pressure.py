"""The pressure in a cylinder over its cycle, by its tables and the motion of its piston."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tmmcalc.core.plane import Real
from tmmcalc.linkage.assembly import TURN
from tmmcalc.linkage.loads.interpolation import reduced, straight
from tmmcalc.linkage.loads.strokes import Piston
from tmmcalc.linkage.loads.travel import EDGE

Strokes = tuple[tuple[tuple[float, ...], tuple[float, ...]], ...]


class Pressure(NamedTuple):
    """Pressure in a cylinder over its cycle, from one table a stroke."""

    strokes: Strokes  # abscissae and pressures of each
    back: float  # pressure on the other side [Pa]
    piston: Piston
    first: float  # theta at which the first stroke begins [rad]
    half: float  # angle of the strokes away from the closed end [rad]

    @property
    def period(self) -> float:
        """Angle of the cycle [rad]."""
        return TURN * (len(self.strokes) // 2)

    @property
    def edges(self) -> list[float]:
        """theta of the beginnings of all strokes [rad]."""
        return [self.first + TURN * (k // 2) + self.half * (k % 2) for k in range(len(self.strokes))]

    def __call__(self, theta: Real, coordinate: Real) -> Real:
        """Pressure less that of the other side [Pa] at theta, the piston standing at ``coordinate`` [m]."""
        along = reduced(theta, self.first, self.period) - self.first
        beginnings = np.array(self.edges) - self.first
        stroke = np.maximum(np.searchsorted(beginnings, along - EDGE) - 1, 0)
        x = np.clip((coordinate - self.piston.low) / (self.piston.high - self.piston.low), 0.0, 1.0)
        nodes = (_ascending(*table) for table in self.strokes)
        tables = [straight(np.array(at), np.array(p), x) for at, p in nodes]
        return np.choose(stroke, tables) - self.back


def pressure_of(strokes: Strokes, back: float, delay: float, piston: Piston) -> Pressure:
    """The pressure law of a piston; its first stroke begins at the first outer dead centre from ``delay`` on [rad]."""
    turns = np.ceil((delay - piston.outer - EDGE) / TURN)
    return Pressure(
        strokes, back, piston, piston.outer + TURN * max(float(turns), 0.0), (piston.inner - piston.outer) % TURN
    )


def _ascending(x: tuple[float, ...], p: tuple[float, ...]) -> tuple[tuple[float, ...], tuple[float, ...]]:
    return (x, p) if x[0] < x[-1] else (x[::-1], p[::-1])
