"""Checks of ``[open_pair]``: a pair that can be made and turns a crank, its losses and materials told once."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.gears.involute.rack import Rack
from tmmcalc.gears.tables.checks.pair import faults
from tmmcalc.gears.tables.checks.strength import check_material
from tmmcalc.gears.tables.checks.written_pair import KINDS, Written
from tmmcalc.linkage.tables.checks.written_linkage import written_linkage
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline, subtable, word

_MATERIALS = ("material", "pinion", "gear")


def check_geometry(outline: Outline) -> Iterator[Finding]:
    """Two wheels, or a pinion in a ring, with a face width: its inertia and strength follow from it."""
    keys = subtable(outline.document, "open_pair")
    kind = word(keys, "kind", "external")
    if kind == "rack":
        rule = 'kind = "rack": the gear on the crank turns'
        yield Finding(("open_pair", "kind"), rule, 'write kind = "external" or "internal", or remove it')
        return
    if "face_width" not in keys:
        rule = "missing key: inertia and strength of the open pair need its face width"
        yield Finding(("open_pair",), rule, 'add face_width = "60 mm"')
    kinds = (kind,) if kind in KINDS else ()
    yield from faults([Written(("open_pair",), keys, {}, kinds, Rack(), False)])


def check_crank(outline: Outline) -> Iterator[Finding]:
    """Only what turns carries a gear."""
    linkage = written_linkage(outline)
    if linkage.slides and linkage.input_joint is not None:
        name = linkage.input_joint.name
        rule = f'the input joint "{name}" is prismatic; only a crank carries a gear'
        yield Finding(("open_pair",), rule, "remove [open_pair]")


def check_losses(outline: Outline) -> Iterator[Finding]:
    """One way to tell the efficiency."""
    keys = subtable(outline.document, "open_pair")
    if {"efficiency", "friction"} <= {*keys}:
        rule = "friction together with efficiency: the efficiency follows from the friction"
        yield Finding(("open_pair", "friction"), rule, "remove one of them")


def check_materials(outline: Outline) -> Iterator[Finding]:
    """Both wheels have one material, or each its own."""
    keys = subtable(outline.document, "open_pair")
    given = [key for key in _MATERIALS if key in keys]
    if "material" in given and len(given) > 1:
        rule = f"material together with {' and '.join(given[1:])}: material is that of both wheels"
        yield Finding(("open_pair", "material"), rule, "remove it, or write pinion and gear alone")
    elif given == ["gear"]:
        yield Finding(("open_pair", "gear"), "gear without pinion", "add [open_pair.pinion], or write material")
    for key in given:
        if isinstance(keys[key], dict):
            yield from check_material(keys[key], ("open_pair", key))


CHECKS = (check_geometry, check_crank, check_losses, check_materials)
