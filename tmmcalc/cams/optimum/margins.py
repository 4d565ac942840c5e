"""The constraints of table 5.5 as margins over S0, r2 and H2: 0 at the limit, negative beyond it.

    2  the roller rolls without slip             6  shaft: r2 <= R0 - r1*
    3  no undercut: r2 <= rho2 - r_m             7  bending of the stem
    4  concave parts: r2 >= r_i - rho1           8  pressure in the guide
    5  roller on its pin: r2 >= r2*              9  contact stress

R0 is S0 of a central follower. The first, closure of the pair, depends on the motion alone. What has no data is not
judged. Every largest value is that over all examined phases, to rounding.
"""

from __future__ import annotations

from dataclasses import fields

import numpy as np

from tmmcalc.cams.forces.kernels import guided
from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.optimum.peaks import largest
from tmmcalc.cams.optimum.scene import Scene
from tmmcalc.cams.strength.kernels import (
    BAD,
    concave_margin,
    contact_stress,
    convex_margin,
    cylinder,
    guide_pressure,
    pin_pressure,
    pin_radius,
    reduced_moment,
    resisting,
    rolling,
    shaft_by_stiffness,
    shaft_by_strength,
    shafted,
    slip,
    stem_moment,
    stem_stress,
    whole,
)
from tmmcalc.cams.task import Requirements
from tmmcalc.records import record

NUMBERS = (2, 3, 4, 5, 6, 7, 8, 9)  # of the constraints, in the order of the rows
NAMES = {
    1: "closure of the pair",
    2: "roller without slip",
    3: "no undercut",
    4: "concave parts",
    5: "roller on its pin",
    6: "shaft",
    7: "bending of the stem",
    8: "pressure in the guide",
    9: "contact stress",
}
BLOCK = 64  # points at once: their values stay in the cache
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


def margins(scene: Scene, start: Values, roller: Values, top: Values) -> Values:
    """Margins (8, B) of the constraints NUMBERS at S0, r2, H2 (B,)."""
    return judge(scene, start, roller, top).margin


def judge(scene: Scene, start: Values, roller: Values, top: Values) -> Judged:
    """Margins and values at S0, r2, H2 (B,) [m]."""
    parts = [
        _block(scene, start[i : i + BLOCK], roller[i : i + BLOCK], top[i : i + BLOCK])
        for i in range(0, max(len(start), 1), BLOCK)
    ]
    if len(parts) == 1:
        return parts[0]
    names = [each.name for each in fields(Judged)]
    return Judged(*(np.concatenate([getattr(part, name) for part in parts], axis=-1) for name in names))


def _block(scene: Scene, start: Values, roller: Values, top: Values) -> Judged:
    """The same of few enough points."""
    need, limits, wide = scene.requirements, scene.limits, roller[:, None]
    on = guided(
        scene.follower,
        scene.motion,
        scene.load,
        scene.sense,
        stroke=scene.stroke,
        friction=scene.friction,
        gap=scene.guide.gap,
        start=start[:, None],
        roller=wide,
        top=top[:, None],
    )
    bend, run = rolling(scene.follower, scene.motion, start[:, None])
    functions = {
        "contact": on.contact,
        "most": bend,
        "least": -bend,
        "edge": np.abs(on.lower),
        "moment": stem_moment(scene.follower, scene.motion, on.contact, on.sine, on.protrusion),
    }
    if need.span is not None and need.bending is not None:
        functions["reduced"] = reduced_moment(on.contact, scene.torque, need.span, need.torsion)
    cusps = np.zeros(len(start), bool)
    if need.width is not None:
        functions["stress"], smooth = contact_stress(on.contact, bend, wide, need.width, need.modulus)
        cusps = ~np.all(smooth, axis=1)
    peak = _peaks(scene, functions)
    none, works = np.zeros(len(start)), np.all(on.works, axis=1)
    pin = _pin(need, peak["contact"])
    grown = _slip(scene, on.contact, run, roller, pin)
    shaft = _shaft(scene, peak)
    least = none if pin is None else need.roller_ratio * pin
    stem = none if scene.guide.stem is None else stem_stress(peak["moment"], scene.guide.stem)
    pressure = none
    if scene.guide.stem is not None and scene.guide.land is not None:
        pressure = guide_pressure(peak["edge"], scene.guide.land, scene.guide.stem)
    stress = peak.get("stress", none)
    flattest = np.hypot(start, scene.follower.offset)
    concave = concave_margin(-peak["least"], roller, limits.concave) if limits.allow_concave else -peak["least"] * start
    margin = np.stack(
        (
            np.where(works, 1 - grown, BAD),
            convex_margin(peak["most"], roller, limits.convex),
            concave,
            np.where(works, _pinned(need, peak["contact"], least, roller), BAD),
            np.where(works, shafted(flattest, roller, shaft[2]), BAD),
            np.where(works, _left(stem, need.bending), BAD),
            np.where(works, _left(pressure, need.guide_pressure), BAD),
            np.where(works & ~cusps, _left(stress, need.contact), BAD),
        )
    )
    bounds = np.stack((-peak["least"], peak["most"]))
    return Judged(
        margin,
        grown,
        bounds,
        peak["contact"],
        none if pin is None else pin,
        least,
        shaft,
        stem,
        peak["edge"],
        pressure,
        stress,
    )


def _peaks(scene: Scene, functions: dict[str, Values]) -> dict[str, Values]:
    """Largest values (B,) of functions (B, M), all found at once."""
    rows = np.concatenate(list(functions.values()))
    found = largest(rows.reshape(len(rows), scene.panels, rows.shape[1] // scene.panels))
    return dict(zip(functions, found.reshape(len(functions), -1), strict=True))


def _left(value: Values, limit: float | None) -> Values:
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


def _slip(scene: Scene, contact: Values, run: Values, roller: Values, pin: Values | None) -> Values:
    """Largest D (B,); 0 without data."""
    need = scene.requirements
    arm, friction, inertia = need.rolling_arm, need.roller_friction, need.roller_inertia
    if arm is None or friction is None or (inertia is None and (need.width is None or pin is None)):
        return np.zeros(len(roller))
    r2, r0 = roller[:, None], 0.0 if pin is None else pin[:, None]
    mass = cylinder(need.width or 0.0, need.roller_density, r2, r0) if inertia is None else inertia
    resisted = resisting(arm, need.pin_friction or 0.0, r0, friction, r2)
    grown, _ = slip(contact, run, resisted, mass, scene.speed, friction, r2)
    return largest(np.abs(grown).reshape(len(roller), scene.panels, grown.shape[-1] // scene.panels))


def _shaft(scene: Scene, peak: dict[str, Values]) -> Values:
    """r1' by strength, r1'' by stiffness, r1* of both in whole mm (3, B)."""
    need, contact = scene.requirements, peak["contact"]
    strong = stiff = np.zeros(len(contact))
    if "reduced" in peak and need.bending is not None:
        strong = shaft_by_strength(peak["reduced"], need.bending)
    if need.span is not None and need.deflection is not None:
        stiff = shaft_by_stiffness(contact, need.span, need.young, need.deflection)
    both = np.maximum(strong, stiff)
    return np.stack((strong, stiff, np.maximum(whole(both), scene.limits.shaft)))
