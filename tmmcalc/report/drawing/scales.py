"""Standard scales of drawings: reductions and enlargements of lengths, round factors of all else; how they are written.

A scale factor mu is the data to a mm of paper. That of lengths is in m/mm, so that 1:4 is 0.004 (GOST 2.302, which
holds the series of ISO 5455); the others are 1, 2, 2.5, 4, 5 times a power of ten.
"""

from __future__ import annotations

from math import floor, log10

import numpy as np

from tmmcalc.core.plane import Plane
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.field import needed
from tmmcalc.report.language import tr_number, tr_unit
from tmmcalc.report.numbers import round_scale

STEPS = (1.0, 2.0, 2.5, 4.0, 5.0, 10.0)
REDUCTIONS = (1.0, 2.0, 2.5, 4.0, 5.0, 10.0, 15.0, 20.0, 25.0, 40.0, 50.0, 75.0, 100.0, 200.0, 400.0, 500.0, 800.0, 1e3)
ENLARGEMENTS = (100.0, 50.0, 40.0, 20.0, 10.0, 5.0, 4.0, 2.5, 2.0)
MM = 1e-3  # [m]
SERIES = [float(f"{mu:.3g}") for mu in (*(MM / size for size in ENLARGEMENTS), *(MM * size for size in REDUCTIONS))]
CLOSE = 1e-9  # what a factor may be smaller than its least


def standard_scale(least: float) -> float:
    """The next standard factor above.

    >>> standard_scale(0.0173), standard_scale(30.0), standard_scale(0.0)
    (0.02, 40.0, 1.0)
    """
    return round_scale(least, STEPS)


def length_scale(least: float) -> float:
    """The next standard factor of lengths [m/mm].

    >>> length_scale(0.0031), length_scale(0.012), length_scale(0.00035)
    (0.004, 0.015, 0.0004)
    """
    if least < SERIES[0]:
        return standard_scale(least)
    return next((mu for mu in SERIES if mu >= least * (1 - CLOSE)), standard_scale(least))


def larger_than(most: float) -> float:
    """The standard factor of lengths that draws larger than ``most`` [m/mm], or just so: the next below.

    >>> larger_than(0.00011), larger_than(0.011), larger_than(8e-6)
    (0.0001, 0.01, 5e-06)
    """
    below = [mu for mu in SERIES if mu <= most * (1 + CLOSE)]
    if below:
        return below[-1]
    power = 10.0 ** floor(log10(most))
    return float(f"{max(step for step in STEPS if step * power <= most * (1 + CLOSE)) * power:.3g}")


def fitting_scale(content: Plane, box: Box, margin: float) -> float:
    """The standard factor [m/mm] at which all of a content [m] keeps its margin [mm] in a rectangle."""
    return length_scale(needed(content, box, margin))


def ratio(mu: float) -> str:
    """A scale of lengths [m/mm] as a drawing has it.

    >>> ratio(0.004), ratio(0.001), ratio(0.0004)
    ('1:4', '1:1', '2.5:1')
    """
    size = mu / MM
    return tr_number(f"1:{size:.4g}" if size >= 1 else f"{1 / size:.4g}:1")


def scale_text(mu: float) -> str:
    """A scale of lengths [m/mm] as it is written beside a picture.

    >>> scale_text(0.0005), scale_text(0.002)
    ('$μ_l$ = 0.0005 m/mm (2:1)', '$μ_l$ = 0.002 m/mm (1:2)')
    """
    return f"{factor_text('μ_l', mu, 'm/mm')} ({ratio(mu)})"


def factor_text(symbol: str, factor: float, unit: str) -> str:
    """A scale factor with its sign and unit.

    >>> factor_text("μ_v", 0.025, "(m/s)/mm"), factor_text("μ_l", 5e-5, "m/mm")
    ('$μ_v$ = 0.025 (m/s)/mm', '$μ_l$ = 0.00005 m/mm')
    """
    written = np.format_float_positional(float(f"{factor:.4g}"), trim="-")
    return f"${symbol}$ = {tr_number(written)} {tr_unit(unit)}"
