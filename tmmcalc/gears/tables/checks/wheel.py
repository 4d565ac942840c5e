"""Checks of ``[wheel]``: a rack that is a tool, keys that its kind uses, a cutter that fits into the ring."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.gears.involute.rack import Rack
from tmmcalc.gears.tables.checks.teeth import tool_faults
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline, Raw, is_integer, subtable, word
from tmmcalc.spec.values import amount

RING_LACKS = {
    "span_teeth": "plates cannot span the teeth of a ring",
    "face_width_rule": "plates cannot span the teeth of a ring",
    "undercut": "a ring is not undercut by a rack; what its cutter cuts away is checked with cutter",
}


def check_wheel(outline: Outline) -> Iterator[Finding]:
    """All faults of the wheel."""
    wheel = subtable(outline.document, "wheel")
    if not wheel:
        return
    yield from tool_faults(wheel, Rack(), lambda key: ("wheel", key))
    yield from _check_limits(wheel)
    if wheel.get("kind", "external") == "external":
        if "cutter" in wheel:
            remedy = 'remove it; it belongs to kind = "internal"'
            yield Finding(("wheel", "cutter"), "cutter is of no use: it cuts a ring, and there is none", remedy)
    elif word(wheel, "kind") == "internal":
        yield from _check_ring(wheel)


def _check_limits(wheel: Raw) -> Iterator[Finding]:
    """What is wanted is not less than what is needed."""
    least, wanted = amount(wheel.get("tip_thickness_min", 0.0)), amount(wheel.get("tip_thickness_wanted", 0.25))
    if least is None or wanted is None or wanted >= least or "tip_thickness_wanted" not in wheel:
        return
    rule = f"tip_thickness_wanted = {wanted:g} is below tip_thickness_min = {least:g}"
    remedy = f"write {least:g} or more, or a lower tip_thickness_min"
    yield Finding(("wheel", "tip_thickness_wanted"), rule, remedy)


def _check_ring(wheel: Raw) -> Iterator[Finding]:
    """A ring has no span, no undercut by a rack, and more teeth than its cutter."""
    for key, lack in RING_LACKS.items():
        if key in wheel:
            yield Finding(("wheel", key), f"{key} is of no use: {lack}", "remove it")
    cutter, teeth = subtable(wheel, "cutter").get("teeth"), wheel.get("teeth")
    if is_integer(cutter) and is_integer(teeth) and cutter >= teeth:
        rule = f"a cutter of {cutter} teeth does not fit into a ring of {teeth}"
        yield Finding(("wheel", "cutter", "teeth"), rule, "take a smaller cutter")


CHECKS = (check_wheel,)
