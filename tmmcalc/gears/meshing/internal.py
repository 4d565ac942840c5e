"""A pinion in a ring: from the strategy to every size; the involute room counts in modules, the results in metres."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from math import cos, hypot, sin

import numpy as np

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.notes import Phrase, listed
from tmmcalc.gears.involute.internal.contact import (
    InternalContact,
    internal_contact,
    internal_extremes,
    internal_sliding,
)
from tmmcalc.gears.involute.internal.margins import internal_margins, nearest_internal
from tmmcalc.gears.involute.internal.pair import InternalPair
from tmmcalc.gears.involute.internal.ring import Ring, angle_of_distance, check_teeth
from tmmcalc.gears.involute.internal.shifts import InternalChoice, choose_internal
from tmmcalc.gears.involute.internal.verdicts import internal_checks, require_internal
from tmmcalc.gears.involute.profile.form import junction
from tmmcalc.gears.involute.quality.verdicts import NOISE, Check, QualityLimits, Verdict
from tmmcalc.gears.meshing.choice import Standing, known_shifts, sound, strictly
from tmmcalc.gears.meshing.cutting import NAMES, blamed, cut_short, cutter_checks, cutter_remedy
from tmmcalc.gears.meshing.distances import nearest_distance, require_sum
from tmmcalc.gears.meshing.geometry import RING_TIPS, asked_distance, internal_of, ring_of, wheel_of
from tmmcalc.gears.meshing.measures import measures
from tmmcalc.gears.meshing.refusal import millimetres, refuse, remedy_by, require_distance
from tmmcalc.gears.meshing.results import LineOfAction, MeshPair, SlidingPeaks, SlidingTable, WheelSizes
from tmmcalc.gears.meshing.sizes import Gear, external_sizes, on_base, require_root
from tmmcalc.gears.meshing.sliding import REST, line_points, peaks_of, sliding_table
from tmmcalc.gears.meshing.task import PairTask


def solve_internal(task: PairTask) -> MeshPair:
    """The pair with all its sizes; raises `NoSolutionError` as `solve_pair` does."""
    check_teeth(wheel_of(task, 1), ring_of(task))
    shifts, note = _choose(task)
    require_sum(task, shifts)
    pair = internal_of(task, shifts)
    require_root(pair.pinion, 1)
    judged = internal_checks(pair, task.limits, task.width, task.fillet)
    found = blamed((*cutter_checks(task, pair), *judged, _undercut(task, shifts[0])))
    refuse(task, found, lambda: _remedy(task, shifts, found))
    stands = _standing(task, shifts, found)
    whole = replace(pair, tips=on_base(pair.tips, (pair.pinion.base, pair.ring.base)))
    meeting = internal_contact(whole, task.width, task.fillet)
    table, left = _sliding(whole, meeting, task.module), _peaks(whole, meeting.segment)
    sizes, gears = _wheels(task, whole, pair.tips, meeting)
    m = task.module
    return MeshPair(
        task=task,
        shifts=shifts,
        note=listed([text for text in (note, cut_short(pair, m), _shortened(pair, m)) if text], "; "),
        broken=stands.broken,
        nearest=stands.nearest,
        angle_t=pair.pinion.transverse_angle,
        angle_w=pair.angle,
        base_helix=pair.pinion.section.base_helix,
        reference_distance=m * pair.reference_distance,
        distance=m * pair.distance if asked_distance(task) is None else float(task.distance or 0.0),
        stretch=pair.distance / pair.reference_distance,
        modification=pair.modification,
        shortening=shifts[0] + shifts[1] + pair.modification,
        contact_ratio=meeting.transverse,
        shortened=meeting.shortened,
        overlap=meeting.overlap,
        line=_line(whole, meeting, m),
        sizes=sizes,
        clearances=(m * pair.clearances[0], m * pair.clearances[1]),
        checks=found,
        peaks=_peaks(whole, whole.segment) or left,
        peaks_left=left,
        sliding=table,
        measures=tuple(measures(task.measuring_of(number), gear) for number, gear in enumerate(gears, 1)),
    )


def _choose(task: PairTask) -> tuple[tuple[float, float], str]:
    """x1, x2 by the strategy, and what it could not give; undercut is allowed only if there is no way without it."""
    total = _sum(task)
    known = known_shifts(task, total)
    if known is not None:
        return known, ""
    tolerated = task.limits.undercut
    try:
        try:
            found = _choice(task, replace(task.limits, undercut=tolerated and not task.strict))
        except NoSolutionError:
            if not (tolerated and task.strict):
                raise
            found = _choice(task, task.limits)
            said = [text for text in ("undercut could not be avoided", found.note) if text]
            return (found.x1, found.x2), listed(said, "; ")
    except NoSolutionError as error:
        if task.refuse or total is None:
            raise
        return (0.0, total), Phrase("{message}; the ring takes all of x1 + x2", message=error.message)
    return (found.x1, found.x2), found.note


def _choice(task: PairTask, limits: QualityLimits) -> InternalChoice:
    distance = None if task.distance is None else task.distance / task.module
    pinion, ring = wheel_of(task, 1), ring_of(task)
    return choose_internal(
        pinion,
        ring,
        task.strategy,
        distance=distance,
        split=task.split,
        limits=limits,
        fillet=task.fillet,
        tips=RING_TIPS,
    )


def _sum(task: PairTask) -> float | None:
    """x1 + x2, where the strategy fixes it."""
    if task.strategy != "given_aw":
        return 0.0 if task.strategy in ("equal_shift", "balanced") else None
    pinion, ring = wheel_of(task, 1), ring_of(task)
    distance = require_distance(task, ring.base - pinion.base, "difference", lambda: nearest_distance(task))
    return angle_of_distance(pinion, ring, distance)[0]


def _standing(task: PairTask, shifts: tuple[float, float], checks: Sequence[Check]) -> Standing:
    """Which conditions the shifts do not meet with tips by the rule."""
    if sound(task, checks):
        return Standing((), None)
    limits = replace(task.limits, undercut=not strictly(task))
    pinion, ring = wheel_of(task, 1, shifts[0]), ring_of(task, shifts[1])
    at = np.array([shifts[0]]), np.array([shifts[1]])
    broken = internal_margins(pinion, ring, *at, limits, task.fillet, RING_TIPS).broken()
    near = nearest_internal(pinion, ring, limits, None, task.fillet, RING_TIPS) if broken else None
    return Standing(broken, None if near is None else near.shifts)


def _undercut(task: PairTask, shift: float) -> Check:
    least = wheel_of(task, 1).least_shift
    if shift >= least - NOISE:
        return Check("undercut", 1, shift, least, shift - least, "ok", "")
    verdict: Verdict = "warn" if task.limits.undercut else "fail"
    text = Phrase("gear 1 is undercut: x1 = {shift:.4g} below {least:.4g}", shift=shift, least=least)
    return Check("undercut", 1, shift, least, shift - least, verdict, text)


def _remedy(task: PairTask, shifts: tuple[float, float], found: Sequence[Check]) -> str:
    broken = {check.name: check for check in found if check.verdict == "fail"}
    cut = broken.pop("undercut", None)
    told = [] if cut is None else [f"x1 of at least {cut.limit:.6g}, or undercut tolerated"]
    of_cutter = [name for name in NAMES if broken.pop(name, None) is not None]
    if of_cutter:
        told.append(cutter_remedy(task, internal_of(task, shifts), of_cutter))
    # a ring that its cutter spoils says nothing about the shifts
    if broken and not {"cutter tip", "cutter depth"} & {*of_cutter}:
        plain = internal_of(task, shifts, asked_tips=False)
        told.append(
            remedy_by(task, lambda: require_internal(plain, task.limits, RING_TIPS, task.fillet), plain.tips),
        )
    return "; ".join(told)


def _shortened(pair: InternalPair, module: float) -> str:
    """What the rule takes from the teeth of the ring."""
    cut = pair.tips[1] - pair.ring.plain_tip
    if cut <= NOISE:
        return ""
    return Phrase(
        "the teeth of the ring are {cut} shorter than the rack's, to clear the pinion's fillet",
        cut=millimetres(cut * module),
    )


def _line(pair: InternalPair, meeting: InternalContact, module: float) -> LineOfAction:
    return LineOfAction(
        -module * pair.length,
        module * pair.operating[0] * sin(pair.angle),
        module * pair.segment[0],
        module * pair.segment[1],
        module * meeting.segment[0],
        module * meeting.segment[1],
    )


def _sliding(pair: InternalPair, meeting: InternalContact, module: float) -> SlidingTable:
    low, high = meeting.segment
    pitch = pair.operating[0] * sin(pair.angle)
    points = internal_sliding(pair, line_points(low, high, pitch, REST * max(high, pitch)), (low, high))
    return sliding_table(points, low, high, module)


def _peaks(pair: InternalPair, segment: tuple[float, float]) -> SlidingPeaks | None:
    """Of a contact between two radii of curvature of the pinion; None: it is not on the line of action."""
    return peaks_of(internal_extremes(pair, segment)) if 0 < segment[0] < segment[1] else None


def _wheels(
    task: PairTask, pair: InternalPair, tips: tuple[float, float], meeting: InternalContact
) -> tuple[tuple[WheelSizes, WheelSizes], tuple[Gear, Gear]]:
    """Sizes of pinion and ring, and what their measures need."""
    low, high = meeting.segment
    pinion, ring, (first, second) = pair.pinion, pair.ring, pair.operating
    form = float(junction(pinion, task.fillet).curvature_radius)
    inner = Gear(pinion, tips[0], float(pinion.root), first, form, low)
    last, reach = high + pair.length, pair.starts[1]
    outer = Gear(ring.signed, tips[1], ring.root, second, ring.curvature_at(max(ring.form, ring.base)), last)
    return (external_sizes(task, 1, inner, pair.starts[0]), ring_sizes(task, ring, outer, reach)), (inner, outer)


def ring_sizes(task: PairTask, ring: Ring, gear: Gear, reach: float) -> WheelSizes:
    """Sizes of the ring; ``reach`` is its radius of curvature where the tip of the pinion leaves it, in modules."""
    m = task.module
    thickness, tip_thickness = ring.thickness_at(ring.reference), ring.thickness_at(gear.tip)
    return WheelSizes(
        name=task.wheels[1],
        kind="ring",
        teeth=ring.teeth,
        shift=ring.shift,
        reference=m * ring.reference,
        operating=m * gear.operating,
        tip=m * gear.tip,
        root=m * ring.root,
        base=m * ring.base,
        form=m * ring.form,
        active=m * hypot(ring.base, reach),
        active_left=m * hypot(ring.base, gear.active),
        thickness=m * thickness,
        tip_thickness=m * tip_thickness,
        arc=m * thickness / cos(ring.helix),
        tip_arc=m * tip_thickness / cos(float(ring.signed.helix_at(gear.tip))),
        half_angle=ring.half_angle_at(ring.reference),
        operating_half_angle=ring.half_angle_at(gear.operating),
        least_shift=None,
        limit=None,
        pointing=None,
        least_teeth=None,
        strength=None,
    )
