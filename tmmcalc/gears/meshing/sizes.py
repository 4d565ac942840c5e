"""The circles of one wheel, from modules to metres."""

from __future__ import annotations

from math import hypot, isfinite

from tmmcalc.errors import NoSolutionError
from tmmcalc.gears.involute.wheel import Number, Wheel
from tmmcalc.gears.meshing.results import WheelSizes
from tmmcalc.gears.meshing.task import PairTask
from tmmcalc.records import record


@record
class Gear:
    """A wheel and the circles that bound its flanks: positive radii in normal modules."""

    wheel: Wheel  # of a ring the one of ISO 21771, whose number of teeth and radii are negative
    tip: float  # r_a
    root: float  # r_f
    operating: float  # r_w
    form: float  # rho_F, radius of curvature where the involute ends at the fillet

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


def external_sizes(task: PairTask, number: int, gear: Gear, active: float) -> WheelSizes:
    """Sizes of an external wheel; ``active`` is r_p in modules."""
    wheel, m = gear.wheel, task.module
    pointing = float(wheel.pointing)
    return WheelSizes(
        task.wheels[number - 1],
        "external",
        wheel.teeth,
        float(wheel.shift),
        m * wheel.reference,
        m * gear.operating,
        m * gear.tip,
        m * gear.root,
        m * wheel.base,
        m * hypot(wheel.base, gear.form),
        m * active,
        m * float(wheel.thickness_at(wheel.reference)),
        m * float(wheel.thickness_at(gear.tip)),
        wheel.least_shift,
        m * float(wheel.limit),
        m * pointing if isfinite(pointing) else None,
    )
