"""Where the flywheel stands: on the input shaft, the motor shaft or any other.

A wheel on a shaft that turns u times as fast as the input shaft counts u^2 times there, so it needs J/u^2 only.
Beyond the gears it does not relieve them, though: they carry the peaks of the load between the wheel and the crank.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from tmmcalc.errors import UsageError
from tmmcalc.machine.flywheel.materials import CAST_IRON, Material
from tmmcalc.machine.flywheel.rim import DEFAULT, Proportions, Rim, rim_of_mean_diameter, rim_of_proportions
from tmmcalc.records import record


@record
class Shaft:
    """A shaft that may carry the flywheel."""

    name: str
    ratio: float  # u, its speed over that of the input shaft [-], of either sign
    room: float = math.inf  # largest outer diameter that fits [m]
    diameter: float | None = None  # chosen mean diameter of the rim [m]; None: by the proportions


@record
class Placement:
    """The flywheel on one shaft."""

    shaft: Shaft
    inertia: float  # of the wheel itself [kg*m^2]
    speed: float  # largest speed of the shaft [rad/s]
    rim: Rim
    remarks: tuple[str, ...]


def placed(
    addition: float,
    shaft: Shaft,
    speed: float,
    material: Material = CAST_IRON,
    proportions: Proportions = DEFAULT,
) -> Placement:
    """The wheel that adds ``addition`` [kg*m^2], reduced to the input shaft, on the ``shaft``.

    ``speed`` is the largest speed of the input shaft [rad/s]. Raises `UsageError` for a ratio of zero and
    `NoSolutionError` if no rim fits.
    """
    if not (math.isfinite(shaft.ratio) and shaft.ratio):
        raise UsageError(
            f"shaft {shaft.name!r} has the ratio {shaft.ratio:g}",
            where="flywheel",
            value=shaft.ratio,
            remedy="give its speed over that of the input shaft",
        )
    inertia, fast = addition / shaft.ratio**2, abs(shaft.ratio) * speed
    if shaft.diameter is None:
        rim = rim_of_proportions(inertia, fast, material, proportions, room=shaft.room)
    else:
        rim = rim_of_mean_diameter(inertia, shaft.diameter, fast, material, proportions)
    return Placement(shaft, inertia, fast, rim, _remarks(shaft, rim))


def placements(
    addition: float,
    shafts: Sequence[Shaft],
    speed: float,
    material: Material = CAST_IRON,
    proportions: Proportions = DEFAULT,
) -> tuple[Placement, ...]:
    """The wheel on each of the ``shafts``, the lightest first."""
    all_placed = (placed(addition, shaft, speed, material, proportions) for shaft in shafts)
    return tuple(sorted(all_placed, key=lambda placement: placement.rim.total_mass))


def _remarks(shaft: Shaft, rim: Rim) -> tuple[str, ...]:
    remarks = []
    if not rim.allowed:
        limit = rim.material.rim_speed
        remarks.append(f"the rim runs at {rim.speed:.4g} m/s, above the {limit:g} m/s of {rim.material.name}")
    if rim.outer > shaft.room * (1 + 1e-12):
        remarks.append(f"the outer diameter {rim.outer:.4g} m does not fit into {shaft.room:.4g} m")
    if abs(shaft.ratio) != 1:
        remarks.append("the gears between the wheel and the input shaft carry the peaks of the load")
    return tuple(remarks)
