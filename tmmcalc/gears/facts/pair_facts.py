"""The facts of one pair of gears, in the order of a calculation by hand: data, shifts, angles, distance, quality."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

from tmmcalc.core.notes import Phrase
from tmmcalc.core.quantity import Quantity, components, keyed, quantities
from tmmcalc.gears.facts.meshes import USUAL, millimetres, written
from tmmcalc.gears.facts.pair_checks import verdict_fact
from tmmcalc.gears.facts.pair_contact import clearance_fact, line_fact, ratio_fact, sliding_fact
from tmmcalc.gears.involute.measure.angles import sexagesimal
from tmmcalc.gears.meshing.results import NOISE, Measures, MeshPair
from tmmcalc.gears.meshing.task import PairTask
from tmmcalc.report.document import Fact
from tmmcalc.report.numbers import angle, number

CLASS = Quantity("class", "class of the pair")
FORMS = {  # of spur and of helical teeth
    "external": ("spur external", "helical external"),
    "internal": ("spur internal", "helical internal"),
    "rack": ("spur rack and pinion", "helical rack and pinion"),
}

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
    yield Fact("pair", f"{task.title}, {_class(found)}", {"pair": task.title, **CLASS.value(_class(found))})
    yield from _data_facts(found)
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
    yield verdict_fact(found.checks)


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
    return Phrase("{form}, {shift}", form=FORMS[found.task.kind][bool(found.task.helix)], shift=shifted)


def _data_facts(found: MeshPair) -> Iterator[Fact]:
    """Teeth, module, helix, rack, face width."""
    task = found.task
    teeth = [z for z in task.teeth if z]
    text = ", ".join(f"z_{i} = {z}" for i, z in enumerate(teeth, 1))
    values: dict[str, Any] = {"z": teeth, "wheel_names": list(task.wheels)[: len(teeth)]}
    if len(teeth) == 2:
        values["u"] = teeth[1] / teeth[0]
        text += f", u = {number(values['u'])}"
    if task.wheels != USUAL:
        text += f"\nindex 1: wheel {task.wheels[0]}" + (f", 2: wheel {task.wheels[1]}" if len(teeth) == 2 else "")
    yield Fact("teeth", text, values)
    text = f"m = {millimetres(task.module)}, pitch p = {millimetres(task.pitch)}"
    text += f", transverse p_t = {millimetres(task.transverse_pitch)}" if task.helix else ""
    yield Fact("normal module", text, keyed(task, "module", "pitch", "transverse_pitch"))
    text = f"beta = {angle(math.degrees(task.helix))} deg"
    if task.helix:
        text += f", beta_b = {angle(math.degrees(found.base_helix))} deg at the base cylinder"
    yield Fact("helix angle", text, keyed(task, "helix") | keyed(found, "base_helix"))
    rack, cut = task.rack, task.section
    text = f"alpha = {angle(math.degrees(rack.angle))} deg, h_a* = {number(rack.addendum)}, "
    text += f"c* = {number(rack.clearance)}, rho* = {number(rack.radius, 5)}"
    if task.helix:
        text += f"\nacross the teeth rho_t* = {number(cut.radius, 6)}, rho_t = {millimetres(task.rounding)}"
    values = keyed(rack) | keyed(cut) | keyed(task, "rounding", "tip_flat")
    yield Fact("basic rack", text, values)
    if task.face_width is not None:
        yield Fact("face width", f"b = {millimetres(task.face_width)}", keyed(task, "face_width"))


def _shift_facts(found: MeshPair) -> Iterator[Fact]:
    x1, x2 = found.shifts
    values = components(found, "shifts", wheel=(1, 2))
    text = f"x_1 = {number(x1)}"
    if found.task.kind != "rack":
        values |= keyed(found, "shift_sum")
        text += f", x_2 = {number(x2)}, x_sum = {number(found.shift_sum, peak=1.0)}"
    else:
        values.popitem()  # a rack has no shift of its own
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
    told = quantities(MeshPair)
    for label, name in (("transverse angle", "angle_t"), ("operating angle", "angle_w")):
        value: float = getattr(found, name)
        symbol = told[name].name
        values = {**keyed(found, name), f"{symbol}_dms": list(sexagesimal(value)[1:])}
        yield Fact(label, f"{symbol} = {written(value)}", values)


def _involute_fact(found: MeshPair) -> Fact:
    """inv of both angles, and how far the flanks stand apart on reference and operating circle (4.73, 4.74)."""
    turn, values = found.turn, keyed(found, "involute_t", "involute_w", "turn")
    text = f"inv alpha_t = {number(found.involute_t)}"
    if found.task.kind != "rack":
        text += f", inv alpha_tw = {number(found.involute_w)}"
    if abs(turn) > NOISE:
        arcs = millimetres(*(abs(turn) * size.reference for size in found.sizes))
        text += f"\ngamma = {number(turn)} rad = {number(math.degrees(turn))} deg\narcs r gamma = {arcs}"
    return Fact("involutes", text, values)


def _distance_fact(found: MeshPair) -> Fact:
    if found.task.kind == "rack":
        text = f"r + x m = {millimetres(found.distance)}, from the axis to the datum line of the rack"
        return Fact("centre distance", text, keyed(found, "distance"))
    text = f"a = {millimetres(found.reference_distance)}, a_w = {millimetres(found.distance)}\n"
    numbers = keyed(found, "stretch", "modification", "shortening")
    text += ", ".join(f"{name} = {number(value, peak=1.0)}" for name, value in numbers.items())
    return Fact("centre distance", text, keyed(found, "reference_distance", "distance") | numbers)


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
