"""The table of the pairs: sliding and pressure along the line of action of every pair, one after the other."""

from __future__ import annotations

import numpy as np

from tmmcalc.core.quantity import headed
from tmmcalc.gears.meshing.results import MeshPair, Pairs, SlidingTable
from tmmcalc.gears.meshing.sliding import sliding_steps

NO, YES = "no", "yes"


def pair_columns(found: Pairs, step: float | None = None) -> dict[str, np.ndarray]:
    """Columns by their headers; ``active`` tells whether the flanks touch there.

    With a ``step`` [m] of rho1 in equal steps, as `sliding_steps` makes them, and raises.
    """
    parts = [sliding_columns(pair, pair.sliding if step is None else sliding_steps(pair, step)) for pair in found.pairs]
    return {header: np.concatenate([part[header] for part in parts]) for header in (parts[0] if parts else ())}


def sliding_columns(pair: MeshPair, table: SlidingTable) -> dict[str, np.ndarray]:
    """The columns of one pair."""
    return {
        "pair": np.full(len(table.rho1), pair.task.name or pair.task.title),
        **headed(table),
        "active": np.where(table.active, YES, NO),
    }
