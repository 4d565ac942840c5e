"""Checks of ``[flywheel]``: what is asked, where it sits, and how its rim is measured."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.linkage.tables.checks.written_linkage import written_linkage
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline, subtable


def check_task(outline: Outline) -> Iterator[Finding]:
    """A flywheel is asked for by the unevenness, or is there with its moment of inertia."""
    linkage = written_linkage(outline)
    flywheel = subtable(outline.document, "flywheel")
    if not {"delta", "inertia"} & {*flywheel}:
        yield Finding(
            ("flywheel",),
            "missing key: the allowed unevenness, or the moment of inertia of a flywheel that is there",
            'add delta = "1/25", or inertia = "20 kg*m^2"',
        )
    if linkage.slides and linkage.input_joint is not None:
        yield Finding(
            ("flywheel",),
            f'the input joint "{linkage.input_joint.name}" is prismatic; a flywheel turns with a crank',
            "remove [flywheel]",
        )


def check_shaft(outline: Outline) -> Iterator[Finding]:
    """The shaft is named or has a ratio; that of the motor has the ratio of its gears."""
    flywheel = subtable(outline.document, "flywheel")
    if "shaft" in flywheel and "ratio" in flywheel:
        yield Finding(
            ("flywheel", "ratio"),
            f'shaft = "{flywheel["shaft"]}" together with ratio: its ratio is known',
            "remove shaft for another shaft of this ratio, or remove ratio",
        )
    known = "motor" in outline.document or "ratio" in subtable(outline.document, "transmission")
    if flywheel.get("shaft") == "motor" and not known:
        yield Finding(
            ("flywheel", "shaft"),
            'shaft = "motor" without a motor: the ratio to the crank is not known',
            "add [motor], or [transmission] with ratio = 26.4",
        )


def check_rim(outline: Outline) -> Iterator[Finding]:
    """A rim has two of its three sizes, or only its diameter; the moment of inertia gives the rest."""
    flywheel = subtable(outline.document, "flywheel")
    sizes = [key for key in ("diameter", "width", "thickness") if key in flywheel]
    if len(sizes) == 3:
        yield Finding(
            ("flywheel", "thickness"),
            "diameter, width and thickness together: one of them follows from the moment of inertia",
            "remove one of them",
        )
    if sizes in (["width"], ["thickness"]):
        yield Finding(
            ("flywheel", sizes[0]),
            f"{sizes[0]} alone: a rim is sized from its diameter, or from its width and thickness",
            'add diameter = "800 mm"',
        )


CHECKS = (check_task, check_shaft, check_rim)
