"""Which step points slip whatever the height: bounds of the slip function over a range of heights.

D is the largest |C1 + C2 A/R| over the turn. At an angle of the cam R goes one way with the length of the guide, so
that over a range of heights it lies between its values at both ends; the radius of the pin, which C1 and C2 contain,
lies between what the largest R of the turn asks for with these. Where the bounds at one angle leave [-1, 1] behind,
the roller slips at every height of the range.
"""

from __future__ import annotations

import numpy as np

from tmmcalc.cams.forces.formulas import Mask
from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.optimum.extremes import blocks, spun
from tmmcalc.cams.optimum.margins import SLACK
from tmmcalc.cams.optimum.peaks import largest
from tmmcalc.cams.optimum.scene import Scene, guided_at
from tmmcalc.cams.strength.formulas import cylinder, pin_radius, resisting, slip


def may_roll(scene: Scene, start: Values, roller: Values, low: Values, high: Values) -> Mask:
    """Sizes S0, r2 (n,) whose roller is not proved to slip at every height H2 from ``low`` to ``high`` (n,) [m]."""
    parts = blocks(scene, len(start))
    return np.concatenate([_may_roll(scene, start[part], roller[part], low[part], high[part]) for part in parts])


def _may_roll(scene: Scene, start: Values, roller: Values, low: Values, high: Values) -> Mask:
    """The same of few points."""
    need, wide = scene.requirements, roller[:, None]
    arm, friction, inertia = need.rolling_arm, need.roller_friction, need.roller_inertia
    pinned = need.pin is not None or need.pin_pressure is not None
    if arm is None or friction is None or (inertia is None and (need.width is None or not pinned)):
        return np.ones(len(start), bool)
    ends = [guided_at(scene, start, roller, top) for top in (low, high)]
    least = np.minimum(ends[0].contact, ends[1].contact)
    most = np.maximum(ends[0].contact, ends[1].contact)
    works = np.all(ends[0].works & ends[1].works, axis=1) & np.all(least > 0, axis=1)
    pins = _pins(scene, np.max(least, axis=1), np.maximum(*(largest(scene.by_panel(end.contact)) for end in ends)))
    run = spun(scene, start, roller)
    resisted = [resisting(arm, need.pin_friction or 0.0, r0, friction, wide) for r0 in pins]
    masses = [cylinder(need.width or 0.0, need.roller_density, wide, r0) if inertia is None else inertia for r0 in pins]
    ratio = [run / np.where(works[:, None], size, 1.0) for size in (least, most)]
    few, many = np.minimum(*ratio), np.maximum(*ratio)
    below, above = (
        way(*(slip(np.ones(1), part, c1, mass, scene.speed, friction, wide)[0] for mass in masses))
        for way, part, c1 in ((np.minimum, few, resisted[0]), (np.maximum, many, resisted[-1]))
    )
    slips = np.any((below > 1 + SLACK) | (above < -1 - SLACK), axis=1)
    found: Mask = ~(works & slips)
    return found


def _pins(scene: Scene, least: Values, most: Values) -> list[Values]:
    """The least and the largest radius (n, 1) of the pin for R (n,) that is largest between ``least`` and ``most``."""
    need = scene.requirements
    if need.pin is not None or need.pin_pressure is None:
        return [np.full((len(least), 1), need.pin or 0.0)] * 2
    return [pin_radius(np.maximum(size, 0.0), need.pin_pressure, need.pin_ratio)[:, None] for size in (least, most)]
