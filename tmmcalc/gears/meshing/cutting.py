"""What is checked of the cutter of a ring: whether it has a tip, whether it cuts deep enough, what it cuts away."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from tmmcalc.core.notes import Phrase
from tmmcalc.gears.involute.internal.cutter import cutter_margins, largest_tip, tip_lead
from tmmcalc.gears.involute.internal.pair import InternalPair
from tmmcalc.gears.involute.internal.ring import Cutter, Ring, cutting
from tmmcalc.gears.involute.quality.verdicts import NOISE, Check, Verdict
from tmmcalc.gears.involute.wheel import Wheel
from tmmcalc.gears.meshing.refusal import millimetres
from tmmcalc.gears.meshing.task import PairTask

NAMES = ("cutter tip", "cutter depth", "cutter interference", "cutter feed")
SHORT = 0.1  # [module] by which a shallow root may shorten the pinion without a word of warning
FEWEST = 3  # teeth of a cutter that is proposed


def cutter_checks(task: PairTask, pair: InternalPair) -> tuple[Check, ...]:
    """The checks of the cutter that made the ring, none without one; lengths in modules, texts in millimetres."""
    cutter = pair.ring.cutter
    if cutter is None:
        return ()
    tip = tip_check(pair.ring, cutter, task.module, 2)
    if tip.verdict == "fail":
        return (tip,)
    return tip, *_depth(task, pair, cutter), *interference_checks(pair.ring, pair.tips[1], cutter, task.module, 2)


def blamed(checks: Sequence[Check]) -> tuple[Check, ...]:
    """The checks with a cutter that is too shallow as a failure, if others fail that are not of the cutter.

    The short teeth that it leaves the pinion are the cause of those; that these end within the base circle is not told.
    """
    failed = {check.name for check in checks if check.verdict == "fail"}
    if not failed - {*NAMES} and "cutter tip" not in failed:
        return tuple(checks)
    shallow = any(check.name == "cutter depth" and check.verdict == "warn" for check in checks)
    if not shallow and "cutter tip" not in failed:
        return tuple(checks)
    kept = [check for check in checks if (check.name, check.wheel) != ("tip circle", 1)]
    return tuple(replace(check, verdict="fail") if check.name == "cutter depth" else check for check in kept)


def cut_short(pair: InternalPair, module: float) -> str:
    """What the root that its cutter leaves the ring takes from the teeth of the pinion, in words."""
    cut = float(pair.pinion.plain_tip) - pair.tips[0]
    if pair.ring.cutter is None or cut <= NOISE:
        return ""
    return Phrase(
        "the teeth of the pinion are {cut} shorter than the rack's, to keep the clearance at the root that the cutter "
        "leaves the ring",
        cut=millimetres(cut * module),
    )


def cutter_remedy(task: PairTask, pair: InternalPair, broken: Sequence[str]) -> str:
    """What to change of the cutter, by the names of its checks that fail; empty if none does."""
    cutter, m = pair.ring.cutter, task.module
    if cutter is None:
        return ""
    told = []
    tool = _tool(pair.ring, cutter)
    if "cutter tip" in broken:
        largest = largest_tip(tool, cutter.rounding)
        least = 2 * m * _wanted(pair, cutter)
        if largest is not None and 2 * m * largest >= least:
            told.append(f"a tip diameter of the cutter from {millimetres(least)} to {millimetres(2 * m * largest)}")
        else:
            told.append("a smaller rounding or shift of the cutter")
    if "cutter depth" in broken:
        told.append(f"a tip diameter of the cutter of at least {millimetres(2 * m * _wanted(pair, cutter))}")
    if "cutter interference" in broken:
        told.append(
            _fewer(pair.ring, pair.tips[1], cutter, 0) or "another ring: no cutter with fewer teeth does better"
        )
    return "; ".join(told)


def _tool(ring: Ring, cutter: Cutter) -> Wheel:
    return Wheel(cutter.teeth, cutter.shift, ring.helix, ring.rack)


def _wanted(pair: InternalPair, cutter: Cutter) -> float:
    """Radius of the cutter's tip that leaves the pinion its whole teeth."""
    _, distance, _ = cutting(pair.ring, cutter)
    return pair.distance + float(pair.pinion.plain_tip) + pair.pinion.rack.clearance - distance


def tip_check(ring: Ring, cutter: Cutter, m: float, number: int) -> Check:
    """The land of the tip of the cutter of ring ``number``, which is not negative; ``m`` [m] is the module."""
    tool, tip = _tool(ring, cutter), cutting(ring, cutter)[2]
    diameter, lead = millimetres(2 * m * tip), tip_lead(tool, tip, cutter.rounding)
    if lead is None:
        margin = tip - cutter.rounding - tool.base
        text = (
            "the tip circle of the cutter, {diameter} in diameter, lies within its base circle, {base} "
            "(margin {margin})"
        )
        if cutter.rounding:
            text = (
                "the tip circle of the cutter, {diameter} in diameter less its rounding of {rounding}, lies within its "
                "base circle, {base} (margin {margin})"
            )
        said = Phrase(
            text,
            diameter=diameter,
            rounding=millimetres(m * cutter.rounding),
            base=millimetres(2 * m * tool.base),
            margin=millimetres(m * margin),
        )
        return Check("cutter tip", number, tip, tool.base + cutter.rounding, margin, "fail", said)
    land = 2 * lead * tip
    if land >= -NOISE:
        return Check("cutter tip", number, land, 0.0, land, "ok", "")
    text = "the tip of the cutter, {diameter} in diameter, is pointed (margin {margin})"
    if cutter.rounding:
        text = (
            "the tip of the cutter, {diameter} in diameter, is narrower than its rounding of {rounding} "
            "(margin {margin})"
        )
    rounding = millimetres(m * cutter.rounding)
    said = Phrase(text, diameter=diameter, rounding=rounding, margin=millimetres(m * land))
    return Check("cutter tip", number, land, 0.0, land, "fail", said)


def _depth(task: PairTask, pair: InternalPair, cutter: Cutter) -> Iterator[Check]:
    """The cutter's tip that leaves the pinion its whole teeth, unless these are as asked for."""
    if task.tips[0] is not None:
        return
    m, tip, wanted = task.module, cutting(pair.ring, cutter)[2], _wanted(pair, cutter)
    if tip >= wanted - SHORT:
        yield Check("cutter depth", 2, tip, wanted - SHORT, tip - wanted + SHORT, "ok", "")
        return
    text = Phrase(
        "the cutter, {diameter} in diameter, leaves the ring a root circle of only {root}, which cuts the teeth "
        "of gear 1 "
        "short by {lack}, to a tip diameter of {tip}; whole teeth need a cutter of {wanted} (margin {margin})",
        diameter=millimetres(2 * m * tip),
        root=millimetres(2 * m * pair.ring.root),
        lack=millimetres(m * (wanted - tip)),
        tip=millimetres(2 * m * pair.tips[0]),
        wanted=millimetres(2 * m * wanted),
        margin=millimetres(m * (tip - wanted)),
    )
    yield Check("cutter depth", 2, tip, wanted - SHORT, tip - wanted + SHORT, "warn", text)


def interference_checks(ring: Ring, tip: float, cutter: Cutter, m: float, number: int) -> Iterator[Check]:
    """Whether the cutter cuts away the tips of ring ``number``: as it generates, and as it is fed in radially.

    ``tip`` [module] is the radius of its tip circle, ``m`` [m] the module.
    """
    margins = cutter_margins(ring, cutter, tip)
    if margins is None:
        return
    cuts = (
        "the cutter of {teeth} teeth cuts the tips of gear {number} away (margin {margin})",
        "the cutter of {teeth} teeth trims the tips of gear {number} when it is fed in radially (margin {margin})",
    )
    verdicts: tuple[Verdict, Verdict] = ("fail", "warn")
    for place, (name, verdict, what) in enumerate(zip(NAMES[2:], verdicts, cuts, strict=True)):
        margin = margins[place]
        if margin >= -NOISE:
            yield Check(name, number, margin, 0.0, margin, "ok", "")
            continue
        told = _fewer(ring, tip, cutter, place)
        text = Phrase(what, teeth=cutter.teeth, number=number, margin=millimetres(m * margin))
        if told:
            text = Phrase("{text}: it takes {told}", text=text, told=told)
        yield Check(name, number, margin, 0.0, margin, verdict, text)


def _fewer(ring: Ring, tip: float, cutter: Cutter, place: int) -> str:
    """The most teeth of a cutter, with the rack's tip circle, that keeps a margin; empty if there is none."""
    for teeth in range(cutter.teeth - 1, FEWEST - 1, -1):
        other = replace(cutter, teeth=teeth, tip=None)
        margins = cutter_margins(ring, other, tip)
        if margins is not None and margins[place] >= 0:
            return Phrase("a cutter of at most {teeth} teeth", teeth=teeth)
    return ""
