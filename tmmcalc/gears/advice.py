"""Why a synthesis found nothing, in words: what removed the last candidates, what would help."""

from __future__ import annotations

import math
from collections.abc import Callable
from fractions import Fraction
from typing import TYPE_CHECKING

from tmmcalc.gears.bounds import single_planet_limits
from tmmcalc.gears.kinds import from_tooth_ratio
from tmmcalc.gears.model import Interval, ToothSets, TrainTask
from tmmcalc.gears.search.measures import tooth_ratio
from tmmcalc.gears.search.relaxation import Relaxation

if TYPE_CHECKING:
    from tmmcalc.gears.train import Request, Variant

# in the order in which they are put; trains with one module begin with the ratio
ORDER = (
    "largest_sum",
    "coaxiality",
    "ratio",
    "mesh_angles",
    "undercut",
    "interference",
    "stage_ratio",
    "diameter_band",
    "assembly",
    "adjacency",
    "coprime",
    "centre_distance",
    "envelope",
)
RATIO_FIRST = ("AIbar", "2A-AA")

CALLED = {
    "largest_sum": "sum of teeth",
    "coaxiality": "common axis",
    "ratio": "ratio",
    "mesh_angles": "pressure angles",
    "undercut": "undercut",
    "interference": "ring difference",
    "stage_ratio": "ratio of one stage",
    "diameter_band": "diameters alike",
    "assembly": "assembly",
    "adjacency": "neighbours' gap",
    "coprime": "coprime meshes",
    "centre_distance": "centre distance",
    "envelope": "envelope",
}


def removals(variant: Variant) -> list[tuple[str, int, int]]:
    """Constraint, how many candidates it removed, and of how many, in the order in which they are put."""
    removed = variant.synthesis.removed
    names = list(ORDER)
    if variant.request.task.layout in RATIO_FIRST:
        names[:3] = ["ratio", "coaxiality", "largest_sum"]
    left, found = variant.synthesis.candidates, []
    for name in (*names, *(name for name in removed if name not in ORDER)):
        if removed.get(name):
            found.append((name, removed[name], left))
            left -= removed[name]
    return found


def why_none(variant: Variant) -> list[str]:
    """What removed the last candidates, with all counts, and the ratios of the layout if the one asked for is none."""
    request = variant.request
    steps = removals(variant)
    if not steps:
        lines = [f"{request.title}: the tooth limits leave no candidates"]
        if request.method == "textbook":
            lines = [f"{request.title}: the textbook's program finds no tooth set"]
    else:
        name, count, _ = steps[-1]
        lines = [
            f"{request.title}: no tooth set; {CALLED[name]} removed the last {count} of {variant.synthesis.candidates}"
        ]
        if len(steps) > 1:
            lines.append("removed: " + ", ".join(f"{CALLED[each]} {number}" for each, number, _ in steps))
    beyond = out_of_range(request)
    return [*lines, beyond] if beyond else lines


def remedies(variant: Variant) -> list[str]:
    """One line a change that would give sets."""
    found = [words for change in variant.relaxations if (words := _words(variant.request, change))]
    return found or ["no single limit gives a set: change several, or choose another layout"]


def out_of_range(request: Request) -> str:
    """The ratios that the layout has within its tooth limits, if the one asked for is not among them; else nothing."""
    task = request.task
    limits = ratio_limits(task)
    if limits is None or (limits.low <= task.ratio.high and task.ratio.low <= limits.high):
        return ""
    low, high = (_of_kind(request, end) for end in (limits.low, limits.high))
    known = " to ".join(f"{float(end):.4g}" for end in sorted(end for end in (low, high) if end is not None))
    return f"with these limits {request.title} has {request.kind} of about {known}"


def ratio_limits(task: TrainTask) -> Interval | None:
    """Tooth ratios that limits of teeth admit, with coaxiality and neighbourhood of AIbar; None: no such bounds."""
    limits, layout = task.limits, task.layout
    if layout == "AII":
        return None
    if not task.scheme.branched:
        pinion, stages = min(limits.largest_pinion, limits.largest), task.scheme.stages
        least, most = Fraction(limits.least, pinion), Fraction(limits.largest, limits.least)
        if task.demands.stage_ratio is not None:
            least, most = max(least, Fraction(1)), min(most, task.demands.stage_ratio)
        return Interval(least**stages, most**stages)
    ends = dict.fromkeys(task.scheme.rings, (limits.least_ring, limits.largest_ring))
    teeth = [ends.get(wheel, (limits.least, limits.largest)) for wheel in task.scheme.wheels]
    if layout in RATIO_FIRST:
        teeth = [teeth[0], teeth[-1]]
    low, high = Fraction(1), Fraction(1)
    for (small, large), (least_wheel, most_wheel) in zip(teeth[::2], teeth[1::2], strict=True):
        low, high = low * Fraction(least_wheel, large), high * Fraction(most_wheel, small)
    return (
        _single(task, low, high)
        if layout in RATIO_FIRST and task.demands.largest_angle is None
        else Interval(low, high)
    )


def _single(task: TrainTask, low: Fraction, high: Fraction) -> Interval:
    """Coaxiality Z3 = Z1 + 2 Z2 (of 2A-AA Z4) makes U greater than 1; crowded planets bound it from above (4.33)."""
    limits = task.limits
    low = max(low, 1 + Fraction(2 * limits.least, limits.largest))
    permissible = single_planet_limits(task.planets).permissible if task.planets > 2 else None
    if permissible is not None and task.demands.gap is not None:
        high = min(high, Fraction(permissible))
    return Interval(low, high)


def _of_kind(request: Request, ratio: Fraction) -> Fraction | None:
    return from_tooth_ratio(request.scheme, request.kind, ratio)


def _words(request: Request, change: Relaxation) -> str:
    change_of_key = _CHANGES[change.constraint](request, change)
    return f"{change_of_key} gives {'/'.join(map(str, change.teeth))}" if change_of_key else ""


def _key(key: str) -> Callable[[Request, Relaxation], str]:
    return lambda request, change: f"{key} {change.present:.0f} -> {change.needed:.0f}"


def _off(key: str) -> Callable[[Request, Relaxation], str]:
    return lambda request, change: f"{key} = false"


def _tolerance(request: Request, change: Relaxation) -> str:
    """The deviation of the nearest ratio in its own kind and as its tolerance is put."""
    sets = _one(request, change)
    numerator, denominator = (int(part[0]) for part in tooth_ratio(sets))
    ratio = _of_kind(request, Fraction(numerator, denominator))
    if ratio is None:
        return ""  # the driven wheel would stand still
    present = max(request.admitted.high - request.nominal, request.nominal - request.admitted.low)
    scale, unit = (100 / abs(request.nominal), " %") if request.relative else (Fraction(1), "")
    sizes = (float(present * scale), float(abs(ratio - request.nominal) * scale))
    widened = " -> ".join(f"{_up(size):.3g}{unit}" for size in sizes)
    return f"tolerance {widened} ({request.kind} = {float(ratio):.6g})"


def _one(request: Request, change: Relaxation) -> ToothSets:
    import numpy as np

    task = request.task
    teeth = np.array([change.teeth], np.int64)
    scheme = task.scheme
    modules, angles = np.zeros((1, scheme.stages), np.int64), np.zeros((1, len(scheme.meshes)))
    return ToothSets(task.layout, teeth, modules, angles, task.planets)


def _up(value: float, digits: int = 3) -> float:
    """Rounded up to some digits: a limit widened so far admits what it has to."""
    if not value:
        return 0.0
    unit = 10.0 ** (math.floor(math.log10(abs(value))) - digits + 1)
    return math.ceil(value / unit * (1 - 1e-9)) * unit


def _gap(request: Request, change: Relaxation) -> str:
    """Rounded down, and a little less where it is met exactly: the neighbours' condition is strict."""
    return f"adjacency_gap {change.present:g} -> {max(math.ceil(1000 * change.needed - 1e-6) - 1, 0) / 1000:g}"


def _undercut(request: Request, change: Relaxation) -> str:
    return f"undercut = false, with wheels of {change.needed:.0f} teeth,"


def _distance(request: Request, change: Relaxation) -> str:
    shorter = change.needed < change.present
    end = math.floor(1e5 * change.needed) / 100 if shorter else math.ceil(1e5 * change.needed) / 100
    return f"centre_distance {1000 * change.present:g} mm -> {end:g} mm"


def _limit(key: str, scale: float = 1.0, unit: str = "") -> Callable[[Request, Relaxation], str]:
    return lambda request, change: f"{key} {scale * change.present:g}{unit} -> {_up(scale * change.needed, 4):g}{unit}"


def _mesh(request: Request, change: Relaxation) -> str:
    return f'mesh_angle_max = "{math.ceil(100 * math.degrees(change.needed)) / 100:g} deg"'


_CHANGES: dict[str, Callable[[Request, Relaxation], str]] = {
    "ratio": _tolerance,
    "largest": _key("z_max"),
    "least": _key("z_min"),
    "largest_ring": _key("ring_max"),
    "least_ring": _key("ring_min"),
    "largest_pinion": _key("z_pinion_max"),
    "largest_sum": _key("sum_max"),
    "planets": _key("planets"),
    "adjacency": _gap,
    "interference": _key("ring_difference"),
    "undercut": _undercut,
    "stage_ratio": _limit("stage_ratio_max"),
    "diameter_band": _limit("diameter_band"),
    "assembly": _off("assembly"),
    "coprime": _off("coprime"),
    "equal_pinions": _off("equal_pinions"),
    "centre_distance": _distance,
    "envelope": _limit("envelope", 1000.0, " mm"),
    "mesh_angles": _mesh,
}
