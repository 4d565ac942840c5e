"""Choice of the shifts x1, x2 of a pair by the rules of a course project, each checked against the contour."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.core.notes import Phrase
from tmmcalc.core.records import record
from tmmcalc.gears.involute.contour.bounds import Flags
from tmmcalc.gears.involute.contour.contour import Contour, contour
from tmmcalc.gears.involute.contour.equalstrength import strength_split
from tmmcalc.gears.involute.contour.interval import interval
from tmmcalc.gears.involute.contour.margins import Margins, margins
from tmmcalc.gears.involute.contour.points import (
    ZOOM,
    deepest,
    equal_sliding,
    held,
    largest_equal_strength,
    largest_sum,
    sliding_split,
)
from tmmcalc.gears.involute.contour.task import LINES, Task
from tmmcalc.gears.involute.pair import sum_from_distance
from tmmcalc.gears.involute.strategies import DESIRED, STRATEGIES, Split
from tmmcalc.gears.model import Values

NARROWING = 5  # rounds, each eight times finer
ROUNDING = 1e-9  # by which a point on the contour itself may miss it


@record
class Choice:
    """Chosen shifts and where they stand."""

    strategy: str
    x1: float
    x2: float
    margins: Margins  # of this point, arrays of shape ()
    inside: bool  # of the asked contour
    broken: tuple[str, ...]  # keys of LINES whose conditions are not met
    nearest: tuple[float, float] | None  # nearest admissible shifts, of a point outside a contour that is not empty
    note: str  # what the strategy had to give up, or empty


def choose(
    task: Task,
    strategy: str,
    *,
    strict: bool = True,
    x1: float | None = None,
    x2: float | None = None,
    distance: float | None = None,
    split: Split = "equal_sliding",
    desired: float = DESIRED,
) -> Choice:
    """The shifts by one of STRATEGIES; ``distance`` in normal modules, ``desired`` is the contact ratio of D.

    ``given`` and ``zero`` are told where they stand; the others raise `NoSolutionError` where nothing is admissible.

    >>> from tmmcalc.gears.involute.wheel import Wheel
    >>> found = choose(Task(Wheel(14), Wheel(17)), "equal_sliding")
    >>> round(found.x1, 4), round(found.x2, 4)
    (0.4842, 0.436)
    """
    if strategy not in STRATEGIES:
        raise UsageError(
            f"there is no strategy {strategy!r}", where="shifts", remedy=f"strategies: {', '.join(STRATEGIES)}"
        )
    if strategy == "given":
        if x1 is None or x2 is None:
            raise UsageError("the strategy given needs both shifts", where="shifts", remedy="give x1 and x2")
        return _judged(task, strategy, strict, x1, x2)
    if strategy == "zero":
        return _judged(task, strategy, strict, 0.0, 0.0)
    area = contour(task, strict, pieces=False)
    if strategy in ("given_aw", "equal_shift"):
        total = 0.0 if strategy == "equal_shift" else _sum(task, distance)
        return _on_sum(area, strategy, total, x1, x2, split)
    note = ""
    if strategy == "equal_sliding":
        one, two, note = _sliding(area, desired)
    elif strategy == "equal_strength":
        one, two = _strength(area)
    elif strategy == "max_contact_ratio" and area.region:
        one, two, _ = area.best
    else:
        one, two = largest_sum(area) if strategy == "max_contact_strength" else deepest(area)[:2]
    return _judged(task, strategy, strict, one, two, note=note)


def nearest(area: Contour, x1: float, x2: float) -> tuple[float, float]:
    """The admissible point of the main region nearest to a point outside."""
    edge1, edge2 = area.region.outline
    start, run = np.column_stack((edge1, edge2))[:-1], np.column_stack((np.diff(edge1), np.diff(edge2)))
    to = np.array([x1, x2]) - start
    t = np.clip(np.sum(to * run, axis=1) / np.maximum(np.sum(run * run, axis=1), 1e-300), 0.0, 1.0)
    foot = start + t[:, None] * run
    best = foot[int(np.argmin(np.sum((foot - (x1, x2)) ** 2, axis=1)))]
    # the chord may leave a hollow edge: keep the sum and step back between its ends
    total, (least, most) = float(best.sum()), area.region.ends
    if not least < total < most:
        return float(best[0]), float(best[1])
    ends = interval(area.frame, total, area.strict, region=area.region, near=float(best[0]))
    one = min(max(float(best[0]), ends.low), ends.high)
    return one, total - one


def _judged(
    task: Task,
    strategy: str,
    strict: bool,
    x1: float,
    x2: float,
    note: str = "",
) -> Choice:
    found = margins(task, x1, x2)
    inside = bool(found.least(strict) >= -ROUNDING)
    broken = () if inside else found.broken(strict)
    near = None
    if not inside:
        area = contour(task, strict, pieces=False)
        near = nearest(area, x1, x2) if area.main is not None else None
    return Choice(strategy, x1, x2, found, inside, broken, near, note)


def _sum(task: Task, distance: float | None) -> float:
    if distance is None:
        raise UsageError("a centre distance is missing", where="shifts", remedy="give the centre distance in modules")
    return sum_from_distance(task.first, task.second, distance)[0]


def _on_sum(area: Contour, strategy: str, total: float, x1: float | None, x2: float | None, split: Split) -> Choice:
    """The split of a given sum."""
    if x1 is not None or x2 is not None:
        one = x1 if x1 is not None else total - float(x2 or 0.0)
        return _judged(area.task, strategy, area.strict, one, total - one)
    sums = area.frame.sums(area.frame.angle_of(np.array([total])))
    line = interval(area.frame, total, area.strict, region=area.main)
    if split == "middle":
        wanted = (line.low + line.high) / 2
    elif split == "max_contact_ratio":
        wanted = float(area.frame.best_split(sums)[0])
    elif split == "equal_strength":
        wanted = float(strength_split(area.frame, sums, np.array([line.low]), np.array([line.high]))[0][0])
    else:
        wanted = float(sliding_split(area.frame, sums)[0])
    line = interval(area.frame, total, area.strict, region=area.main, near=wanted)
    one = min(max(wanted, line.low), line.high)
    note = ""
    if one != wanted:
        limit = line.low_line if one == line.low else line.high_line
        note = Phrase(
            "{split} would need x1 = {wanted:.4f}; stopped by: {limit}",
            split=split.replace("_", " "),
            wanted=wanted,
            limit=LINES[limit][1],
        )
    return _judged(area.task, strategy, area.strict, one, total - one, note)


def _sliding(area: Contour, desired: float) -> tuple[float, float, str]:
    """Point D, or the point of equal sliding in the contour whose contact ratio is nearest to the desired one."""
    found = equal_sliding(area.frame, desired)
    if found is not None and float(margins(area.task, *found).least(area.strict)) >= -ROUNDING:
        return *found, ""
    region = area.region

    def inside(w: Values) -> Flags:
        return held(area, w, sliding_split(area.frame, area.frame.sums(w)))

    w = _best_end(inside, region.angles, lambda w: np.abs(_ratio(area, w) - desired))
    if w is None:
        raise NoSolutionError(
            "no admissible shifts give equal specific sliding",
            where="shifts",
            remedy="another strategy, or a smaller contact ratio or tip thickness",
        )
    sums = area.frame.sums(np.array([w]))
    x1 = float(sliding_split(area.frame, sums)[0])
    ratio = float(_ratio(area, np.array([w]))[0])
    note = Phrase(
        "equal sliding at the contact ratio {desired:g} is outside the contour; the nearest inside has {ratio:.4f}",
        desired=desired,
        ratio=ratio,
    )
    return x1, float(sums.total[0]) - x1, note


def _ratio(area: Contour, w: Values) -> Values:
    sums = area.frame.sums(w)
    return area.frame.overlap(sums, sliding_split(area.frame, sums))[0] + area.task.contact_ratio


def _strength(area: Contour) -> tuple[float, float]:
    """The largest sum of shifts in the contour with equal tooth form factors."""
    found = largest_equal_strength(area)
    if found is None:
        raise NoSolutionError(
            "no admissible shifts give both wheels the same tooth form factor",
            where="shifts",
            remedy="another strategy: the bending strength is better matched by material or face width here",
        )
    return found


def _best_end(holds: Callable[[Values], Flags], w: Values, cost: Callable[[Values], Values]) -> float | None:
    """The w of least cost among those that hold, its neighbours narrowed until they stop holding."""
    for _ in range(NARROWING):
        good = np.flatnonzero(holds(w))
        if not good.size:
            return None
        k = int(good[np.argmin(cost(w[good]))])
        best = float(w[k])
        near = np.linspace(w[max(k - 1, 0)], w[min(k + 1, w.size - 1)], ZOOM)
        w = np.sort(np.append(near, best))
    return best
