"""How far a pinion and a ring are from every condition of their mesh, for many shifts at once; in normal modules.

Trimming interference is left out: it asks for assembly along the axis, the pair works.
"""

from __future__ import annotations

from dataclasses import replace
from math import cos, tan

import numpy as np

from tmmcalc.core.records import record
from tmmcalc.gears.involute.function import inverse_involute, involute
from tmmcalc.gears.involute.internal.pair import Tips
from tmmcalc.gears.involute.internal.ring import Ring
from tmmcalc.gears.involute.profile.form import junction
from tmmcalc.gears.involute.profile.rounding import Shape
from tmmcalc.gears.involute.quality.existence import Form, deepest, form_over_shifts
from tmmcalc.gears.involute.quality.nearest import Margin, Nearest, nearest_admitted
from tmmcalc.gears.involute.quality.verdicts import NOISE, QualityLimits
from tmmcalc.gears.involute.wheel import Wheel
from tmmcalc.gears.model import Values

CONDITIONS: dict[str, str] = {  # key -> what is wrong if it is not met
    "tip1": "the tip circle of the pinion lies within its base circle",
    "tip2": "the tip circle of the ring lies within its base circle",
    "involute": "the tip of the ring reaches beyond the base point of the pinion",
    "fillet1": "the tip of the ring cuts into the fillet of the pinion",
    "fillet2": "the tip of the pinion cuts into the fillet of the ring",
    "trochoid": "the tips collide outside the line of action",
    "contact_ratio": "the contact ratio is too small",
    "thickness1": "the tip of the pinion is too thin",
    "thickness2": "the tip of the ring is too thin",
    "clearance1": "the tip of the ring touches the root of the pinion",
    "clearance2": "the tip of the pinion touches the root of the ring",
    "undercut1": "the pinion is undercut",
}


@record
class InternalMargins:
    """Margins at n pairs of shifts; negative: not met, -inf: there is no such pair."""

    rows: Values  # (12, n) by CONDITIONS
    ratio: Values  # (n,) eps_alpha of the involutes that there are
    unequal: Values  # (n,) theta1 at A2 less theta2 at A1; nan where the contact begins beyond N1

    @property
    def least(self) -> Values:
        """The least of all (n,)."""
        smallest: Values = np.min(self.rows, axis=0)
        return smallest

    def broken(self) -> tuple[str, ...]:
        """What is wrong with the first pair."""
        return tuple(text for text, value in zip(CONDITIONS.values(), self.rows[:, 0], strict=True) if value < -NOISE)


def internal_margins(
    pinion: Wheel,
    ring: Ring,
    x1: Values,
    x2: Values,
    limits: QualityLimits | None = None,
    fillet: Shape = "ellipse",
    tips: Tips = "clear",
    form: Form | None = None,
    cut: float = 0.0,
) -> InternalMargins:
    """The margins at shifts (n,), with tips by a rule of `pair`; the shifts of pinion and ring are not read.

    ``form`` is the curvature of the pinion at the end of its involute over the shift, as `form_over_shifts` gives it;
    None: it is found exactly. The tip of the pinion is at most the plain one less ``cut``, as another mesh may ask.
    """
    limits, rack = limits or QualityLimits(), pinion.rack
    x1, x2 = np.atleast_1d(np.asarray(x1, float)), np.atleast_1d(np.asarray(x2, float))
    whole = x1 > deepest(pinion)
    first = replace(pinion, shift=np.maximum(x1, deepest(pinion)))
    outer = replace(ring, shift=0.0, cutter=None)
    second = Wheel(-ring.teeth, x2, ring.helix, ring.rack)  # as ISO 21771 has it
    with np.errstate(invalid="ignore", divide="ignore"):
        root, end = _bottom(ring, x2)
        angle, a = _mesh(pinion.teeth, ring, np.asarray(first.shift) + x2)
        g = a * np.sin(angle)
        rho1 = junction(first, fillet).curvature_radius if form is None else form(np.asarray(first.shift))
        tip1, tip2 = np.asarray(first.plain_tip) - cut, outer.plain_tip - x2
        if tips != "plain":
            tip1 = np.minimum(tip1, root - a - rack.clearance)
        if tips == "clear":
            tip2 = np.maximum(tip2, np.hypot(ring.base, g + rho1))
        start, stop = second.curvature_at(tip2) - g, first.curvature_at(tip1)
        if tips == "clear":
            start = np.maximum(start, rho1)  # but for rounding it is
        bottom = second.curvature_at(end) - g
        ratio = (np.minimum(stop, bottom) - np.maximum(start, rho1)) / pinion.base_pitch
        u = ring.teeth / pinion.teeth
        rows = np.array(
            [
                tip1 - pinion.base,
                tip2 - ring.base,
                start,
                start - rho1,
                bottom - stop,
                _trochoid(tip1, tip2, a, angle, (pinion.base, ring.base), u),
                ratio - limits.contact_ratio,
                first.thickness_at(tip1) - limits.tip_thickness,
                second.thickness_at(-tip2) - limits.tip_thickness,
                tip2 - a - np.asarray(first.root),
                root - a - tip1,
                np.full_like(x1, np.inf) if limits.undercut else x1 - pinion.least_shift,
            ]
        )
        unequal = u * stop / (stop + g) - (start + g) / (u * start)
    rows = np.where(np.isnan(rows) | ~whole, -np.inf, rows)
    return InternalMargins(rows, ratio, np.where(start > 0, unequal, np.nan))


def _mesh(teeth: int, ring: Ring, total: Values) -> tuple[Values, Values]:
    """Operating angle and centre distance of a wheel of so many teeth in the ring by x1 + x2; nan: none."""
    start = ring.signed.transverse_angle
    angle = inverse_involute(involute(start) - 2 * tan(ring.rack.angle) * total / (ring.teeth - teeth))
    angle = np.where(angle > 0, angle, np.nan)
    return angle, (ring.teeth - teeth) / (2 * cos(ring.helix)) * cos(start) / np.cos(angle)


def _bottom(ring: Ring, x2: Values) -> tuple[Values, Values]:
    """Radius of the root circle, and that where the involute ends, over the shift of the ring."""
    tool = ring.cutter
    if tool is None:
        uncut = replace(ring, shift=0.0)
        return uncut.root - x2, uncut.form - x2
    angle, a = _mesh(tool.teeth, ring, tool.shift + x2)
    wheel = Wheel(tool.teeth, tool.shift, ring.helix, ring.rack)
    tip = float(wheel.plain_tip) + ring.rack.clearance if tool.tip is None else tool.tip
    # the normal of the cutter's involute where its rounding begins passes through the centre of the rounding
    arm = max((tip - tool.rounding) ** 2 - wheel.base**2, 0.0) ** 0.5 + tool.rounding
    return a + tip, np.hypot(ring.base, a * np.sin(angle) + arm)


def _trochoid(tip1: Values, tip2: Values, a: Values, angle: Values, bases: tuple[float, float], u: float) -> Values:
    """Distance of the tips' corners where the tip circle of the pinion crosses the ring's, along that circle."""
    inv1, inv2 = (involute(np.arccos(base / tip)) for base, tip in zip(bases, (tip1, tip2), strict=True))
    inv = involute(angle)
    delta1 = np.arccos(np.clip((tip2**2 - tip1**2 - a**2) / (2 * a * tip1), -1, 1))
    delta2 = np.arccos(np.clip((tip2**2 + a**2 - tip1**2) / (2 * a * tip2), -1, 1))
    beside = tip2 * ((delta1 + inv1 - inv) / u - (delta2 + inv2 - inv))
    return np.where(tip1 + a <= tip2, tip2 - a - tip1, beside)


def margin_of(
    pinion: Wheel, ring: Ring, limits: QualityLimits | None, fillet: Shape, tips: Tips
) -> tuple[Margin, Margin]:
    """The least margin over x1 and x2 (n,), rounding forgiven: quickly to about 1e-9, and exactly."""
    form = form_over_shifts(pinion, fillet)

    def fast(x1: Values, x2: Values) -> Values:
        return internal_margins(pinion, ring, x1, x2, limits, fillet, tips, form).least + NOISE

    def exact(x1: Values, x2: Values) -> Values:
        return internal_margins(pinion, ring, x1, x2, limits, fillet, tips).least + NOISE

    return fast, exact


def nearest_internal(
    pinion: Wheel,
    ring: Ring,
    limits: QualityLimits | None = None,
    direction: float | None = None,
    fillet: Shape = "ellipse",
    tips: Tips = "clear",
) -> Nearest | None:
    """The shifts nearest to those of pinion and ring at which the pair works; None if there are none within 3.

    ``direction`` [rad] in the plane (x1, x2) confines the search to one line through the given shifts: 0 changes x1
    only, pi/2 changes x2 only, -pi/4 keeps the centre distance.

    >>> near = nearest_internal(Wheel(40), Ring(42))
    >>> near is not None and round(near.distance, 3)
    0.367
    """
    fast, _ = margin_of(pinion, ring, limits, fillet, tips)
    return nearest_admitted(fast, (float(pinion.shift), ring.shift), direction)
