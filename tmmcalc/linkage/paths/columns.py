"""The columns of the table of wanted paths: a row a wanted point."""

from __future__ import annotations

from functools import partial

import numpy as np

from tmmcalc.core.columns import Column, column, degrees
from tmmcalc.core.quantity import Quantity
from tmmcalc.linkage.paths.results import Paths

PHI = Quantity("phi[{own}]", "input coordinate, counted from position 0, where the path is nearest to the point")
WANTED = Quantity("{axis}_wanted[m]", "{axis} of the wanted point")
REACHED = Quantity("{axis}_reached[m]", "{axis} of the place of the path that is nearest to the point, or timed for it")
OFF = Quantity("d{axis}[m]", "{axis} of the path less that of the wanted point")
DISTANCE = Quantity("distance[m]", "distance of the path from the wanted point")


def path_columns(result: Paths) -> list[Column]:
    """All columns of a result; angles in degrees, everything else in SI."""
    off = result.reached - result.wanted
    phi = degrees(result.phi) if result.turns else result.phi
    planes = [
        column(told.of(axis=axis), partial(np.asarray, part))
        for told, z in ((OFF, off), (WANTED, result.wanted), (REACHED, result.reached))
        for axis, part in (("x", z.real), ("y", z.imag))
    ]
    first = column(PHI.of(own="deg" if result.turns else "m"), lambda: phi)
    return [first, column(DISTANCE, lambda: np.abs(off)), *planes]
