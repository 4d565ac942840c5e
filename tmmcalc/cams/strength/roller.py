"""Margins of the roller: where it slips and the largest slip function, the strength of its pin, the contact stress."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from tmmcalc.cams.forces.state import state
from tmmcalc.cams.forces.turn import at_rows, crossings, divided, spans
from tmmcalc.cams.forces.turnforces import NOTHING
from tmmcalc.cams.laws.law import Number, Values
from tmmcalc.cams.program import Positions, levelled
from tmmcalc.cams.strength.case import Case, roller_acceleration
from tmmcalc.cams.strength.formulas import (
    HERTZ,
    cylinder,
    pin_pressure,
    pin_radius,
    resisting,
    unused,
)
from tmmcalc.cams.strength.results import OPEN, Margin, RollerUnit, Rolling, judged, stressed
from tmmcalc.cams.task import Requirements

STEPS = 40
LEVEL = 1e-12  # of the largest force: what counts as none; of D: a step that is the last
SLIP = "|C1 + C2 A/|R|| <= 1 (5.72)"
CONTACT = "0.418 sqrt(E_n R/b (1/(rho - r2) + 1/r2)) (5.90)"
TOO_THICK = "the pin does not fit into the roller"
FLAT = "0.418 sqrt(E_n R/(b rho)) (5.90)"


def roller_unit(case: Case) -> RollerUnit | None:
    """Pin as given, or by the pressure on it; None without data (5.82 to 5.84)."""
    needs = case.task.requirements
    if case.flat or not case.follower.roller:
        return None
    if needs.pin is None and needs.pin_pressure is None:
        return None
    pin = float(pin_of(needs, case.pressing.size))
    return RollerUnit(pin, needs.pin is not None, needs.roller_ratio * pin)


def pin_of(needs: Requirements, contact: Number) -> Any:
    """r0 [m] as given, or by the pressure of the largest |R| [N] on it."""
    return pin_radius(contact, needs.pin_pressure or 1.0, needs.pin_ratio) if needs.pin is None else needs.pin


def unit_margins(case: Case, unit: RollerUnit | None) -> Iterator[Margin]:
    """Constraint 5: least roller, and the pressure on a pin that is given."""
    name, formula = "roller unit", "r2 >= alpha0 r0, r0 = 0.5 sqrt(R/(alpha2 [sigma_0])) (5.83, 5.84)"
    if unit is None:
        why = _no_roller(case) or "give pin_pressure or pin in [cam.requirements]"
        yield Margin(name, 5, OPEN, formula, why=why)
        return
    roller, at = case.follower.roller, case.pressing.place
    yield judged(name, 5, formula, "r2*", "m", unit.least, roller, float(unused(unit.least, roller)), at)
    limit = case.task.requirements.pin_pressure
    if unit.given and limit is not None:
        value = float(pin_pressure(case.pressing.size, unit.pin, case.task.requirements.pin_ratio))
        formula = "R/(4 alpha2 r0^2) <= [sigma_0] (5.82)"
        yield judged("pressure on the pin", 5, formula, "p", "Pa", value, limit, float(unused(value, limit)), at)


def rolling_of(case: Case, unit: RollerUnit | None) -> Rolling | None:
    """C1, C2 and where the roller slips; None without data."""
    if unit is not None and not unit.fits(case.follower.roller):
        return None
    found = factors(case, None if unit is None else unit.pin)
    if found is None:
        return None
    c1, c2, inertia = map(float, found)
    return Rolling(c1, c2, inertia, slipping(case, c1, c2))


def factors(case: Case, pin: Number | None) -> tuple[Any, Any, Any] | None:
    """C1, C2 [N/m] and the inertia J [kg*m^2] of the roller on a pin of radius r0 [m]; None without data."""
    needs, roller = case.task.requirements, case.follower.roller
    inertia = _inertia(case, pin)
    if needs.rolling_arm is None or needs.roller_friction is None or inertia is None or not roller:
        return None
    arm, held, friction = needs.rolling_arm, 0.0 if pin is None else pin, needs.roller_friction
    c1 = resisting(arm, needs.pin_friction or 0.0, held, friction, roller)
    return c1, inertia * case.loads.speed**2 / (friction * roller**2), inertia


def _inertia(case: Case, pin: Number | None) -> Any:
    """Of the roller: given, or of a hollow cylinder; None without data."""
    needs = case.task.requirements
    if needs.roller_inertia is not None or needs.width is None or pin is None:
        return needs.roller_inertia
    return cylinder(needs.width, needs.roller_density, case.follower.roller, pin)


def slip_margin(case: Case, unit: RollerUnit | None, rolling: Rolling | None) -> Margin:
    """Constraint 2."""
    why = _no_roller(case)
    if unit is not None and not unit.fits(case.follower.roller):
        why = TOO_THICK
    if rolling is None or why:
        why = why or (
            "give rolling_arm, roller_friction, pin_friction and width or roller_inertia, and pin or pin_pressure in "
            "[cam.requirements]"
        )
        return Margin("no slip", 2, OPEN, SLIP, why=why)
    if rolling.slipping and case.passes_zero:
        place = rolling.slipping[0][0]
        return Margin("no slip", 2, "slip", SLIP, "D", phi=place, why="R passes 0: the roller slips there")
    value, place = largest_slip(case, rolling.resisting, rolling.driving)
    return judged("no slip", 2, SLIP, "D", "", value, 1.0, 1 - value, place, "slip")


def contact_margin(case: Case) -> Margin:
    """Constraint 9, of a roller on either wall and of a flat face."""
    needs, formula = case.task.requirements, FLAT if case.flat else CONTACT
    if needs.contact_source:
        formula = f"{formula}, [sigma_H] = {needs.contact_source}"
    why = "a knife edge has no contact stress by Hertz" if not case.flat and not case.follower.roller else ""
    if not why and needs.width is None:
        why = "give width and contact in [cam.requirements]"
    if not why and case.cusped:
        why = "the profile has a cusp" if not case.flat else "the profile is not convex"
    if why or needs.width is None:
        return Margin("contact stress", 9, OPEN, formula, "sigma_H", "Pa", why=why)
    found = case.over(case.stress_square)
    value = HERTZ * float(np.sqrt(needs.modulus / needs.width * found.largest))
    return stressed("contact stress", 9, formula, "sigma_H", value, needs.contact, found.largest_phi, "contact")


def _no_roller(case: Case) -> str:
    if case.flat:
        return "a flat face has no roller"
    return "" if case.follower.roller else "a knife edge has no roller"


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
        tops = np.array([course.on.extremes(levelled(course.shaped(each)))[1][1] for each in beyond])
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
    return np.abs(contact), roller_acceleration(case.task, case.loads, case.follower, at, contact), rows.phi
