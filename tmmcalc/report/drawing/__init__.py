"""Pictures of results, for people. matplotlib is needed only here, and only when a picture is drawn.

The format follows the suffix of the file: svg, png or pdf. Equal inputs give equal bytes; the file is written in one
step, and left alone if it has these bytes already. Every function raises `UsageError` for another suffix, a position
that the result does not have, a missing matplotlib, or a file that cannot be written.
"""

from __future__ import annotations

from collections.abc import Sequence
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING

from tmmcalc.core.errors import UsageError
from tmmcalc.core.plane import Real
from tmmcalc.linkage.forces.results import Forces
from tmmcalc.linkage.loading import Loading
from tmmcalc.linkage.model import Mechanism
from tmmcalc.linkage.results import Kinematics
from tmmcalc.machine.flywheel.task import Flywheel
from tmmcalc.machine.motion import Motion
from tmmcalc.machine.power import Power
from tmmcalc.machine.reduction.results import Reduction
from tmmcalc.machine.transient.timed import TimedMotions

if TYPE_CHECKING:
    from tmmcalc.core.studies.study import Accuracy
    from tmmcalc.gears.meshing.contours import Blocking
    from tmmcalc.gears.meshing.results import Pairs
    from tmmcalc.gears.selection.results import Selection
    from tmmcalc.gears.train import Trains
    from tmmcalc.linkage.unsteady.results import Unsteady
    from tmmcalc.linkage.unsteady.task import UnsteadyTask
    from tmmcalc.machine.stages.balance import Balances
    from tmmcalc.manipulators.results import Manipulator
    from tmmcalc.manipulators.task import ManipulatorTask
    from tmmcalc.stress.results import Stress

FORMATS = ("svg", "png", "pdf")


def draw_kinematics(
    mechanism: Mechanism,
    result: Kinematics,
    file: Path,
    *,
    positions: Sequence[int] | None = None,
    polygons: int | None = None,
) -> None:
    """Draw the scheme in its positions, the diagrams of the outputs, and the vector polygons of one position.

    ``positions`` are indices of positions to draw, the first with main lines, the others thin; by default the
    middle of the working stroke (or else a quarter of the way) among up to 24. ``polygons`` is the index of the
    position whose polygons stand on a second sheet below.
    """
    form = form_of(file)
    _check_positions(len(result.x), [*(positions or ()), *([] if polygons is None else [polygons])])
    check_matplotlib()
    from tmmcalc.linkage.pictures.kinematics import kinematics_figure
    from tmmcalc.report.drawing.page import write

    write(file, form, lambda: kinematics_figure(mechanism, result, positions, polygons))


def draw_forces(
    mechanism: Mechanism,
    loading: Loading,
    kinematics: Kinematics,
    result: Forces,
    file: Path,
    *,
    polygons: int | None = None,
) -> None:
    """Draw the reactions over the cycle, hodographs of bearing and crank pin, moment and power of the drive.

    ``polygons`` is the index of the row whose load diagrams and force polygons stand on the sheets below.
    """
    form = form_of(file)
    _check_positions(len(result.labels), [] if polygons is None else [polygons])
    check_matplotlib()
    from tmmcalc.linkage.pictures.forces import forces_figure
    from tmmcalc.report.drawing.page import write

    write(file, form, lambda: forces_figure(mechanism, loading, kinematics, result, polygons))


def draw_reduction(result: Reduction, file: Path) -> None:
    """Draw the reduced moments, each and their sum, the reduced inertia and its derivative over the cycle."""
    form = form_of(file)
    check_matplotlib()
    from tmmcalc.machine.pictures.reduction import reduction_figure
    from tmmcalc.report.drawing.page import write

    write(file, form, lambda: reduction_figure(result))


def draw_flywheel(result: Flywheel, phi: Real, file: Path) -> None:
    """Draw the energy-mass curve with its tangents, the work over the cycle, all methods, and the search.

    ``phi`` (n,) are the positions of the cycle, which tell the sense in which the input turns.
    """
    form = form_of(file)
    check_matplotlib()
    from tmmcalc.machine.pictures.flywheel import flywheel_figure
    from tmmcalc.report.drawing.page import write

    write(file, form, lambda: flywheel_figure(result, phi))


def draw_motion(result: Motion, power: Power, reduction: Reduction, file: Path) -> None:
    """Draw speed and moments over the cycle, loaded and idle, and the characteristic of the motor."""
    form = form_of(file)
    check_matplotlib()
    from tmmcalc.machine.pictures.motion import motion_figure
    from tmmcalc.report.drawing.page import write

    write(file, form, lambda: motion_figure(result, power, reduction.cycle))


def draw_transient(result: TimedMotions, file: Path) -> None:
    """Draw speeds and moments of every motion over the time, a sheet each, with its events."""
    form = form_of(file)
    check_matplotlib()
    from tmmcalc.machine.pictures.transient import transient_figure
    from tmmcalc.report.drawing.page import write

    write(file, form, lambda: transient_figure(result))


def draw_unsteady(
    mechanism: Mechanism, task: UnsteadyTask, kinematics: Kinematics, result: Unsteady, file: Path
) -> None:
    """Draw the input, the outputs and the links of an unsteady motion over the time."""
    form = form_of(file)
    check_matplotlib()
    from tmmcalc.linkage.pictures.unsteady import unsteady_figure
    from tmmcalc.report.drawing.page import write

    write(file, form, lambda: unsteady_figure(mechanism, task, kinematics, result))


def draw_manipulator(task: ManipulatorTask, result: Manipulator, file: Path) -> None:
    """Draw the path of a manipulator with points equally spaced in time, the arm, the obstacles, and the joints."""
    form = form_of(file)
    check_matplotlib()
    from tmmcalc.manipulators.pictures.manipulator import manipulator_figure
    from tmmcalc.report.drawing.page import write

    write(file, form, lambda: manipulator_figure(task, result))


def draw_balance(result: Balances, file: Path) -> None:
    """Draw hodographs of the shaking force and what the schemes leave of it; of an engine, force and couple.

    Raises `UsageError` for a rotor alone, which has no picture.
    """
    form = form_of(file)
    check_matplotlib()
    from tmmcalc.machine.pictures.balance import balance_figure
    from tmmcalc.report.drawing.page import write

    write(file, form, lambda: balance_figure(result))


def draw_train(result: Trains, file: Path, *, choose: int = 1) -> None:
    """Draw a tooth set of every variant to scale, all sets, what the constraints removed, curves of choice.

    ``choose`` is the number of the set in each variant, from 1. Raises `UsageError` if no variant has it.
    """
    form = form_of(file)
    check_matplotlib()
    from tmmcalc.gears.pictures.train import train_figure
    from tmmcalc.report.drawing.page import write

    write(file, form, lambda: train_figure(result, choose))


def draw_criteria(result: Selection, trains: Trains, file: Path, *, choose: int | None = None) -> None:
    """Draw the Pareto diagram, pairs of further criteria, and to scale the winner or another train.

    ``choose`` is a row of the stage's table, from 1. Raises `UsageError` for a row that there is not.
    """
    form = form_of(file)
    check_matplotlib()
    from tmmcalc.gears.pictures.criteria import criteria_figure
    from tmmcalc.report.drawing.page import write

    write(file, form, lambda: criteria_figure(result, trains, choose))


def draw_blocking(result: Blocking, file: Path, *, choose: int | None = None) -> None:
    """Draw the blocking contour of every external pair with its numbered lines, points and key, a sheet each.

    ``choose`` is one pair, from 1. Raises `UsageError` for a pair that there is not, and if none has a contour.
    """
    form = form_of(file)
    check_matplotlib()
    from tmmcalc.gears.pictures.contour import blocking_figure
    from tmmcalc.report.drawing.page import write

    write(file, form, lambda: blocking_figure(result, choose=choose))


def draw_pair(found: Pairs, file: Path, *, choose: int | None = None, phase: float = 0.0) -> None:
    """Draw the mesh of every pair to scale with its parameters, sliding and pressure under it: two sheets a pair.

    ``choose`` is one pair, from 1; the first wheel has turned clockwise by ``phase`` [rad] since the contact at P.
    Raises `UsageError` for a pair that there is not.
    """
    form = form_of(file)
    check_matplotlib()
    from tmmcalc.gears.pictures.pairsheet import pair_figure
    from tmmcalc.report.drawing.page import write

    write(file, form, lambda: pair_figure(found, choose=choose, phase=phase))


def draw_profile(found: Pairs, file: Path, *, choose: int | None = None) -> None:
    """Draw the generation and the enlarged tooth profile of every wheel, a sheet each.

    ``choose`` is one pair, from 1. Raises `UsageError` for a pair that there is not, `NoSolutionError` if no wheel has
    a profile.
    """
    form = form_of(file)
    check_matplotlib()
    from tmmcalc.gears.pictures.toothpicture import profile_figure
    from tmmcalc.report.drawing.page import write

    write(file, form, lambda: profile_figure(found, choose=choose))


def draw_accuracy(result: Accuracy, file: Path, heading: str, tolerance: float | None = None) -> None:
    """Draw the work-precision diagrams of all studies and ladders."""
    form = form_of(file)
    check_matplotlib()
    from tmmcalc.accuracy.picture import accuracy_figure
    from tmmcalc.report.drawing.page import write

    write(file, form, lambda: accuracy_figure(result, heading, tolerance))


def draw_stress(result: Stress, file: Path, heading: str) -> None:
    """Draw error over condition number for every ladder of a stress test."""
    form = form_of(file)
    check_matplotlib()
    from tmmcalc.report.drawing.page import write
    from tmmcalc.stress.picture import stress_figure

    write(file, form, lambda: stress_figure(result, heading))


def form_of(file: Path) -> str:
    """The format that the suffix names."""
    form = file.suffix.lower().removeprefix(".")
    if form not in FORMATS:
        raise UsageError(
            f"no picture format for the suffix {file.suffix!r} of {file.name}",
            where="plot",
            remedy=f"formats: {', '.join(FORMATS)}",
        )
    return form


def _check_positions(count: int, positions: Sequence[int]) -> None:
    for k in positions:
        if not 0 <= k < count:
            raise UsageError(f"there is no position {k}", where="plot", remedy=f"indices: 0 to {count - 1}")


def check_matplotlib() -> None:
    """Raise `UsageError` where matplotlib is not installed."""
    if find_spec("matplotlib") is None:
        raise UsageError('pictures need matplotlib: pip install "tmmcalc[plot]"')
