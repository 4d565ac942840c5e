"""What is checked of a wheel without a mate: undercut, its tip, the cutter of a ring; lengths in modules."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.core.notes import Phrase
from tmmcalc.gears.involute.quality.verdicts import NOISE, Check, Verdict, at_least
from tmmcalc.gears.meshing.cutting import interference_checks, tip_check
from tmmcalc.gears.meshing.sizes import Gear
from tmmcalc.gears.single.task import WheelTask


def checks(task: WheelTask, gear: Gear) -> tuple[Check, ...]:
    """Every condition of one wheel with its limit and its margin."""
    return tuple(_checks(task, gear))


def _checks(task: WheelTask, gear: Gear) -> Iterator[Check]:
    if task.kind == "internal" and task.cutter is not None:
        tip = tip_check(task.ring, task.cutter, task.module, 1)
        yield tip
        if tip.verdict != "fail":
            yield from interference_checks(task.ring, gear.tip, task.cutter, task.module, 1)
    if task.kind == "external":
        yield _undercut(task, gear)
    above = gear.tip - gear.base
    if above < 0:
        text = "the tip circle lies within the base circle: there is no involute"
        yield Check("tip circle", 1, gear.tip, gear.base, above, "fail", text)
        return
    side = -1.0 if task.kind == "internal" else 1.0
    thickness = float(gear.wheel.thickness_at(side * gear.tip))
    limits = task.tip_thickness, max(task.tip_thickness, task.tip_thickness_wanted)
    if thickness < 0:
        text = Phrase(
            "the tooth is pointed below its tip circle (margin: thickness {thickness:.4g})", thickness=thickness
        )
        yield Check("tip thickness", 1, thickness, limits[0], thickness - limits[0], "fail", text)
        return
    yield at_least("tip thickness", 1, thickness, limits, "tip thickness")


def _undercut(task: WheelTask, gear: Gear) -> Check:
    least = gear.wheel.least_shift
    margin = task.shift - least
    if margin >= -NOISE:
        return Check("undercut", 1, task.shift, least, margin, "ok", "")
    verdict: Verdict = "warn" if task.undercut else "fail"
    text = Phrase("the tooth is undercut: x = {shift:.4g} below {least:.4g}", shift=task.shift, least=least)
    return Check("undercut", 1, task.shift, least, margin, verdict, text)
