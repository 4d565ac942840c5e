"""The indexing stage: limits, lambda, profiles, pressure angles, roller and efficiency of an indexing drive."""

from __future__ import annotations

from dataclasses import replace
from math import degrees

import numpy as np

from tmmcalc.cams.indexing.bounds import bounds, start_angle, start_pressure
from tmmcalc.cams.indexing.choice import WHERE, choose_ratio, choose_roller
from tmmcalc.cams.indexing.efficiency import efficiency_table
from tmmcalc.cams.indexing.errors import indexing_errors
from tmmcalc.cams.indexing.flanks import Drive, Flank, FlankName, on_panels
from tmmcalc.cams.indexing.handover import Handover, crossing, handover, working_tip
from tmmcalc.cams.indexing.laws import StepLaw
from tmmcalc.cams.indexing.results import Cam, FlankTable, Indexing, PressureReached, SecondCam
from tmmcalc.cams.indexing.rollers import RollerLimit, roller_limits
from tmmcalc.cams.indexing.second import second_cam
from tmmcalc.cams.indexing.task import IndexingTask
from tmmcalc.cams.indexing.verdicts import remarks
from tmmcalc.cams.laws.law import Values
from tmmcalc.core.errors import NoSolutionError


def solve_indexing(task: IndexingTask) -> Indexing:
    """An indexing drive at the rows of the task, with its limits exact to rounding.

    Raises `NoSolutionError` where lambda is below its least, no lambda lies between the limits, the lobe ends before
    the step does, the groove crosses itself, or the roller is too large.
    """
    law = task.law
    ratio, how = choose_ratio(task)
    k = np.linspace(0.0, 1.0, task.rows + 1)
    found = Indexing(
        rollers=task.rollers,
        step=task.step,
        wheel=task.wheel,
        ratio=ratio,
        ratio_how=how,
        roller=task.roller,
        roller_how="given" if task.roller is not None else "none: the law is known by its B alone",
        limit=task.limit,
        frictions=(task.friction, task.pin_friction),
        law=law.name,
        peak=law.peak,
        bounds=bounds(law.peak, task.rollers, task.step, task.limit, ratio),
        base=task.wheel * float(np.abs(ratio - np.exp(1j * np.pi / task.rollers))),
        start_angle=start_angle(task.rollers, ratio),
        start_pressure=start_pressure(task.rollers, ratio),
        k=k if law.law is not None else np.empty(0),
        motion=np.empty((4, 0)),
        cam=None,
        notes=(),
        error={},
        dwells=task.dwells,
    )
    drive = drive_of(task, ratio)
    if drive is not None:
        end = _checked(drive, law)
        limits = roller_limits(drive, end.part, task.shaft)
        roller, how = choose_roller(task, limits)
        cam = _cam(task, drive, end, limits, roller)
        error = indexing_errors(drive, k, cam, roller, found.frictions)
        motion = Flank(drive, "A").motion(k)
        found = replace(found, roller=roller, roller_how=how, motion=motion, cam=cam, error=error)
        found = replace(found, second=_second(task, drive, end, limits, roller))
    return replace(found, notes=tuple(remarks(found)))


def _second(
    task: IndexingTask, drive: Drive, end: Handover, limits: tuple[RollerLimit, ...], roller: float
) -> SecondCam | None:
    """The cam of the second row if it differs; raises `NoSolutionError` for rollers that are too large."""
    own = roller if task.second_roller is None else task.second_roller
    if task.dwells is None and own == roller:
        return None
    if own != roller:
        choose_roller(replace(task, roller=own), limits)
    return second_cam(drive, end.part, own, task.rests, own == roller)


def drive_of(task: IndexingTask, ratio: float) -> Drive | None:
    """The geometry at this lambda; None if the law is known by its B alone."""
    if task.law.law is None:
        return None
    return Drive(task.law.law, task.rollers, task.step, ratio * task.wheel, task.wheel)


def _checked(drive: Drive, law: StepLaw) -> Handover:
    """The tip of the lobe of a drive that exists."""
    end = handover(drive)
    if end is None:
        raise NoSolutionError(
            f"with z2 = {drive.rollers} and lambda = {drive.ratio:.6g} the lobe is cut off before its step is over, "
            "its flanks do not meet",
            where=WHERE,
            value=float(drive.rollers),
            remedy="fewer rollers, a larger step_angle, or a larger centre_distance",
        )
    at = crossing(drive)
    if at is not None:
        raise NoSolutionError(
            f"the groove crosses itself at k = {1 - at:.6g} and {at:.6g} with the law {law.name!r}",
            where=WHERE,
            value=at,
            limit=0.5,
            remedy=f"a larger centre_distance, or a step_angle above {degrees(drive.step):.6g} deg",
        )
    return end


def _cam(task: IndexingTask, drive: Drive, end: Handover, limits: tuple[RollerLimit, ...], roller: float) -> Cam:
    k = np.linspace(0.0, 1.0, task.rows + 1)
    front, groove = Flank(drive, "A"), Flank(drive, "B")
    part = working_tip(drive, roller, end.part)
    at, middle = np.array([part]), np.array([0.5])
    w = 1 + float(groove.motion(middle)[1, 0])
    return Cam(
        a=flank_table(front, k, roller),
        b=flank_table(groove, k, roller),
        handover=end,
        working_part=part,
        working_tip=float(np.abs(front.points(at, roller))[0]),
        working_angle=float(groove.pressure(at)[0]),
        nearest=drive.centres - drive.wheel - roller,
        bottom=drive.wheel * max(drive.ratio - w, 0.0) ** 2 / (drive.ratio - w * w),
        roller_limits=limits,
        run_up=_reached(drive, "A", 0.0, end.part, task.limit),
        run_out=_reached(drive, "B", end.part, 1.0, task.limit),
        efficiency=efficiency_table(drive, k, end.part, task.friction, task.pin_friction),
    )


def flank_table(flank: Flank, k: Values, roller: float) -> FlankTable:
    """A flank with a roller of radius r_r [m] at parts k (n,) of the step."""
    here = flank.frame(k)
    return FlankTable(
        name=flank.name,
        theta=flank.theta(k),
        polar=flank.polar(k) - flank.drive.step * k,
        pressure=flank.pressure(k),
        source=flank.source_pressure(k),
        curvature=here.bend,
        pitch=flank.roller(k) * np.exp(-1j * flank.drive.step * k),
        working=flank.follower.placed(here.offset(roller)),
    )


def _reached(drive: Drive, name: FlankName, low: float, high: float, limit: float) -> PressureReached:
    """The largest pressure angle of a flank between two parts of the step, by the formula at its turning points.

    The limits of a panel at its ends are extrapolated, which makes rounding several times as large.
    """
    flank = Flank(drive, name)
    on, values = on_panels(flank.pressure, drive, low, high)
    at, _ = on.turning(values)
    size = np.abs(flank.pressure(at))
    worst = int(np.flatnonzero(size >= np.max(size) * (1 - 1e-12))[-1])  # ends stand last, after a root beside them
    return PressureReached(name, float(size[worst]), float(at[worst]), limit)
