"""Normal contact of two elastic bodies by boundary integral equations, with Hertz's solution as a check.

The gap h(x, y) of the unloaded bodies closes by the approach delta: inside the contact u + h = delta with the
settlement u = 1/(pi E*) integral of p/r, outside u + h > delta, everywhere p >= 0. 1/E* = sum of (1 - nu^2)/E. Nodes of
a grid of equilateral triangles carry pyramids of pressure; which of them touch is found by an active set.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import pi

import numpy as np

from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.core.notes import Said, held
from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.quantity import derived, quantity
from tmmcalc.core.records import record
from tmmcalc.extras.activeset import Mask, active_set
from tmmcalc.extras.hertz import Hertz, hertz
from tmmcalc.extras.influence import HEIGHT, hexagon, settlement

BORDER = "warning: the contact reaches the border of the grid; a larger size shows all of it"
SMALL = 0.3  # half-axis over radius up to which a body is a half-space to the contact
REACH = 1.5  # corner of the grid over the larger half-axis of Hertz's contact
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
class ContactError:
    """Relative errors: the change against the coarser grid, and the border of the contact, known to one node of n."""

    peak: float
    approach: float


@record
class Contact:
    """Pressure and approach of two bodies on a grid of n nodes."""

    x: Values = quantity("x[m]", "x of the node")  # (n,)
    y: Values = quantity("y[m]", "y of the node")  # (n,)
    gap: Values = quantity("h[m]", "gap of the unloaded bodies")  # (n,)
    pressure: Values = quantity("p[Pa]", "pressure")  # (n,)
    opening: Values = quantity("opening[m]", "opening u + h - delta, 0 in contact")  # (n,)
    labels: tuple[str, ...]  # of the nodes
    step: float = quantity("c[m]", "step of the grid")
    peak: float = quantity("p_max[Pa]", "largest pressure at a node")
    peak_at: tuple[float, float]  # [m]
    approach: float = quantity("delta[m]", "approach of the bodies")
    area: float = quantity("A[m^2]", "area of the nodes in contact")
    touching: int = quantity("touching", "number of nodes in contact")
    passes: int = quantity("passes", "passes of the active set")
    load_error: float = quantity("load_error", "relative error of the load against the sum of the pressures")
    error: ContactError
    peak_change: float = quantity("p_change", "relative change of p_max against a grid of half as many cells")
    approach_change: float = quantity("delta_change", "relative change of delta against a grid of half as many cells")
    hertz: Hertz | None
    notes: tuple[Said, ...] = ()

    @derived("x[m]", "x of the largest pressure")
    def peak_x(self) -> float:
        """Of the node."""
        return self.peak_at[0]

    @derived("y[m]", "y of the largest pressure")
    def peak_y(self) -> float:
        """Of the node."""
        return self.peak_at[1]


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
    peak_change = abs(float(np.max(coarse.pressure)) / peak - 1)
    approach_change = abs(coarse.approach - found.approach) / float(np.max(np.abs(found.approach - found.gap)))
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
        peak_change=peak_change,
        approach_change=approach_change,
        error=ContactError(peak_change + 1 / count, approach_change + 1 / count),
        hertz=smooth,
        notes=tuple(_notes(task, smooth, bool(np.any(found.touching & found.rim)))),
    )


def _notes(task: ContactTask, smooth: Hertz | None, at_border: bool) -> Iterator[Said]:
    if at_border:
        yield BORDER
    if task.radii is not None and smooth is not None:
        part = max(smooth.along_x / task.radii[0], smooth.along_y / task.radii[1])
        if part > SMALL:
            text = (
                "a half-axis is {value:.3g} of its radius, above {limit:g}: bodies are no longer flat against the "
                "contact, and pressure and approach are rough"
            )
            yield held("warning", text, part, SMALL, name="half-axis/radius")


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


def settled(task: ContactTask, result: Contact) -> Values:
    """u (n,) [m]: how far the pressures settle the bodies at the nodes."""
    scale = pi * task.modulus / result.step
    return settlement(*hexagon(task.cells))(result.pressure / scale)


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
        from tmmcalc.core.expression import parse_field

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
