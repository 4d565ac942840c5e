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
    from tmmcalc.cams.elastic import ElasticResult as CamElastic
    from tmmcalc.cams.forces.results import CamForces
    from tmmcalc.cams.indexing.results import Indexing
    from tmmcalc.cams.lawresult import LawResult as CamLaw
    from tmmcalc.cams.optimum.results import CamOptimum
    from tmmcalc.cams.pressure import Pressure as CamPressure
    from tmmcalc.cams.profile.results import Profile as CamProfile
    from tmmcalc.cams.strength.results import CamStrength
    from tmmcalc.cams.synthesis.results import Synthesis as CamSynthesis
    from tmmcalc.extras.bearing import Bearing, BearingTask
    from tmmcalc.extras.contact import Contact, ContactTask
    from tmmcalc.extras.falling_ball import Ball, BallTask
    from tmmcalc.extras.reliability import Reliability, ReliabilityTask
    from tmmcalc.extras.tie_down import TieDown, TieDownTask
    from tmmcalc.feasibility.judge import Feasibility
    from tmmcalc.gears.gearing import Gearing
    from tmmcalc.gears.meshing.contours import Blocking
    from tmmcalc.gears.meshing.profiles import Profiles
    from tmmcalc.gears.meshing.results import Pairs
    from tmmcalc.gears.selection.results import Selection
    from tmmcalc.gears.sizing import Sizing
    from tmmcalc.gears.train import Trains
    from tmmcalc.linkage.forces.results import Forces
    from tmmcalc.linkage.listing import Listing
    from tmmcalc.linkage.loading import Loading
    from tmmcalc.linkage.reduction.results import Reduction
    from tmmcalc.linkage.synthesis.results import Synthesis as LinkSynthesis
    from tmmcalc.linkage.synthesis.task import SynthesisTask
    from tmmcalc.linkage.unsteady.results import Unsteady
    from tmmcalc.machine.flywheel.task import Flywheel
    from tmmcalc.machine.motion import Motion
    from tmmcalc.machine.power import Power
    from tmmcalc.machine.transient.timed import TimedMotions
    from tmmcalc.machine.vibration.pendulum.results import PendulumResult
    from tmmcalc.machine.vibration.pendulum.task import PendulumTask
    from tmmcalc.machine.vibration.vibrator.results import VibratorResult
    from tmmcalc.machine.vibration.vibrator.task import VibratorTask
    from tmmcalc.manipulators.results import Manipulator
    from tmmcalc.pipeline.outcome import Event, RunResult
    from tmmcalc.spec import Spec
    from tmmcalc.stages.balance import Balances


def solve_structure(scene: Spec | Mechanism) -> Structure:
    """Mobility, Assur groups and order of assembly of a spec or of a `Mechanism`.

    Raises `StructureError` with the reason if the mobility is not 1.
    """
    return _structure(_mechanism(scene))


def list_assemblies(scene: Spec | Mechanism) -> Listing:
    """All assemblies of every group where the spec chooses one: at assembly.at, or at position 0.

    Raises `StructureError`; `NoSolutionError` if nothing gives the input coordinate.
    """
    from tmmcalc.linkage.listing import list_assemblies as _assemblies

    return _assemblies(_mechanism(scene))


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


def solve_unsteady(spec: Spec) -> Unsteady:
    """The motion from rest to rest of the mechanism of a spec, by the time-optimal law.

    Raises what `solve_kinematics` does, and `NoSolutionError` for ends or times that cannot be kept.
    """
    return _solved(spec, "unsteady")


def solve_manipulator(spec: Spec) -> Manipulator:
    """Gripper and joints of the manipulator of a spec over the time, by the inverse or the direct problem.

    Raises `NoSolutionError` for a path out of reach, `SingularityError` where the joints' rates are not defined.
    """
    return _solved(spec, "manipulator")


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


def solve_indexing(spec: Spec) -> Indexing:
    """The cam-lantern indexing drive of a spec: limits, profiles, pressure angles, efficiency."""
    return _solved(spec, "indexing")


def solve_cam_elastic(spec: Spec) -> CamElastic:
    """Vibration of the follower on the elastic train of the cam of a spec, after its phases and over the turn."""
    return _solved(spec, "cam_elastic")


def solve_cam_optimum(spec: Spec) -> CamOptimum:
    """The lowest mechanism for the cam of a spec, its blocking contour and active constraints."""
    return _solved(spec, "cam_optimum")


def solve_vibrator(scene: Spec | VibratorTask) -> VibratorResult:
    """Springs, modes, steady vibration and starts of the vibratory device of a spec, or of a plain `VibratorTask`.

    Raises `NoSolutionError` if mass or stiffness is not positive definite, `SingularityError` at resonance without
    damping.
    """
    from tmmcalc.machine.vibration.vibrator.task import VibratorTask

    if not isinstance(scene, VibratorTask):
        return _solved(scene, "vibrator")
    from tmmcalc.machine.vibration.vibrator.solve import solve_vibrator as _vibrator

    return _vibrator(scene)


def solve_pendulum(scene: Spec | PendulumTask) -> PendulumResult:
    """Whirl, critical speeds, torsion and motion of the pendulum-rotor of a spec, or of a plain `PendulumTask`.

    Raises `NoSolutionError` where nothing holds the rod, `SingularityError` for an unbalance at a critical speed.
    """
    from tmmcalc.machine.vibration.pendulum.task import PendulumTask

    if not isinstance(scene, PendulumTask):
        return _solved(scene, "pendulum")
    from tmmcalc.machine.vibration.pendulum.solve import solve_pendulum as _pendulum

    return _pendulum(scene)


def solve_synthesis(scene: Spec | SynthesisTask) -> LinkSynthesis:
    """The linkages that a spec or a plain `SynthesisTask` asks for, best first; ``.best.spec`` is a ready spec.

    Raises `NoSolutionError` if there is none, `AccuracyError` if the simulation of one misses a target.
    """
    from tmmcalc.linkage.synthesis.task import SynthesisTask

    if not isinstance(scene, SynthesisTask):
        return _solved(scene, "synthesis")
    from tmmcalc.linkage.synthesis.kinds import solve_synthesis as _synthesis

    return _synthesis(scene)


def solve_contact(scene: Spec | ContactTask) -> Contact:
    """Pressure and approach of the two bodies of a spec or of a plain `ContactTask`, with Hertz as check.

    Raises `NoSolutionError` for a grid that is too coarse, `UsageError` for a gap without a value.
    """
    from tmmcalc.extras.contact import ContactTask
    from tmmcalc.extras.contact import solve_contact as _solve

    return _solve(scene) if isinstance(scene, ContactTask) else _solved(scene, "contact")


def solve_reliability(scene: Spec | ReliabilityTask) -> Reliability:
    """Reliability and life of the product of a spec or of a plain `ReliabilityTask`.

    Raises `NoSolutionError` if no decay of the strength gives the mean life of a test.
    """
    from tmmcalc.extras.reliability import ReliabilityTask
    from tmmcalc.extras.reliability import solve_reliability as _solve

    return _solve(scene) if isinstance(scene, ReliabilityTask) else _solved(scene, "reliability")


def solve_tie_down(scene: Spec | TieDownTask) -> TieDown:
    """Forces in the ties of the load of a spec or of a plain `TieDownTask`.

    Raises `NoSolutionError` for a load that leaves its cradle.
    """
    from tmmcalc.extras.tie_down import TieDownTask
    from tmmcalc.extras.tie_down import solve_tie_down as _solve

    return _solve(scene) if isinstance(scene, TieDownTask) else _solved(scene, "tie_down")


def solve_falling_ball(scene: Spec | BallTask) -> Ball:
    """Speed and way of the ball of a spec or of a plain `BallTask`, its maximum and its stop."""
    from tmmcalc.extras.falling_ball import BallTask
    from tmmcalc.extras.falling_ball import solve_falling_ball as _solve

    return _solve(scene) if isinstance(scene, BallTask) else _solved(scene, "falling_ball")


def solve_bearing(scene: Spec | BearingTask) -> Bearing:
    """Speeds and frequencies of the defects of the bearing of a spec or of a plain `BearingTask`."""
    from tmmcalc.extras.bearing import BearingTask
    from tmmcalc.extras.bearing import solve_bearing as _solve

    return _solve(scene) if isinstance(scene, BearingTask) else _solved(scene, "bearing")


def solve_feasibility(spec: Spec) -> Feasibility:
    """Whether the results of a spec keep its constraints; of a synthesis all designs, ``.chosen`` the best of them.

    Raises `UsageError` for a quantity that a stage does not tell, and what the stages that it asks about raise.
    """
    return _solved(spec, "feasibility")


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
