"""The circles of one wheel, from modules to metres."""

from __future__ import annotations

from math import cos, hypot, isfinite, sin

import numpy as np

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.records import record
from tmmcalc.gears.involute.formfactor import tooth_form
from tmmcalc.gears.involute.wheel import Number, Wheel
from tmmcalc.gears.meshing.results import ToothStrength, WheelSizes
from tmmcalc.gears.meshing.task import PairTask


@record
class Gear:
    """A wheel and the circles that bound its flanks: positive radii in normal modules."""

    wheel: Wheel  # of a ring the one of ISO 21771, whose number of teeth and radii are negative
    tip: float  # r_a
    root: float  # r_f
    operating: float  # r_w; 0: it has no mate
    form: float  # rho_F, radius of curvature where the involute ends at the fillet
    active: float  # radius of curvature where the contact with the mate ends on it

    @property
    def base(self) -> float:
        """r_b."""
        return abs(self.wheel.base)


def on_base(tips: tuple[Number, Number], bases: tuple[float, float]) -> tuple[float, float]:
    """Tips that lie within their base circles moved out onto them: such a wheel has no involute."""
    return max(float(tips[0]), bases[0]), max(float(tips[1]), bases[1])


def require_root(wheel: Wheel, number: int) -> None:
    """Raise `NoSolutionError` for a wheel whose root circle has shrunk to nothing."""
    root = float(wheel.root)
    if root > 0:
        return
    least = float(wheel.shift) - root
    raise NoSolutionError(
        f"the shift x{number} = {float(wheel.shift):.6g} is so negative that nothing is left of the wheel within its "
        f"root circle (radius {root:.4g} modules)",
        where="involute pair",
        value=float(wheel.shift),
        limit=least,
        remedy=f"x{number} above {least:.6g}, or more teeth",
    )


def external_sizes(task: PairTask, number: int, gear: Gear, start: float) -> WheelSizes:
    """Sizes of an external wheel; ``start`` [module] is its radius of curvature where the tip of the mate meets it."""
    wheel, m, rack = gear.wheel, task.module, task.rack
    pointing, left = float(wheel.pointing), m * hypot(wheel.base, gear.active)
    thickness, tip_thickness = float(wheel.thickness_at(wheel.reference)), float(wheel.thickness_at(gear.tip))
    return WheelSizes(
        name=task.wheels[number - 1],
        kind="external",
        teeth=wheel.teeth,
        shift=float(wheel.shift),
        reference=m * wheel.reference,
        operating=m * gear.operating,
        tip=m * gear.tip,
        root=m * gear.root,
        base=m * wheel.base,
        form=m * hypot(wheel.base, gear.form),
        active=m * hypot(wheel.base, start) if start > 0 else left,
        active_left=left,
        thickness=m * thickness,
        tip_thickness=m * tip_thickness,
        arc=m * thickness / cos(wheel.helix),
        tip_arc=m * tip_thickness / cos(float(wheel.helix_at(gear.tip))),
        half_angle=float(wheel.half_angle),
        operating_half_angle=float(wheel.half_angle_at(gear.operating)),
        least_shift=wheel.least_shift,
        limit=m * float(wheel.limit),
        pointing=m * pointing if isfinite(pointing) else None,
        least_teeth=2 * (rack.straight - float(wheel.shift)) * cos(wheel.helix) / sin(wheel.transverse_angle) ** 2,
        strength=_strength(gear, m),
    )


def _strength(gear: Gear, module: float) -> ToothStrength | None:
    """The form factor with the real tip; None where there is no such section."""
    with np.errstate(all="ignore"):
        found = tooth_form(gear.wheel, gear.tip)
    values = float(found.factor), module * float(found.chord), module * float(found.arm)
    return ToothStrength(*values) if all(map(isfinite, values)) else None
