"""Checks of the tool that cuts teeth, of pairs and of wheels by themselves."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.gears.involute.rack import RACKS, Rack, section
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Raw, word
from tmmcalc.spec.phrases import Path
from tmmcalc.spec.values import amount

_TOOL = ("tip_radius", "clearance", "addendum", "pressure_angle", "helix_angle", "rack")


def tool_faults(keys: Raw, rack: Rack, at: Callable[[str], Path]) -> Iterator[Finding]:
    """Faults of a rack, with what is given in place of its own: it has to be a tool that can be made.

    ``rack`` is that of keys that say nothing, ``at`` the place of a key.
    """
    usual = RACKS.get(word(keys, "rack"), rack)
    angle, helix = amount(keys.get("pressure_angle", usual.angle), "angle"), amount(keys.get("helix_angle", 0), "angle")
    addendum, clearance = amount(keys.get("addendum", usual.addendum)), amount(keys.get("clearance", usual.clearance))
    radius = usual.tip_radius if "tip_radius" not in keys else amount(keys["tip_radius"])
    if angle is None or helix is None or addendum is None or clearance is None:
        return
    if not (0 < angle < 1 and abs(helix) < 1.2) or ("tip_radius" in keys and radius is None):
        return  # the fault is the table's
    given = Rack(angle, addendum, clearance, radius)
    try:
        section(given, helix)
    except NoSolutionError as error:
        key = next((each for each in _TOOL if each in keys), "rack")
        yield Finding(at(key), f"no tool has this rack: {error.message}", f"take {error.remedy}")
