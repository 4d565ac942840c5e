"""The table of the pairs: sliding and pressure along the line of action of every pair, one after the other."""

from __future__ import annotations

import numpy as np

from tmmcalc.gears.meshing.results import MeshPair, Pairs

NO, YES = "no", "yes"


def pair_columns(found: Pairs) -> dict[str, np.ndarray]:
    """Columns by their headers; ``active`` tells whether the flanks touch there."""
    parts = [_of_pair(pair) for pair in found.pairs]
    return {header: np.concatenate([part[header] for part in parts]) for header in (parts[0] if parts else ())}


def _of_pair(pair: MeshPair) -> dict[str, np.ndarray]:
    table = pair.sliding
    return {
        "pair": np.full(len(table.rho1), pair.task.name or pair.task.title),
        "rho1[m]": table.rho1,
        "s[m]": table.along,
        "theta1": table.theta1,
        "theta2": table.theta2,
        "lambda": table.pressure,
        "active": np.where(table.active, YES, NO),
    }
