"""What the last digit of the metric does to reactions and the drive; their error by rounding is told where they are."""

from __future__ import annotations

import numpy as np

from tmmcalc.core.plane import Plane, Real
from tmmcalc.linkage.chain import Chain
from tmmcalc.linkage.errors import centre_of, chosen_of, weakest_of
from tmmcalc.linkage.forces.kinetostatics import Statics
from tmmcalc.linkage.lastdigit import against, effects
from tmmcalc.linkage.loads.sources import Place
from tmmcalc.linkage.results import Kinematics


def last_digit(statics: Statics, theta: Real, side: Real, kinematics: Kinematics) -> float | None:
    """Largest change of a force or of the drive at theta (n,), each against its largest there [-].

    None where the kinematics has none to tell. The loads act as they do; their own digits are not amplified.
    """
    if kinematics.error.last_digit is None:
        return None
    travel, chain = statics.scene.travel, statics.scene.chain
    rows = chosen_of(chain, travel.x(theta), weakest_of(kinematics.qualities))
    theta, side = theta[rows], side[rows]

    def forces(of: Chain, x: Real) -> tuple[Plane, Real]:
        own = statics.on(of)
        state = own.solve(Place(theta, of.evaluate(x), side), side)
        reactions = [np.broadcast_to(state.reactions[joint.name].wrench.force, x.shape) for joint in own.joints]
        return np.array(reactions), np.broadcast_to(state.drive, x.shape)

    x = travel.x(theta)
    pairs = zip(effects(chain, x, forces, centre_of(chain, kinematics)), forces(chain, x), strict=True)
    return max(against(effect, float(np.max(np.abs(values)))) for effect, values in pairs)
