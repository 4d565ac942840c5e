"""The words of a linkage that stand in names of columns: its points, links, joints, outputs, loads, letters."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmmcalc.linkage.pins import find_pins
from tmmcalc.linkage.tables.names import load_names
from tmmcalc.linkage.tables.tasks.mechanism import to_linkage

if TYPE_CHECKING:
    from tmmcalc.linkage.room import LinkageTables


def words_of(spec: LinkageTables) -> dict[str, list[str]]:
    """By place in the names of columns the words of the scene; without a linkage none."""
    if spec.mechanism is None:
        return {}
    mechanism = to_linkage(spec.linkage)
    joints = {kind: [joint.name for joint in mechanism.joints if joint.kind == kind] for kind in PLACES}
    every, links = [joint.name for joint in mechanism.joints], [str(link.id) for link in mechanism.links]
    points = [name for link in (mechanism.frame, *mechanism.links) for name in link.points]
    pins = [pin.name for pin in find_pins(mechanism)]
    turns = mechanism.joint(mechanism.input.joint).kind == "revolute"
    given = [(load.name, load.link) for load in spec.loads]
    return {
        **{PLACES[kind]: names for kind, names in joints.items()},
        "joint": every,
        "letter": ["M" if turns else "F"],
        "inertia": ["J" if turns else "m"],
        "link": links,
        "point": list(dict.fromkeys([*points, *pins])),
        "output": [output.name for output in mechanism.outputs] or [*every, *links],
        "load": load_names([name for name, _ in given], [link for _, link in given]),
        "head": [*pins, *joints["prismatic"]],
        "base": pins,
        **dict.fromkeys(("first", "second"), links),
    }


PLACES = {"revolute": "pin", "prismatic": "slide"}
