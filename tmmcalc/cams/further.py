"""Columns by choice of the tables over the turn of the cam: nothing of them is computed before a column is made.

With them the tables of the textbook's programs are printed one by one: the law in parts of its phase (table 5.1), and
of program 2.7 displacement with its derivatives, radii of curvature, and the reduced curvature of the contact.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import cache, partial
from typing import TYPE_CHECKING, Any

import numpy as np

from tmmcalc.cams.laws.law import Values
from tmmcalc.core.columns import Column, column
from tmmcalc.core.quantity import Quantity

if TYPE_CHECKING:
    from tmmcalc.cams.forces.results import CamForces
    from tmmcalc.cams.lawresult import LawResult
    from tmmcalc.cams.profile.results import Profile
    from tmmcalc.cams.room import CamTables
    from tmmcalc.cams.strength.results import CamStrength
    from tmmcalc.cams.task import CamTask

OF_LAW = (
    Quantity("s", "part of the stroke", source="(5.1)"),
    Quantity("s1", "derivative of the part of the stroke by k, with the sign of the law", symbol="s'"),
    Quantity("s2", "second derivative of the part of the stroke by k", symbol="s''"),
    Quantity("s3", "third derivative of the part of the stroke by k, with the sign of the law", symbol="s'''"),
)
PLACE = (
    Quantity("S[m]", "distance of roller centre or face from the cam's axis along the lift"),
    Quantity("psi[deg]", "angle of the rocker from the line of centres"),
)
SLOPES = (
    Quantity("{coordinate}{order}[m]", "derivative {order} of the displacement by the angle of the cam"),
    Quantity("{coordinate}{order}", "derivative {order} of the displacement by the angle of the cam"),
)
ANGLE = Quantity("theta[deg]", "pressure angle")
PRESSING = Quantity("R[N]", "force of the cam on the follower, in a groove positive on the inner wall")
REDUCED = Quantity(
    "kappa_red[1/m]", "reduced curvature of the contact, 1/(rho - r2) + 1/r2", symbol="1/rho_red", source="(5.88)"
)
STRAIGHT = 1e-9  # of 1/R0: a curvature of a straight piece


def of_law(spec: CamTables, results: Mapping[str, Any]) -> Sequence[Column]:
    """The law itself at the rows of ``cam_law``: s, s', s'', s''' by k; in a dwell s alone is not 0."""
    result: LawResult = results["cam_law"]

    def made(order: int) -> Values:
        length = np.array([each.end - each.begin for each in result.phases])
        way = np.array([(each.end - each.begin) * (1 if each.high >= each.low else -1) for each in result.phases])
        still = np.array([each.constants is None for each in result.phases])
        scale = np.where(still, 0.0 if order else 1.0, way**order if order % 2 else length**order)
        found: Values = result.motion[order] * scale[result.phase] / result.stroke + 0.0
        return found

    return [column(told, partial(made, order)) for order, told in enumerate(OF_LAW)]


def of_forces(spec: CamTables, results: Mapping[str, Any]) -> Sequence[Column]:
    """Displacement from the axis, or from the line of centres, and its derivatives at the rows of ``cam_forces``."""
    result: CamForces = results["cam_forces"]
    turns = result.follower.kind == "oscillating"

    @cache
    def task() -> CamTask:
        from tmmcalc.cams.tables.tasks.cam import to_cam

        return to_cam(spec)

    def place() -> Values:
        found = result.follower.start + result.lift
        return np.degrees(found) if turns else found

    def slope(order: int) -> Values:
        found: Values = task().motion[order]
        return found

    told = SLOPES[turns]
    by_order = (told.of(coordinate="psi" if turns else "S", order=order) for order in (1, 2))
    slopes = [column(each, partial(slope, order)) for order, each in enumerate(by_order, 1)]
    return [column(PLACE[turns], place), *slopes]


def of_profile(spec: CamTables, results: Mapping[str, Any]) -> Sequence[Column]:
    """Radii of curvature at the rows of ``cam_profile``; NaN where a curve is straight."""
    return list(_radii(results["cam_profile"]))


def _radii(result: Profile) -> Iterator[Column]:
    from tmmcalc.cams.profile.columns import BEND

    def radius(bend: Values) -> Values:
        straight = np.abs(bend) * result.follower.base < STRAIGHT
        return np.where(straight, np.nan, 1 / np.where(straight, 1.0, bend))

    for index, bend in (("c", result.pitch_curvature), ("w", result.curvature)):
        if bend is not None:
            yield column(BEND.of(curve=index), partial(radius, bend))


def of_strength(spec: CamTables, results: Mapping[str, Any]) -> Sequence[Column]:
    """Pressure angle, force and reduced curvature of the contact at the rows of ``cam_strength``."""
    result: CamStrength = results["cam_strength"]
    forces: CamForces = results["cam_forces"]

    def reduced() -> Values:
        if result.follower.kind == "flat":
            return result.curvature
        roller = result.follower.roller
        gap = roller * (1 - np.where(forces.contact < 0, -1.0, 1.0) * result.curvature * roller)
        return np.where(gap > 0, 1 / np.where(gap > 0, gap, 1.0), np.nan)

    return [
        column(ANGLE, lambda: np.degrees(forces.theta)),
        column(PRESSING, lambda: forces.contact),
        column(REDUCED, reduced),
    ]
