"""Kinks of friction on the panels of many variants: zeros of the forces on the faces of sliders."""

from __future__ import annotations

import numpy as np

from tmmcalc.core.numerics.roots import Indices
from tmmcalc.core.plane import Plane, Real
from tmmcalc.linkage.forces.kinks import passing
from tmmcalc.linkage.stacked.ragged import Ragged


def kinks(on: Ragged, forces: Real | Plane, largest: Real) -> tuple[Indices, Real]:
    """Panels (m,) and places (m,) of the kinks of forces (F, P, N) on faces or in pins.

    ``largest`` are the sizes (F, V) of which a small part is noise.
    """
    if not len(forces):
        return np.zeros(0, np.intp), np.zeros(0)
    panel, place = passing(forces, largest[:, on.owner])
    return panel, on.low[panel] + on.width[panel] * place
