"""The table of the forces on the follower, in SI.

S, psi           displacement from the lowest position
P, Q_spring, Q   inertia, spring, technological force with weight along the lift; of a rocker the moments M_...
P_c              their sum: it presses on the cam where it is negative
R, N1, N2        of the cam; of lower and upper edge of the guide along x; R_A_x, R_A_y of the frame on the rocker
T, M_drive       P_c S' on the camshaft (5.75); what the camshaft has to give, friction included
"""

from __future__ import annotations

import numpy as np

from tmmcalc.cams.forces.results import CamForces


def force_columns(result: CamForces) -> dict[str, np.ndarray]:
    """Columns of all rows by their headers."""
    turns = result.follower.kind == "oscillating"
    unit, letter = ("N*m", "M") if turns else ("N", "P")
    columns = {
        "i": np.array(result.positions.labels),
        "phi[deg]": np.degrees(result.positions.phi),
        "dpsi[rad]" if turns else "dS[m]": result.lift,
        f"{letter}_in[{unit}]": result.inertia,
        f"{'M' if turns else 'Q'}_spring[{unit}]": result.elastic,
        f"{'M_Q' if turns else 'Q'}[{unit}]": result.force,
        f"{letter}_c[{unit}]": result.load,
        "theta[deg]": np.degrees(result.theta),
        "mu": result.ratio,
        "R[N]": result.contact,
    }
    if result.protrusion is not None:
        columns["q[m]"] = result.protrusion
    if result.lower is not None and result.upper is not None:
        columns |= {"N1[N]": result.lower, "N2[N]": result.upper}
    if result.pivot is not None:
        columns |= {"R_A_x[N]": result.pivot[0], "R_A_y[N]": result.pivot[1], "R_A[N]": np.hypot(*result.pivot)}
    return columns | {"T[N*m]": result.torque, "M_drive[N*m]": result.driving}
