"""What rounding leaves of a train's torques, powers and efficiency.

The residual of the equilibrium in extended precision, over its matrix, is the error of the torques; the same flow is
then computed again from the torques without it, at the exact speeds. What known torques themselves are rounded by
when they come from loads and powers is added as the equilibrium passes it on.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from tmmcalc.core.numerics.extended import EPS, as_number
from tmmcalc.core.records import record
from tmmcalc.gears.model import Values
from tmmcalc.gears.network.equilibrium import Statics, lossy_matrix, matrix_of
from tmmcalc.gears.network.speeds import Motion

WIDE = np.longdouble
CORRECTIONS = 2  # each leaves 1e-16 times the condition number of what was missed


@record
class FlowError:
    """Relative errors of a power flow."""

    torques: float  # outside, of meshes and of locks: to the largest of them
    powers: float  # of members, of meshes, lost: to the largest of them
    efficiency: float  # of the ratio of two powers from outside, to it or to 1, whichever is larger


def corrected(statics: Statics, directions: Values, x: Values) -> tuple[Statics, Values, Values]:
    """The equilibrium and its unknown torques (n,) in extended precision, and what roundings of loads make of them."""
    wide = statics._replace(
        motion=_exact(statics.motion),
        load=statics.load.astype(WIDE),
        matrix=matrix_of(statics.network, statics.constraints.astype(WIDE), statics.unknown),
    )
    matrix, found = lossy_matrix(wide, directions), x.astype(WIDE)
    inverse = np.linalg.inv(matrix.astype(float))
    for _ in range(CORRECTIONS):
        found = found - inverse @ (matrix @ found + wide.load).astype(float)
    return wide, found, EPS / 2 * np.abs(inverse) @ np.abs(statics.load)


def _exact(motion: Motion) -> Motion:
    """The motion in extended precision."""
    speeds = np.array([as_number(w, WIDE) for w in motion.exact])
    rolling = np.array([[as_number(w, WIDE) for w in pair] for pair in motion.exact_rolling], WIDE)
    return replace(motion, speeds=speeds, rolling=rolling.reshape(-1, 2))
