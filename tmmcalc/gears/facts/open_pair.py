"""The document of the open pair: ratio, efficiency and inertia with their sources, torques, forces, stresses."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace

from tmmcalc.core.notes import Phrase
from tmmcalc.core.quantity import keyed
from tmmcalc.gears.facts.meshes import millimetres
from tmmcalc.gears.facts.strength import WHENCE, coefficient_facts, stress_facts
from tmmcalc.gears.openload import OpenLoad, strength_task
from tmmcalc.gears.openpair import tooth_sets
from tmmcalc.gears.strength.explain import coefficients, reason, remarks
from tmmcalc.report.document import Document, Fact
from tmmcalc.report.numbers import number


def summary(result: OpenLoad, title: str) -> Document:
    """What it gives to the drive line, and what loads it."""
    facts = [*_drive_facts(result), *_load_facts(result), *_strength_facts(result)]
    return Document(title, tuple(facts), tuple(_notes(result)))


def document(result: OpenLoad, title: str) -> Document:
    """The summary with every coefficient of the stresses and its source."""
    told = summary(result, title)
    if result.torque is None or result.strength is None:
        return told
    used = coefficients(tooth_sets(result.task.open.pair), strength_task(result.task, result.torque), 0)
    own = [each for each in used if each.of != "train"]
    return replace(told, facts=(*told.facts, *coefficient_facts(own)))


def _drive_facts(result: OpenLoad) -> Iterator[Fact]:
    """Teeth, ratio, efficiency, inertia, and the pitch circle of the gear on the crank."""
    pair = result.task.open.pair
    z_a, z_b = pair.teeth
    ring = ", a ring" if pair.kind == "internal" else ""
    text = f"{z_a}/{z_b}: pinion a on the output shaft of the reducer, gear b{ring} on the crank"
    yield Fact("open pair", text, keyed(result, "name"))
    yield Fact("ratio of the pair", f"u = {number(result.ratio)} = {z_b}/{z_a}", keyed(result, "ratio"))
    text = f"{number(result.efficiency)}, {result.efficiency_of}"
    yield Fact("efficiency of the pair", text, keyed(result, "efficiency", "efficiency_of"))
    text = f"{number(result.inertia)} kg*m^2 at the crank, {result.inertia_of}"
    if result.task.open.inertia is None:
        parts = f"J_a = {number(result.pinion_inertia)} kg*m^2, J_b = {number(result.gear_inertia)} kg*m^2"
        text = f"{number(result.inertia)} kg*m^2 at the crank = J_a u^2 + J_b, {parts}, {result.inertia_of}"
    yield Fact("inertia of the pair", text, keyed(result, "inertia", "inertia_of", "pinion_inertia", "gear_inertia"))
    text = f"r_w = {millimetres(result.radius)}, alpha_tw = {number(math.degrees(result.angle))} deg"
    yield Fact("pitch circle of gear b", text, keyed(result, "radius", "angle"))


def _load_facts(result: OpenLoad) -> Iterator[Fact]:
    """Torques of both wheels, and the forces in their mesh."""
    if result.torque is None or result.pinion_torque is None or result.tangential is None:
        yield Fact("torque on gear b", "not known: nothing loads the crank", {})
        return
    text = f"{number(result.torque)} N*m, {WHENCE[result.torque_of]}"
    yield Fact("torque on gear b", text, keyed(result, "torque", "torque_of"))
    text = f"{number(result.pinion_torque)} N*m = {number(result.torque)} N*m / {number(result.ratio)}, without losses"
    yield Fact("torque on pinion a", text, keyed(result, "pinion_torque"))
    told = {"tangential": "F_t", "radial": "F_r", "axial": "F_a", "across": "F_t and F_r together"}
    forces = {name: getattr(result, name) for name in told}
    text = ", ".join(f"{told[name]} {number(value)} N" for name, value in forces.items() if value)
    yield Fact("forces in its mesh", text, keyed(result, *forces))


def _strength_facts(result: OpenLoad) -> Iterator[Fact]:
    """Stresses beside the permissible ones."""
    found = result.strength
    if found is None:
        return
    yield Fact("strength of the pair", reason(found, 0), {"accepted": bool(found.accepted[0])})
    for fact in stress_facts(found, 0):
        yield replace(fact, label=f"{fact.label} of the pair", text=fact.text.removeprefix("stage 1: "))


def _notes(result: OpenLoad) -> Iterator[str]:
    """What the check leaves out, and whether the force of the mesh enters the reactions."""
    task, found = result.task, result.strength
    if found is not None:
        if not found.accepted[0]:
            yield Phrase(
                "warning: the open pair: {reason}; a larger module, a wider face or harder teeth",
                reason=reason(found, 0),
            )
        yield from found.warnings
        yield from (remark.note for remark in remarks(found, 0))
        if task.open.pair.helix:
            yield "note: stresses are those of spur wheels of the same module and width, which is on the safe side"
    elif result.torque is not None:
        yield "note: no stresses: [open_pair] has no material, and there is no [strength] with one"
    if task.in_bearing is False:
        yield (
            'note: reactions of the crank are those of a coupling: with kind = "gear" and the direction of the pinion '
            "in [drive] the force of this mesh enters them"
        )
    if task.in_bearing and task.open.pair.helix:
        yield "note: the axial force is not in the plane of the linkage, and not in the reactions"
