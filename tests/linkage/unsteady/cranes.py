"""The luffing gear by the closed forms of the textbook, (2.72) to (2.89) with their signs corrected."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from tmmcalc.core.numerics.panels import Values


class Crane(NamedTuple):
    """Mast at polar (l0, phi0), boom l1 to the rack, lc to the tip."""

    l0: float
    phi0: float
    l1: float
    lc: float

    def rack(self, outreach: float) -> float:
        """Length of the rack at an outreach, (2.72) to (2.74)."""
        theta = self.phi0 - math.acos(outreach / self.lc)
        return math.sqrt(self.l0**2 + self.l1**2 - 2 * self.l0 * self.l1 * math.cos(theta))

    def at(self, l2: Values, v: Values, a: Values) -> dict[str, Values]:
        """Everything at rack lengths with their speeds and accelerations."""
        l0, l1, lc = self.l0, self.l1, self.lc
        phi1 = self.phi0 - np.arccos((l1**2 + l0**2 - l2**2) / (2 * l0 * l1))
        phi2 = phi1 - np.arccos((l1**2 - l0**2 + l2**2) / (2 * l1 * l2))
        c, d = np.cos(phi2 - phi1), np.sin(phi2 - phi1)
        om1, om2 = v / (l1 * d), v * c / (l2 * d)
        ep1 = (a + l1 * om1**2 * c - l2 * om2**2) / (l1 * d)
        ep2 = ((a - l2 * om2**2) * c - 2 * om2 * v * d + l1 * om1**2) / (l2 * d)
        return {
            "phi1": phi1,
            "om1": om1,
            "ep1": ep1,
            "phi2": phi2,
            "om2": om2,
            "ep2": ep2,
            "l2": l2,
            "v23": v,
            "a23": a,
            "xC": lc * np.cos(phi1),
            "yC": lc * np.sin(phi1),
            "vCx": -lc * om1 * np.sin(phi1),
            "vCy": lc * om1 * np.cos(phi1),
            "aCx": -lc * (ep1 * np.sin(phi1) + om1**2 * np.cos(phi1)),
            "aCy": lc * (ep1 * np.cos(phi1) - om1**2 * np.sin(phi1)),
        }
