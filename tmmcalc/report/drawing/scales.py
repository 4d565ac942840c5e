"""Standard scales of lengths on drawings, and how scale factors are written beside them."""

from __future__ import annotations

import math

import numpy as np

from tmmcalc.report.language import tr_number, tr_unit

STEPS = (1.0, 2.0, 2.5, 4.0, 5.0, 10.0)  # of enlargements, times a power of ten
REDUCTIONS = (1.0, 2.0, 2.5, 4.0, 5.0, 10.0, 15.0, 20.0, 25.0, 40.0, 50.0, 75.0, 100.0)  # to 1:100 (GOST 2.302)
SLACK = 1 + 1e-9


def standard_scale(least: float) -> float:
    """The standard scale of lengths that is ``least`` or next above, both [m/mm] (GOST 2.302).

    Beyond 1:100 and 1000:1 its steps go on by powers of ten.

    >>> standard_scale(0.00011), standard_scale(0.011), standard_scale(0.0011)
    (0.0002, 0.015, 0.002)
    """
    part = 1e3 * least / SLACK
    if part > REDUCTIONS[-1]:
        power = 10.0 ** math.floor(math.log10(part))
        return 1e-3 * next(step * power for step in STEPS if step * power >= part)
    if part > 1:
        return next(step for step in REDUCTIONS if step >= part) / 1e3
    power = 10.0 ** math.floor(math.log10(1 / part))
    return 1e-3 / max(step * power for step in STEPS if step * power <= 1 / part)


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
