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
    from tmmcalc.pipeline.outcome import Event, RunResult
    from tmmcalc.spec import Spec


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


def _mechanism(scene: Spec | Mechanism) -> Mechanism:
    if isinstance(scene, Mechanism):
        return scene
    from tmmcalc.spec.linkage import to_linkage

    return to_linkage(scene.linkage)
