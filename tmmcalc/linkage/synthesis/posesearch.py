"""What path and motion generation share: all linkages that do exactly what is asked, or else the nearest ones."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import NamedTuple

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.notes import Phrase, listed
from tmmcalc.linkage.synthesis.designs import CLOSED
from tmmcalc.linkage.synthesis.posed import Rated, spread
from tmmcalc.linkage.synthesis.posedesign import designed
from tmmcalc.linkage.synthesis.posefit import nearest
from tmmcalc.linkage.synthesis.results import DISTANCE, TRANSMISSION, Design, SearchStep, Synthesis
from tmmcalc.linkage.synthesis.task import PoseTask, SynthesisTask

EXACT = "fewest defects; then the greatest least transmission angle"
NEAREST = "fewest defects; then the least distance from the points"


class Found(NamedTuple):
    """Linkages with their ratings, what was counted, the steps of the search."""

    linkages: list[Rated]
    counters: dict[str, int]
    course: tuple[SearchStep, ...] = ()


def search(task: SynthesisTask, kind: str, exact: Callable[[], Found] | None) -> Synthesis:
    """The designs of a path or motion, ``exact`` being how they are sought; None if there are too many points.

    Where fewer are exact than are listed, fits that happen to be exact join them; where none is, the fits themselves
    are listed. Raises `NoSolutionError` if there are none.
    """
    asked: PoseTask = task.asked
    unit = spread(asked.points)
    found, counters, course = exact() if exact else Found([], {})
    designs = _met(_designs(task, kind, found), unit)
    if len(designs) < task.solutions:
        near, fitting = nearest(task)
        fits = _designs(task, kind, near)
        designs = _distinct([*designs, *_met(fits, unit)])
        if not designs:
            nearly = Found(near, {**counters, "designs": len(fits)}, fitting)
            return _nearest(task, kind, sorted(fits, key=_by_distance), exact is not None, nearly)
    designs.sort(key=_by_transmission)
    shown = tuple(designs[: task.solutions])
    residual = max(error_of(design, unit) for design in shown)
    told = Phrase("note: the {points} {what} are met exactly", points=len(asked.points), what=_WHAT[kind])
    counters = {**counters, "designs": len(designs)}
    return Synthesis(kind, EXACT, shown, residual, (told, *_defects(shown)), counters, course)


_WHAT = {"path": "points", "motion": "poses"}
_LINKAGE = {"four_bar": "four-bar", "slider_crank": "slider-crank"}


def _nearest(task: SynthesisTask, kind: str, fits: list[Design], few: bool, found: Found) -> Synthesis:
    """The best fits; ``few`` where as many points can be met exactly by other ones."""
    asked: PoseTask = task.asked
    count, what = len(asked.points), _WHAT[kind]
    linkage = _LINKAGE[asked.mechanism]
    if not fits:
        raise NoSolutionError(
            f"no {linkage} was found that passes the {count} {what}",
            where=f"synthesis.{kind}",
            value=float(count),
            remedy=f"try another seed, leave out region, or give fewer {what}",
        )
    told = (
        Phrase(
            "warning: no {linkage} was found that meets the {count} {what} exactly: they are met in the least squares",
            linkage=linkage,
            count=count,
            what=what,
        )
        if few
        else Phrase(
            "note: {count} {what} are more than can be met exactly: they are met in the least squares",
            count=count,
            what=what,
        )
    )
    shown = tuple(fits[: task.solutions])
    return Synthesis(kind, NEAREST, shown, 0.0, (told, *_defects(shown)), found.counters, found.course)


def _designs(task: SynthesisTask, kind: str, found: list[Rated]) -> list[Design]:
    title = f"{kind} generator"
    return [design for bars, rating in found if (design := designed(task, bars, rating, title)) is not None]


def _met(designs: list[Design], unit: float) -> list[Design]:
    return [design for design in designs if error_of(design, unit) < CLOSED]


def error_of(design: Design, unit: float) -> float:
    """Largest error of a design: of angles in rad, of places in units."""
    found = design.precision
    assert found is not None
    return max(float(found.found.max()) / unit, max(map(abs, found.angle_errors), default=0.0))


def _distinct(designs: list[Design]) -> list[Design]:
    """Designs without copies of those before them."""
    kept: list[Design] = []
    for design in designs:
        if all(_apart(design, other) for other in kept):
            kept.append(design)
    return kept


def _apart(one: Design, other: Design) -> bool:
    pairs = [(a.value, b.value) for a, b in zip(one.sizes, other.sizes, strict=True) if a.unit == "m"]
    return max(abs(a - b) for a, b in pairs) > SAME * max(abs(a) for a, _ in pairs)


SAME = 1e-4  # designs whose lengths differ by less are one


def _by_transmission(design: Design) -> tuple[int, float]:
    return len(design.defects), -design.merits[TRANSMISSION.key]


def _by_distance(design: Design) -> tuple[int, float]:
    return len(design.defects), design.merits[DISTANCE.key]


def _defects(designs: tuple[Design, ...]) -> Iterator[str]:
    if designs[0].defects:
        yield Phrase("warning: the best design has a defect: {defects}", defects=listed(designs[0].defects, "; "))
