"""The columns of the table of solutions: number, sizes in m and deg, figures of merit, number of defects."""

from __future__ import annotations

import numpy as np

from tmmcalc.core.quantity import Quantity, in_degrees, quantity_of
from tmmcalc.core.stored import DeferredColumns, Table
from tmmcalc.linkage.synthesis.dwell.columns import PIN, columns_of
from tmmcalc.linkage.synthesis.results import ANGLE_ERROR, DISTANCE, PRESSURE, TRANSMISSION, Design, Synthesis

TOLD = (  # what the columns mean that are no sizes
    *(TRANSMISSION, PRESSURE, DISTANCE, ANGLE_ERROR, *PIN),
    Quantity("structural_error_max[{unit}]", "largest error of the output over the range of the function"),
    Quantity("structural_error_rms[{unit}]", "root mean square of the error of the output over the range"),
    Quantity("r/l", "length of the crank over that of the rod"),
    Quantity("e/r", "offset of the guide over the length of the crank"),
    Quantity("r/L", "length of the crank over the distance of the fixed pivots"),
    Quantity("L/r", "distance of the fixed pivots over the length of the crank"),
    Quantity("longest/shortest", "longest link over the shortest"),
)


def table(result: Synthesis) -> Table:
    """One row a solution: its sizes and figures of merit; of a dwell one row a position of the best one."""
    if result.best.dwell is not None:
        dwell = result.best.dwell
        listed = columns_of(dwell.motion, dwell.output)
        return Table(
            ["i", *(c.header for c in listed)],
            DeferredColumns([np.array(dwell.motion.labels), *(c.make for c in listed)]),
        )
    found = columns(result)
    return Table(list(found), [np.array(values) for values in found.values()])


def columns(result: Synthesis) -> dict[str, list[float] | list[str]]:
    """Columns by header, one row a solution; all solutions of a kind have the same sizes."""
    found: dict[str, list[float] | list[str]] = {"i": [str(k + 1) for k in range(len(result.designs))]}
    for size in result.best.sizes:
        found[size.told.key] = [design.size(size.symbol) for design in result.designs]
    for name in result.best.merits:
        found[name] = [design.merits[name] for design in result.designs]
    found[quantity_of(Design, "defects").key] = [float(len(design.defects)) for design in result.designs]
    return in_degrees(found)
