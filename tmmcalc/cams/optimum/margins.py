"""The constraints of table 5.5 as margins over S0, r2 and H2: 0 at the limit, negative beyond it.

    2  the roller rolls without slip             6  shaft: r2 <= R0 - r1*
    3  no undercut: r2 <= rho2 - r_m             7  bending of the stem
    4  concave parts: r2 >= r_i - rho1           8  pressure in the guide
    5  roller on its pin: r2 >= r2*              9  contact stress

R0 is S0 of a central follower. The first, closure of the pair, depends on the motion alone. What has no data is not
judged. Every largest value is that over all examined phases, to rounding.
"""

from __future__ import annotations

import numpy as np

from tmmcalc.cams.laws.law import Indices, Values
from tmmcalc.cams.optimum.extremes import FUNCTIONS, Extremes, extremes
from tmmcalc.cams.optimum.scene import Scene
from tmmcalc.cams.strength.formulas import (
    BAD,
    concave_margin,
    contact_stress,
    convex_margin,
    cylinder,
    guide_pressure,
    pin_pressure,
    pin_radius,
    resisting,
    shaft_by_stiffness,
    shaft_by_strength,
    shafted,
    slip,
    stem_stress,
    whole,
)
from tmmcalc.cams.task import Requirements
from tmmcalc.core.records import record

NUMBERS = (2, 3, 4, 5, 6, 7, 8, 9)  # of the constraints, in the order of the rows
READ = ((2, 3, 4), (1,), (0,), (4,), (4, 5), (4, 7), (4, 8), (4, 6))  # FUNCTIONS that each of NUMBERS sets limits to
BEHIND = np.array([[k in read for read in READ] for k in range(len(FUNCTIONS))])
SLACK = 1e-12  # a margin this little below 0 is rounding


@record
class Judged:
    """Margins and the values behind them at B points; what is not judged has the margin 1 and the value 0."""

    margin: Values  # (8, B) of the constraints NUMBERS
    slip: Values  # D (B,)
    curvature: Values  # (2, B) least and largest kappa of the pitch curve [1/m]
    contact: Values  # largest R (B,) [N]
    pin: Values  # r0 (B,) [m]
    roller: Values  # r2* (B,) [m]
    shaft: Values  # r1', r1'', r1* (3, B) [m]
    stem: Values  # bending stress (B,) [Pa]
    edge: Values  # largest |N1| (B,) [N]
    pressure: Values  # in the guide (B,) [Pa]
    stress: Values  # sigma_H (B,) [Pa]


def margins(scene: Scene, start: Values, roller: Values, top: Values, row: Indices | None = None) -> Values:
    """Margins (8, B) of the constraints NUMBERS at S0, r2, H2 (B,); with ``row`` (B,) that one alone is of each."""
    return judge(scene, start, roller, top, row).margin


def judge(scene: Scene, start: Values, roller: Values, top: Values, row: Indices | None = None) -> Judged:
    """Margins and values at S0, r2, H2 (B,) [m]; with ``row`` (B,) of the one constraint that is meant at each."""
    on = extremes(scene, start, roller, top, None if row is None else BEHIND[:, row])
    return judged_by(scene, on, roller, np.hypot(start, scene.follower.offset), start)


def judged_by(scene: Scene, on: Extremes, roller: Values, base: Values, size: Values) -> Judged:
    """Margins and values from the extremes over the turn, with r2 and R0 (B,) [m].

    ``size`` (B,) [m] is that against which a concave curvature is told where none is allowed.
    """
    need, limits, guide = scene.requirements, scene.limits, scene.guide
    none, works, (bent, most) = np.zeros(len(roller)), on.works, on.curvature
    pin = _pin(need, on.contact)
    grown = _slip(scene, on.growth, roller, pin)
    shaft = _shaft(scene, on)
    least = none if pin is None else need.roller_ratio * pin
    stem = none if guide.stem is None else stem_stress(on.moment, guide.stem)
    pressure: Values = none
    if guide.stem is not None and guide.land is not None:
        pressure = guide_pressure(on.edge, guide.land, guide.stem)
    stress: Values = none
    if need.width is not None:
        stress, _ = contact_stress(on.pressed, none, roller, need.width, need.modulus)
    margin = np.stack(
        (
            np.where(works, 1 - grown, BAD),
            convex_margin(most, roller, limits.convex),
            concave_margin(bent, roller, limits.concave) if limits.allow_concave else bent * size,
            np.where(works, _pinned(need, on.contact, least, roller), BAD),
            np.where(works, shafted(base, roller, shaft[2]), BAD),
            np.where(works, _margin_of(stem, need.bending), BAD),
            np.where(works, _margin_of(pressure, need.guide_pressure), BAD),
            np.where(works & (on.smooth | (need.width is None)), _margin_of(stress, need.contact), BAD),
        )
    )
    radius = none if pin is None else pin
    return Judged(margin, grown, on.curvature, on.contact, radius, least, shaft, stem, on.edge, pressure, stress)


def _margin_of(value: Values, limit: float | None) -> Values:
    return np.ones_like(value) if limit is None else 1 - value / limit


def _pin(need: Requirements, contact: Values) -> Values | None:
    """r0 (B,): given, or by the pressure on it; None without data."""
    if need.pin is not None:
        return np.full(len(contact), need.pin)
    if need.pin_pressure is None:
        return None
    found: Values = pin_radius(contact, need.pin_pressure, need.pin_ratio)
    return found


def _pinned(need: Requirements, contact: Values, least: Values, roller: Values) -> Values:
    """Margin of r2 >= r2*, and of the pressure on a pin that is given."""
    found = np.where(roller > 0, 1 - least / np.where(roller > 0, roller, 1.0), BAD)
    if need.pin is not None and need.pin_pressure is not None:
        pressed = pin_pressure(contact, need.pin, need.pin_ratio) / need.pin_pressure
        found = np.minimum(found, 1 - pressed)
    return found


def _slip(scene: Scene, growth: Values, roller: Values, pin: Values | None) -> Values:
    """Largest D (B,); 0 without data."""
    need = scene.requirements
    arm, friction, inertia = need.rolling_arm, need.roller_friction, need.roller_inertia
    if arm is None or friction is None or (inertia is None and (need.width is None or pin is None)):
        return np.zeros(len(roller))
    r0 = 0.0 if pin is None else pin
    mass = cylinder(need.width or 0.0, need.roller_density, roller, r0) if inertia is None else inertia
    resisted = resisting(arm, need.pin_friction or 0.0, r0, friction, roller)
    grown, _ = slip(np.ones_like(growth), growth, resisted, mass, scene.speed, friction, roller)
    largest: Values = np.max(np.abs(grown), axis=0)
    return largest


def _shaft(scene: Scene, on: Extremes) -> Values:
    """r1' by strength, r1'' by stiffness, r1* of both in whole mm (3, B)."""
    need = scene.requirements
    strong = stiff = np.zeros(len(on.contact))
    if need.span is not None and need.bending is not None:
        strong = shaft_by_strength(on.reduced, need.bending)
    if need.span is not None and need.deflection is not None:
        stiff = shaft_by_stiffness(on.contact, need.span, need.young, need.deflection)
    both = np.maximum(strong, stiff)
    return np.stack((strong, stiff, np.maximum(whole(both), scene.limits.shaft)))
