"""Reactions and drive densely over the whole cycle, with both limits at every jump of a load or of friction."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.numerics.panels import Panels, panels
from tmmcalc.core.plane import Plane, Real
from tmmcalc.core.records import record
from tmmcalc.linkage.forces.kinetostatics import Statics, compile_statics, reversals
from tmmcalc.linkage.forces.stack import stacked
from tmmcalc.linkage.loading import Loading
from tmmcalc.linkage.loads.scene import compile_scene
from tmmcalc.linkage.model import Mechanism
from tmmcalc.linkage.results import Kinematics
from tmmcalc.report.drawing.limits import places, with_limits

PARTS = 24  # of the cycle at least, each with the points of a panel


@record
class DiagramCourse:
    """What the diagrams draw, at m angles: two at every edge of a panel, the limits from both sides."""

    phi: Real  # (m,) input coordinate from position 0 [rad or m]
    turn: Plane  # (m,) unit vector along the x axis of a crank
    reaction: Plane  # (J, m) [N]
    drive: Real  # (m,) [N*m or N]
    panels: int  # of m / panels points each


def statics_of(mechanism: Mechanism, loading: Loading, kinematics: Kinematics) -> Statics:
    """The force analysis that the result was computed with."""
    return compile_statics(compile_scene(mechanism, loading, kinematics))


def course_of(statics: Statics) -> DiagramCourse:
    """Reactions at the points of panels whose edges lie at every jump; the limits there are extrapolated."""
    scene = statics.scene
    period = scene.travel.period
    widest = (2 * math.pi if scene.chain.turns else period) / PARTS
    dense = panels(0.0, period, scene.edges(reversals(statics)), widest)
    over, _ = stacked(statics, dense.x.ravel(), np.ones(dense.x.size))
    theta = places(dense)
    return DiagramCourse(
        scene.travel.sense * theta,
        np.exp(1j * scene.travel.x(theta)),
        with_limits(dense, _on(dense, over.reaction)),
        with_limits(dense, _on(dense, over.drive)),
        dense.count,
    )


def _on(dense: Panels, values: NDArray[Any]) -> NDArray[Any]:
    """Values (..., K N) in a row as those of panels, (..., K, N)."""
    return values.reshape(*values.shape[:-1], dense.count, dense.order)
