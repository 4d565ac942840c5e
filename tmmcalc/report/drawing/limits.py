"""Functions on panels as curves: the points with both edges of every panel, where a jump shows its two limits."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.numerics.panels import Panels, Values


def places(panels: Panels) -> Values:
    """The points and the edges of every panel (m,), ascending: an inner edge stands twice."""
    return np.concatenate((panels.edges[:-1, None], panels.x, panels.edges[1:, None]), axis=1).ravel()


def with_limits(panels: Panels, values: NDArray[Any]) -> NDArray[Any]:
    """Values (..., K, N) with the limits at both edges of every panel, (..., m) at `places`."""
    low, high = panels.ends(values)
    rows = np.concatenate((low[..., None], values, high[..., None]), axis=-1)
    return rows.reshape(*values.shape[:-2], -1)
