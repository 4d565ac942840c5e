"""The Python API of cams: laws, sizes, profiles, forces, strength, the lowest mechanism, indexing drives."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmmcalc.api import solved

if TYPE_CHECKING:
    from tmmcalc.cams.elastic import ElasticResult as CamElastic
    from tmmcalc.cams.forces.results import CamForces
    from tmmcalc.cams.indexing.results import Indexing
    from tmmcalc.cams.lawresult import LawResult as CamLaw
    from tmmcalc.cams.optimum.results import CamOptimum
    from tmmcalc.cams.pressure.solve import Pressure as CamPressure
    from tmmcalc.cams.profile.results import Profile as CamProfile
    from tmmcalc.cams.strength.results import CamStrength
    from tmmcalc.cams.synthesis.results import Synthesis as CamSynthesis
    from tmmcalc.machine.attached import Attached as CamLoad
    from tmmcalc.project import Spec


def solve_cam_law(spec: Spec) -> CamLaw:
    """The law of motion of the cam of a spec over its turn, its constants and jumps."""
    return solved(spec, "cam_law")


def solve_cam_synthesis(spec: Spec) -> CamSynthesis:
    """The sizes of the cam of a spec, given or found under its limits: ``.follower``."""
    return solved(spec, "cam_synthesis")


def solve_cam_load(spec: Spec) -> CamLoad:
    """What the cam of a spec asks of the shaft of the machine that drives it: inertia and moments over its angle."""
    return solved(spec, "cam_load")


def solve_cam_profile(spec: Spec) -> CamProfile:
    """Pitch and working profiles of the cam of a spec, its curvature, the largest roller."""
    return solved(spec, "cam_profile")


def solve_cam_pressure(spec: Spec) -> CamPressure:
    """The pressure angle of the cam of a spec over its turn."""
    return solved(spec, "cam_pressure")


def solve_cam_forces(spec: Spec) -> CamForces:
    """Spring, reactions, friction and torque of the cam of a spec."""
    return solved(spec, "cam_forces")


def solve_cam_strength(spec: Spec) -> CamStrength:
    """Slip, shaft, stem, pin and contact stress of the cam of a spec, each with its margin."""
    return solved(spec, "cam_strength")


def solve_cam_elastic(spec: Spec) -> CamElastic:
    """Vibration of the follower on the elastic train of the cam of a spec, after its phases and over the turn."""
    return solved(spec, "cam_elastic")


def solve_cam_optimum(spec: Spec) -> CamOptimum:
    """The lowest mechanism for the cam of a spec, its blocking contour and active constraints."""
    return solved(spec, "cam_optimum")


def solve_indexing(spec: Spec) -> Indexing:
    """The cam-lantern indexing drive of a spec: limits, profiles, pressure angles, efficiency."""
    return solved(spec, "indexing")
