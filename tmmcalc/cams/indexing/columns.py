"""Tables of the indexing stage in SI: the motion of the wheel, both flanks, efficiency; a row a part of the step."""

from __future__ import annotations

import numpy as np

from tmmcalc.cams.indexing.results import FlankTable, Indexing
from tmmcalc.core.columns import degrees


def indexing_columns(result: Indexing) -> dict[str, np.ndarray]:
    """Columns of all rows by their headers; of a law that is known by its B alone only the heads."""
    k = result.k
    columns = {"i": np.array(result.labels), "k": k, "phi[deg]": degrees(result.step * k)}
    if result.cam is None:
        return columns
    y, y1, y2, _ = result.motion
    columns |= {"beta[deg]": degrees(y), "beta1": y1, "beta2": y2}
    for flank in (result.cam.a, result.cam.b):
        columns |= _flank_columns(flank)
    table = result.cam.efficiency
    cut = np.where(table.against_cut, 1, 0) + np.where(table.aiding_cut, 2, 0)
    return {**columns, "eta_against": table.against, "eta_aiding": table.aiding, "eta_cut": cut}


def _flank_columns(flank: FlankTable) -> dict[str, np.ndarray]:
    name = flank.name
    return {
        f"theta_{name}[deg]": degrees(flank.theta),
        f"R_{name}[m]": flank.radius,
        f"delta_{name}[deg]": degrees(flank.polar),
        f"vartheta_{name}[deg]": degrees(flank.pressure),
        f"source_{name}[deg]": degrees(flank.source),
        f"rho_{name}[m]": flank.bend,
        f"x_{name}[m]": flank.pitch.real,
        f"y_{name}[m]": flank.pitch.imag,
        f"xw_{name}[m]": flank.working.real,
        f"yw_{name}[m]": flank.working.imag,
    }
