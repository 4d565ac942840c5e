"""Normal contact of two elastic bodies by boundary integral equations, with Hertz's solution as a check.

The gap h(x, y) of the unloaded bodies closes by the approach delta: inside the contact u + h = delta with the
settlement u = 1/(pi E*) integral of p/r, outside u + h > delta, everywhere p >= 0. 1/E* = sum of (1 - nu^2)/E. Nodes of
a grid of equilateral triangles carry pyramids of pressure; which of them touch is found by an active set.
"""

from __future__ import annotations

from collections.abc import Callable
from math import pi

import numpy as np
from numpy.typing import NDArray

from tmmcalc.errors import AccuracyError, NoSolutionError, UsageError
from tmmcalc.extras.pyramid import HEIGHT, hexagon, settlement
from tmmcalc.numerics.panels import Values
from tmmcalc.records import record

Mask = NDArray[np.bool_]

BORDER = "warning: the contact reaches the border of the grid; a larger size shows all of it"
REACH = 1.5  # corner of the grid over the larger half-axis of Hertz's contact
PASSES = 100  # of the active set
SLACK = 1e-12  # of the approach: a smaller overlap outside is rounding
ACCURACY = 1e-12  # of the conjugate gradients, relative
STEPS = 2000  # of them
FINER = "write more cells, or a smoother gap"
FEWEST = 7  # nodes in contact that tell a pressure


@record
class GapTable:
    """A gap on a rectangle, between whose nodes a bicubic spline runs."""

    x: tuple[float, ...]  # [m] ascending
    y: tuple[float, ...]  # [m] ascending
    h: tuple[tuple[float, ...], ...]  # [m] a row for each y


@record
class ContactTask:
    """Two bodies that are pressed together; the gap is given by radii, a formula or a table."""

    load: float  # P [N]
    modulus: float  # E* [Pa]
    radii: tuple[float, float] | None = None  # [m] of the relative paraboloid in the planes xz and yz
    formula: str = ""  # h(x, y) [m], x and y in m
    table: GapTable | None = None
    cells: int = 24  # N, steps of the grid from the middle to a corner
    size: float | None = None  # [m] from the middle to the corners on the axis of x; None: by Hertz or by the table


@record
class Hertz:
    """The contact of two paraboloids in closed form."""

    along_x: float  # half-axes of the ellipse [m]
    along_y: float
    peak: float  # p0 [Pa]
    approach: float  # delta [m]


@record
class Contact:
    """Pressure and approach of two bodies on a grid of n nodes."""

    x: Values  # (n,) [m]
    y: Values  # (n,) [m]
    gap: Values  # (n,) h [m]
    pressure: Values  # (n,) p [Pa]
    opening: Values  # (n,) u + h - delta [m], 0 in contact
    labels: tuple[str, ...]  # of the nodes
    step: float  # c [m]
    peak: float  # largest p at a node [Pa]
    peak_at: tuple[float, float]  # [m]
    approach: float  # delta [m]
    area: float  # of the nodes in contact [m^2]
    touching: int
    passes: int  # of the active set
    load_error: float  # relative, of the load against the sum of the pressures
    peak_change: float  # relative, against a grid of half as many cells
    approach_change: float
    hertz: Hertz | None
    notes: tuple[str, ...] = ()


@record
class _Grid:
    """One solution: step, places, gap, pressure, approach, opening, who touches, who is on the border, passes."""

    step: float
    places: tuple[Values, Values]
    gap: Values
    pressure: Values
    approach: float
    opening: Values
    touching: Mask
    rim: Mask
    passes: int


def composite_modulus(young: tuple[float, float], poisson: tuple[float, float]) -> float:
    """E* [Pa] of two bodies: 1/E* = sum of (1 - nu^2)/E.

    >>> round(composite_modulus((206e9, 206e9), (0.3, 0.3)) / 1e9, 3)
    113.187
    """
    return 1 / sum((1 - nu**2) / e for e, nu in zip(young, poisson, strict=True))


def hertz(load: float, modulus: float, radii: tuple[float, float]) -> Hertz:
    """The elliptical contact of the gap x^2/(2 Rx) + y^2/(2 Ry); K. L. Johnson, Contact Mechanics, (4.26)-(4.28).

    With k = b/a the ratio of curvatures is R_D(0, 1, k^2)/R_D(0, k^2, 1); Carlson's forms lose no digit at k = 1.

    >>> found = hertz(1.0, 1.0, (1.0, 1.0))
    >>> round(found.along_x, 5), round(found.peak * found.along_x**2, 6), round(found.approach / found.along_x**2, 12)
    (0.90856, 0.477465, 1.0)
    """
    from scipy.optimize import brentq
    from scipy.special import elliprd, elliprf

    large, small = max(radii), min(radii)

    def excess(log_ratio: float) -> float:
        k2 = np.exp(2 * log_ratio)
        return float(np.log(elliprd(0.0, 1.0, k2) / elliprd(0.0, k2, 1.0) * small / large))

    ratio = float(np.exp(brentq(excess, -2 * np.log(large / small) - 1, 0.0, xtol=1e-15))) if large > small else 1.0
    major = float(load * large * elliprd(0.0, ratio**2, 1.0) / (pi * modulus)) ** (1 / 3)
    minor = ratio * major
    peak = 1.5 * load / (pi * major * minor)
    axes = (major, minor) if radii[0] >= radii[1] else (minor, major)
    return Hertz(*axes, peak, float(peak * minor * elliprf(0.0, ratio**2, 1.0) / modulus))


def solve_contact(task: ContactTask) -> Contact:
    """Pressures, approach and contact area, with the change against a coarser grid.

    Raises `UsageError` for a gap that has no value on the grid, `NoSolutionError` for a grid that is too coarse.
    """
    smooth = None if task.radii is None else hertz(task.load, task.modulus, task.radii)
    size = _size(task, smooth)
    coarse = _solved(task, size, task.cells // 2)
    found = _solved(task, size, task.cells, coarse)
    count, at = int(found.touching.sum()), int(np.argmax(found.pressure))
    peak, (x, y) = float(found.pressure[at]), found.places
    if count < FEWEST:
        raise NoSolutionError(
            f"{count} nodes at a step of {1e3 * found.step:.4g} mm touch: too few to tell a pressure",
            where="contact",
            value=float(count),
            limit=float(FEWEST),
            remedy="write more cells, or a smaller size",
        )
    return Contact(
        x=x,
        y=y,
        gap=found.gap,
        pressure=found.pressure,
        opening=found.opening,
        labels=tuple(map(str, range(len(x)))),
        step=found.step,
        peak=peak,
        peak_at=(float(x[at]), float(y[at])),
        approach=found.approach,
        area=HEIGHT * found.step**2 * count,
        touching=count,
        passes=found.passes,
        load_error=float(abs(found.pressure.sum() * HEIGHT * found.step**2 / task.load - 1)),
        peak_change=abs(float(np.max(coarse.pressure)) / peak - 1),
        approach_change=abs(coarse.approach - found.approach) / float(np.max(np.abs(found.approach - found.gap))),
        hertz=smooth,
        notes=(BORDER,) if np.any(found.touching & found.rim) else (),
    )


def _size(task: ContactTask, smooth: Hertz | None) -> float:
    if task.size is not None:
        return task.size
    if smooth is not None:
        return REACH * max(smooth.along_x, smooth.along_y)
    if task.table is not None:
        x, y = task.table.x, task.table.y
        size = min(-x[0], x[-1], -y[0] / HEIGHT, y[-1] / HEIGHT)
        if size > 0:
            return size
        raise UsageError("the table does not hold the origin", where="contact.table", remedy="let x and y pass 0")
    raise UsageError("a formula has no size of its own", where="contact.size", remedy='add size = "2 mm"')


def _solved(task: ContactTask, size: float, cells: int, coarse: _Grid | None = None) -> _Grid:
    """One grid; ``coarse`` is a solution on another one."""
    i, j = hexagon(cells)
    step = size / cells
    places = step * (i + j / 2), step * HEIGHT * j
    gap = _gap(task, *places)
    guess = np.ones(len(i), bool) if coarse is None else gap <= coarse.approach  # what touches has settled
    scale = pi * task.modulus / step  # pressure over settlement
    load = task.load / (scale * HEIGHT * step**2)
    q, delta, opening, touching, passes = active_set(settlement(i, j), gap, load, guess)
    rim = np.max(np.abs([i, j, i + j]), axis=0) == cells
    return _Grid(step, places, gap, scale * q, delta, opening, touching, rim, passes)


def _gap(task: ContactTask, x: Values, y: Values) -> Values:
    if task.radii is not None:
        return x**2 / (2 * task.radii[0]) + y**2 / (2 * task.radii[1])
    if task.table is None:
        from tmmcalc.expression import parse_field

        return parse_field(task.formula, ("x", "y"), "contact.gap")(x, y)
    from scipy.interpolate import RectBivariateSpline

    given = task.table
    for axis, places, ends in (("x", x, given.x), ("y", y, given.y)):
        reach, slack = max(abs(float(places.min())), abs(float(places.max()))), 1e-9 * (ends[-1] - ends[0])
        if min(-ends[0], ends[-1]) < reach - slack:
            rule = f"the grid reaches {axis} = {1e3 * reach:.4g} mm, the table of the gap does not"
            raise UsageError(rule, where="contact.size", value=reach, remedy="write a smaller size, or a larger table")
    degrees = (min(3, len(given.x) - 1), min(3, len(given.y) - 1))
    spline = RectBivariateSpline(given.x, given.y, np.array(given.h).T, kx=degrees[0], ky=degrees[1])
    return np.asarray(spline.ev(x, y))


def active_set(
    settle: Callable[[Values], Values], gap: Values, load: float, touching: Mask
) -> tuple[Values, float, Values, Mask, int]:
    """Pressures q >= 0 (n,) with W q + h = delta where q > 0 and the sum ``load``; delta, opening, who touches, passes.

    From a first guess of who touches, nodes that pull are dropped until none does, then those that overlap are
    admitted. Raises `AccuracyError` if that does not settle.
    """
    unit: Values = np.zeros(len(gap))
    own: Values = np.zeros(len(gap))
    for passes in range(1, PASSES + 1):
        unit = _solve(settle, np.ones(len(gap)), unit, touching)
        own = _solve(settle, gap, own, touching)
        delta = float((load + own.sum()) / unit.sum())
        q = delta * unit - own
        if np.any(q < 0):
            touching = q > 0
            continue
        opening = np.where(touching, 0.0, settle(q) + gap - delta)
        overlap = opening < -SLACK * (abs(delta) + float(np.ptp(gap)))
        if not overlap.any():
            return q, delta, opening, touching, passes
        touching = touching | overlap
    raise AccuracyError(f"the nodes in contact did not settle in {PASSES} passes", where="contact", remedy=FINER)


def _solve(settle: Callable[[Values], Values], wanted: Values, first: Values, touching: Mask) -> Values:
    """q, zero where nothing touches, with W q = wanted (n,) elsewhere: conjugate gradients from ``first``."""
    q = np.where(touching, first, 0.0)
    enough = ACCURACY**2 * float(wanted[touching] @ wanted[touching])
    if not enough:
        return np.zeros(len(q))
    residual = np.where(touching, wanted - settle(q), 0.0)
    direction, left = residual, float(residual @ residual)
    for _ in range(STEPS):
        if left <= enough:
            return q
        turned = np.where(touching, settle(direction), 0.0)
        part = left / float(direction @ turned)
        q, residual = q + part * direction, residual - part * turned
        before, left = left, float(residual @ residual)
        direction = residual + left / before * direction
    raise AccuracyError(f"pressures were not found in {STEPS} steps", where="contact", remedy=FINER)
