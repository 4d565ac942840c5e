"""Stage ``cam_forces``: spring, reactions, friction and the torque of the cam."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from tmmcalc.cams.forces.results import CamForces
from tmmcalc.cams.stages.parts import at_speed, cam_of
from tmmcalc.cams.task import CamTask

if TYPE_CHECKING:
    from tmmcalc.cams.room import CamTables


def inputs(spec: CamTables) -> CamTask:
    """The motion, masses, forces, spring, friction, guide."""
    return cam_of(spec, "asked", "limits", "loads", "guide")


def solve(given: CamTask, upstream: Mapping[str, Any], settings: Mapping[str, Any]) -> CamForces:
    """Everything that acts on the follower over the turn."""
    from tmmcalc.cams.forces.solve import solve_forces

    return solve_forces(at_speed(given, upstream.get("motion")), upstream["cam_synthesis"].follower)


def columns(result: CamForces) -> Mapping[str, Any]:
    """One row a position."""
    from tmmcalc.cams.forces.columns import force_columns

    return force_columns(result)
