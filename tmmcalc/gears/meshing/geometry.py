"""A task and its shifts as a pair of the involute room, whose unit of length is the normal module.

The same functions build a pair while it is solved and rebuild it afterwards, so both are equal to the last bit.
"""

from __future__ import annotations

from dataclasses import replace
from math import hypot

from tmmcalc.gears.involute.internal.pair import InternalPair, Tips, internal_of_distance, internal_of_shifts
from tmmcalc.gears.involute.internal.ring import Ring
from tmmcalc.gears.involute.pair import Pair, pair_at, pair_of_shifts, sum_of_shifts
from tmmcalc.gears.involute.profile.form import junction
from tmmcalc.gears.involute.quality.existence import require_least_sum
from tmmcalc.gears.involute.rackpair import RackPair, rack_pair
from tmmcalc.gears.involute.wheel import Wheel
from tmmcalc.gears.meshing.results import MeshPair
from tmmcalc.gears.meshing.task import PairTask

RING_TIPS: Tips = "clear"  # the ring's teeth end where the pinion has an involute


def external_pair(found: MeshPair) -> Pair:
    """The external pair that was solved."""
    return external_of(found.task, found.shifts)


def internal_pair(found: MeshPair) -> InternalPair:
    """The pinion and its ring that were solved."""
    return internal_of(found.task, found.shifts)


def pinion_on_rack(found: MeshPair) -> RackPair:
    """The pinion and its rack that were solved."""
    return rack_of(found.task, found.shifts[0])


def wheel_of(task: PairTask, number: int, shift: float = 0.0) -> Wheel:
    """Wheel 1 or 2 of an external pair, or the pinion of another."""
    return Wheel(task.teeth[number - 1], shift, abs(task.helix), task.rack)


def ring_of(task: PairTask, shift: float = 0.0) -> Ring:
    """The ring of an internal pair."""
    return Ring(task.teeth[1], shift, abs(task.helix), task.rack, task.cutter)


def asked_distance(task: PairTask) -> float | None:
    """The centre distance in modules, if it is what the shifts have to give."""
    return task.distance / task.module if task.strategy == "given_aw" and task.distance is not None else None


def external_of(task: PairTask, shifts: tuple[float, float], *, asked_tips: bool = True) -> Pair:
    """The external pair with these shifts; raises `NoSolutionError` if their sum is too small."""
    first, second = wheel_of(task, 1, shifts[0]), wheel_of(task, 2, shifts[1])
    distance = asked_distance(task)
    if distance is None:
        require_least_sum(first, second)
        pair = pair_of_shifts(first, second)
    else:
        pair = pair_at(first, second, float(sum_of_shifts(first, second, distance)[1]), distance)
    plain = float(pair.tips[0]), float(pair.tips[1])
    return replace(
        pair, angle=float(pair.angle), distance=float(pair.distance), tips=_tips(task, plain) if asked_tips else plain
    )


def internal_of(task: PairTask, shifts: tuple[float, float], *, asked_tips: bool = True) -> InternalPair:
    """The pinion and ring with these shifts; raises as `internal_of_shifts` does."""
    pinion, ring = wheel_of(task, 1, shifts[0]), ring_of(task, shifts[1])
    distance = asked_distance(task)
    if distance is None:
        pair = internal_of_shifts(pinion, ring, RING_TIPS)
    else:
        pair = internal_of_distance(pinion, ring, distance, RING_TIPS)
    return replace(pair, tips=_tips(task, clear_tips(task, pair)) if asked_tips else clear_tips(task, pair))


def clear_tips(task: PairTask, pair: InternalPair) -> tuple[float, float]:
    """Tips of an internal pair by the rule, the ring's clear of the fillet that the task's rounding cuts."""
    if task.fillet == "ellipse":
        return pair.tips
    form = float(junction(pair.pinion, task.fillet).curvature_radius)
    return pair.tips[0], max(pair.tips[1], hypot(pair.ring.base, pair.length + form))


def rack_of(task: PairTask, shift: float, *, asked_tips: bool = True) -> RackPair:
    """The pinion with this shift on its rack, whose second tip is the height above its datum line."""
    rack = task.rack
    # a rounding slightly too large for its rack, such as 0.38, leaves straight flanks slightly shorter than h_a*
    usual = min(rack.addendum, rack.straight)
    pinion = wheel_of(task, 1, shift)
    tip, addendum = _tips(task, (float(pinion.plain_tip), usual)) if asked_tips else (None, usual)
    return rack_pair(pinion, addendum, tip, task.fillet)


def _tips(task: PairTask, plain: tuple[float, float]) -> tuple[float, float]:
    """Tips as asked, else by the rule."""
    first, second = (
        rule if asked is None else asked / task.module for asked, rule in zip(task.tips, plain, strict=True)
    )
    return first, second
