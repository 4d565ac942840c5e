"""Why a synthesis found nothing, in words: what removed the last candidates, what would help."""

from __future__ import annotations

import math
from collections.abc import Callable
from fractions import Fraction
from typing import TYPE_CHECKING

from tmmcalc.core.notes import Phrase
from tmmcalc.gears.kinds import from_tooth_ratio
from tmmcalc.gears.model import ToothSets
from tmmcalc.gears.search.measures import tooth_ratio
from tmmcalc.gears.search.relaxation import Relaxation

if TYPE_CHECKING:
    from tmmcalc.gears.trains import Request, Variant

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
    "equal_pinions",
    "assembly",
    "adjacency",
    "coprime",
    "centre_distance",
    "envelope",
)
CALLED = {
    "largest_sum": "sum of teeth",
    "coaxiality": "common axis",
    "ratio": "ratio",
    "mesh_angles": "pressure angles",
    "undercut": "undercut",
    "interference": "ring difference",
    "stage_ratio": "ratio of one stage",
    "diameter_band": "diameters alike",
    "equal_pinions": "equal pinions",
    "assembly": "assembly",
    "adjacency": "neighbours' gap",
    "coprime": "coprime meshes",
    "centre_distance": "centre distance",
    "envelope": "envelope",
}


def called(name: str) -> str:
    """A constraint in words; one of the user's own is called as it is."""
    return CALLED.get(name, name)


def removals(variant: Variant) -> list[tuple[str, int, int]]:
    """Constraint, how many candidates it removed, and of how many, in the order in which they are put."""
    removed = variant.synthesis.removed
    names = list(ORDER)
    if variant.request.scheme.branched and variant.request.scheme.stages == 1:
        names[:3] = ["ratio", "coaxiality", "largest_sum"]
    left, found = variant.synthesis.candidates, []
    for name in (*names, *(name for name in removed if name not in ORDER)):
        if removed.get(name):
            found.append((name, removed[name], left))
            left -= removed[name]
    return found


def why_none(variant: Variant) -> list[str]:
    """What removed the last candidates, with all counts."""
    request = variant.request
    steps = removals(variant)
    if not steps:
        lines: list[str] = [Phrase("{title}: the tooth limits leave no candidates", title=request.title)]
        if request.method == "textbook":
            lines = [Phrase("{title}: the textbook's program finds no tooth set", title=request.title)]
    else:
        name, count, _ = steps[-1]
        lines = [
            Phrase(
                "{title}: no tooth set; {condition} removed the last {count} of {candidates}",
                title=request.title,
                condition=called(name),
                count=count,
                candidates=variant.synthesis.candidates,
            )
        ]
        if len(steps) > 1:
            removed = [
                Phrase("{condition} {number}", condition=called(each), number=number) for each, number, _ in steps
            ]
            lines.append(Phrase("removed: {removed}", removed=removed))
    end = _end_of_range(variant)
    return [*lines, end] if end else lines


def _end_of_range(variant: Variant) -> str:
    """The least or the greatest ratio that everything else admits, if the one asked for lies beyond it."""
    request = variant.request
    ratios = [_ratio(request, change) for change in variant.relaxations if change.constraint == "ratio"]
    if len(ratios) != 1 or ratios[0] is None:
        return ""
    text = "{kind} = {ratio:.6g} is the greatest that everything else admits"
    if ratios[0] > request.nominal:
        text = "{kind} = {ratio:.6g} is the least that everything else admits"
    return Phrase(text, kind=request.kind, ratio=float(ratios[0]))


def remedies(variant: Variant) -> list[str]:
    """One line a change that would give sets."""
    if variant.request.task.teeth is not None:
        return ["leave teeth out, and all sets that keep the constraints are sought"]
    found = [words for change in variant.relaxations if (words := _words(variant.request, change))]
    return found or ["no single limit gives a set: change several, or choose another layout"]


def _of_kind(request: Request, ratio: Fraction) -> Fraction | None:
    return from_tooth_ratio(request.scheme, request.kind, ratio)


def _words(request: Request, change: Relaxation) -> str:
    change_of_key = _CHANGES[change.constraint](request, change)
    teeth = "/".join(map(str, change.teeth))
    return Phrase("{change} gives {teeth}", change=change_of_key, teeth=teeth) if change_of_key else ""


def _key(key: str) -> Callable[[Request, Relaxation], str]:
    return lambda request, change: _widened(key, f"{change.present:.0f}", f"{change.needed:.0f}")


def _widened(key: str, present: str, needed: str) -> Phrase:
    """A key of the spec with its value and the one that would do."""
    return Phrase("{key} {present} -> {needed}", key=key, present=present, needed=needed)


def _off(key: str) -> Callable[[Request, Relaxation], str]:
    return lambda request, change: Phrase("{key} = false", key=key)


def _tolerance(request: Request, change: Relaxation) -> str:
    """The deviation of the nearest ratio in its own kind and as its tolerance is put."""
    ratio = _ratio(request, change)
    if ratio is None:
        return ""  # the driven wheel would stand still
    present = max(request.admitted.high - request.nominal, request.nominal - request.admitted.low)
    scale, unit = (100 / abs(request.nominal), " %") if request.relative else (Fraction(1), "")
    sizes = (float(present * scale), float(abs(ratio - request.nominal) * scale))
    widened = _widened("tolerance", *(f"{_up(size):.3g}{unit}" for size in sizes))
    return Phrase("{widened} ({kind} = {ratio:.6g})", widened=widened, kind=request.kind, ratio=float(ratio))


def _ratio(request: Request, change: Relaxation) -> Fraction | None:
    """The ratio of the set that a change gives, in the kind that was asked for."""
    numerator, denominator = (int(part[0]) for part in tooth_ratio(_one(request, change)))
    return _of_kind(request, Fraction(numerator, denominator))


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
    needed = max(math.ceil(1000 * change.needed - 1e-6) - 1, 0) / 1000
    return _widened("adjacency_gap", f"{change.present:g}", f"{needed:g}")


def _undercut(request: Request, change: Relaxation) -> str:
    return Phrase("undercut = false, with wheels of {needed:.0f} teeth,", needed=change.needed)


def _distance(request: Request, change: Relaxation) -> str:
    shorter = change.needed < change.present
    end = math.floor(1e5 * change.needed) / 100 if shorter else math.ceil(1e5 * change.needed) / 100
    return _widened("centre_distance", f"{1000 * change.present:g} mm", f"{end:g} mm")


def _limit(key: str, scale: float = 1.0, unit: str = "") -> Callable[[Request, Relaxation], str]:
    return lambda request, change: _widened(
        key, f"{scale * change.present:g}{unit}", f"{_up(scale * change.needed, 4):g}{unit}"
    )


def _mesh(request: Request, change: Relaxation) -> str:
    return Phrase('mesh_angle_max = "{needed:g} deg"', needed=math.ceil(100 * math.degrees(change.needed)) / 100)


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
