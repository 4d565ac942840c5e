"""The torques of one mechanism over the turn: T, which the motion alone decides, and what the camshaft has to give."""

from __future__ import annotations

import numpy as np

from tmmcalc.cams.forces.kernels import cam_torque
from tmmcalc.cams.optimum.peaks import largest
from tmmcalc.cams.optimum.scene import Scene, carried


def torques(scene: Scene, start: float, roller: float, top: float) -> tuple[float, float]:
    """Largest |T| of P_c S' (5.75), and the largest driving torque, friction of the guide included [N*m]."""
    on = carried(scene, *np.array([[start], [roller], [top]]))
    driving = cam_torque(on.contact, on.cosine, scene.motion)[0]
    rows = np.stack((scene.torque, -scene.torque, driving))
    plus, minus, given = largest(scene.by_panel(rows)).tolist()
    return max(plus, minus), given
