"""Functions on panels that are constant on some of them, as all is in a dwell: their rounding has no turning points."""

from __future__ import annotations

import numpy as np

from tmmcalc.cams.laws.law import Values
from tmmcalc.core.numerics.gauss import rule

FLAT = 1e-13  # of the largest: what varies less is constant


def steady(values: Values) -> Values:
    """Values (K, N) with a slope of rounding on panels where they are constant.

    Rounding would make such a panel full of turning points, which all would be looked for.
    """
    peak = np.max(np.abs(values))
    flat = np.max(values, axis=1) - np.min(values, axis=1) <= FLAT * peak
    if not flat.any():
        return values
    ramp = FLAT * peak * rule(values.shape[1]).points
    return np.where(flat[:, None], values[:, :1] + ramp, values)
