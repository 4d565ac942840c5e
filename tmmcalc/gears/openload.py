"""What loads the open pair on the crank: torques of both wheels, forces in the mesh, stresses of the teeth.

The gear b bears the largest reduced moment of the machine, the pinion a that over the ratio. Losses do not enter, as in
the textbook. On the operating pitch circle r_w of the gear

    F_t = T_b/r_w,   F_r = F_t tan(alpha_tw),   F_a = F_t tan(beta_w),   tan(beta_w) = tan(beta) r_w/r

Contact and bending are those of a train (4.38) to (4.41) at the module and face width that are given.
"""

from __future__ import annotations

from math import hypot, tan
from typing import TYPE_CHECKING, Any

import numpy as np

from tmmcalc.core.quantity import derived, quantity
from tmmcalc.core.records import record
from tmmcalc.gears.openpair import OpenPair, tooth_sets, wheel_inertias
from tmmcalc.gears.sizing import GIVEN, MOMENT, REDUCTION, largest_moment
from tmmcalc.gears.strength.errors import strength_error
from tmmcalc.gears.strength.material import Material
from tmmcalc.gears.strength.results import Strength
from tmmcalc.gears.strength.solve import solve_strength
from tmmcalc.gears.strength.task import StageTask, StrengthTask

if TYPE_CHECKING:
    from tmmcalc.gears.meshing.results import Pairs

BY_SIZES = "by module, teeth and face width"


@record
class OpenTask:
    """What is asked of the open pair."""

    open: OpenPair
    pinion: Material | None  # None: no stresses are found
    gear: Material | None  # None: as the pinion
    row: int  # of Table D.4.1
    moment: float | None  # largest moment on the crank as given [N*m]; None: that of the reduction
    in_bearing: bool | None  # whether the force of the mesh is one on the crank's bearing; None: there is no crank


@record
class OpenError:
    """Relative errors of what loads the open pair; 0 where it is given, or not there."""

    torque: float  # of all torques and forces
    contact_stress: float
    bending_stress: float


@record
class OpenLoad:
    """The open pair in the drive; forces and stresses are None where nothing loads the crank."""

    task: OpenTask
    name: str = quantity("open_pair", "the open pair by its teeth")
    ratio: float = quantity("u_open", "ratio of the open pair, z_b/z_a")
    efficiency: float = quantity("eta_open", "efficiency of the open pair")
    efficiency_of: str = quantity("eta_open_of", "where the efficiency of the open pair comes from")
    pinion_inertia: float = quantity("J_a[kg*m^2]", "inertia of the pinion about its own axis", source="(4.44)")
    gear_inertia: float = quantity("J_b[kg*m^2]", "inertia of the gear on the crank", source="(4.44)")
    inertia: float = quantity("J_open[kg*m^2]", "inertia of the open pair reduced to the crank")
    inertia_of: str = quantity("J_open_of", "where the inertia of the open pair comes from")
    radius: float = quantity("r_w_b[m]", "operating pitch radius of the gear on the crank")
    angle: float = quantity("alpha_tw_b[rad]", "operating transverse pressure angle of the open pair")
    torque: float | None = quantity("T_b[N*m]", "largest torque on the gear on the crank")
    torque_of: str = quantity("T_b_source", "where the torque of the open pair comes from")
    lead: float  # tangent of the helix angle on the operating pitch circle
    strength: Strength | None  # at the given module and width
    error: OpenError

    @derived("T_a[N*m]", "largest torque on the pinion, T_b/u")
    def pinion_torque(self) -> float | None:
        """Without losses."""
        return None if self.torque is None else self.torque / self.ratio

    @derived("F_t[N]", "tangential force in the mesh, T_b/r_w")
    def tangential(self) -> float | None:
        """On the operating pitch circle."""
        return None if self.torque is None else self.torque / self.radius

    @derived("F_r[N]", "radial force in the mesh, F_t tan(alpha_tw)")
    def radial(self) -> float | None:
        """It pushes wheels apart, and draws a pinion to the rim of its ring."""
        return None if self.tangential is None else self.tangential * tan(self.angle)

    @derived("F_a[N]", "axial force in the mesh of helical wheels, F_t tan(beta_w)")
    def axial(self) -> float | None:
        """It is not in the plane of the linkage."""
        return None if self.tangential is None else self.tangential * self.lead

    @derived("F_across[N]", "force in the mesh in the transverse plane")
    def across(self) -> float | None:
        """The force that enters the crank's bearing."""
        if self.tangential is None or self.radial is None:
            return None
        return hypot(self.tangential, self.radial)


def solve_open(task: OpenTask, *, pair: Pairs, reduction: Any = None) -> OpenLoad:
    """The open pair in the drive, for the moment that is given or the largest reduced one of ``reduction``.

    Raises `UsageError` for materials that the tables of strength do not know.
    """
    own = task.open
    found = next(each for each in pair.pairs if each.task == own.pair)
    torque, source = _torque(task, reduction)
    pinion, gear = wheel_inertias(own.pair)
    radius, strength = found.sizes[1].operating, _strength(task, torque)
    return OpenLoad(
        task=task,
        name=own.name,
        ratio=own.ratio,
        efficiency=own.efficiency,
        efficiency_of=own.efficiency_of,
        pinion_inertia=pinion,
        gear_inertia=gear,
        inertia=own.on_crank,
        inertia_of=BY_SIZES if own.inertia is None else GIVEN,
        radius=radius,
        angle=found.angle_w,
        torque=torque,
        torque_of=source,
        lead=tan(own.pair.helix) * radius / found.sizes[1].reference,
        strength=strength,
        error=_error(task, torque, strength, reduction),
    )


def _torque(task: OpenTask, reduction: Any) -> tuple[float | None, str]:
    """The largest moment on the crank [N*m] and where it comes from; None: nothing loads it."""
    if task.moment is not None:
        return task.moment, MOMENT
    moment = None if reduction is None else largest_moment(reduction)
    return moment or None, REDUCTION


def _strength(task: OpenTask, torque: float | None) -> Strength | None:
    """Stresses at the given module and width, as of spur wheels; None without a torque or a material."""
    if torque is None or task.pinion is None:
        return None
    return solve_strength(tooth_sets(task.open.pair), strength_task(task, torque))


def _error(task: OpenTask, torque: float | None, found: Strength | None, reduction: Any) -> OpenError:
    """That of the extreme of the reduced moment, and what rounding adds; sigma_H goes as the root of the torque."""
    of_torque = 0.0
    if torque is not None and task.moment is None:
        of_torque = reduction.error.between * float(np.abs(reduction.parts).max()) / torque
    if torque is None or found is None:
        return OpenError(of_torque, 0.0, 0.0)
    rounding = strength_error(tooth_sets(task.open.pair), strength_task(task, torque), found)
    assert rounding is not None
    return OpenError(of_torque, rounding.contact_stress + of_torque / 2, rounding.bending_stress + of_torque)


def strength_task(task: OpenTask, torque: float) -> StrengthTask:
    """The check of the teeth for a ``torque`` [N*m] on the gear."""
    own = task.open.pair
    assert own.face_width is not None
    stage = StageTask(task.pinion, task.gear, row=task.row)
    return StrengthTask(torque / task.open.ratio, (stage,), (own.module,), (own.face_width,))
