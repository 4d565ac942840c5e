"""Mechanisms far larger than the stroke: how large S0 may have to be, and a first one that keeps all constraints.

With S0 the pressure angle falls, the pitch curve becomes a circle and R becomes P, so that every constraint but that of
slip has an S0 from which on some roller and some guide keep it. Twice the largest of these is looked at in wide steps.
"""

from __future__ import annotations

from math import pi, sqrt

import numpy as np

from tmmcalc.cams.optimum.guidelength import SINGLE, TALL, Range, ranges
from tmmcalc.cams.optimum.margins import margins
from tmmcalc.cams.optimum.scene import Scene
from tmmcalc.cams.strength.formulas import HERTZ, pin_radius, shaft_by_stiffness, shaft_by_strength
from tmmcalc.core.records import record

NODES = 32  # of S0, and of r2 at each of them
LENGTHS = 6  # of the guide at each of these
LONGEST = 20.0  # strokes: guides that are tried
AMPLE = 2.0  # what is tried over what should do


@record
class FirstFeasible:
    """Sizes that keep all constraints [m]."""

    start: float
    roller: float
    height: float


def first_feasible(scene: Scene, low: float) -> FirstFeasible | None:
    """The lowest of the mechanisms tried with S0 above ``low``; None if none keeps all constraints."""
    roller = _roller(scene)
    high = AMPLE * _start(scene, roller)
    if high <= low:
        return None
    start = np.geomspace(low, high, NODES)
    side = np.geomspace(min(roller, low) / 4, AMPLE * max(roller, 4 * scene.stroke), NODES)
    start, side = np.repeat(start, NODES), np.tile(side, NODES)
    length = Range(np.zeros(len(start)), np.full(len(start), TALL))
    for key, own in ranges(scene, start, side).items():
        length = length.meet(own) if key in SINGLE else length
    rows = np.flatnonzero(length.some)
    least, most = length.least[rows], np.minimum(length.most[rows], LONGEST * scene.stroke + length.least[rows])
    part = np.repeat(np.linspace(0, 1, LENGTHS), len(rows))
    start, side = np.tile(start[rows], LENGTHS), np.tile(side[rows], LENGTHS)
    guide = np.tile(least, LENGTHS) + part * np.tile(most - least, LENGTHS)
    top = start + scene.stroke + side + scene.guide.gap + guide
    good = np.flatnonzero(np.all(margins(scene, start, side, top) >= 0, axis=0)) if len(rows) else rows
    if not good.size:
        return None
    k = good[int(np.argmin(top[good]))]
    return FirstFeasible(float(start[k]), float(side[k]), float(top[k]))


def _roller(scene: Scene) -> float:
    """r2 [m] that pin, contact stress and rolling resistance ask for where R is P."""
    need, force = scene.requirements, float(np.max(scene.rows.force))
    pin = need.pin or (
        0.0 if need.pin_pressure is None else float(pin_radius(force, need.pin_pressure, need.pin_ratio))
    )
    sizes = [need.roller_ratio * pin]
    if need.contact is not None and need.width is not None:
        sizes.append(AMPLE * (HERTZ / need.contact) ** 2 * need.modulus * force / need.width)
    if need.rolling_arm is not None and need.roller_friction:
        sizes.append(AMPLE * (need.rolling_arm + (need.pin_friction or 0.0) * pin) / need.roller_friction)
    return max(sizes)


def _start(scene: Scene, roller: float) -> float:
    """S0 [m] from which on curvature, shaft, stem and guide should suit with this roller."""
    need, limits, guide, force = scene.requirements, scene.limits, scene.guide, scene.rows.force
    sharp = float(np.max(np.abs(scene.motion[2])))
    couple, peak = float(np.max(scene.rows.couple)), float(np.max(force))
    least, hollow = AMPLE * (roller + limits.convex), limits.concave
    sizes = [(least + sqrt(least * least + 4 * least * sharp)) / 2, AMPLE * float(np.max(np.abs(scene.rows.drag)))]
    sizes.append((sqrt(hollow * hollow + 4 * hollow * sharp) - hollow) / 2 if limits.allow_concave else sharp)
    shaft = limits.shaft
    if need.span is not None and need.deflection is not None:
        shaft = max(shaft, float(shaft_by_stiffness(peak, need.span, need.young, need.deflection)))
    if need.span is not None and need.bending is not None:
        moment = sqrt((peak * need.span / 4) ** 2 + need.torsion * float(np.max(np.abs(scene.torque))) ** 2)
        shaft = max(shaft, float(shaft_by_strength(moment, need.bending)))
    sizes.append(AMPLE * (roller + shaft))
    if guide.stem is not None and need.bending is not None:
        sizes.append(couple * (scene.stroke + roller + guide.gap) * 4 / (need.bending * pi * guide.stem**3))
    if guide.stem is not None and guide.land is not None and need.guide_pressure is not None:
        sizes.append(couple / (need.guide_pressure * 2 * guide.land * guide.stem))
    return max(sizes)
