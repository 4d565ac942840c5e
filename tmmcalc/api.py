"""The Python API: one function a capability, on specs or on plain mechanisms."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from tmmcalc.linkage.kinematics import solve_kinematics as _kinematics
from tmmcalc.linkage.model import Mechanism
from tmmcalc.linkage.results import Kinematics, Method
from tmmcalc.linkage.structure import Structure
from tmmcalc.linkage.structure import solve_structure as _structure

if TYPE_CHECKING:
    from tmmcalc.cams.forces.results import CamForces
    from tmmcalc.cams.lawresult import LawResult as CamLaw
    from tmmcalc.cams.optimum.results import CamOptimum
    from tmmcalc.cams.pressure import Pressure as CamPressure
    from tmmcalc.cams.profile.results import Profile as CamProfile
    from tmmcalc.cams.strength.results import CamStrength
    from tmmcalc.cams.synthesis.results import Synthesis as CamSynthesis
    from tmmcalc.gears.gearing import Gearing
    from tmmcalc.gears.meshing.contours import Blocking
    from tmmcalc.gears.meshing.profiles import Profiles
    from tmmcalc.gears.meshing.results import Pairs
    from tmmcalc.gears.selection.results import Selection
    from tmmcalc.gears.sizing import Sizing
    from tmmcalc.gears.train import Trains
    from tmmcalc.linkage.forces.results import Forces
    from tmmcalc.linkage.loading import Loading
    from tmmcalc.linkage.reduction.results import Reduction
    from tmmcalc.machine.flywheel.task import Flywheel
    from tmmcalc.machine.motion import Motion
    from tmmcalc.machine.power import Power
    from tmmcalc.machine.transient.timed import TimedMotions
    from tmmcalc.pipeline.outcome import Event, RunResult
    from tmmcalc.spec import Spec
    from tmmcalc.stages.balance import Balances


def solve_structure(scene: Spec | Mechanism) -> Structure:
    """Mobility, Assur groups and order of assembly of a spec or of a `Mechanism`.

    Raises `StructureError` with the reason if the mobility is not 1.
    """
    return _structure(_mechanism(scene))


def solve_kinematics(scene: Spec | Mechanism, method: Method | None = None) -> Kinematics:
    """Positions, velocities, accelerations and transfer functions over the positions of the spec's grid.

    Raises `StructureError`, `AssemblyError`, `SingularityError` or `NoSolutionError`.
    """
    return _kinematics(_mechanism(scene), method=method)


def solve_forces(scene: Spec | Mechanism, loading: Loading | None = None) -> Forces:
    """Reactions in all pairs and the drive; a plain `Mechanism` needs its ``loading`` beside it.

    Raises what `solve_kinematics` does, and `NoSolutionError` for self-locking.
    """
    from tmmcalc.linkage.forces.forces import solve_forces as _forces

    mechanism, given = _loaded(scene, loading)
    return _forces(mechanism, given, _kinematics(mechanism))


def solve_reduction(scene: Spec | Mechanism, loading: Loading | None = None) -> Reduction:
    """Reduced moments and inertia over the cycle, and the work of every load; of a spec also of its torque diagram.

    Raises what `solve_forces` does. ``result.cycle`` is what the functions of the machine room take.
    """
    if not isinstance(scene, Mechanism):
        return _solved(scene, "reduction")
    from tmmcalc.linkage.reduction.reduce import solve_reduction as _reduction

    mechanism, given = _loaded(scene, loading)
    return _reduction(mechanism, given, _kinematics(mechanism))


def solve_power(spec: Spec) -> Power:
    """Work per cycle, efficiency, power, and the motor of a spec, given or chosen."""
    return _solved(spec, "power")


def solve_flywheel(spec: Spec) -> Flywheel:
    """The flywheel that keeps the unevenness of the spec, by all methods; raises `NoSolutionError` if none does."""
    return _solved(spec, "flywheel")


def solve_motion(spec: Spec) -> Motion:
    """Steady motion of the machine of a spec; raises `NoSolutionError` where it stalls or runs away."""
    return _solved(spec, "motion")


def solve_transients(spec: Spec) -> TimedMotions:
    """The motions in time that a spec asks for; raises `AccuracyError` where a method does not keep its tolerance."""
    return _solved(spec, "transient")


def solve_balance(spec: Spec) -> Balances:
    """Shaking forces of the linkage, the engine and the rotor of a spec, and what balancing leaves of them."""
    return _solved(spec, "balance")


def solve_train(spec: Spec) -> Trains:
    """All tooth sets of the gear trains of a spec; raises `NoSolutionError` with what stands in the way of any."""
    return _solved(spec, "train")


def solve_strength(spec: Spec) -> Sizing:
    """Modules and face widths of all tooth sets of a spec by the endurance of their teeth."""
    return _solved(spec, "strength")


def solve_criteria(spec: Spec) -> Selection:
    """Mass, inertia, size, efficiency of the gear trains of a spec, their Pareto front and the best of them."""
    return _solved(spec, "criteria")


def solve_gearing(spec: Spec) -> Gearing:
    """Speeds, torques, power flow and efficiency of the train that a spec writes as members and meshes."""
    return _solved(spec, "gearing")


def solve_pairs(spec: Spec) -> Pairs:
    """Geometry, checks and measures of the pairs of gears of a spec, written out or those of its train.

    Raises `NoSolutionError` for pairs that cannot work, with every reason and the nearest admissible shifts.
    """
    return _solved(spec, "pair")


def solve_blocking(spec: Spec) -> Blocking:
    """The blocking contours of the external pairs of a spec: all admissible shifts, and where the chosen ones stand."""
    return _solved(spec, "blocking")


def solve_profiles(spec: Spec) -> Profiles:
    """Half a tooth of every wheel of the pairs of a spec; lengths in metres."""
    return _solved(spec, "profile")


def solve_cam_law(spec: Spec) -> CamLaw:
    """The law of motion of the cam of a spec over its turn, its constants and jumps."""
    return _solved(spec, "cam_law")


def solve_cam_synthesis(spec: Spec) -> CamSynthesis:
    """The sizes of the cam of a spec, given or found under its limits: ``.follower``."""
    return _solved(spec, "cam_synthesis")


def solve_cam_profile(spec: Spec) -> CamProfile:
    """Pitch and working profiles of the cam of a spec, its curvature, the largest roller."""
    return _solved(spec, "cam_profile")


def solve_cam_pressure(spec: Spec) -> CamPressure:
    """The pressure angle of the cam of a spec over its turn."""
    return _solved(spec, "cam_pressure")


def solve_cam_forces(spec: Spec) -> CamForces:
    """Spring, reactions, friction and torque of the cam of a spec."""
    return _solved(spec, "cam_forces")


def solve_cam_strength(spec: Spec) -> CamStrength:
    """Slip, shaft, stem, pin and contact stress of the cam of a spec, each with its margin."""
    return _solved(spec, "cam_strength")


def solve_cam_optimum(spec: Spec) -> CamOptimum:
    """The lowest mechanism for the cam of a spec, its blocking contour and active constraints."""
    return _solved(spec, "cam_optimum")


def run(
    spec: Spec,
    *,
    target: str | None = None,
    out: str | Path | None = None,
    fresh: bool = False,
    from_stage: str | None = None,
    csv: bool | None = None,
    settings: Mapping[str, Mapping[str, Any]] | None = None,
    on_event: Callable[[Event], None] | None = None,
) -> RunResult:
    """Run the pipeline up to ``target`` (None: every stage that the spec has), with files in ``out`` if given.

    A stage whose stored inputs are unchanged is loaded; ``fresh`` recomputes all, ``from_stage`` that one
    and the following. ``csv`` None writes CSV files up to 2000 rows. ``settings`` are options of methods by stage.
    """
    from tmmcalc.pipeline.runner import run as _run

    folder = Path(out) if out is not None else None
    return _run(
        spec,
        target=target,
        out=folder,
        fresh=fresh,
        from_stage=from_stage,
        csv=csv,
        settings=settings,
        on_event=on_event,
    )


def _solved(spec: Spec, stage: str) -> Any:
    """The result of one stage; raises `UsageError` if the scene leaves it out."""
    return run(spec, target=stage).results[stage]


def _loaded(scene: Spec | Mechanism, loading: Loading | None) -> tuple[Mechanism, Loading]:
    from tmmcalc.linkage.loading import Loading

    if isinstance(scene, Mechanism):
        return scene, loading or Loading()
    from tmmcalc.spec.loading import to_loading

    return _mechanism(scene), loading or to_loading(scene)


def _mechanism(scene: Spec | Mechanism) -> Mechanism:
    if isinstance(scene, Mechanism):
        return scene
    from tmmcalc.spec.linkage import to_linkage

    return to_linkage(scene.linkage)
