"""The facts of one pair of gears, in the order of a calculation by hand: data, shifts, angles, distance, quality."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

from tmmcalc.gears.meshing.results import Measures, MeshPair
from tmmcalc.gears.meshing.task import PairTask
from tmmcalc.report.document import Fact
from tmmcalc.report.meshes import USUAL, millimetres, written
from tmmcalc.report.numbers import angle, number
from tmmcalc.report.pairchecks import verdict_fact

NOISE = 1e-9  # [modules] a flank shorter by less is whole
LENGTHS = {"g": "g = N1N2", "g_alpha": "g_alpha = A2A1"}
RULES = {
    "given": "as given",
    "given_aw": "centre distance as given",
    "max_contact_strength": "the largest x1 + x2 (point C)",
    "equal_sliding": "equal specific sliding (point D)",
    "max_contact_ratio": "the largest contact ratio (point E)",
    "zero": "zero shifts",
    "equal_shift": "x1 = -x2",
    "equal_strength": "the largest x1 + x2 with equal form factors of the teeth",
    "balanced": "farthest from every limit of the blocking contour",
}
SPLITS = {
    "equal_sliding": "equal specific sliding",
    "equal_strength": "equal form factors of the teeth",
    "max_contact_ratio": "the largest contact ratio",
    "middle": "middle of the admissible",
}


def pair_facts(found: MeshPair) -> Iterator[Fact]:
    """All facts of one pair in the order of a calculation by hand."""
    task = found.task
    yield Fact("pair", f"{task.title}, {_class(found)}", {"pair": task.title, "class": _class(found)})
    yield from _data_facts(task, found.base_helix)
    yield from _shift_facts(found)
    yield from _angle_facts(found)
    yield _distance_fact(found)
    yield _diameter_fact(found)
    yield _ratio_fact(found)
    yield _line_fact(found)
    yield _clearance_fact(found)
    yield _sliding_fact(found)
    yield from _measured_facts(found)
    yield verdict_fact(found)


def _class(found: MeshPair) -> str:
    """Spur or helical, and the class by the shifts.

    Zero, equally shifted, positive or negative, as the sum of the shifts is; of a rack the pinion's alone.
    """
    x1, x2 = found.shifts
    total = x1 + x2
    if abs(total) < NOISE:
        shifted = "equally shifted" if abs(x1) > NOISE else "zero"
    else:
        shifted = "positive" if total > 0 else "negative"
    form = {"external": "external", "internal": "internal", "rack": "rack and pinion"}[found.task.kind]
    return f"{'helical' if found.task.helix else 'spur'} {form}, {shifted}"


def _data_facts(task: PairTask, base_helix: float) -> Iterator[Fact]:
    """Teeth, module, helix, rack, face width."""
    teeth = [z for z in task.teeth if z]
    text = ", ".join(f"z_{i} = {z}" for i, z in enumerate(teeth, 1))
    values: dict[str, Any] = {"z": teeth, "wheel_names": list(task.wheels)[: len(teeth)]}
    if len(teeth) == 2:
        values["u"] = teeth[1] / teeth[0]
        text += f", u = {number(values['u'])}"
    if task.wheels != USUAL:
        text += f"\nindex 1: wheel {task.wheels[0]}" + (f", 2: wheel {task.wheels[1]}" if len(teeth) == 2 else "")
    yield Fact("teeth", text, values)
    yield Fact("normal module", f"m = {millimetres(task.module)}", {"m[m]": task.module})
    text = f"beta = {angle(math.degrees(task.helix))} deg"
    if task.helix:
        text += f", beta_b = {angle(math.degrees(base_helix))} deg at the base cylinder"
    yield Fact("helix angle", text, {"beta[rad]": task.helix, "beta_b[rad]": base_helix})
    rack = task.rack
    text = f"alpha = {angle(math.degrees(rack.angle))} deg, h_a* = {number(rack.addendum)}, "
    text += f"c* = {number(rack.clearance)}, rho* = {number(rack.radius, 5)}"
    values = {"alpha[rad]": rack.angle, "h_a": rack.addendum, "c": rack.clearance, "rho": rack.radius}
    yield Fact("basic rack", text, values)
    if task.face_width is not None:
        yield Fact("face width", f"b = {millimetres(task.face_width)}", {"b[m]": task.face_width})


def _shift_facts(found: MeshPair) -> Iterator[Fact]:
    x1, x2 = found.shifts
    values: dict[str, Any] = {"x_1": x1}
    text = f"x_1 = {number(x1)}"
    if found.task.kind != "rack":
        values |= {"x_2": x2, "x_sum": x1 + x2}
        text += f", x_2 = {number(x2)}, x_sum = {number(x1 + x2, peak=1.0)}"
    if found.task.kind == "internal":
        text += "\nsign of ISO 21771: x_2 > 0 makes the teeth of the ring thicker"
    yield Fact("shifts", text, values)
    yield Fact("choice of shifts", _rule(found.task), {"strategy": found.task.strategy})
    least = [(i, size.least_shift) for i, size in enumerate(found.sizes, 1) if size.least_shift is not None]
    if least:
        text = ", ".join(f"x_min{i} = {number(x)}" for i, x in least)
        yield Fact("no undercut from", text + _approximate(found), {f"x_min{i}": x for i, x in least})


def _approximate(found: MeshPair) -> str:
    """The least shifts by the textbook's rule for spur wheels of the standard rack, as a check by hand."""
    rack = found.task.rack
    if found.task.helix or abs(rack.angle - math.radians(20)) > NOISE or abs(rack.straight - 1) > NOISE:
        return ""
    shifts = " and ".join(number((17 - size.teeth) / 17, 4) for size in found.sizes if size.least_shift is not None)
    return f"\nabout (17 - z)/17 = {shifts} by the textbook"


def _rule(task: PairTask) -> str:
    """The rule of the shifts in words."""
    text = RULES[task.strategy]
    if task.strategy not in ("given_aw", "equal_shift"):
        return text
    given = [f"x{i}" for i, x in enumerate(task.shifts, 1) if x is not None]
    return f"{text}, {given[0]} as given" if given else f"{text}, split: {SPLITS[task.split]}"


def _angle_facts(found: MeshPair) -> Iterator[Fact]:
    for label, symbol, value in (
        ("transverse angle", "alpha_t", found.angle_t),
        ("operating angle", "alpha_tw", found.angle_w),
    ):
        values = {f"{symbol}[rad]": value, f"{symbol}[deg]": math.degrees(value)}
        yield Fact(label, f"{symbol} = {written(value)}", values)


def _distance_fact(found: MeshPair) -> Fact:
    if found.task.kind == "rack":
        text = f"r + x m = {millimetres(found.distance)}, from the axis to the datum line of the rack"
        return Fact("centre distance", text, {"a_w[m]": found.distance})
    values = {
        "a[m]": found.reference_distance,
        "a_w[m]": found.distance,
        "eta": found.stretch,
        "y": found.modification,
        "dy": found.shortening,
    }
    text = f"a = {millimetres(found.reference_distance)}, a_w = {millimetres(found.distance)}\n"
    names = ("eta", "y", "dy")
    return Fact(
        "centre distance", text + ", ".join(f"{name} = {number(values[name], peak=1.0)}" for name in names), values
    )


def _diameter_fact(found: MeshPair) -> Fact:
    """For drawings, which show diameters."""
    rows = (("d", "reference"), ("d_a", "tip"), ("d_f", "root"))
    lines = [f"{symbol} = {millimetres(*(2 * getattr(size, key) for size in found.sizes))}" for symbol, key in rows]
    return Fact("diameters", "\n".join(lines))


def _ratio_fact(found: MeshPair) -> Fact:
    values: dict[str, Any] = {"eps_alpha": found.contact_ratio, "eps_alpha_shortened": found.shortened}
    text = f"eps_alpha = {number(found.contact_ratio)}"
    if found.shortened < found.contact_ratio - NOISE:
        text += f" of the whole flanks\n{number(found.shortened)} of the involutes that there are"
    if found.task.helix and found.task.face_width is None:
        text += "\nno face width is given for eps_beta"
    elif found.task.helix:
        values |= {"eps_beta": found.overlap, "eps_gamma": found.total}
        text += f"\neps_beta = {number(found.overlap)}, eps_gamma = {number(found.total)}"
    return Fact("contact ratio", text, values)


def _line_fact(found: MeshPair) -> Fact:
    """Distances along the line of action from both base circles."""
    line, rack = found.line, found.task.kind == "rack"
    values = {"N1A2[m]": line.start, "N1P[m]": line.pitch, "N1A1[m]": line.end}
    if not rack:
        values |= {"N2A1[m]": abs(line.length - line.end), "N2P[m]": abs(line.length - line.pitch)}
        values |= {"g[m]": abs(line.length)}
    values |= {"g_alpha[m]": line.end - line.start}
    told = {key.partition("[")[0]: number(1e3 * value) for key, value in values.items()}
    groups = [("N1A2", "N1P", "N1A1"), () if rack else ("N2A1", "N2P"), ("g_alpha",) if rack else ("g", "g_alpha")]
    text = "\n".join(
        f"{', '.join(f'{LENGTHS.get(name, name)} = {told[name]}' for name in group)} mm" for group in groups if group
    )
    slack = NOISE * found.task.module
    if line.begins > line.start + slack or line.ends < line.end - slack:
        text += f"\nthe involutes that there are touch from N1K = {number(1e3 * line.begins)} "
        text += f"to {number(1e3 * line.ends)} mm"
    return Fact("line of action", text, {**values, "contact_from[m]": line.begins, "contact_to[m]": line.ends})


def _clearance_fact(found: MeshPair) -> Fact:
    text = f"{millimetres(*found.clearances)} at the roots of 1 and 2"
    return Fact("radial clearance", text, {"clearances[m]": list(found.clearances)})


def _sliding_fact(found: MeshPair) -> Fact:
    peaks = found.peaks
    if peaks is None:
        return Fact("specific sliding", "none: the flanks do not reach each other")
    text = f"theta_1 = {number(peaks.theta1, 5)} where the contact begins\n"
    text += f"theta_2 = {number(peaks.theta2, 5)} where it ends\n"
    pressures = (peaks.pressure_start, peaks.pressure_pitch, peaks.pressure_end)
    text += f"lambda = {', '.join(number(value, 5) for value in pressures)} at beginning, P, end"
    values = {
        "theta_1": peaks.theta1,
        "theta_2": peaks.theta2,
        "lambda_start": peaks.pressure_start,
        "lambda_P": peaks.pressure_pitch,
        "lambda_end": peaks.pressure_end,
        "lambda_max": peaks.pressure_largest,
    }
    return Fact("specific sliding", text, values)


def _measured_facts(found: MeshPair) -> Iterator[Fact]:
    """What the working drawings state; ``tmmcalc gears measure`` has the rest."""
    lines = [line for measures in found.measures for line in _measured(measures, found.task.measuring.body)]
    if lines:
        yield Fact("measured", "\n".join(lines))


def _measured(measures: Measures, body: str) -> Iterator[str]:
    named = f"wheel {measures.wheel}:"
    if measures.span is not None:
        yield f"{named} W = {millimetres(measures.span.length)} over {measures.span.teeth} teeth"
        named = " " * len(named)
    if measures.balls is not None:
        yield f"{named} M = {millimetres(measures.balls.size)} with {body} of {millimetres(measures.balls.diameter)}"
