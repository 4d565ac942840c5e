"""Which lengths l of the guide the constraints leave at given S0 and r2, in closed form.

With y = 1/l and what `extremes` calls S, T, v and P, every force is a quotient of linear functions of y,

    R = P v/(S - sense f |T| (1 + 2 q y)),   |N1| = R |T| (1 + q y)/v,   |M_T| = R |T| q/v

so a limit for it is a linear inequality a y <= b at every angle of the cam: the least and the largest y are extremes
of quotients. What limits R itself (pin, shaft, contact) needs no y. Constraint 2 alone is not of this kind where the
pin depends on the largest R. A length outside the range breaks a constraint at a node, so the range is an outer bound
of what is feasible: nothing beyond it has to be looked at.
"""

from __future__ import annotations

from collections.abc import Callable
from math import pi

import numpy as np

from tmmcalc.cams.forces.formulas import Mask, protrusion
from tmmcalc.cams.laws.law import Indices, Values
from tmmcalc.cams.optimum.extremes import blocks, pitch
from tmmcalc.cams.optimum.margins import SLACK
from tmmcalc.cams.optimum.peaks import largest
from tmmcalc.cams.optimum.scene import Scene, by_panel
from tmmcalc.cams.strength.formulas import ROUNDING, WHOLE, allowed_square, concave_margin, convex_margin
from tmmcalc.core.records import record

TALL = 1e9  # a guide as long as you please [m]
NEVER = 1e-200  # [N] a limit that nothing keeps
SINGLE = (3, 4, 5, 6, 7, 8, 9)  # constraints that are bounded here


@record
class Range:
    """Lengths of the guide (B,) that constraints leave; none where ``least`` is TALL."""

    least: Values  # [m]
    most: Values  # [m]

    def meet(self, other: Range) -> Range:
        """What both leave."""
        least, most = np.maximum(self.least, other.least), np.minimum(self.most, other.most)
        none = least > most
        return Range(np.where(none, TALL, least), np.where(none, 0.0, most))

    def of(self, rows: Indices) -> Range:
        """Those of some rows, which may repeat."""
        return Range(self.least[rows], self.most[rows])

    @property
    def some(self) -> Mask:
        """Where there is any length (B,)."""
        found: Mask = (self.least <= self.most) & (self.least < TALL)
        return found


Held = Callable[[Values], Range]  # the range in which R keeps a limit


def ranges(scene: Scene, start: Values, roller: Values) -> dict[int, Range]:
    """The range of every constraint of SINGLE by its number, at S0 and r2 (B,)."""
    parts = [_ranges(scene, start[part], roller[part]) for part in blocks(scene, len(start))]
    return {
        k: Range(np.concatenate([p[k].least for p in parts]), np.concatenate([p[k].most for p in parts]))
        for k in SINGLE
    }


def _ranges(scene: Scene, start: Values, roller: Values) -> dict[int, Range]:
    need, limits, guide, rows, r2 = scene.requirements, scene.limits, scene.guide, scene.rows, roller[:, None]
    slow, bend = pitch(scene, start)
    least, most = np.min(bend, axis=1), np.max(bend, axis=1)
    convex = convex_margin(most, roller, limits.convex)
    concave = concave_margin(least, roller, limits.concave) if limits.allow_concave else least
    per = 1 / protrusion(scene.motion, scene.stroke, r2, guide.gap)
    useful, force, lever = (
        (start[:, None] + (scene.motion[0] - rows.drag)) * per,
        rows.force / slow * per,
        2 * rows.drag,
    )

    def held(limit: Values) -> Range:
        """R <= limit."""
        return solved(lever, useful - force / np.maximum(limit, NEVER))

    every = held(np.full((1, 1), np.inf))
    found = {3: masked(convex >= -SLACK), 4: masked(concave >= -SLACK), **dict.fromkeys(SINGLE[2:], every)}
    pin = None if need.pin is None else np.full((1, 1), need.pin)
    if need.pin_pressure is not None:
        widest = r2 / need.roller_ratio if pin is None else pin
        found[5] = held(4 * need.pin_ratio * need.pin_pressure * widest**2)
    if need.pin is not None:
        found[5] = found[5].meet(masked(roller >= need.roller_ratio * need.pin * (1 - SLACK)))
    found[6] = _shafted(scene, start, roller, every, held)
    if need.bending is not None and guide.stem is not None:
        limit = need.bending * pi * guide.stem**3 / 4
        found[7] = every.meet(solved(lever, useful - rows.couple / limit))
    if need.guide_pressure is not None and guide.stem is not None and guide.land is not None:
        limit = need.guide_pressure * 2 * guide.land * guide.stem
        pressed = rows.couple / limit
        found[8] = every.meet(solved(lever + pressed, useful - pressed * per))
    if need.contact is not None and need.width is not None:
        gap = r2 * (1 - bend * r2)
        found[9] = held(allowed_square(need.contact, need.width, need.modulus) * gap)
    return found


def _shafted(scene: Scene, start: Values, roller: Values, every: Range, held: Held) -> Range:
    """The range of constraint 6: the shaft has to be within the base circle, in whole mm."""
    need = scene.requirements
    room = np.hypot(start, scene.follower.offset) - roller
    radius = np.maximum(WHOLE * np.floor(room / WHOLE + ROUNDING), 0.0)[:, None]
    found = every.meet(masked(room >= scene.limits.shaft * (1 - SLACK)))
    if need.span is not None and need.deflection is not None:
        found = found.meet(held(radius**4 * 12 * pi * need.young * need.deflection / need.span**3))
    if need.span is not None and need.bending is not None:
        moment = pi * need.bending * radius**3 / 4
        square = moment**2 - need.torsion * scene.torque**2
        found = found.meet(held(4 / need.span * np.sqrt(np.maximum(square, 0.0))))
    return found


def masked(works: Mask) -> Range:
    """Any length, or none."""
    return Range(np.where(works, 0.0, TALL), np.where(works, TALL, 0.0))


def solved(a: Values, b: Values, panels: int = 0) -> Range:
    """The lengths 1/y with a y <= b, a (M,) and b (B, M), at all nodes and y > 0.

    With the number of ``panels`` the least length is that of all angles, not of the nodes alone.
    """
    level = a == 0
    ratio = b / np.where(level, 1.0, a)
    high = np.min(np.maximum(ratio, np.where(a > 0, -np.inf, TALL)), axis=1, initial=TALL)
    low = np.max(np.minimum(ratio, np.where(a < 0, np.inf, 1 / TALL)), axis=1, initial=1 / TALL)
    none = np.any(b[:, np.flatnonzero(level)] < -SLACK, axis=1) | (high <= 0) | (high < low)
    least = 1 / np.where(none, 1.0, high)
    if panels:
        left = by_panel(np.where(a < 0, 1.0, b), panels)
        pull = by_panel(np.maximum(a, 0.0), panels) / np.where(left > 0, left, 1.0)
        short, longest = largest(np.concatenate((-left, pull))).reshape(2, -1)
        none |= short > SLACK
        least = np.maximum(least, longest)
    return Range(np.where(none, TALL, least), np.where(none, 0.0, 1 / low))
