"""The facts of the contact of one pair: contact ratios, line of action, clearances, sliding and pressure."""

from __future__ import annotations

from tmmcalc.core.quantity import keyed
from tmmcalc.gears.facts.meshes import millimetres
from tmmcalc.gears.meshing.results import NOISE, MeshPair, SlidingPeaks
from tmmcalc.report.document import Fact
from tmmcalc.report.numbers import number

LENGTHS = {"g": "g = N1N2", "g_alpha": "g_alpha = A2A1"}


def ratio_fact(found: MeshPair) -> Fact:
    """Contact ratios of the whole flanks, and of the involutes that there are."""
    values = keyed(found, "contact_ratio", "shortened")
    text = f"eps_alpha = {number(found.contact_ratio)}"
    if found.shortened < found.contact_ratio - NOISE:
        text += f" of the whole flanks\n{number(found.shortened)} of the involutes that there are"
    if found.task.helix and found.task.face_width is None:
        text += "\nno face width is given for eps_beta"
    elif found.task.helix:
        values |= keyed(found, "overlap", "total", "total_left")
        text += f"\neps_beta = {number(found.overlap)}, eps_gamma = {number(found.total)}"
        if found.shortened < found.contact_ratio - NOISE:
            text += f"\neps_gamma = {number(found.total_left)} of the involutes that there are"
    return Fact("contact ratio", text, values)


def line_fact(found: MeshPair) -> Fact:
    """Distances along the line of action from both base circles."""
    line, rack = found.line, found.task.kind == "rack"
    of_second = [] if rack else ["end_from_second", "pitch_from_second", "between"]
    values = keyed(line, "start", "pitch", "end", *of_second, "path")
    told = {key.partition("[")[0]: number(1e3 * value) for key, value in values.items()}
    groups = [("N1A2", "N1P", "N1A1"), () if rack else ("N2A1", "N2P"), ("g_alpha",) if rack else ("g", "g_alpha")]
    text = "\n".join(
        f"{', '.join(f'{LENGTHS.get(name, name)} = {told[name]}' for name in group)} mm" for group in groups if group
    )
    slack = NOISE * found.task.module
    if line.begins > line.start + slack or line.ends < line.end - slack:
        text += f"\nthe involutes that there are touch from N1K = {number(1e3 * line.begins)} "
        text += f"to {number(1e3 * line.ends)} mm"
    return Fact("line of action", text, values | keyed(line, "begins", "ends"))


def clearance_fact(found: MeshPair) -> Fact:
    """Radial clearances at both roots."""
    text = f"{millimetres(*found.clearances)} at the roots of 1 and 2"
    return Fact("radial clearance", text, keyed(found, "clearances"))


def sliding_fact(found: MeshPair) -> Fact:
    """theta and lambda at the ends of the contact, and of the involutes that there are if these differ."""
    peaks = found.peaks
    if peaks is None:
        return Fact("specific sliding", "none: the flanks do not reach each other")
    text, values = _peaks_text(peaks), keyed(peaks)
    left = found.peaks_left
    if left is None:
        text += "\nthe involutes that there are do not reach each other"
    elif _differ(peaks, left):
        text += f"\nof the involutes that there are:\n{_peaks_text(left)}"
        values |= {f"{key}_left": value for key, value in keyed(left).items()}
    return Fact("specific sliding", text, values)


def _differ(one: SlidingPeaks, two: SlidingPeaks) -> bool:
    pairs = zip(keyed(one).values(), keyed(two).values(), strict=True)
    return any(abs(first - second) > NOISE * abs(first) for first, second in pairs)


def _peaks_text(peaks: SlidingPeaks) -> str:
    pressures = (peaks.pressure_start, peaks.pressure_pitch, peaks.pressure_end)
    return (
        f"theta_1 = {number(peaks.theta1, 5)} where the contact begins\n"
        f"theta_2 = {number(peaks.theta2, 5)} where it ends\n"
        f"lambda = {', '.join(number(value, 5) for value in pressures)} at beginning, P, end"
    )
