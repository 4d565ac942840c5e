"""Oscillating slotted link with a rod and a slider, the crank shorter than the line of centres (r < L).

-----[E]------------  guide y = e          C: pivot of the slotted link, A straight above it
      `. l     /D                          extremes: the crank stands across the slotted link
         ` . /                             psi = 2 phi = 180 (K - 1)/(K + 1), sin(phi) = r/L
           /  B                            R = S/(2 sin phi): the ends of D are equally high
         C                                 l = max(|e - R|, |e - R cos phi|)/sin(nu_max)
"""

from __future__ import annotations

import math
from collections.abc import Iterator

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.notes import Said, held
from tmmcalc.linkage.synthesis.designs import ClosedForm, closed_form
from tmmcalc.linkage.synthesis.results import PRESSURE, Size, Synthesis
from tmmcalc.linkage.synthesis.slottedpost import Lengths, checked, checks
from tmmcalc.linkage.synthesis.strokes import overlap
from tmmcalc.linkage.synthesis.task import SlottedTask, SynthesisTask

RULE = "the sizes follow one from another"
KIND = "slotted_link"


def solve(task: SynthesisTask) -> Synthesis:
    """The slotted link with the stroke and time ratio asked for; raises `NoSolutionError` where there is none."""
    asked: SlottedTask = task.asked
    phi = _half_swing(asked.time_ratio)
    arm = asked.stroke / (2 * math.sin(phi))
    crank, centres, guide = _layout(asked, phi)
    levers = abs(guide - arm), abs(guide - arm * math.cos(phi))
    rod = asked.rod if asked.rod is not None else max(levers) / math.sin(asked.pressure or math.nan)
    if rod <= max(levers) or not max(levers):
        raise NoSolutionError(
            f"the rod, {1e3 * rod:.6g} mm, is not longer than the distance of its pin D from the guide, "
            f"{1e3 * max(levers):.6g} mm",
            where=f"synthesis.{KIND}",
            value=rod,
            limit=max(levers),
            remedy="change guide, or give a longer rod",
        )
    tilt = math.degrees(math.asin(levers[1] / rod)) + math.degrees(phi)
    if guide > arm * math.cos(phi) and tilt >= 90:
        raise NoSolutionError(
            "the slider turns back before the slotted link does: at the ends the swing and the pressure angle make "
            f"{tilt:.6g} deg, and the rod stands along the path of its pin D at 90 deg",
            where=f"synthesis.{KIND}",
            value=tilt,
            limit=90.0,
            remedy="ask for a smaller time ratio or pressure angle, or a longer rod",
        )
    return closed_form(task, KIND, RULE, [_closed(task, asked, phi, (crank, centres, arm, rod, guide))])


def _half_swing(ratio: float) -> float:
    phi = overlap(ratio) / 2
    if phi <= 0:
        raise NoSolutionError(
            f"K = {ratio:g} gives no swing: the slotted link would be endless",
            where=f"synthesis.{KIND}, time_ratio",
            value=ratio,
            limit=1.0,
            remedy="ask for K > 1",
        )
    return phi


def _layout(asked: SlottedTask, phi: float) -> tuple[float, float, float]:
    """Crank r, line of centres L and guide e: what is not given follows from r = L sin(phi) and e = L + k r."""
    sine, k = math.sin(phi), asked.clearance
    if asked.crank is not None:
        crank, centres = asked.crank, asked.crank / sine
    elif asked.centres is not None:
        crank, centres = asked.centres * sine, asked.centres
    else:
        crank = (asked.guide or math.nan) / (1 / sine + k)
        centres = crank / sine
    return crank, centres, centres + k * crank if asked.guide is None else asked.guide


def _closed(task: SynthesisTask, asked: SlottedTask, phi: float, lengths: Lengths) -> ClosedForm:
    crank, centres, arm, rod, guide = lengths
    found = checked(task, lengths)
    sizes = (
        Size("r", crank, "m", "crank AB"),
        Size("L", centres, "m", "line of centres CA"),
        Size("R", arm, "m", "arm CD of the slotted link"),
        Size("l", rod, "m", "connecting rod DE"),
        Size("e", guide, "m", "guide over the pivot C"),
        Size("two_phi", 2 * phi, "rad", "swing of the slotted link"),
        Size("psi", 2 * phi, "rad", "overlap angle"),
        Size("phi_zero", -phi, "rad", "crank at the far end of the stroke"),
        Size("phi_second", math.pi + phi, "rad", "crank at the near end of the stroke"),
    )
    merits = {PRESSURE.key: math.degrees(found.pressure), "r/L": crank / centres}
    made, notes = tuple(checks(asked, found)), tuple(_notes(crank, centres, arm, guide))
    return ClosedForm("oscillating slotted link", sizes, made, merits, found.mechanism, found.simulation, notes)


def _notes(crank: float, centres: float, arm: float, guide: float) -> Iterator[Said]:
    if arm < centres + crank:
        text = (
            "the block goes up to L + r = {value:.6g} mm from C, beyond the end D of the arm at R = {limit:.6g} mm: "
            "the slot is longer than the arm"
        )
        yield held("note", text, centres + crank, arm, "m", shown="mm", name="L + r")
    if guide < centres + crank:
        text = (
            "the guide, {value:.6g} mm over C, passes through the circle of the crank pin, which reaches {limit:.6g} mm"
        )
        yield held("warning", text, guide, centres + crank, "m", shown="mm", name="height of the guide")
