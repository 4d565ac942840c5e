"""The Python API of mechanisms: structure, kinematics, forces, reduction, unsteady motion, synthesis; manipulators."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmmcalc.api import solved
from tmmcalc.linkage.kinematics import solve_kinematics as _kinematics
from tmmcalc.linkage.model import Mechanism
from tmmcalc.linkage.results import Kinematics, Method
from tmmcalc.linkage.structure import Structure
from tmmcalc.linkage.structure import solve_structure as _structure

if TYPE_CHECKING:
    from tmmcalc.linkage.forces.results import Forces
    from tmmcalc.linkage.listing import Listing
    from tmmcalc.linkage.loading import Loading
    from tmmcalc.linkage.paths.results import Paths
    from tmmcalc.linkage.synthesis.results import Synthesis as LinkSynthesis
    from tmmcalc.linkage.synthesis.task import SynthesisTask
    from tmmcalc.linkage.unsteady.results import Unsteady
    from tmmcalc.machine.reduction.results import Reduction
    from tmmcalc.manipulators.results import Manipulator
    from tmmcalc.project import Spec


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
    how = method or Method()
    return _kinematics(_mechanism(scene), None, how.name, how.step, how.decimals)


def solve_forces(scene: Spec | Mechanism, loading: Loading | None = None) -> Forces:
    """Reactions in all pairs and the drive; a plain `Mechanism` needs its ``loading`` beside it.

    Raises what `solve_kinematics` does, and `NoSolutionError` for self-locking.
    """
    from tmmcalc.linkage.forces.solve import solve_forces as _forces

    mechanism, given = _loaded(scene, loading)
    return _forces(mechanism, given, _kinematics(mechanism))


def solve_reduction(scene: Spec | Mechanism, loading: Loading | None = None) -> Reduction:
    """Reduced moments and inertia over the cycle, and the work of every load; of a spec also of its torque diagram.

    Raises what `solve_forces` does. ``result.cycle`` is what the functions of the machine room take.
    """
    if not isinstance(scene, Mechanism):
        return solved(scene, "reduction")
    from tmmcalc.machine.reduction.solve import solve_reduction as _reduction

    mechanism, given = _loaded(scene, loading)
    return _reduction(mechanism, given, _kinematics(mechanism))


def solve_paths(spec: Spec) -> Paths:
    """How far the paths of points are from the wanted ones of a spec.

    Raises what `solve_kinematics` does, and `UsageError` for a prescribed position outside of the analysed range.
    """
    return solved(spec, "paths")


def solve_unsteady(spec: Spec) -> Unsteady:
    """The motion from rest to rest of the mechanism of a spec, by the time-optimal law.

    Raises what `solve_kinematics` does, and `NoSolutionError` for ends or times that cannot be kept.
    """
    return solved(spec, "unsteady")


def solve_synthesis(scene: Spec | SynthesisTask) -> LinkSynthesis:
    """The linkages that a spec or a plain `SynthesisTask` asks for, best first; ``.best.spec`` is a ready spec.

    Raises `NoSolutionError` if there is none, `AccuracyError` if the simulation of one misses a target.
    """
    from tmmcalc.linkage.synthesis.task import SynthesisTask

    if not isinstance(scene, SynthesisTask):
        return solved(scene, "synthesis")
    from tmmcalc.linkage.synthesis.kinds import solve_synthesis as _synthesis

    return _synthesis(scene)


def solve_manipulator(spec: Spec) -> Manipulator:
    """Gripper and joints of the manipulator of a spec over the time, by the inverse or the direct problem.

    Raises `NoSolutionError` for a path out of reach, `SingularityError` where the joints' rates are not defined.
    """
    return solved(spec, "manipulator")


def _loaded(scene: Spec | Mechanism, loading: Loading | None) -> tuple[Mechanism, Loading]:
    from tmmcalc.linkage.loading import Loading

    if isinstance(scene, Mechanism):
        return scene, loading or Loading()
    from tmmcalc.linkage.tables.tasks.loading import to_loading

    return _mechanism(scene), loading or to_loading(scene)


def _mechanism(scene: Spec | Mechanism) -> Mechanism:
    if isinstance(scene, Mechanism):
        return scene
    from tmmcalc.linkage.tables.tasks.mechanism import to_linkage

    return to_linkage(scene.linkage)
