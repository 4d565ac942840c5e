"""What the sliding in a pair is measured by, so that rest can be told from motion."""

from __future__ import annotations

import numpy as np

from tmmcalc.linkage.crossings import STILL
from tmmcalc.linkage.forces.wrench import sliding
from tmmcalc.linkage.loads.scene import Scene
from tmmcalc.linkage.model import Joint


def scale_of(joint: Joint, scene: Scene) -> float:
    """Largest relative rate in a joint over the survey; of a pair that never slides what counts as motion at all."""
    configuration = scene.survey.configuration
    own = float(np.max(np.abs(sliding(joint, configuration)[0])))
    around = _size(scene) if joint.kind == "prismatic" else _fastest(joint, scene)
    return own if own > STILL * around else around


def _size(scene: Scene) -> float:
    """Largest coordinate of the metric, per unit of the input coordinate."""
    if not scene.chain.turns:
        return 1.0
    mechanism = scene.chain.mechanism
    points = (p for link in (mechanism.frame, *mechanism.links) for p in link.points.values())
    pins = (p for joint in mechanism.joints for p in joint.points)
    return max(abs(p) for p in (*points, *pins)) or 1.0


def _fastest(joint: Joint, scene: Scene) -> float:
    """Largest rate of turning of the two links; of links that never turn one radian per unit of the input."""
    motions = scene.survey.configuration.motions
    return max(float(np.max(np.abs(motions[k].omega))) for k in joint.links) or 1.0
