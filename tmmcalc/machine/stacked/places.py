"""Angles within the panels of many machines, and functions there."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.numerics.gauss import ORDER, legendre, rule
from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.numerics.roots import Indices
from tmmcalc.machine.nodes import NEAR
from tmmcalc.machine.stacked.regimes import Machines


class Places(NamedTuple):
    """Angles (n,) within the panels of V machines: the panel of each (V, n), its place there and what points count."""

    panel: Indices  # (V, n)
    place: Values  # (V, n) from 0 to 1
    parts: Values  # (V, n, N) of the points of the panel in a value

    def at(self, values: Values) -> Values:
        """Values (V, n) of a function (V, K, N); on an edge the limit that is meant."""
        return np.asarray(np.einsum("vmn,vmn->vm", self._rows(values), self.parts))

    def primitive(self, m: Machines, values: Values) -> Values:
        """Integrals (V, n) of a function (V, K, N) from the first edge on."""
        r, t = rule(ORDER), self.place
        whole = m.width * (values @ r.weights)
        before = np.cumsum(whole, axis=1) - whole
        p = legendre(2 * t.ravel() - 1, ORDER)
        inner = np.vstack((p[1] + 1, (p[2:] - p[:-2]) / (2 * np.arange(1, ORDER) + 1)[:, None])) / 2
        coefficients = self._rows(values) @ r.coefficients.T
        part = np.einsum("vmn,nvm->vm", coefficients, inner.reshape(ORDER, *t.shape))
        width = np.take_along_axis(m.width, self.panel, axis=1)
        return np.asarray(np.take_along_axis(before, self.panel, axis=1) + width * part)

    def _rows(self, values: Values) -> Values:
        return values[np.arange(len(values))[:, None], self.panel]


def places(m: Machines, theta: Values, early: NDArray[np.bool_]) -> Places:
    """Where angles (n,) lie in the panels of all machines: on an edge in that which begins there, or ends if early."""
    near = NEAR * float(m.low.flat[0] + np.sum(m.width[0]))
    panel = np.maximum(np.sum(m.low[:, :, None] <= theta + np.where(early, -near, near), axis=1) - 1, 0)
    low, width = (np.take_along_axis(v, panel, axis=1) for v in (m.low, m.width))
    place = (theta - low) / width
    gap = place[..., None] - rule(ORDER).points
    hit = gap == 0
    parts = np.where(hit.any(axis=-1, keepdims=True), hit, rule(ORDER).barycentric / np.where(hit, 1.0, gap))
    return Places(panel, place, parts / parts.sum(axis=-1, keepdims=True))
