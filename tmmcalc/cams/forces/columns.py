"""The table of the forces on the follower, in SI.

S, psi           displacement from the lowest position
P, Q_spring, Q   inertia, spring, technological force with weight along the lift; of a rocker the moments M_...
P_c              their sum: it presses on the cam where it is negative
R, N1, N2        of the cam; of lower and upper edge of the guide along x; R_A_x, R_A_y of the frame on the rocker
T, M_drive       P_c S' on the camshaft (5.75); what the camshaft has to give, friction included
"""

from __future__ import annotations

import numpy as np

from tmmcalc.cams.follower import along
from tmmcalc.cams.forces.results import CamForces
from tmmcalc.core.quantity import headed, in_degrees, quantities

# names of the technological force with the weight, which have no word of its form
GIVEN = tuple(quantities(CamForces)["force"].of(**along(turns)) for turns in (False, True))


def force_columns(result: CamForces) -> dict[str, np.ndarray]:
    """Columns of all rows by their headers."""
    shown = ["lift", "inertia", "elastic", "force", "load", "theta[deg]", "ratio", "contact"]
    if result.protrusion is not None:
        shown.append("protrusion")
    if result.lower is not None and result.upper is not None:
        shown += ["lower", "upper"]
    if result.pivot is not None:
        shown += ["pivot_x", "pivot_y", "pivot_force"]
    rows = {"i": np.array(result.positions.labels), **headed(result.positions, "phi[deg]")}
    along_lift = headed(result, *shown, "torque", "driving", **along(result.follower.kind == "oscillating"))
    return rows | in_degrees(along_lift)
