"""A pinion and its rack: from the strategy to every size; the involute room counts in modules, the results in metres.

given     x1 as it is                                     balanced  0, or the least x1 without undercut if that is more
given_aw  the distance of the datum line from the axis    zero      0
"""

from __future__ import annotations

from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.core.notes import Phrase
from tmmcalc.gears.involute.quality.contact import overlap_ratio
from tmmcalc.gears.involute.rackpair import RackPair, rack_sliding
from tmmcalc.gears.involute.wheel import Wheel
from tmmcalc.gears.meshing.geometry import asked_distance, rack_of, wheel_of
from tmmcalc.gears.meshing.measures import measures
from tmmcalc.gears.meshing.rackchecks import contact_ends, nearest_shift, rack_checks
from tmmcalc.gears.meshing.refusal import millimetres, place, refuse
from tmmcalc.gears.meshing.results import LineOfAction, MeshPair, SlidingPeaks
from tmmcalc.gears.meshing.sizes import Gear, external_sizes, require_root
from tmmcalc.gears.meshing.sliding import REST, line_points, sliding_table
from tmmcalc.gears.meshing.task import PairTask

STRATEGIES = ("given", "given_aw", "zero", "balanced")


def solve_rack(task: PairTask) -> MeshPair:
    """The pair with all its sizes; raises `NoSolutionError` as `solve_pair` does."""
    shift, note = _choose(task)
    pinion = wheel_of(task, 1, shift)
    require_root(pinion, 1)
    _require_tip(task, pinion)
    pair = rack_of(task, shift)
    found = rack_checks(pair, task.limits)
    refuse(task, found, lambda: _remedy(task, shift))
    (start, end), (low, high), m = pair.segment, contact_ends(pair), task.module
    pitch = pair.pitch_curvature
    points = rack_sliding(pair, line_points(low, high, pitch, REST * max(high, pitch)))
    gear = Gear(pinion, pair.tip, float(pinion.root), pinion.reference, pair.form, low)
    left = _peaks(pair, low, high)
    return MeshPair(
        task=task,
        shifts=(shift, 0.0),
        note=note,
        broken=(),
        nearest=None,
        angle_t=pinion.transverse_angle,
        angle_w=pinion.transverse_angle,
        base_helix=pinion.section.base_helix,
        reference_distance=m * pinion.reference,
        distance=m * pair.distance if asked_distance(task) is None else float(task.distance or 0.0),
        stretch=1.0,  # the rack rolls on the reference circle, whatever the shift
        modification=shift,
        shortening=0.0,
        contact_ratio=pair.contact_ratio,
        shortened=pair.shortened,
        overlap=overlap_ratio(pinion.helix, task.width),
        line=LineOfAction(0.0, m * pitch, m * start, m * end, m * low, m * high),
        sizes=(external_sizes(task, 1, gear, start),),
        clearances=(m * pair.clearances[0], m * pair.clearances[1]),
        checks=found,
        peaks=_peaks(pair, start, end) or left,
        peaks_left=left,
        sliding=sliding_table(points, low, high, m),
        measures=(measures(task.measuring_of(1), gear),),
    )


def _choose(task: PairTask) -> tuple[float, str]:
    """x1 by the strategy, and what is to be said about it."""
    if task.strategy not in STRATEGIES:
        raise UsageError(
            f"the strategy {task.strategy} is for two wheels",
            where=place(task),
            remedy=f"strategies of a rack and pinion: {', '.join(STRATEGIES)}",
        )
    pinion = wheel_of(task, 1)
    if task.strategy == "given":
        return float(task.shifts[0] or 0.0), ""
    if task.strategy == "given_aw":
        distance = asked_distance(task)
        if distance is None:
            raise UsageError("a distance is missing", where=place(task), remedy="give centre_distance, or x1")
        return distance - pinion.reference, ""
    least = pinion.least_shift
    if task.strategy == "zero" or least <= 0:
        return 0.0, ""
    return least, Phrase("x1 = {least:.6g} is the least shift without undercut", least=least)


def _require_tip(task: PairTask, pinion: Wheel) -> None:
    """Raise `NoSolutionError` for a pinion without involute flanks."""
    m = task.module
    tip, base = m * float(pinion.plain_tip) if task.tips[0] is None else task.tips[0], m * pinion.base
    if tip > base:
        return
    raise NoSolutionError(
        f"the tip circle of gear 1, {millimetres(2 * tip)} in diameter, lies within its base circle, "
        f"{millimetres(2 * base)}",
        where=place(task),
        value=tip,
        limit=base,
        remedy=f"a tip diameter above {millimetres(2 * base)}, or a greater shift",
    )


def _remedy(task: PairTask, shift: float) -> str:
    def build(x: float) -> RackPair:
        return rack_of(task, x, asked_tips=False)

    by_rule = build(shift)
    if not any(check.verdict == "fail" for check in rack_checks(by_rule, task.limits)):
        tip, addendum = (millimetres(task.module * size) for size in (2 * by_rule.tip, by_rule.addendum))
        return f"tips by the rule: a tip diameter of {tip}, and a rack whose tip lies {addendum} above its datum line"
    near = nearest_shift(build, shift, task.limits)
    if near is None:
        return "no nearby shift makes this pair possible: more teeth or lower limits"
    distance = millimetres(task.module * build(near).distance)
    return f"the nearest admissible shift is x1 = {near:.6g}, the datum line {distance} from the axis"


def _peaks(pair: RackPair, low: float, high: float) -> SlidingPeaks | None:
    pitch = pair.pitch_curvature
    if not 0 < low < high:
        return None
    return SlidingPeaks(1 - pitch / low, 1 - high / pitch, 1 / low, 1 / pitch, 1 / high, 1 / low)
