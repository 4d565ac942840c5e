"""Pictures of the cam stages, for people; as those of `tmmcalc.report.drawing` in all that concerns files."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

from tmmcalc.report.drawing import check_matplotlib, form_of

if TYPE_CHECKING:
    from tmmcalc.cams.indexing import Indexing
    from tmmcalc.cams.indexing.task import IndexingTask
    from tmmcalc.cams.task import CamTask

FIGURES = {  # stage -> "module:function", called as function(task, result)
    "cam_law": "law:law_figure",  # displacement and its derivatives over the turn, the phase portrait S'(S)
    "cam_synthesis": "synthesis:synthesis_figure",  # the admissible places of the cam's axis
    "cam_profile": "profile:profile_figure",  # the cam to scale with its follower, the curvature over the turn
    "cam_pressure": "pressure:pressure_figure",  # the pressure angle over the turn with its limits
    "cam_forces": "forces:forces_figure",  # lifting force and spring over the lift, reactions, torque
    "cam_strength": "strength:strength_figure",  # slip, contact stress and reduced moment with their limits
    "cam_optimum": "optimum:optimum_figure",  # the blocking contour with all curves, load and stress over the roller
    "cam_elastic": "elastic:elastic_figure",  # residual vibration of the laws, motion of the mass over the turn
}


def draw_indexing(task: IndexingTask, result: Indexing, file: Path, phase: float = 0.0) -> None:
    """Draw an indexing drive: its scheme where the cams have turned by ``phase`` [rad], profiles, diagrams."""
    form = form_of(file)
    check_matplotlib()
    from tmmcalc.cams.pictures.indexing import indexing_figure
    from tmmcalc.report.drawing.page import write

    write(file, form, lambda: indexing_figure(task, result, phase))


def draw_cam(stage: str, task: CamTask, result: Any, file: Path) -> None:
    """Draw the result of a cam stage."""
    form = form_of(file)
    check_matplotlib()
    from tmmcalc.core.stage import resolve
    from tmmcalc.report.drawing.page import write

    figure = resolve(f"{__name__}.{FIGURES[stage]}")
    write(file, form, lambda: figure(task, result))
