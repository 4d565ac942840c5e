"""What rounding leaves of the rows of the requirements and of the extremes that the margins are made of."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from tmmcalc.cams.forces.errors import at_sides, moved_points, shift, wide_points
from tmmcalc.cams.forces.results import SpringFound
from tmmcalc.cams.forces.springerrors import exact_carried, exact_spring
from tmmcalc.cams.forces.state import Carried, State, state
from tmmcalc.cams.forces.turn import Points
from tmmcalc.cams.laws.law import Indices, Values
from tmmcalc.cams.rounding import Errors, chosen, nearer, relative, steep
from tmmcalc.cams.strength.case import Case
from tmmcalc.cams.strength.formulas import flat_radius
from tmmcalc.cams.strength.results import Margin, Rolling, ShaftFound
from tmmcalc.cams.strength.roller import factors, pin_of
from tmmcalc.cams.strength.rows import RequirementRows, rows_of
from tmmcalc.cams.wide import wide
from tmmcalc.core.records import record

TINY = 1e-300
OF_ROWS = {"D": "slip", "sigma_H": "stress", "sigma_F": "bending"}  # symbols of margins that are extremes of rows


@record
class Positioned:
    """The rows of the tables."""

    points: Points
    piece: Indices
    state: State
    rows: RequirementRows


def strength_errors(
    case: Case,
    rolling: Rolling | None,
    at: Positioned,
    margins: tuple[Margin, ...],
    shaft: ShaftFound | None,
    spring: SpringFound,
) -> Errors:
    """Estimates of the rows, and of the largest values behind the margins, each relative to itself."""
    of = exact_carried(case.task, case.follower, case.loads, exact_spring(case.task, case.loads, spring))
    found = at.rows.named()
    slipping = at.rows.slip if at.rows.slip is not None else np.zeros(1)
    least = 1 / (np.abs(at.state.contact) + TINY)
    pressed = least if at.rows.stress is None else np.where(at.rows.stress > 0, least, 0.0)  # stresses go as its root
    which = chosen(
        len(at.points.phi),
        at.rows.curvature,
        slipping,
        at.state.contact,
        least,
        pressed,
        *steep(at.points.phi, at.points.motion),
    )
    there, turns = _widened(case, of, rolling)
    again = wide_points(case.task, case.loads, at.points, at.piece, which)
    moved = moved_points(case.task, case.loads, again)
    exact, off = (rows_of(there, turns, points, state(of, points)).named() for points in (again, moved))
    errors = {}
    for name, values in found.items():
        size = float(np.max(np.abs(values)))
        errors[name] = relative(values[which], exact[name], size) + shift(off[name], exact[name], size)
    return errors | {"extremes": max(_extremes(there, of, turns, margins, shaft))}


def _widened(case: Case, of: Carried, rolling: Rolling | None) -> tuple[Case, Rolling | None]:
    """Data of the case and constants of the slip, its pin by the largest R itself, in extended precision."""
    given = replace(case.task, requirements=wide(case.task.requirements), guide=wide(case.task.guide))
    there = replace(case, task=given, loads=wide(case.loads), follower=of.follower)
    if rolling is None:
        return there, None
    pressing = np.abs(state(of, at_sides(case.task, case.loads, np.array([case.pressing.place]))).contact)
    largest = pressing[int(np.argmin(np.abs(pressing - case.pressing.size)))]
    known = case.task.requirements.pin is not None or case.task.requirements.pin_pressure is not None
    found = factors(there, pin_of(there.task.requirements, largest) if known else None)
    return there, rolling if found is None else Rolling(*found, rolling.slipping)


def _extremes(
    case: Case, of: Carried, rolling: Rolling | None, margins: tuple[Margin, ...], shaft: ShaftFound | None
) -> Iterator[float]:
    """Of a case and a rolling in extended precision."""
    bend, pressing = case.bend, case.pressing
    stressed = [each for each in margins if each.value is not None and each.phi is not None]
    known = [each for each in stressed if each.symbol in OF_ROWS or each.constraint == 8]
    phi = [bend.least_phi, bend.largest_phi, pressing.place, *(each.phi for each in known)]
    if shaft is not None and shaft.moment_phi is not None:
        phi.append(shaft.moment_phi)
    at = at_sides(case.task, case.loads, np.array(phi))
    now = state(of, at)
    rows = rows_of(case, rolling, at, now)

    def there(values: Values, k: int) -> Values:
        return values.reshape(2, -1)[:, k]

    shape = flat_radius(at.motion, case.follower.start) if case.flat else rows.curvature
    size = max(abs(bend.least), abs(bend.largest))
    yield nearer([bend.least], there(shape, 0), size)
    yield nearer([bend.largest], there(shape, 1), size)
    yield nearer([pressing.size], np.abs(there(now.contact, 2)))
    named = rows.named()
    for k, each in enumerate(known, start=3):
        values = named.get(OF_ROWS.get(each.symbol, "pressure"))
        if values is not None:
            yield nearer([each.value], there(values, k))
    if shaft is not None and shaft.moment is not None and rows.reduced is not None:
        yield nearer([shaft.moment], there(rows.reduced, len(phi) - 1))
