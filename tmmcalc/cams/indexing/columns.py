"""Tables of the indexing stage in SI: the motion of the wheel, both flanks, efficiency; a row a part of the step."""

from __future__ import annotations

import numpy as np

from tmmcalc.cams.indexing.results import FlankTable, Indexing
from tmmcalc.core.columns import degrees
from tmmcalc.core.quantity import Quantity, headed, quantity_of

PHI = Quantity("phi[deg]", "angle of the cams")
BETA = (
    Quantity("beta[deg]", "angle of the wheel"),
    Quantity("beta1", "derivative of beta by the angle of the cams", symbol="beta'"),
    Quantity("beta2", "second derivative of beta by the angle of the cams", symbol="beta''"),
)
FLANK = ("theta", "radius", "polar", "pressure", "source", "bend", "x", "y", "working_x", "working_y")


def indexing_columns(result: Indexing) -> dict[str, np.ndarray]:
    """Columns of all rows by their headers; of a law that is known by its B alone only the heads."""
    found = {"i": np.array(result.labels), **headed(result, "k"), PHI.key: degrees(result.step * result.k)}
    if result.cam is None:
        return found
    y, y1, y2, _ = result.motion
    found |= {told.key: row for told, row in zip(BETA, (degrees(y), y1, y2), strict=True)}
    for flank in (result.cam.a, result.cam.b):
        found |= _flank_columns(flank)
    return found | headed(result.cam.efficiency, "against", "aiding", "cut")


def _flank_columns(flank: FlankTable) -> dict[str, np.ndarray]:
    found = {}
    for name in FLANK:
        told, values = quantity_of(FlankTable, name, flank=flank.name), getattr(flank, name)
        turned = told.unit == "rad"
        found[told.shown("deg")[0] if turned else told.key] = degrees(values) if turned else values
    return found
