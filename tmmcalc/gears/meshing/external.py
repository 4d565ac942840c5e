"""Two external wheels: from the strategy to every size; the involute room counts in modules, the results in metres."""

from __future__ import annotations

from dataclasses import replace
from math import sin

from tmmcalc.gears.involute.pair import Pair, pair_of_shifts
from tmmcalc.gears.involute.quality.contact import Contact, contact
from tmmcalc.gears.involute.quality.existence import nearest_shifts, require_pair
from tmmcalc.gears.involute.quality.sliding import sliding, sliding_extremes
from tmmcalc.gears.involute.quality.verdicts import checks
from tmmcalc.gears.meshing.choice import choose_shifts, standing
from tmmcalc.gears.meshing.geometry import asked_distance, external_of, wheel_of
from tmmcalc.gears.meshing.measures import measures
from tmmcalc.gears.meshing.refusal import millimetres, refuse, remedy_by
from tmmcalc.gears.meshing.results import LineOfAction, MeshPair, SlidingPeaks, SlidingTable, WheelSizes
from tmmcalc.gears.meshing.sizes import Gear, external_sizes, on_base, require_root
from tmmcalc.gears.meshing.sliding import line_points, peaks_of, sliding_table
from tmmcalc.gears.meshing.task import PairTask


def solve_external(task: PairTask) -> MeshPair:
    """The pair with all its sizes; raises `NoSolutionError` as `solve_pair` does."""
    shifts, note = choose_shifts(task)
    pair = external_of(task, shifts)
    for number, wheel in enumerate(pair.wheels, 1):
        require_root(wheel, number)
    found = checks(pair, task.limits, task.width, task.fillet)
    refuse(task, found, lambda: _remedy(task, shifts))
    whole = replace(pair, tips=on_base(pair.tips, (pair.first.base, pair.second.base)))
    meeting = contact(whole, task.width, task.fillet)
    stands, m = standing(task, shifts, found), task.module
    line = _line(whole, meeting)
    table = _sliding(whole, line, m)
    left = _peaks(whole, line.begins, line.ends)
    sizes, gears = _wheels(task, pair, meeting)
    clearances = pair.clearances
    return MeshPair(
        task=task,
        shifts=shifts,
        note=note,
        broken=stands.broken,
        nearest=stands.nearest,
        angle_t=pair.first.transverse_angle,
        angle_w=float(pair.angle),
        base_helix=pair.first.section.base_helix,
        reference_distance=m * pair.reference_distance,
        distance=m * float(pair.distance) if asked_distance(task) is None else float(task.distance or 0.0),
        stretch=float(pair.stretch),
        modification=float(pair.modification),
        shortening=float(pair.shortening),
        contact_ratio=float(meeting.transverse),
        shortened=float(meeting.shortened),
        overlap=meeting.overlap,
        line=LineOfAction(
            m * line.length, m * line.pitch, m * line.start, m * line.end, m * line.begins, m * line.ends
        ),
        sizes=sizes,
        clearances=(m * float(clearances[0]), m * float(clearances[1])),
        checks=found,
        peaks=_peaks(whole, line.start, line.end) or left,
        peaks_left=left,
        sliding=table,
        measures=tuple(measures(task.measuring_of(number), gear) for number, gear in enumerate(gears, 1)),
    )


def _remedy(task: PairTask, shifts: tuple[float, float]) -> str:
    plain = external_of(task, shifts, asked_tips=False)
    tips = float(plain.tips[0]), float(plain.tips[1])
    told = remedy_by(task, lambda: require_pair(plain, task.limits, task.fillet), tips)
    if asked_distance(task) is None:
        return told
    near = nearest_shifts(plain.first, plain.second, task.limits, fillet=task.fillet)
    if near is None or not near.distance:
        return told
    first, second = (wheel_of(task, k, shift) for k, shift in enumerate(near.shifts, 1))
    distance = task.module * float(pair_of_shifts(first, second).distance)
    return f"{told}; the nearest have the centre distance {millimetres(distance)}"


def _line(pair: Pair, meeting: Contact) -> LineOfAction:
    """In modules."""
    g = float(pair.length)
    return LineOfAction(
        g,
        float(pair.operating[0]) * sin(float(pair.angle)),
        float(pair.starts[0]),
        g - float(pair.starts[1]),
        float(meeting.starts[0]),
        g - float(meeting.starts[1]),
    )


def _sliding(pair: Pair, line: LineOfAction, module: float) -> SlidingTable:
    low, high, g = line.begins, line.ends, line.length
    points = sliding(pair, line_points(low, high, line.pitch, g), (low, high))
    return sliding_table(points, low, high, module)


def _peaks(pair: Pair, low: float, high: float) -> SlidingPeaks | None:
    """Of a contact between two radii of curvature of wheel 1; None: it is not within the line of action."""
    if not 0 < low < high < float(pair.length):
        return None
    return peaks_of(sliding_extremes(pair, (low, high)))


def _wheels(task: PairTask, pair: Pair, meeting: Contact) -> tuple[tuple[WheelSizes, ...], tuple[Gear, ...]]:
    """The sizes of both, and what their measures need."""
    sizes, gears = [], []
    for k, wheel in enumerate(pair.wheels):
        operating = float(pair.operating[k])
        ends = float(meeting.forms[k]), float(meeting.starts[k])
        gear = Gear(wheel, float(pair.tips[k]), float(wheel.root), operating, *ends)
        sizes.append(external_sizes(task, k + 1, gear, float(meeting.margins[k] + meeting.forms[k])))
        gears.append(gear)
    return tuple(sizes), tuple(gears)
