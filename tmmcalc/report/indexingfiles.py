"""Profiles of indexing cams as the bytes of files: outlines for SVG and DXF, a table of points for a machine tool."""

from __future__ import annotations

import csv
import math
from io import StringIO

import numpy as np

from tmmcalc.cams.indexing.outline import Stretch, outline, stretches
from tmmcalc.cams.indexing.results import Cam, Indexing
from tmmcalc.cams.indexing.solve import drive_of
from tmmcalc.cams.indexing.task import IndexingTask
from tmmcalc.errors import UsageError
from tmmcalc.numerics.curves import Plane, knots
from tmmcalc.numerics.strokes import Bow, Outline
from tmmcalc.report.outlinefiles import MM

DEGREES = 6  # decimals of phi
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
    circles = [_circle("base circle", result.base), *([_circle("shaft", task.shaft)] if task.shaft else [])]
    return (*chain, *circles)


def _circle(name: str, radius: float) -> Outline:
    halves = tuple(Bow(0j, radius, start, math.pi) for start in (0.0, math.pi))
    polygon: Plane = radius * np.exp(0.5j * math.pi * np.arange(4))
    return Outline(name, name, halves, polygon, True)


def nc_table(task: IndexingTask, result: Indexing) -> bytes:
    """phi, X, Y, radius and polar angle of the working profile with the normal out of the cam; mm and deg.

    Rows run clockwise, as the rollers do in the axes of the cam; chords between them keep the tolerance. At the tip of
    the lobe the point stands twice, with either normal. Raises as `chain_of`, and for a tolerance that is too fine.
    """
    check_tolerance(task, result)
    places = max(0, math.ceil(-math.log10(task.tolerance * MM))) + 2
    buffer = StringIO()
    writer = csv.writer(buffer, lineterminator="\n")
    writer.writerow(["part", "phi[deg]", "X[mm]", "Y[mm]", "R[mm]", "alpha[deg]", "N_x", "N_y"])
    for stretch in chain_of(task, result):
        t = knots(stretch.curve, task.tolerance)
        points, normal = stretch.curve.point(t), stretch.normal(t)
        columns = (
            _texts(np.degrees(stretch.angle(t)), DEGREES),
            *(_texts(MM * values, places) for values in (points.real, points.imag, np.abs(points))),
            _texts(np.degrees(np.angle(points)), DEGREES),
            *(_texts(values, DEGREES + 2) for values in (normal.real, normal.imag)),
        )
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


def _texts(values: np.ndarray, places: int) -> list[str]:
    return [f"{value:.{places}f}" for value in (np.round(values, places) + 0.0).tolist()]
