"""The verdict on a pinion in a ring, and why such a pair cannot be."""

from __future__ import annotations

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.notes import Phrase
from tmmcalc.gears.involute.internal.contact import internal_contact, internal_extremes
from tmmcalc.gears.involute.internal.interference import interferences
from tmmcalc.gears.involute.internal.margins import margin_of
from tmmcalc.gears.involute.internal.pair import InternalPair, Tips
from tmmcalc.gears.involute.profile.rounding import Shape
from tmmcalc.gears.involute.quality.nearest import told_nearest
from tmmcalc.gears.involute.quality.verdicts import Check, QualityLimits, Verdict, at_least, at_most, wanted_angle


def internal_checks(
    pair: InternalPair, limits: QualityLimits | None = None, face_width: float = 0.0, fillet: Shape = "ellipse"
) -> tuple[Check, ...]:
    """Every indicator of an internal pair with its limit; ``face_width`` in normal modules.

    Trimming interference is a warning: the pair works, but is assembled along its axis.
    """
    limits = limits or QualityLimits()
    base = _above_base(pair)
    if base:
        return base
    least, wanted = limits.contact_ratio, max(limits.contact_ratio, limits.contact_ratio_wanted)
    meeting = internal_contact(pair, face_width, fillet)
    found = [
        wanted_angle(pair.angle, limits),
        at_least("contact ratio", 0, meeting.shortened, (least, wanted), "transverse contact ratio"),
    ]
    for each in interferences(pair, fillet):
        verdict: Verdict = "ok" if each.free else "warn" if each.kind == "trimming" else "fail"
        found.append(Check(f"{each.kind} interference", 0, each.margin, 0.0, each.margin, verdict, each.text))
    thickness = float(pair.pinion.thickness_at(pair.tips[0])), pair.ring.thickness_at(pair.tips[1])
    tips = limits.tip_thickness, max(limits.tip_thickness, limits.tip_thickness_wanted)
    for i, (value, clearance) in enumerate(zip(thickness, pair.clearances, strict=True), 1):
        found.append(at_least("tip thickness", i, value, tips, Phrase("tip thickness of gear {wheel}", wheel=i)))
        c = pair.pinion.rack.clearance
        found.append(
            at_least(
                "clearance", i, clearance, (0.0, c), Phrase("radial clearance at the root of gear {wheel}", wheel=i)
            )
        )
    return (*found, *_sliding(pair, meeting.segment, limits))


def _above_base(pair: InternalPair) -> tuple[Check, ...]:
    """Failures of tips that do not lie above their base circles."""
    found = []
    for i, (tip, base) in enumerate(zip(pair.tips, (pair.pinion.base, pair.ring.base), strict=True), 1):
        if tip < base:
            text = Phrase("the tip circle of gear {wheel} lies within its base circle", wheel=i)
            found.append(Check("tip circle", i, tip, base, tip - base, "fail", text))
    return tuple(found)


def _sliding(pair: InternalPair, segment: tuple[float, float], limits: QualityLimits) -> list[Check]:
    if not 0 < segment[0] < segment[1]:
        return []
    found = internal_extremes(pair, segment)
    result = [at_most("sliding", i, abs(v), limits.sliding) for i, v in ((1, found.theta1), (2, found.theta2))]
    return [*result, at_most("pressure", 0, found.pressure_largest, limits.pressure)]


def require_internal(
    pair: InternalPair,
    limits: QualityLimits | None = None,
    tips: Tips = "clearance",
    fillet: Shape = "ellipse",
) -> None:
    """Raise `NoSolutionError` if an internal pair cannot work, with every reason, its margin and the nearest shift.

    ``tips`` is the rule by which the tips of other shifts are found.
    """
    broken = _failures(pair, limits, fillet)
    if not broken:
        return
    least = min(broken, key=lambda check: check.margin)
    raise NoSolutionError(
        "; ".join(f"{check.text} (margin {check.margin:.4g})" for check in broken),
        where="internal pair",
        value=least.value,
        limit=least.limit,
        remedy=_remedy(pair, limits, tips, fillet),
    )


def _failures(pair: InternalPair, limits: QualityLimits | None, fillet: Shape) -> list[Check]:
    return [check for check in internal_checks(pair, limits, fillet=fillet) if check.verdict == "fail"]


def _remedy(pair: InternalPair, limits: QualityLimits | None, tips: Tips, fillet: Shape) -> str:
    """The nearest shifts in the plane, of the pinion alone, of the ring alone, and at the same centre distance."""
    fast, exact = margin_of(pair.pinion, pair.ring, limits, fillet, tips)
    return told_nearest(fast, exact, (float(pair.pinion.shift), pair.ring.shift)) or (
        "no nearby shifts make this pair possible: a greater difference of the teeth, or shorter teeth (stub rack)"
    )
