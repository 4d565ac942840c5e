"""From what is asked to linkages: parameters that are given, and those that a search tries, as one array.

A row of the array has the parameters in the order of `NAMES`; the middle position is told as part of the turns to the
last one, which is how its range is meant.
"""

from __future__ import annotations

import math

import numpy as np

from tmmcalc.core.errors import UsageError
from tmmcalc.core.plane import Real
from tmmcalc.linkage.synthesis.dwell.linkages import (
    Drawn,
    Linkages,
    Parameters,
    from_lengths,
    from_positions,
    pivot_of,
    rocking,
    sliding,
)
from tmmcalc.linkage.synthesis.dwell.task import DwellTask

RANGES = {
    "phi12_part": (0.4, 0.6),  # phi12/phi_B
    "psi0": (0.1 * math.pi, 0.9 * math.pi),
    "psi13": (-0.9 * math.pi, -0.1 * math.pi),
    "psi12_part": (0.4, 0.6),  # psi12/psi13
    "bar": (0.1, 1.5),
    "side": (0.1, 1.5),
    "alpha": (0.1 * math.pi, 2 * math.pi - 0.1),
    "n": (0.2, 0.8),
    "left": (0.0, 1.0),  # the pivot of a rocker is to the left from 0.5 on
}
NAMES = tuple(RANGES)
USUAL = 0.5  # of n, where neither it nor a cyclogram is given and nothing is sought


def by_rule(asked: DwellTask) -> float | None:
    """n that is given, or by the stroke towards the dwell: 180 deg - n phi_B, clockwise 180 deg - (1 - n) phi_B."""
    if asked.n is not None or asked.working_angle is None:
        return asked.n
    n = (math.pi - asked.working_angle) / asked.dwell
    return 1 - n if asked.clockwise else n


def given(asked: DwellTask) -> dict[str, float | None]:
    """The parameters by name, None where they are to be found."""
    p = asked.positions
    part12 = None if p.phi12 is None else p.phi12 / asked.dwell
    bars = None if p.psi12 is None or p.psi13 is None else p.psi12 / p.psi13
    left = 0.5 if asked.pivot is not None or asked.output == "slider" else asked.pivot_left
    n = by_rule(asked)
    values = (part12, p.psi0, p.psi13, bars, p.bar, p.side, p.alpha, n, None if left is None else float(left))
    return dict(zip(NAMES, values, strict=True))


def drawn(asked: DwellTask, rows: Real) -> Drawn:
    """The linkages (m,) of parameters (m, 9), or of the lengths that are given, with their output."""
    values = dict(zip(NAMES, rows.T, strict=True))
    if asked.lengths is not None:
        found = from_lengths(asked.lengths, asked.dwell)
    else:
        dwell = np.full(len(rows), asked.dwell)
        found = from_positions(
            Parameters(
                values["phi12_part"] * dwell,
                dwell,
                values["psi0"],
                values["psi12_part"] * values["psi13"],
                values["psi13"],
                values["bar"],
                values["side"],
                values["alpha"],
            )
        )
    return found._replace(linkages=with_output(asked, found.linkages, values["n"], values["left"] >= 0.5))


def with_output(asked: DwellTask, linkages: Linkages, n: Real, left: np.ndarray, longer: float = 1.0) -> Linkages:
    """The linkages with their slider or rocker; ``longer`` lengthens OF beyond what the rule of the swing says."""
    if asked.output == "slider":
        return sliding(linkages, n, asked.dwell, asked.reverse)
    if asked.pivot is not None:
        return rocking(linkages, np.asarray(asked.pivot))
    if asked.swing is None:
        raise UsageError(
            "a rocker needs its swing, or its pivot",
            where="synthesis.dwell",
            remedy='add swing = "40 deg", or pivot = [x, y] in parts of l_OB',
        )
    return rocking(linkages, longer * pivot_of(linkages, n, asked.dwell, asked.swing, left))
