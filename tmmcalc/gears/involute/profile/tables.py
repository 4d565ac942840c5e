"""The textbook's tables of the main profile and of the fillet (program 2.6).

Axes X-Omega-Y: the origin lies on the base circle, Y runs from the centre through a point of the pitch circle, the axis
of the tooth or that of the space; the point of the flank on the reference circle is turned from Y by ``turn``. The
book's columns of the fillet hold for the circular rounding.
"""

from __future__ import annotations

from math import pi, tan
from typing import Literal

import numpy as np

from tmmcalc.core.errors import UsageError
from tmmcalc.core.plane import Plane, Real
from tmmcalc.core.records import record
from tmmcalc.gears.involute.function import involute
from tmmcalc.gears.involute.profile.flank import Flank
from tmmcalc.gears.involute.wheel import Wheel

Axis = Literal["pitch", "reference", "tooth", "space"]
STRAIGHT = 1e-12  # curvature below which a radius is given as its inverse


@record
class MainProfile:
    """Table of the involute; arrays (n,), lengths in normal modules."""

    roll: Real  # phi [rad]
    x: Real  # X_T
    y: Real  # Y_T
    radius: Real  # R_T, of curvature


@record
class FilletTable:
    """Table of the fillet; arrays (n,), lengths in normal modules. The last two rows are those of L and D."""

    roll: Real  # phi [rad]
    centre_x: Real  # X_S
    centre_y: Real  # Y_S
    x: Real  # X, 0 where nothing is cut
    y: Real  # Y, 0 where nothing is cut
    centre_radius: Real  # R_S, of curvature of the path of S
    radius: Real  # R, of curvature of the fillet, 0 where nothing is cut
    cut: np.ndarray  # whether the rounding cuts the fillet at this roll


def axis_turn(wheel: Wheel, axis: Axis = "pitch", angle: float | None = None) -> float:
    """The angle [rad] from the flank's point on the reference circle to the axis Y (4.73, 4.96).

    Y passes through the point of the flank on the operating pitch circle, for the operating angle ``angle`` [rad], or
    on the reference circle, or along the axis of the tooth or the space. Raises `UsageError` if the angle is missing.
    """
    psi = float(wheel.half_angle)
    if axis == "pitch":
        if angle is None:
            raise UsageError(
                "the axis through the pitch point needs a pair", where="tooth profile", remedy='axis = "tooth"'
            )
        return float(involute(angle)) - float(involute(wheel.transverse_angle))
    return {"reference": 0.0, "tooth": psi, "space": psi - pi / wheel.teeth}[axis]


def _split(flank: Flank, points: Plane, turn: float) -> tuple[Real, Real]:
    """X and Y of points in the axes of the tooth."""
    turned = points * np.exp(1j * (turn - float(flank.wheel.half_angle)))
    return turned.real, turned.imag - flank.wheel.base


def main_profile(flank: Flank, turn: float, intervals: int = 10, rolls: Real | None = None) -> MainProfile:
    """The involute from the tip down to its beginning, in equal steps of phi or at given ones (4.77 to 4.84)."""
    ends = flank.rolls
    if rolls is None:
        roll = np.linspace(ends.tip, ends.form, intervals + 1)
    else:
        given = np.sort(np.asarray(rolls, float))[::-1]
        roll = np.concatenate([[ends.tip], given[(given < ends.tip) & (given > ends.form)], [ends.form]])
    xi = np.maximum(roll + tan(flank.rounding.angle), flank.lowest)
    x, y = _split(flank, flank.on_involute(xi), turn)
    return MainProfile(roll, x, y, flank.wheel.base * xi)


def fillet_table(flank: Flank, turn: float, rolls: Real) -> FilletTable:
    """The path of S and the fillet at roll angles (n,) [rad], then at L and D (4.85 to 4.95).

    Raises `UsageError` for an elliptic rounding: its centre of curvature moves.
    """
    tool = flank.rounding
    if tool.width != tool.height:
        raise UsageError(
            "the table of the fillet is that of a circular rounding", where="tooth profile", remedy='fillet = "circle"'
        )
    ends = flank.rolls
    roll = np.concatenate([np.asarray(rolls, float), [ends.limit, ends.root]])
    y, side = float(tool.y), 1.0 if tool.y > 0 else -1.0
    p = tool.reference * roll - float(tool.x)
    # the normal through S and Q; at L and D it is known without the angle, which y_S = 0 leaves open
    theta = np.arctan2(side * y, side * p)
    theta[-2:] = tool.angle, pi / 2
    cut = (theta >= tool.angle - 1e-12) & (theta <= pi / 2 + 1e-12) & (y != 0)
    cut[-2:] = True
    reach = -y / np.sin(np.where(cut, theta, pi / 2)) + tool.height
    centre = (float(tool.x) - tool.reference * roll + 1j * (y + tool.reference)) * np.exp(-1j * roll)
    fillet = (1j * tool.reference + reach * np.exp(-1j * theta)) * np.exp(-1j * roll)
    to_tooth = np.exp(1j * float(flank.wheel.half_angle))
    xs, ys = _split(flank, centre * to_tooth, turn)
    x, y_fillet = _split(flank, fillet * to_tooth, turn)
    squared = y * y + p * p
    path = squared**1.5 / np.maximum(np.abs(tool.reference * y - squared), STRAIGHT)
    own = np.abs(_radius(tool.curvature(np.where(cut, theta, pi / 2))))
    return FilletTable(
        roll, xs, ys, np.where(cut, x, 0.0), np.where(cut, y_fillet, 0.0), path, np.where(cut, own, 0.0), cut
    )


def _radius(curvature: Real) -> Real:
    return 1 / np.where(np.abs(curvature) < STRAIGHT, STRAIGHT, curvature)
