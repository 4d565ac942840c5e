"""Curves over the ratio of a planetary train: its efficiency and its ratio (textbook, figures 4.8 to 4.10)."""

from __future__ import annotations

import math

import numpy as np

from tmmcalc.core.errors import UsageError
from tmmcalc.core.records import record
from tmmcalc.gears.model import Values
from tmmcalc.gears.network.types import WHERE, efficiency, inverted_ratio

NEAREST = 1e-3  # to a pole where the limits of the picture do not end the branch


@record
class Curve:
    """One continuous branch."""

    label: str
    x: Values  # (p,)
    y: Values  # (p,)


def efficiency_over_ratio(
    eta0: float, low: float = -20.0, high: float = 20.0, lowest: float = -1.0, points: int = 200
) -> tuple[Curve, ...]:
    """Efficiency over i_1H with wheel 1 driving (figure 4.9), on both sides of i_1H = 0 and down to ``lowest``.

    >>> [curve.label for curve in efficiency_over_ratio(0.9)]
    ['i_1H < 0', '0 < i_1H < 1', 'i_1H > 1']
    """
    if not (low < 0 and high > 1 and lowest < 0):
        raise UsageError(f"limits {low:g} to {high:g}, down to {lowest:g}", where=WHERE, remedy="low < 0 < 1 < high")
    loss = 1 - eta0
    left = min(loss / (lowest - eta0), -NEAREST)
    right = max(loss / (1 - eta0 * lowest), NEAREST)
    ranges = {"i_1H < 0": (low, left), "0 < i_1H < 1": (right, 1.0), "i_1H > 1": (1.0, high)}
    curves = []
    for label, ends in ranges.items():
        i = np.linspace(*ends, points)
        curves.append(Curve(label, i, efficiency(i, eta0)))
    return tuple(curves)


def efficiency_over_reduction(eta0: float, largest: float = 100.0, points: int = 200) -> tuple[Curve, ...]:
    """Efficiency over |1/i_1H| from 1 to ``largest`` with the carrier driving, for both signs of i_1H (figure 4.10)."""
    if not largest > 1:
        raise UsageError(f"the largest ratio is {largest:g}", where=WHERE, value=largest, limit=1.0, remedy="above 1")
    r = np.geomspace(1.0, largest, points)
    signs = {"0 < i_1H < 1": 1, "-1 < i_1H < 0": -1}
    return tuple(Curve(label, r, efficiency(sign / r, eta0, "H")) for label, sign in signs.items())


def ratio_over_inverted(
    low: float = -8.0, high: float = 8.0, largest: float = 20.0, points: int = 200
) -> tuple[Curve, ...]:
    """i_1H over i_13^H, and the reduction |1/i_1H| up to ``largest`` on both sides of i_13^H = 1 (figure 4.8)."""
    gap = 1 / largest if math.isfinite(largest) and largest > 0 else 0.0
    if not (gap and low < 1 - gap and 1 + gap < high):
        raise UsageError(
            f"limits {low:g} to {high:g}, up to {largest:g}",
            where=WHERE,
            remedy="both sides of 1 must be in the picture",
        )
    line = np.linspace(low, high, points)
    curves = [Curve("i_1H", line, inverted_ratio(line))]
    for label, ends in {"|1/i_1H|, i_13H < 1": (low, 1 - gap), "|1/i_1H|, i_13H > 1": (1 + gap, high)}.items():
        x = np.linspace(*ends, points)
        curves.append(Curve(label, x, 1 / np.abs(inverted_ratio(x))))
    return tuple(curves)
