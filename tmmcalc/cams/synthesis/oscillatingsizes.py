"""Oscillating roller follower: l0, l2, psi0 under limits of the pressure angle.

Three lengths and an angle, one triangle: l0, l2, R0 and psi0. What is given of them leaves a plane of places of the
cam's axis, a curve, or nothing to find. With one length alone the region is searched in the plane (`halfplanes`): the
least base circle of a given rocker, or of given centres. With one size more the axis lies on a curve (`curves`).
"""

from __future__ import annotations

from cmath import phase
from math import acos, atan, cos, pi, sin, sqrt, tan

import numpy as np

from tmmcalc.cams.synthesis.bestplace import best
from tmmcalc.cams.synthesis.curves import Over, about_centres, about_pivot, about_roller, best_on, ray
from tmmcalc.cams.synthesis.halfplanes import Family, Lines, families, sampled
from tmmcalc.cams.synthesis.objectives import Distance, Objective, Ratio
from tmmcalc.cams.synthesis.polygon import polygon
from tmmcalc.cams.synthesis.results import PIVOT, Region
from tmmcalc.cams.task import AngleLimits, Asked, CamTask
from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.core.records import record

WINDOW = 2.2  # depth of the window against that of the axis
SAME = 1e-9  # relative: sizes given twice agree
HALVINGS = 14  # to less than the hundredth of a degree that is told


@record
class Triangle:
    """l0, l2 [m], psi0 [rad] of a rocker, and the rule that found them."""

    centres: float
    rocker: float
    start: float
    how: str

    @property
    def axis(self) -> complex:
        """The cam's axis in the plane of `halfplanes`, in units of l2."""
        return complex(self.centres / self.rocker * np.exp(-1j * self.start))

    @property
    def base(self) -> float:
        """R0 [m]."""
        return self.rocker * abs(self.axis - 1)


def least_triangle(task: CamTask) -> Triangle:
    """The sizes that keep the limits; what is given is kept.

    Raises `UsageError` if no length is given or the given ones contradict each other, `NoSolutionError` if no place of
    the axis keeps the limits.
    """
    asked = task.asked
    lengths = [size for size in (asked.rocker, asked.centres, asked.base) if size is not None]
    if not lengths:
        raise UsageError(
            "no length of the rocker's cam is given: the pressure angle fixes ratios alone",
            where="cam",
            remedy="give rocker_length or centre_distance",
        )
    if len(lengths) + (asked.start is not None) >= 3:
        return given_triangle(asked)
    every = families(task)
    try:
        if len(lengths) == 1 and asked.start is None:
            point = best(every, Ratio() if asked.centres is not None else Distance(1.0)).point
            return scaled(asked, point, "least base circle" if asked.base is None else "longest rocker")
        return on_curve(asked, every)
    except NoSolutionError as fault:
        raise _with_remedy(task, fault) from None


def least_centres(task: CamTask) -> Triangle:
    """The sizes of the least distance of the centres for the same rocker (or of the longest rocker)."""
    point = best(families(task), Distance(0.0)).point
    return scaled(task.asked, point, "least centre distance")


def given_triangle(asked: Asked) -> Triangle:
    """The triangle that the given sizes fix; raises `UsageError` if it does not close or they contradict each other."""
    l0, l2, base, psi0 = asked.centres, asked.rocker, asked.base, asked.start
    if psi0 is None:
        psi0 = _opposite(_known(base), _known(l0), _known(l2))
    if l0 is None:
        l0 = _side(_known(l2), _known(base), psi0, "centre_distance")
    if l2 is None:
        l2 = _side(l0, _known(base), psi0, "rocker_length")
    found = Triangle(l0, l2, psi0, "given")
    if base is not None and abs(found.base - base) > SAME * base:
        raise UsageError(
            f"the given sizes make R0 = {1e3 * found.base:.6g} mm, not {1e3 * base:.6g} mm",
            where="cam",
            value=base,
            limit=found.base,
            remedy="leave base_radius or another of these sizes out",
        )
    return found


def region_of(task: CamTask, found: Triangle) -> Region | None:
    """The polygon of the admissible places of the axis [m], cut below the place taken; None if there are none.

    Its sides are lines at the points of the panels, between which the border is curved, and those that meet in the
    corner.
    """
    every = families(task)
    lines = sampled(every)
    try:
        corner = best(every, Distance(1.0))
    except NoSolutionError:
        return None
    down = -1j * np.exp(0.5j * task.program.stroke)
    depth = WINDOW * max((each * np.conj(down)).real for each in (found.axis, corner.point))
    cut = Lines(np.array([down]), np.array([depth]), np.zeros(1), np.zeros(1, dtype=np.intp))
    lines = lines.apart(corner.lines).joined(corner.lines, cut)
    corners, ring = polygon(lines.normal, lines.bound)
    if not len(corners):
        return None
    corners = corners * found.rocker
    return Region(PIVOT, corners.real.copy(), corners.imag.copy(), lines.phi[ring], lines.side[ring])


def textbook(task: CamTask, rocker: float) -> Triangle | None:
    """psi0 and l0 with the axis square to the rocker's middle position (5.50, 5.51).

    For equal phases and laws; else the larger velocity and the smaller limit. None if there is no such triangle.
    """
    limits, half = task.limits, task.program.stroke / 2
    limit = limits.rise if limits.back is None else min(limits.rise, limits.back)
    start = atan(fastest(task) / tan(limit)) - half
    if start <= 0 or start + half >= pi / 2:
        return None
    return Triangle(rocker / cos(start + half), rocker, start, "textbook (5.50, 5.51)")


def fastest(task: CamTask) -> float:
    """The largest |psi'| of the phases whose pressure angle is limited."""
    speeds = [np.max(np.abs(family.part.turning(family.motion[1])[1])) for family in families(task) if family.side > 0]
    return float(max(speeds))


def lowered(found: Triangle, stroke: float, by: float, asked: Asked) -> Triangle:
    """The axis moved away from the rocker's middle position by so many lengths of it, the given length kept."""
    return scaled(asked, found.axis - 1j * by * complex(np.exp(0.5j * stroke)), found.how)


def on_curve(asked: Asked, every: tuple[Family, ...], also: Over | None = None) -> Triangle:
    """With two sizes given: the best place on their curve, where ``also`` is not above zero."""
    l0, l2, base = asked.centres, asked.rocker, asked.base
    if asked.start is not None:
        aim: Objective = Ratio() if l0 is not None else Distance(1.0)
        point = best_on(every, ray(asked.start), lambda o: float(aim.of(np.array(o))), also)
        return scaled(asked, point, "least base circle with the given start_angle")
    if base is None:
        point = best_on(every, about_pivot(_known(l0) / _known(l2)), lambda o: abs(o - 1), also)
        return scaled(asked, point, "least base circle with the given lengths")
    if l2 is not None:
        point = best_on(every, about_roller(base / l2), abs, also)
        return scaled(asked, point, "least centre distance with the given lengths")
    point = best_on(every, about_centres(base / _known(l0)), lambda o: -abs(o), also)
    return scaled(asked, point, "shortest rocker with the given lengths")


def scaled(asked: Asked, point: complex, how: str) -> Triangle:
    """The triangle of a point of the plane, in metres by the length that is given; what is given is kept to the bit."""
    if asked.rocker is not None:
        l2 = asked.rocker
    elif asked.centres is not None:
        l2 = asked.centres / abs(point)
    else:
        l2 = _known(asked.base) / abs(point - 1)
    l0 = asked.centres if asked.centres is not None else l2 * abs(point)
    return Triangle(l0, l2, asked.start if asked.start is not None else -phase(point), how)


def _known(size: float | None) -> float:
    if size is None:
        raise UsageError("a length of the rocker's cam is missing", where="cam", remedy="give rocker_length")
    return size


def _opposite(base: float, l0: float, l2: float) -> float:
    """psi0 of three lengths."""
    cosine = (l0 * l0 + l2 * l2 - base * base) / (2 * l0 * l2)
    if abs(cosine) >= 1:
        raise UsageError(
            f"no triangle has the sides l0 = {1e3 * l0:g}, l2 = {1e3 * l2:g}, R0 = {1e3 * base:g} mm",
            where="cam",
            remedy="the longest has to be shorter than the two others together",
        )
    return acos(cosine)


def _side(other: float, base: float, psi0: float, name: str) -> float:
    """The side beside psi0 of a triangle with the side ``other`` and, across, R0; the longer of two."""
    height = other * sin(psi0)
    if base < height:
        raise UsageError(
            f"R0 = {1e3 * base:g} mm is shorter than the distance {1e3 * height:g} mm that psi0 leaves",
            where="cam",
            value=base,
            limit=height,
            remedy=f"give {name}, or a larger base_radius",
        )
    return other * cos(psi0) + sqrt((base - height) * (base + height))


def _with_remedy(task: CamTask, fault: NoSolutionError) -> NoSolutionError:
    """The error with the least limits that would do."""
    ways = ["longer phases", "a smaller stroke"]
    factor = _least_factor(task)
    if factor is not None:
        angle = np.degrees(factor * task.limits.rise)
        ways.insert(0, f"a pressure_angle of {np.ceil(100 * angle) / 100:g} deg (the return in proportion)")
    elif fault.remedy:
        ways.insert(0, fault.remedy)
    if task.limits.back is not None:
        ways.append("pressure_angle_return = false where a spring drives the return")
    return NoSolutionError(
        fault.message, where=fault.where, value=fault.value, limit=fault.limit, remedy=", ".join(ways)
    )


def _least_factor(task: CamTask) -> float | None:
    """By what the limits have to grow for the region not to be empty; None if it is not."""
    limits = task.limits
    largest = max(limits.rise, limits.back or 0.0)
    low, high = 1.0, 0.999 * (pi / 2) / largest
    if _opens(task, low) or not _opens(task, high):
        return None
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        low, high = (low, middle) if _opens(task, middle) else (middle, high)
    return high


def _opens(task: CamTask, factor: float) -> bool:
    limits = task.limits
    back = None if limits.back is None else factor * limits.back
    grown = AngleLimits(factor * limits.rise, back)
    try:
        best(families(CamTask(task.program, task.asked, grown)), Distance(1.0))
    except NoSolutionError:
        return False
    return True
