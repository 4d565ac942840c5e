"""Standard scales of lengths on drawings (GOST 2.302), and how scale factors are written beside them."""

from __future__ import annotations

import math

import numpy as np

from tmmcalc.core.plane import Plane
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.language import tr_number, tr_unit

STEPS = (1.0, 2.0, 2.5, 4.0, 5.0)  # of enlargements, and of reductions from 1:100 on, times a power of ten
REDUCTIONS = (1.0, 2.0, 2.5, 4.0, 5.0, 10.0, 15.0, 20.0, 25.0, 40.0, 50.0, 75.0)
SLACK = 1 + 1e-9


def standard_scale(least: float) -> float:
    """The standard scale of lengths that is ``least`` or next above, both [m/mm].

    >>> standard_scale(0.00011), standard_scale(0.011), standard_scale(0.0011)
    (0.0002, 0.015, 0.002)
    """
    return min(mu for mu in _near(least) if mu * SLACK >= least)


def larger_than(most: float) -> float:
    """The standard scale that draws larger than ``most``, or just so: it is next below, both [m/mm].

    >>> larger_than(0.00011), larger_than(0.011)
    (0.0001, 0.01)
    """
    return max(mu for mu in _near(most) if mu <= most * SLACK)


def fitting_scale(content: Plane, box: Box, margin: float) -> float:
    """The standard scale [m/mm] at which all of a content [m] keeps its margin [mm] in a rectangle."""
    size = complex(float(np.ptp(content.real)), float(np.ptp(content.imag)))
    need = max(size.real / (box.width - 2 * margin), size.imag / (box.height - 2 * margin))
    return standard_scale(need or 1e-6)


def _near(mu: float) -> list[float]:
    """Standard scales about a value, to both sides of it."""
    power = math.floor(math.log10(1e3 * mu))
    found = {1e-3 * part for part in REDUCTIONS}
    for k in range(power - 1, power + 2):
        found |= {float(f"{1e-3 / (step * 10.0**-k):.12g}") for step in STEPS if k <= 0}
        found |= {float(f"{step * 10.0 ** (k - 3):.12g}") for step in STEPS if k >= 2}
    return sorted(found)


def scale_text(mu: float) -> str:
    """A scale of lengths on paper, ``mu`` in metres to a millimetre.

    >>> scale_text(0.0005), scale_text(0.002)
    ('$μ_l$ = 0.0005 m/mm (2:1)', '$μ_l$ = 0.002 m/mm (1:2)')
    """
    part = f"1:{_short(1e3 * mu)}" if mu > 1e-3 * SLACK else f"{_short(1e-3 / mu)}:1"
    return f"{factor_text('μ_l', mu, 'm/mm')} ({part})"


def factor_text(symbol: str, factor: float, unit: str) -> str:
    """A scale factor with its sign and unit.

    >>> factor_text("μ_v", 0.025, "(m/s)/mm")
    '$μ_v$ = 0.025 (m/s)/mm'
    """
    return f"${symbol}$ = {_short(factor)} {tr_unit(unit)}"


def _short(value: float) -> str:
    return tr_number(np.format_float_positional(value, 3, fractional=False, trim="-"))
