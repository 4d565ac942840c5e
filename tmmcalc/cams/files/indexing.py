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


def chain_of(task: IndexingTask, result: Indexing, working: bool = True) -> tuple[Stretch, ...]:
    """The working profile, or the pitch curve; raises `UsageError` for a law that is known by its B alone."""
    cam, drive, roller = _cam(result), drive_of(task, result.ratio), result.roller
    assert drive is not None
    if not working or roller is None:
        return stretches(drive, 0.0, cam.handover.part)
    return stretches(drive, roller, cam.working_part)


def outlines(task: IndexingTask, result: Indexing) -> tuple[Outline, ...]:
    """Pitch curve and working profile, each on a layer of its own, with the base circle of the pitch curve and O1."""
    check_tolerance(task, result)
    names = {"pitch curve": False, "working profile": True}
    chain = [outline(name, chain_of(task, result, working), task.tolerance) for name, working in names.items()]
    circles = [circle("base circle", result.base), *([circle("shaft", task.shaft)] if task.shaft else [])]
    return (*chain, *circles)


def nc_table(task: IndexingTask, result: Indexing) -> bytes:
    """phi, X, Y, radius and polar angle of the working profile with the normal out of the cam; mm and deg.

    Rows run clockwise, as the rollers do in the axes of the cam; chords between them keep the tolerance. At the tip of
    the lobe the point stands twice, with either normal. Raises as `chain_of`, and for a tolerance that is too fine.
    """
    check_tolerance(task, result)
    buffer = StringIO()
    writer = csv.writer(buffer, lineterminator="\n")
    writer.writerow(["part", *HEAD])
    for stretch in chain_of(task, result):
        t = knots(stretch.curve, task.tolerance)
        points, normal = stretch.curve.point(t), stretch.normal(t)
        columns = point_texts(stretch.angle(t), points, np.angle(points), normal, task.tolerance)
        writer.writerows([stretch.name, *row] for row in zip(*columns, strict=True))
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
