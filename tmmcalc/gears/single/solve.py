"""A wheel without a mate: circles, limits of its shift, measures and profile."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.numerics.roots import Indices, bracketed
from tmmcalc.gears.involute.profile.form import junction
from tmmcalc.gears.involute.rack import require_tool
from tmmcalc.gears.involute.wheel import Wheel
from tmmcalc.gears.meshing.internal import ring_sizes
from tmmcalc.gears.meshing.measures import measures
from tmmcalc.gears.meshing.refusal import millimetres
from tmmcalc.gears.meshing.results import WheelSizes
from tmmcalc.gears.meshing.sizes import Gear, external_sizes, require_root
from tmmcalc.gears.meshing.task import PairTask
from tmmcalc.gears.meshing.tooth import profile_of
from tmmcalc.gears.model import Values
from tmmcalc.gears.single.errors import single_error
from tmmcalc.gears.single.member import SingleMember
from tmmcalc.gears.single.results import SingleWheel
from tmmcalc.gears.single.task import WheelTask
from tmmcalc.gears.single.verdicts import checks

OWN = (  # sizes that do not depend on a mate
    *("reference", "root", "base", "form", "thickness", "tip_thickness", "arc", "tip_arc", "half_angle"),
    *("least_shift", "least_teeth", "limit", "pointing", "strength"),
)
FARTHEST = 50.0  # [module] shifts up to which a pointed tooth is sought


def solve_single(task: WheelTask) -> SingleWheel:
    """The wheel with all its sizes.

    Raises `NoSolutionError` for a rack that is no tool, a wheel of which nothing is left within its root circle, a
    cutter that cannot make the ring, and a tip circle that is not on the side of the root circle where teeth are.

    >>> from tmmcalc.gears.meshing.task import WheelMeasuring
    >>> found = solve_single(WheelTask(27, 0.005, WheelMeasuring("1", 0.005), shift=0.31))
    >>> round(1e3 * found.tip, 3), round(1e3 * found.measures.span.length, 4), found.measures.span.teeth
    (74.05, 69.374, 5)
    """
    require_tool(task.rack)
    wheel, m, ring = task.wheel, task.module, task.kind == "internal"
    gear = gear_of_task(task)
    sizes = _sizes(task, gear)
    profile, remarks = profile_of(SingleMember(task), task.points)
    found = SingleWheel(
        task=task,
        angle_t=wheel.transverse_angle,
        base_helix=wheel.section.base_helix,
        tip=m * gear.tip,
        **{name: getattr(sizes, name) for name in OWN},
        pointed_shift=task.ring.reference - task.rack.addendum - gear.base if ring else _shift_of(wheel, 0.0),
        thin_shift=None if ring else _shift_of(wheel, task.tip_thickness_wanted),
        checks=checks(task, gear),
        measures=measures(task.measuring, gear, task.circles),
        profile=profile,
        remarks=remarks,
    )
    return replace(found, error=single_error(found))


def gear_of_task(task: WheelTask) -> Gear:
    """The wheel with its circles in modules; raises as `solve_single`, but for its rack."""
    return _ring(task) if task.kind == "internal" else _external(task)


def _external(task: WheelTask) -> Gear:
    wheel, tip = task.wheel, task.tip_radius
    require_root(wheel, 1)
    root = float(wheel.root)
    _require_teeth(task, tip, root, tip - root)
    end = float(junction(wheel, task.fillet).curvature_radius)
    return Gear(wheel, tip, root, 0.0, end, end)


def _ring(task: WheelTask) -> Gear:
    ring, tip = task.ring, task.tip_radius
    _require_teeth(task, tip, ring.root, ring.root - tip)
    if not tip > 0:
        raise NoSolutionError(
            f"teeth as high as the rack's leave the ring no hole (tip radius {tip:.4g} modules)",
            where="wheel",
            value=tip,
            limit=0.0,
            remedy="more teeth, a smaller shift, or a tip_diameter",
        )
    end = ring.curvature_at(max(ring.form, ring.base))
    return Gear(ring.signed, tip, ring.root, 0.0, end, end)


def _require_teeth(task: WheelTask, tip: float, root: float, height: float) -> None:
    """Raise `NoSolutionError` for a tip circle that leaves no teeth; ``height`` [module] is theirs."""
    if height > 0:
        return
    where, side = task.module * 2 * root, "below" if task.kind == "internal" else "above"
    raise NoSolutionError(
        f"the tip circle, {millimetres(2 * task.module * tip)} in diameter, is not {side} the root circle, "
        f"{millimetres(where)}: there are no teeth",
        where="wheel",
        value=2 * task.module * tip,
        limit=where,
        remedy=f"a tip_diameter {side} {millimetres(where)}",
    )


def _shift_of(wheel: Wheel, thickness: float) -> float | None:
    """The largest shift at which teeth of the whole height have this tip thickness [module]; None: none to 50 modules.

    From the shift that brings the tip to the reference circle on a larger one makes the tip thinner.
    """

    def spare(shift: Values, _: Indices) -> Values:
        shifted = replace(wheel, shift=shift)
        return np.asarray(shifted.thickness_at(np.maximum(shifted.plain_tip, wheel.base))) - thickness

    ends = (
        np.array([-wheel.rack.addendum]),
        np.array([FARTHEST]),
    )
    first, last = (float(spare(end, np.array([0]))[0]) for end in ends)
    return float(bracketed(spare, *ends)[0]) if first > 0 > last else None


def _sizes(task: WheelTask, gear: Gear) -> WheelSizes:
    """Sizes of the wheel as if it rolled on its reference circle, and of a tip circle within the base circle there."""
    like = PairTask((task.teeth, 0), task.module, helix=task.helix, rack=task.rack)
    rolling = replace(gear, operating=abs(gear.wheel.reference), tip=max(gear.tip, gear.base))
    if task.kind == "internal":
        return ring_sizes(like, task.ring, rolling, gear.active)
    return external_sizes(like, 1, rolling, 0.0)
