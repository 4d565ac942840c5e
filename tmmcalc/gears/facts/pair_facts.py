"""The facts of one pair of gears, in the order of a calculation by hand: data, shifts, angles, distance, quality."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

from tmmcalc.gears.facts.meshes import USUAL, millimetres, written
from tmmcalc.gears.facts.pair_checks import verdict_fact
from tmmcalc.gears.facts.pair_contact import NOISE, clearance_fact, line_fact, ratio_fact, sliding_fact
from tmmcalc.gears.involute.function import involute
from tmmcalc.gears.involute.measure.angles import sexagesimal
from tmmcalc.gears.involute.rack import Section
from tmmcalc.gears.meshing.results import Measures, MeshPair
from tmmcalc.gears.meshing.task import PairTask
from tmmcalc.report.document import Fact
from tmmcalc.report.numbers import angle, number

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
    yield _involute_fact(found)
    yield _distance_fact(found)
    yield _diameter_fact(found)
    yield ratio_fact(found)
    yield line_fact(found)
    yield clearance_fact(found)
    yield sliding_fact(found)
    yield from _strength_facts(found)
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
    cut, m = Section(task.rack, task.helix), task.module
    values = {"m[m]": m, "p_n[m]": math.pi * m, "p_t[m]": math.pi * m * cut.module}
    text = f"m = {millimetres(m)}, pitch p = {millimetres(math.pi * m)}"
    text += f", transverse p_t = {millimetres(values['p_t[m]'])}" if task.helix else ""
    yield Fact("normal module", text, values)
    text = f"beta = {angle(math.degrees(task.helix))} deg"
    if task.helix:
        text += f", beta_b = {angle(math.degrees(base_helix))} deg at the base cylinder"
    yield Fact("helix angle", text, {"beta[rad]": task.helix, "beta_b[rad]": base_helix})
    rack = task.rack
    text = f"alpha = {angle(math.degrees(rack.angle))} deg, h_a* = {number(rack.addendum)}, "
    text += f"c* = {number(rack.clearance)}, rho* = {number(rack.radius, 5)}"
    if task.helix:
        text += f"\nacross the teeth rho_t* = {number(cut.radius, 6)}, rho_t = {millimetres(m * cut.radius)}"
    values = {"alpha[rad]": rack.angle, "h_a": rack.addendum, "c": rack.clearance, "rho": rack.radius}
    flat = math.pi / 4 * cut.module - rack.straight * math.tan(cut.angle) - cut.radius * math.cos(cut.angle)
    values |= {"rho_t": cut.radius, "rho_t[m]": m * cut.radius, "e_S[m]": m * flat}  # half the flat of the tip
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
        book, values = _approximate(found), {f"x_min{i}": x for i, x in least}
        if book:
            text += f"\nabout (17 - z)/17 = {' and '.join(number(x, 4) for x in book)} by the textbook"
        teeth = [(i, size.least_teeth) for i, size in enumerate(found.sizes, 1) if size.least_teeth is not None]
        text += f"\nat these shifts from {', '.join(f'z_min{i} = {number(z, 5, 1.0)}' for i, z in teeth)}"
        values |= {f"z_min{i}": z for i, z in teeth}
        yield Fact("no undercut from", text, values | ({"x_min_textbook": book} if book else {}))


def _approximate(found: MeshPair) -> list[float]:
    """The least shifts by the textbook's rule for spur wheels of the standard rack, as a check by hand."""
    rack = found.task.rack
    if found.task.helix or abs(rack.angle - math.radians(20)) > NOISE or abs(rack.straight - 1) > NOISE:
        return []
    return [(17 - size.teeth) / 17 for size in found.sizes if size.least_shift is not None]


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
        values: dict[str, Any] = {f"{symbol}[rad]": value, f"{symbol}[deg]": math.degrees(value)}
        values[f"{symbol}_dms"] = list(sexagesimal(value)[1:])
        yield Fact(label, f"{symbol} = {written(value)}", values)


def _involute_fact(found: MeshPair) -> Fact:
    """inv of both angles, and how far the flanks stand apart on reference and operating circle (4.73, 4.74)."""
    start, end, turn = float(involute(found.angle_t)), float(involute(found.angle_w)), found.turn
    values = {"inv_alpha_t": start, "inv_alpha_tw": end, "gamma[rad]": turn}
    text = f"inv alpha_t = {number(start)}"
    if found.task.kind != "rack":
        text += f", inv alpha_tw = {number(end)}"
    if abs(turn) > NOISE:
        arcs = millimetres(*(abs(turn) * size.reference for size in found.sizes))
        text += f"\ngamma = {number(turn)} rad = {number(math.degrees(turn))} deg\narcs r gamma = {arcs}"
    return Fact("involutes", text, values)


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


def _strength_facts(found: MeshPair) -> Iterator[Fact]:
    """Form factors of the teeth; those of a ring are not defined."""
    factors = [number(size.strength.factor, 5) for size in found.sizes if size.strength is not None]
    if factors:
        yield Fact("tooth form", f"Y_F = {' and '.join(factors)} with the load at the tip")


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
