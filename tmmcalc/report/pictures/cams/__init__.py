"""Pictures of the cam stages, for people; as those of `tmmcalc.report.pictures` in all that concerns files."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from tmmcalc.report.pictures import check_matplotlib, form_of

if TYPE_CHECKING:
    from tmmcalc.cams.elastic import ElasticResult
    from tmmcalc.cams.forces.results import CamForces
    from tmmcalc.cams.lawresult import LawResult
    from tmmcalc.cams.optimum.results import CamOptimum
    from tmmcalc.cams.pressure import Pressure
    from tmmcalc.cams.profile.results import Profile
    from tmmcalc.cams.strength.results import CamStrength
    from tmmcalc.cams.synthesis.results import Synthesis
    from tmmcalc.cams.task import CamTask


def draw_cam_synthesis(task: CamTask, result: Synthesis, file: Path) -> None:
    """Draw the admissible places of the cam's axis, by S'(dS) or the positions of the rocker; of a flat face F(phi)."""
    form = form_of(file)
    check_matplotlib()
    from tmmcalc.report.pictures.cams.synthesis import synthesis_figure
    from tmmcalc.report.pictures.page import write

    write(file, form, lambda: synthesis_figure(task, result))


def draw_cam_pressure(task: CamTask, result: Pressure, file: Path) -> None:
    """Draw the pressure angle over the turn with its limits and extremes."""
    form = form_of(file)
    check_matplotlib()
    from tmmcalc.report.pictures.cams.pressure import pressure_figure
    from tmmcalc.report.pictures.page import write

    write(file, form, lambda: pressure_figure(task, result))


def draw_cam_law(task: CamTask, result: LawResult, file: Path) -> None:
    """Draw displacement and its derivatives over the turn with the points a, b, c, d, and the phase portrait S'(S)."""
    form = form_of(file)
    check_matplotlib()
    from tmmcalc.report.pictures.cams.law import law_figure
    from tmmcalc.report.pictures.page import write

    write(file, form, lambda: law_figure(task, result))


def draw_cam_profile(task: CamTask, result: Profile, file: Path) -> None:
    """Draw the cam to scale with its curves, circles and follower, and the curvature over the turn."""
    form = form_of(file)
    check_matplotlib()
    from tmmcalc.report.pictures.cams.profile import profile_figure
    from tmmcalc.report.pictures.page import write

    write(file, form, lambda: profile_figure(task, result))


def draw_cam_forces(task: CamTask, result: CamForces, file: Path) -> None:
    """Draw the lifting force with the spring's line over the lift; forces, reactions and torque over the turn."""
    form = form_of(file)
    check_matplotlib()
    from tmmcalc.report.pictures.cams.forces import forces_figure
    from tmmcalc.report.pictures.page import write

    write(file, form, lambda: forces_figure(task, result))


def draw_cam_strength(task: CamTask, result: CamStrength, file: Path) -> None:
    """Draw slip function, contact stress and reduced moment over the turn, with their limits."""
    form = form_of(file)
    check_matplotlib()
    from tmmcalc.report.pictures.cams.forces import strength_figure
    from tmmcalc.report.pictures.page import write

    write(file, form, lambda: strength_figure(task, result))


def draw_cam_optimum(task: CamTask, result: CamOptimum, file: Path) -> None:
    """Draw the blocking contours with their numbered curves, N1 and sigma_H over r2; of a flat face the chart of H2."""
    form = form_of(file)
    check_matplotlib()
    from tmmcalc.report.pictures.cams.optimum import optimum_figure
    from tmmcalc.report.pictures.page import write

    write(file, form, lambda: optimum_figure(task, result))


def draw_cam_elastic(task: CamTask, result: ElasticResult, file: Path) -> None:
    """Draw the accelerations of cam and mass over the turn, the load on the cam, and the spectra of the laws."""
    form = form_of(file)
    check_matplotlib()
    from tmmcalc.report.pictures.cams.elastic import elastic_figure
    from tmmcalc.report.pictures.page import write

    write(file, form, lambda: elastic_figure(task, result))
