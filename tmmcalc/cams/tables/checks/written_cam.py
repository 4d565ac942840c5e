"""The cam of a spec as it is written: its tables, its kind of follower, and where a key of it stands."""

from __future__ import annotations

from tmmcalc.cams.tables.cam import CLOSURES, FOLLOWERS
from tmmcalc.core.records import record
from tmmcalc.linkage.tables.checks.written_linkage import written_linkage
from tmmcalc.spec.outline import Outline, Raw, subtable, word
from tmmcalc.spec.phrases import Path
from tmmcalc.spec.values import amount

A_FOLLOWER = {
    "translating": "a translating follower",
    "oscillating": "an oscillating follower",
    "flat": "a flat-faced follower",
}


@record
class WrittenCam:
    """[cam] as far as it can be read."""

    table: Raw
    kind: str  # of the follower; empty if that is not known
    closure: str  # empty if it is not known

    def has(self, name: str) -> bool:
        """Whether there is a table in [cam]."""
        return isinstance(self.table.get(name), dict)

    def part(self, name: str) -> Raw:
        """A table in [cam], [cam] itself for an empty name; an empty one if there is none."""
        return subtable(self.table, name) if name else self.table

    def amount(self, key: str, dimension: str = "length") -> float | None:
        """A quantity of [cam] in SI, None if it is absent or faulty."""
        return amount(self.table.get(key), dimension)


def written_cam(outline: Outline) -> WrittenCam:
    """The cam."""
    table = subtable(outline.document, "cam")
    kind, closure = word(table, "follower"), word(table, "closure") if "closure" in table else CLOSURES[0]
    return WrittenCam(table, kind if kind in FOLLOWERS else "", closure if closure in CLOSURES else "")


def turning_shaft(outline: Outline) -> bool:
    """Whether there is a crank, of a linkage that is written or sought, or the shaft of a torque diagram."""
    there = {"mechanism", "synthesis", "torque"} & {*outline.document}
    return bool(there) and not written_linkage(outline).slides


def place(part: str, key: str = "") -> Path:
    """Where a key of a table in [cam] stands, or the table itself."""
    return tuple(step for step in ("cam", part, key) if step)
