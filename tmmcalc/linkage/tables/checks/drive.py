"""Checks of ``[drive]``: a gear on the crank has its size and the place of its pinion."""

from __future__ import annotations

import math
from collections.abc import Iterator

from tmmcalc.linkage.tables.checks.written_linkage import written_linkage
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline, subtable, word
from tmmcalc.spec.phrases import show
from tmmcalc.spec.values import amount

_OF_A_GEAR = ("radius", "mesh_angle", "pinion", "internal")
_STEEPEST = math.radians(45)


def check_gear(outline: Outline) -> Iterator[Finding]:
    """A gear needs its radius and the direction of its pinion, a coupling has neither, a slider has no gear."""
    linkage = written_linkage(outline)
    drive = subtable(outline.document, "drive")
    kind = word(drive, "kind", "coupling")
    if kind == "coupling":
        for key in _OF_A_GEAR:
            if key in drive:
                yield Finding(("drive", key), f"a coupling has no {key}", 'remove it, or write kind = "gear"')
        return
    if kind != "gear":
        return
    if linkage.slides and linkage.input_joint is not None:
        yield Finding(
            ("drive", "kind"),
            f'the input joint "{linkage.input_joint.name}" is prismatic; only a crank carries a gear',
            "remove [drive]: the slider is driven by a force along its guide",
        )
    if "radius" not in drive and "open_pair" not in outline.document:
        yield Finding(
            ("drive", "radius"), "missing key: a gear has its pitch radius", 'add radius = "150 mm", or [open_pair]'
        )
    if "pinion" not in drive:
        rule = "missing key: the mesh force depends on where the pinion is"
        yield Finding(("drive", "pinion"), rule, 'add pinion = "90 deg", the direction from the pivot to its centre')
    angle = amount(drive.get("mesh_angle"), "angle")
    if angle is not None and not 0 < angle < _STEEPEST:
        yield Finding(
            ("drive", "mesh_angle"),
            f"{show(drive['mesh_angle'])} is not a pressure angle; it is above 0 and below 45 deg",
            'write "20 deg", for example',
        )


CHECKS = (check_gear,)
