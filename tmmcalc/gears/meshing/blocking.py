"""The blocking contours of the external pairs of a project, with their lines and points, and where the shifts stand.

An empty contour is a result like any other: it tells its reason and the best contact ratio within reach.
"""

from __future__ import annotations

from dataclasses import fields

import numpy as np

from tmmcalc.core.notes import Phrase
from tmmcalc.core.quantity import Quantity
from tmmcalc.gears.involute.contour.contour import Contour, contours
from tmmcalc.gears.involute.contour.errors import contour_error
from tmmcalc.gears.involute.contour.interval import ShiftInterval, intervals
from tmmcalc.gears.involute.contour.margins import margins
from tmmcalc.gears.involute.contour.regions import Region
from tmmcalc.gears.meshing.blockinglines import contour_lines
from tmmcalc.gears.meshing.blockingpoints import contour_points
from tmmcalc.gears.meshing.choice import contour_task
from tmmcalc.gears.meshing.contours import Area, Blocking, ContourCorner, ContourPoint, Outline, PairContour
from tmmcalc.gears.meshing.results import Pairs

X1 = Quantity("x1", "profile shift of wheel 1 on the boundary")
X2 = Quantity("x2", "profile shift of wheel 2 on the boundary")
SPARED = ("exists", "theta1", "theta2")  # of the margins, which are no lines of the contour


def solve_blocking(pair: Pairs) -> Blocking:
    """The strict and the tolerated contour of every external pair; the others get a remark.

    >>> from tmmcalc.gears.meshing.task import PairTask
    >>> from tmmcalc.gears.meshing.solve import solve_pair
    >>> pair = solve_pair(PairTask((14, 17), 0.005, strategy="given", shifts=(0.6, 0.522)))
    >>> round(solve_blocking(Pairs((pair,), "", ())).pairs[0].strict.main.area, 4)
    0.9687
    """
    solved = []
    for each in (one for one in pair.pairs if one.task.kind == "external"):
        task, asked = each.task, contour_task(each.task)
        strict, tolerated = contours(asked)
        both = strict, tolerated
        points, missing = contour_points(each, both)
        line = _interval(both, points[0])
        left = margins(asked, *each.shifts)
        solved.append(
            PairContour(
                name=task.name,
                teeth=task.teeth,
                module=task.module,
                helix=task.helix,
                rack=task.rack,
                contact_ratio=task.limits.contact_ratio,
                thickness=task.limits.tip_thickness,
                strict=_area(strict),
                tolerated=_area(tolerated),
                lines=contour_lines(each, both),
                points=points,
                missing=missing,
                margins={
                    margin.name: float(getattr(left, margin.name))
                    for margin in fields(left)
                    if margin.name not in SPARED
                },
                low=line.low if line else None,
                high=line.high if line else None,
                ends=(line.low_line, line.high_line) if line else ("", ""),
            )
        )
    return Blocking(tuple(solved), tuple(_remarks(pair)))


def _remarks(found: Pairs) -> list[str]:
    remarks: list[str] = []
    for pair in found.pairs:
        task = pair.task
        if task.kind != "external":
            what = "a rack" if task.kind == "rack" else "a ring"
            remarks.append(
                Phrase(
                    "{title}: no blocking contour, which is that of two external wheels; the mate is {what}",
                    title=task.title,
                    what=what,
                )
            )
        elif task.tips != (None, None):
            remarks.append(
                Phrase(
                    "{title}: the contour and its margins are those of tips by the rule r + h_a* + x - dy; the "
                    "values of the chosen shifts are those of the given tip circles",
                    title=task.title,
                )
            )
    return remarks


def _interval(both: tuple[Contour, Contour], chosen: ContourPoint) -> ShiftInterval | None:
    """The admissible x1 at the chosen sum: the interval that holds the chosen x1, or is nearest to it.

    Without undercut, unless only the tolerated contour holds the chosen shifts or has anything on the line.
    """
    areas = both[1:] if chosen.tolerated and not chosen.strict else both
    for area in areas:
        found = intervals(area.frame, chosen.x1 + chosen.x2, area.strict)
        if found:
            return min(found, key=lambda each: each.distance(chosen.x1))
    return None


def _area(found: Contour) -> Area:
    main = None if found.main is None else _outline(found.main)
    return Area(
        strict=found.strict,
        main=main,
        reason="" if main else found.reason,
        pieces=tuple(_outline(piece) for piece in found.pieces),
        untraced=tuple(wheel for wheel in (1, 2) if {wheel, 3} & set(found.untraced)),
        best_contact_ratio=found.best_contact_ratio,
        error=contour_error(found),
    )


def _outline(region: Region) -> Outline:
    edges = region.edges
    steps = [edge.x1.size - 1 for edge in edges]
    x1, x2 = (
        np.concatenate([*(getattr(edge, name)[:-1] for edge in edges), getattr(edges[0], name)[:1]])
        for name in ("x1", "x2")
    )
    corners = tuple(ContourCorner(corner.x1, corner.x2, corner.lines) for corner in region.corners)
    numbers = np.repeat(np.arange(len(edges)), steps)
    return Outline(x1, x2, numbers, tuple(edge.line for edge in edges), corners, region.area)


def blocking_columns(found: Blocking) -> dict[str, np.ndarray]:
    """The boundaries of all contours: the table blocking.csv; each point with the line that goes on from it."""
    names: list[str] = []
    kinds: list[str] = []
    lines: list[np.ndarray] = []
    places: list[tuple[np.ndarray, np.ndarray]] = []
    for pair in found.pairs:
        for area in (pair.strict, pair.tolerated):
            for outline in (area.main, *area.pieces):
                if outline is None:
                    continue
                edge = np.append(outline.edge, outline.edge[-1])
                names += [pair.name or f"{pair.teeth[0]}/{pair.teeth[1]}"] * edge.size
                kinds += ["strict" if area.strict else "tolerated"] * edge.size
                lines.append(np.array(outline.edges)[edge])
                places.append((outline.x1, outline.x2))
    return {
        "pair": np.array(names, str),
        "contour": np.array(kinds, str),
        "line": np.concatenate(lines) if lines else np.array([], str),
        X1.key: np.concatenate([x1 for x1, _ in places]) if places else np.zeros(0),
        X2.key: np.concatenate([x2 for _, x2 in places]) if places else np.zeros(0),
    }
