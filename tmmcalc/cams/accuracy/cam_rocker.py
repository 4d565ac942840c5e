"""Methods for the least cam under a rocker: exact lines of the limits, those of n positions, a raster, the textbook's.

In the plane of the rocker the limits leave the cam's axis an intersection of half planes, a pair for every angle. On
the sheet their lines are drawn for n positions of each phase, and the nearest place within them is taken: by their
corners exactly, or off a raster. The textbook's closed form sets the axis for the middle of the swing alone. The
reference closes the lines that hold the place in extended precision; their angles are stationary, so that what these
are off counts by its square. The exchange names these lines; that it passes none over is told by many positions, whose
least cam is never larger than the true one.
"""

from __future__ import annotations

from functools import partial

import numpy as np

from tmmcalc.cams.pressure.angle import limited_phases
from tmmcalc.cams.synthesis import oscillatingsizes
from tmmcalc.cams.synthesis.bestplace import Best, best
from tmmcalc.cams.synthesis.halfplanes import Family, Lines, families
from tmmcalc.cams.synthesis.objectives import Distance
from tmmcalc.cams.synthesis.polygon import polygon
from tmmcalc.cams.synthesis.results import Synthesis
from tmmcalc.cams.task import CamTask
from tmmcalc.cams.wide import wide
from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.studies.measure import Clock, Way, relative, series
from tmmcalc.core.studies.sampled import of_positions
from tmmcalc.core.studies.study import Reference, Study

POSITIONS = (6, 12, 24, 48, 96, 192, 384)  # of a phase
GRIDS = (10, 20, 40, 80, 160)  # squares along a side of the raster
MANY = 1501  # positions of a phase of the reference
DRAWN = 48  # positions of a phase on the raster
WINDOW = 1.5  # of the raster, in least distances from the lowest roller centre
FAR = 100.0  # rocker lengths: half planes that close the region
ROLLER = 1.0 + 0j  # lowest roller centre in the plane of the rocker
RASTER = "a place within a square, anywhere; down to what the positions miss"
MIDDLE = "its axis stands square to the middle position of the rocker: near the least, and beside the limits"


def rocker(task: CamTask, found: Synthesis, clock: Clock) -> Study:
    """R0/l2 where the length of the rocker or the base circle is all that is given."""
    every = families(task)
    closed, asked = _exact(every, best(every, Distance(1.0))), _nearest(_sampled(task, every, MANY))
    exact = max(closed, np.longdouble(asked))

    def error(ratio: float) -> float:
        return relative(ratio, exact)

    def by_corners(count: int) -> float:
        return _nearest(_sampled(task, families(task), count))

    def by_raster(squares: int) -> float:
        return _raster(_sampled(task, families(task), DRAWN), WINDOW * float(exact), squares)

    ways = [Way(f"{n} positions", 1 / n, partial(by_corners, n)) for n in POSITIONS]
    squares = [Way(f"{n} squares", 1 / n, partial(by_raster, n)) for n in GRIDS]
    all_series = [
        series("exact lines of the limits", [Way("", None, lambda: _by_exchange(task))], error, clock),
        of_positions("lines of n positions", ways, error, clock),
        series(f"raster, {DRAWN} positions", squares, error, clock, note=RASTER, stepwise=False),
    ]
    if oscillatingsizes.textbook(task, 1.0) is not None:
        book = [Way("", None, lambda: _by_textbook(task))]
        all_series.append(series("textbook (5.50), (5.51)", book, error, clock, note=MIDDLE))
    name = f"the lines that the exchange finds, closed in extended precision; {MANY} positions a phase ask for no more"
    own = max(found.error["sizes"], float((exact - closed) / exact))
    return Study("cam_synthesis", "least base circle over the rocker", Reference(name, own), tuple(all_series))


def _by_exchange(task: CamTask) -> float:
    return abs(best(families(task), Distance(1.0)).point - ROLLER)


def _by_textbook(task: CamTask) -> float:
    found = oscillatingsizes.textbook(task, 1.0)
    assert found is not None
    return found.base


def _exact(every: tuple[Family, ...], found: Best) -> np.longdouble:
    """Distance of the corner, or of the foot on one line, in extended precision."""
    normals, bounds = [], []
    for phi, side, rough in zip(found.lines.phi, found.lines.side, found.lines.normal, strict=True):
        family = min(
            (each for each in every if each.side == side), key=lambda each: _apart(each, float(phi), complex(rough))
        )
        angle = wide(np.array([phi]))
        normal, bound = family.lines(family.program.wider.at(angle, family.program.piece(np.array([phi])))[:2])
        normals.append(normal[0])
        bounds.append(bound[0])
    if len(normals) == 1:
        return np.longdouble((normals[0].conj() * ROLLER).real - bounds[0])
    (a, b), (c, d) = normals[:2], bounds[:2]
    corner = 1j * (d * a - c * b) / (np.conj(a) * b).imag
    return np.longdouble(np.abs(corner - ROLLER))


def _apart(family: Family, phi: float, normal: complex) -> float:
    """How far the line of a family at an angle is from a line."""
    own, _ = family.lines(family.program.at(np.array([phi]))[:2])
    return float(np.min(np.abs(own - normal)))


def _sampled(task: CamTask, every: tuple[Family, ...], count: int) -> Lines:
    """The lines at n equal steps of every limited phase."""
    ends = {kind: (part.edges[0], part.edges[-1]) for kind, _, part, _ in limited_phases(task)}
    first, *others = (family.at(np.linspace(*ends[family.kind], count + 1)) for family in every)
    return first.joined(*others)


def _nearest(lines: Lines) -> float:
    """Distance of the lowest roller centre from the polygon of the lines."""
    box = FAR * np.ones(4)
    corners, ring = polygon(np.append(lines.normal, 1j ** np.arange(4)), np.append(lines.bound, box))
    if not len(ring):
        raise NoSolutionError("the lines leave no place for the axis", where="accuracy, cam_synthesis")
    step = np.roll(corners, -1) - corners
    part = np.clip(((ROLLER - corners) * np.conj(step)).real / np.maximum(np.abs(step) ** 2, 1e-300), 0.0, 1.0)
    return float(np.min(np.abs(corners + part * step - ROLLER)))


def _raster(lines: Lines, window: float, squares: int) -> float:
    """Distance of the nearest node that lies within all lines."""
    across = window * np.arange(-squares, squares + 1) / squares
    nodes = (ROLLER + across[:, None] + 1j * across).ravel()
    inside = np.ones(len(nodes), bool)
    for normal, bound in zip(lines.normal, lines.bound, strict=True):
        inside &= (nodes * np.conj(normal)).real <= bound
    if not inside.any():
        raise NoSolutionError("no node of the raster is within the limits", where="accuracy, cam_synthesis")
    return float(np.min(np.abs(nodes[inside] - ROLLER)))
