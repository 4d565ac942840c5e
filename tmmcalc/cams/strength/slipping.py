"""Where a roller slips, and the slip function's largest value over the turn.

    D = |C1 + C2 A/|R||                                                                             (5.70 to 5.72)

D is steep where R is small, but |C1 |R| + C2 A| - D |R| is as smooth as R and A themselves. Its largest value over the
turn falls with D and is convex, so Newton's steps from one side reach the D for which it is 0.
"""

from __future__ import annotations

import numpy as np

from tmmcalc.cams.forces.course import NOTHING
from tmmcalc.cams.forces.state import state
from tmmcalc.cams.forces.turn import at_rows, crossings, divided, spans
from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.program import Positions
from tmmcalc.cams.steadying import steady
from tmmcalc.cams.strength.work import Case, spun

STEPS = 40
LEVEL = 1e-12  # of the largest force: what counts as none; of D: a step that is the last


def slipping(case: Case, c1: float, c2: float) -> tuple[tuple[float, float], ...]:
    """Intervals of phi where D > 1, which has a sense where R is 0 as well."""
    course, size = case.course, np.abs(case.course.state.contact)
    excess = [course.shaped(side * (c1 * size + c2 * case.run) - size) for side in (1, -1)]
    on = divided(course.on, np.concatenate([crossings(course.on, each) for each in excess]))
    middle = (on.edges[:-1] + on.edges[1:]) / 2
    over = np.maximum(*(course.on.at(each, middle) for each in excess))
    return spans(on.edges, over > LEVEL * np.max(size))


def largest_slip(case: Case, c1: float, c2: float) -> tuple[float, float]:
    """The largest D where the roller is pressed, and its place."""
    course, size = case.course, np.abs(case.course.state.contact)
    least = NOTHING * np.max(size)
    found, place = _worst(size, case.run, course.points.phi, least, c1, c2)
    for _ in range(STEPS):
        beyond = [side * (c1 * size + c2 * case.run) - found * size for side in (1, -1)]
        tops = np.array([course.on.extremes(steady(course.shaped(each)))[1][1] for each in beyond])
        better, at = _worst(*_both_sides(case, tops), least, c1, c2)
        if better <= found:
            break
        last, found, place = found, better, at
        if found <= last * (1 + LEVEL):
            break
    return found, place


def _worst(size: Values, run: Values, phi: Values, least: float, c1: float, c2: float) -> tuple[float, float]:
    """The largest D and its place among points (n,)."""
    pressed = size > least
    values = np.where(pressed, np.abs(c1 + c2 * run / np.where(pressed, size, 1.0)), 0.0)
    k = int(np.argmax(values))
    return float(values[k]), float(phi[k])


def _both_sides(case: Case, phi: Values) -> tuple[Values, Values, Values]:
    """|R|, A and phi (2 n,) before and after places (n,), by the formulas themselves."""
    edges = case.task.program.edges
    sides = [np.clip(np.searchsorted(edges, phi, way) - 1, 0, len(edges) - 2) for way in ("left", "right")]
    rows = Positions(np.tile(phi, 2), np.concatenate(sides), ())
    at = at_rows(case.task, case.loads, rows)
    contact = state(case.course.carried, at).contact
    return np.abs(contact), spun(case.task, case.loads, case.follower, at, contact), rows.phi
