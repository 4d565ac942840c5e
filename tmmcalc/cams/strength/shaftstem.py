"""Margins of what carries cam and follower: the camshaft, the stem, the guide."""

from __future__ import annotations

from collections.abc import Iterator
from math import sqrt

import numpy as np

from tmmcalc.cams.forces.state import State
from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.strength.case import Case, TurnExtremes
from tmmcalc.cams.strength.formulas import (
    guide_pressure,
    shaft_by_stiffness,
    shaft_by_strength,
    shafted,
    stem_moment,
    stem_stress,
    unused,
    whole,
)
from tmmcalc.cams.strength.results import OPEN, Margin, ShaftFound, judged, stressed

STRENGTH = "r1 >= cbrt(4 M_E/(pi [sigma_F])) (5.77)"
STIFFNESS = "r1 >= (R l_s^3/(12 pi E [Delta]))^(1/4) (5.78)"


def shaft_of(case: Case) -> ShaftFound | None:
    """Radii by strength and stiffness; None without data."""
    needs = case.task.requirements
    if needs.span is None or (needs.bending is None and needs.deflection is None):
        return None
    moment = rubbed = phi = strength = stiffness = None
    if needs.bending is not None:
        found = _moment(case)
        moment, phi = found.largest, found.largest_phi
        rubbed = _moment(case, rubbed=True).largest if case.course.carried.rubs else moment
        strength = float(shaft_by_strength(moment, needs.bending))
    if needs.deflection is not None:
        stiffness = float(shaft_by_stiffness(case.pressing.size, needs.span, needs.young, needs.deflection))
    return ShaftFound(moment, phi, rubbed, strength, stiffness, float(whole(max(strength or 0.0, stiffness or 0.0))))


def _moment(case: Case, *, rubbed: bool = False) -> TurnExtremes:
    """M_E over the turn: extremes of its square, which is smooth."""
    now, needs = case.course.state, case.task.requirements
    torque = now.driving if rubbed else now.torque
    found = case.over((now.contact * ((needs.span or 0.0) / 4)) ** 2 + needs.torsion * torque * torque)
    return TurnExtremes(sqrt(max(found.least, 0.0)), found.least_phi, sqrt(found.largest), found.largest_phi)


def shaft_margins(case: Case, shaft: ShaftFound | None) -> Iterator[Margin]:
    """Constraint 6: a shaft that is given is thick enough, and the base circle clears the shaft."""
    given, roller = case.task.limits.shaft, 0.0 if case.flat else case.follower.roller
    clearance = "r2 <= R0 - r1*" if not case.flat else "S0 >= r1*"
    if shaft is None:
        why = "give span and bending or deflection in [cam.requirements]"
        yield Margin("shaft strength", 6, OPEN, STRENGTH, why=why)
        yield Margin("shaft stiffness", 6, OPEN, STIFFNESS, why=why)
    else:
        yield _radius("shaft strength", STRENGTH, "r1'", shaft.strength, given, shaft.moment_phi, "bending")
        yield _radius("shaft stiffness", STIFFNESS, "r1''", shaft.stiffness, given, case.pressing.place, "deflection")
    radius = max(given, shaft.radius if shaft else 0.0)
    if not radius:
        yield Margin("clearance of the shaft", 6, OPEN, clearance, why="no shaft is known")
        return
    base = case.follower.base
    margin = float(shafted(base, roller, radius))
    yield judged("clearance of the shaft", 6, clearance, "r2 + r1", "m", roller + radius, base, margin, None)


def _radius(
    name: str, formula: str, symbol: str, value: float | None, given: float, phi: float | None, key: str
) -> Margin:
    if value is None:
        return Margin(name, 6, OPEN, formula, why=f"give {key} in [cam.requirements]")
    if not given:
        why = "no shaft is given: the clearance is judged with the least one"
        return Margin(name, 6, OPEN, formula, symbol, "m", value, phi=phi, why=why)
    return judged(name, 6, formula, symbol, "m", value, given, float(unused(value, given)), phi)


def bending_of(case: Case, now: State, motion: Values) -> Values | None:
    """Bending stress of the stem; None without a stem in a guide."""
    stem = case.task.guide.stem
    if stem is None or case.course.carried.guide is None:
        return None
    return np.asarray(stem_stress(stem_moment(case.follower, motion, now.contact, now.sine, now.protrusion), stem))


def pressure_of(case: Case, now: State) -> Values | None:
    """Larger pressure of the two edges of the guide; None without a guide and lands."""
    guide = case.task.guide
    if guide.stem is None or guide.land is None or case.course.carried.guide is None:
        return None
    return np.asarray(guide_pressure(np.maximum(np.abs(now.lower), np.abs(now.upper)), guide.land, guide.stem))


def stem_margins(case: Case) -> Iterator[Margin]:
    """Constraints 7 and 8."""
    moment = "R S'" if case.flat else "R sin(theta) q"
    formula = f"{moment}/W <= [sigma_F], W = pi r_T^3/4 (5.79)"
    pressed = "N1/(2 l_H r_T) <= [sigma_cm]"
    guide, needs, now = case.task.guide, case.task.requirements, case.course.state
    if case.course.carried.guide is None:
        why = "a rocker has none" if case.follower.kind == "oscillating" else "give top or length in [cam.guide]"
        yield Margin("bending of the stem", 7, OPEN, formula, why=why)
        yield Margin("pressure in the guide", 8, OPEN, pressed, why=why)
        return
    if guide.stem is None:
        why = "give stem_radius in [cam.guide] and bending in [cam.requirements]"
        yield Margin("bending of the stem", 7, OPEN, formula, why=why)
    else:
        across = case.course.points.motion[1] if case.flat else now.sine * now.protrusion
        found = case.over(now.contact * across)
        value = float(stem_stress(found.size, guide.stem))
        yield stressed("bending of the stem", 7, formula, "sigma_F", value, needs.bending, found.place, "bending")
    if guide.stem is None or guide.land is None:
        why = "give stem_radius and land in [cam.guide] and guide_pressure in [cam.requirements]"
        yield Margin("pressure in the guide", 8, OPEN, pressed, why=why)
        return
    found = max(case.over(now.lower), case.over(now.upper), key=lambda each: each.size)
    value = float(guide_pressure(found.size, guide.land, guide.stem))
    limit = needs.guide_pressure
    yield stressed("pressure in the guide", 8, pressed, "p", value, limit, found.place, "guide_pressure")
