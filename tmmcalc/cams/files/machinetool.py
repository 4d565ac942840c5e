"""Points of cam profiles as text for a machine tool: millimetres and degrees, digits by the chord tolerance."""

from __future__ import annotations

import numpy as np

from tmmcalc.cams.follower import Complex
from tmmcalc.cams.laws.law import Values
from tmmcalc.core.quantity import Quantity
from tmmcalc.report.outlinefiles import MM, places_of

DEGREES = 6  # decimals of angles
HEAD = tuple(
    told.key
    for told in (
        Quantity("phi[deg]", "angle of the cam"),
        Quantity("X[mm]", "X of the point"),
        Quantity("Y[mm]", "Y of the point"),
        Quantity("R[mm]", "distance of the point from the axis of the cam"),
        Quantity("alpha[deg]", "polar angle of the point"),
        Quantity("N_x", "normal out of the cam along X"),
        Quantity("N_y", "normal out of the cam along Y"),
    )
)
BESIDE = (  # of a table that follows the tool's path
    Quantity("X_w[mm]", "X of the point on the working profile").key,
    Quantity("Y_w[mm]", "Y of the point on the working profile").key,
)


def point_texts(phi: Values, points: Complex, polar: Values, normal: Complex, tolerance: float) -> list[list[str]]:
    """The columns of HEAD: phi and polar angle (n,) [rad], points (n,) [m], unit normal (n,) out of the cam."""
    return [
        _texts(np.degrees(phi), DEGREES),
        *place_texts(points, tolerance),
        _lengths(np.abs(points), tolerance),
        _texts(np.degrees(polar), DEGREES),
        *(_texts(values, DEGREES + 2) for values in (normal.real, normal.imag)),
    ]


def place_texts(points: Complex, tolerance: float) -> list[list[str]]:
    """X and Y of points (n,) [m]."""
    return [_lengths(values, tolerance) for values in (points.real, points.imag)]


def _lengths(values: Values, tolerance: float) -> list[str]:
    """Lengths (n,) [m] in mm."""
    return _texts(MM * values, places_of(tolerance))


def _texts(values: Values, places: int) -> list[str]:
    """Fixed decimals; a rounded negative zero has no sign."""
    return [f"{value:.{places}f}" for value in (np.round(values, places) + 0.0).tolist()]
