"""How large a roller may be: every limit, exactly.

convex parts       r_r < rho of the pitch curve, else the working profile gets a point
same row           r_r < l_k sin(2 pi/z2), else neighbours touch
tip of the lobe    k_w > 1/2: flank A has to drive until the groove can
camshaft           r_r < a - l_k - shaft, where the groove comes nearest to O1
"""

from __future__ import annotations

from math import pi, sin

import numpy as np

from tmmcalc.cams.indexing.flanks import Drive, Flank, FlankName, on_panels
from tmmcalc.cams.laws.law import Values
from tmmcalc.core.quantity import quantity
from tmmcalc.core.records import record

USUAL = 0.7, 0.8  # of the least convex radius: what is chosen, what is usual at most
SMALL = 1e-12


@record
class RollerLimit:
    """The radius [m] below which a roller works; None: any."""

    name: str
    radius: float | None = quantity("r_max: {limit}[m]", "radius below which a roller works: {limit}")
    part: float | None = None  # k, where it is that of one place


def convex_limit(drive: Drive, name: FlankName, end: float) -> RollerLimit:
    """Least convex radius of the pitch curve of a flank from k = 0 to ``end``."""
    flank = Flank(drive, name)
    on, values = on_panels(flank.curvature, drive, 0.0, end)
    _, (most, at) = on.extremes(values)
    return RollerLimit(f"convex parts of {name}", 1 / most if most > 0 else None, at)


def tip_limit(drive: Drive) -> RollerLimit:
    """The roller with which the working flank A would end in the middle of the step."""
    flank, axis = Flank(drive, "A"), np.exp(0.5j * drive.step)

    def reach(k: Values) -> Values:
        """Distance along the normal to the axis of the lobe as its inverse, which has no jump at infinity."""
        here = flank.frame(k)
        points, normal = (flank.follower.placed(each) * axis for each in (here.points, 1j * here.tangent))
        return np.asarray(-normal.imag / points.imag)

    on, values = on_panels(reach, drive, 0.0, 0.5)
    _, (most, at) = on.extremes(values)
    return RollerLimit("tip of the lobe", 1 / most if most > SMALL / drive.centres else None, at)


def roller_limits(drive: Drive, end: float, shaft: float) -> tuple[RollerLimit, ...]:
    """All limits; ``end`` is k_m, ``shaft`` the radius of the camshaft [m]."""
    return (
        convex_limit(drive, "A", end),
        convex_limit(drive, "B", 1.0),
        RollerLimit("rollers of one row", drive.wheel * sin(2 * pi / drive.rollers)),
        tip_limit(drive),
        RollerLimit("camshaft", drive.centres - drive.wheel - shaft, 0.5),
    )


def governing(limits: tuple[RollerLimit, ...]) -> RollerLimit:
    """The limit that is least."""
    return min(limits, key=lambda each: np.inf if each.radius is None else each.radius)
