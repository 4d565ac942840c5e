"""The verdict on a pinion and its rack, in the manner of `quality.verdicts`; gear 2 is the rack.

The rack is the shape of the tool that cut the pinion, but no longer: so its tip never cuts into a fillet, even of an
undercut pinion. Undercut shortens the contact, and the contact ratio tells whether what is left will do. Only a rack
with longer teeth than the straight flanks of the tool interferes.
"""

from __future__ import annotations

from collections.abc import Callable
from math import ceil, pi, sin, tan

import numpy as np

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.notes import Phrase
from tmmcalc.gears.involute.quality.verdicts import NOISE, Check, QualityLimits, at_least, at_most, wanted_angle
from tmmcalc.gears.involute.rackpair import RackPair

REACH, STEP = 3.0, 0.02  # how far from the given shift an admissible one is sought


def rack_checks(pair: RackPair, limits: QualityLimits) -> tuple[Check, ...]:
    """Every indicator of a pinion and its rack with its limit."""
    pinion = pair.pinion
    tips = limits.tip_thickness, max(limits.tip_thickness, limits.tip_thickness_wanted)
    thickness = float(pinion.thickness_at(pair.tip)), pi / 2 - 2 * pair.addendum * tan(pinion.rack.angle)
    found = [wanted_angle(pinion.transverse_angle, limits), *_ratios(pair, limits)]
    found += [_own_interference(pair), _rack_interference(pair), _undercut(pair, limits)]
    for i, (value, clearance) in enumerate(zip(thickness, pair.clearances, strict=True), 1):
        text = "tip thickness of the rack" if i == 2 else "tip thickness of gear 1"
        found.append(at_least("tip thickness", i, value, tips, text))
        bounds = 0.0, pinion.rack.clearance
        text = "radial clearance at the root of the rack" if i == 2 else "radial clearance at the root of gear 1"
        found.append(at_least("clearance", i, clearance, bounds, text))
    return (*found, *_sliding(pair, limits))


def contact_ends(pair: RackPair) -> tuple[float, float]:
    """rho1 where the contact begins and ends on the involute that there is."""
    start, end = pair.segment
    return max(start, pair.form), end


def _ratios(pair: RackPair, limits: QualityLimits) -> list[Check]:
    bounds = limits.contact_ratio, max(limits.contact_ratio, limits.contact_ratio_wanted)
    whole = at_least("contact ratio", 0, pair.contact_ratio, bounds, "transverse contact ratio")
    if pair.shortened >= pair.contact_ratio - NOISE:
        return [whole]
    text = "transverse contact ratio of the shortened flanks"
    return [whole, at_least("shortened contact ratio", 0, pair.shortened, bounds, text)]


def _own_interference(pair: RackPair) -> Check:
    """The tip of the rack at the fillet of the pinion."""
    value, margin = pair.segment[0], pair.margin
    if margin >= -NOISE:
        return Check("interference", 1, value, pair.form, margin, "ok", "")
    if pair.addendum <= pair.pinion.rack.straight + NOISE:
        text = Phrase(
            "undercut shortens the active flank of gear 1 by {margin:.4g} modules of the line of action", margin=-margin
        )
        return Check("interference", 1, value, pair.form, margin, "warn", text)
    text = Phrase(
        "the tip of the rack cuts into the fillet of gear 1, {margin:.4g} modules below its involute", margin=-margin
    )
    return Check("interference", 1, value, pair.form, margin, "fail", text)


def _rack_interference(pair: RackPair) -> Check:
    """The tip of the pinion at the fillet of the rack, whose straight flanks are as deep as those of the tool."""
    pinion = pair.pinion
    deepest = pair.pitch_curvature + (pinion.rack.straight + float(pinion.shift)) / sin(pinion.transverse_angle)
    end = pair.segment[1]
    margin = deepest - end
    if margin >= -NOISE:
        return Check("interference", 2, end, deepest, margin, "ok", "")
    text = Phrase(
        "the tip of gear 1 cuts into the fillet of the rack, {margin:.4g} modules beyond its straight flank",
        margin=-margin,
    )
    return Check("interference", 2, end, deepest, margin, "fail", text)


def _undercut(pair: RackPair, limits: QualityLimits) -> Check:
    shift, least = float(pair.pinion.shift), pair.pinion.least_shift
    if shift >= least - NOISE:
        return Check("undercut", 1, shift, least, shift - least, "ok", "")
    text = Phrase("gear 1 is undercut: x1 = {shift:.4g} below {least:.4g}", shift=shift, least=least)
    return Check("undercut", 1, shift, least, shift - least, "warn" if limits.undercut else "fail", text)


def _sliding(pair: RackPair, limits: QualityLimits) -> list[Check]:
    """Nothing to be said if the flanks do not reach each other or touch at N1."""
    (low, high), pitch = contact_ends(pair), pair.pitch_curvature
    if not 0 < low < high:
        return []
    result = [at_most("sliding", 1, abs(1 - pitch / low), limits.sliding)]
    return [*result, at_most("sliding", 2, abs(1 - high / pitch), limits.sliding), _pressure(low, limits)]


def _pressure(low: float, limits: QualityLimits) -> Check:
    return at_most("pressure", 0, 1 / low, limits.pressure)


def nearest_shift(build: Callable[[float], RackPair], shift: float, limits: QualityLimits) -> float | None:
    """The shift nearest to a given one at which nothing fails, with four decimals; None: none within 3."""

    def works(x: float) -> bool:
        try:
            return all(check.verdict != "fail" for check in rack_checks(build(x), limits))
        except NoSolutionError:
            return False

    for size in np.arange(STEP, REACH + STEP / 2, STEP).tolist():
        for sign in (1.0, -1.0):
            if works(shift + sign * size):
                return _refined(works, shift, sign, size)
    return None


def _refined(works: Callable[[float], bool], shift: float, sign: float, size: float) -> float:
    """The nearest number of four decimals between the last step that fails and the first that works."""
    low, high = size - STEP, size
    while high - low > 1e-6:
        middle = (low + high) / 2
        low, high = (low, middle) if works(shift + sign * middle) else (middle, high)
    exact = shift + sign * high
    rounded = sign * ceil(sign * exact * 1e4) / 1e4
    return rounded if works(rounded) else exact
