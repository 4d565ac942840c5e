"""Profiles of indexing cams as the bytes of files: outlines for SVG and DXF, a table of points for a machine tool."""

from __future__ import annotations

import csv
from io import StringIO

import numpy as np

from tmmcalc.cams.files.machinetool import HEAD, point_texts
from tmmcalc.cams.indexing.outline import Stretch, outline, stretches
from tmmcalc.cams.indexing.results import Cam, Indexing
from tmmcalc.cams.indexing.solve import drive_of
from tmmcalc.cams.indexing.task import IndexingTask
from tmmcalc.core.errors import UsageError
from tmmcalc.core.numerics.curves import knots
from tmmcalc.report.outlinefiles import circle
from tmmcalc.report.outlines import Outline

FINEST = 1e-9  # of R0: a finer tolerance would take millions of points


def chain_of(
    task: IndexingTask, result: Indexing, working: bool = True, *, of_second: bool = False
) -> tuple[Stretch, ...]:
    """The working profile, or the pitch curve, of the first or of the second cam, each in axes from its own lobe.

    Raises `UsageError` for a law that is known by its B alone.
    """
    cam, drive, roller, end = _cam(result), drive_of(task, result.ratio), result.roller, _cam(result).working_part
    assert drive is not None
    rests, second = task.dwells, result.second
    if of_second and second is not None:
        roller, end = second.roller, second.working_part
        rests = None if rests is None else (rests[1], rests[0])
    if not working or roller is None:
        return stretches(drive, 0.0, cam.handover.part, rests)
    return stretches(drive, roller, end, rests)


def outlines(task: IndexingTask, result: Indexing) -> tuple[Outline, ...]:
    """Pitch curve and working profile, each on a layer of its own, with the base circle of the pitch curve and O1.

    A second cam that is not equal to the first has layers of its own, in axes from its own lobe.
    """
    check_tolerance(task, result)
    names = {"pitch curve": (False, False), "working profile": (True, False)}
    if result.second is not None:
        names |= {"pitch curve 2": (False, True), "working profile 2": (True, True)}
    chain = [
        outline(name, chain_of(task, result, working, of_second=second), task.tolerance)
        for name, (working, second) in names.items()
    ]
    circles = [circle("base circle", result.base), *([circle("shaft", task.shaft)] if task.shaft else [])]
    return (*chain, *circles)


def nc_table(task: IndexingTask, result: Indexing) -> bytes:
    """phi, X, Y, radius and polar angle of the working profile with the normal out of the cam; mm and deg.

    Rows run clockwise, as the rollers do in the axes of the cam; chords between them keep the tolerance. At the tip of
    the lobe the point stands twice, with either normal. Of two cams that differ the first column tells which. Raises as
    `chain_of`, and for a tolerance that is too fine.
    """
    check_tolerance(task, result)
    buffer = StringIO()
    writer = csv.writer(buffer, lineterminator="\n")
    several = result.second is not None
    writer.writerow([*(["cam"] if several else []), "part", *HEAD])
    for cam in (1, 2) if several else (1,):
        for stretch in chain_of(task, result, of_second=cam == 2):
            t = knots(stretch.curve, task.tolerance)
            points, normal = stretch.curve.point(t), stretch.normal(t)
            columns = point_texts(stretch.angle(t), points, np.angle(points), normal, task.tolerance)
            head = [cam, stretch.name] if several else [stretch.name]
            writer.writerows([*head, *row] for row in zip(*columns, strict=True))
    return buffer.getvalue().encode()


def check_tolerance(task: IndexingTask, result: Indexing) -> None:
    """Raise `UsageError` for a tolerance that nobody could use."""
    least = FINEST * result.base
    if not task.tolerance >= least:
        raise UsageError(
            f"a chord tolerance of {task.tolerance:g} m is too fine for a base circle of {result.base:g} m",
            where="cam indexing",
            value=task.tolerance,
            limit=least,
            remedy=f"at least {least:.1g} m; the coordinates themselves are exact to rounding",
        )


def _cam(result: Indexing) -> Cam:
    if result.cam is not None:
        return result.cam
    raise UsageError(
        "a law that is known by its B alone gives no profile",
        where="cam indexing",
        remedy="name a law of the catalogue",
    )
