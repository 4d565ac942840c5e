"""One tooth set in motion: Willis' equations with its numbers, its plans of velocities and of speeds."""

from __future__ import annotations

import numpy as np

from tmmcalc.core.quantity import quantity
from tmmcalc.core.records import record
from tmmcalc.gears.chosen.choice import Chosen, written_set
from tmmcalc.gears.criteria.size import centre_distances
from tmmcalc.gears.gearing import Gearing
from tmmcalc.gears.gearingtask import GearingTask, layout_task
from tmmcalc.gears.network.plans import Plans, plans
from tmmcalc.gears.network.speeds import Motion, solve_speeds
from tmmcalc.gears.network.willis import Willis, wheel_names, willis

MODULE = 1e-3  # [m] of stage 1, for want of a known one


@record
class Moving:
    """A train in motion, however it came about."""

    task: GearingTask
    motion: Motion
    chosen: Chosen | None  # None: written out mesh by mesh
    remarks: tuple[str, ...] = ()  # what was taken for want of data


@record
class Equations:
    """Willis' equations of a train."""

    speeds: tuple[float, ...] = quantity("omega[rad/s]", "speeds of the members")
    members: tuple[str, ...] = quantity("members", "names of the members")
    equations: tuple[Willis, ...]


def moving(chosen: Chosen, speed: float | None = None) -> Moving:
    """A tooth set that its driver turns at ``speed`` [rad/s], 1 rad/s without one; the driver follows from the ratio.

    >>> from tmmcalc.gears.chosen.choice import written_set
    >>> found = moving(written_set(layout_task("AIbar", (18, 48, 114))), 22.0)
    >>> round(found.motion.speed("H"), 12)
    3.0
    """
    driver = "H" if chosen.request is not None and chosen.request.kind == "i_H1" else "1"
    teeth = chosen.sets.teeth[0].tolist()
    task = layout_task(chosen.sets.layout, teeth, chosen.sets.planets, {driver: speed or 1.0})
    remarks = () if speed else (f"no speed is given: {driver} turns at 1 rad/s",)
    return Moving(task, solve_speeds(task.network, task.speeds), chosen, remarks)


def written(found: Gearing) -> Moving:
    """A train that is written out, in the motion that is known of it."""
    of_motion = tuple(remark for remark in found.task.remarks if "speed" in remark)  # others are of the losses
    return Moving(found.task, found.motion, written_set(found.task), of_motion)


def equations(found: Moving) -> Equations:
    """Willis' equation of every train of wheels on one carrier (4.19)."""
    layout = None if found.chosen is None else found.chosen.sets.scheme
    told = willis(found.task.network, found.motion, wheel_names(found.task.network, layout))
    return Equations(tuple(found.motion.speeds.tolist()), found.motion.members, told)


def plans_of(found: Moving) -> Plans:
    """Both plans, of the modules of the train; where they are not known stage 1 has 1 mm."""
    network, chosen = found.task.network, found.chosen
    if chosen is None:
        return plans(network, found.motion, coaxial=found.task.locked, assumed=MODULE)
    sets = chosen.sets
    distances = centre_distances(sets, np.array([modules_of(chosen)]), chosen.task.pressure_angle)[0].tolist()
    scheme = sets.scheme
    ends = scheme.branched and not scheme.planetary
    return plans(
        network,
        found.motion,
        distances=distances,
        coaxial=(*found.task.locked, *(((scheme.wheels[0], scheme.wheels[-1]),) if ends else ())),
        wheels=wheel_names(network, scheme),
        assumed=None if chosen.modules else MODULE,
    )


def modules_of(chosen: Chosen) -> tuple[float, ...]:
    """The modules [m] of the stages, in their proportion to 1 mm of stage 1 where they are not known."""
    parts = chosen.sets.modules[0].tolist()
    return chosen.modules or tuple(MODULE * part / parts[0] if parts[0] else MODULE for part in parts)
