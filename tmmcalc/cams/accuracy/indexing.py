"""Methods for the tip of an indexing cam, where one flank hands over: a table, bisection, a root on panels.

The tip is where the lobe meets its mirror image. Off a table of n parts of the step the change of sign is told by the
straight line between two rows, which is of second order. The reference is Newton's method in extended precision.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

import numpy as np

from tmmcalc.cams.indexing.flanks import Drive, Flank
from tmmcalc.cams.indexing.handover import tip
from tmmcalc.cams.indexing.results import Indexing
from tmmcalc.cams.indexing.solve import drive_of
from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.wide import wide
from tmmcalc.core.numerics.extended import WIDER
from tmmcalc.core.studies.measure import Way, relative, series
from tmmcalc.core.studies.sampled import of_positions
from tmmcalc.core.studies.scene import Scene
from tmmcalc.core.studies.study import Reference, Study

ROWS = (7, 13, 29, 61, 127, 251, 509, 1021)  # of the second half of the step; none of them within another
CHANCE = "of order 2 on the whole: how the root lies between two rows is chance"
HALVINGS = (8, 16, 24, 32, 40, 48)
NEWTON, APART = 4, 1e-5  # steps from the root of the stage, and of its difference


def studies(scene: Scene) -> Iterator[Study]:
    """k_m of the pitch curve, where a mechanism has a law at all."""
    found: Indexing = scene.results["indexing"]
    drive = drive_of(scene.inputs, found.ratio)
    if drive is None or found.cam is None or not WIDER or not found.cam.handover.part < 1:
        return
    exact = _exact(drive, found.cam.handover.part)

    def error(part: float) -> float:
        return relative(part, exact)

    def by_root() -> float:
        return tip(drive) or 1.0

    rows = [Way(f"{n} rows", 1 / n, partial(_tabled, drive, n)) for n in ROWS]
    halved = [Way(f"{n} halvings", 2.0**-n, partial(_halved, drive, n)) for n in HALVINGS]
    yield Study(
        "indexing",
        "tip of the lobe",
        Reference("Newton in extended precision (64-bit mantissa)", float(np.finfo(np.longdouble).eps)),
        (
            series("root on panels", [Way("", None, by_root)], error, scene.clock, note="the first of all that may be"),
            series("bisection", halved, error, scene.clock, expected=1.0, note="in the second half of the step"),
            of_positions("table of n rows", rows, error, scene.clock, CHANCE),
        ),
    )


def _before(drive: Drive, k: Values) -> Values:
    """How far the lobe is from its mirror image [rad]."""
    return Flank(drive, "A").polar(k) - drive.step * (k - 0.5)


def _exact(drive: Drive, part: float) -> np.longdouble:
    precise, k = wide(drive), np.array([part], np.longdouble)
    for _ in range(NEWTON):
        slope = (_before(precise, k + APART) - _before(precise, k - APART)) / (2 * np.longdouble(APART))
        k = k - _before(precise, k) / slope
    return np.longdouble(k[0])


def _tabled(drive: Drive, count: int) -> float:
    k = np.linspace(0.5, 1.0, count + 1)
    away = _before(drive, k)
    low = int(np.flatnonzero(np.signbit(away[1:]) != np.signbit(away[:-1]))[0])
    return float(k[low] + (k[low + 1] - k[low]) * away[low] / (away[low] - away[low + 1]))


def _halved(drive: Drive, halvings: int) -> float:
    low, high = 0.5, 1.0
    start = np.signbit(_before(drive, np.array([low])))[0]
    for _ in range(halvings):
        middle = (low + high) / 2
        same = np.signbit(_before(drive, np.array([middle])))[0] == start
        low, high = (middle, high) if same else (low, middle)
    return (low + high) / 2
