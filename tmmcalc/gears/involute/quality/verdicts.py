"""The verdict on a pair: every indicator with its limit, its margin and its grade.

``fail`` is a pair that cannot work, ``warn`` one that works but is not recommended.
"""

from __future__ import annotations

from math import degrees, radians
from typing import Literal

from tmmcalc.core.notes import Phrase
from tmmcalc.core.quantity import quantity
from tmmcalc.core.records import record
from tmmcalc.gears.involute.pair import Pair
from tmmcalc.gears.involute.profile.rounding import Shape
from tmmcalc.gears.involute.quality.contact import Contact, contact
from tmmcalc.gears.involute.quality.sliding import sliding_extremes

Verdict = Literal["ok", "warn", "fail"]
NOISE = 1e-12  # [module] a margin that differs from zero by rounding is met


@record
class QualityLimits:
    """What is demanded of a pair and what is wished; lengths in normal modules."""

    contact_ratio: float = 1.0  # least eps_alpha
    contact_ratio_wanted: float = 1.2
    tip_thickness: float = 0.0  # least s_na
    tip_thickness_wanted: float = 0.25  # 0.4 for hardened teeth
    angles: tuple[float, float] = (radians(15), radians(30))  # wanted alpha_tw [rad]
    sliding: float = 3.0  # wanted largest |theta|
    pressure: float | None = None  # wanted largest lambda; None: not judged
    undercut: bool = True  # whether undercut that leaves the active flank whole is tolerated


@record
class Check:
    """One indicator of the pair or of one wheel."""

    name: str = quantity("check", "contact ratio, interference, undercut, tip thickness, sliding and so on")
    wheel: int = quantity("wheel", "whose indicator it is")  # 1 or 2; 0: the pair
    value: float = quantity("value", "the indicator")
    limit: float | None = quantity("limit", "the limit that decides the verdict")  # None: not judged
    margin: float = quantity("margin", "what is left to the limit; negative: it is not kept")  # 0 if there is none
    verdict: Verdict = quantity("verdict", "ok, warn or fail")
    text: str = quantity("text", "what is wrong in words")  # empty if it is "ok"


def checks(
    pair: Pair, limits: QualityLimits | None = None, face_width: float = 0.0, fillet: Shape = "ellipse"
) -> tuple[Check, ...]:
    """Every indicator of one pair that exists (scalar shifts), with its limit; ``face_width`` in normal modules."""
    limits = limits or QualityLimits()
    if any(float(tip) <= wheel.base for tip, wheel in zip(pair.tips, pair.wheels, strict=True)):
        return (wanted_angle(float(pair.angle), limits), *(_tip(pair, wheel, limits) for wheel in (1, 2)))
    meeting = contact(pair, face_width, fillet)
    found = [wanted_angle(float(pair.angle), limits), *_ratios(meeting, limits)]
    if meeting.overlap > 0:
        found.append(Check("overlap ratio", 0, meeting.overlap, None, 0.0, "ok", ""))
        found.append(Check("total contact ratio", 0, float(meeting.total), None, 0.0, "ok", ""))
    for wheel in (1, 2):
        found += [_interference(meeting, wheel), _undercut(pair, meeting, wheel, limits), _tip(pair, wheel, limits)]
        found.append(_clearance(pair, wheel))
    return (*found, *_sliding(pair, meeting, limits))


def worst(found: tuple[Check, ...]) -> Verdict:
    """The worst verdict of all."""
    verdicts = {check.verdict for check in found}
    return "fail" if "fail" in verdicts else "warn" if "warn" in verdicts else "ok"


def at_least(name: str, wheel: int, value: float, limits: tuple[float, float], text: str) -> Check:
    """A value that has to be at least the first of the limits and ought to be at least the second."""
    least, wanted = limits
    grades: tuple[tuple[float, Verdict], ...] = ((least, "fail"), (wanted, "warn"))
    for limit, verdict in grades:
        if value < limit - NOISE:
            said = Phrase("{text} {value:.4g} below {limit:.4g}", text=text, value=value, limit=limit)
            return Check(name, wheel, value, limit, value - limit, verdict, said)
    return Check(name, wheel, value, wanted, value - wanted, "ok", "")


def wanted_angle(value: float, limits: QualityLimits) -> Check:
    """The operating pressure angle [rad], which ought to lie between two limits."""
    low, high = limits.angles
    margin, limit = min((value - low, low), (high - value, high))
    if margin >= 0:
        return Check("pressure angle", 0, value, limit, margin, "ok", "")
    text = Phrase(
        "operating pressure angle {value:.4g} deg outside {low:g}...{high:g} deg",
        value=degrees(value),
        low=degrees(low),
        high=degrees(high),
    )
    return Check("pressure angle", 0, value, limit, margin, "warn", text)


def _ratios(meeting: Contact, limits: QualityLimits) -> list[Check]:
    bounds = limits.contact_ratio, max(limits.contact_ratio, limits.contact_ratio_wanted)
    whole = at_least("contact ratio", 0, float(meeting.transverse), bounds, "transverse contact ratio")
    if float(meeting.shortened) >= float(meeting.transverse) - NOISE:
        return [whole]
    text = "transverse contact ratio of the shortened flanks"
    return [whole, at_least("shortened contact ratio", 0, float(meeting.shortened), bounds, text)]


def _interference(meeting: Contact, wheel: int) -> Check:
    value, limit = float(meeting.margins[wheel - 1] + meeting.forms[wheel - 1]), float(meeting.forms[wheel - 1])
    margin = float(meeting.margins[wheel - 1])
    if margin >= -NOISE:
        return Check("interference", wheel, value, limit, margin, "ok", "")
    text = Phrase(
        "the tip of gear {wheel} cuts into the fillet of gear {mate}, {margin:.4g} modules below its involute",
        wheel=3 - wheel,
        mate=wheel,
        margin=-margin,
    )
    return Check("interference", wheel, value, limit, margin, "fail", text)


def _undercut(pair: Pair, meeting: Contact, wheel: int, limits: QualityLimits) -> Check:
    cut = pair.wheels[wheel - 1]
    shift, least = float(cut.shift), cut.least_shift
    if shift >= least - NOISE:
        return Check("undercut", wheel, shift, least, shift - least, "ok", "")
    harmless = limits.undercut and float(meeting.margins[wheel - 1]) >= -NOISE
    values = {"wheel": wheel, "index": wheel, "shift": shift, "least": least}
    text = Phrase("gear {wheel} is undercut: x{index} = {shift:.4g} below {least:.4g}", **values)
    if float(meeting.margins[wheel - 1]) >= -NOISE:
        text = Phrase("{text}; the active flank is left whole", text=text)
    return Check("undercut", wheel, shift, least, shift - least, "warn" if harmless else "fail", text)


def _tip(pair: Pair, wheel: int, limits: QualityLimits) -> Check:
    tip, cut = pair.tips[wheel - 1], pair.wheels[wheel - 1]
    if float(tip) <= cut.base:
        text = Phrase("the tip circle of gear {wheel} lies within its base circle", wheel=wheel)
        return Check("tip thickness", wheel, float(tip), cut.base, float(tip) - cut.base, "fail", text)
    value, wanted = float(cut.thickness_at(tip)), max(limits.tip_thickness, limits.tip_thickness_wanted)
    if value < min(0.0, limits.tip_thickness) - NOISE:
        above = float(tip - cut.pointing)
        text = Phrase(
            "gear {wheel} is pointed {above:.4g} modules below its tip circle (margin: thickness {value:.4g})",
            wheel=wheel,
            above=above,
            value=value,
        )
        return Check("tip thickness", wheel, value, limits.tip_thickness, value - limits.tip_thickness, "fail", text)
    text = Phrase("tip thickness of gear {wheel}", wheel=wheel)
    return at_least("tip thickness", wheel, value, (limits.tip_thickness, wanted), text)


def _clearance(pair: Pair, wheel: int) -> Check:
    value, standard = float(pair.clearances[wheel - 1]), pair.first.rack.clearance
    text = Phrase("radial clearance at the root of gear {wheel}", wheel=wheel)
    return at_least("clearance", wheel, value, (0.0, standard), text)


def _sliding(pair: Pair, meeting: Contact, limits: QualityLimits) -> list[Check]:
    """Of the flanks that there are; nothing to be said if they do not reach each other."""
    low, high = float(meeting.starts[0]), float(pair.length - meeting.starts[1])
    if not 0 < low < high < float(pair.length):
        return []
    found = sliding_extremes(pair, (low, high))
    result = [at_most("sliding", i, abs(v), limits.sliding) for i, v in ((1, found.theta1), (2, found.theta2))]
    return [*result, at_most("pressure", 0, found.pressure_largest, limits.pressure)]


def at_most(name: str, wheel: int, value: float, wanted: float | None) -> Check:
    """A value that ought to be at most ``wanted``, if that is given."""
    if wanted is None:
        return Check(name, wheel, value, None, 0.0, "ok", "")
    if value <= wanted:
        return Check(name, wheel, value, wanted, wanted - value, "ok", "")
    what = "specific sliding" if name == "sliding" else "specific pressure"
    whose = Phrase("{what} of gear {wheel}", what=what, wheel=wheel) if wheel else what
    text = Phrase("{whose} {value:.4g} above {wanted:g}", whose=whose, value=value, wanted=wanted)
    return Check(name, wheel, value, wanted, wanted - value, "warn", text)
