"""Checks of ``[motion]``: what drives is there, and the speed is given once."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.linkage.tables.checks.written_linkage import written_linkage
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline, subtable


def check_motion(outline: Outline) -> Iterator[Finding]:
    """A motor that drives is described; a motor sets the speed itself; a machine turns a crank."""
    linkage = written_linkage(outline)
    motion = subtable(outline.document, "motion")
    drive = motion.get("drive", "motor" if "motor" in outline.document else "positional")
    if drive == "motor" and "motor" not in outline.document:
        yield Finding(
            ("motion", "drive"), 'drive = "motor" without a motor', 'add [motor], or write drive = "positional"'
        )
    if drive == "motor" and "speed" in motion:
        yield Finding(
            ("motion", "speed"),
            "speed together with a motor: its characteristic and the load set the speed",
            'remove it, or write drive = "positional"',
        )
    if drive == "none" and "speed" in motion:
        yield Finding(
            ("motion", "speed"),
            'speed together with drive = "none": the loads set the speed',
            'remove it, or write drive = "positional"',
        )
    if linkage.slides and linkage.input_joint is not None:
        yield Finding(
            ("motion",),
            f'the input joint "{linkage.input_joint.name}" is prismatic; the motion is found of a machine with a crank',
            "remove [motion]",
        )


CHECKS = (check_motion,)
