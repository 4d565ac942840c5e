"""The points of interest of a blocking contour, and the chosen shifts, with what each of them gives."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from tmmcalc.core.notes import Phrase
from tmmcalc.gears.involute.contour.contour import Contour
from tmmcalc.gears.involute.contour.margins import margins, sliding_at_start
from tmmcalc.gears.involute.contour.points import (
    deepest,
    equal_sliding,
    largest_equal_strength,
    largest_sum,
)
from tmmcalc.gears.involute.contour.task import LINES, Task
from tmmcalc.gears.involute.formfactor import tooth_form
from tmmcalc.gears.involute.pair import pair_of_shifts
from tmmcalc.gears.involute.shifts import ROUNDING
from tmmcalc.gears.meshing.choice import contour_task
from tmmcalc.gears.meshing.contours import ContourPoint, MissingPoints
from tmmcalc.gears.meshing.geometry import external_pair
from tmmcalc.gears.meshing.results import MeshPair

Place = tuple[float, float]
Named = tuple[str, Phrase | str, Place | None]  # a point by its name, with what is special about it


def contour_points(
    pair: MeshPair, both: tuple[Contour, Contour]
) -> tuple[tuple[ContourPoint, ...], tuple[MissingPoints, ...]]:
    """The chosen shifts first, then the points that exist, and why the others do not.

    The values of the chosen shifts are those of the pair itself, whatever its tips; the others have tips by the rule.
    The points are those of the strict contour; of the tolerated one if that is empty or the task tolerates undercut.
    """
    task, asked = pair.task, contour_task(pair.task)
    areas = both if task.strict else both[1:]
    area = next((area for area in areas if area.main is not None), None)
    places: list[Named] = [("chosen", f"by the strategy {task.strategy}", pair.shifts)]
    missing: list[MissingPoints] = []
    if area is None:
        missing.append(MissingPoints(("C", "D", "E", "balanced", "equal strength"), areas[-1].reason))
    else:
        kind = "strict" if area.strict else "tolerated"
        places += [
            ("C", f"largest x1 + x2 of the {kind} contour", largest_sum(area)),
            (
                "D",
                Phrase("equal specific sliding at the contact ratio {ratio}", ratio=f"{task.desired:g}"),
                _sliding(area, task.desired, missing),
            ),
            ("E", f"largest contact ratio of the {kind} contour", area.best[:2]),
            ("balanced", f"farthest from all lines of the {kind} contour", deepest(area)[:2]),
            ("equal strength", "equal tooth form factors at the largest x1 + x2", _strength(area, missing)),
        ]
    named = [(name, title, place) for name, title, place in places if place is not None]
    chosen, *others = _points(asked, task.module, named)
    return (_own(pair, chosen), *others), tuple(missing)


def _own(pair: MeshPair, point: ContourPoint) -> ContourPoint:
    """The chosen point with the values of the pair that was solved."""
    one, two = pair.sizes
    m, solved = pair.task.module, external_pair(pair)
    ratio, g = solved.ratio, float(solved.length)
    start1, start2 = map(np.asarray, solved.starts)
    forms = [size.strength.factor if size.strength else 0.0 for size in (one, two)]
    return replace(
        point,
        contact_ratio=pair.contact_ratio,
        tip_thickness=(one.tip_thickness / m, two.tip_thickness / m),
        sliding=(
            float(sliding_at_start(g - start1, start1, ratio)),
            float(sliding_at_start(g - start2, start2, 1 / ratio)),
        ),
        form_factors=(forms[0], forms[1]),
        distance=pair.distance,
    )


def _sliding(area: Contour, desired: float, missing: list[MissingPoints]) -> Place | None:
    """Point D, if the contour holds it."""
    found = equal_sliding(area.frame, desired)
    if found is None:
        reason = Phrase("no mesh has the contact ratio {ratio} and equal specific sliding", ratio=f"{desired:g}")
        missing.append(MissingPoints(("D",), reason))
        return None
    there = margins(area.task, *found)
    if float(there.least(area.strict)) >= -ROUNDING:
        return found
    reason = Phrase(
        "equal sliding at the contact ratio {ratio}, x1 = {x1}, x2 = {x2}, lies outside the contour: {lines}",
        ratio=f"{desired:g}",
        x1=f"{found[0]:.4f}",
        x2=f"{found[1]:.4f}",
        lines=[LINES[key][1] for key in there.broken(area.strict)],
    )
    missing.append(MissingPoints(("D",), reason))
    return None


def _strength(area: Contour, missing: list[MissingPoints]) -> Place | None:
    found = largest_equal_strength(area)
    if found is None:
        reason = "no admissible shifts give both wheels the same tooth form factor"
        missing.append(MissingPoints(("equal strength",), reason))
    return found


def _points(asked: Task, module: float, named: list[tuple[str, str, Place]]) -> tuple[ContourPoint, ...]:
    """All points with their qualities, computed together."""
    x1, x2 = np.array([place for _, _, place in named], float).T
    there = margins(asked, x1, x2)
    one, two = asked.first, asked.second
    pair = pair_of_shifts(replace(one, shift=x1), replace(two, shift=x2))
    forms = [tooth_form(wheel, tip).factor for wheel, tip in zip(pair.wheels, pair.tips, strict=True)]
    rows = np.array(
        [
            there.contact_ratio + asked.contact_ratio,
            there.thickness1 + asked.thickness[0],
            there.thickness2 + asked.thickness[1],
            there.theta1,
            there.theta2,
            *forms,
            module * pair.distance,
        ]
    ).T.tolist()
    strict, tolerated = (there.least(kind) >= -ROUNDING for kind in (True, False))
    return tuple(
        ContourPoint(
            name=name,
            title=title,
            x1=float(place[0]),
            x2=float(place[1]),
            contact_ratio=row[0],
            tip_thickness=(row[1], row[2]),
            sliding=(row[3], row[4]),
            form_factors=(row[5], row[6]),
            distance=row[7],
            strict=bool(strict[k]),
            tolerated=bool(tolerated[k]),
        )
        for k, ((name, title, place), row) in enumerate(zip(named, rows, strict=True))
    )
