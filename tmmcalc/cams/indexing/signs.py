"""Functions of the part k of a step, resolved to rounding on panels, and where they change sign, all of it exactly."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from tmmcalc.cams.indexing.flanks import Drive
from tmmcalc.cams.laws.law import Values
from tmmcalc.core.numerics.panels import Panels, panels, resolved
from tmmcalc.core.numerics.roots import bracketed

WIDEST = 1 / 16  # of a first panel, of the step
Function = Callable[[Values], Values]


def sampled(f: Function, drive: Drive, low: float, high: float, *breaks: float) -> tuple[Panels, Values]:
    """Panels from ``low`` to ``high`` of the step that resolve f, and its values (K, N)."""
    edges = [*drive.law.breaks.tolist(), 0.5, *breaks]
    on, values, _ = resolved(lambda k: f(k)[None], panels(low, high, edges, WIDEST))
    return on, values[0]


def changes(f: Function, drive: Drive, low: float, high: float, *breaks: float) -> list[float]:
    """All k between ``low`` and ``high`` at which f changes sign, ascending; ``breaks`` are its kinks."""
    on, values = sampled(f, drive, low, high, *breaks)
    at, found = on.turning(values)
    k = np.concatenate((on.x.ravel(), at))
    order = np.argsort(k, kind="stable")
    k, value = k[order], np.concatenate((values.ravel(), found))[order]
    which = np.flatnonzero(np.signbit(value[1:]) != np.signbit(value[:-1]))
    roots: list[float] = bracketed(lambda x, _: f(x), k[which], k[which + 1]).tolist()
    return roots
