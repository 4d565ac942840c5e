"""Checks of ``[strength]``: a torque, materials that the tables know, and modules that are found or checked."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

from tmmcalc.core.errors import UsageError
from tmmcalc.gears.strength.endurance import endurance
from tmmcalc.gears.strength.material import TREATMENTS, Hardness, Material, parse_hardness
from tmmcalc.gears.strength.steels import check_steel
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline, Raw, subtable, word
from tmmcalc.spec.phrases import Path, show
from tmmcalc.spec.values import amount, bare_number

_MATERIALS = ("material", "pinion", "wheel")
_PERMISSIBLE = ("permissible_contact", "permissible_bending")
_PER_STAGE = ("face_width", "arrangement", *_PERMISSIBLE, "module", "width")
_OF_CHOICE = ("modules_row", "underrun", "face_width_rule", "rounding", "on_overload", "iterate")
_WORDS = ("structure", "failure", "blank", "wear", "load", "row")
_LIMITS = ("contact_limit", "bending_limit")
# Bare numbers outside these limits are in the unit that is meant, not in SI.
_BARE = {
    "module": ("m", "mm", 0.0, 0.2),
    "width": ("m", "mm", 0.0, 2.0),
    "permissible_contact": ("Pa", "MPa", 1e5, math.inf),
    "permissible_bending": ("Pa", "MPa", 1e5, math.inf),
}


def check_torque(outline: Outline) -> Iterator[Finding]:
    """The torque is given, or follows from a moment and its ratio; the reduction may give the moment."""
    strength = subtable(outline.document, "strength")
    if "moment_ratio" in strength and "open_pair" in outline.document:
        rule = "moment_ratio beside [open_pair]: the ratio to the crank is that of the train times that of the pair"
        yield Finding(("strength", "moment_ratio"), rule, "remove it")
    for key in ("moment", "moment_ratio"):
        if "torque" in strength and key in strength:
            rule = f"torque together with {key}: the torque on wheel 1 is the moment over the ratio"
            yield Finding(("strength", key), rule, f"remove {key}, or remove torque")
            return
    if not {"torque", "moment"} & {*strength} and not {"mechanism", "synthesis", "torque"} & {*outline.document}:
        rule = "missing key: the torque on wheel 1"
        yield Finding(("strength",), rule, 'add torque = "22 N*m", or moment = "1980 N*m" of the output shaft')


def check_materials(outline: Outline) -> Iterator[Finding]:
    """All wheels have one material, or pinions and wheels their own; or both permissible stresses are given."""
    strength = subtable(outline.document, "strength")
    given = [key for key in _MATERIALS if key in strength]
    if "material" in given and len(given) > 1:
        rule = f"material together with {' and '.join(given[1:])}: material is that of all wheels"
        yield Finding(("strength", "material"), rule, "remove it, or write pinion and wheel alone")
    elif given == ["wheel"]:
        yield Finding(("strength", "wheel"), "wheel without pinion", "add [strength.pinion], or write material")
    elif not given and not {*_PERMISSIBLE} <= {*strength}:
        rule = "missing key: the material of the wheels, or both permissible stresses"
        remedy = "add [strength.material], or permissible_contact and permissible_bending"
        yield Finding(("strength",), rule, remedy)
    for key in given:
        if isinstance(strength[key], dict):
            yield from check_material(strength[key], ("strength", key))


def check_material(material: Raw, path: Path) -> Iterator[Finding]:
    """A material has what the tables ask for, and they know it."""
    missing = [
        Finding(path, f"missing key: {rule}", f"add {key} = {example}")
        for key, rule, example in _needed(material)
        if key not in material
    ]
    yield from missing
    steel = material.get("steel")
    if isinstance(steel, str) and not {"row", "bending_limit"} & {*material}:
        try:
            check_steel(steel, "", "name a row of the table, or give bending_limit")
        except UsageError as fault:
            yield Finding((*path, "steel"), fault.message, fault.remedy)
            return
    read = None if missing else _read(material)
    if read is None:
        return
    try:
        endurance(read, "one-sided", "")
    except UsageError as fault:
        key = "hardness" if "hardness" in fault.message else "row" if "row" in material else "steel"
        yield Finding((*path, key), fault.message, fault.remedy)


def _needed(material: Raw) -> Iterator[tuple[str, str, str]]:
    """Keys that a material has, with the rule and an example."""
    yield "treatment", "the limits depend on the heat treatment", '"improved"'
    yield "hardness", "the limits depend on the hardness of the teeth", '"300 HB"'
    treatment = word(material, "treatment")
    if treatment != "surface-hardened" and not {"row", "bending_limit"} & {*material}:
        yield "steel", "the bending limit depends on the steel", '"40Kh"'
    if treatment == "nitrided" and "bending_limit" not in material:
        yield "core", "the bending limit of nitrided teeth depends on the hardness of their core", '"30 HRC"'
    if treatment == "through-hardened":
        yield "contact_limit", "Table D.4.4 has no contact limit of through-hardened teeth", '"900 MPa"'
    if treatment == "annealed":
        yield "bending_limit", "Table D.4.3 has no bending limit of annealed teeth", '"400 MPa"'


def _read(material: Raw) -> Material | None:
    """The material as the strength calculation has it, None if a value of it has a fault of its own."""
    data: dict[str, Any] = {key: word(material, key) for key in ("steel", "treatment", *_WORDS) if key in material}
    for key in ("hardness", "core"):
        if key in material:
            data[key] = _hardness(material[key])
    for key in _LIMITS:
        if key in material:
            data[key] = amount(material[key], "pressure")
    if None in data.values() or data["treatment"] not in TREATMENTS:
        return None
    try:
        return Material(**data)
    except UsageError:
        return None


def _hardness(value: object) -> Hardness | None:
    try:
        if isinstance(value, dict):
            number, scale = amount(value.get("value")), value.get("scale")
            return Hardness(number, scale) if number is not None and isinstance(scale, str) else None
        return parse_hardness(value) if isinstance(value, str) else None
    except UsageError:
        return None


def check_modules(outline: Outline) -> Iterator[Finding]:
    """Given modules are checked: widths belong to them, rules of rounding do not."""
    strength = subtable(outline.document, "strength")
    if "width" in strength and "module" not in strength:
        rule = "width without module: the width follows from the module that strength asks for"
        yield Finding(("strength", "width"), rule, 'add module = "2 mm", or write face_width, the width over diameter')
    for key in _OF_CHOICE if "module" in strength else ():
        if key in strength:
            rule = f"{key} together with module: a given module is checked, nothing is chosen"
            yield Finding(("strength", key), rule, f"remove {key}, or remove module")
    for key, (unit, meant, least, largest) in _BARE.items():
        written = strength.get(key)
        bare = [bare_number(value) for value in (written if isinstance(written, list) else [written])]
        strange = next((number for number in bare if number and not least <= number <= largest), None)
        if strange is not None and strange > 0:
            what = f"{show(strange)} without a unit is in {unit}"
            yield Finding(("strength", key), what, f'write "{strange:g} {meant}" or "{strange:g} {unit}"')


def check_stages(outline: Outline) -> Iterator[Finding]:
    """Lists have a value for every stage of one train."""
    strength = subtable(outline.document, "strength")
    counts = {key: len(value) for key in _PER_STAGE if isinstance(value := strength.get(key), list) and len(value) > 1}
    for key, count in counts.items():
        first = next(iter(counts))
        if count != counts[first]:
            rule = f"{key} has {count} values, {first} has {counts[first]}"
            yield Finding(("strength", key), rule, "write one value for all stages, or one for each")


CHECKS = (check_torque, check_materials, check_modules, check_stages)
